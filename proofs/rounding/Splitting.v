(** * Two ways to split a number into halves

    Veltkamp's multiplication by 2^27 + 1, which NumPy and the kernels use, and rounding of the bits to the upper 26,
    which stands in for it under JAX (XLA would simplify the multiplication away): both give halves as [Products.v]
    wants them, of a number that is not subnormal.  Hence [jax_two_product] and [numpy_two_square] are exact.

    Code: polhode._base.arrays.loops.split_halves, polhode.special._doubledouble. *)
From Coq Require Import Reals ZArith Lia Lra.
From Flocq Require Import Core Pff2Flocq.
From Polhode.rounding Require Import Grid Sums Products.
Local Open Scope R_scope.

(** ** Veltkamp's splitting *)

Lemma normal_on_grid a e : double a -> (-1074 <= e)%Z -> pow2 (52 + e) <= Rabs a -> exists m, on_grid e m a.
Proof.
  intros da bottom low.
  rewrite <- (rnd_double a da).
  now apply rnd_on_grid.
Qed.

Theorem veltkamp_halves a e :
  double a -> (-1074 <= e)%Z -> pow2 (52 + e) <= Rabs a -> Rabs a <= IZR (2 ^ 53 - 1) * pow2 e ->
  halves a (numpy_high a) (numpy_low a) e.
Proof.
  intros da bottom low high.
  assert (form : numpy_high a = rnd (rnd (a - rnd (a * (pow2 27 + 1))) + rnd (a * (pow2 27 + 1)))).
  { unfold numpy_high.
    replace (134217729 * a) with (a * (pow2 27 + 1)) by (cbn; ring).
    set (p := rnd (a * (pow2 27 + 1))).
    rewrite <- (Ropp_minus_distr a p), rnd_opp.
    f_equal; ring. }
  destruct (Veltkamp radix2 (-1074) 53 (fun x => negb (Z.even x)) 27 ltac:(lia) ltac:(lia) ltac:(lia) ltac:(lia) a da)
    as (choice & rounded).
  destruct (Veltkamp_tail radix2 (-1074) 53 (fun x => negb (Z.even x)) 27 ltac:(lia) ltac:(lia) ltac:(lia) ltac:(lia)
    a da) as (sum & _).
  rewrite <- form in rounded, sum.
  fold (numpy_low a) in sum.
  change (53 - 27)%Z with 26%Z in rounded.
  assert (positive := bpow_gt_0 radix2 e).
  assert (nonzero : a <> 0).
  { intros z; rewrite z, Rabs_R0 in low; assert (h := bpow_gt_0 radix2 (52 + e)); lra. }
  assert (top : (mag radix2 a <= 53 + e)%Z).
  { apply mag_le_bpow; [exact nonzero|].
    rewrite bpow_plus; cbn in high |- *; lra. }
  assert (exponent : cexp radix2 (FLT_exp (-1074) 26) a = (27 + e)%Z).
  { unfold cexp, FLT_exp.
    assert (52 + e + 1 <= mag radix2 a)%Z
      by (apply mag_ge_bpow; now replace (52 + e + 1 - 1)%Z with (52 + e)%Z by lia).
    lia. }
  assert (small : Rabs (numpy_high a - a) <= pow2 (26 + e)).
  { rewrite rounded.
    eapply Rle_trans; [apply error_le_half_ulp; apply FLT_exp_valid; now compute|].
    rewrite ulp_neq_0, exponent by exact nonzero.
    replace (27 + e)%Z with (1 + (26 + e))%Z by lia.
    rewrite bpow_plus; change (pow2 1) with 2; lra. }
  assert (grid_high : exists k, numpy_high a = IZR k * pow2 (27 + e)).
  { exists (Znearest choice (scaled_mantissa radix2 (FLT_exp (-1074) 26) a)).
    rewrite rounded at 1; unfold round, F2R; cbn [Fnum Fexp].
    now rewrite exponent. }
  destruct grid_high as (k & value).
  assert (grid_k : on_grid (27 + e) (Z.abs k) (numpy_high a)) by (exists k; split; [exact value | lia]).
  destruct (normal_on_grid a e da bottom low) as (m & grid_a).
  rewrite bpow_plus in small; change (pow2 26) with (IZR (2 ^ 26)) in small.
  split; [exact sum | | | exact low | exact high].
  - apply (grid_size _ _ _ _ grid_k).
    assert (triangle := Rabs_triang_inv (numpy_high a) (numpy_high a - a)).
    assert (whole := Rabs_triang (numpy_high a - a) a).
    replace (numpy_high a - a + a) with (numpy_high a) in whole by ring.
    (* a whole multiple of 2^27 units below 2^53 + 2^26 of them is at most 2^53 *)
    rewrite value, bpow_plus, Rabs_mult, (Rabs_pos_eq (pow2 27 * pow2 e)) in * by (cbn; lra).
    apply Rmult_le_compat_r; [cbn; lra|].
    rewrite <- abs_IZR; apply IZR_le.
    assert (bound : IZR (Z.abs k) < IZR (2 ^ 26 + 1)).
    { rewrite abs_IZR.
      apply (Rmult_lt_reg_r (pow2 27 * pow2 e)); [cbn; lra|].
      cbn in *; lra. }
    apply lt_IZR in bound; lia.
  - assert (low_value : numpy_low a = a - numpy_high a) by lra.
    rewrite low_value.
    assert (fine := grid_refine e 27 (Z.abs k) (numpy_high a)).
    rewrite (Z.add_comm e 27) in fine.
    apply (grid_size _ _ _ _ (grid_sub _ _ _ _ _ grid_a (fine grid_k ltac:(lia)))).
    now rewrite Rabs_minus_sym.
Qed.

Theorem numpy_two_square_exact a e :
  double a -> pow2 (52 + e) <= Rabs a -> Rabs a <= IZR (2 ^ 53 - 1) * pow2 e -> (-1074 <= e)%Z -> (-1074 <= e + e)%Z ->
  fst (numpy_two_square a) + snd (numpy_two_square a) = a * a.
Proof.
  intros da low high bottom no_underflow.
  exact (square_by_halves_exact a _ _ e (veltkamp_halves a e da bottom low high) no_underflow).
Qed.

(** ** Splitting by bits *)

(* The code's (bits + (1 << 26)) & -(1 << 27), on the 63 bits below the sign *)
Definition masked_bits (bits : Z) : Z := Z.land (bits + 2 ^ 26) (- 2 ^ 27).

(* the number with given bits, exponent and fraction of a normal number *)
Definition number_of_bits (bits : Z) : R := IZR (2 ^ 52 + bits mod 2 ^ 52) * pow2 (bits / 2 ^ 52 - 1075).

Lemma masked_bits_value bits : masked_bits bits = ((bits + 2 ^ 26) / 2 ^ 27 * 2 ^ 27)%Z.
Proof.
  unfold masked_bits.
  change (- 2 ^ 27)%Z with (Z.lnot (Z.ones 27)).
  rewrite <- Z.ldiff_land, Z.ldiff_ones_r by lia.
  now rewrite Z.shiftr_div_pow2, Z.shiftl_mul_pow2 by lia.
Qed.

(* a sign bit, as the sign of the integer, stays as it is *)
Theorem mask_keeps_sign bits : masked_bits (- 2 ^ 63 + bits) = (- 2 ^ 63 + masked_bits bits)%Z.
Proof.
  rewrite !masked_bits_value.
  replace (- 2 ^ 63 + bits + 2 ^ 26)%Z with (bits + 2 ^ 26 + (- 2 ^ 36) * 2 ^ 27)%Z by lia.
  rewrite Z.div_add by lia.
  lia.
Qed.

Theorem mask_halves exponent fraction :
  (1 <= exponent)%Z -> (0 <= fraction < 2 ^ 52)%Z ->
  let bits := (exponent * 2 ^ 52 + fraction)%Z in
  let a := number_of_bits bits in
  let high := number_of_bits (masked_bits bits) in
  halves a high (rnd (a - high)) (exponent - 1075).
Proof.
  intros normal_exponent range bits a high.
  set (e := (exponent - 1075)%Z).
  assert (value : a = IZR (2 ^ 52 + fraction) * pow2 e).
  { unfold a, number_of_bits, bits.
    rewrite (Z.add_comm (exponent * 2 ^ 52)), Z.mod_add, Z.mod_small, Z.div_add, Z.div_small by lia.
    reflexivity. }
  set (k := ((fraction + 2 ^ 26) / 2 ^ 27)%Z).
  assert (k_range : (0 <= k <= 2 ^ 25)%Z).
  { unfold k; split; [apply Z.div_pos; lia|].
    assert ((fraction + 2 ^ 26) / 2 ^ 27 < 2 ^ 25 + 1)%Z; [|lia].
    apply Z.div_lt_upper_bound; lia. }
  assert (masked : masked_bits bits = (exponent * 2 ^ 52 + k * 2 ^ 27)%Z).
  { rewrite masked_bits_value; unfold bits, k.
    replace (exponent * 2 ^ 52 + fraction + 2 ^ 26)%Z with (fraction + 2 ^ 26 + exponent * 2 ^ 25 * 2 ^ 27)%Z by lia.
    rewrite Z.div_add by lia.
    lia. }
  assert (high_value : high = IZR (2 ^ 25 + k) * pow2 (27 + e)).
  { unfold high; rewrite masked; unfold number_of_bits.
    destruct (Z.eq_dec k (2 ^ 25)) as [carry|plain].
    - (* the fraction overflows into the exponent, which doubles the unit *)
      rewrite carry.
      replace (exponent * 2 ^ 52 + 2 ^ 25 * 2 ^ 27)%Z with (0 + (exponent + 1) * 2 ^ 52)%Z by lia.
      rewrite Z.mod_add, Z.mod_small, Z.div_add, Z.div_small by lia.
      replace (0 + (exponent + 1) - 1075)%Z with (1 + e)%Z by (unfold e; lia).
      rewrite !bpow_plus; cbn; lra.
    - rewrite (Z.add_comm (exponent * 2 ^ 52)), Z.mod_add, Z.mod_small, Z.div_add, Z.div_small by lia.
      replace (0 + exponent - 1075)%Z with e by (unfold e; lia).
      replace (2 ^ 52 + k * 2 ^ 27)%Z with ((2 ^ 25 + k) * 2 ^ 27)%Z by lia.
      rewrite mult_IZR, bpow_plus.
      change (pow2 27) with (IZR (2 ^ 27)); ring. }
  assert (division := Z.div_mod (fraction + 2 ^ 26) (2 ^ 27) ltac:(lia)); fold k in division.
  assert (remainder := Z.mod_pos_bound (fraction + 2 ^ 26) (2 ^ 27) ltac:(lia)).
  assert (difference : on_grid e (2 ^ 26) (a - high)).
  { exists (2 ^ 52 + fraction - (2 ^ 25 + k) * 2 ^ 27)%Z; split; [|lia].
    rewrite value, high_value, bpow_plus, minus_IZR, (mult_IZR (2 ^ 25 + k)).
    change (pow2 27) with (IZR (2 ^ 27)); ring. }
  assert (exact_low : rnd (a - high) = a - high) by (apply (grid_exact _ _ _ difference); unfold e; lia).
  assert (positive := bpow_gt_0 radix2 e).
  rewrite exact_low; split.
  - ring.
  - exists (2 ^ 25 + k)%Z; split; [exact high_value | lia].
  - exact difference.
  - rewrite value, bpow_plus, Rabs_pos_eq by (apply Rmult_le_pos; [apply IZR_le; lia | lra]).
    apply Rmult_le_compat_r; [lra|].
    change (pow2 52) with (IZR (2 ^ 52)); apply IZR_le; lia.
  - rewrite value, Rabs_pos_eq by (apply Rmult_le_pos; [apply IZR_le; lia | lra]).
    apply Rmult_le_compat_r; [lra | apply IZR_le; lia].
Qed.

(* negative numbers split into the opposite halves *)
Lemma halves_opp a high low e : halves a high low e -> halves (- a) (- high) (- low) e.
Proof.
  intros [sum grid_high grid_low low_bound high_bound]; split.
  - rewrite sum; ring.
  - now apply grid_opp.
  - now apply grid_opp.
  - now rewrite Rabs_Ropp.
  - now rewrite Rabs_Ropp.
Qed.
