// SPDX-License-Identifier: MIT
// Printed from src/polhode/exact by `python -m printing` in reference/: change the formulas, and print again.
// names are those of Python, and a formula may leave something unused
#![allow(dead_code, non_snake_case, unused_imports, unused_variables)]

use crate::words::*;

type Pair = (f64, f64);
type Three = (f64, f64, f64);
type FivePairs = (Pair, Pair, Pair, Pair, Pair);
type TwoPairs = (Pair, Pair);

// 1.5 · 2⁵²: added and taken away again, it leaves the nearest whole number
pub const ROUNDING: f64 = 6755399441055744.0;
// 2²⁷ + 1
pub const SPLITTING: f64 = 134217729.0;
// of the power series of sin 2πx and cos 2πx
pub const S0: f64 = 6.283185307179586;
pub const S1: f64 = -41.341702240399755;
pub const S2: f64 = 81.60524927607504;
pub const S3: f64 = -76.70585975306136;
pub const S4: f64 = 42.058693944897634;
pub const S5: f64 = -15.094642576822984;
pub const S6: f64 = 3.8199525848482803;
pub const S7: f64 = -0.7181223017785001;
pub const S8: f64 = 0.10422916220813978;
pub const C0: f64 = 1.0;
pub const C1: f64 = -19.739208802178716;
pub const C2: f64 = 64.93939402266828;
pub const C3: f64 = -85.45681720669371;
pub const C4: f64 = 60.24464137187664;
pub const C5: f64 = -26.426256783374388;
pub const C6: f64 = 7.903536371318465;
pub const C7: f64 = -1.7143907110886711;
pub const C8: f64 = 0.282005968455791;
pub const C9: f64 = -0.03638284114254564;
/// Return the product and its exact error, as long as that does not underflow [Dekker–Veltkamp].
pub fn two_product(a: f64, b: f64) -> Pair {
    let p = a * b;
    let t = SPLITTING * a;
    let u = SPLITTING * b;
    let ah = t - (t - a);
    let bh = u - (u - b);
    let al = a - ah;
    let bl = b - bh;
    (p, ah * bh - p + ah * bl + al * bh + al * bl)
}

pub fn whole(x: f64) -> f64 {
    x + ROUNDING - ROUNDING
}

/// Return sin 2πx and cos 2πx, |x| ≤ ½.
pub fn sine_cosine(x: f64) -> Pair {
    let quarter = whole(4.0 * x);
    let r = x - 0.25 * quarter;
    let z = r * r;
    let s = r * (S0 + z * (S1 + z * (S2 + z * (S3 + z * (S4 + z * (S5 + z * (S6 + z * (S7 + z * S8))))))));
    let c = C0 + z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * (C6 + z * (C7 + z * (C8 + z * C9))))))));
    let n = quarter - 4.0 * (0.25 * quarter).floor();
    let odd = n == 1.0 || n == 3.0;
    let (a, b) = if odd { (c, s) } else { (s, c) };
    (if n >= 2.0 { -a } else { a }, if n == 1.0 || n == 2.0 { -b } else { b })
}

pub fn halves(x: f64) -> Pair {
    let t = SPLITTING * x;
    let high = t - (t - x);
    (high, x - high)
}

pub fn two_sum(a: f64, b: f64) -> Pair {
    let s = a + b;
    let t = s - a;
    (s, a - (s - t) + (b - t))
}

/// Return circular.reduced_phase.
pub fn phase(rate: Three, time: Three) -> Three {
    let (upper, lower, least) = rate;
    let (high, low, rest) = time;
    let a = upper * high;
    let b = upper * low;
    let c = lower * high;
    let na = whole(a);
    let nb = whole(b);
    let nc = whole(c);
    let d = lower * low + least * (high + low) + (upper + lower) * rest;
    let (middle, middle_error) = two_sum(b - nb, c - nc);
    let (fraction, error) = two_sum(a - na, middle);
    let more = whole(fraction);
    (fraction - more, error + (middle_error + d), na + (nb + nc) + more)
}

pub fn two_square(a: f64) -> Pair {
    two_product(a, a)
}

pub fn fast_two_sum(a: f64, b: f64) -> Pair {
    let s = a + b;
    (s, b - (s - a))
}

pub fn add(x: Pair, y: Pair) -> Pair {
    let (s, e) = two_sum(x.0, y.0);
    fast_two_sum(s, e + (x.1 + y.1))
}

pub fn subtract(x: Pair, y: Pair) -> Pair {
    add(x, (-y.0, -y.1))
}

pub fn multiply(x: Pair, y: Pair) -> Pair {
    let (p, e) = two_product(x.0, y.0);
    fast_two_sum(p, e + (x.0 * y.1 + x.1 * y.0))
}

pub fn multiply_float(x: Pair, factor: f64) -> Pair {
    let (p, e) = two_product(x.0, factor);
    fast_two_sum(p, e + x.1 * factor)
}

pub fn square(x: Pair) -> Pair {
    let (p, e) = two_product(x.0, x.0);
    fast_two_sum(p, e + 2.0 * x.0 * x.1)
}

pub fn scale(x: Pair, power_of_two: f64) -> Pair {
    (x.0 * power_of_two, x.1 * power_of_two)
}

pub fn divide(x: Pair, y: Pair) -> Pair {
    let q = x.0 / y.0;
    let (p, e) = two_product(q, y.0);
    let r = x.0 - p - e + (x.1 - q * y.1);
    fast_two_sum(q, r / y.0)
}

/// Return √x of a positive number.
pub fn root(x: Pair) -> Pair {
    let s = x.0.sqrt();
    let (p, e) = two_product(s, s);
    fast_two_sum(s, (x.0 - p - e + x.1) / (s + s))
}

/// Return √x, zero for x = 0.
pub fn root_or_zero(x: Pair) -> Pair {
    let zero = x.0 == 0.0;
    if zero { (0.0, 0.0) } else { root(if zero { (1.0, 0.0) } else { x }) }
}

pub const PI: Pair = (3.141592653589793, 1.2246467991473532e-16);
pub const INVERSE_TWO_PI: Pair = (0.15915494309189535, -9.839338337591243e-18);
pub const LN2: Pair = (0.6931471805599453, 2.3190468138462996e-17);
// the closing formulas of the mean leave an error of the fourth power
pub const CONVERGED: f64 = 2e-08;
pub const MOST_STEPS: i32 = 20;
// steps of all, before the first is looked at
pub const AT_ONCE: i32 = 3;
/// Return the leading part of −(x + rest)(upper + lower), which is exact, and the factor for the rest.
pub fn exponent(x: f64, rest: f64, upper: f64, lower: f64) -> Pair {
    // −(x + rest)(upper + lower) = −high · upper − small, and e^(−small) to second order
    let (high, low) = halves(x);
    let small = high * lower + low * (upper + lower) + rest * upper;
    (-(high * upper), 1.0 - small * (1.0 - 0.5 * small))
}

/// Return an argument in half periods as a number within ±½ and its rest, and the half periods taken out.
///
/// On the separatrix, where periodic is zero, it runs to infinity and none is taken out.
pub fn reduced_argument(rate: Three, start: Pair, periodic: f64, time: Three) -> Three {
    let (fraction, rest, turned) = phase(rate, time);
    let (total, first_error) = two_sum((1.0 - periodic) * turned, fraction);
    let (u, second_error) = two_sum(total, start.0);
    let (u, u_rest) = fast_two_sum(u, rest + (start.1 + (first_error + second_error)));
    let more = periodic * nearest(u);
    (u - more, u_rest, periodic * turned + more)
}

/// Return elliptic.nome_per_parameter.
pub fn nome_per_parameter(parameter: f64, k: f64) -> f64 {
    let more = 1.0 + k.sqrt();
    let ratio = 0.5 / ((1.0 + k) * more * more);
    let e = ratio * parameter;
    let e4 = e * e * (e * e);
    ratio * (1.0 + e4 * (2.0 + e4 * (15.0 + e4 * (150.0 + e4 * 1707.0))))
}

/// Return a period over θ3², of which 1/θ3² is 1 less a small correction.
pub fn by_theta(period: Pair, nome: f64) -> Pair {
    let q4 = nome * nome * (nome * nome);
    let e = 2.0 * (nome + q4 + q4 * q4 * nome);
    add(period, (-period.0 * (e * (2.0 + e) / ((1.0 + e) * (1.0 + e))), 0.0))
}

/// Take a step of the arithmetic–geometric mean and its third-kind sum, in double-double.
///
/// With ε = (p²−ag)/(p²+ag), Q ← Qε/2 and p ← (p²+ag)/2p; the sum is of all Q, from Q = 1. Arithmetic and square roots
/// alone give complete elliptic integrals of the first and third kind, so that the rates of exact motion carry thirty
/// digits and their phases stay right for any time. Source: Carlson, SIAM J. Math. Anal. 8 (1977) 231.
pub fn mean_step(a: Pair, g: Pair, pp: Pair, q: Pair, total: Pair) -> FivePairs {
    let ag = multiply(a, g);
    let both = add(pp, ag);
    let q = scale(multiply(q, divide(subtract(pp, ag), both)), 0.5);
    (scale(add(a, g), 0.5), root(ag), scale(divide(square(both), pp), 0.25), q, add(total, q))
}

/// Return x = (a−g)/(a+g), ε and (a+g)/2; ag is taken as ((a+g)/2)² − ((a−g)/2)², which does not cancel in ε.
pub fn mean_distance(a: Pair, g: Pair, pp: Pair) -> (f64, f64, Pair) {
    let middle = scale(add(a, g), 0.5);
    let half = 0.5 * (a.0 - g.0 + (a.1 - g.1));
    let d = subtract(pp, square(middle));
    let e = d.0 + d.1 + half * half;
    (half / middle.0, e / (2.0 * middle.0 * middle.0 + e), middle)
}

/// Return the mean and the sum of what mean_distance returns, exact where that is below CONVERGED.
pub fn mean_closed(x: f64, e: f64, middle: Pair, q: f64, total: Pair) -> TwoPairs {
    let last = 0.5 * q * e;
    let rest = last + last * (0.25 * (e * e - 0.5 * x * x));
    // agm(1 + x, 1 − x) = 1 − x²/4 + O(x⁴)
    (add(middle, (-0.25 * middle.0 * x * x, 0.0)), add(total, (rest, 0.0)))
}

/// Return where the mean of positive a and g begins, with the sum that starts from p², and the exponent taken out.
///
/// Rates go down to 1e-150, whose fourth powers would underflow. Scaled down, a tiny g would.
pub fn mean_start(a: Pair, g: Pair, pp: Pair) -> (FivePairs, f64) {
    let power = smaller(binary_exponent(a.0), 0.0 * a.0);
    let up = times_power(1.0, -power);
    let one = (1.0, 0.0);
    ((scale(a, up), scale(g, up), scale(scale(pp, up), up), one, one), power)
}

/// Return the mean after a step.
pub fn mean_next(state: FivePairs) -> FivePairs {
    let (a, g, pp, q, total) = state;
    mean_step(a, g, pp, q, total)
}

/// Return whether the closing formulas are exact.
pub fn mean_converged(state: FivePairs) -> bool {
    let (x, e, _) = mean_distance(state.0, state.1, state.2);
    x.abs() < CONVERGED && e.abs() < CONVERGED
}

/// Return mean and sum, of which the first lacks the exponent taken out.
pub fn mean_end(state: FivePairs) -> TwoPairs {
    let (x, e, middle) = mean_distance(state.0, state.1, state.2);
    mean_closed(x, e, middle, state.3.0, state.4)
}

/// Return agm(a, g) of positive numbers, and the sum that starts from p² = pp.
pub fn third_kind_mean(a: Pair, g: Pair, pp: Pair) -> TwoPairs {
    let (state, power) = mean_start(a, g, pp);
    let mut running = state;
    for k in 0..MOST_STEPS {
        if k >= AT_ONCE && mean_converged(running) {
            break;
        }
        running = mean_next(running);
    }
    let (mean, total) = mean_end(running);
    (scale(mean, times_power(1.0, power)), total)
}
