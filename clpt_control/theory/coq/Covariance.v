(* Least squares with a covariance P, and w = eta P^-1, one axis:

     P'   = lambda P - P phi_f phi_f^T P/r^2        w' = -lambda w - g
     eta' = -(eta phi_f) P phi_f/r^2 - P g

   From a start with P = P^T and eta = w P, so it stays, and
     (w eta^T)' = -lambda w eta^T - (eta phi_f)^2/r^2 - 2 g eta^T *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus Memory.
Open Scope R_scope.

Section Covariance.
  Variables (N : nat) (P : nat -> nat -> R -> R) (lambda : R -> R) (r2 : R).
  Variables (phi_f w g eta : nat -> R -> R).
  Definition P_phi k t := sum N (fun j => P k j t * phi_f j t).
  Definition eps t := sum N (fun k => eta k t * phi_f k t).
  Hypothesis P_follows : forall k j, (k < N)%nat -> (j < N)%nat ->
    follows (P k j) (fun t => lambda t * P k j t - / r2 * (P_phi k t * P_phi j t)).
  Hypothesis w_follows : forall k, (k < N)%nat -> follows (w k) (fun t => - lambda t * w k t - g k t).
  Hypothesis eta_follows : forall k, (k < N)%nat ->
    follows (eta k) (fun t => - / r2 * eps t * P_phi k t - sum N (fun j => P k j t * g j t)).
  Hypothesis lambda_bounded : locally_bounded lambda.
  Hypothesis phi_f_bounded : forall k, (k < N)%nat -> locally_bounded (phi_f k).
  Hypothesis start_symmetric : forall k j, (k < N)%nat -> (j < N)%nat -> P k j 0 = P j k 0.
  Hypothesis start_eta : forall k, (k < N)%nat -> eta k 0 = sum N (fun j => w j 0 * P j k 0).

  Theorem covariance_symmetric k j t : (k < N)%nat -> (j < N)%nat -> 0 <= t -> P k j t = P j k t.
  Proof.
    intros Hk Hj Ht. assert (E : P k j t - P j k t = 0); [|lra].
    apply (scalar_stays (fun t => P k j t - P j k t) lambda); auto.
    - apply (follows_by _ _ _ (follows_minus _ _ _ _ (P_follows k j Hk Hj) (P_follows j k Hj Hk))). intros; ring.
    - rewrite start_symmetric by auto. ring.
  Qed.

  Lemma contracted f t : 0 <= t ->
    sum N (fun k => w k t * sum N (fun j => P k j t * f j)) = sum N (fun j => f j * sum N (fun k => w k t * P k j t)).
  Proof.
    intros Ht. rewrite (sum_ext N (fun k => w k t * _) (fun k => sum N (fun j => w k t * (P k j t * f j)))).
    2: { intros. rewrite sum_scal. ring. }
    rewrite sum_swap. apply sum_ext. intros j _. rewrite <- sum_scal. apply sum_ext. intros; ring.
  Qed.

  Theorem covariance_kept k t : (k < N)%nat -> 0 <= t -> eta k t = sum N (fun j => w j t * P j k t).
  Proof.
    intros Hk Ht. assert (E : eta k t - sum N (fun j => w j t * P j k t) = 0); [|lra].
    apply (vector_stays N (fun k t => eta k t - sum N (fun j => w j t * P j k t))
      (fun k t => - / r2 * P_phi k t) phi_f); auto.
    - intros i Hi. eapply follows_by.
      + eapply (follows_minus _ _ _ _ (eta_follows i Hi)). apply (follows_sum N (fun j t => w j t * P j i t)).
        intros j Hj. apply (follows_mult _ _ _ _ (w_follows j Hj) (P_follows j i Hj Hi)).
      + intros u Hu. cbv beta.
        rewrite (sum_ext N (fun j => (- lambda u * w j u - g j u) * _ + _)
          (fun j => - / r2 * P_phi i u * (w j u * P_phi j u) + -1 * (P i j u * g j u))).
        2: { intros j Hj. rewrite (covariance_symmetric j i) by (auto; lra). ring. }
        rewrite sum_plus, !sum_scal. unfold P_phi at 3. rewrite contracted by lra.
        rewrite (sum_ext N (fun j => (eta j u - _) * phi_f j u)
          (fun j => eta j u * phi_f j u + -1 * (phi_f j u * sum N (fun k => w k u * P k j u)))) by (intros; ring).
        rewrite sum_plus, sum_scal. unfold eps. ring.
    - intros i Hi. apply (locally_mult (fun _ => _)); [apply locally_const|]. unfold P_phi.
      apply (locally_sum N (fun j t => P i j t * phi_f j t)). intros j Hj. apply locally_mult; auto.
      apply (locally_follows _ _ (P_follows i j Hi Hj)).
    - intros i Hi. rewrite start_eta by auto. ring.
  Qed.

  Lemma contracted_eta f t : 0 <= t ->
    sum N (fun k => w k t * sum N (fun j => P k j t * f j)) = sum N (fun j => f j * eta j t).
  Proof. intros Ht. rewrite contracted by auto. apply sum_ext. intros j Hj. rewrite covariance_kept by auto. easy. Qed.

  Theorem weighted_rate : follows (fun t => sum N (fun k => w k t * eta k t))
    (fun t => - lambda t * sum N (fun k => w k t * eta k t) - / r2 * (eps t)^2 - 2 * sum N (fun k => g k t * eta k t)).
  Proof.
    eapply follows_by.
    - apply (follows_sum N (fun k t => w k t * eta k t)). intros k Hk.
      apply (follows_mult _ _ _ _ (w_follows k Hk) (eta_follows k Hk)).
    - intros u Hu. cbv beta.
      rewrite (sum_ext N _ (fun k => - lambda u * (w k u * eta k u) + -1 * (g k u * eta k u)
        + - / r2 * eps u * (w k u * sum N (fun j => P k j u * phi_f j u))
        + -1 * (w k u * sum N (fun j => P k j u * g j u)))) by (intros; unfold P_phi; ring).
      rewrite !sum_plus, !sum_scal, !contracted_eta by lra.
      rewrite (sum_ext N (fun j => phi_f j u * eta j u) (fun j => eta j u * phi_f j u)) by (intros; ring).
      unfold eps. ring.
  Qed.
End Covariance.

(* V of two axes by its parts *)
Lemma level_parts e_1 e_2 A_1 A_2 K_1 K_2 G_1 G_2 de_1 de_2 dA_1 dA_2 dK_1 dK_2 dG_1 dG_2 c k g kd_1 kd_2 gd_1 gd_2 :
  follows e_1 de_1 -> follows e_2 de_2 -> follows A_1 dA_1 -> follows A_2 dA_2 ->
  follows K_1 dK_1 -> follows K_2 dK_2 -> follows G_1 dG_1 -> follows G_2 dG_2 ->
  follows (fun t => / 2 * (e_1 t)^2 + / 2 * (e_2 t)^2 + c * (A_1 t + A_2 t)
      + k * (K_1 t - kd_1)^2 + k * (K_2 t - kd_2)^2 + g * (gd_1 - G_1 t)^2 + g * (gd_2 - G_2 t)^2)
    (fun t => e_1 t * de_1 t + e_2 t * de_2 t + c * (dA_1 t + dA_2 t)
      + 2 * k * ((K_1 t - kd_1) * dK_1 t + (K_2 t - kd_2) * dK_2 t)
      - 2 * g * ((gd_1 - G_1 t) * dG_1 t + (gd_2 - G_2 t) * dG_2 t)).
Proof. intros. eapply follows_by; [follow|]. intros t _. cbv beta. field. Qed.
