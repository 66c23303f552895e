(* Relations between states of a law that hold at the start hold for ever: a regression without
   derivatives, and memories of it.

     phi_f' = l (phi - phi_f)     q' = l (l x + v - q)         then q = l x - theta phi_f
     Q' = s n n^T     b' = s (y - b h) n     n = w - Q h       then Q = Q^T >= 0, b = kappa Q if y = kappa w *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus.
Open Scope R_scope.

Definition locally_bounded (f : R -> R) := forall T, exists M, forall t, 0 <= t <= T -> Rabs (f t) <= M.

Lemma locally_continuous f : (forall t, 0 <= t -> continuous f t) -> locally_bounded f.
Proof.
  intros C T. destruct (Rle_lt_dec 0 T) as [HT|HT].
  - destruct (@bounded_continuity R_AbsRing R_NormedModule f 0 T) as [M HM].
    { intros t Ht. apply C. lra. }
    exists M. intros t Ht. apply Rlt_le, HM, Ht.
  - exists 0. intros t Ht. lra.
Qed.

Lemma locally_follows f df : follows f df -> locally_bounded f.
Proof. intros F. apply locally_continuous, F. Qed.

Lemma locally_const a : locally_bounded (fun _ => a).
Proof. intros T. exists (Rabs a). intros; lra. Qed.

Lemma locally_plus f g : locally_bounded f -> locally_bounded g -> locally_bounded (fun t => f t + g t).
Proof. intros Hf Hg T. destruct (Hf T) as [M HM], (Hg T) as [L HL]. exists (M + L). intros t Ht.
  eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; auto. Qed.

Lemma locally_mult f g : locally_bounded f -> locally_bounded g -> locally_bounded (fun t => f t * g t).
Proof. intros Hf Hg T. destruct (Hf T) as [M HM], (Hg T) as [L HL]. exists (M * L). intros t Ht.
  rewrite Rabs_mult. apply Rmult_le_compat; auto using Rabs_pos. Qed.

Lemma locally_ext f g : (forall t, 0 <= t -> f t = g t) -> locally_bounded f -> locally_bounded g.
Proof. intros E H T. destruct (H T) as [M HM]. exists M. intros t Ht. rewrite <- E by lra. auto. Qed.

Lemma locally_minus f g : locally_bounded f -> locally_bounded g -> locally_bounded (fun t => f t - g t).
Proof. intros Hf Hg. apply (locally_ext (fun t => f t + -1 * g t)); [intros; ring|].
  apply locally_plus; auto. apply (locally_mult (fun _ => -1)); auto using locally_const. Qed.

Lemma locally_sum n (f : nat -> R -> R) : (forall k, (k < n)%nat -> locally_bounded (f k)) ->
  locally_bounded (fun t => sum n (fun k => f k t)).
Proof. induction n as [|n IH]; intros H; simpl; [apply locally_const|].
  apply (locally_plus (fun t => sum n (fun k => f k t))); auto. Qed.

(* W' <= L W with W >= 0, W(0) = 0 *)
Lemma stays_zero W dW L : follows W dW -> locally_bounded L -> (forall t, 0 <= t -> 0 <= W t) ->
  (forall t, 0 < t -> dW t <= L t * W t) -> W 0 = 0 -> forall t, 0 <= t -> W t = 0.
Proof.
  intros F B P D W0 t Ht. destruct (B t) as [M HM].
  assert (G : follows (fun t => exp (- M * t) * W t)
                      (fun t => - M * exp (- M * t) * W t + exp (- M * t) * dW t)).
  { apply follows_mult; auto. apply follows_smooth. intros s. auto_derive; auto. ring. }
  assert (A : exp (- M * t) * W t <= exp (- M * 0) * W 0).
  { apply (falls _ _ 0 t G); [lra|]. intros s Hs. assert (E := exp_pos (- M * s)).
    assert (Q := HM s ltac:(lra)). assert (U := Rle_abs (L s)). assert (V := D s ltac:(lra)).
    assert (N := P s ltac:(lra)). assert (dW s <= M * W s) by nra.
    assert (exp (- M * s) * (dW s - M * W s) <= 0) by nra. lra. }
  rewrite W0, Rmult_0_r in A. assert (E := exp_pos (- M * t)). assert (N := P t Ht). nra.
Qed.

Lemma scalar_stays r a : follows r (fun t => a t * r t) -> locally_bounded a -> r 0 = 0 ->
  forall t, 0 <= t -> r t = 0.
Proof.
  intros F B R0 t Ht. assert (E : (r t)^2 = 0); [|apply Rsqr_0_uniq; unfold Rsqr; simpl in E; lra].
  apply (stays_zero (fun t => (r t)^2) _ (fun t => 2 * a t) (follows_square _ _ F)); auto.
  - apply locally_mult; auto using locally_const.
  - intros. apply pow2_ge_0.
  - intros s Hs. right. ring.
  - rewrite R0. ring.
Qed.

Lemma cauchy_schwarz n f g : (sum n (fun k => f k * g k))^2 <= sum n (fun k => (f k)^2) * sum n (fun k => (g k)^2).
Proof.
  set (P := sum n (fun k => f k * g k)). set (F := sum n (fun k => (f k)^2)). set (G := sum n (fun k => (g k)^2)).
  assert (G0 : 0 <= G) by (apply sum_nonneg; intros; apply pow2_ge_0).
  destruct (Req_dec G 0) as [Z|Nz].
  - assert (E : P = 0).
    { unfold P. rewrite (sum_ext n _ (fun _ => 0 * 0)), sum_scal; [ring|]. intros k Hk.
      assert (M : (g k)^2 <= G) by (apply (sum_member n (fun k => (g k)^2)); auto; intros; apply pow2_ge_0).
      assert (g k = 0) by (apply Rsqr_0_uniq; unfold Rsqr; assert (Q := pow2_ge_0 (g k)); simpl in *; lra).
      rewrite H. ring. }
    rewrite E, Z. lra.
  - assert (S : 0 <= sum n (fun k => (f k * G - g k * P)^2)) by (apply sum_nonneg; intros; apply pow2_ge_0).
    rewrite (sum_ext n _ (fun k => G^2 * (f k)^2 + (-2 * G * P) * (f k * g k) + P^2 * (g k)^2)) in S by (intros; ring).
    rewrite !sum_plus, !sum_scal in S. fold F G P in S.
    assert (0 <= G * (F * G - P^2)) by lra. apply (Rmult_le_reg_l G); lra.
Qed.

(* r_k' = c_k sum_j r_j w_j *)
Lemma vector_stays n (r c w : nat -> R -> R) :
  (forall k, (k < n)%nat -> follows (r k) (fun t => c k t * sum n (fun j => r j t * w j t))) ->
  (forall k, (k < n)%nat -> locally_bounded (c k)) -> (forall k, (k < n)%nat -> locally_bounded (w k)) ->
  (forall k, (k < n)%nat -> r k 0 = 0) -> forall k t, (k < n)%nat -> 0 <= t -> r k t = 0.
Proof.
  intros F Bc Bw R0 k t Hk Ht. set (W := fun t => sum n (fun k => (r k t)^2)).
  assert (FW := follows_sum n (fun k t => (r k t)^2) _ (fun k Hk => follows_square _ _ (F k Hk))).
  assert (Z : W t = 0).
  { apply (stays_zero W _ (fun t => sum n (fun k => (c k t)^2) + sum n (fun k => (w k t)^2)) FW); auto.
    - apply locally_plus; apply (locally_sum n (fun k t => _)); intros j Hj;
        [apply (locally_ext (fun t => c j t * c j t))|apply (locally_ext (fun t => w j t * w j t))];
        try (intros; ring); apply locally_mult; auto.
    - intros s _. apply sum_nonneg. intros. apply pow2_ge_0.
    - intros s _. set (S := sum n (fun j => r j s * w j s)).
      rewrite (sum_ext n _ (fun k => (2 * S) * (r k s * c k s))) by (intros; unfold S; ring). rewrite sum_scal.
      assert (A := cauchy_schwarz n (fun k => r k s) (fun k => c k s)).
      assert (B := cauchy_schwarz n (fun k => r k s) (fun k => w k s)). cbv beta in A, B. fold S in B.
      set (P := sum n (fun k => r k s * c k s)) in *.
      assert (Q : 2 * S * P <= S^2 + P^2) by (assert (T := pow2_ge_0 (S - P)); lra).
      unfold W. lra.
    - unfold W. rewrite (sum_ext n _ (fun _ => 0 * 0)), sum_scal; [ring|]. intros j Hj. rewrite R0 by auto. ring. }
  assert (M : (r k t)^2 <= W t) by (apply (sum_member n (fun k => (r k t)^2)); auto; intros; apply pow2_ge_0).
  apply Rsqr_0_uniq. unfold Rsqr. assert (Q := pow2_ge_0 (r k t)). simpl in *. lra.
Qed.

Theorem filter_kept N l (theta : nat -> R) (phi phi_f : nat -> R -> R) x q v :
  follows x (fun t => sum N (fun k => theta k * phi k t) + v t) ->
  follows q (fun t => l * (l * x t + v t - q t)) ->
  (forall k, (k < N)%nat -> follows (phi_f k) (fun t => l * (phi k t - phi_f k t))) ->
  (forall k, (k < N)%nat -> phi_f k 0 = 0) -> q 0 = l * x 0 ->
  forall t, 0 <= t -> q t = l * x t - sum N (fun k => theta k * phi_f k t).
Proof.
  intros Fx Fq Fp P0 Q0 t Ht.
  assert (E : q t - (l * x t - sum N (fun k => theta k * phi_f k t)) = 0); [|lra].
  apply (scalar_stays (fun t => q t - (l * x t - sum N (fun k => theta k * phi_f k t))) (fun _ => - l)); auto.
  - eapply follows_by.
    + eapply (follows_minus q _ _ _ Fq). eapply (follows_minus _ _ _ _ (follows_scal l _ _ Fx)).
      apply (follows_sum N (fun k t => theta k * phi_f k t)). intros k Hk. apply follows_scal, (Fp k Hk).
    + intros s _. cbv beta.
      rewrite (sum_ext N (fun k => theta k * (l * (phi k s - phi_f k s)))
        (fun k => l * (theta k * phi k s) + - l * (theta k * phi_f k s))) by (intros; ring).
      rewrite sum_plus, !sum_scal. ring.
  - apply locally_const.
  - rewrite Q0, (sum_ext N _ (fun _ => 0 * 0)), sum_scal; [ring|]. intros k Hk. rewrite P0 by auto. ring.
Qed.

Section Memory.
  Variables (n : nat) (Q : nat -> nat -> R -> R) (s : R -> R) (w h : nat -> R -> R).
  Definition new k t := w k t - sum n (fun j => Q k j t * h j t).
  Hypothesis Q_follows : forall k j, (k < n)%nat -> (j < n)%nat -> follows (Q k j) (fun t => s t * (new k t * new j t)).
  Hypothesis s_positive : forall t, 0 < t -> 0 <= s t.
  Hypothesis s_bounded : locally_bounded s.
  Hypothesis w_bounded : forall k, (k < n)%nat -> locally_bounded (w k).
  Hypothesis h_bounded : forall k, (k < n)%nat -> locally_bounded (h k).
  Hypothesis Q_zero : forall k j, (k < n)%nat -> (j < n)%nat -> Q k j 0 = 0.

  Theorem memory_symmetric k j t : (k < n)%nat -> (j < n)%nat -> 0 <= t -> Q k j t = Q j k t.
  Proof.
    intros Hk Hj Ht. assert (E : Q k j t - Q j k t = 0); [|lra].
    apply (scalar_stays (fun t => Q k j t - Q j k t) (fun _ => 0)); auto using locally_const.
    - apply (follows_by _ _ _ (follows_minus _ _ _ _ (Q_follows k j Hk Hj) (Q_follows j k Hj Hk))). intros; ring.
    - rewrite !Q_zero by auto. ring.
  Qed.

  Theorem memory_nonneg (c : nat -> R) t : 0 <= t ->
    0 <= sum n (fun k => sum n (fun j => c k * c j * Q k j t)).
  Proof.
    intros Ht.
    assert (F : follows (fun t => sum n (fun k => sum n (fun j => c k * c j * Q k j t)))
        (fun t => s t * (sum n (fun k => c k * new k t))^2)).
    { eapply follows_by.
      - apply (follows_sum n (fun k t => sum n (fun j => c k * c j * Q k j t))). intros k Hk.
        apply (follows_sum n (fun j t => c k * c j * Q k j t)). intros j Hj. apply follows_scal, (Q_follows k j Hk Hj).
      - intros u _. cbv beta. replace (sum n (fun k => c k * new k u) ^ 2)
          with (sum n (fun k => c k * new k u) * sum n (fun k => c k * new k u)) by ring.
        rewrite sum_product, <- sum_scal. apply sum_ext. intros k _. rewrite <- sum_scal. apply sum_ext. intros; ring. }
    assert (L := falls _ _ 0 t (follows_scal (-1) _ _ F) ltac:(lra)). cbv beta in L.
    rewrite (sum_ext n (fun k => sum n (fun j => c k * c j * Q k j 0)) (fun _ => 0 * 0)), sum_scal in L.
    - assert (-1 * sum n (fun k => sum n (fun j => c k * c j * Q k j t)) <= -1 * (0 * sum n (fun _ => 0))).
      { apply L. intros u Hu. assert (A := s_positive u ltac:(lra)).
        assert (B := pow2_ge_0 (sum n (fun k => c k * new k u))). nra. }
      lra.
    - intros k Hk. rewrite (sum_ext n _ (fun _ => 0 * 0)), sum_scal; [ring|]. intros j Hj. rewrite Q_zero by auto. ring.
  Qed.

  Theorem memory_kept (b : nat -> R -> R) (y : R -> R) (kappa : nat -> R) :
    (forall k, (k < n)%nat -> follows (b k) (fun t => s t * ((y t - sum n (fun j => b j t * h j t)) * new k t))) ->
    (forall t, 0 < t -> y t = sum n (fun k => kappa k * w k t)) -> (forall k, (k < n)%nat -> b k 0 = 0) ->
    forall k t, (k < n)%nat -> 0 <= t -> b k t = sum n (fun j => kappa j * Q j k t).
  Proof.
    intros Fb Y B0 k t Hk Ht. assert (E : b k t - sum n (fun j => kappa j * Q j k t) = 0); [|lra].
    apply (vector_stays n (fun k t => b k t - sum n (fun j => kappa j * Q j k t))
      (fun k t => -1 * (s t * new k t)) h); auto.
    - intros i Hi. eapply follows_by.
      + eapply (follows_minus _ _ _ _ (Fb i Hi)). apply (follows_sum n (fun j t => kappa j * Q j i t)).
        intros j Hj. apply follows_scal, (Q_follows j i Hj Hi).
      + intros u Hu. cbv beta. rewrite Y by lra.
        rewrite (sum_ext n (fun j => kappa j * (s u * (new j u * new i u)))
          (fun j => (s u * new i u) * (kappa j * w j u - kappa j * sum n (fun m => Q j m u * h m u))))
          by (intros; unfold new; ring).
        rewrite (sum_ext n (fun j => (b j u - _) * h j u)
          (fun m => b m u * h m u + -1 * sum n (fun j => kappa j * (Q j m u * h m u)))).
        2: { intros m _. rewrite Rmult_minus_distr_r, (Rmult_comm (sum n _)), <- sum_scal.
             rewrite (sum_ext n (fun k0 => h m u * _) (fun j => kappa j * (Q j m u * h m u))) by (intros; ring). ring. }
        rewrite sum_plus, !sum_scal.
        rewrite (sum_ext n (fun j => kappa j * w j u - _) (fun j => kappa j * w j u + -1 * sum n (fun m => kappa j * (Q j m u * h m u))))
          by (intros; rewrite sum_scal; ring).
        rewrite sum_plus, sum_scal, (sum_swap n n (fun j m => kappa j * (Q j m u * h m u))). ring.
    - intros i Hi. apply (locally_mult (fun _ => -1)); auto using locally_const. apply locally_mult; auto.
      unfold new. apply locally_minus; auto. apply (locally_sum n (fun j t => Q i j t * h j t)). intros j Hj.
      apply locally_mult; auto. apply (locally_follows _ _ (Q_follows i j Hi Hj)).
    - intros i Hi. rewrite B0 by auto. rewrite (sum_ext n _ (fun _ => 0 * 0)), sum_scal; [ring|].
      intros j Hj. rewrite Q_zero by auto. ring.
  Qed.
End Memory.
