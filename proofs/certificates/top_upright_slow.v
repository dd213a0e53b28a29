(* HeavyTop: (0, 0, 1/2, 0, 0, 1) is unstable.

Arbitrarily near the point are starts from which no solution stays near it beyond some time:
the theorem at the end, about the equations f1, f2, ...
Of the numbers that came in, each double is the shortest decimal that rounds to it.
Written by polhode; checked by `coqc -Q . Polhode checker.v` and `coqc -Q . Polhode top_upright_slow.v` in this folder. *)
From Coq Require Import Reals QArith List Lra Lia.
From Polhode Require Import checker.
Import ListNotations.
Local Open Scope R_scope.

(* the equations: the rate of change of each coordinate *)
Definition f1 (x1 x2 x3 x4 x5 x6 : R) : R := (-1 / 6) * x2 * x3 + x5.
Definition f2 (x1 x2 x3 x4 x5 x6 : R) : R := (2 / 3) * x1 * x3 + (-1) * x4.
Definition f3 (x1 x2 x3 x4 x5 x6 : R) : R := (-1 / 2) * x1 * x2.
Definition f4 (x1 x2 x3 x4 x5 x6 : R) : R := (-1 / 2) * x2 * x6 + (1 / 3) * x3 * x5.
Definition f5 (x1 x2 x3 x4 x5 x6 : R) : R := x1 * x6 + (-1 / 3) * x3 * x4.
Definition f6 (x1 x2 x3 x4 x5 x6 : R) : R := (-1) * x1 * x5 + (1 / 2) * x2 * x4.
(* the square of the distance from the point *)
Definition distance2 (x1 x2 x3 x4 x5 x6 : R) : R := (x1 - (0)) * (x1 - (0)) + (x2 - (0)) * (x2 - (0)) + (x3 - (1 /
  2)) * (x3 - (1 / 2)) + (x4 - (0)) * (x4 - (0)) + (x5 - (0)) * (x5 - (0)) + (x6 - (1)) * (x6 - (1)).

(* the same as data: polynomials are lists of coefficient and variables, counted from 0 *)
Definition field : list poly := [
  [((-1#6), [1; 2]%nat); ((1#1), [4]%nat)];
  [((2#3), [0; 2]%nat); ((-1#1), [3]%nat)];
  [((-1#2), [0; 1]%nat)];
  [((-1#2), [1; 5]%nat); ((1#3), [2; 4]%nat)];
  [((1#1), [0; 5]%nat); ((-1#3), [2; 3]%nat)];
  [((-1#1), [0; 4]%nat); ((1#2), [1; 3]%nat)]].
Definition point : list Q := [(0#1); (0#1); (1#2); (0#1); (0#1); (1#1)].
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

(* V grows: its rate of change is at least 62/63 V near the point *)
Definition V : poly := [((3#8), [0; 0]%nat); ((-1#1), [0; 3]%nat); ((3#2), [0; 4]%nat); ((5#8), [1; 1]%nat);
  ((-13#4), [1; 3]%nat); ((-3#4), [1; 4]%nat); ((-1#1), [2; 2]%nat); ((17#8), [3; 3]%nat); ((1#4), [3; 4]%nat);
  ((1#2), [4; 4]%nat); ((-1#1), [5; 5]%nat)].
Definition direction : list Q := [(5#32); (5#8); (0#1); (-1#1); (-7#64); (0#1)].
Definition gamma : Q := (31#63).
Definition margin : Q := (1#4).
Definition radius : Q := (1#256).
Definition forms : list (Q * list Q) := [((37#42), [(1#1); (35#592); (0#1); (-25#444); (-3#37); (0#1)]);
  ((903269#1193472), [(0#1); (1#1); (0#1); (22444#903269); (-26928#903269); (0#1)]);
  ((185#252), [(0#1); (0#1); (1#1); (0#1); (0#1); (0#1)]);
  ((1179733003#1365742728), [(0#1); (0#1); (0#1); (1#1); (52871205#2359466006); (0#1)]);
  ((1885324094029#2378341734048), [(0#1); (0#1); (0#1); (0#1); (1#1); (0#1)]);
  ((185#252), [(0#1); (0#1); (0#1); (0#1); (0#1); (1#1)])].
Lemma checked : check_growth 6 zf zp V direction radius gamma margin forms = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem equilibrium_is_unstable : exists eps, 0 < eps /\ forall del, 0 < del ->
  exists p1 p2 p3 p4 p5 p6 : R, distance2 p1 p2 p3 p4 p5 p6 < del /\ exists last : R,
  forall (x1 x2 x3 x4 x5 x6 : R -> R) (T : R),
  (forall t, 0 <= t <= T -> derivable_pt_lim x1 t (f1 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x2 t (f2 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x3 t (f3 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x4 t (f4 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x5 t (f5 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x6 t (f6 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t))) ->
  x1 0 = p1 -> x2 0 = p2 -> x3 0 = p3 -> x4 0 = p4 -> x5 0 = p5 -> x6 0 = p6 ->
  (forall t, 0 <= t <= T -> distance2 (x1 t) (x2 t) (x3 t) (x4 t) (x5 t) (x6 t) <= eps) -> T <= last.
Proof.
  destruct (growing 6 zf zp V direction radius gamma margin forms checked) as (eps & pe & h).
  exists eps; split; [exact pe|]. intros del pd. destruct (h del pd) as (p & ins & near & last & k).
  exists (p 0%nat), (p 1%nat), (p 2%nat), (p 3%nat), (p 4%nat), (p 5%nat). rewrite reads_distance in near.
  split; [exact near|]. exists last.
  intros x1 x2 x3 x4 x5 x6 T s1 s2 s3 s4 s5 s6 b1 b2 b3 b4 b5 b6 stays.
  apply (k (path [x1; x2; x3; x4; x5; x6]) T).
  - intros [|[|[|[|[|[|i]]]]]] r hr.
  { rewrite reads1; exact (s1 r hr). }
  { rewrite reads2; exact (s2 r hr). }
  { rewrite reads3; exact (s3 r hr). }
  { rewrite reads4; exact (s4 r hr). }
  { rewrite reads5; exact (s5 r hr). }
  { rewrite reads6; exact (s6 r hr). }
  apply still_beyond; simpl; lia.
  - intros; apply path_inside; simpl; lia.
  - intros [|[|[|[|[|[|i]]]]]]; [exact b1|exact b2|exact b3|exact b4|exact b5|exact b6|].
    rewrite path_beyond by (simpl; lia). rewrite ins by lia. unfold zp, entry_of. rewrite nth_overflow by (simpl; lia).
    rewrite Q2R_0; reflexivity.
  - intros t ht. rewrite reads_distance. exact (stays t ht).
Qed.
Print Assumptions equilibrium_is_unstable.
