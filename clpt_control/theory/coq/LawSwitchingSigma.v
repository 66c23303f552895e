(* Law switching-sigma, for every N: where the truth is within the limits, V falls and e -> 0. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem PaperLoop AddedRates Leaks TwoAxes.
Open Scope R_scope.

Section LawSwitchingSigma.
(* record of switching-sigma *)

(* text of axes.txt *)
Let s_1 t := r_adaptation'leak * clip (-1 + sqrt (sum N (fun k => (r_alpha_1 k t)^2)
  + sum N (fun k => (r_alpha_2 k t)^2)) / r_adaptation'largest_flow) 0 1.
Let s_2 t := r_adaptation'leak * clip (-1 + sqrt ((r_K_1 t)^2 + (r_K_2 t)^2) / r_adaptation'largest_feedback) 0 1.
Let s_3 t := r_adaptation'leak
  * clip (-1 + sqrt ((r_Gamma_1 t)^2 + (r_Gamma_2 t)^2) / r_adaptation'largest_feedforward) 0 1.
Let a := leak_a r_gamma alpha s_1.    Let b := leak_b r_gamma K s_2.    Let c := leak_c r_gamma Gamma s_3.
Ltac added_rates := unfold leak_a, leak_b, leak_c, s_1, s_2, s_3.
(* text of added.txt *)
(* text of level.txt *)

(* limits that the truth is within *)
Hypothesis flow_within : squares2 2 N theta <= r_adaptation'largest_flow^2.
Hypothesis feedback_within : squares 2 KD <= r_adaptation'largest_feedback^2.
Hypothesis feedforward_within : squares 2 GammaD <= r_adaptation'largest_feedforward^2.

Lemma outside leak n M : 0 < leak -> 0 < M -> 0 <= n ->
  0 <= leak * clip (-1 + sqrt n / M) 0 1 /\ (leak * clip (-1 + sqrt n / M) 0 1 = 0 \/ M^2 <= n).
Proof.
  intros Hl HM Hn. destruct (clip_beyond (-1 + sqrt n / M)) as [P [->|B]]; split; try (left; ring); try nra.
  right. assert (M <= sqrt n) by (apply (Rmult_le_reg_r (/ M)); [apply Rinv_0_lt_compat; auto|];
    rewrite Rinv_r by lra; unfold Rdiv in B; lra).
  rewrite <- (sqrt_sqrt n Hn). simpl. nra.
Qed.

Lemma beyond t : 0 < t -> 0 <= s_1 t /\ 0 <= s_2 t /\ 0 <= s_3 t /\
  (s_1 t = 0 \/ squares2 2 N theta <= squares2 2 N (fun i k => alpha i k t)) /\
  (s_2 t = 0 \/ squares 2 KD <= squares 2 (fun i => K i t)) /\
  (s_3 t = 0 \/ squares 2 GammaD <= squares 2 (fun i => Gamma i t)).
Proof.
  intros _.
  destruct (outside _ (squares2 2 N (fun i k => alpha i k t)) _ P_adaptation'leak P_adaptation'largest_flow)
    as [A1 B1]; [apply squares2_nonneg|].
  destruct (outside _ (squares 2 (fun i => K i t)) _ P_adaptation'leak P_adaptation'largest_feedback)
    as [A2 B2]; [apply squares_nonneg|].
  destruct (outside _ (squares 2 (fun i => Gamma i t)) _ P_adaptation'leak P_adaptation'largest_feedforward)
    as [A3 B3]; [apply squares_nonneg|].
  unfold squares2 in A1, B1 at 1. unfold squares in A2, A3, B2 at 1, B3 at 1. rewrite sum_two in A1, A2, A3.
  rewrite sum_two in B1, B2, B3.
  repeat split; auto; [destruct B1|destruct B2|destruct B3]; auto; right; lra.
Qed.

Theorem switching_sigma_rate : follows run_V (fun t => - loss 2 KD x z t
  - s_1 t * pull_1 2 N theta alpha t - s_2 t * pull_2 2 KD K t - s_3 t * pull_3 2 GammaD Gamma t).
Proof.
  apply (follows_ext _ _ _ _ (fun t => eq_sym (same_V t)) (fun t _ => eq_refl)).
  apply (leak_rate _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ P_gamma loop).
Qed.

Theorem switching_sigma_falls s t : 0 <= s <= t -> run_V t <= run_V s.
Proof.
  intros H. rewrite !same_V.
  apply (beyond_falls _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ P_gamma KD_positive loop beyond s t H).
Qed.

Theorem switching_sigma_converges : (forall k, (k < N)%nat -> bounded (r_phi_x k)) -> bounded r_zc_1 -> bounded r_zc_2 ->
  is_lim (fun t => r_x_1 t - r_z_1 t) p_infty 0 /\ is_lim (fun t => r_x_2 t - r_z_2 t) p_infty 0.
Proof.
  intros Bp B1 B2.
  assert (C := beyond_converges _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ P_gamma KD_positive loop beyond Bp
    ltac:(intros [|i] Hi; assumption)).
  split; [apply (C 0%nat)|apply (C 1%nat)]; lia.
Qed.
End LawSwitchingSigma.
Print Assumptions switching_sigma_rate.
Print Assumptions switching_sigma_falls.
Print Assumptions switching_sigma_converges.
