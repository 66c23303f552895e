(* Theorem 3.1 for the blocks that run, law known-flow, for every N. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem PaperLoop MeanSquare KnownFlow TwoAxes.
Open Scope R_scope.

Section LawKnownFlow.
(* record of known-flow *)

Local Notation "f @ t" := (fun i => f i t) (at level 5).
Let theta := two r_theta_1 r_theta_2.    Let theta_h := two r_theta_hat_1 r_theta_hat_2.
Let alpha_M := two r_alpha_M_1 r_alpha_M_2.
Let KD := two r_KD_1 r_KD_2.             Let GammaD := two r_GammaD_1 r_GammaD_2.
Let x := two r_x_1 r_x_2.                Let z := two r_z_1 r_z_2.
Let K := two r_K_1 r_K_2.                Let Gamma := two r_Gamma_1 r_Gamma_2.
Let zc := two r_zc_1 r_zc_2.
Ltac open := cbv [x_rate known_z_rate K_rate Gamma_rate true_flow v_x error
  theta theta_h alpha_M KD GammaD x z K Gamma zc two].

(* the rates that run are those of the paper *)
Ltac same run := unfold run; open; equal_rates.
Lemma same_x_1 t : run_x_1 t = x_rate N theta alpha_M KD GammaD x@t r_phi_x@t zc@t (fun _ => 0) 0.
Proof. same run_x_1. Qed.
Lemma same_x_2 t : run_x_2 t = x_rate N theta alpha_M KD GammaD x@t r_phi_x@t zc@t (fun _ => 0) 1.
Proof. same run_x_2. Qed.
Lemma same_z_1 t : run_z_1 t = known_z_rate N theta_h alpha_M r_phi_x r_phi_z zc z K Gamma 0 t.
Proof. same run_z_1. Qed.
Lemma same_z_2 t : run_z_2 t = known_z_rate N theta_h alpha_M r_phi_x r_phi_z zc z K Gamma 1 t.
Proof. same run_z_2. Qed.
Lemma same_K_1 t : run_K_1 t = K_rate r_gamma x@t z@t 0.
Proof. same run_K_1. Qed.
Lemma same_K_2 t : run_K_2 t = K_rate r_gamma x@t z@t 1.
Proof. same run_K_2. Qed.
Lemma same_Gamma_1 t : run_Gamma_1 t = Gamma_rate r_gamma x@t z@t zc@t 0.
Proof. same run_Gamma_1. Qed.
Lemma same_Gamma_2 t : run_Gamma_2 t = Gamma_rate r_gamma x@t z@t zc@t 1.
Proof. same run_Gamma_2. Qed.
Lemma same_V t : run_V t = Lyapunov_17 2 KD GammaD r_gamma x z K Gamma t.
Proof. unfold run_V, Lyapunov_17. rewrite !sum_two. open. equal_rates. Qed.

Lemma loop : known_loop 2 N theta theta_h alpha_M KD GammaD r_gamma r_phi_x r_phi_z zc x z K Gamma.
Proof.
  constructor.
  - intros [|[|i]] Hi; [apply (follows_by _ _ _ H_x_1)|apply (follows_by _ _ _ H_x_2)|lia];
      intros t _; [apply same_x_1|apply same_x_2].
  - intros [|[|i]] Hi; [apply (follows_by _ _ _ H_z_1)|apply (follows_by _ _ _ H_z_2)|lia];
      intros t _; [apply same_z_1|apply same_z_2].
  - intros [|[|i]] Hi; [apply (follows_by _ _ _ H_K_1)|apply (follows_by _ _ _ H_K_2)|lia];
      intros t _; [apply same_K_1|apply same_K_2].
  - intros [|[|i]] Hi; [apply (follows_by _ _ _ H_Gamma_1)|apply (follows_by _ _ _ H_Gamma_2)|lia];
      intros t _; [apply same_Gamma_1|apply same_Gamma_2].
Qed.

Let flow_error := drive N theta theta_h r_phi_x.    (* (theta - theta_h) phi *)

Theorem known_flow_rate : follows run_V (fun t => - sum 2 (fun i => KD i * (x i t - z i t)^2)
  + sum 2 (fun i => (x i t - z i t) * flow_error i t)).
Proof.
  apply (follows_ext _ _ _ _ (fun t => eq_sym (same_V t)) (fun t _ => eq_refl)).
  apply (theorem_3_1_rate 2 N theta theta_h alpha_M KD GammaD r_gamma r_phi_x r_phi_z zc); [lra|apply loop].
Qed.

Theorem known_flow_mean_square k : 0 < k -> k <= r_KD_1 -> k <= r_KD_2 ->
  (forall t, 0 <= t -> ex_RInt (square 2 flow_error) 0 t) -> piecewise_continuous (square 2 flow_error) ->
  forall t, 0 <= t -> RInt (square 2 (fun i t => x i t - z i t)) 0 t
    <= 2 * run_V 0 / k + RInt (square 2 flow_error) 0 t / k^2.
Proof.
  intros Hk H1 H2 I P t Ht. rewrite same_V.
  apply (theorem_3_1 2 N theta theta_h alpha_M KD GammaD r_gamma k r_phi_x r_phi_z zc); auto.
  - intros [|i] Hi; assumption.
  - apply loop.
Qed.
End LawKnownFlow.
Print Assumptions known_flow_rate.
Print Assumptions known_flow_mean_square.
