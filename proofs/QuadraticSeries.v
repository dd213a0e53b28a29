(** * Systems of quadratic differential equations in n unknowns: a power series solves them near any initial value

    The equation of unknown i is x_i' = sum over terms of factor x_left x_right. Euler's equations, those of a body
    with its attitude, the heavy top and every Lie-Poisson system with a quadratic Hamiltonian have this form
    (linear terms too, with one more unknown that stays 1). The Taylor coefficients obey (k + 1) a_(k+1) = sum of
    factor times Cauchy products. Where the factors of each equation have sum of sizes at most m and the initial
    values size at most s, induction gives |a_k| <= s (m s)^k, so the series converges for |t| < 1/(m s).

    Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section I.8 (Cauchy's majorants). *)
From Coq Require Import Reals Lra Psatz Lia List.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import QuadraticTerms.
Local Open Scope R_scope.

(* The coefficient of order k of evaluate, on power series with coefficients a k i. *)
Definition cauchy (l : list term) (a : nat -> nat -> R) k :=
  fold_right (fun t s => factor t * PS_mult (fun j => a j (left t)) (fun j => a j (right t)) k + s) 0 l.

Section System.
Variable n : nat.
Variable terms : nat -> list term.
Hypothesis closed : forall i, (i < n)%nat -> within n (terms i).
Variable start : nat -> R.

(* table k holds the right coefficients up to order k: recursion on all earlier ones, written as recursion on k. *)
Fixpoint table k : nat -> nat -> R := match k with
  | 0%nat => fun _ => start
  | S m => fun j => if Nat.leb j m then table m j else fun i => cauchy (terms i) (table m) m / INR (S m)
  end.
Definition coefficient k := table k k.

Lemma table_stable k j : (j <= k)%nat -> table k j = coefficient j.
Proof.
  induction k as [|k hypothesis]; intros order.
  - now replace j with 0%nat by lia.
  - destruct (Nat.eq_dec j (S k)) as [->|other]; [reflexivity|].
    cbn.
    rewrite (proj2 (Nat.leb_le j k)) by lia.
    apply hypothesis; lia.
Qed.

Lemma cauchy_ext l a b k : (forall j, (j <= k)%nat -> a j = b j) -> cauchy l a k = cauchy l b k.
Proof.
  intros equal.
  induction l as [|t l rest]; [reflexivity|].
  cbn [cauchy fold_right].
  fold (cauchy l a k) (cauchy l b k).
  rewrite rest.
  do 2 f_equal.
  apply sum_eq.
  intros j order.
  now rewrite (equal j order), (equal (k - j)%nat) by lia.
Qed.

Lemma coefficient_next k i : coefficient (S k) i = cauchy (terms i) coefficient k / INR (S k).
Proof.
  unfold coefficient at 1.
  cbn [table].
  rewrite (proj2 (Nat.leb_gt (S k) k)) by lia.
  f_equal.
  apply cauchy_ext.
  intros j order.
  now apply table_stable.
Qed.

Definition series t i := PSeries (fun k => coefficient k i) t.

Lemma series_start i : series 0 i = start i.
Proof. exact (PSeries_0 (fun k => coefficient k i)). Qed.

Section Bound.
Variables m s : R.
Hypotheses (m_positive : 0 < m) (s_positive : 0 < s).
Hypothesis small_factors : forall i, (i < n)%nat -> weight (terms i) <= m.
Hypothesis small_start : forall i, (i < n)%nat -> Rabs (start i) <= s.

Lemma product_bound (a b : nat -> R) k :
  (forall j, (j <= k)%nat -> Rabs (a j) <= s * (m * s) ^ j /\ Rabs (b j) <= s * (m * s) ^ j) ->
  Rabs (PS_mult a b k) <= s * s * (m * s) ^ k * INR (S k).
Proof.
  intros bound.
  eapply Rle_trans; [apply sum_f_R0_triangle|].
  rewrite <- sum_cte.
  apply sum_Rle.
  intros j order.
  rewrite Rabs_mult.
  replace (s * s * (m * s) ^ k) with ((s * (m * s) ^ j) * (s * (m * s) ^ (k - j))).
  - apply Rmult_le_compat; try apply Rabs_pos; apply bound; lia.
  - replace k with (j + (k - j))%nat at 2 by lia.
    rewrite pow_add; ring.
Qed.

Lemma cauchy_bound l a k : within n l ->
  (forall j i, (j <= k)%nat -> (i < n)%nat -> Rabs (a j i) <= s * (m * s) ^ j) ->
  Rabs (cauchy l a k) <= weight l * (s * s * (m * s) ^ k * INR (S k)).
Proof.
  intros inside bound.
  induction inside as [|t l (hl & hr) inside rest].
  - cbn.
    rewrite Rabs_R0; lra.
  - cbn [cauchy weight fold_right].
    fold (cauchy l a k) (weight l).
    eapply Rle_trans; [apply Rabs_triang|].
    rewrite Rabs_mult, Rmult_plus_distr_r.
    apply Rplus_le_compat; [|exact rest].
    apply Rmult_le_compat_l; [apply Rabs_pos|].
    apply product_bound.
    intros j order; split; apply bound; auto.
Qed.

(* Cauchy's majorant. *)
Lemma coefficient_bound k i : (i < n)%nat -> Rabs (coefficient k i) <= s * (m * s) ^ k.
Proof.
  revert i.
  induction k as [k earlier] using (well_founded_induction Wf_nat.lt_wf).
  intros i hi.
  destruct k as [|k].
  - cbn [pow].
    rewrite Rmult_1_r.
    exact (small_start i hi).
  - rewrite coefficient_next.
    assert (count : 0 < INR (S k)) by (apply lt_0_INR; lia).
    assert (growth : 0 <= s * s * (m * s) ^ k * INR (S k)).
    { repeat apply Rmult_le_pos; try lra.
      apply pow_le, Rmult_le_pos; lra. }
    assert (sum := cauchy_bound (terms i) coefficient k (closed i hi)
      (fun j i' order hi' => earlier j (proj2 (Nat.lt_succ_r j k) order) i' hi')).
    assert (factors := Rmult_le_compat_r _ _ _ growth (small_factors i hi)).
    unfold Rdiv.
    rewrite Rabs_mult, Rabs_inv, (Rabs_right (INR (S k))) by lra.
    replace (s * (m * s) ^ S k) with (m * (s * s * (m * s) ^ k * INR (S k)) * / INR (S k)) by (cbn [pow]; field; lra).
    apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat; exact count | lra].
Qed.

Lemma radius_bound i t : (i < n)%nat -> Rabs t < / (m * s) ->
  Rbar_lt (Rabs t) (CV_radius (fun k => coefficient k i)).
Proof.
  intros hi inside.
  assert (product : 0 < m * s) by (apply Rmult_lt_0_compat; auto).
  apply Rbar_lt_le_trans with (Finite (/ (m * s))); [exact inside|].
  apply (proj1 (CV_radius_bounded (fun k => coefficient k i))).
  exists s.
  intros k.
  assert (powers : (m * s) ^ k * (/ (m * s)) ^ k = 1) by (rewrite <- Rpow_mult_distr, Rinv_r, pow1; lra).
  assert (positive : 0 < (/ (m * s)) ^ k) by (apply pow_lt, Rinv_0_lt_compat; auto).
  rewrite Rabs_mult, (Rabs_right ((/ (m * s)) ^ k)) by lra.
  assert (scaled := Rmult_le_compat_r _ _ _ (Rlt_le _ _ positive) (coefficient_bound k i hi)).
  rewrite Rmult_assoc, powers in scaled.
  lra.
Qed.

(* Power series may be multiplied and added term by term. *)
Lemma cauchy_series l t : within n l -> Rabs t < / (m * s) ->
  ex_pseries (cauchy l coefficient) t /\ PSeries (cauchy l coefficient) t = evaluate l (series t).
Proof.
  intros inside small.
  induction inside as [|h l (hl & hr) inside (exists_rest & rest)].
  - split.
    + apply (ex_pseries_ext (fun _ => 0)); [reflexivity|].
      apply CV_radius_inside.
      rewrite CV_radius_const_0.
      exact I.
    + exact (PSeries_const_0 t).
  - set (product := PS_mult (fun j => coefficient j (left h)) (fun j => coefficient j (right h))).
    assert (cl := radius_bound (left h) t hl small).
    assert (cr := radius_bound (right h) t hr small).
    assert (exists_product : ex_pseries (PS_scal (factor h) product) t).
    { apply ex_pseries_scal; [apply Rmult_comm|].
      now apply ex_pseries_mult. }
    split.
    + exact (ex_pseries_plus (PS_scal (factor h) product) (cauchy l coefficient) t exists_product exists_rest).
    + transitivity (PSeries (PS_plus (PS_scal (factor h) product) (cauchy l coefficient)) t); [reflexivity|].
      rewrite PSeries_plus, PSeries_scal, rest by auto.
      unfold product.
      rewrite PSeries_mult by auto.
      reflexivity.
Qed.

Theorem series_solves t i : (i < n)%nat -> Rabs t < / (m * s) ->
  is_derive (fun x => series x i) t (evaluate (terms i) (series t)).
Proof.
  intros hi inside.
  rewrite <- (proj2 (cauchy_series (terms i) t (closed i hi) inside)).
  rewrite <- (PSeries_ext (PS_derive (fun k => coefficient k i)) (cauchy (terms i) coefficient) t).
  - exact (is_derive_PSeries (fun k => coefficient k i) t (radius_bound i t hi inside)).
  - intros k.
    unfold PS_derive.
    rewrite coefficient_next.
    field.
    apply not_0_INR; lia.
Qed.
End Bound.
End System.
