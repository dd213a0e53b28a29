(* Kirchhoff: (0, 0, 4, 0, 0, 1/2) is stable.

Every solution that starts near enough, in any direction, stays near the point:
the theorem at the end, about the equations f1, f2, ...
Of the numbers that came in, each double is the shortest decimal that rounds to it.
Written by polhode; checked by `coqc -Q . Polhode checker.v` and `coqc -Q . Polhode hull_spinning.v` in this folder. *)
From Coq Require Import Reals QArith List Lra Lia.
From Polhode Require Import checker.
Import ListNotations.
Local Open Scope R_scope.

(* the equations: the rate of change of each coordinate *)
Definition f1 (x1 x2 x3 x4 x5 x6 : R) : R := (-1 / 4) * x2 * x3 + (1 / 2) * x5 * x6.
Definition f2 (x1 x2 x3 x4 x5 x6 : R) : R := (3 / 4) * x1 * x3 + (-3 / 4) * x4 * x6.
Definition f3 (x1 x2 x3 x4 x5 x6 : R) : R := (-1 / 2) * x1 * x2 + (1 / 4) * x4 * x5.
Definition f4 (x1 x2 x3 x4 x5 x6 : R) : R := (-1 / 2) * x2 * x6 + (1 / 4) * x3 * x5.
Definition f5 (x1 x2 x3 x4 x5 x6 : R) : R := x1 * x6 + (-1 / 4) * x3 * x4.
Definition f6 (x1 x2 x3 x4 x5 x6 : R) : R := (-1) * x1 * x5 + (1 / 2) * x2 * x4.
(* the square of the distance from the point *)
Definition distance2 (x1 x2 x3 x4 x5 x6 : R) : R := (x1 - (0)) * (x1 - (0)) + (x2 - (0)) * (x2 - (0)) + (x3 - (4)) *
  (x3 - (4)) + (x4 - (0)) * (x4 - (0)) + (x5 - (0)) * (x5 - (0)) + (x6 - (1 / 2)) * (x6 - (1 / 2)).

(* the same as data: polynomials are lists of coefficient and variables, counted from 0 *)
Definition field : list poly := [
  [((-1#4), [1; 2]%nat); ((1#2), [4; 5]%nat)];
  [((3#4), [0; 2]%nat); ((-3#4), [3; 5]%nat)];
  [((-1#2), [0; 1]%nat); ((1#4), [3; 4]%nat)];
  [((-1#2), [1; 5]%nat); ((1#4), [2; 4]%nat)];
  [((1#1), [0; 5]%nat); ((-1#4), [2; 3]%nat)];
  [((-1#1), [0; 4]%nat); ((1#2), [1; 3]%nat)]].
Definition point : list Q := [(0#1); (0#1); (4#1); (0#1); (0#1); (1#2)].
Definition zf := equation field.
Definition zp := entry_of point.
Lemma reads1 x : eval x (zf 0) = f1 (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat).
Proof. unfold zf, field, f1. read_data. Qed.
Lemma reads2 x : eval x (zf 1) = f2 (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat).
Proof. unfold zf, field, f2. read_data. Qed.
Lemma reads3 x : eval x (zf 2) = f3 (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat).
Proof. unfold zf, field, f3. read_data. Qed.
Lemma reads4 x : eval x (zf 3) = f4 (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat).
Proof. unfold zf, field, f4. read_data. Qed.
Lemma reads5 x : eval x (zf 4) = f5 (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat).
Proof. unfold zf, field, f5. read_data. Qed.
Lemma reads6 x : eval x (zf 5) = f6 (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat).
Proof. unfold zf, field, f6. read_data. Qed.
Lemma reads_distance x : off 6 zp x = distance2 (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat).
Proof. unfold zp, point, distance2. read_data. Qed.

(* what is conserved: c1 = |P|²; c2 = Π·P; c3 = H *)
Definition c1 : poly := [((1#1), [3; 3]%nat); ((1#1), [4; 4]%nat); ((1#1), [5; 5]%nat)].
Definition c2 : poly := [((1#1), [0; 3]%nat); ((1#1), [1; 4]%nat); ((1#1), [2; 5]%nat)].
Definition c3 : poly := [((1#2), [0; 0]%nat); ((1#4), [1; 1]%nat); ((1#8), [2; 2]%nat); ((1#8), [3; 3]%nat); ((1#4),
  [4; 4]%nat); ((1#2), [5; 5]%nat)].
Definition square (p : poly) (level : Q) : poly := times (add p (constant (- level))) (add p (constant (- level))).
Definition G : poly := add (scale (15#2) c1) (add (scale (-2#1) c2) (add (scale (1#1) c3) (scale (4#1) (square c1
  (1#4))))).
Definition margin : Q := (1#64).
Definition radius : Q := (1#8192).
Definition forms : list (Q * list Q) := [((31#64), [(1#1); (0#1); (0#1); (-64#31); (0#1); (0#1)]);
  ((15#64), [(0#1); (1#1); (0#1); (0#1); (-64#15); (0#1)]);
  ((7#64), [(0#1); (0#1); (1#1); (0#1); (0#1); (-64#7)]);
  ((11001#1984), [(0#1); (0#1); (0#1); (1#1); (0#1); (0#1)]);
  ((3329#960), [(0#1); (0#1); (0#1); (0#1); (1#1); (0#1)]);
  ((1273#448), [(0#1); (0#1); (0#1); (0#1); (0#1); (1#1)])].

Lemma minimum : check_extremum 6 zp G [] forms margin radius = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma kept : is_zero (rate zf G) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem equilibrium_is_stable : forall eps, 0 < eps -> exists del, 0 < del /\
  forall (x1 x2 x3 x4 x5 x6 : R -> R) (T : R),
  (forall t, 0 <= t <= T -> derivable_pt_lim x1 t (f1 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x2 t (f2 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x3 t (f3 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x4 t (f4 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x5 t (f5 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x6 t (f6 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  distance2 (x1 0) (x2 0) (x3 0) (x4 0) (x5 0) (x6 0) < del ->
  forall t, 0 <= t <= T -> distance2 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t) < eps.
Proof.
  intros eps pe. destruct (confined 6 zf zp G forms margin radius minimum kept eps pe) as (del & pd & h).
  exists del; split; [exact pd|]. intros x1 x2 x3 x4 x5 x6 T s1 s2 s3 s4 s5 s6 near t ht.
  assert (k : off 6 zp (path [x1; x2; x3; x4; x5; x6] t) < eps); [|rewrite reads_distance in k; exact k].
  apply (h (path [x1; x2; x3; x4; x5; x6]) T);
    [| intros; apply path_inside; simpl; lia | rewrite reads_distance; exact near | exact ht].
  intros [|[|[|[|[|[|i]]]]]] r hr.
  { rewrite reads1; exact (s1 r hr). }
  { rewrite reads2; exact (s2 r hr). }
  { rewrite reads3; exact (s3 r hr). }
  { rewrite reads4; exact (s4 r hr). }
  { rewrite reads5; exact (s5 r hr). }
  { rewrite reads6; exact (s6 r hr). }
  apply still_beyond; simpl; lia.
Qed.
Print Assumptions equilibrium_is_stable.
