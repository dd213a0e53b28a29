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
   gnu modes): phases are kept in pairs of doubles, whose errors are computed exactly. _init checks that they are. */
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

/* ---------------------------------------------------------------- double-double arithmetic
   A number is an unevaluated sum of two doubles with about 32 digits. Dekker, Numer. Math. 18 (1971) 224. */

typedef struct { double hi, lo; } phd_pair;

static const phd_pair PHD_ONE = {1.0, 0.0}, PHD_ZERO = {0.0, 0.0};
static const phd_pair PHD_PI = {3.141592653589793, 1.2246467991473532e-16};
static const phd_pair PHD_LN2 = {0.6931471805599453, 2.3190468138462996e-17};
static const phd_pair PHD_INVERSE_TWO_PI = {0.15915494309189535, -9.839338337591243e-18};

static inline phd_pair phd_make(double hi, double lo) { phd_pair x; x.hi = hi; x.lo = lo; return x; }
static inline phd_pair phd_negate(phd_pair x) { return phd_make(-x.hi, -x.lo); }
static inline phd_pair phd_scale(phd_pair x, double power_of_two) { return phd_make(x.hi * power_of_two, x.lo * power_of_two); }

/* The upper half of a double, of at most 26 bits; what is left is exact and as short. Veltkamp. */
static inline double phd_upper(double a)
{
    const double c = 134217729.0 * a;
    return c - (c - a);
}

static inline phd_pair phd_two_sum(double a, double b)
{
    const double s = a + b, t = s - a;
    return phd_make(s, (a - (s - t)) + (b - t));
}

static inline phd_pair phd_fast_two_sum(double a, double b)
{
    const double s = a + b;
    return phd_make(s, b - (s - a));
}

static inline phd_pair phd_two_product(double a, double b)
{
    const double ah = phd_upper(a), al = a - ah, bh = phd_upper(b), bl = b - bh, p = a * b;
    return phd_make(p, ((ah * bh - p) + ah * bl + al * bh) + al * bl);
}

static inline phd_pair phd_add(phd_pair x, phd_pair y)
{
    const phd_pair s = phd_two_sum(x.hi, y.hi);
    return phd_fast_two_sum(s.hi, s.lo + (x.lo + y.lo));
}

static inline phd_pair phd_subtract(phd_pair x, phd_pair y) { return phd_add(x, phd_negate(y)); }

static inline phd_pair phd_multiply(phd_pair x, phd_pair y)
{
    const phd_pair p = phd_two_product(x.hi, y.hi);
    return phd_fast_two_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi));
}

static inline phd_pair phd_times(phd_pair x, double y) { return phd_multiply(x, phd_make(y, 0.0)); }
static inline phd_pair phd_square(phd_pair x) { return phd_multiply(x, x); }

static inline phd_pair phd_divide(phd_pair x, phd_pair y)
{
    const double q = x.hi / y.hi;
    const phd_pair p = phd_two_product(q, y.hi);
    return phd_fast_two_sum(q, (((x.hi - p.hi) - p.lo) + (x.lo - q * y.lo)) / y.hi);
}

static inline phd_pair phd_sqrt(phd_pair x)
{
    const double s = sqrt(x.hi);
    const phd_pair p = phd_two_product(s, s);
    return phd_fast_two_sum(s, (((x.hi - p.hi) - p.lo) + x.lo) / (s > 0.0 ? s + s : 1.0));
}

/* An unevaluated sum of floats, exact. Shewchuk 1997. */
typedef struct { int count; double term[64]; } phd_sum;

static inline phd_sum phd_sum_of(phd_pair x) { phd_sum s; s.count = 2; s.term[0] = x.hi; s.term[1] = x.lo; return s; }

static inline phd_sum phd_joined(phd_sum x, const phd_sum *y, double power_of_two)
{
    int k;
    for (k = 0; k < y->count; k++) x.term[x.count++] = y->term[k] * power_of_two;
    return x;
}

static inline phd_sum phd_sum_times(const phd_sum *x, double factor)
{
    phd_sum s;
    int k;
    s.count = 2 * x->count;
    for (k = 0; k < x->count; k++) {
        const phd_pair p = phd_two_product(x->term[k], factor);
        s.term[2 * k] = p.hi;
        s.term[2 * k + 1] = p.lo;
    }
    return s;
}

static inline phd_sum phd_sum_times_sum(const phd_sum *x, const phd_sum *y)
{
    phd_sum s;
    int k;
    s.count = 0;
    for (k = 0; k < y->count; k++) {
        const phd_sum part = phd_sum_times(x, y->term[k]);
        s = phd_joined(s, &part, 1.0);
    }
    return s;
}

/* Moves the leading part to the end; the sum stays exactly what it was. Ogita, Rump & Oishi 2005. */
static inline void phd_sweep(phd_sum *x)
{
    double running = x->term[0];
    int k;
    for (k = 1; k < x->count; k++) {
        const phd_pair s = phd_two_sum(running, x->term[k]);
        running = s.hi;
        x->term[k - 1] = s.lo;
    }
    x->term[x->count - 1] = running;
}

/* The sum to double-double accuracy, whatever cancels, up to 2^-265. */
static inline phd_pair phd_distil(phd_sum x)
{
    double rest;
    int k;
    for (k = 0; k < 5; k++) phd_sweep(&x);
    rest = x.term[0];
    for (k = 1; k < x.count - 1; k++) rest += x.term[k];
    return phd_two_sum(x.term[x.count - 1], rest);
}

/* The sum as one of `count` floats, largest last, correct to 2^(-53 count) of its size. */
static inline phd_sum phd_compress(phd_sum x, int count)
{
    int k;
    if (x.count <= count) return x;
    for (k = 0; k <= count; k++) phd_sweep(&x);
    for (k = 0; k < count; k++) x.term[k] = x.term[x.count - count + k];
    x.count = count;
    return x;
}

static inline int phd_exponent(double x) { int e; (void)frexp(x, &e); return e; }
static inline double phd_largest3(const double v[3]) { return fmax(fmax(fabs(v[0]), fabs(v[1])), fabs(v[2])); }

static inline int phd_arithmetic_is_exact(void)
{
    volatile double a = 1.0 + 1.0 / 1073741824.0, big = 1e16, small = 0.1, third = 1.0 / 3.0;
    const phd_pair p = phd_two_product(a, a), s = phd_two_sum(big, small);
    const double half = phd_upper(third), rest = third - half;
    return p.lo == 1.0 / 1152921504606846976.0 && s.hi == 1e16 && s.lo == small
        && half * 67108864.0 == floor(half * 67108864.0 * 4.0) / 4.0 && fabs(rest) < 1e-8;
}

static inline int phd_are_finite(const double *v, int count)
{
    int k;
    for (k = 0; k < count; k++) if (!isfinite(v[k])) return 0;
    return 1;
}

/* Returns the first error in what both motions are made of. */
static inline int phd_check(const double moments[3], const double momentum[3], const double attitude[4], double epoch)
{
    int k;
    if (!phd_arithmetic_is_exact()) return POLHODE_BAD_ARITHMETIC;
    for (k = 0; k < 3; k++) if (!(moments[k] > 0.0 && isfinite(moments[k]))) return POLHODE_BAD_MOMENTS;
    if (!phd_are_finite(momentum, 3)) return POLHODE_BAD_MOMENTUM;
    if (attitude) {
        const double size = sqrt(attitude[0] * attitude[0] + attitude[1] * attitude[1] + attitude[2] * attitude[2]
                                 + attitude[3] * attitude[3]);
        if (!(fabs(size - 1.0) < 1e-6)) return POLHODE_BAD_ATTITUDE;
    }
    return isfinite(epoch) ? POLHODE_OK : POLHODE_BAD_EPOCH;
}

/* ---------------------------------------------------------------- phases in turns, decay, elliptic integrals */

typedef struct { double upper, lower, rest; } phd_rate; /* [turns per time], in halves whose products are exact */
typedef struct { double high, low, rest; } phd_time; /* in halves, and what is left where t - epoch is no double */
typedef struct { double fraction, rest, turns; } phd_phase;
typedef struct { double sine, cosine; } phd_wave;

static inline phd_rate phd_split(phd_pair rate)
{
    phd_rate r;
    r.upper = phd_upper(rate.hi);
    r.lower = rate.hi - r.upper;
    r.rest = rate.lo;
    return r;
}

/* Reduces rate times time to a fraction of a turn, exactly, and whole turns. */
static inline phd_phase phd_reduce(phd_rate rate, phd_time t)
{
    const double a = rate.upper * t.high, b = rate.upper * t.low, c = rate.lower * t.high;
    const double na = rint(a), nb = rint(b), nc = rint(c);
    const double d = (rate.lower * t.low + rate.rest * (t.high + t.low)) + (rate.upper + rate.lower) * t.rest;
    /* each remainder may reach half a turn: a plain sum would cost 1e-16 turns */
    const phd_pair middle = phd_two_sum(b - nb, c - nc), sum = phd_two_sum(a - na, middle.hi);
    const double more = rint(sum.hi);
    phd_phase p;
    p.fraction = sum.hi - more;
    p.rest = sum.lo + (middle.lo + d);
    p.turns = na + (nb + nc) + more;
    return p;
}

static const phd_time PHD_EPOCH = {0.0, 0.0, 0.0};

/* The time since the epoch, exactly. */
static inline phd_time phd_since(double t, double epoch)
{
    const phd_pair elapsed = phd_two_sum(t, -epoch);
    phd_time since;
    since.high = phd_upper(elapsed.hi);
    since.low = elapsed.hi - since.high;
    since.rest = elapsed.lo;
    return since;
}

static inline double phd_wrapped(double turns) { return turns - rint(turns); }

static inline phd_wave phd_sine_cosine(double turns)
{
    const double t = tan(phd_wrapped(turns) * PHD_PI.hi), d = 2.0 / (t * t + 1.0);
    phd_wave w;
    w.sine = t * d;
    w.cosine = d - 1.0;
    return w;
}

/* exp(-(x + rest)(high + low)) with the exponent's product exact in its leading part */
static inline double phd_decay(double x, double rest, double high, double low)
{
    const double xh = phd_upper(x), xl = x - xh;
    const double small = (xh * low + xl * (high + low)) + rest * high;
    return exp(-(xh * high)) * (1.0 - small * (1.0 - 0.5 * small));
}

typedef struct { double x, e; phd_pair middle; } phd_closing;

static inline phd_closing phd_close(phd_pair a, phd_pair g, phd_pair pp)
{
    phd_closing c;
    double half, e;
    phd_pair d;
    c.middle = phd_scale(phd_add(a, g), 0.5);
    half = 0.5 * ((a.hi - g.hi) + (a.lo - g.lo));
    d = phd_subtract(pp, phd_square(c.middle));
    e = d.hi + d.lo + half * half;
    c.x = half / c.middle.hi;
    c.e = e / (2.0 * c.middle.hi * c.middle.hi + e);
    return c;
}

/* Returns agm(a, g), and in *total the third-kind sum that starts from p^2 = pp. Carlson, SIAM J. Math. Anal. 8 (1977) 231. */
static inline phd_pair phd_agm(phd_pair a, phd_pair g, phd_pair pp, phd_pair *total)
{
    const int exponent = phd_exponent(a.hi) < 0 ? phd_exponent(a.hi) : 0;
    const double up = ldexp(1.0, exponent), down = ldexp(1.0, -exponent);
    phd_pair q = PHD_ONE, sum = PHD_ONE;
    phd_closing c;
    double last;
    int k;
    a = phd_scale(a, down);
    g = phd_scale(g, down);
    pp = phd_scale(phd_scale(pp, down), down);
    for (k = 0; k < 23; k++) {
        phd_pair ag, s, e;
        c = phd_close(a, g, pp);
        if (k >= 3 && fabs(c.x) < 2e-8 && fabs(c.e) < 2e-8) break; /* closing leaves an error of the fourth power */
        ag = phd_multiply(a, g);
        s = phd_add(pp, ag);
        e = phd_divide(phd_subtract(pp, ag), s);
        q = phd_scale(phd_multiply(q, e), 0.5);
        pp = phd_scale(phd_divide(phd_square(s), pp), 0.25);
        a = phd_scale(phd_add(a, g), 0.5);
        g = phd_sqrt(ag);
        sum = phd_add(sum, q);
    }
    c = phd_close(a, g, pp);
    last = 0.5 * q.hi * c.e;
    *total = phd_add(sum, phd_make(last + last * (0.25 * (c.e * c.e - 0.5 * c.x * c.x)), 0.0));
    return phd_scale(phd_add(c.middle, phd_make(-0.25 * c.middle.hi * c.x * c.x, 0.0)), up);
}

/* nome over parameter, with k = sqrt(1 - parameter), for parameters up to 1/2. Whittaker & Watson, 21.8. */
static inline double phd_nome_over(double parameter, double k)
{
    const double root = 1.0 + sqrt(k), ratio = 0.5 / ((1.0 + k) * root * root), e = ratio * parameter;
    const double e4 = (e * e) * (e * e);
    return ratio * (1.0 + e4 * (2.0 + e4 * (15.0 + e4 * (150.0 + e4 * 1707.0))));
}

static inline double phd_power(double x, int n) { double y = 1.0; while (n-- > 0) y *= x; return y; }
static inline double phd_theta3_excess(double q) { return 2.0 * (q + phd_power(q, 4) + phd_power(q, 9)); }

/* Returns the Hamilton product p q in place of r. */
static inline void phd_quaternion_product(const double p[4], const double q[4], double r[4])
{
    r[0] = ((p[0] * q[0] - p[1] * q[1]) - p[2] * q[2]) - p[3] * q[3];
    r[1] = ((p[0] * q[1] + p[1] * q[0]) + p[2] * q[3]) - p[3] * q[2];
    r[2] = ((p[0] * q[2] - p[1] * q[3]) + p[2] * q[0]) + p[3] * q[1];
    r[3] = ((p[0] * q[3] + p[1] * q[2]) - p[2] * q[1]) + p[3] * q[0];
}

/* ---------------------------------------------------------------- the free body
   Comments on the method stand in free_reduction.js, free_rates.js and free_series.js, which this follows. */

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
    /* what evaluation needs */
    int full;
    double epoch, fastest;
    phd_rate first, second;
    phd_pair start;
    double a[5], b[5];        /* full form: coefficients; complementary form: cosines and sines */
    double root_nome, decay_high, decay_low, y_turns, periodic, parity;
    double to_attitude[16], to_momentum[9];
} polhode_free_body;

typedef struct {
    double I[3], L[3], canonical[3], axes[9];
    phd_pair A, B, C, P, Q, S, root_S, V, G2;
    double root_P, momentum_scale, rate_scale;
    int long_axis;
} phd_free;

typedef struct { phd_pair modulus, mean, precession, G; int constant, separatrix; } phd_free_rates;

static inline phd_pair phd_signed_distance(const double I[3], const double L[3], phd_pair A, phd_pair B)
{
    const phd_pair first = phd_multiply(A, phd_two_product(L[0], L[0]));
    const phd_pair plain = phd_subtract(first, phd_multiply(B, phd_two_product(L[2], L[2])));
    phd_sum gain, loss;
    if (!(fabs(plain.hi) < 1e-2 * first.hi)) return plain;
    gain = phd_sum_of(phd_two_sum(I[1], -I[0]));
    loss = phd_sum_of(phd_two_sum(I[2], -I[1]));
    gain = phd_sum_times(&gain, I[2]);
    gain = phd_sum_times(&gain, L[0]);
    gain = phd_sum_times(&gain, L[0]);
    loss = phd_sum_times(&loss, -I[0]);
    loss = phd_sum_times(&loss, L[2]);
    loss = phd_sum_times(&loss, L[2]);
    return phd_distil(phd_joined(gain, &loss, 1.0));
}

static inline double phd_root_of_sum(double value, double C, double x, double B, double y)
{
    const int exponent = phd_exponent(fmax(fabs(x), fabs(y)));
    if (value > 1e-280) return sqrt(value);
    x = ldexp(x, -exponent);
    y = ldexp(y, -exponent);
    return ldexp(sqrt(C * x * x + B * y * y), exponent);
}

static inline phd_free phd_reduced(const double moments[3], const double momentum[3])
{
    phd_free f;
    int order[3] = {0, 1, 2}, place[3], i, j, moment_exponent, momentum_exponent, near;
    double parity, smallest, size = phd_largest3(momentum), lifted[3], half_turn, flip[3];
    phd_pair s1, s2, s3, S;
    for (i = 0; i < 2; i++)
        for (j = 0; j < 2 - i; j++)
            if (moments[order[j]] > moments[order[j + 1]]) {
                const int swapped = order[j];
                order[j] = order[j + 1];
                order[j + 1] = swapped;
            }
    parity = (order[1] - order[0]) * (order[2] - order[0]) * (order[2] - order[1]) > 0 ? 1.0 : -1.0;
    smallest = size;
    for (i = 0; i < 3; i++) if (momentum[i] != 0.0) smallest = fmin(smallest, fabs(momentum[i]));
    moment_exponent = phd_exponent(moments[order[2]]);
    /* a component down to the smallest number keeps its digits in what is formed of it */
    momentum_exponent = phd_exponent(size) - (smallest < ldexp(size, -900) ? 100 : 0);
    for (i = 0; i < 3; i++) {
        f.I[i] = ldexp(moments[order[i]], -moment_exponent);
        f.L[i] = parity * ldexp(momentum[order[i]], -momentum_exponent);
    }
    f.A = phd_times(phd_two_sum(f.I[1], -f.I[0]), f.I[2]);
    f.B = phd_times(phd_two_sum(f.I[2], -f.I[1]), f.I[0]);
    f.C = phd_times(phd_two_sum(f.I[2], -f.I[0]), f.I[1]);
    s1 = phd_two_product(f.L[0], f.L[0]);
    s2 = phd_two_product(f.L[1], f.L[1]);
    s3 = phd_two_product(f.L[2], f.L[2]);
    f.P = phd_add(phd_multiply(f.C, s1), phd_multiply(f.B, s2));
    f.Q = phd_add(phd_multiply(f.A, s2), phd_multiply(f.C, s3));
    f.G2 = phd_add(phd_add(s1, s2), s3);
    /* near the saddle L1^2 and L3^2 would lose their low words, so S is formed with both scaled up */
    near = phd_exponent(fmax(fabs(f.L[0]), fabs(f.L[2])));
    for (i = 0; i < 3; i++) lifted[i] = ldexp(f.L[i], -near);
    S = phd_signed_distance(f.I, lifted, f.A, f.B);
    f.long_axis = S.hi > 0.0;
    f.canonical[0] = f.L[f.long_axis ? 2 : 0];
    f.canonical[1] = f.L[1];
    f.canonical[2] = f.L[f.long_axis ? 0 : 2];
    for (i = 0; i < 3; i++) place[i] = order[f.long_axis ? 2 - i : i];
    if (f.long_axis) {
        phd_pair swapped = f.A;
        f.A = f.B;
        f.B = swapped;
        swapped = f.P;
        f.P = f.Q;
        f.Q = swapped;
    } else {
        S = phd_negate(S);
    }
    half_turn = f.canonical[2] < 0.0 ? -1.0 : 1.0;
    f.root_P = phd_root_of_sum(f.P.hi, f.C.hi, f.canonical[0], f.B.hi, f.L[1]);
    f.canonical[0] *= half_turn;
    f.canonical[2] *= half_turn;
    flip[0] = flip[2] = half_turn;
    flip[1] = 1.0;
    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++) f.axes[3 * i + j] = place[j] == i ? parity * flip[j] : 0.0;
    f.S = phd_scale(phd_scale(S, -ldexp(1.0, near)), ldexp(1.0, near));
    f.root_S = phd_scale(phd_sqrt(S), ldexp(1.0, near));
    f.V = phd_times(phd_two_product(f.I[0], f.I[1]), f.I[2]);
    f.momentum_scale = ldexp(1.0, momentum_exponent);
    f.rate_scale = ldexp(1.0, momentum_exponent - moment_exponent);
    return f;
}

static inline phd_free_rates phd_rates_of(const phd_free *f)
{
    phd_free_rates r;
    const phd_pair BQ = phd_multiply(f->B, f->Q);
    const double sign = f->long_axis ? -1.0 : 1.0;
    phd_pair start, total, outer, share;
    int third_axis;
    r.constant = !(BQ.hi > 0.0) || !(f->root_P > 0.0) || (f->canonical[0] == 0.0 && f->canonical[2] == 0.0);
    r.separatrix = !(f->C.hi > 0.0 && f->root_S.hi > 0.0) && !r.constant;
    r.G = phd_sqrt(f->G2);
    r.modulus = phd_sqrt(BQ);
    r.mean = PHD_ONE;
    r.precession = PHD_ZERO;
    if (r.constant) return r;
    if (r.separatrix) {
        r.precession = phd_multiply(r.G, phd_two_product(sign * f->I[0], f->I[2]));
        return r;
    }
    /* of two forms the one whose sum converges fast */
    third_axis = f->B.hi >= f->A.hi;
    start = third_axis ? phd_multiply(f->Q, f->C) : phd_multiply(phd_multiply(f->B, f->C), f->G2);
    r.mean = phd_agm(r.modulus, phd_multiply(phd_sqrt(f->C), f->root_S), start, &total);
    outer = phd_two_product(sign * ((f->long_axis != 0) == (third_axis != 0) ? f->I[0] : f->I[2]), f->I[1]);
    total = phd_multiply(third_axis ? f->A : f->P, total);
    share = third_axis ? phd_scale(total, -0.5) : phd_scale(phd_divide(total, f->G2), 0.5);
    r.precession = phd_multiply(r.G, phd_add(outer, share));
    if (!third_axis) r.precession = phd_add(r.precession, r.mean);
    return r;
}

/* Follows a circular and a hyperbolic amplitude down five Landen steps; returns the factor of the circular tangent. */
static inline double phd_landen(double k, double dn, double *sinh_, double cosine, double dc)
{
    double x = 1.0, y = k, factor = 1.0;
    int step;
    for (step = 0; step < 5; step++) {
        const double kappa = (x - y) / (x + y), grown = 1.0 + kappa, product = x * y;
        const double next = sqrt(1.0 - kappa * (1.0 - dn) / (1.0 + dn));
        x = 0.5 * (x + y);
        y = sqrt(product);
        factor *= next / grown;
        *sinh_ = 2.0 * *sinh_ / (grown * (cosine + dc));
        dc = sqrt(1.0 + kappa * (dc - cosine) / (dc + cosine));
        cosine = 1.0;
        dn = next;
    }
    return factor;
}

static inline void phd_full_series(polhode_free_body *m, const phd_free *f, double parameter, double complement)
{
    const double A = f->A.hi, B = f->B.hi, C = f->C.hi, Q = f->Q.hi, total = B * Q, *l = f->canonical;
    const double k = sqrt(complement / total), over = phd_nome_over(parameter / total, k), q = over * (parameter / total);
    /* sqrt(P/Q) sinh, as the hyperbolic sine itself overflows near a stable axis */
    const double small = f->root_P / sqrt(Q), q2 = q * q, q4 = q2 * q2, q8 = q4 * q4;
    double scaled = sqrt(B), grown, g, g2, r, up, down, up2, down2, both, factor;
    factor = phd_landen(k, l[2] * sqrt(C / Q), &scaled, sqrt(B), sqrt(C));
    grown = scaled + sqrt(small * small + scaled * scaled);
    g = small / grown;
    g2 = g * g;
    r = (A / B) * over * grown * grown;
    m->start = phd_make(atan2(sqrt(B) * l[1] * factor, sqrt(C) * l[0]) * (0.25 / PHD_PI.hi), 0.0);
    up = -q * g2;
    down = -q2 * r;
    up2 = q4 * q2 * g2 * g2;
    down2 = q8 * r * r;
    both = up2 + down2;
    m->a[0] = 1.0 - both;
    m->a[1] = up + down;
    m->a[2] = 2.0 * both;
    m->a[3] = up - down;
    m->a[4] = 2.0 * (up2 - down2);
    up = -q2 * q * g2;
    up2 = q8 * q2 * g2 * g2;
    down2 = q4 * r * r;
    both = up2 + down2;
    m->b[0] = g * (1.0 - both);
    m->b[1] = g * (up - r);
    m->b[2] = 2.0 * g * both;
    m->b[3] = g * (up + r);
    m->b[4] = 2.0 * g * (up2 - down2);
}

static inline void phd_complementary_series(
    polhode_free_body *m, const phd_free *f, const phd_free_rates *rates, double parameter, double complement)
{
    const double B = f->B.hi, C = f->C.hi, P = f->P.hi, Q = f->Q.hi, *l = f->canonical;
    const int separatrix = rates->separatrix;
    const double k = separatrix ? 1.0 : sqrt(parameter / (B * Q)), small = separatrix ? 0.0 : complement / (B * Q);
    const double q = small * phd_nome_over(small, k);
    const double cosine = sqrt(C) * fabs(l[0]), dc = sqrt(C) * l[2] * sqrt(P / Q), along = fabs(sqrt(B) * l[1]);
    /* close to the unstable axis the hyperbolic sine and its square leave the range of numbers */
    const int huge = cosine + dc < ldexp(along, -400);
    double sinh_ = huge ? ldexp(along, -200) : along, y, argument, back;
    const double factor = phd_landen(k, sqrt(P / B) / rates->G.hi, &sinh_, cosine, dc);
    phd_pair x, period = PHD_ONE;
    phd_rate halves;
    int n;
    y = atan(sqrt(Q / P) * factor);
    argument = huge ? log(2.0 * sinh_) : asinh(sinh_);
    back = huge ? 0.5 * exp(argument) : sinh(argument);
    x = phd_fast_two_sum(argument, (sinh_ - back) / (huge ? back : sqrt(1.0 + back * back)));
    if (huge) x = phd_add(x, phd_make(138.62943611198907, -3.3555121496085278e-15)); /* 200 ln 2 */
    x = phd_scale(x, (l[1] < 0.0) != (l[0] < 0.0) ? -1.0 : 1.0);
    if (!separatrix) {
        const double e = phd_theta3_excess(q);
        period = phd_divide(phd_multiply(rates->modulus, PHD_PI), rates->mean);
        period = phd_add(period, phd_make(-period.hi * (e * (2.0 + e) / ((1.0 + e) * (1.0 + e))), 0.0));
    }
    halves = phd_split(period);
    m->start = phd_divide(x, period);
    for (n = 0; n < 5; n++) {
        const double angle = (2 * n + 1) * (0.5 * y - 0.25 * PHD_PI.hi);
        m->a[n] = cos(angle);
        m->b[n] = sin(angle);
    }
    m->root_nome = sqrt(q);
    m->decay_high = halves.upper;
    m->decay_low = halves.lower + halves.rest;
    m->y_turns = separatrix ? 0.0 : y * (0.5 / PHD_PI.hi);
    m->periodic = separatrix ? 0.0 : 1.0;
    m->parity = l[0] < 0.0 ? 1.0 : 0.0;
}

static inline void phd_free_spinor(const polhode_free_body *m, phd_time t, double spinor[4])
{
    const phd_phase one = phd_reduce(m->first, t), two = phd_reduce(m->second, t);
    const double *a = m->a, *b = m->b;
    if (m->full) {
        const phd_wave A = phd_sine_cosine(one.fraction + (one.rest - m->start.hi));
        const phd_wave B = phd_sine_cosine(two.fraction + (two.rest + m->start.hi));
        const double cz = A.cosine * B.cosine + A.sine * B.sine, sz = B.sine * A.cosine - B.cosine * A.sine;
        const double s2 = sz + sz, X = 1.0 - s2 * sz, Y = s2 * cz;
        const double pa = a[0] + X * (a[1] + X * a[2]), qa = Y * (a[3] + X * a[4]);
        const double pb = b[0] + X * (b[1] + X * b[2]), qb = Y * (b[3] + X * b[4]);
        spinor[0] = A.cosine * pa - A.sine * qa;
        spinor[1] = A.cosine * qa + A.sine * pa;
        spinor[2] = B.cosine * pb - B.sine * qb;
        spinor[3] = B.cosine * qb + B.sine * pb;
    } else {
        /* on the separatrix u runs to infinity: no period is taken out */
        const phd_pair sum = phd_two_sum((1.0 - m->periodic) * two.turns, two.fraction);
        const phd_pair v = phd_two_sum(sum.hi, m->start.hi);
        const phd_pair w = phd_fast_two_sum(v.hi, two.rest + (m->start.lo + (sum.lo + v.lo)));
        const double more = m->periodic * rint(w.hi), u = w.hi - more, side = u < 0.0 ? -1.0 : 1.0;
        double count = m->parity + (m->periodic * two.turns + more), odd, f = u * side, g = w.lo * side, distance, e0, R, q;
        double grow = 1.0, fall, grow_by, fall_by, ar = 0.0, ai = 0.0, br = 0.0, bi = 0.0, sign = -1.0;
        phd_wave wave;
        int n;
        count -= 4.0 * rint(0.25 * count);
        wave = phd_sine_cosine(phd_wrapped(one.fraction - 0.25 * count) + (one.rest - u * m->y_turns));
        e0 = phd_decay(f, g, m->decay_high, m->decay_low);
        distance = fmax(0.5 - f, 0.0);
        R = m->periodic
          * phd_decay(distance, ((0.5 - distance) - f) * m->periodic - g, m->decay_high, m->decay_low);
        q = m->root_nome * m->root_nome;
        fall = e0;
        grow_by = m->root_nome * R;
        fall_by = q * e0;
        for (n = 0; n < 5; n++) {
            const double plus = grow + fall, minus = grow - fall;
            ar += a[n] * plus;
            ai += b[n] * minus;
            br += sign * b[n] * plus;
            bi -= sign * a[n] * minus;
            grow *= grow_by;
            fall *= fall_by;
            grow_by *= q;
            fall_by *= q;
            sign = -sign;
        }
        ai *= side;
        bi *= side;
        odd = 1.0 - 2.0 * (count - 2.0 * floor(0.5 * count));
        spinor[0] = wave.cosine * ar - wave.sine * ai;
        spinor[1] = wave.cosine * ai + wave.sine * ar;
        spinor[2] = odd * (wave.cosine * br - wave.sine * bi);
        spinor[3] = odd * (wave.cosine * bi + wave.sine * br);
    }
}

static inline void phd_rotation_axis(const double moments[3], const double momentum[3], double axis[3])
{
    const double largest = phd_largest3(momentum), least = fmin(fmin(moments[0], moments[1]), moments[2]);
    double size;
    int i;
    for (i = 0; i < 3; i++) axis[i] = largest > 0.0 ? momentum[i] / largest * (least / moments[i]) : 0.0;
    size = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
    for (i = 0; i < 3; i++) axis[i] = size > 0.0 ? axis[i] / size : 0.0;
}

static inline void phd_free_matrices(
    polhode_free_body *m, const phd_free *f, const phd_free_rates *rates, const double moments[3], const double momentum[3],
    const double attitude[4])
{
    double s[4], size, relative[4][4], axis[3], column[4], turned[4];
    const double mirror = f->long_axis ? -1.0 : 1.0;
    int i, j, k;
    phd_free_spinor(m, PHD_EPOCH, s);
    size = sqrt((s[0] * s[0] + s[1] * s[1]) + (s[2] * s[2] + s[3] * s[3]));
    for (k = 0; k < 4; k++) s[k] /= size;
    /* rows of (start frame)* (present frame) as functions of the spinor */
    relative[0][0] = s[0]; relative[0][1] = s[1]; relative[0][2] = s[2]; relative[0][3] = s[3];
    relative[1][0] = -s[3]; relative[1][1] = s[2]; relative[1][2] = -s[1]; relative[1][3] = s[0];
    relative[2][0] = s[2]; relative[2][1] = s[3]; relative[2][2] = -s[0]; relative[2][3] = -s[1];
    relative[3][0] = -s[1]; relative[3][1] = s[0]; relative[3][2] = s[3]; relative[3][3] = -s[2];
    phd_rotation_axis(moments, momentum, axis);
    for (k = 0; k < 4; k++) {
        column[0] = rates->constant ? (k == 0 ? 1.0 : 0.0) : relative[0][k];
        for (i = 0; i < 3; i++) {
            double sum = 0.0;
            for (j = 0; j < 3; j++) sum += f->axes[3 * i + j] * relative[1 + j][k];
            column[1 + i] = rates->constant ? (k == 1 ? axis[i] : 0.0) : mirror * sum;
        }
        phd_quaternion_product(attitude, column, turned);
        for (i = 0; i < 4; i++) m->to_attitude[4 * i + k] = turned[i];
    }
    for (i = 0; i < 3; i++)
        for (j = 0; j < 3; j++)
            m->to_momentum[3 * i + j] = rates->constant ? (j == 2 ? momentum[i] : 0.0)
                                                        : rates->G.hi * f->momentum_scale * f->axes[3 * i + j];
}

static inline void phd_free_numbers(
    polhode_free_body *m, const phd_free *f, const phd_free_rates *rates, const double moments[3], const double momentum[3])
{
    const double sense = f->long_axis ? -1.0 : 1.0, size = phd_largest3(momentum);
    const int symmetric = f->I[0] == f->I[1] || f->I[1] == f->I[2];
    phd_pair scaled;
    int i;
    m->energy = 0.5 * (momentum[0] / moments[0] * momentum[0] + momentum[1] / moments[1] * momentum[1]
                       + momentum[2] / moments[2] * momentum[2]);
    m->momentum_norm = sqrt(f->G2.hi) * f->momentum_scale;
    m->encircled_axis = -1;
    m->modulus = m->period = m->precession_rate = m->precession_per_period = m->flip_interval = NAN;
    m->regime = size == 0.0           ? POLHODE_REST
              : f->I[0] == f->I[2]    ? POLHODE_SPHERICAL
              : rates->constant       ? POLHODE_PERMANENT
              : rates->separatrix     ? POLHODE_SEPARATRIX
              : symmetric             ? POLHODE_SYMMETRIC
              : f->long_axis          ? POLHODE_LONG_AXIS
                                      : POLHODE_SHORT_AXIS;
    if (rates->constant) return;
    m->precession_rate = sense * phd_divide(rates->precession, f->V).hi * f->rate_scale;
    if (rates->separatrix) {
        m->modulus = 1.0;
        m->period = m->precession_per_period = m->flip_interval = INFINITY;
        return;
    }
    scaled = phd_divide(phd_scale(PHD_PI, 2.0), rates->mean);
    for (i = 0; i < 3; i++) if (f->axes[3 * i + 2] != 0.0) m->encircled_axis = i;
    m->modulus = sqrt(f->A.hi / f->B.hi) * (f->root_P / sqrt(f->Q.hi));
    m->period = phd_multiply(scaled, f->V).hi / f->rate_scale;
    m->precession_per_period = sense * phd_multiply(rates->precession, scaled).hi;
    if (!symmetric) m->flip_interval = 0.5 * m->period;
}

/* Prepares a free body: principal moments [kg m2] in any order, momentum at the epoch along the principal axes, unit
   quaternion (NULL for the identity). Returns 0 or an error code, of which polhode_error tells the meaning. */
static inline int polhode_free_body_init(
    polhode_free_body *m, const double moments[3], const double momentum[3], const double attitude[4], double epoch)
{
    static const double identity[4] = {1.0, 0.0, 0.0, 0.0};
    const int error = phd_check(moments, momentum, attitude, epoch);
    double q[4], size = 1.0, parameter, complement;
    phd_free f;
    phd_free_rates rates;
    phd_pair inverse, half, turn, first, second;
    int k;
    if (error) return error;
    if (!attitude) attitude = identity;
    size = sqrt(attitude[0] * attitude[0] + attitude[1] * attitude[1] + attitude[2] * attitude[2] + attitude[3] * attitude[3]);
    for (k = 0; k < 4; k++) q[k] = attitude[k] / size;
    f = phd_reduced(moments, momentum);
    rates = phd_rates_of(&f);
    parameter = f.A.hi * f.P.hi;
    complement = -f.C.hi * f.S.hi;
    m->epoch = epoch;
    m->fastest = 0.0;
    for (k = 0; k < 3; k++) m->fastest = fmax(m->fastest, fabs(momentum[k] / moments[k]));
    m->full = rates.constant || (parameter <= complement && !rates.separatrix);
    inverse = phd_scale(phd_divide(PHD_INVERSE_TWO_PI, f.V), f.rate_scale);
    half = phd_scale(phd_multiply(rates.precession, inverse), 0.5);
    turn = phd_scale(phd_multiply(rates.mean, inverse), 2.0);
    m->start = PHD_ZERO;
    m->root_nome = m->decay_high = m->decay_low = m->y_turns = m->periodic = m->parity = 0.0;
    for (k = 0; k < 5; k++) m->a[k] = m->b[k] = 0.0;
    if (rates.constant) {
        phd_pair sum = PHD_ZERO;
        for (k = 0; k < 3; k++) sum = phd_add(sum, phd_square(phd_divide(phd_make(f.L[k], 0.0), phd_make(f.I[k], 0.0))));
        first = phd_scale(phd_multiply(phd_sqrt(sum), PHD_INVERSE_TWO_PI), 0.5 * f.rate_scale);
        second = PHD_ZERO;
        m->a[0] = 1.0;
    } else if (m->full) {
        first = phd_subtract(half, phd_scale(turn, 0.25));
        second = phd_add(half, phd_scale(turn, 0.25));
        phd_full_series(m, &f, parameter, complement);
    } else {
        first = half;
        second = rates.separatrix ? phd_scale(phd_divide(rates.modulus, f.V), f.rate_scale) : turn;
        phd_complementary_series(m, &f, &rates, parameter, complement);
    }
    m->first = phd_split(first);
    m->second = phd_split(second);
    phd_free_matrices(m, &f, &rates, moments, momentum, q);
    phd_free_numbers(m, &f, &rates, moments, momentum);
    return isfinite(m->fastest) && isfinite(first.hi) && isfinite(second.hi) && isfinite(m->first.lower)
            && isfinite(m->second.lower) && phd_are_finite(m->to_attitude, 16) && phd_are_finite(m->to_momentum, 9)
         ? POLHODE_OK : POLHODE_OUT_OF_RANGE;
}

/* Gives attitude (w, x, y, z) and momentum (body axes) at a time [s]. Returns 0 or an error code. */
static inline int polhode_free_body_state(const polhode_free_body *m, double t, double attitude[4], double momentum[3])
{
    const phd_time since = phd_since(t, m->epoch);
    double s[4], aa, bb, x, root, n[3];
    int k;
    if (!(fabs(since.high) * m->fastest <= 1e27)) return POLHODE_BAD_TIME;
    phd_free_spinor(m, since, s);
    aa = s[0] * s[0] + s[1] * s[1];
    bb = s[2] * s[2] + s[3] * s[3];
    x = 1.0 / (aa + bb);
    root = sqrt(x);
    n[0] = (s[0] * s[2] + s[1] * s[3]) * (x + x);
    n[1] = (s[0] * s[3] - s[1] * s[2]) * (x + x);
    n[2] = (aa - bb) * x;
    for (k = 0; k < 4; k++) s[k] *= root;
    for (k = 0; k < 4; k++) {
        const double *row = m->to_attitude + 4 * k;
        attitude[k] = ((row[0] * s[0] + row[1] * s[1]) + row[2] * s[2]) + row[3] * s[3];
    }
    for (k = 0; k < 3; k++) {
        const double *row = m->to_momentum + 3 * k;
        momentum[k] = (row[0] * n[0] + row[1] * n[1]) + row[2] * n[2];
    }
    return POLHODE_OK;
}

/* ---------------------------------------------------------------- the Lagrange top
   Comments on the method stand in top_reduction.js, top_roots.js, top_rates.js, top_series.js and top_state.js. */

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
    int full;
    double epoch, fastest;
    phd_rate first, second, third; /* of the phases of alpha and beta, and of the argument */
    phd_pair start;
    double a_up[4], a_down[4], b_up[4], b_down[4]; /* full: sums and gaps; complementary: sines and cosines, cosines and sines */
    double constant, q, decay_high, decay_low, turns_a, turns_b, periodic, sign_a, sign_b;
    double by_argument, by_phase, phase[4], axial, reversed;
} polhode_top;

typedef struct {
    double I1, I3, L[3], q[4], reversed, momentum_scale, rate_scale;
    int lift, upright, leaves; /* L and q have a tiny displacement from the vertical scaled up by 2^lift */
    phd_pair size, G, s0, t0, u0, p, c, c_plus, twist, F, D, w2, lean;
} phd_top;

typedef struct { phd_pair from_lower, from_upper, d, s1, s2, t1, t2, A, B, Y, Z_minus, Z_plus; } phd_turning;

typedef struct {
    phd_pair half_root, nutation, alpha, beta, spin;
    double sign_alpha, sign_beta;
    int permanent, separatrix, steady;
} phd_top_rates;

typedef struct { int full; double q, theta3, y_alpha, y_beta, r_alpha, r_beta; phd_pair x0; } phd_lattice;

/* a b + c d as a sum of floats */
static inline phd_sum phd_two_products(double a, double b, double c, double d)
{
    const phd_sum second = phd_sum_of(phd_two_product(c, d));
    return phd_joined(phd_sum_of(phd_two_product(a, b)), &second, 1.0);
}

static inline phd_pair phd_over(const phd_sum *x, phd_pair n) { return phd_divide(phd_distil(*x), n); }

/* The invariants, summed exactly: near the separatrix c, F and D vanish together, and what is left of them decides. `size` is
   |q|^2 of the quaternion as given: as a pair it would leave F of a planar top only 32 digits of what cancels. */
static inline void phd_top_invariants(phd_top *t, const phd_sum *size)
{
    const double L1 = t->L[0], L2 = t->L[1], L3 = t->L[2], w = t->q[0], x = t->q[1], y = t->q[2], z = t->q[3];
    const phd_sum S = phd_two_products(x, x, y, y), T = phd_two_products(w, w, z, z);
    const phd_sum real = phd_two_products(x, w, y, z), imaginary = phd_two_products(x, z, -y, w);
    const phd_sum w2 = phd_two_products(L1, L1, L2, L2), minus_L3 = phd_sum_of(phd_two_product(L3, -L3));
    const phd_sum G = phd_sum_of(t->G);
    phd_sum in_phase, twist, c, c_plus, energy, F, D, rest, lean, part;
    part = phd_sum_times(&imaginary, -L2);
    in_phase = phd_compress(phd_joined(phd_sum_times(&real, L1), &part, 1.0), 4);
    part = phd_sum_times(&imaginary, L1);
    twist = phd_joined(phd_sum_times(&real, L2), &part, 1.0);
    part.count = 0;
    twist = phd_compress(phd_joined(part, &twist, 2.0), 4);
    part = phd_sum_times(&S, -2.0 * L3);
    c = phd_compress(phd_joined(twist, &part, 1.0), 4);
    part = phd_sum_times(&T, 2.0 * L3);
    c_plus = phd_compress(phd_joined(twist, &part, 1.0), 4);
    part = phd_sum_times_sum(&G, &S);
    energy = phd_compress(phd_joined(phd_sum_times_sum(size, &w2), &part, -2.0), 5);
    part = phd_sum_times(&c, -L3);
    F = phd_compress(phd_joined(energy, &part, 1.0), 5);
    part.count = 0;
    rest = phd_joined(phd_joined(part, &G, 2.0), &minus_L3, 1.0);
    D = phd_compress(phd_joined(phd_sum_times_sum(size, &rest), &energy, -1.0), 5);
    part = phd_sum_times_sum(&G, &c);
    lean = phd_compress(phd_joined(phd_sum_times(&energy, L3), &part, -1.0), 6);
    t->s0 = phd_scale(phd_over(&S, t->size), 2.0);
    t->t0 = phd_scale(phd_over(&T, t->size), 2.0);
    part = phd_joined(T, &S, -1.0);
    t->u0 = phd_over(&part, t->size);
    t->p = phd_scale(phd_over(&in_phase, t->size), -2.0);
    t->c = phd_over(&c, t->size);
    t->c_plus = phd_over(&c_plus, t->size);
    t->twist = phd_over(&twist, t->size);
    t->F = phd_over(&F, t->size);
    t->D = phd_over(&D, t->size);
    t->w2 = phd_distil(w2);
    t->lean = phd_over(&lean, t->size);
}

/* Scales a tiny displacement from the vertical up. There the motion is linear in it, and the invariants are of its square, so
   that squares of these underflow. Exactly at the threshold of sleeping, where it grows like t, it is dropped: nothing is to be
   seen of it within 1e27 radians. */
static inline void phd_lift_top(phd_top *t)
{
    const double cosine = fmax(fabs(t->q[0]), fabs(t->q[3])), sine = fmax(fabs(t->q[1]), fabs(t->q[2]));
    const double displacement = fmax(fmin(cosine, sine), fmax(fabs(t->L[0]), fabs(t->L[1])));
    const phd_pair twice = phd_scale(t->G, 2.0), square = phd_two_product(t->L[2], t->L[2]);
    const int exponent = phd_exponent(displacement);
    double *first, *second;
    t->upright = cosine >= sine;
    t->lift = 0;
    if (!(displacement > 0.0 && exponent < -200 && t->G.hi > 0.0)) return;
    first = &t->q[t->upright ? 1 : 0];
    second = &t->q[t->upright ? 2 : 3];
    if (t->upright && twice.hi == square.hi && twice.lo == square.lo) {
        *first = *second = t->L[0] = t->L[1] = 0.0;
        return;
    }
    t->lift = -150 - exponent;
    *first = ldexp(*first, t->lift);
    *second = ldexp(*second, t->lift);
    t->L[0] = ldexp(t->L[0], t->lift);
    t->L[1] = ldexp(t->L[1], t->lift);
}

static inline phd_top phd_reduced_top(const double moments[3], double mgl, const double momentum[3], const double q[4])
{
    phd_top t;
    const int turned = mgl < 0.0, moment_exponent = phd_exponent(moments[0]);
    const double largest = phd_largest3(momentum), weight = fabs(mgl), sign = turned ? -1.0 : 1.0;
    int exponent = phd_exponent(largest), k;
    phd_sum S, T, size;
    if (weight > 0.0) { /* the larger of |L| and sqrt(mgl I1), without forming a product that may overflow */
        const int half = (int)floor((moment_exponent + phd_exponent(weight) + 1) / 2.0);
        exponent = largest > 0.0 && exponent > half ? exponent : half;
    }
    /* a centre of mass below is one above on the reversed axis: a half turn about the first body axis */
    t.q[0] = turned ? -q[1] : q[0];
    t.q[1] = turned ? q[0] : q[1];
    t.q[2] = turned ? q[3] : q[2];
    t.q[3] = turned ? -q[2] : q[3];
    t.I1 = ldexp(moments[0], -moment_exponent);
    t.I3 = ldexp(moments[2], -moment_exponent);
    for (k = 0; k < 3; k++) t.L[k] = (k ? sign : 1.0) * ldexp(momentum[k], -exponent);
    t.reversed = sign;
    t.momentum_scale = ldexp(1.0, exponent);
    t.rate_scale = ldexp(1.0, exponent - moment_exponent);
    t.G = phd_scale(phd_two_product(ldexp(ldexp(weight, moment_exponent - exponent), -exponent), t.I1), 2.0);
    S = phd_two_products(t.q[1], t.q[1], t.q[2], t.q[2]);
    T = phd_two_products(t.q[0], t.q[0], t.q[3], t.q[3]);
    size = phd_compress(phd_joined(S, &T, 1.0), 4);
    t.size = phd_distil(size);
    phd_lift_top(&t);
    phd_top_invariants(&t, &size);
    t.leaves = t.lift > 0 && t.upright && t.D.hi > 0.0;
    return t;
}

/* Returns the largest root of x^3 + b x^2 + c x + d, whose roots are real, and in *cosine Viete's cos 3 phi. */
static inline double phd_largest_root(const phd_pair cubic[3], double *cosine)
{
    const double b = cubic[0].hi, c = cubic[1].hi, d = cubic[2].hi;
    const double P = c - b * b / 3.0, Q = 2.0 * b * b * b / 27.0 - b * c / 3.0 + d, r = sqrt(fmax(-P / 3.0, 0.0));
    *cosine = r > 0.0 ? fmin(fmax(-0.5 * Q / (r * r * r), -1.0), 1.0) : 1.0;
    return 2.0 * r * cos(acos(*cosine) / 3.0) - b / 3.0;
}

static inline phd_pair phd_polished(double start, const phd_pair cubic[3])
{
    phd_pair x = phd_make(start, 0.0);
    int step;
    for (step = 0; step < 5; step++) {
        const phd_pair inner = phd_add(phd_multiply(phd_add(x, cubic[0]), x), cubic[1]);
        const phd_pair value = phd_add(phd_multiply(inner, x), cubic[2]);
        const phd_pair three = phd_add(phd_add(phd_scale(x, 2.0), x), phd_scale(cubic[0], 2.0));
        const phd_pair change = phd_divide(value, phd_add(phd_multiply(three, x), cubic[1]));
        if (isfinite(change.hi)) x = phd_subtract(x, change);
    }
    return x;
}

/* x / y, and zero for x = 0 whatever y */
static inline phd_pair phd_quotient(phd_pair x, phd_pair y) { return x.hi == 0.0 ? x : phd_divide(x, y); }

/* x >= 0 and y >= 0 from x - y, x + y and x y */
static inline void phd_larger_and_smaller(phd_pair sum, phd_pair difference, phd_pair product, phd_pair *x, phd_pair *y)
{
    const int positive = sum.hi >= 0.0;
    const phd_pair larger = phd_scale(phd_add(difference, positive ? sum : phd_negate(sum)), 0.5);
    const phd_pair smaller = larger.hi > 0.0 ? phd_quotient(product, larger) : PHD_ZERO;
    *x = positive ? larger : smaller;
    *y = positive ? smaller : larger;
}

/* x + y = sqrt((x - y)^2 + 4 x y), also where the square underflows */
static inline phd_pair phd_difference(phd_pair sum, phd_pair product)
{
    const int exponent = phd_exponent(sum.hi);
    const int alone = product.hi == 0.0 || phd_exponent(product.hi) < 2 * exponent;
    const int tiny = sum.hi != 0.0 && exponent < -400 && alone;
    const double up = ldexp(1.0, tiny ? -exponent : 0), down = ldexp(1.0, tiny ? exponent : 0);
    const phd_pair raised = phd_scale(phd_scale(product, up), up);
    return phd_scale(phd_sqrt(phd_add(phd_square(phd_scale(sum, up)), phd_scale(raised, 4.0))), down);
}

static inline void phd_upper_root_apart(const phd_top *t, phd_pair p2, phd_pair c2, phd_pair f1, phd_turning *o)
{
    const phd_pair product = phd_quotient(p2, o->Y);
    const phd_pair sum = phd_quotient(phd_add(f1, phd_multiply(t->G, product)), o->Y);
    o->d = phd_difference(sum, product);
    phd_larger_and_smaller(sum, o->d, product, &o->from_upper, &o->from_lower);
    o->s1 = phd_add(t->s0, o->from_lower);
    o->s2 = phd_subtract(t->s0, o->from_upper);
    o->Z_minus = phd_subtract(o->Y, phd_multiply(t->G, t->s0));
    /* s1 s2 Z = c^2; of s2 and Z only the larger is an accurate difference */
    if (o->Z_minus.hi >= phd_multiply(t->G, o->s2).hi) o->s2 = phd_quotient(c2, phd_multiply(o->s1, o->Z_minus));
    else o->Z_minus = phd_quotient(c2, phd_multiply(o->s1, o->s2));
    o->A = phd_add(o->Y, phd_multiply(t->G, o->from_lower));
    o->B = phd_subtract(o->Y, phd_multiply(t->G, o->from_upper));
}

static inline void phd_lower_root_apart(const phd_top *t, phd_pair p2, phd_pair c2, phd_turning *o)
{
    const phd_pair Gs1 = phd_multiply(t->G, o->s1), product = phd_quotient(c2, Gs1);
    const phd_pair sum = phd_divide(phd_add(phd_scale(t->F, -2.0), phd_quotient(c2, o->s1)), Gs1);
    const phd_pair gap = phd_difference(sum, product);
    phd_pair minus_s3, other;
    phd_larger_and_smaller(sum, gap, product, &o->s2, &minus_s3);
    o->Z_minus = phd_multiply(t->G, minus_s3);
    o->Y = phd_add(phd_multiply(t->G, t->s0), o->Z_minus);
    other = phd_quotient(p2, o->Y);
    o->from_upper = phd_subtract(t->s0, o->s2);
    o->from_lower = phd_subtract(o->s1, t->s0);
    if (o->from_upper.hi >= o->from_lower.hi) o->from_lower = phd_quotient(other, o->from_upper);
    else o->from_upper = phd_quotient(other, o->from_lower);
    o->d = phd_subtract(o->s1, o->s2);
    o->A = phd_multiply(t->G, phd_add(o->s1, minus_s3));
    o->B = phd_multiply(t->G, gap);
}

static inline phd_turning phd_turning_points(const phd_top *t)
{
    phd_turning o;
    const phd_pair G = t->G, p2 = phd_square(t->p), c2 = phd_square(t->c), a = phd_make(t->L[2], 0.0);
    phd_pair f1 = phd_scale(phd_multiply(a, t->twist), 2.0), cubic[3];
    double cosine, root;
    f1 = phd_subtract(f1, phd_multiply(G, phd_multiply(t->s0, t->t0)));
    f1 = phd_subtract(f1, phd_scale(phd_multiply(t->u0, t->w2), 2.0));
    cubic[0] = phd_subtract(phd_subtract(phd_scale(phd_multiply(G, t->u0), 2.0), t->w2), phd_square(a));
    cubic[1] = phd_multiply(G, f1);
    cubic[2] = phd_multiply(phd_square(G), p2);
    root = phd_largest_root(cubic, &cosine);
    if (cosine >= 0.0 || !(G.hi > 0.0)) {
        o.Y = phd_polished(root, cubic);
        phd_upper_root_apart(t, p2, c2, f1, &o);
    } else {
        cubic[0] = phd_negate(phd_divide(t->D, G));
        cubic[1] = phd_scale(phd_divide(t->F, G), -2.0);
        cubic[2] = phd_divide(c2, G);
        root = phd_largest_root(cubic, &cosine);
        o.s1 = phd_polished(root, cubic);
        phd_lower_root_apart(t, p2, c2, &o);
    }
    o.t2 = phd_add(t->t0, o.from_upper);
    o.Z_plus = phd_add(o.Y, phd_multiply(G, t->t0));
    o.t1 = phd_quotient(phd_square(t->c_plus), phd_multiply(o.t2, o.Z_plus));
    return o;
}

/* c G/(4 Z) sum in the first form, |c|/(2 near) [1 - d/(2 far) sum] - nutation in the second */
static inline phd_pair phd_drift(
    phd_pair G, phd_pair c, phd_pair Z, phd_pair near, phd_pair far, phd_pair d, phd_pair nutation, phd_pair total, int first)
{
    const int idle = c.hi == 0.0;
    phd_pair outer, share;
    if (first) return phd_scale(phd_multiply(phd_divide(phd_multiply(c, G), idle ? PHD_ONE : Z), total), 0.25);
    outer = phd_scale(phd_divide(c, idle ? PHD_ONE : near), 0.5);
    share = phd_scale(phd_multiply(phd_divide(d, far), total), 0.5);
    return phd_subtract(phd_multiply(outer, phd_subtract(PHD_ONE, share)), nutation);
}

/* The x = W tau that a top which leaves the vertical needs until its displacement is as large as the lifted one. */
static inline phd_pair phd_climb(const phd_top *t) { return t->leaves ? phd_times(PHD_LN2, t->lift) : PHD_ZERO; }

/* The rates of a top that leaves the vertical from those of the lifted one: K = pi W/(2 nutation) is longer by the climb,
   during which alpha turns by c'/4 and beta not at all. */
static inline void phd_linger(const phd_top *t, phd_top_rates *r)
{
    const phd_pair own = phd_scale(t->c_plus, 0.25), product = phd_multiply(phd_climb(t), r->nutation);
    const phd_pair longer = phd_scale(phd_divide(product, phd_multiply(PHD_PI, r->half_root)), 2.0); /* climb/K */
    const phd_pair share = phd_divide(PHD_ONE, phd_add(PHD_ONE, longer));
    r->nutation = phd_multiply(r->nutation, share);
    r->alpha = phd_add(own, phd_multiply(phd_subtract(r->alpha, own), share));
    r->beta = phd_multiply(r->beta, share);
}

static inline phd_top_rates phd_rates_of_top(const phd_top *t, const phd_turning *o)
{
    phd_top_rates r;
    const double a = t->L[2];
    const int upright = t->s0.hi == 0.0 || t->t0.hi == 0.0;
    const phd_pair root_A = phd_sqrt(o->A);
    phd_pair root_B, c, c_plus, square_alpha, square_beta, total_alpha, total_beta;
    int first_alpha, first_beta;
    r.permanent = t->w2.hi == 0.0 && (upright || (t->G.hi == 0.0 && a == 0.0));
    r.separatrix = !(o->B.hi > 0.0) && !r.permanent;
    r.steady = 0;
    r.sign_alpha = t->c_plus.hi >= 0.0 ? 1.0 : -1.0;
    r.sign_beta = t->c.hi >= 0.0 ? 1.0 : -1.0;
    r.half_root = phd_scale(root_A, 0.5);
    r.spin = phd_divide(phd_times(phd_two_sum(t->I1, -t->I3), a), phd_make(t->I3, 0.0));
    r.nutation = r.alpha = r.beta = PHD_ZERO;
    if (r.separatrix) r.alpha = phd_scale(t->c_plus, 0.25);
    if (r.permanent || r.separatrix) return r;
    root_B = phd_sqrt(o->B);
    c_plus = phd_scale(t->c_plus, r.sign_alpha);
    c = phd_scale(t->c, r.sign_beta);
    first_alpha = o->Z_plus.hi <= 2.0 * o->A.hi;
    first_beta = phd_multiply(t->G, o->s2).hi <= o->Z_minus.hi;
    square_alpha = first_alpha ? o->Z_plus : phd_divide(phd_multiply(o->A, o->t2), o->t1);
    /* c = 0 through the upper pole: the factor of the sum vanishes, and the square must only not be zero */
    square_beta = first_beta ? (c.hi == 0.0 ? o->A : o->Z_minus) : phd_divide(phd_multiply(o->s1, o->B), o->s2);
    r.nutation = phd_scale(phd_agm(root_A, root_B, square_alpha, &total_alpha), 0.5);
    (void)phd_agm(root_A, root_B, square_beta, &total_beta);
    r.alpha = phd_drift(t->G, c_plus, o->Z_plus, o->t1, o->t2, o->d, r.nutation, total_alpha, first_alpha);
    r.beta = phd_drift(t->G, c, o->Z_minus, o->s2, o->s1, o->d, r.nutation, total_beta, first_beta);
    r.alpha = phd_scale(r.alpha, r.sign_alpha);
    r.beta = phd_scale(r.beta, first_beta ? -r.sign_beta : r.sign_beta);
    r.steady = !(o->d.hi > 0.0);
    if (t->leaves) phd_linger(t, &r);
    return r;
}

/* R_F(x, y, 1) by duplication. Carlson, Numer. Algorithms 10 (1995) 13. */
static inline phd_pair phd_first_kind(phd_pair x, phd_pair y)
{
    phd_pair a = x, b = y, c = PHD_ONE, mean;
    double X, Y, Z, E2, E3;
    int step;
    for (step = 0; step < 20; step++) {
        const phd_pair ra = phd_sqrt(a), rb = phd_sqrt(b), rc = phd_sqrt(c);
        const phd_pair lambda = phd_add(phd_add(phd_multiply(ra, rb), phd_multiply(rb, rc)), phd_multiply(rc, ra));
        a = phd_scale(phd_add(a, lambda), 0.25);
        b = phd_scale(phd_add(b, lambda), 0.25);
        c = phd_scale(phd_add(c, lambda), 0.25);
    }
    mean = phd_divide(phd_add(phd_add(a, b), c), phd_make(3.0, 0.0));
    X = phd_subtract(PHD_ONE, phd_divide(a, mean)).hi;
    Y = phd_subtract(PHD_ONE, phd_divide(b, mean)).hi;
    Z = -X - Y;
    E2 = X * Y - Z * Z;
    E3 = X * Y * Z;
    X = -E2 / 10.0 + E3 / 14.0 + E2 * E2 / 24.0 - 3.0 * E2 * E3 / 44.0;
    return phd_divide(phd_add(PHD_ONE, phd_make(X, 0.0)), phd_sqrt(mean));
}

/* sqrt(factor) R_F(x, y, 1), and sqrt(factor) where the integral is not used */
static inline phd_pair phd_integral(phd_pair factor, phd_pair x, phd_pair y)
{
    const double size = x.hi + y.hi;
    return phd_multiply(phd_sqrt(factor), size > 0.0 && isfinite(size) ? phd_first_kind(x, y) : PHD_ONE);
}

static inline phd_lattice phd_places(const phd_top *t, const phd_turning *o, const phd_top_rates *r)
{
    phd_lattice at;
    const phd_pair G = t->G, A = o->A, d = o->d;
    const double m = G.hi * d.hi / A.hi, m1 = r->separatrix ? 0.0 : o->B.hi / A.hi;
    double small, scale;
    at.full = r->permanent || (m <= m1 && !r->separatrix);
    small = r->permanent ? 0.0 : at.full ? m : m1;
    at.q = small * phd_nome_over(small, sqrt(1.0 - small));
    at.theta3 = 1.0 + phd_theta3_excess(at.q);
    scale = 1.0 / (at.theta3 * at.theta3);
    /* where the tilt stays the pole is infinitely far: only exp(-y) = 0 enters */
    at.y_alpha = at.y_beta = r->steady ? INFINITY : 0.0;
    at.r_alpha = at.r_beta = 0.0;
    at.x0 = PHD_ZERO;
    if (r->permanent || r->steady) return at;
    if (r->separatrix) {
        at.y_alpha = atan2(sqrt(o->t1.hi), sqrt(d.hi)) * scale;
    } else {
        const phd_pair s1B = phd_multiply(o->s1, o->B), At2 = phd_multiply(A, o->t2);
        at.y_alpha = scale * phd_integral(phd_divide(o->t1, o->t2), phd_divide(d, o->t2),
                                          phd_divide(phd_multiply(d, o->Z_plus), At2)).hi;
        if (o->s2.hi != 0.0)
            at.y_beta = scale * phd_integral(phd_divide(phd_multiply(o->s2, A), s1B),
                                             phd_divide(phd_multiply(d, o->Z_minus), s1B), phd_divide(d, o->s1)).hi;
    }
    if (at.full && at.q > 0.0) {
        at.r_alpha = exp(-2.0 * scale * phd_integral(phd_divide(A, o->Z_plus), phd_divide(phd_multiply(G, o->t1), o->Z_plus),
                                                     phd_divide(phd_multiply(G, o->t2), o->Z_plus)).hi);
        at.r_beta = exp(-2.0 * scale * phd_integral(phd_divide(o->Z_minus, o->B), phd_divide(phd_multiply(G, o->s2), o->B),
                                                    phd_divide(phd_multiply(G, o->s1), A)).hi);
    }
    at.x0 = phd_integral(phd_divide(o->from_lower, d), phd_divide(o->from_upper, d), phd_divide(o->Y, A));
    at.x0 = phd_add(at.x0, phd_climb(t));
    if (!(t->p.hi >= 0.0)) at.x0 = phd_negate(at.x0);
    return at;
}

static inline void phd_top_argument(polhode_top *m, const phd_top *t, const phd_top_rates *r, const phd_lattice *at)
{
    phd_pair third, twice_K;
    phd_rate halves;
    const double share = at->full ? 0.5 : 1.0, shrink = phd_theta3_excess(at->q);
    m->decay_high = 1.0;
    m->decay_low = 0.0;
    if (r->permanent) {
        third = PHD_ZERO;
        m->start = phd_make(0.25, 0.0);
    } else if (r->separatrix) {
        third = phd_divide(phd_scale(r->half_root, t->rate_scale), phd_make(t->I1, 0.0));
        m->start = at->x0;
    } else {
        third = phd_divide(phd_scale(r->nutation, t->rate_scale), phd_times(PHD_PI, t->I1));
        third = phd_scale(third, share);
        twice_K = phd_divide(phd_multiply(r->half_root, PHD_PI), r->nutation);
        m->start = phd_scale(phd_divide(at->x0, twice_K), share);
        twice_K = phd_add(twice_K, phd_make(-twice_K.hi * (shrink * (2.0 + shrink) / (at->theta3 * at->theta3)), 0.0));
        halves = phd_split(twice_K);
        m->decay_high = halves.upper;
        m->decay_low = halves.lower + halves.rest;
    }
    m->third = phd_split(third);
}

static inline void phd_full_row(double size, double q, double y, double r, int alternating, double up[4], double down[4])
{
    const double h = exp(-2.0 * y);
    double weight[4], total = 0.0;
    int n;
    for (n = 3; n >= 0; n--) {
        weight[n] = phd_power(phd_power(q, n) * r, n);
        total += weight[n] * (1.0 + phd_power(h, 2 * n + 1));
    }
    for (n = 0; n < 4; n++) {
        const double signed_ = size / total * weight[n] * (alternating && n % 2 ? -1.0 : 1.0), odd = phd_power(h, 2 * n + 1);
        up[n] = signed_ * (1.0 + odd);
        down[n] = signed_ * (1.0 - odd);
    }
}

static inline double phd_theta4(double q, double y)
{
    return 1.0 - 2.0 * (q * cos(2.0 * y) - phd_power(q, 4) * cos(4.0 * y) + phd_power(q, 9) * cos(6.0 * y));
}

static inline void phd_top_series(
    polhode_top *m, const phd_top *t, const phd_turning *o, const phd_top_rates *r, const phd_lattice *at)
{
    /* what stays near the vertical moves as the lifted top does, at the given size */
    const double q = at->q, down = ldexp(1.0, t->leaves ? 0 : -t->lift);
    const double size_a = t->upright ? 1.0 : down, size_b = t->upright ? down : 1.0;
    int n;
    m->constant = 0.0;
    if (r->permanent) { /* one of alpha, beta, or at rest both, as it started */
        for (n = 0; n < 4; n++) m->a_up[n] = m->a_down[n] = m->b_up[n] = m->b_down[n] = 0.0;
        m->a_up[0] = sqrt(0.5 * t->t0.hi);
        m->b_down[0] = sqrt(0.5 * t->s0.hi);
    } else if (at->full) {
        phd_full_row(size_a * sqrt(0.5 * o->t2.hi) * at->theta3, q, at->y_alpha, at->r_alpha, 1, m->a_up, m->a_down);
        phd_full_row(size_b * sqrt(0.5 * o->s1.hi) * phd_theta4(q, 0.0), q, at->y_beta, at->r_beta, 0, m->b_up, m->b_down);
    } else {
        const double alpha = sqrt(0.5 * o->t2.hi) * at->theta3 / phd_theta4(q, at->y_alpha);
        const double theta2 = 1.0 + phd_power(q, 2) + phd_power(q, 6) + phd_power(q, 12);
        const double beta = sqrt(0.5 * o->s1.hi) * theta2 / phd_theta4(q, at->y_beta);
        for (n = 0; n < 4; n++) {
            const double sign = n % 2 ? -1.0 : 1.0;
            m->a_up[n] = alpha * sign * sin((2 * n + 1) * at->y_alpha);
            m->a_down[n] = alpha * sign * cos((2 * n + 1) * at->y_alpha);
            m->b_up[n] = -beta * sign * cos((2 * n + 2) * at->y_beta);
            m->b_down[n] = -beta * sign * sin((2 * n + 2) * at->y_beta);
        }
        m->constant = beta;
    }
}

/* A, B and their derivatives by the argument, real and imaginary parts, and phases in turns */
typedef struct { double ar, ai, br, bi, dar, dai, dbr, dbi, turns_a, turns_b; } phd_numerators;

static inline double phd_turns(phd_rate rate, phd_time t)
{
    const phd_phase p = phd_reduce(rate, t);
    return p.fraction + p.rest;
}

static inline phd_numerators phd_full_numerators(const polhode_top *m, phd_time t)
{
    phd_numerators v = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const phd_wave wave = phd_sine_cosine(phd_turns(m->third, t) + m->start.hi);
    const double double_c = 1.0 - 2.0 * wave.sine * wave.sine, double_s = 2.0 * wave.sine * wave.cosine;
    double c = wave.cosine, s = wave.sine;
    int n;
    for (n = 0; n < 4; n++) {
        const double k = 2.0 * n + 1.0, next = c * double_c - s * double_s;
        v.ar += m->a_up[n] * s;
        v.ai -= m->sign_a * m->a_down[n] * c;
        v.br += m->b_up[n] * c;
        v.bi += m->sign_b * m->b_down[n] * s;
        v.dar += k * m->a_up[n] * c;
        v.dai += k * m->sign_a * m->a_down[n] * s;
        v.dbr -= k * m->b_up[n] * s;
        v.dbi += k * m->sign_b * m->b_down[n] * c;
        s = s * double_c + c * double_s;
        c = next;
    }
    v.turns_a = phd_turns(m->first, t);
    v.turns_b = phd_turns(m->second, t);
    return v;
}

static inline phd_numerators phd_complementary_numerators(const polhode_top *m, phd_time t)
{
    phd_numerators v = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
    const phd_phase p = phd_reduce(m->third, t);
    /* x/2K within half a period as a pair, and the periods taken out; on the separatrix none is */
    const phd_pair sum = phd_two_sum((1.0 - m->periodic) * p.turns, p.fraction), o = phd_two_sum(sum.hi, m->start.hi);
    const phd_pair w = phd_fast_two_sum(o.hi, p.rest + (m->start.lo + (sum.lo + o.lo)));
    const double more = m->periodic * rint(w.hi), u = w.hi - more, count = m->periodic * p.turns + more;
    const double half = 0.5 * (count - 2.0 * floor(0.5 * count)), side = u < 0.0 ? -1.0 : 1.0, f = u * side, g = w.lo * side;
    const double e0 = phd_decay(f, g, m->decay_high, m->decay_low), distance = fmax(0.5 - f, 0.0), e = 2.0 * e0, q = m->q;
    const double R = m->periodic
                   * phd_decay(distance, ((0.5 - distance) - f) * m->periodic - g, m->decay_high, m->decay_low);
    const double h = e0 * e0, r = R * R, q2 = q * q, within = u + w.lo;
    double weight = 1.0, hk = h, up = r, down = q * h, qr = q * r, up_by = q2 * r, down_by = q2 * q * h;
    int n;
    v.br = m->constant;
    for (n = 0; n < 4; n++) {
        const double odd = 2.0 * n + 1.0, even = 2.0 * n + 2.0, plus = weight * (1.0 + hk), minus = weight * (1.0 - hk);
        v.ar += m->a_up[n] * plus;
        v.ai += m->a_down[n] * minus;
        v.dar += odd * m->a_up[n] * minus;
        v.dai += odd * m->a_down[n] * plus;
        v.br += m->b_up[n] * (up + down);
        v.bi += m->b_down[n] * (up - down);
        v.dbr += even * m->b_up[n] * (up - down);
        v.dbi += even * m->b_down[n] * (up + down);
        weight *= qr;
        qr *= q2;
        hk *= h * h;
        up *= up_by;
        up_by *= q2;
        down *= down_by;
        down_by *= q2;
    }
    v.ai *= m->sign_a * side;
    v.dar *= side;
    v.dai *= m->sign_a;
    v.br *= e;
    v.bi *= -m->sign_b * side * e;
    v.dbr *= side * e;
    v.dbi *= -m->sign_b * e;
    v.turns_a = phd_wrapped(phd_turns(m->first, t) + m->sign_a * within * m->turns_a) + half;
    v.turns_b = phd_wrapped(phd_turns(m->second, t) + m->sign_b * within * m->turns_b) + half;
    return v;
}

static inline phd_numerators phd_top_numerators(const polhode_top *m, phd_time t)
{
    return m->full ? phd_full_numerators(m, t) : phd_complementary_numerators(m, t);
}

/* cos and sin of the phase that turns the series r + i i at the epoch into the given g, of slope e */
static inline void phd_constant_phase(
    const double series[4], double turns, double rate, double argument_rate, double drop, const double given[4], double size,
    double phase[2])
{
    const double r = series[0], i = series[1];
    const double sr = argument_rate * (series[2] - r * drop) - rate * i, si = argument_rate * (series[3] - i * drop) + rate * r;
    const double real = (r * given[0] + i * given[1]) + (sr * given[2] + si * given[3]) / size;
    const double imaginary = (r * given[1] - i * given[0]) + (sr * given[3] - si * given[2]) / size;
    const double c = cos(2.0 * PHD_PI.hi * turns), s = sin(2.0 * PHD_PI.hi * turns);
    const double x = real * c + imaginary * s, y = imaginary * c - real * s, length = sqrt(x * x + y * y);
    phase[0] = length > 0.0 ? x / length : 1.0;
    phase[1] = length > 0.0 ? y / length : 0.0;
}

static inline phd_numerators phd_lifted(phd_numerators v, const phd_top *t)
{
    const double up = ldexp(1.0, t->lift), up_a = t->upright ? 1.0 : up, up_b = t->upright ? up : 1.0;
    v.ar *= up_a;
    v.ai *= up_a;
    v.dar *= up_a;
    v.dai *= up_a;
    v.br *= up_b;
    v.bi *= up_b;
    v.dbr *= up_b;
    v.dbi *= up_b;
    return v;
}

static inline void phd_top_phases(polhode_top *m, const phd_top *t, double linear_a, double linear_b, double argument_rate)
{
    const double L1 = t->L[0], L2 = t->L[1], L3 = t->L[2];
    const phd_numerators v = phd_lifted(phd_top_numerators(m, PHD_EPOCH), t);
    const double square = (v.ar * v.ar + v.ai * v.ai) + (v.br * v.br + v.bi * v.bi), norm = sqrt(square);
    const double drop = ((v.ar * v.dar + v.ai * v.dai) + (v.br * v.dbr + v.bi * v.dbi)) / square;
    double size = L1 * L1 + L2 * L2 + L3 * L3 + t->G.hi, q[4], given[4], series[4];
    int k;
    if (!(size > 0.0)) size = 1.0;
    for (k = 0; k < 4; k++) q[k] = phd_divide(phd_make(t->q[k], 0.0), phd_sqrt(t->size)).hi;
    /* 2 alpha' = i a alpha - conj(w) beta, 2 beta' = w alpha - i a beta */
    given[0] = q[0];
    given[1] = q[3];
    given[2] = 0.5 * (-L3 * q[3] - (L1 * q[1] + L2 * q[2]));
    given[3] = 0.5 * (L3 * q[0] - (L1 * q[2] - L2 * q[1]));
    series[0] = v.ar / norm;
    series[1] = v.ai / norm;
    series[2] = v.dar / norm;
    series[3] = v.dai / norm;
    phd_constant_phase(series, v.turns_a, linear_a, argument_rate, drop, given, size, m->phase);
    given[0] = q[1];
    given[1] = q[2];
    given[2] = 0.5 * (L1 * q[0] - L2 * q[3] + L3 * q[2]);
    given[3] = 0.5 * (L1 * q[3] + L2 * q[0] - L3 * q[1]);
    series[0] = v.br / norm;
    series[1] = v.bi / norm;
    series[2] = v.dbr / norm;
    series[3] = v.dbi / norm;
    phd_constant_phase(series, v.turns_b, linear_b, argument_rate, drop, given, size, m->phase + 2);
}

static inline polhode_top_regime phd_regime_of_top(const phd_top *t, const phd_top_rates *r)
{
    const double a = t->L[2], along = a < 0.0 ? -t->lean.hi : t->lean.hi;
    const int within = t->c.hi * a < 0.0 && t->c_plus.hi * a > 0.0; /* the azimuth stands still at some tilt */
    if (r->permanent && a == 0.0) return POLHODE_TOP_REST;
    if (t->G.hi == 0.0) return POLHODE_TOP_FREE;
    if (r->permanent) return t->s0.hi == 0.0 ? POLHODE_TOP_SLEEPING : POLHODE_TOP_HANGING;
    if (r->separatrix) return POLHODE_TOP_SEPARATRIX;
    if (r->steady) return POLHODE_TOP_STEADY;
    if (a == 0.0 && t->c.hi == 0.0) return POLHODE_TOP_PLANAR;
    if (within && along == 0.0) return POLHODE_TOP_CUSP;
    return within && along > 0.0 ? POLHODE_TOP_LOOP : POLHODE_TOP_UNDULATING;
}

/* u from the smaller of 1 - u and 1 + u */
static inline double phd_cosine(phd_pair s, phd_pair t)
{
    return s.hi < t.hi ? phd_subtract(PHD_ONE, s).hi : phd_subtract(t, PHD_ONE).hi;
}

static inline void phd_top_numbers(polhode_top *m, const phd_top *t, const phd_turning *o, const phd_top_rates *r)
{
    double lower = t->u0.hi, upper = t->u0.hi;
    phd_pair alpha, beta, spin;
    if (!r->permanent) {
        lower = phd_cosine(o->s1, o->t1);
        upper = phd_cosine(o->s2, o->t2);
    }
    m->regime = phd_regime_of_top(t, r);
    m->lowest = t->reversed < 0.0 ? -upper : lower;
    m->highest = t->reversed < 0.0 ? -lower : upper;
    m->nutation_period = r->separatrix ? INFINITY : NAN;
    m->precession_per_period = m->spin_per_period = NAN;
    if (r->permanent || r->separatrix) return;
    alpha = phd_add(phd_divide(r->alpha, r->nutation), phd_make(r->sign_alpha, 0.0));
    beta = phd_add(phd_divide(r->beta, r->nutation), phd_make(r->sign_beta, 0.0));
    spin = phd_divide(r->spin, r->nutation);
    m->nutation_period = phd_divide(phd_times(PHD_PI, t->I1), phd_scale(r->nutation, t->rate_scale)).hi;
    m->precession_per_period = phd_multiply(PHD_PI, phd_add(alpha, beta)).hi;
    m->spin_per_period = t->reversed * phd_multiply(PHD_PI, phd_add(phd_subtract(alpha, beta), spin)).hi;
}

/* The phase rates of alpha and beta by tau, the spin that I3 != I1 adds included. */
static inline void phd_top_phase_rates(polhode_top *m, const phd_top *t, const phd_top_rates *r)
{
    const phd_pair spin = phd_scale(r->spin, 0.5), inverse = phd_divide(PHD_INVERSE_TWO_PI, phd_make(t->I1, 0.0));
    phd_pair alpha = phd_add(r->alpha, spin), beta = phd_subtract(r->beta, spin);
    if (r->permanent) {
        alpha = phd_divide(phd_two_product(0.5 * t->L[2], t->I1), phd_make(t->I3, 0.0));
        beta = phd_negate(alpha);
    }
    m->first = phd_split(phd_scale(phd_multiply(alpha, inverse), t->rate_scale));
    m->second = phd_split(phd_scale(phd_multiply(beta, inverse), t->rate_scale));
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
    phd_top t;
    phd_turning o;
    phd_top_rates r;
    phd_lattice at;
    double argument_rate, carried, linear_a = 0.0, linear_b = 0.0, up, down;
    int k, still;
    if (error) return error;
    if (moments[0] != moments[1]) return POLHODE_BAD_MOMENTS;
    if (!isfinite(mgl)) return POLHODE_BAD_MGL;
    t = phd_reduced_top(moments, mgl, momentum, q);
    o = phd_turning_points(&t);
    r = phd_rates_of_top(&t, &o);
    at = phd_places(&t, &o, &r);
    still = at.full || r.separatrix;
    m->full = at.full;
    m->q = at.q;
    m->epoch = epoch;
    m->axial = momentum[2];
    m->reversed = t.reversed;
    m->turns_a = still ? 0.0 : at.y_alpha / PHD_PI.hi;
    m->turns_b = still ? 0.0 : at.y_beta / PHD_PI.hi;
    m->periodic = r.separatrix ? 0.0 : 1.0;
    m->sign_a = r.permanent ? 1.0 : r.sign_alpha;
    m->sign_b = r.permanent ? 1.0 : r.sign_beta;
    phd_top_phase_rates(m, &t, &r);
    phd_top_argument(m, &t, &r, &at);
    phd_top_series(m, &t, &o, &r, &at);
    argument_rate = r.permanent ? 0.0 : at.full ? r.nutation.hi : r.half_root.hi / (at.theta3 * at.theta3);
    if (!r.permanent) { /* derivatives by tau of the phases that evaluation adds to A and B, spin aside */
        carried = still ? 0.0 : r.nutation.hi * (2.0 / PHD_PI.hi);
        linear_a = r.alpha.hi + (still ? 0.0 : r.sign_alpha * at.y_alpha * carried);
        linear_b = r.beta.hi + (still ? 0.0 : r.sign_beta * at.y_beta * carried);
    }
    m->by_argument = 2.0 * argument_rate * t.momentum_scale;
    m->by_phase = 2.0 * (linear_a + linear_b) * t.momentum_scale;
    phd_top_phases(m, &t, linear_a, linear_b, argument_rate);
    phd_top_numbers(m, &t, &o, &r);
    m->fastest = 0.0;
    m->energy = 0.0;
    for (k = 0; k < 3; k++) {
        m->fastest = fmax(m->fastest, fabs(momentum[k] / moments[k]));
        m->energy += 0.5 * (momentum[k] / moments[k] * momentum[k]);
    }
    m->fastest += sqrt(fabs(mgl) / moments[0]);
    up = q[0] * q[0] + q[3] * q[3];
    down = q[1] * q[1] + q[2] * q[2];
    m->energy += mgl * (up - down) / (up + down);
    return isfinite(m->fastest) && isfinite(m->first.lower) && isfinite(m->second.lower) && isfinite(m->third.lower)
            && isfinite(m->start.hi) && isfinite(m->by_argument) && isfinite(m->by_phase) && phd_are_finite(m->phase, 4)
         ? POLHODE_OK : POLHODE_OUT_OF_RANGE;
}

/* Gives attitude (w, x, y, z) and momentum (body axes) at a time [s]. Returns 0 or an error code. */
static inline int polhode_top_state(const polhode_top *m, double t, double attitude[4], double momentum[3])
{
    const phd_time since = phd_since(t, m->epoch);
    const double *c = m->phase;
    phd_numerators v;
    phd_wave a, b;
    double x, root, ca, sa, cb, sb, ar, ai, br, bi, gain_r, gain_i, wr, wi, cw, sw;
    if (!(fabs(since.high) * m->fastest <= 1e27)) return POLHODE_BAD_TIME;
    v = phd_top_numerators(m, since);
    a = phd_sine_cosine(v.turns_a);
    b = phd_sine_cosine(v.turns_b);
    x = 1.0 / ((v.ar * v.ar + v.ai * v.ai) + (v.br * v.br + v.bi * v.bi));
    root = sqrt(x);
    ca = a.cosine * c[0] - a.sine * c[1];
    sa = a.sine * c[0] + a.cosine * c[1];
    cb = b.cosine * c[2] - b.sine * c[3];
    sb = b.sine * c[2] + b.cosine * c[3];
    ar = (v.ar * ca - v.ai * sa) * root;
    ai = (v.ar * sa + v.ai * ca) * root;
    br = (v.br * cb - v.bi * sb) * root;
    bi = (v.br * sb + v.bi * cb) * root;
    gain_r = (v.ar * v.dbr + v.ai * v.dbi) - (v.br * v.dar + v.bi * v.dai);
    gain_i = (v.ar * v.dbi - v.ai * v.dbr) - (v.bi * v.dar - v.br * v.dai);
    wr = (m->by_argument * gain_r + m->by_phase * (v.ai * v.br - v.ar * v.bi)) * x;
    wi = (m->by_argument * gain_i + m->by_phase * (v.ar * v.br + v.ai * v.bi)) * x;
    cw = cb * ca + sb * sa;
    sw = sb * ca - cb * sa;
    attitude[0] = m->reversed < 0.0 ? br : ar;
    attitude[1] = m->reversed < 0.0 ? -ar : br;
    attitude[2] = m->reversed < 0.0 ? -ai : bi;
    attitude[3] = m->reversed < 0.0 ? bi : ai;
    momentum[0] = wr * cw - wi * sw;
    momentum[1] = m->reversed * (wr * sw + wi * cw);
    momentum[2] = m->axial;
    return POLHODE_OK;
}

#endif
