(* Law projection, for every N: where the truth is within the limits, V falls and e -> 0. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem PaperLoop AddedRates Leaks TwoAxes.
Open Scope R_scope.

Section LawProjection.
(* record of projection *)

(* text of axes.txt *)
Let share n M := clip ((n - M^2) / (M^2 * r_adaptation'layer * (r_adaptation'layer + 2))) 0 1.
Let s_1 t := let n := sum N (fun k => (r_alpha_1 k t)^2) + sum N (fun k => (r_alpha_2 k t)^2) in
  share n r_adaptation'largest_flow * Rmax (sum N (fun k => - (r_alpha_1 k t) * r_gamma * (r_phi_x k t) * (r_x_1 t - r_z_1 t))
    + sum N (fun k => - (r_alpha_2 k t) * r_gamma * (r_phi_x k t) * (r_x_2 t - r_z_2 t))) 0
  / Rmax n (r_adaptation'largest_flow^2) / r_gamma.
Let s_2 t := let n := (r_K_1 t)^2 + (r_K_2 t)^2 in
  share n r_adaptation'largest_feedback * Rmax (- (r_K_1 t) * r_gamma * (r_z_1 t) * (r_x_1 t - r_z_1 t)
    - (r_K_2 t) * r_gamma * (r_z_2 t) * (r_x_2 t - r_z_2 t)) 0
  / Rmax n (r_adaptation'largest_feedback^2) / r_gamma.
Let s_3 t := let n := (r_Gamma_1 t)^2 + (r_Gamma_2 t)^2 in
  share n r_adaptation'largest_feedforward * Rmax ((r_Gamma_1 t) * r_gamma * (r_zc_1 t) * (r_x_1 t - r_z_1 t)
    + (r_Gamma_2 t) * r_gamma * (r_zc_2 t) * (r_x_2 t - r_z_2 t)) 0
  / Rmax n (r_adaptation'largest_feedforward^2) / r_gamma.
Let a := leak_a r_gamma alpha s_1.    Let b := leak_b r_gamma K s_2.    Let c := leak_c r_gamma Gamma s_3.
Ltac added_rates := unfold leak_a, leak_b, leak_c, s_1, s_2, s_3, share; cbv zeta.
(* text of added.txt *)
(* text of level.txt *)

(* limits that the truth is within *)
Hypothesis flow_within : squares2 2 N theta <= r_adaptation'largest_flow^2.
Hypothesis feedback_within : squares 2 KD <= r_adaptation'largest_feedback^2.
Hypothesis feedforward_within : squares 2 GammaD <= r_adaptation'largest_feedforward^2.

Lemma outside n M r : 0 < M -> 0 <= n -> 0 <= share n M * Rmax r 0 / Rmax n (M^2) / r_gamma /\
  (share n M * Rmax r 0 / Rmax n (M^2) / r_gamma = 0 \/ M^2 <= n).
Proof.
  intros HM Hn. unfold share. set (q := (n - M^2) / (M^2 * r_adaptation'layer * (r_adaptation'layer + 2))).
  assert (Q : 0 < M^2 * r_adaptation'layer * (r_adaptation'layer + 2)) by positive.
  assert (P : 0 < Rmax n (M^2)) by positive. assert (P0 : 0 <= Rmax r 0) by apply Rmax_r.
  destruct (clip_beyond q) as [C [E|B]].
  - rewrite E. split; [right; field; lra|left; field; lra].
  - split; [not_negative; auto|]. right.
    assert (n - M^2 = q * (M^2 * r_adaptation'layer * (r_adaptation'layer + 2))) by (unfold q; field; lra).
    assert (0 < n - M^2) by (rewrite H; positive). lra.
Qed.

Lemma beyond t : 0 < t -> 0 <= s_1 t /\ 0 <= s_2 t /\ 0 <= s_3 t /\
  (s_1 t = 0 \/ squares2 2 N theta <= squares2 2 N (fun i k => alpha i k t)) /\
  (s_2 t = 0 \/ squares 2 KD <= squares 2 (fun i => K i t)) /\
  (s_3 t = 0 \/ squares 2 GammaD <= squares 2 (fun i => Gamma i t)).
Proof.
  intros _. unfold s_1, s_2, s_3; cbv zeta.
  replace (sum N (fun k => r_alpha_1 k t ^ 2) + sum N (fun k => r_alpha_2 k t ^ 2))
    with (squares2 2 N (fun i k => alpha i k t)) by (unfold squares2; rewrite sum_two; reflexivity).
  replace (r_K_1 t ^ 2 + r_K_2 t ^ 2) with (squares 2 (fun i => K i t))
    by (unfold squares; rewrite sum_two; reflexivity).
  replace (r_Gamma_1 t ^ 2 + r_Gamma_2 t ^ 2) with (squares 2 (fun i => Gamma i t))
    by (unfold squares; rewrite sum_two; reflexivity).
  lazymatch goal with |- 0 <= share ?n1 ?M1 * Rmax ?r1 0 / _ / _ /\ 0 <= share ?n2 ?M2 * Rmax ?r2 0 / _ / _ /\
    0 <= share ?n3 ?M3 * Rmax ?r3 0 / _ / _ /\ _ =>
    destruct (outside n1 M1 r1) as [A1 B1]; [assumption|apply squares2_nonneg|];
    destruct (outside n2 M2 r2) as [A2 B2]; [assumption|apply squares_nonneg|];
    destruct (outside n3 M3 r3) as [A3 B3]; [assumption|apply squares_nonneg|] end.
  repeat split; auto; [destruct B1|destruct B2|destruct B3]; auto; right; lra.
Qed.

Theorem projection_rate : follows run_V (fun t => - loss 2 KD x z t
  - s_1 t * pull_1 2 N theta alpha t - s_2 t * pull_2 2 KD K t - s_3 t * pull_3 2 GammaD Gamma t).
Proof.
  apply (follows_ext _ _ _ _ (fun t => eq_sym (same_V t)) (fun t _ => eq_refl)).
  apply (leak_rate _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ P_gamma loop).
Qed.

Theorem projection_falls s t : 0 <= s <= t -> run_V t <= run_V s.
Proof.
  intros H. rewrite !same_V.
  apply (beyond_falls _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ P_gamma KD_positive loop beyond s t H).
Qed.

Theorem projection_converges : (forall k, (k < N)%nat -> bounded (r_phi_x k)) -> bounded r_zc_1 -> bounded r_zc_2 ->
  is_lim (fun t => r_x_1 t - r_z_1 t) p_infty 0 /\ is_lim (fun t => r_x_2 t - r_z_2 t) p_infty 0.
Proof.
  intros Bp B1 B2.
  assert (C := beyond_converges _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ P_gamma KD_positive loop beyond Bp
    ltac:(intros [|i] Hi; assumption)).
  split; [apply (C 0%nat)|apply (C 1%nat)]; lia.
Qed.
End LawProjection.
Print Assumptions projection_rate.
Print Assumptions projection_falls.
Print Assumptions projection_converges.
