(* Law normalised-gradient, for every N: V falls and e -> 0. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem PaperLoop AddedRates Memory TwoAxes.
Open Scope R_scope.

Section LawNormalisedGradient.
(* record of normalised-gradient *)

(* text of axes.txt *)
Let gain_K := r_gamma.    Let gain_Gamma := r_gamma.
(* text of gains.txt *)
(* text of filter.txt *)
Let a_of (alpha_i : nat -> R -> R) x_i q_i k t := - r_adaptation'regression_gain * r_phi_f k t
  * (r_adaptation'filter * x_i t - q_i t + sum N (fun k => alpha_i k t * r_phi_f k t))
  / (sum N (fun k => (r_phi_f k t)^2) + 1).
Let a := two (a_of r_alpha_1 r_x_1 r_q_1) (a_of r_alpha_2 r_x_2 r_q_2).
Let b := two (fun t => r_gamma * (r_b_v_1'1 t - r_Q_1_1'1 t * r_K_1 t - r_Q_1_1'2 t * r_Gamma_1 t))
             (fun t => r_gamma * (r_b_v_2'1 t - r_Q_2_1'1 t * r_K_2 t - r_Q_2_1'2 t * r_Gamma_2 t)).
Let c := two (fun t => r_gamma * (r_b_v_1'2 t - r_Q_1_2'1 t * r_K_1 t - r_Q_1_2'2 t * r_Gamma_1 t))
             (fun t => r_gamma * (r_b_v_2'2 t - r_Q_2_2'1 t * r_K_2 t - r_Q_2_2'2 t * r_Gamma_2 t)).
Ltac added_rates := cbv [a_of two].
(* text of added.txt *)
(* text of level.txt *)

Lemma added_is t : 0 <= t -> added 2 N theta KD GammaD alpha K Gamma a b c t =
  - r_adaptation'regression_gain * ((eps_1 t)^2 + (eps_2 t)^2) / (sum N (fun k => (r_phi_f k t)^2) + 1)
  - r_gamma * (quadratic_1 t + quadratic_2 t).
Proof.
  intros Ht. unfold added. rewrite !sum_two. unfold a, b, c. open. cbv [a_of].
  assert (D : sum N (fun k => (r_phi_f k t)^2) + 1 <> 0) by domain.
  assert (A : forall f g q, sum N (fun k => (f k + g k) * (- r_adaptation'regression_gain * r_phi_f k t * q
      / (sum N (fun k => (r_phi_f k t)^2) + 1)))
    = - r_adaptation'regression_gain * q / (sum N (fun k => (r_phi_f k t)^2) + 1)
      * sum N (fun k => (f k + g k) * r_phi_f k t)).
  { intros f g q. rewrite <- sum_scal. apply sum_ext. intros. field. exact D. }
  rewrite !A, unexplained_1, unexplained_2 by auto. fold (eps_1 t) (eps_2 t).
  assert (G1 := gains_1 t Ht). assert (G2 := gains_2 t Ht).
  match goal with |- ?p + ?q + ?r - ?s = _ => replace (p + q + r - s) with (p + q + (r - s)) by ring end.
  replace (quadratic_1 t + quadratic_2 t) with (- (- quadratic_1 t + - quadratic_2 t)) by ring.
  rewrite <- G1, <- G2. field. exact D.
Qed.

Theorem normalised_gradient_rate : follows run_V (fun t => - sum 2 (fun i => KD i * (x i t - z i t)^2)
  - r_adaptation'regression_gain / r_gamma * ((eps_1 t)^2 + (eps_2 t)^2) / (sum N (fun k => (r_phi_f k t)^2) + 1)
  - quadratic_1 t - quadratic_2 t).
Proof.
  apply (follows_ext _ _ _ _ (fun t => eq_sym (same_V t)) (fun t _ => eq_refl)).
  apply (follows_by _ _ _ (added_rate _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ loop ltac:(lra))).
  intros t Ht. rewrite added_is by lra. field. split; domain.
Qed.

Lemma added_nonpositive t : 0 < t -> added 2 N theta KD GammaD alpha K Gamma a b c t <= 0.
Proof.
  intros Ht. rewrite added_is by lra.
  assert (A : 0 <= r_adaptation'regression_gain * ((eps_1 t)^2 + (eps_2 t)^2) / (sum N (fun k => (r_phi_f k t)^2) + 1))
    by not_negative.
  assert (B : 0 <= r_gamma * (quadratic_1 t + quadratic_2 t)).
  { apply Rmult_le_pos; [lra|]. assert (Q1 := quadratic_nonneg_1 t ltac:(lra)).
    assert (Q2 := quadratic_nonneg_2 t ltac:(lra)). lra. }
  unfold Rdiv in *. lra.
Qed.

Theorem normalised_gradient_falls s t : 0 <= s <= t -> run_V t <= run_V s.
Proof.
  intros H. rewrite !same_V.
  apply (added_falls _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ loop P_gamma KD_positive added_nonpositive s t H).
Qed.

Theorem normalised_gradient_converges :
  (forall k, (k < N)%nat -> bounded (r_phi_x k)) -> bounded r_zc_1 -> bounded r_zc_2 ->
  is_lim (fun t => r_x_1 t - r_z_1 t) p_infty 0 /\ is_lim (fun t => r_x_2 t - r_z_2 t) p_infty 0.
Proof.
  intros Bp B1 B2.
  assert (C := added_converges _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ loop P_gamma KD_positive added_nonpositive Bp
    ltac:(intros [|i] Hi; assumption)).
  split; [apply (C 0%nat)|apply (C 1%nat)]; lia.
Qed.
End LawNormalisedGradient.
Print Assumptions normalised_gradient_rate.
Print Assumptions normalised_gradient_falls.
Print Assumptions normalised_gradient_converges.
