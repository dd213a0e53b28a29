(* HeavyTop: (6/5, 0, 21/10, 3/5, 0, 4/5) is stable.

Every solution that starts near enough stays near the point up to the flow of J1:
the theorem at the end, about the equations f1, f2, ...
Of the numbers that came in, each double is the shortest decimal that rounds to it.
Written by polhode; checked by `coqc -Q . Polhode checker.v` and `coqc -Q . Polhode top_precessing.v` in this folder. *)
From Coq Require Import Reals QArith List Lra Lia.
From Polhode Require Import checker.
Import ListNotations.
Local Open Scope R_scope.

(* the equations: the rate of change of each coordinate *)
Definition f1 (x1 x2 x3 x4 x5 x6 : R) : R := x2 * x3 + x5.
Definition f2 (x1 x2 x3 x4 x5 x6 : R) : R := (-1) * x1 * x3 + (-1) * x4.
Definition f3 (x1 x2 x3 x4 x5 x6 : R) : R := 0.
Definition f4 (x1 x2 x3 x4 x5 x6 : R) : R := (-1) * x2 * x6 + (2) * x3 * x5.
Definition f5 (x1 x2 x3 x4 x5 x6 : R) : R := x1 * x6 + (-2) * x3 * x4.
Definition f6 (x1 x2 x3 x4 x5 x6 : R) : R := (-1) * x1 * x5 + x2 * x4.
(* the square of the distance from the point *)
Definition distance2 (x1 x2 x3 x4 x5 x6 : R) : R := (x1 - (6 / 5)) * (x1 - (6 / 5)) + (x2 - (0)) * (x2 - (0)) + (x3
  - (21 / 10)) * (x3 - (21 / 10)) + (x4 - (3 / 5)) * (x4 - (3 / 5)) + (x5 - (0)) * (x5 - (0)) + (x6 - (4 / 5)) * (x6
  - (4 / 5)).

(* the same as data: polynomials are lists of coefficient and variables, counted from 0 *)
Definition field : list poly := [
  [((1#1), [1; 2]%nat); ((1#1), [4]%nat)];
  [((-1#1), [0; 2]%nat); ((-1#1), [3]%nat)];
  [];
  [((-1#1), [1; 5]%nat); ((2#1), [2; 4]%nat)];
  [((1#1), [0; 5]%nat); ((-2#1), [2; 3]%nat)];
  [((-1#1), [0; 4]%nat); ((1#1), [1; 3]%nat)]].
Definition point : list Q := [(6#5); (0#1); (21#10); (3#5); (0#1); (4#5)].
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

(* what is conserved: c1 = |P|²; c2 = Π·P; c3 = J1; c4 = H *)
Definition c1 : poly := [((1#1), [3; 3]%nat); ((1#1), [4; 4]%nat); ((1#1), [5; 5]%nat)].
Definition c2 : poly := [((1#1), [0; 3]%nat); ((1#1), [1; 4]%nat); ((1#1), [2; 5]%nat)].
Definition c3 : poly := [((1#1), [2]%nat)].
Definition c4 : poly := [((1#2), [0; 0]%nat); ((1#2), [1; 1]%nat); ((1#1), [2; 2]%nat); ((1#1), [5]%nat)].
Definition square (p : poly) (level : Q) : poly := times (add p (constant (- level))) (add p (constant (- level))).
Definition G : poly := add (scale (2#1) c1) (add (scale (-2#1) c2) (add (scale (-13#5) c3) (add (scale (1#1) c4)
  (scale (1#4) (square c1 (1#1)))))).
Definition margin : Q := (1#64).
Definition radius : Q := (1#1024).
Definition forms : list (Q * list Q) := [((31#64), [(1#1); (0#1); (0#1); (-64#31); (0#1); (0#1)]);
  ((1927#1600), [(0#1); (1#1); (0#1); (0#1); (-1024#1927); (0#1)]);
  ((63#64), [(0#1); (0#1); (1#1); (0#1); (0#1); (-64#63)]);
  ((13881#49600), [(0#1); (0#1); (0#1); (1#1); (0#1); (7936#4627)]);
  ((224985#123328), [(0#1); (0#1); (0#1); (0#1); (1#1); (0#1)]);
  ((2092757#2665152), [(0#1); (0#1); (0#1); (0#1); (0#1); (1#1)])].
Definition slice : Q := (1#2).

(* turned points: those on the orbit of the flow of J1 *)
Definition turn1 (a x1 x2 x3 x4 x5 x6 : R) : R := x1 + sin a * (x2) + (1 - cos a) * ((-1) * x1).
Definition turn2 (a x1 x2 x3 x4 x5 x6 : R) : R := x2 + sin a * ((-1) * x1) + (1 - cos a) * ((-1) * x2).
Definition turn3 (a x1 x2 x3 x4 x5 x6 : R) : R := x3 + sin a * (0) + (1 - cos a) * (0).
Definition turn4 (a x1 x2 x3 x4 x5 x6 : R) : R := x4 + sin a * (x5) + (1 - cos a) * ((-1) * x4).
Definition turn5 (a x1 x2 x3 x4 x5 x6 : R) : R := x5 + sin a * ((-1) * x4) + (1 - cos a) * ((-1) * x5).
Definition turn6 (a x1 x2 x3 x4 x5 x6 : R) : R := x6 + sin a * (0) + (1 - cos a) * (0).
Definition turning : list poly := [
  [((1#1), [1]%nat)];
  [((-1#1), [0]%nat)];
  [];
  [((1#1), [4]%nat)];
  [((-1#1), [3]%nat)];
  []].
Definition turning_twice : list poly := [
  [((-1#1), [0]%nat)];
  [((-1#1), [1]%nat)];
  [];
  [((-1#1), [3]%nat)];
  [((-1#1), [4]%nat)];
  []].
Lemma twice1 : is_zero (add (X2 turning 0) (scale (-1) (equation turning_twice 0))) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma reads_turn1 a x : turn turning a x 0 = turn1 a (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat).
Proof. unfold turn. rewrite (eval_same _ _ x twice1).
  unfold X1, turning, turning_twice, turn1. read_data. Qed.
Lemma twice2 : is_zero (add (X2 turning 1) (scale (-1) (equation turning_twice 1))) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma reads_turn2 a x : turn turning a x 1 = turn2 a (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat).
Proof. unfold turn. rewrite (eval_same _ _ x twice2).
  unfold X1, turning, turning_twice, turn2. read_data. Qed.
Lemma twice3 : is_zero (add (X2 turning 2) (scale (-1) (equation turning_twice 2))) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma reads_turn3 a x : turn turning a x 2 = turn3 a (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat).
Proof. unfold turn. rewrite (eval_same _ _ x twice3).
  unfold X1, turning, turning_twice, turn3. read_data. Qed.
Lemma twice4 : is_zero (add (X2 turning 3) (scale (-1) (equation turning_twice 3))) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma reads_turn4 a x : turn turning a x 3 = turn4 a (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat).
Proof. unfold turn. rewrite (eval_same _ _ x twice4).
  unfold X1, turning, turning_twice, turn4. read_data. Qed.
Lemma twice5 : is_zero (add (X2 turning 4) (scale (-1) (equation turning_twice 4))) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma reads_turn5 a x : turn turning a x 4 = turn5 a (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat).
Proof. unfold turn. rewrite (eval_same _ _ x twice5).
  unfold X1, turning, turning_twice, turn5. read_data. Qed.
Lemma twice6 : is_zero (add (X2 turning 5) (scale (-1) (equation turning_twice 5))) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma reads_turn6 a x : turn turning a x 5 = turn6 a (x 0%nat) (x 1%nat) (x 2%nat) (x 3%nat) (x 4%nat) (x 5%nat).
Proof. unfold turn. rewrite (eval_same _ _ x twice6).
  unfold X1, turning, turning_twice, turn6. read_data. Qed.

Lemma symmetry : check_symmetry 6 turning = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma minimum : check_extremum 6 zp G (let w := shift zp (across 6 zp turning) in scale slice (times w w))
  forms margin radius = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma kept : is_zero (rate zf G) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.
Lemma kept_by_turns : is_zero (rate (X1 turning) G) = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem orbit_is_stable : forall eps, 0 < eps -> exists del, 0 < del /\
  forall (x1 x2 x3 x4 x5 x6 : R -> R) (T : R),
  (forall t, 0 <= t <= T -> derivable_pt_lim x1 t (f1 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x2 t (f2 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x3 t (f3 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x4 t (f4 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x5 t (f5 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x6 t (f6 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  distance2 (x1 0) (x2 0) (x3 0) (x4 0) (x5 0) (x6 0) < del ->
  forall t, 0 <= t <= T -> exists a : R,
  distance2 (turn1 a (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t)) (turn2 a (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t)) (turn3 a (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t)) (turn4 a (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t)) (turn5 a (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t)) (turn6 a (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t)) < eps.
Proof.
  intros eps pe.
  destruct (confined_up_to_turns 6 zf zp turning symmetry G slice forms margin radius minimum kept kept_by_turns
    eps pe) as (del & pd & h).
  exists del; split; [exact pd|]. intros x1 x2 x3 x4 x5 x6 T s1 s2 s3 s4 s5 s6 near t ht.
  assert (k : exists a, off 6 zp (turn turning a (path [x1; x2; x3; x4; x5; x6] t)) < eps).
  2: { destruct k as (a & k). exists a. rewrite reads_distance, reads_turn1, reads_turn2, reads_turn3, reads_turn4, reads_turn5, reads_turn6 in k. exact k. }
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
Print Assumptions orbit_is_stable.
