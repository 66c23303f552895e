(* A rate at which errors fall along a run: e' = - a e + w'th, th' = - w e, for any number of parameters.
   With f' = - p f + w, z = e - f'th and M' = - rho M - rho C I + f f' - kappa M w w'M,
   U = C (e^2 + th'th) + D z^2 + th'M th falls at the rate rho wherever M >= 0 and b0 <= f'w <= b1. *)
From Coq Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Clpt Require Import Runs.
Open Scope R_scope.

Fixpoint total (n : nat) (x : nat -> R) : R := match n with O => 0 | S m => total m x + x m end.
Definition dot (n : nat) (x y : nat -> R -> R) (t : R) := total n (fun i => x i t * y i t).
Definition form (n : nat) (M : nat -> nat -> R -> R) (t : R) (x y : nat -> R) :=
  total n (fun i => total n (fun k => M i k t * (x i * y k))).
Definition unit (i k : nat) : R := if Nat.eq_dec i k then 1 else 0.

Lemma total_by n x y : (forall i, (i < n)%nat -> x i = y i) -> total n x = total n y.
Proof. induction n as [|n IH]; intros H; simpl; auto. rewrite IH by auto. rewrite H by lia. auto. Qed.
Lemma total_plus n x y : total n (fun i => x i + y i) = total n x + total n y.
Proof. induction n as [|n IH]; simpl; [ring|]. rewrite IH. ring. Qed.
Lemma total_times n c x : total n (fun i => c * x i) = c * total n x.
Proof. induction n as [|n IH]; simpl; [ring|]. rewrite IH. ring. Qed.
Lemma total_product n x y : total n (fun i => total n (fun k => x i * y k)) = total n x * total n y.
Proof. rewrite (total_by n _ (fun i => total n y * x i)); [rewrite total_times; ring|].
  intros i _. rewrite total_times. ring. Qed.
Lemma total_swap n x : total n (fun i => total n (fun k => x i k)) = total n (fun k => total n (fun i => x i k)).
Proof. enough (G : forall m, total m (fun i => total n (fun k => x i k)) = total n (fun k => total m (fun i => x i k))) by apply G.
  induction m as [|m IH]; simpl.
  - induction n as [|n IHn]; simpl; [|rewrite <- IHn]; ring.
  - rewrite IH, total_plus. auto. Qed.
Lemma total_unit n i x : (i < n)%nat -> total n (fun k => unit i k * x k) = x i.
Proof. assert (Z : forall m, (m <= i)%nat -> total m (fun k => unit i k * x k) = 0).
  { induction m as [|m IH]; intros H; simpl; auto. rewrite IH by lia. unfold unit. destruct (Nat.eq_dec i m); [lia|ring]. }
  induction n as [|n IH]; intros H; simpl; [lia|]. unfold unit at 2. destruct (Nat.eq_dec i n) as [<-|].
  - rewrite Z by lia. ring. - rewrite IH by lia. ring. Qed.
Lemma follows_total T n x dx : (forall i, (i < n)%nat -> follows T (x i) (dx i)) ->
  follows T (fun t => total n (fun i => x i t)) (fun t => total n (fun i => dx i t)).
Proof. induction n as [|n IH]; intros H; simpl; [apply follows_const|].
  apply (follows_plus T (fun t => total n (fun i => x i t)) (fun t => total n (fun i => dx i t))); auto. Qed.

Section Rate.
Variables (T : Rbar) (n : nat) (e : R -> R) (th w f : nat -> R -> R) (M : nat -> nat -> R -> R).
Variables a p kappa b0 b1 C D rho c : R.
Let s i t := total n (fun k => M i k t * w k t).
Let V t := e t ^ 2 + dot n th th t.
Let z t := e t - dot n f th t.
Let y t := form n M t (fun i => th i t) (fun i => th i t).
Hypothesis F_e : follows T e (fun t => - a * e t + dot n w th t).
Hypothesis F_th : forall i, (i < n)%nat -> follows T (th i) (fun t => - w i t * e t).
Hypothesis F_f : forall i, (i < n)%nat -> follows T (f i) (fun t => - p * f i t + w i t).
Hypothesis S_M : forall i k t, M i k t = M k i t.
Hypothesis F_M : forall i k, (i < n)%nat -> (k < n)%nat -> follows T (M i k)
  (fun t => - rho * M i k t - rho * C * unit i k + f i t * f k t - kappa * (s i t * s k t)).
Hypothesis B_b : forall t, on T t -> b0 <= dot n f w t <= b1.
Hypothesis B_M : forall t, on T t -> forall x, 0 <= form n M t x x.
Hypothesis B_0 : forall x0 x, D * (x0 - total n (fun i => f i 0 * x i)) ^ 2 + form n M 0 x x
  <= (c - 1) * C * (x0 ^ 2 + total n (fun i => x i ^ 2)).
Let E := (2 * a - rho) * C - 1 - 1 / kappa.
Let Z := (2 * p - rho) * D - 1.
Let X b := D * (p - a + b) - 1.
Hypothesis Hkappa : 0 < kappa.
Hypothesis HC : 0 < C.
Hypothesis HD : 0 <= D.
Hypothesis Hrho : 0 < rho.
Hypothesis HZ : 0 < Z.
Hypothesis H0 : X b0 ^ 2 <= E * Z.
Hypothesis H1 : X b1 ^ 2 <= E * Z.

Lemma F_dot x dx g dg : (forall i, (i < n)%nat -> follows T (x i) (dx i)) ->
  (forall i, (i < n)%nat -> follows T (g i) (dg i)) ->
  follows T (dot n x g) (fun t => dot n dx g t + dot n x dg t).
Proof. intros Hx Hg. eapply follows_by.
  - apply (follows_total T n (fun i t => x i t * g i t)). intros i Hi. apply follows_mult; [apply Hx|apply Hg]; exact Hi.
  - intros t _. unfold dot. rewrite total_plus. auto. Qed.

Lemma F_V : follows T V (fun t => - 2 * a * e t ^ 2).
Proof. eapply follows_by; [apply follows_plus; [apply (follows_pow T 2 e _ F_e)|exact (F_dot _ _ _ _ F_th F_th)]|].
  intros t _. simpl. unfold dot.
  rewrite (total_by n (fun i => - w i t * e t * th i t) (fun i => - e t * (w i t * th i t))) by (intros; ring).
  rewrite (total_by n (fun i => th i t * (- w i t * e t)) (fun i => - e t * (w i t * th i t))) by (intros; ring).
  rewrite total_times. ring. Qed.

Lemma F_z : follows T z (fun t => - p * z t + (p - a + dot n f w t) * e t).
Proof. eapply follows_by; [apply follows_minus; [exact F_e|exact (F_dot _ _ _ _ F_f F_th)]|].
  intros t _. unfold z, dot.
  rewrite (total_by n (fun i => (- p * f i t + w i t) * th i t) (fun i => - p * (f i t * th i t) + w i t * th i t)) by (intros; ring).
  rewrite (total_by n (fun i => f i t * (- w i t * e t)) (fun i => - e t * (f i t * w i t))) by (intros; ring).
  rewrite total_plus, !total_times. ring. Qed.

Lemma F_y : follows T y (fun t => - rho * y t - rho * C * dot n th th t + dot n f th t ^ 2
  - 2 * e t * dot n s th t - kappa * dot n s th t ^ 2).
Proof. eapply follows_by.
  - apply (follows_total T n (fun i t => total n (fun k => M i k t * (th i t * th k t)))). intros i Hi.
    apply (follows_total T n (fun k t => M i k t * (th i t * th k t))). intros k Hk.
    apply follows_mult; [exact (F_M i k Hi Hk)|apply follows_mult; [exact (F_th i Hi)|exact (F_th k Hk)]].
  - intros t _. cbv beta.
    assert (P : forall i k, (- rho * M i k t - rho * C * unit i k + f i t * f k t - kappa * (s i t * s k t)) * (th i t * th k t)
      + M i k t * (- w i t * e t * th k t + th i t * (- w k t * e t)) =
      - rho * (M i k t * (th i t * th k t)) + (- rho * C * (unit i k * (th i t * th k t))
      + ((f i t * th i t) * (f k t * th k t) + (- kappa * ((s i t * th i t) * (s k t * th k t))
      + (- e t * (M i k t * w i t * th k t) + - e t * (th i t * (M i k t * w k t))))))) by (intros; ring).
    transitivity (total n (fun i => - rho * total n (fun k => M i k t * (th i t * th k t)) + (- rho * C * (th i t * th i t)
      + (total n (fun k => (f i t * th i t) * (f k t * th k t)) + (- kappa * total n (fun k => (s i t * th i t) * (s k t * th k t))
      + (- e t * total n (fun k => M i k t * w i t * th k t) + - e t * (s i t * th i t))))))).
    + apply total_by. intros i Hi. rewrite (total_by n _ _ (fun k _ => P i k)).
      rewrite !total_plus, !total_times, (total_unit n i (fun k => th i t * th k t) Hi). unfold s. ring.
    + rewrite !total_plus, !total_times, !total_product, (total_swap n (fun i k => M i k t * w i t * th k t)).
      rewrite (total_by n (fun k => total n (fun i => M i k t * w i t * th k t)) (fun k => s k t * th k t)).
      * unfold y, form, dot. ring.
      * intros k _. unfold s. rewrite (total_by n _ (fun i => th k t * (M k i t * w i t))); [rewrite total_times; ring|].
        intros i _. rewrite (S_M i k). ring. Qed.

Lemma X_below b : b0 <= b <= b1 -> X b ^ 2 <= E * Z.
Proof. intros [B0 B1]. assert (M0 := Rmult_le_compat_l _ _ _ HD B0). assert (M1 := Rmult_le_compat_l _ _ _ HD B1).
  destruct (Rle_dec 0 (X b)).
  - assert (X b <= X b1) by (unfold X; lra). assert (X b ^ 2 <= X b1 ^ 2) by (apply pow_incr; lra). lra.
  - assert (X b0 <= X b) by (unfold X; lra). assert ((- X b) ^ 2 <= (- X b0) ^ 2) by (apply pow_incr; lra). lra. Qed.

Theorem errors_rate t : on T t -> V t <= c * V 0 * exp (- rho * t).
Proof.
  intros Ht. set (U t := C * V t + D * z t ^ 2 + y t).
  assert (FU := follows_plus T _ _ _ _ (follows_plus T _ _ _ _
    (follows_mult T (fun _ => C) (fun _ => 0) _ _ (follows_const T C) F_V)
    (follows_mult T (fun _ => D) (fun _ => 0) _ _ (follows_const T D) (follows_pow T 2 z _ F_z))) F_y).
  assert (A : forall t, on T t -> U t <= U 0 * exp (- rho * t)).
  { apply (decays_to_zero T U _ rho Hrho FU). intros u Hu. unfold U, V. simpl. set (k := dot n s th u). set (b := dot n f w u).
    assert (L := X_below b (B_b u Hu)).
    assert (Q : 0 <= E * e u ^ 2 - 2 * X b * e u * z u + Z * z u ^ 2).
    { apply (Rmult_le_reg_l Z); [exact HZ|]. rewrite Rmult_0_r.
      replace (Z * (E * e u ^ 2 - 2 * X b * e u * z u + Z * z u ^ 2))
        with ((Z * z u - X b * e u) ^ 2 + (E * Z - X b ^ 2) * e u ^ 2) by ring.
      assert (S1 := pow2_ge_0 (Z * z u - X b * e u)). assert (S2 := pow2_ge_0 (e u)). nra. }
    assert (K : 0 <= (e u + kappa * k) ^ 2 / kappa) by (apply Rdiv_le_0_compat; [apply pow2_ge_0|exact Hkappa]).
    unfold E, Z, X in Q. replace (dot n f th u) with (e u - z u) by (unfold z; ring).
    replace ((e u + kappa * k) ^ 2 / kappa) with (1 / kappa * e u ^ 2 + 2 * e u * k + kappa * k ^ 2) in K by (field; lra).
    unfold Rdiv in *. lra. }
  assert (G := A t Ht). assert (P : 0 <= y t) by exact (B_M t Ht (fun i => th i t)). assert (Q := pow2_ge_0 (z t)).
  assert (W := B_0 (e 0) (fun i => th i 0)). assert (Y := exp_pos (- rho * t)).
  apply (Rmult_le_reg_l C); [exact HC|]. assert (0 <= D * z t ^ 2) by nra.
  assert (U 0 <= C * (c * V 0)).
  { unfold U, V, z, y, dot in *. rewrite (total_by n (fun i => th i 0 * th i 0) (fun i => th i 0 ^ 2)) by (intros; ring).
    lra. }
  assert (U 0 * exp (- rho * t) <= C * (c * V 0) * exp (- rho * t)) by (apply Rmult_le_compat_r; lra).
  unfold U in G at 1. lra.
Qed.
End Rate.
