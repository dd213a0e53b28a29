(* HeavyTop: (0, 0, 1) is stable on its own leaf, else undecided.

Every solution with x4 = x5 = x6 = 0, that starts near enough stays near the point; of other solutions, on leaves nearby, nothing is proved:
the theorem at the end, about the equations f1, f2, ...
Of the numbers that came in, each double is the shortest decimal that rounds to it.
Written by polhode; checked by `coqc -Q . Polhode checker.v` and `coqc -Q . Polhode top_on_leaf.v` in this folder. *)
From Coq Require Import Reals QArith List Lra Lia.
From Polhode Require Import checker.
Import ListNotations.
Local Open Scope R_scope.

(* the equations: the rate of change of each coordinate *)
Definition f1 (x1 x2 x3 : R) : R := (-1 / 6) * x2 * x3.
Definition f2 (x1 x2 x3 : R) : R := (2 / 3) * x1 * x3.
Definition f3 (x1 x2 x3 : R) : R := (-1 / 2) * x1 * x2.
(* the square of the distance from the point *)
Definition distance2 (x1 x2 x3 : R) : R := (x1 - (0)) * (x1 - (0)) + (x2 - (0)) * (x2 - (0)) + (x3 - (1)) * (x3 -
  (1)).

(* the same as data: polynomials are lists of coefficient and variables, counted from 0 *)
Definition field : list poly := [
  [((-1#6), [1; 2]%nat)];
  [((2#3), [0; 2]%nat)];
  [((-1#2), [0; 1]%nat)]].
Definition point : list Q := [(0#1); (0#1); (1#1)].
Definition zf := equation field.
Definition zp := entry_of point.
Lemma reads1 x : eval x (zf 0) = f1 (x 0%nat) (x 1%nat) (x 2%nat).
Proof. unfold zf, field, f1. read_data. Qed.
Lemma reads2 x : eval x (zf 1) = f2 (x 0%nat) (x 1%nat) (x 2%nat).
Proof. unfold zf, field, f2. read_data. Qed.
Lemma reads3 x : eval x (zf 2) = f3 (x 0%nat) (x 1%nat) (x 2%nat).
Proof. unfold zf, field, f3. read_data. Qed.
Lemma reads_distance x : off 3 zp x = distance2 (x 0%nat) (x 1%nat) (x 2%nat).
Proof. unfold zp, point, distance2. read_data. Qed.

(* what is conserved: c1 = −3 x1² + x3²; c2 = H *)
Definition c1 : poly := [((-3#1), [0; 0]%nat); ((1#1), [2; 2]%nat)].
Definition c2 : poly := [((1#2), [0; 0]%nat); ((1#4), [1; 1]%nat); ((1#6), [2; 2]%nat)].
Definition square (p : poly) (level : Q) : poly := times (add p (constant (- level))) (add p (constant (- level))).
Definition G : poly := add (scale (-1#6) c1) (add (scale (1#1) c2) (scale (1#16) (square c1 (1#1)))).
Definition margin : Q := (1#8).
Definition radius : Q := (1#32).
Definition forms : list (Q * list Q) := [((7#8), [(1#1); (0#1); (0#1)]);
  ((1#8), [(0#1); (1#1); (0#1)]);
  ((1#8), [(0#1); (0#1); (1#1)])].

Lemma minimum : check_extremum 3 zp G [] forms margin radius = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma kept : is_zero (rate zf G) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem equilibrium_is_stable_on_its_leaf : forall eps, 0 < eps -> exists del, 0 < del /\
  forall (x1 x2 x3 : R -> R) (T : R),
  (forall t, 0 <= t <= T -> derivable_pt_lim x1 t (f1 (x1 t) (x2 t) (x3 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x2 t (f2 (x1 t) (x2 t) (x3 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x3 t (f3 (x1 t) (x2 t) (x3 t))) ->
  distance2 (x1 0) (x2 0) (x3 0) < del ->
  forall t, 0 <= t <= T -> distance2 (x1 t) (x2 t) (x3 t) < eps.
Proof.
  intros eps pe. destruct (confined 3 zf zp G forms margin radius minimum kept eps pe) as (del & pd & h).
  exists del; split; [exact pd|]. intros x1 x2 x3 T s1 s2 s3 near t ht.
  assert (k : off 3 zp (path [x1; x2; x3] t) < eps); [|rewrite reads_distance in k; exact k].
  apply (h (path [x1; x2; x3]) T);
    [| intros; apply path_inside; simpl; lia | rewrite reads_distance; exact near | exact ht].
  intros [|[|[|i]]] r hr.
  { rewrite reads1; exact (s1 r hr). }
  { rewrite reads2; exact (s2 r hr). }
  { rewrite reads3; exact (s3 r hr). }
  apply still_beyond; simpl; lia.
Qed.
Print Assumptions equilibrium_is_stable_on_its_leaf.
