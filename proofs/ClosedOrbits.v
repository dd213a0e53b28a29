(** * Motions of the free body are periodic: T = 4 K(m)/nu, and half a period is half a turn of L

    An orbit that circles axis 3 is the closed curve (A cos phi, B sin phi, C sqrt(1 - m sin^2 phi)).  Along it the
    field is nu sqrt(1 - m sin^2 phi) times the derivative by phi, so time is clock m phi / nu up to a constant
    (EllipticClock.v).  A given motion, written in phi instead of time, obeys the same equation with the same initial
    value as the curve: Uniqueness.v makes them equal.  The clock need not be inverted, only be onto.

    Source: Landau and Lifshitz, Mechanics, section 37; Whittaker, Analytical Dynamics, section 69. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Vec3 Calculus Euler Stability Uniqueness GlobalSolution EllipticClock.
Local Open Scope R_scope.

Lemma two_squares_zero k x y : 0 < k -> x * x + k * (y * y) = 0 -> x = 0 /\ y = 0.
Proof.
  intros positive sum.
  assert (x2 := Rle_0_sqr x).
  assert (y2 := Rle_0_sqr y).
  unfold Rsqr in *.
  assert (part := Rmult_le_pos k (y * y) (Rlt_le _ _ positive) y2).
  assert (x_zero : x * x = 0) by lra.
  assert (y_zero : k * (y * y) = 0) by lra.
  destruct (Rmult_integral _ _ y_zero) as [k_zero|y_square]; [lra|].
  destruct (Rmult_integral _ _ x_zero), (Rmult_integral _ _ y_square); auto.
Qed.

Lemma same_sign_squares x y : x * x = y * y -> 0 < x * y -> x = y.
Proof.
  intros squares sign.
  assert (factors : (x - y) * (x + y) = 0) by (ring_simplify; lra).
  destruct (Rmult_integral _ _ factors) as [equal|contrary]; [lra|].
  assert (x = - y) as -> by lra.
  assert (y2 := Rle_0_sqr y).
  unfold Rsqr in y2.
  lra.
Qed.

Section Circling.
Variables p q r : R.
Hypothesis balanced : p + q + r = 0.
(* Axis 3 is extremal and axis 2 intermediate (or as extreme as axis 1). *)
Hypothesis opposite : p * q < 0.
Hypothesis middle : q * r <= 0.
Variable L : R -> V.
Hypothesis solution : forall t, solves_at p q r L t.
(* The orbit is inside the separatrix that surrounds axis 3. *)
Hypothesis inside : q * (p * (Z (L 0) * Z (L 0)) - r * (X (L 0) * X (L 0))) < 0.
Variables nu m : R.
Hypothesis nu_positive : 0 < nu.
Hypothesis nu_square : nu * nu = - p * (q * (Z (L 0) * Z (L 0)) - r * (Y (L 0) * Y (L 0))).
Hypothesis m_value : m * (nu * nu) = - r * (q * (X (L 0) * X (L 0)) - p * (Y (L 0) * Y (L 0))).

Lemma m_range : 0 <= m < 1.
Proof.
  assert (square_positive : 0 < nu * nu) by nra.
  assert (x2 := Rle_0_sqr (X (L 0))).
  assert (y2 := Rle_0_sqr (Y (L 0))).
  unfold Rsqr in *.
  assert (pr : 0 <= p * r).
  { destruct (Rlt_dec 0 q) as [up|down].
    - assert (p < 0) by nra.
      nra.
    - assert (q < 0) by nra.
      assert (0 < p) by nra.
      nra. }
  split.
  - apply (Rmult_le_reg_r (nu * nu)); auto.
    rewrite m_value.
    nra.
  - apply (Rmult_lt_reg_r (nu * nu)); auto.
    rewrite m_value, nu_square.
    nra.
Qed.

(* The closed curve that the orbit fills. *)
Definition curve a b c phi := mk (a * cos phi) (b * sin phi) (c * delta m phi).

Lemma curve_derive a b c phi : - a * nu = p * (b * c) -> b * nu = q * (c * a) -> - c * m * nu = r * (a * b) ->
  has_velocity (curve a b c) phi (scale (/ (nu * delta m phi)) (triple p q r (curve a b c phi))).
Proof.
  intros ha hb hc.
  assert (root := delta_positive m m_range phi).
  refine (conj _ (conj _ _)); unfold curve; cbn [X Y Z scale triple].
  - replace (/ (nu * delta m phi) * (p * (b * sin phi * (c * delta m phi)))) with
      (p * (b * c) * (sin phi * / nu)) by (field; lra).
    rewrite <- ha.
    replace (- a * nu * (sin phi * / nu)) with (a * - sin phi) by (field; lra).
    apply (is_derive_scal cos phi a).
    apply is_derive_Reals, derivable_pt_lim_cos.
  - replace (/ (nu * delta m phi) * (q * (c * delta m phi * (a * cos phi)))) with
      (q * (c * a) * (cos phi * / nu)) by (field; lra).
    rewrite <- hb.
    replace (b * nu * (cos phi * / nu)) with (b * cos phi) by (field; lra).
    apply (is_derive_scal sin phi b).
    apply is_derive_Reals, derivable_pt_lim_sin.
  - replace (/ (nu * delta m phi) * (r * (a * cos phi * (b * sin phi)))) with
      (r * (a * b) * (sin phi * cos phi * / (nu * delta m phi))) by (field; lra).
    rewrite <- hc.
    replace (- c * m * nu * (sin phi * cos phi * / (nu * delta m phi))) with
      (c * (- (m * sin phi * cos phi) / delta m phi)) by (field; lra).
    apply (is_derive_scal (delta m) phi c).
    apply (delta_derive m m_range).
Qed.

(* The constants a, b, c and the angle at time 0. *)
Lemma constants_exist : exists a b c phi, - a * nu = p * (b * c) /\ b * nu = q * (c * a) /\
  - c * m * nu = r * (a * b) /\ curve a b c phi = L 0 /\ (a = 0 \/ b = 0 -> X (L 0) = 0 /\ Y (L 0) = 0).
Proof.
  set (x := X (L 0)) in *.
  set (y := Y (L 0)) in *.
  set (z := Z (L 0)) in *.
  assert (p_nonzero : p <> 0) by nra.
  assert (q_nonzero : q <> 0) by nra.
  assert (square_positive : 0 < nu * nu) by nra.
  assert (x2 := Rle_0_sqr x).
  assert (y2 := Rle_0_sqr y).
  assert (z2 := Rle_0_sqr z).
  unfold Rsqr in *.
  assert (ratio : 0 < - (p / q)).
  { replace (- (p / q)) with (- (p * q) * / (q * q)) by (field; auto).
    apply Rmult_lt_0_compat; [lra|].
    apply Rinv_0_lt_compat; nra. }
  assert (ratio' : 0 < - (q / p)).
  { replace (- (q / p)) with (/ - (p / q)) by (field; auto).
    apply Rinv_0_lt_compat; auto. }
  set (a := sqrt (x * x - p / q * (y * y))).
  assert (a_square : a * a = x * x - p / q * (y * y)) by (apply sqrt_sqrt; nra).
  assert (a_positive : 0 <= a) by apply sqrt_pos.
  assert (z_nonzero : z <> 0).
  { intros z_zero.
    rewrite z_zero in inside.
    nra. }
  assert (c_exists : exists c, - (p * q) * (c * c) = nu * nu /\ 0 < c * z).
  { assert (root := sqrt_lt_R0 (- (p * q)) ltac:(lra)).
    assert (square := sqrt_sqrt (- (p * q)) ltac:(lra)).
    set (k := sqrt (- (p * q))) in *.
    destruct (Rlt_dec 0 z) as [up|down].
    - exists (nu / k).
      split.
      + rewrite <- square; field; lra.
      + apply Rmult_lt_0_compat; auto.
        apply Rdiv_lt_0_compat; auto.
    - exists (- (nu / k)).
      split.
      + rewrite <- square; field; lra.
      + assert (positive : 0 < nu / k) by (apply Rdiv_lt_0_compat; auto).
        nra. }
  destruct c_exists as (c & c_square & c_sign).
  set (b := q * (c * a) / nu).
  assert (hb : b * nu = q * (c * a)) by (unfold b; field; lra).
  assert (ha : - a * nu = p * (b * c)).
  { apply (Rmult_eq_reg_r nu); [|lra].
    replace (p * (b * c) * nu) with (p * c * (b * nu)) by ring.
    rewrite hb.
    replace (- a * nu * nu) with (- a * (nu * nu)) by ring.
    rewrite <- c_square; ring. }
  assert (b_square : b * b = y * y - q / p * (x * x)).
  { apply (Rmult_eq_reg_r (nu * nu)); [|lra].
    replace (b * b * (nu * nu)) with ((b * nu) * (b * nu)) by ring.
    rewrite hb, <- c_square.
    replace (q * (c * a) * (q * (c * a))) with (q * q * (c * c) * (a * a)) by ring.
    rewrite a_square.
    field; auto. }
  assert (hc : - c * m * nu = r * (a * b)).
  { apply (Rmult_eq_reg_r nu); [|lra].
    replace (r * (a * b) * nu) with (r * a * (b * nu)) by ring.
    rewrite hb.
    replace (r * a * (q * (c * a))) with (r * q * c * (a * a)) by ring.
    rewrite a_square.
    replace (- c * m * nu * nu) with (- c * (m * (nu * nu))) by ring.
    rewrite m_value.
    field; auto. }
  assert (rest : a = 0 \/ b = 0 -> x = 0 /\ y = 0).
  { intros zero.
    assert (a_zero : a * a = 0).
    { destruct zero as [e|e].
      - rewrite e; ring.
      - rewrite e in ha.
        assert (product : a * nu = 0) by (rewrite Rmult_0_l, Rmult_0_r in ha; lra).
        destruct (Rmult_integral _ _ product) as [->|nu_zero]; [ring | lra]. }
    rewrite a_square in a_zero.
    apply (two_squares_zero (- (p / q))); lra. }
  assert (angle : exists phi, a * cos phi = x /\ b * sin phi = y).
  { destruct (Req_dec a 0) as [flat|open].
    - exists 0.
      destruct (rest (or_introl flat)) as (-> & ->).
      rewrite flat, sin_0.
      split; ring.
    - assert (b_nonzero : b <> 0).
      { intros e.
        rewrite e, Rmult_0_l, Rmult_0_r in ha.
        assert (product : a * nu = 0) by lra.
        destruct (Rmult_integral _ _ product); [contradiction | lra]. }
      destruct (angle_exists (x / a) (y / b)) as (phi & cosine & sine).
      + replace (x / a * (x / a) + y / b * (y / b)) with (x * x * / (a * a) + y * y * / (b * b)) by (field; auto).
        assert (a2 : a * a <> 0) by (now apply Rmult_integral_contrapositive_currified).
        replace (b * b) with (- (q / p) * (a * a)) by (rewrite b_square, a_square; field; auto).
        transitivity ((x * x - p / q * (y * y)) * / (a * a)); [field; auto|].
        rewrite <- a_square.
        now apply Rinv_r.
      + exists phi.
        rewrite cosine, sine.
        split; field; auto. }
  destruct angle as (phi & hx & hy).
  exists a, b, c, phi.
  refine (conj ha (conj hb (conj hc (conj _ rest)))).
  apply V_eq; cbn [curve X Y Z]; auto.
  fold z.
  assert (root := delta_positive m m_range phi).
  assert (square : delta m phi * delta m phi = 1 - m * (sin phi * sin phi)).
  { apply sqrt_sqrt.
    assert (bound := delta_square m m_range phi).
    lra. }
  assert (c2 : q * (c * c) = q * (z * z) - r * (y * y)).
  { apply (Rmult_eq_reg_l (- p)); [|lra].
    rewrite <- nu_square, <- c_square; ring. }
  assert (height : (c * delta m phi) * (c * delta m phi) = z * z).
  { replace ((c * delta m phi) * (c * delta m phi)) with (c * c * (delta m phi * delta m phi)) by ring.
    rewrite square.
    apply (Rmult_eq_reg_l q); auto.
    replace (q * (c * c * (1 - m * (sin phi * sin phi)))) with
      (q * (c * c) - q * c * (c * m) * (sin phi * sin phi)) by ring.
    assert (cm : c * m = - (r * (a * b)) / nu) by (rewrite <- hc; field; lra).
    rewrite cm, c2.
    replace (q * c * (- (r * (a * b)) / nu)) with (- r * b * (q * (c * a) / nu)) by (field; lra).
    fold b.
    replace (- r * b * b * (sin phi * sin phi)) with (- r * ((b * sin phi) * (b * sin phi))) by ring.
    rewrite hy; ring. }
  apply same_sign_squares; auto.
  replace (c * delta m phi * z) with (c * z * delta m phi) by ring.
  now apply Rmult_lt_0_compat.
Qed.

(* The motion as explicit functions of the angle. *)
Theorem motion_by_angle : exists a b c phi0, curve a b c phi0 = L 0 /\
  (a = 0 \/ b = 0 -> X (L 0) = 0 /\ Y (L 0) = 0) /\
  forall phi, L ((clock m phi - clock m phi0) / nu) = curve a b c phi.
Proof.
  destruct constants_exist as (a & b & c & phi0 & ha & hb & hc & first & rest).
  exists a, b, c, phi0.
  refine (conj first (conj rest _)).
  intros phi.
  set (time := fun x => (clock m x - clock m phi0) / nu).
  assert (range := m_range).
  assert (le1 := Rmin_l phi phi0).
  assert (le2 := Rmin_r phi phi0).
  assert (le3 := Rmax_l phi phi0).
  assert (le4 := Rmax_r phi phi0).
  change (L (time phi) = curve a b c phi).
  apply (driven_unique p q r balanced (fun x => / (nu * delta m x)) (/ (nu * sqrt (1 - m)))
    (fun x => L (time x)) (curve a b c) (Rmin phi phi0) (Rmax phi phi0) phi0); try lra.
  - intros x _.
    assert (root := delta_positive m range x).
    assert (least := delta_ge m range x).
    assert (floor := sqrt_lt_R0 (1 - m) ltac:(lra)).
    rewrite Rabs_right.
    + apply Rinv_le_contravar.
      * apply Rmult_lt_0_compat; auto.
      * apply Rmult_le_compat_l; lra.
    + apply Rle_ge, Rlt_le, Rinv_0_lt_compat, Rmult_lt_0_compat; auto.
  - intros x _.
    assert (root := delta_positive m range x).
    assert (slope : is_derive time x (/ (nu * delta m x))).
    { replace (/ (nu * delta m x)) with (/ nu * (/ delta m x - 0)) by (field; lra).
      apply (is_derive_ext (fun s => / nu * (clock m s - clock m phi0))).
      - intros s.
        apply (Rmult_comm (/ nu)).
      - apply (is_derive_scal (fun s => clock m s - clock m phi0)).
        apply (is_derive_minus (clock m) (fun _ => clock m phi0)).
        + now apply clock_derive.
        + apply (is_derive_const (clock m phi0)). }
    destruct (solution (time x)) as (dx & dy & dz).
    refine (conj _ (conj _ _)).
    + exact (is_derive_comp (fun s => X (L s)) time x _ _ dx slope).
    + exact (is_derive_comp (fun s => Y (L s)) time x _ _ dy slope).
    + exact (is_derive_comp (fun s => Z (L s)) time x _ _ dz slope).
  - intros x _.
    now apply curve_derive.
  - rewrite first.
    f_equal.
    unfold time; field; lra.
Qed.

Lemma time_to_angle phi0 t : exists phi, t = (clock m phi - clock m phi0) / nu.
Proof.
  destruct (clock_onto m m_range (nu * t + clock m phi0)) as (phi & value).
  exists phi.
  rewrite value; field; lra.
Qed.

Definition half_turn3 u := mk (- X u) (- Y u) (Z u).

Theorem half_period3 t : L (t + 2 * quarter m / nu) = half_turn3 (L t).
Proof.
  destruct motion_by_angle as (a & b & c & phi0 & _ & _ & explicit).
  destruct (time_to_angle phi0 t) as (phi & ->).
  assert (later : (clock m phi - clock m phi0) / nu + 2 * quarter m / nu = (clock m (phi + PI) - clock m phi0) / nu).
  { rewrite (clock_half_turn m m_range).
    field; lra. }
  rewrite later, !explicit.
  unfold curve, half_turn3; cbn [X Y Z].
  rewrite neg_cos, neg_sin, delta_half_turn.
  apply V_eq; cbn; ring.
Qed.

Theorem period3 t : L (t + 4 * quarter m / nu) = L t.
Proof.
  replace (t + 4 * quarter m / nu) with (t + 2 * quarter m / nu + 2 * quarter m / nu) by (field; lra).
  rewrite !half_period3.
  unfold half_turn3; apply V_eq; cbn; ring.
Qed.

(* Unless L stays on axis 3, the motion takes no value twice within a period. *)
Theorem period3_least : ~ (X (L 0) = 0 /\ Y (L 0) = 0) -> forall t s, 0 < s < 4 * quarter m / nu -> L (t + s) <> L t.
Proof.
  intros moving t s hs equal.
  destruct motion_by_angle as (a & b & c & phi0 & _ & rest & explicit).
  destruct (time_to_angle phi0 t) as (phi & ht).
  destruct (time_to_angle phi0 (t + s)) as (psi & hts).
  assert (a_nonzero : a <> 0) by tauto.
  assert (b_nonzero : b <> 0) by tauto.
  rewrite hts, ht, !explicit in equal.
  assert (cosine : cos psi = cos phi) by (apply (f_equal X) in equal; apply (Rmult_eq_reg_l a); auto).
  assert (sine : sin psi = sin phi) by (apply (f_equal Y) in equal; apply (Rmult_eq_reg_l b); auto).
  assert (elapsed : clock m psi - clock m phi = nu * s).
  { replace (nu * s) with (nu * (t + s) - nu * t) by ring.
    rewrite hts, ht; field; lra. }
  assert (full : nu * s < 4 * quarter m).
  { replace (4 * quarter m) with (nu * (4 * quarter m / nu)) by (field; lra).
    apply Rmult_lt_compat_l; lra. }
  assert (turn : clock m (phi + PI + PI) = clock m phi + 4 * quarter m).
  { rewrite !(clock_half_turn m m_range); ring. }
  assert (forward_in_time : 0 < nu * s) by (apply Rmult_lt_0_compat; lra).
  assert (after : phi < psi) by (apply (clock_increasing m m_range); lra).
  assert (before : psi < phi + PI + PI) by (apply (clock_increasing m m_range); lra).
  assert (half : 0 < sin ((psi - phi) / 2)) by (apply sin_gt_0; lra).
  assert (difference : cos (psi - phi) = 1).
  { rewrite cos_minus, cosine, sine.
    assert (circle := sin2_cos2 phi).
    unfold Rsqr in circle.
    lra. }
  replace (psi - phi) with (2 * ((psi - phi) / 2)) in difference by field.
  rewrite cos_2a_sin in difference.
  assert (square := Rmult_lt_0_compat _ _ half half).
  lra.
Qed.
End Circling.
