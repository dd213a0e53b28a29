(** * Quadratic systems with a bound that motion conserves: exactly one solution for all time

    Two solutions through one point are equal by Gronwall's inequality for the square of their distance.  Where a
    function size, constant along solutions, bounds every unknown, the series of QuadraticSeries.v converges for the
    same time, two steps, about each state of a solution.  So steps of one length, forward or backward, reach every
    time; series about neighbouring nodes agree where both converge.

    Source: Hartman, Ordinary Differential Equations, chapters II (continuation) and III (uniqueness). *)
From Coq Require Import Reals Lra Psatz Lia List.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Calculus Uniqueness QuadraticTerms QuadraticSeries.
Local Open Scope R_scope.

Section System.
Variable n : nat.
Variable terms : nat -> list term.
Hypothesis closed : forall i, (i < n)%nat -> within n (terms i).
Variable m : R.
Hypothesis small_factors : forall i, (i < n)%nat -> weight (terms i) <= m.
Hypothesis m_positive : 0 < m.

Definition same (x y : nat -> R) := forall i, (i < n)%nat -> x i = y i.
Definition solves (c : R -> nat -> R) t :=
  forall i, (i < n)%nat -> is_derive (fun x => c x i) t (evaluate (terms i) (c t)).
Definition solves_on c a b := forall t, a <= t <= b -> solves c t.

Theorem solutions_agree c c' bound a b s : solves_on c a b -> solves_on c' a b ->
  (forall t i, a <= t <= b -> (i < n)%nat -> Rabs (c t i) <= bound /\ Rabs (c' t i) <= bound) ->
  a <= s <= b -> same (c s) (c' s) -> forall t, a <= t <= b -> same (c t) (c' t).
Proof.
  intros solution solution' bounded hs start t ht i hi.
  set (square := fun x i => (c x i - c' x i) * (c x i - c' x i)).
  set (rate := fun x i => 2 * (c x i - c' x i) * (evaluate (terms i) (c x) - evaluate (terms i) (c' x))).
  assert (squares : forall x i, (i < n)%nat -> 0 <= square x i) by (intros; apply Rle_0_sqr).
  assert (vanishes : total n (square t) <= 0).
  { apply (gronwall_zero (fun x => total n (square x)) (fun x => total n (rate x)) (INR n * (4 * m * bound)) a b s);
      auto.
    - intros x hx.
      apply total_derive.
      intros j hj.
      assert (d := is_derive_minus (fun x => c x j) (fun x => c' x j) x _ _ (solution x hx j hj) (solution' x hx j hj)).
      unfold rate, square.
      replace (2 * (c x j - c' x j) * (evaluate (terms j) (c x) - evaluate (terms j) (c' x))) with
        ((evaluate (terms j) (c x) - evaluate (terms j) (c' x)) * (c x j - c' x j) +
         (c x j - c' x j) * (evaluate (terms j) (c x) - evaluate (terms j) (c' x))) by ring.
      exact (is_derive_mult (fun x => c x j - c' x j) (fun x => c x j - c' x j) x _ _ d d Rmult_comm).
    - intros x hx.
      set (w := total n (square x)).
      assert (w_positive : 0 <= w) by (apply total_positive; auto).
      assert (root := sqrt_sqrt w w_positive).
      assert (root_positive := sqrt_pos w).
      assert (each : forall j, (j < n)%nat -> Rabs (c x j - c' x j) <= sqrt w).
      { intros j hj.
        rewrite <- sqrt_Rsqr_abs.
        apply sqrt_le_1_alt.
        exact (total_ge_term n (square x) j (squares x) hj). }
      rewrite Rmult_assoc.
      apply total_bound.
      intros j hj.
      destruct (bounded x j hx hj) as (bx & _).
      assert (bound_positive : 0 <= bound) by (assert (z := Rabs_pos (c x j)); lra).
      assert (difference := evaluate_difference n (terms j) (c x) (c' x) bound (sqrt w) (closed j hj) root_positive
        (fun k hk => conj (proj1 (bounded x k hx hk)) (conj (proj2 (bounded x k hx hk)) (each k hk)))).
      assert (change_positive : 0 <= 2 * bound * sqrt w) by (repeat apply Rmult_le_pos; lra).
      assert (factors := Rmult_le_compat_r _ _ _ change_positive (small_factors j hj)).
      unfold rate.
      rewrite Rabs_mult, Rabs_mult, (Rabs_right 2) by lra.
      assert (product := Rmult_le_compat _ _ _ _ (Rabs_pos _) (Rabs_pos _) (each j hj)
        (Rle_trans _ _ _ difference factors)).
      replace (4 * m * bound * w) with (2 * (sqrt w * (m * (2 * bound * sqrt w)))).
      + lra.
      + rewrite <- root at 3; ring.
    - assert (zero : forall k, (forall j, (j < k)%nat -> square s j = 0) -> total k (square s) = 0).
      { induction k as [|k hypothesis]; intros flat; [reflexivity|].
        cbn [total].
        rewrite (flat k (Nat.lt_succ_diag_r k)), hypothesis; [ring|].
        intros j hj; apply flat; lia. }
      apply zero.
      intros j hj.
      unfold square.
      rewrite (start j hj); ring. }
  assert (part := total_ge_term n (square t) i (squares t) hi).
  assert (sign := squares t i hi).
  assert (product : square t i = 0) by lra.
  destruct (Rmult_integral _ _ product); lra.
Qed.

(* A bound on the state that motion conserves. *)
Variable size : (nat -> R) -> R.
Hypothesis size_bounds : forall x i, (i < n)%nat -> Rabs (x i) <= size x.
Hypothesis size_same : forall x y, same x y -> size x = size y.
Hypothesis size_conserved : forall c a b, solves_on c a b -> forall s t, a <= s <= b -> a <= t <= b ->
  size (c s) = size (c t).

Theorem solutions_unique c c' a b s : solves_on c a b -> solves_on c' a b -> a <= s <= b -> same (c s) (c' s) ->
  forall t, a <= t <= b -> same (c t) (c' t).
Proof.
  intros solution solution' hs start.
  apply (solutions_agree c c' (size (c s)) a b s); auto.
  intros t i ht hi.
  split.
  - rewrite (size_conserved c a b solution s t hs ht).
    now apply size_bounds.
  - rewrite (size_same _ _ start), (size_conserved c' a b solution' s t hs ht).
    now apply size_bounds.
Qed.

Lemma solves_shift c s t : solves c (t + s) -> solves (fun x => c (x + s)) t.
Proof.
  intros solution i hi.
  assert (inner : is_derive (fun x => x + s) t 1) by (auto_derive; auto; ring).
  replace (evaluate (terms i) (c (t + s))) with (1 * evaluate (terms i) (c (t + s))) by ring.
  exact (is_derive_comp (fun u => c u i) (fun x => x + s) t _ _ (solution i hi) inner).
Qed.

Lemma evaluate_same l x y : within n l -> same x y -> evaluate l x = evaluate l y.
Proof.
  intros inside equal.
  induction inside as [|t l (hl & hr) inside rest]; [reflexivity|].
  cbn [evaluate fold_right].
  fold (evaluate l x) (evaluate l y).
  now rewrite rest, (equal _ hl), (equal _ hr).
Qed.

(* The equations hold at t for a curve that agrees with a solution near t. *)
Lemma solves_local c c' t d : 0 < d -> (forall s, Rabs (s - t) < d -> same (c s) (c' s)) -> solves c t -> solves c' t.
Proof.
  intros positive agree solution i hi.
  rewrite <- (evaluate_same (terms i) (c t) (c' t) (closed i hi)).
  - apply (is_derive_ext_loc (fun x => c x i)); auto.
    exists (mkposreal d positive).
    intros s inside.
    exact (agree s inside i hi).
  - apply agree.
    rewrite Rminus_eq_0, Rabs_R0; exact positive.
Qed.

Section Start.
Variable start : nat -> R.

Definition reach := Rabs (size start) + 1.
Definition step := / (2 * (m * reach)).

Lemma reach_positive : 0 < m * reach.
Proof.
  assert (positive := Rabs_pos (size start)).
  apply Rmult_lt_0_compat; unfold reach; lra.
Qed.

Lemma step_positive : 0 < step.
Proof. assert (positive := reach_positive). apply Rinv_0_lt_compat; lra. Qed.

(* The series about any state of the same size converges for two steps. *)
Lemma series_two_steps u t : size u = size start -> Rabs t < 2 * step -> solves (series terms u) t.
Proof.
  intros equal inside i hi.
  assert (positive := reach_positive).
  apply (series_solves n terms closed u m reach); auto.
  - unfold reach; assert (size_positive := Rabs_pos (size start)); lra.
  - intros j hj.
    assert (component := size_bounds u j hj).
    rewrite equal in component.
    assert (value := Rle_abs (size start)).
    unfold reach; lra.
  - enough (twice : / (m * reach) = 2 * step) by (rewrite twice; exact inside).
    unfold step.
    generalize (m * reach), positive.
    intros product product_positive.
    field; lra.
Qed.

(* Steps in one direction of time: sign is 1 or -1. *)
Section Direction.
Variable sign : R.
Hypothesis unit : sign * sign = 1.

Fixpoint node k := match k with 0%nat => start | S j => series terms (node j) (sign * step) end.

Lemma sign_size x : Rabs (sign * x) = Rabs x.
Proof.
  assert (squares : Rabs sign * Rabs sign = 1) by (rewrite <- Rabs_mult, unit; apply Rabs_R1).
  assert (positive := Rabs_pos sign).
  rewrite Rabs_mult.
  assert (Rabs sign = 1) as -> by nra.
  ring.
Qed.

Lemma node_size k : size (node k) = size start.
Proof.
  assert (positive := step_positive).
  induction k as [|k hypothesis]; [reflexivity|].
  cbn [node].
  rewrite <- hypothesis.
  rewrite <- (size_same _ _ (fun i _ => series_start terms (node k) i)).
  assert (length := sign_size step).
  rewrite (Rabs_right step) in length by lra.
  assert (ends := Rle_refl (Rabs (sign * step))).
  apply Rabs_le_between in ends.
  apply (size_conserved (series terms (node k)) (- step) step); try lra.
  intros t ht.
  apply series_two_steps; auto.
  apply Rabs_def1; lra.
Qed.

Lemma node_solves k t : Rabs t < 2 * step -> solves (series terms (node k)) t.
Proof. apply series_two_steps, node_size. Qed.

(* The series about neighbouring nodes agree. *)
Lemma overlap k t : Rabs t < step -> same (series terms (node (S k)) t) (series terms (node k) (t + sign * step)).
Proof.
  intros inside.
  assert (positive := step_positive).
  assert (length := sign_size step).
  rewrite (Rabs_right step) in length by lra.
  assert (ends := Rle_refl (Rabs t)).
  apply Rabs_le_between in ends.
  assert (t_positive := Rabs_pos t).
  apply (solutions_unique _ (fun x => series terms (node k) (x + sign * step)) (- Rabs t) (Rabs t) 0); auto; try lra.
  - intros x hx.
    apply node_solves, Rabs_def1; lra.
  - intros x hx.
    apply solves_shift, node_solves.
    eapply Rle_lt_trans; [apply Rabs_triang|].
    assert (Rabs x <= Rabs t) by (apply Rabs_le; lra).
    lra.
  - intros i hi.
    rewrite Rplus_0_l.
    exact (series_start terms (node (S k)) i).
Qed.

(* The number of whole steps before time t, and the solution on this side of time 0. *)
Definition steps_before t := Z.to_nat (Int_part (sign * t / step)).
Definition glued t := series terms (node (steps_before t)) (t - INR (steps_before t) * (sign * step)).

Lemma steps_before_spec t : - step < sign * t -> Rabs (t - INR (steps_before t) * (sign * step)) < step.
Proof.
  intros later.
  assert (positive := step_positive).
  destruct (base_Int_part (sign * t / step)) as (below & above).
  assert (value : sign * t = sign * t / step * step) by (field; lra).
  replace (t - INR (steps_before t) * (sign * step)) with (sign * (sign * t - INR (steps_before t) * step))
    by (transitivity ((sign * sign) * t - INR (steps_before t) * (sign * step)); [ring | rewrite unit; ring]).
  rewrite sign_size.
  unfold steps_before.
  set (k := Int_part (sign * t / step)) in *.
  set (y := sign * t / step) in *.
  destruct (Z_le_gt_dec 0 k) as [natural|negative].
  - rewrite INR_IZR_INZ, Znat.Z2Nat.id by auto.
    apply Rabs_def1; nra.
  - replace (Z.to_nat k) with 0%nat by lia.
    assert (IZR k <= -1) by (apply IZR_le; lia).
    cbn [INR].
    apply Rabs_def1; nra.
Qed.

Lemma glued_series k t : - step < sign * t -> Rabs (t - INR k * (sign * step)) < step ->
  same (glued t) (series terms (node k) (t - INR k * (sign * step))).
Proof.
  intros later close.
  assert (positive := step_positive).
  assert (own := steps_before_spec t later).
  unfold glued.
  set (j := steps_before t) in *.
  assert (cases : j = k \/ j = S k \/ k = S j).
  { assert (gap : Rabs ((INR j - INR k) * step) < 2 * step).
    { rewrite <- sign_size.
      replace (sign * ((INR j - INR k) * step)) with
        ((t - INR k * (sign * step)) + - (t - INR j * (sign * step))) by ring.
      eapply Rle_lt_trans; [apply Rabs_triang|].
      rewrite Rabs_Ropp; lra. }
    apply Rabs_lt_between in gap.
    assert (near : INR j < INR k + 2 /\ INR k < INR j + 2) by nra.
    destruct near as (one & two).
    change 2 with (INR 2) in one, two.
    rewrite <- plus_INR in one, two.
    apply INR_lt in one, two.
    lia. }
  destruct cases as [-> | [-> | ->]]; intros i hi; [reflexivity| |]; rewrite S_INR in *.
  - rewrite (overlap k) by auto.
    f_equal; ring.
  - rewrite (overlap j) by auto.
    f_equal; ring.
Qed.

Lemma glued_start : same (glued 0) start.
Proof.
  assert (positive := step_positive).
  intros i hi.
  rewrite (glued_series 0 0); auto; cbn [INR node].
  - rewrite Rmult_0_l, Rminus_0_r.
    apply series_start.
  - rewrite Rmult_0_r; lra.
  - rewrite Rmult_0_l, Rminus_0_r, Rabs_R0; exact positive.
Qed.

Lemma glued_solves t : - step < sign * t -> solves glued t.
Proof.
  intros later.
  assert (positive := step_positive).
  assert (own := steps_before_spec t later).
  set (k := steps_before t) in *.
  set (d := Rmin (sign * t + step) (step - Rabs (t - INR k * (sign * step)))).
  assert (d1 : d <= sign * t + step) by apply Rmin_l.
  assert (d2 : d <= step - Rabs (t - INR k * (sign * step))) by apply Rmin_r.
  assert (d_positive : 0 < d) by (unfold d; apply Rmin_glb_lt; lra).
  clearbody d.
  apply (solves_local (fun x => series terms (node k) (x + - (INR k * (sign * step)))) glued t d d_positive).
  - intros s close i hi.
    symmetry.
    apply glued_series; auto.
    + assert (moved := sign_size (s - t)).
      assert (low := Rle_refl (Rabs (sign * (s - t)))).
      apply Rabs_le_between in low.
      lra.
    + replace (s - INR k * (sign * step)) with ((s - t) + (t - INR k * (sign * step))) by ring.
      eapply Rle_lt_trans; [apply Rabs_triang|].
      lra.
  - apply solves_shift, node_solves.
    change (Rabs (t - INR k * (sign * step)) < 2 * step).
    lra.
Qed.
End Direction.

Definition flow t := if Rle_dec 0 t then glued 1 t else glued (-1) t.

Lemma flow_start : same (flow 0) start.
Proof.
  unfold flow.
  destruct (Rle_dec 0 0) as [_|impossible]; [apply glued_start; ring | lra].
Qed.

Theorem flow_solves t : solves flow t.
Proof.
  assert (positive := step_positive).
  assert (plus : 1 * 1 = 1) by ring.
  assert (minus : -1 * -1 = 1) by ring.
  destruct (Rlt_dec t 0) as [past|later].
  - apply (solves_local (glued (-1)) _ t (- t)); [lra| |].
    + intros s close i hi.
      apply Rabs_lt_between in close.
      unfold flow.
      destruct (Rle_dec 0 s); [lra | reflexivity].
    + apply glued_solves; auto; lra.
  - apply (solves_local (glued 1) _ t step positive).
    + intros s close i hi.
      apply Rabs_lt_between in close.
      unfold flow.
      destruct (Rle_dec 0 s) as [_|negative]; [reflexivity|].
      apply (solutions_unique (glued 1) (glued (-1)) s 0 0); auto; try lra.
      * intros x hx.
        apply glued_solves; auto; lra.
      * intros x hx.
        apply glued_solves; auto; lra.
      * intros j hj.
        rewrite (glued_start 1 plus j hj), (glued_start (-1) minus j hj).
        reflexivity.
    + apply glued_solves; auto; lra.
Qed.
End Start.

(* Exactly one solution for all time through each state; equality is that of the n unknowns. *)
Definition one_flow := forall start, exists c, same (c 0) start /\ (forall t, solves c t) /\
  forall c' s, same (c' s) (c s) -> (forall t, solves c' t) -> forall t, same (c' t) (c t).

Lemma bounded_flow : one_flow.
Proof.
  intros start.
  exists (flow start).
  refine (conj (flow_start start) (conj (flow_solves start) _)).
  intros c' s meet solution t.
  assert (le1 := Rmin_l s t).
  assert (le2 := Rmin_r s t).
  assert (le3 := Rmax_l s t).
  assert (le4 := Rmax_r s t).
  apply (solutions_unique c' (flow start) (Rmin s t) (Rmax s t) s); auto; try lra.
  - intros x _; apply solution.
  - intros x _; apply flow_solves.
Qed.
End System.

Theorem quadratic_flow n terms size : (forall i, (i < n)%nat -> within n (terms i)) ->
  (forall x i, (i < n)%nat -> Rabs (x i) <= size x) -> (forall x y, same n x y -> size x = size y) ->
  (forall c a b, solves_on n terms c a b -> forall s t, a <= s <= b -> a <= t <= b -> size (c s) = size (c t)) ->
  one_flow n terms.
Proof.
  intros closed bounds same_size conserved.
  set (m := total n (fun i => weight (terms i)) + 1).
  assert (positive : 0 <= total n (fun i => weight (terms i))) by (apply total_positive; intros; apply weight_positive).
  apply (bounded_flow n terms closed m) with (size := size); auto; [|unfold m; lra].
  intros i hi.
  assert (part := total_ge_term n (fun i => weight (terms i)) i (fun j _ => weight_positive (terms j)) hi).
  unfold m; cbn beta in part; lra.
Qed.

(* Where the field is tangent to spheres, the length of the state is such a bound. *)
Theorem sphere_flow n terms : (forall i, (i < n)%nat -> within n (terms i)) ->
  (forall x, total n (fun i => x i * evaluate (terms i) x) = 0) -> one_flow n terms.
Proof.
  intros closed tangent.
  set (length := fun x : nat -> R => sqrt (total n (fun i => x i * x i))).
  apply (quadratic_flow n terms length closed).
  - intros x i hi.
    rewrite <- sqrt_Rsqr_abs.
    apply sqrt_le_1_alt.
    exact (total_ge_term n (fun i => x i * x i) i (fun j _ => Rle_0_sqr (x j)) hi).
  - intros x y equal.
    unfold length.
    f_equal.
    apply total_ext.
    intros i hi.
    now rewrite (equal i hi).
  - intros c a b solution.
    assert (constant : forall t, a <= t <= b -> total n (fun i => c t i * c t i) = total n (fun i => c a i * c a i)).
    { apply (const_of_derive (fun t => total n (fun i => c t i * c t i))).
      intros t ht.
      replace 0 with (total n (fun i => evaluate (terms i) (c t) * c t i + c t i * evaluate (terms i) (c t))).
      - apply (total_derive n (fun t i => c t i * c t i)).
        intros i hi.
        assert (d := solution t ht i hi).
        exact (is_derive_mult (fun x => c x i) (fun x => c x i) t _ _ d d Rmult_comm).
      - rewrite (total_ext n _ (fun i => 2 * (c t i * evaluate (terms i) (c t)))) by (intros; ring).
        rewrite total_scal, tangent; ring. }
    intros s t hs ht.
    unfold length.
    now rewrite (constant s hs), (constant t ht).
Qed.
