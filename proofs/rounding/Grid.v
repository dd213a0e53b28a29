(** * Binary64 numbers, and when rounding changes nothing

    Real numbers that are a whole multiple of a power of two and not too many of them are floating-point numbers, so
    that a sum or product that is one is computed exactly.  This is the argument behind every error-free
    transformation in [Sums.v] and [Products.v].

    Numbers are reals of the format of binary64 with gradual underflow and without overflow; [rnd] rounds to nearest,
    ties to even, as IEEE 754 demands.  Source: Boldo & Melquiond, Computer Arithmetic and Formal Proofs (2017). *)
From Coq Require Import Reals ZArith Lia Lra.
From Flocq Require Import Core.
Local Open Scope R_scope.

Notation rnd := (round radix2 (FLT_exp (-1074) 53) ZnearestE).
Notation double := (generic_format radix2 (FLT_exp (-1074) 53)).
Notation pow2 := (bpow radix2).

#[global] Instance prec53 : Prec_gt_0 53.
Proof. now compute. Qed.

Lemma double_rnd x : double (rnd x).
Proof. apply generic_format_round; [apply FLT_exp_valid, prec53 | apply valid_rnd_N]. Qed.

Lemma rnd_double x : double x -> rnd x = x.
Proof. apply round_generic, valid_rnd_N. Qed.

Lemma rnd_opp x : rnd (- x) = - rnd x.
Proof. apply round_NE_opp. Qed.

(** ** Multiples of a power of two *)

(* x is k 2^g for a whole number k with |k| <= most *)
Definition on_grid (g most : Z) (x : R) := exists k : Z, x = IZR k * pow2 g /\ (Z.abs k <= most)%Z.

Lemma grid_double g most x : on_grid g most x -> (most <= 2 ^ 53)%Z -> (-1074 <= g)%Z -> double x.
Proof.
  intros (k & -> & small) top bottom.
  destruct (Z.eq_dec (Z.abs k) (2 ^ 53)) as [edge|inside].
  - (* 2^53 itself is one bit long *)
    assert (half : IZR k * pow2 g = IZR (k / 2) * pow2 (g + 1)).
    { rewrite bpow_plus, <- (Rmult_comm (pow2 1)), <- Rmult_assoc.
      f_equal.
      change (pow2 1) with (IZR 2).
      rewrite <- mult_IZR.
      f_equal.
      destruct (Z.abs_eq_or_opp k) as [e|e]; rewrite e in edge.
      - now rewrite edge.
      - now replace k with (- 2 ^ 53)%Z by lia. }
    rewrite half.
    apply generic_format_FLT.
    exists (Float radix2 (k / 2) (g + 1)); [reflexivity | cbn [Fnum] | cbn [Fexp]; lia].
    change (Zpower radix2 53) with (2 ^ 53)%Z.
    destruct (Z.abs_eq_or_opp k) as [e|e]; rewrite e in edge.
    + rewrite edge; reflexivity.
    + replace k with (- 2 ^ 53)%Z by lia; reflexivity.
  - apply generic_format_FLT.
    exists (Float radix2 k g); [reflexivity | cbn [Fnum] | exact bottom].
    change (Zpower radix2 53) with (2 ^ 53)%Z.
    lia.
Qed.

Lemma grid_exact g most x : on_grid g most x -> (most <= 2 ^ 53)%Z -> (-1074 <= g)%Z -> rnd x = x.
Proof. intros h top bottom; apply rnd_double, (grid_double g most); assumption. Qed.

Lemma grid_add g m n x y : on_grid g m x -> on_grid g n y -> on_grid g (m + n) (x + y).
Proof.
  intros (k & -> & small) (l & -> & little).
  exists (k + l)%Z; split; [rewrite plus_IZR; ring | lia].
Qed.

Lemma grid_opp g m x : on_grid g m x -> on_grid g m (- x).
Proof.
  intros (k & -> & small).
  exists (- k)%Z; split; [rewrite opp_IZR; ring | lia].
Qed.

Lemma grid_sub g m n x y : on_grid g m x -> on_grid g n y -> on_grid g (m + n) (x - y).
Proof. intros a b; apply grid_add, grid_opp; assumption. Qed.

Lemma grid_mul g h m n x y : on_grid g m x -> on_grid h n y -> on_grid (g + h) (m * n) (x * y).
Proof.
  intros (k & -> & small) (l & -> & little).
  exists (k * l)%Z; split.
  - rewrite mult_IZR, bpow_plus; ring.
  - rewrite Z.abs_mul; apply Z.mul_le_mono_nonneg; lia.
Qed.

(* a coarse grid is part of a fine one *)
Lemma grid_refine g h m x : on_grid (g + h) m x -> (0 <= h)%Z -> on_grid g (m * 2 ^ h) x.
Proof.
  intros (k & -> & small) up.
  exists (k * 2 ^ h)%Z; split.
  - rewrite mult_IZR, bpow_plus.
    replace (IZR (2 ^ h)) with (pow2 h); [ring|].
    now rewrite <- IZR_Zpower.
  - rewrite Z.abs_mul, (Z.abs_eq (2 ^ h)) by lia.
    apply Z.mul_le_mono_nonneg_r; lia.
Qed.

(* what is known about the size of a number bounds how many units it has *)
Lemma grid_size g m n x : on_grid g m x -> Rabs x <= IZR n * pow2 g -> on_grid g n x.
Proof.
  intros (k & -> & _) size.
  exists k; split; [reflexivity|].
  apply le_IZR.
  apply (Rmult_le_reg_r (pow2 g)); [apply bpow_gt_0|].
  rewrite Rabs_mult, (Rabs_pos_eq (pow2 g)) in size by apply bpow_ge_0.
  now rewrite abs_IZR.
Qed.

Lemma grid_bound g m x : on_grid g m x -> Rabs x <= IZR m * pow2 g.
Proof.
  intros (k & -> & small).
  rewrite Rabs_mult, (Rabs_pos_eq (pow2 g)) by apply bpow_ge_0.
  apply Rmult_le_compat_r; [apply bpow_ge_0|].
  rewrite <- abs_IZR.
  now apply IZR_le.
Qed.

(** ** Rounding keeps to a grid *)

Lemma rnd_on_grid h x : (-1074 <= h)%Z -> pow2 (52 + h) <= Rabs x -> exists m, on_grid h m (rnd x).
Proof.
  intros bottom low.
  set (c := cexp radix2 (FLT_exp (-1074) 53) x).
  assert (exponent : (h <= c)%Z).
  { unfold c, cexp, FLT_exp.
    assert (52 + h + 1 <= mag radix2 x)%Z
      by (apply mag_ge_bpow; now replace (52 + h + 1 - 1)%Z with (52 + h)%Z by lia).
    lia. }
  set (k := ZnearestE (scaled_mantissa radix2 (FLT_exp (-1074) 53) x)).
  exists (Z.abs (k * 2 ^ (c - h))), (k * 2 ^ (c - h))%Z; split; [|lia].
  change (IZR k * pow2 c = IZR (k * 2 ^ (c - h)) * pow2 h).
  rewrite mult_IZR.
  change 2%Z with (radix_val radix2).
  rewrite IZR_Zpower by lia.
  rewrite Rmult_assoc, <- bpow_plus.
  do 2 f_equal; lia.
Qed.

Lemma rnd_error h x : (-1074 <= h)%Z -> Rabs x <= pow2 (54 + h) -> Rabs (rnd x - x) <= pow2 h.
Proof.
  intros bottom high.
  destruct (Req_dec x 0) as [zero|nonzero].
  { rewrite zero, round_0 by apply valid_rnd_N.
    rewrite Rminus_0_r, Rabs_R0; apply bpow_ge_0. }
  destruct (Rle_lt_or_eq_dec _ _ high) as [below|edge].
  - apply Rle_trans with (/ 2 * ulp radix2 (FLT_exp (-1074) 53) x).
    { apply error_le_half_ulp, FLT_exp_valid, prec53. }
    rewrite ulp_neq_0 by exact nonzero.
    assert (cexp radix2 (FLT_exp (-1074) 53) x <= 1 + h)%Z.
    { unfold cexp, FLT_exp.
      assert (mag radix2 x <= 54 + h)%Z by (apply mag_le_bpow; assumption).
      lia. }
    apply Rle_trans with (/ 2 * pow2 (1 + h)).
    { apply Rmult_le_compat_l; [lra | now apply bpow_le]. }
    rewrite bpow_plus.
    change (pow2 1) with 2.
    lra.
  - (* a power of two is its own rounding *)
    replace (rnd x) with x.
    { unfold Rminus; rewrite Rplus_opp_r, Rabs_R0; apply bpow_ge_0. }
    symmetry; apply (grid_exact (54 + h) 1); [|lia|lia].
    destruct (Rcase_abs x) as [negative|positive].
    + exists (-1)%Z; split; [|lia].
      rewrite Rabs_left in edge by exact negative; lra.
    + exists 1%Z; split; [|lia].
      rewrite Rabs_right in edge by exact positive; lra.
Qed.
