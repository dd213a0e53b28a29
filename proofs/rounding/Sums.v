(** * Sums with their exact errors

    [two_sum] and [fast_two_sum] of polhode return the rounded sum and its error, and the two together are exactly
    the sum.  Each definition has the operations of the code in the code's order (a test evaluates these definitions
    and the code on the same numbers and compares every bit):

    - [numpy_two_sum]: polhode.special._doubledouble, for arrays of NumPy and JAX;
    - [kernel_two_sum]: polhode.exact._kernel_arithmetic, single numbers, run by Python and compiled by Numba;
    - [fast_two_sum]: both.

    Sources: Knuth, The Art of Computer Programming II, 4.2.2; Dekker, Numer. Math. 18 (1971) 224; the theorems of
    Knuth and Dekker are those of Flocq. *)
From Coq Require Import Reals ZArith Lia Lra.
From Flocq Require Import Core Pff2Flocq.
From Polhode.rounding Require Import Grid.
Local Open Scope R_scope.

Definition numpy_two_sum a b :=
  let s := rnd (a + b) in
  let t := rnd (s - a) in
  let e := rnd (b - t) in
  let t := rnd (s - t) in
  let t := rnd (t - a) in
  (s, rnd (e - t)).

Definition kernel_two_sum a b :=
  let s := rnd (a + b) in
  let t := rnd (s - a) in
  (s, rnd (rnd (a - rnd (s - t)) + rnd (b - t))).

Definition fast_two_sum a b :=
  let s := rnd (a + b) in
  (s, rnd (b - rnd (s - a))).

Lemma ties_are_symmetric x : negb (Z.even x) = negb (negb (Z.even (- (x + 1)))).
Proof. rewrite Z.even_opp, Z.even_add; destruct (Z.even x); reflexivity. Qed.

Theorem kernel_two_sum_exact a b :
  double a -> double b -> fst (kernel_two_sum a b) + snd (kernel_two_sum a b) = a + b.
Proof.
  intros da db.
  exact (TwoSum_correct (-1074) 53 _ ltac:(lia) ltac:(lia) ties_are_symmetric a b da db).
Qed.

Lemma two_sums_agree a b : numpy_two_sum a b = kernel_two_sum a b.
Proof.
  unfold numpy_two_sum, kernel_two_sum; f_equal; f_equal.
  rewrite <- (Ropp_minus_distr a (rnd (rnd (a + b) - rnd (rnd (a + b) - a)))), rnd_opp.
  ring.
Qed.

Theorem numpy_two_sum_exact a b :
  double a -> double b -> fst (numpy_two_sum a b) + snd (numpy_two_sum a b) = a + b.
Proof. intros da db; rewrite two_sums_agree; now apply kernel_two_sum_exact. Qed.

Theorem fast_two_sum_exact a b :
  double a -> double b -> Rabs b <= Rabs a -> fst (fast_two_sum a b) + snd (fast_two_sum a b) = a + b.
Proof.
  intros da db order.
  assert (h := Fast2Sum_correct (-1074) 53 _ ltac:(lia) ltac:(lia) ties_are_symmetric a b da db order).
  refine (eq_trans _ h); unfold fast_two_sum, fst, snd; f_equal; f_equal.
  rewrite <- (Ropp_minus_distr a (rnd (a + b))), rnd_opp.
  ring.
Qed.
