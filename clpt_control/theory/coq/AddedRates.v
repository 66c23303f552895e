(* Laws that add rates to those of Eqs. (21)-(23), for d axes and N functions, both any numbers:

     alpha_ik' = -gamma e_i phi_k + a_ik     K_i' = -gamma z_i e_i + b_i     Gamma_i' = gamma zc_i e_i + c_i

   With V of Eq. (24), eta = theta + alpha, kappa = K - KD and nu = GammaD - Gamma,

     V' = -e^T KD e + added/gamma,     added = sum eta_ik a_ik + sum kappa_i b_i - sum nu_i c_i

   Where added <= 0, V falls, what is learned is bounded, and e -> 0. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem Barbalat PaperLoop.
Open Scope R_scope.

Section AddedRates.
  Variables (d N : nat) (theta alpha_M : nat -> nat -> R) (KD GammaD : nat -> R) (gamma : R).
  Variables (phi_x phi_z zc : nat -> R -> R).
  Variables (x z : nat -> R -> R) (alpha : nat -> nat -> R -> R) (K Gamma : nat -> R -> R).
  Variables (a : nat -> nat -> R -> R) (b c : nat -> R -> R).

  Local Notation "f @ t" := (fun i => f i t) (at level 5).
  Local Notation "f @@ t" := (fun i k => f i k t) (at level 5).
  Local Notation level_at t := (level d N gamma (fun i => x i t - z i t)
    (fun i k => theta i k + alpha i k t) (fun i => K i t - KD i) (fun i => GammaD i - Gamma i t)).

  Record added_loop : Prop := {
    added_x : forall i, (i < d)%nat ->
      follows (x i) (fun t => x_rate N theta alpha_M KD GammaD x@t phi_x@t zc@t (fun _ => 0) i);
    added_z : forall i, (i < d)%nat ->
      follows (z i) (fun t => z_rate N alpha_M z@t alpha@@t K@t Gamma@t phi_x@t phi_z@t zc@t i);
    added_alpha : forall i k, (i < d)%nat -> (k < N)%nat ->
      follows (alpha i k) (fun t => alpha_rate gamma x@t z@t phi_x@t i k + a i k t);
    added_K : forall i, (i < d)%nat -> follows (K i) (fun t => K_rate gamma x@t z@t i + b i t);
    added_Gamma : forall i, (i < d)%nat ->
      follows (Gamma i) (fun t => Gamma_rate gamma x@t z@t zc@t i + c i t) }.

  Definition added t :=
    sum d (fun i => sum N (fun k => (theta i k + alpha i k t) * a i k t))
    + sum d (fun i => (K i t - KD i) * b i t) - sum d (fun i => (GammaD i - Gamma i t) * c i t).

  (* Eq. (27), whatever alpha, K and Gamma are *)
  Definition error_rate_at i t :=
    - KD i * (x i t - z i t) + sum N (fun k => (theta i k + alpha i k t) * phi_x k t)
    + (K i t - KD i) * z i t + (GammaD i - Gamma i t) * zc i t.

  Hypothesis loop : added_loop.

  Lemma error_follows i : (i < d)%nat -> follows (fun t => x i t - z i t) (error_rate_at i).
  Proof.
    intros Hi. destruct loop as [Hx Hz _ _ _].
    apply (follows_by _ _ _ (follows_minus _ _ _ _ (Hx i Hi) (Hz i Hi))). intros t _.
    rewrite error_rate. unfold error_rate_at, e_rate, error. ring.
  Qed.

  Theorem added_rate : gamma <> 0 -> follows (Lyapunov d N theta KD GammaD gamma x z alpha K Gamma)
    (fun t => - sum d (fun i => KD i * (x i t - z i t)^2) + / gamma * added t).
  Proof.
    intros G. assert (He := error_follows). destruct loop as [_ _ Ha HK HG].
    apply (follows_by _ (fun t => / 2 * (sum d (fun i => 2 * (x i t - z i t) * error_rate_at i t)
      + / gamma * (sum d (fun i => sum N (fun k => 2 * (theta i k + alpha i k t)
            * (0 + (alpha_rate gamma x@t z@t phi_x@t i k + a i k t))))
          + sum d (fun i => 2 * (K i t - KD i) * (K_rate gamma x@t z@t i + b i t - 0))
          + sum d (fun i => 2 * (GammaD i - Gamma i t) * (0 - (Gamma_rate gamma x@t z@t zc@t i + c i t))))))).
    - unfold Lyapunov. apply follows_scal, follows_plus.
      + apply (follows_sum d (fun i t => (x i t - z i t)^2)). intros i Hi.
        apply (follows_square (fun t => x i t - z i t)), He, Hi.
      + apply follows_scal, follows_plus; [apply follows_plus|].
        * apply (follows_sum d (fun i t => sum N (fun k => (theta i k + alpha i k t)^2))). intros i Hi.
          apply (follows_sum N (fun k t => (theta i k + alpha i k t)^2)). intros k Hk.
          apply (follows_square (fun t => theta i k + alpha i k t)), follows_plus; auto. apply follows_const.
        * apply (follows_sum d (fun i t => (K i t - KD i)^2)). intros i Hi.
          apply (follows_square (fun t => K i t - KD i)), follows_minus; auto. apply follows_const.
        * apply (follows_sum d (fun i t => (GammaD i - Gamma i t)^2)). intros i Hi.
          apply (follows_square (fun t => GammaD i - Gamma i t)), follows_minus; auto. apply follows_const.
    - intros t _.
      assert (I := identity d N KD gamma (fun i => x i t - z i t) (fun i k => theta i k + alpha i k t)
        (fun i => K i t - KD i) (fun i => GammaD i - Gamma i t) phi_x@t z@t zc@t (fun _ => 0) G).
      unfold level_rate, e_rate, eta_rate, kappa_rate, nu_rate in I.
      assert (Z : sum d (fun i => (x i t - z i t) * 0) = 0)
        by (rewrite (sum_ext d _ (fun _ => 0 * 0)), sum_scal by (intros; ring); ring).
      rewrite Z, Rplus_0_r in I. rewrite <- I. unfold added, error_rate_at, alpha_rate, K_rate, Gamma_rate, error.
      assert (D : forall q f g h, (forall i, h i = f i + q * g i) -> sum d h = sum d f + q * sum d g).
      { intros q f g h H. rewrite <- sum_scal, <- sum_plus. apply sum_ext. auto. }
      lazymatch goal with |- / 2 * (?S1 + / gamma * (?S2 + ?S3 + ?S4))
          = / 2 * (?T1 + / gamma * (?T2 + ?T3 + ?T4)) + / gamma * (?A2 + ?A3 - ?A4) =>
        assert (E1 : S1 = T1) by (apply sum_ext; intros; ring);
        assert (E2 : S2 = T2 + 2 * A2) by (apply D; intros; rewrite <- sum_scal, <- sum_plus; apply sum_ext; intros; ring);
        assert (E3 : S3 = T3 + 2 * A3) by (apply D; intros; ring);
        assert (E4 : S4 = T4 + -2 * A4) by (apply D; intros; ring) end.
      rewrite E1, E2, E3, E4.
      field. exact G.
  Qed.

  Hypothesis gamma_positive : 0 < gamma.
  Hypothesis KD_positive : forall i, (i < d)%nat -> 0 < KD i.
  Hypothesis added_nonpositive : forall t, 0 < t -> added t <= 0.

  Let V := Lyapunov d N theta KD GammaD gamma x z alpha K Gamma.

  Lemma term_nonneg t i : (i < d)%nat -> 0 <= KD i * (x i t - z i t)^2.
  Proof. intros Hi. apply Rmult_le_pos; [apply Rlt_le; auto|apply pow2_ge_0]. Qed.

  Lemma added_dissipates t : 0 < t ->
    - sum d (fun i => KD i * (x i t - z i t)^2) + / gamma * added t <= - sum d (fun i => KD i * (x i t - z i t)^2).
  Proof.
    intros Ht. assert (0 < / gamma) by (apply Rinv_0_lt_compat; auto).
    assert (A := added_nonpositive t Ht). nra.
  Qed.

  Theorem added_falls s t : 0 <= s <= t -> V t <= V s.
  Proof.
    intros Hst. apply (falls _ _ s t (added_rate ltac:(lra))); auto. intros u Hu.
    assert (A := added_dissipates u ltac:(lra)).
    assert (0 <= sum d (fun i => KD i * (x i u - z i u)^2)) by (apply sum_nonneg, term_nonneg). lra.
  Qed.

  Lemma square_bounded (f : R -> R) q :
    (forall t, 0 <= t -> (f t)^2 <= q * V t) -> 0 <= q -> bounded f.
  Proof.
    intros H Hq. exists (sqrt (q * V 0)). intros t Ht.
    assert (A := H t Ht). assert (B := added_falls 0 t ltac:(lra)).
    rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold Rsqr. nra.
  Qed.

  Theorem added_errors_bounded i : (i < d)%nat ->
    bounded (fun t => x i t - z i t) /\ bounded (K i) /\ bounded (Gamma i) /\
    forall k, (k < N)%nat -> bounded (alpha i k).
  Proof.
    intros Hi.
    assert (B := fun t => level_bounds d N gamma (fun i => x i t - z i t) (fun i k => theta i k + alpha i k t)
      (fun i => K i t - KD i) (fun i => GammaD i - Gamma i t) gamma_positive i Hi).
    split; [|split; [|split; [|intros k Hk]]].
    - apply (square_bounded _ 2); [|lra]. intros t _. apply (B t).
    - apply (bounded_ext (fun t => (K i t - KD i) + KD i)); [intros; ring|].
      apply bounded_plus; [|apply bounded_const]. apply (square_bounded _ (2 * gamma)); [|lra]. intros t _. apply (B t).
    - apply (bounded_ext (fun t => GammaD i - (GammaD i - Gamma i t))); [intros; ring|].
      apply bounded_minus; [apply bounded_const|]. apply (square_bounded _ (2 * gamma)); [|lra]. intros t _. apply (B t).
    - apply (bounded_ext (fun t => (theta i k + alpha i k t) - theta i k)); [intros; ring|].
      apply bounded_minus; [|apply bounded_const]. apply (square_bounded _ (2 * gamma)); [|lra].
      intros t _. destruct (B t) as [_ [_ [_ Bk]]]. apply Bk, Hk.
  Qed.

  Hypothesis phi_x_bounded : forall k, (k < N)%nat -> bounded (phi_x k).
  Hypothesis zc_bounded : forall i, (i < d)%nat -> bounded (zc i).

  Theorem vehicle_bounded i : (i < d)%nat -> bounded (x i).
  Proof.
    intros Hi. destruct loop as [Hx _ _ _ _].
    apply (stable (KD i) (x i) (fun t => sum N (fun k => (theta i k - alpha_M i k) * phi_x k t)
      + GammaD i * zc i t + 0)); [apply KD_positive, Hi| |].
    - apply (follows_by _ _ _ (Hx i Hi)). intros t _. apply vehicle.
    - apply bounded_plus; [|apply bounded_const]. apply bounded_plus.
      + apply (bounded_sum N (fun k t => (theta i k - alpha_M i k) * phi_x k t)). intros k Hk.
        apply bounded_mult; [apply bounded_const|apply phi_x_bounded, Hk].
      + apply bounded_mult; [apply bounded_const|apply zc_bounded, Hi].
  Qed.

  Theorem added_x_bounded i : (i < d)%nat -> bounded (x i) /\ bounded (z i).
  Proof.
    intros Hi. destruct (added_errors_bounded i Hi) as [Be _]. assert (Bx := vehicle_bounded i Hi). split; auto.
    apply (bounded_ext (fun t => x i t - (x i t - z i t))); [intros; ring|apply bounded_minus; auto].
  Qed.

  Theorem added_converges i : (i < d)%nat -> is_lim (fun t => x i t - z i t) p_infty 0.
  Proof.
    intros Hi. set (e := fun t => x i t - z i t).
    destruct (added_errors_bounded i Hi) as [Be [BK [BG Ba]]]. destruct (added_x_bounded i Hi) as [Bx Bz].
    assert (Br : bounded (error_rate_at i)).
    { unfold error_rate_at. apply bounded_plus; [apply bounded_plus; [apply bounded_plus|]|].
      - apply bounded_mult; auto. apply bounded_const.
      - apply (bounded_sum N (fun k t => (theta i k + alpha i k t) * phi_x k t)). intros k Hk.
        apply bounded_mult; auto. apply bounded_plus; auto. apply bounded_const.
      - apply bounded_mult; auto. apply bounded_minus; auto. apply bounded_const.
      - apply bounded_mult; auto. apply bounded_minus; auto. apply bounded_const. }
    apply (square_vanishes (KD i)); auto.
    apply (barbalat_dissipation V _ _ (added_rate ltac:(lra))).
    - intros t _. apply (level_nonneg d N gamma (fun i => x i t - z i t)); auto.
    - intros t _. apply term_nonneg, Hi.
    - intros t Ht. eapply Rle_trans; [apply added_dissipates, Ht|]. apply Ropp_le_contravar.
      apply (sum_member d (fun i => KD i * (x i t - z i t)^2)); auto. apply term_nonneg.
    - destruct (bounded_mult _ _ (bounded_const (KD i * 2)) (bounded_mult _ _ Be Br)) as [L HL]. exists L.
      apply (lipschitz _ (fun t => KD i * (2 * e t * error_rate_at i t))).
      + apply follows_scal, (follows_square e), error_follows, Hi.
      + intros t Ht. replace (KD i * (2 * e t * error_rate_at i t))
          with (KD i * 2 * ((x i t - z i t) * error_rate_at i t)) by (unfold e; ring). apply HL. lra.
  Qed.
End AddedRates.
