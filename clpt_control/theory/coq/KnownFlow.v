(* Theorem 3.1: the known-flow law, alpha = alpha_M and the injection (13); theta_h is the estimate.
   Corrected: the mean square of e is at most that of the drive (theta - theta_h) phi over k.
   As printed, Eq. (16), it is false. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem Trajectories PaperLoop MeanSquare Counterexample.
Open Scope R_scope.

Section KnownFlow.
  Variables (d N : nat) (theta theta_h alpha_M : nat -> nat -> R) (KD GammaD : nat -> R) (gamma k : R).
  Variables (phi_x phi_z zc : nat -> R -> R) (x z K Gamma : nat -> R -> R).
  Local Notation "f @ t" := (fun i => f i t) (at level 5).

  Definition drive i t := sum N (fun k => (theta i k - theta_h i k) * phi_x k t).

  (* (2), (4), (6) with alpha = alpha_M, and (13) *)
  Definition known_z_rate i t :=
    sum N (fun k => alpha_M i k * phi_z k t)
    + (- sum N (fun k => alpha_M i k * phi_z k t) - K i t * z i t + Gamma i t * zc i t
       + sum N (fun k => (theta_h i k - alpha_M i k) * phi_x k t)).

  Record known_loop : Prop := {
    known_x : forall i, (i < d)%nat ->
      follows (x i) (fun t => x_rate N theta alpha_M KD GammaD x@t phi_x@t zc@t (fun _ => 0) i);
    known_z : forall i, (i < d)%nat -> follows (z i) (known_z_rate i);
    known_K : forall i, (i < d)%nat -> follows (K i) (fun t => K_rate gamma x@t z@t i);
    known_Gamma : forall i, (i < d)%nat -> follows (Gamma i) (fun t => Gamma_rate gamma x@t z@t zc@t i) }.

  (* V of Eq. (17) *)
  Definition Lyapunov_17 t := / 2 * (sum d (fun i => (x i t - z i t)^2)
    + / gamma * (sum d (fun i => (K i t - KD i)^2) + sum d (fun i => (GammaD i - Gamma i t)^2))).

  (* an error system without functions, and the drive as its disturbance *)
  Lemma known_errors : known_loop -> error_system d 0 KD gamma (e x z) (fun _ _ _ => 0)
    (kappa KD K) (nu GammaD Gamma) (fun _ _ => 0) z zc drive.
  Proof.
    intros [Hx Hz HK HG]. constructor.
    - intros i Hi. apply (follows_by _ _ _ (follows_minus _ _ _ _ (Hx i Hi) (Hz i Hi))). intros t _.
      unfold x_rate, true_flow, v_x, known_z_rate, e_rate_at, e_rate, drive, kappa, nu, e. simpl sum.
      assert (A : forall f g, sum N (fun k => (f k - g k) * phi_x k t)
        = sum N (fun k => f k * phi_x k t) - sum N (fun k => g k * phi_x k t)).
      { intros f g. replace (sum N (fun k => f k * phi_x k t) - sum N (fun k => g k * phi_x k t))
          with (sum N (fun k => f k * phi_x k t) + -1 * sum N (fun k => g k * phi_x k t)) by ring.
        rewrite <- sum_scal, <- sum_plus. apply sum_ext. intros. ring. }
      rewrite !A. ring.
    - intros. lia.
    - intros i Hi. apply (follows_by _ _ _ (follows_minus _ _ _ _ (HK i Hi) (follows_const (KD i)))).
      intros t _. unfold K_rate, kappa_rate, PaperLoop.error, e. ring.
    - intros i Hi. apply (follows_by _ _ _ (follows_minus _ _ _ _ (follows_const (GammaD i)) (HG i Hi))).
      intros t _. unfold Gamma_rate, nu_rate, PaperLoop.error, e. ring.
  Qed.

  Lemma V_17 t : level d 0 gamma (fun i => e x z i t) (fun _ _ => 0) (fun i => kappa KD K i t)
    (fun i => nu GammaD Gamma i t) = Lyapunov_17 t.
  Proof.
    assert (Z : forall n, sum n (fun _ => sum 0 (fun _ => 0 ^ 2)) = 0) by (induction n; simpl in *; lra).
    unfold level, Lyapunov_17, e, kappa, nu. rewrite Z. ring.
  Qed.

  Theorem theorem_3_1_rate : gamma <> 0 -> known_loop -> follows Lyapunov_17 (fun t =>
    - sum d (fun i => KD i * (x i t - z i t)^2) + sum d (fun i => (x i t - z i t) * drive i t)).
  Proof.
    intros G loop. apply (follows_ext _ _ _ _ V_17 (fun t _ => eq_refl)).
    apply (V_follows d 0 KD gamma (e x z) (fun _ _ _ => 0) (kappa KD K) (nu GammaD Gamma) (fun _ _ => 0) z zc drive);
      auto using known_errors.
  Qed.

  Theorem theorem_3_1 : 0 < gamma -> 0 < k -> (forall i, (i < d)%nat -> k <= KD i) -> known_loop ->
    (forall t, 0 <= t -> ex_RInt (square d drive) 0 t) -> piecewise_continuous (square d drive) ->
    forall t, 0 <= t -> RInt (square d (e x z)) 0 t
      <= 2 * Lyapunov_17 0 / k + RInt (square d drive) 0 t / k^2.
  Proof.
    intros G Hk Kl loop I P t Ht. rewrite <- V_17.
    apply (mean_square d 0 KD gamma k (e x z) (fun _ _ _ => 0) (kappa KD K) (nu GammaD Gamma)
      (fun _ _ => 0) z zc drive); auto using known_errors.
  Qed.
End KnownFlow.

(* Eq. (16): limsup |e| <= limsup |drive|/mu for mu < KD *)
Definition printed_16 := forall (d N : nat) theta theta_h alpha_M KD GammaD gamma phi_x phi_z zc x z K Gamma,
  0 < gamma -> (forall i, (i < d)%nat -> 0 < KD i) ->
  (forall k, (k < N)%nat -> bounded (phi_x k) /\ bounded (phi_z k)) ->
  (forall i, (i < d)%nat -> bounded (zc i)) -> persistently_exciting d zc ->
  known_loop d N theta theta_h alpha_M KD GammaD gamma phi_x phi_z zc x z K Gamma ->
  forall f_max, (forall t, 0 <= t -> sqrt (sum d (fun i => drive N theta theta_h phi_x i t ^ 2)) <= f_max) ->
  forall mu, 0 < mu -> (forall i, (i < d)%nat -> mu < KD i) ->
  exists T, forall t, T <= t -> sqrt (sum d (fun i => (x i t - z i t) ^ 2)) <= f_max / mu.

(* zc = 1, two functions: the first is what Gamma makes of zc, so that z = 0; the second is the drive *)
Definition wave t := sin t + sin (3 * t) / 6 - cos (3 * t) / 16.
Definition functions (k : nat) t := match k with O => 10 - flow_error t | S _ => wave t end.

Lemma wave_small t : Rabs (wave t) <= 0.93.
Proof.
  unfold wave. rewrite sin_3. assert (B := COS_bound (3 * t)). assert (S := SIN_bound t). set (s := sin t) in *.
  assert (C1 : 0 <= (s - 0.866) ^ 2 * (s + 1.732)) by (apply Rmult_le_pos; [apply pow2_ge_0|lra]).
  assert (C2 : 0 <= (s + 0.866) ^ 2 * (1.732 - s)) by (apply Rmult_le_pos; [apply pow2_ge_0|lra]).
  assert (C : -0.8662 <= 3 / 2 * s - 2 / 3 * s ^ 3 <= 0.8662) by (simpl in *; split; lra).
  replace (s + (3 * s - 4 * s ^ 3) / 6) with (3 / 2 * s - 2 / 3 * s ^ 3) by field.
  apply Rabs_le. lra.
Qed.

Lemma constant_excites : persistently_exciting 1 (first (fun _ => 1)).
Proof.
  exists 1, 1. split; [lra|split; [lra|]]. intros t _ a.
  rewrite (RInt_ext _ (fun _ => a 0%nat ^ 2)) by (intros; unfold first; simpl; ring).
  rewrite RInt_const. unfold scal; simpl; unfold mult; simpl. lra.
Qed.

Theorem printed_16_is_false : ~ printed_16.
Proof.
  intros H.
  destruct (H 1%nat 2%nat (fun _ k => match k with O => -1 | S _ => 1 end) (fun _ k => match k with O => -1 | S _ => 0 end)
    (fun _ _ => 0) (fun _ => 1) (fun _ => 10) 1 functions (fun _ _ => 0) (first (fun _ => 1)) (first error)
    (first (fun _ => 0)) (first (fun _ => 1)) (first (fun t => 10 - flow_error t)))
    with (f_max := 0.93) (mu := 0.95) as [T HT]; try (intros; lra).
  - intros k _. split; [|apply bounded_const]. destruct k as [|k]; simpl.
    + exists 11.03. intros t _. change (functions 0 t) with (10 - flow_error t). assert (A := flow_error_small t). apply Rabs_le. lra.
    + exists 0.93. intros t _. apply (wave_small t).
  - intros. apply bounded_const.
  - apply constant_excites.
  - constructor; intros i Hi; unfold first.
    + apply (follows_by error error'); [apply follows_smooth, error_derives|]. intros t _.
      unfold x_rate, true_flow, v_x, functions, error, error', flow_error, wave; simpl sum. field.
    + apply (follows_by _ _ _ (follows_const 0)). intros t _. unfold known_z_rate, functions; simpl sum. ring.
    + apply (follows_by _ _ _ (follows_const 1)). intros t _. unfold K_rate. ring.
    + apply (follows_by (fun t => 10 - flow_error t) (fun t => 0 - - error t)).
      * apply follows_minus; [apply follows_const|apply follows_smooth, flow_error_derives].
      * intros t _. unfold Gamma_rate, PaperLoop.error. ring.
  - intros t _. rewrite (sum_ext 1 _ (fun _ => wave t ^ 2)).
    + rewrite one_axis. apply wave_small.
    + intros i _. unfold drive, functions; simpl sum. ring.
  - destruct (equation_33_is_false T) as [t [Ht E]]. assert (A := HT t Ht).
    unfold first in *. rewrite one_axis in A. assert (B := E 0.95 ltac:(lra)). lra.
Qed.
Print Assumptions theorem_3_1.
Print Assumptions printed_16_is_false.
