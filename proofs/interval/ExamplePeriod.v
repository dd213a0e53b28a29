(** * The period of one motion as a number: I = (1, 2, 3), L(0) = (3/10, 2/10, 1)

    PeriodOfMotion.v says that this motion has the least period 4 K(m)/nu with m = 30/103 and nu^2 = 103/900;
    interval/Period.v encloses that number.  Together: the motion exists, is the only one, and returns first after
    a time within 1e-16 of the decimal below.  Kept apart from the other files since the quadrature takes 10 s and
    uses the kernel's machine integers. *)
From Coq Require Import Reals Lra.
From Coquelicot Require Import Coquelicot.
From Polhode Require Import Vec3 Calculus Euler Stability GlobalSolution ClosedOrbits PeriodOfMotion.
From Polhode.interval Require Import Period.
Local Open Scope R_scope.

Definition example_start := mk (3 / 10) (2 / 10) 1.

Theorem example_period : exists T, Rabs (T - 20.20493473808199798897) <= 1 / 10 ^ 16 /\
  exists! L : R -> V, L 0 = example_start /\ motion 1 2 3 L /\ closed_orbit L T half_turn3.
Proof.
  set (E := energy 1 2 3 example_start).
  set (G := nrm2 example_start).
  assert (E_value : E = 133 / 300) by (unfold E, energy, example_start; cbn [X Y Z]; field).
  assert (G_value : G = 113 / 100) by (unfold G, nrm2, dot, example_start; cbn [X Y Z]; field).
  exists (period 1 2 3 E G).
  split.
  - assert (enclosure := T_encl).
    cbv zeta in enclosure.
    unfold period, angular_rate, elliptic_m, complete_K.
    rewrite E_value, G_value.
    replace ((2 - 1) * (3 * (133 / 300) - 113 / 100) / ((3 - 2) * (113 / 100 - 1 * (133 / 300)))) with (30 / 103)
      by field.
    replace ((3 - 2) * (113 / 100 - 1 * (133 / 300)) / (1 * 2 * 3)) with (103 / 900) by field.
    erewrite (RInt_ext (fun x => / sqrt (1 - 30 / 103 * (sin x * sin x)))); [exact enclosure|].
    intros x _.
    unfold Rdiv.
    rewrite Rmult_1_l.
    do 3 f_equal.
    cbn [pow]; ring.
  - destruct (motion_exists_unique 1 2 3 ltac:(lra) ltac:(lra) ltac:(lra) example_start)
      as (L & (first & solution) & unique).
    exists L.
    refine (conj (conj first (conj solution _)) _).
    + assert (orbit := circles_axis3 1 2 3 ltac:(lra) ltac:(lra) ltac:(lra) L solution).
      rewrite first in orbit.
      fold E G in orbit.
      apply orbit.
      * lra.
      * rewrite E_value, G_value; lra.
      * unfold example_start; cbn [X Y]; lra.
    + intros L' (first' & solution' & _).
      apply unique; auto.
Qed.
