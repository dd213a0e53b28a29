(** * Errors of double-double sums

    polhode's [add] is the shorter of the two algorithms in use: where the leading digits of x and y cancel, the error
    stays small beside the operands, not beside the sum.

    - [add_error]: at most 6 u^2 (|x_high| + |y_high|), for all operands, no matter how small;
    - [add_error_one_sign]: at most 4 u^2 relative, for operands of one sign.

    The final renormalisation is included, also where cancellation leaves a sum smaller than the error term, so that
    Dekker's condition fails.  The definition has the operations of the code in the code's order.

    Code: [add] of polhode.special._doubledouble and polhode.exact._kernel_arithmetic; [subtract] adds the negative. *)
From Coq Require Import Reals ZArith Lia Lra.
From Flocq Require Import Core.
From Interval Require Import Tactic.
From Polhode.rounding Require Import Grid Sums Products DoubleDouble.
Local Open Scope R_scope.

Definition add (two_sum : R -> R -> R * R) xh xl yh yl :=
  let (s, e) := two_sum xh yh in
  let e := rnd (e + rnd (xl + yl)) in
  fast_two_sum s e.

(* x a + y b with small a and b *)
Lemma combination_small x y a b most :
  Rabs a <= most -> Rabs b <= most -> Rabs (x * a + y * b) <= most * (Rabs x + Rabs y).
Proof.
  intros small_a small_b.
  eapply Rle_trans; [apply Rabs_triang|].
  rewrite !Rabs_mult.
  assert (px := Rabs_pos x); assert (py := Rabs_pos y); nra.
Qed.

(* what the last step loses where the second number is the larger *)
Lemma fast_two_sum_anyway a b :
  double a -> double b -> Rabs a <= Rabs b ->
  Rabs (fst (fast_two_sum a b) + snd (fast_two_sum a b) - (a + b)) <= 1.01 * u * Rabs b.
Proof.
  intros da db order.
  destruct (rnd_sum a b da db) as (d1 & s1 & e1).
  destruct (rnd_difference (rnd (a + b)) a (double_rnd _) da) as (d2 & s2 & e2).
  destruct (rnd_difference b (rnd (rnd (a + b) - a)) db (double_rnd _)) as (d3 & s3 & e3).
  unfold fast_two_sum, fst, snd.
  destruct (Req_dec b 0) as [zero|nonzero].
  { rewrite zero, Rabs_R0 in order.
    assert (a0 : a = 0) by (destruct (Req_dec a 0) as [z|n]; [exact z | assert (h := Rabs_pos_lt _ n); lra]).
    rewrite e3, e2, e1, a0, zero, Rabs_R0.
    match goal with |- Rabs ?z <= _ => replace z with 0 by ring end.
    rewrite Rabs_R0; lra. }
  set (w := a / b).
  assert (small_w : Rabs w <= 1).
  { unfold w, Rdiv; rewrite Rabs_mult, Rabs_inv.
    apply (Rmult_le_reg_r (Rabs b)); [now apply Rabs_pos_lt|].
    rewrite Rmult_assoc, Rinv_l by (now apply Rabs_no_R0); lra. }
  assert (value_a : a = b * w) by (unfold w; field; exact nonzero).
  rewrite e3, e2, e1, value_a; clearbody w.
  replace ((b * w + b) * (1 + d1) + (b - ((b * w + b) * (1 + d1) - b * w) * (1 + d2)) * (1 + d3) - (b * w + b))
    with (b * (- (1 + (w + 1) * d1) * d2 - ((w + 1) * d1 + (1 + (w + 1) * d1) * d2) * d3)) by ring.
  rewrite Rabs_mult, Rmult_comm.
  apply Rmult_le_compat_r; [apply Rabs_pos|].
  unfold u in *; interval with (i_prec 120).
Qed.

Section Sum.

Variables (two_sum : R -> R -> R * R) (xh xl yh yl : R).
Hypotheses (sum : fst (two_sum xh yh) = rnd (xh + yh)) (exact : fst (two_sum xh yh) + snd (two_sum xh yh) = xh + yh).
Hypotheses (double_e : double (snd (two_sum xh yh))).
Hypotheses (dx : double xh) (dy : double yh) (dxl : double xl) (dyl : double yl).
Hypotheses (small_x : Rabs xl <= u * Rabs xh) (small_y : Rabs yl <= u * Rabs yh).

Let s := fst (two_sum xh yh).
Let e := snd (two_sum xh yh).
Let q := rnd (e + rnd (xl + yl)).
Let r := add two_sum xh xl yh yl.

Lemma add_steps :
  r = fast_two_sum s q
  /\ Rabs (s + q - (xh + xl + (yh + yl))) <= 3.5 * u ^ 2 * (Rabs xh + Rabs yh)
  /\ Rabs q <= 2.01 * u * (Rabs xh + Rabs yh).
Proof.
  destruct (low_part _ _ small_x) as (a & sa & value_x); destruct (low_part _ _ small_y) as (b & sb & value_y).
  destruct (rnd_sum xh yh dx dy) as (d0 & s0 & e0).
  destruct (rnd_sum xl yl dxl dyl) as (d1 & s1 & e1).
  destruct (rnd_sum e (rnd (xl + yl)) double_e (double_rnd _)) as (d2 & s2 & e2).
  assert (value_s : s = (xh + yh) * (1 + d0)) by (unfold s; now rewrite sum, e0).
  assert (value_e : e = - (xh + yh) * d0) by (unfold e; unfold s in value_s; lra).
  assert (value_q : q = xh * ((- d0 + a * (1 + d1)) * (1 + d2)) + yh * ((- d0 + b * (1 + d1)) * (1 + d2))).
  { unfold q; rewrite e2, value_e, e1, value_x, value_y; ring. }
  refine (conj _ (conj _ _)).
  - unfold r, add, s, q, e; now rewrite (surjective_pairing (two_sum xh yh)).
  - rewrite value_s, value_q, value_x, value_y.
    match goal with |- Rabs ?z <= _ =>
      replace z with (xh * (- d0 * d2 + a * (d1 + d2 + d1 * d2)) + yh * (- d0 * d2 + b * (d1 + d2 + d1 * d2))) by ring
    end.
    apply combination_small; unfold u in *; interval with (i_prec 200).
  - rewrite value_q.
    apply combination_small; unfold u in *; interval with (i_prec 200).
Qed.

Let double_s : double s.
Proof. unfold s; rewrite sum; apply double_rnd. Qed.

Theorem add_error : Rabs (fst r + snd r - (xh + xl + (yh + yl))) <= 6 * u ^ 2 * (Rabs xh + Rabs yh).
Proof.
  destruct add_steps as (-> & before & small_q).
  assert (size : 0 <= Rabs xh + Rabs yh) by (assert (px := Rabs_pos xh); assert (py := Rabs_pos yh); lra).
  destruct (Rle_or_lt (Rabs q) (Rabs s)) as [order|swapped].
  - rewrite (fast_two_sum_exact s q double_s (double_rnd _) order).
    apply Rle_trans with (1 := before); assert (0 < u ^ 2) by (unfold u; lra); nra.
  - assert (last := fast_two_sum_anyway s q double_s (double_rnd _) ltac:(lra)).
    match goal with |- Rabs (?f - ?z) <= _ => replace (f - z) with ((f - (s + q)) + (s + q - z)) by ring end.
    eapply Rle_trans; [apply Rabs_triang|].
    assert (0 < u) by (unfold u; lra).
    assert (Rabs q * u <= 2.01 * u * (Rabs xh + Rabs yh) * u) by (apply Rmult_le_compat_r; lra).
    assert (0 <= u ^ 2 * (Rabs xh + Rabs yh)) by (apply Rmult_le_pos; [apply pow2_ge_0 | exact size]).
    nra.
Qed.

Theorem add_error_one_sign :
  0 <= xh * yh -> Rabs (fst r + snd r - (xh + xl + (yh + yl))) <= 4 * u ^ 2 * Rabs (xh + xl + (yh + yl)).
Proof.
  intros one_sign.
  destruct add_steps as (-> & before & small_q).
  assert (px := Rabs_pos xh); assert (py := Rabs_pos yh).
  assert (together : Rabs (xh + yh) = Rabs xh + Rabs yh).
  { unfold Rabs in *; repeat destruct Rcase_abs; nra. }
  assert (whole : (1 - u) * (Rabs xh + Rabs yh) <= Rabs (xh + xl + (yh + yl))).
  { assert (triangle := Rabs_triang_inv (xh + yh) (- (xl + yl))); rewrite Rabs_Ropp in triangle.
    replace (xh + yh - - (xl + yl)) with (xh + xl + (yh + yl)) in triangle by ring.
    assert (parts := Rabs_triang xl yl); lra. }
  assert (order : Rabs q <= Rabs s).
  { destruct (rnd_sum xh yh dx dy) as (d & small & value).
    unfold s; rewrite sum, value, Rabs_mult, together.
    apply Rabs_le_inv in small; unfold u in small, small_q; rewrite (Rabs_pos_eq (1 + d)) by lra; nra. }
  rewrite (fast_two_sum_exact s q double_s (double_rnd _) order).
  apply Rle_trans with (1 := before).
  assert (0 < u ^ 2) by (unfold u; lra).
  apply Rle_trans with (4 * u ^ 2 * ((1 - u) * (Rabs xh + Rabs yh))).
  - unfold u in *; nra.
  - apply Rmult_le_compat_l; [lra | exact whole].
Qed.

End Sum.

(* both ways to add two floats are such *)
Theorem numpy_add_error xh xl yh yl :
  double xh -> double yh -> double xl -> double yl -> Rabs xl <= u * Rabs xh -> Rabs yl <= u * Rabs yh ->
  let r := add numpy_two_sum xh xl yh yl in
  Rabs (fst r + snd r - (xh + xl + (yh + yl))) <= 6 * u ^ 2 * (Rabs xh + Rabs yh).
Proof.
  intros; apply add_error; auto; [now apply numpy_two_sum_exact | apply double_rnd].
Qed.

Theorem kernel_add_error xh xl yh yl :
  double xh -> double yh -> double xl -> double yl -> Rabs xl <= u * Rabs xh -> Rabs yl <= u * Rabs yh ->
  let r := add kernel_two_sum xh xl yh yl in
  Rabs (fst r + snd r - (xh + xl + (yh + yl))) <= 6 * u ^ 2 * (Rabs xh + Rabs yh).
Proof.
  intros; apply add_error; auto; [now apply kernel_two_sum_exact | apply double_rnd].
Qed.
