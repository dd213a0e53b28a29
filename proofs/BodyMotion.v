(** * The motion of a free body, attitude included: exactly one for all time, and its attitude stays a rotation

    The unknowns are L in the body and the columns a, b, c of the attitude A, with A' = A (W x .), as in Motion.v.  The
    system is quadratic in twelve unknowns and tangent to spheres, since |L| and the rows of A keep their lengths, so
    QuadraticFlow.v applies.  Scalar products of rows and the determinant are constant: A stays orthogonal and
    right-handed.

    Source: Landau and Lifshitz, Mechanics, section 36; Marsden and Ratiu, Introduction to Mechanics and Symmetry,
    chapter 15. *)
From Coq Require Import Reals Lra Psatz Lia List.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Vec3 Calculus Euler Stability Motion QuadraticTerms QuadraticFlow GlobalSolution.
From Polhode Require Import EllipticClock CotangentBundle Atlas.
Import ListNotations.
Local Open Scope R_scope.

(* Coquelicot types values by a module that is R only up to unfolding; ring and field want R itself. *)
Ltac over_reals := match goal with |- @eq _ ?x ?y => change (@eq R x y) end.

Lemma is_derive_value (f : R -> R) t v w : is_derive f t v -> v = w -> is_derive f t w.
Proof. intros derivative <-. exact derivative. Qed.

(* Unknowns 0 to 2 are L, then come the columns of the attitude. *)
Definition pack L a b c (i : nat) := match i with
  | 0 => X L | 1 => Y L | 2 => Z L
  | 3 => X a | 4 => Y a | 5 => Z a
  | 6 => X b | 7 => Y b | 8 => Z b
  | 9 => X c | 10 => Y c | _ => Z c
  end%nat.

(* Columns are orthonormal and right-handed just when rows are. *)
Lemma transposed u v w : orthonormal u v w ->
  orthonormal (mk (X u) (X v) (X w)) (mk (Y u) (Y v) (Y w)) (mk (Z u) (Z v) (Z w)).
Proof.
  intros axes.
  assert (first := orthonormal_expand u v w e1 axes).
  assert (second := orthonormal_expand u v w e2 axes).
  assert (third := orthonormal_expand u v w e3 axes).
  assert (xx := f_equal X first).
  assert (xy := f_equal Y first).
  assert (yy := f_equal Y second).
  assert (yz := f_equal Z second).
  assert (zz := f_equal Z third).
  assert (zx := f_equal X third).
  unfold add, scale, dot, e1, e2, e3 in xx, xy, yy, yz, zz, zx; cbn [X Y Z] in xx, xy, yy, yz, zz, zx.
  split; unfold norm_squared, dot; cbn [X Y Z]; lra.
Qed.

Lemma right_handed a b c : orthonormal a b c -> det a b c = 1 -> cross a b = c /\ cross b c = a /\ cross c a = b.
Proof.
  assert (third : forall u v w, orthonormal u v w -> det u v w = 1 -> cross u v = w).
  { intros u v w [n1 n2 n3 o12 o23 o31] hand.
    assert (distance : norm_squared (sub (cross u v) w) = 0).
    { replace (norm_squared (sub (cross u v) w)) with (norm_squared (cross u v) + norm_squared w - 2 * det u v w)
        by (unfold det; vector_ring).
      rewrite lagrange, n1, n2, n3, o12, hand; ring. }
    apply norm_squared_eq0 in distance.
    apply V_eq;
      [apply (f_equal X) in distance | apply (f_equal Y) in distance | apply (f_equal Z) in distance];
      cbn [X Y Z sub zero] in distance; lra. }
  intros axes hand.
  refine (conj (third a b c axes hand) (conj (third b c a _ _) (third c a b _ _))).
  - destruct axes; now split.
  - rewrite <- hand; unfold det; vector_ring.
  - destruct axes; now split.
  - rewrite <- hand; unfold det; vector_ring.
Qed.

Lemma rotation_rows a b c : rotation (columns_times a b c) <->
  orthonormal (mk (X a) (X b) (X c)) (mk (Y a) (Y b) (Y c)) (mk (Z a) (Z b) (Z c)) /\
  det (mk (X a) (X b) (X c)) (mk (Y a) (Y b) (Y c)) (mk (Z a) (Z b) (Z c)) = 1.
Proof.
  assert (same_det : det (mk (X a) (X b) (X c)) (mk (Y a) (Y b) (Y c)) (mk (Z a) (Z b) (Z c)) = det a b c)
    by (unfold det; vector_ring).
  rewrite same_det.
  split.
  - intros turn.
    assert (columns := rotation_orthonormal _ turn).
    assert (hand := proj2 turn e1 e2).
    replace (columns_times a b c e1) with a in * by (unfold columns_times; vector_ring).
    replace (columns_times a b c e2) with b in * by (unfold columns_times; vector_ring).
    replace (columns_times a b c e3) with c in * by (unfold columns_times; vector_ring).
    replace (columns_times a b c (cross e1 e2)) with c in hand by (unfold columns_times; vector_ring).
    split; [now apply transposed|].
    replace (det a b c) with (dot c (cross a b)) by (unfold det; vector_ring).
    rewrite <- hand.
    exact (n_w _ _ _ columns).
  - intros (rows & hand).
    assert (columns := transposed _ _ _ rows).
    cbn [X Y Z] in columns.
    assert (shape : forall u, mk (X u) (Y u) (Z u) = u) by (intros []; reflexivity).
    rewrite !shape in columns.
    destruct (right_handed a b c columns hand) as (ab & bc & ca).
    destruct columns as [n1 n2 n3 o12 o23 o31].
    split; intros u v.
    + replace (dot (columns_times a b c u) (columns_times a b c v)) with
        (X u * X v * norm_squared a + Y u * Y v * norm_squared b + Z u * Z v * norm_squared c +
        (X u * Y v + Y u * X v) * dot a b + (Y u * Z v + Z u * Y v) * dot b c + (Z u * X v + X u * Z v) * dot c a)
        by (unfold columns_times; vector_ring).
      rewrite n1, n2, n3, o12, o23, o31.
      unfold dot; ring.
    + replace (cross (columns_times a b c u) (columns_times a b c v)) with
        (add (add (scale (X (cross u v)) (cross b c)) (scale (Y (cross u v)) (cross c a)))
          (scale (Z (cross u v)) (cross a b))) by (unfold columns_times; vector_ring).
      rewrite ab, bc, ca.
      reflexivity.
Qed.

Section Body.
Variables I1 I2 I3 : R.
Hypotheses (p1 : 0 < I1) (p2 : 0 < I2) (p3 : 0 < I3).

Definition turning (L a b c : R -> V) t := has_velocity L t (euler_field I1 I2 I3 (L t)) /\
  let W := angular_velocity I1 I2 I3 (L t) in let A := columns_times (a t) (b t) (c t) in
  has_velocity a t (A (cross W e1)) /\ has_velocity b t (A (cross W e2)) /\ has_velocity c t (A (cross W e3)).

Definition body_terms (i : nat) := match i with
  | 0 => [Term (1 / I3 - 1 / I2) 1 2]
  | 1 => [Term (1 / I1 - 1 / I3) 2 0]
  | 2 => [Term (1 / I2 - 1 / I1) 0 1]
  | 3 => [Term (1 / I3) 2 6; Term (- (1 / I2)) 1 9]
  | 4 => [Term (1 / I3) 2 7; Term (- (1 / I2)) 1 10]
  | 5 => [Term (1 / I3) 2 8; Term (- (1 / I2)) 1 11]
  | 6 => [Term (- (1 / I3)) 2 3; Term (1 / I1) 0 9]
  | 7 => [Term (- (1 / I3)) 2 4; Term (1 / I1) 0 10]
  | 8 => [Term (- (1 / I3)) 2 5; Term (1 / I1) 0 11]
  | 9 => [Term (1 / I2) 1 3; Term (- (1 / I1)) 0 6]
  | 10 => [Term (1 / I2) 1 4; Term (- (1 / I1)) 0 7]
  | _ => [Term (1 / I2) 1 5; Term (- (1 / I1)) 0 8]
  end%nat.

Lemma body_closed i : (i < 12)%nat -> within 12 (body_terms i).
Proof.
  intros hi.
  do 11 (destruct i as [|i]; [repeat constructor|]).
  repeat constructor.
Qed.

Lemma body_flow : one_flow 12 body_terms.
Proof.
  apply (sphere_flow 12 body_terms body_closed).
  intros x.
  cbn [total body_terms evaluate fold_right factor left right].
  ring.
Qed.

Ltac components := unfold euler_field, angular_velocity, columns_times, cross, add, scale, e1, e2, e3;
  cbn [X Y Z pack body_terms evaluate fold_right factor left right];
  over_reals; field; lra.

Lemma turning_solves L a b c t : turning L a b c t -> solves 12 body_terms (fun x => pack (L x) (a x) (b x) (c x)) t.
Proof.
  intros ((lx & ly & lz) & (ax & ay & az) & (bx & by_ & bz) & (cx & cy & cz)) i hi.
  do 12 (destruct i as [|i]; [eapply is_derive_value; [eassumption | components]|]).
  lia.
Qed.

Lemma solves_turning x t : solves 12 body_terms x t ->
  turning (fun t => mk (x t 0%nat) (x t 1%nat) (x t 2%nat)) (fun t => mk (x t 3%nat) (x t 4%nat) (x t 5%nat))
    (fun t => mk (x t 6%nat) (x t 7%nat) (x t 8%nat)) (fun t => mk (x t 9%nat) (x t 10%nat) (x t 11%nat)) t.
Proof.
  intros each.
  refine (conj (conj _ (conj _ _)) (conj (conj _ (conj _ _)) (conj (conj _ (conj _ _)) (conj _ (conj _ _))))).
  - apply (is_derive_value _ t _ _ (each 0%nat ltac:(lia))); components.
  - apply (is_derive_value _ t _ _ (each 1%nat ltac:(lia))); components.
  - apply (is_derive_value _ t _ _ (each 2%nat ltac:(lia))); components.
  - apply (is_derive_value _ t _ _ (each 3%nat ltac:(lia))); components.
  - apply (is_derive_value _ t _ _ (each 4%nat ltac:(lia))); components.
  - apply (is_derive_value _ t _ _ (each 5%nat ltac:(lia))); components.
  - apply (is_derive_value _ t _ _ (each 6%nat ltac:(lia))); components.
  - apply (is_derive_value _ t _ _ (each 7%nat ltac:(lia))); components.
  - apply (is_derive_value _ t _ _ (each 8%nat ltac:(lia))); components.
  - apply (is_derive_value _ t _ _ (each 9%nat ltac:(lia))); components.
  - apply (is_derive_value _ t _ _ (each 10%nat ltac:(lia))); components.
  - apply (is_derive_value _ t _ _ (each 11%nat ltac:(lia))); components.
Qed.

Lemma pack_injective L a b c L' a' b' c' : same 12 (pack L a b c) (pack L' a' b' c') ->
  L = L' /\ a = a' /\ b = b' /\ c = c'.
Proof.
  intros equal.
  refine (conj _ (conj _ (conj _ _))); apply V_eq.
  - exact (equal 0%nat ltac:(lia)).
  - exact (equal 1%nat ltac:(lia)).
  - exact (equal 2%nat ltac:(lia)).
  - exact (equal 3%nat ltac:(lia)).
  - exact (equal 4%nat ltac:(lia)).
  - exact (equal 5%nat ltac:(lia)).
  - exact (equal 6%nat ltac:(lia)).
  - exact (equal 7%nat ltac:(lia)).
  - exact (equal 8%nat ltac:(lia)).
  - exact (equal 9%nat ltac:(lia)).
  - exact (equal 10%nat ltac:(lia)).
  - exact (equal 11%nat ltac:(lia)).
Qed.

Theorem body_motion_exists_unique L0 a0 b0 c0 : exists L a b c,
  (L 0 = L0 /\ a 0 = a0 /\ b 0 = b0 /\ c 0 = c0) /\ (forall t, turning L a b c t) /\
  forall L' a' b' c', (L' 0 = L0 /\ a' 0 = a0 /\ b' 0 = b0 /\ c' 0 = c0) -> (forall t, turning L' a' b' c' t) ->
  forall t, L' t = L t /\ a' t = a t /\ b' t = b t /\ c' t = c t.
Proof.
  destruct (body_flow (pack L0 a0 b0 c0)) as (x & first & solution & unique).
  set (L := fun t => mk (x t 0%nat) (x t 1%nat) (x t 2%nat)).
  set (a := fun t => mk (x t 3%nat) (x t 4%nat) (x t 5%nat)).
  set (b := fun t => mk (x t 6%nat) (x t 7%nat) (x t 8%nat)).
  set (c := fun t => mk (x t 9%nat) (x t 10%nat) (x t 11%nat)).
  assert (packed : forall t, same 12 (pack (L t) (a t) (b t) (c t)) (x t)).
  { intros t i hi.
    do 12 (destruct i as [|i]; [reflexivity|]).
    lia. }
  exists L, a, b, c.
  refine (conj _ (conj _ _)).
  - apply pack_injective.
    intros i hi.
    rewrite (packed 0 i hi).
    exact (first i hi).
  - intros t.
    apply solves_turning, solution.
  - intros L' a' b' c' (l_first & a_first & b_first & c_first) solution' t.
    apply pack_injective.
    intros i hi.
    rewrite (packed t i hi).
    refine (unique (fun s => pack (L' s) (a' s) (b' s) (c' s)) 0 _ _ t i hi).
    + intros j hj.
      rewrite l_first, a_first, b_first, c_first.
      symmetry; exact (first j hj).
    + intros s.
      apply turning_solves, solution'.
Qed.

Lemma product_derive (f g : R -> R) t df dg : is_derive f t df -> is_derive g t dg ->
  is_derive (fun s => f s * g s) t (df * g t + f t * dg).
Proof. intros hf hg. exact (is_derive_mult f g t df dg hf hg Rmult_comm). Qed.

Section Attitude.
Variables L a b c : R -> V.
Hypothesis solution : forall t, turning L a b c t.

(* The rows of the attitude: space axes as seen from the body. *)
Definition row (k : V -> R) t := mk (k (a t)) (k (b t)) (k (c t)).

(* Vectors fixed in space, seen from the body, obey u' = u x W; so does L. *)
Definition fixed_in_space (u : R -> V) := forall t, has_velocity u t (cross (u t) (angular_velocity I1 I2 I3 (L t))).

Lemma row_fixed k : k = X \/ k = Y \/ k = Z -> fixed_in_space (row k).
Proof.
  intros which t.
  destruct (solution t) as (_ & (ax & ay & az) & (bx & by_ & bz) & (cx & cy & cz)).
  destruct which as [-> | [-> | ->]]; refine (conj _ (conj _ _));
    (eapply is_derive_value; [eassumption | unfold row; components]).
Qed.

Lemma momentum_fixed : fixed_in_space L.
Proof. intros t. exact (proj1 (solution t)). Qed.

Lemma dot_derive u v t du dv : has_velocity u t du -> has_velocity v t dv ->
  is_derive (fun x => dot (u x) (v x)) t (dot du (v t) + dot (u t) dv).
Proof.
  intros (ux & uy & uz) (vx & vy & vz).
  assert (x := product_derive _ _ t _ _ ux vx).
  assert (y := product_derive _ _ t _ _ uy vy).
  assert (z := product_derive _ _ t _ _ uz vz).
  apply (is_derive_value _ t _ _ (is_derive_plus _ _ t _ _ (is_derive_plus _ _ t _ _ x y) z)).
  unfold plus, dot; cbn; ring.
Qed.

Lemma cross_derive u v t du dv : has_velocity u t du -> has_velocity v t dv ->
  has_velocity (fun x => cross (u x) (v x)) t (add (cross du (v t)) (cross (u t) dv)).
Proof.
  intros (ux & uy & uz) (vx & vy & vz).
  refine (conj _ (conj _ _)); cbn [X Y Z cross add].
  - apply (is_derive_value _ t _ _ (is_derive_minus _ _ t _ _ (product_derive _ _ t _ _ uy vz)
      (product_derive _ _ t _ _ uz vy))).
    unfold minus, plus, opp; cbn; ring.
  - apply (is_derive_value _ t _ _ (is_derive_minus _ _ t _ _ (product_derive _ _ t _ _ uz vx)
      (product_derive _ _ t _ _ ux vz))).
    unfold minus, plus, opp; cbn; ring.
  - apply (is_derive_value _ t _ _ (is_derive_minus _ _ t _ _ (product_derive _ _ t _ _ ux vy)
      (product_derive _ _ t _ _ uy vx))).
    unfold minus, plus, opp; cbn; ring.
Qed.

Lemma dot_constant u v s t : fixed_in_space u -> fixed_in_space v -> dot (u s) (v s) = dot (u t) (v t).
Proof.
  intros hu hv.
  apply (constant_everywhere (fun t => dot (u t) (v t))).
  intros x.
  apply (is_derive_value _ x _ _ (dot_derive u v x _ _ (hu x) (hv x))).
  over_reals.
  generalize (u x), (v x), (angular_velocity I1 I2 I3 (L x)).
  vector_ring.
Qed.

Lemma det_constant u v w s t : fixed_in_space u -> fixed_in_space v -> fixed_in_space w ->
  det (u s) (v s) (w s) = det (u t) (v t) (w t).
Proof.
  intros hu hv hw.
  apply (constant_everywhere (fun t => det (u t) (v t) (w t))).
  intros x.
  apply (is_derive_value _ x _ _ (dot_derive u _ x _ _ (hu x) (cross_derive v w x _ _ (hv x) (hw x)))).
  over_reals.
  generalize (u x), (v x), (w x), (angular_velocity I1 I2 I3 (L x)).
  unfold det; vector_ring.
Qed.

(* The angular momentum in space does not change. *)
Theorem space_momentum s t : columns_times (a s) (b s) (c s) (L s) = columns_times (a t) (b t) (c t) (L t).
Proof.
  assert (component : forall k, k = X \/ k = Y \/ k = Z -> dot (row k s) (L s) = dot (row k t) (L t)).
  { intros k which.
    apply dot_constant; [now apply row_fixed | apply momentum_fixed]. }
  assert (x := component X ltac:(auto)).
  assert (y := component Y ltac:(auto)).
  assert (z := component Z ltac:(auto)).
  unfold row, dot in x, y, z; cbn [X Y Z] in x, y, z.
  apply V_eq; unfold columns_times, add, scale; cbn [X Y Z]; lra.
Qed.

(* The attitude stays a rotation. *)
Theorem attitude_stays_rotation s : rotation (columns_times (a s) (b s) (c s)) ->
  forall t, rotation (columns_times (a t) (b t) (c t)).
Proof.
  intros turn t.
  apply rotation_rows in turn.
  destruct turn as (axes & hand).
  fold (row X s) (row Y s) (row Z s) in axes, hand.
  assert (fx : fixed_in_space (row X)) by (apply row_fixed; auto).
  assert (fy : fixed_in_space (row Y)) by (apply row_fixed; auto).
  assert (fz : fixed_in_space (row Z)) by (apply row_fixed; auto).
  apply rotation_rows.
  fold (row X t) (row Y t) (row Z t).
  split.
  - destruct axes as [n1 n2 n3 o12 o23 o31].
    unfold norm_squared in n1, n2, n3.
    split; unfold norm_squared.
    + now rewrite (dot_constant _ _ t s fx fx).
    + now rewrite (dot_constant _ _ t s fy fy).
    + now rewrite (dot_constant _ _ t s fz fz).
    + now rewrite (dot_constant _ _ t s fx fy).
    + now rewrite (dot_constant _ _ t s fy fz).
    + now rewrite (dot_constant _ _ t s fz fx).
  - now rewrite (det_constant _ _ _ t s fx fy fz).
Qed.
End Attitude.
End Body.
