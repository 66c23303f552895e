(* Law sigma, for every N: V' with a constant leak, and the level that V comes to. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus ErrorSystem PaperLoop AddedRates Leaks TwoAxes.
Open Scope R_scope.

Section LawSigma.
(* record of sigma *)

(* text of axes.txt *)
Let s (_ : R) := r_adaptation'leak.
Let a := leak_a r_gamma alpha s.    Let b := leak_b r_gamma K s.    Let c := leak_c r_gamma Gamma s.
Ltac added_rates := unfold leak_a, leak_b, leak_c, s.
(* text of added.txt *)
(* text of level.txt *)

Theorem sigma_rate : follows run_V (fun t => - loss 2 KD x z t
  - r_adaptation'leak * (pull_1 2 N theta alpha t + pull_2 2 KD K t + pull_3 2 GammaD Gamma t)).
Proof.
  apply (follows_ext _ _ _ _ (fun t => eq_sym (same_V t)) (fun t _ => eq_refl)).
  apply (follows_by _ _ _ (leak_rate _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ P_gamma loop)).
  intros t _. unfold s. ring.
Qed.

(* c is half the leak times |theta|^2 + |KD|^2 + |GammaD|^2 *)
Theorem sigma_bounded m : 0 < m -> m <= r_gamma * r_adaptation'leak -> m <= 2 * r_KD_1 -> m <= 2 * r_KD_2 ->
  let c := r_adaptation'leak / 2 * truth2 2 N theta KD GammaD in
  forall t, 0 <= t -> run_V t <= c / m + (run_V 0 - c / m) * exp (- m * t).
Proof.
  intros Hm Hg H1 H2 c' t Ht. rewrite !same_V.
  apply (constant_leak _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ _ P_gamma loop); auto.
  intros [|i] Hi; assumption.
Qed.
End LawSigma.
Print Assumptions sigma_rate.
Print Assumptions sigma_bounded.
