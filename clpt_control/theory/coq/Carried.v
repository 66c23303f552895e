(* Errors are at most |Phi| times the first, and the integral of what is added to their rates.

   x' = M x + g of any number n of errors, in coordinates in which V = x'x / 2 does not rise without
   g, x'M x <= 0: e' = A e + W th, th' = - W'e of a verdict, or of the paper's loop.  Phi' = M Phi is
   computed beside the loop, whatever W, start and disturbance are. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus Runs.
Open Scope R_scope.

Definition dot (n : nat) (x y : nat -> R) := sum n (fun i => x i * y i).
Definition norm (n : nat) (x : nat -> R) := sqrt (dot n x x).
Definition times (n : nat) (A : nat -> nat -> R) (x : nat -> R) (i : nat) := sum n (fun k => A i k * x k).
Definition unit (i k : nat) : R := if Nat.eq_dec i k then 1 else 0.
(* |A| <= c *)
Definition at_most (n : nat) (A : nat -> nat -> R) (c : R) := forall x, norm n (times n A x) <= c * norm n x.

Lemma dot_pos n x : 0 <= dot n x x.
Proof. apply sum_nonneg. intros i _. apply Rle_0_sqr. Qed.
Lemma norm_square n x : norm n x ^ 2 = dot n x x.
Proof. apply pow2_sqrt, dot_pos. Qed.
Lemma norm_pos n x : 0 <= norm n x.
Proof. apply sqrt_pos. Qed.
Lemma norm_ext n x y : (forall i, (i < n)%nat -> x i = y i) -> norm n x = norm n y.
Proof. intros H. unfold norm, dot. f_equal. apply sum_ext. intros i Hi. rewrite H; auto. Qed.
Lemma times_unit n i x : (i < n)%nat -> times n unit x i = x i.
Proof. intros Hi. unfold times. rewrite (sum_single n _ i Hi).
  - unfold unit. destruct (Nat.eq_dec i i); [ring|easy].
  - intros k _ Ne. unfold unit. destruct (Nat.eq_dec i k); [lia|ring]. Qed.

Lemma cauchy n x y : dot n x y ^ 2 <= dot n x x * dot n y y.
Proof. induction n as [|n IH]; [unfold dot; simpl; lra|].
  assert (HX := dot_pos n x). assert (HY := dot_pos n y). unfold dot in *. simpl sum.
  set (X := sum n (fun i => x i * x i)) in *. set (Y := sum n (fun i => y i * y i)) in *.
  set (Z := sum n (fun i => x i * y i)) in *. set (p := x n) in *. set (q := y n) in *.
  assert (K : 2 * (p * q) * Z <= p ^ 2 * Y + q ^ 2 * X).
  { assert (A := pow2_ge_0 p). assert (A' := pow2_ge_0 q). apply Rsqr_incr_0_var; [|nra]. unfold Rsqr.
    assert (D := pow2_ge_0 (p ^ 2 * Y - q ^ 2 * X)).
    assert (L : (p * q) ^ 2 * Z ^ 2 <= (p * q) ^ 2 * (X * Y)) by (apply Rmult_le_compat_l; [apply pow2_ge_0|exact IH]). lra. }
  lra. Qed.
Lemma dot_le n x y : dot n x y <= norm n x * norm n y.
Proof. assert (A := cauchy n x y). assert (P := norm_pos n x). assert (Q := norm_pos n y).
  rewrite <- !norm_square in A. apply Rsqr_incr_0_var; [unfold Rsqr; lra|nra]. Qed.
Lemma triangle n x y : norm n (fun i => x i + y i) <= norm n x + norm n y.
Proof. assert (A := dot_le n x y). assert (P := norm_pos n x). assert (Q := norm_pos n y).
  rewrite <- (sqrt_pow2 (norm n x + norm n y)) by lra. apply sqrt_le_1_alt.
  replace (dot n (fun i => x i + y i) (fun i => x i + y i)) with (dot n x x + (2 * dot n x y + dot n y y)).
  - rewrite <- !norm_square. lra.
  - unfold dot. rewrite <- sum_scal, <- !sum_plus. apply sum_ext. intros. ring. Qed.

(* what the block computes: |A|^2 <= |A'A|, and |A| is at most the root of the sum of its squares *)
Lemma gram n A d : 0 <= d -> at_most n (fun i k => sum n (fun j => A j i * A j k)) d -> at_most n A (sqrt d).
Proof. intros Hd H x. assert (P := norm_pos n x). assert (S := sqrt_pos d).
  assert (E : dot n (times n A x) (times n A x) = dot n x (times n (fun i k => sum n (fun j => A j i * A j k)) x)).
  { unfold dot, times. transitivity (sum n (fun j => sum n (fun i => sum n (fun k => x i * (A j i * A j k * x k))))).
    - apply sum_ext. intros j _. rewrite sum_product. apply sum_ext. intros i _. apply sum_ext. intros. ring.
    - rewrite sum_swap. apply sum_ext. intros i _. rewrite sum_swap, <- sum_scal. apply sum_ext. intros k _.
      rewrite sum_scal. f_equal. rewrite (Rmult_comm _ (x k)), <- sum_scal. apply sum_ext. intros. ring. }
  assert (B := dot_le n x (times n (fun i k => sum n (fun j => A j i * A j k)) x)). specialize (H x).
  rewrite <- (sqrt_pow2 (sqrt d * norm n x)) by nra. apply sqrt_le_1_alt. rewrite E.
  replace ((sqrt d * norm n x) ^ 2) with (sqrt d ^ 2 * norm n x ^ 2) by ring. rewrite pow2_sqrt by lra. nra. Qed.
Lemma root_of_squares n A : at_most n A (sqrt (sum n (fun i => sum n (fun k => A i k ^ 2)))).
Proof. intros x. assert (P := norm_pos n x). unfold norm at 1. rewrite <- (sqrt_pow2 (norm n x)), <- sqrt_mult_alt.
  - apply sqrt_le_1_alt. unfold dot at 1. rewrite norm_square, Rmult_comm, <- sum_scal. apply sum_le. intros i _.
    assert (C := cauchy n (A i) x). unfold times. unfold dot at 1 in C.
    replace (sum n (fun k => A i k ^ 2)) with (dot n (A i) (A i)) by (apply sum_ext; intros; ring). lra.
  - apply sum_nonneg. intros i _. apply sum_nonneg. intros k _. apply pow2_ge_0.
  - exact P. Qed.

Lemma follows_sum T n x dx : (forall i, (i < n)%nat -> follows T (x i) (dx i)) ->
  follows T (fun t => sum n (fun i => x i t)) (fun t => sum n (fun i => dx i t)).
Proof. induction n as [|n IH]; intros H; simpl; [apply follows_const|].
  apply (follows_plus T (fun t => sum n (fun i => x i t)) (fun t => sum n (fun i => dx i t))); auto. Qed.

Section Errors.
Variables (T : Rbar) (n : nat) (M : R -> nat -> nat -> R).
Hypothesis V_falls : forall t, on T t -> forall x, dot n x (times n (M t) x) <= 0.
Definition solves (x g : nat -> R -> R) :=
  forall i, (i < n)%nat -> follows T (x i) (fun t => times n (M t) (fun k => x k t) i + g i t).
Definition size (x : nat -> R -> R) (t : R) := norm n (fun i => x i t).

Lemma follows_dot x g : solves x g -> follows T (fun t => dot n (fun i => x i t) (fun i => x i t))
  (fun t => 2 * dot n (fun i => x i t) (times n (M t) (fun i => x i t)) + 2 * dot n (fun i => x i t) (fun i => g i t)).
Proof. intros H. eapply follows_by.
  - apply (follows_sum T n (fun i t => x i t * x i t)). intros i Hi. apply follows_mult; exact (H i Hi).
  - intros t _. cbv beta. unfold dot. rewrite <- !sum_scal, <- sum_plus. apply sum_ext. intros. ring. Qed.

(* G is the integral of |g|, or of more *)
Theorem errors_add x g G gamma s t : solves x g -> follows T G gamma -> (forall u, on T u -> size g u <= gamma u) ->
  0 <= s <= t -> on T t -> size x t <= size x s + (G t - G s).
Proof. intros H FG B Hs Ht. apply le_epsilon. intros d Hd.
  set (V u := dot n (fun i => x i u) (fun i => x i u)).
  assert (P : forall u, 0 <= V u) by (intros; apply dot_pos).
  assert (FS := follows_minus T _ _ _ _ (follows_sqrt T (fun u => V u + d ^ 2) _ (fun u _ => Rplus_le_lt_0_compat _ _ (P u) (pow_lt d 2 Hd))
    (follows_plus T _ _ _ _ (follows_dot x g H) (follows_const T (d ^ 2)))) FG).
  assert (L : sqrt (V t + d ^ 2) - G t <= sqrt (V s + d ^ 2) - G s).
  { refine (falls T _ _ FS _ s t Hs Ht). intros u Hu. cbv beta. set (r := sqrt (V u + d ^ 2)).
    assert (Pr : 0 < r) by (apply sqrt_lt_R0; assert (A := P u); assert (A' := pow_lt d 2 Hd); lra).
    assert (Lr : size x u <= r) by (apply sqrt_le_1_alt; assert (A' := pow2_ge_0 d); unfold V; lra).
    assert (I := dot_le n (fun i => x i u) (fun i => g i u)). assert (F := V_falls u Hu (fun i => x i u)).
    assert (A := norm_pos n (fun i => x i u)). assert (A' := norm_pos n (fun i => g i u)). assert (B' := B u Hu).
    unfold size in Lr, B'.
    match goal with |- ?k * / (2 * r) - gamma u <= 0 => enough (k * / (2 * r) <= gamma u) by lra end.
    apply (Rmult_le_reg_r (2 * r)); [lra|]. rewrite Rmult_assoc, Rinv_l, Rmult_1_r by lra.
    assert (norm n (fun i => x i u) * norm n (fun i => g i u) <= r * gamma u) by (apply Rmult_le_compat; lra). lra. }
  assert (L0 : sqrt (V s + d ^ 2) <= size x s + d).
  { assert (S := norm_pos n (fun i => x i s)). unfold size. rewrite <- (sqrt_pow2 (norm n (fun i => x i s) + d)) by lra.
    apply sqrt_le_1_alt. unfold V. rewrite <- norm_square. nra. }
  assert (L1 : size x t <= sqrt (V t + d ^ 2)) by (apply sqrt_le_1_alt; assert (A := pow2_ge_0 d); unfold V; lra).
  lra. Qed.

(* the transition matrix, computed beside the loop from time s: column j begins as unit j *)
Definition carried (s : R) (Phi : nat -> nat -> R -> R) :=
  (forall j, (j < n)%nat -> solves (fun i => Phi i j) (fun _ _ => 0)) /\
  (forall i j, (i < n)%nat -> (j < n)%nat -> Phi i j s = unit i j).

Lemma solves_rest s x g Phi : carried s Phi -> solves x g ->
  solves (fun i t => x i t - sum n (fun j => x j s * Phi i j t)) g.
Proof. intros [FP _] Fx i Hi. eapply follows_by;
    [apply follows_minus; [exact (Fx i Hi)|apply (follows_sum T n (fun j t => x j s * Phi i j t))]|].
  - intros j Hj. apply follows_mult; [apply follows_const|exact (FP j Hj i Hi)].
  - intros t _. cbv beta. unfold times.
    assert (E : sum n (fun k => M t i k * (x k t - sum n (fun j => x j s * Phi k j t)))
      = sum n (fun k => M t i k * x k t) + -1 * sum n (fun k => sum n (fun j => x j s * (M t i k * Phi k j t)))).
    { rewrite <- sum_scal, <- sum_plus. apply sum_ext. intros k _.
      rewrite (sum_ext n (fun j => x j s * (M t i k * Phi k j t)) (fun j => M t i k * (x j s * Phi k j t))) by (intros; ring).
      rewrite sum_scal. ring. }
    rewrite E, sum_swap. rewrite (sum_ext n (fun j => 0 * _ + _) (fun j => sum n (fun k => x j s * (M t i k * Phi k j t)))).
    + ring.
    + intros j _. rewrite sum_scal. ring. Qed.

(* for any M and any start: errors fall as the norm c of Phi, but for what a disturbance adds *)
Theorem errors_carried x g G gamma Phi s t c : solves x g -> follows T G gamma ->
  (forall u, on T u -> size g u <= gamma u) -> carried s Phi -> 0 <= s <= t -> on T t ->
  at_most n (fun i j => Phi i j t) c -> size x t <= c * size x s + (G t - G s).
Proof. intros Fx FG B C Hs Ht H. set (moved := times n (fun i j => Phi i j t) (fun j => x j s)).
  assert (A := errors_add _ _ _ _ s t (solves_rest s x g Phi C Fx) FG B Hs Ht). unfold size in *.
  assert (Z : norm n (fun i => x i s - sum n (fun j => x j s * Phi i j s)) = 0).
  { rewrite (norm_ext n _ (fun _ => 0)); [unfold norm, dot; rewrite sum_zero, sqrt_0 by (intros; ring); easy|].
    intros i Hi. rewrite <- (times_unit n i (fun j => x j s) Hi) at 1. unfold times.
    rewrite (sum_ext n _ (fun j => x j s * Phi i j s)); [ring|]. intros j Hj. rewrite (proj2 C i j Hi Hj). ring. }
  rewrite Z in A. specialize (H (fun j => x j s)). cbv beta in H. fold moved in H.
  assert (D := triangle n (fun i => x i t - moved i) moved). cbv beta in D.
  rewrite (norm_ext n (fun i => _ - _ + _) (fun i => x i t)) in D by (intros; ring).
  rewrite (norm_ext n (fun i => x i t - moved i) (fun i => x i t - sum n (fun j => x j s * Phi i j t))) in D.
  - lra.
  - intros i _. unfold moved, times. f_equal. apply sum_ext. intros. ring. Qed.

(* |Phi| <= q in each window, and at most d added: the errors at the ends of windows *)
Theorem errors_by_windows x g G gamma Phi tau q d : solves x g -> follows T G gamma ->
  (forall u, on T u -> size g u <= gamma u) -> 0 <= q < 1 -> 0 <= tau 0%nat ->
  (forall k, tau k <= tau (S k) /\ on T (tau (S k)) /\ carried (tau k) (Phi k) /\
    at_most n (fun i j => Phi k i j (tau (S k))) q /\ G (tau (S k)) - G (tau k) <= d) ->
  forall k, size x (tau k) <= q ^ k * size x (tau 0%nat) + d / (1 - q).
Proof. intros Fx FG B Hq H0 H.
  assert (P : forall k, 0 <= tau k) by (induction k; [easy|destruct (H k); lra]).
  assert (Hd : 0 <= d).
  { destruct (H 0%nat) as (L & O & _ & _ & D). enough (G (tau 0%nat) <= G (tau 1%nat)) by lra.
    assert (F := falls T _ _ (follows_opp T _ _ FG)). cbv beta in F. enough (- G (tau 1%nat) <= - G (tau 0%nat)) by lra.
    apply F; auto. intros u Hu. assert (A := B u Hu). assert (A' := norm_pos n (fun i => g i u)). unfold size in A. lra. }
  assert (E : q * (d / (1 - q)) + d = d / (1 - q)) by (field; lra).
  assert (N : 0 <= d / (1 - q)) by (apply Rdiv_le_0_compat; lra).
  induction k as [|k IH]; [simpl; lra|]. destruct (H k) as (L & O & C & A & D).
  assert (S := errors_carried x g G gamma (Phi k) (tau k) (tau (S k)) q Fx FG B C (conj (P k) L) O A). simpl.
  assert (q * size x (tau k) <= q * (q ^ k * size x (tau 0%nat) + d / (1 - q))) by (apply Rmult_le_compat_l; lra). lra. Qed.
End Errors.

(* e first, then th: V does not rise where A + A' <= 0, whatever W is *)
Definition loop (m : nat) (A W : nat -> nat -> R) (i k : nat) : R :=
  if Nat.ltb i m then if Nat.ltb k m then A i k else W i (k - m)%nat
  else if Nat.ltb k m then - W k (i - m)%nat else 0.
Lemma sum_split m p f : sum (m + p) f = sum m f + sum p (fun j => f (m + j)%nat).
Proof. induction p as [|p IH]; [rewrite Nat.add_0_r; simpl; ring|]. rewrite Nat.add_succ_r. simpl. rewrite IH. ring. Qed.
Lemma loop_falls m p A W x : (forall e, dot m e (times m A e) <= 0) ->
  dot (m + p) x (times (m + p) (loop m A W) x) <= 0.
Proof. intros H. assert (F := H x). unfold dot, times in *. rewrite sum_split.
  rewrite (sum_ext m _ (fun i => x i * sum m (fun k => A i k * x k) + sum p (fun j => W i j * (x i * x (m + j)%nat)))).
  - rewrite (sum_ext p _ (fun j => -1 * sum m (fun i => W i j * (x i * x (m + j)%nat)))).
    + rewrite sum_scal, sum_plus, (sum_swap m p). lra.
    + intros j _. rewrite sum_split, (sum_zero p), Rplus_0_r, <- !sum_scal.
      * apply sum_ext. intros i Hi. unfold loop. destruct (Nat.ltb_spec (m + j) m); [lia|].
        destruct (Nat.ltb_spec i m); [|lia]. replace (m + j - m)%nat with j by lia. ring.
      * intros i _. unfold loop. destruct (Nat.ltb_spec (m + j) m); [lia|]. destruct (Nat.ltb_spec (m + i) m); [lia|ring].
  - intros i Hi. rewrite sum_split, Rmult_plus_distr_l. f_equal.
    + f_equal. apply sum_ext. intros k Hk. unfold loop. destruct (Nat.ltb_spec i m); [|lia]. destruct (Nat.ltb_spec k m); [easy|lia].
    + rewrite <- sum_scal. apply sum_ext. intros j _. unfold loop. destruct (Nat.ltb_spec i m); [|lia].
      destruct (Nat.ltb_spec (m + j) m); [lia|]. replace (m + j - m)%nat with j by lia. ring. Qed.

Print Assumptions errors_carried.
Print Assumptions errors_by_windows.
