(** * The time that a closed orbit takes, as an incomplete elliptic integral of an angle

    clock m phi = integral from 0 to phi of 1/sqrt(1 - m sin^2 x), for 0 <= m < 1 (Legendre's F with parameter m).
    It increases without bound both ways, and half a turn of the angle always takes 2 K(m).  Both shifts follow from
    derivatives that vanish, so no change of variables in integrals is needed.

    Source: Digital Library of Mathematical Functions, 19.2.4 and 19.2.10. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Vec3 Calculus.
Local Open Scope R_scope.

Lemma sin2_bound x : 0 <= sin x * sin x <= 1.
Proof.
  assert (circle := sin2_cos2 x).
  unfold Rsqr in circle.
  nra.
Qed.

Lemma angle_exists x y : x * x + y * y = 1 -> exists phi, cos phi = x /\ sin phi = y.
Proof.
  intros unit.
  assert (range : -1 <= x <= 1) by (split; nra).
  assert (bounds := acos_bound x).
  assert (cosine := cos_acos x range).
  assert (circle := sin2_cos2 (acos x)).
  unfold Rsqr in circle.
  rewrite cosine in circle.
  assert (positive := sin_ge_0 (acos x) (proj1 bounds) (proj2 bounds)).
  destruct (Rle_dec 0 y) as [up|down].
  - exists (acos x).
    split; [exact cosine | nra].
  - exists (- acos x).
    rewrite cos_neg, sin_neg.
    split; [exact cosine | nra].
Qed.

Lemma constant_everywhere f : (forall t, is_derive f t 0) -> forall s t, f s = f t.
Proof.
  intros flat s t.
  rewrite (const_of_derive f (Rmin s t) (Rmax s t)); auto using Rmin_l, Rmax_l.
  rewrite (const_of_derive f (Rmin s t) (Rmax s t) (fun x _ => flat x) t); auto using Rmin_r, Rmax_r.
Qed.

Section Elliptic.
Variable m : R.
Hypothesis range : 0 <= m < 1.

Definition delta x := sqrt (1 - m * (sin x * sin x)).
Definition clock (phi : R) : R := RInt (fun x => / delta x) 0 phi.
Definition quarter := clock (PI / 2).

Lemma delta_square x : 0 < 1 - m * (sin x * sin x) <= 1.
Proof. assert (bound := sin2_bound x). nra. Qed.

Lemma delta_positive x : 0 < delta x.
Proof. apply sqrt_lt_R0, delta_square. Qed.

Lemma delta_le_1 x : delta x <= 1.
Proof. unfold delta. rewrite <- sqrt_1 at 2. apply sqrt_le_1_alt, delta_square. Qed.

Lemma delta_ge x : sqrt (1 - m) <= delta x.
Proof. assert (bound := sin2_bound x). apply sqrt_le_1_alt. nra. Qed.

Lemma delta_half_turn x : delta (x + PI) = delta x.
Proof. unfold delta. rewrite neg_sin. f_equal; ring. Qed.

Lemma delta_reflected x : delta (PI - x) = delta x.
Proof. unfold delta. now rewrite sin_PI_x. Qed.

Lemma rate_continuous x : continuous (fun x => / delta x) x.
Proof.
  apply (ex_derive_continuous (fun x => / delta x)).
  assert (positive := delta_square x).
  assert (root := delta_positive x).
  unfold delta in *.
  auto_derive.
  unfold Rminus in *.
  refine (conj (proj1 positive) (conj _ I)); lra.
Qed.

Lemma clock_derive phi : is_derive clock phi (/ delta phi).
Proof.
  unfold clock.
  apply (is_derive_RInt (fun x => / delta x) _ 0 phi).
  - apply filter_forall.
    intros b.
    apply (@RInt_correct R_CompleteNormedModule).
    apply (@ex_RInt_continuous R_CompleteNormedModule).
    intros x _.
    apply rate_continuous.
  - apply rate_continuous.
Qed.

Lemma clock_0 : clock 0 = 0.
Proof. exact (RInt_point 0 (fun x => / delta x)). Qed.

(* The clock runs at least as fast as the angle, so it is strictly increasing and takes every value. *)
Lemma clock_rate a b : a <= b -> b - a <= clock b - clock a.
Proof.
  intros order.
  destruct (MVT_gen clock a b (fun x => / delta x)) as (x & _ & mean).
  - intros; apply clock_derive.
  - intros x _.
    apply derivable_continuous_pt.
    exists (/ delta x).
    apply is_derive_Reals, clock_derive.
  - rewrite mean.
    assert (fast : 1 <= / delta x).
    { rewrite <- Rinv_1.
      apply Rinv_le_contravar; [apply delta_positive | apply delta_le_1]. }
    nra.
Qed.

Lemma clock_onto t : exists phi, clock phi = t.
Proof.
  assert (size := Rabs_pos t).
  assert (ends := Rle_refl (Rabs t)).
  apply Rabs_le_between in ends.
  assert (above := clock_rate 0 (Rabs t) size).
  assert (below := clock_rate (- Rabs t) 0 ltac:(lra)).
  rewrite clock_0 in above, below.
  destruct (IVT_gen clock (- Rabs t) (Rabs t) t) as (phi & _ & value).
  - intros x.
    apply derivable_continuous_pt.
    exists (/ delta x).
    apply is_derive_Reals, clock_derive.
  - rewrite Rmin_left, Rmax_right by lra.
    lra.
  - now exists phi.
Qed.

Lemma clock_increasing a b : clock a < clock b -> a < b.
Proof.
  intros order.
  destruct (Rlt_dec a b) as [yes|no]; [exact yes|].
  assert (reversed := clock_rate b a ltac:(lra)).
  lra.
Qed.

Lemma clock_PI : clock PI = 2 * quarter.
Proof.
  assert (constant := constant_everywhere (fun x => clock (PI - x) + clock x)).
  assert (flat : forall x, is_derive (fun x => clock (PI - x) + clock x) x 0).
  { intros x.
    replace 0 with (-1 * / delta (PI - x) + / delta x) by (rewrite delta_reflected; ring).
    apply (is_derive_plus (fun x => clock (PI - x)) clock); [|apply clock_derive].
    apply (is_derive_comp clock (fun x => PI - x)); [apply clock_derive|].
    auto_derive; auto; ring. }
  assert (ends := constant flat 0 (PI / 2)).
  cbn beta in ends.
  replace (PI - PI / 2) with (PI / 2) in ends by field.
  rewrite Rminus_0_r, clock_0 in ends.
  unfold quarter; lra.
Qed.

Theorem clock_half_turn phi : clock (phi + PI) = clock phi + 2 * quarter.
Proof.
  assert (constant := constant_everywhere (fun x => clock (x + PI) - clock x)).
  assert (flat : forall x, is_derive (fun x => clock (x + PI) - clock x) x 0).
  { intros x.
    replace 0 with (1 * / delta (x + PI) - / delta x) by (rewrite delta_half_turn; ring).
    apply (is_derive_minus (fun x => clock (x + PI)) clock); [|apply clock_derive].
    apply (is_derive_comp clock (fun x => x + PI)); [apply clock_derive|].
    auto_derive; auto; ring. }
  assert (ends := constant flat phi 0).
  cbn beta in ends.
  rewrite Rplus_0_l, clock_0, clock_PI in ends.
  lra.
Qed.

Lemma quarter_positive : 0 < quarter.
Proof.
  assert (pi := PI_RGT_0).
  assert (fast := clock_rate 0 (PI / 2) ltac:(lra)).
  rewrite clock_0 in fast.
  unfold quarter; lra.
Qed.

Lemma delta_derive x : is_derive delta x (- (m * sin x * cos x) / delta x).
Proof.
  assert (positive := delta_square x).
  assert (root := delta_positive x).
  unfold delta in *.
  unfold Rminus in *.
  auto_derive.
  - lra.
  - field; lra.
Qed.
End Elliptic.
