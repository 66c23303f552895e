(* Theorem 3.2 with the basis of Eq. (5) in four readings of the printed exponent, r = |p - c_k|:

     exponential                    exp(-r/(2 s))        the kernel "exponential"
     gaussian with width s          exp(-r^2/(2 s))
     gaussian with width s^2        exp(-r^2/(2 s^2))    the kernel "gaussian"
     gaussian with width s/2        exp(-r^2/s)          the kernel "gaussian-sigma"

   These are definitions of this file: no file reads the record of the basis block that runs.  A
   loop whose reference jumps meets the assumptions of Theorem 3.2. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem Barbalat Trajectories PaperLoop MeanSquare.
Open Scope R_scope.

Section Basis.
  Variables (d N : nat) (c : nat -> nat -> R) (width frequency phase : nat -> R).
  Hypothesis width_positive : forall k, (k < N)%nat -> 0 < width k.

  Definition distance2 k (p : nat -> R) := sum d (fun i => (p i - c k i)^2).
  Definition exponential k p t := exp (- sqrt (distance2 k p) / (2 * width k)) * cos (frequency k * t + phase k).
  Definition gaussian k p t := exp (- distance2 k p / (2 * width k)) * cos (frequency k * t + phase k).

  Lemma at_most_1 r w a : 0 <= r -> 0 < w -> Rabs (exp (- r / (2 * w)) * cos a) <= 1.
  Proof.
    intros Hr Hw. rewrite Rabs_mult. rewrite <- (Rmult_1_r 1).
    apply Rmult_le_compat; try apply Rabs_pos.
    - rewrite Rabs_pos_eq by (apply Rlt_le, exp_pos). rewrite <- exp_0.
      assert (- r / (2 * w) <= 0).
      { unfold Rdiv. assert (0 < / (2 * w)) by (apply Rinv_0_lt_compat; lra). nra. }
      destruct (Req_dec (- r / (2 * w)) 0) as [->|]; [lra|]. apply Rlt_le, exp_increasing. lra.
    - apply Rabs_le. assert (B := COS_bound a). lra.
  Qed.

  Lemma distance2_nonneg k p : 0 <= distance2 k p.
  Proof. apply sum_nonneg. intros. apply pow2_ge_0. Qed.

  Lemma exponential_bounded (x : nat -> R -> R) k : (k < N)%nat ->
    bounded (fun t => exponential k (fun i => x i t) t).
  Proof. intros Hk. exists 1. intros t _. apply at_most_1; auto. apply sqrt_pos. Qed.

  Lemma gaussian_bounded (x : nat -> R -> R) k : (k < N)%nat ->
    bounded (fun t => gaussian k (fun i => x i t) t).
  Proof. intros Hk. exists 1. intros t _. apply at_most_1; auto. apply distance2_nonneg. Qed.

  Variables (theta alpha_M : nat -> nat -> R) (KD GammaD : nat -> R) (gamma : R) (zc : nat -> R -> R).
  Variables (x z : nat -> R -> R) (alpha : nat -> nat -> R -> R) (K Gamma : nat -> R -> R).
  Hypothesis gamma_positive : 0 < gamma.
  Hypothesis KD_positive : forall i, (i < d)%nat -> 0 < KD i.
  Hypothesis zc_bounded : forall i, (i < d)%nat -> bounded (zc i).

  Theorem theorem_3_2_exponential :
    closed_loop d N theta alpha_M KD GammaD gamma (fun k t => exponential k (fun i => x i t) t)
      (fun k t => exponential k (fun i => z i t) t) zc (fun _ _ => 0) x z alpha K Gamma ->
    forall i, (i < d)%nat -> is_lim (fun t => x i t - z i t) p_infty 0.
  Proof.
    intros loop. apply (theorem_3_2 d N theta alpha_M KD GammaD gamma _ _ zc (fun _ _ => 0) x z alpha K Gamma
      gamma_positive KD_positive (fun k Hk => exponential_bounded x k Hk) zc_bounded loop (fun _ _ _ _ => eq_refl)).
  Qed.

  Theorem theorem_3_2_gaussian :
    closed_loop d N theta alpha_M KD GammaD gamma (fun k t => gaussian k (fun i => x i t) t)
      (fun k t => gaussian k (fun i => z i t) t) zc (fun _ _ => 0) x z alpha K Gamma ->
    forall i, (i < d)%nat -> is_lim (fun t => x i t - z i t) p_infty 0.
  Proof.
    intros loop. apply (theorem_3_2 d N theta alpha_M KD GammaD gamma _ _ zc (fun _ _ => 0) x z alpha K Gamma
      gamma_positive KD_positive (fun k Hk => gaussian_bounded x k Hk) zc_bounded loop (fun _ _ _ _ => eq_refl)).
  Qed.
End Basis.

(* a reference that jumps from 1 to -1 at t = 1, and a trajectory that follows it *)
Definition jump t := if Rlt_dec t 1 then 1 else -1.
Definition turn t := Rmin 1 (-1 + 2 * exp (1 - t)).

Lemma turn_follows : follows turn (fun t => - turn t + jump t).
Proof.
  assert (D : forall t, is_derive (fun t => -1 + 2 * exp (1 - t)) t (- 2 * exp (1 - t))).
  { intros t. auto_derive; auto. unfold Rminus. ring. }
  assert (L : forall t, t < 1 -> 1 < exp (1 - t)).
  { intros t Ht. assert (E := exp_increasing 0 (1 - t) ltac:(lra)). rewrite exp_0 in E. exact E. }
  assert (M : forall t, 1 < t -> exp (1 - t) < 1).
  { intros t Ht. assert (E := exp_increasing (1 - t) 0 ltac:(lra)). rewrite exp_0 in E. exact E. }
  split.
  - intros t _. apply continuity_pt_filterlim.
    apply (continuity_pt_ext (fun t => (1 + (-1 + 2 * exp (1 - t)) - Rabs (1 - (-1 + 2 * exp (1 - t)))) / 2)).
    + intros s. unfold turn, Rmin, Rabs. destruct (Rle_dec 1 (-1 + 2 * exp (1 - s))), (Rcase_abs (1 - (-1 + 2 * exp (1 - s)))); lra.
    + reg.
  - intros T. exists (1 :: nil). intros t Ht Hn. assert (t <> 1) by (intros ->; apply Hn; simpl; auto).
    destruct (Rlt_le_dec t 1) as [Lt|Ge].
    + apply (is_derive_ext_loc (fun _ => 1)).
      * exists (mkposreal (1 - t) ltac:(lra)). intros y Hy. assert (A : Rabs (y - t) < 1 - t) by exact Hy.
        apply Rabs_lt_between in A. unfold turn. assert (B := L y ltac:(lra)). rewrite Rmin_left; lra.
      * unfold turn, jump. assert (B := L t Lt). rewrite Rmin_left by lra. destruct (Rlt_dec t 1); [|lra].
        replace (- (1) + 1) with 0 by ring. apply @is_derive_const.
    + apply (is_derive_ext_loc (fun t => -1 + 2 * exp (1 - t))).
      * exists (mkposreal (t - 1) ltac:(lra)). intros y Hy. assert (A : Rabs (y - t) < t - 1) by exact Hy.
        apply Rabs_lt_between in A. unfold turn. assert (B := M y ltac:(lra)). rewrite Rmin_right; lra.
      * unfold turn, jump. assert (B := M t ltac:(lra)). rewrite Rmin_right by lra. destruct (Rlt_dec t 1); [lra|].
        replace (- (-1 + 2 * exp (1 - t)) + -1) with (- 2 * exp (1 - t)) by ring. apply D.
Qed.

(* so the hypotheses of Theorem 3.2 hold of a loop with a jump, started true *)
Example loop_with_jump : closed_loop 1 0 (fun _ _ => 0) (fun _ _ => 0) (fun _ => 1) (fun _ => 1) 1
  (fun _ _ => 0) (fun _ _ => 0) (fun _ => jump) (fun _ _ => 0) (fun _ => turn) (fun _ => turn)
  (fun _ _ _ => 0) (fun _ _ => 1) (fun _ _ => 1).
Proof.
  constructor; intros.
  - apply (follows_by _ _ _ turn_follows). intros. unfold x_rate, true_flow, v_x; simpl. ring.
  - apply (follows_by _ _ _ turn_follows). intros. unfold z_rate, modeled_flow, v_z, psi; simpl. ring.
  - lia.
  - apply (follows_by _ _ _ (follows_const 1)). intros. unfold K_rate, error. ring.
  - apply (follows_by _ _ _ (follows_const 1)). intros. unfold Gamma_rate, error. ring.
Qed.
Print Assumptions theorem_3_2_exponential.
Print Assumptions theorem_3_2_gaussian.
Print Assumptions loop_with_jump.
