(** * The period of one motion as a number: I = (1, 2, 3), L(0) = (3/10, 2/10, 1)

    PeriodOfMotion.v says that this motion has the least period 4 K(m)/nu; interval/Period.v encloses that number.
    Together: the motion exists, is the only one, and returns first after a time within 1e-16 of the decimals below, for
    the decimal state and for the binary64 state next to it.  Kept apart from the other files since the quadrature takes
    ten seconds and uses the kernel's machine integers. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Vec3 Calculus Euler Stability GlobalSolution ClosedOrbits PeriodOfMotion.
From Polhode.interval Require Import Period.
Local Open Scope R_scope.

Lemma periods_equal I1 I2 I3 u : I1 <> 0 -> I2 <> 0 -> I3 <> 0 ->
  PeriodOfMotion.period I1 I2 I3 (double_energy I1 I2 I3 u) (norm_squared u) = period I1 I2 I3 (X u) (Y u) (Z u).
Proof.
  intros h1 h2 h3.
  assert (energy_equal : double_energy I1 I2 I3 u = twice_energy I1 I2 I3 (X u) (Y u) (Z u)).
  { unfold double_energy, twice_energy.
    field; auto. }
  assert (norm_equal : norm_squared u = squared_momentum (X u) (Y u) (Z u)).
  { unfold norm_squared, dot, squared_momentum.
    ring. }
  unfold PeriodOfMotion.period, angular_rate, elliptic_m, complete_K, period, parameter, squared_rate.
  rewrite energy_equal, norm_equal, (Rmult_comm I1), (Rmult_comm I3).
  erewrite RInt_ext; [reflexivity|].
  intros x _.
  unfold Rdiv.
  rewrite Rmult_1_l.
  do 3 f_equal.
  cbn [pow]; ring.
Qed.

(* The state (a, b, 1) of the body with moments 1, 2, 3, inside the separatrix about axis 3. *)
Lemma motion_with_period a b decimal : a <> 0 -> a * a < / 3 -> Rabs (period 1 2 3 a b 1 - decimal) <= 1 / 10 ^ 16 ->
  exists T, Rabs (T - decimal) <= 1 / 10 ^ 16 /\
  exists! L : R -> V, L 0 = mk a b 1 /\ motion 1 2 3 L /\ closed_orbit L T half_turn3.
Proof.
  intros moving inside enclosure.
  exists (period 1 2 3 a b 1).
  split; [exact enclosure|].
  destruct (motion_exists_unique 1 2 3 ltac:(lra) ltac:(lra) ltac:(lra) (mk a b 1))
    as (L & (first & solution) & unique).
  exists L.
  refine (conj (conj first (conj solution _)) _).
  - assert (orbit := circles_axis3 1 2 3 ltac:(lra) ltac:(lra) ltac:(lra) L solution).
    rewrite first, periods_equal in orbit by lra.
    apply orbit.
    + lra.
    + unfold double_energy, norm_squared, dot; cbn [X Y Z].
      lra.
    + cbn [X Y].
      tauto.
  - intros L' (first' & solution' & _).
    apply unique; auto.
Qed.

Theorem example_period : exists T, Rabs (T - 20.2049347380819979889700509566080377946) <= 1 / 10 ^ 16 /\
  exists! L : R -> V, L 0 = mk (3 / 10) (2 / 10) 1 /\ motion 1 2 3 L /\ closed_orbit L T half_turn3.
Proof.
  apply motion_with_period; [lra | lra | exact decimal_period].
Qed.

Theorem example_period_binary : exists T, Rabs (T - 20.2049347380819978396) <= 1 / 10 ^ 16 /\
  exists! L : R -> V, L 0 = mk three_tenths two_tenths 1 /\ motion 1 2 3 L /\ closed_orbit L T half_turn3.
Proof.
  apply motion_with_period; [unfold three_tenths; lra | unfold three_tenths; lra | exact binary_period].
Qed.
