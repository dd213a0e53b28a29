(** * Euler's equations: exactly one solution for all time through every initial value

    Euler's equations are a quadratic system tangent to the spheres |L| = constant, so QuadraticFlow.v gives a solution
    for all time, past and future.  So Stability.v, which speaks of every solution, speaks of solutions that exist.

    Source: Arnold, Mathematical Methods of Classical Mechanics, section 29 (motions stay on the sphere, so go on). *)
From Coq Require Import Reals Lra Psatz Lia List FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Vec3 Calculus Euler Stability Uniqueness QuadraticTerms QuadraticFlow.
Import ListNotations.
Local Open Scope R_scope.

Definition unit_rate (t : R) := 1.
Definition solves_at p q r (c : R -> V) t := has_velocity c t (triple p q r (c t)).

Lemma driven_of_solves p q r c a b : (forall t, a <= t <= b -> solves_at p q r c t) -> driven p q r unit_rate c a b.
Proof.
  intros solution t ht.
  replace (scale (unit_rate t) (triple p q r (c t))) with (triple p q r (c t))
    by (unfold unit_rate, triple; vector_ring).
  now apply solution.
Qed.

Lemma solves_unique p q r c c' a b s : p + q + r = 0 -> (forall t, a <= t <= b -> solves_at p q r c t) ->
  (forall t, a <= t <= b -> solves_at p q r c' t) -> a <= s <= b -> c s = c' s -> forall t, a <= t <= b -> c t = c' t.
Proof.
  intros balanced solution solution' hs start.
  apply (driven_unique p q r balanced unit_rate 1 c c' a b s); auto using driven_of_solves.
  intros t _.
  unfold unit_rate.
  rewrite Rabs_R1; lra.
Qed.

(* A change of time t -> k t + s of a curve. *)
Lemma vderive_affine c k s t v : has_velocity c (k * t + s) v -> has_velocity (fun x => c (k * x + s)) t (scale k v).
Proof.
  assert (inner : is_derive (fun x => k * x + s) t k) by (auto_derive; auto; ring).
  intros (x & y & z).
  refine (conj _ (conj _ _)); cbn [X Y Z scale].
  - exact (is_derive_comp (fun u => X (c u)) (fun x => k * x + s) t _ _ x inner).
  - exact (is_derive_comp (fun u => Y (c u)) (fun x => k * x + s) t _ _ y inner).
  - exact (is_derive_comp (fun u => Z (c u)) (fun x => k * x + s) t _ _ z inner).
Qed.

Lemma solves_reversed p q r c t : solves_at (- p) (- q) (- r) c (- t) -> solves_at p q r (fun x => c (- x)) t.
Proof.
  unfold solves_at; intros solution.
  apply (has_velocity_ext (fun x => c (-1 * x + 0))); [intros; f_equal; ring|].
  replace (triple p q r (c (- t))) with (scale (-1) (triple (- p) (- q) (- r) (c (- t))))
    by (unfold triple; vector_ring).
  apply vderive_affine.
  now replace (-1 * t + 0) with (- t) by ring.
Qed.

(* The equations as a quadratic system in three unknowns. *)
Definition euler_terms p q r (i : nat) := match i with
  | 0%nat => [Term p 1 2]
  | 1%nat => [Term q 2 0]
  | _ => [Term r 0 1]
  end.
Definition unknowns u (i : nat) := match i with 0%nat => X u | 1%nat => Y u | _ => Z u end.

Lemma euler_closed p q r i : (i < 3)%nat -> within 3 (euler_terms p q r i).
Proof. intros hi. destruct i as [|[|i]]; repeat constructor. Qed.

Lemma euler_flow p q r start : p + q + r = 0 -> exists c, c 0 = start /\ forall t, solves_at p q r c t.
Proof.
  intros balanced.
  destruct (sphere_flow 3 (euler_terms p q r) (euler_closed p q r)) with (start := unknowns start)
    as (x & first & solution & _).
  - intros x.
    transitivity ((p + q + r) * (x 0%nat * x 1%nat * x 2%nat)); [cbn; ring|].
    rewrite balanced; ring.
  - exists (fun t => mk (x t 0%nat) (x t 1%nat) (x t 2%nat)).
    split.
    + apply V_eq; cbn [X Y Z]; apply first; lia.
    + intros t.
      assert (each := solution t).
      refine (conj _ (conj _ _)); cbn [X Y Z triple].
      * rewrite <- (Rplus_0_r (p * _)).
        exact (each 0%nat ltac:(lia)).
      * rewrite <- (Rplus_0_r (q * _)).
        exact (each 1%nat ltac:(lia)).
      * rewrite <- (Rplus_0_r (r * _)).
        exact (each 2%nat ltac:(lia)).
Qed.

Section Body.
Variables I1 I2 I3 : R.
Hypotheses (p1 : 0 < I1) (p2 : 0 < I2) (p3 : 0 < I3).

Definition rate1 := 1 / I3 - 1 / I2.
Definition rate2 := 1 / I1 - 1 / I3.
Definition rate3 := 1 / I2 - 1 / I1.

Lemma rates_balanced : rate1 + rate2 + rate3 = 0.
Proof. unfold rate1, rate2, rate3; ring. Qed.

(* A motion: a curve that obeys Euler's equations at every time, past and future. *)
Definition motion (L : R -> V) := forall t, has_velocity L t (euler_field I1 I2 I3 (L t)).

Lemma euler_field_triple L : euler_field I1 I2 I3 L = triple rate1 rate2 rate3 L.
Proof. exact (euler_field_components I1 I2 I3 p1 p2 p3 L). Qed.

Lemma solves_of_motion L t : has_velocity L t (euler_field I1 I2 I3 (L t)) <-> solves_at rate1 rate2 rate3 L t.
Proof. unfold solves_at. rewrite euler_field_triple; tauto. Qed.

(* One value, at any time, determines a motion. *)
Theorem motion_determined L L' s : motion L -> motion L' -> L s = L' s -> forall t, L t = L' t.
Proof.
  intros solution solution' equal t.
  assert (le1 := Rmin_l s t).
  assert (le2 := Rmin_r s t).
  assert (le3 := Rmax_l s t).
  assert (le4 := Rmax_r s t).
  apply (solves_unique rate1 rate2 rate3 L L' (Rmin s t) (Rmax s t) s rates_balanced); auto; try lra;
    intros x _; now apply solves_of_motion.
Qed.

Theorem motion_exists_unique start : exists! L : R -> V, L 0 = start /\ motion L.
Proof.
  destruct (euler_flow rate1 rate2 rate3 start rates_balanced) as (L & first & solves).
  assert (solution : motion L).
  { intros t.
    apply solves_of_motion, solves. }
  exists L.
  refine (conj (conj first solution) _).
  intros L' (first' & solution').
  apply functional_extensionality.
  apply (motion_determined _ _ 0 solution solution').
  now rewrite first, first'.
Qed.

(* A solution on [0, T], the notion of Stability.v, is a piece of exactly one motion. *)
Theorem solution_extends c T : 0 <= T -> solution I1 I2 I3 c T ->
  exists! L : R -> V, motion L /\ forall t, 0 <= t <= T -> c t = L t.
Proof.
  intros order solution.
  destruct (motion_exists_unique (c 0)) as (L & (first & whole) & unique).
  exists L.
  split.
  - refine (conj whole _).
    apply (solves_unique rate1 rate2 rate3 c L 0 T 0 rates_balanced); auto; try lra.
    + intros t ht.
      now apply solves_of_motion, solution.
    + intros t _.
      now apply solves_of_motion.
  - intros L' (whole' & agree).
    apply unique.
    refine (conj _ whole').
    symmetry; apply agree; lra.
Qed.
End Body.
