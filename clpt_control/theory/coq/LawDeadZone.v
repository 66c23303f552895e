(* Law dead-zone, for every N: V falls, what is learned is bounded, and |e| comes to at most the zone. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem PaperLoop AddedRates DeadZone TwoAxes.
Open Scope R_scope.

Section LawDeadZone.
(* record of dead-zone *)

(* text of axes.txt *)
Let zone := r_adaptation'zone.
Let a := dead_a r_gamma zone r_phi_x x z.    Let b := dead_b r_gamma zone x z.    Let c := dead_c r_gamma zone zc x z.
Ltac added_rates := unfold dead_a, dead_b, dead_c, outside, beyond, zone.
(* text of added.txt *)
Lemma same_V t : run_V t = dead_V 2 N theta KD GammaD r_gamma zone x z alpha K Gamma t.
Proof.
  unfold run_V, dead_V, level, outside, beyond, zone. rewrite !sum_two, !sum_div. open. match_sums. match_words.
  field. lra.
Qed.
Lemma zone_positive : 0 <= zone.
Proof. apply Rlt_le, P_adaptation'zone. Qed.

Theorem dead_zone_rate : follows run_V (fun t => - sum 2 (fun i => outside zone x z i t * (KD i * (x i t - z i t)))).
Proof.
  apply (follows_ext _ _ _ _ (fun t => eq_sym (same_V t)) (fun t _ => eq_refl)).
  apply (dead_rate _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ P_gamma zone_positive loop).
Qed.

Theorem dead_zone_falls s t : 0 <= s <= t -> run_V t <= run_V s.
Proof.
  intros H. rewrite !same_V. apply (dead_falls _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ P_gamma KD_positive zone_positive loop s t H).
Qed.

(* whatever phi and zc are *)
Theorem dead_zone_bounded : bounded r_K_1 /\ bounded r_K_2 /\ bounded r_Gamma_1 /\ bounded r_Gamma_2 /\
  forall k, (k < N)%nat -> bounded (r_alpha_1 k) /\ bounded (r_alpha_2 k).
Proof.
  assert (B := fun i Hi => dead_errors_bounded _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ P_gamma KD_positive zone_positive loop i Hi).
  destruct (B 0%nat ltac:(lia)) as [_ [_ [K1 [G1 A1]]]]. destruct (B 1%nat ltac:(lia)) as [_ [_ [K2 [G2 A2]]]].
  assert (E : forall f g q r, bounded g -> (forall t, f t = q + r * g t) -> bounded f).
  { intros f g q r Bg H. apply (bounded_ext (fun t => q + r * g t)); [intros; symmetry; apply H|].
    apply bounded_plus; [apply bounded_const|]. apply (bounded_mult (fun _ => r)); [apply bounded_const|exact Bg]. }
  split; [apply (E _ _ r_KD_1 1 K1); intros; simpl; ring|].
  split; [apply (E _ _ r_KD_2 1 K2); intros; simpl; ring|].
  split; [apply (E _ _ r_GammaD_1 (-1) G1); intros; simpl; ring|].
  split; [apply (E _ _ r_GammaD_2 (-1) G2); intros; simpl; ring|]. intros k Hk.
  split; [apply (E _ _ (- r_theta_1 k) 1 (A1 k Hk)); intros; simpl; ring
         |apply (E _ _ (- r_theta_2 k) 1 (A2 k Hk)); intros; simpl; ring].
Qed.

(* e - clip(e, -zone, zone) goes to zero: |e| comes to at most the zone *)
Theorem dead_zone_converges : (forall k, (k < N)%nat -> bounded (r_phi_x k)) -> bounded r_zc_1 -> bounded r_zc_2 ->
  is_lim (fun t => beyond zone (r_x_1 t - r_z_1 t)) p_infty 0 /\ is_lim (fun t => beyond zone (r_x_2 t - r_z_2 t)) p_infty 0.
Proof.
  intros Bp B1 B2.
  assert (C := dead_converges _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ P_gamma KD_positive zone_positive loop Bp
    ltac:(intros [|i] Hi; assumption)).
  split; [apply (C 0%nat)|apply (C 1%nat)]; lia.
Qed.
End LawDeadZone.
Print Assumptions dead_zone_rate.
Print Assumptions dead_zone_falls.
Print Assumptions dead_zone_bounded.
Print Assumptions dead_zone_converges.
