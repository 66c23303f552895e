(* Law e-modification, for every N: V' with a leak that grows with |e|, and a level that V does not pass. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem PaperLoop AddedRates Leaks TwoAxes.
Open Scope R_scope.

Section LawEModification.
(* record of e-modification *)

(* text of axes.txt *)
Let s (t : R) := r_adaptation'leak * sqrt (squares 2 (fun i => x i t - z i t)).
Let a := leak_a r_gamma alpha s.    Let b := leak_b r_gamma K s.    Let c := leak_c r_gamma Gamma s.
Ltac added_rates := unfold leak_a, leak_b, leak_c, s, squares; rewrite sum_two.
(* text of added.txt *)
(* text of level.txt *)

Theorem e_modification_rate : follows run_V (fun t => - loss 2 KD x z t
  - s t * (pull_1 2 N theta alpha t + pull_2 2 KD K t + pull_3 2 GammaD Gamma t)).
Proof.
  apply (follows_ext _ _ _ _ (fun t => eq_sym (same_V t)) (fun t _ => eq_refl)).
  apply (follows_by _ _ _ (leak_rate _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ P_gamma loop)).
  intros t _. ring.
Qed.

(* c is half the leak times |theta|^2 + |KD|^2 + |GammaD|^2 *)
Theorem e_modification_bounded k : 0 < k -> k <= r_KD_1 -> k <= r_KD_2 ->
  let c := r_adaptation'leak / 2 * truth2 2 N theta KD GammaD in
  forall t, 0 <= t -> run_V t <= Rmax (run_V 0) (Rmax (c^2 / (2 * k^2)) (c / (r_adaptation'leak * r_gamma))).
Proof.
  intros Hk H1 H2 c' t Ht. rewrite !same_V.
  apply (error_leak _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ P_gamma loop); auto.
  intros [|i] Hi; assumption.
Qed.
End LawEModification.
Print Assumptions e_modification_rate.
Print Assumptions e_modification_bounded.
