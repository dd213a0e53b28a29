(* FreeRigidBody: (1, 0, 0) is unstable.

Arbitrarily near the point are starts from which no solution stays near it beyond some time:
the theorem at the end, about the equations f1, f2, ...
Of the numbers that came in, each double is the shortest decimal that rounds to it.
Written by polhode; checked by `coqc -Q . Polhode checker.v` and `coqc -Q . Polhode free_equator.v` in this folder. *)
From Coq Require Import Reals QArith List Lra Lia.
From Polhode Require Import checker.
Import ListNotations.
Local Open Scope R_scope.

(* the equations: the rate of change of each coordinate *)
Definition f1 (x1 x2 x3 : R) : R := (-1 / 2) * x2 * x3.
Definition f2 (x1 x2 x3 : R) : R := (1 / 2) * x1 * x3.
Definition f3 (x1 x2 x3 : R) : R := 0.
(* the square of the distance from the point *)
Definition distance2 (x1 x2 x3 : R) : R := (x1 - (1)) * (x1 - (1)) + (x2 - (0)) * (x2 - (0)) + (x3 - (0)) * (x3 -
  (0)).

(* the same as data: polynomials are lists of coefficient and variables, counted from 0 *)
Definition field : list poly := [
  [((-1#2), [1; 2]%nat)];
  [((1#2), [0; 2]%nat)];
  []].
Definition point : list Q := [(1#1); (0#1); (0#1)].
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

(* V drifts: its rate of change is K q, with K conserved *)
Definition V : poly := [((1#2), [1; 2]%nat)].
Definition K : poly := [((1#4), [2; 2]%nat)].
Definition q : poly := [((1#1), [0]%nat); ((1#1), []%nat)].
Definition direction : list Q := [(0#1); (0#1); (1#1)].
Definition radius : Q := (1#2).
Lemma checked : check_drift 3 zf zp V direction radius K q = true.
Proof. vm_cast_no_check (eq_refl true). Qed.

Theorem equilibrium_is_unstable : exists eps, 0 < eps /\ forall del, 0 < del ->
  exists p1 p2 p3 : R, distance2 p1 p2 p3 < del /\ exists last : R,
  forall (x1 x2 x3 : R -> R) (T : R),
  (forall t, 0 <= t <= T -> derivable_pt_lim x1 t (f1 (x1 t) (x2 t) (x3 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x2 t (f2 (x1 t) (x2 t) (x3 t))) ->
  (forall t, 0 <= t <= T -> derivable_pt_lim x3 t (f3 (x1 t) (x2 t) (x3 t))) ->
  x1 0 = p1 -> x2 0 = p2 -> x3 0 = p3 ->
  (forall t, 0 <= t <= T -> distance2 (x1 t) (x2 t) (x3 t) <= eps) -> T <= last.
Proof.
  destruct (drifting 3 zf zp V direction radius K q checked) as (eps & pe & h).
  exists eps; split; [exact pe|]. intros del pd. destruct (h del pd) as (p & ins & near & last & k).
  exists (p 0%nat), (p 1%nat), (p 2%nat). rewrite reads_distance in near.
  split; [exact near|]. exists last.
  intros x1 x2 x3 T s1 s2 s3 b1 b2 b3 stays.
  apply (k (path [x1; x2; x3]) T).
  - intros [|[|[|i]]] r hr.
  { rewrite reads1; exact (s1 r hr). }
  { rewrite reads2; exact (s2 r hr). }
  { rewrite reads3; exact (s3 r hr). }
  apply still_beyond; simpl; lia.
  - intros; apply path_inside; simpl; lia.
  - intros [|[|[|i]]]; [exact b1|exact b2|exact b3|].
    rewrite path_beyond by (simpl; lia). rewrite ins by lia. unfold zp, entry_of. rewrite nth_overflow by (simpl; lia).
    rewrite Q2R_0; reflexivity.
  - intros t ht. rewrite reads_distance. exact (stays t ht).
Qed.
Print Assumptions equilibrium_is_unstable.
