(* Barbalat's lemma in three forms, by Runs.v. *)
From Coq Require Import Reals Lra Lia List.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Runs Calculus.
Open Scope R_scope.

(* as in textbooks: F has a limit and F' is uniformly continuous, then F' -> 0 *)
Theorem barbalat (F f : R -> R) (l : R) :
  (forall t, 0 <= t -> is_derive F t (f t)) ->
  is_lim F p_infty l ->
  (forall eps, 0 < eps -> exists delta, 0 < delta /\
     forall s t, 0 <= s -> 0 <= t -> Rabs (t - s) < delta -> Rabs (f t - f s) < eps) ->
  is_lim f p_infty 0.
Proof.
  intros D. apply Runs.barbalat_limit. split.
  - intros t [Ht _]. apply @ex_derive_continuous. exists (f t). auto.
  - intros S _. exists nil. intros t Ht _. apply D. lra.
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
  rewrite follows_run. intros F V0 g0 D [L H].
  apply (Runs.barbalat V dV); auto; try (intros t [Ht _]; auto).
  exists L. intros s t [Hs _] [Ht _]. auto.
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
  intros Hk. apply (fades_shape (fun x => x ^ 2) k (shape_even 0) Hk).
Qed.
