(** * The heavy top: exactly one motion for all time through every state

    L' = L x W + Gamma x g and Gamma' = Gamma x W, where g is weight times the vector to the centre of mass, in the
    body. With a seventh unknown that stays 1 the system is quadratic, and the energy and |Gamma|^2 give a conserved
    bound: k (L.W + |Gamma + x7 g|^2) + |Gamma|^2 + x7^2 with k = I1 + I2 + I3 is a sum of squares and exceeds
    |L|^2. So the certificates for tops, upright, hanging and sleeping, speak of motions that exist for all time.

    Source: Arnold, Mathematical Methods of Classical Mechanics, section 30; sign of g as in certificates/. *)
From Coq Require Import Reals Lra Psatz Lia List.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Vec3 Calculus Stability QuadraticTerms QuadraticFlow GlobalSolution EllipticClock.
From Polhode Require Import BodyMotion.
Import ListNotations.
Local Open Scope R_scope.

Section Top.
Variables I1 I2 I3 : R.
Hypotheses (p1 : 0 < I1) (p2 : 0 < I2) (p3 : 0 < I3).
Variable g : V.

Definition top_motion (L Gamma : R -> V) t := let W := angular_velocity I1 I2 I3 (L t) in
  has_velocity L t (add (cross (L t) W) (cross (Gamma t) g)) /\ has_velocity Gamma t (cross (Gamma t) W).

(* Unknowns 0 to 2 are L, 3 to 5 Gamma, and 6 is the constant 1. *)
Definition top_unknowns L Gamma (i : nat) := match i with
  | 0 => X L | 1 => Y L | 2 => Z L
  | 3 => X Gamma | 4 => Y Gamma | 5 => Z Gamma
  | _ => 1%R
  end%nat.

Definition top_terms (i : nat) := match i with
  | 0 => [Term (1 / I3 - 1 / I2) 1 2; Term (Z g) 4 6; Term (- Y g) 5 6]
  | 1 => [Term (1 / I1 - 1 / I3) 2 0; Term (X g) 5 6; Term (- Z g) 3 6]
  | 2 => [Term (1 / I2 - 1 / I1) 0 1; Term (Y g) 3 6; Term (- X g) 4 6]
  | 3 => [Term (1 / I3) 4 2; Term (- (1 / I2)) 5 1]
  | 4 => [Term (1 / I1) 5 0; Term (- (1 / I3)) 3 2]
  | 5 => [Term (1 / I2) 3 1; Term (- (1 / I1)) 4 0]
  | _ => []
  end%nat.

Lemma top_closed i : (i < 7)%nat -> within 7 (top_terms i).
Proof.
  intros hi.
  do 6 (destruct i as [|i]; [repeat constructor|]).
  constructor.
Qed.

(* The conserved sum of weighted squares of linear forms. *)
Definition heaviness (i : nat) := match i with
  | 0%nat => (I1 + I2 + I3) / I1 | 1%nat => (I1 + I2 + I3) / I2 | 2%nat => (I1 + I2 + I3) / I3
  | 3%nat => I1 + I2 + I3 | 4%nat => I1 + I2 + I3 | 5%nat => I1 + I2 + I3
  | _ => 1
  end.
Definition form (x : nat -> R) (i : nat) := match i with
  | 0%nat => x 0%nat | 1%nat => x 1%nat | 2%nat => x 2%nat
  | 3%nat => x 3%nat + x 6%nat * X g | 4%nat => x 4%nat + x 6%nat * Y g | 5%nat => x 5%nat + x 6%nat * Z g
  | 6%nat => x 3%nat | 7%nat => x 4%nat | 8%nat => x 5%nat
  | _ => x 6%nat
  end.
Definition square x i := heaviness i * (form x i * form x i).
Definition bound_square x := total 10 (square x).

Lemma ratio_ge_1 a b c : 0 < a -> 0 < b -> 0 < c -> 1 <= (a + b + c) / a.
Proof.
  intros ha hb hc.
  replace ((a + b + c) / a) with (1 + (b + c) * / a) by (field; lra).
  assert (positive := Rinv_0_lt_compat a ha).
  assert (product : 0 <= (b + c) * / a) by (apply Rmult_le_pos; lra).
  lra.
Qed.

Lemma square_positive x i : 0 <= square x i.
Proof.
  apply Rmult_le_pos; [|apply Rle_0_sqr].
  assert (r1 := ratio_ge_1 I1 I2 I3 p1 p2 p3).
  assert (r2 := ratio_ge_1 I2 I1 I3 p2 p1 p3).
  assert (r3 := ratio_ge_1 I3 I1 I2 p3 p1 p2).
  replace (I2 + I1 + I3) with (I1 + I2 + I3) in r2 by ring.
  replace (I3 + I1 + I2) with (I1 + I2 + I3) in r3 by ring.
  do 6 (destruct i as [|i]; [cbn; lra|]).
  cbn; lra.
Qed.

Lemma bound_unknown x i : (i < 7)%nat -> x i * x i <= bound_square x.
Proof.
  intros hi.
  assert (part := fun j hj => total_ge_term 10 (square x) j (fun k _ => square_positive x k) hj).
  assert (light : forall r y, 1 <= r -> y * y <= r * (y * y)).
  { intros r y hr.
    assert (positive := Rle_0_sqr y).
    unfold Rsqr in positive.
    assert (product := Rmult_le_compat_r _ _ _ positive hr).
    lra. }
  assert (r1 := light _ (x 0%nat) (ratio_ge_1 I1 I2 I3 p1 p2 p3)).
  assert (r2 := light _ (x 1%nat) (ratio_ge_1 I2 I1 I3 p2 p1 p3)).
  assert (r3 := light _ (x 2%nat) (ratio_ge_1 I3 I1 I2 p3 p1 p2)).
  replace (I2 + I1 + I3) with (I1 + I2 + I3) in r2 by ring.
  replace (I3 + I1 + I2) with (I1 + I2 + I3) in r3 by ring.
  unfold bound_square.
  destruct i as [|[|[|i]]].
  - exact (Rle_trans _ _ _ r1 (part 0%nat ltac:(lia))).
  - exact (Rle_trans _ _ _ r2 (part 1%nat ltac:(lia))).
  - exact (Rle_trans _ _ _ r3 (part 2%nat ltac:(lia))).
  - assert (own := part (6 + i)%nat ltac:(lia)).
    do 4 (destruct i as [|i]; [unfold square in own at 1; cbn [heaviness form Nat.add] in own; lra|]).
    lia.
Qed.

Lemma form_derive c t i : solves 7 top_terms c t ->
  is_derive (fun x => form (c x) i) t (form (fun j => evaluate (top_terms j) (c t)) i).
Proof.
  intros each.
  assert (shifted : forall j k, (j < 7)%nat -> is_derive (fun x => c x j + c x 6%nat * k) t
    (evaluate (top_terms j) (c t) + evaluate (top_terms 6) (c t) * k)).
  { intros j k hj.
    apply (is_derive_plus (fun x => c x j) (fun x => c x 6%nat * k)); [exact (each j hj)|].
    exact (is_derive_scal_l (fun x => c x 6%nat) t _ k (each 6%nat ltac:(lia))). }
  do 3 (destruct i as [|i]; [apply each; lia|]).
  do 3 (destruct i as [|i]; [apply shifted; lia|]).
  do 3 (destruct i as [|i]; [apply each; lia|]).
  apply each; lia.
Qed.

Lemma bound_constant c a b : solves_on 7 top_terms c a b -> forall t, a <= t <= b ->
  bound_square (c t) = bound_square (c a).
Proof.
  intros solution.
  apply (const_of_derive (fun t => bound_square (c t))).
  intros t ht.
  set (rate := fun i => heaviness i * (form (fun j => evaluate (top_terms j) (c t)) i * form (c t) i +
    form (c t) i * form (fun j => evaluate (top_terms j) (c t)) i)).
  apply (is_derive_value _ t (total 10 rate) 0).
  - apply (total_derive 10 (fun t => square (c t)) rate).
    intros i _.
    assert (d := form_derive c t i (solution t ht)).
    apply (is_derive_scal (fun t => form (c t) i * form (c t) i)).
    exact (product_derive _ _ t _ _ d d).
  - over_reals.
    unfold rate.
    cbn [total heaviness form top_terms evaluate fold_right factor left right].
    field; lra.
Qed.

Lemma top_flow : one_flow 7 top_terms.
Proof.
  apply (quadratic_flow 7 top_terms (fun x => sqrt (bound_square x)) top_closed).
  - intros x i hi.
    rewrite <- sqrt_Rsqr_abs.
    apply sqrt_le_1_alt.
    exact (bound_unknown x i hi).
  - intros x y equal.
    f_equal.
    apply total_ext.
    intros i _.
    unfold square.
    enough (form x i = form y i) as -> by reflexivity.
    unfold same in equal.
    do 10 (destruct i as [|i]; [cbn [form]; rewrite !equal by lia; reflexivity|]).
    exact (equal 6%nat ltac:(lia)).
  - intros c a b solution s t hs ht.
    now rewrite (bound_constant c a b solution s hs), (bound_constant c a b solution t ht).
Qed.

Ltac components := unfold angular_velocity, cross, add;
  cbn [X Y Z top_unknowns top_terms evaluate fold_right factor left right]; over_reals; field; lra.

Lemma top_solves L Gamma t : top_motion L Gamma t -> solves 7 top_terms (fun x => top_unknowns (L x) (Gamma x)) t.
Proof.
  intros ((lx & ly & lz) & (x & y & z)) i hi.
  do 6 (destruct i as [|i]; [eapply is_derive_value; [eassumption | components]|]).
  exact (is_derive_const 1 t).
Qed.

Theorem top_motion_exists_unique L0 Gamma0 : exists L Gamma,
  (L 0 = L0 /\ Gamma 0 = Gamma0) /\ (forall t, top_motion L Gamma t) /\
  forall L' Gamma', (L' 0 = L0 /\ Gamma' 0 = Gamma0) -> (forall t, top_motion L' Gamma' t) ->
  forall t, L' t = L t /\ Gamma' t = Gamma t.
Proof.
  destruct (top_flow (top_unknowns L0 Gamma0)) as (x & first & solution & unique).
  assert (one : forall t, x t 6%nat = 1).
  { intros t.
    transitivity (x 0 6%nat); [|exact (first 6%nat ltac:(lia))].
    apply (constant_everywhere (fun t => x t 6%nat)).
    intros s.
    exact (solution s 6%nat ltac:(lia)). }
  exists (fun t => mk (x t 0%nat) (x t 1%nat) (x t 2%nat)), (fun t => mk (x t 3%nat) (x t 4%nat) (x t 5%nat)).
  refine (conj (conj _ _) (conj _ _)).
  - apply V_eq; cbn [X Y Z]; apply first; lia.
  - apply V_eq; cbn [X Y Z]; [apply (first 3%nat) | apply (first 4%nat) | apply (first 5%nat)]; lia.
  - intros t.
    assert (each := solution t).
    refine (conj (conj _ (conj _ _)) (conj _ (conj _ _))).
    + apply (is_derive_value _ t _ _ (each 0%nat ltac:(lia))); cbn [top_terms evaluate fold_right factor left right];
        rewrite one; components.
    + apply (is_derive_value _ t _ _ (each 1%nat ltac:(lia))); cbn [top_terms evaluate fold_right factor left right];
        rewrite one; components.
    + apply (is_derive_value _ t _ _ (each 2%nat ltac:(lia))); cbn [top_terms evaluate fold_right factor left right];
        rewrite one; components.
    + apply (is_derive_value _ t _ _ (each 3%nat ltac:(lia))); components.
    + apply (is_derive_value _ t _ _ (each 4%nat ltac:(lia))); components.
    + apply (is_derive_value _ t _ _ (each 5%nat ltac:(lia))); components.
  - intros L' Gamma' (l_first & g_first) solution' t.
    assert (equal : same 7 (top_unknowns (L' t) (Gamma' t)) (x t)).
    { apply (unique (fun s => top_unknowns (L' s) (Gamma' s)) 0).
      - intros j hj.
        rewrite l_first, g_first.
        symmetry; exact (first j hj).
      - intros s.
        apply top_solves, solution'. }
    split; apply V_eq; cbn [X Y Z].
    + exact (equal 0%nat ltac:(lia)).
    + exact (equal 1%nat ltac:(lia)).
    + exact (equal 2%nat ltac:(lia)).
    + exact (equal 3%nat ltac:(lia)).
    + exact (equal 4%nat ltac:(lia)).
    + exact (equal 5%nat ltac:(lia)).
Qed.
End Top.
