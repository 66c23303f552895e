(* Tactics for records of the blocks that run, which have two axes. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus.
Open Scope R_scope.

Definition two {A : Type} (a b : A) (i : nat) : A := match i with O => a | _ => b end.

Lemma sum_two f : sum 2 f = f 0%nat + f 1%nat.
Proof. simpl. ring. Qed.

Lemma sum_div n f a : sum n (fun k => f k / a) = sum n f / a.
Proof. rewrite (sum_ext n _ (fun k => / a * f k)), sum_scal by (intros; unfold Rdiv; ring). unfold Rdiv. ring. Qed.

(* np.clip *)
Definition clip (s low high : R) := Rmin (Rmax s low) high.

Lemma clip_bounds s low high : low <= high -> low <= clip s low high <= high.
Proof. intros H. unfold clip. split; [apply Rmin_glb; [apply Rmax_r|exact H]|apply Rmin_r]. Qed.

Lemma clip_zero s low high : s <= low -> low <= high -> clip s low high = low.
Proof. intros H1 H2. unfold clip. rewrite Rmax_right, Rmin_left; auto. Qed.

(* a factor that is clip(a/b - 1, 0, 1): zero where a <= b *)
Lemma clip_beyond s : 0 <= clip s 0 1 /\ (clip s 0 1 = 0 \/ 0 < s).
Proof.
  split; [apply clip_bounds; lra|]. destruct (Rlt_dec 0 s); [auto|]. left. apply clip_zero; lra.
Qed.

(* sums whose terms are equal, or each the other's negative, become one *)
Lemma sum_opp n f g : (forall k, f k = - g k) -> sum n f = - sum n g.
Proof. intros H. rewrite (sum_ext n f (fun k => -1 * g k)); [rewrite sum_scal; ring|intros; rewrite H; ring]. Qed.

Ltac match_sums :=
  repeat match goal with |- context [sum ?n ?f] =>
    match goal with |- context [sum n ?g] => tryif constr_eq f g then fail else
      let E := fresh in
      first [assert (E : sum n f = sum n g) by (apply sum_ext; intros; cbv beta; ring)
            |assert (E : sum n f = - sum n g) by (apply sum_opp; intros; cbv beta; ring)];
      rewrite E; clear E
    end
  end.

(* a divisor is not zero, the argument of a root is not negative *)
Ltac positive :=
  lazymatch goal with
  | |- 0 < ?a * ?b => apply Rmult_lt_0_compat; positive
  | |- 0 < ?a / ?b => apply Rdiv_lt_0_compat; positive
  | |- 0 < ?a ^ _ => apply pow_lt; positive
  | |- 0 < Rmax _ ?b => apply Rlt_le_trans with (2 := Rmax_r _ b); positive
  | |- 0 < ?a + ?b => first [apply Rplus_lt_le_0_compat; [positive|not_negative]
                            |apply Rplus_le_lt_0_compat; [not_negative|positive]]
  | |- _ => first [assumption|lra|solve [auto]]
  end
with not_negative :=
  lazymatch goal with
  | |- 0 <= ?a ^ 2 => apply pow2_ge_0
  | |- 0 <= sqrt _ => apply sqrt_pos
  | |- 0 <= Rabs _ => apply Rabs_pos
  | |- 0 <= sum _ _ => apply sum_nonneg; intros; not_negative
  | |- 0 <= ?a + ?b => apply Rplus_le_le_0_compat; not_negative
  | |- 0 <= ?a * ?b => apply Rmult_le_pos; not_negative
  | |- 0 <= ?a / ?b => apply Rmult_le_pos; [not_negative|apply Rlt_le, Rinv_0_lt_compat; positive]
  | |- _ => first [assumption|apply Rlt_le; positive]
  end.
Ltac domain := intros; first [apply Rgt_not_eq; red; positive|apply Rle_ge; not_negative].

(* words whose arguments are equal become one *)
Ltac match_words :=
  let same := first [reflexivity|field; repeat split; domain] in
  repeat match goal with
  | |- context [clip ?u ?l ?h] => match goal with |- context [clip ?v l h] => tryif constr_eq u v then fail else
      replace (clip u l h) with (clip v l h) by (f_equal; same) end
  | |- context [Rmax ?u ?w] => match goal with |- context [Rmax ?v w] => tryif constr_eq u v then fail else
      replace (Rmax u w) with (Rmax v w) by (f_equal; same) end
  | |- context [sqrt ?u] => match goal with |- context [sqrt ?v] => tryif constr_eq u v then fail else
      replace (sqrt u) with (sqrt v) by (f_equal; same) end
  end.
(* a rate that runs is what is claimed, up to the order of terms *)
Ltac equal_rates := match_sums; match_words; field; repeat split; domain.
