(* Trajectories of the error system: V falls, errors are bounded, e -> 0. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem Barbalat.
Open Scope R_scope.

Section Trajectories.
  Variables (d N : nat) (KD : nat -> R) (gamma : R).
  Variables (e : nat -> R -> R) (eta : nat -> nat -> R -> R) (kappa nu : nat -> R -> R).
  Variables (phi : nat -> R -> R) (z zc Delta : nat -> R -> R).

  (* the value at t of a family *)
  Local Notation "f @ t" := (fun i => f i t) (at level 5).
  Local Notation "f @@ t" := (fun i k => f i k t) (at level 5).

  Definition e_rate_at i t :=
    e_rate N KD e@t eta@@t kappa@t nu@t phi@t z@t zc@t Delta@t i.

  Record error_system : Prop := {
    e_follows : forall i, (i < d)%nat -> follows (e i) (e_rate_at i);
    eta_follows : forall i k, (i < d)%nat -> (k < N)%nat ->
      follows (eta i k) (fun t => eta_rate gamma e@t phi@t i k);
    kappa_follows : forall i, (i < d)%nat -> follows (kappa i) (fun t => kappa_rate gamma e@t z@t i);
    nu_follows : forall i, (i < d)%nat -> follows (nu i) (fun t => nu_rate gamma e@t zc@t i) }.

  Definition V t := level d N gamma e@t eta@@t kappa@t nu@t.

  (* dV/dt = -e^T KD e + e^T Delta *)
  Theorem V_follows : gamma <> 0 -> error_system ->
    follows V (fun t => - sum d (fun i => KD i * (e i t)^2) + sum d (fun i => e i t * Delta i t)).
  Proof.
    intros G [He Heta Hk Hn].
    apply (follows_ext V (fun t => level_rate d N KD gamma e@t eta@@t kappa@t nu@t phi@t z@t zc@t Delta@t));
      [auto|intros t _; apply identity, G|].
    unfold V, level, level_rate. apply follows_scal, follows_plus.
    - apply (follows_sum d (fun i t => (e i t)^2)). intros i Hi. apply (follows_square (e i)), He, Hi.
    - apply follows_scal, follows_plus; [apply follows_plus|].
      + apply (follows_sum d (fun i t => sum N (fun k => (eta i k t)^2))). intros i Hi.
        apply (follows_sum N (fun k t => (eta i k t)^2)). intros k Hk'.
        apply (follows_square (eta i k)). apply Heta; auto.
      + apply (follows_sum d (fun i t => (kappa i t)^2)). intros i Hi. apply (follows_square (kappa i)), Hk, Hi.
      + apply (follows_sum d (fun i t => (nu i t)^2)). intros i Hi. apply (follows_square (nu i)), Hn, Hi.
  Qed.

  Hypothesis gamma_positive : 0 < gamma.
  Hypothesis KD_positive : forall i, (i < d)%nat -> 0 < KD i.

  Lemma V_nonneg t : 0 <= V t.
  Proof. apply level_nonneg, gamma_positive. Qed.

  Section Undisturbed.
    Hypothesis loop : error_system.
    Hypothesis no_disturbance : forall i t, (i < d)%nat -> 0 <= t -> Delta i t = 0.

    Lemma V_rate : follows V (fun t => - sum d (fun i => KD i * (e i t)^2)).
    Proof.
      apply (follows_ext V (fun t => - sum d (fun i => KD i * (e i t)^2) + sum d (fun i => e i t * Delta i t)));
        auto; [|apply V_follows; [lra|auto]].
      intros t Ht. rewrite (sum_ext d (fun i => e i t * Delta i t) (fun _ => 0 * 0)).
      - rewrite (sum_scal d 0 (fun _ => 0)). ring.
      - intros i Hi. rewrite no_disturbance; [ring|auto|lra].
    Qed.

    Lemma term_nonneg t : forall i, (i < d)%nat -> 0 <= KD i * (e i t)^2.
    Proof. intros i Hi. apply Rmult_le_pos; [|apply pow2_ge_0]. apply Rlt_le; auto. Qed.

    Theorem V_falls s t : 0 <= s <= t -> V t <= V s.
    Proof.
      intros Hst. apply (falls _ _ s t V_rate); auto. intros u _.
      assert (0 <= sum d (fun i => KD i * (e i u)^2)) by (apply sum_nonneg, term_nonneg). lra.
    Qed.

    Lemma square_bounded (f : R -> R) c :
      (forall t, 0 <= t -> (f t)^2 <= c * V t) -> 0 <= c -> bounded f.
    Proof.
      intros H Hc. exists (sqrt (c * V 0)). intros t Ht.
      assert (A := H t Ht). assert (B := V_falls 0 t ltac:(lra)).
      rewrite <- sqrt_Rsqr_abs. apply sqrt_le_1_alt. unfold Rsqr. nra.
    Qed.

    Theorem errors_bounded i : (i < d)%nat ->
      bounded (e i) /\ bounded (kappa i) /\ bounded (nu i) /\
      forall k, (k < N)%nat -> bounded (eta i k).
    Proof.
      intros Hi.
      assert (B := fun t => level_bounds d N gamma e@t eta@@t kappa@t nu@t gamma_positive i Hi).
      split; [|split; [|split; [|intros k Hk]]].
      - apply (square_bounded (e i) 2); [|lra]. intros t _. apply (B t).
      - apply (square_bounded (kappa i) (2 * gamma)); [|lra]. intros t _. apply (B t).
      - apply (square_bounded (nu i) (2 * gamma)); [|lra]. intros t _. apply (B t).
      - apply (square_bounded (eta i k) (2 * gamma)); [|lra]. intros t _.
        destruct (B t) as [_ [_ [_ Bk]]]. apply Bk, Hk.
    Qed.

    Hypothesis phi_bounded : forall k, (k < N)%nat -> bounded (phi k).
    Hypothesis z_bounded : forall i, (i < d)%nat -> bounded (z i).
    Hypothesis zc_bounded : forall i, (i < d)%nat -> bounded (zc i).

    Lemma e_rate_bounded i : (i < d)%nat -> bounded (e_rate_at i).
    Proof.
      intros Hi. destruct (errors_bounded i Hi) as [Be [Bk [Bn Beta]]]. unfold e_rate_at, e_rate.
      apply bounded_plus; [apply bounded_plus; [apply bounded_plus; [apply bounded_plus|]|]|].
      - apply bounded_mult; auto. apply bounded_const.
      - apply (bounded_sum N (fun k t => eta i k t * phi k t)). intros k Hk. apply bounded_mult; auto.
      - apply bounded_mult; auto.
      - apply bounded_mult; auto.
      - apply (bounded_ext (fun _ => 0)); [intros t Ht; symmetry; auto|apply bounded_const].
    Qed.

    Theorem e_converges i : (i < d)%nat -> is_lim (e i) p_infty 0.
    Proof.
      intros Hi.
      assert (L : is_lim (fun t => KD i * (e i t)^2) p_infty 0).
      { apply (barbalat_dissipation V _ _ V_rate).
        - intros. apply V_nonneg.
        - intros. apply term_nonneg, Hi.
        - intros t _. apply Ropp_le_contravar.
          apply (sum_member d (fun i => KD i * (e i t)^2)); auto. apply term_nonneg.
        - destruct (errors_bounded i Hi) as [Be _].
          destruct (bounded_mult _ _ (bounded_const (KD i * 2)) (bounded_mult _ _ Be (e_rate_bounded i Hi)))
            as [L HL]. exists L.
          apply (lipschitz _ (fun t => KD i * (2 * e i t * e_rate_at i t))).
          + apply follows_scal, (follows_square (e i)), loop, Hi.
          + intros t Ht. replace (KD i * (2 * e i t * e_rate_at i t))
              with (KD i * 2 * (e i t * e_rate_at i t)) by ring. apply HL. lra. }
      apply (square_vanishes (KD i)); auto.
    Qed.
  End Undisturbed.
End Trajectories.
