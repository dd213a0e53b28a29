(** * Errors of double-double arithmetic

    A double-double number is a pair high + low with |low| <= u |high|, u = 2^-53.  Here are bounds of the errors of
    polhode's products, squares and quotients of such numbers, for operands of any size that neither overflow
    nor come near underflow, with the final renormalisation ([fast_two_sum]) included:

    - [multiply_error]: 9 u^2 relative;
    - [multiply_float_error], [square_error]: 4 u^2 and 7 u^2 relative;
    - [divide_error]: 16 u^2 relative.

    Sums are in [DoubleDoubleSum.v].  How the exact products come about does not matter: [numpy_product_is_exact],
    [fused_product_is_exact] and [jax_product_is_exact] are the code's three ways.
    The definitions have the operations of the code in the code's order.  u^2 = 1.2e-32.

    Code: polhode.special._doubledouble and polhode.exact._kernel_arithmetic, which agree.  Compare Joldes, Muller &
    Popescu, ACM Trans. Math. Softw. 44 (2017) 15, whose bounds for these algorithms are a little smaller. *)
From Coq Require Import Reals ZArith Lia Lra.
From Flocq Require Import Core Plus_error Mult_error Relative.
From Interval Require Import Tactic.
From Polhode.rounding Require Import Grid Sums Products.
Local Open Scope R_scope.

Definition u := / 9007199254740992.

(** ** What one rounding does *)

Lemma u_is_half_ulp : / 2 * pow2 (- 53 + 1) = u.
Proof. unfold u; cbn; lra. Qed.

Lemma rnd_sum x y : double x -> double y -> exists d, Rabs d <= u /\ rnd (x + y) = (x + y) * (1 + d).
Proof.
  intros dx dy.
  destruct (FLT_plus_error_N_ex radix2 (-1074) 53 (fun x => negb (Z.even x)) x y dx dy) as (d & small & e).
  exists d; split; [|exact e].
  apply Rle_trans with (1 := small).
  change (u_ro radix2 53) with (/ 2 * pow2 (- 53 + 1)); rewrite u_is_half_ulp.
  unfold u; lra.
Qed.

Lemma rnd_difference x y : double x -> double y -> exists d, Rabs d <= u /\ rnd (x - y) = (x - y) * (1 + d).
Proof. intros dx dy; apply rnd_sum; [exact dx | now apply generic_format_opp]. Qed.

(* in units of a number [whole] that is far from underflow, what rounding of a product loses there is negligible *)
Lemma rnd_scaled whole z :
  pow2 (-900) <= Rabs whole ->
  exists d t, Rabs d <= u /\ Rabs t <= / 2 ^ 170 /\ rnd (whole * z) = whole * (z * (1 + d) + t).
Proof.
  intros large.
  destruct (error_N_FLT radix2 (-1074) 53 ltac:(lia) (fun x => negb (Z.even x)) (whole * z))
    as (d & eta & small & little & _ & e).
  assert (nonzero : whole <> 0).
  { intros zero; rewrite zero, Rabs_R0 in large; assert (h := bpow_gt_0 radix2 (-900)); lra. }
  exists d, (eta / whole); split; [now rewrite <- u_is_half_ulp | split].
  - unfold Rdiv; rewrite Rabs_mult, Rabs_inv.
    apply (Rmult_le_reg_r (Rabs whole)); [now apply Rabs_pos_lt|].
    rewrite Rmult_assoc, Rinv_l, Rmult_1_r by (now apply Rabs_no_R0).
    apply Rle_trans with (1 := little).
    apply Rle_trans with (/ 2 ^ 170 * pow2 (-900)).
    + replace (/ 2 ^ 170) with (pow2 (-170)) by (change (/ 2 ^ 170) with (/ (2 ^ 170)); cbn; lra).
      rewrite <- bpow_plus.
      apply Rle_trans with (pow2 (-1074)); [assert (h := bpow_gt_0 radix2 (-1074)); lra | apply bpow_le; lia].
    + apply Rmult_le_compat_l; [apply Rlt_le, Rinv_0_lt_compat, pow_lt; lra | exact large].
  - rewrite e; field; exact nonzero.
Qed.

Lemma rnd_normal z : pow2 (-900) <= Rabs z -> exists d, Rabs d <= u /\ rnd z = z * (1 + d).
Proof.
  intros large.
  destruct (relative_error_N_FLT_ex radix2 (-1074) 53 ltac:(lia) (fun x => negb (Z.even x)) z) as (d & small & e).
  - apply Rle_trans with (2 := large); apply bpow_le; lia.
  - exists d; split; [now rewrite <- u_is_half_ulp | exact e].
Qed.

(** ** The renormalisation *)

(* a part that is small beside the other becomes at most half a unit in the last place of the sum *)
Theorem renormalised a b :
  double a -> double b -> Rabs b <= Rabs a -> pow2 (-900) <= Rabs (a + b) ->
  fst (fast_two_sum a b) + snd (fast_two_sum a b) = a + b
  /\ Rabs (snd (fast_two_sum a b)) <= u * Rabs (fst (fast_two_sum a b)).
Proof.
  intros da db order large.
  assert (sum := fast_two_sum_exact a b da db order).
  split; [exact sum|].
  replace (snd (fast_two_sum a b)) with (- (rnd (a + b) - (a + b)))
    by (change (fst (fast_two_sum a b)) with (rnd (a + b)) in sum; lra).
  change (fst (fast_two_sum a b)) with (rnd (a + b)).
  rewrite Rabs_Ropp, <- u_is_half_ulp.
  apply relative_error_N_FLT_round; [lia|].
  apply Rle_trans with (2 := large); apply bpow_le; lia.
Qed.

(** ** Products *)

Definition multiply (two_product : R -> R -> R * R) xh xl yh yl :=
  let (p, e) := two_product xh yh in
  let cross := rnd (xh * yl) in
  let cross := rnd (cross + rnd (xl * yh)) in
  let e := rnd (e + cross) in
  fast_two_sum p e.

Definition multiply_float (two_product : R -> R -> R * R) xh xl factor :=
  let (p, e) := two_product xh factor in
  let e := rnd (e + rnd (xl * factor)) in
  fast_two_sum p e.

Definition square (two_square : R -> R * R) xh xl :=
  let (p, e) := two_square xh in
  let e := rnd (e + rnd (rnd (2 * xh) * xl)) in
  fast_two_sum p e.

(* what [Products.v] proves of the ways to multiply *)
Definition exact_product (result : R * R) z := fst result = rnd z /\ fst result + snd result = z /\ double (snd result).

(* the low part as a small multiple of the high one *)
Lemma low_part xh xl : Rabs xl <= u * Rabs xh -> exists a, Rabs a <= u /\ xl = xh * a.
Proof.
  intros small.
  destruct (Req_dec xh 0) as [zero|nonzero].
  - exists 0; rewrite Rabs_R0; split; [unfold u; lra|].
    rewrite zero, Rabs_R0, Rmult_0_r in small.
    rewrite Rmult_0_r; destruct (Req_dec xl 0) as [z|n]; [exact z|].
    assert (h := Rabs_pos_lt _ n); lra.
  - exists (xl / xh); split; [|field; exact nonzero].
    unfold Rdiv; rewrite Rabs_mult, Rabs_inv.
    apply (Rmult_le_reg_r (Rabs xh)); [now apply Rabs_pos_lt|].
    rewrite Rmult_assoc, Rinv_l, Rmult_1_r; [exact small | now apply Rabs_no_R0].
Qed.

Ltac small_reals := unfold u in *; interval with (i_prec 200).

(* a bound in units of a number, as a bound relative to a number close to it *)
Lemma relative_bound whole error factor bound :
  Rabs error <= bound * Rabs factor -> Rabs (whole * error) <= bound * Rabs (whole * factor).
Proof.
  intros h; rewrite !Rabs_mult, <- Rmult_assoc, (Rmult_comm bound), Rmult_assoc.
  apply Rmult_le_compat_l; [apply Rabs_pos | exact h].
Qed.

(* the last step of all: p = whole (1 + d) and a correction of a few u *)
Lemma renormalised_in_units whole d E p q :
  pow2 (-880) <= Rabs whole -> Rabs d <= u -> Rabs E <= 6 * u -> p = whole * (1 + d) -> q = whole * E ->
  double p -> double q ->
  fst (fast_two_sum p q) + snd (fast_two_sum p q) = whole * (1 + d + E)
  /\ Rabs (snd (fast_two_sum p q)) <= u * Rabs (fst (fast_two_sum p q)).
Proof.
  intros large small_d small_E -> -> dp dq.
  assert (power := bpow_gt_0 radix2 (-900)).
  assert (factor : pow2 (-880) = 1048576 * pow2 (-900)).
  { change 1048576 with (pow2 20); now rewrite <- bpow_plus. }
  apply Rabs_le_inv in small_d, small_E; unfold u in small_d, small_E.
  replace (whole * (1 + d + E)) with (whole * (1 + d) + whole * E) by ring.
  apply renormalised; [exact dp | exact dq | |].
  - rewrite !Rabs_mult; apply Rmult_le_compat_l; [apply Rabs_pos|].
    rewrite (Rabs_pos_eq (1 + d)) by lra.
    apply Rabs_le; lra.
  - rewrite <- Rmult_plus_distr_l, Rabs_mult, (Rabs_pos_eq (1 + d + E)) by lra.
    rewrite factor in large; nra.
Qed.

Lemma large_enough z : pow2 (-880) <= Rabs z -> pow2 (-900) <= Rabs z.
Proof. intros h; apply Rle_trans with (2 := h); apply bpow_le; lia. Qed.

(* operands that are exact products' inputs, in units of [whole]: p = whole (1 + d), e = - whole d *)
Lemma product_in_units result whole :
  exact_product result whole -> pow2 (-880) <= Rabs whole ->
  exists d, Rabs d <= u /\ fst result = whole * (1 + d) /\ snd result = whole * (- d) /\ double (fst result).
Proof.
  intros (first & exact & _) large.
  destruct (rnd_normal whole (large_enough _ large)) as (d & small & e).
  exists d; split; [exact small|].
  rewrite first in *; rewrite e in exact |- *.
  refine (conj eq_refl (conj _ _)); [lra | rewrite <- e; apply double_rnd].
Qed.

Theorem multiply_error two_product xh xl yh yl :
  exact_product (two_product xh yh) (xh * yh) ->
  Rabs xl <= u * Rabs xh -> Rabs yl <= u * Rabs yh -> pow2 (-880) <= Rabs (xh * yh) ->
  let r := multiply two_product xh xl yh yl in
  Rabs (fst r + snd r - (xh + xl) * (yh + yl)) <= 9 * u ^ 2 * Rabs ((xh + xl) * (yh + yl))
  /\ Rabs (snd r) <= u * Rabs (fst r).
Proof.
  intros product small_x small_y large r.
  destruct (low_part _ _ small_x) as (a & sa & ->); destruct (low_part _ _ small_y) as (b & sb & ->).
  destruct (product_in_units _ _ product large) as (d0 & s0 & value_p & value_e & dp).
  set (whole := xh * yh) in *.
  destruct (rnd_scaled whole b (large_enough _ large)) as (d1 & t1 & s1 & st1 & e1).
  destruct (rnd_scaled whole a (large_enough _ large)) as (d2 & t2 & s2 & st2 & e2).
  destruct (rnd_sum (rnd (whole * b)) (rnd (whole * a)) (double_rnd _) (double_rnd _)) as (d3 & s3 & e3).
  set (p := fst (two_product xh yh)) in *; set (e := snd (two_product xh yh)) in *.
  set (cross := rnd (rnd (whole * b) + rnd (whole * a))) in *.
  destruct (rnd_sum e cross (proj2 (proj2 product)) (double_rnd _)) as (d4 & s4 & e4).
  assert (value_r : r = fast_two_sum p (rnd (e + cross))).
  { unfold r, multiply, p, e, cross, whole.
    rewrite (surjective_pairing (two_product xh yh)).
    replace (xh * yh * b) with (xh * (yh * b)) by ring.
    now replace (xh * yh * a) with (xh * a * yh) by ring. }
  set (C := (b * (1 + d1) + t1 + (a * (1 + d2) + t2)) * (1 + d3)).
  set (E := (- d0 + C) * (1 + d4)).
  assert (value_q : rnd (e + cross) = whole * E) by (rewrite e4, value_e, e3, e1, e2; unfold E, C; ring).
  assert (small_E : Rabs E <= 6 * u) by (unfold E, C; small_reals).
  destruct (renormalised_in_units whole d0 E p _ large s0 small_E value_p value_q dp (double_rnd _)) as (sum & normal).
  rewrite value_r; split; [rewrite sum | exact normal].
  replace (whole * (1 + d0 + E) - (xh + xh * a) * (yh + yh * b))
    with (whole * ((C - d0) * d4 + (b * d1 + t1 + (a * d2 + t2))
      + (b * (1 + d1) + t1 + (a * (1 + d2) + t2)) * d3 - a * b)) by (unfold E, C, whole; ring).
  replace ((xh + xh * a) * (yh + yh * b)) with (whole * ((1 + a) * (1 + b))) by (unfold whole; ring).
  apply relative_bound.
  assert (close : 0.99 <= (1 + a) * (1 + b)) by small_reals.
  rewrite (Rabs_pos_eq ((1 + a) * (1 + b))) by lra.
  apply Rle_trans with (8.5 * u ^ 2); [unfold C; small_reals|].
  assert (0 < u ^ 2) by (unfold u; lra).
  nra.
Qed.

Theorem multiply_float_error two_product xh xl factor :
  exact_product (two_product xh factor) (xh * factor) ->
  Rabs xl <= u * Rabs xh -> pow2 (-880) <= Rabs (xh * factor) ->
  let r := multiply_float two_product xh xl factor in
  Rabs (fst r + snd r - (xh + xl) * factor) <= 4 * u ^ 2 * Rabs ((xh + xl) * factor)
  /\ Rabs (snd r) <= u * Rabs (fst r).
Proof.
  intros product small_x large r.
  destruct (low_part _ _ small_x) as (a & sa & ->).
  destruct (product_in_units _ _ product large) as (d0 & s0 & value_p & value_e & dp).
  set (whole := xh * factor) in *.
  destruct (rnd_scaled whole a (large_enough _ large)) as (d1 & t1 & s1 & st1 & e1).
  set (p := fst (two_product xh factor)) in *; set (e := snd (two_product xh factor)) in *.
  destruct (rnd_sum e (rnd (whole * a)) (proj2 (proj2 product)) (double_rnd _)) as (d2 & s2 & e2).
  assert (value_r : r = fast_two_sum p (rnd (e + rnd (whole * a)))).
  { unfold r, multiply_float, p, e, whole.
    rewrite (surjective_pairing (two_product xh factor)).
    now replace (xh * factor * a) with (xh * a * factor) by ring. }
  set (E := (- d0 + (a * (1 + d1) + t1)) * (1 + d2)).
  assert (value_q : rnd (e + rnd (whole * a)) = whole * E) by (rewrite e2, value_e, e1; unfold E; ring).
  assert (small_E : Rabs E <= 6 * u) by (unfold E; small_reals).
  destruct (renormalised_in_units whole d0 E p _ large s0 small_E value_p value_q dp (double_rnd _)) as (sum & normal).
  rewrite value_r; split; [rewrite sum | exact normal].
  replace (whole * (1 + d0 + E) - (xh + xh * a) * factor)
    with (whole * ((- d0 + (a * (1 + d1) + t1)) * d2 + a * d1 + t1)) by (unfold E, whole; ring).
  replace ((xh + xh * a) * factor) with (whole * (1 + a)) by (unfold whole; ring).
  apply relative_bound.
  assert (close : 0.99 <= 1 + a) by small_reals.
  rewrite (Rabs_pos_eq (1 + a)) by lra.
  apply Rle_trans with (3.5 * u ^ 2); [small_reals|].
  assert (0 < u ^ 2) by (unfold u; lra).
  nra.
Qed.

Theorem square_error two_square xh xl :
  exact_product (two_square xh) (xh * xh) -> double xh ->
  Rabs xl <= u * Rabs xh -> pow2 (-880) <= Rabs (xh * xh) ->
  let r := square two_square xh xl in
  Rabs (fst r + snd r - (xh + xl) ^ 2) <= 7 * u ^ 2 * Rabs ((xh + xl) ^ 2)
  /\ Rabs (snd r) <= u * Rabs (fst r).
Proof.
  intros product dx small_x large r.
  destruct (low_part _ _ small_x) as (a & sa & ->).
  destruct (product_in_units _ _ product large) as (d0 & s0 & value_p & value_e & dp).
  set (whole := xh * xh) in *.
  destruct (rnd_scaled whole (2 * a) (large_enough _ large)) as (d1 & t1 & s1 & st1 & e1).
  set (p := fst (two_square xh)) in *; set (e := snd (two_square xh)) in *.
  destruct (rnd_sum e (rnd (whole * (2 * a))) (proj2 (proj2 product)) (double_rnd _)) as (d2 & s2 & e2).
  assert (twice : rnd (2 * xh) = 2 * xh).
  { apply rnd_double; rewrite Rmult_comm; change 2 with (pow2 1).
    apply mult_bpow_pos_exact_FLT; [exact dx | lia]. }
  assert (value_r : r = fast_two_sum p (rnd (e + rnd (whole * (2 * a))))).
  { unfold r, square, p, e, whole.
    rewrite (surjective_pairing (two_square xh)), twice.
    now replace (xh * xh * (2 * a)) with (2 * xh * (xh * a)) by ring. }
  set (E := (- d0 + (2 * a * (1 + d1) + t1)) * (1 + d2)).
  assert (value_q : rnd (e + rnd (whole * (2 * a))) = whole * E) by (rewrite e2, value_e, e1; unfold E; ring).
  assert (small_E : Rabs E <= 6 * u) by (unfold E; small_reals).
  destruct (renormalised_in_units whole d0 E p _ large s0 small_E value_p value_q dp (double_rnd _)) as (sum & normal).
  rewrite value_r; split; [rewrite sum | exact normal].
  replace (whole * (1 + d0 + E) - (xh + xh * a) ^ 2)
    with (whole * ((- d0 + (2 * a * (1 + d1) + t1)) * d2 + 2 * a * d1 + t1 - a * a)) by (unfold E, whole; ring).
  replace ((xh + xh * a) ^ 2) with (whole * (1 + a) ^ 2) by (unfold whole; ring).
  apply relative_bound.
  assert (close : 0.99 <= (1 + a) ^ 2) by small_reals.
  rewrite (Rabs_pos_eq ((1 + a) ^ 2)) by lra.
  apply Rle_trans with (6.5 * u ^ 2); [small_reals|].
  assert (0 < u ^ 2) by (unfold u; lra).
  nra.
Qed.

(** ** Quotients *)

Definition divide (two_product : R -> R -> R * R) xh xl yh yl :=
  let q := rnd (xh / yh) in
  let (p, e) := two_product q yh in
  let r := rnd (xh - p) in
  let r := rnd (r - e) in
  let r := rnd (r + rnd (xl - rnd (q * yl))) in
  let r := rnd (r / yh) in
  fast_two_sum q r.

Theorem divide_error two_product xh xl yh yl :
  let q := rnd (xh / yh) in
  exact_product (two_product q yh) (q * yh) ->
  double xh -> double xl -> Rabs xl <= u * Rabs xh -> Rabs yl <= u * Rabs yh -> yh <> 0 ->
  pow2 (-870) <= Rabs xh -> pow2 (-870) <= Rabs (xh / yh) ->
  let r := divide two_product xh xl yh yl in
  Rabs (fst r + snd r - (xh + xl) / (yh + yl)) <= 16 * u ^ 2 * Rabs ((xh + xl) / (yh + yl))
  /\ Rabs (snd r) <= u * Rabs (fst r).
Proof.
  intros q product dx dxl small_x small_y nonzero large_x large_q r.
  set (ratio := xh / yh) in *.
  assert (step : forall z, pow2 (-870) <= Rabs z -> pow2 (-880) <= Rabs z)
    by (intros z h; apply Rle_trans with (2 := h); apply bpow_le; lia).
  assert (large := step _ large_q).
  destruct (low_part _ _ small_x) as (a & sa & ->); destruct (low_part _ _ small_y) as (b & sb & ->).
  destruct (rnd_normal ratio (large_enough _ large)) as (d0 & s0 & e0); fold q in e0.
  assert (whole : q * yh = xh * (1 + d0)) by (rewrite e0; unfold ratio; field; exact nonzero).
  assert (large_p : pow2 (-880) <= Rabs (q * yh)).
  { rewrite whole, Rabs_mult.
    replace (-870)%Z with (10 + -880)%Z in large_x by lia; rewrite bpow_plus in large_x.
    change (pow2 10) with 1024 in large_x.
    assert (power := bpow_gt_0 radix2 (-880)).
    apply Rabs_le_inv in s0; unfold u in s0; rewrite (Rabs_pos_eq (1 + d0)) by lra; nra. }
  destruct (product_in_units _ _ product large_p) as (d1 & s1 & value_p & value_e & dp).
  set (p := fst (two_product q yh)) in *; set (e := snd (two_product q yh)) in *.
  destruct (rnd_difference xh p dx dp) as (d2 & s2 & e2); set (r1 := rnd (xh - p)) in *.
  destruct (rnd_difference r1 e (double_rnd _) (proj2 (proj2 product))) as (d3 & s3 & e3).
  set (r2 := rnd (r1 - e)) in *.
  destruct (rnd_scaled xh ((1 + d0) * b) (large_enough _ (step _ large_x))) as (d4 & t4 & s4 & st4 & e4).
  assert (value_w : q * (yh * b) = xh * ((1 + d0) * b))
    by (rewrite <- Rmult_assoc, whole; ring).
  destruct (rnd_difference (xh * a) (rnd (q * (yh * b))) dxl (double_rnd _)) as (d5 & s5 & e5).
  set (v := rnd (xh * a - rnd (q * (yh * b)))) in *.
  destruct (rnd_sum r2 v (double_rnd _) (double_rnd _)) as (d6 & s6 & e6); set (r3 := rnd (r2 + v)) in *.
  set (delta := d0 + d1 + d0 * d1).
  set (g := - d0 - delta * d2).
  set (h := a - b - d0 * b - (1 + d0) * b * d4 - t4).
  set (sigma := g * (1 + d3) + h * (1 + d5)).
  assert (value_r3 : r3 = xh * (sigma * (1 + d6))).
  { rewrite e6, e3, e2, e5, value_w, e4, value_e, value_p, whole; unfold sigma, h, g, delta; ring. }
  destruct (rnd_scaled ratio (sigma * (1 + d6)) (large_enough _ large)) as (d7 & t7 & s7 & st7 & e7).
  set (E := sigma * (1 + d6) * (1 + d7) + t7).
  assert (value_r4 : rnd (r3 / yh) = ratio * E).
  { unfold E; rewrite <- e7, value_r3; f_equal; unfold ratio; field; exact nonzero. }
  assert (small_E : Rabs E <= 6 * u) by (unfold E, sigma, h, g, delta; small_reals).
  assert (value_result : r = fast_two_sum q (rnd (r3 / yh))).
  { unfold r, divide; fold ratio; fold q.
    now rewrite (surjective_pairing (two_product q yh)). }
  destruct (renormalised_in_units ratio d0 E q _ large s0 small_E e0 value_r4 (double_rnd _) (double_rnd _))
    as (sum & normal).
  rewrite value_result; split; [rewrite sum | exact normal].
  assert (close_x : 0.99 <= 1 + a) by small_reals; assert (close_y : 0.99 <= 1 + b <= 1.01) by (split; small_reals).
  set (Y := - delta * d2 + g * d3 - d0 * b - (1 + d0) * b * d4 - t4 + h * d5 + sigma * d6 + sigma * (1 + d6) * d7 + t7).
  assert (first_order : d0 + E = a - b + Y) by (unfold Y, E, sigma, h, g; ring).
  assert (nonzero_sum : yh + yh * b <> 0).
  { replace (yh + yh * b) with (yh * (1 + b)) by ring.
    apply Rmult_integral_contrapositive_currified; [exact nonzero | lra]. }
  replace (ratio * (1 + d0 + E) - (xh + xh * a) / (yh + yh * b)) with (ratio * ((Y + (a - b + Y) * b) / (1 + b))).
  2:{ rewrite Rplus_assoc, first_order; unfold ratio; field; repeat split;
      first [exact nonzero | exact nonzero_sum | lra]. }
  replace ((xh + xh * a) / (yh + yh * b)) with (ratio * ((1 + a) / (1 + b)))
    by (unfold ratio; field; repeat split; first [exact nonzero | exact nonzero_sum | lra]).
  apply relative_bound.
  unfold Rdiv; rewrite !Rabs_mult, <- Rmult_assoc.
  apply Rmult_le_compat_r; [apply Rabs_pos|].
  rewrite (Rabs_pos_eq (1 + a)) by lra.
  apply Rle_trans with (15.5 * u ^ 2); [unfold Y, sigma, h, g, delta; small_reals|].
  assert (0 < u ^ 2) by (unfold u; lra).
  nra.
Qed.

(** ** The code's ways to multiply are such *)

Lemma numpy_product_is_exact a b :
  double a -> double b -> pow2 (-880) <= Rabs (a * b) -> exact_product (numpy_two_product a b) (a * b).
Proof.
  intros da db large; refine (conj eq_refl (conj _ (double_rnd _))).
  apply numpy_two_product_exact; [exact da | exact db | right].
  apply Rle_trans with (2 := large); apply bpow_le; lia.
Qed.

Lemma fused_product_is_exact a b :
  double a -> double b -> pow2 (-880) <= Rabs (a * b) -> exact_product (fused_two_product a b) (a * b).
Proof.
  intros da db large; refine (conj eq_refl (conj _ (double_rnd _))).
  apply fused_two_product_exact; [exact da | exact db | right].
  apply Rle_trans with (2 := large); apply bpow_le; lia.
Qed.

Lemma jax_product_is_exact a b ah al bh bl ea eb :
  halves a ah al ea -> halves b bh bl eb -> (-1074 <= ea + eb)%Z ->
  exact_product (jax_two_product ah al bh bl) (a * b).
Proof.
  intros split_a split_b bottom.
  destruct (jax_two_product_exact a b ah al bh bl ea eb split_a split_b bottom) as (first & sum).
  refine (conj first (conj sum _)).
  unfold jax_two_product, jax_sum_of_partial_products.
  destruct numpy_two_sum as (middle & below); destruct fast_two_sum as (p & e).
  destruct numpy_two_sum as (e' & rest); destruct fast_two_sum as (p' & e'').
  apply double_rnd.
Qed.

(* multiplication as NumPy does it, all hypotheses on its operands alone *)
Corollary numpy_multiply_error xh xl yh yl :
  double xh -> double yh -> Rabs xl <= u * Rabs xh -> Rabs yl <= u * Rabs yh -> pow2 (-880) <= Rabs (xh * yh) ->
  let r := multiply numpy_two_product xh xl yh yl in
  Rabs (fst r + snd r - (xh + xl) * (yh + yl)) <= 9 * u ^ 2 * Rabs ((xh + xl) * (yh + yl)).
Proof.
  intros dx dy small_x small_y large.
  apply multiply_error; try assumption.
  now apply numpy_product_is_exact.
Qed.
