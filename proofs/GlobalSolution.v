(* (8) Euler's equations: exactly one solution for all time through every initial value.

   The power series of PowerSeriesSolution.v converges for |t| < 2 step, where step depends on |L| alone.  As |L| is
   constant along solutions, the same step serves again at the end of each step: node k is the state after k steps,
   and the series about two neighbouring nodes agree where both converge (Uniqueness.v).  Times before 0 come from
   reversal, which changes the signs of p, q, r.  So Stability.v speaks about solutions that exist, for all time.
   Source: Hartman, Ordinary Differential Equations, chapter II (continuation); Arnold, Mathematical Methods, 29. *)
From Coq Require Import Reals Lra Psatz Lia FunctionalExtensionality.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Vec3 Calculus Euler Stability Uniqueness PowerSeriesSolution.
Local Open Scope R_scope.

Definition unit_rate (t : R) := 1.
Definition solves_at p q r (c : R -> V) t := vderive c t (triple p q r (c t)).

Lemma driven_of_solves p q r c a b : (forall t, a <= t <= b -> solves_at p q r c t) -> driven p q r unit_rate c a b.
Proof.
  intros solution t ht.
  replace (Vec3.scal (unit_rate t) (triple p q r (c t))) with (triple p q r (c t)) by (unfold unit_rate, triple; vring).
  now apply solution.
Qed.

Lemma solves_unique p q r c c' a b s : p + q + r = 0 -> (forall t, a <= t <= b -> solves_at p q r c t) ->
  (forall t, a <= t <= b -> solves_at p q r c' t) -> a <= s <= b -> c s = c' s -> forall t, a <= t <= b -> c t = c' t.
Proof.
  intros balanced solution solution' hs start.
  apply (driven_unique p q r balanced unit_rate 1 c c' a b s); auto using driven_of_solves.
  intros t _.
  unfold unit_rate.
  rewrite Rabs_R1; lra.
Qed.

(* A change of time t -> k t + s of a curve. *)
Lemma vderive_affine c k s t v : vderive c (k * t + s) v -> vderive (fun x => c (k * x + s)) t (Vec3.scal k v).
Proof.
  assert (inner : is_derive (fun x => k * x + s) t k) by (auto_derive; auto; ring).
  intros (x & y & z).
  refine (conj _ (conj _ _)); cbn [X Y Z Vec3.scal].
  - exact (is_derive_comp (fun u => X (c u)) (fun x => k * x + s) t _ _ x inner).
  - exact (is_derive_comp (fun u => Y (c u)) (fun x => k * x + s) t _ _ y inner).
  - exact (is_derive_comp (fun u => Z (c u)) (fun x => k * x + s) t _ _ z inner).
Qed.

Lemma solves_shift p q r c s t : solves_at p q r c (t + s) -> solves_at p q r (fun x => c (x + s)) t.
Proof.
  unfold solves_at; intros solution.
  apply (vderive_ext (fun x => c (1 * x + s))); [intros; f_equal; ring|].
  replace (triple p q r (c (t + s))) with (Vec3.scal 1 (triple p q r (c (t + s)))) by (unfold triple; vring).
  apply vderive_affine.
  now rewrite Rmult_1_l.
Qed.

Lemma solves_reversed p q r c t : solves_at (- p) (- q) (- r) c (- t) -> solves_at p q r (fun x => c (- x)) t.
Proof.
  unfold solves_at; intros solution.
  apply (vderive_ext (fun x => c (-1 * x + 0))); [intros; f_equal; ring|].
  replace (triple p q r (c (- t))) with (Vec3.scal (-1) (triple (- p) (- q) (- r) (c (- t)))) by (unfold triple; vring).
  apply vderive_affine.
  now replace (-1 * t + 0) with (- t) by ring.
Qed.

(* The equations hold at t for a curve that agrees with a solution near t. *)
Lemma solves_local p q r c c' t d : 0 < d -> (forall s, Rabs (s - t) < d -> c s = c' s) ->
  solves_at p q r c t -> solves_at p q r c' t.
Proof.
  intros positive agree.
  assert (near : forall f : V -> R, locally t (fun s => f (c s) = f (c' s))).
  { intros f.
    exists (mkposreal d positive).
    intros s inside.
    now rewrite (agree s inside). }
  unfold solves_at.
  rewrite (agree t) by (rewrite Rminus_eq_0, Rabs_R0; exact positive).
  intros (x & y & z).
  refine (conj _ (conj _ _)); [revert x | revert y | revert z]; apply is_derive_ext_loc.
  - exact (near X).
  - exact (near Y).
  - exact (near Z).
Qed.

Section Forward.
Variables p q r : R.
Hypothesis balanced : p + q + r = 0.
Variable start : V.

Definition coefficient_size := Rabs p + Rabs q + Rabs r + 1.
Definition state_size := sqrt (nrm2 start) + 1.
Definition step := / (2 * (coefficient_size * state_size)).

Lemma sizes_positive : 0 < coefficient_size * state_size.
Proof.
  assert (ap := Rabs_pos p).
  assert (aq := Rabs_pos q).
  assert (ar := Rabs_pos r).
  assert (root := sqrt_pos (nrm2 start)).
  unfold coefficient_size, state_size.
  apply Rmult_lt_0_compat; lra.
Qed.

Lemma step_positive : 0 < step.
Proof. assert (positive := sizes_positive). unfold step. apply Rinv_0_lt_compat; lra. Qed.

(* The series about any state of the same size converges for two steps. *)
Lemma series_two_steps u t : nrm2 u = nrm2 start -> Rabs t < 2 * step -> solves_at p q r (series p q r u) t.
Proof.
  intros size inside.
  assert (positive := sizes_positive).
  assert (root := sqrt_pos (nrm2 start)).
  assert (square := sqrt_sqrt (nrm2 start) (nrm2_ge0 start)).
  assert (components := component_bound u state_size).
  assert (ap := Rabs_pos p).
  assert (aq := Rabs_pos q).
  assert (ar := Rabs_pos r).
  destruct components as (hx & hy & hz).
  { unfold state_size; lra. }
  { rewrite size; unfold state_size; nra. }
  apply (series_solves p q r u coefficient_size state_size); auto; unfold coefficient_size; try lra.
  - unfold state_size; lra.
  - fold coefficient_size.
    enough (twice : / (coefficient_size * state_size) = 2 * step) by (rewrite twice; exact inside).
    unfold step.
    generalize (coefficient_size * state_size), positive.
    intros size' positive'.
    field; lra.
Qed.

Fixpoint node k := match k with 0%nat => start | S j => series p q r (node j) step end.

Lemma node_size k : nrm2 (node k) = nrm2 start.
Proof.
  assert (positive := step_positive).
  induction k as [|k hypothesis]; [reflexivity|].
  cbn [node].
  rewrite <- hypothesis.
  rewrite <- (series_start p q r (node k)) at 2.
  apply (driven_norm p q r balanced unit_rate (series p q r (node k)) 0 step); try lra.
  apply driven_of_solves.
  intros t ht.
  apply series_two_steps; auto.
  apply Rabs_def1; lra.
Qed.

Lemma node_solves k t : Rabs t < 2 * step -> solves_at p q r (series p q r (node k)) t.
Proof. apply series_two_steps, node_size. Qed.

(* The series about neighbouring nodes agree. *)
Lemma overlap k t : Rabs t < step -> series p q r (node (S k)) t = series p q r (node k) (t + step).
Proof.
  intros inside.
  assert (positive := step_positive).
  assert (ends := inside).
  apply Rabs_lt_between in ends.
  set (a := Rabs t) in *.
  assert (a_positive : 0 <= a) by apply Rabs_pos.
  assert (between : - a <= t <= a) by (apply Rabs_le_between, Rle_refl).
  apply (solves_unique p q r _ (fun x => series p q r (node k) (x + step)) (- a) a 0 balanced); auto; try lra.
  - intros x hx.
    apply node_solves, Rabs_def1; lra.
  - intros x hx.
    apply solves_shift, node_solves, Rabs_def1; lra.
  - now rewrite series_start, Rplus_0_l.
Qed.

(* The number of whole steps before time t, and the solution for t > - step. *)
Definition steps_before t := Z.to_nat (Int_part (t / step)).
Definition forward t := series p q r (node (steps_before t)) (t - INR (steps_before t) * step).

Lemma steps_before_spec t : - step < t -> - step < t - INR (steps_before t) * step < step.
Proof.
  intros later.
  assert (positive := step_positive).
  destruct (base_Int_part (t / step)) as (below & above).
  assert (value : t = t / step * step) by (field; lra).
  unfold steps_before.
  set (n := Int_part (t / step)) in *.
  destruct (Z_le_gt_dec 0 n) as [natural|negative].
  - rewrite INR_IZR_INZ, Znat.Z2Nat.id by auto.
    nra.
  - replace (Z.to_nat n) with 0%nat by lia.
    assert (IZR n <= -1) by (apply IZR_le; lia).
    cbn [INR].
    nra.
Qed.

Lemma forward_series k t : - step < t -> Rabs (t - INR k * step) < step ->
  forward t = series p q r (node k) (t - INR k * step).
Proof.
  intros later close.
  assert (positive := step_positive).
  assert (own := steps_before_spec t later).
  unfold forward.
  set (j := steps_before t) in *.
  apply Rabs_lt_between in close.
  assert (near : INR j < INR k + 2 /\ INR k < INR j + 2) by nra.
  assert (cases : j = k \/ j = S k \/ k = S j).
  { destruct near as (one & two).
    change 2 with (INR 2) in one, two.
    rewrite <- plus_INR in one, two.
    apply INR_lt in one, two.
    lia. }
  destruct cases as [-> | [-> | ->]]; [reflexivity| |].
  - rewrite S_INR in *.
    rewrite overlap by (apply Rabs_def1; lra).
    f_equal; ring.
  - rewrite S_INR in *.
    rewrite overlap by (apply Rabs_def1; lra).
    f_equal; ring.
Qed.

Lemma forward_start : forward 0 = start.
Proof.
  assert (positive := step_positive).
  rewrite (forward_series 0 0); cbn [INR node]; try lra.
  - rewrite Rmult_0_l, Rminus_0_r.
    apply series_start.
  - rewrite Rmult_0_l, Rminus_0_r, Rabs_R0; lra.
Qed.

Lemma forward_solves t : - step < t -> solves_at p q r forward t.
Proof.
  intros later.
  assert (positive := step_positive).
  assert (own := steps_before_spec t later).
  set (k := steps_before t) in *.
  set (d := Rmin (t + step) (Rmin (step - (t - INR k * step)) (step + (t - INR k * step)))).
  assert (d_positive : 0 < d) by (unfold d; repeat apply Rmin_glb_lt; lra).
  assert (d1 : d <= t + step) by apply Rmin_l.
  assert (d2 : d <= step - (t - INR k * step)) by (eapply Rle_trans; [apply Rmin_r | apply Rmin_l]).
  assert (d3 : d <= step + (t - INR k * step)) by (eapply Rle_trans; [apply Rmin_r | apply Rmin_r]).
  clearbody d.
  apply (solves_local p q r (fun x => series p q r (node k) (x + - (INR k * step))) forward t d d_positive).
  - intros s close.
    apply Rabs_lt_between in close.
    symmetry.
    apply forward_series; [lra|].
    apply Rabs_def1; lra.
  - apply solves_shift, node_solves, Rabs_def1; lra.
Qed.
End Forward.

(* The flow for all time, forward and backward. *)
Definition flow p q r start t :=
  if Rle_dec 0 t then forward p q r start t else forward (- p) (- q) (- r) start (- t).

Section Flow.
Variables p q r : R.
Hypothesis balanced : p + q + r = 0.
Variable start : V.

Lemma flow_start : flow p q r start 0 = start.
Proof.
  unfold flow.
  destruct (Rle_dec 0 0) as [_|impossible]; [now apply forward_start | lra].
Qed.

Lemma backward_solves t : t < step (- p) (- q) (- r) start ->
  solves_at p q r (fun x => forward (- p) (- q) (- r) start (- x)) t.
Proof.
  intros earlier.
  apply solves_reversed, forward_solves; lra.
Qed.

Theorem flow_solves t : solves_at p q r (flow p q r start) t.
Proof.
  assert (reversed_balanced : - p + - q + - r = 0) by lra.
  set (d := Rmin (step p q r start) (step (- p) (- q) (- r) start)).
  assert (d1 : d <= step p q r start) by apply Rmin_l.
  assert (d2 : d <= step (- p) (- q) (- r) start) by apply Rmin_r.
  assert (d_positive : 0 < d) by (unfold d; apply Rmin_glb_lt; apply step_positive).
  clearbody d.
  destruct (Rlt_dec t 0) as [past|later].
  - apply (solves_local p q r (fun x => forward (- p) (- q) (- r) start (- x)) _ t (- t)); [lra| |].
    + intros s close.
      apply Rabs_lt_between in close.
      unfold flow.
      destruct (Rle_dec 0 s); [lra | reflexivity].
    + apply backward_solves; lra.
  - apply (solves_local p q r (forward p q r start) _ t d d_positive).
    + intros s close.
      apply Rabs_lt_between in close.
      unfold flow.
      destruct (Rle_dec 0 s) as [_|negative]; [reflexivity|].
      apply (solves_unique p q r _ (fun x => forward (- p) (- q) (- r) start (- x)) s 0 0 balanced); try lra.
      * intros x hx.
        apply forward_solves; auto; lra.
      * intros x hx.
        apply backward_solves; lra.
      * now rewrite Ropp_0, !forward_start.
    + apply forward_solves; auto; lra.
Qed.
End Flow.

Section Body.
Variables I1 I2 I3 : R.
Hypotheses (p1 : 0 < I1) (p2 : 0 < I2) (p3 : 0 < I3).

Definition rate1 := 1 / I3 - 1 / I2.
Definition rate2 := 1 / I1 - 1 / I3.
Definition rate3 := 1 / I2 - 1 / I1.

Lemma rates_balanced : rate1 + rate2 + rate3 = 0.
Proof. unfold rate1, rate2, rate3; ring. Qed.

(* A motion: a curve that obeys Euler's equations at every time, past and future. *)
Definition motion (L : R -> V) := forall t, vderive L t (eul I1 I2 I3 (L t)).

Lemma eul_triple L : eul I1 I2 I3 L = triple rate1 rate2 rate3 L.
Proof. exact (eul_components I1 I2 I3 p1 p2 p3 L). Qed.

Lemma solves_of_motion L t : vderive L t (eul I1 I2 I3 (L t)) <-> solves_at rate1 rate2 rate3 L t.
Proof. unfold solves_at. rewrite eul_triple; tauto. Qed.

(* One value, at any time, determines a motion. *)
Theorem motion_determined L L' s : motion L -> motion L' -> L s = L' s -> forall t, L t = L' t.
Proof.
  intros solution solution' equal t.
  assert (le1 := Rmin_l s t).
  assert (le2 := Rmin_r s t).
  assert (le3 := Rmax_l s t).
  assert (le4 := Rmax_r s t).
  apply (solves_unique rate1 rate2 rate3 L L' (Rmin s t) (Rmax s t) s rates_balanced); auto; try lra;
    intros x _; now apply solves_of_motion.
Qed.

Theorem motion_exists_unique start : exists! L : R -> V, L 0 = start /\ motion L.
Proof.
  exists (flow rate1 rate2 rate3 start).
  assert (first := flow_start rate1 rate2 rate3 rates_balanced start).
  assert (solution : motion (flow rate1 rate2 rate3 start)).
  { intros t.
    apply solves_of_motion, flow_solves, rates_balanced. }
  refine (conj (conj first solution) _).
  intros L (first' & solution').
  apply functional_extensionality.
  apply (motion_determined _ _ 0 solution solution').
  now rewrite first, first'.
Qed.

(* A solution on [0, T], the notion of Stability.v, is a piece of exactly one motion. *)
Theorem sol_extends c T : 0 <= T -> sol I1 I2 I3 c T ->
  exists! L : R -> V, motion L /\ forall t, 0 <= t <= T -> c t = L t.
Proof.
  intros order solution.
  destruct (motion_exists_unique (c 0)) as (L & (first & whole) & unique).
  exists L.
  split.
  - refine (conj whole _).
    apply (solves_unique rate1 rate2 rate3 c L 0 T 0 rates_balanced); auto; try lra.
    + intros t ht.
      now apply solves_of_motion, solution.
    + intros t _.
      now apply solves_of_motion.
  - intros L' (whole' & agree).
    apply unique.
    refine (conj _ whole').
    symmetry; apply agree; lra.
Qed.
End Body.
