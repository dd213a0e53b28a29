(** * Products with their exact errors

    [two_product] and [two_square] of polhode return the rounded product and its error, and the two together are
    exactly the product.  Each definition has the operations of the code in the code's order (a test evaluates these
    definitions and the code on the same numbers and compares every bit):

    - [numpy_two_product]: polhode.special._doubledouble, for NumPy arrays, and polhode.exact._kernel_arithmetic, single
      numbers run by Python;
    - [numpy_two_square]: polhode.special._doubledouble, for NumPy arrays;
    - [fused_two_product]: what takes its place when Numba compiles, with one fused multiply-add;
    - [jax_two_product]: polhode.special._doubledouble, for JAX arrays; how their numbers are split is in
      [Splitting.v].

    Sources: Dekker, Numer. Math. 18 (1971) 224; Dekker's theorem with Veltkamp's splitting is that of Flocq. *)
From Coq Require Import Reals ZArith Lia Lra.
From Flocq Require Import Core Pff2Flocq Mult_error.
From Polhode.rounding Require Import Grid Sums.
Local Open Scope R_scope.

(** ** Products by halves *)

(* Veltkamp's splitting, with 2^27 + 1; the second form is that of the kernels *)
Definition numpy_high a :=
  let p := rnd (134217729 * a) in
  rnd (p - rnd (p - a)).

Definition numpy_low a := rnd (a - numpy_high a).

Definition numpy_two_product a b :=
  let p := rnd (a * b) in
  let e := rnd (rnd (numpy_high a * numpy_high b) - p) in
  let e := rnd (e + rnd (numpy_high a * numpy_low b)) in
  let e := rnd (e + rnd (numpy_low a * numpy_high b)) in
  (p, rnd (e + rnd (numpy_low a * numpy_low b))).

Definition numpy_two_square a :=
  let m := rnd (numpy_high a * numpy_low a) in
  let p := rnd (a * a) in
  let e := rnd (rnd (numpy_high a * numpy_high a) - p) in
  let e := rnd (e + rnd (m + m)) in
  (p, rnd (e + rnd (numpy_low a * numpy_low a))).

(* what the product of numbers of two halves is summed from, for any halves *)
Definition product_by_halves a b ah al bh bl :=
  let p := rnd (a * b) in
  (p, rnd (rnd (rnd (rnd (rnd (ah * bh) - p) + rnd (ah * bl)) + rnd (al * bh)) + rnd (al * bl))).

(* the sum of the four products of halves, as for JAX *)
Definition jax_sum_of_partial_products most middle other least :=
  let (middle, below) := numpy_two_sum middle other in
  let (p, e) := fast_two_sum most middle in
  let (e, rest) := numpy_two_sum e least in
  let (p, e) := fast_two_sum p e in
  (p, rnd (e + rnd (rest + below))).

Definition jax_two_product ah al bh bl := jax_sum_of_partial_products
  (rnd (ah * bh)) (rnd (ah * bl)) (rnd (al * bh)) (rnd (al * bl)).

Theorem numpy_two_product_exact a b :
  double a -> double b -> a * b = 0 \/ pow2 (-969) <= Rabs (a * b) ->
  fst (numpy_two_product a b) + snd (numpy_two_product a b) = a * b.
Proof.
  intros da db size.
  destruct (Dekker radix2 (-1074) 53 (fun x => negb (Z.even x)) ltac:(lia) ltac:(lia) a b da db (or_introl eq_refl))
    as (exact_product & _).
  assert (high : forall x, numpy_high x =
    rnd (rnd (x - rnd (x * (pow2 27 + 1))) + rnd (x * (pow2 27 + 1)))).
  { intros x; unfold numpy_high.
    replace (134217729 * x) with (x * (pow2 27 + 1)) by (cbn; ring).
    set (p := rnd (x * (pow2 27 + 1))).
    rewrite <- (Ropp_minus_distr x p), rnd_opp.
    f_equal; ring. }
  specialize (exact_product size).
  change (53 - Z.div2 53)%Z with 27%Z in exact_product.
  rewrite (Rplus_comm (- rnd (a * b))) in exact_product.
  unfold numpy_two_product, numpy_low, fst, snd.
  rewrite !high.
  exact (eq_sym exact_product).
Qed.

(** ** Halves of a number with 53 bits *)

(* a = (high 2^27 + low) 2^e, high of at most 26 bits and low of 26 bits and a sign *)
Record halves (a high low : R) (e : Z) : Prop := {
  sum_of_halves : a = high + low;
  high_grid : on_grid (27 + e) (2 ^ 26) high;
  low_grid : on_grid e (2 ^ 26) low;
  normal : pow2 (52 + e) <= Rabs a;
  short : Rabs a <= IZR (2 ^ 53 - 1) * pow2 e
}.

Section Product.

Variables (a b ah al bh bl : R) (ea eb : Z).
Hypotheses (split_a : halves a ah al ea) (split_b : halves b bh bl eb).
Let g := (ea + eb)%Z.
Hypothesis no_underflow : (-1074 <= g)%Z.

Let most : on_grid (54 + g) (2 ^ 52) (ah * bh).
Proof.
  replace (54 + g)%Z with ((27 + ea) + (27 + eb))%Z by (unfold g; lia).
  apply (grid_mul _ _ (2 ^ 26) (2 ^ 26)); [apply split_a | apply split_b].
Qed.

Let middle : on_grid (27 + g) (2 ^ 52) (ah * bl).
Proof.
  replace (27 + g)%Z with ((27 + ea) + eb)%Z by (unfold g; lia).
  apply (grid_mul _ _ (2 ^ 26) (2 ^ 26)); [apply split_a | apply split_b].
Qed.

Let other : on_grid (27 + g) (2 ^ 52) (al * bh).
Proof.
  replace (27 + g)%Z with (ea + (27 + eb))%Z by (unfold g; lia).
  apply (grid_mul _ _ (2 ^ 26) (2 ^ 26)); [apply split_a | apply split_b].
Qed.

Let least : on_grid g (2 ^ 52) (al * bl).
Proof. apply (grid_mul _ _ (2 ^ 26) (2 ^ 26)); [apply split_a | apply split_b]. Qed.

Let product_of_sums : a * b = ah * bh + ah * bl + al * bh + al * bl.
Proof. rewrite (sum_of_halves _ _ _ _ split_a), (sum_of_halves _ _ _ _ split_b); ring. Qed.

Let product_low : pow2 (104 + g) <= Rabs (a * b).
Proof.
  rewrite Rabs_mult.
  replace (104 + g)%Z with ((52 + ea) + (52 + eb))%Z by (unfold g; lia).
  rewrite (bpow_plus radix2 (52 + ea)).
  apply Rmult_le_compat; try apply bpow_ge_0; [apply split_a | apply split_b].
Qed.

(* a size in units of 2^g *)
Let units n m : (0 <= m)%Z -> IZR n * pow2 (m + g) = IZR (n * 2 ^ m) * pow2 g.
Proof.
  intros pos; rewrite mult_IZR, bpow_plus.
  change (2 ^ m)%Z with (radix2 ^ m)%Z.
  rewrite IZR_Zpower by exact pos; ring.
Qed.

Let unit_power m : (0 <= m)%Z -> pow2 (m + g) = IZR (2 ^ m) * pow2 g.
Proof. intros pos; rewrite <- (Rmult_1_l (pow2 (m + g))); now rewrite (units 1 m pos), Z.mul_1_l. Qed.

Let product_high : Rabs (a * b) <= IZR ((2 ^ 53 - 1) * (2 ^ 53 - 1)) * pow2 g.
Proof.
  rewrite Rabs_mult, mult_IZR.
  unfold g; rewrite bpow_plus.
  replace (IZR (2 ^ 53 - 1) * IZR (2 ^ 53 - 1) * (pow2 ea * pow2 eb))
    with ((IZR (2 ^ 53 - 1) * pow2 ea) * (IZR (2 ^ 53 - 1) * pow2 eb)) by ring.
  apply Rmult_le_compat; try apply Rabs_pos; [apply split_a | apply split_b].
Qed.

Let p := rnd (a * b).

Let positive := bpow_gt_0 radix2 g.

Let error_small : Rabs (a * b - p) <= IZR (2 ^ 52) * pow2 g.
Proof.
  rewrite <- unit_power, Rabs_minus_sym by lia.
  apply rnd_error; [lia|].
  replace (54 + (52 + g))%Z with (106 + g)%Z by lia.
  rewrite unit_power by lia.
  assert (high := product_high); cbn in high |- *; lra.
Qed.

(* the size of a sum of terms of which each is known *)
Ltac bound_all :=
  assert (middle_small := grid_bound _ _ _ middle); assert (other_small := grid_bound _ _ _ other);
  assert (least_small := grid_bound _ _ _ least);
  rewrite units in middle_small, other_small by lia.

Let step1 : rnd (ah * bh - p) = ah * bh - p /\ exists m, on_grid (27 + g) m (ah * bh - p).
Proof.
  destruct (rnd_on_grid (52 + g) (a * b)) as (m & grid_p); [lia | |].
  { now replace (52 + (52 + g))%Z with (104 + g)%Z by lia. }
  assert (grid : on_grid (52 + g) (2 ^ 52 * 2 ^ 2 + m) (ah * bh - p)).
  { apply grid_sub; [|exact grid_p].
    apply grid_refine; [|lia].
    now replace (52 + g + 2)%Z with (54 + g)%Z by lia. }
  split.
  - apply (grid_exact (52 + g) (2 ^ 30)); [|lia|lia].
    apply (grid_size _ _ _ _ grid).
    bound_all.
    rewrite units by lia.
    replace (ah * bh - p) with (a * b - p - ah * bl - al * bh - al * bl) by (rewrite product_of_sums; ring).
    apply Rabs_le.
    apply Rabs_le_inv in error_small, middle_small, other_small, least_small.
    cbn in error_small, middle_small, other_small, least_small |- *.
    lra.
  - exists ((2 ^ 52 * 2 ^ 2 + m) * 2 ^ 25)%Z.
    apply grid_refine; [|lia].
    now replace (27 + g + 25)%Z with (52 + g)%Z by lia.
Qed.

Let step2 : rnd (ah * bh - p + ah * bl) = ah * bh - p + ah * bl
  /\ exists m, on_grid (27 + g) m (ah * bh - p + ah * bl).
Proof.
  destruct step1 as (_ & m & grid).
  assert (sum := grid_add _ _ _ _ _ grid middle).
  split; [|eexists; exact sum].
  apply (grid_exact (27 + g) (2 ^ 53)); [|lia|lia].
  apply (grid_size _ _ _ _ sum).
  bound_all.
  rewrite units by lia.
  replace (ah * bh - p + ah * bl) with (a * b - p - al * bh - al * bl) by (rewrite product_of_sums; ring).
  apply Rabs_le.
  apply Rabs_le_inv in error_small, middle_small, other_small, least_small.
  cbn in error_small, middle_small, other_small, least_small |- *.
  lra.
Qed.

Let step3 : rnd (ah * bh - p + ah * bl + al * bh) = ah * bh - p + ah * bl + al * bh
  /\ exists m, on_grid (27 + g) m (ah * bh - p + ah * bl + al * bh).
Proof.
  destruct step2 as (_ & m & grid).
  assert (sum := grid_add _ _ _ _ _ grid other).
  split; [|eexists; exact sum].
  apply (grid_exact (27 + g) (2 ^ 53)); [|lia|lia].
  apply (grid_size _ _ _ _ sum).
  bound_all.
  rewrite units by lia.
  replace (ah * bh - p + ah * bl + al * bh) with (a * b - p - al * bl) by (rewrite product_of_sums; ring).
  apply Rabs_le.
  apply Rabs_le_inv in error_small, middle_small, other_small, least_small.
  cbn in error_small, middle_small, other_small, least_small |- *.
  lra.
Qed.

Let step4 : rnd (a * b - p) = a * b - p.
Proof.
  destruct step3 as (_ & m & grid).
  assert (fine : on_grid g (m * 2 ^ 27) (ah * bh - p + ah * bl + al * bh)).
  { apply grid_refine; [|lia].
    now rewrite Z.add_comm. }
  assert (sum := grid_add _ _ _ _ _ fine least).
  replace (ah * bh - p + ah * bl + al * bh + al * bl) with (a * b - p) in sum by (rewrite product_of_sums; ring).
  apply (grid_exact g (2 ^ 52)); [|lia|lia].
  now apply (grid_size _ _ _ _ sum).
Qed.

(* what the order of a square needs of these steps *)
Lemma product_by_halves_steps :
  rnd (ah * bh) = ah * bh /\ rnd (al * bl) = al * bl
  /\ rnd (ah * bh - rnd (a * b)) = ah * bh - rnd (a * b)
  /\ rnd (ah * bh - rnd (a * b) + ah * bl + al * bh) = ah * bh - rnd (a * b) + ah * bl + al * bh
  /\ rnd (a * b - rnd (a * b)) = a * b - rnd (a * b).
Proof.
  refine (conj (grid_exact _ _ _ most _ _) (conj (grid_exact _ _ _ least _ _) (conj _ (conj _ step4)))); try lia.
  - apply step1.
  - apply step3.
Qed.

Theorem product_by_halves_exact :
  fst (product_by_halves a b ah al bh bl) + snd (product_by_halves a b ah al bh bl) = a * b.
Proof.
  unfold product_by_halves, fst, snd; fold p.
  rewrite (grid_exact _ _ _ most), (grid_exact _ _ _ middle), (grid_exact _ _ _ other), (grid_exact _ _ _ least) by lia.
  destruct step1 as (-> & _); destruct step2 as (-> & _); destruct step3 as (-> & _).
  replace (ah * bh - p + ah * bl + al * bh + al * bl) with (a * b - p) by (rewrite product_of_sums; ring).
  rewrite step4; ring.
Qed.

(** ** The sum of the four products of halves, as for JAX *)

(* a sum that is a floating-point number has no error *)
Lemma two_sum_without_error x y : double x -> double y -> double (x + y) -> numpy_two_sum x y = (x + y, 0).
Proof.
  intros dx dy sum.
  assert (h := numpy_two_sum_exact x y dx dy).
  assert (first : fst (numpy_two_sum x y) = x + y) by (apply rnd_double; exact sum).
  rewrite first in h.
  rewrite (surjective_pairing (numpy_two_sum x y)), first.
  f_equal; lra.
Qed.

Lemma fast_two_sum_doubles x y : double (fst (fast_two_sum x y)) /\ double (snd (fast_two_sum x y)).
Proof. split; apply double_rnd. Qed.

(* the sum of all but the least product *)
Let x := ah * bh + (ah * bl + al * bh).

Let all_but_least : x = a * b - al * bl.
Proof. unfold x; rewrite product_of_sums; ring. Qed.

Let x_low : IZR (2 ^ 103) * pow2 g <= Rabs x.
Proof.
  assert (low := product_low); rewrite unit_power in low by lia.
  assert (least_small := grid_bound _ _ _ least).
  assert (triangle := Rabs_triang_inv (a * b) (al * bl)).
  rewrite all_but_least.
  cbn in low, least_small |- *; lra.
Qed.

Let x_high : Rabs x <= IZR (2 ^ 106) * pow2 g.
Proof.
  assert (high := product_high).
  assert (least_small := grid_bound _ _ _ least).
  assert (triangle := Rabs_triang (a * b) (- (al * bl))).
  rewrite Rabs_Ropp in triangle.
  rewrite all_but_least.
  cbn in high, least_small |- *; unfold Rminus; lra.
Qed.

Let x_error : on_grid g (2 ^ 52) (x - rnd x).
Proof.
  destruct (rnd_on_grid (51 + g) x) as (m & grid); [lia | |].
  { replace (52 + (51 + g))%Z with (103 + g)%Z by lia.
    now rewrite unit_power by lia. }
  assert (fine : on_grid g (m * 2 ^ 51) (rnd x)) by (apply grid_refine; [now rewrite Z.add_comm | lia]).
  assert (whole : on_grid g (2 ^ 52 * 2 ^ 54 + (2 ^ 52 + 2 ^ 52) * 2 ^ 27) x).
  { apply grid_add; (apply grid_refine; [rewrite Z.add_comm | lia]).
    - exact most.
    - exact (grid_add _ _ _ _ _ middle other). }
  apply (grid_size _ _ _ _ (grid_sub _ _ _ _ _ whole fine)).
  rewrite Rabs_minus_sym, <- unit_power by lia.
  apply rnd_error; [lia|].
  replace (54 + (52 + g))%Z with (106 + g)%Z by lia.
  now rewrite unit_power by lia.
Qed.

Let most_large : Rabs (ah * bl + al * bh) <= Rabs (ah * bh).
Proof.
  bound_all.
  assert (low := x_low).
  assert (triangle := Rabs_triang (ah * bl) (al * bh)).
  assert (whole := Rabs_triang (ah * bh) (ah * bl + al * bh)).
  fold x in whole.
  cbn in middle_small, other_small, low |- *; lra.
Qed.

Theorem jax_two_product_exact :
  fst (jax_two_product ah al bh bl) = rnd (a * b)
  /\ fst (jax_two_product ah al bh bl) + snd (jax_two_product ah al bh bl) = a * b.
Proof.
  unfold jax_two_product, jax_sum_of_partial_products.
  rewrite (grid_exact _ _ _ most), (grid_exact _ _ _ middle), (grid_exact _ _ _ other), (grid_exact _ _ _ least) by lia.
  assert (double_most := grid_double _ _ _ most ltac:(lia) ltac:(lia)).
  assert (double_least := grid_double _ _ _ least ltac:(lia) ltac:(lia)).
  assert (double_sum := grid_double _ _ _ (grid_add _ _ _ _ _ middle other) ltac:(lia) ltac:(lia)).
  rewrite (two_sum_without_error (ah * bl) (al * bh));
    [|apply (grid_double _ _ _ middle); lia | apply (grid_double _ _ _ other); lia | exact double_sum].
  assert (first := fast_two_sum_exact _ _ double_most double_sum most_large).
  assert (upper : fst (fast_two_sum (ah * bh) (ah * bl + al * bh)) = rnd x) by reflexivity.
  rewrite (surjective_pairing (fast_two_sum (ah * bh) (ah * bl + al * bh))), upper.
  rewrite upper in first; fold x in first.
  replace (snd (fast_two_sum (ah * bh) (ah * bl + al * bh))) with (x - rnd x) by lra.
  assert (error_grid := x_error).
  assert (rest_grid := grid_add _ _ _ _ _ error_grid least).
  rewrite (two_sum_without_error (x - rnd x) (al * bl));
    [|apply (grid_double _ _ _ error_grid); lia | exact double_least | apply (grid_double _ _ _ rest_grid); lia].
  assert (second := fast_two_sum_exact (rnd x) (x - rnd x + al * bl) (double_rnd x)
    (grid_double _ _ _ rest_grid ltac:(lia) ltac:(lia))).
  destruct (fast_two_sum_doubles (rnd x) (x - rnd x + al * bl)) as (_ & double_e).
  assert (sum : rnd x + (x - rnd x + al * bl) = a * b) by (rewrite all_but_least; ring).
  assert (whole : fst (fast_two_sum (rnd x) (x - rnd x + al * bl)) = rnd (a * b)) by (rewrite <- sum; reflexivity).
  rewrite sum in second.
  rewrite whole in second.
  rewrite (surjective_pairing (fast_two_sum (rnd x) (x - rnd x + al * bl))).
  cbn [fst snd] in *.
  rewrite Rplus_0_r, (rnd_double 0), Rplus_0_r, (rnd_double _ double_e) by apply generic_format_0.
  split; [exact whole|].
  rewrite whole; apply second.
  assert (rest_small := grid_bound _ _ _ rest_grid); assert (error_bound := grid_bound _ _ _ error_grid).
  assert (low := x_low).
  assert (triangle := Rabs_triang_inv x (x - rnd x)).
  replace (x - (x - rnd x)) with (rnd x) in triangle by ring.
  cbn in rest_small, error_bound, low |- *; lra.
Qed.

End Product.

(** ** Squares *)

Theorem square_by_halves_exact a high low e :
  halves a high low e -> (-1074 <= e + e)%Z ->
  let m := rnd (high * low) in
  rnd (a * a) + rnd (rnd (rnd (rnd (high * high) - rnd (a * a)) + rnd (m + m)) + rnd (low * low)) = a * a.
Proof.
  intros split bottom m.
  assert (grid := grid_mul _ _ _ _ _ _ (high_grid _ _ _ _ split) (low_grid _ _ _ _ split)).
  assert (exact_m : m = high * low) by (apply (grid_exact _ _ _ grid); lia).
  assert (double_m : rnd (m + m) = m + m).
  { rewrite exact_m; apply (grid_exact _ _ _ (grid_add _ _ _ _ _ grid grid)); lia. }
  rewrite double_m, exact_m.
  assert (product := product_by_halves_steps a a high low high low e e split split bottom).
  destruct product as (most & least & step1 & step3 & step4).
  set (p := rnd (a * a)) in *.
  rewrite most, least, step1.
  replace (high * high - p + (high * low + high * low)) with (high * high - p + high * low + low * high) by ring.
  rewrite step3.
  replace (high * high - p + high * low + low * high + low * low) with (a * a - p)
    by (clearbody p; rewrite (sum_of_halves _ _ _ _ split); ring).
  rewrite step4; ring.
Qed.

(** ** Products with one fused multiply-add *)

Definition fused_two_product a b :=
  let p := rnd (a * b) in
  (p, rnd (a * b - p)).

Theorem fused_two_product_exact a b :
  double a -> double b -> a * b = 0 \/ pow2 (-969) <= Rabs (a * b) ->
  fst (fused_two_product a b) + snd (fused_two_product a b) = a * b.
Proof.
  intros da db size; unfold fused_two_product, fst, snd.
  rewrite (rnd_double (a * b - rnd (a * b))); [ring|].
  rewrite <- (Ropp_minus_distr (rnd (a * b))).
  apply generic_format_opp, mult_error_FLT; [exact prec53 | apply valid_rnd_N | exact da | exact db |].
  intros nonzero; destruct size as [zero|large]; [contradiction | exact large].
Qed.
