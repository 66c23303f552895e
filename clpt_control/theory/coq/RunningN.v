(* Theorem 3.2 for the blocks that run, law learned-flow, for every N. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem Trajectories PaperLoop TwoAxes.
Open Scope R_scope.

Section RunningN.
(* record of learned-flow *)

(* text of axes.txt *)
Lemma same_alpha_1 k t : run_alpha_1 k t = alpha_rate r_gamma x@t z@t r_phi_x@t 0 k.
Proof. same run_alpha_1. Qed.
Lemma same_alpha_2 k t : run_alpha_2 k t = alpha_rate r_gamma x@t z@t r_phi_x@t 1 k.
Proof. same run_alpha_2. Qed.
Lemma same_K_1 t : run_K_1 t = K_rate r_gamma x@t z@t 0.
Proof. same run_K_1. Qed.
Lemma same_K_2 t : run_K_2 t = K_rate r_gamma x@t z@t 1.
Proof. same run_K_2. Qed.
Lemma same_Gamma_1 t : run_Gamma_1 t = Gamma_rate r_gamma x@t z@t zc@t 0.
Proof. same run_Gamma_1. Qed.
Lemma same_Gamma_2 t : run_Gamma_2 t = Gamma_rate r_gamma x@t z@t zc@t 1.
Proof. same run_Gamma_2. Qed.

(* text of level.txt *)

Lemma loop : closed_loop 2 N theta alpha_M KD GammaD r_gamma r_phi_x r_phi_z zc (fun _ _ => 0) x z alpha K Gamma.
Proof.
  constructor.
  - intros [|[|i]] Hi; [apply (follows_by _ _ _ H_x_1)|apply (follows_by _ _ _ H_x_2)|lia];
      intros t _; [apply same_x_1|apply same_x_2].
  - intros [|[|i]] Hi; [apply (follows_by _ _ _ H_z_1)|apply (follows_by _ _ _ H_z_2)|lia];
      intros t _; [apply same_z_1|apply same_z_2].
  - intros [|[|i]] k Hi Hk; [apply (follows_by _ _ _ (H_alpha_1 k Hk))|apply (follows_by _ _ _ (H_alpha_2 k Hk))|lia];
      intros t _; [apply same_alpha_1|apply same_alpha_2].
  - intros [|[|i]] Hi; [apply (follows_by _ _ _ H_K_1)|apply (follows_by _ _ _ H_K_2)|lia];
      intros t _; [apply same_K_1|apply same_K_2].
  - intros [|[|i]] Hi; [apply (follows_by _ _ _ H_Gamma_1)|apply (follows_by _ _ _ H_Gamma_2)|lia];
      intros t _; [apply same_Gamma_1|apply same_Gamma_2].
Qed.

Hypothesis phi_bounded : forall k, (k < N)%nat -> bounded (r_phi_x k).
Hypothesis zc_bounded : bounded r_zc_1 /\ bounded r_zc_2.

(* CLPE of the blocks that run goes to zero, for every N, and their V falls *)
Theorem running_V_falls s t : 0 <= s <= t -> run_V t <= run_V s.
Proof.
  intros H. rewrite !same_V. apply (theorem_3_2_falls 2 N theta alpha_M KD GammaD r_gamma r_phi_x r_phi_z zc
    (fun _ _ => 0) x z alpha K Gamma P_gamma KD_positive loop ltac:(auto) s t H).
Qed.

Theorem running_converges :
  is_lim (fun t => r_x_1 t - r_z_1 t) p_infty 0 /\ is_lim (fun t => r_x_2 t - r_z_2 t) p_infty 0.
Proof.
  assert (C := fun i Hi => theorem_3_2 2 N theta alpha_M KD GammaD r_gamma r_phi_x r_phi_z zc (fun _ _ => 0)
    x z alpha K Gamma P_gamma KD_positive phi_bounded ltac:(intros [|j] Hj; apply zc_bounded) loop ltac:(auto) i Hi).
  split; [apply (C 0%nat)|apply (C 1%nat)]; lia.
Qed.
End RunningN.
Print Assumptions running_V_falls.
Print Assumptions running_converges.
