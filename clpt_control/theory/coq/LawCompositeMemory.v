(* Law composite-memory, for every N: V falls and e -> 0. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem PaperLoop AddedRates Memory TwoAxes.
Open Scope R_scope.

Section LawCompositeMemory.
(* record of composite-memory *)

(* text of axes.txt *)
Let gain_K := r_gamma.    Let gain_Gamma := r_gamma.
(* text of gains.txt *)
(* text of filter.txt *)
(* the memory of the flow, which is zero at the start *)
Let h k t := r_adaptation'forgetting * r_phi_f k t.
Let size t := sum N (fun k => (r_phi_f k t)^2) + 1.
Let noted := new N r_Q r_phi_f h.
Hypothesis start_Q : forall k j, (k < N)%nat -> (j < N)%nat -> r_Q k j 0 = 0.
Hypothesis start_flow_1 : forall k, (k < N)%nat -> r_b_1 k 0 = 0.
Hypothesis start_flow_2 : forall k, (k < N)%nat -> r_b_2 k 0 = 0.
Ltac same_memory run := unfold run, noted, new, h, size; equal_rates.
Lemma same_Q k j t : run_Q k j t = / size t * (noted k t * noted j t).
Proof. same_memory run_Q. Qed.
Lemma same_b_1 k t : run_b_1 k t =
  / size t * ((r_adaptation'filter * r_x_1 t - r_q_1 t - sum N (fun j => r_b_1 j t * h j t)) * noted k t).
Proof. same_memory run_b_1. Qed.
Lemma same_b_2 k t : run_b_2 k t =
  / size t * ((r_adaptation'filter * r_x_2 t - r_q_2 t - sum N (fun j => r_b_2 j t * h j t)) * noted k t).
Proof. same_memory run_b_2. Qed.
Lemma size_positive t : 0 < size t.
Proof. unfold size. positive. Qed.
Lemma size_bounded : locally_bounded (fun t => / size t).
Proof.
  intros T. exists 1. intros t _. assert (P := size_positive t). assert (C : 1 <= size t).
  { unfold size. assert (0 <= sum N (fun k => (r_phi_f k t)^2)) by not_negative. lra. }
  rewrite Rabs_pos_eq by (apply Rlt_le, Rinv_0_lt_compat; auto). rewrite <- Rinv_1. apply Rinv_le_contravar; lra.
Qed.
Lemma phi_f_bounded k : (k < N)%nat -> locally_bounded (r_phi_f k).
Proof. intros Hk. apply (locally_follows _ _ (H_phi_f k Hk)). Qed.
Lemma h_bounded k : (k < N)%nat -> locally_bounded (h k).
Proof. intros Hk. apply (locally_mult (fun _ => _)); [apply locally_const|apply phi_f_bounded, Hk]. Qed.
Lemma memory k j : (k < N)%nat -> (j < N)%nat -> follows (r_Q k j) (fun t => / size t * (noted k t * noted j t)).
Proof. intros Hk Hj. apply (follows_by _ _ _ (H_Q k Hk j Hj)). intros t _. apply same_Q. Qed.
Lemma symmetric k j t : (k < N)%nat -> (j < N)%nat -> 0 <= t -> r_Q k j t = r_Q j k t.
Proof. apply (memory_symmetric N r_Q (fun t => / size t) r_phi_f h memory start_Q). Qed.
Lemma kept_flow_1 k t : (k < N)%nat -> 0 <= t -> r_b_1 k t = sum N (fun j => r_theta_1 j * r_Q j k t).
Proof.
  apply (memory_kept N r_Q (fun t => / size t) r_phi_f h memory size_bounded phi_f_bounded h_bounded start_Q r_b_1
    (fun t => r_adaptation'filter * r_x_1 t - r_q_1 t)); auto.
  - intros i Hi. apply (follows_by _ _ _ (H_b_1 i Hi)). intros u _. apply same_b_1.
  - intros u Hu. rewrite kept_q_1 by lra. ring.
Qed.
Lemma kept_flow_2 k t : (k < N)%nat -> 0 <= t -> r_b_2 k t = sum N (fun j => r_theta_2 j * r_Q j k t).
Proof.
  apply (memory_kept N r_Q (fun t => / size t) r_phi_f h memory size_bounded phi_f_bounded h_bounded start_Q r_b_2
    (fun t => r_adaptation'filter * r_x_2 t - r_q_2 t)); auto.
  - intros i Hi. apply (follows_by _ _ _ (H_b_2 i Hi)). intros u _. apply same_b_2.
  - intros u Hu. rewrite kept_q_2 by lra. ring.
Qed.
(* eta Q eta^T, eta = theta + alpha *)
Definition eta_1 k t := r_theta_1 k + r_alpha_1 k t.
Definition eta_2 k t := r_theta_2 k + r_alpha_2 k t.
Definition known (eta : nat -> R -> R) t := sum N (fun k => sum N (fun j => eta k t * eta j t * r_Q k j t)).
Lemma known_nonneg eta t : 0 <= t -> 0 <= known eta t.
Proof.
  apply (memory_nonneg N r_Q (fun t => / size t) r_phi_f h memory
    ltac:(intros u _; apply Rlt_le, Rinv_0_lt_compat, size_positive) start_Q (fun k => eta k t)).
Qed.

Let a_of (alpha_i b_i : nat -> R -> R) k t := - r_adaptation'memory_gain
  * (b_i k t + sum N (fun j => r_Q k j t * alpha_i j t)).
Let a := two (a_of r_alpha_1 r_b_1) (a_of r_alpha_2 r_b_2).
Let b := two (fun t => r_gamma * (r_b_v_1'1 t - r_Q_1_1'1 t * r_K_1 t - r_Q_1_1'2 t * r_Gamma_1 t))
             (fun t => r_gamma * (r_b_v_2'1 t - r_Q_2_1'1 t * r_K_2 t - r_Q_2_1'2 t * r_Gamma_2 t)).
Let c := two (fun t => r_gamma * (r_b_v_1'2 t - r_Q_1_2'1 t * r_K_1 t - r_Q_1_2'2 t * r_Gamma_1 t))
             (fun t => r_gamma * (r_b_v_2'2 t - r_Q_2_2'1 t * r_K_2 t - r_Q_2_2'2 t * r_Gamma_2 t)).
Ltac added_rates := cbv [a_of two].
(* text of added.txt *)
(* text of level.txt *)

Lemma pulled theta_i alpha_i b_i t : 0 <= t ->
  (forall k, (k < N)%nat -> b_i k t = sum N (fun j => theta_i j * r_Q j k t)) ->
  sum N (fun k => (theta_i k + alpha_i k t) * a_of alpha_i b_i k t)
  = - r_adaptation'memory_gain * known (fun k t => theta_i k + alpha_i k t) t.
Proof.
  intros Ht B. unfold known. rewrite <- sum_scal. apply sum_ext. intros k Hk. unfold a_of. rewrite B by auto.
  rewrite (sum_ext N (fun j => theta_i j * r_Q j k t) (fun j => r_Q k j t * theta_i j))
    by (intros; rewrite (symmetric k) by auto; ring).
  rewrite <- sum_plus, <- !sum_scal. apply sum_ext. intros; ring.
Qed.

Lemma added_is t : 0 <= t -> added 2 N theta KD GammaD alpha K Gamma a b c t =
  - r_adaptation'memory_gain * (known eta_1 t + known eta_2 t) - r_gamma * (quadratic_1 t + quadratic_2 t).
Proof.
  intros Ht. unfold added. rewrite !sum_two.
  change (fun k => (theta 0%nat k + alpha 0%nat k t) * a 0%nat k t)
    with (fun k => (r_theta_1 k + r_alpha_1 k t) * a_of r_alpha_1 r_b_1 k t).
  change (fun k => (theta 1%nat k + alpha 1%nat k t) * a 1%nat k t)
    with (fun k => (r_theta_2 k + r_alpha_2 k t) * a_of r_alpha_2 r_b_2 k t).
  rewrite (pulled r_theta_1 r_alpha_1), (pulled r_theta_2 r_alpha_2)
    by (auto; intros; first [apply kept_flow_1|apply kept_flow_2]; auto).
  change (known (fun k t => r_theta_1 k + r_alpha_1 k t) t) with (known eta_1 t).
  change (known (fun k t => r_theta_2 k + r_alpha_2 k t) t) with (known eta_2 t).
  assert (G1 := gains_1 t Ht). assert (G2 := gains_2 t Ht). unfold b, c. open.
  replace (quadratic_1 t + quadratic_2 t) with (- (- quadratic_1 t + - quadratic_2 t)) by ring.
  rewrite <- G1, <- G2. ring.
Qed.

Theorem composite_memory_rate : follows run_V (fun t => - sum 2 (fun i => KD i * (x i t - z i t)^2)
  - r_adaptation'memory_gain / r_gamma * (known eta_1 t + known eta_2 t) - quadratic_1 t - quadratic_2 t).
Proof.
  apply (follows_ext _ _ _ _ (fun t => eq_sym (same_V t)) (fun t _ => eq_refl)).
  apply (follows_by _ _ _ (added_rate _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ loop ltac:(lra))).
  intros t Ht. rewrite added_is by lra. field. domain.
Qed.

Lemma added_nonpositive t : 0 < t -> added 2 N theta KD GammaD alpha K Gamma a b c t <= 0.
Proof.
  intros Ht. rewrite added_is by lra.
  assert (A : 0 <= r_adaptation'memory_gain * (known eta_1 t + known eta_2 t)).
  { apply Rmult_le_pos; [lra|]. assert (Q1 := known_nonneg eta_1 t ltac:(lra)).
    assert (Q2 := known_nonneg eta_2 t ltac:(lra)). lra. }
  assert (B : 0 <= r_gamma * (quadratic_1 t + quadratic_2 t)).
  { apply Rmult_le_pos; [lra|]. assert (Q1 := quadratic_nonneg_1 t ltac:(lra)).
    assert (Q2 := quadratic_nonneg_2 t ltac:(lra)). lra. }
  lra.
Qed.

Theorem composite_memory_falls s t : 0 <= s <= t -> run_V t <= run_V s.
Proof.
  intros H. rewrite !same_V.
  apply (added_falls _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ loop P_gamma KD_positive added_nonpositive s t H).
Qed.

Theorem composite_memory_converges :
  (forall k, (k < N)%nat -> bounded (r_phi_x k)) -> bounded r_zc_1 -> bounded r_zc_2 ->
  is_lim (fun t => r_x_1 t - r_z_1 t) p_infty 0 /\ is_lim (fun t => r_x_2 t - r_z_2 t) p_infty 0.
Proof.
  intros Bp B1 B2.
  assert (C := added_converges _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ loop P_gamma KD_positive added_nonpositive Bp
    ltac:(intros [|i] Hi; assumption)).
  split; [apply (C 0%nat)|apply (C 1%nat)]; lia.
Qed.
End LawCompositeMemory.
Print Assumptions composite_memory_rate.
Print Assumptions composite_memory_falls.
Print Assumptions composite_memory_converges.
