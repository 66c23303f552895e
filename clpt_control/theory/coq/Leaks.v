(* Laws with leaks s_1, s_2, s_3, functions of time that may depend on the states:

     alpha' = (21) - gamma s_1 alpha     K' = (22) - gamma s_2 K     Gamma' = (23) - gamma s_3 Gamma

     V' = -e^T KD e - s_1 (theta + alpha).alpha - s_2 (K - KD).K - s_3 (Gamma - GammaD).Gamma

   With constant leaks V is bounded.  Where a leak acts only on what is at least as large as the
   truth, V falls and e -> 0. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem Barbalat PaperLoop AddedRates.
Open Scope R_scope.

(* y' <= -m y + c: y comes below c/m exponentially *)
Lemma decays y dy m c : 0 < m -> follows y dy -> (forall t, 0 < t -> dy t <= - m * y t + c) ->
  forall t, 0 <= t -> y t <= c / m + (y 0 - c / m) * exp (- m * t).
Proof.
  intros Hm F D t Ht.
  assert (G : follows (fun t => exp (m * t) * (y t - c / m))
                      (fun t => m * exp (m * t) * (y t - c / m) + exp (m * t) * (dy t - 0))).
  { apply follows_mult; [|apply follows_minus; [auto|apply follows_const]].
    apply follows_smooth. intros s. auto_derive; auto. ring. }
  assert (L : exp (m * t) * (y t - c / m) <= exp (m * 0) * (y 0 - c / m)).
  { apply (falls _ _ 0 t G); [lra|]. intros s Hs. assert (P := exp_pos (m * s)).
    assert (B := D s ltac:(lra)). assert (E : m * (c / m) = c) by (field; lra).
    assert (exp (m * s) * (dy s + m * (y s - c / m)) <= 0) by nra. lra. }
  rewrite Rmult_0_r, exp_0 in L. replace (- m * t) with (- (m * t)) by ring. rewrite exp_Ropp.
  assert (P := exp_pos (m * t)).
  apply (Rmult_le_compat_l (/ exp (m * t))) in L; [|apply Rlt_le, Rinv_0_lt_compat, P].
  rewrite <- Rmult_assoc, Rinv_l in L by lra. lra.
Qed.

(* y' <= 0 where y > L: y does not pass the larger of L and y(0) *)
Lemma stays_below y dy L : follows y dy -> (forall t, 0 < t -> L < y t -> dy t <= 0) ->
  forall t, 0 <= t -> y t <= Rmax (y 0) L.
Proof.
  intros F D t Ht. set (M := Rmax (y 0) L). assert (M0 : y 0 <= M) by apply Rmax_l.
  assert (M1 : L <= M) by apply Rmax_r. destruct (Rle_lt_dec (y t) M) as [|Above]; auto. exfalso.
  (* s is the last time before t at which y <= M *)
  destruct (completeness (fun u => 0 <= u <= t /\ y u <= M)) as [s [Up Least]].
  { exists t. intros u [Hu _]. lra. }
  { exists 0. split; auto. lra. }
  assert (Hs : 0 <= s <= t) by (split; [apply Up; split; auto; lra|apply Least; intros u [Hu _]; lra]).
  assert (After : forall u, s < u <= t -> M < y u).
  { intros u Hu. destruct (Rlt_le_dec M (y u)) as [|Le]; auto.
    assert (u <= s) by (apply Up; split; auto; lra). lra. }
  assert (C := proj1 F s (proj1 Hs)). apply continuity_pt_filterlim in C.
  assert (Ys : y s <= M).
  { destruct (Rle_lt_dec (y s) M) as [|Gt]; auto. exfalso.
    destruct (C (y s - M) ltac:(lra)) as [h [Hh Near]].
    assert (Q : s <= s - Rmin h (t + 1) / 2 \/ 0 < Rmin h (t + 1)) by (right; apply Rmin_pos; lra).
    assert (B : is_upper_bound (fun u => 0 <= u <= t /\ y u <= M) (s - h / 2)).
    { intros u [Hu Le]. assert (u <= s) by (apply Up; split; auto).
      destruct (Rle_lt_dec u (s - h / 2)) as [|Close]; auto. exfalso.
      destruct (Req_dec u s) as [->|Ne]; [lra|].
      assert (A : Rabs (y u - y s) < y s - M).
      { apply Near. split; [split; [exact I|auto]|]. simpl. unfold R_dist. rewrite Rabs_left1; lra. }
      apply Rabs_lt_between in A. lra. }
    assert (s <= s - h / 2) by (apply Least, B). lra. }
  destruct (Req_dec s t) as [->|Ne]; [lra|].
  assert (y t <= y s) by (apply (falls y dy s t F); [lra|]; intros u Hu; apply D; [lra|];
    assert (A := After u ltac:(lra)); lra).
  lra.
Qed.

Section Leaks.
  Variables (d N : nat) (theta alpha_M : nat -> nat -> R) (KD GammaD : nat -> R) (gamma : R).
  Variables (phi_x phi_z zc : nat -> R -> R).
  Variables (x z : nat -> R -> R) (alpha : nat -> nat -> R -> R) (K Gamma : nat -> R -> R).
  Variables s_1 s_2 s_3 : R -> R.

  Definition leak_a i k t := - gamma * s_1 t * alpha i k t.
  Definition leak_b i t := - gamma * s_2 t * K i t.
  Definition leak_c i t := - gamma * s_3 t * Gamma i t.
  Definition leaking := added_loop d N theta alpha_M KD GammaD gamma phi_x phi_z zc x z alpha K Gamma
    leak_a leak_b leak_c.

  Definition squares (f : nat -> R) := sum d (fun i => (f i)^2).
  Definition squares2 (f : nat -> nat -> R) := sum d (fun i => sum N (fun k => (f i k)^2)).
  Definition loss t := sum d (fun i => KD i * (x i t - z i t)^2).
  Definition pull_1 t := sum d (fun i => sum N (fun k => (theta i k + alpha i k t) * alpha i k t)).
  Definition pull_2 t := sum d (fun i => (K i t - KD i) * K i t).
  Definition pull_3 t := sum d (fun i => (Gamma i t - GammaD i) * Gamma i t).
  Local Notation V := (Lyapunov d N theta KD GammaD gamma x z alpha K Gamma).

  Lemma leak_added t : added d N theta KD GammaD alpha K Gamma leak_a leak_b leak_c t
    = - gamma * (s_1 t * pull_1 t + s_2 t * pull_2 t + s_3 t * pull_3 t).
  Proof.
    unfold added, leak_a, leak_b, leak_c, pull_1, pull_2, pull_3.
    rewrite <- !sum_scal.
    rewrite (sum_ext d (fun i => sum N (fun k => (theta i k + alpha i k t) * (- gamma * s_1 t * alpha i k t)))
      (fun i => - gamma * (s_1 t * sum N (fun k => (theta i k + alpha i k t) * alpha i k t)))).
    2: { intros i _. rewrite <- !sum_scal. apply sum_ext. intros; ring. }
    rewrite (sum_ext d (fun i => (K i t - KD i) * (- gamma * s_2 t * K i t))
      (fun i => - gamma * (s_2 t * ((K i t - KD i) * K i t)))) by (intros; ring).
    rewrite (sum_ext d (fun i => (GammaD i - Gamma i t) * (- gamma * s_3 t * Gamma i t))
      (fun i => gamma * (s_3 t * ((Gamma i t - GammaD i) * Gamma i t)))) by (intros; ring).
    rewrite !sum_scal. ring.
  Qed.

  (* d.a = (|d|^2 + |a|^2 - |a*|^2)/2, d = a - a* *)
  Lemma pull_1_is t : pull_1 t = / 2 * (squares2 (fun i k => theta i k + alpha i k t)
    + squares2 (fun i k => alpha i k t) - squares2 theta).
  Proof.
    unfold pull_1, squares2.
    match goal with |- _ = / 2 * (?p + ?q - ?r) => replace (p + q - r) with (p + q + -1 * r) by ring end.
    rewrite <- !sum_scal, <- !sum_plus, <- !sum_scal. apply sum_ext. intros i _.
    rewrite <- !sum_scal, <- !sum_plus, <- !sum_scal. apply sum_ext. intros k _. field.
  Qed.

  Lemma pull_is (a true : nat -> R) : sum d (fun i => (a i - true i) * a i)
    = / 2 * (squares (fun i => a i - true i) + squares a - squares true).
  Proof.
    unfold squares.
    match goal with |- _ = / 2 * (?p + ?q - ?r) => replace (p + q - r) with (p + q + -1 * r) by ring end.
    rewrite <- !sum_scal, <- !sum_plus, <- !sum_scal. apply sum_ext. intros i _. field.
  Qed.

  Lemma squares_nonneg f : 0 <= squares f.
  Proof. apply sum_nonneg. intros. apply pow2_ge_0. Qed.
  Lemma squares2_nonneg f : 0 <= squares2 f.
  Proof. apply sum_nonneg. intros. apply sum_nonneg. intros. apply pow2_ge_0. Qed.

  Hypothesis gamma_positive : 0 < gamma.
  Hypothesis KD_positive : forall i, (i < d)%nat -> 0 < KD i.
  Hypothesis loop : leaking.

  Theorem leak_rate : follows V (fun t => - loss t - s_1 t * pull_1 t - s_2 t * pull_2 t - s_3 t * pull_3 t).
  Proof.
    apply (follows_by _ _ _ (added_rate _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ loop ltac:(lra))).
    intros t _. rewrite leak_added. unfold loss. field. lra.
  Qed.

  (* half the squared errors of what is learned, and half the squares of the truth *)
  Definition errors2 t := squares2 (fun i k => theta i k + alpha i k t)
    + squares (fun i => K i t - KD i) + squares (fun i => Gamma i t - GammaD i).
  Definition truth2 := squares2 theta + squares KD + squares GammaD.

  Lemma leak_below s t : 0 <= s -> s_1 t = s -> s_2 t = s -> s_3 t = s ->
    - loss t - s_1 t * pull_1 t - s_2 t * pull_2 t - s_3 t * pull_3 t
      <= - loss t - s / 2 * errors2 t + s / 2 * truth2.
  Proof.
    intros Hs -> -> ->. rewrite pull_1_is. unfold pull_2, pull_3. rewrite !pull_is. unfold errors2, truth2.
    assert (A := squares2_nonneg (fun i k => alpha i k t)). assert (B := squares_nonneg (fun i => K i t)).
    assert (C := squares_nonneg (fun i => Gamma i t)).
    assert (0 <= s * (squares2 (fun i k => alpha i k t) + squares (fun i => K i t) + squares (fun i => Gamma i t)))
      by (apply Rmult_le_pos; lra).
    lra.
  Qed.

  Lemma V_is t : V t = / 2 * (squares (fun i => x i t - z i t) + / gamma * errors2 t).
  Proof.
    unfold Lyapunov, errors2, squares, squares2.
    rewrite (sum_ext d (fun i => (GammaD i - Gamma i t)^2) (fun i => (Gamma i t - GammaD i)^2)) by (intros; ring).
    ring.
  Qed.

  (* constant leaks: V comes below c/m, c = leak |truth|^2/2 *)
  Theorem constant_leak s m : 0 < s -> 0 < m -> m <= gamma * s -> (forall i, (i < d)%nat -> m <= 2 * KD i) ->
    (forall t, 0 < t -> s_1 t = s /\ s_2 t = s /\ s_3 t = s) ->
    forall t, 0 <= t -> V t <= s / 2 * truth2 / m + (V 0 - s / 2 * truth2 / m) * exp (- m * t).
  Proof.
    intros Hs Hm Hg Hk E. apply (decays V _ m (s / 2 * truth2) Hm leak_rate). intros t Ht.
    destruct (E t Ht) as [E1 [E2 E3]]. eapply Rle_trans; [apply (leak_below s); auto; lra|]. rewrite V_is.
    assert (A : m / 2 * squares (fun i => x i t - z i t) <= loss t).
    { unfold squares, loss. rewrite <- sum_scal. apply sum_le. intros i Hi. assert (B := Hk i Hi).
      assert (0 <= (x i t - z i t)^2) by apply pow2_ge_0. nra. }
    assert (G : m * / gamma * errors2 t <= s * errors2 t).
    { apply Rmult_le_compat_r.
      - unfold errors2. assert (P1 := squares2_nonneg (fun i k => theta i k + alpha i k t)).
        assert (P2 := squares_nonneg (fun i => K i t - KD i)). assert (P3 := squares_nonneg (fun i => Gamma i t - GammaD i)). lra.
      - apply (Rmult_le_reg_r gamma); [lra|]. rewrite Rmult_assoc, Rinv_l by lra. lra. }
    lra.
  Qed.

  (* leaks s |e|: V does not pass the larger of V(0) and a level *)
  Theorem error_leak s k : 0 < s -> 0 < k -> (forall i, (i < d)%nat -> k <= KD i) ->
    (forall t, 0 < t -> let r := s * sqrt (squares (fun i => x i t - z i t)) in s_1 t = r /\ s_2 t = r /\ s_3 t = r) ->
    let c := s / 2 * truth2 in
    forall t, 0 <= t -> V t <= Rmax (V 0) (Rmax (c^2 / (2 * k^2)) (c / (s * gamma))).
  Proof.
    intros Hs Hk Kl E c. apply (stays_below V _ _ leak_rate). intros t Ht Above.
    set (n := sqrt (squares (fun i => x i t - z i t))) in *.
    assert (Pn : 0 <= n) by apply sqrt_pos.
    assert (En : n^2 = squares (fun i => x i t - z i t)) by (unfold n; rewrite <- Rsqr_pow2, Rsqr_sqrt; auto; apply squares_nonneg).
    destruct (E t Ht) as [E1 [E2 E3]]. fold n in E1, E2, E3.
    eapply Rle_trans; [apply (leak_below (s * n)); auto; apply Rmult_le_pos; lra|].
    assert (A : k * n^2 <= loss t).
    { rewrite En. unfold squares, loss. rewrite <- sum_scal. apply sum_le. intros i Hi. assert (B := Kl i Hi).
      assert (0 <= (x i t - z i t)^2) by apply pow2_ge_0. nra. }
    assert (P2 : 0 <= errors2 t).
    { unfold errors2. assert (Q1 := squares2_nonneg (fun i k => theta i k + alpha i k t)).
      assert (Q2 := squares_nonneg (fun i => K i t - KD i)). assert (Q3 := squares_nonneg (fun i => Gamma i t - GammaD i)). lra. }
    assert (Pc : 0 <= c).
    { unfold c, truth2. assert (Q1 := squares2_nonneg theta). assert (Q2 := squares_nonneg KD).
      assert (Q3 := squares_nonneg GammaD). apply Rmult_le_pos; lra. }
    assert (Big : c <= k * n + s / 2 * errors2 t).
    { destruct (Rle_lt_dec c (k * n + s / 2 * errors2 t)) as [|Small]; auto. exfalso.
      set (u := k * n) in *. set (v := s / 2 * errors2 t) in *.
      assert (Pu : 0 <= u) by (apply Rmult_le_pos; lra). assert (Pv : 0 <= v) by (apply Rmult_le_pos; lra).
      assert (Ev : V t = u^2 / (2 * k^2) + v / (s * gamma)).
      { rewrite V_is, <- En. unfold u, v. field. lra. }
      set (m := Rmax (c^2 / (2 * k^2)) (c / (s * gamma))) in *.
      assert (M1 : c^2 / (2 * k^2) <= m) by apply Rmax_l. assert (M2 : c / (s * gamma) <= m) by apply Rmax_r.
      assert (I1 : 0 < / (2 * k^2)) by (apply Rinv_0_lt_compat; nra).
      assert (I2 : 0 < / (s * gamma)) by (apply Rinv_0_lt_compat; nra).
      unfold Rdiv in *. set (p := / (2 * k^2)) in *. set (q := / (s * gamma)) in *.
      assert (Pm : 0 <= m) by nra.
      (* c V <= u m + v m <= c m *)
      assert (0 <= u * c * p * (c - u)) by (apply Rmult_le_pos; [apply Rmult_le_pos; [apply Rmult_le_pos|]|]; lra).
      assert (u * (c^2 * p) <= u * m) by (apply Rmult_le_compat_l; lra).
      assert (v * (c * q) <= v * m) by (apply Rmult_le_compat_l; lra).
      assert ((u + v) * m <= c * m) by (apply Rmult_le_compat_r; lra).
      assert (c * V t <= c * m) by (rewrite Ev; lra).
      assert (c * m < c * V t) by (apply Rmult_lt_compat_l; lra). lra. }
    assert (n * c <= n * (k * n + s / 2 * errors2 t)) by (apply Rmult_le_compat_l; auto).
    replace (s * n / 2 * truth2) with (n * c) by (unfold c; field). simpl in A. nra.
  Qed.

  (* leaks that act only where alpha, K and Gamma are at least as large as the truth *)
  Hypothesis beyond : forall t, 0 < t -> 0 <= s_1 t /\ 0 <= s_2 t /\ 0 <= s_3 t /\
    (s_1 t = 0 \/ squares2 theta <= squares2 (fun i k => alpha i k t)) /\
    (s_2 t = 0 \/ squares KD <= squares (fun i => K i t)) /\
    (s_3 t = 0 \/ squares GammaD <= squares (fun i => Gamma i t)).

  Lemma beyond_added t : 0 < t -> added d N theta KD GammaD alpha K Gamma leak_a leak_b leak_c t <= 0.
  Proof.
    intros Ht. destruct (beyond t Ht) as [P1 [P2 [P3 [B1 [B2 B3]]]]].
    assert (A1 : 0 <= s_1 t * pull_1 t).
    { destruct B1 as [->|B]; [lra|]. apply Rmult_le_pos; auto. rewrite pull_1_is.
      assert (Q := squares2_nonneg (fun i k => theta i k + alpha i k t)). lra. }
    assert (A2 : 0 <= s_2 t * pull_2 t).
    { destruct B2 as [->|B]; [lra|]. apply Rmult_le_pos; auto. unfold pull_2. rewrite pull_is.
      assert (Q := squares_nonneg (fun i => K i t - KD i)). lra. }
    assert (A3 : 0 <= s_3 t * pull_3 t).
    { destruct B3 as [->|B]; [lra|]. apply Rmult_le_pos; auto. unfold pull_3. rewrite pull_is.
      assert (Q := squares_nonneg (fun i => Gamma i t - GammaD i)). lra. }
    rewrite leak_added. nra.
  Qed.

  Theorem beyond_falls s t : 0 <= s <= t -> V t <= V s.
  Proof. apply (added_falls _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ loop gamma_positive KD_positive beyond_added). Qed.

  Theorem beyond_converges : (forall k, (k < N)%nat -> bounded (phi_x k)) -> (forall i, (i < d)%nat -> bounded (zc i)) ->
    forall i, (i < d)%nat -> is_lim (fun t => x i t - z i t) p_infty 0.
  Proof.
    intros Bp Bz. apply (added_converges _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ loop gamma_positive KD_positive
      beyond_added Bp Bz).
  Qed.
End Leaks.
