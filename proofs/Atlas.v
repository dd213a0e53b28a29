(** * T*SO(3) by an atlas of two charts of Euler angles: the reduction to so(3)* holds at every attitude

    The chart of CotangentBundle.v fails where sin(theta) = 0, that is where body axis 3 is along space axis 3.  The
    second chart is the same one followed by a fixed quarter turn of space about axis 1; it fails where body axis 3 is
    along space axis 2.  No attitude is in both sets.  A fixed turn of space leaves body velocities alone, so the body
    momentum is the same function of angles and momenta in both charts.  The canonical bracket of functions on
    T*SO(3) then has one formula, in left-trivialised form, that names no chart: the charts agree where they overlap.

    Source: Marsden and Ratiu, Introduction to Mechanics and Symmetry, chapters 13 and 15. *)
From Coq Require Import Reals Lra Psatz Nsatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Vec3 Calculus Euler CotangentBundle EllipticClock.
Local Open Scope R_scope.

(* Attitudes: maps of space that keep scalar and vector products. *)
Definition rotation (A : V -> V) := (forall u v, dot (A u) (A v) = dot u v) /\
  (forall u v, A (cross u v) = cross (A u) (A v)).

Lemma axes_orthonormal : orthonormal e1 e2 e3.
Proof. split; vector_ring. Qed.

Lemma rotation_orthonormal A : rotation A -> orthonormal (A e1) (A e2) (A e3).
Proof.
  intros (keeps & _).
  split; unfold norm_squared; rewrite keeps; vector_ring.
Qed.

Lemma rotation_expand A v : rotation A ->
  A v = add (add (scale (X v) (A e1)) (scale (Y v) (A e2))) (scale (Z v) (A e3)).
Proof.
  intros turn.
  rewrite (orthonormal_expand _ _ _ (A v) (rotation_orthonormal A turn)) at 1.
  rewrite !(proj1 turn).
  replace (dot v e1) with (X v) by vector_ring.
  replace (dot v e2) with (Y v) by vector_ring.
  replace (dot v e3) with (Z v) by vector_ring.
  reflexivity.
Qed.

(* Two attitudes that agree on two axes are equal. *)
Lemma rotation_ext A B : rotation A -> rotation B -> A e1 = B e1 -> A e3 = B e3 -> forall v, A v = B v.
Proof.
  intros turn turn' first third v.
  assert (axis2 : e2 = cross e3 e1) by vector_ring.
  assert (second : A e2 = B e2).
  { rewrite axis2, (proj2 turn), (proj2 turn'), first, third.
    reflexivity. }
  rewrite (rotation_expand A v turn), (rotation_expand B v turn'), first, second, third.
  reflexivity.
Qed.

Lemma chart_rotation f th s : rotation (attitude f th s).
Proof. split; intros; [apply attitude_dot | apply attitude_cross]. Qed.

(* Euler angles exist unless body axis 3 is along space axis 3. *)
Theorem euler_angles A : rotation A -> Z (A e3) * Z (A e3) < 1 ->
  exists f th s, 0 < sin th /\ forall v, A v = attitude f th s v.
Proof.
  intros turn tilted.
  assert (axes := rotation_orthonormal A turn).
  assert (unit3 := n_w _ _ _ axes).
  set (a := A e3) in *.
  assert (range : -1 <= Z a <= 1) by (split; nra).
  set (th := acos (Z a)).
  assert (cosine : cos th = Z a) by (now apply cos_acos).
  assert (circle := sin_cos th).
  assert (bounds := acos_bound (Z a)).
  assert (sine : 0 < sin th).
  { assert (weak := sin_ge_0 th (proj1 bounds) (proj2 bounds)).
    destruct weak as [strict|flat]; [exact strict|].
    rewrite <- flat, cosine in circle; lra. }
  destruct (angle_exists (- Y a / sin th) (X a / sin th)) as (f & cos_f & sin_f).
  { replace (- Y a / sin th * (- Y a / sin th) + X a / sin th * (X a / sin th)) with
      ((norm_squared a - Z a * Z a) * / (sin th * sin th)) by (unfold norm_squared, dot; field; lra).
    rewrite unit3, <- cosine.
    replace (1 - cos th * cos th) with (sin th * sin th) by lra.
    apply Rinv_r.
    apply Rmult_integral_contrapositive_currified; lra. }
  assert (third : forall s, attitude f th s e3 = a).
  { intros s.
    unfold attitude, e3; apply V_eq; cbn [X Y Z].
    - rewrite sin_f; field; lra.
    - rewrite cos_f; field; lra.
    - rewrite cosine; ring. }
  set (n := attitude f th 0 e1).
  set (k := attitude f th 0 e2).
  assert (frame : orthonormal n k a).
  { rewrite <- (third 0).
    apply rotation_orthonormal, chart_rotation. }
  assert (flat : dot (A e1) a = 0) by (unfold a; rewrite (proj1 turn); vector_ring).
  assert (length := parseval n k a (A e1) frame).
  rewrite flat, (n_u _ _ _ axes) in length.
  destruct (angle_exists (dot (A e1) n) (dot (A e1) k) ltac:(lra)) as (s & cos_s & sin_s).
  exists f, th, s.
  split; [exact sine|].
  apply rotation_ext; auto using chart_rotation.
  - rewrite (orthonormal_expand n k a (A e1) frame), flat, <- cos_s, <- sin_s.
    unfold n, k, attitude, e1, e2, add, scale; rewrite sin_0, cos_0.
    apply V_eq; cbn [X Y Z]; ring.
Qed.

(* The atlas. *)
Definition quarter_turn v := mk (X v) (- Z v) (Y v).
Definition quarter_back v := mk (X v) (Z v) (- Y v).
Definition chart (second : bool) f th s v := if second then quarter_turn (attitude f th s v) else attitude f th s v.

Lemma back_rotation A : rotation A -> rotation (fun v => quarter_back (A v)).
Proof.
  intros (dots & crosses).
  split; intros u v.
  - rewrite <- (dots u v).
    unfold quarter_back, dot; cbn [X Y Z]; ring.
  - rewrite crosses.
    unfold quarter_back, cross; apply V_eq; cbn [X Y Z]; ring.
Qed.

Theorem atlas_covers A : rotation A -> exists second f th s, 0 < sin th /\ forall v, A v = chart second f th s v.
Proof.
  intros turn.
  destruct (Rlt_dec (Z (A e3) * Z (A e3)) 1) as [tilted|upright].
  - exists false.
    exact (euler_angles A turn tilted).
  - exists true.
    destruct (euler_angles (fun v => quarter_back (A v)) (back_rotation A turn)) as (f & th & s & sine & same).
    + assert (unit3 := n_w _ _ _ (rotation_orthonormal A turn)).
      unfold norm_squared, dot in unit3.
      unfold quarter_back; cbn [X Y Z].
      assert (x2 := Rle_0_sqr (X (A e3))).
      unfold Rsqr in x2.
      lra.
    + exists f, th, s.
      split; [exact sine|].
      intros v.
      unfold chart.
      rewrite <- same.
      unfold quarter_turn, quarter_back; apply V_eq; cbn [X Y Z]; ring.
Qed.

(* Body velocities of the angles are those of CotangentBundle.v in both charts. *)
Lemma quarter_derive c t v : has_velocity c t v -> has_velocity (fun x => quarter_turn (c x)) t (quarter_turn v).
Proof.
  intros (x & y & z).
  refine (conj x (conj _ y)); cbn [quarter_turn Y].
  exact (is_derive_opp (fun s => Z (c s)) t _ z).
Qed.

Theorem chart_velocity second f th s v :
  has_velocity (fun x => chart second x th s v) f (chart second f th s (cross (axis_precession th s) v)) /\
  has_velocity (fun x => chart second f x s v) th (chart second f th s (cross (axis_nutation s) v)) /\
  has_velocity (fun x => chart second f th x v) s (chart second f th s (cross axis_spin v)).
Proof.
  destruct second; unfold chart.
  - refine (conj _ (conj _ _)); apply quarter_derive.
    + apply attitude_derive_precession.
    + apply attitude_derive_nutation.
    + apply attitude_derive_spin.
  - refine (conj _ (conj _ _)).
    + apply attitude_derive_precession.
    + apply attitude_derive_nutation.
    + apply attitude_derive_spin.
Qed.

(* K, a function of attitude and body momentum, has the left-trivialised differential (xi, g) at (A, P): along every
   curve through (A, P) with body velocity w and momentum rate q it changes at the rate xi . w + g . q. *)
Definition differential (K : (V -> V) -> V -> R) (A : V -> V) P xi g := forall (a : R -> V -> V) (p : R -> V) t w q,
  a t = A -> p t = P -> (forall v, has_velocity (fun x => a x v) t (A (cross w v))) -> has_velocity p t q ->
  is_derive (fun x => K (a x) (p x)) t (dot xi w + dot g q).

(* The functions on T*SO(3) that depend on body momentum alone, of which reduction speaks. *)
Lemma momentum_differential F A P g : is_gradient F P g -> differential (fun _ => F) A P zero g.
Proof.
  intros gradient a p t w q _ value _ moves.
  replace (dot zero w + dot g q) with (dot g q) by vector_ring.
  apply chain; auto.
  now rewrite value.
Qed.

Lemma constant_derive u t : has_velocity (fun _ : R => u) t zero.
Proof.
  refine (conj _ (conj _ _)).
  - exact (is_derive_const (X u) t).
  - exact (is_derive_const (Y u) t).
  - exact (is_derive_const (Z u) t).
Qed.

Section Bracket.
Variable second : bool.
Variables (f th s pf pt ps : R).
Hypothesis regular : sin th <> 0.
Let A := chart second f th s.
Let P := body_momentum th s pf pt ps.

Lemma still v t : has_velocity (fun _ : R => A v) t (A (cross zero v)).
Proof.
  replace (A (cross zero v)) with zero; [apply constant_derive|].
  unfold A, chart, quarter_turn, attitude.
  destruct second; apply V_eq; cbn; ring.
Qed.

(* The momenta of the angles are dual to their velocities. *)
Lemma dual xi g :
  dot xi (axis_precession th s) * dot g (d_pf th s) + dot xi (axis_nutation s) * dot g (d_pt s) +
    dot xi axis_spin * dot g (d_ps th s) = dot xi g.
Proof.
  transitivity ((X xi * X g + Y xi * Y g) * (sin s * sin s + cos s * cos s) + Z xi * Z g).
  - unfold dot, axis_precession, axis_nutation, axis_spin, d_pf, d_pt, d_ps; cbn [X Y Z].
    field; auto.
  - rewrite sin_cos.
    unfold dot; ring.
Qed.

Theorem bracket_left_trivialised K K' xi g xi' g' : differential K A P xi g -> differential K' A P xi' g' ->
  canonical_bracket (fun f th s pf pt ps => K (chart second f th s) (body_momentum th s pf pt ps))
    (fun f th s pf pt ps => K' (chart second f th s) (body_momentum th s pf pt ps)) f th s pf pt ps
  = dot xi g' - dot g xi' + bracket g g' P.
Proof.
  intros hK hK'.
  assert (partial_f : forall L x y, differential L A P x y ->
    Derive (fun u => L (chart second u th s) (body_momentum th s pf pt ps)) f = dot x (axis_precession th s)).
  { intros L x y hL.
    apply is_derive_unique.
    replace (dot x (axis_precession th s)) with (dot x (axis_precession th s) + dot y zero) by vector_ring.
    apply hL; auto; [|apply constant_derive].
    intros v; exact (proj1 (chart_velocity second f th s v)). }
  assert (partial_th : forall L x y, differential L A P x y ->
    Derive (fun u => L (chart second f u s) (body_momentum u s pf pt ps)) th =
    dot x (axis_nutation s) + dot y (d_th th s pf ps)).
  { intros L x y hL.
    apply is_derive_unique, hL; auto.
    - intros v; exact (proj1 (proj2 (chart_velocity second f th s v))).
    - now apply v_th. }
  assert (partial_s : forall L x y, differential L A P x y ->
    Derive (fun u => L (chart second f th u) (body_momentum th u pf pt ps)) s =
    dot x axis_spin + dot y (d_s th s pf pt ps)).
  { intros L x y hL.
    apply is_derive_unique, hL; auto.
    - intros v; exact (proj2 (proj2 (chart_velocity second f th s v))).
    - now apply v_s. }
  assert (partial_p : forall L x y (p : R -> V) t q, differential L A P x y -> p t = P -> has_velocity p t q ->
    Derive (fun u => L A (p u)) t = dot y q).
  { intros L x y p t q hL value moves.
    apply is_derive_unique.
    replace (dot y q) with (dot x zero + dot y q) by vector_ring.
    apply hL; auto.
    intros v.
    exact (still v t). }
  unfold canonical_bracket.
  rewrite (partial_f K _ _ hK), (partial_f K' _ _ hK').
  rewrite (partial_th K _ _ hK), (partial_th K' _ _ hK').
  rewrite (partial_s K _ _ hK), (partial_s K' _ _ hK').
  fold A.
  assert (partial_pf := fun L x y hL => partial_p L x y (fun u => body_momentum th s u pt ps) pf _ hL eq_refl
    (v_pf th s pf pt ps regular)).
  assert (partial_pt := fun L x y hL => partial_p L x y (fun u => body_momentum th s pf u ps) pt _ hL eq_refl
    (v_pt th s pf pt ps)).
  assert (partial_ps := fun L x y hL => partial_p L x y (fun u => body_momentum th s pf pt u) ps _ hL eq_refl
    (v_ps th s pf pt ps regular)).
  rewrite (partial_pf K _ _ hK), (partial_pf K' _ _ hK').
  rewrite (partial_pt K _ _ hK), (partial_pt K' _ _ hK').
  rewrite (partial_ps K _ _ hK), (partial_ps K' _ _ hK').
  transitivity (dot xi g' - dot xi' g + ((X g * Y g' - Y g * X g') * B th s pf pt ps X Y +
    (Y g * Z g' - Z g * Y g') * B th s pf pt ps Y Z + (Z g * X g' - X g * Z g') * B th s pf pt ps Z X)).
  - rewrite <- (dual xi g'), <- (dual xi' g).
    unfold B, dot.
    generalize (d_th th s pf ps), (d_s th s pf pt ps), (d_pf th s), (d_pt s), (d_ps th s).
    generalize (axis_precession th s), (axis_nutation s), axis_spin.
    intros; ring.
  - rewrite B12, B23, B31 by exact regular.
    unfold bracket, dot, cross, P, body_momentum; cbn [X Y Z]; ring.
Qed.
End Bracket.

(* Every body momentum has momenta conjugate to the angles. *)
Lemma momenta_exist th s P : sin th <> 0 ->
  P = body_momentum th s (dot P (axis_precession th s)) (dot P (axis_nutation s)) (dot P axis_spin).
Proof.
  intros regular.
  assert (circle := sin_cos s).
  assert (around : dot P (axis_precession th s) - dot P axis_spin * cos th = sin th * (X P * sin s + Y P * cos s))
    by (unfold dot, axis_precession, axis_spin; cbn [X Y Z]; ring).
  unfold body_momentum, momentum1, momentum2, momentum3.
  rewrite around.
  replace (sin th * (X P * sin s + Y P * cos s) / sin th) with (X P * sin s + Y P * cos s) by (field; auto).
  unfold dot, axis_nutation, axis_spin; apply V_eq; cbn [X Y Z].
  - transitivity (X P * (sin s * sin s + cos s * cos s)); [rewrite circle|]; ring.
  - transitivity (Y P * (sin s * sin s + cos s * cos s)); [rewrite circle|]; ring.
  - ring.
Qed.

(* At every point (A, P) of T*SO(3) some chart applies, and there the canonical bracket of two functions of body
   momentum is the Lie-Poisson bracket of so(3)*. *)
Theorem reduction_everywhere A P : rotation A -> exists second f th s pf pt ps,
  (forall v, A v = chart second f th s v) /\ P = body_momentum th s pf pt ps /\
  forall F G g h, is_gradient F P g -> is_gradient G P h ->
  canonical_bracket (fun _ th s pf pt ps => F (body_momentum th s pf pt ps))
    (fun _ th s pf pt ps => G (body_momentum th s pf pt ps)) f th s pf pt ps
  = bracket g h P.
Proof.
  intros turn.
  destruct (atlas_covers A turn) as (second & f & th & s & sine & same).
  assert (regular : sin th <> 0) by lra.
  assert (momentum := momenta_exist th s P regular).
  revert momentum.
  generalize (dot P (axis_precession th s)), (dot P (axis_nutation s)), (dot P axis_spin).
  intros pf pt ps ->.
  exists second, f, th, s, pf, pt, ps.
  refine (conj same (conj eq_refl _)).
  intros F G g h hF hG.
  assert (formula := bracket_left_trivialised second f th s pf pt ps regular (fun _ => F) (fun _ => G) zero g zero h
    (momentum_differential F _ _ g hF) (momentum_differential G _ _ h hG)).
  cbv beta in formula.
  rewrite formula.
  unfold dot, zero; cbn [X Y Z]; ring.
Qed.
