(** * Bodies with a density: the theory of Inertia.v applies to them

    A body is the image of a box under a continuous map, place, with a continuous weight that is not negative on the
    box: density times the Jacobian of place.  Boxes have the identity as place, balls spherical coordinates, shells
    and wires maps of smaller rank.  The Riemann integral is linear and positive on continuous functions only, while
    a mass of Inertia.v accepts every function; so the instance is made for quadratic forms, which is all that inertia
    needs.  The matrix S of second moments is symmetric with u . S u >= 0, and its principal axes with its principal
    values as weights are three points with the same second moments.

    Source: Goldstein, Classical Mechanics, section 5.3 (inertia as an integral); equimomental systems: Routh. *)
From Coq Require Import Reals Lra Psatz List.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Vec3 Inertia PrincipalAxes IteratedIntegral.
Import ListNotations.
Local Open Scope R_scope.

Definition quadratic_form (f : V -> R) := exists a b c d e g, forall r, f r =
  a * (X r * X r) + b * (Y r * Y r) + c * (Z r * Z r) + d * (X r * Y r) + e * (X r * Z r) + g * (Y r * Z r).

Lemma continuous_product f g : everywhere_continuous f -> everywhere_continuous g ->
  everywhere_continuous (fun s => f s * g s).
Proof. intros hf hg x. exact (continuous_mult f g x (hf x) (hg x)). Qed.

Lemma continuous_sum f g : everywhere_continuous f -> everywhere_continuous g ->
  everywhere_continuous (fun s => f s + g s).
Proof. intros hf hg x. exact (continuous_plus f g x (hf x) (hg x)). Qed.

Lemma continuous_constant k : everywhere_continuous (fun _ => k).
Proof. intros x. exact (continuous_const k x). Qed.

(* Three weighted points along orthonormal axes of S have S as their matrix of second moments. *)
Lemma equimomental a b c d e f : (forall u, 0 <= dot u (A a b c d e f u)) -> exists l, nonneg l /\
  sum_over l (fun r => X r * X r) = a /\ sum_over l (fun r => Y r * Y r) = b /\ sum_over l (fun r => Z r * Z r) = c /\
  sum_over l (fun r => X r * Y r) = d /\ sum_over l (fun r => X r * Z r) = e /\ sum_over l (fun r => Y r * Z r) = f.
Proof.
  intros positive.
  destruct (spectral a b c d e f) as (u & v & w & l1 & l2 & l3 & axes & _ & eigen1 & eigen2 & eigen3).
  unfold eigen in *.
  assert (value : forall x l, norm_squared x = 1 -> A a b c d e f x = scale l x -> 0 <= l).
  { intros x l unit equation.
    assert (sign := positive x).
    rewrite equation in sign.
    replace (dot x (scale l x)) with (l * norm_squared x) in sign by vector_ring.
    rewrite unit in sign; lra. }
  exists [(l1, u); (l2, v); (l3, w)].
  split.
  - destruct axes.
    repeat apply Forall_cons; cbn [fst]; [apply (value u) | apply (value v) | apply (value w) | apply Forall_nil]; auto.
  - assert (image : forall r, A a b c d e f r =
      add (add (scale (l1 * dot r u) u) (scale (l2 * dot r v) v)) (scale (l3 * dot r w) w)).
    { intros r.
      rewrite (orthonormal_expand u v w r axes) at 1.
      rewrite !A_add, !A_scal, eigen1, eigen2, eigen3.
      vector_ring. }
    assert (first := image e1).
    assert (second := image e2).
    assert (third := image e3).
    assert (xx := f_equal X first).
    assert (xy := f_equal Y first).
    assert (xz := f_equal Z first).
    assert (yy := f_equal Y second).
    assert (yz := f_equal Z second).
    assert (zz := f_equal Z third).
    unfold A, add, scale, dot, e1, e2, e3 in xx, xy, xz, yy, yz, zz.
    cbn [X Y Z] in xx, xy, xz, yy, yz, zz.
    unfold sum_over; cbn [fold_right fst snd].
    refine (conj _ (conj _ (conj _ (conj _ (conj _ _))))); [clear - xx | clear - yy | clear - zz | clear - xy |
      clear - xz | clear - yz]; lra.
Qed.

Section Body.
Variables a1 b1 a2 b2 a3 b3 : R.
Hypotheses (h1 : a1 <= b1) (h2 : a2 <= b2) (h3 : a3 <= b3).
Variable weight : point -> R.
Variable place : point -> V.
Hypothesis weight_continuous : everywhere_continuous weight.
Hypothesis x_continuous : everywhere_continuous (fun s => X (place s)).
Hypothesis y_continuous : everywhere_continuous (fun s => Y (place s)).
Hypothesis z_continuous : everywhere_continuous (fun s => Z (place s)).
Hypothesis weight_positive : forall x y z, a1 <= x <= b1 -> a2 <= y <= b2 -> a3 <= z <= b3 -> 0 <= weight (x, y, z).

Definition over_body (f : V -> R) := integral a1 b1 a2 b2 a3 b3 (fun s => weight s * f (place s)).
Definition regular (f : V -> R) := everywhere_continuous (fun s => f (place s)).

Lemma weighted f : regular f -> everywhere_continuous (fun s => weight s * f (place s)).
Proof. exact (continuous_product weight (fun s => f (place s)) weight_continuous). Qed.

Lemma over_body_ext f g : (forall r, f r = g r) -> over_body f = over_body g.
Proof.
  intros equal.
  unfold over_body.
  apply integral_ext.
  intros s.
  now rewrite equal.
Qed.

Lemma over_body_add f g : regular f -> regular g -> over_body (fun r => f r + g r) = over_body f + over_body g.
Proof.
  intros hf hg.
  unfold over_body.
  rewrite <- (integral_add a1 b1 a2 b2 a3 b3 h2 h3 _ _ (weighted f hf) (weighted g hg)).
  apply integral_ext.
  intros s; ring.
Qed.

Lemma over_body_scal k f : regular f -> over_body (fun r => k * f r) = k * over_body f.
Proof.
  intros hf.
  unfold over_body.
  rewrite <- (integral_scal a1 b1 a2 b2 a3 b3 h2 h3 k _ (weighted f hf)).
  apply integral_ext.
  intros s; ring.
Qed.

Lemma over_body_pos f : regular f -> (forall r, 0 <= f r) -> 0 <= over_body f.
Proof.
  intros hf positive.
  unfold over_body.
  apply (integral_pos a1 b1 a2 b2 a3 b3 h1 h2 h3 _ (weighted f hf)).
  intros x y z hx hy hz.
  apply Rmult_le_pos; auto.
Qed.

Lemma regular_add f g : regular f -> regular g -> regular (fun r => f r + g r).
Proof. apply continuous_sum. Qed.

Lemma regular_scal k f : regular f -> regular (fun r => k * f r).
Proof. intros hf. apply continuous_product; [apply continuous_constant | exact hf]. Qed.

Let xx r := X r * X r.
Let yy r := Y r * Y r.
Let zz r := Z r * Z r.
Let xy r := X r * Y r.
Let xz r := X r * Z r.
Let yz r := Y r * Z r.

Lemma add_term k f rest total : regular f -> regular rest /\ over_body rest = total ->
  regular (fun r => rest r + k * f r) /\ over_body (fun r => rest r + k * f r) = total + k * over_body f.
Proof.
  intros hf (hrest & <-).
  assert (hterm := regular_scal k f hf).
  split; [exact (regular_add rest _ hrest hterm)|].
  rewrite (over_body_add rest _ hrest hterm).
  now rewrite (over_body_scal k f hf).
Qed.

Lemma over_body_quadratic a b c d e g :
  regular (fun r => a * xx r + b * yy r + c * zz r + d * xy r + e * xz r + g * yz r) /\
  over_body (fun r => a * xx r + b * yy r + c * zz r + d * xy r + e * xz r + g * yz r) =
  a * over_body xx + b * over_body yy + c * over_body zz + d * over_body xy + e * over_body xz + g * over_body yz.
Proof.
  assert (product : forall f h, regular f -> regular h -> regular (fun r => f r * h r)).
  { intros f h.
    exact (continuous_product (fun s => f (place s)) (fun s => h (place s))). }
  assert (rxx := product _ _ x_continuous x_continuous).
  refine (add_term g yz _ _ (product _ _ y_continuous z_continuous) _).
  refine (add_term e xz _ _ (product _ _ x_continuous z_continuous) _).
  refine (add_term d xy _ _ (product _ _ x_continuous y_continuous) _).
  refine (add_term c zz _ _ (product _ _ z_continuous z_continuous) _).
  refine (add_term b yy _ _ (product _ _ y_continuous y_continuous) _).
  exact (conj (regular_scal a xx rxx) (over_body_scal a xx rxx)).
Qed.

(* The body has the inertia of a mass in the sense of Inertia.v: so each theorem there holds for it. *)
Theorem density_is_mass : exists m : mass, forall f, quadratic_form f -> M m f = over_body f.
Proof.
  destruct (equimomental (over_body xx) (over_body yy) (over_body zz) (over_body xy) (over_body xz) (over_body yz))
    as (l & positive & mxx & myy & mzz & mxy & mxz & myz).
  - intros u.
    replace (dot u (A (over_body xx) (over_body yy) (over_body zz) (over_body xy) (over_body xz) (over_body yz) u))
      with (X u * X u * over_body xx + Y u * Y u * over_body yy + Z u * Z u * over_body zz +
        2 * (X u * Y u) * over_body xy + 2 * (X u * Z u) * over_body xz + 2 * (Y u * Z u) * over_body yz)
      by (unfold A, dot; cbn [X Y Z]; ring).
    destruct (over_body_quadratic (X u * X u) (Y u * Y u) (Z u * Z u) (2 * (X u * Y u)) (2 * (X u * Z u))
      (2 * (Y u * Z u))) as (continuity & <-).
    apply over_body_pos; auto.
    intros r.
    replace (X u * X u * xx r + Y u * Y u * yy r + Z u * Z u * zz r + 2 * (X u * Y u) * xy r +
      2 * (X u * Z u) * xz r + 2 * (Y u * Z u) * yz r) with (dot u r * dot u r)
      by (unfold xx, yy, zz, xy, xz, yz, dot; ring).
    apply Rle_0_sqr.
  - exists (points l positive).
    intros f (a & b & c & d & e & g & form).
    set (combination := fun r => a * xx r + b * yy r + c * zz r + d * xy r + e * xz r + g * yz r).
    rewrite (over_body_ext f combination form), (M_ext (points l positive) f combination form).
    rewrite (proj2 (over_body_quadratic a b c d e g) : over_body combination = _).
    unfold combination.
    rewrite !M_add, !M_scale.
    cbn [M points].
    unfold xx, yy, zz, xy, xz, yz in *.
    now rewrite mxx, myy, mzz, mxy, mxz, myz.
Qed.

(* The inertia tensor as an integral, and what Inertia.v and PrincipalAxes.v say about it. *)
Definition density_inertia i j := over_body (fun r => norm_squared r * delta i j - coordinate r i * coordinate r j).
Definition density_apply u := mk
  (density_inertia 0 0 * X u + density_inertia 0 1 * Y u + density_inertia 0 2 * Z u)
  (density_inertia 1 0 * X u + density_inertia 1 1 * Y u + density_inertia 1 2 * Z u)
  (density_inertia 2 0 * X u + density_inertia 2 1 * Y u + density_inertia 2 2 * Z u).

Lemma inertia_integrand i j : quadratic_form (fun r => norm_squared r * delta i j - coordinate r i * coordinate r j).
Proof.
  set (k := delta i j).
  set (basis := fun n l => if Nat.eqb (match n with 0 => 0 | 1 => 1 | _ => 2 end)%nat l then 1 else 0).
  exists (k - basis i 0%nat * basis j 0%nat), (k - basis i 1%nat * basis j 1%nat), (k - basis i 2%nat * basis j 2%nat),
    (- (basis i 0%nat * basis j 1%nat + basis i 1%nat * basis j 0%nat)),
    (- (basis i 0%nat * basis j 2%nat + basis i 2%nat * basis j 0%nat)),
    (- (basis i 1%nat * basis j 2%nat + basis i 2%nat * basis j 1%nat)).
  assert (component : forall n r, coordinate r n = basis n 0%nat * X r + basis n 1%nat * Y r + basis n 2%nat * Z r).
  { intros [|[|n]] r; unfold basis, coordinate; cbn; ring. }
  intros r.
  rewrite !component.
  unfold norm_squared, dot; ring.
Qed.

Lemma cross_integrand u : quadratic_form (fun r => norm_squared (cross r u)).
Proof.
  exists (Y u * Y u + Z u * Z u), (X u * X u + Z u * Z u), (X u * X u + Y u * Y u), (- 2 * (X u * Y u)),
    (- 2 * (X u * Z u)), (- 2 * (Y u * Z u)).
  intros r.
  unfold norm_squared, dot, cross; cbn [X Y Z]; ring.
Qed.

Theorem density_energy u : dot u (density_apply u) = over_body (fun r => norm_squared (cross r u)).
Proof.
  destruct density_is_mass as (m & same).
  rewrite <- (same _ (cross_integrand u)), <- (I_energy m u).
  unfold density_apply, Iv, density_inertia, I.
  now rewrite !(same _ (inertia_integrand _ _)).
Qed.

Theorem density_definite : (forall u, u <> zero -> 0 < dot u (density_apply u)) <->
  ~ exists u, u <> zero /\ over_body (fun r => norm_squared (cross r u)) = 0.
Proof.
  destruct density_is_mass as (m & same).
  assert (apply_same : forall u, density_apply u = Iv m u).
  { intros u.
    unfold density_apply, Iv, density_inertia, I.
    now rewrite !(same _ (inertia_integrand _ _)). }
  assert (line_same : forall u,
    over_body (fun r => norm_squared (cross r u)) = M m (fun r => norm_squared (cross r u))).
  { intros u.
    symmetry.
    apply same, cross_integrand. }
  assert (definite := I_pos_def m).
  unfold on_line in definite.
  split.
  - intros positive (u & nonzero & line).
    apply (proj1 definite).
    + intros v hv.
      rewrite <- apply_same; auto.
    + exists u.
      now rewrite <- line_same.
  - intros none u nonzero.
    rewrite apply_same.
    apply (proj2 definite); auto.
    intros (v & hv & line).
    apply none.
    exists v.
    now rewrite line_same.
Qed.

(* The mass of a body is on the line along u through the fixed point, as far as inner points of the box show. *)
Definition on_one_line u := forall x y z, a1 < x < b1 -> a2 < y < b2 -> a3 < z < b3 -> 0 < weight (x, y, z) ->
  cross (place (x, y, z)) u = zero.

Theorem density_line u : over_body (fun r => norm_squared (cross r u)) = 0 <-> on_one_line u.
Proof.
  assert (continuity : regular (fun r => norm_squared (cross r u))).
  { intros s.
    destruct (cross_integrand u) as (a & b & c & d & e & g & form).
    apply (continuous_ext (fun s => a * xx (place s) + b * yy (place s) + c * zz (place s) + d * xy (place s) +
      e * xz (place s) + g * yz (place s))).
    - intros t.
      symmetry; apply form.
    - exact (proj1 (over_body_quadratic a b c d e g) s). }
  assert (positive : forall x y z, a1 <= x <= b1 -> a2 <= y <= b2 -> a3 <= z <= b3 ->
    0 <= weight (x, y, z) * norm_squared (cross (place (x, y, z)) u)).
  { intros x y z hx hy hz.
    apply Rmult_le_pos; auto using norm_squared_ge0. }
  split.
  - intros zero_integral x y z hx hy hz heavy.
    destruct (V_dec (cross (place (x, y, z)) u) zero) as [on_line|off_line]; [exact on_line | exfalso].
    assert (strict : 0 < over_body (fun r => norm_squared (cross r u))).
    { apply (integral_strict a1 b1 a2 b2 a3 b3 h2 h3 _ x y z (weighted _ continuity) positive hx hy hz).
      apply Rmult_lt_0_compat; auto.
      now apply norm_squared_pos. }
    lra.
  - intros line.
    apply (integral_zero a1 b1 a2 b2 a3 b3 h1 h2 h3).
    intros x y z hx hy hz.
    destruct (weight_positive x y z ltac:(lra) ltac:(lra) ltac:(lra)) as [heavy|empty].
    + rewrite (line x y z hx hy hz heavy).
      unfold norm_squared, dot, zero; cbn [X Y Z]; ring.
    + rewrite <- empty; ring.
Qed.

(* Inertia is definite just when the mass is not on one line through the fixed point. *)
Theorem density_definite_line : (forall u, u <> zero -> 0 < dot u (density_apply u)) <->
  ~ exists u, u <> zero /\ on_one_line u.
Proof.
  rewrite density_definite.
  split; intros none (u & nonzero & line); apply none; exists u; split; auto; now apply density_line.
Qed.

Theorem density_principal_axes : exists u v w l1 l2 l3, orthonormal u v w /\ w = cross u v /\
  density_apply u = scale l1 u /\ density_apply v = scale l2 v /\ density_apply w = scale l3 w /\
  0 <= l1 /\ 0 <= l2 /\ 0 <= l3 /\ l1 <= l2 + l3 /\ l2 <= l3 + l1 /\ l3 <= l1 + l2.
Proof.
  destruct density_is_mass as (m & same).
  assert (apply_same : forall u, density_apply u = Iv m u).
  { intros u.
    unfold density_apply, Iv, density_inertia, I.
    now rewrite !(same _ (inertia_integrand _ _)). }
  destruct (principal_axes m) as (u & v & w & l1 & l2 & l3 & axes).
  exists u, v, w, l1, l2, l3.
  now rewrite !apply_same.
Qed.
End Body.
