(* The dead-zone law for d axes and N functions, both any numbers: D_i = e_i - clip(e_i, -b, b) in
   place of e_i in Eqs. (21)-(23), and in V of Eq. (24):

     V' = -D^T KD e <= -D^T KD D

   V has a derivative at every time, also where e enters or leaves the zone (which it may do
   infinitely often), as D^2/2 has the derivative D.  V falls, and D -> 0: |e_i| comes to at most b. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem Barbalat PaperLoop AddedRates TwoAxes.
Open Scope R_scope.

Definition beyond (b s : R) := s - clip s (- b) b.

Lemma beyond_cases b s : 0 <= b ->
  (s <= - b /\ beyond b s = s + b) \/ (- b <= s <= b /\ beyond b s = 0) \/ (b <= s /\ beyond b s = s - b).
Proof. intros Hb. unfold beyond, clip, Rmin, Rmax. repeat destruct Rle_dec; lra. Qed.

(* D^2/2 lies within h^2/2 of its tangent *)
Lemma beyond_smooth b s h : 0 <= b ->
  0 <= beyond b (s + h) ^ 2 / 2 - beyond b s ^ 2 / 2 - beyond b s * h <= h ^ 2 / 2.
Proof.
  intros Hb. destruct (beyond_cases b s Hb) as [[A ->]|[[A ->]|[A ->]]];
    destruct (beyond_cases b (s + h) Hb) as [[B ->]|[[B ->]|[B ->]]]; nra.
Qed.

Lemma beyond_derive b s : 0 <= b -> is_derive (fun s => beyond b s ^ 2 / 2) s (beyond b s).
Proof.
  intros Hb. apply is_derive_Reals. intros eps He. exists (mkposreal eps He). intros h Hh Small. simpl in Small.
  assert (A := beyond_smooth b s h Hb). set (q := beyond b (s + h) ^ 2 / 2 - beyond b s ^ 2 / 2 - beyond b s * h) in *.
  replace ((beyond b (s + h) ^ 2 / 2 - beyond b s ^ 2 / 2) / h - beyond b s) with (q / h) by (unfold q; field; auto).
  unfold Rdiv. rewrite Rabs_mult, Rabs_Rinv by auto. rewrite (Rabs_pos_eq q) by lra.
  assert (P : 0 < Rabs h) by (apply Rabs_pos_lt; auto).
  apply Rmult_lt_reg_r with (Rabs h); auto. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
  assert (E : h ^ 2 = Rabs h * Rabs h).
  { simpl. rewrite Rmult_1_r, <- Rabs_mult. symmetry. apply Rabs_pos_eq. apply Rle_0_sqr. }
  assert (M : Rabs h * Rabs h < eps * Rabs h) by (apply Rmult_lt_compat_r; auto).
  apply Rle_lt_trans with (Rabs h * Rabs h); [|auto]. assert (0 <= Rabs h * Rabs h) by (apply Rmult_le_pos; lra). lra.
Qed.

(* along a trajectory: (D^2/2)' = D e' *)
Lemma beyond_follows b e de : 0 <= b -> follows e de ->
  follows (fun t => beyond b (e t) ^ 2 / 2) (fun t => beyond b (e t) * de t).
Proof.
  intros Hb [C F]. split.
  - intros t Ht. apply (continuous_comp e (fun s => beyond b s ^ 2 / 2)); [auto|].
    apply (ex_derive_continuous (fun s => beyond b s ^ 2 / 2)). exists (beyond b (e t)). apply beyond_derive, Hb.
  - intros T. destruct (F T) as [l H]. exists l. intros t Ht Nin.
    replace (beyond b (e t) * de t) with (de t * beyond b (e t)) by ring.
    apply (is_derive_comp (fun s => beyond b s ^ 2 / 2) e); [apply beyond_derive, Hb|auto].
Qed.

(* -D KD e <= -D KD D *)
Lemma beyond_loss b s k : 0 <= b -> 0 < k -> - (beyond b s * (k * s)) <= - (k * beyond b s ^ 2).
Proof.
  intros Hb Hk. assert (A : 0 <= beyond b s * (s - beyond b s)).
  { destruct (beyond_cases b s Hb) as [[A ->]|[[A ->]|[A ->]]]; nra. }
  assert (B := Rmult_le_pos k _ (Rlt_le _ _ Hk) A). nra.
Qed.

Section DeadZone.
  Variables (d N : nat) (theta alpha_M : nat -> nat -> R) (KD GammaD : nat -> R) (gamma zone : R).
  Variables (phi_x phi_z zc : nat -> R -> R).
  Variables (x z : nat -> R -> R) (alpha : nat -> nat -> R -> R) (K Gamma : nat -> R -> R).

  Definition outside i t := beyond zone (x i t - z i t).
  (* D in place of e, as rates that are added to Eqs. (21)-(23) *)
  Definition dead_a i k t := gamma * (x i t - z i t - outside i t) * phi_x k t.
  Definition dead_b i t := gamma * z i t * (x i t - z i t - outside i t).
  Definition dead_c i t := - gamma * zc i t * (x i t - z i t - outside i t).
  Definition dead_V t := level d N gamma (fun i => outside i t) (fun i k => theta i k + alpha i k t)
    (fun i => K i t - KD i) (fun i => GammaD i - Gamma i t).

  Hypothesis gamma_positive : 0 < gamma.
  Hypothesis KD_positive : forall i, (i < d)%nat -> 0 < KD i.
  Hypothesis zone_positive : 0 <= zone.
  Hypothesis loop : added_loop d N theta alpha_M KD GammaD gamma phi_x phi_z zc x z alpha K Gamma
    dead_a dead_b dead_c.

  Local Notation rate_at := (error_rate_at N theta KD GammaD phi_x zc x z alpha K Gamma).

  Lemma e_follows i : (i < d)%nat -> follows (fun t => x i t - z i t) (rate_at i).
  Proof. apply (error_follows _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ loop). Qed.

  Theorem dead_rate : follows dead_V (fun t => - sum d (fun i => outside i t * (KD i * (x i t - z i t)))).
  Proof.
    assert (G : gamma <> 0) by lra.
    apply (follows_ext (fun t => Lyapunov d N theta KD GammaD gamma x z alpha K Gamma t
        + (sum d (fun i => outside i t ^ 2 / 2) - / 2 * sum d (fun i => (x i t - z i t)^2)))
      (fun t => (- sum d (fun i => KD i * (x i t - z i t)^2)
          + / gamma * added d N theta KD GammaD alpha K Gamma dead_a dead_b dead_c t)
        + (sum d (fun i => outside i t * rate_at i t) - / 2 * sum d (fun i => 2 * (x i t - z i t) * rate_at i t)))).
    - intros t. unfold dead_V, level, Lyapunov.
      rewrite (sum_ext d (fun i => outside i t ^ 2 / 2) (fun i => / 2 * outside i t ^ 2)), sum_scal by (intros; field).
      ring.
    - intros t _. unfold added.
      rewrite (sum_ext d (fun i => sum N (fun k => (theta i k + alpha i k t) * dead_a i k t))
        (fun i => gamma * ((x i t - z i t - outside i t) * sum N (fun k => (theta i k + alpha i k t) * phi_x k t)))).
      2: { intros i _. rewrite <- !sum_scal. apply sum_ext. intros. unfold dead_a. ring. }
      rewrite (sum_ext d (fun i => (K i t - KD i) * dead_b i t)
        (fun i => gamma * ((x i t - z i t - outside i t) * ((K i t - KD i) * z i t)))) by (intros; unfold dead_b; ring).
      rewrite (sum_ext d (fun i => (GammaD i - Gamma i t) * dead_c i t)
        (fun i => - gamma * ((x i t - z i t - outside i t) * ((GammaD i - Gamma i t) * zc i t))))
        by (intros; unfold dead_c; ring).
      rewrite !sum_scal.
      rewrite (sum_ext d (fun i => 2 * (x i t - z i t) * rate_at i t) (fun i => 2 * ((x i t - z i t) * rate_at i t))), sum_scal
        by (intros; ring).
      lazymatch goal with |- - ?L + / gamma * (gamma * ?P + gamma * ?Q - - gamma * ?R) + (?S - / 2 * (2 * ?E)) = - ?F =>
        assert (Balance : S = E + (-1 * (P + Q + R) + (L + -1 * F))) end.
      { rewrite <- !sum_plus, <- !sum_scal, <- !sum_plus. apply sum_ext. intros i _. unfold error_rate_at. ring. }
      rewrite Balance. field. exact G.
    - apply follows_plus; [apply (added_rate _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ loop G)|].
      apply follows_minus; [|apply follows_scal].
      + apply (follows_sum d (fun i t => outside i t ^ 2 / 2) (fun i t => outside i t * rate_at i t)). intros i Hi.
        apply (beyond_follows zone (fun t => x i t - z i t)); auto. apply e_follows, Hi.
      + apply (follows_sum d (fun i t => (x i t - z i t)^2) (fun i t => 2 * (x i t - z i t) * rate_at i t)). intros i Hi.
        apply (follows_square (fun t => x i t - z i t)), e_follows, Hi.
  Qed.

  Lemma dead_term_nonneg t i : (i < d)%nat -> 0 <= KD i * outside i t ^ 2.
  Proof. intros Hi. apply Rmult_le_pos; [apply Rlt_le; auto|apply pow2_ge_0]. Qed.

  Theorem dead_dissipates t : - sum d (fun i => outside i t * (KD i * (x i t - z i t)))
    <= - sum d (fun i => KD i * outside i t ^ 2).
  Proof.
    apply Ropp_le_contravar, sum_le. intros i Hi. assert (A := beyond_loss zone (x i t - z i t) (KD i)).
    fold (outside i t) in A. assert (B := A zone_positive (KD_positive i Hi)). lra.
  Qed.

  Theorem dead_falls s t : 0 <= s <= t -> dead_V t <= dead_V s.
  Proof.
    intros Hst. apply (falls _ _ s t dead_rate Hst). intros u _. eapply Rle_trans; [apply dead_dissipates|].
    assert (0 <= sum d (fun i => KD i * outside i u ^ 2)) by (apply sum_nonneg, dead_term_nonneg). lra.
  Qed.

  Lemma dead_square_bounded (f : R -> R) q : (forall t, 0 <= t -> (f t)^2 <= q * dead_V t) -> 0 <= q -> bounded f.
  Proof.
    intros H Hq. exists (sqrt (q * dead_V 0)). intros t Ht.
    assert (A := H t Ht). assert (B := dead_falls 0 t ltac:(lra)).
    rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold Rsqr. nra.
  Qed.

  (* what is learned stays bounded, whatever phi and zc are *)
  Theorem dead_errors_bounded i : (i < d)%nat ->
    bounded (outside i) /\ bounded (fun t => x i t - z i t) /\ bounded (fun t => K i t - KD i)
    /\ bounded (fun t => GammaD i - Gamma i t) /\ forall k, (k < N)%nat -> bounded (fun t => theta i k + alpha i k t).
  Proof.
    intros Hi.
    assert (B := fun t => level_bounds d N gamma (fun i => outside i t) (fun i k => theta i k + alpha i k t)
      (fun i => K i t - KD i) (fun i => GammaD i - Gamma i t) gamma_positive i Hi).
    assert (Bo : bounded (outside i)) by (apply (dead_square_bounded _ 2); [intros t _; apply (B t)|lra]).
    split; [exact Bo|split; [|split; [|split; [|intros k Hk]]]].
    - destruct Bo as [M HM]. exists (M + zone). intros t Ht. assert (A := HM t Ht). apply Rabs_le_between in A.
      unfold outside in A. apply Rabs_le.
      destruct (beyond_cases zone (x i t - z i t) zone_positive) as [[C E]|[[C E]|[C E]]]; rewrite E in A; lra.
    - apply (dead_square_bounded _ (2 * gamma)); [|lra]. intros t _. apply (B t).
    - apply (dead_square_bounded _ (2 * gamma)); [|lra]. intros t _. apply (B t).
    - apply (dead_square_bounded _ (2 * gamma)); [|lra]. intros t _. destruct (B t) as [_ [_ [_ Bk]]]. apply Bk, Hk.
  Qed.

  Hypothesis phi_x_bounded : forall k, (k < N)%nat -> bounded (phi_x k).
  Hypothesis zc_bounded : forall i, (i < d)%nat -> bounded (zc i).

  Theorem dead_converges i : (i < d)%nat -> is_lim (outside i) p_infty 0.
  Proof.
    intros Hi. destruct (dead_errors_bounded i Hi) as [Bo [Be [BK [BG Ba]]]].
    assert (Bx := vehicle_bounded _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ loop KD_positive phi_x_bounded zc_bounded i Hi).
    assert (Bz : bounded (z i))
      by (apply (bounded_ext (fun t => x i t - (x i t - z i t))); [intros; ring|apply bounded_minus; auto]).
    assert (Br : bounded (rate_at i)).
    { unfold error_rate_at. apply bounded_plus; [apply bounded_plus; [apply bounded_plus|]|].
      - apply bounded_mult; auto. apply bounded_const.
      - apply (bounded_sum N (fun k t => (theta i k + alpha i k t) * phi_x k t)). intros k Hk. apply bounded_mult; auto.
      - apply bounded_mult; auto.
      - apply bounded_mult; auto. }
    apply (square_vanishes (KD i)); auto.
    apply (barbalat_dissipation dead_V _ _ dead_rate).
    - intros t _. apply level_nonneg; auto.
    - intros t _. apply dead_term_nonneg, Hi.
    - intros t _. eapply Rle_trans; [apply dead_dissipates|]. apply Ropp_le_contravar.
      apply (sum_member d (fun i => KD i * outside i t ^ 2)); auto. apply dead_term_nonneg.
    - destruct (bounded_mult _ _ (bounded_const (KD i * 2)) (bounded_mult _ _ Bo Br)) as [L HL]. exists L.
      apply (lipschitz _ (fun t => KD i * 2 * (outside i t * rate_at i t))).
      + apply (follows_ext (fun t => KD i * 2 * (outside i t ^ 2 / 2)) (fun t => KD i * 2 * (outside i t * rate_at i t)));
          [intros; field|auto|]. apply follows_scal.
        apply (beyond_follows zone (fun t => x i t - z i t)); auto. apply e_follows, Hi.
      + intros t Ht. apply HL. lra.
  Qed.
End DeadZone.
