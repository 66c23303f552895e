(* Finite sums, and functions of time that follow a rate except at finitely many times: runs on
   [0, T) of Runs.v with T infinite.

   A waypoint reference jumps, so a trajectory has no derivative there.  [follows f df] says that f
   is continuous for t >= 0 and f' = df but at finitely many times before any T.  (A trajectory on
   t >= 0 is continued to t < 0 by its first value.) *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Runs.
Open Scope R_scope.

(* sum of f 0 ... f (n - 1) *)
Fixpoint sum (n : nat) (f : nat -> R) : R :=
  match n with O => 0 | S m => sum m f + f m end.

Lemma sum_ext n f g : (forall k, (k < n)%nat -> f k = g k) -> sum n f = sum n g.
Proof. induction n as [|n IH]; intros H; simpl; [easy|]. rewrite IH, H; auto. Qed.

Lemma sum_plus n f g : sum n (fun k => f k + g k) = sum n f + sum n g.
Proof. induction n as [|n IH]; simpl; [ring|]. rewrite IH. ring. Qed.

Lemma sum_scal n a f : sum n (fun k => a * f k) = a * sum n f.
Proof. induction n as [|n IH]; simpl; [ring|]. rewrite IH. ring. Qed.

Lemma sum_nonneg n f : (forall k, (k < n)%nat -> 0 <= f k) -> 0 <= sum n f.
Proof. induction n as [|n IH]; intros H; simpl; [lra|].
  assert (0 <= f n) by auto. assert (0 <= sum n f) by auto. lra. Qed.

Lemma sum_le n f g : (forall k, (k < n)%nat -> f k <= g k) -> sum n f <= sum n g.
Proof. induction n as [|n IH]; intros H; simpl; [lra|].
  assert (f n <= g n) by auto. assert (sum n f <= sum n g) by auto. lra. Qed.

Lemma sum_member n f j :
  (forall k, (k < n)%nat -> 0 <= f k) -> (j < n)%nat -> f j <= sum n f.
Proof. induction n as [|n IH]; intros H Hj; [lia|]. simpl.
  assert (0 <= f n) by auto. assert (0 <= sum n f) by (apply sum_nonneg; auto).
  destruct (Nat.eq_dec j n) as [->|]; [lra|]. assert (f j <= sum n f) by (apply IH; auto; lia). lra. Qed.

Lemma sum_zero n f : (forall k, (k < n)%nat -> f k = 0) -> sum n f = 0.
Proof. intros H. rewrite (sum_ext n f (fun _ => 0 * 0)), sum_scal by (intros; rewrite H; auto; ring). ring. Qed.

Lemma sum_single n f j : (j < n)%nat -> (forall k, (k < n)%nat -> k <> j -> f k = 0) -> sum n f = f j.
Proof. induction n as [|n IH]; intros Hj H; simpl; [lia|]. destruct (Nat.eq_dec j n) as [->|].
  - rewrite sum_zero; [ring|]. intros k Hk. apply H; lia.
  - rewrite IH, (H n); [ring|lia|lia|lia|]. intros k Hk Ne. apply H; lia. Qed.

Lemma sum_swap n m (f : nat -> nat -> R) :
  sum n (fun i => sum m (fun j => f i j)) = sum m (fun j => sum n (fun i => f i j)).
Proof. induction n as [|n IH]; simpl.
  - induction m as [|m IH]; simpl; [easy|]. rewrite <- IH. ring.
  - rewrite IH, <- sum_plus. easy. Qed.

Lemma sum_product n m f g : sum n f * sum m g = sum n (fun i => sum m (fun j => f i * g j)).
Proof. rewrite Rmult_comm, <- sum_scal. apply sum_ext. intros i _. rewrite sum_scal. ring. Qed.

Definition follows (f df : R -> R) : Prop :=
  (forall t, 0 <= t -> continuous f t) /\
  (forall T, exists l : list R, forall t, 0 < t < T -> ~ In t l -> is_derive f t (df t)).

(* the same as of a run that has no end *)
Lemma follows_run f df : follows f df <-> Runs.follows p_infty f df.
Proof. split; intros [C D]; (split; [intros t Ht; apply C; auto; apply Ht|]).
  - intros S _. apply D.
  - intros S. destruct (D (Rmax S 0)) as [l H]; [apply on_all, Rmax_r|]. exists l. intros t Ht.
    apply H. assert (A := Rmax_l S 0). lra. Qed.

Lemma follows_ext f df g dg :
  (forall t, f t = g t) -> (forall t, 0 < t -> df t = dg t) -> follows f df -> follows g dg.
Proof. intros Hf Hd [C D]. split.
  - intros t Ht. apply (continuous_ext f); auto.
  - intros T. destruct (D T) as [l H]. exists l. intros t Ht Hn.
    rewrite <- Hd by lra. apply (is_derive_ext f); auto. Qed.

Lemma follows_const a : follows (fun _ => a) (fun _ => 0).
Proof. apply follows_run, Runs.follows_const. Qed.

Lemma follows_smooth f df :
  (forall t, is_derive f t (df t)) -> follows f df.
Proof. intros H. split; [|intros T; exists nil; auto].
  intros t _. apply @ex_derive_continuous. exists (df t). apply H. Qed.

Lemma follows_plus f df g dg :
  follows f df -> follows g dg -> follows (fun t => f t + g t) (fun t => df t + dg t).
Proof. rewrite !follows_run. apply Runs.follows_plus. Qed.

Lemma follows_mult f df g dg :
  follows f df -> follows g dg ->
  follows (fun t => f t * g t) (fun t => df t * g t + f t * dg t).
Proof. rewrite !follows_run. apply Runs.follows_mult. Qed.

Lemma follows_scal a f df : follows f df -> follows (fun t => a * f t) (fun t => a * df t).
Proof. intros H. apply (follows_ext (fun t => a * f t) (fun t => 0 * f t + a * df t)); auto.
  - intros. ring.
  - apply follows_mult; auto. apply follows_const. Qed.

Lemma follows_minus f df g dg :
  follows f df -> follows g dg -> follows (fun t => f t - g t) (fun t => df t - dg t).
Proof. rewrite !follows_run. apply Runs.follows_minus. Qed.

Lemma follows_sum n (f df : nat -> R -> R) :
  (forall k, (k < n)%nat -> follows (f k) (df k)) ->
  follows (fun t => sum n (fun k => f k t)) (fun t => sum n (fun k => df k t)).
Proof. induction n as [|n IH]; intros H; simpl; [apply follows_const|].
  apply (follows_plus (fun t => sum n (fun k => f k t)) (fun t => sum n (fun k => df k t))); auto. Qed.

Lemma follows_square f df : follows f df -> follows (fun t => (f t)^2) (fun t => 2 * f t * df t).
Proof. intros H. apply (follows_ext (fun t => f t * f t) (fun t => df t * f t + f t * df t));
  try (intros; ring). apply follows_mult; auto. Qed.

Lemma slope f df M a b : follows f df -> 0 <= a <= b ->
  (forall t, a < t < b -> df t <= M) -> f b - f a <= M * (b - a).
Proof. rewrite follows_run. intros F Hab. apply (Runs.slope p_infty); auto. apply on_all. lra. Qed.

Lemma falls f df a b : follows f df -> 0 <= a <= b ->
  (forall t, a < t < b -> df t <= 0) -> f b <= f a.
Proof. intros F Hab H. assert (S := slope f df 0 a b F Hab H). lra. Qed.

Lemma lipschitz f df L : follows f df -> (forall t, 0 < t -> Rabs (df t) <= L) ->
  forall s t, 0 <= s -> 0 <= t -> Rabs (f t - f s) <= L * Rabs (t - s).
Proof. rewrite follows_run. intros F H s t Hs Ht. apply (Lipschitz_by p_infty f df L); auto. Qed.

(* bounded for t >= 0 *)
Definition bounded (f : R -> R) : Prop := exists M, forall t, 0 <= t -> Rabs (f t) <= M.

Lemma bounded_run f : bounded f <-> Runs.bounded p_infty f.
Proof. split; intros [M H]; exists M; intros t Ht; apply H; auto; apply Ht. Qed.

Lemma bounded_const a : bounded (fun _ => a).
Proof. apply bounded_run, Runs.bounded_const. Qed.

Lemma bounded_plus f g : bounded f -> bounded g -> bounded (fun t => f t + g t).
Proof. rewrite !bounded_run. apply Runs.bounded_plus. Qed.

Lemma bounded_mult f g : bounded f -> bounded g -> bounded (fun t => f t * g t).
Proof. rewrite !bounded_run. apply Runs.bounded_mult. Qed.

Lemma bounded_minus f g : bounded f -> bounded g -> bounded (fun t => f t - g t).
Proof. rewrite !bounded_run. apply Runs.bounded_minus. Qed.

Lemma bounded_sum n (f : nat -> R -> R) :
  (forall k, (k < n)%nat -> bounded (f k)) -> bounded (fun t => sum n (fun k => f k t)).
Proof. induction n as [|n IH]; intros H; simpl; [apply bounded_const|].
  apply (bounded_plus (fun t => sum n (fun k => f k t))); auto. Qed.

Lemma bounded_ext f g : (forall t, 0 <= t -> f t = g t) -> bounded f -> bounded g.
Proof. intros E [M H]. exists M. intros t Ht. rewrite <- E; auto. Qed.

(* x' = -k x + u with a bounded u: x is bounded *)
Lemma stable k x u : 0 < k -> follows x (fun t => - k * x t + u t) -> bounded u -> bounded x.
Proof. rewrite follows_run, !bounded_run. intros Hk F. apply (bounded_lag p_infty k x u Hk).
  apply (Runs.follows_by _ _ _ _ F). intros. ring. Qed.

(* the rate of an expression, by the rules above: [follow] proves follows f ?df for f made of
   +, -, *, ^2, constants and functions of which [follows] is an assumption *)
Lemma follows_by f df dg : follows f df -> (forall t, 0 < t -> df t = dg t) -> follows f dg.
Proof. intros F E. apply (follows_ext f df); auto. Qed.

Ltac follow :=
  lazymatch goal with
  | |- follows (fun _ => ?a) _ => apply (follows_const a)
  | |- follows (fun t => @?f t + @?g t) _ => eapply (follows_plus f _ g _); follow
  | |- follows (fun t => @?f t - @?g t) _ => eapply (follows_minus f _ g _); follow
  | |- follows (fun t => @?f t * @?g t) _ => eapply (follows_mult f _ g _); follow
  | |- follows (fun t => (@?f t)^2) _ => eapply (follows_square f _); follow
  | |- follows (fun t => ?f t) _ => change (fun t => f t) with f; eassumption
  | |- _ => eassumption
  end.
