(* Runs on [0, T), T finite or infinite: rates, bounds, limits and stability of what a loop does.

   [follows T f df] says that f is continuous on [0, T) and f' = df but at finitely many times
   before any S < T.  Tactics follow the form of their goal.  Files of verdicts begin with this
   text; they state a loop, V and what holds of them. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
Open Scope R_scope.

(* t is a time of a run on [0, T); T may be infinite *)
Definition on (T : Rbar) (t : R) : Prop := 0 <= t /\ Rbar_lt t T.

Lemma on_le T s t : on T t -> 0 <= s <= t -> on T s.
Proof. intros [_ H] Hs. split; [lra|]. destruct T; simpl in *; auto; lra. Qed.
Lemma on_all t : 0 <= t -> on p_infty t.
Proof. split; simpl; auto. Qed.
Global Hint Resolve on_all : core.

(* f is continuous on [0, T), and f' = df but at finitely many times before any S < T *)
Definition follows (T : Rbar) (f df : R -> R) : Prop :=
  (forall t, on T t -> continuous f t) /\
  (forall S, on T S -> exists l : list R, forall t, 0 < t < S -> ~ In t l -> is_derive f t (df t)).

Section Rules.
Variable T : Rbar.

Lemma follows_by f df dg : follows T f df -> (forall t, on T t -> df t = dg t) -> follows T f dg.
Proof. intros [C D] E. split; auto. intros S HS. destruct (D S HS) as [l H]. exists l.
  intros t Ht Hn. rewrite <- E by (apply (on_le T t S); auto; lra). auto. Qed.

Lemma follows_const a : follows T (fun _ => a) (fun _ => 0).
Proof. split; [intros; apply continuous_const|]. intros S _. exists nil. intros. apply @is_derive_const. Qed.

Lemma follows_time : follows T (fun t => t) (fun _ => 1).
Proof. split; [intros; apply continuous_id|]. intros S _. exists nil. intros. apply @is_derive_id. Qed.

Lemma follows_two (op : (R -> R) -> (R -> R) -> R -> R) d f df g dg :
  (forall t, continuous f t -> continuous g t -> continuous (op f g) t) ->
  (forall t, is_derive f t (df t) -> is_derive g t (dg t) -> is_derive (op f g) t (d t)) ->
  follows T f df -> follows T g dg -> follows T (op f g) d.
Proof. intros HC HD [Cf Df] [Cg Dg]. split; auto.
  intros S HS. destruct (Df S HS) as [l Hl], (Dg S HS) as [m Hm]. exists (l ++ m). intros t Ht Hn.
  apply HD; [apply Hl|apply Hm]; auto; intros Hi; apply Hn, in_or_app; auto. Qed.

Lemma follows_plus f df g dg :
  follows T f df -> follows T g dg -> follows T (fun t => f t + g t) (fun t => df t + dg t).
Proof. apply (follows_two (fun f g t => f t + g t)); intros.
  - apply @continuous_plus; auto. - apply @is_derive_plus; auto. Qed.

Lemma follows_minus f df g dg :
  follows T f df -> follows T g dg -> follows T (fun t => f t - g t) (fun t => df t - dg t).
Proof. apply (follows_two (fun f g t => f t - g t)); intros.
  - apply @continuous_minus; auto. - apply @is_derive_minus; auto. Qed.

Lemma follows_mult f df g dg :
  follows T f df -> follows T g dg -> follows T (fun t => f t * g t) (fun t => df t * g t + f t * dg t).
Proof. apply (follows_two (fun f g t => f t * g t)); intros.
  - apply @continuous_mult; auto. - apply @is_derive_mult; auto; intros; apply Rmult_comm. Qed.

Lemma follows_in (g dg : R -> R) f df : (forall t, on T t -> is_derive g (f t) (dg (f t))) ->
  follows T f df -> follows T (fun t => g (f t)) (fun t => df t * dg (f t)).
Proof. intros G [C D]. split.
  - intros t Ht. apply continuous_comp; auto. apply @ex_derive_continuous. exists (dg (f t)). auto.
  - intros S HS. destruct (D S HS) as [l H]. exists l. intros t Ht Hn.
    apply (is_derive_comp g f); [apply G, (on_le T t S); auto; lra|apply H; auto]. Qed.

Lemma follows_opp f df : follows T f df -> follows T (fun t => - f t) (fun t => - df t).
Proof. intros H. apply (follows_by _ (fun t => df t * -1)); [|intros; ring].
  apply (follows_in Ropp (fun _ => -1)); auto. intros. auto_derive; auto; ring. Qed.

Lemma follows_pow n f df : follows T f df ->
  follows T (fun t => f t ^ n) (fun t => df t * (IZR (Z.of_nat n) * f t ^ pred n)).
Proof. apply (follows_in (fun x => x ^ n) (fun x => IZR (Z.of_nat n) * x ^ pred n)).
  intros. auto_derive; auto; rewrite <- INR_IZR_INZ; ring. Qed.

Lemma follows_inv f df : (forall t, on T t -> f t <> 0) -> follows T f df ->
  follows T (fun t => / f t) (fun t => df t * (- (/ f t) ^ 2)).
Proof. intros N. apply (follows_in Rinv (fun x => - (/ x) ^ 2)).
  intros t Ht. assert (A := N t Ht). auto_derive; auto; field; auto. Qed.

Lemma follows_div f df g dg : (forall t, on T t -> g t <> 0) ->
  follows T f df -> follows T g dg ->
  follows T (fun t => f t / g t) (fun t => df t / g t + f t * (dg t * (- (/ g t) ^ 2))).
Proof. intros N F G. apply (follows_mult f df (fun t => / g t)); auto. apply follows_inv; auto. Qed.

Lemma follows_sin f df : follows T f df -> follows T (fun t => sin (f t)) (fun t => df t * cos (f t)).
Proof. apply (follows_in sin cos). intros. auto_derive; auto; ring. Qed.
Lemma follows_cos f df : follows T f df -> follows T (fun t => cos (f t)) (fun t => df t * (- sin (f t))).
Proof. apply (follows_in cos (fun x => - sin x)). intros. auto_derive; auto; ring. Qed.
Lemma follows_exp f df : follows T f df -> follows T (fun t => exp (f t)) (fun t => df t * exp (f t)).
Proof. apply (follows_in exp exp). intros. auto_derive; auto; ring. Qed.
Lemma tanh_exp x : tanh x = (exp x - exp (- x)) / (exp x + exp (- x)).
Proof. assert (A := exp_pos x). assert (B := exp_pos (- x)). unfold tanh, sinh, cosh. field. lra. Qed.
Lemma derive_tanh x : is_derive tanh x (1 - tanh x ^ 2).
Proof. assert (A := exp_pos x). assert (B := exp_pos (- x)).
  apply (is_derive_ext (fun x => (exp x - exp (- x)) / (exp x + exp (- x)))).
  - intros y. symmetry. apply tanh_exp.
  - auto_derive; [lra|]. rewrite tanh_exp. field. lra. Qed.
Lemma follows_tanh f df : follows T f df -> follows T (fun t => tanh (f t)) (fun t => df t * (1 - tanh (f t) ^ 2)).
Proof. apply (follows_in tanh (fun x => 1 - tanh x ^ 2)). intros. apply derive_tanh. Qed.
Lemma follows_ln f df : (forall t, on T t -> 0 < f t) -> follows T f df ->
  follows T (fun t => ln (f t)) (fun t => df t * / f t).
Proof. intros P. apply (follows_in ln Rinv). intros t Ht. assert (A := P t Ht). auto_derive; auto; field; lra. Qed.
Lemma follows_sqrt f df : (forall t, on T t -> 0 < f t) -> follows T f df ->
  follows T (fun t => sqrt (f t)) (fun t => df t * / (2 * sqrt (f t))).
Proof. intros P. apply (follows_in sqrt (fun x => / (2 * sqrt x))). intros t Ht. assert (A := P t Ht).
  assert (B := sqrt_lt_R0 _ A). auto_derive; auto; field; lra. Qed.

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

Lemma slope f df M a b : follows T f df -> 0 <= a <= b -> on T b ->
  (forall t, a < t < b -> df t <= M) -> f b - f a <= M * (b - a).
Proof. intros [C D] Hab Hb H. destruct (D b Hb) as [l Hl].
  apply (slope_list f df M l); [lra|intros; apply C, (on_le T t b); auto; lra|].
  intros t Ht Hn. split; [apply Hl; auto; lra|auto]. Qed.

Lemma falls f df : follows T f df -> (forall t, on T t -> df t <= 0) ->
  forall s t, 0 <= s <= t -> on T t -> f t <= f s.
Proof. intros F H s t Hst Ht. assert (S := slope f df 0 s t F Hst Ht). enough (f t - f s <= 0 * (t - s)) by lra.
  apply S. intros u Hu. apply H, (on_le T u t); auto; lra. Qed.

(* V' <= d - c V *)
Lemma decays V dV c d : 0 < c -> follows T V dV -> (forall t, on T t -> dV t <= d - c * V t) ->
  forall t, on T t -> V t <= d / c + (V 0 - d / c) * exp (- c * t).
Proof. intros Hc F H t Ht.
  assert (G : follows T (fun t => (V t - d / c) * exp (c * t))
    (fun t => (dV t - 0) * exp (c * t) + (V t - d / c) * ((0 * t + c * 1) * exp (c * t)))).
  { apply follows_mult; [apply follows_minus; [auto|apply follows_const]|].
    apply follows_exp, follows_mult; [apply follows_const|apply follows_time]. }
  assert (L : (V t - d / c) * exp (c * t) <= (V 0 - d / c) * exp (c * 0)).
  { apply (falls _ _ G); [|split; [lra|apply Ht]|auto]. intros s Hs. assert (P := exp_pos (c * s)).
    assert (dV s <= d - c * V s) by auto.
    replace ((dV s - 0) * exp (c * s) + (V s - d / c) * ((0 * s + c * 1) * exp (c * s)))
      with ((dV s - (d - c * V s)) * exp (c * s)) by (field; lra). nra. }
  rewrite Rmult_0_r, exp_0 in L. replace (- c * t) with (- (c * t)) by ring. rewrite exp_Ropp.
  assert (P := exp_pos (c * t)).
  assert (E : V t - d / c <= (V 0 - d / c) * / exp (c * t)); [|lra].
  apply (Rmult_le_reg_r (exp (c * t))); [auto|]. rewrite Rmult_assoc, Rinv_l by lra. lra. Qed.

(* V' <= c - k V: V is at most what decays to the level l = c/k *)
Lemma decays_to k c l V dV : 0 < k -> l * k = c -> follows T V dV ->
  (forall t, on T t -> dV t <= c - k * V t) ->
  forall t, on T t -> V t <= l + (V 0 - l) * exp (- k * t).
Proof. intros Hk <- F H t Ht. assert (A := decays V dV k (l * k) Hk F H t Ht).
  replace (l * k / k) with l in A by (field; lra). exact A. Qed.
Lemma below_max k l v0 t : 0 < k -> 0 <= t -> l + (v0 - l) * exp (- k * t) <= Rmax v0 l.
Proof. intros Hk Ht. assert (P := exp_pos (- k * t)). assert (E : exp (- k * t) <= 1).
  { rewrite <- exp_0. destruct (Req_dec t 0) as [->|N]; [right; f_equal; ring|].
    left. apply exp_increasing. nra. }
  assert (A := Rmax_l v0 l). assert (B := Rmax_r v0 l). nra. Qed.
Lemma decays_near k l V c : 0 < k -> l < c -> (forall t, 0 <= t -> V t <= l + (V 0 - l) * exp (- k * t)) ->
  exists s, forall t, s <= t -> V t < c.
Proof. intros Hk Hc H. set (v0 := V 0) in *. set (d := (c - l) / (Rabs (v0 - l) + 1)). assert (N := Rabs_pos (v0 - l)).
  assert (D : 0 < d) by (apply Rdiv_lt_0_compat; lra). exists (Rmax 0 (- ln d / k)).
  intros t Ht. assert (K := Rmax_l 0 (- ln d / k)). assert (L := Rmax_r 0 (- ln d / k)). assert (E : exp (- k * t) <= d).
  { rewrite <- (exp_ln d) by auto. assert (M : - k * t <= ln d).
    { assert (Q : - ln d / k <= t) by lra. apply (Rmult_le_compat_l k) in Q; [|lra].
      replace (k * (- ln d / k)) with (- ln d) in Q by (field; lra). lra. }
    destruct M as [M| ->]; [apply Rlt_le, exp_increasing, M|lra]. }
  assert (P := exp_pos (- k * t)). assert (A := Rle_abs (v0 - l)).
  assert (F : (Rabs (v0 - l) + 1) * d = c - l) by (unfold d; field; lra).
  assert (G : (v0 - l) * exp (- k * t) <= Rabs (v0 - l) * d) by nra.
  assert (B := H t ltac:(lra)). nra. Qed.

(* V' <= 0 where V < c: what begins below c stays there, and V falls *)
Lemma stays_below V dV c : follows T V dV -> (forall t, on T t -> V t < c -> dV t <= 0) -> V 0 < c ->
  forall t, on T t -> V t < c.
Proof. intros F H H0 t Ht. destruct (Rlt_le_dec (V t) c) as [|Big]; auto. exfalso.
  set (E := fun s => 0 <= s <= t /\ forall r, 0 <= r <= s -> V r < c).
  assert (P0 : 0 <= t) by apply Ht.
  destruct (completeness E) as [m [Up Least]].
  { exists t. intros s [Hs _]. lra. }
  { exists 0. split; [lra|]. intros r Hr. replace r with 0 by lra. auto. }
  assert (M0 : 0 <= m). { apply Up. split; [lra|]. intros r Hr. replace r with 0 by lra. auto. }
  assert (Mt : m <= t). { apply Least. intros s [Hs _]. lra. }
  assert (Below : forall r, 0 <= r < m -> V r < c).
  { intros r Hr. destruct (Rlt_le_dec (V r) c) as [|B]; auto. exfalso.
    assert (m <= r); [|lra]. apply Least. intros s [Hs Hb]. destruct (Rle_lt_dec s r); auto.
    assert (V r < c) by (apply Hb; lra). lra. }
  assert (Om : on T m) by (apply (on_le T m t); auto).
  assert (Vm : V m < c).
  { assert (S := slope V dV 0 0 m F ltac:(lra) Om). enough (V m - V 0 <= 0 * (m - 0)) by lra.
    apply S. intros u Hu. apply H; [apply (on_le T u m); auto; lra|apply Below; lra]. }
  destruct F as [C _]. assert (Cm := C m Om).
  assert (Q : 0 < c - V m) by lra.
  destruct (Cm (ball (V m) (mkposreal _ Q)) (locally_ball _ _)) as [d Hd].
  destruct (Req_dec m t) as [->|Ne]; [lra|].
  assert (Pd := cond_pos d). set (s := Rmin t (m + d / 2)).
  assert (S1 : s <= t) by apply Rmin_l. assert (S2 : s <= m + d / 2) by apply Rmin_r.
  assert (S3 : m < s) by (apply Rmin_glb_lt; lra).
  assert (s <= m); [|lra]. apply Up. split; [lra|]. intros r Hr.
  destruct (Rlt_le_dec r m) as [L|L]; [apply Below; lra|].
  assert (B : ball m d r). { change (Rabs (r - m) < d). rewrite Rabs_pos_eq; lra. }
  assert (A := Hd r B). change (Rabs (V r - V m) < c - V m) in A. apply Rabs_lt_between in A. lra. Qed.

(* bounded on [0, T) *)
Definition bounded (f : R -> R) : Prop := exists M, forall t, on T t -> Rabs (f t) <= M.

Lemma bounded_const a : bounded (fun _ => a).
Proof. exists (Rabs a). intros; lra. Qed.
Lemma bounded_between a b f : (forall t, on T t -> a <= f t <= b) -> bounded f.
Proof. intros H. exists (Rabs a + Rabs b). intros t Ht. destruct (H t Ht). assert (A := Rle_abs b).
  assert (B := Rle_abs (- a)). rewrite Rabs_Ropp in B. assert (C := Rabs_pos a). assert (D := Rabs_pos b).
  apply Rabs_le. lra. Qed.
Lemma bounded_plus f g : bounded f -> bounded g -> bounded (fun t => f t + g t).
Proof. intros [M HM] [L HL]. exists (M + L). intros t Ht.
  eapply Rle_trans; [apply Rabs_triang|]. apply Rplus_le_compat; auto. Qed.
Lemma bounded_mult f g : bounded f -> bounded g -> bounded (fun t => f t * g t).
Proof. intros [M HM] [L HL]. exists (M * L). intros t Ht. rewrite Rabs_mult.
  apply Rmult_le_compat; auto using Rabs_pos. Qed.
Lemma bounded_opp f : bounded f -> bounded (fun t => - f t).
Proof. intros [M HM]. exists M. intros t Ht. rewrite Rabs_Ropp. auto. Qed.
Lemma bounded_minus f g : bounded f -> bounded g -> bounded (fun t => f t - g t).
Proof. intros Hf Hg. apply (bounded_plus f (fun t => - g t)); auto using bounded_opp. Qed.
Lemma bounded_pow n f : bounded f -> bounded (fun t => f t ^ n).
Proof. intros H. induction n; simpl; [apply bounded_const|apply bounded_mult; auto]. Qed.
Lemma bounded_abs f : bounded f -> bounded (fun t => Rabs (f t)).
Proof. intros [M H]. exists M. intros t Ht. rewrite Rabs_Rabsolu. auto. Qed.
Lemma bounded_sqrt f : bounded f -> bounded (fun t => sqrt (f t)).
Proof. intros [M H]. exists (sqrt M). intros t Ht. rewrite Rabs_pos_eq by apply sqrt_pos.
  apply sqrt_le_1_alt. eapply Rle_trans; [apply Rle_abs|auto]. Qed.
Lemma bounded_ext f g : (forall t, on T t -> f t = g t) -> bounded f -> bounded g.
Proof. intros E [M H]. exists M. intros t Ht. rewrite <- E; auto. Qed.
Lemma bounded_by M (f : R -> R) : (forall x, Rabs (f x) <= M) -> forall g, bounded (fun t => f (g t)).
Proof. intros H g. exists M. auto. Qed.
Lemma bounded_sin f : bounded (fun t => sin (f t)).
Proof. apply (bounded_by 1 sin). intros. apply Rabs_le, SIN_bound. Qed.
Lemma bounded_cos f : bounded (fun t => cos (f t)).
Proof. apply (bounded_by 1 cos). intros. apply Rabs_le, COS_bound. Qed.
Lemma tanh_between x : -1 <= tanh x <= 1.
Proof. rewrite tanh_exp. assert (A := exp_pos x). assert (B := exp_pos (- x)).
  split; apply (Rmult_le_reg_r (exp x + exp (- x))); try lra; unfold Rdiv;
  rewrite ?Rmult_assoc, ?Rinv_l by lra; lra. Qed.
Lemma bounded_tanh f : bounded (fun t => tanh (f t)).
Proof. apply (bounded_by 1 tanh). intros. apply Rabs_le, tanh_between. Qed.
Lemma bounded_exp f : bounded f -> bounded (fun t => exp (f t)).
Proof. intros [M H]. exists (exp M). intros t Ht. rewrite Rabs_pos_eq by (apply Rlt_le, exp_pos).
  assert (f t <= M) by (eapply Rle_trans; [apply Rle_abs|auto]).
  destruct H0; [apply Rlt_le, exp_increasing; auto|right; f_equal; auto]. Qed.
Lemma bounded_inv_exp f : bounded f -> bounded (fun t => / exp (f t)).
Proof. intros H. apply (bounded_ext (fun t => exp (- f t))); [intros; apply exp_Ropp|].
  apply bounded_exp, bounded_opp, H. Qed.
Lemma bounded_inv c f : 0 < c -> (forall t, on T t -> c <= f t) -> bounded (fun t => / f t).
Proof. intros Hc H. exists (/ c). intros t Ht. assert (c <= f t) by auto.
  rewrite Rabs_pos_eq by (apply Rlt_le, Rinv_0_lt_compat; lra). apply Rinv_le_contravar; auto. Qed.
(* x' = -k x + u with a bounded u: x is bounded *)
Lemma bounded_lag k x u : 0 < k -> follows T x (fun t => u t - k * x t) -> bounded u -> bounded x.
Proof. intros Hk F [U HU]. exists (U / k + Rabs (x 0)). intros t Ht.
  assert (E : 0 < exp (- k * t) <= 1).
  { split; [apply exp_pos|]. rewrite <- exp_0. destruct Ht as [Ht _]. destruct (Req_dec t 0) as [->|].
    - right. f_equal. ring. - left. apply exp_increasing. nra. }
  assert (0 <= U). { eapply Rle_trans; [apply Rabs_pos|apply (HU t Ht)]. }
  assert (0 <= U / k) by (apply Rmult_le_pos; auto; apply Rlt_le, Rinv_0_lt_compat; auto).
  assert (A := Rle_abs (x 0)). assert (B := Rle_abs (- x 0)). rewrite Rabs_Ropp in B.
  assert (P := decays x _ k U Hk F). assert (M := decays (fun t => - x t) _ k U Hk (follows_opp _ _ F)).
  apply Rabs_le. simpl in *. split.
  - enough (- x t <= U / k + (- x 0 - U / k) * exp (- k * t)) by nra. apply M; auto.
    intros s Hs. assert (B' := HU s Hs). apply Rabs_le_between in B'. lra.
  - enough (x t <= U / k + (x 0 - U / k) * exp (- k * t)) by nra. apply P; auto.
    intros s Hs. assert (B' := HU s Hs). apply Rabs_le_between in B'. lra. Qed.
End Rules.
(* cosh, sinh and atan *)
Lemma derive_sinh x : is_derive sinh x (cosh x).
Proof. unfold sinh, cosh. auto_derive; auto; field. Qed.
Lemma derive_cosh x : is_derive cosh x (sinh x).
Proof. unfold sinh, cosh. auto_derive; auto; field. Qed.
Lemma derive_atan x : is_derive atan x (/ (1 + x ^ 2)).
Proof. apply is_derive_Reals, derivable_pt_lim_atan. Qed.
Lemma follows_sinh T f df : follows T f df -> follows T (fun t => sinh (f t)) (fun t => df t * cosh (f t)).
Proof. apply (follows_in T sinh cosh). intros. apply derive_sinh. Qed.
Lemma follows_cosh T f df : follows T f df -> follows T (fun t => cosh (f t)) (fun t => df t * sinh (f t)).
Proof. apply (follows_in T cosh sinh). intros. apply derive_cosh. Qed.
Lemma follows_atan T f df : follows T f df -> follows T (fun t => atan (f t)) (fun t => df t * / (1 + f t ^ 2)).
Proof. apply (follows_in T atan (fun x => / (1 + x ^ 2))). intros. apply derive_atan. Qed.
Lemma bounded_atan T f : bounded T (fun t => atan (f t)).
Proof. apply (bounded_by T (PI / 2) atan). intros x. assert (A := atan_bound x). apply Rabs_le. lra. Qed.
Lemma bounded_cosh T f : bounded T f -> bounded T (fun t => cosh (f t)).
Proof. intros H. apply (bounded_mult T (fun t => exp (f t) + exp (- f t)) (fun _ => / 2)); [|apply bounded_const].
  apply bounded_plus; apply bounded_exp; auto using bounded_opp. Qed.
Lemma bounded_sinh T f : bounded T f -> bounded T (fun t => sinh (f t)).
Proof. intros H. apply (bounded_mult T (fun t => exp (f t) - exp (- f t)) (fun _ => / 2)); [|apply bounded_const].
  apply bounded_minus; apply bounded_exp; auto using bounded_opp. Qed.

(* --- limits --- *)
Section Rates.
Variable T : Rbar.
Definition Lipschitz (g : R -> R) : Prop :=
  exists L, forall s t, on T s -> on T t -> Rabs (g t - g s) <= L * Rabs (t - s).

Lemma Lipschitz_by f df L : follows T f df -> (forall t, 0 < t -> on T t -> Rabs (df t) <= L) ->
  forall s t, on T s -> on T t -> Rabs (f t - f s) <= L * Rabs (t - s).
Proof. intros F H.
  assert (W : forall s t, 0 <= s <= t -> on T t -> Rabs (f t - f s) <= L * Rabs (t - s)).
  { intros s t Hst Ht. rewrite (Rabs_pos_eq (t - s)) by lra.
    assert (B : forall u, s < u < t -> - L <= df u <= L).
    { intros u Hu. apply Rabs_le_between, H; [lra|apply (on_le T u t); auto; lra]. }
    apply Rabs_le. split.
    - assert (S := slope T _ _ L s t (follows_opp T f df F) Hst Ht).
      assert (- f t - - f s <= L * (t - s)); [|lra]. apply S. intros u Hu. assert (C := B u Hu). lra.
    - apply (slope T f df L s t F Hst Ht). intros u Hu. assert (C := B u Hu). lra. }
  intros s t Hs Ht. destruct (Rle_lt_dec s t); [apply W; auto; destruct Hs; lra|].
  rewrite (Rabs_minus_sym (f t)), (Rabs_minus_sym t). apply W; auto. destruct Ht. lra. Qed.
Lemma Lipschitz_rate f df : follows T f df -> bounded T df -> Lipschitz f.
Proof. intros F [L H]. exists L. apply (Lipschitz_by f df); auto. Qed.
Lemma Lipschitz_const a : Lipschitz (fun _ => a).
Proof. exists 0. intros. rewrite Rminus_eq_0, Rabs_R0. lra. Qed.
Lemma Lipschitz_time : Lipschitz (fun t => t).
Proof. exists 1. intros. lra. Qed.
Lemma Lipschitz_plus f g : Lipschitz f -> Lipschitz g -> Lipschitz (fun t => f t + g t).
Proof. intros [L HL] [M HM]. exists (L + M). intros s t Hs Ht.
  replace (f t + g t - (f s + g s)) with ((f t - f s) + (g t - g s)) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. specialize (HL s t Hs Ht). specialize (HM s t Hs Ht). lra. Qed.
Lemma Lipschitz_mult f g : bounded T f -> bounded T g -> Lipschitz f -> Lipschitz g ->
  Lipschitz (fun t => f t * g t).
Proof. intros [F HF] [G HG] [L HL] [M HM]. exists (L * G + F * M). intros s t Hs Ht.
  replace (f t * g t - f s * g s) with ((f t - f s) * g t + f s * (g t - g s)) by ring.
  eapply Rle_trans; [apply Rabs_triang|]. rewrite !Rabs_mult.
  specialize (HL s t Hs Ht). specialize (HM s t Hs Ht). specialize (HF s Hs). specialize (HG t Ht).
  assert (A := Rabs_pos (f t - f s)). assert (B := Rabs_pos (g t - g s)).
  assert (C := Rabs_pos (g t)). assert (D := Rabs_pos (f s)).
  assert (Rabs (f t - f s) * Rabs (g t) <= L * Rabs (t - s) * G) by (apply Rmult_le_compat; auto).
  assert (Rabs (f s) * Rabs (g t - g s) <= F * (M * Rabs (t - s))) by (apply Rmult_le_compat; auto). nra. Qed.
Lemma Lipschitz_scal a f : Lipschitz f -> Lipschitz (fun t => a * f t).
Proof. intros [L H]. exists (Rabs a * L). intros s t Hs Ht. rewrite <- Rmult_minus_distr_l, Rabs_mult, Rmult_assoc.
  apply Rmult_le_compat_l; auto using Rabs_pos. Qed.
Lemma Lipschitz_times a f : Lipschitz f -> Lipschitz (fun t => f t * a).
Proof. intros H. destruct (Lipschitz_scal a f H) as [L HL]. exists L. intros s t Hs Ht. rewrite !(Rmult_comm _ a). auto. Qed.
Lemma Lipschitz_opp f : Lipschitz f -> Lipschitz (fun t => - f t).
Proof. intros [L H]. exists L. intros s t Hs Ht. replace (- f t - - f s) with (- (f t - f s)) by ring.
  rewrite Rabs_Ropp. auto. Qed.
Lemma Lipschitz_minus f g : Lipschitz f -> Lipschitz g -> Lipschitz (fun t => f t - g t).
Proof. intros F G. apply (Lipschitz_plus f (fun t => - g t)); auto using Lipschitz_opp. Qed.
Lemma Lipschitz_pow n f : bounded T f -> Lipschitz f -> Lipschitz (fun t => f t ^ n).
Proof. intros B L. induction n; simpl; [apply Lipschitz_const|apply Lipschitz_mult; auto using bounded_pow]. Qed.
Lemma Lipschitz_abs f : Lipschitz f -> Lipschitz (fun t => Rabs (f t)).
Proof. intros [L H]. exists L. intros s t Hs Ht. eapply Rle_trans; [apply Rabs_triang_inv2|auto]. Qed.
Lemma Lipschitz_in (g dg : R -> R) M f : (forall x, is_derive g x (dg x)) -> (forall x, Rabs (dg x) <= M) ->
  Lipschitz f -> Lipschitz (fun t => g (f t)).
Proof. intros D B [L H]. exists (M * L). intros s t Hs Ht.
  destruct (MVT_gen g (f s) (f t) dg) as [c [_ E]].
  - intros; apply D. - intros. apply continuity_pt_filterlim, @ex_derive_continuous. eexists. apply D.
  - rewrite E, Rabs_mult. rewrite Rmult_assoc. apply Rmult_le_compat; auto using Rabs_pos. Qed.
Lemma Lipschitz_sin f : Lipschitz f -> Lipschitz (fun t => sin (f t)).
Proof. apply (Lipschitz_in sin cos 1). - intros. auto_derive; auto. ring.
  - intros. apply Rabs_le, COS_bound. Qed.
Lemma Lipschitz_cos f : Lipschitz f -> Lipschitz (fun t => cos (f t)).
Proof. apply (Lipschitz_in cos (fun x => - sin x) 1). - intros. auto_derive; auto. ring.
  - intros. rewrite Rabs_Ropp. apply Rabs_le, SIN_bound. Qed.
Lemma Lipschitz_atan f : Lipschitz f -> Lipschitz (fun t => atan (f t)).
Proof. apply (Lipschitz_in atan (fun x => / (1 + x ^ 2)) 1); [apply derive_atan|]. intros x. assert (A := pow2_ge_0 x).
  rewrite Rabs_pos_eq by (apply Rlt_le, Rinv_0_lt_compat; lra). rewrite <- Rinv_1. apply Rinv_le_contravar; lra. Qed.
Lemma Lipschitz_tanh f : Lipschitz f -> Lipschitz (fun t => tanh (f t)).
Proof. apply (Lipschitz_in tanh (fun x => 1 - tanh x ^ 2) 1); [apply derive_tanh|].
  intros x. assert (A := tanh_between x). apply Rabs_le. split; nra. Qed.
End Rates.
(* 1/f of a Lipschitz f that stays away from zero, as 1/(1 + |x|) *)
Lemma Lipschitz_inv T c f : 0 < c -> (forall t, on T t -> c <= f t) -> Lipschitz T f -> Lipschitz T (fun t => / f t).
Proof. intros P A [L H]. exists (L * (/ c * / c)). intros s t Hs Ht. assert (B := A s Hs). assert (C := A t Ht).
  replace (/ f t - / f s) with ((f t - f s) * - (/ f t * / f s)) by (field; lra). rewrite Rabs_mult, Rabs_Ropp.
  assert (D : 0 < / f t * / f s) by (apply Rmult_lt_0_compat; apply Rinv_0_lt_compat; lra). rewrite (Rabs_pos_eq (_ * _)) by lra.
  assert (E : / f t * / f s <= / c * / c).
  { apply Rmult_le_compat; try (apply Rlt_le, Rinv_0_lt_compat; lra); apply Rinv_le_contravar; auto. }
  assert (F := H s t Hs Ht). assert (Q := Rabs_pos (f t - f s)). assert (0 < / c * / c) by (apply Rmult_lt_0_compat; apply Rinv_0_lt_compat; auto).
  replace (L * (/ c * / c) * Rabs (t - s)) with (L * Rabs (t - s) * (/ c * / c)) by ring. apply Rmult_le_compat; lra. Qed.

(* f goes to zero for ever *)
Definition fades (f : R -> R) : Prop := is_lim f p_infty 0.
(* V >= 0 loses a Lipschitz g >= 0: g -> 0 (Barbalat) *)
Theorem barbalat (V dV g : R -> R) :
  follows p_infty V dV -> (forall t, on p_infty t -> 0 <= V t) -> (forall t, on p_infty t -> 0 <= g t) ->
  (forall t, 0 < t -> dV t <= - g t) -> Lipschitz p_infty g -> fades g.
Proof.
  intros F V0 g0 D [L HL]. apply is_lim_spec. intros [eps He]. simpl.
  assert (Fall : forall s t, 0 <= s <= t -> V t <= V s).
  { intros s t Hst. enough (V t - V s <= 0 * (t - s)) by lra.
    apply (slope p_infty V dV); auto; [apply on_all; lra|]. intros u Hu.
    assert (dV u <= - g u) by (apply D; lra). assert (0 <= g u) by (apply g0, on_all; lra). lra. }
  destruct (ex_finite_lim_seq_decr (fun n => V (INR n)) 0) as [l Hl].
  { intros n. apply Fall. rewrite S_INR. assert (0 <= INR n) by apply pos_INR. lra. }
  { intros n. apply V0, on_all, pos_INR. }
  set (h := eps / (2 * (Rabs L + 1))). assert (PL : 0 <= Rabs L) by apply Rabs_pos.
  assert (Hh : 0 < h) by (apply Rdiv_lt_0_compat; lra).
  assert (Lh : Rabs L * h <= eps / 2).
  { unfold h. apply (Rmult_le_reg_r (2 * (Rabs L + 1))); [lra|].
    replace (Rabs L * (eps / (2 * (Rabs L + 1))) * (2 * (Rabs L + 1))) with (Rabs L * eps)
      by (field; lra). nra. }
  assert (P : 0 < eps / 2 * h / 2) by nra.
  apply is_lim_seq_spec in Hl. destruct (Hl (mkposreal _ P)) as [n Hn]. simpl in Hn.
  assert (Near : forall t, INR n <= t -> l - eps / 2 * h / 2 < V t < l + eps / 2 * h / 2).
  { intros t Ht. assert (0 <= INR n) by apply pos_INR. split.
    - destruct (nfloor_ex t ltac:(lra)) as [m [Hm1 Hm2]].
      assert (V (INR (S m)) <= V t) by (apply Fall; rewrite S_INR; lra).
      assert (n <= S m)%nat by (apply INR_le; rewrite S_INR; lra).
      assert (B := Hn (S m) ltac:(auto)). apply Rabs_lt_between in B. lra.
    - assert (V t <= V (INR n)) by (apply Fall; lra).
      assert (B := Hn n ltac:(auto)). apply Rabs_lt_between in B. lra. }
  exists (INR n). intros t Ht. rewrite Rminus_0_r. assert (0 <= INR n) by apply pos_INR.
  rewrite Rabs_pos_eq by (apply g0, on_all; lra).
  destruct (Rlt_le_dec (g t) eps) as [|Big]; auto. exfalso.
  assert (S : V (t + h) - V t <= - (eps / 2) * (t + h - t)).
  { apply (slope p_infty V dV); auto; [lra|apply on_all; lra|]. intros u Hu.
    assert (dV u <= - g u) by (apply D; lra).
    assert (B := HL t u ltac:(apply on_all; lra) ltac:(apply on_all; lra)). rewrite (Rabs_pos_eq (u - t)) in B by lra.
    apply Rabs_le_between in B. assert (L <= Rabs L) by apply Rle_abs.
    assert (L * (u - t) <= eps / 2) by nra. lra. }
  assert (A := Near t ltac:(lra)). assert (B := Near (t + h) ltac:(lra)). nra.
Qed.

(* as in textbooks: F has a limit and F' is uniformly continuous, then F' -> 0 *)
Theorem barbalat_limit (F f : R -> R) (l : R) :
  follows p_infty F f -> is_lim F p_infty l ->
  (forall eps, 0 < eps -> exists delta, 0 < delta /\
     forall s t, 0 <= s -> 0 <= t -> Rabs (t - s) < delta -> Rabs (f t - f s) < eps) -> fades f.
Proof.
  intros D L U. apply is_lim_spec. apply is_lim_spec in L. intros [eps He]. simpl.
  destruct (U (eps / 2) ltac:(lra)) as [d [Hd Hu]]. set (h := d / 2).
  assert (P : 0 < eps / 2 * h / 2) by (unfold h; nra).
  destruct (L (mkposreal _ P)) as [M HM]. simpl in HM. assert (Hh : 0 < h < d) by (unfold h; lra).
  exists (Rmax M 0). intros t Ht.
  assert (M < t) by (eapply Rle_lt_trans; [apply Rmax_l|apply Ht]).
  assert (0 < t) by (eapply Rle_lt_trans; [apply Rmax_r|apply Ht]).
  assert (A := HM t ltac:(lra)). assert (B := HM (t + h) ltac:(lra)).
  apply Rabs_lt_between in A. apply Rabs_lt_between in B. rewrite Rminus_0_r.
  assert (Near : forall u, t < u < t + h -> f t - eps / 2 <= f u <= f t + eps / 2).
  { intros u Hu'. assert (C : Rabs (f u - f t) < eps / 2).
    { apply Hu; [lra|lra|]. rewrite Rabs_pos_eq; lra. }
    apply Rabs_lt_between in C. lra. }
  assert (O : on p_infty (t + h)) by (apply on_all; lra).
  assert (Up := slope p_infty F f (f t + eps / 2) t (t + h) D ltac:(lra) O
    ltac:(intros u Hu'; apply Near; lra)).
  assert (W := slope p_infty (fun t => - F t) (fun t => - f t) (- (f t - eps / 2)) t (t + h)
    (follows_opp _ _ _ D) ltac:(lra) O ltac:(intros u Hu'; destruct (Near u Hu'); lra)).
  apply Rabs_lt_between. split; nra.
Qed.

(* q -> 0 with a Lipschitz rate: q' -> 0 *)
Lemma barbalat_next (q dq : R -> R) : follows p_infty q dq -> fades q -> Lipschitz p_infty dq -> fades dq.
Proof. intros F Q [L HL]. apply (barbalat_limit q dq 0 F Q). intros eps He. assert (PL := Rabs_pos L).
  exists (eps / (Rabs L + 1)). split; [apply Rdiv_lt_0_compat; lra|]. intros s t Hs Ht H.
  assert (A := HL s t (on_all s Hs) (on_all t Ht)). assert (B := Rabs_pos (t - s)). assert (C := Rle_abs L).
  apply (Rmult_lt_compat_r (Rabs L + 1)) in H; [|lra].
  replace (eps / (Rabs L + 1) * (Rabs L + 1)) with eps in H by (field; lra). nra. Qed.

Lemma fades_ext f g : (forall t, on p_infty t -> f t = g t) -> fades f -> fades g.
Proof. intros E H. apply (is_lim_ext_loc f); auto. exists 0. intros t Ht. apply E, on_all. lra. Qed.
Lemma fades_plus f g : fades f -> fades g -> fades (fun t => f t + g t).
Proof. intros F G. unfold fades. replace (Finite 0) with (Rbar_plus 0 0) by (simpl; f_equal; ring).
  apply is_lim_plus'; auto. Qed.
Lemma fades_opp f : fades f -> fades (fun t => - f t).
Proof. intros F. unfold fades. replace (Finite 0) with (Rbar_opp 0) by (simpl; f_equal; ring).
  apply is_lim_opp; auto. Qed.
Lemma fades_minus f g : fades f -> fades g -> fades (fun t => f t - g t).
Proof. intros F G. apply (fades_plus f (fun t => - g t)); auto using fades_opp. Qed.
(* f is at most M |g| *)
Lemma fades_le M f g : (forall t, on p_infty t -> Rabs (f t) <= M * Rabs (g t)) -> fades g -> fades f.
Proof. intros H G. apply is_lim_spec. intros eps. assert (He := cond_pos eps). apply is_lim_spec in G. simpl.
  assert (P : 0 < eps / (Rabs M + 1)) by (apply Rdiv_lt_0_compat; auto; assert (A := Rabs_pos M); lra).
  destruct (G (mkposreal _ P)) as [N HN]. simpl in HN. exists (Rmax N 0). intros t Ht.
  assert (N < t) by (eapply Rle_lt_trans; [apply Rmax_l|apply Ht]).
  assert (0 < t) by (eapply Rle_lt_trans; [apply Rmax_r|apply Ht]).
  assert (A := HN t ltac:(auto)). assert (B := H t ltac:(apply on_all; lra)).
  rewrite Rminus_0_r in *. assert (C := Rabs_pos M). assert (M <= Rabs M) by apply Rle_abs.
  assert (D := Rabs_pos (g t)).
  apply (Rle_lt_trans _ ((Rabs M + 1) * Rabs (g t))); [nra|].
  apply (Rmult_lt_compat_l (Rabs M + 1)) in A; [|lra].
  replace ((Rabs M + 1) * (eps / (Rabs M + 1))) with (pos eps) in A by (field; lra). auto. Qed.
Lemma fades_left f g : fades f -> bounded p_infty g -> fades (fun t => f t * g t).
Proof. intros F [M H]. apply (fades_le M _ f); auto. intros t Ht. rewrite Rabs_mult, Rmult_comm.
  apply Rmult_le_compat_r; auto using Rabs_pos. Qed.
Lemma fades_right f g : bounded p_infty f -> fades g -> fades (fun t => f t * g t).
Proof. intros F G. apply (fades_ext (fun t => g t * f t)); [intros; ring|apply fades_left; auto]. Qed.
Lemma fades_pow n f : bounded p_infty f -> fades f -> fades (fun t => f t ^ S n).
Proof. intros B F. simpl. apply fades_left; auto using bounded_pow. Qed.
(* f^n -> 0: f -> 0 *)
Lemma fades_root n f : fades (fun t => f t ^ S n) -> fades f.
Proof. intros H. apply is_lim_spec. intros [eps He]. apply is_lim_spec in H. simpl.
  assert (P : 0 < eps ^ S n) by (apply pow_lt; auto). destruct (H (mkposreal _ P)) as [N HN].
  exists N. intros t Ht. assert (A := HN t Ht). change (Rabs (f t ^ S n - 0) < eps ^ S n) in A.
  rewrite Rminus_0_r in *. rewrite <- RPow_abs in A.
  destruct (Rlt_le_dec (Rabs (f t)) eps); auto.
  assert (eps ^ S n <= Rabs (f t) ^ S n) by (apply pow_incr; lra). lra. Qed.
Lemma fades_abs f : fades (fun t => Rabs (f t)) -> fades f.
Proof. apply (fades_le 1). intros. rewrite Rabs_Rabsolu. lra. Qed.
Lemma fades_zero : fades (fun _ => 0).
Proof. apply is_lim_const. Qed.

(* --- shapes: functions of a form that are positive but at 0 --- *)
Lemma even_power n x : 0 <= x ^ (2 * n).
Proof. rewrite pow_mult. apply pow_le, pow2_ge_0. Qed.
Lemma one_minus_cos x : 0 <= 1 - cos x. Proof. assert (A := COS_bound x). lra. Qed.
Lemma one_plus_cos x : 0 <= 1 + cos x. Proof. assert (A := COS_bound x). lra. Qed.
Lemma exp_line x : 0 <= exp x - x - 1.
Proof. destruct (Req_dec x 0) as [->|H]; [rewrite exp_0; lra|]. assert (A := exp_ineq1 x H). lra. Qed.
Lemma sin_square x : sin x ^ 2 = 1 - cos x ^ 2.
Proof. assert (A := sin2_cos2 x). unfold Rsqr in A. simpl. lra. Qed.
Lemma tanh_increasing x y : x < y -> tanh x < tanh y.
Proof. intros H. assert (A := exp_pos x). assert (B := exp_pos (- x)). assert (C := exp_pos y). assert (D := exp_pos (- y)).
  assert (E := exp_increasing x y H). assert (F := exp_increasing (- y) (- x) ltac:(lra)). rewrite !tanh_exp.
  apply (Rmult_lt_reg_r (exp x + exp (- x))); [lra|]. apply (Rmult_lt_reg_r (exp y + exp (- y))); [lra|].
  replace ((exp x - exp (- x)) / (exp x + exp (- x)) * (exp x + exp (- x)) * (exp y + exp (- y)))
    with ((exp x - exp (- x)) * (exp y + exp (- y))) by (field; lra).
  replace ((exp y - exp (- y)) / (exp y + exp (- y)) * (exp x + exp (- x)) * (exp y + exp (- y)))
    with ((exp y - exp (- y)) * (exp x + exp (- x))) by (field; lra). nra. Qed.
Lemma tanh_rises x y : x <= y -> tanh x <= tanh y.
Proof. intros [H| ->]; [apply Rlt_le, tanh_increasing, H|lra]. Qed.
Lemma tanh_0 : tanh 0 = 0.
Proof. rewrite tanh_exp, Ropp_0, Rminus_eq_0. unfold Rdiv. apply Rmult_0_l. Qed.
Lemma tanh_odd x : tanh (- x) = - tanh x.
Proof. rewrite !tanh_exp, Ropp_involutive. assert (A := exp_pos x). assert (B := exp_pos (- x)). field. lra. Qed.
(* small where the form is, and large where the form is *)
Definition shape (g : R -> R) : Prop :=
  (forall x, 0 <= g x) /\
  (forall eps, 0 < eps -> exists d, 0 < d /\ forall x, g x < d -> Rabs x < eps) /\
  (forall B, exists M, forall x, g x <= B -> Rabs x <= M).

(* even, and rising at least as fast as a multiple of |x| where |x| > 1 *)
Lemma shape_by (g : R -> R) : (forall x, 0 <= g x) ->
  (forall e, 0 < e -> exists d, 0 < d /\ forall x, e <= Rabs x -> d * Rabs x <= g x) -> shape g.
Proof. intros P H. repeat split; auto.
  - intros e He. destruct (H e He) as [d [Hd D]]. exists (d * e). split; [apply Rmult_lt_0_compat; auto|].
    intros x Hx. destruct (Rlt_le_dec (Rabs x) e); auto. specialize (D x r). nra.
  - intros B. destruct (H 1 ltac:(lra)) as [d [Hd D]]. exists (1 + Rabs B / d). intros x Hx.
    assert (0 <= Rabs B / d) by (apply Rmult_le_pos; [apply Rabs_pos|apply Rlt_le, Rinv_0_lt_compat; auto]).
    destruct (Rlt_le_dec (Rabs x) 1) as [L|L]; [lra|]. specialize (D x L). assert (A := Rle_abs B).
    enough (Rabs x <= Rabs B / d) by lra. apply (Rmult_le_reg_l d); auto.
    replace (d * (Rabs B / d)) with (Rabs B) by (field; lra). lra. Qed.
Lemma shape_even n : shape (fun x => x ^ (2 * S n)).
Proof. apply shape_by; [intros; apply even_power|]. intros e He. exists (e ^ (2 * n + 1)). split; [apply pow_lt; auto|].
  intros x Hx. replace (2 * S n)%nat with (2 * n + 1 + 1)%nat by lia. assert (A := Rabs_pos x).
  replace (x ^ (2 * n + 1 + 1)) with (Rabs x ^ (2 * n + 1 + 1)).
  - rewrite (pow_add _ (2 * n + 1) 1), pow_1. apply Rmult_le_compat_r; auto. apply pow_incr. lra.
  - replace (2 * n + 1 + 1)%nat with (2 * S n)%nat by lia. rewrite !pow_mult, pow2_abs. easy. Qed.
Lemma shape_rising g : (forall x y, x < y -> g x < g y) -> (forall x, g (- x) = - g x) -> shape (fun x => x * g x).
Proof. intros G O. assert (Z : g 0 = 0). { assert (A := O 0). rewrite Ropp_0 in A. lra. }
  assert (E : forall x, x * g x = Rabs x * g (Rabs x)). { intros x. unfold Rabs. destruct (Rcase_abs x); auto. rewrite O. ring. }
  assert (N : forall x, 0 <= x -> 0 <= g x). { intros x [H| <-]; [assert (A := G _ _ H)|]; lra. }
  apply shape_by.
  - intros x. rewrite E. apply Rmult_le_pos; [|apply N]; apply Rabs_pos.
  - intros e He. exists (g e). split; [assert (A := G _ _ He); lra|]. intros x Hx. rewrite E, Rmult_comm.
    apply Rmult_le_compat_l; [apply Rabs_pos|]. destruct Hx as [Hx| <-]; [apply Rlt_le, G, Hx|lra]. Qed.
Lemma shape_tanh : shape (fun x => x * tanh x).
Proof. apply shape_rising; [apply tanh_increasing|apply tanh_odd]. Qed.
Lemma shape_atan : shape (fun x => x * atan x).
Proof. apply shape_rising; [apply atan_increasing|apply atan_opp]. Qed.
Lemma sinh_rises x y : x < y -> sinh x < sinh y.
Proof. intros H. unfold sinh. assert (A := exp_increasing _ _ H). assert (B := exp_increasing (- y) (- x) ltac:(lra)). lra. Qed.
Lemma sinh_0 : sinh 0 = 0.
Proof. unfold sinh. rewrite Ropp_0, Rminus_eq_0. unfold Rdiv. apply Rmult_0_l. Qed.
Lemma tanh_nonneg x : 0 <= x -> 0 <= tanh x.
Proof. intros H. rewrite <- tanh_0. apply tanh_rises, H. Qed.
Lemma sinh_nonneg x : 0 <= x -> 0 <= sinh x.
Proof. intros [H| <-]; [|rewrite sinh_0; lra]. apply Rlt_le. rewrite <- sinh_0. apply sinh_rises, H. Qed.
Lemma atan_nonneg x : 0 <= x -> 0 <= atan x.
Proof. intros [H| <-]; [|rewrite atan_0; lra]. apply Rlt_le. rewrite <- atan_0. apply atan_increasing, H. Qed.
Lemma shape_sinh : shape (fun x => x * sinh x).
Proof. apply shape_rising; [apply sinh_rises|]. intros x. unfold sinh. rewrite Ropp_involutive. field. Qed.
Lemma shape_cube : shape (fun x => Rabs x * x ^ 2).
Proof. apply shape_by; [intros; apply Rmult_le_pos; [apply Rabs_pos|apply pow2_ge_0]|]. intros e He. exists (e ^ 2).
  split; [apply pow_lt; auto|]. intros x Hx. rewrite Rmult_comm, <- (pow2_abs x).
  apply Rmult_le_compat_l; [apply Rabs_pos|apply pow_incr; lra]. Qed.
Lemma vanishing_slope (g dg : R -> R) a b : (forall x, is_derive g x (dg x)) -> a <= b ->
  exists c, a <= c <= b /\ g b - g a = dg c * (b - a).
Proof. intros D H. destruct (MVT_gen g a b dg) as [c [Hc E]];
  rewrite ?Rmin_left, ?Rmax_right in * by lra.
  - intros; apply D. - intros. apply continuity_pt_filterlim, @ex_derive_continuous. eexists. apply D. - exists c. auto. Qed.
Lemma shape_exp : shape (fun x => exp x - x - 1).
Proof. apply shape_by; [apply exp_line|]. intros e He.
  assert (D : forall x, is_derive (fun x => exp x - x - 1) x (exp x - 1)) by (intros; auto_derive; auto; ring).
  set (h := e / 2). assert (P : 0 < h) by (unfold h; lra).
  assert (U : exp (- h) < 1) by (rewrite <- exp_0; apply exp_increasing; lra).
  assert (W : 1 < exp h) by (rewrite <- exp_0; apply exp_increasing; lra).
  exists (Rmin (exp h - 1) (1 - exp (- h)) / 2). split; [apply Rdiv_lt_0_compat; [apply Rmin_pos; lra|lra]|].
  intros x Hx. assert (A := Rmin_l (exp h - 1) (1 - exp (- h))). assert (B := Rmin_r (exp h - 1) (1 - exp (- h))).
  assert (Q : 0 < Rmin (exp h - 1) (1 - exp (- h))) by (apply Rmin_pos; lra). set (m := Rmin _ _) in *.
  destruct (Rle_lt_dec 0 x) as [S|S].
  - rewrite Rabs_pos_eq in * by auto. destruct (vanishing_slope _ _ h x D ltac:(unfold h; lra)) as [c [Hc E]].
    assert (exp h <= exp c) by (destruct Hc as [[?| ->] _]; [apply Rlt_le, exp_increasing; auto|lra]).
    assert (F := exp_line h). assert (h <= x / 2) by (unfold h; lra). nra.
  - rewrite Rabs_left in * by auto. destruct (vanishing_slope _ _ x (- h) D ltac:(unfold h; lra)) as [c [Hc E]].
    assert (exp c <= exp (- h)) by (destruct Hc as [_ [?| ->]]; [apply Rlt_le, exp_increasing; auto|lra]).
    assert (F := exp_line (- h)). assert (h <= - x / 2) by (unfold h; lra). nra. Qed.

(* cosh(s) - 1, sqrt(1 + s^2) - 1, |s| - ln(1 + |s|) *)
Lemma shape_above g h c : shape g -> 0 < c -> (forall x, c * g x <= h x) -> shape h.
Proof. intros [P [S L]] Hc H. assert (W : forall x, g x <= h x / c).
  { intros x. apply (Rmult_le_reg_l c); auto. replace (c * (h x / c)) with (h x) by (field; lra). apply H. }
  repeat split.
  - intros x. assert (A := P x). assert (B := H x). nra.
  - intros e He. destruct (S e He) as [d [Hd D]]. exists (c * d). split; [apply Rmult_lt_0_compat; auto|].
    intros x Hx. apply D. assert (A := H x). apply (Rmult_lt_reg_l c); auto. lra.
  - intros B. destruct (L (B / c)) as [M HM]. exists M. intros x Hx. apply HM. eapply Rle_trans; [apply W|].
    apply Rmult_le_compat_r; auto. apply Rlt_le, Rinv_0_lt_compat, Hc. Qed.
Lemma shape_cosh : shape (fun x => cosh x - 1).
Proof. apply (shape_above _ _ (/ 2) shape_exp); [lra|]. intros x. unfold cosh. assert (A := exp_line (- x)). lra. Qed.
Lemma cosh_above x : 1 <= cosh x.
Proof. assert (A := proj1 shape_cosh x). simpl in A. lra. Qed.
Lemma root_above x d e : 0 < e -> d = e / (3 + 3 * e) -> e <= Rabs x -> 1 + d * Rabs x <= sqrt (x ^ 2 + 1).
Proof. intros He Ed Hx. assert (D : 0 < d <= 1 / 3 /\ d <= e / 3).
  { subst d. split; [split|].
    - apply Rdiv_lt_0_compat; lra. - apply (Rmult_le_reg_r (3 + 3 * e)); [lra|]. replace (e / (3 + 3 * e) * (3 + 3 * e)) with e by (field; lra). lra.
    - apply (Rmult_le_reg_r (3 + 3 * e)); [lra|]. replace (e / (3 + 3 * e) * (3 + 3 * e)) with e by (field; lra). nra. }
  assert (A := Rabs_pos x). rewrite <- (sqrt_pow2 (1 + d * Rabs x)) by nra. apply sqrt_le_1_alt. rewrite <- (pow2_abs x).
  set (a := Rabs x) in *. enough (a * (2 * d + d * d * a) <= a * a) by nra. apply Rmult_le_compat_l; auto.
  assert (d * d <= 1 / 9) by nra. nra. Qed.
Lemma root_one x : 1 <= sqrt (x ^ 2 + 1).
Proof. rewrite <- sqrt_1 at 1. apply sqrt_le_1_alt. assert (A := pow2_ge_0 x). lra. Qed.
Lemma shape_root : shape (fun x => sqrt (x ^ 2 + 1) - 1).
Proof. apply shape_by; [intros x; assert (A := root_one x); lra|]. intros e He. exists (e / (3 + 3 * e)). split; [apply Rdiv_lt_0_compat; lra|].
  intros x Hx. assert (A := root_above x _ e He eq_refl Hx). lra. Qed.
Lemma soft_exp x : Rabs x - ln (1 + Rabs x) = exp (ln (1 + Rabs x)) - ln (1 + Rabs x) - 1.
Proof. assert (A := Rabs_pos x). rewrite exp_ln by lra. ring. Qed.
Lemma ln_above x : 0 <= ln (1 + Rabs x).
Proof. assert (A := Rabs_pos x). rewrite <- ln_1. apply ln_le; lra. Qed.
Lemma shape_soft : shape (fun x => Rabs x - ln (1 + Rabs x)).
Proof. destruct shape_exp as [P [S L]]. repeat split.
  - intros x. rewrite soft_exp. apply P.
  - intros e He. assert (0 < ln (1 + e)) by (rewrite <- ln_1; apply ln_increasing; lra). destruct (S _ H) as [d [Hd D]]. exists d. split; auto.
    intros x Hx. rewrite soft_exp in Hx. assert (A := D _ Hx). rewrite Rabs_pos_eq in A by apply ln_above. assert (B := Rabs_pos x).
    apply ln_lt_inv in A; lra.
  - intros B. destruct (L B) as [M HM]. exists (exp M). intros x Hx. rewrite soft_exp in Hx. assert (A := HM _ Hx).
    rewrite Rabs_pos_eq in A by apply ln_above. assert (C := Rabs_pos x). assert (exp (ln (1 + Rabs x)) <= exp M).
    { destruct A as [A| ->]; [apply Rlt_le, exp_increasing, A|lra]. } rewrite exp_ln in H by lra. lra. Qed.
(* rates of |s| s^2 and of |s| - ln(1 + |s|) *)
Lemma derive_flat (g : R -> R) : g 0 = 0 -> (forall x, Rabs x <= 1 -> Rabs (g x) <= x ^ 2) -> is_derive g 0 0.
Proof. intros Z H. apply is_derive_Reals. intros e He. assert (P : 0 < Rmin 1 e) by (apply Rmin_pos; lra).
  exists (mkposreal _ P). intros h Nh Hh. simpl in Hh. assert (A := Rmin_l 1 e). assert (B := Rmin_r 1 e).
  rewrite Rplus_0_l, Z, !Rminus_0_r. unfold Rdiv. rewrite Rabs_mult, Rabs_inv. assert (C := Rabs_pos_lt h Nh).
  apply (Rle_lt_trans _ (Rabs h)); [|lra]. apply (Rmult_le_reg_r (Rabs h)); auto. rewrite Rmult_assoc, Rinv_l by lra.
  assert (D := H h ltac:(lra)). rewrite <- (pow2_abs h) in D. lra. Qed.
Lemma derive_by_sides (g p m d : R -> R) : (forall x, 0 < x -> g x = p x) -> (forall x, x < 0 -> g x = m x) ->
  (forall x, 0 < x -> is_derive p x (d x)) -> (forall x, x < 0 -> is_derive m x (d x)) -> is_derive g 0 (d 0) ->
  forall x, is_derive g x (d x).
Proof. intros Gp Gm P M Z x. destruct (Rtotal_order x 0) as [H|[->|H]]; auto.
  - apply (is_derive_ext_loc m); auto. exists (mkposreal (- x) ltac:(lra)). intros y Hy. symmetry. apply Gm.
    change (Rabs (y - x) < - x) in Hy. apply Rabs_lt_between in Hy. lra.
  - apply (is_derive_ext_loc p); auto. exists (mkposreal x H). intros y Hy. symmetry. apply Gp.
    change (Rabs (y - x) < x) in Hy. apply Rabs_lt_between in Hy. lra. Qed.
Lemma derive_cube : forall x, is_derive (fun x => Rabs x * x ^ 2) x (3 * Rabs x * x).
Proof. apply (derive_by_sides _ (fun x => x * x ^ 2) (fun x => - x * x ^ 2)).
  - intros x H. rewrite Rabs_pos_eq by lra. ring. - intros x H. rewrite Rabs_left by lra. ring.
  - intros x H. rewrite Rabs_pos_eq by lra. auto_derive; auto; ring. - intros x H. rewrite Rabs_left by lra. auto_derive; auto; ring.
  - rewrite Rmult_0_r. apply derive_flat; [ring|]. intros x H. rewrite Rabs_mult, Rabs_Rabsolu, (Rabs_pos_eq (x ^ 2)) by apply pow2_ge_0.
    assert (A := pow2_ge_0 x). nra. Qed.
Lemma derive_soft : forall x, is_derive (fun x => Rabs x - ln (1 + Rabs x)) x (x / (1 + Rabs x)).
Proof. apply (derive_by_sides _ (fun x => x - ln (1 + x)) (fun x => - x - ln (1 + - x))).
  - intros x H. rewrite Rabs_pos_eq by lra. easy. - intros x H. rewrite Rabs_left by lra. easy.
  - intros x H. rewrite Rabs_pos_eq by lra. auto_derive; [lra|field; lra]. - intros x H. rewrite Rabs_left by lra. auto_derive; [lra|field; lra].
  - unfold Rdiv. rewrite Rmult_0_l. apply derive_flat; [rewrite Rabs_R0, Rplus_0_r, ln_1; ring|]. intros x _. destruct shape_soft as [P _].
    rewrite Rabs_pos_eq by apply P. rewrite <- (pow2_abs x). assert (A := Rabs_pos x). set (a := Rabs x) in *.
    assert (B := exp_line (- ln (1 + a))). rewrite exp_Ropp, exp_ln in B by lra.
    assert (C : / (1 + a) <= 1 - a + a ^ 2). { apply (Rmult_le_reg_l (1 + a)); [lra|]. rewrite Rinv_r by lra. assert (0 <= a ^ 3) by (apply pow_le; auto). nra. }
    lra. Qed.
Lemma follows_cube T f df : follows T f df -> follows T (fun t => Rabs (f t) * f t ^ 2) (fun t => df t * (3 * Rabs (f t) * f t)).
Proof. apply (follows_in T (fun x => Rabs x * x ^ 2) (fun x => 3 * Rabs x * x)). intros. apply derive_cube. Qed.
Lemma follows_soft T f df : follows T f df -> follows T (fun t => Rabs (f t) - ln (1 + Rabs (f t))) (fun t => df t * (f t / (1 + Rabs (f t)))).
Proof. apply (follows_in T (fun x => Rabs x - ln (1 + Rabs x)) (fun x => x / (1 + Rabs x))). intros. apply derive_soft. Qed.
(* functions that rise *)
Lemma rising_product g a b : (forall x y, x < y -> g x < g y) -> 0 <= (a - b) * (g a - g b).
Proof. intros G. destruct (Rtotal_order a b) as [H|[->|H]]; [|lra|]; assert (A := G _ _ H); nra. Qed.
Lemma tanh_below x : 0 <= tanh x * (x - tanh x).
Proof. assert (D : forall u v, u <= v -> u - tanh u <= v - tanh v).
  { intros u v H. destruct (vanishing_slope (fun x => x - tanh x) (fun x => tanh x ^ 2) u v) as [c [_ E]]; auto.
    - intros y. replace (tanh y ^ 2) with (1 - (1 - tanh y ^ 2)) by ring. apply @is_derive_minus; [apply @is_derive_id|apply derive_tanh].
    - assert (A := pow2_ge_0 (tanh c)). nra. }
  assert (Z := tanh_0). destruct (Rle_lt_dec 0 x) as [H|H].
  - assert (A := D 0 x H). assert (B := tanh_rises 0 x H). nra.
  - assert (A := D x 0 ltac:(lra)). assert (B := tanh_rises x 0 ltac:(lra)). nra. Qed.
Lemma exp_falls u : u <= 0 -> exp u <= 1.
Proof. intros [H| ->]; [|rewrite exp_0; lra]. rewrite <- exp_0. apply Rlt_le, exp_increasing, H. Qed.
Lemma ln_nonneg a : 1 <= a -> 0 <= ln a.
Proof. intros H. rewrite <- ln_1. apply ln_le; lra. Qed.
Lemma negative_square b : 0 > b -> 0 < b ^ 2. Proof. nra. Qed.
Lemma negative_inverse b : 0 > b -> 0 < -1 / b.
Proof. intros H. replace (-1 / b) with (/ - b) by (field; lra). apply Rinv_0_lt_compat. lra. Qed.

Section Shapes.
Variables (T : Rbar) (g : R -> R) (c : R).
Hypotheses (G : shape g) (P : 0 < c).
Lemma bounded_shape B f : (forall t, on T t -> c * g (f t) <= B) -> bounded T f.
Proof. destruct G as [_ [_ H]]. destruct (H (B / c)) as [M HM]. intros F. exists M. intros t Ht. apply HM.
  apply (Rmult_le_reg_l c); auto. replace (c * (B / c)) with B by (field; lra). auto. Qed.
Lemma fades_shape f : fades (fun t => c * g (f t)) -> fades f.
Proof. destruct G as [G0 [H _]]. intros F. apply is_lim_spec. intros [eps He]. apply is_lim_spec in F.
  destruct (H eps He) as [d [Hd D]]. assert (Q : 0 < c * d) by (apply Rmult_lt_0_compat; auto).
  destruct (F (mkposreal _ Q)) as [N HN]. exists N. intros t Ht. simpl. rewrite Rminus_0_r. apply D.
  assert (A := HN t Ht). simpl in A. rewrite Rminus_0_r, Rabs_pos_eq in A by (apply Rmult_le_pos; [lra|auto]).
  apply (Rmult_lt_reg_l c); auto. Qed.
End Shapes.

(* --- limits of a run that may end: nothing is said if T is finite --- *)
Definition vanishes (T : Rbar) (f : R -> R) : Prop := T = p_infty -> fades f.
Section Vanishing.
Variable T : Rbar.
(* a part h of what V loses *)
Lemma vanishes_value V dV h : follows T V dV -> (forall t, on T t -> 0 <= V t) -> (forall t, on T t -> dV t <= - h t) ->
  (forall t, on T t -> 0 <= h t) -> Lipschitz T h -> vanishes T h.
Proof. intros F V0 D H L ->. apply (barbalat V dV); auto. intros t Ht. apply D, on_all, Rlt_le, Ht. Qed.
Lemma vanishes_shape g f c : shape g -> 0 < c -> vanishes T (fun t => c * g (f t)) -> vanishes T f.
Proof. intros G P F E. apply (fades_shape g c); auto. Qed.
Lemma vanishes_of_abs f : vanishes T (fun t => Rabs (f t)) -> vanishes T f.
Proof. intros F E. apply fades_abs; auto. Qed.
Lemma vanishes_next q dq : vanishes T q -> follows T q dq -> Lipschitz T dq -> vanishes T dq.
Proof. intros Q F L ->. apply (barbalat_next q); auto. Qed.
Lemma vanishes_ext f g : (forall t, on T t -> f t = g t) -> vanishes T f -> vanishes T g.
Proof. intros E H ->. apply (fades_ext f); auto. Qed.
Lemma vanishes_zero : vanishes T (fun _ => 0).
Proof. intros _. apply fades_zero. Qed.
Lemma vanishes_plus f g : vanishes T f -> vanishes T g -> vanishes T (fun t => f t + g t).
Proof. intros F G E. apply fades_plus; auto. Qed.
Lemma vanishes_minus f g : vanishes T f -> vanishes T g -> vanishes T (fun t => f t - g t).
Proof. intros F G E. apply fades_minus; auto. Qed.
Lemma vanishes_opp f : vanishes T f -> vanishes T (fun t => - f t).
Proof. intros F E. apply fades_opp; auto. Qed.
Lemma vanishes_left f g : vanishes T f -> bounded T g -> vanishes T (fun t => f t * g t).
Proof. intros F G ->. apply fades_left; auto. Qed.
Lemma vanishes_right f g : bounded T f -> vanishes T g -> vanishes T (fun t => f t * g t).
Proof. intros F G ->. apply fades_right; auto. Qed.
Lemma vanishes_pow n f : bounded T f -> vanishes T f -> vanishes T (fun t => f t ^ S n).
Proof. intros B F ->. apply fades_pow; auto. Qed.
Lemma vanishes_root n f : vanishes T (fun t => f t ^ S n) -> vanishes T f.
Proof. intros F E. apply (fades_root n); auto. Qed.
End Vanishing.
(* functions that are continuous and zero at zero *)
Definition through (g : R -> R) : Prop := continuous g 0 /\ g 0 = 0.
Lemma through_by (g : R -> R) : ex_derive g 0 -> g 0 = 0 -> through g.
Proof. intros D Z. split; [apply @ex_derive_continuous, D|exact Z]. Qed.
Lemma through_sin : through sin.
Proof. apply through_by; [auto_derive; auto|apply sin_0]. Qed.
Lemma through_tanh : through tanh.
Proof. apply through_by; [eexists; apply derive_tanh|apply tanh_0]. Qed.
Lemma through_sinh : through sinh.
Proof. apply through_by; [eexists; apply derive_sinh|apply sinh_0]. Qed.
Lemma through_atan : through atan.
Proof. apply through_by; [eexists; apply derive_atan|apply atan_0]. Qed.
Lemma through_cos : through (fun x => 1 - cos x).
Proof. apply through_by; [auto_derive; auto|rewrite cos_0; ring]. Qed.
Lemma through_cosh : through (fun x => cosh x - 1).
Proof. apply through_by; [eexists; apply @is_derive_minus; [apply derive_cosh|apply @is_derive_const]|rewrite cosh_0; ring]. Qed.
Lemma through_exp : through (fun x => exp x - x - 1).
Proof. apply through_by; [auto_derive; auto|rewrite exp_0; ring]. Qed.
Lemma through_root : through (fun x => sqrt (x ^ 2 + 1) - 1).
Proof. apply through_by; [auto_derive; nra|]. rewrite pow_ne_zero, Rplus_0_l, sqrt_1 by lia. ring. Qed.
Lemma through_soft : through (fun x => Rabs x - ln (1 + Rabs x)).
Proof. apply through_by; [eexists; apply derive_soft|]. rewrite Rabs_R0, Rplus_0_r, ln_1. ring. Qed.
Lemma vanishes_at (g : R -> R) T f : through g -> vanishes T f -> vanishes T (fun t => g (f t)).
Proof. intros [C Z] F E. apply is_lim_spec. intros eps. assert (L := F E). apply is_lim_spec in L.
  destruct (C (ball (g 0) eps) (locally_ball _ _)) as [d Hd]. destruct (L d) as [N HN]. exists N. intros t Ht. simpl in *.
  assert (A := Hd (f t) (HN t Ht)). change (Rabs (g (f t) - g 0) < eps) in A. rewrite Z in A. exact A. Qed.
(* of a function that rises through zero *)
Lemma vanishes_of_rising g T f : (forall x y, x < y -> g x < g y) -> g 0 = 0 -> vanishes T (fun t => g (f t)) -> vanishes T f.
Proof. intros G Z F E. assert (L := F E). apply is_lim_spec. intros eps. apply is_lim_spec in L. assert (He := cond_pos eps).
  assert (A := G 0 eps He). assert (B := G (- eps) 0 ltac:(lra)).
  assert (P : 0 < Rmin (g eps) (- g (- eps))) by (apply Rmin_pos; lra).
  destruct (L (mkposreal _ P)) as [N HN]. exists N. intros t Ht. assert (Q := HN t Ht). simpl in *. rewrite Rminus_0_r in *.
  assert (C := Rmin_l (g eps) (- g (- eps))). assert (D := Rmin_r (g eps) (- g (- eps))). apply Rabs_lt_between in Q. apply Rabs_lt_between.
  split; apply Rnot_le_lt; intros [H|H].
  - assert (K := G _ _ H). lra. - subst. rewrite <- H in D. rewrite <- H in Q. lra.
  - assert (K := G _ _ H). lra. - rewrite <- H in Q. lra. Qed.
Lemma vanishes_of_tanh T f : vanishes T (fun t => tanh (f t)) -> vanishes T f.
Proof. apply (vanishes_of_rising tanh); [apply tanh_increasing|apply tanh_0]. Qed.
Lemma vanishes_of_sinh T f : vanishes T (fun t => sinh (f t)) -> vanishes T f.
Proof. apply (vanishes_of_rising sinh); [apply sinh_rises|apply sinh_0]. Qed.
Lemma vanishes_of_atan T f : vanishes T (fun t => atan (f t)) -> vanishes T f.
Proof. apply (vanishes_of_rising atan); [apply atan_increasing|apply atan_0]. Qed.



(* --- runs that begin near the rest stay near it --- *)
Section Small.
Variables (I : Type) (near : R -> I -> Prop) (now : I -> R -> Prop).
Hypothesis near_le : forall d e i, d <= e -> near d i -> near e i.
Definition small (f : I -> R -> R) : Prop := forall eps, 0 < eps -> exists delta, 0 < delta /\
  forall i, near delta i -> forall t, now i t -> Rabs (f i t) < eps.

Lemma small_le M f g : 0 < M -> (forall i t, now i t -> Rabs (f i t) <= M * Rabs (g i t)) -> small g -> small f.
Proof. intros HM H G eps He. destruct (G (eps / M)) as [d [Hd D]]; [apply Rdiv_lt_0_compat; auto|].
  exists d. split; auto. intros i Hi t Ht. assert (A := D i Hi t Ht). assert (B := H i t Ht).
  apply (Rmult_lt_compat_l M) in A; auto. replace (M * (eps / M)) with eps in A by (field; lra). lra. Qed.
Lemma small_ext f g : (forall i t, now i t -> f i t = g i t) -> small f -> small g.
Proof. intros E. apply (small_le 1); [lra|]. intros. rewrite E; auto. lra. Qed.
Lemma small_plus f g : small f -> small g -> small (fun i t => f i t + g i t).
Proof. intros F G eps He. destruct (F (eps / 2) ltac:(lra)) as [d [Hd D]], (G (eps / 2) ltac:(lra)) as [e [H E]].
  exists (Rmin d e). split; [apply Rmin_pos; auto|]. intros i Hi t Ht.
  assert (A := D i (near_le _ _ i (Rmin_l d e) Hi) t Ht). assert (B := E i (near_le _ _ i (Rmin_r d e) Hi) t Ht).
  eapply Rle_lt_trans; [apply Rabs_triang|]. lra. Qed.
Lemma small_zero : small (fun _ _ => 0).
Proof. intros eps He. exists 1. split; [lra|]. intros. rewrite Rabs_R0. auto. Qed.
Lemma small_scal a f : small f -> small (fun i t => a * f i t).
Proof. apply (small_le (Rabs a + 1)). - assert (A := Rabs_pos a). lra.
  - intros. rewrite Rabs_mult. assert (A := Rabs_pos (f i t)). nra. Qed.
Lemma small_share a f : small f -> small (fun i t => f i t / a).
Proof. intros F. apply (small_ext (fun i t => / a * f i t)); [intros; unfold Rdiv; ring|apply small_scal, F]. Qed.
Lemma small_opp f : small f -> small (fun i t => - f i t).
Proof. apply (small_le 1); [lra|]. intros. rewrite Rabs_Ropp. lra. Qed.
Lemma small_abs f : small f -> small (fun i t => Rabs (f i t)).
Proof. apply (small_le 1); [lra|]. intros. rewrite Rabs_Rabsolu. lra. Qed.
Lemma small_minus f g : small f -> small g -> small (fun i t => f i t - g i t).
Proof. intros F G. apply (small_plus f (fun i t => - g i t)); auto using small_opp. Qed.
Lemma small_mult f g : small f -> small g -> small (fun i t => f i t * g i t).
Proof. intros F G eps He. destruct (F 1 ltac:(lra)) as [d [Hd D]], (G eps He) as [e [H E]].
  exists (Rmin d e). split; [apply Rmin_pos; auto|]. intros i Hi t Ht.
  assert (A := D i (near_le _ _ i (Rmin_l d e) Hi) t Ht). assert (B := E i (near_le _ _ i (Rmin_r d e) Hi) t Ht).
  rewrite Rabs_mult. assert (P := Rabs_pos (f i t)). assert (Q := Rabs_pos (g i t)). nra. Qed.
Lemma small_pow n f : small f -> small (fun i t => f i t ^ S n).
Proof. intros F. induction n; [apply (small_ext f); auto; intros; ring|].
  apply (small_mult f (fun i t => f i t ^ S n)); auto. Qed.
Lemma small_at (g : R -> R) f : through g -> small f -> small (fun i t => g (f i t)).
Proof. intros [C Z] F eps He. destruct (C (ball (g 0) (mkposreal eps He)) (locally_ball _ _)) as [d Hd].
  destruct (F d (cond_pos d)) as [e [H E]]. exists e. split; auto. intros i Hi t Ht.
  assert (A : ball 0 d (f i t)). { change (Rabs (f i t - 0) < d). rewrite Rminus_0_r. auto. }
  assert (B := Hd _ A). change (Rabs (g (f i t) - g 0) < eps) in B. rewrite Z, Rminus_0_r in B. auto. Qed.
Lemma small_shape c g f v : shape g -> 0 < c -> (forall i t, now i t -> c * g (f i t) <= v i t) -> small v -> small f.
Proof. intros [G0 [H _]] P B G eps He. destruct (H eps He) as [d [Hd D]].
  destruct (G (c * d)) as [e [Pe E]]; [apply Rmult_lt_0_compat; auto|]. exists e. split; auto. intros i Hi t Ht. apply D.
  assert (A := E i Hi t Ht). assert (S := B i t Ht). assert (L := Rle_abs (v i t)). apply (Rmult_lt_reg_l c); auto. lra. Qed.
End Small.

Lemma product_between a b : -1 <= a <= 1 -> -1 <= b <= 1 -> -1 <= a * b <= 1. Proof. nra. Qed.
Lemma below_left a b c : a <= b -> 0 <= c -> a <= b + c. Proof. lra. Qed.
Lemma below_right a b c : a <= c -> 0 <= b -> a <= b + c. Proof. lra. Qed.
(* --- tactics: each follows the form of its goal, and searches for nothing else --- *)
Create HintDb clpt.
(* a fact that is not yet among the assumptions *)
Tactic Notation "know" constr(P) "by" tactic3(proof) :=
  lazymatch goal with A : P |- _ => fail | _ => assert P by proof end.
(* by the ranges of functions and of time *)
Ltac above :=
  repeat match goal with
  | A : on _ ?t |- _ => know (0 <= t) by apply A
  | |- context [sin ?u] => know (-1 <= sin u <= 1) by apply SIN_bound
  | |- context [cos ?u] => know (-1 <= cos u <= 1) by apply COS_bound
  | |- context [tanh ?u] => know (-1 <= tanh u <= 1) by apply tanh_between
  | |- context [cosh ?u] => know (1 <= cosh u) by apply cosh_above
  | |- context [exp ?u] => know (0 < exp u) by apply exp_pos
  | |- context [exp ?u] => know (exp u <= 1) by (apply exp_falls; lra)
  end; first [lra | repeat match goal with A : -1 <= ?a <= 1, B : -1 <= ?b <= 1 |- _ =>
    lazymatch a with _ * _ => fail | _ => lazymatch b with _ * _ => fail | _ =>
      know (-1 <= a * b <= 1) by (apply product_between; assumption) end end end; lra].
Ltac rising := match goal with |- 0 <= _ * (?g _ - _) => apply (rising_product g);
  first [apply exp_increasing | apply tanh_increasing | apply sinh_rises | apply atan_increasing] end.
Ltac positive :=
  first [assumption |
  lazymatch goal with
  | |- 0 < ?a * ?b => first [apply Rmult_lt_0_compat; positive | lra]
  | |- 0 < ?a / ?b => first [apply Rdiv_lt_0_compat; positive | apply negative_inverse; assumption]
  | |- 0 < / ?a => apply Rinv_0_lt_compat; positive
  | |- 0 < ?a + ?b => first [apply Rplus_lt_le_0_compat; [positive|nonneg] | apply Rplus_le_lt_0_compat; [nonneg|positive] | above]
  | |- 0 < _ ^ _ => first [apply pow_lt; positive | apply negative_square; assumption]
  | |- 0 < exp _ => apply exp_pos
  | |- 0 < sqrt _ => apply sqrt_lt_R0; positive
  | |- 0 < cosh _ => apply (Rlt_le_trans _ 1); [lra|apply cosh_above]
  | |- _ => first [lra | above | solve [auto with clpt nocore]]
  end]
with nonneg :=
  first [assumption |
  lazymatch goal with
  | |- 0 <= ?a * tanh ?a => apply (proj1 shape_tanh)
  | |- 0 <= ?a * sinh ?a => apply (proj1 shape_sinh)
  | |- 0 <= ?a * atan ?a => apply (proj1 shape_atan)
  | |- 0 <= tanh ?a * (?a - tanh ?a) => apply tanh_below
  | |- 0 <= (?a - tanh ?a) * tanh ?a => rewrite Rmult_comm; apply tanh_below
  | |- 0 <= 1 - cos _ => apply one_minus_cos
  | |- 0 <= 1 + cos _ => apply one_plus_cos
  | |- 0 <= cosh _ - 1 => apply (proj1 shape_cosh)
  | |- 0 <= sqrt _ - 1 => apply (proj1 shape_root)
  | |- 0 <= Rabs ?a - ln (1 + Rabs ?a) => apply (proj1 shape_soft)
  | |- 0 <= exp ?a - ?a - 1 => apply exp_line
  | |- 0 <= exp ?a - 1 - ?a => assert (L := exp_line a); lra
  | |- 0 <= - 1 - ?a + exp ?a => assert (L := exp_line a); lra
  | |- 0 <= ?a + ?b => first [apply Rplus_le_le_0_compat; nonneg | above | solve [auto with clpt nocore]]
  | |- 0 <= ?a - ?b => first [above | solve [auto with clpt nocore]]
  | |- 0 <= ?a * ?a => apply Rle_0_sqr
  | |- 0 <= ?a * ?b => first [apply Rmult_le_pos; nonneg | rising | lra]
  | |- 0 <= ?a / ?b => first [apply Rmult_le_pos; [nonneg|apply Rlt_le, Rinv_0_lt_compat; positive] | apply Rlt_le; positive
      | solve [auto with clpt nocore]]
  | |- 0 <= / ?a => apply Rlt_le, Rinv_0_lt_compat; positive
  | |- 0 <= ?a ^ ?n =>
      let k := eval compute in (Nat.div2 n) in let odd := eval compute in (Nat.odd n) in
      lazymatch odd with false => exact (even_power k a) | true => apply pow_le; nonneg end
  | |- 0 <= Rabs _ => apply Rabs_pos
  | |- 0 <= sqrt _ => apply sqrt_pos
  | |- 0 <= exp _ => apply Rlt_le, exp_pos
  | |- 0 <= tanh _ => apply tanh_nonneg; nonneg
  | |- 0 <= sinh _ => apply sinh_nonneg; nonneg
  | |- 0 <= atan _ => apply atan_nonneg; nonneg
  | |- 0 <= ln _ => apply ln_nonneg; first [below | above]
  | |- _ => first [lra | above | apply Rlt_le; positive | solve [auto with clpt nocore]]
  end]
(* a term of a sum *)
with below := first [apply Rle_refl | apply below_left; [below|nonneg] | apply below_right; [below|nonneg]].
Ltac nonzero := first [assumption | apply not_eq_sym, Rlt_not_eq; positive | apply Rlt_not_eq; lra | apply Rgt_not_eq; nra].
Ltac leaf := first [assumption | eassumption | solve [eauto with clpt nocore]].
Ltac follow :=
  lazymatch goal with
  | |- follows _ (fun _ => ?a) _ => apply follows_const
  | |- follows _ (fun t => t) _ => apply follows_time
  | |- follows _ (fun t => Rabs (@?f t) * (@?f t) ^ 2) _ => eapply (follows_cube _ f _); follow
  | |- follows _ (fun t => Rabs (@?f t) - ln (1 + Rabs (@?f t))) _ => eapply (follows_soft _ f _); follow
  | |- follows _ (fun t => @?f t + @?g t) _ => eapply (follows_plus _ f _ g _); follow
  | |- follows _ (fun t => @?f t - @?g t) _ => eapply (follows_minus _ f _ g _); follow
  | |- follows _ (fun t => @?f t * @?g t) _ => eapply (follows_mult _ f _ g _); follow
  | |- follows _ (fun t => - @?f t) _ => eapply (follows_opp _ f _); follow
  | |- follows _ (fun t => (@?f t) ^ ?n) _ => eapply (follows_pow _ n f _); follow
  | |- follows _ (fun t => @?f t / @?g t) _ => eapply (follows_div _ f _ g _); [intros; nonzero|follow|follow]
  | |- follows _ (fun t => / @?f t) _ => eapply (follows_inv _ f _); [intros; nonzero|follow]
  | |- follows _ (fun t => sin (@?f t)) _ => eapply (follows_sin _ f _); follow
  | |- follows _ (fun t => cos (@?f t)) _ => eapply (follows_cos _ f _); follow
  | |- follows _ (fun t => tanh (@?f t)) _ => eapply (follows_tanh _ f _); follow
  | |- follows _ (fun t => sinh (@?f t)) _ => eapply (follows_sinh _ f _); follow
  | |- follows _ (fun t => cosh (@?f t)) _ => eapply (follows_cosh _ f _); follow
  | |- follows _ (fun t => atan (@?f t)) _ => eapply (follows_atan _ f _); follow
  | |- follows _ (fun t => exp (@?f t)) _ => eapply (follows_exp _ f _); follow
  | |- follows _ (fun t => sqrt (@?f t)) _ => eapply (follows_sqrt _ f _); [intros; positive|follow]
  | |- follows _ (fun t => ln (@?f t)) _ => eapply (follows_ln _ f _); [intros; positive|follow]
  | |- follows _ (fun t => ?f t) _ => change (fun t => f t) with f; leaf
  | |- _ => leaf
  end.
Ltac bounded_inverse f :=
  match f with
  | (fun t => @?g t + ?c) => apply (bounded_inv _ c f); [positive|intros t Ht; below]
  | (fun t => ?c + @?g t) => apply (bounded_inv _ c f); [positive|intros t Ht; below]
  | (fun t => sqrt (@?g t + ?c)) => apply (bounded_inv _ (sqrt c) f); [positive|intros t Ht; apply sqrt_le_1_alt; below]
  | (fun t => sqrt (@?g t)) => apply (bounded_inv _ (sqrt 1) f); [positive|intros t Ht; apply sqrt_le_1_alt; below]
  | (fun t => (@?g t) ^ ?n) => apply (bounded_ext _ (fun t => (/ g t) ^ n)); [intros t Ht; field; nonzero|apply (bounded_pow _ n (fun t => / g t)); bnd]
  | (fun t => @?g t * @?h t) => apply (bounded_ext _ (fun t => / g t * / h t)); [intros t Ht; field; repeat split; nonzero|bnd]
  | _ => apply bounded_const
  end
with bnd := first [solve [eauto with clpt nocore] |
  lazymatch goal with
  | |- bounded _ (fun _ => ?a) => apply bounded_const
  | |- bounded _ (fun t => @?f t + @?g t) => apply (bounded_plus _ f g); bnd
  | |- bounded _ (fun t => @?f t - @?g t) => apply (bounded_minus _ f g); bnd
  | |- bounded _ (fun t => @?f t * @?g t) => apply (bounded_mult _ f g); bnd
  | |- bounded _ (fun t => @?f t / @?g t) => apply (bounded_mult _ f (fun t => / g t)); bnd
  | |- bounded _ (fun t => - @?f t) => apply (bounded_opp _ f); bnd
  | |- bounded _ (fun t => (@?f t) ^ ?n) => apply (bounded_pow _ n f); bnd
  | |- bounded _ (fun t => / exp (@?f t)) => apply (bounded_inv_exp _ f); bnd
  | |- bounded _ (fun t => / @?f t) => first [leaf | bounded_inverse f
      | apply (bounded_inv _ 1 f); [lra|intros t Ht; above] | apply (bounded_inv _ (/ 100) f); [lra|intros t Ht; above]]
  | |- bounded _ (fun t => sin (@?f t)) => apply (bounded_sin _ f)
  | |- bounded _ (fun t => cos (@?f t)) => apply (bounded_cos _ f)
  | |- bounded _ (fun t => tanh (@?f t)) => apply (bounded_tanh _ f)
  | |- bounded _ (fun t => sinh (@?f t)) => apply (bounded_sinh _ f); bnd
  | |- bounded _ (fun t => cosh (@?f t)) => apply (bounded_cosh _ f); bnd
  | |- bounded _ (fun t => atan (@?f t)) => apply (bounded_atan _ f)
  | |- bounded _ (fun t => exp (@?f t)) => apply (bounded_exp _ f); bnd
  | |- bounded _ (fun t => sqrt (@?f t)) => apply (bounded_sqrt _ f); bnd
  | |- bounded _ (fun t => Rabs (@?f t)) => apply (bounded_abs _ f); bnd
  | |- bounded _ (fun t => ?f t) => change (fun t => f t) with f; leaf
  | |- _ => leaf
  end].
Ltac lip :=
  lazymatch goal with
  | |- Lipschitz _ (fun _ => ?a) => apply Lipschitz_const
  | |- Lipschitz _ (fun t => @?f t + @?g t) => apply (Lipschitz_plus _ f g); lip
  | |- Lipschitz _ (fun t => @?f t - @?g t) => apply (Lipschitz_minus _ f g); lip
  | |- Lipschitz _ (fun t => / @?f t) => first [eapply Lipschitz_rate; [follow|bnd] | lazymatch f with
      | (fun t => _ + ?c) => apply (Lipschitz_inv _ c f); [positive|intros t Ht; below|lip] end]
  | |- Lipschitz _ (fun t => exp (@?f t)) => eapply Lipschitz_rate; [follow|bnd]
  | |- Lipschitz _ (fun t => @?f t * @?g t) => lazymatch f with
      | (fun _ => ?a) => apply (Lipschitz_scal _ a g); lip
      | _ => lazymatch g with
        | (fun _ => ?a) => apply (Lipschitz_times _ a f); lip
        | _ => apply (Lipschitz_mult _ f g); [bnd|bnd|lip|lip]
        end
      end
  | |- Lipschitz _ (fun t => @?f t / @?g t) => lazymatch g with
      | (fun _ => ?a) => apply (Lipschitz_times _ (/ a) f); lip
      | _ => apply (Lipschitz_mult _ f (fun t => / g t)); [bnd|bnd|lip|lip]
      end
  | |- Lipschitz _ (fun t => - @?f t) => apply (Lipschitz_opp _ f); lip
  | |- Lipschitz _ (fun t => (@?f t) ^ ?n) => apply (Lipschitz_pow _ n f); [bnd|lip]
  | |- Lipschitz _ (fun t => sin (@?f t)) => apply (Lipschitz_sin _ f); lip
  | |- Lipschitz _ (fun t => cos (@?f t)) => apply (Lipschitz_cos _ f); lip
  | |- Lipschitz _ (fun t => tanh (@?f t)) => apply (Lipschitz_tanh _ f); lip
  | |- Lipschitz _ (fun t => atan (@?f t)) => apply (Lipschitz_atan _ f); lip
  | |- Lipschitz _ (fun t => Rabs (@?f t)) => apply (Lipschitz_abs _ f); lip
  | |- Lipschitz _ (fun t => t) => apply Lipschitz_time
  | |- Lipschitz _ (fun t => ?f t) => change (fun t => f t) with f; first [leaf | eapply Lipschitz_rate; [follow|bnd]]
  | |- _ => first [leaf | eapply Lipschitz_rate; [follow|bnd]]
  end.
Ltac van :=
  first [leaf | lazymatch goal with
  | |- vanishes _ (fun _ => 0) => apply vanishes_zero
  | |- vanishes _ (fun t => @?f t + @?g t) => apply (vanishes_plus _ f g); van
  | |- vanishes _ (fun t => @?f t - @?g t) => apply (vanishes_minus _ f g); van
  | |- vanishes _ (fun t => - @?f t) => apply (vanishes_opp _ f); van
  | |- vanishes _ (fun t => @?f t * @?g t) =>
      first [apply (vanishes_left _ f g); [van|bnd] | apply (vanishes_right _ f g); [bnd|van]]
  | |- vanishes _ (fun t => @?f t / @?g t) => apply (vanishes_left _ f (fun t => / g t)); [van|bnd]
  | |- vanishes _ (fun t => (@?f t) ^ ?n) =>
      let k := eval compute in (pred n) in apply (vanishes_pow _ k f); [bnd|van]
  | |- vanishes _ (fun t => sin (@?f t)) => apply (vanishes_at sin _ f through_sin); van
  | |- vanishes _ (fun t => tanh (@?f t)) => apply (vanishes_at tanh _ f through_tanh); van
  | |- vanishes _ (fun t => sinh (@?f t)) => apply (vanishes_at sinh _ f through_sinh); van
  | |- vanishes _ (fun t => atan (@?f t)) => apply (vanishes_at atan _ f through_atan); van
  | |- vanishes _ (fun t => ?f t) => change (fun t => f t) with f; leaf
  end].
(* an identity of fractions, with at most two squares of sines, roots or absolute values *)
Ltac tidy := cbn [Z.of_nat Pos.of_succ_nat Pos.succ pred].
Ltac field_with := field; repeat split; nonzero.
Ltac square_of :=
  match goal with
  | |- context [sin ?u] => know (sin u ^ 2 = 1 - cos u ^ 2) by apply sin_square
  | |- context [Rabs ?u] => know (Rabs u ^ 2 = u ^ 2) by apply pow2_abs
  | |- context [sqrt ?u] => know (sqrt u ^ 2 = u) by (apply pow2_sqrt; nonneg)
  end.
Ltac ring_of :=
  match goal with
  | A : _ ^ 2 = _, B : _ ^ 2 = _ |- _ => first [ring [A B] | field_simplify_eq; [ring [A B]|repeat split; nonzero..]]
  | A : _ ^ 2 = _ |- _ => first [ring [A] | field_simplify_eq; [ring [A]|repeat split; nonzero..]]
  end.
Lemma exp_inverse a b : a + b = 0 -> exp a = / exp b.
Proof. intros H. rewrite <- exp_Ropp. f_equal. lra. Qed.
Lemma exp_times n a : exp (IZR (Z.of_nat n) * a) = exp a ^ n.
Proof. rewrite <- INR_IZR_INZ. induction n; [rewrite Rmult_0_l; apply exp_0|].
  rewrite S_INR, Rmult_plus_distr_r, Rmult_1_l, exp_plus, IHn. simpl. ring. Qed.
Lemma exp_times_less n a : exp (- IZR (Z.of_nat n) * a) = / exp a ^ n.
Proof. rewrite <- exp_times, <- exp_Ropp. f_equal. ring. Qed.
Ltac exponentials := rewrite ?exp_plus; repeat match goal with
  | |- context [exp (IZR (Zpos ?p) * ?a)] => let n := eval compute in (Pos.to_nat p) in
      change (exp (IZR (Zpos p) * a)) with (exp (IZR (Z.of_nat n) * a)); rewrite (exp_times n a)
  | |- context [exp (IZR (Zneg ?p) * ?a)] => let n := eval compute in (Pos.to_nat p) in
      change (exp (IZR (Zneg p) * a)) with (exp (- IZR (Z.of_nat n) * a)); rewrite (exp_times_less n a)
  end; repeat match goal with
  | |- context [exp ?a] => match goal with |- context [exp ?b] => rewrite (exp_inverse a b) by lra end end.
Ltac equal := tidy; first [ring | field_with | square_of; first [ring_of | square_of; ring_of] | exponentials; field_with
  | unfold tanh; field_with].

(* --- proofs of files --- *)
Ltac shape_of := first [exact shape_tanh | exact shape_cube | exact shape_exp | exact shape_cosh | exact shape_root
  | exact shape_soft | exact shape_sinh | exact shape_atan | exact (shape_even 0) | exact (shape_even 1)
  | exact (shape_even 2) | exact (shape_even 3) | exact (shape_even 4) | exact (shape_even 5)].
(* the rest *)
Ltac at_rest := first [apply bounded_const | solve [intros; lra] | eapply follows_by; [apply follows_const|intros t Ht; cbv beta;
  repeat first [rewrite Rmult_0_l | rewrite Rmult_0_r | rewrite sin_0 | rewrite cos_0 | rewrite exp_0 | rewrite tanh_0 | rewrite sinh_0
    | rewrite cosh_0 | rewrite atan_0 | rewrite Rabs_R0 | rewrite sqrt_0 | rewrite Ropp_0 | rewrite Rminus_0_r | rewrite Rplus_0_l | rewrite Rplus_0_r]; equal]].
(* V' as a sum *)
Ltac sum_of rate V loss := eapply follows_by; [exact rate|intros t Ht; unfold V, loss; equal].
Ltac parts_of V := intros t Ht; unfold V; equal.
Ltac nonneg_of parts := intros t Ht; rewrite (parts t Ht); nonneg.
Ltac nonneg_loss loss := unfold loss; intros t Ht; nonneg.
Ltac falls_of sum loss := intros s t Hst Ht; apply (falls _ _ _ sum); auto; intros u Hu; assert (A := loss u Hu); lra.
Ltac spent_of sum V loss := intros L HL t Ht; assert (F := falls _ _ _ (follows_plus _ _ _ _ _ HL sum) ltac:(intros; lra) 0 t ltac:(destruct Ht; lra) Ht);
  assert (A := V t Ht); lra.
Ltac mean_of sum V loss := intros L P HL HP t Ht;
  assert (F := falls _ _ _ (follows_minus _ _ _ _ _ (follows_plus _ _ _ _ _ HL sum) HP) ltac:(intros u Hu; assert (B := V u Hu); lra) 0 t ltac:(destruct Ht; lra) Ht);
  assert (A := V t Ht); lra.
Ltac decays_of d sum V loss := intros c Hc; refine (decays _ _ _ d c _ sum _); [positive|];
  intros u Hu; assert (A := loss u Hu); assert (B := Hc u Hu); lra.
(* V' <= push - decay V, and V by it *)
Ltac pulled_of loss_nonneg V loss := intros t Ht; assert (A := loss_nonneg t Ht); apply Rminus_le_0; eapply Rle_trans; [exact A|];
  apply Req_le; unfold V, loss; equal.
Ltac level_of push sum loss := refine (decays_to _ _ push _ _ _ _ _ sum _); [positive|field; nonzero|];
  intros u Hu; assert (A := loss u Hu); lra.
Ltac below_level k decays := intros t Ht; eapply Rle_trans; [exact (decays t Ht)|apply (below_max k); [positive|apply Ht]].
Ltac near_level k V decays := intros E c Hc; refine (decays_near k _ V c _ Hc _); [positive|];
  intros t Ht; apply decays; rewrite E; apply on_all, Ht.
Ltac between_of bounds := intros t Ht; assert (A := bounds t Ht); lra.
(* V <= V(0) exp(-c t), as c V <= loss term by term *)
Lemma decays_to_zero T V dV c : 0 < c -> follows T V dV -> (forall t, on T t -> c * V t <= - dV t) ->
  forall t, on T t -> V t <= V 0 * exp (- c * t).
Proof. intros Hc F H t Ht. assert (A := decays T V dV c 0 Hc F ltac:(intros u Hu; assert (B := H u Hu); lra) t Ht).
  unfold Rdiv in A. rewrite Rmult_0_l, Rplus_0_l, Rminus_0_r in A. exact A. Qed.
Lemma larger_share c w l g : c * w <= l -> 0 <= g -> c * (w * g) <= l * g.
Proof. intros. rewrite <- Rmult_assoc. apply Rmult_le_compat_r; auto. Qed.
Lemma larger_share_by c w l m f g : c * w <= l * m -> m <= f -> 0 <= l -> 0 <= g -> c * (w * g) <= l * f * g.
Proof. intros. rewrite <- Rmult_assoc. apply Rmult_le_compat_r; auto. apply (Rle_trans _ (l * m)); auto. apply Rmult_le_compat_l; auto. Qed.
Lemma below_shares c a b d e : c * a <= d -> c * b <= e -> c * (a + b) <= d + e. Proof. lra. Qed.
Ltac shares := first [apply below_shares; [solve [shares]|solve [shares]] | apply below_left; [solve [shares]|nonneg]
  | apply below_right; [solve [shares]|nonneg] | eapply larger_share_by; [eassumption|above|nonneg|nonneg] | apply larger_share; [assumption|nonneg]].
Ltac exponential_of sum parts loss := intros c Hc; intros; eapply (decays_to_zero _ _ _ c Hc sum); [|assumption];
  intros u Hu; cbv beta; rewrite Ropp_involutive, (parts u Hu); unfold loss; shares.
Ltac bound_of falls parts := intros t Ht; eapply Rle_trans; [|exact (falls 0 t ltac:(destruct Ht; lra) Ht)]; rewrite (parts t Ht); below.
Ltac part_of loss := intros t Ht; apply Ropp_le_contravar; unfold loss; below.
(* V stays below c; the room to c is printed as a factor of losses *)
Lemma room_at V c r : V < c -> r = c - V -> 0 <= r. Proof. lra. Qed.
Ltac room_of stays V := intros t Ht; apply (room_at _ _ _ (stays t Ht)); unfold V; field.
Lemma loses x : 0 <= x -> - x <= 0. Proof. lra. Qed.
Ltac stays_of c sum begins V loss room := apply (stays_below _ _ _ c sum); [|exact begins]; intros u Hu L;
  assert (M : 0 <= room u) by (apply (room_at _ _ _ L); unfold V; field); cbv beta in M |- *; apply loses; unfold loss; nonneg.
(* V' as it is printed *)
Ltac rate_of := eapply follows_by; [follow|intros t Ht; equal].
(* a form that V bounds, as bound says, by its shape g *)
Ltac bounded_by_shape bound g := eapply (bounded_shape _ g); [shape_of| |intros t Ht; exact (bound t Ht)]; positive.
(* what V loses goes to zero *)
Ltac lost_from sum V loss := eapply (vanishes_value _ _ _ _ sum V); [cbv beta; part_of loss|cbv beta; intros t Ht; nonneg|lip].
Ltac zero_of lost g := eapply (vanishes_shape _ g); [shape_of| |exact lost]; positive.
(* the rate of what goes to zero *)
Ltac next_of zero := eapply (vanishes_next _ _ _ zero); [rate_of|lip].
(* a form by what goes to zero, is bounded or small *)
Ltac vanishes_as f := apply (vanishes_ext _ f); [intros t Ht; equal|van].
Ltac bounded_as f := apply (bounded_ext _ f); [intros t Ht; equal|bnd].

Ltac sml le := first [solve [eauto with clpt nocore] |
  lazymatch goal with
  | |- small _ _ _ (fun i t => @?f i t + @?g i t) => apply (small_plus _ _ _ le f g); sml le
  | |- small _ _ _ (fun i t => exp (@?f i t) - @?f i t - 1) => apply (small_at _ _ _ _ f through_exp); sml le
  | |- small _ _ _ (fun i t => 1 - cos (@?f i t)) => apply (small_at _ _ _ _ f through_cos); sml le
  | |- small _ _ _ (fun i t => cosh (@?f i t) - 1) => apply (small_at _ _ _ _ f through_cosh); sml le
  | |- small _ _ _ (fun i t => sqrt ((@?f i t) ^ 2 + 1) - 1) => apply (small_at _ _ _ _ f through_root); sml le
  | |- small _ _ _ (fun i t => Rabs (@?f i t) - ln (1 + Rabs (@?f i t))) => apply (small_at _ _ _ _ f through_soft); sml le
  | |- small _ _ _ (fun i t => sin (@?f i t)) => apply (small_at _ _ _ _ f through_sin); sml le
  | |- small _ _ _ (fun i t => tanh (@?f i t)) => apply (small_at _ _ _ _ f through_tanh); sml le
  | |- small _ _ _ (fun i t => sinh (@?f i t)) => apply (small_at _ _ _ _ f through_sinh); sml le
  | |- small _ _ _ (fun i t => atan (@?f i t)) => apply (small_at _ _ _ _ f through_atan); sml le
  | |- small _ _ _ (fun i t => @?f i t - @?g i t) => apply (small_minus _ _ _ le f g); sml le
  | |- small _ _ _ (fun _ _ => 0) => apply small_zero
  | |- small _ _ _ (fun i t => @?f i t * @?g i t) => lazymatch f with
      | (fun _ _ => ?a) => apply (small_scal _ _ _ a g); sml le
      | _ => apply (small_mult _ _ _ le f g); sml le
      end
  | |- small _ _ _ (fun i t => @?f i t / ?a) => apply (small_share _ _ _ a f); sml le
  | |- small _ _ _ (fun i t => Rabs (@?f i t)) => apply (small_abs _ _ _ f); sml le
  | |- small _ _ _ (fun i t => - @?f i t) => apply (small_opp _ _ _ f); sml le
  | |- small _ _ _ (fun i t => (@?f i t) ^ ?n) =>
      let k := eval compute in (pred n) in apply (small_pow _ _ _ le k f); sml le
  | |- _ => leaf
  end].
Ltac small_by_shape small_V bound g :=
  refine (small_shape _ _ _ _ g _ _ _ _ _ small_V); [shape_of| |intros i t Ht; exact (bound i t Ht)]; positive.
Ltac small_as le f := apply (small_ext _ _ _ f); [intros i t Ht; equal|sml le].
Ltac near_of near := unfold near; intros; repeat match goal with A : _ /\ _ |- _ => destruct A end; repeat split; lra.
Ltac start_of near := intros eps He; exists eps; split; [exact He|]; intros i Hi t _; unfold near in Hi; tauto.
Ltac small_V_of le parts f := apply (small_ext _ _ _ f);
  [intros i t Ht; symmetry; apply parts; apply (on_le _ 0 t Ht); destruct Ht; lra|sml le].

