(** * Quadratic vector fields in n unknowns as data: for each unknown a list of terms factor x_left x_right

    The size of such a field and its Lipschitz constant on a cube are read off the list.  Sums over the unknowns come
    with the few facts that the flow needs: derivative, sign, comparison with one term. *)
From Coq Require Import Reals Lra Psatz Lia List.
From Coquelicot Require Import Coquelicot.
Local Open Scope R_scope.

Record term := Term { factor : R; left : nat; right : nat }.
Definition evaluate (l : list term) (x : nat -> R) :=
  fold_right (fun t s => factor t * (x (left t) * x (right t)) + s) 0 l.
Definition weight (l : list term) := fold_right (fun t s => Rabs (factor t) + s) 0 l.
Definition within n (l : list term) := List.Forall (fun t => (left t < n)%nat /\ (right t < n)%nat) l.

Lemma weight_positive l : 0 <= weight l.
Proof.
  induction l as [|t l rest]; [apply Rle_refl|].
  assert (size := Rabs_pos (factor t)).
  cbn; unfold weight in rest; lra.
Qed.

(* Sums over the n unknowns. *)
Fixpoint total n (f : nat -> R) := match n with 0%nat => 0 | S m => total m f + f m end.

Lemma total_ext n f g : (forall i, (i < n)%nat -> f i = g i) -> total n f = total n g.
Proof.
  induction n as [|n hypothesis]; intros equal; [reflexivity|].
  cbn [total].
  rewrite (equal n (Nat.lt_succ_diag_r n)), hypothesis; auto.
Qed.

Lemma total_scal n k f : total n (fun i => k * f i) = k * total n f.
Proof.
  induction n as [|n hypothesis]; cbn [total]; [ring|].
  rewrite hypothesis; ring.
Qed.

Lemma total_derive n (f : R -> nat -> R) df t : (forall i, (i < n)%nat -> is_derive (fun x => f x i) t (df i)) ->
  is_derive (fun x => total n (f x)) t (total n df).
Proof.
  induction n as [|n hypothesis]; intros each.
  - exact (is_derive_const 0 t).
  - cbn [total].
    apply (is_derive_plus (fun x => total n (f x)) (fun x => f x n)); auto.
Qed.

Lemma total_positive n f : (forall i, (i < n)%nat -> 0 <= f i) -> 0 <= total n f.
Proof.
  induction n as [|n hypothesis]; intros each; cbn [total]; [lra|].
  assert (last := each n (Nat.lt_succ_diag_r n)).
  assert (rest := hypothesis (fun i hi => each i (Nat.lt_lt_succ_r i n hi))).
  lra.
Qed.

Lemma total_ge_term n f i : (forall i, (i < n)%nat -> 0 <= f i) -> (i < n)%nat -> f i <= total n f.
Proof.
  induction n as [|n hypothesis]; intros each hi; [lia|].
  cbn [total].
  assert (earlier := fun i hi => each i (Nat.lt_lt_succ_r i n hi)).
  destruct (Nat.eq_dec i n) as [->|other].
  - assert (rest := total_positive n f earlier); lra.
  - assert (last := each n (Nat.lt_succ_diag_r n)).
    assert (rest := hypothesis earlier ltac:(lia)).
    lra.
Qed.

Lemma total_bound n f k : (forall i, (i < n)%nat -> Rabs (f i) <= k) -> Rabs (total n f) <= INR n * k.
Proof.
  induction n as [|n hypothesis]; intros each; [cbn; rewrite Rabs_R0; lra|].
  cbn [total].
  rewrite S_INR.
  assert (last := each n (Nat.lt_succ_diag_r n)).
  assert (rest := hypothesis (fun i hi => each i (Nat.lt_lt_succ_r i n hi))).
  assert (triangle := Rabs_triang (total n f) (f n)).
  lra.
Qed.

(* How much the right-hand side changes, for states of size at most b that differ by at most d. *)
Lemma evaluate_difference n l x y b d : within n l -> 0 <= d ->
  (forall i, (i < n)%nat -> Rabs (x i) <= b /\ Rabs (y i) <= b /\ Rabs (x i - y i) <= d) ->
  Rabs (evaluate l x - evaluate l y) <= weight l * (2 * b * d).
Proof.
  intros inside d_positive near.
  induction inside as [|t l (hl & hr) inside rest].
  - cbn.
    rewrite Rminus_0_r, Rabs_R0; lra.
  - cbn [evaluate weight fold_right].
    fold (evaluate l x) (evaluate l y) (weight l).
    destruct (near (left t) hl) as (_ & yl & dl).
    destruct (near (right t) hr) as (xr & _ & dr).
    replace (factor t * (x (left t) * x (right t)) + evaluate l x -
      (factor t * (y (left t) * y (right t)) + evaluate l y)) with
      (factor t * ((x (left t) - y (left t)) * x (right t) + y (left t) * (x (right t) - y (right t))) +
        (evaluate l x - evaluate l y)) by ring.
    eapply Rle_trans; [apply Rabs_triang|].
    rewrite Rabs_mult, Rmult_plus_distr_r.
    apply Rplus_le_compat; [|exact rest].
    apply Rmult_le_compat_l; [apply Rabs_pos|].
    eapply Rle_trans; [apply Rabs_triang|].
    rewrite !Rabs_mult.
    assert (first := Rmult_le_compat _ _ _ _ (Rabs_pos _) (Rabs_pos _) dl xr).
    assert (other := Rmult_le_compat _ _ _ _ (Rabs_pos _) (Rabs_pos _) yl dr).
    lra.
Qed.
