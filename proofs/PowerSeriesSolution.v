(* (8) Euler's equations have a solution near any initial value: a power series in time.

   For X' = p Y Z, Y' = q Z X, Z' = r X Y the Taylor coefficients obey (n + 1) a_(n+1) = sum over k of a_k a_(n-k).
   With |p|, |q|, |r| <= m and initial components at most s, induction gives |a_n| <= s (m s)^n, so the series
   converges for |t| < 1/(m s) and solves the equations there.  Cauchy's majorants close faster than Picard's
   iteration, since Coquelicot knows power series but no uniform limits of vectors, and they show more: solutions
   are analytic.  The radius depends on the initial value through its size alone.
   Source: Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, section I.8 (Cauchy's majorants). *)
From Coq Require Import Reals Lra Psatz Lia.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Vec3 Calculus Euler Uniqueness.
Local Open Scope R_scope.

Section Series.
Variables p q r : R.
Variable start : V.

(* The coefficient that follows the first n + 1 coefficients of a. *)
Definition next (a : nat -> V) n := mk
  (p * PS_mult (fun k => Y (a k)) (fun k => Z (a k)) n / INR (S n))
  (q * PS_mult (fun k => Z (a k)) (fun k => X (a k)) n / INR (S n))
  (r * PS_mult (fun k => X (a k)) (fun k => Y (a k)) n / INR (S n)).

(* table n holds the right coefficients up to index n: recursion on all earlier values, written as recursion on n. *)
Fixpoint table n : nat -> V := match n with
  | 0%nat => fun _ => start
  | S m => fun k => if Nat.leb k m then table m k else next (table m) m
  end.
Definition coefficient n := table n n.

Lemma table_stable n k : (k <= n)%nat -> table n k = coefficient k.
Proof.
  induction n as [|n hypothesis]; intros order.
  - now replace k with 0%nat by lia.
  - destruct (Nat.eq_dec k (S n)) as [->|other]; [reflexivity|].
    cbn.
    rewrite (proj2 (Nat.leb_le k n)) by lia.
    apply hypothesis; lia.
Qed.

Lemma product_ext (a a' b b' : nat -> R) n : (forall k, (k <= n)%nat -> a k = a' k /\ b k = b' k) ->
  PS_mult a b n = PS_mult a' b' n.
Proof.
  intros equal.
  apply sum_eq.
  intros k order.
  rewrite (proj1 (equal k order)).
  now rewrite (proj2 (equal (n - k)%nat ltac:(lia))).
Qed.

Lemma coefficient_next n : coefficient (S n) = next coefficient n.
Proof.
  unfold coefficient at 1.
  cbn [table].
  rewrite (proj2 (Nat.leb_gt (S n) n)) by lia.
  unfold next.
  apply V_eq; cbn [X Y Z]; f_equal; f_equal; apply product_ext; intros k order;
    now rewrite (table_stable n k order).
Qed.

Definition series t := mk (PSeries (fun n => X (coefficient n)) t) (PSeries (fun n => Y (coefficient n)) t)
  (PSeries (fun n => Z (coefficient n)) t).

Lemma series_start : series 0 = start.
Proof. unfold series. rewrite !PSeries_0. now apply V_eq. Qed.

Section Bound.
Variables m s : R.
Hypotheses (hp : Rabs p <= m) (hq : Rabs q <= m) (hr : Rabs r <= m).
Hypotheses (hx : Rabs (X start) <= s) (hy : Rabs (Y start) <= s) (hz : Rabs (Z start) <= s).
Hypotheses (m_positive : 0 < m) (s_positive : 0 < s).

Lemma product_bound (a b : nat -> R) n :
  (forall k, (k <= n)%nat -> Rabs (a k) <= s * (m * s) ^ k /\ Rabs (b k) <= s * (m * s) ^ k) ->
  Rabs (PS_mult a b n) <= s * s * (m * s) ^ n * INR (S n).
Proof.
  intros bound.
  eapply Rle_trans; [apply sum_f_R0_triangle|].
  rewrite <- sum_cte.
  apply sum_Rle.
  intros k order.
  rewrite Rabs_mult.
  replace (s * s * (m * s) ^ n) with ((s * (m * s) ^ k) * (s * (m * s) ^ (n - k))).
  - apply Rmult_le_compat; try apply Rabs_pos.
    + apply bound; lia.
    + apply bound; lia.
  - replace n with (k + (n - k))%nat at 2 by lia.
    rewrite pow_add; ring.
Qed.

Lemma next_bound a b c n : Rabs a <= m ->
  (forall k, (k <= n)%nat -> Rabs (b k) <= s * (m * s) ^ k /\ Rabs (c k) <= s * (m * s) ^ k) ->
  Rabs (a * PS_mult b c n / INR (S n)) <= s * (m * s) ^ S n.
Proof.
  intros ha bound.
  assert (product := product_bound b c n bound).
  assert (count : 0 < INR (S n)) by (apply lt_0_INR; lia).
  unfold Rdiv.
  rewrite !Rabs_mult, Rabs_inv, (Rabs_right (INR (S n))) by lra.
  replace (s * (m * s) ^ S n) with (m * (s * s * (m * s) ^ n * INR (S n)) * / INR (S n)) by (cbn [pow]; field; lra).
  apply Rmult_le_compat_r; [apply Rlt_le, Rinv_0_lt_compat; auto|].
  apply Rmult_le_compat; auto; apply Rabs_pos.
Qed.

(* Cauchy's majorant. *)
Lemma coefficient_bound n : Rabs (X (coefficient n)) <= s * (m * s) ^ n /\
  Rabs (Y (coefficient n)) <= s * (m * s) ^ n /\ Rabs (Z (coefficient n)) <= s * (m * s) ^ n.
Proof.
  induction n as [n earlier] using (well_founded_induction Wf_nat.lt_wf).
  destruct n as [|n].
  - cbn [pow].
    rewrite Rmult_1_r.
    unfold coefficient; cbn; auto.
  - rewrite coefficient_next.
    unfold next; cbn [X Y Z].
    refine (conj _ (conj _ _)); apply next_bound; auto; intros k order; split; apply earlier; lia.
Qed.

Lemma radius_bound (a : nat -> R) t : (forall n, Rabs (a n) <= s * (m * s) ^ n) -> Rabs t < / (m * s) ->
  Rbar_lt (Rabs t) (CV_radius a).
Proof.
  intros bound inside.
  assert (product : 0 < m * s) by (apply Rmult_lt_0_compat; auto).
  apply Rbar_lt_le_trans with (Finite (/ (m * s))); [exact inside|].
  apply (proj1 (CV_radius_bounded a)).
  exists s.
  intros n.
  assert (powers : (m * s) ^ n * (/ (m * s)) ^ n = 1) by (rewrite <- Rpow_mult_distr, Rinv_r, pow1; lra).
  assert (positive : 0 < (/ (m * s)) ^ n) by (apply pow_lt, Rinv_0_lt_compat; auto).
  rewrite Rabs_mult, (Rabs_right ((/ (m * s)) ^ n)) by lra.
  assert (scaled := Rmult_le_compat_r _ _ _ (Rlt_le _ _ positive) (bound n)).
  rewrite Rmult_assoc, powers in scaled.
  lra.
Qed.

(* One component of the equations, at the level of power series. *)
Lemma series_derive k (a b c : nat -> R) t : (forall n, PS_derive a n = k * PS_mult b c n) ->
  Rbar_lt (Rabs t) (CV_radius a) -> Rbar_lt (Rabs t) (CV_radius b) -> Rbar_lt (Rabs t) (CV_radius c) ->
  is_derive (PSeries a) t (k * (PSeries b t * PSeries c t)).
Proof.
  intros recurrence ha hb hc.
  rewrite <- (PSeries_mult b c t hb hc), <- PSeries_scal.
  rewrite <- (PSeries_ext (PS_derive a) (PS_scal k (PS_mult b c)) t recurrence).
  now apply is_derive_PSeries.
Qed.

Theorem series_solves t : Rabs t < / (m * s) -> vderive series t (triple p q r (series t)).
Proof.
  intros inside.
  assert (cx := radius_bound (fun n => X (coefficient n)) t (fun n => proj1 (coefficient_bound n)) inside).
  assert (cy := radius_bound (fun n => Y (coefficient n)) t (fun n => proj1 (proj2 (coefficient_bound n))) inside).
  assert (cz := radius_bound (fun n => Z (coefficient n)) t (fun n => proj2 (proj2 (coefficient_bound n))) inside).
  assert (count : forall n, INR (S n) <> 0) by (intros; apply not_0_INR; lia).
  refine (conj _ (conj _ _)); unfold series; cbn [X Y Z triple]; apply series_derive; auto;
    intros n; unfold PS_derive; rewrite coefficient_next; unfold next; cbn [X Y Z]; field; apply count.
Qed.
End Bound.
End Series.
