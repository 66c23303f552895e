(* The hypothesis of Theorem 3.3 can be met: d = 1, N = 0, zc = sin t + cos t, x = sin t, and the filtered
   regressor ((sin t - cos t)/2, sin t) excites in every window of 2 pi. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus Convergence Theorem33.
Open Scope R_scope.

Definition x (_ : nat) t := sin t.
Definition zc (_ : nat) t := sin t + cos t.
Definition w_f (j : nat) t := match j with O => (sin t - cos t) / 2 | S _ => sin t end.

Example excited : filtered_w 0 1 (w_star 0 (fun _ _ => 0) zc x 0) w_f /\ excites 2 w_f.
Proof.
  split.
  - intros [|[|j]] Hj; [| |lia]; (eapply follows_by; [apply follows_smooth|]).
    + instantiate (1 := fun t => (cos t + sin t) / 2). intros t. unfold w_f. auto_derive; auto. field.
    + intros t _. unfold w_star, joined, w_f, x; simpl. field.
    + instantiate (1 := cos). intros t. unfold w_f. auto_derive; auto. ring.
    + intros t _. unfold w_star, joined, w_f, zc; simpl. ring.
  - exists 0.3, (2 * PI). assert (P := PI2_1). split; [lra|split; [lra|]]. intros t Ht a.
    set (A := a 0%nat / 2 + a 1%nat). set (B := - (a 0%nat / 2)).
    set (F := fun s => A^2 * (s - sin s * cos s) / 2 + A * B * sin s ^ 2 + B^2 * (s + sin s * cos s) / 2).
    assert (I : is_RInt (fun s => (sum 2 (fun j => a j * w_f j s)) ^ 2) t (t + 2 * PI) ((A^2 + B^2) * PI)).
    { replace ((A^2 + B^2) * PI) with (minus (F (t + 2 * PI)) (F t)).
      - apply (@is_RInt_derive R_CompleteNormedModule F).
        + intros s _. unfold F. auto_derive; auto. assert (S := sin2_cos2 s). unfold Rsqr in S.
          replace (sum 2 (fun j => a j * w_f j s) ^ 2) with ((A * sin s + B * cos s)^2)
            by (simpl; unfold A, B; field).
          apply Rminus_diag_uniq. transitivity ((A^2 + B^2) / 2 * (1 - (sin s * sin s + cos s * cos s))); [field|].
          rewrite S. field.
        + intros s _. apply @ex_derive_continuous. unfold w_f; simpl. auto_derive. auto.
      - unfold F, minus, plus, opp; simpl. rewrite sin_plus, cos_plus, sin_2PI, cos_2PI. field. }
    rewrite (is_RInt_unique _ _ _ _ I).
    assert (Q : 0.15 * (a 0%nat ^ 2 + a 1%nat ^ 2) <= A^2 + B^2).
    { unfold A, B. assert (U := pow2_ge_0 (a 0%nat + a 1%nat / 0.7)). assert (W := pow2_ge_0 (a 1%nat)). simpl in *. lra. }
    assert (0 <= A^2 + B^2) by (assert (U := pow2_ge_0 A); assert (W := pow2_ge_0 B); lra).
    simpl sum. nra.
Qed.
Print Assumptions excited.
