(* A trajectory with e(0) = 1 that meets the assumptions of Theorem 3.2: d = 1, N = 0, zc = 0, x = 0,
   z = -1/cosh t, K = tanh t, KD = 1, gamma = 1.  K starts at 0, off its true value 1. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem Barbalat Trajectories PaperLoop.
Open Scope R_scope.

Definition zero2 (_ _ : nat) := 0.
Definition one1 (_ : nat) := 1.
Definition still (_ : nat) (_ : R) := 0.
Definition z0 (_ : nat) t := - / cosh t.
Definition K0 (_ : nat) t := sinh t / cosh t.

Lemma cosh_pos t : 0 < cosh t.
Proof. unfold cosh. assert (A := exp_pos t). assert (B := exp_pos (-t)). lra. Qed.

Lemma d_cosh t : is_derive cosh t (sinh t).
Proof. unfold cosh, sinh. auto_derive; auto. field. Qed.
Lemma d_sinh t : is_derive sinh t (cosh t).
Proof. unfold cosh, sinh. auto_derive; auto. field. Qed.
Lemma unit_of t : cosh t ^ 2 - sinh t ^ 2 = 1.
Proof. unfold cosh, sinh. assert (A : exp t * exp (- t) = 1). { rewrite <- exp_plus. replace (t + - t) with 0 by ring. apply exp_0. }
  simpl. nra. Qed.

Lemma moving_loop : closed_loop 1 0 zero2 zero2 one1 (fun _ => 0) 1 still still still still still z0 (fun _ _ _ => 0) K0 still.
Proof.
  assert (C : forall t, cosh t <> 0) by (intros t; assert (A := cosh_pos t); lra).
  constructor.
  - intros [|i] Hi; [|lia]. apply (follows_by _ (fun _ => 0)); [apply (follows_const 0)|].
    intros t _. unfold x_rate, true_flow, v_x, still, one1; simpl. ring.
  - intros [|i] Hi; [|lia]. apply (follows_by _ (fun t => sinh t / cosh t ^ 2)).
    + apply follows_smooth. intros t. unfold z0.
      replace (sinh t / cosh t ^ 2) with (- (- (sinh t) / cosh t ^ 2)) by (field; apply C).
      apply @is_derive_opp. apply is_derive_inv; [apply d_cosh|apply C].
    + intros t _. unfold z_rate, modeled_flow, v_z, psi, still, z0, K0; simpl. field. apply C.
  - intros i k Hi Hk. lia.
  - intros [|i] Hi; [|lia]. apply (follows_by _ (fun t => / cosh t ^ 2)).
    + apply follows_smooth. intros t. unfold K0.
      replace (/ cosh t ^ 2) with ((cosh t * cosh t - sinh t * sinh t) / cosh t ^ 2).
      * apply is_derive_div; [apply d_sinh|apply d_cosh|apply C].
      * assert (U := unit_of t). replace (cosh t * cosh t - sinh t * sinh t) with 1 by (rewrite <- U; ring). field. apply C.
    + intros t _. unfold K_rate, error, still, z0; simpl. field. apply C.
  - intros [|i] Hi; [|lia]. apply (follows_by _ (fun _ => 0)); [apply (follows_const 0)|].
    intros t _. unfold Gamma_rate, error, still; simpl. ring.
Qed.

(* e(0) = 1, and e -> 0 by Theorem 3.2 *)
Example moving : (still 0 0 - z0 0 0 = 1) /\ is_lim (fun t => still 0 t - z0 0 t) p_infty 0.
Proof.
  split.
  - unfold still, z0, cosh. replace (- 0) with 0 by ring. rewrite exp_0. lra.
  - refine (theorem_3_2 1 0 zero2 zero2 one1 (fun _ => 0) 1 still still still still still z0 (fun _ _ _ => 0) K0 still
      Rlt_0_1 _ _ _ moving_loop _ 0%nat _).
    + intros i Hi. unfold one1. apply Rlt_0_1.
    + intros k Hk. inversion Hk.
    + intros i Hi. apply (bounded_const 0).
    + intros i t Hi Ht. reflexivity.
    + apply Nat.lt_0_1.
Qed.
Print Assumptions moving.
