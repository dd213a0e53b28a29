(** * Integrals over a box, as iterated Riemann integrals of continuous functions: linear and positive

    The one fact that Coquelicot lacks is that an integral over an interval depends continuously on a parameter
    from any uniform space.  It follows from compactness of the interval: continuity at the points (u, z) for all z is
    uniform in z.  Applied twice, with parameters (x, y) and then x, it makes every inner integral integrable.

    Source: Rudin, Principles of Mathematical Analysis, chapters 4 (compactness) and 9 (integrals with a parameter). *)
From Coq Require Import Reals Lra Psatz ClassicalEpsilon.
From Coquelicot Require Import Coquelicot.
Local Open Scope R_scope.

Lemma continuous_eps (U : UniformSpace) (g : U -> R) x : continuous g x ->
  forall eps, 0 < eps -> exists d : posreal, forall y, ball x d y -> Rabs (g y - g x) < eps.
Proof.
  intros regular eps positive.
  destruct (proj1 (filterlim_locally g (g x)) regular (mkposreal eps positive)) as (d & near).
  exists d.
  intros y inside.
  exact (near y inside).
Qed.

(* For all z in [a, b] at once, g(u, z) changes little when u does. *)
Lemma uniformly_continuous (U : UniformSpace) (g : U * R -> R) a b u : (forall x, continuous g x) ->
  forall eps, 0 < eps -> exists d : posreal, forall v, ball u d v ->
  forall z, a <= z <= b -> Rabs (g (v, z) - g (u, z)) < eps.
Proof.
  intros regular eps positive.
  assert (half : 0 < eps / 2) by lra.
  set (radius := fun z => constructive_indefinite_description _ (continuous_eps _ g (u, z) (regular (u, z)) _ half)).
  destruct (compactness_value_1d a b (fun z => proj1_sig (radius z))) as (d & cover).
  exists d.
  intros v inside z hz.
  destruct (Rlt_dec (Rabs (g (v, z) - g (u, z))) eps) as [small|large]; [exact small|].
  exfalso.
  apply (cover z hz).
  intros (t & _ & close & order).
  apply large.
  assert (near := proj2_sig (radius t)).
  cbn beta in near.
  assert (first : Rabs (g (v, z) - g (u, t)) < eps / 2).
  { apply near.
    split; cbn [fst snd]; [|exact close].
    exact (ball_le u d _ order v inside). }
  assert (second : Rabs (g (u, z) - g (u, t)) < eps / 2).
  { apply near.
    split; cbn [fst snd]; [|exact close].
    apply ball_center. }
  apply Rabs_lt_between in first, second.
  apply Rabs_def1; lra.
Qed.

Lemma slice_continuous (U : UniformSpace) (g : U * R -> R) u z : continuous g (u, z) ->
  continuous (fun t => g (u, t)) z.
Proof.
  intros regular.
  apply filterlim_locally.
  intros eps.
  destruct (continuous_eps _ g (u, z) regular eps (cond_pos eps)) as (d & near).
  exists d.
  intros t inside.
  apply near.
  split; [apply ball_center | exact inside].
Qed.

Lemma slice_integrable (U : UniformSpace) (g : U * R -> R) a b u : (forall x, continuous g x) ->
  ex_RInt (fun z => g (u, z)) a b.
Proof.
  intros regular.
  apply (@ex_RInt_continuous R_CompleteNormedModule).
  intros z _.
  now apply slice_continuous.
Qed.

Theorem integral_continuous (U : UniformSpace) (g : U * R -> R) a b : a <= b -> (forall x, continuous g x) ->
  forall u, continuous (fun v => RInt (fun z => g (v, z)) a b) u.
Proof.
  intros order regular u.
  apply filterlim_locally.
  intros eps.
  assert (small : 0 < eps / (b - a + 1)) by (apply Rdiv_lt_0_compat; [apply cond_pos | lra]).
  destruct (uniformly_continuous U g a b u regular _ small) as (d & near).
  exists d.
  intros v inside.
  assert (integrable := fun w => slice_integrable U g a b w regular).
  assert (difference := RInt_minus (fun z => g (v, z)) (fun z => g (u, z)) a b (integrable v) (integrable u)).
  assert (difference_integrable := ex_RInt_minus (fun z => g (v, z)) (fun z => g (u, z)) a b (integrable v)
    (integrable u)).
  change (Rabs (minus (RInt (fun z => g (v, z)) a b) (RInt (fun z => g (u, z)) a b)) < eps).
  rewrite <- difference.
  apply Rle_lt_trans with ((b - a) * (eps / (b - a + 1))).
  - apply abs_RInt_le_const; auto.
    intros z hz.
    apply Rlt_le.
    exact (near v inside z hz).
  - assert (positive := cond_pos eps).
    replace (pos eps) with ((b - a + 1) * (eps / (b - a + 1))) at 2 by (field; lra).
    lra.
Qed.

Section Box.
Variables a1 b1 a2 b2 a3 b3 : R.
Hypotheses (h1 : a1 <= b1) (h2 : a2 <= b2) (h3 : a3 <= b3).

(* Points of the box are ((x, y), z). *)
Definition point := (R * R * R)%type.
Definition everywhere_continuous (g : point -> R) := forall x : prod_UniformSpace (prod_UniformSpace R_UniformSpace
  R_UniformSpace) R_UniformSpace, continuous g x.
Definition inner (g : point -> R) (xy : R * R) : R := RInt (fun z => g (xy, z)) a3 b3.
Definition middle (g : point -> R) (x : R) : R := RInt (fun y => inner g (x, y)) a2 b2.
Definition integral (g : point -> R) : R := RInt (middle g) a1 b1.

Lemma inner_continuous g : everywhere_continuous g ->
  forall x : prod_UniformSpace R_UniformSpace R_UniformSpace, continuous (inner g) x.
Proof.
  intros regular.
  exact (integral_continuous (prod_UniformSpace R_UniformSpace R_UniformSpace) g a3 b3 h3 regular).
Qed.

Lemma middle_continuous g : everywhere_continuous g -> forall x : R_UniformSpace, continuous (middle g) x.
Proof.
  intros regular.
  exact (integral_continuous R_UniformSpace (inner g) a2 b2 h2 (inner_continuous g regular)).
Qed.

Lemma inner_integrable g xy : everywhere_continuous g -> ex_RInt (fun z => g (xy, z)) a3 b3.
Proof. exact (slice_integrable (prod_UniformSpace R_UniformSpace R_UniformSpace) g a3 b3 xy). Qed.

Lemma middle_integrable g x : everywhere_continuous g -> ex_RInt (fun y => inner g (x, y)) a2 b2.
Proof.
  intros regular.
  exact (slice_integrable R_UniformSpace (inner g) a2 b2 x (inner_continuous g regular)).
Qed.

Lemma outer_integrable g : everywhere_continuous g -> ex_RInt (middle g) a1 b1.
Proof.
  intros regular.
  apply (@ex_RInt_continuous R_CompleteNormedModule).
  intros x _.
  now apply middle_continuous.
Qed.

Theorem integral_ext f g : (forall s, f s = g s) -> integral f = integral g.
Proof.
  intros equal.
  apply RInt_ext; intros x _.
  apply RInt_ext; intros y _.
  apply RInt_ext; intros z _.
  apply equal.
Qed.

Theorem integral_add f g : everywhere_continuous f -> everywhere_continuous g ->
  integral (fun s => f s + g s) = integral f + integral g.
Proof.
  intros hf hg.
  assert (first : forall xy, inner (fun s => f s + g s) xy = inner f xy + inner g xy).
  { intros xy.
    exact (RInt_plus (fun z => f (xy, z)) (fun z => g (xy, z)) a3 b3 (inner_integrable f xy hf)
      (inner_integrable g xy hg)). }
  assert (second : forall x, middle (fun s => f s + g s) x = middle f x + middle g x).
  { intros x.
    transitivity (RInt (fun y => inner f (x, y) + inner g (x, y)) a2 b2).
    - apply RInt_ext; intros y _.
      apply first.
    - exact (RInt_plus (fun y => inner f (x, y)) (fun y => inner g (x, y)) a2 b2 (middle_integrable f x hf)
        (middle_integrable g x hg)). }
  transitivity (RInt (fun x => middle f x + middle g x) a1 b1).
  - apply RInt_ext; intros x _.
    apply second.
  - exact (RInt_plus (middle f) (middle g) a1 b1 (outer_integrable f hf) (outer_integrable g hg)).
Qed.

Theorem integral_scal k f : everywhere_continuous f -> integral (fun s => k * f s) = k * integral f.
Proof.
  intros hf.
  assert (first : forall xy, inner (fun s => k * f s) xy = k * inner f xy).
  { intros xy.
    exact (RInt_scal (fun z => f (xy, z)) a3 b3 k (inner_integrable f xy hf)). }
  assert (second : forall x, middle (fun s => k * f s) x = k * middle f x).
  { intros x.
    transitivity (RInt (fun y => k * inner f (x, y)) a2 b2).
    - apply RInt_ext; intros y _.
      apply first.
    - exact (RInt_scal (fun y => inner f (x, y)) a2 b2 k (middle_integrable f x hf)). }
  transitivity (RInt (fun x => k * middle f x) a1 b1).
  - apply RInt_ext; intros x _.
    apply second.
  - exact (RInt_scal (middle f) a1 b1 k (outer_integrable f hf)).
Qed.

Theorem integral_pos f : everywhere_continuous f ->
  (forall x y z, a1 <= x <= b1 -> a2 <= y <= b2 -> a3 <= z <= b3 -> 0 <= f (x, y, z)) -> 0 <= integral f.
Proof.
  intros hf positive.
  apply (RInt_ge_0 (middle f) a1 b1 h1 (outer_integrable f hf)).
  intros x hx.
  apply (RInt_ge_0 (fun y => inner f (x, y)) a2 b2 h2 (middle_integrable f x hf)).
  intros y hy.
  apply (RInt_ge_0 (fun z => f (x, y, z)) a3 b3 h3 (inner_integrable f (x, y) hf)).
  intros z hz.
  apply positive; lra.
Qed.

(* A function that is not negative has a positive integral as soon as it is positive at one inner point. *)
Lemma interval_strict (f : R -> R) a b c : (forall x, continuous f x) -> (forall x, a <= x <= b -> 0 <= f x) ->
  a < c < b -> 0 < f c -> 0 < RInt f a b.
Proof.
  intros regular positive inside value.
  assert (half : 0 < f c / 2) by lra.
  destruct (continuous_eps _ f c (regular c) _ half) as (d & near).
  set (e := Rmin (d / 2) (Rmin (c - a) (b - c))).
  assert (e1 : e <= d / 2) by apply Rmin_l.
  assert (e2 : e <= c - a) by (eapply Rle_trans; [apply Rmin_r | apply Rmin_l]).
  assert (e3 : e <= b - c) by (eapply Rle_trans; [apply Rmin_r | apply Rmin_r]).
  assert (d_positive := cond_pos d).
  assert (e_positive : 0 < e) by (unfold e; repeat apply Rmin_glb_lt; lra).
  clearbody e.
  assert (integrable : forall x y, ex_RInt f x y).
  { intros x y.
    apply (@ex_RInt_continuous R_CompleteNormedModule); auto. }
  rewrite <- (RInt_Chasles f a (c - e) b) by auto.
  rewrite <- (RInt_Chasles f (c - e) (c + e) b) by auto.
  assert (left : 0 <= RInt f a (c - e)).
  { apply RInt_ge_0; auto; [lra|].
    intros x hx; apply positive; lra. }
  assert (right : 0 <= RInt f (c + e) b).
  { apply RInt_ge_0; auto; [lra|].
    intros x hx; apply positive; lra. }
  assert (centre : 0 < RInt f (c - e) (c + e)).
  { apply RInt_gt_0; auto; [lra|].
    intros x hx.
    assert (close : ball c d x) by (apply Rabs_def1; cbn; unfold minus, plus, opp; cbn; lra).
    assert (bound := near x close).
    apply Rabs_lt_between in bound.
    lra. }
  change (0 < RInt f a (c - e) + (RInt f (c - e) (c + e) + RInt f (c + e) b)).
  lra.
Qed.

Theorem integral_strict f x0 y0 z0 : everywhere_continuous f ->
  (forall x y z, a1 <= x <= b1 -> a2 <= y <= b2 -> a3 <= z <= b3 -> 0 <= f (x, y, z)) ->
  a1 < x0 < b1 -> a2 < y0 < b2 -> a3 < z0 < b3 -> 0 < f (x0, y0, z0) -> 0 < integral f.
Proof.
  intros hf positive hx hy hz value.
  apply (interval_strict (middle f) a1 b1 x0 (middle_continuous f hf)); auto.
  - intros x hx'.
    apply (RInt_ge_0 (fun y => inner f (x, y)) a2 b2 h2 (middle_integrable f x hf)).
    intros y hy'.
    apply (RInt_ge_0 (fun z => f (x, y, z)) a3 b3 h3 (inner_integrable f (x, y) hf)).
    intros z hz'.
    apply positive; lra.
  - apply (interval_strict (fun y => inner f (x0, y)) a2 b2 y0); auto.
    + intros y.
      exact (slice_continuous R_UniformSpace (inner f) x0 y (inner_continuous f hf (x0, y))).
    + intros y hy'.
      apply (RInt_ge_0 (fun z => f (x0, y, z)) a3 b3 h3 (inner_integrable f (x0, y) hf)).
      intros z hz'.
      apply positive; lra.
    + apply (interval_strict (fun z => f (x0, y0, z)) a3 b3 z0); auto.
      * intros z.
        exact (slice_continuous (prod_UniformSpace R_UniformSpace R_UniformSpace) f (x0, y0) z (hf (x0, y0, z))).
      * intros z hz'.
        apply positive; lra.
Qed.

Theorem integral_zero f :
  (forall x y z, a1 < x < b1 -> a2 < y < b2 -> a3 < z < b3 -> f (x, y, z) = 0) -> integral f = 0.
Proof.
  intros vanishes.
  assert (zero : forall (g : R -> R) a b, a <= b -> (forall x, a < x < b -> g x = 0) -> RInt g a b = 0).
  { intros g a b order flat.
    rewrite (RInt_ext g (fun _ => 0)).
    - rewrite RInt_const.
      apply Rmult_0_r.
    - intros x hx.
      rewrite Rmin_left, Rmax_right in hx by exact order.
      now apply flat. }
  apply (zero _ _ _ h1); intros x hx.
  apply (zero _ _ _ h2); intros y hy.
  apply (zero _ _ _ h3); intros z hz.
  now apply vanishes.
Qed.
End Box.
