(** * Two bodies whose moments of inertia every table lists: a solid box and a solid ball

    They show that the integrals of Densities.v are the usual ones: the box uses its own coordinates, the ball
    spherical coordinates with the Jacobian r^2 sin(theta) as part of the weight.

    Source: Goldstein, Classical Mechanics, section 5.3, exercises. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Vec3 Inertia IteratedIntegral Densities.
Local Open Scope R_scope.

(* Coquelicot types integrals by a module that is R only up to unfolding; ring and field want R itself. *)
Ltac over_reals := match goal with |- @eq _ ?x ?y => change (@eq R x y) end.

Lemma by_antiderivative (F f : R -> R) a b : (forall x, is_derive F x (f x)) -> (forall x, continuous f x) ->
  RInt f a b = F b - F a.
Proof.
  intros derivative regular.
  apply is_RInt_unique.
  exact (is_RInt_derive F f a b (fun x _ => derivative x) (fun x _ => regular x)).
Qed.

Lemma integral_even_quadratic k l a : RInt (fun t => k + l * (t * t)) (- a) a = 2 * a * k + 2 / 3 * (a * a * a) * l.
Proof.
  rewrite (by_antiderivative (fun t => k * t + l * (t * t * t) / 3)).
  - over_reals; field.
  - intros t.
    auto_derive; auto; over_reals; field.
  - intros t.
    apply (ex_derive_continuous (fun t => k + l * (t * t))).
    auto_derive; auto.
Qed.

Definition cartesian (s : point) := mk (fst (fst s)) (snd (fst s)) (snd s).

Lemma x_coordinate : everywhere_continuous (fun s => fst (fst s)).
Proof.
  intros s.
  apply (continuous_comp (fun s : R_UniformSpace * R_UniformSpace * R_UniformSpace => fst s) fst).
  - apply continuous_fst.
  - apply continuous_fst.
Qed.

Lemma y_coordinate : everywhere_continuous (fun s => snd (fst s)).
Proof.
  intros s.
  apply (continuous_comp (fun s : R_UniformSpace * R_UniformSpace * R_UniformSpace => fst s) snd).
  - apply continuous_fst.
  - apply continuous_snd.
Qed.

Lemma z_coordinate : everywhere_continuous (fun s => snd s).
Proof. intros s. apply continuous_snd. Qed.

Definition box_inertia a b c rho :=
  density_inertia (- a) a (- b) b (- c) c (fun _ => rho) cartesian.

(* A box with half sides a, b, c and mass 8 a b c rho. *)
Theorem box_moment a b c rho : box_inertia a b c rho 0 0 = 8 * a * b * c * rho * (b * b + c * c) / 3.
Proof.
  unfold box_inertia, density_inertia, over_body, integral.
  transitivity (RInt (fun x => (8 * b * c * rho * (b * b + c * c) / 6) + 0 * (x * x)) (- a) a);
    [|rewrite integral_even_quadratic; over_reals; field].
  apply RInt_ext; intros x _.
  transitivity (RInt (fun y => (2 / 3 * (c * c * c) * rho) + (2 * c * rho) * (y * y)) (- b) b);
    [|rewrite integral_even_quadratic; over_reals; field].
  apply RInt_ext; intros y _.
  transitivity (RInt (fun z => rho * (y * y) + rho * (z * z)) (- c) c);
    [|rewrite integral_even_quadratic; over_reals; field].
  apply RInt_ext; intros z _.
  unfold norm_squared, dot, delta, coordinate, cartesian; cbn [fst snd X Y Z Nat.eqb].
  over_reals; ring.
Qed.

(* Spherical coordinates ((r, theta), phi). *)
Definition spherical (s : point) := let r := fst (fst s) in let theta := snd (fst s) in let phi := snd s in
  mk (r * sin theta * cos phi) (r * sin theta * sin phi) (r * cos theta).
Definition ball_weight rho (s : point) := rho * (fst (fst s) * fst (fst s)) * sin (snd (fst s)).
Definition ball_inertia size rho := density_inertia 0 size 0 PI 0 (2 * PI) (ball_weight rho) spherical.

Lemma continuous_sin_of f : everywhere_continuous f -> everywhere_continuous (fun s => sin (f s)).
Proof.
  intros hf s.
  apply (continuous_comp f sin); [apply hf|].
  apply (ex_derive_continuous sin).
  auto_derive; auto.
Qed.

Lemma continuous_cos_of f : everywhere_continuous f -> everywhere_continuous (fun s => cos (f s)).
Proof.
  intros hf s.
  apply (continuous_comp f cos); [apply hf|].
  apply (ex_derive_continuous cos).
  auto_derive; auto.
Qed.

(* The ball meets every hypothesis of Densities.v, so it has principal axes and so on. *)
Theorem ball_is_mass size rho : 0 <= size -> 0 <= rho -> exists m : mass, forall f, quadratic_form f ->
  M m f = over_body 0 size 0 PI 0 (2 * PI) (ball_weight rho) spherical f.
Proof.
  intros h_size h_rho.
  assert (pi := PI_RGT_0).
  assert (r_continuous := x_coordinate).
  assert (theta_continuous := y_coordinate).
  assert (phi_continuous := z_coordinate).
  assert (r_sin := continuous_product _ _ r_continuous (continuous_sin_of _ theta_continuous)).
  apply density_is_mass; try lra.
  - exact (continuous_product _ _ (continuous_product _ _ (continuous_constant rho)
      (continuous_product _ _ r_continuous r_continuous)) (continuous_sin_of _ theta_continuous)).
  - exact (continuous_product _ _ r_sin (continuous_cos_of _ phi_continuous)).
  - exact (continuous_product _ _ r_sin (continuous_sin_of _ phi_continuous)).
  - exact (continuous_product _ _ r_continuous (continuous_cos_of _ theta_continuous)).
  - intros r theta phi _ h_theta _.
    unfold ball_weight; cbn [fst snd].
    apply Rmult_le_pos; [apply Rmult_le_pos; [exact h_rho | apply Rle_0_sqr] | apply sin_ge_0; lra].
Qed.

(* A ball of radius size and mass 4/3 pi rho size^3: two fifths of the mass times the square of the radius. *)
Theorem ball_moment size rho :
  ball_inertia size rho 2 2 = 2 / 5 * (4 / 3 * PI * rho * (size * size * size)) * (size * size).
Proof.
  unfold ball_inertia, density_inertia, over_body, integral.
  transitivity (RInt (fun r => 8 / 3 * PI * rho * (r * r * r * r)) 0 size).
  - apply RInt_ext; intros r _.
    transitivity (RInt (fun theta => 2 * PI * rho * (r * r * r * r) * (sin theta * (1 - cos theta * cos theta))) 0 PI).
    + apply RInt_ext; intros theta _.
      transitivity (RInt (fun _ => rho * (r * r * r * r) * (sin theta * (1 - cos theta * cos theta))) 0 (2 * PI)).
      * apply RInt_ext; intros phi _.
        unfold norm_squared, dot, delta, coordinate, spherical, ball_weight; cbn [fst snd X Y Z Nat.eqb].
        assert (circle := sin2_cos2 phi).
        assert (circle' := sin2_cos2 theta).
        unfold Rsqr in circle, circle'.
        over_reals.
        transitivity (rho * (r * r * r * r) * sin theta * (sin theta * sin theta) *
          (sin phi * sin phi + cos phi * cos phi)); [ring|].
        rewrite circle.
        replace (sin theta * sin theta) with (1 - cos theta * cos theta) by lra.
        ring.
      * rewrite RInt_const.
        over_reals.
        unfold Hierarchy.scal; cbn; unfold mult; cbn.
        ring.
    + rewrite (by_antiderivative (fun t => 2 * PI * rho * (r * r * r * r) * (cos t * cos t * cos t / 3 - cos t))).
      * rewrite cos_PI, cos_0; over_reals; field.
      * intros t.
        auto_derive; auto; over_reals; field.
      * intros t.
        apply (ex_derive_continuous (fun t => 2 * PI * rho * (r * r * r * r) * (sin t * (1 - cos t * cos t)))).
        auto_derive; auto.
  - rewrite (by_antiderivative (fun r => 8 / 15 * PI * rho * (r * r * r * r * r))).
    + over_reals; field.
    + intros t.
      auto_derive; auto; over_reals; field.
    + intros t.
      apply (ex_derive_continuous (fun r => 8 / 3 * PI * rho * (r * r * r * r))).
      auto_derive; auto.
Qed.
