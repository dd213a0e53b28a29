(* FreeRigidBody: (3/5, 0, 4/5) is stable.

Every solution that starts near enough stays near the point up to the flow of J1:
the theorem at the end, about the equations f1, f2, ...
Of the numbers that came in, each double is the shortest decimal that rounds to it.
Written by polhode; checked by `coqc -Q . Polhode checker.v` and `coqc -Q . Polhode symmetric_body.v` in this folder. *)
From Coq Require Import Reals QArith List Lra Lia.
From Polhode Require Import checker.
Import ListNotations.
Local Open Scope R_scope.

(* the equations: the rate of change of each coordinate *)
Definition f1 (x1 x2 x3 : R) : R := (-1 / 2) * x2 * x3.
Definition f2 (x1 x2 x3 : R) : R := (1 / 2) * x1 * x3.
Definition f3 (x1 x2 x3 : R) : R := 0.
(* the square of the distance from the point *)
Definition distance2 (x1 x2 x3 : R) : R := (x1 - (3 / 5)) * (x1 - (3 / 5)) + (x2 - (0)) * (x2 - (0)) + (x3 - (4 /
  5)) * (x3 - (4 / 5)).

(* the same as data: polynomials are lists of coefficient and variables, counted from 0 *)
Definition field : list poly := [
  [((-1#2), [1; 2]%nat)];
  [((1#2), [0; 2]%nat)];
  []].
Definition point : list Q := [(3#5); (0#1); (4#5)].
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

(* what is conserved: c1 = |L|²; c2 = J1; c3 = H *)
Definition c1 : poly := [((1#1), [0; 0]%nat); ((1#1), [1; 1]%nat); ((1#1), [2; 2]%nat)].
Definition c2 : poly := [((1#1), [2]%nat)].
Definition c3 : poly := [((1#2), [0; 0]%nat); ((1#2), [1; 1]%nat); ((1#4), [2; 2]%nat)].
Definition square (p : poly) (level : Q) : poly := times (add p (constant (- level))) (add p (constant (- level))).
Definition G : poly := add (scale (-1#2) c1) (add (scale (2#5) c2) (add (scale (1#1) c3) (add (scale (1#8) (square
  c1 (1#1))) (scale (1#2) (square c2 (4#5)))))).
Definition margin : Q := (1#32).
Definition radius : Q := (1#256).
Definition forms : list (Q * list Q) := [((119#800), [(1#1); (0#1); (192#119)]);
  ((263#800), [(0#1); (1#1); (0#1)]);
  ((577#3808), [(0#1); (0#1); (1#1)])].
Definition slice : Q := (1#1).

(* turned points: those on the orbit of the flow of J1 *)
Definition turn1 (a x1 x2 x3 : R) : R := x1 + sin a * (x2) + (1 - cos a) * ((-1) * x1).
Definition turn2 (a x1 x2 x3 : R) : R := x2 + sin a * ((-1) * x1) + (1 - cos a) * ((-1) * x2).
Definition turn3 (a x1 x2 x3 : R) : R := x3 + sin a * (0) + (1 - cos a) * (0).
Definition turning : list poly := [
  [((1#1), [1]%nat)];
  [((-1#1), [0]%nat)];
  []].
Definition turning_twice : list poly := [
  [((-1#1), [0]%nat)];
  [((-1#1), [1]%nat)];
  []].
Lemma twice1 : is_zero (add (X2 turning 0) (scale (-1) (equation turning_twice 0))) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma reads_turn1 a x : turn turning a x 0 = turn1 a (x 0%nat) (x 1%nat) (x 2%nat).
Proof. unfold turn. rewrite (eval_same _ _ x twice1).
  unfold X1, turning, turning_twice, turn1. read_data. Qed.
Lemma twice2 : is_zero (add (X2 turning 1) (scale (-1) (equation turning_twice 1))) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma reads_turn2 a x : turn turning a x 1 = turn2 a (x 0%nat) (x 1%nat) (x 2%nat).
Proof. unfold turn. rewrite (eval_same _ _ x twice2).
  unfold X1, turning, turning_twice, turn2. read_data. Qed.
Lemma twice3 : is_zero (add (X2 turning 2) (scale (-1) (equation turning_twice 2))) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma reads_turn3 a x : turn turning a x 2 = turn3 a (x 0%nat) (x 1%nat) (x 2%nat).
Proof. unfold turn. rewrite (eval_same _ _ x twice3).
  unfold X1, turning, turning_twice, turn3. read_data. Qed.

Lemma symmetry : check_symmetry 3 turning = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma minimum : check_extremum 3 zp G (let w := shift zp (across 3 zp turning) in scale slice (times w w))
  forms margin radius = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma kept : is_zero (rate zf G) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma kept_by_turns : is_zero (rate (X1 turning) G) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem orbit_is_stable : forall eps, 0 < eps -> exists del, 0 < del /\
  forall (x1 x2 x3 : R -> R) (T : R),
  (forall t, 0 <= t <= T -> derivable_pt_lim x1 t (f1 (x1 t) (x2 t) (x3 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x2 t (f2 (x1 t) (x2 t) (x3 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x3 t (f3 (x1 t) (x2 t) (x3 t))) ->
  distance2 (x1 0) (x2 0) (x3 0) < del ->
  forall t, 0 <= t <= T -> exists a : R,
  distance2 (turn1 a (x1 t) (x2 t) (x3 t)) (turn2 a (x1 t) (x2 t) (x3 t)) (turn3 a (x1 t) (x2 t) (x3 t)) < eps.
Proof.
  intros eps pe.
  destruct (confined_up_to_turns 3 zf zp turning symmetry G slice forms margin radius minimum kept kept_by_turns
    eps pe) as (del & pd & h).
  exists del; split; [exact pd|]. intros x1 x2 x3 T s1 s2 s3 near t ht.
  assert (k : exists a, off 3 zp (turn turning a (path [x1; x2; x3] t)) < eps).
  2: { destruct k as (a & k). exists a. rewrite reads_distance, reads_turn1, reads_turn2, reads_turn3 in k. exact k. }
  apply (h (path [x1; x2; x3]) T);
    [| intros; apply path_inside; simpl; lia | rewrite reads_distance; exact near | exact ht].
  intros [|[|[|i]]] r hr.
  { rewrite reads1; exact (s1 r hr). }
  { rewrite reads2; exact (s2 r hr). }
  { rewrite reads3; exact (s3 r hr). }
  apply still_beyond; simpl; lia.
Qed.
Print Assumptions orbit_is_stable.
