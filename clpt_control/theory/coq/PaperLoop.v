(* The paper's closed loop in the paper's variables, and Theorem 3.2 (with all its assumptions).
   d axes, N basis functions, any numbers.  phi_x, phi_z are the basis at the vehicle and at the
   prediction as functions of time, as zc and Delta; Basis.v puts Eq. (5) in. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem Barbalat Trajectories.
Open Scope R_scope.

(* right-hand sides at one instant: phx is phi(x, t), phz is phi(z, t) *)
Section Rates.
  Variables (N : nat) (theta alpha_M : nat -> nat -> R) (KD GammaD : nat -> R) (gamma : R).
  Variables (x z : nat -> R) (alpha : nat -> nat -> R) (K Gamma : nat -> R).
  Variables (phx phz zc Delta : nat -> R).

  Definition error i := x i - z i.
  Definition true_flow i := sum N (fun k => theta i k * phx k) + Delta i.                 (* (3) *)
  Definition modeled_flow i := sum N (fun k => alpha_M i k * phz k).                      (* (4) *)
  Definition v_x i := - sum N (fun k => alpha_M i k * phx k) - KD i * x i + GammaD i * zc i. (* (7) *)
  Definition psi i :=                                                                    (* (20) *)
    - sum N (fun k => (alpha_M i k + alpha i k) * phx k)
    - sum N (fun k => (alpha_M i k - alpha i k) * phz k).
  Definition v_z i :=                                                                     (* (6) *)
    - sum N (fun k => alpha i k * phz k) - K i * z i + Gamma i * zc i + psi i.

  Definition x_rate i := true_flow i + v_x i.                                        (* (1), (9) *)
  Definition z_rate i := modeled_flow i + v_z i.                                     (* (2), (8) *)
  Definition alpha_rate i k := - gamma * error i * phx k.                                (* (21) *)
  Definition K_rate i := - gamma * z i * error i.                                        (* (22) *)
  Definition Gamma_rate i := gamma * zc i * error i.                                     (* (23) *)

  (* (9) and (27): the rates of x and of e *)
  Lemma vehicle i : x_rate i =
    - KD i * x i + (sum N (fun k => (theta i k - alpha_M i k) * phx k) + GammaD i * zc i + Delta i).
  Proof.
    unfold x_rate, true_flow, v_x.
    replace (sum N (fun k => (theta i k - alpha_M i k) * phx k))
      with (sum N (fun k => theta i k * phx k) - sum N (fun k => alpha_M i k * phx k)); [ring|].
    replace (sum N (fun k => theta i k * phx k) - sum N (fun k => alpha_M i k * phx k))
      with (sum N (fun k => theta i k * phx k) + -1 * sum N (fun k => alpha_M i k * phx k)) by ring.
    rewrite <- sum_scal, <- sum_plus. apply sum_ext. intros. ring.
  Qed.

  Lemma error_rate i : x_rate i - z_rate i =
    e_rate N KD error (fun i k => theta i k + alpha i k) (fun i => K i - KD i)
      (fun i => GammaD i - Gamma i) phx z zc Delta i.
  Proof.
    unfold x_rate, z_rate, true_flow, modeled_flow, v_x, v_z, psi, e_rate, error.
    assert (A : forall a b f, sum N (fun k => (a k + b k) * f k)
      = sum N (fun k => a k * f k) + sum N (fun k => b k * f k)).
    { intros a b f. rewrite <- sum_plus. apply sum_ext. intros. ring. }
    assert (B : forall a b f, sum N (fun k => (a k - b k) * f k)
      = sum N (fun k => a k * f k) - sum N (fun k => b k * f k)).
    { intros a b f. replace (sum N (fun k => a k * f k) - sum N (fun k => b k * f k))
        with (sum N (fun k => a k * f k) + -1 * sum N (fun k => b k * f k)) by ring.
      rewrite <- sum_scal, <- sum_plus. apply sum_ext. intros. ring. }
    rewrite !(A (alpha_M i) (alpha i)), !(A (theta i) (alpha i)), !(B (alpha_M i) (alpha i)). ring.
  Qed.
End Rates.

Section Loop.
  Variables (d N : nat) (theta alpha_M : nat -> nat -> R) (KD GammaD : nat -> R) (gamma : R).
  Variables (phi_x phi_z zc Delta : nat -> R -> R).
  Variables (x z : nat -> R -> R) (alpha : nat -> nat -> R -> R) (K Gamma : nat -> R -> R).

  Local Notation "f @ t" := (fun i => f i t) (at level 5).
  Local Notation "f @@ t" := (fun i k => f i k t) (at level 5).

  (* x, z, alpha, K, Gamma are a trajectory of the closed loop for t >= 0 *)
  Record closed_loop : Prop := {
    x_follows : forall i, (i < d)%nat ->
      follows (x i) (fun t => x_rate N theta alpha_M KD GammaD x@t phi_x@t zc@t Delta@t i);
    z_follows : forall i, (i < d)%nat ->
      follows (z i) (fun t => z_rate N alpha_M z@t alpha@@t K@t Gamma@t phi_x@t phi_z@t zc@t i);
    alpha_follows : forall i k, (i < d)%nat -> (k < N)%nat ->
      follows (alpha i k) (fun t => alpha_rate gamma x@t z@t phi_x@t i k);
    K_follows : forall i, (i < d)%nat -> follows (K i) (fun t => K_rate gamma x@t z@t i);
    Gamma_follows : forall i, (i < d)%nat ->
      follows (Gamma i) (fun t => Gamma_rate gamma x@t z@t zc@t i) }.

  Definition e i t := x i t - z i t.
  Definition eta i k t := theta i k + alpha i k t.
  Definition kappa i t := K i t - KD i.
  Definition nu i t := GammaD i - Gamma i t.

  (* V of Eq. (24) *)
  Definition Lyapunov t :=
    / 2 * (sum d (fun i => (x i t - z i t)^2)
      + / gamma * (sum d (fun i => sum N (fun k => (theta i k + alpha i k t)^2))
                   + sum d (fun i => (K i t - KD i)^2) + sum d (fun i => (GammaD i - Gamma i t)^2))).

  Lemma errors : closed_loop -> error_system d N KD gamma e eta kappa nu phi_x z zc Delta.
  Proof.
    intros [Hx Hz Ha HK HG]. constructor.
    - intros i Hi. eapply follows_ext; [intros; reflexivity| |apply (follows_minus _ _ _ _ (Hx i Hi) (Hz i Hi))].
      intros t _. apply error_rate.
    - intros i k Hi Hk. eapply follows_ext;
        [intros; reflexivity| |apply (follows_plus _ _ _ _ (follows_const (theta i k)) (Ha i k Hi Hk))].
      intros t _. unfold alpha_rate, eta_rate, error, e. ring.
    - intros i Hi. eapply follows_ext;
        [intros; reflexivity| |apply (follows_minus _ _ _ _ (HK i Hi) (follows_const (KD i)))].
      intros t _. unfold K_rate, kappa_rate, error, e. ring.
    - intros i Hi. eapply follows_ext;
        [intros; reflexivity| |apply (follows_minus _ _ _ _ (follows_const (GammaD i)) (HG i Hi))].
      intros t _. unfold Gamma_rate, nu_rate, error, e. ring.
  Qed.

  Hypothesis gamma_positive : 0 < gamma.
  Hypothesis KD_positive : forall i, (i < d)%nat -> 0 < KD i.     (* Assumption 3.2, KD diagonal *)
  Hypothesis phi_x_bounded : forall k, (k < N)%nat -> bounded (phi_x k).
  Hypothesis zc_bounded : forall i, (i < d)%nat -> bounded (zc i).
  Hypothesis trajectory : closed_loop.

  (* the vehicle's place is bounded, also under a bounded disturbance *)
  Theorem x_bounded : (forall i, (i < d)%nat -> bounded (Delta i)) ->
    forall i, (i < d)%nat -> bounded (x i).
  Proof.
    intros HD i Hi. destruct trajectory as [Hx _ _ _ _].
    apply (stable (KD i) (x i) (fun t => sum N (fun k => (theta i k - alpha_M i k) * phi_x k t)
      + GammaD i * zc i t + Delta i t)); auto.
    - eapply follows_ext; [intros; reflexivity| |apply (Hx i Hi)]. intros t _. apply vehicle.
    - apply bounded_plus; [apply bounded_plus|auto].
      + apply (bounded_sum N (fun k t => (theta i k - alpha_M i k) * phi_x k t)). intros k Hk.
        apply bounded_mult; [apply bounded_const|auto].
      + apply bounded_mult; [apply bounded_const|auto].
  Qed.

  Hypothesis no_disturbance : forall i t, (i < d)%nat -> 0 <= t -> Delta i t = 0.

  (* dV/dt = -e^T KD e for every N, but at the jumps of zc, where V is continuous *)
  Theorem theorem_3_2_rate :
    follows Lyapunov (fun t => - sum d (fun i => KD i * (x i t - z i t)^2)).
  Proof. apply (V_rate d N KD gamma e eta kappa nu phi_x z zc Delta); auto. apply errors, trajectory. Qed.

  Theorem theorem_3_2_falls : forall s t, 0 <= s <= t -> Lyapunov t <= Lyapunov s.
  Proof. intros s t. apply (V_falls d N KD gamma e eta kappa nu phi_x z zc Delta); auto. apply errors, trajectory. Qed.

  Theorem theorem_3_2_bounded : forall i, (i < d)%nat ->
    bounded (x i) /\ bounded (z i) /\ bounded (K i) /\ bounded (Gamma i) /\
    forall k, (k < N)%nat -> bounded (alpha i k).
  Proof.
    intros i Hi.
    assert (Bx : bounded (x i)).
    { apply x_bounded; auto. intros j Hj. apply (bounded_ext (fun _ => 0)); [|apply bounded_const].
      intros. symmetry. apply no_disturbance; auto. }
    destruct (errors_bounded d N KD gamma e eta kappa nu phi_x z zc Delta gamma_positive KD_positive
      (errors trajectory) no_disturbance i Hi) as [Be [Bk [Bn Ba]]].
    split; [exact Bx|split; [|split; [|split; [|intros k Hk]]]].
    - apply (bounded_ext (fun t => x i t - e i t)); [intros; unfold e; ring|apply bounded_minus; auto].
    - apply (bounded_ext (fun t => kappa i t + KD i)); [intros; unfold kappa; ring|].
      apply bounded_plus; auto. apply bounded_const.
    - apply (bounded_ext (fun t => GammaD i - nu i t)); [intros; unfold nu; ring|].
      apply bounded_minus; auto. apply bounded_const.
    - apply (bounded_ext (fun t => eta i k t - theta i k)); [intros; unfold eta; ring|].
      apply bounded_minus; auto. apply bounded_const.
  Qed.

  Theorem theorem_3_2 : forall i, (i < d)%nat -> is_lim (fun t => x i t - z i t) p_infty 0.
  Proof.
    intros i Hi. apply (e_converges d N KD gamma e eta kappa nu phi_x z zc Delta); auto.
    - apply errors, trajectory.
    - intros j Hj. apply theorem_3_2_bounded, Hj.
  Qed.
End Loop.

Print Assumptions theorem_3_2_rate.
Print Assumptions theorem_3_2_bounded.
Print Assumptions theorem_3_2.
