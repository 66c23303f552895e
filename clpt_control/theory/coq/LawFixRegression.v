(* The law fix-regression that runs, for every N: its step at a fix is least squares of AtFixes.v,
   so the bound of AtFixes.v holds for the V that runs.  A fix arrives without latency. *)
From Coq Require Import Reals Lra Lia List.
From Coq Require FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus Memory AtFixes.
Open Scope R_scope.

Section LawFixRegression.
(* record of fix-regression *)

Let r2 := r_adaptation'noise^2.
Let P_at t k j := r_P k j t.
Let J_at t k j := r_information k j t.
Let m_at t k := r_m k t.
Let g k t := gain N (P_at t) (m_at t) k.
Let s t := scale N (P_at t) (m_at t) r2.
Let eta_1 t k := r_theta_1 k + r_alpha_1 k t.
Let eta_2 t k := r_theta_2 k + r_alpha_2 k t.
Hypothesis taken : forall t, r_taken_1 t = 1.
Hypothesis s_positive : forall t, 0 < s t.

Ltac opened run := unfold run; rewrite ?Rplus_0_l.
(* between fixes *)
Lemma same_x_1 t : run_x_1 t = sum N (fun k => r_theta_1 k * r_phi_x k t) + r_v_x_1 t.
Proof. opened run_x_1. rewrite Rplus_comm. f_equal. apply sum_ext. intros; ring. Qed.
Lemma same_x_2 t : run_x_2 t = sum N (fun k => r_theta_2 k * r_phi_x k t) + r_v_x_2 t.
Proof. opened run_x_2. rewrite Rplus_comm. f_equal. apply sum_ext. intros; ring. Qed.
Lemma negative f (p : nat -> R) : - sum N (fun k => f k * p k) = sum N (fun k => - f k * p k).
Proof. replace (- sum N (fun k => f k * p k)) with (-1 * sum N (fun k => f k * p k)) by ring.
  rewrite <- sum_scal. apply sum_ext. intros; ring. Qed.
Lemma same_z_1 t : run_z_1 t = sum N (fun k => - r_alpha_1 k t * r_phi_z k t) + r_v_x_1 t.
Proof. opened run_z_1. rewrite <- (negative (fun k => r_alpha_1 k t) (fun k => r_phi_z k t)). ring. Qed.
Lemma same_z_2 t : run_z_2 t = sum N (fun k => - r_alpha_2 k t * r_phi_z k t) + r_v_x_2 t.
Proof. opened run_z_2. rewrite <- (negative (fun k => r_alpha_2 k t) (fun k => r_phi_z k t)). ring. Qed.
Lemma same_m k t : run_m k t = r_phi_z k t.
Proof. opened run_m. easy. Qed.

(* at a fix *)
Lemma same_alpha_1 k t : run_after_alpha_1 k t = r_alpha_1 k t - (r_fix_1 t - r_z_1 t) * g k t / s t.
Proof. opened run_after_alpha_1. rewrite taken. unfold g, s, scale, dot, gain, times, r2, Rdiv, P_at, m_at. ring. Qed.
Lemma same_alpha_2 k t : run_after_alpha_2 k t = r_alpha_2 k t - (r_fix_2 t - r_z_2 t) * g k t / s t.
Proof. opened run_after_alpha_2. rewrite taken. unfold g, s, scale, dot, gain, times, r2, Rdiv, P_at, m_at. ring. Qed.
(* (P - g g^T/s) m = (r^2/s) g *)
Lemma joseph (q f : nat -> R) (c : R) t : (forall k, f k = m_at t k * (q k - g k t * c / s t)) ->
  sum N f = sum N (fun k => q k * m_at t k) - c * (s t - r2) / s t.
Proof.
  intros E. assert (D := s_positive t).
  rewrite (sum_ext N f (fun k => q k * m_at t k + - c / s t * (m_at t k * g k t))) by (intros; rewrite E; field; lra).
  rewrite sum_plus, sum_scal. change (sum N (fun k => m_at t k * g k t)) with (dot N (m_at t) (gain N (P_at t) (m_at t))).
  replace (dot N (m_at t) (gain N (P_at t) (m_at t))) with (s t - r2) by (unfold s, scale; ring). field. lra.
Qed.
Lemma same_P k j t : run_after_P k j t = P_next N (P_at t) (m_at t) r2 k j.
Proof.
  assert (D := s_positive t). opened run_after_P. rewrite taken.
  pose (product i l := r_m l t * (r_P i l t - sum N (fun k2 => r_P l k2 t * r_m k2 t) * sum N (fun k1 => r_P i k1 t * r_m k1 t)
    / (r_adaptation'noise^2 + sum N (fun k1 => r_m k1 t * sum N (fun k2 => r_P k1 k2 t * r_m k2 t))))).
  rewrite (sum_ext N (fun k1 => r_m k1 t * (r_P j k1 t - _)) (product j)) by (intros; unfold product, Rdiv; ring).
  rewrite (sum_ext N (fun k1 => r_m k1 t * (r_P k k1 t - _)) (product k)) by (intros; unfold product, Rdiv; ring).
  rewrite (joseph (fun l => P_at t k l) (product k) (g k t) t) by (intros; easy).
  rewrite (joseph (fun l => P_at t j l) (product j) (g j t) t) by (intros; easy).
  change (sum N (fun i => r_P k i t * r_m i t)) with (g k t). change (sum N (fun i => r_P j i t * r_m i t)) with (g j t).
  change (sum N (fun i => P_at t k i * m_at t i)) with (g k t). change (sum N (fun i => P_at t j i * m_at t i)) with (g j t).
  change (r_adaptation'noise^2 + sum N (fun k1 => r_m k1 t * sum N (fun k2 => r_P k1 k2 t * r_m k2 t))) with (s t).
  change (sum N (fun k1 => r_m k1 t * sum N (fun k2 => r_P k1 k2 t * r_m k2 t))) with (dot N (m_at t) (gain N (P_at t) (m_at t))).
  replace (dot N (m_at t) (gain N (P_at t) (m_at t))) with (s t - r2) by (unfold s, scale; ring).
  unfold P_next. change (gain N (P_at t) (m_at t) k) with (g k t). change (gain N (P_at t) (m_at t) j) with (g j t).
  change (scale N (P_at t) (m_at t) r2) with (s t). unfold P_at. fold r2. field. split; lra.
Qed.
Lemma r2_positive : 0 < r2.
Proof. unfold r2. apply pow_lt, P_adaptation'noise. Qed.
Lemma same_information k j t : run_after_information k j t = J_next (J_at t) (m_at t) r2 k j.
Proof. assert (D := r2_positive). opened run_after_information. unfold J_next, J_at, m_at. rewrite taken. fold r2. field. lra. Qed.
Lemma same_z_after_1 t : run_after_z_1 t = r_fix_1 t.
Proof. opened run_after_z_1. rewrite taken. ring. Qed.
Lemma same_z_after_2 t : run_after_z_2 t = r_fix_2 t.
Proof. opened run_after_z_2. rewrite taken. ring. Qed.
Lemma same_m_after k t : run_after_m k t = 0.
Proof. opened run_after_m. rewrite taken. ring. Qed.
(* of a fix that arrives late, these are kept *)
Lemma same_sent t : run_after_sent_1 t = r_fix_1 t /\ run_after_sent_2 t = r_fix_2 t.
Proof. opened run_after_sent_1. opened run_after_sent_2. easy. Qed.
Lemma same_z_sent t : run_after_z_sent_1 t = r_z_1 t /\ run_after_z_sent_2 t = r_z_2 t.
Proof. opened run_after_z_sent_1. opened run_after_z_sent_2. easy. Qed.
Lemma same_m_sent k t : run_after_m_sent k t = r_m k t.
Proof. opened run_after_m_sent. easy. Qed.

Lemma divisors t : divisor_1 t <> 0 /\ divisor_2 t <> 0 /\ divisor_3 t <> 0 /\ divisor_4 t <> 0.
Proof.
  assert (D := s_positive t). assert (E := r2_positive).
  assert (A : divisor_1 t = s t) by easy.
  assert (B : divisor_2 t = 2 * s t) by (unfold divisor_2, s, scale, dot, gain, times, r2, P_at, m_at; ring).
  assert (C : 0 < s t ^ 2) by (apply pow_lt; auto).
  change (divisor_3 t) with (s t ^ 2). change (divisor_4 t) with r2. repeat split; lra.
Qed.

Lemma weighted_sum t (a eta : nat -> R) : (forall k, a k = eta k) ->
  sum N (fun k => a k * sum N (fun j => r_information j k t * a j)) = form N (J_at t) eta.
Proof.
  intros E. unfold form. rewrite sum_swap. apply sum_ext. intros k _. rewrite <- sum_scal. apply sum_ext.
  intros j _. rewrite !E. unfold J_at. ring.
Qed.
Lemma same_V t : run_V t = r2 / 2 * (form N (J_at t) (eta_1 t) + form N (J_at t) (eta_2 t)).
Proof.
  opened run_V. fold r2.
  rewrite (weighted_sum t (fun k => r_alpha_1 k t + r_theta_1 k) (eta_1 t)) by (intros; unfold eta_1; ring).
  rewrite (weighted_sum t (fun k => r_alpha_2 k t + r_theta_2 k) (eta_2 t)) by (intros; unfold eta_2; ring).
  field.
Qed.
End LawFixRegression.

(* The law flies: leg n lies between fixes n and n + 1, at which the states jump as the record says;
   between them they move as the record says.  P begins with prior^2 I, its inverse beside it. *)
Section Flies.
Variables (N : nat) (noise prior : R) (theta : nat -> nat -> R) (alpha P_run J_run : nat -> nat -> nat -> R).
Variables (phi : nat -> nat -> (nat -> R) -> R -> R) (x z v Delta M : nat -> nat -> R -> R).
Variables (nu : nat -> nat -> R) (T : nat -> R) (L delta top_noise top_T : R).
Let m n k := M n k (T n).
Let measured n i := x n i (T n) + nu (S n) i.
Let y n i := measured n i - z n i (T n).
Let at_z n u k := phi n k (fun j => z n j u) u.
Definition run_level n := run_V N noise (fun k _ => alpha n 0%nat k) (fun k _ => alpha n 1%nat k)
  (fun k j _ => J_run n k j) (theta 0%nat) (theta 1%nat) 0.
Hypothesis noise_positive : 0 < noise.
Hypothesis prior_positive : 0 < prior.
Hypothesis start_P : forall k j, P_run 0 k j = prior^2 * identity k j.
Hypothesis start_J : forall k j, J_run 0 k j = / prior^2 * identity k j.
(* the record at a fix *)
Hypothesis alpha_1_jumps : forall n k, alpha (S n) 0%nat k = run_after_alpha_1 N (fun k j _ => P_run n k j) noise
  (fun k _ => alpha n 0%nat k) (fun _ => measured n 0%nat) (fun k _ => m n k) (fun _ => 1) (fun _ => z n 0%nat (T n)) k 0.
Hypothesis alpha_2_jumps : forall n k, alpha (S n) 1%nat k = run_after_alpha_2 N (fun k j _ => P_run n k j) noise
  (fun k _ => alpha n 1%nat k) (fun _ => measured n 1%nat) (fun k _ => m n k) (fun _ => 1) (fun _ => z n 1%nat (T n)) k 0.
Hypothesis P_jumps : forall n k j, P_run (S n) k j =
  run_after_P N (fun k j _ => P_run n k j) noise (fun k _ => m n k) (fun _ => 1) k j 0.
Hypothesis J_jumps : forall n k j, J_run (S n) k j =
  run_after_information noise (fun k j _ => J_run n k j) (fun k _ => m n k) (fun _ => 1) k j 0.
Hypothesis z_1_jumps : forall n, z (S n) 0%nat 0 =
  run_after_z_1 (fun _ => measured n 0%nat) (fun _ => 1) (fun _ => z n 0%nat (T n)) 0.
Hypothesis z_2_jumps : forall n, z (S n) 1%nat 0 =
  run_after_z_2 (fun _ => measured n 1%nat) (fun _ => 1) (fun _ => z n 1%nat (T n)) 0.
Hypothesis m_jumps : forall n k, M (S n) k 0 = run_after_m (fun k _ => m n k) (fun _ => 1) k 0.
(* the record between fixes; Delta is what the functions do not express *)
Hypothesis x_1_moves : forall n, follows (x n 0%nat) (fun s =>
  run_x_1 N (fun k u => phi n k (fun j => x n j u) u) (theta 0%nat) (v n 0%nat) s + Delta n 0%nat s).
Hypothesis x_2_moves : forall n, follows (x n 1%nat) (fun s =>
  run_x_2 N (fun k u => phi n k (fun j => x n j u) u) (theta 1%nat) (v n 1%nat) s + Delta n 1%nat s).
Hypothesis z_1_moves : forall n, follows (z n 0%nat)
  (run_z_1 N (fun k _ => alpha n 0%nat k) (fun k u => at_z n u k) (v n 0%nat)).
Hypothesis z_2_moves : forall n, follows (z n 1%nat)
  (run_z_2 N (fun k _ => alpha n 1%nat k) (fun k u => at_z n u k) (v n 1%nat)).
Hypothesis m_moves : forall n k, follows (M n k) (run_m (fun k u => at_z n u k) k).
(* the vehicle does not jump; the first fix *)
Hypothesis x_goes_on : forall n i, x (S n) i 0 = x n i (T n).
Hypothesis first_z : forall i, z 0%nat i 0 = x 0%nat i 0 + nu 0%nat i.
Hypothesis first_m : forall k, M 0%nat k 0 = 0.
(* limits of the sea and the fixes *)
Hypothesis L_positive : 0 < L.
Hypothesis delta_nonneg : 0 <= delta.
Hypothesis T_range : forall n, 0 <= T n <= top_T.
Hypothesis top_T_positive : 0 < top_T.
Hypothesis shear : forall n s p q, 0 < s ->
  norm 2 (fun i => flow N (phi n) theta i p s - flow N (phi n) theta i q s) <= L * norm 2 (fun i => p i - q i).
Hypothesis unmodelled : forall n s, 0 < s -> norm 2 (fun i => Delta n i s) <= delta.
Hypothesis fix_noise : forall n, norm 2 (nu n) <= top_noise.

Let r2 := noise^2.
Let hat_0 i k := - alpha 0 i k.
Lemma r2_up : 0 < r2.
Proof. apply pow_lt, noise_positive. Qed.
Lemma prior_up : 0 < prior^2.
Proof. apply pow_lt, prior_positive. Qed.
Lemma inv_up : 0 < / prior^2.
Proof. apply Rinv_0_lt_compat, prior_up. Qed.
Lemma identity_sym k j : identity k j = identity j k.
Proof. unfold identity. destruct (Nat.eq_dec k j), (Nat.eq_dec j k); congruence. Qed.
Lemma P_sym : forall k j, (k < N)%nat -> (j < N)%nat -> P_run 0 k j = P_run 0 j k.
Proof. intros. rewrite !start_P, identity_sym. easy. Qed.
Lemma J_sym : forall k j, (k < N)%nat -> (j < N)%nat -> J_run 0 k j = J_run 0 j k.
Proof. intros. rewrite !start_J, identity_sym. easy. Qed.
Lemma picked (f : nat -> R) k : (k < N)%nat -> sum N (fun j => f j * identity k j) = f k.
Proof.
  intros Hk. rewrite (sum_single N (fun j => f j * identity k j) k); auto.
  - unfold identity. destruct (Nat.eq_dec k k); [ring|easy].
  - intros j Hj Ne. unfold identity. destruct (Nat.eq_dec k j); [congruence|ring].
Qed.
Lemma J_nonneg : forall a, 0 <= form N (J_run 0) a.
Proof.
  intros a. unfold form. apply sum_nonneg. intros k Hk.
  rewrite (sum_ext N _ (fun j => (/ prior^2 * a k * a j) * identity k j)) by (intros; rewrite start_J; ring).
  rewrite picked by auto. replace (/ prior ^ 2 * a k * a k) with (/ prior^2 * (a k)^2) by ring.
  assert (A := inv_up). apply Rmult_le_pos; [lra|apply pow2_ge_0].
Qed.
Lemma inverse : forall k l, (k < N)%nat -> (l < N)%nat -> sum N (fun j => J_run 0 k j * P_run 0 j l) = identity k l.
Proof.
  intros k l Hk Hl.
  rewrite (sum_ext N _ (fun j => identity j l * identity k j)).
  - apply (picked (fun j => identity j l) k Hk).
  - intros j _. rewrite start_J, start_P. field. apply Rgt_not_eq, prior_positive.
Qed.

Let s_up n := s_positive N r2 (P_run 0) (J_run 0) m r2_up P_sym J_sym J_nonneg inverse n.
Lemma P_is n : P_run n = P N r2 (P_run 0) m n.
Proof.
  induction n as [|n IH]; [easy|]. apply FunctionalExtensionality.functional_extensionality. intros k. apply FunctionalExtensionality.functional_extensionality.
  intros j. rewrite P_jumps. assert (D := s_up n). unfold s in D. rewrite <- IH in D. simpl. rewrite <- IH.
  apply (same_P N (fun k j _ => P_run n k j) noise (fun k _ => m n k)); auto.
Qed.
Lemma J_is n : J_run n = J r2 (J_run 0) m n.
Proof.
  induction n as [|n IH]; [easy|]. apply FunctionalExtensionality.functional_extensionality. intros k. apply FunctionalExtensionality.functional_extensionality.
  intros j. rewrite J_jumps. simpl. rewrite <- IH.
  apply (same_information noise noise_positive (fun k j _ => J_run n k j) (fun k _ => m n k)); auto.
Qed.
Lemma hat_is n k : hat N r2 hat_0 (P_run 0) m y n 0 k = - alpha n 0%nat k
  /\ hat N r2 hat_0 (P_run 0) m y n 1 k = - alpha n 1%nat k.
Proof.
  revert k. induction n as [|n IH]; [easy|]. intros k. destruct (IH k) as [A B].
  assert (D := s_up n). assert (E := D). unfold s in E. rewrite <- P_is in E. simpl. rewrite A, B, alpha_1_jumps, alpha_2_jumps.
  rewrite (same_alpha_1 N (fun k j _ => P_run n k j) noise (fun k _ => alpha n 0%nat k) (fun _ => measured n 0%nat)
    (fun k _ => m n k) (fun _ => 1) (fun _ => z n 0%nat (T n))), (same_alpha_2 N (fun k j _ => P_run n k j) noise
    (fun k _ => alpha n 1%nat k) (fun _ => measured n 1%nat) (fun k _ => m n k) (fun _ => 1) (fun _ => z n 1%nat (T n))) by auto.
  unfold s. rewrite <- P_is. change (fun k0 j => P_run n k0 j) with (P_run n). change (fun k0 => m n k0) with (m n).
  unfold y. fold r2. split; field; fold r2; lra.
Qed.
Lemma level_is n : run_level n = r2 / 2 * V 2 N r2 theta hat_0 (P_run 0) (J_run 0) m y n.
Proof.
  unfold run_level. rewrite same_V. unfold V, r2. cbn [sum]. rewrite Rplus_0_l, <- J_is. f_equal.
  f_equal; apply form_ext; intros k; unfold eta; destruct (hat_is n k) as [A B]; fold r2; [rewrite A|rewrite B]; ring.
Qed.

Lemma z_at_fix : forall n i, (i < 2)%nat -> z n i 0 = x n i 0 + nu n i.
Proof.
  intros [|n] i Hi; [apply first_z|]. rewrite x_goes_on. destruct i as [|[|i]]; [| |lia].
  - rewrite z_1_jumps, same_z_after_1; auto.
  - rewrite z_2_jumps, same_z_after_2; auto.
Qed.
Lemma x_moves : forall n i, (i < 2)%nat -> follows (x n i) (fun s => flow N (phi n) theta i (fun j => x n j s) s + v n i s + Delta n i s).
Proof.
  intros n [|[|i]] Hi; [| |lia]; eapply follows_by; [apply x_1_moves| |apply x_2_moves|]; intros t _; cbv beta.
  - rewrite same_x_1. unfold flow. easy.
  - rewrite same_x_2. unfold flow. easy.
Qed.
Lemma z_moves : forall n i, (i < 2)%nat -> follows (z n i)
  (fun s => flow N (phi n) (hat N r2 hat_0 (P_run 0) m y n) i (fun j => z n j s) s + v n i s).
Proof.
  intros n [|[|i]] Hi; [| |lia]; eapply follows_by; [apply z_1_moves| |apply z_2_moves|]; intros t _; cbv beta.
  - rewrite same_z_1. unfold flow. f_equal. apply sum_ext. intros k _. destruct (hat_is n k) as [A _]. rewrite A. easy.
  - rewrite same_z_2. unfold flow. f_equal. apply sum_ext. intros k _. destruct (hat_is n k) as [_ B]. rewrite B. easy.
Qed.
Lemma m_starts : forall n k, (k < N)%nat -> M n k 0 = 0.
Proof. intros [|n] k _; [apply first_m|]. rewrite m_jumps. apply (same_m_after (fun k _ => m n k)); auto. Qed.
Lemma y_is : forall n i, (i < 2)%nat -> y n i = x n i (T n) + nu (S n) i - z n i (T n).
Proof. intros. unfold y, measured. ring. Qed.
Lemma m_is : forall n k, (k < N)%nat -> m n k = M n k (T n).
Proof. easy. Qed.
Lemma m_follows : forall n k, (k < N)%nat -> follows (M n k) (fun s => phi n k (fun j => z n j s) s).
Proof. intros n k _. apply (follows_by _ _ _ (m_moves n k)). intros t _. apply same_m. Qed.

(* B bounds 2 V, kappa r the error of the prediction along leg n by P *)
Theorem fix_regression_bound (B kappa : nat -> R) : 2 * run_level 0 <= B 0%nat -> (forall n, 0 <= kappa n) ->
  (forall n u, 0 < u < top_T -> form N (P_run n) (at_z n u) <= noise^2 * (kappa n)^2) ->
  (forall n, B n + (omega L delta top_noise top_T + growth L top_T * kappa n * sqrt (B n))^2 <= B (S n)) ->
  forall n, 2 * run_level n <= B n.
Proof.
  intros B0 K0 K Next n. rewrite level_is.
  replace (2 * (r2 / 2 * V 2 N r2 theta hat_0 (P_run 0) (J_run 0) m y n))
    with (r2 * V 2 N r2 theta hat_0 (P_run 0) (J_run 0) m y n) by field.
  apply (certificate 2 N r2 theta hat_0 (P_run 0) (J_run 0) phi x z v Delta M nu T m y L delta top_noise top_T
    r2_up P_sym J_sym J_nonneg inverse m_is y_is z_at_fix x_moves z_moves m_follows m_starts L_positive delta_nonneg
    T_range top_T_positive shear unmodelled fix_noise B kappa); auto.
  - rewrite level_is in B0. replace (r2 * V 2 N r2 theta hat_0 (P_run 0) (J_run 0) m y 0)
      with (2 * (r2 / 2 * V 2 N r2 theta hat_0 (P_run 0) (J_run 0) m y 0)) by field. exact B0.
  - intros k u Hu. rewrite <- P_is. apply K, Hu.
Qed.

Theorem fix_regression_flow n a : sum 2 (fun i => (dot N (fun k => theta i k + alpha n i k) a)^2)
  <= 2 * run_level n / noise^2 * form N (P_run n) a.
Proof.
  assert (F := flow_error 2 N r2 theta hat_0 (P_run 0) (J_run 0) m y r2_up P_sym J_sym J_nonneg inverse n a).
  rewrite level_is. fold r2.
  replace (2 * (r2 / 2 * V 2 N r2 theta hat_0 (P_run 0) (J_run 0) m y n) / r2)
    with (V 2 N r2 theta hat_0 (P_run 0) (J_run 0) m y n) by (assert (A := r2_up); field; lra).
  rewrite <- P_is in F. eapply Rle_trans; [|exact F]. right. apply sum_ext. intros i Hi. f_equal. apply sum_ext. intros k _.
  f_equal. unfold eta. destruct (hat_is n k) as [A B]. destruct i as [|[|i]]; [rewrite A|rewrite B|lia]; ring.
Qed.

(* in the end, where the legs hold k T^2 phi^T P phi <= ell r^2 and ell^(1/2) (e^(L T) - 1 - L T)/(L T) < 1 *)
Theorem fix_regression_ultimately ell n0 eps : (1 <= n0)%nat -> 0 <= ell -> rho L top_T ell < 1 ->
  (forall n u, (n0 <= n)%nat -> 0 < u < top_T -> INR n * (top_T^2 * form N (P_run n) (at_z n u)) <= noise^2 * ell) ->
  0 < eps -> exists n1, forall n, (n1 <= n)%nat ->
  2 * run_level n / INR n <= (omega L delta top_noise top_T / (1 - rho L top_T ell))^2 + eps.
Proof.
  intros Hn He Hr K Hp.
  destruct (V_ultimately 2 N r2 theta hat_0 (P_run 0) (J_run 0) phi x z v Delta M nu T m y L delta top_noise top_T ell n0
    r2_up P_sym J_sym J_nonneg inverse m_is y_is z_at_fix x_moves z_moves m_follows m_starts L_positive delta_nonneg
    T_range top_T_positive shear unmodelled fix_noise Hn He Hr) with (eps := eps) as [n1 H]; auto.
  - intros n u H1 H2. rewrite <- P_is. apply K; auto.
  - exists n1. intros n H1. rewrite level_is.
    replace (2 * (r2 / 2 * V 2 N r2 theta hat_0 (P_run 0) (J_run 0) m y n))
      with (r2 * V 2 N r2 theta hat_0 (P_run 0) (J_run 0) m y n) by field. apply H, H1.
Qed.
End Flies.
Print Assumptions fix_regression_bound.
Print Assumptions fix_regression_flow.
Print Assumptions fix_regression_ultimately.
