/* SPDX-License-Identifier: MIT
   Copyright (c) 2026 The polhode developers; the licence is the file LICENSE of the repository.

   How rigid bodies rotate, exactly at any time: the free body and the Lagrange top. C99 and C++, <math.h> alone, no malloc.

   Conventions are those of docs/conventions.md: quaternions (w, x, y, z) take body to space, momentum and moments are along
   the principal axes, everything is in SI units. The method and its sources are told in README.md beside this file.

       polhode_free_body body;
       double moments[3] = {1, 2, 3}, momentum[3] = {0.3, 1.8, 1.5}, q[4], L[3];
       int error = polhode_free_body_init(&body, moments, momentum, NULL, 0);
       if (!error) error = polhode_free_body_state(&body, 10, q, L);
       if (error) puts(polhode_error(error));

   Compile without -ffast-math, and with -ffp-contract=off where the compiler would fuse products and sums (GCC does in its
   gnu modes): phases are kept in pairs of doubles, whose errors are computed exactly. _init checks that they are.

   What begins with polhode_ is for you; what begins with phd_ is printed from the formulas of polhode in Python by
   `python -m printing` in reference/: change those in src/polhode/exact, or printing/polhode.in.h, and print again. */
#ifndef POLHODE_H
#define POLHODE_H

#define POLHODE_VERSION "@version@"

#include <math.h>

#if defined(__FAST_MATH__)
#error "polhode.h needs exact rounding: compile without -ffast-math"
#endif
#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__
#error "polhode.h checks for numbers that are not finite: compile without -ffinite-math-only"
#endif
#if defined(__FLT_EVAL_METHOD__) && (__FLT_EVAL_METHOD__ == 2 || __FLT_EVAL_METHOD__ == -1)
#error "polhode.h needs doubles computed as doubles: compile with -mfpmath=sse"
#endif
#if defined(__clang__)
#pragma STDC FP_CONTRACT OFF
#endif

enum {
    POLHODE_OK = 0,
    POLHODE_BAD_MOMENTS,
    POLHODE_BAD_MOMENTUM,
    POLHODE_BAD_ATTITUDE,
    POLHODE_BAD_EPOCH,
    POLHODE_BAD_MGL,
    POLHODE_BAD_TIME,
    POLHODE_OUT_OF_RANGE,
    POLHODE_BAD_ARITHMETIC
};

/* Returns what an error code means and what to do. */
static inline const char *polhode_error(int code)
{
    switch (code) {
    case POLHODE_OK: return "no error";
    case POLHODE_BAD_MOMENTS:
        return "moments must be three positive finite numbers [kg m2]; of a top the first two must be equal";
    case POLHODE_BAD_MOMENTUM: return "momentum must be three finite numbers [kg m2/s]";
    case POLHODE_BAD_ATTITUDE: return "attitude must be a unit quaternion, scalar first: divide it by its norm";
    case POLHODE_BAD_EPOCH: return "epoch must be a finite number [s]";
    case POLHODE_BAD_MGL: return "mgl must be a finite number [N m]";
    case POLHODE_BAD_TIME: return "time must be finite, and since the epoch, times the rate of rotation, at most 1e27 rad";
    case POLHODE_OUT_OF_RANGE: return "moments, momentum or their ratios leave the range of doubles: choose other units";
    case POLHODE_BAD_ARITHMETIC: return "sums and products are fused or reordered: compile with -ffp-contract=off";
    default: return "no such error code";
    }
}

/* ---------------------------------------------------------------- words of the formulas that <math.h> has not */

static inline double phd_larger(double x, double y) { return x > y ? x : y; }
static inline double phd_smaller(double x, double y) { return x < y ? x : y; }
static inline double phd_times_power(double x, double n) { return ldexp(x, (int)n); }

static inline double phd_binary_exponent(double x)
{
    int exponent;
    (void)frexp(x, &exponent);
    return exponent;
}

/* ---------------------------------------------------------------- formulas of both motions */

@both@
/* ---------------------------------------------------------------- exact sums, words of the formulas too */

/* An unevaluated sum of floats, exact. Shewchuk 1997. */
typedef struct { int count; double term[64]; } phd_sum;

static inline phd_sum phd_as_sum(phd_pair x)
{
    phd_sum s;
    s.count = 2;
    s.term[0] = x.hi;
    s.term[1] = x.lo;
    return s;
}

static inline phd_sum phd_join(phd_sum x, phd_sum y)
{
    for (int k = 0; k < y.count; k++) x.term[x.count++] = y.term[k];
    return x;
}

static inline phd_sum phd_negated(phd_sum x)
{
    for (int k = 0; k < x.count; k++) x.term[k] = -x.term[k];
    return x;
}

static inline phd_sum phd_multiply_terms(phd_sum x, double factor)
{
    phd_sum s;
    s.count = 0;
    for (int k = 0; k < x.count; k++) {
        const phd_pair p = phd_two_product(x.term[k], factor);
        s.term[s.count++] = p.hi;
        s.term[s.count++] = p.lo;
    }
    return s;
}

/* Moves the leading parts to the end; the sum stays exactly what it was. Ogita, Rump & Oishi 2005. */
static inline phd_sum phd_swept(phd_sum x, int times)
{
    while (times-- > 0) {
        for (int k = 1; k < x.count; k++) {
            const phd_pair s = phd_two_sum(x.term[k - 1], x.term[k]);
            x.term[k - 1] = s.lo;
            x.term[k] = s.hi;
        }
    }
    return x;
}

/* The sum as one of `count` terms at most, largest last, correct to 2^(-53 count) of its size. */
static inline phd_sum phd_compress(phd_sum x, int count)
{
    const int more = x.count - count;
    if (more <= 0) return x;
    x = phd_swept(x, count + 1);
    for (int k = 0; k < count; k++) x.term[k] = x.term[more + k];
    x.count = count;
    return x;
}

/* The sum to double-double accuracy, whatever cancels, up to 2^-265. */
static inline phd_pair phd_distil(phd_sum x)
{
    double rest;
    x = phd_swept(x, 5);
    rest = x.term[0];
    for (int k = 1; k < x.count - 1; k++) rest += x.term[k];
    return phd_two_sum(x.term[x.count - 1], rest);
}

/* ---------------------------------------------------------------- what both motions are made of */

static inline int phd_arithmetic_is_exact(void)
{
    volatile double a = 1.0 + 1.0 / 1073741824.0, big = 1e16, small = 0.1, third = 1.0 / 3.0;
    const phd_pair product = phd_two_product(a, a), sum = phd_two_sum(big, small), halves = phd_halves(third);
    return product.lo == 1.0 / 1152921504606846976.0 && sum.hi == 1e16 && sum.lo == small
        && halves.hi * 67108864.0 == floor(halves.hi * 67108864.0 * 4.0) / 4.0 && fabs(halves.lo) < 1e-8;
}

static inline int phd_are_finite(const double *values, int count)
{
    for (int k = 0; k < count; k++) if (!isfinite(values[k])) return 0;
    return 1;
}

static inline double phd_length(const double *values, int count)
{
    double sum = 0.0;
    for (int k = 0; k < count; k++) sum += values[k] * values[k];
    return sqrt(sum);
}

/* Returns the first error in what both motions are made of. */
static inline int phd_check(const double moments[3], const double momentum[3], const double attitude[4], double epoch)
{
    if (!phd_arithmetic_is_exact()) return POLHODE_BAD_ARITHMETIC;
    for (int k = 0; k < 3; k++) if (!(moments[k] > 0.0 && isfinite(moments[k]))) return POLHODE_BAD_MOMENTS;
    if (!phd_are_finite(momentum, 3)) return POLHODE_BAD_MOMENTUM;
    if (attitude && !(fabs(phd_length(attitude, 4) - 1.0) < 1e-6)) return POLHODE_BAD_ATTITUDE;
    return isfinite(epoch) ? POLHODE_OK : POLHODE_BAD_EPOCH;
}

static inline double phd_fastest(const double moments[3], const double momentum[3])
{
    double fastest = 0.0;
    for (int k = 0; k < 3; k++) fastest = phd_larger(fastest, fabs(momentum[k] / moments[k]));
    return fastest;
}

static inline double phd_kinetic_energy(const double moments[3], const double momentum[3])
{
    double sum = 0.0;
    for (int k = 0; k < 3; k++) sum += momentum[k] / moments[k] * momentum[k];
    return 0.5 * sum;
}

/* Gives the time since the epoch, exactly, in two doubles; refuses times whose phases have hardly a digit left. */
static inline int phd_since(double t, double epoch, double fastest, phd_pair *elapsed)
{
    *elapsed = phd_two_sum(t, -epoch);
    return fabs(elapsed->hi) * fastest <= 1e27 ? POLHODE_OK : POLHODE_BAD_TIME;
}

/* ---------------------------------------------------------------- formulas of the free body */

@free_body@
/* ---------------------------------------------------------------- the free body */

typedef enum {
    POLHODE_REST,
    POLHODE_SPHERICAL,
    POLHODE_PERMANENT,
    POLHODE_SYMMETRIC,
    POLHODE_SHORT_AXIS,
    POLHODE_LONG_AXIS,
    POLHODE_SEPARATRIX
} polhode_regime;

typedef struct {
    /* what the motion means: what is infinite is INFINITY, what is undefined NAN, and -1 of the axis */
    polhode_regime regime;
    int encircled_axis;           /* index of the axis that the polhode goes round */
    double energy, momentum_norm; /* [J], [kg m2/s] */
    double modulus;
    double period;                /* [s] after which the momentum is back along the body's axes */
    double precession_rate;       /* mean rate at which the encircled axis turns about the momentum [rad/s] */
    double precession_per_period; /* that times the period [rad] */
    double flip_interval;         /* half the period, undefined of a symmetric body [s] */
    double solid_angle;           /* of the cap that the polhode cuts off about the encircled axis [sr] */
    /* what evaluation needs */
    double epoch, fastest;
    phd_free_motion_record motion;
} polhode_free_body;

static inline void phd_free_put_numbers(polhode_free_body *m, const phd_free_given_record *given)
{
    const phd_free_numbers_record numbers = phd_free_numbers(&given->body, &given->rates);
    m->regime = (polhode_regime)(int)numbers.regime;
    m->encircled_axis = (int)numbers.encircled_axis;
    m->momentum_norm = given->rates.G.hi * given->body.momentum_scale;
    m->modulus = numbers.modulus;
    m->period = numbers.period;
    m->precession_rate = numbers.precession_rate;
    m->precession_per_period = numbers.precession_per_period;
    m->flip_interval = m->regime == POLHODE_SYMMETRIC ? NAN : 0.5 * m->period;
    m->solid_angle = numbers.solid_angle;
}

/* Prepares a free body: principal moments [kg m2] in any order, momentum at the epoch along the principal axes, unit
   quaternion (NULL for the identity). Returns 0 or an error code, of which polhode_error tells the meaning. */
static inline int polhode_free_body_init(
    polhode_free_body *m, const double moments[3], const double momentum[3], const double attitude[4], double epoch)
{
    static const double identity[4] = {1.0, 0.0, 0.0, 0.0};
    const int error = phd_check(moments, momentum, attitude, epoch);
    const double *q = attitude ? attitude : identity, size = phd_length(q, 4);
    phd_free_given_record given;
    if (error) return error;
    given.moments = phd_make_three(moments[0], moments[1], moments[2]);
    given.momentum = phd_make_three(momentum[0], momentum[1], momentum[2]);
    given.attitude = phd_make_four(q[0] / size, q[1] / size, q[2] / size, q[3] / size);
    given.body = phd_free_reduction(given.moments, given.momentum);
    given.rates = phd_free_frequencies(&given.body);
    m->epoch = epoch;
    m->fastest = phd_fastest(moments, momentum);
    m->energy = phd_kinetic_energy(moments, momentum);
    m->motion = phd_free_motion_of(&given);
    phd_free_put_numbers(m, &given);
    return isfinite(m->fastest) && phd_are_finite(m->motion.first.at, 3) && phd_are_finite(m->motion.second.at, 3)
            && phd_are_finite(m->motion.to_attitude.at, 16) && phd_are_finite(m->motion.to_momentum.at, 9)
         ? POLHODE_OK : POLHODE_OUT_OF_RANGE;
}

/* Gives attitude (w, x, y, z) and momentum (body axes) at a time [s]. Returns 0 or an error code. */
static inline int polhode_free_body_state(const polhode_free_body *m, double t, double attitude[4], double momentum[3])
{
    phd_pair elapsed;
    phd_seven state;
    const int error = phd_since(t, m->epoch, m->fastest, &elapsed);
    if (error) return error;
    state = phd_free_state_at(&m->motion, elapsed.hi, elapsed.lo);
    for (int k = 0; k < 4; k++) attitude[k] = state.at[k];
    for (int k = 0; k < 3; k++) momentum[k] = state.at[4 + k];
    return POLHODE_OK;
}

/* ---------------------------------------------------------------- formulas of the Lagrange top */

@lagrange_top@
/* ---------------------------------------------------------------- the Lagrange top */

typedef enum {
    POLHODE_TOP_REST,
    POLHODE_TOP_SLEEPING,
    POLHODE_TOP_HANGING,
    POLHODE_TOP_STEADY,
    POLHODE_TOP_FREE,
    POLHODE_TOP_PLANAR,
    POLHODE_TOP_UNDULATING,
    POLHODE_TOP_CUSP,
    POLHODE_TOP_LOOP,
    POLHODE_TOP_SEPARATRIX
} polhode_top_regime;

typedef struct {
    /* what the motion means: what is infinite is INFINITY, what is undefined NAN */
    polhode_top_regime regime;
    double energy;                /* [J], zero potential where the axis is level */
    double lowest, highest;       /* limits of the cosine of the tilt from the upward vertical */
    double nutation_period;       /* [s]; of a steady top that of its smallest nutations */
    double precession_per_period; /* azimuth gained by the axis in a period, unreduced [rad] */
    double spin_per_period;       /* the body's own turn in a period, unreduced [rad] */
    /* what evaluation needs */
    double epoch, fastest;
    phd_top_motion_record motion;
} polhode_top;

static inline void phd_top_put_numbers(polhode_top *m, const phd_top_given_record *given)
{
    const phd_top_numbers_record numbers = phd_top_numbers(&given->top, &given->points, &given->rates);
    m->regime = (polhode_top_regime)(int)numbers.regime;
    m->lowest = numbers.lowest;
    m->highest = numbers.highest;
    m->nutation_period = numbers.period;
    m->precession_per_period = numbers.precession_per_period;
    m->spin_per_period = numbers.spin_per_period;
}

/* Prepares a Lagrange top: moments (I1, I1, I3) about the pivot, mgl the weight times the distance from there to the centre of
   mass along the third axis (negative below) [N m], momentum at the epoch (body axes), unit quaternion (NULL for the identity),
   space z up. Returns 0 or an error code. */
static inline int polhode_top_init(
    polhode_top *m, const double moments[3], double mgl, const double momentum[3], const double attitude[4], double epoch)
{
    static const double identity[4] = {1.0, 0.0, 0.0, 0.0};
    const int error = phd_check(moments, momentum, attitude, epoch);
    const double *q = attitude ? attitude : identity;
    const double up = q[0] * q[0] + q[3] * q[3], down = q[1] * q[1] + q[2] * q[2];
    phd_top_given_record given;
    phd_top_integrals_record integrals;
    if (error) return error;
    if (moments[0] != moments[1]) return POLHODE_BAD_MOMENTS;
    if (!isfinite(mgl)) return POLHODE_BAD_MGL;
    given.top = phd_top_reduction(
        phd_make_three(moments[0], moments[1], moments[2]), mgl, phd_make_three(momentum[0], momentum[1], momentum[2]),
        phd_make_four(q[0], q[1], q[2], q[3]));
    given.points = phd_top_turning_points(&given.top);
    given.rates = phd_top_frequencies(&given.top, &given.points);
    integrals = phd_top_integrals_of(&given.top, &given.points, &given.rates);
    given.at = phd_top_arguments(&given.top, &given.points, &given.rates, &integrals);
    given.axial = momentum[2];
    m->epoch = epoch;
    m->fastest = phd_fastest(moments, momentum) + sqrt(fabs(mgl) / moments[0]);
    m->energy = phd_kinetic_energy(moments, momentum) + mgl * (up - down) / (up + down);
    m->motion = phd_top_motion_of(&given);
    phd_top_put_numbers(m, &given);
    return isfinite(m->fastest) && phd_are_finite(m->motion.first.at, 3) && phd_are_finite(m->motion.second.at, 3)
            && phd_are_finite(m->motion.third.at, 3) && isfinite(m->motion.start.hi) && isfinite(m->motion.rates.hi)
            && isfinite(m->motion.rates.lo) && phd_are_finite(m->motion.phases.at, 4)
         ? POLHODE_OK : POLHODE_OUT_OF_RANGE;
}

/* Gives attitude (w, x, y, z) and momentum (body axes) at a time [s]. Returns 0 or an error code. */
static inline int polhode_top_state(const polhode_top *m, double t, double attitude[4], double momentum[3])
{
    phd_pair elapsed;
    phd_seven state;
    const int error = phd_since(t, m->epoch, m->fastest, &elapsed);
    if (error) return error;
    state = phd_top_state_at(&m->motion, elapsed.hi, elapsed.lo);
    for (int k = 0; k < 4; k++) attitude[k] = state.at[k];
    for (int k = 0; k < 3; k++) momentum[k] = state.at[4 + k];
    return POLHODE_OK;
}

#if defined(__clang__)
#pragma STDC FP_CONTRACT DEFAULT
#endif
#endif
