(* Finite sums, and functions of time that follow a rate except at finitely many times.

   A waypoint reference jumps, so a trajectory has no derivative there.  [follows f df] says that f
   is continuous for t >= 0 and f' = df but at finitely many times before any T.  (A trajectory on
   t >= 0 is continued to t < 0 by its first value.) *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
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

Lemma follows_ext f df g dg :
  (forall t, f t = g t) -> (forall t, 0 < t -> df t = dg t) -> follows f df -> follows g dg.
Proof. intros Hf Hd [C D]. split.
  - intros t Ht. apply (continuous_ext f); auto.
  - intros T. destruct (D T) as [l H]. exists l. intros t Ht Hn.
    rewrite <- Hd by lra. apply (is_derive_ext f); auto. Qed.

Lemma follows_const a : follows (fun _ => a) (fun _ => 0).
Proof. split; [intros; apply continuous_const|]. intros T. exists nil. intros. apply @is_derive_const. Qed.

Lemma follows_smooth f df :
  (forall t, is_derive f t (df t)) -> follows f df.
Proof. intros H. split; [|intros T; exists nil; auto].
  intros t _. apply @ex_derive_continuous. exists (df t). apply H. Qed.

Lemma follows_plus f df g dg :
  follows f df -> follows g dg -> follows (fun t => f t + g t) (fun t => df t + dg t).
Proof. intros [Cf Df] [Cg Dg]. split.
  - intros t Ht. apply @continuous_plus; auto.
  - intros T. destruct (Df T) as [l Hl], (Dg T) as [m Hm]. exists (l ++ m). intros t Ht Hn.
    apply @is_derive_plus; [apply Hl|apply Hm]; auto; intros Hi; apply Hn, in_or_app; auto. Qed.

Lemma follows_mult f df g dg :
  follows f df -> follows g dg ->
  follows (fun t => f t * g t) (fun t => df t * g t + f t * dg t).
Proof. intros [Cf Df] [Cg Dg]. split.
  - intros t Ht. apply @continuous_mult; auto.
  - intros T. destruct (Df T) as [l Hl], (Dg T) as [m Hm]. exists (l ++ m). intros t Ht Hn.
    apply @is_derive_mult; [apply Hl|apply Hm|intros; apply Rmult_comm]; auto;
      intros Hi; apply Hn, in_or_app; auto. Qed.

Lemma follows_scal a f df : follows f df -> follows (fun t => a * f t) (fun t => a * df t).
Proof. intros H. apply (follows_ext (fun t => a * f t) (fun t => 0 * f t + a * df t)); auto.
  - intros. ring.
  - apply follows_mult; auto. apply follows_const. Qed.

Lemma follows_minus f df g dg :
  follows f df -> follows g dg -> follows (fun t => f t - g t) (fun t => df t - dg t).
Proof. intros Hf Hg.
  apply (follows_ext (fun t => f t + -1 * g t) (fun t => df t + -1 * dg t)); try (intros; ring).
  apply follows_plus; auto. apply follows_scal; auto. Qed.

Lemma follows_sum n (f df : nat -> R -> R) :
  (forall k, (k < n)%nat -> follows (f k) (df k)) ->
  follows (fun t => sum n (fun k => f k t)) (fun t => sum n (fun k => df k t)).
Proof. induction n as [|n IH]; intros H; simpl; [apply follows_const|].
  apply (follows_plus (fun t => sum n (fun k => f k t)) (fun t => sum n (fun k => df k t))); auto. Qed.

Lemma follows_square f df : follows f df -> follows (fun t => (f t)^2) (fun t => 2 * f t * df t).
Proof. intros H. apply (follows_ext (fun t => f t * f t) (fun t => df t * f t + f t * df t));
  try (intros; ring). apply follows_mult; auto. Qed.

(* the mean value theorem with exceptions *)
Lemma slope_list (f df : R -> R) M (l : list R) : forall a b, a <= b ->
  (forall t, a <= t <= b -> continuous f t) ->
  (forall t, a < t < b -> ~ In t l -> is_derive f t (df t) /\ df t <= M) ->
  f b - f a <= M * (b - a).
Proof. induction l as [|c l IH]; intros a b Hab C D.
  - destruct (MVT_gen f a b (fun t => Rmin (df t) M)) as [c [Hc E]];
      rewrite ?Rmin_left, ?Rmax_right in * by lra.
    + intros t Ht. destruct (D t Ht) as [Dt Lt]; auto. rewrite Rmin_left by exact Lt. exact Dt.
    + intros t Ht. apply continuity_pt_filterlim, C, Ht.
    + rewrite E. apply Rmult_le_compat_r; [lra|]. apply Rmin_r.
  - destruct (Rlt_dec a c) as [Hac|Hac]; [destruct (Rlt_dec c b) as [Hcb|Hcb]|].
    + assert (f c - f a <= M * (c - a)).
      { apply IH; [lra|intros; apply C; lra|]. intros t Ht Hn. apply D; [lra|].
        intros [->|Hi]; [lra|auto]. }
      assert (f b - f c <= M * (b - c)).
      { apply IH; [lra|intros; apply C; lra|]. intros t Ht Hn. apply D; [lra|].
        intros [->|Hi]; [lra|auto]. }
      nra.
    + apply IH; auto. intros t Ht Hn. apply D; auto. intros [->|Hi]; [lra|auto].
    + apply IH; auto. intros t Ht Hn. apply D; auto. intros [->|Hi]; [lra|auto]. Qed.

Lemma slope f df M a b : follows f df -> 0 <= a <= b ->
  (forall t, a < t < b -> df t <= M) -> f b - f a <= M * (b - a).
Proof. intros [C D] Hab H. destruct (D b) as [l Hl].
  apply (slope_list f df M l); [lra|intros; apply C; lra|].
  intros t Ht Hn. split; [apply Hl; auto; lra|auto]. Qed.

Lemma falls f df a b : follows f df -> 0 <= a <= b ->
  (forall t, a < t < b -> df t <= 0) -> f b <= f a.
Proof. intros F Hab H. assert (S := slope f df 0 a b F Hab H). lra. Qed.

Lemma lipschitz f df L : follows f df -> (forall t, 0 < t -> Rabs (df t) <= L) ->
  forall s t, 0 <= s -> 0 <= t -> Rabs (f t - f s) <= L * Rabs (t - s).
Proof. intros F H.
  assert (W : forall s t, 0 <= s <= t -> Rabs (f t - f s) <= L * Rabs (t - s)).
  { intros s t Hst. rewrite (Rabs_pos_eq (t - s)) by lra. apply Rabs_le. split.
    - assert (S := slope _ _ L s t (follows_scal (-1) f df F) Hst).
      assert (-1 * f t - -1 * f s <= L * (t - s)).
      { apply S. intros u Hu. assert (B := H u ltac:(lra)). apply Rabs_le_between in B. lra. }
      lra.
    - apply (slope f df L s t F Hst). intros u Hu. assert (B := H u ltac:(lra)).
      apply Rabs_le_between in B. lra. }
  intros s t Hs Ht. destruct (Rle_lt_dec s t); [apply W; lra|].
  rewrite (Rabs_minus_sym (f t)), (Rabs_minus_sym t). apply W. lra. Qed.

(* bounded for t >= 0 *)
Definition bounded (f : R -> R) : Prop := exists M, forall t, 0 <= t -> Rabs (f t) <= M.

Lemma bounded_const a : bounded (fun _ => a).
Proof. exists (Rabs a). intros; lra. Qed.

Lemma bounded_plus f g : bounded f -> bounded g -> bounded (fun t => f t + g t).
Proof. intros [M HM] [L HL]. exists (M + L). intros t Ht.
  eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; auto. Qed.

Lemma bounded_mult f g : bounded f -> bounded g -> bounded (fun t => f t * g t).
Proof. intros [M HM] [L HL]. exists (M * L). intros t Ht. rewrite Rabs_mult.
  apply Rmult_le_compat; auto using Rabs_pos. Qed.

Lemma bounded_minus f g : bounded f -> bounded g -> bounded (fun t => f t - g t).
Proof. intros Hf [L HL]. apply (bounded_plus f (fun t => - g t)); auto.
  exists L. intros t Ht. rewrite Rabs_Ropp. auto. Qed.

Lemma bounded_sum n (f : nat -> R -> R) :
  (forall k, (k < n)%nat -> bounded (f k)) -> bounded (fun t => sum n (fun k => f k t)).
Proof. induction n as [|n IH]; intros H; simpl; [apply bounded_const|].
  apply (bounded_plus (fun t => sum n (fun k => f k t))); auto. Qed.

Lemma bounded_ext f g : (forall t, 0 <= t -> f t = g t) -> bounded f -> bounded g.
Proof. intros E [M H]. exists M. intros t Ht. rewrite <- E; auto. Qed.

(* x' = -k x + u with a bounded u: x is bounded *)
Lemma stable_upper k x u B : 0 < k -> follows x (fun t => - k * x t + u t) ->
  (forall t, 0 <= t -> u t <= k * B) -> x 0 <= B -> forall t, 0 <= t -> x t <= B.
Proof. intros Hk F U H0 t Ht.
  assert (G : follows (fun t => exp (k * t) * (x t - B))
                      (fun t => k * exp (k * t) * (x t - B) + exp (k * t) * (- k * x t + u t - 0))).
  { apply follows_mult; [|apply follows_minus; [auto|apply follows_const]].
    apply follows_smooth. intros s. auto_derive; auto. ring. }
  assert (L : exp (k * t) * (x t - B) <= exp (k * 0) * (x 0 - B)).
  { apply (falls _ _ 0 t G); [lra|]. intros s Hs. assert (P := exp_pos (k * s)).
    assert (u s <= k * B) by (apply U; lra). nra. }
  rewrite Rmult_0_r, exp_0 in L. assert (P := exp_pos (k * t)). nra. Qed.

Lemma stable k x u : 0 < k -> follows x (fun t => - k * x t + u t) -> bounded u -> bounded x.
Proof. intros Hk F [U HU]. set (B := Rmax (Rabs (x 0)) (U / k)).
  assert (A1 : Rabs (x 0) <= B) by apply Rmax_l.
  assert (A2 : U <= k * B).
  { assert (U / k <= B) by apply Rmax_r. apply (Rmult_le_compat_l k) in H; [|lra].
    replace (k * (U / k)) with U in H by (field; lra). lra. }
  apply Rabs_le_between in A1. exists B. intros t Ht. apply Rabs_le. split.
  - assert (L : -1 * x t <= B).
    { apply (stable_upper k (fun t => -1 * x t) (fun t => -1 * u t) B); auto; [| |lra].
      - apply (follows_ext (fun t => -1 * x t) (fun t => -1 * (- k * x t + u t))); try (intros; ring).
        apply follows_scal, F.
      - intros s Hs. assert (S := HU s Hs). apply Rabs_le_between in S. lra. }
    lra.
  - apply (stable_upper k x u B); auto; [|lra].
    intros s Hs. assert (S := HU s Hs). apply Rabs_le_between in S. lra. Qed.

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
