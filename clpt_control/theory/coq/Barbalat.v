(* Barbalat's lemma in three forms. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Calculus.
Open Scope R_scope.

(* as in textbooks: F has a limit and F' is uniformly continuous, then F' -> 0 *)
Theorem barbalat (F f : R -> R) (l : R) :
  (forall t, 0 <= t -> is_derive F t (f t)) ->
  is_lim F p_infty l ->
  (forall eps, 0 < eps -> exists delta, 0 < delta /\
     forall s t, 0 <= s -> 0 <= t -> Rabs (t - s) < delta -> Rabs (f t - f s) < eps) ->
  is_lim f p_infty 0.
Proof.
  intros D L U. apply is_lim_spec. apply is_lim_spec in L. intros [eps He]. simpl.
  destruct (U (eps / 2) ltac:(lra)) as [delta [Hd Hu]].
  assert (P : 0 < eps * delta / 8) by nra.
  destruct (L (mkposreal _ P)) as [T HT]. simpl in HT.
  exists (Rmax T 0). intros t Ht.
  assert (T < t) by (eapply Rle_lt_trans; [apply Rmax_l|apply Ht]).
  assert (0 < t) by (eapply Rle_lt_trans; [apply Rmax_r|apply Ht]).
  destruct (MVT_gen F t (t + delta / 2) f) as [c [Hc E]];
    rewrite ?Rmin_left, ?Rmax_right in * by lra.
  - intros s Hs. apply D. lra.
  - intros s Hs. apply continuity_pt_filterlim. apply @ex_derive_continuous.
    exists (f s). apply D. lra.
  - assert (A := HT t ltac:(lra)). assert (B := HT (t + delta / 2) ltac:(lra)).
    apply Rabs_lt_between in A. apply Rabs_lt_between in B.
    assert (Cc : Rabs (f t - f c) < eps / 2).
    { apply Hu; [lra|lra|]. apply Rabs_lt_between. lra. }
    apply Rabs_lt_between in Cc.
    assert (Fc : - (eps / 2) < f c < eps / 2) by (split; nra).
    apply Rabs_lt_between. lra.
Qed.

Definition Lipschitz (g : R -> R) : Prop :=
  exists L, forall s t, 0 <= s -> 0 <= t -> Rabs (g t - g s) <= L * Rabs (t - s).

(* V >= 0 loses g, which is Lipschitz, then g -> 0.  V may have no derivative at jumps. *)
Theorem barbalat_dissipation (V dV g : R -> R) :
  follows V dV ->
  (forall t, 0 <= t -> 0 <= V t) ->
  (forall t, 0 <= t -> 0 <= g t) ->
  (forall t, 0 < t -> dV t <= - g t) ->
  Lipschitz g ->
  is_lim g p_infty 0.
Proof.
  intros F V0 g0 D [L HL]. apply is_lim_spec. intros [eps He]. simpl.
  assert (Fall : forall s t, 0 <= s <= t -> V t <= V s).
  { intros s t Hst. apply (falls V dV); auto. intros u Hu.
    assert (dV u <= - g u) by (apply D; lra). assert (0 <= g u) by (apply g0; lra). lra. }
  destruct (ex_finite_lim_seq_decr (fun n => V (INR n)) 0) as [l Hl].
  { intros n. apply Fall. rewrite S_INR. assert (0 <= INR n) by apply pos_INR. lra. }
  { intros n. apply V0, pos_INR. }
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
  rewrite Rabs_pos_eq by (apply g0; lra).
  destruct (Rlt_le_dec (g t) eps) as [|Big]; auto. exfalso.
  assert (S : V (t + h) - V t <= - (eps / 2) * (t + h - t)).
  { apply (slope V dV); auto; [lra|]. intros u Hu.
    assert (dV u <= - g u) by (apply D; lra).
    assert (B := HL t u ltac:(lra) ltac:(lra)). rewrite (Rabs_pos_eq (u - t)) in B by lra.
    apply Rabs_le_between in B. assert (L <= Rabs L) by apply Rle_abs.
    assert (L * (u - t) <= eps / 2) by nra. lra. }
  assert (A := Near t ltac:(lra)). assert (B := Near (t + h) ltac:(lra)). nra.
Qed.

(* a Lipschitz g >= 0 with a bounded integral goes to zero *)
Theorem barbalat_integral (g : R -> R) (M : R) :
  (forall t, 0 <= g t) ->
  (forall t, continuous g t) ->
  Lipschitz g ->
  (forall t, 0 <= t -> RInt g 0 t <= M) ->
  is_lim g p_infty 0.
Proof.
  intros g0 C HL B.
  apply (barbalat_dissipation (fun t => M - RInt g 0 t) (fun t => 0 - g t)); auto.
  - apply follows_minus; [apply follows_const|]. apply follows_smooth. intros t.
    apply (is_derive_RInt g (fun t => RInt g 0 t) 0 t); auto.
    exists (mkposreal 1 Rlt_0_1). intros y _. apply (@RInt_correct R_CompleteNormedModule).
    apply (@ex_RInt_continuous R_CompleteNormedModule). auto.
  - intros t Ht. assert (A := B t Ht). lra.
  - intros t Ht. lra.
Qed.

(* k f^2 -> 0 with k > 0: f -> 0 *)
Lemma square_vanishes (k : R) (f : R -> R) :
  0 < k -> is_lim (fun t => k * (f t)^2) p_infty 0 -> is_lim f p_infty 0.
Proof.
  intros Hk L. apply is_lim_spec. intros [eps He]. apply is_lim_spec in L. simpl.
  assert (P : 0 < k * eps^2) by (apply Rmult_lt_0_compat; [auto|apply pow_lt; auto]).
  destruct (L (mkposreal _ P)) as [T HT]. exists T. intros t Ht. assert (A := HT t Ht). simpl in A.
  rewrite Rminus_0_r in *. apply Rabs_lt_between in A.
  assert (Q : (f t)^2 < eps^2) by (simpl; nra). apply Rabs_lt_between. split; nra.
Qed.
