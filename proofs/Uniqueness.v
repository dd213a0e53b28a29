(** * A solution of Euler's equations is determined by one of its values

    Euler's equations for principal axes read X' = p Y Z, Y' = q Z X, Z' = r X Y with p + q + r = 0
    (Stability.v), so |L|^2 is constant.  Two solutions therefore stay in one ball, on which the
    quadratic field is Lipschitz, and Gronwall's inequality for the square of their distance makes them equal.
    The field may carry a factor h(t): ClosedOrbits.v changes the independent variable from time to an angle.

    Source: Hartman, Ordinary Differential Equations, chapter III, theorem 1.1. *)
From Coq Require Import Reals Lra Psatz.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Vec3 Calculus Euler.
Local Open Scope R_scope.

(* The quadratic field, and the curves that it drives at the rate h on a closed interval. *)
Definition triple p q r u := mk (p * (Y u * Z u)) (q * (Z u * X u)) (r * (X u * Y u)).
Definition driven p q r (h : R -> R) (c : R -> V) a b :=
  forall t, a <= t <= b -> has_velocity c t (scale (h t) (triple p q r (c t))).

(* A function with a derivative that is nowhere negative does not decrease. *)
Lemma nondecreasing (f df : R -> R) a b : (forall t, a <= t <= b -> is_derive f t (df t)) ->
  (forall t, a <= t <= b -> 0 <= df t) -> a <= b -> f a <= f b.
Proof.
  intros derivative sign order.
  destruct (MVT_gen f a b df) as (x & between & mean).
  - intros x hx.
    rewrite Rmin_left, Rmax_right in hx by lra.
    apply derivative; lra.
  - intros x hx.
    rewrite Rmin_left, Rmax_right in hx by lra.
    apply derivable_continuous_pt.
    exists (df x).
    apply is_derive_Reals, derivative; lra.
  - rewrite Rmin_left, Rmax_right in between by lra.
    assert (slope := sign x between).
    nra.
Qed.

(* Gronwall's inequality in the form used here: |w'| <= k w and w(s) = 0 leave no room for w > 0. *)
Lemma gronwall_zero (w dw : R -> R) k a b s : (forall t, a <= t <= b -> is_derive w t (dw t)) ->
  (forall t, a <= t <= b -> Rabs (dw t) <= k * w t) -> a <= s <= b -> w s = 0 ->
  forall t, a <= t <= b -> w t <= 0.
Proof.
  intros derivative bound hs start t ht.
  assert (two : forall x, a <= x <= b -> dw x <= k * w x /\ - (k * w x) <= dw x).
  { intros x hx.
    assert (size := bound x hx).
    apply Rabs_le_between in size.
    lra. }
  destruct (Rle_dec s t) as [forward|backward].
  - assert (monotone : - (w s * exp (- k * s)) <= - (w t * exp (- k * t))).
    { apply (nondecreasing (fun x => - (w x * exp (- k * x))) (fun x => (k * w x - dw x) * exp (- k * x))); auto.
      - intros x hx.
        assert (dx := derivative x ltac:(lra)).
        auto_derive; [eexists; exact dx|].
        change (Derive (fun x => w x) x) with (Derive w x).
        rewrite (is_derive_unique w x (dw x) dx).
        ring.
      - intros x hx.
        assert (both := two x ltac:(lra)).
        apply Rmult_le_pos; [lra | apply Rlt_le, exp_pos]. }
    rewrite start in monotone.
    assert (positive := exp_pos (- k * t)).
    nra.
  - assert (monotone : w t * exp (k * t) <= w s * exp (k * s)).
    { apply (nondecreasing (fun x => w x * exp (k * x)) (fun x => (dw x + k * w x) * exp (k * x))); [| |lra].
      - intros x hx.
        assert (dx := derivative x ltac:(lra)).
        auto_derive; [eexists; exact dx|].
        change (Derive (fun x => w x) x) with (Derive w x).
        rewrite (is_derive_unique w x (dw x) dx).
        ring.
      - intros x hx.
        assert (both := two x ltac:(lra)).
        apply Rmult_le_pos; [lra | apply Rlt_le, exp_pos]. }
    rewrite start in monotone.
    assert (positive := exp_pos (k * t)).
    nra.
Qed.

Lemma component_bound u n : 0 <= n -> norm_squared u <= n * n -> Rabs (X u) <= n /\ Rabs (Y u) <= n /\ Rabs (Z u) <= n.
Proof.
  unfold norm_squared, dot; intros positive size.
  assert (square : forall x, x * x <= n * n -> Rabs x <= n).
  { intros x hx.
    apply Rabs_le; split; nra. }
  refine (conj _ (conj _ _)); apply square; nra.
Qed.

(* One of the six terms of the Lipschitz estimate. *)
Lemma term_bound m n a x y z : Rabs a <= m -> Rabs z <= n -> Rabs (a * x * y * z) <= m * n * ((x * x + y * y) / 2).
Proof.
  intros ha hz.
  replace (a * x * y * z) with ((a * z) * (x * y)) by ring.
  rewrite Rabs_mult.
  apply Rmult_le_compat; try apply Rabs_pos.
  - rewrite Rabs_mult.
    apply Rmult_le_compat; auto; apply Rabs_pos.
  - assert (square_of_sum := Rle_0_sqr (x + y)).
    assert (square_of_difference := Rle_0_sqr (x - y)).
    unfold Rsqr in *.
    apply Rabs_le; split; lra.
Qed.

Lemma vderive_sub c c' t v v' : has_velocity c t v -> has_velocity c' t v' ->
  has_velocity (fun s => sub (c s) (c' s)) t (sub v v').
Proof.
  intros (x & y & z) (x' & y' & z').
  refine (conj _ (conj _ _)); cbn [X Y Z sub].
  - exact (is_derive_minus (fun s => X (c s)) (fun s => X (c' s)) t _ _ x x').
  - exact (is_derive_minus (fun s => Y (c s)) (fun s => Y (c' s)) t _ _ y y').
  - exact (is_derive_minus (fun s => Z (c s)) (fun s => Z (c' s)) t _ _ z z').
Qed.

Section Field.
Variables p q r : R.

Lemma lipschitz m n u v : Rabs p <= m -> Rabs q <= m -> Rabs r <= m -> 0 <= n ->
  norm_squared u <= n * n -> norm_squared v <= n * n ->
  Rabs (dot (sub u v) (sub (triple p q r u) (triple p q r v))) <= 2 * m * n * norm_squared (sub u v).
Proof.
  intros hp hq hr positive hu hv.
  destruct (component_bound u n positive hu) as (xu & yu & zu).
  destruct (component_bound v n positive hv) as (xv & yv & zv).
  replace (dot (sub u v) (sub (triple p q r u) (triple p q r v))) with
    ((p * (X u - X v) * (Y u - Y v) * Z u + p * (X u - X v) * (Z u - Z v) * Y v) +
     (q * (Y u - Y v) * (Z u - Z v) * X u + q * (Y u - Y v) * (X u - X v) * Z v) +
     (r * (Z u - Z v) * (X u - X v) * Y u + r * (Z u - Z v) * (Y u - Y v) * X v)) by (unfold triple; vector_ring).
  assert (t1 := term_bound m n p (X u - X v) (Y u - Y v) (Z u) hp zu).
  assert (t2 := term_bound m n p (X u - X v) (Z u - Z v) (Y v) hp yv).
  assert (t3 := term_bound m n q (Y u - Y v) (Z u - Z v) (X u) hq xu).
  assert (t4 := term_bound m n q (Y u - Y v) (X u - X v) (Z v) hq zv).
  assert (t5 := term_bound m n r (Z u - Z v) (X u - X v) (Y u) hr yu).
  assert (t6 := term_bound m n r (Z u - Z v) (Y u - Y v) (X v) hr xv).
  apply Rabs_le_between in t1, t2, t3, t4, t5, t6.
  unfold norm_squared, dot, sub; cbn [X Y Z].
  apply Rabs_le; split; lra.
Qed.

Hypothesis balanced : p + q + r = 0.

Lemma driven_norm h c a b : driven p q r h c a b ->
  forall s t, a <= s <= b -> a <= t <= b -> norm_squared (c s) = norm_squared (c t).
Proof.
  intros solution.
  assert (constant : forall t, a <= t <= b -> norm_squared (c t) = norm_squared (c a)).
  { apply (const_of_derive (fun t => norm_squared (c t))).
    intros t ht.
    replace 0 with (dot (scale 2 (c t)) (scale (h t) (triple p q r (c t)))).
    - exact (chain norm_squared c t _ _ (solution t ht) (norm_squared_gradient (c t))).
    - transitivity (2 * h t * (p + q + r) * (X (c t) * Y (c t) * Z (c t))); [unfold triple; vector_ring|].
      rewrite balanced; ring. }
  intros s t hs ht.
  now rewrite (constant s hs), (constant t ht).
Qed.

Theorem driven_unique h g c c' a b s : (forall t, a <= t <= b -> Rabs (h t) <= g) ->
  driven p q r h c a b -> driven p q r h c' a b -> a <= s <= b -> c s = c' s ->
  forall t, a <= t <= b -> c t = c' t.
Proof.
  intros rate solution solution' hs start t ht.
  set (n := sqrt (norm_squared (c s))).
  assert (n_positive : 0 <= n) by apply sqrt_pos.
  assert (n_square : n * n = norm_squared (c s)) by (apply sqrt_sqrt, norm_squared_ge0).
  set (m := Rabs p + Rabs q + Rabs r).
  assert (ap := Rabs_pos p).
  assert (aq := Rabs_pos q).
  assert (ar := Rabs_pos r).
  set (distance := fun x => norm_squared (sub (c x) (c' x))).
  set (rhs := fun x => scale (h x) (sub (triple p q r (c x)) (triple p q r (c' x)))).
  assert (vanishes : distance t <= 0).
  { apply (gronwall_zero distance (fun x => dot (scale 2 (sub (c x) (c' x))) (rhs x)) (4 * g * m * n) a b s); auto.
    - intros x hx.
      replace (rhs x) with (sub (scale (h x) (triple p q r (c x))) (scale (h x) (triple p q r (c' x))))
        by (unfold rhs; vector_ring).
      refine (chain norm_squared (fun y => sub (c y) (c' y)) x _ _ _ (norm_squared_gradient _)).
      apply vderive_sub; auto.
    - intros x hx.
      assert (radius : norm_squared (c x) <= n * n) by (rewrite n_square; right; apply (driven_norm h c a b); auto).
      assert (radius' : norm_squared (c' x) <= n * n).
      { rewrite n_square, start; right; apply (driven_norm h c' a b); auto. }
      assert (estimate := lipschitz m n (c x) (c' x) ltac:(unfold m; lra) ltac:(unfold m; lra) ltac:(unfold m; lra)
        n_positive radius radius').
      replace (dot (scale 2 (sub (c x) (c' x))) (rhs x)) with
        (2 * (h x * dot (sub (c x) (c' x)) (sub (triple p q r (c x)) (triple p q r (c' x)))))
        by (unfold rhs; vector_ring).
      rewrite Rabs_mult, Rabs_mult, (Rabs_right 2) by lra.
      assert (product := Rmult_le_compat _ _ _ _ (Rabs_pos _) (Rabs_pos _) (rate x hx) estimate).
      unfold distance; lra.
    - unfold distance.
      rewrite start; vector_ring. }
  assert (zero_distance : sub (c t) (c' t) = zero).
  { apply norm_squared_eq0.
    assert (positive := norm_squared_ge0 (sub (c t) (c' t))).
    unfold distance in vanishes; lra. }
  apply V_eq;
    [apply (f_equal X) in zero_distance | apply (f_equal Y) in zero_distance | apply (f_equal Z) in zero_distance];
    cbn in zero_distance; lra.
Qed.
End Field.
