(* The assumptions of Theorem 3.3 can be met together: d = 1, N = 1, phi = cos 2t, zc = sin t + cos t, theta = 1, and
   the trajectory x = z = sin t, started at the true parameters.  The filtered regressor
   ((cos 2t + 2 sin 2t)/5, (sin t - cos t)/2, sin t) excites in every window of 2 pi. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus PaperLoop Convergence Theorem33.
Open Scope R_scope.

Definition x (_ : nat) t := sin t.
Definition zc (_ : nat) t := sin t + cos t.
Definition phi (_ : nat) t := cos (2 * t).
Definition w_f (j : nat) t :=
  match j with O => (cos (2 * t) + 2 * sin (2 * t)) / 5 | S O => (sin t - cos t) / 2 | S (S _) => sin t end.

Lemma excited_loop : closed_loop 1 1 (fun _ _ => 1) (fun _ _ => 1) (fun _ => 1) (fun _ => 1) 1 phi phi zc (fun _ _ => 0)
  x x (fun _ _ _ => -1) (fun _ _ => 1) (fun _ _ => 1).
Proof.
  assert (D : follows (x 0) cos) by (apply follows_smooth; intros t; unfold x; auto_derive; auto; ring).
  constructor; intros.
  - apply (follows_by _ _ _ D). intros. unfold x_rate, true_flow, v_x, zc, x; simpl. ring.
  - apply (follows_by _ _ _ D). intros. unfold z_rate, modeled_flow, v_z, psi, zc, x; simpl. ring.
  - apply (follows_by _ _ _ (follows_const _)). intros. unfold alpha_rate, error. ring.
  - apply (follows_by _ _ _ (follows_const _)). intros. unfold K_rate, error. ring.
  - apply (follows_by _ _ _ (follows_const _)). intros. unfold Gamma_rate, error. ring.
Qed.

Lemma excited_filter : filtered_w 1 1 (w_star 1 phi zc x 0) w_f.
Proof.
  intros [|[|[|j]]] Hj; [| | |lia]; (eapply follows_by; [apply follows_smooth|]).
  - instantiate (1 := fun t => (-2 * sin (2 * t) + 4 * cos (2 * t)) / 5). intros t. unfold w_f. auto_derive; auto. field.
  - intros t _. unfold w_star, joined, w_f, phi; simpl. field.
  - instantiate (1 := fun t => (cos t + sin t) / 2). intros t. unfold w_f. auto_derive; auto. field.
  - intros t _. unfold w_star, joined, w_f, x; simpl. field.
  - instantiate (1 := cos). intros t. unfold w_f. auto_derive; auto. ring.
  - intros t _. unfold w_star, joined, w_f, zc; simpl. ring.
Qed.

Example excited : closed_loop 1 1 (fun _ _ => 1) (fun _ _ => 1) (fun _ => 1) (fun _ => 1) 1 phi phi zc (fun _ _ => 0)
    x x (fun _ _ _ => -1) (fun _ _ => 1) (fun _ _ => 1)
  /\ bounded (phi 0) /\ bounded (zc 0) /\ filtered_w 1 1 (w_star 1 phi zc x 0) w_f /\ excites 3 w_f.
Proof.
  split; [exact excited_loop|split; [|split; [|split; [exact excited_filter|]]]].
  - exists 1. intros t _. unfold phi. apply Rabs_le. apply COS_bound.
  - exists 2. intros t _. unfold zc. apply Rabs_le. assert (A := SIN_bound t). assert (B := COS_bound t). lra.
  - exists 0.3, (2 * PI). assert (P := PI2_1). split; [lra|split; [lra|]]. intros t Ht a.
    set (A := a 1%nat / 2 + a 2%nat). set (B := - (a 1%nat / 2)). set (C := a 0%nat / 5).
    (* the integral of (A sin s + B cos s + C cos 2s + 2 C sin 2s)^2 *)
    set (F := fun s => A^2 * (s - sin s * cos s) / 2 + A * B * sin s ^ 2 + B^2 * (s + sin s * cos s) / 2
      + C^2 * (5 / 2 * s - 3 / 2 * (sin s * cos s * (1 - 2 * sin s ^ 2)) + 4 * (sin s ^ 2 * (1 - sin s ^ 2)))
      + 2 * A * C * (cos s - 2 / 3 * cos s ^ 3 + 4 / 3 * sin s ^ 3)
      + 2 * B * C * (sin s - 2 / 3 * sin s ^ 3 - 4 / 3 * cos s ^ 3)).
    assert (I : is_RInt (fun s => (sum 3 (fun j => a j * w_f j s)) ^ 2) t (t + 2 * PI) ((A^2 + B^2 + 5 * C^2) * PI)).
    { replace ((A^2 + B^2 + 5 * C^2) * PI) with (minus (F (t + 2 * PI)) (F t)).
      - apply (@is_RInt_derive R_CompleteNormedModule F).
        + intros s _. unfold F. auto_derive; auto.
          replace (sum 3 (fun j => a j * w_f j s) ^ 2)
            with ((A * sin s + B * cos s + C * (cos (2 * s) + 2 * sin (2 * s)))^2)
            by (simpl; unfold A, B, C; field).
          rewrite cos_2a_sin, sin_2a.
          assert (E : cos s * cos s = 1 - sin s * sin s) by (assert (S := sin2_cos2 s); unfold Rsqr in S; lra).
          field [E].
        + intros s _. apply @ex_derive_continuous. unfold w_f; simpl. auto_derive. auto.
      - unfold F, minus, plus, opp; simpl. rewrite sin_plus, cos_plus, sin_2PI, cos_2PI. field. }
    rewrite (is_RInt_unique _ _ _ _ I).
    assert (Q : 0.15 * (a 0%nat ^ 2 + a 1%nat ^ 2 + a 2%nat ^ 2) <= A^2 + B^2 + 5 * C^2).
    { unfold A, B, C. assert (U := pow2_ge_0 (a 1%nat + a 2%nat / 0.7)). assert (W := pow2_ge_0 (a 2%nat)).
      assert (X := pow2_ge_0 (a 0%nat)). simpl in *. lra. }
    assert (0 <= A^2 + B^2 + 5 * C^2)
      by (assert (U := pow2_ge_0 A); assert (W := pow2_ge_0 B); assert (X := pow2_ge_0 C); lra).
    simpl sum. nra.
Qed.
Print Assumptions excited.
