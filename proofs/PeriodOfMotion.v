(** * The period in the textbook's terms: twice the energy E, the square G = |L|^2 and the principal moments

    With I1 < I2 < I3 an orbit circles axis 3 where G > I2 E and axis 1 where G < I2 E; G = I2 E is the separatrix.
    Both cases are one theorem of ClosedOrbits.v, since a permutation of the axes permutes the three rates.

    Source: Landau and Lifshitz, Mechanics, section 37, equations (37.8) to (37.12), where 2 E is our E. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Vec3 Calculus Euler Stability Uniqueness GlobalSolution EllipticClock ClosedOrbits.
Local Open Scope R_scope.

(* For an orbit about the axis with moment c, b the middle moment and a the other one. *)
Definition angular_rate a b c E G := sqrt ((c - b) * (G - a * E) / (a * b * c)).
Definition elliptic_m a b c E G := (b - a) * (c * E - G) / ((c - b) * (G - a * E)).
Definition complete_K m := RInt (fun x => / sqrt (1 - m * (sin x * sin x))) 0 (PI / 2).
Definition period a b c E G := 4 * complete_K (elliptic_m a b c E G) / angular_rate a b c E G.

Definition half_turn1 u := mk (X u) (- Y u) (- Z u).

(* L returns after T, not earlier, and is turned half way round after T/2. *)
Definition closed_orbit (L : R -> V) T turn := 0 < T /\ (forall t, L (t + T / 2) = turn (L t)) /\
  (forall t, L (t + T) = L t) /\ (forall t s, 0 < s < T -> L (t + s) <> L t).

Section Body.
Variables I1 I2 I3 : R.
Hypotheses (p1 : 0 < I1) (p2 : 0 < I2) (p3 : 0 < I3).
Variable L : R -> V.
Hypothesis solution : motion I1 I2 I3 L.
Let E := double_energy I1 I2 I3 (L 0).
Let G := norm_squared (L 0).

Lemma solves_everywhere t : solves_at (rate1 I2 I3) (rate2 I1 I3) (rate3 I1 I2) L t.
Proof. now apply solves_of_motion. Qed.

(* Either I1 <= I2 < I3 with G > I2 E (short-axis mode for a solid body), or I1 >= I2 > I3 with G < I2 E. *)
Section Axis3.
Hypothesis middle : 0 <= (I2 - I1) * (I3 - I2).
Hypothesis circled : 0 < (I3 - I2) * (G - I2 * E).
Let nu := angular_rate I1 I2 I3 E G.
Let m := elliptic_m I1 I2 I3 E G.

Lemma moments_product : 0 < I1 * I2 * I3.
Proof. repeat apply Rmult_lt_0_compat; auto. Qed.

(* G - I1 E has the sign of I3 - I2. *)
Lemma rate_argument : 0 < (I3 - I2) * (G - I1 * E).
Proof.
  assert (split_value : (I3 - I2) * (G - I1 * E) = (I3 - I2) * (G - I2 * E) + (I2 - I1) * (I3 - I2) * E) by ring.
  assert (energy_positive : 0 <= E).
  { unfold E, double_energy.
    assert (x2 := Rle_0_sqr (X (L 0))).
    assert (y2 := Rle_0_sqr (Y (L 0))).
    assert (z2 := Rle_0_sqr (Z (L 0))).
    unfold Rsqr in *.
    repeat apply Rplus_le_le_0_compat; apply Rmult_le_pos; auto; apply Rlt_le, Rinv_0_lt_compat; auto. }
  assert (rest := Rmult_le_pos _ _ middle energy_positive).
  lra.
Qed.

Lemma nu_square3 : nu * nu =
  - rate1 I2 I3 * (rate2 I1 I3 * (Z (L 0) * Z (L 0)) - rate3 I1 I2 * (Y (L 0) * Y (L 0))).
Proof.
  unfold nu, angular_rate.
  rewrite sqrt_sqrt.
  - unfold E, G, double_energy, norm_squared, dot, rate1, rate2, rate3.
    field; lra.
  - apply Rlt_le, Rdiv_lt_0_compat; [apply rate_argument | apply moments_product].
Qed.

Lemma nu_positive3 : 0 < nu.
Proof. apply sqrt_lt_R0, Rdiv_lt_0_compat; [apply rate_argument | apply moments_product]. Qed.

Lemma m_value3 : m * (nu * nu) =
  - rate3 I1 I2 * (rate2 I1 I3 * (X (L 0) * X (L 0)) - rate1 I2 I3 * (Y (L 0) * Y (L 0))).
Proof.
  assert (positive := rate_argument).
  assert (product := moments_product).
  unfold nu, angular_rate, m, elliptic_m.
  rewrite sqrt_sqrt by (apply Rlt_le, Rdiv_lt_0_compat; auto).
  transitivity ((I2 - I1) * (I3 * E - G) / (I1 * I2 * I3)).
  - revert positive product.
    generalize ((I3 - I2) * (G - I1 * E)), (I1 * I2 * I3).
    intros a b ha hb.
    field; lra.
  - unfold E, G, double_energy, norm_squared, dot, rate1, rate2, rate3.
    field; lra.
Qed.

Lemma opposite3 : rate1 I2 I3 * rate2 I1 I3 < 0.
Proof.
  assert (apart : I3 - I2 <> 0) by (intros equal; rewrite equal in circled; lra).
  assert (square : 0 < (I3 - I2) * (I3 - I2)) by nra.
  replace (rate1 I2 I3 * rate2 I1 I3) with
    (- (((I3 - I2) * (I3 - I2) + (I2 - I1) * (I3 - I2)) * / (I1 * I2 * I3 * I3))) by (unfold rate1, rate2; field; lra).
  assert (inverse : 0 < / (I1 * I2 * I3 * I3)) by (apply Rinv_0_lt_compat; repeat apply Rmult_lt_0_compat; auto).
  apply Ropp_lt_gt_0_contravar, Rmult_lt_0_compat; lra.
Qed.

Lemma middle3 : rate2 I1 I3 * rate3 I1 I2 <= 0.
Proof.
  replace (rate2 I1 I3 * rate3 I1 I2) with
    (- (((I2 - I1) * (I3 - I2) + (I2 - I1) * (I2 - I1)) * / (I1 * I1 * I2 * I3))) by (unfold rate2, rate3; field; lra).
  assert (inverse : 0 < / (I1 * I1 * I2 * I3)) by (apply Rinv_0_lt_compat; repeat apply Rmult_lt_0_compat; auto).
  assert (square := Rle_0_sqr (I2 - I1)).
  unfold Rsqr in square.
  enough (0 <= ((I2 - I1) * (I3 - I2) + (I2 - I1) * (I2 - I1)) * / (I1 * I1 * I2 * I3)) by lra.
  apply Rmult_le_pos; lra.
Qed.

Lemma inside3 : rate2 I1 I3 * (rate1 I2 I3 * (Z (L 0) * Z (L 0)) - rate3 I1 I2 * (X (L 0) * X (L 0))) < 0.
Proof.
  set (value := rate1 I2 I3 * (Z (L 0) * Z (L 0)) - rate3 I1 I2 * (X (L 0) * X (L 0))).
  assert (separatrix : (I3 - I2) * (G - I2 * E) = I2 * I2 * I3 * (rate1 I2 I3 * value)).
  { unfold value, E, G, double_energy, norm_squared, dot, rate1, rate3.
    field; lra. }
  assert (weight : 0 < I2 * I2 * I3) by (repeat apply Rmult_lt_0_compat; auto).
  assert (same : 0 < rate1 I2 I3 * value).
  { apply (Rmult_lt_reg_l (I2 * I2 * I3)); auto.
    lra. }
  assert (other := opposite3).
  revert same other.
  generalize (rate1 I2 I3), (rate2 I1 I3), value.
  intros a b v same other.
  assert (product := Rmult_lt_0_compat (- (a * b)) (a * v) ltac:(lra) same).
  assert (square := Rle_0_sqr a).
  unfold Rsqr in square.
  destruct (Rlt_dec (b * v) 0) as [negative|other_sign]; [exact negative|].
  assert (contrary := Rmult_le_pos (a * a) (b * v) square ltac:(lra)).
  lra.
Qed.

Theorem circles_axis3 : ~ (X (L 0) = 0 /\ Y (L 0) = 0) -> closed_orbit L (period I1 I2 I3 E G) half_turn3.
Proof.
  intros moving.
  assert (balanced := rates_balanced I1 I2 I3).
  assert (positive := nu_positive3).
  assert (range := m_range _ _ _ balanced opposite3 middle3 L inside3 nu m positive nu_square3 m_value3).
  change (closed_orbit L (4 * quarter m / nu) half_turn3).
  refine (conj _ (conj _ (conj _ _))).
  - assert (quarter_time := quarter_positive m range).
    apply Rdiv_lt_0_compat; lra.
  - intros t.
    replace (4 * quarter m / nu / 2) with (2 * quarter m / nu) by (field; lra).
    exact (half_period3 _ _ _ balanced opposite3 middle3 L solves_everywhere inside3 nu m positive nu_square3
      m_value3 t).
  - exact (period3 _ _ _ balanced opposite3 middle3 L solves_everywhere inside3 nu m positive nu_square3 m_value3).
  - exact (period3_least _ _ _ balanced opposite3 middle3 L solves_everywhere inside3 nu m positive nu_square3
      m_value3 moving).
Qed.
End Axis3.
End Body.

Lemma square_derive (f : R -> R) t d : is_derive f t d -> is_derive (fun s => f s * f s) t (2 * f t * d).
Proof.
  intros derivative.
  replace (2 * f t * d) with (d * f t + f t * d) by ring.
  exact (is_derive_mult f f t d d derivative derivative Rmult_comm).
Qed.

Definition swap13 u := mk (Z u) (Y u) (X u).

Section Orbits.
Variables I1 I2 I3 : R.
Hypotheses (p1 : 0 < I1) (p2 : 0 < I2) (p3 : 0 < I3).
Variable L : R -> V.
Hypothesis solution : motion I1 I2 I3 L.
Let E := double_energy I1 I2 I3 (L 0).
Let G := norm_squared (L 0).

(* Exchange of the axes 1 and 3 is a reflection: it turns a motion into a motion of the relabelled body run backward. *)
Lemma swapped_motion : motion I3 I2 I1 (fun t => swap13 (L (- t))).
Proof.
  intros t.
  apply solves_of_motion; auto.
  apply (solves_reversed _ _ _ (fun s => swap13 (L s)) t).
  destruct (solution (- t)) as (x & y & z).
  rewrite euler_field_components in x, y, z by auto.
  refine (conj _ (conj _ _)); unfold swap13, triple, rate1, rate2, rate3; cbn [X Y Z] in *.
  - replace (- (1 / I1 - 1 / I2) * (Y (L (- t)) * X (L (- t)))) with
      ((1 / I2 - 1 / I1) * (X (L (- t)) * Y (L (- t)))) by ring.
    exact z.
  - replace (- (1 / I3 - 1 / I1) * (X (L (- t)) * Z (L (- t)))) with
      ((1 / I1 - 1 / I3) * (Z (L (- t)) * X (L (- t)))) by ring.
    exact y.
  - replace (- (1 / I2 - 1 / I3) * (Z (L (- t)) * Y (L (- t)))) with
      ((1 / I3 - 1 / I2) * (Y (L (- t)) * Z (L (- t)))) by ring.
    exact x.
Qed.

Lemma closed_orbit_swapped T : closed_orbit (fun t => swap13 (L (- t))) T half_turn3 -> closed_orbit L T half_turn1.
Proof.
  intros (positive & half & whole & least).
  assert (back : forall u v, swap13 u = swap13 v -> u = v).
  { intros u v equal.
    apply V_eq; [apply (f_equal Z) in equal | apply (f_equal Y) in equal | apply (f_equal X) in equal]; exact equal. }
  refine (conj positive (conj _ (conj _ _))).
  - intros t.
    apply back.
    assert (turn := half (- (t + T / 2))).
    replace (- (- (t + T / 2) + T / 2)) with t in turn by ring.
    rewrite Ropp_involutive in turn.
    unfold half_turn1.
    assert (hx := f_equal X turn).
    assert (hy := f_equal Y turn).
    assert (hz := f_equal Z turn).
    unfold swap13, half_turn3 in *; cbn [X Y Z] in *.
    rewrite hx, hy, hz.
    apply V_eq; cbn [X Y Z]; ring.
  - intros t.
    apply back.
    assert (turn := whole (- (t + T))).
    replace (- (- (t + T) + T)) with t in turn by ring.
    rewrite Ropp_involutive in turn.
    now symmetry.
  - intros t s hs equal.
    apply (least (- (t + s)) s hs).
    rewrite Ropp_involutive, equal.
    f_equal; f_equal; ring.
Qed.

Theorem circles_axis1 : 0 <= (I2 - I3) * (I1 - I2) -> 0 < (I1 - I2) * (G - I2 * E) ->
  ~ (Z (L 0) = 0 /\ Y (L 0) = 0) -> closed_orbit L (period I3 I2 I1 E G) half_turn1.
Proof.
  intros middle circled moving.
  apply closed_orbit_swapped.
  assert (orbit := circles_axis3 I3 I2 I1 p3 p2 p1 (fun t => swap13 (L (- t))) swapped_motion).
  assert (energy_same : double_energy I3 I2 I1 (swap13 (L (- 0))) = E).
  { rewrite Ropp_0.
    unfold E, double_energy, swap13; cbn [X Y Z]; ring. }
  assert (size_same : norm_squared (swap13 (L (- 0))) = G) by (rewrite Ropp_0; unfold G, swap13; vector_ring).
  cbv beta in orbit.
  rewrite energy_same, size_same, Ropp_0 in orbit.
  now apply orbit.
Qed.

(* Every motion off the separatrix and off the axes, of a body with three different moments, is a closed orbit. *)
Theorem closed_orbits : I1 < I2 < I3 -> euler_field I1 I2 I3 (L 0) <> zero -> G <> I2 * E ->
  (I2 * E < G /\ closed_orbit L (period I1 I2 I3 E G) half_turn3) \/
  (G < I2 * E /\ closed_orbit L (period I3 I2 I1 E G) half_turn1).
Proof.
  intros (order & order') moving generic.
  assert (off_axis : (Y (L 0) = 0 -> X (L 0) <> 0 /\ Z (L 0) <> 0)).
  { intros y_zero.
    split; intros other; apply moving; rewrite euler_field_components by auto; rewrite y_zero, other;
      apply V_eq; cbn; ring. }
  destruct (Rlt_dec (I2 * E) G) as [short|long]; [left | right].
  - split; [exact short|].
    apply circles_axis3; auto; try tauto.
    + apply Rmult_le_pos; lra.
    + apply Rmult_lt_0_compat; unfold E, G in *; lra.
  - assert (below : G < I2 * E) by lra.
    split; [exact below|].
    apply circles_axis1; try tauto.
    + replace ((I2 - I3) * (I1 - I2)) with ((I3 - I2) * (I2 - I1)) by ring.
      apply Rmult_le_pos; lra.
    + replace ((I1 - I2) * (G - I2 * E)) with ((I2 - I1) * (I2 * E - G)) by ring.
      apply Rmult_lt_0_compat; lra.
Qed.

Lemma at_rest : euler_field I1 I2 I3 (L 0) = zero -> forall t, L t = L 0.
Proof.
  intros rest t.
  symmetry.
  apply (motion_determined I1 I2 I3 p1 p2 p3 (fun _ => L 0) L 0); auto.
  intros x.
  rewrite rest.
  refine (conj _ (conj _ _)).
  - exact (is_derive_const (X (L 0)) x).
  - exact (is_derive_const (Y (L 0)) x).
  - exact (is_derive_const (Z (L 0)) x).
Qed.

(* On the separatrix L never comes back: L2 would have an extremum, where the motion would be at rest. *)
Theorem separatrix_open : I1 < I2 < I3 -> euler_field I1 I2 I3 (L 0) <> zero -> G = I2 * E ->
  forall t s, s <> 0 -> L (t + s) <> L t.
Proof.
  intros (order & order') moving critical.
  set (a := rate1 I2 I3).
  set (b := rate3 I1 I2).
  assert (negative : a < 0 /\ b < 0).
  { assert (i12 := Rinv_lt_contravar I1 I2 ltac:(nra) order).
    assert (i23 := Rinv_lt_contravar I2 I3 ltac:(nra) order').
    unfold a, b, rate1, rate3; lra. }
  assert (balance : forall t, a * (Z (L t) * Z (L t)) - b * (X (L t) * X (L t)) = 0).
  { assert (flat : forall t, is_derive (fun t => a * (Z (L t) * Z (L t)) - b * (X (L t) * X (L t))) t 0).
    { intros t.
      destruct (solves_everywhere I1 I2 I3 p1 p2 p3 L solution t) as (x & _ & z).
      cbn [X Z triple] in x, z.
      replace 0 with (a * (2 * Z (L t) * (b * (X (L t) * Y (L t)))) - b * (2 * X (L t) * (a * (Y (L t) * Z (L t)))))
        by ring.
      apply (is_derive_minus (fun t => a * (Z (L t) * Z (L t))) (fun t => b * (X (L t) * X (L t)))).
      - apply (is_derive_scal (fun t => Z (L t) * Z (L t))).
        exact (square_derive (fun t => Z (L t)) t _ z).
      - apply (is_derive_scal (fun t => X (L t) * X (L t))).
        exact (square_derive (fun t => X (L t)) t _ x). }
    intros t.
    rewrite (constant_everywhere _ flat t 0).
    replace (a * (Z (L 0) * Z (L 0)) - b * (X (L 0) * X (L 0))) with (E - G / I2)
      by (unfold a, b, rate1, rate3, E, G, double_energy, norm_squared, dot; field; lra).
    rewrite critical; field; lra. }
  assert (never_still : forall t, Z (L t) * X (L t) <> 0).
  { intros t product.
    assert (level := balance t).
    assert (x2 := Rle_0_sqr (X (L t))).
    assert (z2 := Rle_0_sqr (Z (L t))).
    unfold Rsqr in x2, z2.
    assert (both : X (L t) = 0 /\ Z (L t) = 0).
    { destruct (Rmult_integral _ _ product) as [z_zero|x_zero].
      - rewrite z_zero in level.
        split; auto.
        assert (square : b * (X (L t) * X (L t)) = 0) by lra.
        destruct (Rmult_integral _ _ square) as [b_zero|x_square]; [lra|].
        destruct (Rmult_integral _ _ x_square); auto.
      - rewrite x_zero in level.
        split; auto.
        assert (square : a * (Z (L t) * Z (L t)) = 0) by lra.
        destruct (Rmult_integral _ _ square) as [a_zero|z_square]; [lra|].
        destruct (Rmult_integral _ _ z_square); auto. }
    destruct both as (x_zero & z_zero).
    assert (still : euler_field I1 I2 I3 (L t) = zero).
    { rewrite euler_field_components, x_zero, z_zero by auto.
      apply V_eq; cbn; ring. }
    assert (constant : L 0 = L t).
    { symmetry.
      apply (motion_determined I1 I2 I3 p1 p2 p3 (fun _ => L t) L t) with (t := 0); auto.
      intros x.
      rewrite still.
      refine (conj _ (conj _ _)).
      - exact (is_derive_const (X (L t)) x).
      - exact (is_derive_const (Y (L t)) x).
      - exact (is_derive_const (Z (L t)) x). }
    apply moving.
    now rewrite constant. }
  intros t s later equal.
  destruct (MVT_gen (fun x => Y (L x)) t (t + s) (fun x => rate2 I1 I3 * (Z (L x) * X (L x)))) as (x & _ & mean).
  - intros x _.
    apply (solves_everywhere I1 I2 I3 p1 p2 p3 L solution x).
  - intros x _.
    apply derivable_continuous_pt.
    exists (rate2 I1 I3 * (Z (L x) * X (L x))).
    apply is_derive_Reals, (solves_everywhere I1 I2 I3 p1 p2 p3 L solution x).
  - rewrite equal in mean.
    assert (product : rate2 I1 I3 * (Z (L x) * X (L x)) * s = 0) by lra.
    destruct (Rmult_integral _ _ product) as [slope|s_zero]; [|contradiction].
    destruct (Rmult_integral _ _ slope) as [rate_zero|still]; [|exact (never_still x still)].
    assert (balanced := rates_balanced I1 I2 I3).
    unfold a, b in negative; lra.
Qed.

(* All motions of a body with three different moments: at rest, closed orbits about axis 3 or axis 1, separatrix. *)
Theorem motions_classified : I1 < I2 < I3 ->
  (forall t, L t = L 0) \/
  (I2 * E < G /\ closed_orbit L (period I1 I2 I3 E G) half_turn3) \/
  (G < I2 * E /\ closed_orbit L (period I3 I2 I1 E G) half_turn1) \/
  (G = I2 * E /\ forall t s, s <> 0 -> L (t + s) <> L t).
Proof.
  intros order.
  destruct (V_dec (euler_field I1 I2 I3 (L 0)) zero) as [rest|moving]; [left; now apply at_rest | right].
  destruct (Req_dec G (I2 * E)) as [critical|generic].
  - right; right.
    exact (conj critical (separatrix_open order moving critical)).
  - destruct (closed_orbits order moving generic) as [short|long]; auto.
Qed.
End Orbits.
