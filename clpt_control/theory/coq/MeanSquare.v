(* The corrected Theorems 3.1 and 3.4: without any excitation,
     int_0^t |e|^2 <= 2 V(0)/k + int_0^t |Delta|^2/k^2,     k <= KD_i. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem Barbalat Trajectories PaperLoop.
Open Scope R_scope.

Definition piecewise_continuous (f : R -> R) : Prop :=
  forall T, exists l : list R, forall t, 0 < t < T -> ~ In t l -> continuous f t.

(* zero for t < 0 *)
Definition right (f : R -> R) t := if Rlt_dec t 0 then 0 else f t.

Lemma right_integral f t : 0 <= t -> RInt (right f) 0 t = RInt f 0 t.
Proof. intros Ht. apply RInt_ext. intros s Hs. rewrite Rmin_left in Hs by lra.
  unfold right. destruct (Rlt_dec s 0); [lra|auto]. Qed.

Lemma right_integrable f : (forall t, 0 <= t -> ex_RInt f 0 t) -> forall t, ex_RInt (right f) 0 t.
Proof. intros H t. destruct (Rle_lt_dec 0 t) as [Ht|Ht].
  - apply (ex_RInt_ext f); [|apply H, Ht]. intros s Hs. rewrite Rmin_left in Hs by lra.
    unfold right. destruct (Rlt_dec s 0); [lra|auto].
  - apply ex_RInt_swap. apply (ex_RInt_ext (fun _ => 0)); [|apply ex_RInt_const].
    intros s Hs. rewrite Rmin_left, Rmax_right in Hs by lra.
    unfold right. destruct (Rlt_dec s 0); [auto|lra]. Qed.

Lemma follows_integral f :
  (forall t, 0 <= t -> ex_RInt f 0 t) -> piecewise_continuous f ->
  follows (fun t => RInt (right f) 0 t) f.
Proof.
  intros I P.
  assert (J : forall t, is_RInt (right f) 0 t (RInt (right f) 0 t)).
  { intros t. apply (@RInt_correct R_CompleteNormedModule), right_integrable, I. }
  split.
  - intros t _. apply (continuous_RInt_1 (right f) 0 t (fun t => RInt (right f) 0 t)).
    exists (mkposreal 1 Rlt_0_1). intros y _. apply J.
  - intros T. destruct (P T) as [l Hl]. exists l. intros t Ht Hn.
    replace (f t) with (right f t) by (unfold right; destruct (Rlt_dec t 0); [lra|auto]).
    apply (is_derive_RInt (right f) (fun t => RInt (right f) 0 t) 0 t).
    + exists (mkposreal 1 Rlt_0_1). intros y _. apply J.
    + apply (continuous_ext_loc (right f) f t); [|apply (Hl t); auto].
      exists (mkposreal t (proj1 Ht)). intros y Hy. unfold right.
      destruct (Rlt_dec y 0); auto. exfalso.
      assert (A : Rabs (y - t) < t) by exact Hy. apply Rabs_lt_between in A. lra.
Qed.

Lemma continuous_sum n (f : nat -> R -> R) t :
  (forall k, (k < n)%nat -> continuous (f k) t) -> continuous (fun t => sum n (fun k => f k t)) t.
Proof. induction n as [|n IH]; intros H; simpl; [apply continuous_const|].
  apply @continuous_plus; auto. Qed.

Section MeanSquare.
  Variables (d N : nat) (KD : nat -> R) (gamma k : R).
  Variables (e : nat -> R -> R) (eta : nat -> nat -> R -> R) (kappa nu : nat -> R -> R).
  Variables (phi : nat -> R -> R) (z zc Delta : nat -> R -> R).
  Hypothesis gamma_positive : 0 < gamma.
  Hypothesis k_positive : 0 < k.
  Hypothesis k_least : forall i, (i < d)%nat -> k <= KD i.
  Hypothesis loop : error_system d N KD gamma e eta kappa nu phi z zc Delta.

  Definition square (f : nat -> R -> R) t := sum d (fun i => (f i t)^2).
  Hypothesis Delta_integrable : forall t, 0 <= t -> ex_RInt (square Delta) 0 t.
  Hypothesis Delta_continuous : piecewise_continuous (square Delta).

  Let Vt := V d N gamma e eta kappa nu.

  Theorem mean_square t : 0 <= t ->
    RInt (square e) 0 t <= 2 * Vt 0 / k + RInt (square Delta) 0 t / k^2.
  Proof.
    intros Ht.
    assert (Ce : forall s, 0 <= s -> continuous (square e) s).
    { intros s Hs. apply (continuous_sum d (fun i t => (e i t)^2)). intros i Hi.
      apply (follows_square (e i) _ (e_follows _ _ _ _ _ _ _ _ _ _ _ _ loop i Hi)), Hs. }
    assert (Fe : follows (fun t => RInt (right (square e)) 0 t) (square e)).
    { apply follows_integral.
      - intros s Hs. apply (@ex_RInt_continuous R_CompleteNormedModule). intros u Hu.
        rewrite Rmin_left in Hu by lra. apply Ce. lra.
      - intros T. exists nil. intros s Hs _. apply Ce. lra. }
    assert (Fd := follows_integral (square Delta) Delta_integrable Delta_continuous).
    assert (FV : follows Vt _) by (apply (V_follows d N KD gamma e eta kappa nu phi z zc Delta); [lra|auto]).
    assert (FW := follows_minus _ _ _ _
      (follows_plus _ _ _ _ FV (follows_scal (k / 2) _ _ Fe)) (follows_scal (/ (2 * k)) _ _ Fd)).
    assert (W := falls _ _ 0 t FW ltac:(lra)). cbv beta in W.
    assert (R0 : forall f, RInt (right f) 0 0 = 0) by (intros f; apply (@RInt_point R_CompleteNormedModule)).
    rewrite !R0, !right_integral in W by lra.
    assert (V0 : 0 <= Vt t) by (apply (V_nonneg d N gamma e eta kappa nu); auto).
    assert (L : Vt t + k / 2 * RInt (square e) 0 t - / (2 * k) * RInt (square Delta) 0 t
                <= Vt 0 + k / 2 * 0 - / (2 * k) * 0).
    { apply W. intros s Hs. unfold square.
      replace (_ - _) with (sum d (fun i => - ((KD i - k) * (e i s)^2 + k / 2 * (e i s - Delta i s / k)^2))).
      - replace 0 with (- 0) by ring.
        replace (sum d (fun i => - ((KD i - k) * (e i s)^2 + k / 2 * (e i s - Delta i s / k)^2)))
          with (- sum d (fun i => (KD i - k) * (e i s)^2 + k / 2 * (e i s - Delta i s / k)^2)).
        + apply Ropp_le_contravar, sum_nonneg. intros i Hi. assert (B := k_least i Hi).
          assert (0 <= (e i s)^2) by apply pow2_ge_0.
          assert (0 <= (e i s - Delta i s / k)^2) by apply pow2_ge_0. nra.
        + replace (- sum d (fun i => (KD i - k) * (e i s)^2 + k / 2 * (e i s - Delta i s / k)^2))
            with (-1 * sum d (fun i => (KD i - k) * (e i s)^2 + k / 2 * (e i s - Delta i s / k)^2)) by ring.
          rewrite <- sum_scal. apply sum_ext. intros; ring.
      - replace (- sum d (fun i => KD i * (e i s)^2)) with (sum d (fun i => -1 * (KD i * (e i s)^2)))
          by (rewrite sum_scal; ring).
        match goal with |- _ = ?a + ?b * ?u - ?c * ?v => replace (a + b * u - c * v)
          with (a + b * u + (- c) * v) by ring end.
        rewrite <- !sum_scal, <- !sum_plus. apply sum_ext. intros i _. field. lra. }
    apply (Rmult_le_reg_l (k / 2)); [lra|].
    replace (k / 2 * (2 * Vt 0 / k + RInt (square Delta) 0 t / k^2))
      with (Vt 0 + / (2 * k) * RInt (square Delta) 0 t) by (field; lra).
    lra.
  Qed.
End MeanSquare.

(* Theorem 3.4, corrected *)
Theorem theorem_3_4 (d N : nat) theta alpha_M KD GammaD gamma k phi_x phi_z zc Delta x z alpha K Gamma :
  0 < gamma -> 0 < k -> (forall i, (i < d)%nat -> k <= KD i) ->
  closed_loop d N theta alpha_M KD GammaD gamma phi_x phi_z zc Delta x z alpha K Gamma ->
  (forall t, 0 <= t -> ex_RInt (square d Delta) 0 t) -> piecewise_continuous (square d Delta) ->
  forall t, 0 <= t ->
  RInt (square d (e x z)) 0 t <=
    2 * Lyapunov d N theta KD GammaD gamma x z alpha K Gamma 0 / k + RInt (square d Delta) 0 t / k^2.
Proof.
  intros G Hk Kl loop I P t Ht.
  apply (mean_square d N KD gamma k (e x z) (eta theta alpha) (kappa KD K) (nu GammaD Gamma)
    phi_x z zc Delta); auto. apply errors with (1 := loop).
Qed.
Print Assumptions theorem_3_4.

(* Theorem 3.2: what is spent, int e^T KD e <= V(0) *)
Theorem theorem_3_2_spent (d N : nat) theta alpha_M KD GammaD gamma phi_x phi_z zc Delta x z alpha K Gamma :
  0 < gamma -> (forall i, (i < d)%nat -> 0 < KD i) ->
  closed_loop d N theta alpha_M KD GammaD gamma phi_x phi_z zc Delta x z alpha K Gamma ->
  (forall i t, (i < d)%nat -> 0 <= t -> Delta i t = 0) ->
  forall t, 0 <= t -> RInt (fun s => sum d (fun i => KD i * (x i s - z i s)^2)) 0 t
    <= Lyapunov d N theta KD GammaD gamma x z alpha K Gamma 0.
Proof.
  intros G HK loop no t Ht. set (g := fun s => sum d (fun i => KD i * (x i s - z i s)^2)).
  assert (Cg : forall s, 0 <= s -> continuous g s).
  { intros s Hs. apply (continuous_sum d (fun i t => KD i * (x i t - z i t)^2)). intros i Hi.
    apply (follows_scal (KD i) _ _ (follows_square _ _
      (follows_minus _ _ _ _ (x_follows _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ loop i Hi)
         (z_follows _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ loop i Hi)))), Hs. }
  assert (F : follows (fun t => RInt (right g) 0 t) g).
  { apply follows_integral.
    - intros s Hs. apply (@ex_RInt_continuous R_CompleteNormedModule). intros u Hu.
      rewrite Rmin_left in Hu by lra. apply Cg. lra.
    - intros T. exists nil. intros s Hs _. apply Cg. lra. }
  assert (W := falls _ _ 0 t (follows_plus _ _ _ _
    (theorem_3_2_rate d N theta alpha_M KD GammaD gamma phi_x phi_z zc Delta x z alpha K Gamma G loop no) F)
    ltac:(lra)). cbv beta in W.
  assert (R0 : RInt (right g) 0 0 = 0) by apply (@RInt_point R_CompleteNormedModule).
  rewrite R0, (right_integral g t Ht) in W.
  assert (V0 : 0 <= Lyapunov d N theta KD GammaD gamma x z alpha K Gamma t)
    by (apply (V_nonneg d N gamma (e x z) (eta theta alpha) (kappa KD K) (nu GammaD Gamma)); auto).
  assert (L := W ltac:(intros s Hs; unfold g; lra)). lra.
Qed.
Print Assumptions theorem_3_2_spent.
