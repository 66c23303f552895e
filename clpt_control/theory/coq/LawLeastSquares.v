(* Law least-squares, for every N: eta = scaled P is kept, and V' with the term e^T eta phi, which has either sign. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem PaperLoop Memory Covariance TwoAxes.
Open Scope R_scope.

Section LawLeastSquares.
(* record of least-squares *)

(* text of axes.txt *)
Let gain_K := r_adaptation'gain_K.    Let gain_Gamma := r_adaptation'gain_Gamma.
(* text of gains.txt *)
(* text of filter.txt *)
(* text of covariance.txt *)

(* scaled = eta P^-1 *)
Let scaled_1 k t := r_rho_1 t * (r_theta_1 k + r_adaptation'alpha_0'1 k) * r_adaptation'information k.
Let scaled_2 k t := r_rho_1 t * (r_theta_2 k + r_adaptation'alpha_0'2 k) * r_adaptation'information k.
Let g_1 (k : nat) (t : R) := 0.
Lemma scaled_follows_1 k : (k < N)%nat -> follows (scaled_1 k) (fun t => - lambda t * scaled_1 k t - g_1 k t).
Proof.
  intros Hk. apply (follows_ext (fun t => (r_theta_1 k + r_adaptation'alpha_0'1 k) * r_adaptation'information k * r_rho_1 t)
    (fun t => (r_theta_1 k + r_adaptation'alpha_0'1 k) * r_adaptation'information k * (- lambda t * r_rho_1 t)));
    [intros; unfold scaled_1; ring|intros; unfold scaled_1, g_1; ring|]. apply follows_scal, rho_follows.
Qed.
Let g_2 (k : nat) (t : R) := 0.
Lemma scaled_follows_2 k : (k < N)%nat -> follows (scaled_2 k) (fun t => - lambda t * scaled_2 k t - g_2 k t).
Proof.
  intros Hk. apply (follows_ext (fun t => (r_theta_2 k + r_adaptation'alpha_0'2 k) * r_adaptation'information k * r_rho_1 t)
    (fun t => (r_theta_2 k + r_adaptation'alpha_0'2 k) * r_adaptation'information k * (- lambda t * r_rho_1 t)));
    [intros; unfold scaled_2; ring|intros; unfold scaled_2, g_2; ring|]. apply follows_scal, rho_follows.
Qed.
Ltac same_alpha run g := unfold run, r2, P_phi, g; rewrite (sum_zero N (fun j => _ * 0)) by (intros; ring); equal_rates.
Ltac drive := unfold g_1, g_2; rewrite !(sum_zero N (fun k => 0 * _)) by (intros; ring).
Lemma same_alpha_1 k t : run_alpha_1 k t = - / r2
  * (r_adaptation'filter * r_x_1 t - r_q_1 t + sum N (fun k => r_alpha_1 k t * r_phi_f k t)) * P_phi N r_P r_phi_f k t
  - sum N (fun j => r_P k j t * g_1 j t).
Proof. same_alpha run_alpha_1 g_1. Qed.
Lemma same_alpha_2 k t : run_alpha_2 k t = - / r2
  * (r_adaptation'filter * r_x_2 t - r_q_2 t + sum N (fun k => r_alpha_2 k t * r_phi_f k t)) * P_phi N r_P r_phi_f k t
  - sum N (fun j => r_P k j t * g_2 j t).
Proof. same_alpha run_alpha_2 g_2. Qed.
Lemma eta_follows_1 k : (k < N)%nat -> follows (eta_1 k) (fun t =>
  - / r2 * eps N r_phi_f eta_1 t * P_phi N r_P r_phi_f k t - sum N (fun j => r_P k j t * g_1 j t)).
Proof.
  intros Hk. apply (follows_by _ _ _ (follows_plus _ _ _ _ (follows_const (r_theta_1 k)) (H_alpha_1 k Hk))).
  intros t Ht. rewrite same_alpha_1, unexplained_1 by lra. unfold eps, eps_1, eta_1. ring.
Qed.
Lemma eta_follows_2 k : (k < N)%nat -> follows (eta_2 k) (fun t =>
  - / r2 * eps N r_phi_f eta_2 t * P_phi N r_P r_phi_f k t - sum N (fun j => r_P k j t * g_2 j t)).
Proof.
  intros Hk. apply (follows_by _ _ _ (follows_plus _ _ _ _ (follows_const (r_theta_2 k)) (H_alpha_2 k Hk))).
  intros t Ht. rewrite same_alpha_2, unexplained_2 by lra. unfold eps, eps_2, eta_2. ring.
Qed.
Hypothesis start_alpha_1 : forall k, (k < N)%nat -> r_alpha_1 k 0 = r_adaptation'alpha_0'1 k.
Lemma start_eta_1 k : (k < N)%nat -> eta_1 k 0 = sum N (fun j => scaled_1 j 0 * r_P j k 0).
Proof.
  intros Hk. rewrite (start_column (fun j => scaled_1 j 0)) by auto. unfold eta_1, scaled_1. rewrite start_alpha_1, start_rho by auto.
  rewrite Rmult_assoc, start_variance by auto. ring.
Qed.
Hypothesis start_alpha_2 : forall k, (k < N)%nat -> r_alpha_2 k 0 = r_adaptation'alpha_0'2 k.
Lemma start_eta_2 k : (k < N)%nat -> eta_2 k 0 = sum N (fun j => scaled_2 j 0 * r_P j k 0).
Proof.
  intros Hk. rewrite (start_column (fun j => scaled_2 j 0)) by auto. unfold eta_2, scaled_2. rewrite start_alpha_2, start_rho by auto.
  rewrite Rmult_assoc, start_variance by auto. ring.
Qed.
Let weighted_1 t := sum N (fun k => scaled_1 k t * eta_1 k t).    (* tr(eta P^-1 eta^T) of axis I *)
Lemma weighted_follows_1 : follows weighted_1 (fun t => - lambda t * weighted_1 t - / r2 * (eps_1 t)^2
  - 2 * sum N (fun k => g_1 k t * eta_1 k t)).
Proof.
  apply (weighted_rate N r_P lambda r2 r_phi_f scaled_1 g_1 eta_1 P_follows scaled_follows_1 eta_follows_1 lambda_bounded
    phi_f_bounded start_symmetric start_eta_1).
Qed.
Let weighted_2 t := sum N (fun k => scaled_2 k t * eta_2 k t).    (* tr(eta P^-1 eta^T) of axis I *)
Lemma weighted_follows_2 : follows weighted_2 (fun t => - lambda t * weighted_2 t - / r2 * (eps_2 t)^2
  - 2 * sum N (fun k => g_2 k t * eta_2 k t)).
Proof.
  apply (weighted_rate N r_P lambda r2 r_phi_f scaled_2 g_2 eta_2 P_follows scaled_follows_2 eta_follows_2 lambda_bounded
    phi_f_bounded start_symmetric start_eta_2).
Qed.

(* what the states keep: eta = scaled P *)
Theorem least_squares_kept k t : (k < N)%nat -> 0 <= t ->
  eta_1 k t = sum N (fun j => scaled_1 j t * r_P j k t) /\ eta_2 k t = sum N (fun j => scaled_2 j t * r_P j k t).
Proof.
  intros Hk Ht. split.
  - apply (covariance_kept N r_P lambda r2 r_phi_f scaled_1 g_1 eta_1 P_follows scaled_follows_1 eta_follows_1 lambda_bounded
      phi_f_bounded start_symmetric start_eta_1 k t Hk Ht).
  - apply (covariance_kept N r_P lambda r2 r_phi_f scaled_2 g_2 eta_2 P_follows scaled_follows_2 eta_follows_2 lambda_bounded
      phi_f_bounded start_symmetric start_eta_2 k t Hk Ht).
Qed.

Lemma same_V t : run_V t = / 2 * (r_x_1 t - r_z_1 t)^2 + / 2 * (r_x_2 t - r_z_2 t)^2
  + r2 / (2 * r_adaptation'rate) * (weighted_1 t + weighted_2 t)
  + / (2 * gain_K) * (r_K_1 t - r_KD_1)^2 + / (2 * gain_K) * (r_K_2 t - r_KD_2)^2
  + / (2 * gain_Gamma) * (r_GammaD_1 - r_Gamma_1 t)^2 + / (2 * gain_Gamma) * (r_GammaD_2 - r_Gamma_2 t)^2.
Proof. unfold run_V, weighted_1, weighted_2, scaled_1, scaled_2, eta_1, eta_2, r2, gain_K, gain_Gamma. equal_rates. Qed.

Lemma same_K_1 t : run_K_1 t = - gain_K * r_z_1 t * (r_x_1 t - r_z_1 t)
  + gain_K * (r_b_v_1'1 t - r_Q_1_1'1 t * r_K_1 t - r_Q_1_1'2 t * r_Gamma_1 t).
Proof. unfold run_K_1, gain_K. ring. Qed.
Lemma same_Gamma_1 t : run_Gamma_1 t = gain_Gamma * r_zc_1 t * (r_x_1 t - r_z_1 t)
  + gain_Gamma * (r_b_v_1'2 t - r_Q_1_2'1 t * r_K_1 t - r_Q_1_2'2 t * r_Gamma_1 t).
Proof. unfold run_Gamma_1, gain_Gamma. ring. Qed.
Lemma same_K_2 t : run_K_2 t = - gain_K * r_z_2 t * (r_x_2 t - r_z_2 t)
  + gain_K * (r_b_v_2'1 t - r_Q_2_1'1 t * r_K_2 t - r_Q_2_1'2 t * r_Gamma_2 t).
Proof. unfold run_K_2, gain_K. ring. Qed.
Lemma same_Gamma_2 t : run_Gamma_2 t = gain_Gamma * r_zc_2 t * (r_x_2 t - r_z_2 t)
  + gain_Gamma * (r_b_v_2'2 t - r_Q_2_2'1 t * r_K_2 t - r_Q_2_2'2 t * r_Gamma_2 t).
Proof. unfold run_Gamma_2, gain_Gamma. ring. Qed.

Theorem least_squares_rate : follows run_V (fun t =>
  - r_KD_1 * (r_x_1 t - r_z_1 t)^2 - r_KD_2 * (r_x_2 t - r_z_2 t)^2
  + (r_x_1 t - r_z_1 t) * sum N (fun k => eta_1 k t * r_phi_x k t)
  + (r_x_2 t - r_z_2 t) * sum N (fun k => eta_2 k t * r_phi_x k t)
  - ((eps_1 t)^2 + (eps_2 t)^2) / (2 * r_adaptation'rate)
  - lambda t * r2 * (weighted_1 t + weighted_2 t) / (2 * r_adaptation'rate) - quadratic_1 t - quadratic_2 t).
Proof.
  apply (follows_ext _ _ _ _ (fun t => eq_sym (same_V t)) (fun t _ => eq_refl)).
  apply (follows_by _ _ _ (level_parts _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ (r2 / (2 * r_adaptation'rate)) (/ (2 * gain_K))
    (/ (2 * gain_Gamma)) r_KD_1 r_KD_2 r_GammaD_1 r_GammaD_2
    error_1 error_2 weighted_follows_1 weighted_follows_2 H_K_1 H_K_2 H_Gamma_1 H_Gamma_2)).
  intros t Ht. rewrite same_K_1, same_K_2, same_Gamma_1, same_Gamma_2.
  replace (quadratic_1 t) with (- - quadratic_1 t) by ring. replace (quadratic_2 t) with (- - quadratic_2 t) by ring.
  rewrite <- gains_1, <- gains_2 by lra. drive.
  assert (gain_K <> 0) by (unfold gain_K; domain). assert (gain_Gamma <> 0) by (unfold gain_Gamma; domain).
  assert (r2 <> 0) by (unfold r2; domain). field. repeat split; auto; domain.
Qed.
End LawLeastSquares.
Print Assumptions least_squares_kept.
Print Assumptions least_squares_rate.
