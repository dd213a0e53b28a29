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

#define POLHODE_VERSION "0.2.0"

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

/* 1.5 · 2⁵²: added and taken away again, it leaves the nearest whole number */
static const double PHD_ROUNDING = 6755399441055744.0;
/* 2²⁷ + 1 */
static const double PHD_SPLITTING = 134217729.0;
/* of the power series of sin 2πx and cos 2πx */
static const double PHD_S0 = 6.283185307179586;
static const double PHD_S1 = -41.341702240399755;
static const double PHD_S2 = 81.60524927607504;
static const double PHD_S3 = -76.70585975306136;
static const double PHD_S4 = 42.058693944897634;
static const double PHD_S5 = -15.094642576822984;
static const double PHD_S6 = 3.8199525848482803;
static const double PHD_S7 = -0.7181223017785001;
static const double PHD_S8 = 0.10422916220813978;
static const double PHD_C0 = 1.0;
static const double PHD_C1 = -19.739208802178716;
static const double PHD_C2 = 64.93939402266828;
static const double PHD_C3 = -85.45681720669371;
static const double PHD_C4 = 60.24464137187664;
static const double PHD_C5 = -26.426256783374388;
static const double PHD_C6 = 7.903536371318465;
static const double PHD_C7 = -1.7143907110886711;
static const double PHD_C8 = 0.282005968455791;
static const double PHD_C9 = -0.03638284114254564;
typedef struct { double hi, lo; } phd_pair;

static inline phd_pair phd_make_pair(double hi, double lo)
{
    phd_pair all;
    all.hi = hi; all.lo = lo;
    return all;
}

/* Return the product and its exact error, as long as that does not underflow [Dekker–Veltkamp]. */
static inline phd_pair phd_two_product(double a, double b)
{
    const double p = a * b;
    const double t = PHD_SPLITTING * a;
    const double u = PHD_SPLITTING * b;
    const double ah = t - (t - a);
    const double bh = u - (u - b);
    const double al = a - ah;
    const double bl = b - bh;
    return phd_make_pair(p, ah * bh - p + ah * bl + al * bh + al * bl);
}

static inline double phd_whole(double x)
{
    return x + PHD_ROUNDING - PHD_ROUNDING;
}

/* Return sin 2πx and cos 2πx, |x| ≤ ½. */
static inline phd_pair phd_sine_cosine(double x)
{
    const double quarter = phd_whole(4.0 * x);
    const double r = x - 0.25 * quarter;
    const double z = r * r;
    const double s =
        r
        * (PHD_S0
        + z
        * (PHD_S1
        + z * (PHD_S2 + z * (PHD_S3 + z * (PHD_S4 + z * (PHD_S5 + z * (PHD_S6 + z * (PHD_S7 + z * PHD_S8))))))));
    const double c =
        PHD_C0
        + z
        * (PHD_C1
        + z
        * (PHD_C2
        + z * (PHD_C3 + z * (PHD_C4 + z * (PHD_C5 + z * (PHD_C6 + z * (PHD_C7 + z * (PHD_C8 + z * PHD_C9))))))));
    const double n = quarter - 4.0 * floor(0.25 * quarter);
    const int odd = n == 1.0 || n == 3.0;
    const phd_pair of_a_b = odd ? phd_make_pair(c, s) : phd_make_pair(s, c);
    const double a = of_a_b.hi, b = of_a_b.lo;
    return phd_make_pair(n >= 2.0 ? -a : a, n == 1.0 || n == 2.0 ? -b : b);
}

static inline phd_pair phd_halves(double x)
{
    const double t = PHD_SPLITTING * x;
    const double high = t - (t - x);
    return phd_make_pair(high, x - high);
}

static inline phd_pair phd_two_sum(double a, double b)
{
    const double s = a + b;
    const double t = s - a;
    return phd_make_pair(s, a - (s - t) + (b - t));
}

typedef struct { double at[3]; } phd_three;

static inline phd_three phd_make_three(double x0, double x1, double x2)
{
    phd_three all;
    all.at[0] = x0; all.at[1] = x1; all.at[2] = x2;
    return all;
}

/* Return circular.reduced_phase. */
static inline phd_three phd_phase(phd_three rate, phd_three time)
{
    const double upper = rate.at[0], lower = rate.at[1], least = rate.at[2];
    const double high = time.at[0], low = time.at[1], rest = time.at[2];
    const double a = upper * high;
    const double b = upper * low;
    const double c = lower * high;
    const double na = phd_whole(a);
    const double nb = phd_whole(b);
    const double nc = phd_whole(c);
    const double d = lower * low + least * (high + low) + (upper + lower) * rest;
    const phd_pair of_two_sum = phd_two_sum(b - nb, c - nc);
    const double middle = of_two_sum.hi, middle_error = of_two_sum.lo;
    const phd_pair of_two_sum_2 = phd_two_sum(a - na, middle);
    const double fraction = of_two_sum_2.hi, error = of_two_sum_2.lo;
    const double more = phd_whole(fraction);
    return phd_make_three(fraction - more, error + (middle_error + d), na + (nb + nc) + more);
}

static inline phd_pair phd_two_square(double a)
{
    return phd_two_product(a, a);
}

static inline phd_pair phd_fast_two_sum(double a, double b)
{
    const double s = a + b;
    return phd_make_pair(s, b - (s - a));
}

static inline phd_pair phd_add(phd_pair x, phd_pair y)
{
    const phd_pair of_two_sum = phd_two_sum(x.hi, y.hi);
    const double s = of_two_sum.hi, e = of_two_sum.lo;
    return phd_fast_two_sum(s, e + (x.lo + y.lo));
}

static inline phd_pair phd_subtract(phd_pair x, phd_pair y)
{
    return phd_add(x, phd_make_pair(-y.hi, -y.lo));
}

static inline phd_pair phd_multiply(phd_pair x, phd_pair y)
{
    const phd_pair of_two_product = phd_two_product(x.hi, y.hi);
    const double p = of_two_product.hi, e = of_two_product.lo;
    return phd_fast_two_sum(p, e + (x.hi * y.lo + x.lo * y.hi));
}

static inline phd_pair phd_multiply_float(phd_pair x, double factor)
{
    const phd_pair of_two_product = phd_two_product(x.hi, factor);
    const double p = of_two_product.hi, e = of_two_product.lo;
    return phd_fast_two_sum(p, e + x.lo * factor);
}

static inline phd_pair phd_square(phd_pair x)
{
    const phd_pair of_two_product = phd_two_product(x.hi, x.hi);
    const double p = of_two_product.hi, e = of_two_product.lo;
    return phd_fast_two_sum(p, e + 2.0 * x.hi * x.lo);
}

static inline phd_pair phd_scale(phd_pair x, double power_of_two)
{
    return phd_make_pair(x.hi * power_of_two, x.lo * power_of_two);
}

static inline phd_pair phd_divide(phd_pair x, phd_pair y)
{
    const double q = x.hi / y.hi;
    const phd_pair of_two_product = phd_two_product(q, y.hi);
    const double p = of_two_product.hi, e = of_two_product.lo;
    const double r = x.hi - p - e + (x.lo - q * y.lo);
    return phd_fast_two_sum(q, r / y.hi);
}

/* Return √x of a positive number. */
static inline phd_pair phd_root(phd_pair x)
{
    const double s = sqrt(x.hi);
    const phd_pair of_two_product = phd_two_product(s, s);
    const double p = of_two_product.hi, e = of_two_product.lo;
    return phd_fast_two_sum(s, (x.hi - p - e + x.lo) / (s + s));
}

/* Return √x, zero for x = 0. */
static inline phd_pair phd_root_or_zero(phd_pair x)
{
    const int zero = x.hi == 0.0;
    return zero ? phd_make_pair(0.0, 0.0) : phd_root(zero ? phd_make_pair(1.0, 0.0) : x);
}

static const phd_pair PHD_PI = {3.141592653589793, 1.2246467991473532e-16};
static const phd_pair PHD_INVERSE_TWO_PI = {0.15915494309189535, -9.839338337591243e-18};
static const phd_pair PHD_LN2 = {0.6931471805599453, 2.3190468138462996e-17};
/* the closing formulas of the mean leave an error of the fourth power */
static const double PHD_CONVERGED = 2e-08;
static const int PHD_MOST_STEPS = 20;
/* steps of all, before the first is looked at */
static const int PHD_AT_ONCE = 3;
/* Return the leading part of −(x + rest)(upper + lower), which is exact, and the factor for the rest. */
static inline phd_pair phd_exponent(double x, double rest, double upper, double lower)
{
    /* −(x + rest)(upper + lower) = −high · upper − small, and e^(−small) to second order */
    const phd_pair of_halves = phd_halves(x);
    const double high = of_halves.hi, low = of_halves.lo;
    const double small = high * lower + low * (upper + lower) + rest * upper;
    return phd_make_pair(-(high * upper), 1.0 - small * (1.0 - 0.5 * small));
}

/* Return an argument in half periods as a number within ±½ and its rest, and the half periods taken out.

   On the separatrix, where periodic is zero, it runs to infinity and none is taken out. */
static inline phd_three phd_reduced_argument(phd_three rate, phd_pair start, double periodic, phd_three time)
{
    const phd_three of_phase = phd_phase(rate, time);
    const double fraction = of_phase.at[0], rest = of_phase.at[1], turned = of_phase.at[2];
    const phd_pair of_two_sum = phd_two_sum((1.0 - periodic) * turned, fraction);
    const double total = of_two_sum.hi, first_error = of_two_sum.lo;
    const phd_pair of_two_sum_2 = phd_two_sum(total, start.hi);
    double u = of_two_sum_2.hi;
    const double second_error = of_two_sum_2.lo;
    const phd_pair of_fast_two_sum = phd_fast_two_sum(u, rest + (start.lo + (first_error + second_error)));
    u = of_fast_two_sum.hi;
    const double u_rest = of_fast_two_sum.lo;
    const double more = periodic * rint(u);
    return phd_make_three(u - more, u_rest, periodic * turned + more);
}

/* Return elliptic.nome_per_parameter. */
static inline double phd_nome_per_parameter(double parameter, double k)
{
    const double more = 1.0 + sqrt(k);
    const double ratio = 0.5 / ((1.0 + k) * more * more);
    const double e = ratio * parameter;
    const double e4 = e * e * (e * e);
    return ratio * (1.0 + e4 * (2.0 + e4 * (15.0 + e4 * (150.0 + e4 * 1707.0))));
}

/* Return a period over θ3², of which 1/θ3² is 1 less a small correction. */
static inline phd_pair phd_by_theta(phd_pair period, double nome)
{
    const double q4 = nome * nome * (nome * nome);
    const double e = 2.0 * (nome + q4 + q4 * q4 * nome);
    return phd_add(period, phd_make_pair(-period.hi * (e * (2.0 + e) / ((1.0 + e) * (1.0 + e))), 0.0));
}

typedef struct { phd_pair at[5]; } phd_five_pairs;

static inline phd_five_pairs phd_make_five_pairs(phd_pair x0, phd_pair x1, phd_pair x2, phd_pair x3, phd_pair x4)
{
    phd_five_pairs all;
    all.at[0] = x0; all.at[1] = x1; all.at[2] = x2; all.at[3] = x3; all.at[4] = x4;
    return all;
}

/* Take a step of the arithmetic–geometric mean and its third-kind sum, in double-double.

   With ε = (p²−ag)/(p²+ag), Q ← Qε/2 and p ← (p²+ag)/2p; the sum is of all Q, from Q = 1. Arithmetic and square
   roots
   alone give complete elliptic integrals of the first and third kind, so that the rates of exact motion carry thirty
   digits and their phases stay right for any time. Source: Carlson, SIAM J. Math. Anal. 8 (1977) 231. */
static inline phd_five_pairs phd_mean_step(phd_pair a, phd_pair g, phd_pair pp, phd_pair q, phd_pair total)
{
    const phd_pair ag = phd_multiply(a, g);
    const phd_pair both = phd_add(pp, ag);
    q = phd_scale(phd_multiply(q, phd_divide(phd_subtract(pp, ag), both)), 0.5);
    return phd_make_five_pairs(phd_scale(phd_add(a, g), 0.5), phd_root(ag),
        phd_scale(phd_divide(phd_square(both), pp), 0.25), q, phd_add(total, q));
}

typedef struct {
    double first;
    double second;
    phd_pair third;
} phd_two_numbers_pair;

static inline phd_two_numbers_pair phd_make_two_numbers_pair(double first, double second, phd_pair third)
{
    phd_two_numbers_pair all;
    all.first = first; all.second = second; all.third = third;
    return all;
}

/* Return x = (a−g)/(a+g), ε and (a+g)/2; ag is taken as ((a+g)/2)² − ((a−g)/2)², which does not cancel in ε. */
static inline phd_two_numbers_pair phd_mean_distance(phd_pair a, phd_pair g, phd_pair pp)
{
    const phd_pair middle = phd_scale(phd_add(a, g), 0.5);
    const double half = 0.5 * (a.hi - g.hi + (a.lo - g.lo));
    const phd_pair d = phd_subtract(pp, phd_square(middle));
    const double e = d.hi + d.lo + half * half;
    return phd_make_two_numbers_pair(half / middle.hi, e / (2.0 * middle.hi * middle.hi + e), middle);
}

typedef struct { phd_pair at[2]; } phd_two_pairs;

static inline phd_two_pairs phd_make_two_pairs(phd_pair x0, phd_pair x1)
{
    phd_two_pairs all;
    all.at[0] = x0; all.at[1] = x1;
    return all;
}

/* Return the mean and the sum of what mean_distance returns, exact where that is below CONVERGED. */
static inline phd_two_pairs phd_mean_closed(double x, double e, phd_pair middle, double q, phd_pair total)
{
    const double last = 0.5 * q * e;
    const double rest = last + last * (0.25 * (e * e - 0.5 * x * x));
    /* agm(1 + x, 1 − x) = 1 − x²/4 + O(x⁴) */
    return phd_make_two_pairs(phd_add(middle, phd_make_pair(-0.25 * middle.hi * x * x, 0.0)),
        phd_add(total, phd_make_pair(rest, 0.0)));
}

typedef struct {
    phd_five_pairs first;
    double second;
} phd_five_pairs_number;

static inline phd_five_pairs_number phd_make_five_pairs_number(phd_five_pairs first, double second)
{
    phd_five_pairs_number all;
    all.first = first; all.second = second;
    return all;
}

/* Return where the mean of positive a and g begins, with the sum that starts from p², and the exponent taken out.

   Rates go down to 1e-150, whose fourth powers would underflow. Scaled down, a tiny g would. */
static inline phd_five_pairs_number phd_mean_start(phd_pair a, phd_pair g, phd_pair pp)
{
    const double power = phd_smaller(phd_binary_exponent(a.hi), 0.0 * a.hi);
    const double up = phd_times_power(1.0, -power);
    const phd_pair one = phd_make_pair(1.0, 0.0);
    return phd_make_five_pairs_number(phd_make_five_pairs(phd_scale(a, up), phd_scale(g, up),
            phd_scale(phd_scale(pp, up), up), one, one), power);
}

/* Return the mean after a step. */
static inline phd_five_pairs phd_mean_next(phd_five_pairs state)
{
    const phd_pair a = state.at[0], g = state.at[1], pp = state.at[2], q = state.at[3], total = state.at[4];
    return phd_mean_step(a, g, pp, q, total);
}

/* Return whether the closing formulas are exact. */
static inline int phd_mean_converged(phd_five_pairs state)
{
    const phd_two_numbers_pair of_mean_distance = phd_mean_distance(state.at[0], state.at[1], state.at[2]);
    const double x = of_mean_distance.first, e = of_mean_distance.second;
    return fabs(x) < PHD_CONVERGED && fabs(e) < PHD_CONVERGED;
}

/* Return mean and sum, of which the first lacks the exponent taken out. */
static inline phd_two_pairs phd_mean_end(phd_five_pairs state)
{
    const phd_two_numbers_pair of_mean_distance = phd_mean_distance(state.at[0], state.at[1], state.at[2]);
    const double x = of_mean_distance.first, e = of_mean_distance.second;
    const phd_pair middle = of_mean_distance.third;
    return phd_mean_closed(x, e, middle, state.at[3].hi, state.at[4]);
}

/* Return agm(a, g) of positive numbers, and the sum that starts from p² = pp. */
static inline phd_two_pairs phd_third_kind_mean(phd_pair a, phd_pair g, phd_pair pp)
{
    const phd_five_pairs_number of_mean_start = phd_mean_start(a, g, pp);
    const phd_five_pairs state = of_mean_start.first;
    const double power = of_mean_start.second;
    phd_five_pairs running = state;
    for (int k = 0; k < PHD_MOST_STEPS; k++) {
        if (k >= PHD_AT_ONCE && phd_mean_converged(running)) {
            break;
        }
        running = phd_mean_next(running);
    }
    const phd_two_pairs of_mean_end = phd_mean_end(running);
    const phd_pair mean = of_mean_end.at[0], total = of_mean_end.at[1];
    return phd_make_two_pairs(phd_scale(mean, phd_times_power(1.0, power)), total);
}

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

/* of components of L, below which numbers with it are scaled up by LIFT binary places */
static const double PHD_FREE_TINY_RATIO = 1.1830521861667747e-271;
static const double PHD_FREE_LIFT = 100.0;
/* products of double-doubles above it have all their digits */
static const double PHD_FREE_SHARP = 1e-280;
/* of the terms of S: what is left below it is summed exactly */
static const double PHD_FREE_NEAR = 0.01;
/* A body with sorted axes and without powers of two. */
typedef struct {
    phd_three moments; /* ascending, ½ ≤ I3 < 1 */
    phd_three momentum; /* along the sorted axes, ½ ≤ max |L_i| < 1, times 2^LIFT if a component is tiny */
    phd_three order; /* which of the given axes they are */
    double parity; /* −1 if sorting is no proper rotation; the momentum then has the other sign */
    double momentum_scale; /* powers of two taken out */
    double rate_scale;
} phd_free_scaled_record;

static inline phd_free_scaled_record phd_make_free_scaled_record(phd_three moments, phd_three momentum, phd_three order,
    double parity, double momentum_scale, double rate_scale)
{
    phd_free_scaled_record all;
    all.moments = moments; all.momentum = momentum; all.order = order; all.parity = parity;
    all.momentum_scale = momentum_scale; all.rate_scale = rate_scale;
    return all;
}

/* Invariants before the mirror, each a sum of terms of one sign. */
typedef struct {
    phd_pair A;
    phd_pair B;
    phd_pair C;
    phd_pair P;
    phd_pair Q;
    phd_pair G2;
} phd_free_sums_record;

static inline phd_free_sums_record phd_make_free_sums_record(phd_pair A, phd_pair B, phd_pair C, phd_pair P, phd_pair Q,
    phd_pair G2)
{
    phd_free_sums_record all;
    all.A = A; all.B = B; all.C = C; all.P = P; all.Q = Q; all.G2 = G2;
    return all;
}

/* A body in canonical form; all pairs are double-double.

   With V = I1 I2 I3: A = (I2−I1)I3, B = (I3−I2)I1, C = (I3−I1)I2, P = C L1² + B L2², Q = A L2² + C L3² and
   S = A L1² − B L3² ≤ 0 are V times the textbook quantities, which avoids all divisions; the mirror has been
   applied. */
typedef struct {
    phd_three moments; /* those of Scaled */
    phd_three momentum;
    phd_three canonical; /* momentum after mirror and half turn, third component ≥ 0 */
    phd_pair A;
    phd_pair B;
    phd_pair C;
    phd_pair P;
    phd_pair Q;
    phd_pair S;
    phd_pair root_S; /* √−S, accurate where S itself underflows */
    double root_P; /* √P, likewise */
    phd_pair V;
    phd_pair G2; /* |L|² */
    int long_axis; /* whether the mirror was applied */
    phd_three order; /* which of the given axes the canonical ones are */
    double parity; /* that of Scaled */
    double half_turn; /* −1 where the half turn about the second axis was applied */
    double momentum_scale; /* powers of two taken out */
    double rate_scale;
} phd_free_reduction_record;

static inline phd_free_reduction_record phd_make_free_reduction_record(phd_three moments, phd_three momentum,
    phd_three canonical, phd_pair A, phd_pair B, phd_pair C, phd_pair P, phd_pair Q, phd_pair S, phd_pair root_S,
    double root_P, phd_pair V, phd_pair G2, int long_axis, phd_three order, double parity, double half_turn,
    double momentum_scale, double rate_scale)
{
    phd_free_reduction_record all;
    all.moments = moments; all.momentum = momentum; all.canonical = canonical; all.A = A; all.B = B; all.C = C;
    all.P = P; all.Q = Q; all.S = S; all.root_S = root_S; all.root_P = root_P; all.V = V; all.G2 = G2;
    all.long_axis = long_axis; all.order = order; all.parity = parity; all.half_turn = half_turn;
    all.momentum_scale = momentum_scale; all.rate_scale = rate_scale;
    return all;
}

typedef struct {
    phd_three first;
    phd_three second;
    double third;
} phd_two_threes_number;

static inline phd_two_threes_number phd_make_two_threes_number(phd_three first, phd_three second, double third)
{
    phd_two_threes_number all;
    all.first = first; all.second = second; all.third = third;
    return all;
}

static inline phd_two_threes_number phd_free_in_order(phd_three one, phd_three other, double parity)
{
    const int swap = other.at[0] < one.at[0];
    return phd_make_two_threes_number(phd_make_three(swap ? other.at[0] : one.at[0], swap ? other.at[1] : one.at[1],
            swap ? other.at[2] : one.at[2]),
        phd_make_three(swap ? one.at[0] : other.at[0], swap ? one.at[1] : other.at[1], swap ? one.at[2] : other.at[2]),
        swap ? -parity : parity);
}

static inline double phd_free_size(double x, double size)
{
    return x == 0.0 ? size : fabs(x);
}

/* Sort the axes by their moments, and take out powers of two. */
static inline phd_free_scaled_record phd_free_scaled(phd_three moments, phd_three momentum)
{
    const phd_two_threes_number of_in_order = phd_free_in_order(phd_make_three(moments.at[0], momentum.at[0], 0.0),
        phd_make_three(moments.at[1], momentum.at[1], 1.0), 1.0);
    phd_three x = of_in_order.first;
    phd_three y = of_in_order.second;
    double parity = of_in_order.third;
    const phd_two_threes_number of_in_order_2 = phd_free_in_order(y, phd_make_three(moments.at[2], momentum.at[2], 2.0),
        parity);
    y = of_in_order_2.first;
    parity = of_in_order_2.third;
    const phd_three z = of_in_order_2.second;
    const phd_two_threes_number of_in_order_3 = phd_free_in_order(x, y, parity);
    x = of_in_order_3.first;
    y = of_in_order_3.second;
    parity = of_in_order_3.third;
    const double size = phd_larger(phd_larger(fabs(x.at[1]), fabs(y.at[1])), fabs(z.at[1]));
    /* a component down to the smallest number keeps its digits in what is formed of it */
    const double smallest = phd_smaller(phd_smaller(phd_free_size(x.at[1], size), phd_free_size(y.at[1], size)),
        phd_free_size(z.at[1], size));
    const double of_momentum =
        phd_binary_exponent(size) - (smallest < PHD_FREE_TINY_RATIO * size ? PHD_FREE_LIFT : 0.0);
    const double of_moments = phd_binary_exponent(z.at[0]);
    return phd_make_free_scaled_record(phd_make_three(phd_times_power(x.at[0], -of_moments),
            phd_times_power(y.at[0], -of_moments), phd_times_power(z.at[0], -of_moments)),
        phd_make_three(parity * phd_times_power(x.at[1], -of_momentum), parity * phd_times_power(y.at[1], -of_momentum),
            parity * phd_times_power(z.at[1], -of_momentum)), phd_make_three(x.at[2], y.at[2], z.at[2]), parity,
        phd_times_power(1.0, of_momentum), phd_times_power(1.0, of_momentum - of_moments));
}

/* Return the invariants but S. */
static inline phd_free_sums_record phd_free_sums_of(const phd_free_scaled_record *body)
{
    const double i1 = body->moments.at[0], i2 = body->moments.at[1], i3 = body->moments.at[2];
    const double x = body->momentum.at[0], y = body->momentum.at[1], z = body->momentum.at[2];
    const phd_pair a = phd_multiply_float(phd_two_sum(i2, -i1), i3);
    const phd_pair b = phd_multiply_float(phd_two_sum(i3, -i2), i1);
    const phd_pair c = phd_multiply_float(phd_two_sum(i3, -i1), i2);
    const phd_pair s1 = phd_two_square(x);
    const phd_pair s2 = phd_two_square(y);
    const phd_pair s3 = phd_two_square(z);
    const phd_pair p = phd_add(phd_multiply(c, s1), phd_multiply(b, s2));
    const phd_pair q = phd_add(phd_multiply(a, s2), phd_multiply(c, s3));
    return phd_make_free_sums_record(a, b, c, p, q, phd_add(phd_add(s1, s2), s3));
}

static inline double phd_free_exponent_near_saddle(const phd_free_scaled_record *body)
{
    return phd_binary_exponent(phd_larger(fabs(body->momentum.at[0]), fabs(body->momentum.at[2])));
}

typedef struct {
    phd_three first;
    double second;
    double third;
} phd_three_two_numbers;

static inline phd_three_two_numbers phd_make_three_two_numbers(phd_three first, double second, double third)
{
    phd_three_two_numbers all;
    all.first = first; all.second = second; all.third = third;
    return all;
}

/* Return the moments, and L1 and L3 scaled up: near the saddle their squares would lose their low words. */
static inline phd_three_two_numbers phd_free_terms_of_distance(const phd_free_scaled_record *body)
{
    const double exponent = phd_free_exponent_near_saddle(body);
    const double x = body->momentum.at[0], z = body->momentum.at[2];
    return phd_make_three_two_numbers(body->moments, phd_times_power(x, -exponent), phd_times_power(z, -exponent));
}

typedef struct {
    phd_pair first;
    int second;
} phd_pair_flag;

static inline phd_pair_flag phd_make_pair_flag(phd_pair first, int second)
{
    phd_pair_flag all;
    all.first = first; all.second = second;
    return all;
}

/* Return A x² − B z² in double-double, and whether so much cancels that it is to be summed exactly. */
static inline phd_pair_flag phd_free_plain_distance(phd_pair a, phd_pair b, double x, double z)
{
    const phd_pair first = phd_multiply(a, phd_two_square(x));
    const phd_pair distance = phd_subtract(first, phd_multiply(b, phd_two_square(z)));
    return phd_make_pair_flag(distance, fabs(distance.hi) < PHD_FREE_NEAR * first.hi);
}

/* Return the product of a gap, a moment and x². */
static inline phd_sum phd_free_of_square(phd_pair gap, double moment, double x)
{
    return phd_multiply_terms(phd_multiply_terms(phd_multiply_terms(phd_as_sum(gap), moment), x), x);
}

/* Return S = (I2 − I1) I3 x² − (I3 − I2) I1 z², correct to its last digit however close to the separatrix. */
static inline phd_pair phd_free_exact_distance(phd_three moments, double x, double z)
{
    const double i1 = moments.at[0], i2 = moments.at[1], i3 = moments.at[2];
    return phd_distil(phd_join(phd_free_of_square(phd_two_sum(i2, -i1), i3, x),
            phd_free_of_square(phd_two_sum(i3, -i2), -i1, z)));
}

typedef struct {
    phd_three_two_numbers first;
    phd_pair second;
} phd_three_two_numbers_pair;

static inline phd_three_two_numbers_pair phd_make_three_two_numbers_pair(phd_three_two_numbers first, phd_pair second)
{
    phd_three_two_numbers_pair all;
    all.first = first; all.second = second;
    return all;
}

static inline phd_pair phd_free_exact(phd_three_two_numbers_pair values)
{
    const phd_three moments = values.first.first;
    const double x = values.first.second, z = values.first.third;
    return phd_free_exact_distance(moments, x, z);
}

static inline phd_pair phd_free_plain(phd_three_two_numbers_pair values)
{
    return values.second;
}

/* Return A L1² − B L3², with both components scaled up. */
static inline phd_pair phd_free_signed_distance(const phd_free_scaled_record *body, const phd_free_sums_record *sums)
{
    const phd_three_two_numbers terms = phd_free_terms_of_distance(body);
    const phd_pair_flag of_plain_distance = phd_free_plain_distance(sums->A, sums->B, terms.second, terms.third);
    const phd_pair plain = of_plain_distance.first;
    const int near = of_plain_distance.second;
    return near
        ? phd_free_exact(phd_make_three_two_numbers_pair(terms, plain))
        : phd_free_plain(phd_make_three_two_numbers_pair(terms, plain));
}

/* Return √(C x² + B y²), of which the sum is given but may have lost digits, or all, to underflow. */
static inline double phd_free_root_of_sum(double value, double c, double x, double b, double y)
{
    const double exponent = phd_binary_exponent(phd_larger(fabs(x), fabs(y)));
    x = phd_times_power(x, -exponent);
    y = phd_times_power(y, -exponent);
    return value > PHD_FREE_SHARP ? sqrt(value) : phd_times_power(sqrt(c * x * x + b * y * y), exponent);
}

/* Apply mirror and half turn; the distance is that of signed_distance. */
static inline phd_free_reduction_record phd_free_reduced(const phd_free_scaled_record *body,
    const phd_free_sums_record *sums, phd_pair distance)
{
    const int long_axis = distance.hi > 0.0;
    const phd_pair a = long_axis ? sums->B : sums->A;
    const phd_pair b = long_axis ? sums->A : sums->B;
    const phd_pair p = long_axis ? sums->Q : sums->P;
    const phd_pair q = long_axis ? sums->P : sums->Q;
    double x = body->momentum.at[0];
    double z = body->momentum.at[2];
    const double y = body->momentum.at[1];
    const phd_pair of_x_z = phd_make_pair(long_axis ? z : x, long_axis ? x : z);
    x = of_x_z.hi;
    z = of_x_z.lo;
    const double half_turn = z < 0.0 ? -1.0 : 1.0;
    const double i1 = body->moments.at[0], i2 = body->moments.at[1], i3 = body->moments.at[2];
    const double side = long_axis ? 1.0 : -1.0;
    const double near = phd_times_power(1.0, phd_free_exponent_near_saddle(body));
    const phd_pair minus_s = phd_scale(distance, side);
    const double first = body->order.at[0], second = body->order.at[1], third = body->order.at[2];
    return phd_make_free_reduction_record(body->moments, body->momentum,
        phd_make_three(x * half_turn, y, z * half_turn), a, b, sums->C, p, q,
        phd_scale(phd_scale(minus_s, -near), near), phd_scale(phd_root_or_zero(minus_s), near),
        phd_free_root_of_sum(p.hi, sums->C.hi, x, b.hi, y), phd_multiply_float(phd_two_product(i1, i2), i3), sums->G2,
        long_axis, phd_make_three(long_axis ? third : first, second, long_axis ? first : third), body->parity,
        half_turn, body->momentum_scale, body->rate_scale);
}

/* Return the canonical form of a body, in any order and at any scale. */
static inline phd_free_reduction_record phd_free_reduction(phd_three moments, phd_three momentum)
{
    const phd_free_scaled_record body = phd_free_scaled(moments, momentum);
    const phd_free_sums_record sums = phd_free_sums_of(&body);
    return phd_free_reduced(&body, &sums, phd_free_signed_distance(&body, &sums));
}

/* Rates times V in canonical scaled units, and the regime of the body. */
typedef struct {
    phd_pair modulus_rate; /* λ = √(BQ): u = u0 + λ t */
    phd_pair mean; /* agm(√(BQ), √(−CS)) = π λ / 2K; meaningless on the separatrix */
    phd_pair precession; /* ω_p */
    phd_pair G; /* |L| */
    int constant; /* permanent rotation, sphere or rest: L stays */
    int separatrix;
} phd_free_frequencies_record;

static inline phd_free_frequencies_record phd_make_free_frequencies_record(phd_pair modulus_rate, phd_pair mean,
    phd_pair precession, phd_pair G, int constant, int separatrix)
{
    phd_free_frequencies_record all;
    all.modulus_rate = modulus_rate; all.mean = mean; all.precession = precession; all.G = G; all.constant = constant;
    all.separatrix = separatrix;
    return all;
}

/* What of the frequencies is there before the mean. */
typedef struct {
    phd_pair modulus_rate;
    int constant;
    int separatrix;
} phd_free_start_record;

static inline phd_free_start_record phd_make_free_start_record(phd_pair modulus_rate, int constant, int separatrix)
{
    phd_free_start_record all;
    all.modulus_rate = modulus_rate; all.constant = constant; all.separatrix = separatrix;
    return all;
}

typedef struct {
    phd_free_start_record first;
    phd_pair second;
    phd_pair third;
    phd_pair fourth;
} phd_free_start_record_three_pairs;

static inline phd_free_start_record_three_pairs
phd_make_free_start_record_three_pairs(const phd_free_start_record *first, phd_pair second, phd_pair third,
    phd_pair fourth)
{
    phd_free_start_record_three_pairs all;
    all.first = *first; all.second = second; all.third = third; all.fourth = fourth;
    return all;
}

/* Return the start and √(BQ), √(−CS) and p² for the mean, or ones where there is no period.

   p² is so chosen that the third-kind sum stays quadratic. */
static inline phd_free_start_record_three_pairs phd_free_start_of(const phd_free_reduction_record *body)
{
    const phd_pair rate = phd_root_or_zero(phd_multiply(body->B, body->Q));
    const phd_pair slow = phd_multiply(phd_root_or_zero(body->C), body->root_S);
    const int third = body->B.hi >= body->A.hi;
    phd_pair pp = phd_multiply(third ? body->Q : body->B, body->C);
    pp = third ? pp : phd_multiply(pp, body->G2);
    const double x = body->canonical.at[0], z = body->canonical.at[2];
    const int is_constant = !(rate.hi > 0.0) || !(body->root_P > 0.0) || (x == 0.0 && z == 0.0);
    const int separatrix = !(body->C.hi > 0.0 && body->root_S.hi > 0.0) && !is_constant;
    const int idle = is_constant || separatrix;
    const phd_pair one = phd_make_pair(1.0, 0.0);
    const phd_free_start_record start = phd_make_free_start_record(rate, is_constant, separatrix);
    return phd_make_free_start_record_three_pairs(&start, idle ? one : rate, idle ? one : slow, idle ? one : pp);
}

/* Return the frequencies, of mean and third-kind sum. */
static inline phd_free_frequencies_record phd_free_frequencies_of(const phd_free_reduction_record *body,
    const phd_free_start_record *start, phd_pair mean, phd_pair total)
{
    const phd_pair g = phd_root_or_zero(body->G2);
    const int third = body->B.hi >= body->A.hi;
    const double i1 = body->moments.at[0], i2 = body->moments.at[1], i3 = body->moments.at[2];
    /* a1 V = I2 I3 and a3 V = I1 I2, and with the mirror −I1 I2 and −I2 I3 */
    const double side = body->long_axis ? -1.0 : 1.0;
    const phd_pair outer = phd_two_product(side * (body->long_axis == third ? i1 : i3), i2);
    const phd_pair correction = phd_multiply(third ? body->A : body->P, total);
    const phd_pair share = third ? phd_scale(correction, -0.5) : phd_scale(phd_divide(correction, body->G2), 0.5);
    const phd_pair rate = phd_multiply(g, phd_add(outer, share));
    phd_pair precession = third ? rate : phd_add(rate, mean);
    /* on the separatrix the frame ends up turning at |L|/I2, here times V = I1 I2 I3 */
    const phd_pair saddle = phd_multiply(g, phd_two_product(side * i1, i3));
    precession = start->separatrix ? saddle : precession;
    return phd_make_free_frequencies_record(start->modulus_rate, mean, precession, g, start->constant,
        start->separatrix);
}

/* Return the frequencies of a reduced body. */
static inline phd_free_frequencies_record phd_free_frequencies(const phd_free_reduction_record *body)
{
    const phd_free_start_record_three_pairs of_start_of = phd_free_start_of(body);
    const phd_free_start_record start = of_start_of.first;
    const phd_pair fast = of_start_of.second, slow = of_start_of.third, pp = of_start_of.fourth;
    const phd_two_pairs of_third_kind_mean = phd_third_kind_mean(fast, slow, pp);
    const phd_pair mean = of_third_kind_mean.at[0], total = of_third_kind_mean.at[1];
    return phd_free_frequencies_of(body, &start, mean, total);
}

typedef struct { phd_three at[2]; } phd_two_threes;

static inline phd_two_threes phd_make_two_threes(phd_three x0, phd_three x1)
{
    phd_two_threes all;
    all.at[0] = x0; all.at[1] = x1;
    return all;
}

/* Return Motion.first and Motion.second [turns per time], in halves, of a body with two frequencies. */
static inline phd_two_threes phd_free_phase_rates(int full, const phd_free_reduction_record *body,
    const phd_free_frequencies_record *rates)
{
    /* rates times V become turns: over 2πV */
    const phd_pair inverse = phd_scale(phd_divide(PHD_INVERSE_TWO_PI, body->V), body->rate_scale);
    const phd_pair half = phd_scale(phd_multiply(rates->precession, inverse), 0.5);
    const phd_pair turn = phd_scale(phd_multiply(rates->mean, inverse), 2.0);
    const phd_pair quarter = phd_scale(turn, 0.25);
    const phd_pair saddle = phd_scale(phd_divide(rates->modulus_rate, body->V), body->rate_scale);
    const phd_pair first = full ? phd_subtract(half, quarter) : half;
    const phd_pair second = rates->separatrix ? saddle : full ? phd_add(half, quarter) : turn;
    const phd_pair of_halves = phd_halves(first.hi);
    const double first_high = of_halves.hi, first_low = of_halves.lo;
    const phd_pair of_halves_2 = phd_halves(second.hi);
    const double second_high = of_halves_2.hi, second_low = of_halves_2.lo;
    return phd_make_two_threes(phd_make_three(first_high, first_low, first.lo),
        phd_make_three(second_high, second_low, second.lo));
}

typedef struct { double at[10]; } phd_ten;

static inline phd_ten phd_make_ten(double x0, double x1, double x2, double x3, double x4, double x5, double x6,
    double x7, double x8, double x9)
{
    phd_ten all;
    all.at[0] = x0; all.at[1] = x1; all.at[2] = x2; all.at[3] = x3; all.at[4] = x4; all.at[5] = x5; all.at[6] = x6;
    all.at[7] = x7; all.at[8] = x8; all.at[9] = x9;
    return all;
}

typedef struct { double at[5]; } phd_five;

static inline phd_five phd_make_five(double x0, double x1, double x2, double x3, double x4)
{
    phd_five all;
    all.at[0] = x0; all.at[1] = x1; all.at[2] = x2; all.at[3] = x3; all.at[4] = x4;
    return all;
}

typedef struct { double at[16]; } phd_sixteen;

static inline phd_sixteen phd_make_sixteen(double x0, double x1, double x2, double x3, double x4, double x5, double x6,
    double x7, double x8, double x9, double x10, double x11, double x12, double x13, double x14, double x15)
{
    phd_sixteen all;
    all.at[0] = x0; all.at[1] = x1; all.at[2] = x2; all.at[3] = x3; all.at[4] = x4; all.at[5] = x5; all.at[6] = x6;
    all.at[7] = x7; all.at[8] = x8; all.at[9] = x9; all.at[10] = x10; all.at[11] = x11; all.at[12] = x12;
    all.at[13] = x13; all.at[14] = x14; all.at[15] = x15;
    return all;
}

typedef struct { double at[9]; } phd_nine;

static inline phd_nine phd_make_nine(double x0, double x1, double x2, double x3, double x4, double x5, double x6,
    double x7, double x8)
{
    phd_nine all;
    all.at[0] = x0; all.at[1] = x1; all.at[2] = x2; all.at[3] = x3; all.at[4] = x4; all.at[5] = x5; all.at[6] = x6;
    all.at[7] = x7; all.at[8] = x8;
    return all;
}

/* All that evaluation needs of a body: numbers, or arrays with one for each of many. */
typedef struct {
    double full; /* whether it takes the full form */
    phd_three first; /* full: rate of the phase of A; complementary: half the precession rate [turns per time] */
    phd_three second; /* full: rate of the phase of B; complementary: rate of u/2K */
    phd_pair start; /* full: (z0/4π, 0); complementary: u0/2K, double-double */
    phd_ten series; /* full: five coefficients of A and of B; complementary: cos and sin of (2n+1)(y/2 − π/4) */
    phd_five nome; /* complementary: √q1, πK/K' in halves, y/2π, 0 on the separatrix */
    double parity; /* complementary: half turns of u at the start */
    phd_sixteen to_attitude; /* by rows: quaternion = matrix (4, 4) · spinor / norm */
    phd_nine to_momentum; /* by rows: momentum = matrix (3, 3) · (n1, n2, n3) */
} phd_free_motion_record;

static inline phd_free_motion_record phd_make_free_motion_record(double full, phd_three first, phd_three second,
    phd_pair start, phd_ten series, phd_five nome, double parity, phd_sixteen to_attitude, phd_nine to_momentum)
{
    phd_free_motion_record all;
    all.full = full; all.first = first; all.second = second; all.start = start; all.series = series; all.nome = nome;
    all.parity = parity; all.to_attitude = to_attitude; all.to_momentum = to_momentum;
    return all;
}

typedef struct { double at[4]; } phd_four;

static inline phd_four phd_make_four(double x0, double x1, double x2, double x3)
{
    phd_four all;
    all.at[0] = x0; all.at[1] = x1; all.at[2] = x2; all.at[3] = x3;
    return all;
}

/* Sum A and B as polynomials in X = cos 2z and Y = sin 2z, where z is the difference of their phases. */
static inline phd_four phd_free_full_sums(const phd_free_motion_record *m, phd_three time)
{
    const double start = m->start.hi;
    const double a0 = m->series.at[0], a1 = m->series.at[1], a2 = m->series.at[2], a3 = m->series.at[3],
        a4 = m->series.at[4], b0 = m->series.at[5], b1 = m->series.at[6], b2 = m->series.at[7], b3 = m->series.at[8],
        b4 = m->series.at[9];
    const phd_three of_phase = phd_phase(m->first, time);
    const double fa = of_phase.at[0], ra = of_phase.at[1];
    const phd_three of_phase_2 = phd_phase(m->second, time);
    const double fb = of_phase_2.at[0], rb = of_phase_2.at[1];
    const double ta = fa + (ra - start);
    const double tb = fb + (rb + start);
    const phd_pair of_sine_cosine = phd_sine_cosine(ta - phd_whole(ta));
    const double sa = of_sine_cosine.hi, ca = of_sine_cosine.lo;
    const phd_pair of_sine_cosine_2 = phd_sine_cosine(tb - phd_whole(tb));
    const double sb = of_sine_cosine_2.hi, cb = of_sine_cosine_2.lo;
    const double cz = ca * cb + sa * sb;
    const double sz = sb * ca - cb * sa;
    /* cos 2z = 1 − 2 sin² z, sin 2z = 2 sin z cos z */
    const double s2 = sz + sz;
    const double X = 1.0 - s2 * sz;
    const double Y = s2 * cz;
    const double pa = a0 + X * (a1 + X * a2);
    const double qa = Y * (a3 + X * a4);
    const double pb = b0 + X * (b1 + X * b2);
    const double qb = Y * (b3 + X * b4);
    return phd_make_four(ca * pa - sa * qa, ca * qa + sa * pa, cb * pb - sb * qb, cb * qb + sb * pb);
}

typedef struct { double at[7]; } phd_seven;

static inline phd_seven phd_make_seven(double x0, double x1, double x2, double x3, double x4, double x5, double x6)
{
    phd_seven all;
    all.at[0] = x0; all.at[1] = x1; all.at[2] = x2; all.at[3] = x3; all.at[4] = x4; all.at[5] = x5; all.at[6] = x6;
    return all;
}

/* Return turns, side, count of half turns, and exponent and factor of E and of R, which sums A and B. */
static inline phd_seven phd_free_complementary_phase(const phd_free_motion_record *m, phd_three time)
{
    const double upper = m->nome.at[1], lower = m->nome.at[2], y_turns = m->nome.at[3], periodic = m->nome.at[4];
    const phd_three of_phase = phd_phase(m->first, time);
    const double fraction = of_phase.at[0], rest = of_phase.at[1];
    const phd_three of_reduced_argument = phd_reduced_argument(m->second, m->start, periodic, time);
    double count = of_reduced_argument.at[2];
    const double u = of_reduced_argument.at[0], u_rest = of_reduced_argument.at[1];
    count = m->parity + count;
    count = count - 4.0 * phd_whole(0.25 * count);
    double turns = fraction - 0.25 * count;
    turns = turns - phd_whole(turns) + (rest - u * y_turns);
    const double side = u < 0.0 ? -1.0 : 1.0;
    const double f = u * side;
    const double g = u_rest * side;
    const phd_pair of_exponent = phd_exponent(f, g, upper, lower);
    const double e = of_exponent.hi, e_factor = of_exponent.lo;
    const double distance = phd_larger(0.5 - f, 0.0);
    const phd_pair of_exponent_2 = phd_exponent(distance, (0.5 - distance - f) * periodic - g, upper, lower);
    const double r = of_exponent_2.hi, r_factor = of_exponent_2.lo;
    return phd_make_seven(turns, side, count, e, e_factor, r, periodic * r_factor);
}

/* Sum A and B in the growing powers of R = √q1/E and the decaying ones of E = e^−|x|, x = πu/2K'. */
static inline phd_four phd_free_complementary_sums(const phd_free_motion_record *m, double turns, double side,
    double count, double e0, double R)
{
    const double c0 = m->series.at[0], c1 = m->series.at[1], c2 = m->series.at[2], c3 = m->series.at[3],
        c4 = m->series.at[4], s0 = m->series.at[5], s1 = m->series.at[6], s2 = m->series.at[7], s3 = m->series.at[8],
        s4 = m->series.at[9];
    const double root = m->nome.at[0];
    const phd_pair of_sine_cosine = phd_sine_cosine(turns - phd_whole(turns));
    const double s = of_sine_cosine.hi, c = of_sine_cosine.lo;
    const double q = root * root;
    const double q2 = q * q;
    const double g1 = root * R;
    const double g2 = g1 * g1 * q;
    const double g3 = g2 * g1 * q2;
    const double g4 = g3 * g1 * q2 * q;
    const double e1 = q * e0 * e0;
    const double e2 = q2 * e1 * e0;
    const double e3 = q2 * q * e2 * e0;
    const double e4 = q2 * q2 * e3 * e0;
    double ar = c4 * (g4 + e4);
    double ai = s4 * (g4 - e4);
    double br = -s4 * (g4 + e4);
    double bi = c4 * (g4 - e4);
    ar = ar + c3 * (g3 + e3);
    ai = ai + s3 * (g3 - e3);
    br = br + s3 * (g3 + e3);
    bi = bi - c3 * (g3 - e3);
    ar = ar + c2 * (g2 + e2);
    ai = ai + s2 * (g2 - e2);
    br = br - s2 * (g2 + e2);
    bi = bi + c2 * (g2 - e2);
    ar = ar + c1 * (g1 + e1);
    ai = ai + s1 * (g1 - e1);
    br = br + s1 * (g1 + e1);
    bi = bi - c1 * (g1 - e1);
    ar = ar + c0 * (1.0 + e0);
    ai = ai + s0 * (1.0 - e0);
    br = br - s0 * (1.0 + e0);
    bi = bi + c0 * (1.0 - e0);
    ai = ai * side;
    bi = bi * side;
    const double odd = 1.0 - 2.0 * (count - 2.0 * floor(0.5 * count));
    return phd_make_four(c * ar - s * ai, c * ai + s * ar, odd * (c * br - s * bi), odd * (c * bi + s * br));
}

/* Return attitude and momentum. */
static inline phd_seven phd_free_state_of(const phd_free_motion_record *m, phd_four spinor)
{
    const double a0 = spinor.at[0], a1 = spinor.at[1], b0 = spinor.at[2], b1 = spinor.at[3];
    const double aa = a0 * a0 + a1 * a1;
    const double bb = b0 * b0 + b1 * b1;
    const double x = 1.0 / (aa + bb);
    const double root = sqrt(x);
    const double x2 = x + x;
    /* the direction of L of a spinor (A, B): 2 Re ĀB, 2 Im ĀB and |A|² − |B|², over |A|² + |B|² */
    const double n0 = (a0 * b0 + a1 * b1) * x2;
    const double n1 = (a0 * b1 - a1 * b0) * x2;
    const double n2 = (aa - bb) * x;
    const double a = a0 * root;
    const double b = a1 * root;
    const double c = b0 * root;
    const double d = b1 * root;
    const phd_sixteen q = m->to_attitude;
    const phd_nine p = m->to_momentum;
    return phd_make_seven(q.at[0] * a + q.at[1] * b + q.at[2] * c + q.at[3] * d,
        q.at[4] * a + q.at[5] * b + q.at[6] * c + q.at[7] * d, q.at[8] * a + q.at[9] * b + q.at[10] * c + q.at[11] * d,
        q.at[12] * a + q.at[13] * b + q.at[14] * c + q.at[15] * d, p.at[0] * n0 + p.at[1] * n1 + p.at[2] * n2,
        p.at[3] * n0 + p.at[4] * n1 + p.at[5] * n2, p.at[6] * n0 + p.at[7] * n1 + p.at[8] * n2);
}

/* Return attitude and momentum of a motion at a time, given in two parts. */
static inline phd_seven phd_free_state_at(const phd_free_motion_record *m, double time, double rest)
{
    const phd_pair of_halves = phd_halves(time);
    const double high = of_halves.hi, low = of_halves.lo;
    if (m->full != 0.0) {
        return phd_free_state_of(m, phd_free_full_sums(m, phd_make_three(high, low, rest)));
    }
    const phd_seven of_complementary_phase = phd_free_complementary_phase(m, phd_make_three(high, low, rest));
    const double a = of_complementary_phase.at[0], b = of_complementary_phase.at[1], c = of_complementary_phase.at[2],
        exponent = of_complementary_phase.at[3], factor = of_complementary_phase.at[4],
        other = of_complementary_phase.at[5], other_factor = of_complementary_phase.at[6];
    const double e0 = exp(exponent) * factor;
    const double R = exp(other) * other_factor;
    return phd_free_state_of(m, phd_free_complementary_sums(m, a, b, c, e0, R));
}

/* below it the leading term of the cap's area is as exact as the difference it replaces */
static const double PHD_FREE_SMALL_CAP = 1e-14;
/* What a free body's motion is like; what is infinite is inf, what is undefined NaN, and −1 of the axis. */
typedef struct {
    double regime; /* 0 rest, 1 spherical, 2 permanent, 3 symmetric, 4 short axis, 5 long axis, 6 separatrix */
    double encircled_axis; /* index of the given axis that the polhode goes round */
    double modulus;
    double period; /* after which the momentum is back along the body's axes */
    double precession_rate; /* mean rate at which the encircled axis turns about the momentum */
    double precession_per_period;
    double solid_angle; /* of the cap that the polhode cuts off about the encircled axis */
} phd_free_numbers_record;

static inline phd_free_numbers_record phd_make_free_numbers_record(double regime, double encircled_axis, double modulus,
    double period, double precession_rate, double precession_per_period, double solid_angle)
{
    phd_free_numbers_record all;
    all.regime = regime; all.encircled_axis = encircled_axis; all.modulus = modulus; all.period = period;
    all.precession_rate = precession_rate; all.precession_per_period = precession_per_period;
    all.solid_angle = solid_angle;
    return all;
}

static inline double phd_free_regime(const phd_free_reduction_record *body, const phd_free_frequencies_record *rates)
{
    const double i1 = body->moments.at[0], i2 = body->moments.at[1], i3 = body->moments.at[2];
    const double x = body->momentum.at[0], y = body->momentum.at[1], z = body->momentum.at[2];
    double code = body->long_axis ? 5.0 : 4.0;
    code = i1 == i2 || i2 == i3 ? 3.0 : code;
    code = rates->separatrix ? 6.0 : code;
    code = rates->constant ? 2.0 : code;
    code = i1 == i3 ? 1.0 : code;
    return x == 0.0 && y == 0.0 && z == 0.0 ? 0.0 : code;
}

/* Return Ω = 2π − (ω_p − 2E/|L|) T, in double-double, as small caps cancel. */
static inline double phd_free_solid_angle(const phd_free_reduction_record *body,
    const phd_free_frequencies_record *rates, phd_pair per_period, phd_pair scaled_period, phd_pair two_pi)
{
    const double i1 = body->moments.at[0], i2 = body->moments.at[1], i3 = body->moments.at[2];
    const double b = body->B.hi;
    const double c = body->C.hi;
    const double p = body->P.hi;
    const double q = body->Q.hi;
    const double g2 = body->G2.hi;
    const phd_pair twice_energy = phd_add(body->P,
        phd_multiply(phd_two_product(body->long_axis ? -i3 : i1, i2), body->G2));
    const phd_pair dynamic = phd_multiply(phd_divide(twice_energy, rates->G), scaled_period);
    const phd_pair angle = phd_subtract(two_pi, phd_subtract(per_period, dynamic));
    /* a small cap is the ellipse C L1² + B L2² = P, of area πP/√(BC), over |L|² */
    const double cap = 3.141592653589793 * p / (sqrt(b * c) * g2);
    /* a symmetric body's period has no bound near its equator, and the difference no digit left */
    const double round_cap = 2.0 * 3.141592653589793 * (p / (c * g2)) / (1.0 + sqrt(q / (c * g2)));
    return body->A.hi == 0.0 ? round_cap : p / (b * g2) < PHD_FREE_SMALL_CAP ? cap : angle.hi;
}

static inline double phd_free_by_kind(const phd_free_frequencies_record *rates, double permanent, double separatrix,
    double periodic)
{
    return rates->constant ? permanent : rates->separatrix ? separatrix : periodic;
}

/* Return the numbers of a body. */
static inline phd_free_numbers_record phd_free_numbers(const phd_free_reduction_record *body,
    const phd_free_frequencies_record *rates)
{
    const phd_pair two_pi = phd_scale(PHD_PI, 2.0);
    /* T/V */
    const phd_pair scaled_period = phd_divide(two_pi, rates->mean);
    /* ω_p T */
    const phd_pair per_period = phd_multiply(rates->precession, scaled_period);
    const phd_pair period = phd_divide(phd_multiply(scaled_period, body->V),
        phd_make_pair(body->rate_scale, 0.0 * body->rate_scale));
    const phd_pair rate = phd_scale(phd_divide(rates->precession, body->V), body->rate_scale);
    const double sense = body->long_axis ? -1.0 : 1.0;
    /* k² = AP/(BQ) */
    const double modulus = sqrt(body->A.hi / body->B.hi) * (body->root_P / sqrt(body->Q.hi));
    const double solid_angle = phd_free_solid_angle(body, rates, per_period, scaled_period, two_pi);
    return phd_make_free_numbers_record(phd_free_regime(body, rates),
        phd_free_by_kind(rates, -1.0, -1.0, body->order.at[2]), phd_free_by_kind(rates, NAN, 1.0, modulus),
        phd_free_by_kind(rates, NAN, INFINITY, period.hi), rates->constant ? NAN : sense * rate.hi,
        phd_free_by_kind(rates, NAN, INFINITY, sense * per_period.hi), phd_free_by_kind(rates, NAN, NAN, solid_angle));
}

/* a sine above the inverse of the first is scaled by the second */
static const double PHD_FREE_HUGE_INVERSE = 3.8725919148493183e-121;
static const double PHD_FREE_HUGE_SCALE = 6.223015277861142e-61;
/* 200 ln 2 */
static const phd_pair PHD_FREE_LOG_OF_SCALE = {138.62943611198907, -3.3555121496085278e-15};
static const phd_nine PHD_FREE_NINE_ZEROS = {{0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0}};
static const phd_sixteen PHD_FREE_SIXTEEN_ZEROS = {{0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0}};
/* What a form takes at the epoch. */
typedef struct {
    phd_pair start;
    phd_ten series;
    phd_five nome;
    double parity;
} phd_free_arguments_record;

static inline phd_free_arguments_record phd_make_free_arguments_record(phd_pair start, phd_ten series, phd_five nome,
    double parity)
{
    phd_free_arguments_record all;
    all.start = start; all.series = series; all.nome = nome; all.parity = parity;
    return all;
}

/* What the full form's start is the angle of, and its coefficients. */
typedef struct {
    double rise;
    double run;
    phd_ten series;
} phd_free_full_amplitude_record;

static inline phd_free_full_amplitude_record phd_make_free_full_amplitude_record(double rise, double run,
    phd_ten series)
{
    phd_free_full_amplitude_record all;
    all.rise = rise; all.run = run; all.series = series;
    return all;
}

/* What the complementary form's start is made from. */
typedef struct {
    double nome;
    double tangent; /* of y, the circular amplitude */
    double sinh_; /* of x, the hyperbolic one, times HUGE_SCALE if it is huge */
    int huge;
} phd_free_amplitude_record;

static inline phd_free_amplitude_record phd_make_free_amplitude_record(double nome, double tangent, double sinh_,
    int huge)
{
    phd_free_amplitude_record all;
    all.nome = nome; all.tangent = tangent; all.sinh_ = sinh_; all.huge = huge;
    return all;
}

/* The amplitudes, and the hyperbolic sine of x as it is rounded. */
typedef struct {
    double x;
    double sinh_;
    double y;
} phd_free_angles_record;

static inline phd_free_angles_record phd_make_free_angles_record(double x, double sinh_, double y)
{
    phd_free_angles_record all;
    all.x = x; all.sinh_ = sinh_; all.y = y;
    return all;
}

/* A body as given, with its reduction and frequencies. */
typedef struct {
    phd_three moments;
    phd_three momentum;
    phd_four attitude;
    phd_free_reduction_record body;
    phd_free_frequencies_record rates;
} phd_free_given_record;

static inline phd_free_given_record phd_make_free_given_record(phd_three moments, phd_three momentum, phd_four attitude,
    const phd_free_reduction_record *body, const phd_free_frequencies_record *rates)
{
    phd_free_given_record all;
    all.moments = moments; all.momentum = momentum; all.attitude = attitude; all.body = *body; all.rates = *rates;
    return all;
}

typedef struct { double at[6]; } phd_six;

static inline phd_six phd_make_six(double x0, double x1, double x2, double x3, double x4, double x5)
{
    phd_six all;
    all.at[0] = x0; all.at[1] = x1; all.at[2] = x2; all.at[3] = x3; all.at[4] = x4; all.at[5] = x5;
    return all;
}

/* Return x, y, dn, factor, sinh and dc after a step. */
static inline phd_six phd_free_landen_step(double x, double y, double dn, double factor, double sinh_, double cosine,
    double dc)
{
    /* descending Landen (DLMF §22.7(i)), κ = (1 − k′)/(1 + k′): (1 − dn)/(1 + dn) = κ sn² of the next step, whose
       dn² = 1 − κ² sn², and tan am = (1 + κ) tan am/dn of the next step */
    const double kappa = (x - y) / (x + y);
    const double grown = 1.0 + kappa;
    const double next_dn = sqrt(1.0 - kappa * (1.0 - dn) / (1.0 + dn));
    sinh_ = 2.0 * sinh_ / (grown * (cosine + dc));
    const double next_dc = sqrt(1.0 + kappa * (dc - cosine) / (dc + cosine));
    return phd_make_six(0.5 * (x + y), sqrt(x * y), next_dn, factor * (next_dn / grown), sinh_, next_dc);
}

/* Follow a circular and a hyperbolic amplitude down five Landen steps from the complementary modulus k.

   Returns the factor of the tangent of the circular amplitude and the hyperbolic sine of the other; its first step
   takes sinh · c, c and dc · c so that none of them needs a quotient that may be 0/0. */
static inline phd_pair phd_free_landen(double k, double dn, double sinh_times_cosine, double cosine, double dc)
{
    const phd_six of_landen_step = phd_free_landen_step(1.0, k, dn, 1.0, sinh_times_cosine, cosine, dc);
    double x = of_landen_step.at[0];
    double y = of_landen_step.at[1];
    dn = of_landen_step.at[2];
    double factor = of_landen_step.at[3];
    double sinh_ = of_landen_step.at[4];
    dc = of_landen_step.at[5];
    const phd_six of_landen_step_2 = phd_free_landen_step(x, y, dn, factor, sinh_, 1.0, dc);
    x = of_landen_step_2.at[0];
    y = of_landen_step_2.at[1];
    dn = of_landen_step_2.at[2];
    factor = of_landen_step_2.at[3];
    sinh_ = of_landen_step_2.at[4];
    dc = of_landen_step_2.at[5];
    const phd_six of_landen_step_3 = phd_free_landen_step(x, y, dn, factor, sinh_, 1.0, dc);
    x = of_landen_step_3.at[0];
    y = of_landen_step_3.at[1];
    dn = of_landen_step_3.at[2];
    factor = of_landen_step_3.at[3];
    sinh_ = of_landen_step_3.at[4];
    dc = of_landen_step_3.at[5];
    const phd_six of_landen_step_4 = phd_free_landen_step(x, y, dn, factor, sinh_, 1.0, dc);
    x = of_landen_step_4.at[0];
    y = of_landen_step_4.at[1];
    dn = of_landen_step_4.at[2];
    factor = of_landen_step_4.at[3];
    sinh_ = of_landen_step_4.at[4];
    dc = of_landen_step_4.at[5];
    const phd_six of_landen_step_5 = phd_free_landen_step(x, y, dn, factor, sinh_, 1.0, dc);
    x = of_landen_step_5.at[0];
    y = of_landen_step_5.at[1];
    dn = of_landen_step_5.at[2];
    factor = of_landen_step_5.at[3];
    sinh_ = of_landen_step_5.at[4];
    dc = of_landen_step_5.at[5];
    return phd_make_pair(factor, sinh_);
}

/* Return what the start of the full form, m ≤ ½, is the angle of, and the coefficients of A and B. */
static inline phd_free_full_amplitude_record phd_free_full_amplitude(const phd_free_reduction_record *body)
{
    const double a = body->A.hi;
    const double b = body->B.hi;
    const double c = body->C.hi;
    const double q = body->Q.hi;
    const double x = body->canonical.at[0], y = body->canonical.at[1], z = body->canonical.at[2];
    const double total = b * q;
    const double parameter = a * body->P.hi / total;
    const double complement = -c * body->S.hi / total;
    const double per_parameter = phd_nome_per_parameter(parameter, sqrt(complement));
    const double nome = per_parameter * parameter;
    /* √(P/Q) sinh, as the hyperbolic sine itself overflows near a stable axis */
    const double small = body->root_P / sqrt(q);
    const double of_b = sqrt(b);
    const double of_c = sqrt(c);
    const phd_pair of_landen = phd_free_landen(sqrt(complement), z * sqrt(c / q), of_b, of_b, of_c);
    const double factor = of_landen.hi, scaled = of_landen.lo;
    const double grown = scaled + sqrt(small * small + scaled * scaled);
    const double g = small / grown;
    const double r = a / b * per_parameter * grown * grown;
    const double g2 = g * g;
    const double q2 = nome * nome;
    const double r2 = r * r;
    const double q3 = q2 * nome;
    const double q4 = q2 * q2;
    const double q8 = q4 * q4;
    const double gg = g2 * g2;
    const double up = -nome * g2;
    const double down = -q2 * r;
    const double up2 = q4 * q2 * gg;
    const double down2 = q8 * r2;
    const double up3 = -q3 * g2;
    const double up4 = q8 * q2 * gg;
    const double down4 = q4 * r2;
    return phd_make_free_full_amplitude_record(of_b * y * factor, of_c * x,
        phd_make_ten(1.0 - (up2 + down2), up + down, 2.0 * (up2 + down2), up - down, 2.0 * (up2 - down2),
            g * (1.0 - (up4 + down4)), g * (up3 - r), 2.0 * g * (up4 + down4), g * (up3 + r), 2.0 * g * (up4 - down4)));
}

/* Return z0/4π. */
static inline double phd_free_full_start(double rise, double run)
{
    return atan2(rise, run) * (0.25 / 3.141592653589793);
}

/* Return what the full form takes. */
static inline phd_free_arguments_record phd_free_full_arguments(double start, phd_ten series)
{
    return phd_make_free_arguments_record(phd_make_pair(start, 0.0), series, phd_make_five(0.0, 0.0, 0.0, 0.0, 0.0),
        0.0);
}

static inline phd_free_arguments_record phd_free_full_arguments_inside(const phd_free_given_record *given)
{
    const phd_free_full_amplitude_record at = phd_free_full_amplitude(&given->body);
    return phd_free_full_arguments(phd_free_full_start(at.rise, at.run), at.series);
}

/* Return what the start of the complementary form, m > ½, is made from. */
static inline phd_free_amplitude_record phd_free_amplitude(const phd_free_reduction_record *body,
    const phd_free_frequencies_record *rates)
{
    const double b = body->B.hi;
    const double c = body->C.hi;
    const double p = body->P.hi;
    const double q = body->Q.hi;
    const double x = body->canonical.at[0], y = body->canonical.at[1], z = body->canonical.at[2];
    const double total = b * q;
    const double k = rates->separatrix ? 1.0 : sqrt(body->A.hi * p / total);
    const double parameter = rates->separatrix ? 0.0 : -c * body->S.hi / total;
    const double of_c = sqrt(c);
    /* dn, and sinh, cosine and dc of which all but the last are times one number: none needs a quotient that may be
       0/0 */
    const double dn = sqrt(p / b) / rates->G.hi;
    const double along = fabs(sqrt(b) * y);
    const double cosine = of_c * fabs(x);
    const double dc = of_c * z * sqrt(p / q);
    /* close to the unstable axis the hyperbolic sine and its square leave the range of numbers */
    const int huge = cosine + dc < PHD_FREE_HUGE_INVERSE * along;
    const phd_pair of_landen = phd_free_landen(k, dn, huge ? PHD_FREE_HUGE_SCALE * along : along, cosine, dc);
    const double factor = of_landen.hi, sinh_ = of_landen.lo;
    return phd_make_free_amplitude_record(parameter * phd_nome_per_parameter(parameter, k), sqrt(q / p) * factor, sinh_,
        huge);
}

static inline phd_pair phd_free_of_huge(double sinh_)
{
    const double x = log(2.0 * sinh_);
    return phd_make_pair(x, 0.5 * exp(x));
}

static inline phd_pair phd_free_of_ordinary(double sinh_)
{
    const double x = asinh(sinh_);
    return phd_make_pair(x, sinh(x));
}

/* Return the amplitudes by elementary functions. */
static inline phd_free_angles_record phd_free_angles(const phd_free_amplitude_record *at)
{
    const phd_pair of_x_sinh = at->huge ? phd_free_of_huge(at->sinh_) : phd_free_of_ordinary(at->sinh_);
    const double x = of_x_sinh.hi, sinh_ = of_x_sinh.lo;
    return phd_make_free_angles_record(x, sinh_, atan(at->tangent));
}

/* Return πK/K' = 2K/θ3², of √(BQ) and the mean. */
static inline phd_pair phd_free_half_period(phd_pair fast, phd_pair mean, double nome)
{
    return phd_by_theta(phd_divide(phd_multiply(fast, PHD_PI), mean), nome);
}

/* Return cos and sin of (2n+1)(y/2 − π/4), n from 0 to 4, for 0 ≤ y ≤ π/2. */
static inline phd_ten phd_free_harmonics(double y)
{
    const double angle = (0.5 * y - 0.25 * 3.141592653589793) * (0.5 / 3.141592653589793);
    const phd_pair of_sine_cosine = phd_sine_cosine(angle);
    const double s0 = of_sine_cosine.hi, c0 = of_sine_cosine.lo;
    const phd_pair of_sine_cosine_2 = phd_sine_cosine(3.0 * angle);
    const double s1 = of_sine_cosine_2.hi, c1 = of_sine_cosine_2.lo;
    const phd_pair of_sine_cosine_3 = phd_sine_cosine(5.0 * angle - phd_whole(5.0 * angle));
    const double s2 = of_sine_cosine_3.hi, c2 = of_sine_cosine_3.lo;
    const phd_pair of_sine_cosine_4 = phd_sine_cosine(7.0 * angle - phd_whole(7.0 * angle));
    const double s3 = of_sine_cosine_4.hi, c3 = of_sine_cosine_4.lo;
    const phd_pair of_sine_cosine_5 = phd_sine_cosine(9.0 * angle - phd_whole(9.0 * angle));
    const double s4 = of_sine_cosine_5.hi, c4 = of_sine_cosine_5.lo;
    return phd_make_ten(c0, c1, c2, c3, c4, s0, s1, s2, s3, s4);
}

/* Return start, harmonics, nome and parity of the complementary form, separatrix included. */
static inline phd_free_arguments_record phd_free_complementary_arguments(const phd_free_reduction_record *body,
    const phd_free_frequencies_record *rates, const phd_free_amplitude_record *at, const phd_free_angles_record *angle)
{
    const double l1 = body->canonical.at[0], l2 = body->canonical.at[1];
    const double slope = at->huge ? angle->sinh_ : sqrt(1.0 + angle->sinh_ * angle->sinh_);
    phd_pair x = phd_fast_two_sum(angle->x, (at->sinh_ - angle->sinh_) / slope);
    x = at->huge ? phd_add(x, PHD_FREE_LOG_OF_SCALE) : x;
    x = phd_scale(x, (l2 < 0.0) == (l1 < 0.0) ? 1.0 : -1.0);
    phd_pair period = phd_free_half_period(rates->modulus_rate, rates->mean, at->nome);
    period = rates->separatrix ? phd_make_pair(1.0, 0.0) : period;
    const phd_pair of_halves = phd_halves(period.hi);
    const double upper = of_halves.hi, lower = of_halves.lo;
    const double periodic = rates->separatrix ? 0.0 : 1.0;
    return phd_make_free_arguments_record(phd_divide(x, period), phd_free_harmonics(angle->y),
        phd_make_five(sqrt(at->nome), upper, lower + period.lo, periodic * angle->y * (0.5 / 3.141592653589793),
            periodic), l1 < 0.0 ? 1.0 : 0.0);
}

static inline phd_free_arguments_record phd_free_complementary_arguments_inside(const phd_free_given_record *given)
{
    const phd_free_amplitude_record at = phd_free_amplitude(&given->body, &given->rates);
    const phd_free_angles_record of_angles = phd_free_angles(&at);
    return phd_free_complementary_arguments(&given->body, &given->rates, &at, &of_angles);
}

/* Return the product of quaternions. */
static inline phd_four phd_free_turned(phd_four given, double scalar, double x, double y, double z)
{
    const double a = given.at[0], b = given.at[1], c = given.at[2], d = given.at[3];
    return phd_make_four(a * scalar - b * x - c * y - d * z, a * x + b * scalar + c * z - d * y,
        a * y - b * z + c * scalar + d * x, a * z + b * y - c * x + d * scalar);
}

/* Return the component along a given axis of a vector along axes of this order. */
static inline double phd_free_on_axis(double k, phd_three order, double x, double y, double z)
{
    return order.at[0] == k ? x : order.at[1] == k ? y : z;
}

static inline phd_four phd_free_column(phd_four given, phd_three order, double scalar, double x, double y, double z)
{
    return phd_free_turned(given, scalar, phd_free_on_axis(0.0, order, x, y, z), phd_free_on_axis(1.0, order, x, y, z),
        phd_free_on_axis(2.0, order, x, y, z));
}

typedef struct { phd_three at[3]; } phd_three_threes;

static inline phd_three_threes phd_make_three_threes(phd_three x0, phd_three x1, phd_three x2)
{
    phd_three_threes all;
    all.at[0] = x0; all.at[1] = x1; all.at[2] = x2;
    return all;
}

/* Return the signed permutation whose rows take canonical components to those along the given axes. */
static inline phd_three_threes phd_free_axes_of(const phd_free_reduction_record *body)
{
    const double i = body->order.at[0], j = body->order.at[1], k = body->order.at[2];
    const double middle = body->parity;
    const double outer = body->parity * body->half_turn;
    return phd_make_three_threes(phd_make_three(i == 0.0 ? outer : 0.0, j == 0.0 ? middle : 0.0,
            k == 0.0 ? outer : 0.0),
        phd_make_three(i == 1.0 ? outer : 0.0, j == 1.0 ? middle : 0.0, k == 1.0 ? outer : 0.0),
        phd_make_three(i == 2.0 ? outer : 0.0, j == 2.0 ? middle : 0.0, k == 2.0 ? outer : 0.0));
}

typedef struct {
    phd_sixteen first;
    phd_nine second;
} phd_sixteen_nine;

static inline phd_sixteen_nine phd_make_sixteen_nine(phd_sixteen first, phd_nine second)
{
    phd_sixteen_nine all;
    all.first = first; all.second = second;
    return all;
}

/* Return by rows the matrices from spinor to attitude and from canonical direction to momentum.

   Args:
       body: the reduction.
       g: |L|.
       attitude: at the epoch.
       spinor: likewise. */
static inline phd_sixteen_nine phd_free_matrices(const phd_free_reduction_record *body, double g, phd_four attitude,
    phd_four spinor)
{
    double a0 = spinor.at[0];
    double a1 = spinor.at[1];
    double b0 = spinor.at[2];
    double b1 = spinor.at[3];
    const double norm = sqrt(a0 * a0 + a1 * a1 + (b0 * b0 + b1 * b1));
    a0 = a0 / norm;
    a1 = a1 / norm;
    b0 = b0 / norm;
    b1 = b1 / norm;
    /* (start frame)* (present frame) is linear in the spinor (Re A, Im A, Re B, Im B); the mirror reverses its
       vector */
    const double h = body->long_axis ? -body->parity : body->parity;
    const phd_three order = body->order;
    const double f = h * body->half_turn;
    const phd_four p = phd_free_column(attitude, order, a0, -f * b1, h * b0, -f * a1);
    const phd_four q = phd_free_column(attitude, order, a1, f * b0, h * b1, f * a0);
    const phd_four r = phd_free_column(attitude, order, b0, -f * a1, -h * a0, f * b1);
    const phd_four s = phd_free_column(attitude, order, b1, f * a0, -h * a1, -f * b0);
    const double size = g * body->momentum_scale;
    const phd_three_threes of_axes_of = phd_free_axes_of(body);
    const phd_three first = of_axes_of.at[0], second = of_axes_of.at[1], third = of_axes_of.at[2];
    return phd_make_sixteen_nine(phd_make_sixteen(p.at[0], q.at[0], r.at[0], s.at[0], p.at[1], q.at[1], r.at[1],
            s.at[1], p.at[2], q.at[2], r.at[2], s.at[2], p.at[3], q.at[3], r.at[3], s.at[3]),
        phd_make_nine(size * first.at[0], size * first.at[1], size * first.at[2], size * second.at[0],
            size * second.at[1], size * second.at[2], size * third.at[0], size * third.at[1], size * third.at[2]));
}

/* Return whether the motion takes the full form, m ≤ ½, if it has a period. */
static inline int phd_free_is_full(const phd_free_reduction_record *body)
{
    return body->A.hi * body->P.hi <= -body->C.hi * body->S.hi;
}

static inline phd_four phd_free_full_spinor(const phd_free_motion_record *m)
{
    const double zero = 0.0 * m->start.hi;
    return phd_free_full_sums(m, phd_make_three(zero, zero, zero));
}

static inline phd_four phd_free_complementary_spinor(const phd_free_motion_record *m)
{
    const double zero = 0.0 * m->start.hi;
    const phd_seven of_complementary_phase = phd_free_complementary_phase(m, phd_make_three(zero, zero, zero));
    const double a = of_complementary_phase.at[0], b = of_complementary_phase.at[1], c = of_complementary_phase.at[2],
        e = of_complementary_phase.at[3], factor = of_complementary_phase.at[4], other = of_complementary_phase.at[5],
        other_factor = of_complementary_phase.at[6];
    return phd_free_complementary_sums(m, a, b, c, exp(e) * factor, exp(other) * other_factor);
}

/* Return the motion of a body whose momentum moves. */
static inline phd_free_motion_record phd_free_moving(const phd_free_given_record *given)
{
    const phd_free_reduction_record body = given->body;
    const phd_free_frequencies_record rates = given->rates;
    const int full = phd_free_is_full(&body) && !rates.separatrix;
    const phd_two_threes of_phase_rates = phd_free_phase_rates(full, &body, &rates);
    const phd_three first = of_phase_rates.at[0], second = of_phase_rates.at[1];
    const phd_free_arguments_record at =
        full ? phd_free_full_arguments_inside(given) : phd_free_complementary_arguments_inside(given);
    const double kind = full ? 1.0 : 0.0;
    const phd_free_motion_record m = phd_make_free_motion_record(kind, first, second, at.start, at.series, at.nome,
        at.parity, PHD_FREE_SIXTEEN_ZEROS, PHD_FREE_NINE_ZEROS);
    const phd_four spinor = full ? phd_free_full_spinor(&m) : phd_free_complementary_spinor(&m);
    const phd_sixteen_nine of_matrices = phd_free_matrices(&body, rates.G.hi, given->attitude, spinor);
    const phd_sixteen to_attitude = of_matrices.first;
    const phd_nine to_momentum = of_matrices.second;
    return phd_make_free_motion_record(kind, first, second, at.start, at.series, at.nome, at.parity, to_attitude,
        to_momentum);
}

/* Return |Ω|/4π, the rate of half the angle of a permanent rotation, in turns. */
static inline phd_three phd_free_permanent_rate(const phd_free_reduction_record *body)
{
    const double i1 = body->moments.at[0], i2 = body->moments.at[1], i3 = body->moments.at[2];
    const double x = body->momentum.at[0], y = body->momentum.at[1], z = body->momentum.at[2];
    const double none = 0.0 * body->root_P;
    const phd_pair u = phd_divide(phd_make_pair(x, none), phd_make_pair(i1, none));
    const phd_pair v = phd_divide(phd_make_pair(y, none), phd_make_pair(i2, none));
    const phd_pair w = phd_divide(phd_make_pair(z, none), phd_make_pair(i3, none));
    const phd_pair size = phd_root_or_zero(phd_add(phd_add(phd_square(u), phd_square(v)), phd_square(w)));
    const phd_pair rate = phd_scale(phd_scale(phd_multiply(size, PHD_INVERSE_TWO_PI), 0.5), body->rate_scale);
    const phd_pair of_halves = phd_halves(rate.hi);
    const double high = of_halves.hi, low = of_halves.lo;
    return phd_make_three(high, low, rate.lo);
}

/* Return the direction of Ω along the given axes, zero at rest. */
static inline phd_three phd_free_rotation_axis(phd_three moments, phd_three momentum)
{
    const double i1 = moments.at[0], i2 = moments.at[1], i3 = moments.at[2];
    double x = momentum.at[0];
    double y = momentum.at[1];
    double z = momentum.at[2];
    double largest = phd_larger(phd_larger(fabs(x), fabs(y)), fabs(z));
    largest = largest > 0.0 ? largest : 1.0;
    const double least = phd_smaller(phd_smaller(i1, i2), i3);
    x = x / largest * (least / i1);
    y = y / largest * (least / i2);
    z = z / largest * (least / i3);
    double size = sqrt(x * x + y * y + z * z);
    size = size > 0.0 ? size : 1.0;
    return phd_make_three(x / size, y / size, z / size);
}

/* Return the motion of a body at rest, of a sphere, or in permanent rotation: (A, B) turns, and L stays. */
static inline phd_free_motion_record phd_free_permanent(const phd_free_given_record *given)
{
    const double zero = 0.0 * given->body.root_P;
    const double one = zero + 1.0;
    const phd_three of_rotation_axis = phd_free_rotation_axis(given->moments, given->momentum);
    const double x = of_rotation_axis.at[0], y = of_rotation_axis.at[1], z = of_rotation_axis.at[2];
    const phd_four p = phd_free_turned(given->attitude, 1.0, zero, zero, zero);
    const phd_four q = phd_free_turned(given->attitude, 0.0, x, y, z);
    const double l1 = given->momentum.at[0], l2 = given->momentum.at[1], l3 = given->momentum.at[2];
    return phd_make_free_motion_record(one, phd_free_permanent_rate(&given->body), phd_make_three(zero, zero, zero),
        phd_make_pair(zero, zero), phd_make_ten(one, zero, zero, zero, zero, zero, zero, zero, zero, zero),
        phd_make_five(zero, zero, zero, zero, zero), zero,
        phd_make_sixteen(p.at[0], q.at[0], zero, zero, p.at[1], q.at[1], zero, zero, p.at[2], q.at[2], zero, zero,
            p.at[3], q.at[3], zero, zero), phd_make_nine(zero, zero, l1, zero, zero, l2, zero, zero, l3));
}

/* Return the constants of motion of a body. */
static inline phd_free_motion_record phd_free_motion_of(const phd_free_given_record *given)
{
    return given->rates.constant ? phd_free_permanent(given) : phd_free_moving(given);
}

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

/* binary exponents: of a displacement that is scaled up, and of what it becomes */
static const double PHD_TOP_TINY = -200.0;
static const double PHD_TOP_LIFTED = -150.0;
static const phd_pair PHD_TOP_ONE = {1.0, 0.0};
static const phd_pair PHD_TOP_ZERO = {0.0, 0.0};
/* A top with mgl ≥ 0 and without powers of two. */
typedef struct {
    phd_pair moments; /* I1, I3 */
    phd_three momentum;
    phd_four quaternion;
    int reversed; /* whether the axis was reversed */
    double lift; /* binary exponent of the displacement's scale, 0 for most tops */
    double exponent; /* binary, taken out of the momentum */
    double momentum_scale; /* powers of two taken out */
    double rate_scale;
    phd_pair G;
} phd_top_scaled_record;

static inline phd_top_scaled_record phd_make_top_scaled_record(phd_pair moments, phd_three momentum,
    phd_four quaternion, int reversed, double lift, double exponent, double momentum_scale, double rate_scale,
    phd_pair G)
{
    phd_top_scaled_record all;
    all.moments = moments; all.momentum = momentum; all.quaternion = quaternion; all.reversed = reversed;
    all.lift = lift; all.exponent = exponent; all.momentum_scale = momentum_scale; all.rate_scale = rate_scale;
    all.G = G;
    return all;
}

/* A top with mgl ≥ 0, scaled by powers of two; pairs are double-double.

   u = cos θ, s = 1 − u, t = 1 + u, index 0 at the epoch; dots are derivatives by τ. */
typedef struct {
    phd_pair moments; /* I1, I3 */
    phd_three momentum; /* with the displacement scaled up by 2^lift */
    phd_four quaternion; /* not normalised; likewise */
    int reversed; /* whether the axis was reversed */
    double lift; /* binary exponent of the displacement's scale, 0 for most tops */
    double momentum_scale; /* powers of two taken out */
    double rate_scale;
    phd_pair size; /* |q|² as given */
    phd_pair G;
    phd_pair s0;
    phd_pair t0;
    phd_pair u0;
    phd_pair p; /* u̇ at the epoch */
    phd_pair c; /* p_φ − L3 */
    phd_pair c_plus; /* p_φ + L3 */
    phd_pair twist; /* p_φ − u L3 at the epoch */
    phd_pair F; /* |w|² − G s − a c */
    phd_pair D; /* 2G − a² − |w|² + G s */
    phd_pair w2; /* |w|² at the epoch */
    phd_pair lean; /* a (|w|² − G s) − G c: its sign against a's tells loops from waves */
} phd_top_reduction_record;

static inline phd_top_reduction_record phd_make_top_reduction_record(phd_pair moments, phd_three momentum,
    phd_four quaternion, int reversed, double lift, double momentum_scale, double rate_scale, phd_pair size, phd_pair G,
    phd_pair s0, phd_pair t0, phd_pair u0, phd_pair p, phd_pair c, phd_pair c_plus, phd_pair twist, phd_pair F,
    phd_pair D, phd_pair w2, phd_pair lean)
{
    phd_top_reduction_record all;
    all.moments = moments; all.momentum = momentum; all.quaternion = quaternion; all.reversed = reversed;
    all.lift = lift; all.momentum_scale = momentum_scale; all.rate_scale = rate_scale; all.size = size; all.G = G;
    all.s0 = s0; all.t0 = t0; all.u0 = u0; all.p = p; all.c = c; all.c_plus = c_plus; all.twist = twist; all.F = F;
    all.D = D; all.w2 = w2; all.lean = lean;
    return all;
}

/* Return whether the axis points up rather than down at the epoch. */
static inline int phd_top_is_upright(const phd_top_reduction_record *top)
{
    return top->s0.hi < top->t0.hi;
}

/* Return whether the displacement was scaled up and grows. */
static inline int phd_top_leaves(const phd_top_reduction_record *top)
{
    return top->lift > 0.0 && phd_top_is_upright(top) && top->D.hi > 0.0;
}

static inline double phd_top_largest(double x, double y)
{
    return phd_larger(fabs(x), fabs(y));
}

/* Turn a top whose centre of mass lies below, and take out powers of two. */
static inline phd_top_scaled_record phd_top_scaled(phd_three moments, double mgl, phd_three momentum, phd_four attitude)
{
    const int turned = mgl < 0.0;
    const double side = turned ? -1.0 : 1.0;
    double weight = fabs(mgl);
    const double w = attitude.at[0], x = attitude.at[1], y = attitude.at[2], z = attitude.at[3];
    double i1 = moments.at[0];
    const double i3 = moments.at[2];
    const double l1 = momentum.at[0], l2 = momentum.at[1], l3 = momentum.at[2];
    const double largest = phd_larger(phd_top_largest(l1, l2), fabs(l3));
    const double of_moment = phd_binary_exponent(i1);
    const double of_momentum = phd_binary_exponent(largest);
    /* the larger of |L| and √(mgl I1), without forming a product that may overflow */
    const double half = floor(0.5 * (of_moment + phd_binary_exponent(weight) + 1.0));
    const double of_both = largest > 0.0 ? phd_larger(of_momentum, half) : half;
    const double exponent = weight > 0.0 ? of_both : of_momentum;
    i1 = phd_times_power(i1, -of_moment);
    weight = phd_times_power(phd_times_power(weight, of_moment - exponent), -exponent);
    /* a half turn about the first body axis: q → q i */
    return phd_make_top_scaled_record(phd_make_pair(i1, phd_times_power(i3, -of_moment)),
        phd_make_three(phd_times_power(l1, -exponent), phd_times_power(side * l2, -exponent),
            phd_times_power(side * l3, -exponent)),
        phd_make_four(turned ? -x : w, turned ? w : x, turned ? z : y, turned ? -y : z), turned, 0.0 * weight, exponent,
        phd_times_power(1.0, exponent), phd_times_power(1.0, exponent - of_moment),
        phd_scale(phd_two_product(weight, i1), 2.0));
}

/* Scale a tiny displacement up; the momentum is the given one, which keeps digits that scaling down has lost.

   Exactly at the threshold of sleeping, 2G = a², where it grows like t and not like e^t, it is dropped: nothing is
   to
   show within 1e27 radians, the longest time for which a motion is given. */
static inline phd_top_scaled_record phd_top_lifted(const phd_top_scaled_record *top, phd_three momentum)
{
    const double w = top->quaternion.at[0], x = top->quaternion.at[1], y = top->quaternion.at[2],
        z = top->quaternion.at[3];
    const double l1 = top->momentum.at[0], l2 = top->momentum.at[1], l3 = top->momentum.at[2];
    const double cosine = phd_top_largest(w, z);
    const double sine = phd_top_largest(x, y);
    const int below = cosine < sine;
    const double displacement = phd_larger(phd_smaller(cosine, sine), phd_top_largest(l1, l2));
    const double exponent = phd_binary_exponent(displacement);
    const phd_pair double_ = phd_scale(top->G, 2.0);
    const phd_pair square = phd_two_product(l3, l3);
    const int threshold = double_.hi == square.hi && double_.lo == square.lo && !below;
    const int tiny = displacement > 0.0 && exponent < PHD_TOP_TINY && top->G.hi > 0.0;
    const double lift = tiny && !threshold ? PHD_TOP_LIFTED - exponent : 0.0;
    const double kept = tiny && threshold ? 0.0 : 1.0;
    const double above = below ? 0.0 : lift;
    const double under = below ? lift : 0.0;
    const double side = top->reversed ? -1.0 : 1.0;
    const double power = lift - top->exponent;
    return phd_make_top_scaled_record(top->moments,
        phd_make_three(kept * phd_times_power(momentum.at[0], power),
            kept * phd_times_power(side * momentum.at[1], power), l3),
        phd_make_four(phd_times_power(w, under), kept * phd_times_power(x, above), kept * phd_times_power(y, above),
            phd_times_power(z, under)), top->reversed, lift, top->exponent, top->momentum_scale, top->rate_scale,
        top->G);
}

/* Return the reduction of invariants times |q|²; s and t are half of them, and in_phase is −p/2. */
static inline phd_top_reduction_record phd_top_over_size(const phd_top_scaled_record *top, phd_pair size, phd_pair s,
    phd_pair t, phd_pair u, phd_pair in_phase, phd_pair c, phd_pair c_plus, phd_pair twist, phd_pair f, phd_pair d,
    phd_pair w2, phd_pair lean)
{
    return phd_make_top_reduction_record(top->moments, top->momentum, top->quaternion, top->reversed, top->lift,
        top->momentum_scale, top->rate_scale, size, top->G, phd_scale(phd_divide(s, size), 2.0),
        phd_scale(phd_divide(t, size), 2.0), phd_divide(u, size), phd_scale(phd_divide(in_phase, size), -2.0),
        phd_divide(c, size), phd_divide(c_plus, size), phd_divide(twist, size), phd_divide(f, size),
        phd_divide(d, size), w2, phd_divide(lean, size));
}

/* Return ab + cd. */
static inline phd_sum phd_top_products(double a, double b, double c, double d)
{
    return phd_join(phd_as_sum(phd_two_product(a, b)), phd_as_sum(phd_two_product(c, d)));
}

static inline phd_sum phd_top_times_pair(phd_sum x, phd_pair y)
{
    return phd_join(phd_multiply_terms(x, y.hi), phd_multiply_terms(x, y.lo));
}

/* Return |q|²: as a pair it would leave F of a planar top only 32 digits of what cancels. */
static inline phd_sum phd_top_size_of(const phd_top_scaled_record *top)
{
    const double w = top->quaternion.at[0], x = top->quaternion.at[1], y = top->quaternion.at[2],
        z = top->quaternion.at[3];
    return phd_compress(phd_join(phd_top_products(x, x, y, y), phd_top_products(w, w, z, z)), 4);
}

/* Return the reduction of a top; its invariants are polynomials of the given floats over |q|², which is size.

   The polynomials are summed exactly, since near the separatrix c, F and D vanish together and what is left of them
   decides how long the top lingers upright; double-double alone would leave nothing. */
static inline phd_top_reduction_record phd_top_exactly_reduced(const phd_top_scaled_record *top, phd_sum size)
{
    const double l1 = top->momentum.at[0], l2 = top->momentum.at[1], l3 = top->momentum.at[2];
    const double w = top->quaternion.at[0], x = top->quaternion.at[1], y = top->quaternion.at[2],
        z = top->quaternion.at[3];
    const phd_sum s = phd_top_products(x, x, y, y);
    const phd_sum t = phd_top_products(w, w, z, z);
    /* of β̄α */
    const phd_sum real = phd_top_products(x, w, y, z);
    const phd_sum imaginary = phd_top_products(x, z, -y, w);
    /* of β̄αw */
    const phd_sum in_phase = phd_compress(phd_join(phd_multiply_terms(real, l1), phd_multiply_terms(imaginary, -l2)),
        4);
    const phd_sum twist = phd_compress(phd_join(phd_multiply_terms(real, 2.0 * l2),
            phd_multiply_terms(imaginary, 2.0 * l1)), 4);
    const phd_sum c = phd_compress(phd_join(twist, phd_multiply_terms(s, -2.0 * l3)), 4);
    const phd_sum c_plus = phd_compress(phd_join(twist, phd_multiply_terms(t, 2.0 * l3)), 4);
    const phd_sum kinetic = phd_join(phd_top_times_pair(size, phd_two_product(l1, l1)),
        phd_top_times_pair(size, phd_two_product(l2, l2)));
    phd_sum fall = phd_as_sum(phd_scale(top->G, -2.0));
    fall = phd_join(phd_top_times_pair(fall, phd_two_product(x, x)), phd_top_times_pair(fall, phd_two_product(y, y)));
    const phd_sum energy = phd_compress(phd_join(kinetic, fall), 5);
    const phd_sum f = phd_compress(phd_join(energy, phd_multiply_terms(c, -l3)), 5);
    const phd_sum rest = phd_join(phd_top_times_pair(size, phd_scale(top->G, 2.0)),
        phd_top_times_pair(size, phd_two_product(l3, -l3)));
    const phd_sum d = phd_compress(phd_join(rest, phd_negated(energy)), 5);
    const phd_sum lean = phd_compress(phd_join(phd_multiply_terms(energy, l3),
            phd_top_times_pair(c, phd_scale(top->G, -1.0))), 6);
    return phd_top_over_size(top, phd_distil(size), phd_distil(s), phd_distil(t),
        phd_distil(phd_join(t, phd_negated(s))), phd_distil(in_phase), phd_distil(c), phd_distil(c_plus),
        phd_distil(twist), phd_distil(f), phd_distil(d), phd_distil(phd_top_products(l1, l1, l2, l2)),
        phd_distil(lean));
}

/* Return the reduction of a top, at any scale and however near the vertical. */
static inline phd_top_reduction_record phd_top_reduction(phd_three moments, double mgl, phd_three momentum,
    phd_four attitude)
{
    const phd_top_scaled_record top = phd_top_scaled(moments, mgl, momentum, attitude);
    const phd_top_scaled_record of_lifted = phd_top_lifted(&top, momentum);
    return phd_top_exactly_reduced(&of_lifted, phd_top_size_of(&top));
}

/* All that evaluation needs of a top: numbers, or arrays with one for each of many.

   Each series has four terms: q^16 is below 1e-21. */
typedef struct {
    double full; /* whether it takes the full form */
    phd_three first; /* of the phase of α [turns per time] */
    phd_three second; /* of the phase of β */
    phd_three third; /* full: of z/2π; complementary: of x/2K */
    phd_pair start; /* the same at the epoch, double-double */
    phd_four a_sum; /* full: sums of the terms e^{±ikz} in A; complementary: their factors of sin ky, k = 1, 3, 5, 7 */
    phd_four a_gap; /* full: differences; complementary: factors of cos ky */
    phd_four b_sum; /* full: as of A; complementary: factors of cos ky, k = 2, 4, 6, 8 */
    phd_four b_gap; /* full: as of A; complementary: factors of sin ky */
    double constant; /* complementary: the constant term of B */
    phd_six nome; /* complementary: q, πK/K' in halves, y_a/π, y_b/π, whether periodic */
    phd_pair signs; /* of c' and c */
    phd_pair rates; /* of w: twice dz/dt or dx'/dt, twice the sum of the linear rates [momentum] */
    phd_four phases; /* cos, sin of the constant phases of α and β */
    double axial; /* L3 */
    double reversed; /* −1 where the axis was turned round */
} phd_top_motion_record;

static inline phd_top_motion_record phd_make_top_motion_record(double full, phd_three first, phd_three second,
    phd_three third, phd_pair start, phd_four a_sum, phd_four a_gap, phd_four b_sum, phd_four b_gap, double constant,
    phd_six nome, phd_pair signs, phd_pair rates, phd_four phases, double axial, double reversed)
{
    phd_top_motion_record all;
    all.full = full; all.first = first; all.second = second; all.third = third; all.start = start; all.a_sum = a_sum;
    all.a_gap = a_gap; all.b_sum = b_sum; all.b_gap = b_gap; all.constant = constant; all.nome = nome;
    all.signs = signs; all.rates = rates; all.phases = phases; all.axial = axial; all.reversed = reversed;
    return all;
}

/* Sum the products, smallest first. */
static inline double phd_top_dot(phd_four x, phd_four y)
{
    const double a = x.at[0], b = x.at[1], c = x.at[2], d = x.at[3];
    const double e = y.at[0], f = y.at[1], g = y.at[2], h = y.at[3];
    return d * h + c * g + b * f + a * e;
}

/* Sum the products times 1, 3, 5 and 7, which a derivative brings. */
static inline double phd_top_odd(phd_four x, phd_four y)
{
    const double a = x.at[0], b = x.at[1], c = x.at[2], d = x.at[3];
    const double e = y.at[0], f = y.at[1], g = y.at[2], h = y.at[3];
    return d * (7.0 * h) + c * (5.0 * g) + b * (3.0 * f) + a * e;
}

/* Sum the products times 2, 4, 6 and 8. */
static inline double phd_top_even(phd_four x, phd_four y)
{
    const double a = x.at[0], b = x.at[1], c = x.at[2], d = x.at[3];
    const double e = y.at[0], f = y.at[1], g = y.at[2], h = y.at[3];
    return d * (8.0 * h) + c * (6.0 * g) + b * (4.0 * f) + a * (2.0 * e);
}

static inline double phd_top_turns(phd_three rate, phd_three time)
{
    const phd_three of_phase = phd_phase(rate, time);
    const double fraction = of_phase.at[0], rest = of_phase.at[1];
    return fraction + rest;
}

/* Sum A, B and their derivatives by z. */
static inline phd_ten phd_top_full_sums(const phd_top_motion_record *m, phd_three time)
{
    const double sa = m->signs.hi, sb = m->signs.lo;
    const phd_three of_phase = phd_phase(m->third, time);
    const double fraction = of_phase.at[0], rest = of_phase.at[1];
    const double z = fraction + (rest + m->start.hi);
    const phd_pair of_sine_cosine = phd_sine_cosine(z - phd_whole(z));
    const double s1 = of_sine_cosine.hi, c1 = of_sine_cosine.lo;
    const double c = 1.0 - 2.0 * s1 * s1;
    const double s = 2.0 * s1 * c1;
    const double c3 = c1 * c - s1 * s;
    const double s3 = s1 * c + c1 * s;
    const double c5 = c3 * c - s3 * s;
    const double s5 = s3 * c + c3 * s;
    const double c7 = c5 * c - s5 * s;
    const double s7 = s5 * c + c5 * s;
    const phd_four cosines = phd_make_four(c1, c3, c5, c7);
    const phd_four sines = phd_make_four(s1, s3, s5, s7);
    return phd_make_ten(phd_top_dot(m->a_sum, sines), -sa * phd_top_dot(m->a_gap, cosines),
        phd_top_dot(m->b_sum, cosines), sb * phd_top_dot(m->b_gap, sines), phd_top_odd(m->a_sum, cosines),
        sa * phd_top_odd(m->a_gap, sines), -phd_top_odd(m->b_sum, sines), sb * phd_top_odd(m->b_gap, cosines),
        phd_top_turns(m->first, time), phd_top_turns(m->second, time));
}

/* Return side, both phases in turns, and exponent and factor of E and of R, which sum A and B. */
static inline phd_seven phd_top_complementary_phase(const phd_top_motion_record *m, phd_three time)
{
    const double upper = m->nome.at[1], lower = m->nome.at[2], ya_turns = m->nome.at[3], yb_turns = m->nome.at[4],
        periodic = m->nome.at[5];
    const double sa = m->signs.hi, sb = m->signs.lo;
    const phd_three of_reduced_argument = phd_reduced_argument(m->third, m->start, periodic, time);
    const double u = of_reduced_argument.at[0], u_rest = of_reduced_argument.at[1], count = of_reduced_argument.at[2];
    const double side = u < 0.0 ? -1.0 : 1.0;
    const double f = u * side;
    const double g = u_rest * side;
    const phd_pair of_exponent = phd_exponent(f, g, upper, lower);
    const double e = of_exponent.hi, e_factor = of_exponent.lo;
    const double distance = phd_larger(0.5 - f, 0.0);
    const phd_pair of_exponent_2 = phd_exponent(distance, (0.5 - distance - f) * periodic - g, upper, lower);
    const double r = of_exponent_2.hi, r_factor = of_exponent_2.lo;
    const double half = 0.5 * (count - 2.0 * floor(0.5 * count));
    const double within = u + u_rest;
    double turns_a = phd_top_turns(m->first, time) + sa * within * ya_turns;
    double turns_b = phd_top_turns(m->second, time) + sb * within * yb_turns;
    turns_a = turns_a - phd_whole(turns_a) + half;
    turns_b = turns_b - phd_whole(turns_b) + half;
    return phd_make_seven(side, turns_a, turns_b, e, e_factor, r, periodic * r_factor);
}

/* Sum A, B and their derivatives by x' in the decaying powers of E = e^−|x'| and the growing ones of R = √q/E. */
static inline phd_ten phd_top_complementary_sums(const phd_top_motion_record *m, double side, double turns_a,
    double turns_b, double e0, double R)
{
    const double q = m->nome.at[0];
    const double sa = m->signs.hi, sb = m->signs.lo;
    const double h = e0 * e0;
    const double r = R * R;
    const double h2 = h * h;
    const double h3 = h * h2;
    const double h5 = h3 * h2;
    const double h7 = h5 * h2;
    const double q2 = q * q;
    const double q3 = q2 * q;
    const double w1 = q * r;
    const double w2 = q2 * r;
    const double w3 = q3 * r;
    const double p1 = q * h;
    const double p2 = q2 * h;
    const double p3 = q3 * h;
    const double p4 = q2 * q2 * h;
    const double v2 = w2 * w2;
    double v3 = w3 * w3;
    const double u1 = w1 * w1;
    const double u2 = v2 * w2;
    const double u3 = v3 * v3;
    const double d2 = p2 * p2;
    const double d3 = p3 * p3 * p3;
    const double d4 = p4 * p4 * (p4 * p4);
    v3 = v3 * w3;
    const phd_four sums = phd_make_four(1.0 + h, w1 * (1.0 + h3), v2 * (1.0 + h5), v3 * (1.0 + h7));
    const phd_four gaps = phd_make_four(1.0 - h, w1 * (1.0 - h3), v2 * (1.0 - h5), v3 * (1.0 - h7));
    const phd_four up = phd_make_four(r + p1, u1 + d2, u2 + d3, u3 + d4);
    const phd_four down = phd_make_four(r - p1, u1 - d2, u2 - d3, u3 - d4);
    const double e = 2.0 * e0;
    return phd_make_ten(phd_top_dot(m->a_sum, sums), sa * side * phd_top_dot(m->a_gap, gaps),
        e * (m->constant + phd_top_dot(m->b_sum, up)), -sb * side * e * phd_top_dot(m->b_gap, down),
        side * phd_top_odd(m->a_sum, gaps), sa * phd_top_odd(m->a_gap, sums), side * e * phd_top_even(m->b_sum, down),
        -sb * e * phd_top_even(m->b_gap, up), turns_a, turns_b);
}

/* Return attitude and momentum: α = A e^{iφ_a}, β = B e^{iφ_b} over their norm, and w. */
static inline phd_seven phd_top_state_of(const phd_top_motion_record *m, phd_ten sums)
{
    const double ar = sums.at[0], ai = sums.at[1], br = sums.at[2], bi = sums.at[3], dar = sums.at[4], dai = sums.at[5],
        dbr = sums.at[6], dbi = sums.at[7], turns_a = sums.at[8], turns_b = sums.at[9];
    const double by_argument = m->rates.hi, by_phase = m->rates.lo;
    const double c0 = m->phases.at[0], s0 = m->phases.at[1], c1 = m->phases.at[2], s1 = m->phases.at[3];
    double x = 1.0 / (ar * ar + ai * ai + (br * br + bi * bi));
    const double root = sqrt(x);
    const phd_pair of_sine_cosine = phd_sine_cosine(turns_a - phd_whole(turns_a));
    double s = of_sine_cosine.hi;
    double c = of_sine_cosine.lo;
    const double ca = c * c0 - s * s0;
    const double sa = s * c0 + c * s0;
    const phd_pair of_sine_cosine_2 = phd_sine_cosine(turns_b - phd_whole(turns_b));
    s = of_sine_cosine_2.hi;
    c = of_sine_cosine_2.lo;
    const double cb = c * c1 - s * s1;
    const double sb = s * c1 + c * s1;
    const double ar_t = (ar * ca - ai * sa) * root;
    const double ai_t = (ar * sa + ai * ca) * root;
    const double br_t = (br * cb - bi * sb) * root;
    const double bi_t = (br * sb + bi * cb) * root;
    /* ĀB' − BĀ' and i ĀB */
    const double gain_r = ar * dbr + ai * dbi - (br * dar + bi * dai);
    const double gain_i = ar * dbi - ai * dbr - (bi * dar - br * dai);
    const double turn_r = ai * br - ar * bi;
    const double turn_i = ar * br + ai * bi;
    const double wr = (by_argument * gain_r + by_phase * turn_r) * x;
    const double wi = (by_argument * gain_i + by_phase * turn_i) * x;
    const double cw = cb * ca + sb * sa;
    const double sw = sb * ca - cb * sa;
    const double side = m->reversed;
    const int turned = side < 0.0;
    const phd_pair of_w_z = turned ? phd_make_pair(br_t, bi_t) : phd_make_pair(ar_t, ai_t);
    const double w = of_w_z.hi, z = of_w_z.lo;
    const phd_pair of_x_y = turned ? phd_make_pair(ar_t, ai_t) : phd_make_pair(br_t, bi_t);
    x = of_x_y.hi;
    const double y = of_x_y.lo;
    return phd_make_seven(w, side * x, side * y, z, wr * cw - wi * sw, side * (wr * sw + wi * cw), m->axial);
}

/* Return attitude and momentum of a motion at a time, given in two parts. */
static inline phd_seven phd_top_state_at(const phd_top_motion_record *m, double time, double rest)
{
    const phd_pair of_halves = phd_halves(time);
    const double high = of_halves.hi, low = of_halves.lo;
    if (m->full != 0.0) {
        return phd_top_state_of(m, phd_top_full_sums(m, phd_make_three(high, low, rest)));
    }
    const phd_seven of_complementary_phase = phd_top_complementary_phase(m, phd_make_three(high, low, rest));
    const double a = of_complementary_phase.at[0], b = of_complementary_phase.at[1], c = of_complementary_phase.at[2],
        exponent = of_complementary_phase.at[3], factor = of_complementary_phase.at[4],
        other = of_complementary_phase.at[5], other_factor = of_complementary_phase.at[6];
    const double e0 = exp(exponent) * factor;
    const double R = exp(other) * other_factor;
    return phd_top_state_of(m, phd_top_complementary_sums(m, a, b, c, e0, R));
}

/* binary exponent down to which a square has all its digits */
static const double PHD_TOP_SQUARABLE = -400.0;
/* of cos(⅓ acos x), 0 ≤ x ≤ 1, to 2e-4 */
static const double PHD_TOP_BEGIN = 0.8660254;
static const double PHD_TOP_SLOPE = 0.1642;
static const double PHD_TOP_CURVE = -0.0302;
/* steps of Newton's, of all and of any: two do, three more where the start was poor */
static const int PHD_TOP_AT_ONCE = 2;
static const int PHD_TOP_MOST = 5;
/* of the last change over the root: what is left is smaller by a float64's precision */
static const double PHD_TOP_CONVERGED = 8.673617379884035e-19;
/* Distances between the roots, the poles u = ±1 and the start u0, each as a number of its own. */
typedef struct {
    phd_pair from_lower; /* u0 − u1 */
    phd_pair from_upper; /* u2 − u0 */
    phd_pair d; /* u2 − u1 */
    phd_pair s1; /* 1 − u1 */
    phd_pair s2; /* 1 − u2 */
    phd_pair t1; /* 1 + u1 */
    phd_pair t2; /* 1 + u2 */
    phd_pair A; /* G (u3 − u1) */
    phd_pair B; /* G (u3 − u2) */
    phd_pair Y; /* G (u3 − u0) */
    phd_pair Z_minus; /* G (u3 − 1) */
    phd_pair Z_plus; /* G (u3 + 1) */
} phd_top_turning_points_record;

static inline phd_top_turning_points_record phd_make_top_turning_points_record(phd_pair from_lower, phd_pair from_upper,
    phd_pair d, phd_pair s1, phd_pair s2, phd_pair t1, phd_pair t2, phd_pair A, phd_pair B, phd_pair Y,
    phd_pair Z_minus, phd_pair Z_plus)
{
    phd_top_turning_points_record all;
    all.from_lower = from_lower; all.from_upper = from_upper; all.d = d; all.s1 = s1; all.s2 = s2; all.t1 = t1;
    all.t2 = t2; all.A = A; all.B = B; all.Y = Y; all.Z_minus = Z_minus; all.Z_plus = Z_plus;
    return all;
}

typedef struct { phd_pair at[3]; } phd_three_pairs;

static inline phd_three_pairs phd_make_three_pairs(phd_pair x0, phd_pair x1, phd_pair x2)
{
    phd_three_pairs all;
    all.at[0] = x0; all.at[1] = x1; all.at[2] = x2;
    return all;
}

/* The cubic whose largest root stands apart from the others. */
typedef struct {
    int upper; /* whether it is that of Y, and the root u3, or that of s, and the root u1 */
    phd_three_pairs cubic;
    double start; /* near the root */
    phd_pair f1;
} phd_top_apart_record;

static inline phd_top_apart_record phd_make_top_apart_record(int upper, phd_three_pairs cubic, double start,
    phd_pair f1)
{
    phd_top_apart_record all;
    all.upper = upper; all.cubic = cubic; all.start = start; all.f1 = f1;
    return all;
}

typedef struct {
    phd_pair first;
    phd_three_pairs second;
    phd_three_pairs third;
} phd_pair_two_three_pairss;

static inline phd_pair_two_three_pairss phd_make_pair_two_three_pairss(phd_pair first, phd_three_pairs second,
    phd_three_pairs third)
{
    phd_pair_two_three_pairss all;
    all.first = first; all.second = second; all.third = third;
    return all;
}

/* Return f1, and the cubics x³ + bx² + cx + d of Y = G (u3 − u0) and of s = 1 − u1; inverse is 1/G. */
static inline phd_pair_two_three_pairss phd_top_cubics(double axial, phd_pair g, phd_pair inverse, phd_pair s0,
    phd_pair t0, phd_pair u0, phd_pair w2, phd_pair twist, phd_pair p2, phd_pair c2, phd_pair d, phd_pair f)
{
    /* with v = u − u0 and the |w|² of the start, u̇² = (1 − u²)(|w|² − G v) − (b − a u)² = p² + f1 v + f2 v² + G v³,
       and with s = 1 − u it is −(G s³ − D s² − 2F s + c²) */
    phd_pair f1 = phd_subtract(phd_scale(phd_multiply_float(twist, axial), 2.0), phd_multiply(g, phd_multiply(s0, t0)));
    f1 = phd_subtract(f1, phd_scale(phd_multiply(u0, w2), 2.0));
    const phd_pair f2 = phd_subtract(phd_subtract(phd_scale(phd_multiply(g, u0), 2.0), w2), phd_two_square(axial));
    d = phd_multiply(d, inverse);
    f = phd_multiply(f, inverse);
    return phd_make_pair_two_three_pairss(f1,
        phd_make_three_pairs(f2, phd_multiply(g, f1), phd_multiply(phd_square(g), p2)),
        phd_make_three_pairs(phd_make_pair(-d.hi, -d.lo), phd_scale(f, -2.0), phd_multiply(c2, inverse)));
}

/* Return b/3, r and cos 3φ of a cubic with real roots, of which 2r cos φ − b/3 is the largest. */
static inline phd_three phd_top_by_angle(phd_three_pairs cubic)
{
    /* x = 2r cos φ − b/3 with r = √(−P/3) and cos 3φ = −Q/2r³ */
    const double b = cubic.at[0].hi;
    const double c = cubic.at[1].hi;
    const double d = cubic.at[2].hi;
    const double third = b / 3.0;
    const double p = c - b * third;
    const double q = 2.0 * (third * third) * third - third * c + d;
    const double r = sqrt(phd_larger(-p / 3.0, 0.0 * p));
    return phd_make_three(third, r, r > 0.0 ? -0.5 * q / (r > 0.0 ? r * r * r : 1.0) : 1.0);
}

/* Return the cubic whose largest root stands apart. */
static inline phd_top_apart_record phd_top_apart(const phd_top_reduction_record *top)
{
    const int weightless = !(top->G.hi > 0.0);
    const phd_pair one = PHD_TOP_ONE;
    const phd_pair_two_three_pairss of_cubics = phd_top_cubics(top->momentum.at[2], top->G,
        phd_divide(one, weightless ? one : top->G), top->s0, top->t0, top->u0, top->w2, top->twist, phd_square(top->p),
        phd_square(top->c), top->D, top->F);
    const phd_pair f1 = of_cubics.first;
    const phd_three_pairs of_y = of_cubics.second, of_s = of_cubics.third;
    const phd_three of_by_angle = phd_top_by_angle(of_y);
    const double third = of_by_angle.at[0], r = of_by_angle.at[1], cosine = of_by_angle.at[2];
    const phd_three of_by_angle_2 = phd_top_by_angle(of_s);
    const double other_third = of_by_angle_2.at[0], other_r = of_by_angle_2.at[1], other = of_by_angle_2.at[2];
    const int upper = cosine >= 0.0 || weightless;
    double x = upper ? cosine : other;
    x = phd_smaller(phd_larger(x, 0.0 * x), 1.0 + 0.0 * x);
    /* cos φ is a root of 4 y³ − 3 y = x */
    double y = PHD_TOP_BEGIN + x * (PHD_TOP_SLOPE + x * PHD_TOP_CURVE);
    y = (8.0 * y * y * y + x) / (12.0 * y * y - 3.0);
    y = (8.0 * y * y * y + x) / (12.0 * y * y - 3.0);
    const phd_three_pairs cubic = phd_make_three_pairs(upper ? of_y.at[0] : of_s.at[0], upper ? of_y.at[1] : of_s.at[1],
        upper ? of_y.at[2] : of_s.at[2]);
    return phd_make_top_apart_record(upper, cubic, 2.0 * (upper ? r : other_r) * y - (upper ? third : other_third), f1);
}

typedef struct {
    phd_pair first;
    double second;
    phd_three_pairs third;
} phd_pair_number_three_pairs;

static inline phd_pair_number_three_pairs phd_make_pair_number_three_pairs(phd_pair first, double second,
    phd_three_pairs third)
{
    phd_pair_number_three_pairs all;
    all.first = first; all.second = second; all.third = third;
    return all;
}

/* Return the root before the first step. */
static inline phd_pair_number_three_pairs phd_top_begun(const phd_top_apart_record *lone)
{
    return phd_make_pair_number_three_pairs(phd_make_pair(lone->start, 0.0 * lone->start), lone->start, lone->cubic);
}

/* Return a root after a step of Newton's, whose slope need not be sharp. */
static inline phd_pair_number_three_pairs phd_top_nearer(phd_pair_number_three_pairs root)
{
    const phd_pair x = root.first;
    const phd_three_pairs cubic = root.third;
    const phd_pair b = cubic.at[0], c = cubic.at[1], d = cubic.at[2];
    const phd_pair value = phd_add(phd_multiply(phd_add(phd_multiply(phd_add(x, b), x), c), x), d);
    double change = -value.hi / ((3.0 * x.hi + 2.0 * b.hi) * x.hi + c.hi);
    change = change - change == 0.0 ? change : 0.0;
    return phd_make_pair_number_three_pairs(phd_add(x, phd_make_pair(change, 0.0 * change)), change, cubic);
}

/* Return whether the last change leaves nothing to be changed. */
static inline int phd_top_is_found(phd_pair_number_three_pairs root)
{
    const phd_pair x = root.first;
    const double change = root.second;
    return x.hi > 0.0 && fabs(change) <= PHD_TOP_CONVERGED * x.hi;
}

/* Return x / y, and zero for x = 0 whatever y. */
static inline phd_pair phd_top_quotient(phd_pair x, phd_pair y)
{
    const int zero = x.hi == 0.0;
    return zero ? x : phd_divide(x, zero ? PHD_TOP_ONE : y);
}

/* Return x + y = √((x − y)² + 4 x y), also where the square underflows. */
static inline phd_pair phd_top_difference(phd_pair total, phd_pair product)
{
    const double exponent = phd_binary_exponent(total.hi);
    const int alone = product.hi == 0.0 || phd_binary_exponent(product.hi) < 2.0 * exponent;
    const double power = total.hi != 0.0 && exponent < PHD_TOP_SQUARABLE && alone ? -exponent : 0.0;
    const double up = phd_times_power(1.0, power);
    const phd_pair raised = phd_scale(phd_scale(product, up), up);
    return phd_scale(phd_root_or_zero(phd_add(phd_square(phd_scale(total, up)), phd_scale(raised, 4.0))),
        phd_times_power(1.0, -power));
}

/* Return x ≥ 0 and y ≥ 0 from x − y, x + y and x y. */
static inline phd_two_pairs phd_top_larger_and_smaller(phd_pair total, phd_pair sum_, phd_pair product)
{
    const int positive = total.hi >= 0.0;
    const phd_pair most = phd_scale(phd_add(sum_, positive ? total : phd_make_pair(-total.hi, -total.lo)), 0.5);
    const phd_pair least = most.hi > 0.0 ? phd_top_quotient(product, most) : PHD_TOP_ZERO;
    return phd_make_two_pairs(positive ? most : least, positive ? least : most);
}

typedef struct { phd_pair at[9]; } phd_nine_pairs;

static inline phd_nine_pairs phd_make_nine_pairs(phd_pair x0, phd_pair x1, phd_pair x2, phd_pair x3, phd_pair x4,
    phd_pair x5, phd_pair x6, phd_pair x7, phd_pair x8)
{
    phd_nine_pairs all;
    all.at[0] = x0; all.at[1] = x1; all.at[2] = x2; all.at[3] = x3; all.at[4] = x4; all.at[5] = x5; all.at[6] = x6;
    all.at[7] = x7; all.at[8] = x8;
    return all;
}

/* From Y = G (u3 − u0): with v = u − u0, v1 + v2 = (f1 + G p²/Y)/Y and v1 v2 = −p²/Y. */
static inline phd_nine_pairs phd_top_upper_root_apart(phd_pair g, phd_pair s0, phd_pair p2, phd_pair c2, phd_pair f1,
    phd_pair y)
{
    const phd_pair product = phd_top_quotient(p2, y);
    const phd_pair total = phd_top_quotient(phd_add(f1, phd_multiply(g, product)), y);
    const phd_pair gap = phd_top_difference(total, product);
    const phd_two_pairs of_larger_and_smaller = phd_top_larger_and_smaller(total, gap, product);
    const phd_pair upper = of_larger_and_smaller.at[0], lower = of_larger_and_smaller.at[1];
    const phd_pair s1 = phd_add(s0, lower);
    phd_pair s2 = phd_subtract(s0, upper);
    phd_pair z = phd_subtract(y, phd_multiply(g, s0));
    /* s1 s2 Z = c²; of s2 and Z only the larger is an accurate difference */
    const int take = z.hi >= phd_multiply(g, s2).hi;
    const phd_pair other = phd_top_quotient(c2, phd_multiply(s1, take ? z : s2));
    s2 = take ? other : s2;
    z = take ? z : other;
    return phd_make_nine_pairs(lower, upper, gap, s1, s2, phd_add(y, phd_multiply(g, lower)),
        phd_subtract(y, phd_multiply(g, upper)), y, z);
}

/* From s1 = 1 − u1: s2 + s3 = (c²/s1 − 2F)/(G s1) and s2 s3 = −c²/(G s1). */
static inline phd_nine_pairs phd_top_lower_root_apart(phd_pair g, phd_pair s0, phd_pair p2, phd_pair c2, phd_pair f,
    phd_pair s1)
{
    const phd_pair gs = phd_multiply(g, s1);
    const phd_pair product = phd_top_quotient(c2, gs);
    const phd_pair total = phd_divide(phd_add(phd_scale(f, -2.0), phd_top_quotient(c2, s1)), gs);
    const phd_pair between = phd_top_difference(total, product);
    const phd_two_pairs of_larger_and_smaller = phd_top_larger_and_smaller(total, between, product);
    const phd_pair s2 = of_larger_and_smaller.at[0], minus_s3 = of_larger_and_smaller.at[1];
    const phd_pair z = phd_multiply(g, minus_s3);
    const phd_pair y = phd_add(phd_multiply(g, s0), z);
    phd_pair upper = phd_subtract(s0, s2);
    phd_pair lower = phd_subtract(s1, s0);
    const int take = upper.hi >= lower.hi;
    const phd_pair other = phd_top_quotient(phd_top_quotient(p2, y), take ? upper : lower);
    upper = take ? upper : other;
    lower = take ? other : lower;
    return phd_make_nine_pairs(lower, upper, phd_subtract(s1, s2), s1, s2, phd_multiply(g, phd_add(s1, minus_s3)),
        phd_multiply(g, between), y, z);
}

/* Return the turning points from the separate root, Y or else s1. */
static inline phd_top_turning_points_record phd_top_turning_points_of(const phd_top_reduction_record *top, int is_upper,
    phd_pair lone, phd_pair f1)
{
    const phd_pair g = top->G;
    const phd_pair s0 = top->s0;
    const phd_pair t0 = top->t0;
    const phd_pair p2 = phd_square(top->p);
    const phd_pair c2 = phd_square(top->c);
    const phd_nine_pairs x = phd_top_upper_root_apart(g, s0, p2, c2, f1, lone);
    const phd_nine_pairs y = phd_top_lower_root_apart(g.hi > 0.0 ? g : PHD_TOP_ONE, s0, p2, c2, top->F, lone);
    const phd_pair upper = is_upper ? x.at[1] : y.at[1];
    const phd_pair above = is_upper ? x.at[7] : y.at[7];
    const phd_pair t2 = phd_add(t0, upper);
    const phd_pair z = phd_add(above, phd_multiply(g, t0));
    return phd_make_top_turning_points_record(is_upper ? x.at[0] : y.at[0], upper, is_upper ? x.at[2] : y.at[2],
        is_upper ? x.at[3] : y.at[3], is_upper ? x.at[4] : y.at[4],
        phd_top_quotient(phd_square(top->c_plus), phd_multiply(t2, z)), t2, is_upper ? x.at[5] : y.at[5],
        is_upper ? x.at[6] : y.at[6], above, is_upper ? x.at[8] : y.at[8], z);
}

/* Return the turning points of a top. */
static inline phd_top_turning_points_record phd_top_turning_points(const phd_top_reduction_record *top)
{
    const phd_top_apart_record lone = phd_top_apart(top);
    phd_pair_number_three_pairs running = phd_top_begun(&lone);
    for (int k = 0; k < PHD_TOP_MOST; k++) {
        if (k >= PHD_TOP_AT_ONCE && phd_top_is_found(running)) {
            break;
        }
        running = phd_top_nearer(running);
    }
    const phd_pair root = running.first;
    return phd_top_turning_points_of(top, lone.upper, root, lone.f1);
}

/* Rates by τ = t/I1 in scaled units; all but the signs and flags are double-double. */
typedef struct {
    phd_pair half_root; /* W = ½√A: x = x0 + W τ */
    phd_pair nutation; /* ϖ = ½ agm(√A, √B) = πW/2K, zero on the separatrix */
    phd_pair alpha; /* linear rates of the phases of α and β apart from their theta quotients */
    phd_pair beta;
    double sign_alpha; /* sgn c' and sgn c, +1 for zero */
    double sign_beta;
    phd_pair spin; /* ν I1, the spin that I3 ≠ I1 adds, by τ */
    int permanent; /* the momentum stays: sleeping, hanging, rest */
    int separatrix;
    int steady; /* the tilt stays */
} phd_top_frequencies_record;

static inline phd_top_frequencies_record phd_make_top_frequencies_record(phd_pair half_root, phd_pair nutation,
    phd_pair alpha, phd_pair beta, double sign_alpha, double sign_beta, phd_pair spin, int permanent, int separatrix,
    int steady)
{
    phd_top_frequencies_record all;
    all.half_root = half_root; all.nutation = nutation; all.alpha = alpha; all.beta = beta; all.sign_alpha = sign_alpha;
    all.sign_beta = sign_beta; all.spin = spin; all.permanent = permanent; all.separatrix = separatrix;
    all.steady = steady;
    return all;
}

/* What the means start from, and harmless numbers where there is no period. */
typedef struct {
    phd_pair root_A;
    phd_pair root_B;
    phd_pair alpha; /* p² of the sums of α and β */
    phd_pair beta;
    int permanent;
    int separatrix;
} phd_top_starts_record;

static inline phd_top_starts_record phd_make_top_starts_record(phd_pair root_A, phd_pair root_B, phd_pair alpha,
    phd_pair beta, int permanent, int separatrix)
{
    phd_top_starts_record all;
    all.root_A = root_A; all.root_B = root_B; all.alpha = alpha; all.beta = beta; all.permanent = permanent;
    all.separatrix = separatrix;
    return all;
}

/* Return p² at the start of the sum of α; first says that it takes the form that starts from Z. */
static inline phd_pair phd_top_start_of_alpha(int first, phd_pair a, phd_pair z_plus, phd_pair t1, phd_pair t2)
{
    return first ? z_plus : phd_divide(phd_multiply(a, t2), first ? PHD_TOP_ONE : t1);
}

/* Return p² of the sum of β. Where c = 0 the factor of the sum vanishes, and p² must only not be zero. */
static inline phd_pair phd_top_start_of_beta(int first, phd_pair c, phd_pair a, phd_pair b, phd_pair z_minus,
    phd_pair s1, phd_pair s2)
{
    const phd_pair other = phd_divide(phd_multiply(s1, b), first ? PHD_TOP_ONE : s2);
    return first ? (c.hi == 0.0 ? a : z_minus) : other;
}

/* Return cG/(4Z) Σ in the first form, |c|/(2 near) [1 − d/(2 far) Σ] − ϖ in the second. */
static inline phd_pair phd_top_drift(int first, phd_pair c, phd_pair g, phd_pair z, phd_pair near, phd_pair far,
    phd_pair d, phd_pair nutation, phd_pair total)
{
    const int idle = c.hi == 0.0;
    const phd_pair ratio = phd_divide(first ? phd_multiply(c, g) : c, idle ? PHD_TOP_ONE : first ? z : near);
    const phd_pair share = phd_subtract(PHD_TOP_ONE, phd_scale(phd_multiply(phd_divide(d, far), total), 0.5));
    return first
        ? phd_scale(phd_multiply(ratio, total), 0.25)
        : phd_subtract(phd_multiply(phd_scale(ratio, 0.5), share), nutation);
}

/* Return ν I1, the spin that I3 ≠ I1 adds, by τ. */
static inline phd_pair phd_top_spin(double i1, double i3, double axial)
{
    return phd_divide(phd_multiply_float(phd_two_sum(i1, -i3), axial), phd_make_pair(i3, 0.0));
}

/* Return a rate by τ as turns per time. */
static inline phd_pair phd_top_turns_per_time(phd_pair rate, double i1, double rate_scale)
{
    const phd_pair inverse = phd_divide(PHD_INVERSE_TWO_PI, phd_make_pair(i1, 0.0));
    return phd_multiply(rate, phd_scale(inverse, rate_scale));
}

/* Return the rate of x/2K [half periods per time]. */
static inline phd_pair phd_top_half_periods(phd_pair nutation, double i1, double rate_scale)
{
    return phd_divide(phd_scale(nutation, rate_scale), phd_multiply_float(PHD_PI, i1));
}

/* Return K and πK/K', of the nome of the smaller parameter. */
static inline phd_two_pairs phd_top_periods(phd_pair half_root, phd_pair nutation, double nome)
{
    const phd_pair quarter = phd_divide(phd_scale(phd_multiply(half_root, PHD_PI), 0.5), nutation);
    return phd_make_two_pairs(quarter, phd_by_theta(phd_scale(quarter, 2.0), nome));
}

static inline int phd_top_first_alpha(const phd_top_turning_points_record *points)
{
    return points->Z_plus.hi <= 2.0 * points->A.hi;
}

static inline int phd_top_first_beta(const phd_top_reduction_record *top, const phd_top_turning_points_record *points)
{
    return phd_multiply(top->G, points->s2).hi <= points->Z_minus.hi;
}

/* Return what the means start from. */
static inline phd_top_starts_record phd_top_starts_of(const phd_top_reduction_record *top,
    const phd_top_turning_points_record *points)
{
    const double a = top->momentum.at[2];
    const int vertical = top->s0.hi == 0.0 || top->t0.hi == 0.0;
    const int permanent = top->w2.hi == 0.0 && (vertical || (top->G.hi == 0.0 && a == 0.0));
    const int separatrix = !(points->B.hi > 0.0) && !permanent;
    const int idle = permanent || separatrix;
    const phd_pair one = PHD_TOP_ONE;
    const phd_pair alpha = phd_top_start_of_alpha(phd_top_first_alpha(points), points->A, points->Z_plus, points->t1,
        points->t2);
    const int first = phd_top_first_beta(top, points);
    const phd_pair beta = phd_top_start_of_beta(first, top->c, points->A, points->B, points->Z_minus, points->s1,
        points->s2);
    return phd_make_top_starts_record(idle ? one : phd_root_or_zero(points->A),
        idle ? one : phd_root_or_zero(points->B), idle ? one : alpha, idle ? one : beta, permanent, separatrix);
}

/* Return the frequencies of a top as its displacement is scaled, of the mean and the third-kind sums. */
static inline phd_top_frequencies_record phd_top_frequencies_of(const phd_top_reduction_record *top,
    const phd_top_turning_points_record *points, const phd_top_starts_record *start, phd_pair mean,
    phd_pair total_alpha, phd_pair total_beta)
{
    const phd_pair nutation = phd_scale(mean, 0.5);
    const int separatrix = start->separatrix;
    const double sign_alpha = top->c_plus.hi >= 0.0 ? 1.0 : -1.0;
    const double sign_beta = top->c.hi >= 0.0 ? 1.0 : -1.0;
    const phd_pair c_plus = phd_scale(top->c_plus, sign_alpha);
    const phd_pair c = phd_scale(top->c, sign_beta);
    const int first = phd_top_first_beta(top, points);
    phd_pair alpha = phd_top_drift(phd_top_first_alpha(points), c_plus, top->G, points->Z_plus, points->t1, points->t2,
        points->d, nutation, total_alpha);
    phd_pair beta = phd_top_drift(first, c, top->G, points->Z_minus, points->s2, points->s1, points->d, nutation,
        total_beta);
    alpha = phd_scale(separatrix ? phd_scale(c_plus, 0.25) : alpha, sign_alpha);
    beta = phd_scale(separatrix ? PHD_TOP_ZERO : beta, first ? -sign_beta : sign_beta);
    const int steady = !(points->d.hi > 0.0 || start->permanent || separatrix);
    return phd_make_top_frequencies_record(phd_scale(phd_root_or_zero(points->A), 0.5),
        separatrix ? PHD_TOP_ZERO : nutation, alpha, beta, sign_alpha, sign_beta,
        phd_top_spin(top->moments.hi, top->moments.lo, top->momentum.at[2]), start->permanent, separatrix, steady);
}

/* Return the x = W τ after which the displacement of a top that leaves the vertical has the lifted one's size. */
static inline phd_pair phd_top_climb(const phd_top_reduction_record *top)
{
    return phd_multiply_float(PHD_LN2, phd_top_leaves(top) ? top->lift : 0.0);
}

/* Return the frequencies of tops that leave the vertical from those of the lifted ones.

   The displacement grows and falls as e^{±x}, so K = πW/2ϖ is longer by climb. During it α turns by c'/4 and
   β not at all, so the turns of a nutation that are beyond that stay unchanged and their mean rates shrink as ϖ
   does. */
static inline phd_top_frequencies_record phd_top_lingering(const phd_top_reduction_record *top,
    const phd_top_frequencies_record *rates)
{
    const phd_pair W = rates->half_root;
    const phd_pair c_plus = phd_scale(top->c_plus, 0.25);
    const phd_pair one = PHD_TOP_ONE;
    const phd_pair pi = PHD_PI;
    const int lingers = phd_top_leaves(top);
    /* climb/K */
    const phd_pair longer = phd_scale(phd_divide(phd_multiply(phd_top_climb(top), rates->nutation),
            phd_multiply(pi, W)), 2.0);
    const phd_pair share = phd_divide(one, phd_add(one, longer));
    const phd_pair alpha = phd_add(c_plus, phd_multiply(phd_subtract(rates->alpha, c_plus), share));
    return phd_make_top_frequencies_record(W, lingers ? phd_multiply(rates->nutation, share) : rates->nutation,
        lingers ? alpha : rates->alpha, lingers ? phd_multiply(rates->beta, share) : rates->beta, rates->sign_alpha,
        rates->sign_beta, rates->spin, rates->permanent, rates->separatrix, rates->steady);
}

/* Return the frequencies of a reduced top. */
static inline phd_top_frequencies_record phd_top_frequencies(const phd_top_reduction_record *top,
    const phd_top_turning_points_record *points)
{
    const phd_top_starts_record start = phd_top_starts_of(top, points);
    const phd_two_pairs of_third_kind_mean = phd_third_kind_mean(start.root_A, start.root_B, start.alpha);
    const phd_pair mean = of_third_kind_mean.at[0], total_alpha = of_third_kind_mean.at[1];
    const phd_two_pairs of_third_kind_mean_2 = phd_third_kind_mean(start.root_A, start.root_B, start.beta);
    const phd_pair total_beta = of_third_kind_mean_2.at[1];
    const phd_top_frequencies_record of_frequencies_of = phd_top_frequencies_of(top, points, &start, mean, total_alpha,
        total_beta);
    return phd_top_lingering(top, &of_frequencies_of);
}

/* Return the rates of the phases of α and β [turns per time], the spin that I3 ≠ I1 adds included. */
static inline phd_two_pairs phd_top_phase_rates(const phd_top_reduction_record *top,
    const phd_top_frequencies_record *rates)
{
    const phd_pair half = phd_scale(rates->spin, 0.5);
    const double i1 = top->moments.hi, i3 = top->moments.lo;
    const phd_pair own = phd_divide(phd_two_product(0.5 * top->momentum.at[2], i1), phd_make_pair(i3, 0.0));
    const phd_pair alpha = rates->permanent ? own : phd_add(rates->alpha, half);
    const phd_pair beta = rates->permanent ? phd_make_pair(-own.hi, -own.lo) : phd_subtract(rates->beta, half);
    return phd_make_two_pairs(phd_top_turns_per_time(alpha, i1, top->rate_scale),
        phd_top_turns_per_time(beta, i1, top->rate_scale));
}

static const int PHD_TOP_MOST_STEPS = 40;
/* of the spread, whose eighth power is what the closing formula leaves */
static const double PHD_TOP_CLOSE = 0.01;
static const double PHD_TOP_CLOSER = 0.002;
/* Elliptic integrals of the first kind. */
typedef struct {
    double v_alpha; /* distances of α's and β's poles from the real axis; infinite where the tilt stays */
    double v_beta;
    double w_alpha; /* K' − v, of the full form */
    double w_beta;
    phd_pair x0; /* distance of the start from the lowest place */
} phd_top_integrals_record;

static inline phd_top_integrals_record phd_make_top_integrals_record(double v_alpha, double v_beta, double w_alpha,
    double w_beta, phd_pair x0)
{
    phd_top_integrals_record all;
    all.v_alpha = v_alpha; all.v_beta = v_beta; all.w_alpha = w_alpha; all.w_beta = w_beta; all.x0 = x0;
    return all;
}

/* Return what R_F is more than one over the root of the mean, of relative distances from it (DLMF 19.36.1). */
static inline double phd_top_series(double x, double y)
{
    const double z = -x - y;
    const double second = x * y - z * z;
    const double third = x * y * z;
    double higher = second * second * (1.0 / 24.0 - second * (5.0 / 208.0)) - second * third * (3.0 / 44.0);
    higher = higher + third * (3.0 / 104.0 * third + 0.0625 * second * second);
    return higher + third * (1.0 / 14.0) - 0.1 * second;
}

/* Return the largest distance from the mean over it. */
static inline double phd_top_widest(double x, double y, double z)
{
    const double mean = (x + y + z) / 3.0;
    return phd_larger(phd_larger(fabs(mean - x), fabs(mean - y)), fabs(mean - z)) / mean;
}

/* Return numbers of equal R_F, nearer to each other (DLMF §19.26(iii)). */
static inline phd_three phd_top_duplicated(phd_three now)
{
    const double x = now.at[0], y = now.at[1], z = now.at[2];
    const double a = sqrt(x);
    const double b = sqrt(y);
    const double c = sqrt(z);
    const double more = a * b + b * c + c * a;
    return phd_make_three(0.25 * (x + more), 0.25 * (y + more), 0.25 * (z + more));
}

/* Return whether the closing formula has all digits of a float. */
static inline int phd_top_is_close(phd_three now)
{
    return phd_top_widest(now.at[0], now.at[1], now.at[2]) <= PHD_TOP_CLOSE;
}

/* Return R_F of numbers next to each other, NaN of others. */
static inline double phd_top_closed(phd_three now)
{
    const double x = now.at[0], y = now.at[1], z = now.at[2];
    const double mean = (x + y + z) / 3.0;
    return phd_top_is_close(now) ? (1.0 + phd_top_series(1.0 - x / mean, 1.0 - y / mean)) / sqrt(mean) : NAN;
}

/* Return duplicated in double-double. */
static inline phd_three_pairs phd_top_duplicated_sharply(phd_three_pairs now)
{
    const phd_pair x = now.at[0], y = now.at[1], z = now.at[2];
    const phd_pair a = phd_root_or_zero(x);
    const phd_pair b = phd_root_or_zero(y);
    const phd_pair c = phd_root(z);
    const phd_pair more = phd_add(phd_multiply(a, phd_add(b, c)), phd_multiply(b, c));
    return phd_make_three_pairs(phd_scale(phd_add(x, more), 0.25), phd_scale(phd_add(y, more), 0.25),
        phd_scale(phd_add(z, more), 0.25));
}

/* Return whether the closing formula has the digits that a phase wants. */
static inline int phd_top_is_closer(phd_three_pairs now)
{
    return phd_top_widest(now.at[0].hi, now.at[1].hi, now.at[2].hi) <= PHD_TOP_CLOSER;
}

/* Return closed in double-double. */
static inline phd_pair phd_top_closed_sharply(phd_three_pairs now)
{
    const phd_pair x = now.at[0], y = now.at[1], z = now.at[2];
    const phd_pair one = PHD_TOP_ONE;
    const phd_pair mean = phd_divide(phd_add(phd_add(x, y), z), phd_make_pair(3.0, 0.0));
    const double apart = phd_top_series(1.0 - phd_divide(x, mean).hi, 1.0 - phd_divide(y, mean).hi);
    return phd_top_is_closer(now)
        ? phd_divide(phd_add(one, phd_make_pair(apart, 0.0 * apart)), phd_root(mean))
        : phd_make_pair(NAN, NAN);
}

/* Return x, y and c of an integral √c R_F(x, y, 1), v of α. */
static inline phd_three phd_top_pole_of_alpha(const phd_top_reduction_record *top,
    const phd_top_turning_points_record *points)
{
    (void)top;
    const double d = points->d.hi;
    const double t2 = points->t2.hi;
    return phd_make_three(d / t2, d * points->Z_plus.hi / (points->A.hi * t2), points->t1.hi / t2);
}

/* Return the like of v of β. */
static inline phd_three phd_top_pole_of_beta(const phd_top_reduction_record *top,
    const phd_top_turning_points_record *points)
{
    (void)top;
    const double d = points->d.hi;
    const double s1 = points->s1.hi;
    const double b = points->B.hi;
    return phd_make_three(d * points->Z_minus.hi / (s1 * b), d / s1, points->s2.hi * points->A.hi / (s1 * b));
}

/* Return the like of K' − v of α. */
static inline phd_three phd_top_rest_of_alpha(const phd_top_reduction_record *top,
    const phd_top_turning_points_record *points)
{
    const double g = top->G.hi;
    const double z = points->Z_plus.hi;
    return phd_make_three(g * points->t1.hi / z, g * points->t2.hi / z, points->A.hi / z);
}

/* Return the like of K' − v of β. */
static inline phd_three phd_top_rest_of_beta(const phd_top_reduction_record *top,
    const phd_top_turning_points_record *points)
{
    const double g = top->G.hi;
    const double b = points->B.hi;
    return phd_make_three(g * points->s2.hi / b, g * points->s1.hi / points->A.hi, points->Z_minus.hi / b);
}

/* Return the like of the start's distance from the lowest place, in double-double. */
static inline phd_three_pairs phd_top_place_of_start(const phd_top_turning_points_record *points)
{
    return phd_make_three_pairs(phd_divide(points->from_upper, points->d), phd_divide(points->Y, points->A),
        phd_divide(points->from_lower, points->d));
}

/* Return √c R_F(x, y, 1), or some number where there is none. */
static inline double phd_top_integral(int idle, phd_three terms)
{
    const double x = terms.at[0], y = terms.at[1], c = terms.at[2];
    const double total = x + y;
    int good = (idle ? 0.0 : total) > 0.0;
    good = good && total < INFINITY;
    const phd_three start = phd_make_three(good ? x : 1.0, good ? y : 1.0, 1.0 + 0.0 * x);
    phd_three running = start;
    for (int k = 0; k < PHD_TOP_MOST_STEPS; k++) {
        if (phd_top_is_close(running)) {
            break;
        }
        running = phd_top_duplicated(running);
    }
    return sqrt(c) * phd_top_closed(running);
}

static inline phd_pair phd_top_sharp_integral(int idle, phd_three_pairs terms)
{
    const phd_pair x = terms.at[0], y = terms.at[1], c = terms.at[2];
    const double total = x.hi + y.hi;
    const phd_pair one = PHD_TOP_ONE;
    int good = (idle ? 0.0 : total) > 0.0;
    good = good && total < INFINITY;
    const phd_three_pairs start = phd_make_three_pairs(good ? x : one, good ? y : one, one);
    phd_three_pairs running = start;
    for (int k = 0; k < PHD_TOP_MOST_STEPS; k++) {
        if (phd_top_is_closer(running)) {
            break;
        }
        running = phd_top_duplicated_sharply(running);
    }
    return phd_multiply(phd_root_or_zero(c), phd_top_closed_sharply(running));
}

/* Return the integrals of a top. */
static inline phd_top_integrals_record phd_top_integrals_of(const phd_top_reduction_record *top,
    const phd_top_turning_points_record *points, const phd_top_frequencies_record *rates)
{
    const int idle = rates->permanent || rates->steady;
    const int separatrix = rates->separatrix;
    const double d = points->d.hi;
    double v_alpha = phd_top_integral(idle, phd_top_pole_of_alpha(top, points));
    double v_beta = phd_top_integral(idle, phd_top_pole_of_beta(top, points));
    v_alpha = separatrix ? atan2(sqrt(points->t1.hi), sqrt(d)) : v_alpha;
    v_beta = separatrix || points->s2.hi == 0.0 ? 0.0 : v_beta;
    /* where the tilt stays the pole is infinitely far: only e^−y = 0 enters */
    const double still = rates->steady ? INFINITY : 0.0;
    const phd_pair x0 = phd_top_sharp_integral(idle, phd_top_place_of_start(points));
    return phd_make_top_integrals_record(idle ? still : v_alpha, idle ? still : v_beta,
        phd_top_integral(idle, phd_top_rest_of_alpha(top, points)),
        phd_top_integral(idle, phd_top_rest_of_beta(top, points)), idle && d <= 0.0 ? PHD_TOP_ZERO : x0);
}

/* What a top's motion is like; what is infinite is inf, what is undefined NaN. */
typedef struct {
    /* 0 rest, 1 sleeping, 2 hanging, 3 steady, 4 free, 5 planar, 6 undulating, 7 cusp, 8 loop, 9 separatrix */
    double regime;
    double lowest; /* of the cosine of the tilt from the upward vertical */
    double highest;
    double period; /* of the nutation; of a steady top that of its smallest nutations */
    double precession_per_period; /* azimuth gained by the axis in a period, unreduced */
    double spin_per_period; /* the body's own turn in a period, unreduced */
} phd_top_numbers_record;

static inline phd_top_numbers_record phd_make_top_numbers_record(double regime, double lowest, double highest,
    double period, double precession_per_period, double spin_per_period)
{
    phd_top_numbers_record all;
    all.regime = regime; all.lowest = lowest; all.highest = highest; all.period = period;
    all.precession_per_period = precession_per_period; all.spin_per_period = spin_per_period;
    return all;
}

/* Return u from the smaller of 1 − u and 1 + u. */
static inline double phd_top_cosine(phd_pair s, phd_pair t)
{
    const phd_pair one = phd_make_pair(1.0, 0.0);
    return s.hi < t.hi ? phd_subtract(one, s).hi : phd_subtract(t, one).hi;
}

/* Signs of polynomials in the given floats decide; only the steady top needs the computed gap u2 − u1.

   The azimuth is at rest where p_φ = a u; there |w|² = lean/a, which is positive inside the nutation's range. */
static inline double phd_top_regime(const phd_top_reduction_record *top, const phd_top_frequencies_record *rates)
{
    const double a = top->momentum.at[2];
    const double c = top->c.hi;
    const double c_plus = top->c_plus.hi;
    const double lean = top->lean.hi;
    const double along = a < 0.0 ? -lean : lean;
    /* the place p_φ/a is a tilt: −1 < p_φ/a < 1 */
    const int within = c * a < 0.0 && c_plus * a > 0.0;
    double code = within && along > 0.0 ? 8.0 : 6.0;
    code = within && along == 0.0 ? 7.0 : code;
    code = a == 0.0 && c == 0.0 ? 5.0 : code;
    code = rates->steady ? 3.0 : code;
    code = rates->separatrix ? 9.0 : code;
    code = rates->permanent ? (top->s0.hi == 0.0 ? 1.0 : 2.0) : code;
    code = top->G.hi == 0.0 ? 4.0 : code;
    return a == 0.0 && rates->permanent ? 0.0 : code;
}

static inline double phd_top_by_kind(const phd_top_frequencies_record *rates, double permanent, double separatrix,
    double periodic)
{
    return rates->permanent ? permanent : rates->separatrix ? separatrix : periodic;
}

/* Return the numbers of a top. */
static inline phd_top_numbers_record phd_top_numbers(const phd_top_reduction_record *top,
    const phd_top_turning_points_record *points, const phd_top_frequencies_record *rates)
{
    double lower = phd_top_cosine(points->s1, points->t1);
    double upper = phd_top_cosine(points->s2, points->t2);
    lower = rates->permanent ? top->u0.hi : lower;
    upper = rates->permanent ? top->u0.hi : upper;
    const phd_pair pi = PHD_PI;
    /* α = cos(θ/2) e^{i(φ + ψ)/2}, β = sin(θ/2) e^{i(φ − ψ)/2} up to a constant phase: φ = arg α + arg β,
       ψ = arg α − arg β. In a period, π/ϖ by τ, each argument gains its linear part, and half a turn by its thetas */
    const phd_pair turn_alpha = phd_add(phd_divide(rates->alpha, rates->nutation),
        phd_make_pair(rates->sign_alpha, 0.0 * rates->sign_alpha));
    const phd_pair turn_beta = phd_add(phd_divide(rates->beta, rates->nutation),
        phd_make_pair(rates->sign_beta, 0.0 * rates->sign_beta));
    const phd_pair spin = phd_divide(rates->spin, rates->nutation);
    const double precession = phd_multiply(pi, phd_add(turn_alpha, turn_beta)).hi;
    double own_turn = phd_multiply(pi, phd_add(phd_subtract(turn_alpha, turn_beta), spin)).hi;
    const double period = phd_divide(phd_multiply_float(pi, top->moments.hi),
        phd_scale(rates->nutation, top->rate_scale)).hi;
    /* never −0 */
    own_turn = (top->reversed ? -1.0 : 1.0) * own_turn + 0.0;
    return phd_make_top_numbers_record(phd_top_regime(top, rates), top->reversed ? -upper : lower,
        top->reversed ? -lower : upper, phd_top_by_kind(rates, NAN, INFINITY, period),
        phd_top_by_kind(rates, NAN, NAN, precession), phd_top_by_kind(rates, NAN, NAN, own_turn));
}

static const phd_four PHD_TOP_NO_TERMS = {{0.0, 0.0, 0.0, 0.0}};
/* The modulus and the places of start and poles in the lattice. */
typedef struct {
    int full;
    double q; /* nome of the smaller parameter */
    double theta3;
    double y_alpha; /* imaginary distance of the poles, times π/2K (full) or π/2K' */
    double y_beta;
    double w_alpha; /* full: the like of K' − v */
    double w_beta;
    phd_pair x0;
} phd_top_arguments_record;

static inline phd_top_arguments_record phd_make_top_arguments_record(int full, double q, double theta3, double y_alpha,
    double y_beta, double w_alpha, double w_beta, phd_pair x0)
{
    phd_top_arguments_record all;
    all.full = full; all.q = q; all.theta3 = theta3; all.y_alpha = y_alpha; all.y_beta = y_beta; all.w_alpha = w_alpha;
    all.w_beta = w_beta; all.x0 = x0;
    return all;
}

/* A reduced top with all that its motion is made from. */
typedef struct {
    phd_top_reduction_record top;
    phd_top_turning_points_record points;
    phd_top_frequencies_record rates;
    phd_top_arguments_record at;
    double axial; /* L3 as given */
} phd_top_given_record;

static inline phd_top_given_record phd_make_top_given_record(const phd_top_reduction_record *top,
    const phd_top_turning_points_record *points, const phd_top_frequencies_record *rates,
    const phd_top_arguments_record *at, double axial)
{
    phd_top_given_record all;
    all.top = *top; all.points = *points; all.rates = *rates; all.at = *at; all.axial = axial;
    return all;
}

typedef struct {
    phd_three first;
    phd_three second;
    phd_three third;
    phd_pair fourth;
} phd_three_threes_pair;

static inline phd_three_threes_pair phd_make_three_threes_pair(phd_three first, phd_three second, phd_three third,
    phd_pair fourth)
{
    phd_three_threes_pair all;
    all.first = first; all.second = second; all.third = third; all.fourth = fourth;
    return all;
}

typedef struct {
    phd_six first;
    phd_pair second;
    phd_pair third;
} phd_six_two_pairs;

static inline phd_six_two_pairs phd_make_six_two_pairs(phd_six first, phd_pair second, phd_pair third)
{
    phd_six_two_pairs all;
    all.first = first; all.second = second; all.third = third;
    return all;
}

/* What of a Motion depends on rates and places. */
typedef struct {
    phd_three_threes_pair rates; /* its first to start */
    phd_six_two_pairs places; /* its nome to rates */
    phd_pair linear; /* derivatives by τ of the phases of α and β that evaluation adds to A and B, spin aside */
    double turn; /* dz/dτ or dx'/dτ */
} phd_top_timing_record;

static inline phd_top_timing_record phd_make_top_timing_record(phd_three_threes_pair rates, phd_six_two_pairs places,
    phd_pair linear, double turn)
{
    phd_top_timing_record all;
    all.rates = rates; all.places = places; all.linear = linear; all.turn = turn;
    return all;
}

/* Return whether the motion takes the full form, m ≤ ½, if it nutates. */
static inline int phd_top_is_full(const phd_top_reduction_record *top, const phd_top_turning_points_record *points)
{
    /* m = (A − B)/A = G (u2 − u1)/A and 1 − m = B/A */
    return top->G.hi * points->d.hi <= points->B.hi;
}

/* Return modulus and places, of the integrals. */
static inline phd_top_arguments_record phd_top_arguments(const phd_top_reduction_record *top,
    const phd_top_turning_points_record *points, const phd_top_frequencies_record *rates,
    const phd_top_integrals_record *integrals)
{
    const double m = top->G.hi * points->d.hi / points->A.hi;
    const double m1 = rates->separatrix ? 0.0 : points->B.hi / points->A.hi;
    const int full = rates->permanent || (phd_top_is_full(top, points) && !rates->separatrix);
    const double small = rates->permanent ? 0.0 : full ? m : m1;
    const double q = small * phd_nome_per_parameter(small, sqrt(1.0 - small));
    const double q4 = q * q * (q * q);
    const double theta3 = 1.0 + 2.0 * (q + q4 + q4 * q4 * q);
    /* π/2K of the smaller quarter period (DLMF 22.2.2) */
    const double by = 1.0 / (theta3 * theta3);
    const phd_pair x0 = phd_scale(phd_add(integrals->x0, phd_top_climb(top)), top->p.hi >= 0.0 ? 1.0 : -1.0);
    return phd_make_top_arguments_record(full, q, theta3, integrals->v_alpha * by, integrals->v_beta * by,
        integrals->w_alpha * by, integrals->w_beta * by, x0);
}

typedef struct { phd_four at[2]; } phd_two_fours;

static inline phd_two_fours phd_make_two_fours(phd_four x0, phd_four x1)
{
    phd_two_fours all;
    all.at[0] = x0; all.at[1] = x1;
    return all;
}

/* Return sums and differences of the coefficients of e^{±ikz}, k = 1, 3, 5, 7. */
static inline phd_two_fours phd_top_full_terms(double size, double h, double q, double r, double alternating)
{
    double w1 = q * r;
    double w2 = q * q * r;
    double w3 = q * q * q * r;
    w2 = w2 * w2;
    w3 = w3 * w3 * w3;
    const double h3 = h * h * h;
    const double h5 = h3 * h * h;
    const double h7 = h3 * h3 * h;
    size = size / (w3 * (1.0 + h7) + w2 * (1.0 + h5) + w1 * (1.0 + h3) + (1.0 + h));
    w1 = alternating * size * w1;
    w2 = size * w2;
    w3 = alternating * size * w3;
    return phd_make_two_fours(phd_make_four(size * (1.0 + h), w1 * (1.0 + h3), w2 * (1.0 + h5), w3 * (1.0 + h7)),
        phd_make_four(size * (1.0 - h), w1 * (1.0 - h3), w2 * (1.0 - h5), w3 * (1.0 - h7)));
}

/* Return √t θ3 and √s θ4. */
static inline phd_pair phd_top_full_sizes(double root_t, double root_s, double q, double theta3)
{
    const double q4 = q * q * (q * q);
    return phd_make_pair(root_t * theta3, root_s * (1.0 - 2.0 * (q - q4 + q4 * q4 * q)));
}

/* Return cos ky and sin ky for k = 1 to 4 of 0 ≤ y ≤ π. */
static inline phd_two_fours phd_top_multiples(double y)
{
    const phd_pair of_sine_cosine = phd_sine_cosine(y * (0.5 / 3.141592653589793));
    const double s1 = of_sine_cosine.hi, c1 = of_sine_cosine.lo;
    const double s2 = 2.0 * s1 * c1;
    const double c2 = 1.0 - 2.0 * s1 * s1;
    return phd_make_two_fours(phd_make_four(c1, c2, c2 * c1 - s2 * s1, 1.0 - 2.0 * s2 * s2),
        phd_make_four(s1, s2, s2 * c1 + c2 * s1, 2.0 * s2 * c2));
}

typedef struct {
    phd_four first;
    phd_four second;
    phd_four third;
    phd_four fourth;
    double fifth;
} phd_four_fours_number;

static inline phd_four_fours_number phd_make_four_fours_number(phd_four first, phd_four second, phd_four third,
    phd_four fourth, double fifth)
{
    phd_four_fours_number all;
    all.first = first; all.second = second; all.third = third; all.fourth = fourth; all.fifth = fifth;
    return all;
}

/* Return A's factors of sin ky and cos ky, k = 1, 3, 5, 7, B's of cos and sin of 2, 4, 6, 8 y, and its constant. */
static inline phd_four_fours_number phd_top_complementary_series(double root_t, double root_s, double q, double theta3,
    double y_alpha, double y_beta)
{
    const double q2 = q * q;
    const double q4 = q2 * q2;
    const double q6 = q2 * q2 * q2;
    const double q9 = q6 * q2 * q;
    const phd_two_fours of_multiples = phd_top_multiples(y_alpha);
    phd_four c = of_multiples.at[0];
    phd_four s = of_multiples.at[1];
    double theta4 = 1.0 - 2.0 * (q * c.at[1] - q4 * c.at[3] + q9 * (2.0 * c.at[2] * c.at[2] - 1.0));
    double size = root_t * theta3 / theta4;
    const double c5 = c.at[3] * c.at[0] - s.at[3] * s.at[0];
    const double s5 = s.at[3] * c.at[0] + c.at[3] * s.at[0];
    const double c7 = c.at[3] * c.at[2] - s.at[3] * s.at[2];
    const double s7 = s.at[3] * c.at[2] + c.at[3] * s.at[2];
    const phd_four a_sine = phd_make_four(size * s.at[0], -size * s.at[2], size * s5, -size * s7);
    const phd_four a_cosine = phd_make_four(size * c.at[0], -size * c.at[2], size * c5, -size * c7);
    const phd_two_fours of_multiples_2 = phd_top_multiples(2.0 * y_beta);
    c = of_multiples_2.at[0];
    s = of_multiples_2.at[1];
    theta4 = 1.0 - 2.0 * (q * c.at[0] - q4 * c.at[1] + q9 * c.at[2]);
    size = root_s * (1.0 + q2 + q6 + q6 * q6) / theta4;
    return phd_make_four_fours_number(a_sine, a_cosine,
        phd_make_four(-size * c.at[0], size * c.at[1], -size * c.at[2], size * c.at[3]),
        phd_make_four(-size * s.at[0], size * s.at[1], -size * s.at[2], size * s.at[3]), size);
}

/* Return √(t/2) and √(s/2) at the given size of the displacement, where that stays as small. */
static inline phd_pair phd_top_sizes(const phd_top_reduction_record *top, phd_pair t, phd_pair s)
{
    const double down = phd_times_power(1.0, -(phd_top_leaves(top) ? 0.0 : top->lift));
    const int upright = phd_top_is_upright(top);
    const double root_t = sqrt(0.5 * t.hi);
    const double root_s = sqrt(0.5 * s.hi);
    return phd_make_pair(root_t * (upright ? 1.0 : down), root_s * (upright ? down : 1.0));
}

/* Return q e^{2y}, accurate where y is far out, and e^{−2y}, of α and of β. */
static inline phd_four phd_top_tails(const phd_top_arguments_record *at)
{
    return phd_make_four(exp(-2.0 * at->w_alpha), exp(-2.0 * at->y_alpha), exp(-2.0 * at->w_beta),
        exp(-2.0 * at->y_beta));
}

/* Return sums and differences of the coefficients of e^{±ikz}, k = 1, 3, 5, 7, in A and in B. */
static inline phd_four_fours_number phd_top_full_series(const phd_top_reduction_record *top,
    const phd_top_turning_points_record *points, const phd_top_arguments_record *at, phd_four tail)
{
    const phd_pair of_sizes = phd_top_sizes(top, points->t2, points->s1);
    const double root_t = of_sizes.hi, root_s = of_sizes.lo;
    const phd_pair of_full_sizes = phd_top_full_sizes(root_t, root_s, at->q, at->theta3);
    const double of_alpha = of_full_sizes.hi, of_beta = of_full_sizes.lo;
    const int some = at->q > 0.0;
    const phd_two_fours of_full_terms = phd_top_full_terms(of_alpha, tail.at[1], at->q, some ? tail.at[0] : 0.0, -1.0);
    const phd_four a_sum = of_full_terms.at[0], a_gap = of_full_terms.at[1];
    const phd_two_fours of_full_terms_2 = phd_top_full_terms(of_beta, tail.at[3], at->q, some ? tail.at[2] : 0.0, 1.0);
    const phd_four b_sum = of_full_terms_2.at[0], b_gap = of_full_terms_2.at[1];
    return phd_make_four_fours_number(a_sum, a_gap, b_sum, b_gap, 0.0);
}

static inline phd_four_fours_number phd_top_full(const phd_top_given_record *given)
{
    return phd_top_full_series(&given->top, &given->points, &given->at, phd_top_tails(&given->at));
}

/* Return the series of a permanent top, which has one of α, β, or at rest both, as it started. */
static inline phd_four_fours_number phd_top_standing(const phd_top_given_record *given)
{
    /* A = |α| sin z and B = i |β| sin z at z = π/2 */
    const phd_pair of_sizes = phd_top_sizes(&given->top, given->top.t0, given->top.s0);
    const double root_t = of_sizes.hi, root_s = of_sizes.lo;
    return phd_make_four_fours_number(phd_make_four(root_t, 0.0, 0.0, 0.0), PHD_TOP_NO_TERMS, PHD_TOP_NO_TERMS,
        phd_make_four(root_s, 0.0, 0.0, 0.0), 0.0);
}

static inline phd_four_fours_number phd_top_of_full_form(const phd_top_given_record *given)
{
    return given->rates.permanent ? phd_top_standing(given) : phd_top_full(given);
}

/* Return the series of the complementary form. */
static inline phd_four_fours_number phd_top_complementary(const phd_top_reduction_record *top,
    const phd_top_turning_points_record *points, const phd_top_arguments_record *at)
{
    const phd_pair of_sizes = phd_top_sizes(top, points->t2, points->s1);
    const double root_t = of_sizes.hi, root_s = of_sizes.lo;
    return phd_top_complementary_series(root_t, root_s, at->q, at->theta3, at->y_alpha, at->y_beta);
}

static inline phd_four_fours_number phd_top_of_complementary_form(const phd_top_given_record *given)
{
    return phd_top_complementary(&given->top, &given->points, &given->at);
}

/* Return cos and sin of the phase that turns A or B at the epoch into the given α or β.

   Where one of them vanishes its own phase says nothing; its derivative then does, so both are used. */
static inline phd_pair phd_top_constant_phase(double r, double i, double dr, double di, double turns, double rate,
    phd_pair component, phd_pair slope, double norm, double drop, double turn, double size)
{
    r = r / norm;
    i = i / norm;
    const double sr = turn * (dr / norm - r * drop) - rate * i;
    const double si = turn * (di / norm - i * drop) + rate * r;
    const double gr = component.hi, gi = component.lo;
    const double er = slope.hi, ei = slope.lo;
    double real = r * gr + i * gi + (sr * er + si * ei) / size;
    double imaginary = r * gi - i * gr + (sr * ei - si * er) / size;
    const phd_pair of_sine_cosine = phd_sine_cosine(turns - phd_whole(turns));
    const double s = of_sine_cosine.hi, c = of_sine_cosine.lo;
    const phd_pair of_real_imaginary = phd_make_pair(real * c + imaginary * s, imaginary * c - real * s);
    real = of_real_imaginary.hi;
    imaginary = of_real_imaginary.lo;
    const double length = sqrt(real * real + imaginary * imaginary);
    const int some = length > 0.0;
    const double safe = some ? length : 1.0;
    return phd_make_pair(some ? real / safe : 1.0, some ? imaginary / safe : 0.0);
}

/* Return cos and sin of the phases that turn A and B at the epoch into the given α and β.

   Args:
       quaternion, norm2: at the epoch, and its |q|².
       momentum: at the epoch.
       size: |L|² + G, by which derivatives count.
       sums: at the epoch.
       linear: derivatives by τ of the phases that evaluation adds to A and B.
       turn: dz/dτ or dx'/dτ. */
static inline phd_four phd_top_constant_phases(phd_four quaternion, phd_pair norm2, phd_three momentum, double size,
    phd_ten sums, phd_pair linear, double turn)
{
    const double x = momentum.at[0], y = momentum.at[1], z = momentum.at[2];
    const phd_pair length = phd_root(norm2);
    const double q0 = phd_divide(phd_make_pair(quaternion.at[0], 0.0), length).hi;
    const double q1 = phd_divide(phd_make_pair(quaternion.at[1], 0.0), length).hi;
    const double q2 = phd_divide(phd_make_pair(quaternion.at[2], 0.0), length).hi;
    const double q3 = phd_divide(phd_make_pair(quaternion.at[3], 0.0), length).hi;
    /* 2α' = i a α − w̄ β, 2β' = w α − i a β */
    const phd_pair a = phd_make_pair(0.5 * (-z * q3 - (x * q1 + y * q2)), 0.5 * (z * q0 - (x * q2 - y * q1)));
    const phd_pair b = phd_make_pair(0.5 * (x * q0 - y * q3 + z * q2), 0.5 * (x * q3 + y * q0 - z * q1));
    const double ar = sums.at[0], ai = sums.at[1], br = sums.at[2], bi = sums.at[3], dar = sums.at[4], dai = sums.at[5],
        dbr = sums.at[6], dbi = sums.at[7], turns_a = sums.at[8], turns_b = sums.at[9];
    const double length2 = ar * ar + ai * ai + (br * br + bi * bi);
    const double norm = sqrt(length2);
    const double drop = (ar * dar + ai * dai + (br * dbr + bi * dbi)) / length2;
    const phd_pair of_constant_phase = phd_top_constant_phase(ar, ai, dar, dai, turns_a, linear.hi,
        phd_make_pair(q0, q3), a, norm, drop, turn, size);
    const double c0 = of_constant_phase.hi, s0 = of_constant_phase.lo;
    const phd_pair of_constant_phase_2 = phd_top_constant_phase(br, bi, dbr, dbi, turns_b, linear.lo,
        phd_make_pair(q1, q2), b, norm, drop, turn, size);
    const double c1 = of_constant_phase_2.hi, s1 = of_constant_phase_2.lo;
    return phd_make_four(c0, s0, c1, s1);
}

/* Return the constant phases, of the sums at the epoch. */
static inline phd_four phd_top_phases_of(const phd_top_reduction_record *top, const phd_top_timing_record *timing,
    phd_ten sums)
{
    const double ar = sums.at[0], ai = sums.at[1], br = sums.at[2], bi = sums.at[3], dar = sums.at[4], dai = sums.at[5],
        dbr = sums.at[6], dbi = sums.at[7], turns_a = sums.at[8], turns_b = sums.at[9];
    const double up = phd_times_power(1.0, top->lift);
    const int upright = phd_top_is_upright(top);
    const double a = upright ? 1.0 : up;
    const double b = upright ? up : 1.0;
    const double x = top->momentum.at[0], y = top->momentum.at[1], z = top->momentum.at[2];
    const double size = x * x + y * y + (z * z + top->G.hi);
    const phd_ten lifted = phd_make_ten(ar * a, ai * a, br * b, bi * b, dar * a, dai * a, dbr * b, dbi * b, turns_a,
        turns_b);
    return phd_top_constant_phases(top->quaternion, top->size, top->momentum, size > 0.0 ? size : 1.0, lifted,
        timing->linear, timing->turn);
}

static inline phd_three phd_top_in_halves(phd_pair rate)
{
    const phd_pair of_halves = phd_halves(rate.hi);
    const double high = of_halves.hi, low = of_halves.lo;
    return phd_make_three(high, low, rate.lo);
}

/* Return what of the motion depends on rates and places. */
static inline phd_top_timing_record phd_top_timing_of(const phd_top_reduction_record *top,
    const phd_top_frequencies_record *rates, const phd_top_arguments_record *at)
{
    const double i1 = top->moments.hi;
    const int permanent = rates->permanent;
    const int separatrix = rates->separatrix;
    const int full = at->full;
    const phd_two_pairs of_phase_rates = phd_top_phase_rates(top, rates);
    const phd_pair alpha = of_phase_rates.at[0], beta = of_phase_rates.at[1];
    const phd_pair half = phd_top_half_periods(rates->nutation, i1, top->rate_scale);
    const phd_pair saddle = phd_divide(phd_scale(rates->half_root, top->rate_scale), phd_make_pair(i1, 0.0));
    const phd_pair third = permanent ? PHD_TOP_ZERO : full ? phd_scale(half, 0.5) : separatrix ? saddle : half;
    const phd_two_pairs of_periods = phd_top_periods(rates->half_root, rates->nutation, at->q);
    phd_pair period = of_periods.at[1];
    const phd_pair quarter = of_periods.at[0];
    const phd_pair fraction = phd_scale(phd_divide(at->x0, quarter), 0.5);
    phd_pair start = full ? phd_scale(fraction, 0.5) : separatrix ? at->x0 : fraction;
    start = permanent ? phd_make_pair(0.25, 0.0) : start;
    period = separatrix ? PHD_TOP_ONE : period;
    const phd_pair of_halves = phd_halves(period.hi);
    const double upper = of_halves.hi, lower = of_halves.lo;
    const double ya = full || separatrix ? 0.0 : at->y_alpha;
    const double yb = full || separatrix ? 0.0 : at->y_beta;
    const double carried = rates->nutation.hi * (2.0 / 3.141592653589793);
    const double sa = rates->sign_alpha;
    const double sb = rates->sign_beta;
    double turn = full ? rates->nutation.hi : rates->half_root.hi / (at->theta3 * at->theta3);
    const double linear_a = permanent ? 0.0 : rates->alpha.hi + sa * ya * carried;
    const double linear_b = permanent ? 0.0 : rates->beta.hi + sb * yb * carried;
    turn = permanent ? 0.0 : turn;
    const double size = top->momentum_scale;
    return phd_make_top_timing_record(phd_make_three_threes_pair(phd_top_in_halves(alpha), phd_top_in_halves(beta),
            phd_top_in_halves(third), start),
        phd_make_six_two_pairs(phd_make_six(at->q, upper, lower + period.lo, ya / 3.141592653589793,
                yb / 3.141592653589793, separatrix ? 0.0 : 1.0),
            phd_make_pair(permanent ? 1.0 : sa, permanent ? 1.0 : sb),
            phd_make_pair(2.0 * turn * size, 2.0 * (linear_a + linear_b) * size)), phd_make_pair(linear_a, linear_b),
        turn);
}

static inline phd_top_motion_record phd_top_motion(const phd_top_given_record *given,
    const phd_top_timing_record *timing, phd_four_fours_number series, phd_four phases)
{
    const phd_three first = timing->rates.first, second = timing->rates.second, third = timing->rates.third;
    const phd_pair start = timing->rates.fourth;
    const phd_six nome = timing->places.first;
    const phd_pair signs = timing->places.second, rates = timing->places.third;
    const phd_four a_sum = series.first, a_gap = series.second, b_sum = series.third, b_gap = series.fourth;
    const double constant = series.fifth;
    return phd_make_top_motion_record(given->at.full ? 1.0 : 0.0, first, second, third, start, a_sum, a_gap, b_sum,
        b_gap, constant, nome, signs, rates, phases, given->axial, given->top.reversed ? -1.0 : 1.0);
}

typedef struct {
    phd_top_motion_record first;
    phd_top_timing_record second;
} phd_top_motion_record_top_timing_record;

static inline phd_top_motion_record_top_timing_record
phd_make_top_motion_record_top_timing_record(const phd_top_motion_record *first, const phd_top_timing_record *second)
{
    phd_top_motion_record_top_timing_record all;
    all.first = *first; all.second = *second;
    return all;
}

/* Return the motion of a top whose constant phases are none. */
static inline phd_top_motion_record_top_timing_record phd_top_motion_without_phases(const phd_top_given_record *given)
{
    const phd_top_timing_record timing = phd_top_timing_of(&given->top, &given->rates, &given->at);
    const phd_four_fours_number series =
        given->at.full ? phd_top_of_full_form(given) : phd_top_of_complementary_form(given);
    const phd_top_motion_record of_motion = phd_top_motion(given, &timing, series, phd_make_four(1.0, 0.0, 1.0, 0.0));
    return phd_make_top_motion_record_top_timing_record(&of_motion, &timing);
}

static inline phd_ten phd_top_full_start(const phd_top_motion_record *m)
{
    const double zero = 0.0 * m->start.hi;
    return phd_top_full_sums(m, phd_make_three(zero, zero, zero));
}

static inline phd_ten phd_top_complementary_start(const phd_top_motion_record *m)
{
    const double zero = 0.0 * m->start.hi;
    const phd_seven of_complementary_phase = phd_top_complementary_phase(m, phd_make_three(zero, zero, zero));
    const double a = of_complementary_phase.at[0], b = of_complementary_phase.at[1], c = of_complementary_phase.at[2],
        e = of_complementary_phase.at[3], factor = of_complementary_phase.at[4], other = of_complementary_phase.at[5],
        other_factor = of_complementary_phase.at[6];
    return phd_top_complementary_sums(m, a, b, c, exp(e) * factor, exp(other) * other_factor);
}

/* Return the motion, which begins at the given attitude. */
static inline phd_top_motion_record phd_top_motion_with_phases(const phd_top_given_record *given,
    const phd_top_motion_record *motion, const phd_top_timing_record *timing)
{
    const phd_ten sums = given->at.full ? phd_top_full_start(motion) : phd_top_complementary_start(motion);
    const phd_four_fours_number series = phd_make_four_fours_number(motion->a_sum, motion->a_gap, motion->b_sum,
        motion->b_gap, motion->constant);
    return phd_top_motion(given, timing, series, phd_top_phases_of(&given->top, timing, sums));
}

/* Return the constants of motion of a top. */
static inline phd_top_motion_record phd_top_motion_of(const phd_top_given_record *given)
{
    const phd_top_motion_record_top_timing_record of_motion_without_phases = phd_top_motion_without_phases(given);
    const phd_top_motion_record motion = of_motion_without_phases.first;
    const phd_top_timing_record timing = of_motion_without_phases.second;
    return phd_top_motion_with_phases(given, &motion, &timing);
}

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
