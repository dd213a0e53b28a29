// SPDX-License-Identifier: MIT
// Printed from src/polhode/exact by `python -m printing` in reference/: change the formulas, and print again.
// names are those of Python, and a formula may leave something unused
#![allow(dead_code, non_snake_case, unused_imports, unused_variables)]

use crate::both;
use crate::words::*;

type Pair = (f64, f64);
type Three = (f64, f64, f64);
type Four = (f64, f64, f64, f64);
type Six = (f64, f64, f64, f64, f64, f64);
type Ten = (f64, f64, f64, f64, f64, f64, f64, f64, f64, f64);
type Seven = (f64, f64, f64, f64, f64, f64, f64);
type ThreePairs = (Pair, Pair, Pair);
type TwoPairs = (Pair, Pair);
type NinePairs = (Pair, Pair, Pair, Pair, Pair, Pair, Pair, Pair, Pair);
type TwoFours = (Four, Four);

// binary exponents: of a displacement that is scaled up, and of what it becomes
pub const TINY: f64 = -200.0;
pub const LIFTED: f64 = -150.0;
pub const ONE: Pair = (1.0, 0.0);
pub const ZERO: Pair = (0.0, 0.0);
/// A top with mgl ≥ 0 and without powers of two.
#[derive(Clone, Copy)]
pub struct Scaled {
    /// I1, I3
    pub moments: Pair,
    pub momentum: Three,
    pub quaternion: Four,
    /// whether the axis was reversed
    pub reversed: bool,
    /// binary exponent of the displacement's scale, 0 for most tops
    pub lift: f64,
    /// binary, taken out of the momentum
    pub exponent: f64,
    /// powers of two taken out
    pub momentum_scale: f64,
    pub rate_scale: f64,
    pub G: Pair,
}

/// A top with mgl ≥ 0, scaled by powers of two; pairs are double-double.
///
/// u = cos θ, s = 1 − u, t = 1 + u, index 0 at the epoch; dots are derivatives by τ.
#[derive(Clone, Copy)]
pub struct Reduction {
    /// I1, I3
    pub moments: Pair,
    /// with the displacement scaled up by 2^lift
    pub momentum: Three,
    /// not normalised; likewise
    pub quaternion: Four,
    /// whether the axis was reversed
    pub reversed: bool,
    /// binary exponent of the displacement's scale, 0 for most tops
    pub lift: f64,
    /// powers of two taken out
    pub momentum_scale: f64,
    pub rate_scale: f64,
    /// |q|² as given
    pub size: Pair,
    pub G: Pair,
    pub s0: Pair,
    pub t0: Pair,
    pub u0: Pair,
    /// u̇ at the epoch
    pub p: Pair,
    /// p_φ − L3
    pub c: Pair,
    /// p_φ + L3
    pub c_plus: Pair,
    /// p_φ − u L3 at the epoch
    pub twist: Pair,
    /// |w|² − G s − a c
    pub F: Pair,
    /// 2G − a² − |w|² + G s
    pub D: Pair,
    /// |w|² at the epoch
    pub w2: Pair,
    /// a (|w|² − G s) − G c: its sign against a's tells loops from waves
    pub lean: Pair,
}

/// Return whether the axis points up rather than down at the epoch.
pub fn is_upright(top: &Reduction) -> bool {
    top.s0.0 < top.t0.0
}

/// Return whether the displacement was scaled up and grows.
pub fn leaves(top: &Reduction) -> bool {
    top.lift > 0.0 && is_upright(top) && top.D.0 > 0.0
}

pub fn _largest(x: f64, y: f64) -> f64 {
    larger(x.abs(), y.abs())
}

/// Turn a top whose centre of mass lies below, and take out powers of two.
pub fn scaled(moments: Three, mgl: f64, momentum: Three, attitude: Four) -> Scaled {
    let turned = mgl < 0.0;
    let side = if turned { -1.0 } else { 1.0 };
    let weight = mgl.abs();
    let (w, x, y, z) = attitude;
    let (i1, _, i3) = moments;
    let (l1, l2, l3) = momentum;
    let largest = larger(_largest(l1, l2), l3.abs());
    let of_moment = binary_exponent(i1);
    let of_momentum = binary_exponent(largest);
    // the larger of |L| and √(mgl I1), without forming a product that may overflow
    let half = (0.5 * (of_moment + binary_exponent(weight) + 1.0)).floor();
    let of_both = if largest > 0.0 { larger(of_momentum, half) } else { half };
    let exponent = if weight > 0.0 { of_both } else { of_momentum };
    let i1 = times_power(i1, -of_moment);
    let weight = times_power(times_power(weight, of_moment - exponent), -exponent);
    // a half turn about the first body axis: q → q i
    Scaled {
        moments: (i1, times_power(i3, -of_moment)),
        momentum: (times_power(l1, -exponent), times_power(side * l2, -exponent), times_power(side * l3, -exponent)),
        quaternion: (
            if turned { -x } else { w },
            if turned { w } else { x },
            if turned { z } else { y },
            if turned { -y } else { z },
        ),
        reversed: turned,
        lift: 0.0 * weight,
        exponent,
        momentum_scale: times_power(1.0, exponent),
        rate_scale: times_power(1.0, exponent - of_moment),
        G: both::scale(both::two_product(weight, i1), 2.0),
    }
}

/// Scale a tiny displacement up; the momentum is the given one, which keeps digits that scaling down has lost.
///
/// Exactly at the threshold of sleeping, 2G = a², where it grows like t and not like e^t, it is dropped: nothing is to
/// show within 1e27 radians, the longest time for which a motion is given.
pub fn lifted(top: &Scaled, momentum: Three) -> Scaled {
    let (w, x, y, z) = top.quaternion;
    let (l1, l2, l3) = top.momentum;
    let cosine = _largest(w, z);
    let sine = _largest(x, y);
    let below = cosine < sine;
    let displacement = larger(smaller(cosine, sine), _largest(l1, l2));
    let exponent = binary_exponent(displacement);
    let double = both::scale(top.G, 2.0);
    let square = both::two_product(l3, l3);
    let threshold = double.0 == square.0 && double.1 == square.1 && !below;
    let tiny = displacement > 0.0 && exponent < TINY && top.G.0 > 0.0;
    let lift = if tiny && !threshold { LIFTED - exponent } else { 0.0 };
    let kept = if tiny && threshold { 0.0 } else { 1.0 };
    let above = if below { 0.0 } else { lift };
    let under = if below { lift } else { 0.0 };
    let side = if top.reversed { -1.0 } else { 1.0 };
    let power = lift - top.exponent;
    Scaled {
        moments: top.moments,
        momentum: (kept * times_power(momentum.0, power), kept * times_power(side * momentum.1, power), l3),
        quaternion: (
            times_power(w, under),
            kept * times_power(x, above),
            kept * times_power(y, above),
            times_power(z, under),
        ),
        reversed: top.reversed,
        lift,
        exponent: top.exponent,
        momentum_scale: top.momentum_scale,
        rate_scale: top.rate_scale,
        G: top.G,
    }
}

/// Return the reduction of invariants times |q|²; s and t are half of them, and in_phase is −p/2.
pub fn _over_size(
    top: &Scaled,
    size: Pair,
    s: Pair,
    t: Pair,
    u: Pair,
    in_phase: Pair,
    c: Pair,
    c_plus: Pair,
    twist: Pair,
    f: Pair,
    d: Pair,
    w2: Pair,
    lean: Pair,
) -> Reduction {
    Reduction {
        moments: top.moments,
        momentum: top.momentum,
        quaternion: top.quaternion,
        reversed: top.reversed,
        lift: top.lift,
        momentum_scale: top.momentum_scale,
        rate_scale: top.rate_scale,
        size,
        G: top.G,
        s0: both::scale(both::divide(s, size), 2.0),
        t0: both::scale(both::divide(t, size), 2.0),
        u0: both::divide(u, size),
        p: both::scale(both::divide(in_phase, size), -2.0),
        c: both::divide(c, size),
        c_plus: both::divide(c_plus, size),
        twist: both::divide(twist, size),
        F: both::divide(f, size),
        D: both::divide(d, size),
        w2,
        lean: both::divide(lean, size),
    }
}

/// Return ab + cd.
pub fn _products(a: f64, b: f64, c: f64, d: f64) -> Sum {
    join(as_sum(both::two_product(a, b)), as_sum(both::two_product(c, d)))
}

pub fn _times_pair(x: Sum, y: Pair) -> Sum {
    join(multiply_terms(x, y.0), multiply_terms(x, y.1))
}

/// Return |q|²: as a pair it would leave F of a planar top only 32 digits of what cancels.
pub fn size_of(top: &Scaled) -> Sum {
    let (w, x, y, z) = top.quaternion;
    compress(join(_products(x, x, y, y), _products(w, w, z, z)), 4)
}

/// Return the reduction of a top; its invariants are polynomials of the given floats over |q|², which is size.
///
/// The polynomials are summed exactly, since near the separatrix c, F and D vanish together and what is left of them
/// decides how long the top lingers upright; double-double alone would leave nothing.
pub fn exactly_reduced(top: &Scaled, size: Sum) -> Reduction {
    let (l1, l2, l3) = top.momentum;
    let (w, x, y, z) = top.quaternion;
    let s = _products(x, x, y, y);
    let t = _products(w, w, z, z);
    // of β̄α
    let real = _products(x, w, y, z);
    let imaginary = _products(x, z, -y, w);
    // of β̄αw
    let in_phase = compress(join(multiply_terms(real, l1), multiply_terms(imaginary, -l2)), 4);
    let twist = compress(join(multiply_terms(real, 2.0 * l2), multiply_terms(imaginary, 2.0 * l1)), 4);
    let c = compress(join(twist, multiply_terms(s, -2.0 * l3)), 4);
    let c_plus = compress(join(twist, multiply_terms(t, 2.0 * l3)), 4);
    let kinetic = join(_times_pair(size, both::two_product(l1, l1)), _times_pair(size, both::two_product(l2, l2)));
    let fall = as_sum(both::scale(top.G, -2.0));
    let fall = join(_times_pair(fall, both::two_product(x, x)), _times_pair(fall, both::two_product(y, y)));
    let energy = compress(join(kinetic, fall), 5);
    let f = compress(join(energy, multiply_terms(c, -l3)), 5);
    let rest = join(_times_pair(size, both::scale(top.G, 2.0)), _times_pair(size, both::two_product(l3, -l3)));
    let d = compress(join(rest, negated(energy)), 5);
    let lean = compress(join(multiply_terms(energy, l3), _times_pair(c, both::scale(top.G, -1.0))), 6);
    _over_size(
        top,
        distil(size),
        distil(s),
        distil(t),
        distil(join(t, negated(s))),
        distil(in_phase),
        distil(c),
        distil(c_plus),
        distil(twist),
        distil(f),
        distil(d),
        distil(_products(l1, l1, l2, l2)),
        distil(lean),
    )
}

/// Return the reduction of a top, at any scale and however near the vertical.
pub fn reduction(moments: Three, mgl: f64, momentum: Three, attitude: Four) -> Reduction {
    let top = scaled(moments, mgl, momentum, attitude);
    exactly_reduced(&lifted(&top, momentum), size_of(&top))
}

/// All that evaluation needs of a top: numbers, or arrays with one for each of many.
///
/// Each series has four terms: q^16 is below 1e-21.
#[derive(Clone, Copy)]
pub struct Motion {
    /// whether it takes the full form
    pub full: f64,
    /// of the phase of α [turns per time]
    pub first: Three,
    /// of the phase of β
    pub second: Three,
    /// full: of z/2π; complementary: of x/2K
    pub third: Three,
    /// the same at the epoch, double-double
    pub start: Pair,
    /// full: sums of the terms e^{±ikz} in A; complementary: their factors of sin ky, k = 1, 3, 5, 7
    pub a_sum: Four,
    /// full: differences; complementary: factors of cos ky
    pub a_gap: Four,
    /// full: as of A; complementary: factors of cos ky, k = 2, 4, 6, 8
    pub b_sum: Four,
    /// full: as of A; complementary: factors of sin ky
    pub b_gap: Four,
    /// complementary: the constant term of B
    pub constant: f64,
    /// complementary: q, πK/K' in halves, y_a/π, y_b/π, whether periodic
    pub nome: Six,
    /// of c' and c
    pub signs: Pair,
    /// of w: twice dz/dt or dx'/dt, twice the sum of the linear rates [momentum]
    pub rates: Pair,
    /// cos, sin of the constant phases of α and β
    pub phases: Four,
    /// L3
    pub axial: f64,
    /// −1 where the axis was turned round
    pub reversed: f64,
}

/// Sum the products, smallest first.
pub fn _dot(x: Four, y: Four) -> f64 {
    let (a, b, c, d) = x;
    let (e, f, g, h) = y;
    d * h + c * g + b * f + a * e
}

/// Sum the products times 1, 3, 5 and 7, which a derivative brings.
pub fn _odd(x: Four, y: Four) -> f64 {
    let (a, b, c, d) = x;
    let (e, f, g, h) = y;
    d * (7.0 * h) + c * (5.0 * g) + b * (3.0 * f) + a * e
}

/// Sum the products times 2, 4, 6 and 8.
pub fn _even(x: Four, y: Four) -> f64 {
    let (a, b, c, d) = x;
    let (e, f, g, h) = y;
    d * (8.0 * h) + c * (6.0 * g) + b * (4.0 * f) + a * (2.0 * e)
}

pub fn _turns(rate: Three, time: Three) -> f64 {
    let (fraction, rest, _) = both::phase(rate, time);
    fraction + rest
}

/// Sum A, B and their derivatives by z.
pub fn full_sums(m: &Motion, time: Three) -> Ten {
    let (sa, sb) = m.signs;
    let (fraction, rest, _) = both::phase(m.third, time);
    let z = fraction + (rest + m.start.0);
    let (s1, c1) = both::sine_cosine(z - both::whole(z));
    let c = 1.0 - 2.0 * s1 * s1;
    let s = 2.0 * s1 * c1;
    let c3 = c1 * c - s1 * s;
    let s3 = s1 * c + c1 * s;
    let c5 = c3 * c - s3 * s;
    let s5 = s3 * c + c3 * s;
    let c7 = c5 * c - s5 * s;
    let s7 = s5 * c + c5 * s;
    let cosines = (c1, c3, c5, c7);
    let sines = (s1, s3, s5, s7);
    (
        _dot(m.a_sum, sines),
        -sa * _dot(m.a_gap, cosines),
        _dot(m.b_sum, cosines),
        sb * _dot(m.b_gap, sines),
        _odd(m.a_sum, cosines),
        sa * _odd(m.a_gap, sines),
        -_odd(m.b_sum, sines),
        sb * _odd(m.b_gap, cosines),
        _turns(m.first, time),
        _turns(m.second, time),
    )
}

/// Return side, both phases in turns, and exponent and factor of E and of R, which sum A and B.
pub fn complementary_phase(m: &Motion, time: Three) -> Seven {
    let (_, upper, lower, ya_turns, yb_turns, periodic) = m.nome;
    let (sa, sb) = m.signs;
    let (u, u_rest, count) = both::reduced_argument(m.third, m.start, periodic, time);
    let side = if u < 0.0 { -1.0 } else { 1.0 };
    let f = u * side;
    let g = u_rest * side;
    let (e, e_factor) = both::exponent(f, g, upper, lower);
    let distance = larger(0.5 - f, 0.0);
    let (r, r_factor) = both::exponent(distance, (0.5 - distance - f) * periodic - g, upper, lower);
    let half = 0.5 * (count - 2.0 * (0.5 * count).floor());
    let within = u + u_rest;
    let turns_a = _turns(m.first, time) + sa * within * ya_turns;
    let turns_b = _turns(m.second, time) + sb * within * yb_turns;
    let turns_a = turns_a - both::whole(turns_a) + half;
    let turns_b = turns_b - both::whole(turns_b) + half;
    (side, turns_a, turns_b, e, e_factor, r, periodic * r_factor)
}

/// Sum A, B and their derivatives by x' in the decaying powers of E = e^−|x'| and the growing ones of R = √q/E.
pub fn complementary_sums(m: &Motion, side: f64, turns_a: f64, turns_b: f64, e0: f64, R: f64) -> Ten {
    let q = m.nome.0;
    let (sa, sb) = m.signs;
    let h = e0 * e0;
    let r = R * R;
    let h2 = h * h;
    let h3 = h * h2;
    let h5 = h3 * h2;
    let h7 = h5 * h2;
    let q2 = q * q;
    let q3 = q2 * q;
    let w1 = q * r;
    let w2 = q2 * r;
    let w3 = q3 * r;
    let p1 = q * h;
    let p2 = q2 * h;
    let p3 = q3 * h;
    let p4 = q2 * q2 * h;
    let v2 = w2 * w2;
    let v3 = w3 * w3;
    let u1 = w1 * w1;
    let u2 = v2 * w2;
    let u3 = v3 * v3;
    let d2 = p2 * p2;
    let d3 = p3 * p3 * p3;
    let d4 = p4 * p4 * (p4 * p4);
    let v3 = v3 * w3;
    let sums = (1.0 + h, w1 * (1.0 + h3), v2 * (1.0 + h5), v3 * (1.0 + h7));
    let gaps = (1.0 - h, w1 * (1.0 - h3), v2 * (1.0 - h5), v3 * (1.0 - h7));
    let up = (r + p1, u1 + d2, u2 + d3, u3 + d4);
    let down = (r - p1, u1 - d2, u2 - d3, u3 - d4);
    let e = 2.0 * e0;
    (
        _dot(m.a_sum, sums),
        sa * side * _dot(m.a_gap, gaps),
        e * (m.constant + _dot(m.b_sum, up)),
        -sb * side * e * _dot(m.b_gap, down),
        side * _odd(m.a_sum, gaps),
        sa * _odd(m.a_gap, sums),
        side * e * _even(m.b_sum, down),
        -sb * e * _even(m.b_gap, up),
        turns_a,
        turns_b,
    )
}

/// Return attitude and momentum: α = A e^{iφ_a}, β = B e^{iφ_b} over their norm, and w.
pub fn state_of(m: &Motion, sums: Ten) -> Seven {
    let (ar, ai, br, bi, dar, dai, dbr, dbi, turns_a, turns_b) = sums;
    let (by_argument, by_phase) = m.rates;
    let (c0, s0, c1, s1) = m.phases;
    let x = 1.0 / (ar * ar + ai * ai + (br * br + bi * bi));
    let root = x.sqrt();
    let (s, c) = both::sine_cosine(turns_a - both::whole(turns_a));
    let ca = c * c0 - s * s0;
    let sa = s * c0 + c * s0;
    let (s, c) = both::sine_cosine(turns_b - both::whole(turns_b));
    let cb = c * c1 - s * s1;
    let sb = s * c1 + c * s1;
    let ar_t = (ar * ca - ai * sa) * root;
    let ai_t = (ar * sa + ai * ca) * root;
    let br_t = (br * cb - bi * sb) * root;
    let bi_t = (br * sb + bi * cb) * root;
    // ĀB' − BĀ' and i ĀB
    let gain_r = ar * dbr + ai * dbi - (br * dar + bi * dai);
    let gain_i = ar * dbi - ai * dbr - (bi * dar - br * dai);
    let turn_r = ai * br - ar * bi;
    let turn_i = ar * br + ai * bi;
    let wr = (by_argument * gain_r + by_phase * turn_r) * x;
    let wi = (by_argument * gain_i + by_phase * turn_i) * x;
    let cw = cb * ca + sb * sa;
    let sw = sb * ca - cb * sa;
    let side = m.reversed;
    let turned = side < 0.0;
    let (w, z) = if turned { (br_t, bi_t) } else { (ar_t, ai_t) };
    let (x, y) = if turned { (ar_t, ai_t) } else { (br_t, bi_t) };
    (w, side * x, side * y, z, wr * cw - wi * sw, side * (wr * sw + wi * cw), m.axial)
}

/// Return attitude and momentum of a motion at a time, given in two parts.
pub fn state_at(m: &Motion, time: f64, rest: f64) -> Seven {
    let (high, low) = both::halves(time);
    if m.full != 0.0 {
        return state_of(m, full_sums(m, (high, low, rest)));
    }
    let (a, b, c, exponent, factor, other, other_factor) = complementary_phase(m, (high, low, rest));
    let e0 = exponent.exp() * factor;
    let R = other.exp() * other_factor;
    state_of(m, complementary_sums(m, a, b, c, e0, R))
}

// binary exponent down to which a square has all its digits
pub const SQUARABLE: f64 = -400.0;
// of cos(⅓ acos x), 0 ≤ x ≤ 1, to 2e-4
pub const BEGIN: f64 = 0.8660254;
pub const SLOPE: f64 = 0.1642;
pub const CURVE: f64 = -0.0302;
// steps of Newton's, of all and of any: two do, three more where the start was poor
pub const AT_ONCE: i32 = 2;
pub const MOST: i32 = 5;
// of the last change over the root: what is left is smaller by a float64's precision
pub const CONVERGED: f64 = 8.673617379884035e-19;
/// Distances between the roots, the poles u = ±1 and the start u0, each as a number of its own.
#[derive(Clone, Copy)]
pub struct TurningPoints {
    /// u0 − u1
    pub from_lower: Pair,
    /// u2 − u0
    pub from_upper: Pair,
    /// u2 − u1
    pub d: Pair,
    /// 1 − u1
    pub s1: Pair,
    /// 1 − u2
    pub s2: Pair,
    /// 1 + u1
    pub t1: Pair,
    /// 1 + u2
    pub t2: Pair,
    /// G (u3 − u1)
    pub A: Pair,
    /// G (u3 − u2)
    pub B: Pair,
    /// G (u3 − u0)
    pub Y: Pair,
    /// G (u3 − 1)
    pub Z_minus: Pair,
    /// G (u3 + 1)
    pub Z_plus: Pair,
}

/// The cubic whose largest root stands apart from the others.
#[derive(Clone, Copy)]
pub struct Apart {
    /// whether it is that of Y, and the root u3, or that of s, and the root u1
    pub upper: bool,
    pub cubic: ThreePairs,
    /// near the root
    pub start: f64,
    pub f1: Pair,
}

/// Return f1, and the cubics x³ + bx² + cx + d of Y = G (u3 − u0) and of s = 1 − u1; inverse is 1/G.
pub fn cubics(
    axial: f64,
    g: Pair,
    inverse: Pair,
    s0: Pair,
    t0: Pair,
    u0: Pair,
    w2: Pair,
    twist: Pair,
    p2: Pair,
    c2: Pair,
    d: Pair,
    f: Pair,
) -> (Pair, ThreePairs, ThreePairs) {
    // with v = u − u0 and the |w|² of the start, u̇² = (1 − u²)(|w|² − G v) − (b − a u)² = p² + f1 v + f2 v² + G v³,
    // and with s = 1 − u it is −(G s³ − D s² − 2F s + c²)
    let f1 = both::subtract(
        both::scale(both::multiply_float(twist, axial), 2.0),
        both::multiply(g, both::multiply(s0, t0)),
    );
    let f1 = both::subtract(f1, both::scale(both::multiply(u0, w2), 2.0));
    let f2 = both::subtract(both::subtract(both::scale(both::multiply(g, u0), 2.0), w2), both::two_square(axial));
    let d = both::multiply(d, inverse);
    let f = both::multiply(f, inverse);
    (
        f1,
        (f2, both::multiply(g, f1), both::multiply(both::square(g), p2)),
        ((-d.0, -d.1), both::scale(f, -2.0), both::multiply(c2, inverse)),
    )
}

/// Return b/3, r and cos 3φ of a cubic with real roots, of which 2r cos φ − b/3 is the largest.
pub fn _by_angle(cubic: ThreePairs) -> Three {
    // x = 2r cos φ − b/3 with r = √(−P/3) and cos 3φ = −Q/2r³
    let b = cubic.0.0;
    let c = cubic.1.0;
    let d = cubic.2.0;
    let third = b / 3.0;
    let p = c - b * third;
    let q = 2.0 * (third * third) * third - third * c + d;
    let r = larger(-p / 3.0, 0.0 * p).sqrt();
    (third, r, if r > 0.0 { -0.5 * q / (if r > 0.0 { r * r * r } else { 1.0 }) } else { 1.0 })
}

/// Return the cubic whose largest root stands apart.
pub fn apart(top: &Reduction) -> Apart {
    let weightless = !(top.G.0 > 0.0);
    let one = ONE;
    let (f1, of_y, of_s) = cubics(
        top.momentum.2,
        top.G,
        both::divide(one, if weightless { one } else { top.G }),
        top.s0,
        top.t0,
        top.u0,
        top.w2,
        top.twist,
        both::square(top.p),
        both::square(top.c),
        top.D,
        top.F,
    );
    let (third, r, cosine) = _by_angle(of_y);
    let (other_third, other_r, other) = _by_angle(of_s);
    let upper = cosine >= 0.0 || weightless;
    let x = if upper { cosine } else { other };
    let x = smaller(larger(x, 0.0 * x), 1.0 + 0.0 * x);
    // cos φ is a root of 4 y³ − 3 y = x
    let y = BEGIN + x * (SLOPE + x * CURVE);
    let y = (8.0 * y * y * y + x) / (12.0 * y * y - 3.0);
    let y = (8.0 * y * y * y + x) / (12.0 * y * y - 3.0);
    let cubic = (
        if upper { of_y.0 } else { of_s.0 },
        if upper { of_y.1 } else { of_s.1 },
        if upper { of_y.2 } else { of_s.2 },
    );
    Apart {
        upper,
        cubic,
        start: 2.0 * (if upper { r } else { other_r }) * y - (if upper { third } else { other_third }),
        f1,
    }
}

/// Return the root before the first step.
pub fn begun(lone: &Apart) -> (Pair, f64, ThreePairs) {
    ((lone.start, 0.0 * lone.start), lone.start, lone.cubic)
}

/// Return a root after a step of Newton's, whose slope need not be sharp.
pub fn nearer(root: (Pair, f64, ThreePairs)) -> (Pair, f64, ThreePairs) {
    let (x, _, cubic) = root;
    let (b, c, d) = cubic;
    let value = both::add(both::multiply(both::add(both::multiply(both::add(x, b), x), c), x), d);
    let change = -value.0 / ((3.0 * x.0 + 2.0 * b.0) * x.0 + c.0);
    let change = if change - change == 0.0 { change } else { 0.0 };
    (both::add(x, (change, 0.0 * change)), change, cubic)
}

/// Return whether the last change leaves nothing to be changed.
pub fn is_found(root: (Pair, f64, ThreePairs)) -> bool {
    let (x, change, _) = root;
    x.0 > 0.0 && change.abs() <= CONVERGED * x.0
}

/// Return x / y, and zero for x = 0 whatever y.
pub fn quotient(x: Pair, y: Pair) -> Pair {
    let zero = x.0 == 0.0;
    if zero { x } else { both::divide(x, if zero { ONE } else { y }) }
}

/// Return x + y = √((x − y)² + 4 x y), also where the square underflows.
pub fn difference(total: Pair, product: Pair) -> Pair {
    let exponent = binary_exponent(total.0);
    let alone = product.0 == 0.0 || binary_exponent(product.0) < 2.0 * exponent;
    let power = if total.0 != 0.0 && exponent < SQUARABLE && alone { -exponent } else { 0.0 };
    let up = times_power(1.0, power);
    let raised = both::scale(both::scale(product, up), up);
    both::scale(
        both::root_or_zero(both::add(both::square(both::scale(total, up)), both::scale(raised, 4.0))),
        times_power(1.0, -power),
    )
}

/// Return x ≥ 0 and y ≥ 0 from x − y, x + y and x y.
pub fn _larger_and_smaller(total: Pair, sum_: Pair, product: Pair) -> TwoPairs {
    let positive = total.0 >= 0.0;
    let most = both::scale(both::add(sum_, if positive { total } else { (-total.0, -total.1) }), 0.5);
    let least = if most.0 > 0.0 { quotient(product, most) } else { ZERO };
    (if positive { most } else { least }, if positive { least } else { most })
}

/// From Y = G (u3 − u0): with v = u − u0, v1 + v2 = (f1 + G p²/Y)/Y and v1 v2 = −p²/Y.
pub fn _upper_root_apart(g: Pair, s0: Pair, p2: Pair, c2: Pair, f1: Pair, y: Pair) -> NinePairs {
    let product = quotient(p2, y);
    let total = quotient(both::add(f1, both::multiply(g, product)), y);
    let gap = difference(total, product);
    let (upper, lower) = _larger_and_smaller(total, gap, product);
    let s1 = both::add(s0, lower);
    let s2 = both::subtract(s0, upper);
    let z = both::subtract(y, both::multiply(g, s0));
    // s1 s2 Z = c²; of s2 and Z only the larger is an accurate difference
    let take = z.0 >= both::multiply(g, s2).0;
    let other = quotient(c2, both::multiply(s1, if take { z } else { s2 }));
    let s2 = if take { other } else { s2 };
    let z = if take { z } else { other };
    (
        lower,
        upper,
        gap,
        s1,
        s2,
        both::add(y, both::multiply(g, lower)),
        both::subtract(y, both::multiply(g, upper)),
        y,
        z,
    )
}

/// From s1 = 1 − u1: s2 + s3 = (c²/s1 − 2F)/(G s1) and s2 s3 = −c²/(G s1).
pub fn _lower_root_apart(g: Pair, s0: Pair, p2: Pair, c2: Pair, f: Pair, s1: Pair) -> NinePairs {
    let gs = both::multiply(g, s1);
    let product = quotient(c2, gs);
    let total = both::divide(both::add(both::scale(f, -2.0), quotient(c2, s1)), gs);
    let between = difference(total, product);
    let (s2, minus_s3) = _larger_and_smaller(total, between, product);
    let z = both::multiply(g, minus_s3);
    let y = both::add(both::multiply(g, s0), z);
    let upper = both::subtract(s0, s2);
    let lower = both::subtract(s1, s0);
    let take = upper.0 >= lower.0;
    let other = quotient(quotient(p2, y), if take { upper } else { lower });
    let upper = if take { upper } else { other };
    let lower = if take { other } else { lower };
    (
        lower,
        upper,
        both::subtract(s1, s2),
        s1,
        s2,
        both::multiply(g, both::add(s1, minus_s3)),
        both::multiply(g, between),
        y,
        z,
    )
}

/// Return the turning points from the separate root, Y or else s1.
pub fn turning_points_of(top: &Reduction, is_upper: bool, lone: Pair, f1: Pair) -> TurningPoints {
    let g = top.G;
    let s0 = top.s0;
    let t0 = top.t0;
    let p2 = both::square(top.p);
    let c2 = both::square(top.c);
    let x = _upper_root_apart(g, s0, p2, c2, f1, lone);
    let y = _lower_root_apart(if g.0 > 0.0 { g } else { ONE }, s0, p2, c2, top.F, lone);
    let upper = if is_upper { x.1 } else { y.1 };
    let above = if is_upper { x.7 } else { y.7 };
    let t2 = both::add(t0, upper);
    let z = both::add(above, both::multiply(g, t0));
    TurningPoints {
        from_lower: if is_upper { x.0 } else { y.0 },
        from_upper: upper,
        d: if is_upper { x.2 } else { y.2 },
        s1: if is_upper { x.3 } else { y.3 },
        s2: if is_upper { x.4 } else { y.4 },
        t1: quotient(both::square(top.c_plus), both::multiply(t2, z)),
        t2,
        A: if is_upper { x.5 } else { y.5 },
        B: if is_upper { x.6 } else { y.6 },
        Y: above,
        Z_minus: if is_upper { x.8 } else { y.8 },
        Z_plus: z,
    }
}

/// Return the turning points of a top.
pub fn turning_points(top: &Reduction) -> TurningPoints {
    let lone = apart(top);
    let mut running = begun(&lone);
    for k in 0..MOST {
        if k >= AT_ONCE && is_found(running) {
            break;
        }
        running = nearer(running);
    }
    let (root, _, _) = running;
    turning_points_of(top, lone.upper, root, lone.f1)
}

/// Rates by τ = t/I1 in scaled units; all but the signs and flags are double-double.
#[derive(Clone, Copy)]
pub struct Frequencies {
    /// W = ½√A: x = x0 + W τ
    pub half_root: Pair,
    /// ϖ = ½ agm(√A, √B) = πW/2K, zero on the separatrix
    pub nutation: Pair,
    /// linear rates of the phases of α and β apart from their theta quotients
    pub alpha: Pair,
    pub beta: Pair,
    /// sgn c' and sgn c, +1 for zero
    pub sign_alpha: f64,
    pub sign_beta: f64,
    /// ν I1, the spin that I3 ≠ I1 adds, by τ
    pub spin: Pair,
    /// the momentum stays: sleeping, hanging, rest
    pub permanent: bool,
    pub separatrix: bool,
    /// the tilt stays
    pub steady: bool,
}

/// What the means start from, and harmless numbers where there is no period.
#[derive(Clone, Copy)]
pub struct Starts {
    pub root_A: Pair,
    pub root_B: Pair,
    /// p² of the sums of α and β
    pub alpha: Pair,
    pub beta: Pair,
    pub permanent: bool,
    pub separatrix: bool,
}

/// Return p² at the start of the sum of α; first says that it takes the form that starts from Z.
pub fn start_of_alpha(first: bool, a: Pair, z_plus: Pair, t1: Pair, t2: Pair) -> Pair {
    if first { z_plus } else { both::divide(both::multiply(a, t2), if first { ONE } else { t1 }) }
}

/// Return p² of the sum of β. Where c = 0 the factor of the sum vanishes, and p² must only not be zero.
pub fn start_of_beta(first: bool, c: Pair, a: Pair, b: Pair, z_minus: Pair, s1: Pair, s2: Pair) -> Pair {
    let other = both::divide(both::multiply(s1, b), if first { ONE } else { s2 });
    if first { if c.0 == 0.0 { a } else { z_minus } } else { other }
}

/// Return cG/(4Z) Σ in the first form, |c|/(2 near) [1 − d/(2 far) Σ] − ϖ in the second.
pub fn drift(
    first: bool,
    c: Pair,
    g: Pair,
    z: Pair,
    near: Pair,
    far: Pair,
    d: Pair,
    nutation: Pair,
    total: Pair,
) -> Pair {
    let idle = c.0 == 0.0;
    let ratio = both::divide(
        if first { both::multiply(c, g) } else { c },
        if idle { ONE } else { if first { z } else { near } },
    );
    let share = both::subtract(ONE, both::scale(both::multiply(both::divide(d, far), total), 0.5));
    if first {
        both::scale(both::multiply(ratio, total), 0.25)
    } else {
        both::subtract(both::multiply(both::scale(ratio, 0.5), share), nutation)
    }
}

/// Return ν I1, the spin that I3 ≠ I1 adds, by τ.
pub fn spin(i1: f64, i3: f64, axial: f64) -> Pair {
    both::divide(both::multiply_float(both::two_sum(i1, -i3), axial), (i3, 0.0))
}

/// Return a rate by τ as turns per time.
pub fn turns_per_time(rate: Pair, i1: f64, rate_scale: f64) -> Pair {
    let inverse = both::divide(both::INVERSE_TWO_PI, (i1, 0.0));
    both::multiply(rate, both::scale(inverse, rate_scale))
}

/// Return the rate of x/2K [half periods per time].
pub fn half_periods(nutation: Pair, i1: f64, rate_scale: f64) -> Pair {
    both::divide(both::scale(nutation, rate_scale), both::multiply_float(both::PI, i1))
}

/// Return K and πK/K', of the nome of the smaller parameter.
pub fn periods(half_root: Pair, nutation: Pair, nome: f64) -> TwoPairs {
    let quarter = both::divide(both::scale(both::multiply(half_root, both::PI), 0.5), nutation);
    (quarter, both::by_theta(both::scale(quarter, 2.0), nome))
}

pub fn _first_alpha(points: &TurningPoints) -> bool {
    points.Z_plus.0 <= 2.0 * points.A.0
}

pub fn _first_beta(top: &Reduction, points: &TurningPoints) -> bool {
    both::multiply(top.G, points.s2).0 <= points.Z_minus.0
}

/// Return what the means start from.
pub fn starts_of(top: &Reduction, points: &TurningPoints) -> Starts {
    let a = top.momentum.2;
    let vertical = top.s0.0 == 0.0 || top.t0.0 == 0.0;
    let permanent = top.w2.0 == 0.0 && (vertical || (top.G.0 == 0.0 && a == 0.0));
    let separatrix = !(points.B.0 > 0.0) && !permanent;
    let idle = permanent || separatrix;
    let one = ONE;
    let alpha = start_of_alpha(_first_alpha(points), points.A, points.Z_plus, points.t1, points.t2);
    let first = _first_beta(top, points);
    let beta = start_of_beta(first, top.c, points.A, points.B, points.Z_minus, points.s1, points.s2);
    Starts {
        root_A: if idle { one } else { both::root_or_zero(points.A) },
        root_B: if idle { one } else { both::root_or_zero(points.B) },
        alpha: if idle { one } else { alpha },
        beta: if idle { one } else { beta },
        permanent,
        separatrix,
    }
}

/// Return the frequencies of a top as its displacement is scaled, of the mean and the third-kind sums.
pub fn frequencies_of(
    top: &Reduction,
    points: &TurningPoints,
    start: &Starts,
    mean: Pair,
    total_alpha: Pair,
    total_beta: Pair,
) -> Frequencies {
    let nutation = both::scale(mean, 0.5);
    let separatrix = start.separatrix;
    let sign_alpha = if top.c_plus.0 >= 0.0 { 1.0 } else { -1.0 };
    let sign_beta = if top.c.0 >= 0.0 { 1.0 } else { -1.0 };
    let c_plus = both::scale(top.c_plus, sign_alpha);
    let c = both::scale(top.c, sign_beta);
    let first = _first_beta(top, points);
    let alpha = drift(
        _first_alpha(points),
        c_plus,
        top.G,
        points.Z_plus,
        points.t1,
        points.t2,
        points.d,
        nutation,
        total_alpha,
    );
    let beta = drift(first, c, top.G, points.Z_minus, points.s2, points.s1, points.d, nutation, total_beta);
    let alpha = both::scale(if separatrix { both::scale(c_plus, 0.25) } else { alpha }, sign_alpha);
    let beta = both::scale(if separatrix { ZERO } else { beta }, if first { -sign_beta } else { sign_beta });
    let steady = !(points.d.0 > 0.0 || start.permanent || separatrix);
    Frequencies {
        half_root: both::scale(both::root_or_zero(points.A), 0.5),
        nutation: if separatrix { ZERO } else { nutation },
        alpha,
        beta,
        sign_alpha,
        sign_beta,
        spin: spin(top.moments.0, top.moments.1, top.momentum.2),
        permanent: start.permanent,
        separatrix,
        steady,
    }
}

/// Return the x = W τ after which the displacement of a top that leaves the vertical has the lifted one's size.
pub fn climb(top: &Reduction) -> Pair {
    both::multiply_float(both::LN2, if leaves(top) { top.lift } else { 0.0 })
}

/// Return the frequencies of tops that leave the vertical from those of the lifted ones.
///
/// The displacement grows and falls as e^{±x}, so K = πW/2ϖ is longer by climb. During it α turns by c'/4 and
/// β not at all, so the turns of a nutation that are beyond that stay unchanged and their mean rates shrink as ϖ does.
pub fn _lingering(top: &Reduction, rates: &Frequencies) -> Frequencies {
    let W = rates.half_root;
    let c_plus = both::scale(top.c_plus, 0.25);
    let one = ONE;
    let pi = both::PI;
    let lingers = leaves(top);
    // climb/K
    let longer = both::scale(both::divide(both::multiply(climb(top), rates.nutation), both::multiply(pi, W)), 2.0);
    let share = both::divide(one, both::add(one, longer));
    let alpha = both::add(c_plus, both::multiply(both::subtract(rates.alpha, c_plus), share));
    Frequencies {
        half_root: W,
        nutation: if lingers { both::multiply(rates.nutation, share) } else { rates.nutation },
        alpha: if lingers { alpha } else { rates.alpha },
        beta: if lingers { both::multiply(rates.beta, share) } else { rates.beta },
        sign_alpha: rates.sign_alpha,
        sign_beta: rates.sign_beta,
        spin: rates.spin,
        permanent: rates.permanent,
        separatrix: rates.separatrix,
        steady: rates.steady,
    }
}

/// Return the frequencies of a reduced top.
pub fn frequencies(top: &Reduction, points: &TurningPoints) -> Frequencies {
    let start = starts_of(top, points);
    let (mean, total_alpha) = both::third_kind_mean(start.root_A, start.root_B, start.alpha);
    let (_, total_beta) = both::third_kind_mean(start.root_A, start.root_B, start.beta);
    _lingering(top, &frequencies_of(top, points, &start, mean, total_alpha, total_beta))
}

/// Return the rates of the phases of α and β [turns per time], the spin that I3 ≠ I1 adds included.
pub fn phase_rates(top: &Reduction, rates: &Frequencies) -> TwoPairs {
    let half = both::scale(rates.spin, 0.5);
    let (i1, i3) = top.moments;
    let own = both::divide(both::two_product(0.5 * top.momentum.2, i1), (i3, 0.0));
    let alpha = if rates.permanent { own } else { both::add(rates.alpha, half) };
    let beta = if rates.permanent { (-own.0, -own.1) } else { both::subtract(rates.beta, half) };
    (turns_per_time(alpha, i1, top.rate_scale), turns_per_time(beta, i1, top.rate_scale))
}

pub const MOST_STEPS: i32 = 40;
// of the spread, whose eighth power is what the closing formula leaves
pub const CLOSE: f64 = 0.01;
pub const CLOSER: f64 = 0.002;
/// Elliptic integrals of the first kind.
#[derive(Clone, Copy)]
pub struct Integrals {
    /// distances of α's and β's poles from the real axis; infinite where the tilt stays
    pub v_alpha: f64,
    pub v_beta: f64,
    /// K' − v, of the full form
    pub w_alpha: f64,
    pub w_beta: f64,
    /// distance of the start from the lowest place
    pub x0: Pair,
}

/// Return what R_F is more than one over the root of the mean, of relative distances from it (DLMF 19.36.1).
pub fn _series(x: f64, y: f64) -> f64 {
    let z = -x - y;
    let second = x * y - z * z;
    let third = x * y * z;
    let higher = second * second * (1.0 / 24.0 - second * (5.0 / 208.0)) - second * third * (3.0 / 44.0);
    let higher = higher + third * (3.0 / 104.0 * third + 0.0625 * second * second);
    higher + third * (1.0 / 14.0) - 0.1 * second
}

/// Return the largest distance from the mean over it.
pub fn widest(x: f64, y: f64, z: f64) -> f64 {
    let mean = (x + y + z) / 3.0;
    larger(larger((mean - x).abs(), (mean - y).abs()), (mean - z).abs()) / mean
}

/// Return numbers of equal R_F, nearer to each other (DLMF §19.26(iii)).
pub fn duplicated(now: Three) -> Three {
    let (x, y, z) = now;
    let a = x.sqrt();
    let b = y.sqrt();
    let c = z.sqrt();
    let more = a * b + b * c + c * a;
    (0.25 * (x + more), 0.25 * (y + more), 0.25 * (z + more))
}

/// Return whether the closing formula has all digits of a float.
pub fn is_close(now: Three) -> bool {
    widest(now.0, now.1, now.2) <= CLOSE
}

/// Return R_F of numbers next to each other, NaN of others.
pub fn closed(now: Three) -> f64 {
    let (x, y, z) = now;
    let mean = (x + y + z) / 3.0;
    if is_close(now) { (1.0 + _series(1.0 - x / mean, 1.0 - y / mean)) / mean.sqrt() } else { f64::NAN }
}

/// Return duplicated in double-double.
pub fn duplicated_sharply(now: ThreePairs) -> ThreePairs {
    let (x, y, z) = now;
    let a = both::root_or_zero(x);
    let b = both::root_or_zero(y);
    let c = both::root(z);
    let more = both::add(both::multiply(a, both::add(b, c)), both::multiply(b, c));
    (
        both::scale(both::add(x, more), 0.25),
        both::scale(both::add(y, more), 0.25),
        both::scale(both::add(z, more), 0.25),
    )
}

/// Return whether the closing formula has the digits that a phase wants.
pub fn is_closer(now: ThreePairs) -> bool {
    widest(now.0.0, now.1.0, now.2.0) <= CLOSER
}

/// Return closed in double-double.
pub fn closed_sharply(now: ThreePairs) -> Pair {
    let (x, y, z) = now;
    let one = ONE;
    let mean = both::divide(both::add(both::add(x, y), z), (3.0, 0.0));
    let apart = _series(1.0 - both::divide(x, mean).0, 1.0 - both::divide(y, mean).0);
    if is_closer(now) {
        both::divide(both::add(one, (apart, 0.0 * apart)), both::root(mean))
    } else {
        (f64::NAN, f64::NAN)
    }
}

/// Return x, y and c of an integral √c R_F(x, y, 1), v of α.
pub fn pole_of_alpha(top: &Reduction, points: &TurningPoints) -> Three {
    let d = points.d.0;
    let t2 = points.t2.0;
    (d / t2, d * points.Z_plus.0 / (points.A.0 * t2), points.t1.0 / t2)
}

/// Return the like of v of β.
pub fn pole_of_beta(top: &Reduction, points: &TurningPoints) -> Three {
    let d = points.d.0;
    let s1 = points.s1.0;
    let b = points.B.0;
    (d * points.Z_minus.0 / (s1 * b), d / s1, points.s2.0 * points.A.0 / (s1 * b))
}

/// Return the like of K' − v of α.
pub fn rest_of_alpha(top: &Reduction, points: &TurningPoints) -> Three {
    let g = top.G.0;
    let z = points.Z_plus.0;
    (g * points.t1.0 / z, g * points.t2.0 / z, points.A.0 / z)
}

/// Return the like of K' − v of β.
pub fn rest_of_beta(top: &Reduction, points: &TurningPoints) -> Three {
    let g = top.G.0;
    let b = points.B.0;
    (g * points.s2.0 / b, g * points.s1.0 / points.A.0, points.Z_minus.0 / b)
}

/// Return the like of the start's distance from the lowest place, in double-double.
pub fn place_of_start(points: &TurningPoints) -> ThreePairs {
    (
        both::divide(points.from_upper, points.d),
        both::divide(points.Y, points.A),
        both::divide(points.from_lower, points.d),
    )
}

/// Return √c R_F(x, y, 1), or some number where there is none.
pub fn _integral(idle: bool, terms: Three) -> f64 {
    let (x, y, c) = terms;
    let total = x + y;
    let good = (if idle { 0.0 } else { total }) > 0.0;
    let good = good && total < f64::INFINITY;
    let start = (if good { x } else { 1.0 }, if good { y } else { 1.0 }, 1.0 + 0.0 * x);
    let mut running = start;
    for k in 0..MOST_STEPS {
        if is_close(running) {
            break;
        }
        running = duplicated(running);
    }
    c.sqrt() * closed(running)
}

pub fn _sharp_integral(idle: bool, terms: ThreePairs) -> Pair {
    let (x, y, c) = terms;
    let total = x.0 + y.0;
    let one = ONE;
    let good = (if idle { 0.0 } else { total }) > 0.0;
    let good = good && total < f64::INFINITY;
    let start = (if good { x } else { one }, if good { y } else { one }, one);
    let mut running = start;
    for k in 0..MOST_STEPS {
        if is_closer(running) {
            break;
        }
        running = duplicated_sharply(running);
    }
    both::multiply(both::root_or_zero(c), closed_sharply(running))
}

/// Return the integrals of a top.
pub fn integrals_of(top: &Reduction, points: &TurningPoints, rates: &Frequencies) -> Integrals {
    let idle = rates.permanent || rates.steady;
    let separatrix = rates.separatrix;
    let d = points.d.0;
    let v_alpha = _integral(idle, pole_of_alpha(top, points));
    let v_beta = _integral(idle, pole_of_beta(top, points));
    let v_alpha = if separatrix { points.t1.0.sqrt().atan2(d.sqrt()) } else { v_alpha };
    let v_beta = if separatrix || points.s2.0 == 0.0 { 0.0 } else { v_beta };
    // where the tilt stays the pole is infinitely far: only e^−y = 0 enters
    let still = if rates.steady { f64::INFINITY } else { 0.0 };
    let x0 = _sharp_integral(idle, place_of_start(points));
    Integrals {
        v_alpha: if idle { still } else { v_alpha },
        v_beta: if idle { still } else { v_beta },
        w_alpha: _integral(idle, rest_of_alpha(top, points)),
        w_beta: _integral(idle, rest_of_beta(top, points)),
        x0: if idle && d <= 0.0 { ZERO } else { x0 },
    }
}

/// What a top's motion is like; what is infinite is inf, what is undefined NaN.
#[derive(Clone, Copy)]
pub struct Numbers {
    /// 0 rest, 1 sleeping, 2 hanging, 3 steady, 4 free, 5 planar, 6 undulating, 7 cusp, 8 loop, 9 separatrix
    pub regime: f64,
    /// of the cosine of the tilt from the upward vertical
    pub lowest: f64,
    pub highest: f64,
    /// of the nutation; of a steady top that of its smallest nutations
    pub period: f64,
    /// azimuth gained by the axis in a period, unreduced
    pub precession_per_period: f64,
    /// the body's own turn in a period, unreduced
    pub spin_per_period: f64,
}

/// Return u from the smaller of 1 − u and 1 + u.
pub fn _cosine(s: Pair, t: Pair) -> f64 {
    let one = (1.0, 0.0);
    if s.0 < t.0 { both::subtract(one, s).0 } else { both::subtract(t, one).0 }
}

/// Signs of polynomials in the given floats decide; only the steady top needs the computed gap u2 − u1.
///
/// The azimuth is at rest where p_φ = a u; there |w|² = lean/a, which is positive inside the nutation's range.
pub fn _regime(top: &Reduction, rates: &Frequencies) -> f64 {
    let a = top.momentum.2;
    let c = top.c.0;
    let c_plus = top.c_plus.0;
    let lean = top.lean.0;
    let along = if a < 0.0 { -lean } else { lean };
    // the place p_φ/a is a tilt: −1 < p_φ/a < 1
    let within = c * a < 0.0 && c_plus * a > 0.0;
    let code = if within && along > 0.0 { 8.0 } else { 6.0 };
    let code = if within && along == 0.0 { 7.0 } else { code };
    let code = if a == 0.0 && c == 0.0 { 5.0 } else { code };
    let code = if rates.steady { 3.0 } else { code };
    let code = if rates.separatrix { 9.0 } else { code };
    let code = if rates.permanent { if top.s0.0 == 0.0 { 1.0 } else { 2.0 } } else { code };
    let code = if top.G.0 == 0.0 { 4.0 } else { code };
    if a == 0.0 && rates.permanent { 0.0 } else { code }
}

pub fn _by_kind(rates: &Frequencies, permanent: f64, separatrix: f64, periodic: f64) -> f64 {
    if rates.permanent { permanent } else { if rates.separatrix { separatrix } else { periodic } }
}

/// Return the numbers of a top.
pub fn numbers(top: &Reduction, points: &TurningPoints, rates: &Frequencies) -> Numbers {
    let lower = _cosine(points.s1, points.t1);
    let upper = _cosine(points.s2, points.t2);
    let lower = if rates.permanent { top.u0.0 } else { lower };
    let upper = if rates.permanent { top.u0.0 } else { upper };
    let pi = both::PI;
    // α = cos(θ/2) e^{i(φ + ψ)/2}, β = sin(θ/2) e^{i(φ − ψ)/2} up to a constant phase: φ = arg α + arg β,
    // ψ = arg α − arg β. In a period, π/ϖ by τ, each argument gains its linear part, and half a turn by its thetas
    let turn_alpha = both::add(both::divide(rates.alpha, rates.nutation), (rates.sign_alpha, 0.0 * rates.sign_alpha));
    let turn_beta = both::add(both::divide(rates.beta, rates.nutation), (rates.sign_beta, 0.0 * rates.sign_beta));
    let spin = both::divide(rates.spin, rates.nutation);
    let precession = both::multiply(pi, both::add(turn_alpha, turn_beta)).0;
    let own_turn = both::multiply(pi, both::add(both::subtract(turn_alpha, turn_beta), spin)).0;
    let period = both::divide(both::multiply_float(pi, top.moments.0), both::scale(rates.nutation, top.rate_scale)).0;
    // never −0
    let own_turn = (if top.reversed { -1.0 } else { 1.0 }) * own_turn + 0.0;
    Numbers {
        regime: _regime(top, rates),
        lowest: if top.reversed { -upper } else { lower },
        highest: if top.reversed { -lower } else { upper },
        period: _by_kind(rates, f64::NAN, f64::INFINITY, period),
        precession_per_period: _by_kind(rates, f64::NAN, f64::NAN, precession),
        spin_per_period: _by_kind(rates, f64::NAN, f64::NAN, own_turn),
    }
}

pub const NO_TERMS: Four = (0.0, 0.0, 0.0, 0.0);
/// The modulus and the places of start and poles in the lattice.
#[derive(Clone, Copy)]
pub struct Arguments {
    pub full: bool,
    /// nome of the smaller parameter
    pub q: f64,
    pub theta3: f64,
    /// imaginary distance of the poles, times π/2K (full) or π/2K'
    pub y_alpha: f64,
    pub y_beta: f64,
    /// full: the like of K' − v
    pub w_alpha: f64,
    pub w_beta: f64,
    pub x0: Pair,
}

/// A reduced top with all that its motion is made from.
#[derive(Clone, Copy)]
pub struct Given {
    pub top: Reduction,
    pub points: TurningPoints,
    pub rates: Frequencies,
    pub at: Arguments,
    /// L3 as given
    pub axial: f64,
}

/// What of a Motion depends on rates and places.
#[derive(Clone, Copy)]
pub struct Timing {
    /// its first to start
    pub rates: (Three, Three, Three, Pair),
    /// its nome to rates
    pub places: (Six, Pair, Pair),
    /// derivatives by τ of the phases of α and β that evaluation adds to A and B, spin aside
    pub linear: Pair,
    /// dz/dτ or dx'/dτ
    pub turn: f64,
}

/// Return whether the motion takes the full form, m ≤ ½, if it nutates.
pub fn is_full(top: &Reduction, points: &TurningPoints) -> bool {
    // m = (A − B)/A = G (u2 − u1)/A and 1 − m = B/A
    top.G.0 * points.d.0 <= points.B.0
}

/// Return modulus and places, of the integrals.
pub fn arguments(top: &Reduction, points: &TurningPoints, rates: &Frequencies, integrals: &Integrals) -> Arguments {
    let m = top.G.0 * points.d.0 / points.A.0;
    let m1 = if rates.separatrix { 0.0 } else { points.B.0 / points.A.0 };
    let full = rates.permanent || (is_full(top, points) && !rates.separatrix);
    let small = if rates.permanent { 0.0 } else { if full { m } else { m1 } };
    let q = small * both::nome_per_parameter(small, (1.0 - small).sqrt());
    let q4 = q * q * (q * q);
    let theta3 = 1.0 + 2.0 * (q + q4 + q4 * q4 * q);
    // π/2K of the smaller quarter period (DLMF 22.2.2)
    let by = 1.0 / (theta3 * theta3);
    let x0 = both::scale(both::add(integrals.x0, climb(top)), if top.p.0 >= 0.0 { 1.0 } else { -1.0 });
    Arguments {
        full,
        q,
        theta3,
        y_alpha: integrals.v_alpha * by,
        y_beta: integrals.v_beta * by,
        w_alpha: integrals.w_alpha * by,
        w_beta: integrals.w_beta * by,
        x0,
    }
}

/// Return sums and differences of the coefficients of e^{±ikz}, k = 1, 3, 5, 7.
pub fn full_terms(size: f64, h: f64, q: f64, r: f64, alternating: f64) -> TwoFours {
    let w1 = q * r;
    let w2 = q * q * r;
    let w3 = q * q * q * r;
    let w2 = w2 * w2;
    let w3 = w3 * w3 * w3;
    let h3 = h * h * h;
    let h5 = h3 * h * h;
    let h7 = h3 * h3 * h;
    let size = size / (w3 * (1.0 + h7) + w2 * (1.0 + h5) + w1 * (1.0 + h3) + (1.0 + h));
    let w1 = alternating * size * w1;
    let w2 = size * w2;
    let w3 = alternating * size * w3;
    (
        (size * (1.0 + h), w1 * (1.0 + h3), w2 * (1.0 + h5), w3 * (1.0 + h7)),
        (size * (1.0 - h), w1 * (1.0 - h3), w2 * (1.0 - h5), w3 * (1.0 - h7)),
    )
}

/// Return √t θ3 and √s θ4.
pub fn full_sizes(root_t: f64, root_s: f64, q: f64, theta3: f64) -> Pair {
    let q4 = q * q * (q * q);
    (root_t * theta3, root_s * (1.0 - 2.0 * (q - q4 + q4 * q4 * q)))
}

/// Return cos ky and sin ky for k = 1 to 4 of 0 ≤ y ≤ π.
pub fn _multiples(y: f64) -> TwoFours {
    let (s1, c1) = both::sine_cosine(y * (0.5 / std::f64::consts::PI));
    let s2 = 2.0 * s1 * c1;
    let c2 = 1.0 - 2.0 * s1 * s1;
    ((c1, c2, c2 * c1 - s2 * s1, 1.0 - 2.0 * s2 * s2), (s1, s2, s2 * c1 + c2 * s1, 2.0 * s2 * c2))
}

/// Return A's factors of sin ky and cos ky, k = 1, 3, 5, 7, B's of cos and sin of 2, 4, 6, 8 y, and its constant.
pub fn complementary_series(
    root_t: f64,
    root_s: f64,
    q: f64,
    theta3: f64,
    y_alpha: f64,
    y_beta: f64,
) -> (Four, Four, Four, Four, f64) {
    let q2 = q * q;
    let q4 = q2 * q2;
    let q6 = q2 * q2 * q2;
    let q9 = q6 * q2 * q;
    let (c, s) = _multiples(y_alpha);
    let theta4 = 1.0 - 2.0 * (q * c.1 - q4 * c.3 + q9 * (2.0 * c.2 * c.2 - 1.0));
    let size = root_t * theta3 / theta4;
    let c5 = c.3 * c.0 - s.3 * s.0;
    let s5 = s.3 * c.0 + c.3 * s.0;
    let c7 = c.3 * c.2 - s.3 * s.2;
    let s7 = s.3 * c.2 + c.3 * s.2;
    let a_sine = (size * s.0, -size * s.2, size * s5, -size * s7);
    let a_cosine = (size * c.0, -size * c.2, size * c5, -size * c7);
    let (c, s) = _multiples(2.0 * y_beta);
    let theta4 = 1.0 - 2.0 * (q * c.0 - q4 * c.1 + q9 * c.2);
    let size = root_s * (1.0 + q2 + q6 + q6 * q6) / theta4;
    (
        a_sine,
        a_cosine,
        (-size * c.0, size * c.1, -size * c.2, size * c.3),
        (-size * s.0, size * s.1, -size * s.2, size * s.3),
        size,
    )
}

/// Return √(t/2) and √(s/2) at the given size of the displacement, where that stays as small.
pub fn _sizes(top: &Reduction, t: Pair, s: Pair) -> Pair {
    let down = times_power(1.0, -(if leaves(top) { 0.0 } else { top.lift }));
    let upright = is_upright(top);
    let root_t = (0.5 * t.0).sqrt();
    let root_s = (0.5 * s.0).sqrt();
    (root_t * (if upright { 1.0 } else { down }), root_s * (if upright { down } else { 1.0 }))
}

/// Return q e^{2y}, accurate where y is far out, and e^{−2y}, of α and of β.
pub fn tails(at: &Arguments) -> Four {
    ((-2.0 * at.w_alpha).exp(), (-2.0 * at.y_alpha).exp(), (-2.0 * at.w_beta).exp(), (-2.0 * at.y_beta).exp())
}

/// Return sums and differences of the coefficients of e^{±ikz}, k = 1, 3, 5, 7, in A and in B.
pub fn full_series(
    top: &Reduction,
    points: &TurningPoints,
    at: &Arguments,
    tail: Four,
) -> (Four, Four, Four, Four, f64) {
    let (root_t, root_s) = _sizes(top, points.t2, points.s1);
    let (of_alpha, of_beta) = full_sizes(root_t, root_s, at.q, at.theta3);
    let some = at.q > 0.0;
    let (a_sum, a_gap) = full_terms(of_alpha, tail.1, at.q, if some { tail.0 } else { 0.0 }, -1.0);
    let (b_sum, b_gap) = full_terms(of_beta, tail.3, at.q, if some { tail.2 } else { 0.0 }, 1.0);
    (a_sum, a_gap, b_sum, b_gap, 0.0)
}

pub fn _full(given: &Given) -> (Four, Four, Four, Four, f64) {
    full_series(&given.top, &given.points, &given.at, tails(&given.at))
}

/// Return the series of a permanent top, which has one of α, β, or at rest both, as it started.
pub fn _standing(given: &Given) -> (Four, Four, Four, Four, f64) {
    // A = |α| sin z and B = i |β| sin z at z = π/2
    let (root_t, root_s) = _sizes(&given.top, given.top.t0, given.top.s0);
    ((root_t, 0.0, 0.0, 0.0), NO_TERMS, NO_TERMS, (root_s, 0.0, 0.0, 0.0), 0.0)
}

pub fn _of_full_form(given: &Given) -> (Four, Four, Four, Four, f64) {
    if given.rates.permanent { _standing(given) } else { _full(given) }
}

/// Return the series of the complementary form.
pub fn complementary(top: &Reduction, points: &TurningPoints, at: &Arguments) -> (Four, Four, Four, Four, f64) {
    let (root_t, root_s) = _sizes(top, points.t2, points.s1);
    complementary_series(root_t, root_s, at.q, at.theta3, at.y_alpha, at.y_beta)
}

pub fn _of_complementary_form(given: &Given) -> (Four, Four, Four, Four, f64) {
    complementary(&given.top, &given.points, &given.at)
}

/// Return cos and sin of the phase that turns A or B at the epoch into the given α or β.
///
/// Where one of them vanishes its own phase says nothing; its derivative then does, so both are used.
pub fn _constant_phase(
    r: f64,
    i: f64,
    dr: f64,
    di: f64,
    turns: f64,
    rate: f64,
    component: Pair,
    slope: Pair,
    norm: f64,
    drop: f64,
    turn: f64,
    size: f64,
) -> Pair {
    let r = r / norm;
    let i = i / norm;
    let sr = turn * (dr / norm - r * drop) - rate * i;
    let si = turn * (di / norm - i * drop) + rate * r;
    let (gr, gi) = component;
    let (er, ei) = slope;
    let real = r * gr + i * gi + (sr * er + si * ei) / size;
    let imaginary = r * gi - i * gr + (sr * ei - si * er) / size;
    let (s, c) = both::sine_cosine(turns - both::whole(turns));
    let (real, imaginary) = (real * c + imaginary * s, imaginary * c - real * s);
    let length = (real * real + imaginary * imaginary).sqrt();
    let some = length > 0.0;
    let safe = if some { length } else { 1.0 };
    (if some { real / safe } else { 1.0 }, if some { imaginary / safe } else { 0.0 })
}

/// Return cos and sin of the phases that turn A and B at the epoch into the given α and β.
///
/// Args:
///     quaternion, norm2: at the epoch, and its |q|².
///     momentum: at the epoch.
///     size: |L|² + G, by which derivatives count.
///     sums: at the epoch.
///     linear: derivatives by τ of the phases that evaluation adds to A and B.
///     turn: dz/dτ or dx'/dτ.
pub fn constant_phases(
    quaternion: Four,
    norm2: Pair,
    momentum: Three,
    size: f64,
    sums: Ten,
    linear: Pair,
    turn: f64,
) -> Four {
    let (x, y, z) = momentum;
    let length = both::root(norm2);
    let q0 = both::divide((quaternion.0, 0.0), length).0;
    let q1 = both::divide((quaternion.1, 0.0), length).0;
    let q2 = both::divide((quaternion.2, 0.0), length).0;
    let q3 = both::divide((quaternion.3, 0.0), length).0;
    // 2α' = i a α − w̄ β, 2β' = w α − i a β
    let a = (0.5 * (-z * q3 - (x * q1 + y * q2)), 0.5 * (z * q0 - (x * q2 - y * q1)));
    let b = (0.5 * (x * q0 - y * q3 + z * q2), 0.5 * (x * q3 + y * q0 - z * q1));
    let (ar, ai, br, bi, dar, dai, dbr, dbi, turns_a, turns_b) = sums;
    let length2 = ar * ar + ai * ai + (br * br + bi * bi);
    let norm = length2.sqrt();
    let drop = (ar * dar + ai * dai + (br * dbr + bi * dbi)) / length2;
    let (c0, s0) = _constant_phase(ar, ai, dar, dai, turns_a, linear.0, (q0, q3), a, norm, drop, turn, size);
    let (c1, s1) = _constant_phase(br, bi, dbr, dbi, turns_b, linear.1, (q1, q2), b, norm, drop, turn, size);
    (c0, s0, c1, s1)
}

/// Return the constant phases, of the sums at the epoch.
pub fn phases_of(top: &Reduction, timing: &Timing, sums: Ten) -> Four {
    let (ar, ai, br, bi, dar, dai, dbr, dbi, turns_a, turns_b) = sums;
    let up = times_power(1.0, top.lift);
    let upright = is_upright(top);
    let a = if upright { 1.0 } else { up };
    let b = if upright { up } else { 1.0 };
    let (x, y, z) = top.momentum;
    let size = x * x + y * y + (z * z + top.G.0);
    let lifted = (ar * a, ai * a, br * b, bi * b, dar * a, dai * a, dbr * b, dbi * b, turns_a, turns_b);
    constant_phases(
        top.quaternion,
        top.size,
        top.momentum,
        if size > 0.0 { size } else { 1.0 },
        lifted,
        timing.linear,
        timing.turn,
    )
}

pub fn _in_halves(rate: Pair) -> Three {
    let (high, low) = both::halves(rate.0);
    (high, low, rate.1)
}

/// Return what of the motion depends on rates and places.
pub fn timing_of(top: &Reduction, rates: &Frequencies, at: &Arguments) -> Timing {
    let (i1, _) = top.moments;
    let permanent = rates.permanent;
    let separatrix = rates.separatrix;
    let full = at.full;
    let (alpha, beta) = phase_rates(top, rates);
    let half = half_periods(rates.nutation, i1, top.rate_scale);
    let saddle = both::divide(both::scale(rates.half_root, top.rate_scale), (i1, 0.0));
    let third =
        if permanent {
            ZERO
        } else {
            if full { both::scale(half, 0.5) } else { if separatrix { saddle } else { half } }
        };
    let (quarter, period) = periods(rates.half_root, rates.nutation, at.q);
    let fraction = both::scale(both::divide(at.x0, quarter), 0.5);
    let start = if full { both::scale(fraction, 0.5) } else { if separatrix { at.x0 } else { fraction } };
    let start = if permanent { (0.25, 0.0) } else { start };
    let period = if separatrix { ONE } else { period };
    let (upper, lower) = both::halves(period.0);
    let ya = if full || separatrix { 0.0 } else { at.y_alpha };
    let yb = if full || separatrix { 0.0 } else { at.y_beta };
    let carried = rates.nutation.0 * (2.0 / std::f64::consts::PI);
    let sa = rates.sign_alpha;
    let sb = rates.sign_beta;
    let turn = if full { rates.nutation.0 } else { rates.half_root.0 / (at.theta3 * at.theta3) };
    let linear_a = if permanent { 0.0 } else { rates.alpha.0 + sa * ya * carried };
    let linear_b = if permanent { 0.0 } else { rates.beta.0 + sb * yb * carried };
    let turn = if permanent { 0.0 } else { turn };
    let size = top.momentum_scale;
    Timing {
        rates: (_in_halves(alpha), _in_halves(beta), _in_halves(third), start),
        places: (
            (
                at.q,
                upper,
                lower + period.1,
                ya / std::f64::consts::PI,
                yb / std::f64::consts::PI,
                if separatrix { 0.0 } else { 1.0 },
            ),
            (if permanent { 1.0 } else { sa }, if permanent { 1.0 } else { sb }),
            (2.0 * turn * size, 2.0 * (linear_a + linear_b) * size),
        ),
        linear: (linear_a, linear_b),
        turn,
    }
}

pub fn _motion(given: &Given, timing: &Timing, series: (Four, Four, Four, Four, f64), phases: Four) -> Motion {
    let (first, second, third, start) = timing.rates;
    let (nome, signs, rates) = timing.places;
    let (a_sum, a_gap, b_sum, b_gap, constant) = series;
    Motion {
        full: if given.at.full { 1.0 } else { 0.0 },
        first,
        second,
        third,
        start,
        a_sum,
        a_gap,
        b_sum,
        b_gap,
        constant,
        nome,
        signs,
        rates,
        phases,
        axial: given.axial,
        reversed: if given.top.reversed { -1.0 } else { 1.0 },
    }
}

/// Return the motion of a top whose constant phases are none.
pub fn motion_without_phases(given: &Given) -> (Motion, Timing) {
    let timing = timing_of(&given.top, &given.rates, &given.at);
    let series = if given.at.full { _of_full_form(given) } else { _of_complementary_form(given) };
    (_motion(given, &timing, series, (1.0, 0.0, 1.0, 0.0)), timing)
}

pub fn _full_start(m: &Motion) -> Ten {
    let zero = 0.0 * m.start.0;
    full_sums(m, (zero, zero, zero))
}

pub fn _complementary_start(m: &Motion) -> Ten {
    let zero = 0.0 * m.start.0;
    let (a, b, c, e, factor, other, other_factor) = complementary_phase(m, (zero, zero, zero));
    complementary_sums(m, a, b, c, e.exp() * factor, other.exp() * other_factor)
}

/// Return the motion, which begins at the given attitude.
pub fn motion_with_phases(given: &Given, motion: &Motion, timing: &Timing) -> Motion {
    let sums = if given.at.full { _full_start(motion) } else { _complementary_start(motion) };
    let series = (motion.a_sum, motion.a_gap, motion.b_sum, motion.b_gap, motion.constant);
    _motion(given, timing, series, phases_of(&given.top, timing, sums))
}

/// Return the constants of motion of a top.
pub fn motion_of(given: &Given) -> Motion {
    let (motion, timing) = motion_without_phases(given);
    motion_with_phases(given, &motion, &timing)
}
