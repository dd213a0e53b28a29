// SPDX-License-Identifier: MIT
// Printed from src/polhode/exact by `python -m printing` in reference/: change the formulas, and print again.
// names are those of Python, and a formula may leave something unused
#![allow(dead_code, non_snake_case, unused_imports, unused_variables)]

use crate::both;
use crate::words::*;

type Three = (f64, f64, f64);
type Pair = (f64, f64);
type TwoThrees = (Three, Three);
type Ten = (f64, f64, f64, f64, f64, f64, f64, f64, f64, f64);
type Five = (f64, f64, f64, f64, f64);
type Sixteen = (f64, f64, f64, f64, f64, f64, f64, f64, f64, f64, f64, f64, f64, f64, f64, f64);
type Nine = (f64, f64, f64, f64, f64, f64, f64, f64, f64);
type Four = (f64, f64, f64, f64);
type Seven = (f64, f64, f64, f64, f64, f64, f64);
type Six = (f64, f64, f64, f64, f64, f64);
type ThreeThrees = (Three, Three, Three);

// of components of L, below which numbers with it are scaled up by LIFT binary places
pub const TINY_RATIO: f64 = 1.1830521861667747e-271;
pub const LIFT: f64 = 100.0;
// products of double-doubles above it have all their digits
pub const SHARP: f64 = 1e-280;
// of the terms of S: what is left below it is summed exactly
pub const NEAR: f64 = 0.01;
/// A body with sorted axes and without powers of two.
#[derive(Clone, Copy)]
pub struct Scaled {
    /// ascending, ½ ≤ I3 < 1
    pub moments: Three,
    /// along the sorted axes, ½ ≤ max |L_i| < 1, times 2^LIFT if a component is tiny
    pub momentum: Three,
    /// which of the given axes they are
    pub order: Three,
    /// −1 if sorting is no proper rotation; the momentum then has the other sign
    pub parity: f64,
    /// powers of two taken out
    pub momentum_scale: f64,
    pub rate_scale: f64,
}

/// Invariants before the mirror, each a sum of terms of one sign.
#[derive(Clone, Copy)]
pub struct Sums {
    pub A: Pair,
    pub B: Pair,
    pub C: Pair,
    pub P: Pair,
    pub Q: Pair,
    pub G2: Pair,
}

/// A body in canonical form; all pairs are double-double.
///
/// With V = I1 I2 I3: A = (I2−I1)I3, B = (I3−I2)I1, C = (I3−I1)I2, P = C L1² + B L2², Q = A L2² + C L3² and
/// S = A L1² − B L3² ≤ 0 are V times the textbook quantities, which avoids all divisions; the mirror has been applied.
#[derive(Clone, Copy)]
pub struct Reduction {
    /// those of Scaled
    pub moments: Three,
    pub momentum: Three,
    /// momentum after mirror and half turn, third component ≥ 0
    pub canonical: Three,
    pub A: Pair,
    pub B: Pair,
    pub C: Pair,
    pub P: Pair,
    pub Q: Pair,
    pub S: Pair,
    /// √−S, accurate where S itself underflows
    pub root_S: Pair,
    /// √P, likewise
    pub root_P: f64,
    pub V: Pair,
    /// |L|²
    pub G2: Pair,
    /// whether the mirror was applied
    pub long_axis: bool,
    /// which of the given axes the canonical ones are
    pub order: Three,
    /// that of Scaled
    pub parity: f64,
    /// −1 where the half turn about the second axis was applied
    pub half_turn: f64,
    /// powers of two taken out
    pub momentum_scale: f64,
    pub rate_scale: f64,
}

pub fn _in_order(one: Three, other: Three, parity: f64) -> (Three, Three, f64) {
    let swap = other.0 < one.0;
    (
        (if swap { other.0 } else { one.0 }, if swap { other.1 } else { one.1 }, if swap { other.2 } else { one.2 }),
        (if swap { one.0 } else { other.0 }, if swap { one.1 } else { other.1 }, if swap { one.2 } else { other.2 }),
        if swap { -parity } else { parity },
    )
}

pub fn _size(x: f64, size: f64) -> f64 {
    if x == 0.0 { size } else { x.abs() }
}

/// Sort the axes by their moments, and take out powers of two.
pub fn scaled(moments: Three, momentum: Three) -> Scaled {
    let (x, y, parity) = _in_order((moments.0, momentum.0, 0.0), (moments.1, momentum.1, 1.0), 1.0);
    let (y, z, parity) = _in_order(y, (moments.2, momentum.2, 2.0), parity);
    let (x, y, parity) = _in_order(x, y, parity);
    let size = larger(larger(x.1.abs(), y.1.abs()), z.1.abs());
    // a component down to the smallest number keeps its digits in what is formed of it
    let smallest = smaller(smaller(_size(x.1, size), _size(y.1, size)), _size(z.1, size));
    let of_momentum = binary_exponent(size) - (if smallest < TINY_RATIO * size { LIFT } else { 0.0 });
    let of_moments = binary_exponent(z.0);
    Scaled {
        moments: (times_power(x.0, -of_moments), times_power(y.0, -of_moments), times_power(z.0, -of_moments)),
        momentum: (
            parity * times_power(x.1, -of_momentum),
            parity * times_power(y.1, -of_momentum),
            parity * times_power(z.1, -of_momentum),
        ),
        order: (x.2, y.2, z.2),
        parity,
        momentum_scale: times_power(1.0, of_momentum),
        rate_scale: times_power(1.0, of_momentum - of_moments),
    }
}

/// Return the invariants but S.
pub fn sums_of(body: &Scaled) -> Sums {
    let (i1, i2, i3) = body.moments;
    let (x, y, z) = body.momentum;
    let a = both::multiply_float(both::two_sum(i2, -i1), i3);
    let b = both::multiply_float(both::two_sum(i3, -i2), i1);
    let c = both::multiply_float(both::two_sum(i3, -i1), i2);
    let s1 = both::two_square(x);
    let s2 = both::two_square(y);
    let s3 = both::two_square(z);
    let p = both::add(both::multiply(c, s1), both::multiply(b, s2));
    let q = both::add(both::multiply(a, s2), both::multiply(c, s3));
    Sums { A: a, B: b, C: c, P: p, Q: q, G2: both::add(both::add(s1, s2), s3) }
}

pub fn _exponent_near_saddle(body: &Scaled) -> f64 {
    binary_exponent(larger(body.momentum.0.abs(), body.momentum.2.abs()))
}

/// Return the moments, and L1 and L3 scaled up: near the saddle their squares would lose their low words.
pub fn terms_of_distance(body: &Scaled) -> (Three, f64, f64) {
    let exponent = _exponent_near_saddle(body);
    let (x, _, z) = body.momentum;
    (body.moments, times_power(x, -exponent), times_power(z, -exponent))
}

/// Return A x² − B z² in double-double, and whether so much cancels that it is to be summed exactly.
pub fn plain_distance(a: Pair, b: Pair, x: f64, z: f64) -> (Pair, bool) {
    let first = both::multiply(a, both::two_square(x));
    let distance = both::subtract(first, both::multiply(b, both::two_square(z)));
    (distance, distance.0.abs() < NEAR * first.0)
}

/// Return the product of a gap, a moment and x².
pub fn _of_square(gap: Pair, moment: f64, x: f64) -> Sum {
    multiply_terms(multiply_terms(multiply_terms(as_sum(gap), moment), x), x)
}

/// Return S = (I2 − I1) I3 x² − (I3 − I2) I1 z², correct to its last digit however close to the separatrix.
pub fn exact_distance(moments: Three, x: f64, z: f64) -> Pair {
    let (i1, i2, i3) = moments;
    distil(join(_of_square(both::two_sum(i2, -i1), i3, x), _of_square(both::two_sum(i3, -i2), -i1, z)))
}

pub fn _exact(values: ((Three, f64, f64), Pair)) -> Pair {
    let (moments, x, z) = values.0;
    exact_distance(moments, x, z)
}

pub fn _plain(values: ((Three, f64, f64), Pair)) -> Pair {
    values.1
}

/// Return A L1² − B L3², with both components scaled up.
pub fn signed_distance(body: &Scaled, sums: &Sums) -> Pair {
    let terms = terms_of_distance(body);
    let (plain, near) = plain_distance(sums.A, sums.B, terms.1, terms.2);
    if near { _exact((terms, plain)) } else { _plain((terms, plain)) }
}

/// Return √(C x² + B y²), of which the sum is given but may have lost digits, or all, to underflow.
pub fn _root_of_sum(value: f64, c: f64, x: f64, b: f64, y: f64) -> f64 {
    let exponent = binary_exponent(larger(x.abs(), y.abs()));
    let x = times_power(x, -exponent);
    let y = times_power(y, -exponent);
    if value > SHARP { value.sqrt() } else { times_power((c * x * x + b * y * y).sqrt(), exponent) }
}

/// Apply mirror and half turn; the distance is that of signed_distance.
pub fn reduced(body: &Scaled, sums: &Sums, distance: Pair) -> Reduction {
    let long_axis = distance.0 > 0.0;
    let a = if long_axis { sums.B } else { sums.A };
    let b = if long_axis { sums.A } else { sums.B };
    let p = if long_axis { sums.Q } else { sums.P };
    let q = if long_axis { sums.P } else { sums.Q };
    let (x, y, z) = body.momentum;
    let (x, z) = (if long_axis { z } else { x }, if long_axis { x } else { z });
    let half_turn = if z < 0.0 { -1.0 } else { 1.0 };
    let (i1, i2, i3) = body.moments;
    let side = if long_axis { 1.0 } else { -1.0 };
    let near = times_power(1.0, _exponent_near_saddle(body));
    let minus_s = both::scale(distance, side);
    let (first, second, third) = body.order;
    Reduction {
        moments: body.moments,
        momentum: body.momentum,
        canonical: (x * half_turn, y, z * half_turn),
        A: a,
        B: b,
        C: sums.C,
        P: p,
        Q: q,
        S: both::scale(both::scale(minus_s, -near), near),
        root_S: both::scale(both::root_or_zero(minus_s), near),
        root_P: _root_of_sum(p.0, sums.C.0, x, b.0, y),
        V: both::multiply_float(both::two_product(i1, i2), i3),
        G2: sums.G2,
        long_axis,
        order: (if long_axis { third } else { first }, second, if long_axis { first } else { third }),
        parity: body.parity,
        half_turn,
        momentum_scale: body.momentum_scale,
        rate_scale: body.rate_scale,
    }
}

/// Return the canonical form of a body, in any order and at any scale.
pub fn reduction(moments: Three, momentum: Three) -> Reduction {
    let body = scaled(moments, momentum);
    let sums = sums_of(&body);
    reduced(&body, &sums, signed_distance(&body, &sums))
}

/// Rates times V in canonical scaled units, and the regime of the body.
#[derive(Clone, Copy)]
pub struct Frequencies {
    /// λ = √(BQ): u = u0 + λ t
    pub modulus_rate: Pair,
    /// agm(√(BQ), √(−CS)) = π λ / 2K; meaningless on the separatrix
    pub mean: Pair,
    /// ω_p
    pub precession: Pair,
    /// |L|
    pub G: Pair,
    /// permanent rotation, sphere or rest: L stays
    pub constant: bool,
    pub separatrix: bool,
}

/// What of the frequencies is there before the mean.
#[derive(Clone, Copy)]
pub struct Start {
    pub modulus_rate: Pair,
    pub constant: bool,
    pub separatrix: bool,
}

/// Return the start and √(BQ), √(−CS) and p² for the mean, or ones where there is no period.
///
/// p² is so chosen that the third-kind sum stays quadratic.
pub fn start_of(body: &Reduction) -> (Start, Pair, Pair, Pair) {
    let rate = both::root_or_zero(both::multiply(body.B, body.Q));
    let slow = both::multiply(both::root_or_zero(body.C), body.root_S);
    let third = body.B.0 >= body.A.0;
    let pp = both::multiply(if third { body.Q } else { body.B }, body.C);
    let pp = if third { pp } else { both::multiply(pp, body.G2) };
    let (x, _, z) = body.canonical;
    let is_constant = !(rate.0 > 0.0) || !(body.root_P > 0.0) || (x == 0.0 && z == 0.0);
    let separatrix = !(body.C.0 > 0.0 && body.root_S.0 > 0.0) && !is_constant;
    let idle = is_constant || separatrix;
    let one = (1.0, 0.0);
    let start = Start { modulus_rate: rate, constant: is_constant, separatrix };
    (start, if idle { one } else { rate }, if idle { one } else { slow }, if idle { one } else { pp })
}

/// Return the frequencies, of mean and third-kind sum.
pub fn frequencies_of(body: &Reduction, start: &Start, mean: Pair, total: Pair) -> Frequencies {
    let g = both::root_or_zero(body.G2);
    let third = body.B.0 >= body.A.0;
    let (i1, i2, i3) = body.moments;
    // a1 V = I2 I3 and a3 V = I1 I2, and with the mirror −I1 I2 and −I2 I3
    let side = if body.long_axis { -1.0 } else { 1.0 };
    let outer = both::two_product(side * (if body.long_axis == third { i1 } else { i3 }), i2);
    let correction = both::multiply(if third { body.A } else { body.P }, total);
    let share = if third { both::scale(correction, -0.5) } else { both::scale(both::divide(correction, body.G2), 0.5) };
    let rate = both::multiply(g, both::add(outer, share));
    let precession = if third { rate } else { both::add(rate, mean) };
    // on the separatrix the frame ends up turning at |L|/I2, here times V = I1 I2 I3
    let saddle = both::multiply(g, both::two_product(side * i1, i3));
    let precession = if start.separatrix { saddle } else { precession };
    Frequencies {
        modulus_rate: start.modulus_rate,
        mean,
        precession,
        G: g,
        constant: start.constant,
        separatrix: start.separatrix,
    }
}

/// Return the frequencies of a reduced body.
pub fn frequencies(body: &Reduction) -> Frequencies {
    let (start, fast, slow, pp) = start_of(body);
    let (mean, total) = both::third_kind_mean(fast, slow, pp);
    frequencies_of(body, &start, mean, total)
}

/// Return Motion.first and Motion.second [turns per time], in halves, of a body with two frequencies.
pub fn phase_rates(full: bool, body: &Reduction, rates: &Frequencies) -> TwoThrees {
    // rates times V become turns: over 2πV
    let inverse = both::scale(both::divide(both::INVERSE_TWO_PI, body.V), body.rate_scale);
    let half = both::scale(both::multiply(rates.precession, inverse), 0.5);
    let turn = both::scale(both::multiply(rates.mean, inverse), 2.0);
    let quarter = both::scale(turn, 0.25);
    let saddle = both::scale(both::divide(rates.modulus_rate, body.V), body.rate_scale);
    let first = if full { both::subtract(half, quarter) } else { half };
    let second = if rates.separatrix { saddle } else { if full { both::add(half, quarter) } else { turn } };
    let (first_high, first_low) = both::halves(first.0);
    let (second_high, second_low) = both::halves(second.0);
    ((first_high, first_low, first.1), (second_high, second_low, second.1))
}

/// All that evaluation needs of a body: numbers, or arrays with one for each of many.
#[derive(Clone, Copy)]
pub struct Motion {
    /// whether it takes the full form
    pub full: f64,
    /// full: rate of the phase of A; complementary: half the precession rate [turns per time]
    pub first: Three,
    /// full: rate of the phase of B; complementary: rate of u/2K
    pub second: Three,
    /// full: (z0/4π, 0); complementary: u0/2K, double-double
    pub start: Pair,
    /// full: five coefficients of A and of B; complementary: cos and sin of (2n+1)(y/2 − π/4)
    pub series: Ten,
    /// complementary: √q1, πK/K' in halves, y/2π, 0 on the separatrix
    pub nome: Five,
    /// complementary: half turns of u at the start
    pub parity: f64,
    /// by rows: quaternion = matrix (4, 4) · spinor / norm
    pub to_attitude: Sixteen,
    /// by rows: momentum = matrix (3, 3) · (n1, n2, n3)
    pub to_momentum: Nine,
}

/// Sum A and B as polynomials in X = cos 2z and Y = sin 2z, where z is the difference of their phases.
pub fn full_sums(m: &Motion, time: Three) -> Four {
    let start = m.start.0;
    let (a0, a1, a2, a3, a4, b0, b1, b2, b3, b4) = m.series;
    let (fa, ra, _) = both::phase(m.first, time);
    let (fb, rb, _) = both::phase(m.second, time);
    let ta = fa + (ra - start);
    let tb = fb + (rb + start);
    let (sa, ca) = both::sine_cosine(ta - both::whole(ta));
    let (sb, cb) = both::sine_cosine(tb - both::whole(tb));
    let cz = ca * cb + sa * sb;
    let sz = sb * ca - cb * sa;
    // cos 2z = 1 − 2 sin² z, sin 2z = 2 sin z cos z
    let s2 = sz + sz;
    let X = 1.0 - s2 * sz;
    let Y = s2 * cz;
    let pa = a0 + X * (a1 + X * a2);
    let qa = Y * (a3 + X * a4);
    let pb = b0 + X * (b1 + X * b2);
    let qb = Y * (b3 + X * b4);
    (ca * pa - sa * qa, ca * qa + sa * pa, cb * pb - sb * qb, cb * qb + sb * pb)
}

/// Return turns, side, count of half turns, and exponent and factor of E and of R, which sums A and B.
pub fn complementary_phase(m: &Motion, time: Three) -> Seven {
    let (_, upper, lower, y_turns, periodic) = m.nome;
    let (fraction, rest, _) = both::phase(m.first, time);
    let (u, u_rest, count) = both::reduced_argument(m.second, m.start, periodic, time);
    let count = m.parity + count;
    let count = count - 4.0 * both::whole(0.25 * count);
    let turns = fraction - 0.25 * count;
    let turns = turns - both::whole(turns) + (rest - u * y_turns);
    let side = if u < 0.0 { -1.0 } else { 1.0 };
    let f = u * side;
    let g = u_rest * side;
    let (e, e_factor) = both::exponent(f, g, upper, lower);
    let distance = larger(0.5 - f, 0.0);
    let (r, r_factor) = both::exponent(distance, (0.5 - distance - f) * periodic - g, upper, lower);
    (turns, side, count, e, e_factor, r, periodic * r_factor)
}

/// Sum A and B in the growing powers of R = √q1/E and the decaying ones of E = e^−|x|, x = πu/2K'.
pub fn complementary_sums(m: &Motion, turns: f64, side: f64, count: f64, e0: f64, R: f64) -> Four {
    let (c0, c1, c2, c3, c4, s0, s1, s2, s3, s4) = m.series;
    let root = m.nome.0;
    let (s, c) = both::sine_cosine(turns - both::whole(turns));
    let q = root * root;
    let q2 = q * q;
    let g1 = root * R;
    let g2 = g1 * g1 * q;
    let g3 = g2 * g1 * q2;
    let g4 = g3 * g1 * q2 * q;
    let e1 = q * e0 * e0;
    let e2 = q2 * e1 * e0;
    let e3 = q2 * q * e2 * e0;
    let e4 = q2 * q2 * e3 * e0;
    let ar = c4 * (g4 + e4);
    let ai = s4 * (g4 - e4);
    let br = -s4 * (g4 + e4);
    let bi = c4 * (g4 - e4);
    let ar = ar + c3 * (g3 + e3);
    let ai = ai + s3 * (g3 - e3);
    let br = br + s3 * (g3 + e3);
    let bi = bi - c3 * (g3 - e3);
    let ar = ar + c2 * (g2 + e2);
    let ai = ai + s2 * (g2 - e2);
    let br = br - s2 * (g2 + e2);
    let bi = bi + c2 * (g2 - e2);
    let ar = ar + c1 * (g1 + e1);
    let ai = ai + s1 * (g1 - e1);
    let br = br + s1 * (g1 + e1);
    let bi = bi - c1 * (g1 - e1);
    let ar = ar + c0 * (1.0 + e0);
    let ai = ai + s0 * (1.0 - e0);
    let br = br - s0 * (1.0 + e0);
    let bi = bi + c0 * (1.0 - e0);
    let ai = ai * side;
    let bi = bi * side;
    let odd = 1.0 - 2.0 * (count - 2.0 * (0.5 * count).floor());
    (c * ar - s * ai, c * ai + s * ar, odd * (c * br - s * bi), odd * (c * bi + s * br))
}

/// Return attitude and momentum.
pub fn state_of(m: &Motion, spinor: Four) -> Seven {
    let (a0, a1, b0, b1) = spinor;
    let aa = a0 * a0 + a1 * a1;
    let bb = b0 * b0 + b1 * b1;
    let x = 1.0 / (aa + bb);
    let root = x.sqrt();
    let x2 = x + x;
    // the direction of L of a spinor (A, B): 2 Re ĀB, 2 Im ĀB and |A|² − |B|², over |A|² + |B|²
    let n0 = (a0 * b0 + a1 * b1) * x2;
    let n1 = (a0 * b1 - a1 * b0) * x2;
    let n2 = (aa - bb) * x;
    let a = a0 * root;
    let b = a1 * root;
    let c = b0 * root;
    let d = b1 * root;
    let q = m.to_attitude;
    let p = m.to_momentum;
    (
        q.0 * a + q.1 * b + q.2 * c + q.3 * d,
        q.4 * a + q.5 * b + q.6 * c + q.7 * d,
        q.8 * a + q.9 * b + q.10 * c + q.11 * d,
        q.12 * a + q.13 * b + q.14 * c + q.15 * d,
        p.0 * n0 + p.1 * n1 + p.2 * n2,
        p.3 * n0 + p.4 * n1 + p.5 * n2,
        p.6 * n0 + p.7 * n1 + p.8 * n2,
    )
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

// below it the leading term of the cap's area is as exact as the difference it replaces
pub const SMALL_CAP: f64 = 1e-14;
/// What a free body's motion is like; what is infinite is inf, what is undefined NaN, and −1 of the axis.
#[derive(Clone, Copy)]
pub struct Numbers {
    /// 0 rest, 1 spherical, 2 permanent, 3 symmetric, 4 short axis, 5 long axis, 6 separatrix
    pub regime: f64,
    /// index of the given axis that the polhode goes round
    pub encircled_axis: f64,
    pub modulus: f64,
    /// after which the momentum is back along the body's axes
    pub period: f64,
    /// mean rate at which the encircled axis turns about the momentum
    pub precession_rate: f64,
    pub precession_per_period: f64,
    /// of the cap that the polhode cuts off about the encircled axis
    pub solid_angle: f64,
}

pub fn _regime(body: &Reduction, rates: &Frequencies) -> f64 {
    let (i1, i2, i3) = body.moments;
    let (x, y, z) = body.momentum;
    let code = if body.long_axis { 5.0 } else { 4.0 };
    let code = if i1 == i2 || i2 == i3 { 3.0 } else { code };
    let code = if rates.separatrix { 6.0 } else { code };
    let code = if rates.constant { 2.0 } else { code };
    let code = if i1 == i3 { 1.0 } else { code };
    if x == 0.0 && y == 0.0 && z == 0.0 { 0.0 } else { code }
}

/// Return Ω = 2π − (ω_p − 2E/|L|) T, in double-double, as small caps cancel.
pub fn _solid_angle(body: &Reduction, rates: &Frequencies, per_period: Pair, scaled_period: Pair, two_pi: Pair) -> f64 {
    let (i1, i2, i3) = body.moments;
    let b = body.B.0;
    let c = body.C.0;
    let p = body.P.0;
    let q = body.Q.0;
    let g2 = body.G2.0;
    let twice_energy = both::add(
        body.P,
        both::multiply(both::two_product(if body.long_axis { -i3 } else { i1 }, i2), body.G2),
    );
    let dynamic = both::multiply(both::divide(twice_energy, rates.G), scaled_period);
    let angle = both::subtract(two_pi, both::subtract(per_period, dynamic));
    // a small cap is the ellipse C L1² + B L2² = P, of area πP/√(BC), over |L|²
    let cap = std::f64::consts::PI * p / ((b * c).sqrt() * g2);
    // a symmetric body's period has no bound near its equator, and the difference no digit left
    let round_cap = 2.0 * std::f64::consts::PI * (p / (c * g2)) / (1.0 + (q / (c * g2)).sqrt());
    if body.A.0 == 0.0 { round_cap } else { if p / (b * g2) < SMALL_CAP { cap } else { angle.0 } }
}

pub fn _by_kind(rates: &Frequencies, permanent: f64, separatrix: f64, periodic: f64) -> f64 {
    if rates.constant { permanent } else { if rates.separatrix { separatrix } else { periodic } }
}

/// Return the numbers of a body.
pub fn numbers(body: &Reduction, rates: &Frequencies) -> Numbers {
    let two_pi = both::scale(both::PI, 2.0);
    // T/V
    let scaled_period = both::divide(two_pi, rates.mean);
    // ω_p T
    let per_period = both::multiply(rates.precession, scaled_period);
    let period = both::divide(both::multiply(scaled_period, body.V), (body.rate_scale, 0.0 * body.rate_scale));
    let rate = both::scale(both::divide(rates.precession, body.V), body.rate_scale);
    let sense = if body.long_axis { -1.0 } else { 1.0 };
    // k² = AP/(BQ)
    let modulus = (body.A.0 / body.B.0).sqrt() * (body.root_P / body.Q.0.sqrt());
    let solid_angle = _solid_angle(body, rates, per_period, scaled_period, two_pi);
    Numbers {
        regime: _regime(body, rates),
        encircled_axis: _by_kind(rates, -1.0, -1.0, body.order.2),
        modulus: _by_kind(rates, f64::NAN, 1.0, modulus),
        period: _by_kind(rates, f64::NAN, f64::INFINITY, period.0),
        precession_rate: if rates.constant { f64::NAN } else { sense * rate.0 },
        precession_per_period: _by_kind(rates, f64::NAN, f64::INFINITY, sense * per_period.0),
        solid_angle: _by_kind(rates, f64::NAN, f64::NAN, solid_angle),
    }
}

// a sine above the inverse of the first is scaled by the second
pub const HUGE_INVERSE: f64 = 3.8725919148493183e-121;
pub const HUGE_SCALE: f64 = 6.223015277861142e-61;
// 200 ln 2
pub const LOG_OF_SCALE: Pair = (138.62943611198907, -3.3555121496085278e-15);
pub const NINE_ZEROS: Nine = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
pub const SIXTEEN_ZEROS: Sixteen = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0);
/// What a form takes at the epoch.
#[derive(Clone, Copy)]
pub struct Arguments {
    pub start: Pair,
    pub series: Ten,
    pub nome: Five,
    pub parity: f64,
}

/// What the full form's start is the angle of, and its coefficients.
#[derive(Clone, Copy)]
pub struct FullAmplitude {
    pub rise: f64,
    pub run: f64,
    pub series: Ten,
}

/// What the complementary form's start is made from.
#[derive(Clone, Copy)]
pub struct Amplitude {
    pub nome: f64,
    /// of y, the circular amplitude
    pub tangent: f64,
    /// of x, the hyperbolic one, times HUGE_SCALE if it is huge
    pub sinh: f64,
    pub huge: bool,
}

/// The amplitudes, and the hyperbolic sine of x as it is rounded.
#[derive(Clone, Copy)]
pub struct Angles {
    pub x: f64,
    pub sinh: f64,
    pub y: f64,
}

/// A body as given, with its reduction and frequencies.
#[derive(Clone, Copy)]
pub struct Given {
    pub moments: Three,
    pub momentum: Three,
    pub attitude: Four,
    pub body: Reduction,
    pub rates: Frequencies,
}

/// Return x, y, dn, factor, sinh and dc after a step.
pub fn _landen_step(x: f64, y: f64, dn: f64, factor: f64, sinh: f64, cosine: f64, dc: f64) -> Six {
    // descending Landen (DLMF §22.7(i)), κ = (1 − k′)/(1 + k′): (1 − dn)/(1 + dn) = κ sn² of the next step, whose
    // dn² = 1 − κ² sn², and tan am = (1 + κ) tan am/dn of the next step
    let kappa = (x - y) / (x + y);
    let grown = 1.0 + kappa;
    let next_dn = (1.0 - kappa * (1.0 - dn) / (1.0 + dn)).sqrt();
    let sinh = 2.0 * sinh / (grown * (cosine + dc));
    let next_dc = (1.0 + kappa * (dc - cosine) / (dc + cosine)).sqrt();
    (0.5 * (x + y), (x * y).sqrt(), next_dn, factor * (next_dn / grown), sinh, next_dc)
}

/// Follow a circular and a hyperbolic amplitude down five Landen steps from the complementary modulus k.
///
/// Returns the factor of the tangent of the circular amplitude and the hyperbolic sine of the other; its first step
/// takes sinh · c, c and dc · c so that none of them needs a quotient that may be 0/0.
pub fn landen(k: f64, dn: f64, sinh_times_cosine: f64, cosine: f64, dc: f64) -> Pair {
    let (x, y, dn, factor, sinh, dc) = _landen_step(1.0, k, dn, 1.0, sinh_times_cosine, cosine, dc);
    let (x, y, dn, factor, sinh, dc) = _landen_step(x, y, dn, factor, sinh, 1.0, dc);
    let (x, y, dn, factor, sinh, dc) = _landen_step(x, y, dn, factor, sinh, 1.0, dc);
    let (x, y, dn, factor, sinh, dc) = _landen_step(x, y, dn, factor, sinh, 1.0, dc);
    let (x, y, dn, factor, sinh, dc) = _landen_step(x, y, dn, factor, sinh, 1.0, dc);
    (factor, sinh)
}

/// Return what the start of the full form, m ≤ ½, is the angle of, and the coefficients of A and B.
pub fn full_amplitude(body: &Reduction) -> FullAmplitude {
    let a = body.A.0;
    let b = body.B.0;
    let c = body.C.0;
    let q = body.Q.0;
    let (x, y, z) = body.canonical;
    let total = b * q;
    let parameter = a * body.P.0 / total;
    let complement = -c * body.S.0 / total;
    let per_parameter = both::nome_per_parameter(parameter, complement.sqrt());
    let nome = per_parameter * parameter;
    // √(P/Q) sinh, as the hyperbolic sine itself overflows near a stable axis
    let small = body.root_P / q.sqrt();
    let of_b = b.sqrt();
    let of_c = c.sqrt();
    let (factor, scaled) = landen(complement.sqrt(), z * (c / q).sqrt(), of_b, of_b, of_c);
    let grown = scaled + (small * small + scaled * scaled).sqrt();
    let g = small / grown;
    let r = a / b * per_parameter * grown * grown;
    let g2 = g * g;
    let q2 = nome * nome;
    let r2 = r * r;
    let q3 = q2 * nome;
    let q4 = q2 * q2;
    let q8 = q4 * q4;
    let gg = g2 * g2;
    let up = -nome * g2;
    let down = -q2 * r;
    let up2 = q4 * q2 * gg;
    let down2 = q8 * r2;
    let up3 = -q3 * g2;
    let up4 = q8 * q2 * gg;
    let down4 = q4 * r2;
    FullAmplitude {
        rise: of_b * y * factor,
        run: of_c * x,
        series: (
            1.0 - (up2 + down2),
            up + down,
            2.0 * (up2 + down2),
            up - down,
            2.0 * (up2 - down2),
            g * (1.0 - (up4 + down4)),
            g * (up3 - r),
            2.0 * g * (up4 + down4),
            g * (up3 + r),
            2.0 * g * (up4 - down4),
        ),
    }
}

/// Return z0/4π.
pub fn full_start(rise: f64, run: f64) -> f64 {
    rise.atan2(run) * (0.25 / std::f64::consts::PI)
}

/// Return what the full form takes.
pub fn full_arguments(start: f64, series: Ten) -> Arguments {
    Arguments { start: (start, 0.0), series, nome: (0.0, 0.0, 0.0, 0.0, 0.0), parity: 0.0 }
}

pub fn _full_arguments(given: &Given) -> Arguments {
    let at = full_amplitude(&given.body);
    full_arguments(full_start(at.rise, at.run), at.series)
}

/// Return what the start of the complementary form, m > ½, is made from.
pub fn amplitude(body: &Reduction, rates: &Frequencies) -> Amplitude {
    let b = body.B.0;
    let c = body.C.0;
    let p = body.P.0;
    let q = body.Q.0;
    let (x, y, z) = body.canonical;
    let total = b * q;
    let k = if rates.separatrix { 1.0 } else { (body.A.0 * p / total).sqrt() };
    let parameter = if rates.separatrix { 0.0 } else { -c * body.S.0 / total };
    let of_c = c.sqrt();
    // dn, and sinh, cosine and dc of which all but the last are times one number: none needs a quotient that may be 0/0
    let dn = (p / b).sqrt() / rates.G.0;
    let along = (b.sqrt() * y).abs();
    let cosine = of_c * x.abs();
    let dc = of_c * z * (p / q).sqrt();
    // close to the unstable axis the hyperbolic sine and its square leave the range of numbers
    let huge = cosine + dc < HUGE_INVERSE * along;
    let (factor, sinh) = landen(k, dn, if huge { HUGE_SCALE * along } else { along }, cosine, dc);
    Amplitude { nome: parameter * both::nome_per_parameter(parameter, k), tangent: (q / p).sqrt() * factor, sinh, huge }
}

pub fn _of_huge(sinh: f64) -> Pair {
    let x = (2.0 * sinh).ln();
    (x, 0.5 * x.exp())
}

pub fn _of_ordinary(sinh: f64) -> Pair {
    let x = sinh.asinh();
    (x, x.sinh())
}

/// Return the amplitudes by elementary functions.
pub fn angles(at: &Amplitude) -> Angles {
    let (x, sinh) = if at.huge { _of_huge(at.sinh) } else { _of_ordinary(at.sinh) };
    Angles { x, sinh, y: at.tangent.atan() }
}

/// Return πK/K' = 2K/θ3², of √(BQ) and the mean.
pub fn half_period(fast: Pair, mean: Pair, nome: f64) -> Pair {
    both::by_theta(both::divide(both::multiply(fast, both::PI), mean), nome)
}

/// Return cos and sin of (2n+1)(y/2 − π/4), n from 0 to 4, for 0 ≤ y ≤ π/2.
pub fn harmonics(y: f64) -> Ten {
    let angle = (0.5 * y - 0.25 * std::f64::consts::PI) * (0.5 / std::f64::consts::PI);
    let (s0, c0) = both::sine_cosine(angle);
    let (s1, c1) = both::sine_cosine(3.0 * angle);
    let (s2, c2) = both::sine_cosine(5.0 * angle - both::whole(5.0 * angle));
    let (s3, c3) = both::sine_cosine(7.0 * angle - both::whole(7.0 * angle));
    let (s4, c4) = both::sine_cosine(9.0 * angle - both::whole(9.0 * angle));
    (c0, c1, c2, c3, c4, s0, s1, s2, s3, s4)
}

/// Return start, harmonics, nome and parity of the complementary form, separatrix included.
pub fn complementary_arguments(body: &Reduction, rates: &Frequencies, at: &Amplitude, angle: &Angles) -> Arguments {
    let (l1, l2, _) = body.canonical;
    let slope = if at.huge { angle.sinh } else { (1.0 + angle.sinh * angle.sinh).sqrt() };
    let x = both::fast_two_sum(angle.x, (at.sinh - angle.sinh) / slope);
    let x = if at.huge { both::add(x, LOG_OF_SCALE) } else { x };
    let x = both::scale(x, if (l2 < 0.0) == (l1 < 0.0) { 1.0 } else { -1.0 });
    let period = half_period(rates.modulus_rate, rates.mean, at.nome);
    let period = if rates.separatrix { (1.0, 0.0) } else { period };
    let (upper, lower) = both::halves(period.0);
    let periodic = if rates.separatrix { 0.0 } else { 1.0 };
    Arguments {
        start: both::divide(x, period),
        series: harmonics(angle.y),
        nome: (at.nome.sqrt(), upper, lower + period.1, periodic * angle.y * (0.5 / std::f64::consts::PI), periodic),
        parity: if l1 < 0.0 { 1.0 } else { 0.0 },
    }
}

pub fn _complementary_arguments(given: &Given) -> Arguments {
    let at = amplitude(&given.body, &given.rates);
    complementary_arguments(&given.body, &given.rates, &at, &angles(&at))
}

/// Return the product of quaternions.
pub fn _turned(given: Four, scalar: f64, x: f64, y: f64, z: f64) -> Four {
    let (a, b, c, d) = given;
    (
        a * scalar - b * x - c * y - d * z,
        a * x + b * scalar + c * z - d * y,
        a * y - b * z + c * scalar + d * x,
        a * z + b * y - c * x + d * scalar,
    )
}

/// Return the component along a given axis of a vector along axes of this order.
pub fn _on_axis(k: f64, order: Three, x: f64, y: f64, z: f64) -> f64 {
    if order.0 == k { x } else { if order.1 == k { y } else { z } }
}

pub fn _column(given: Four, order: Three, scalar: f64, x: f64, y: f64, z: f64) -> Four {
    _turned(given, scalar, _on_axis(0.0, order, x, y, z), _on_axis(1.0, order, x, y, z), _on_axis(2.0, order, x, y, z))
}

/// Return the signed permutation whose rows take canonical components to those along the given axes.
pub fn axes_of(body: &Reduction) -> ThreeThrees {
    let (i, j, k) = body.order;
    let middle = body.parity;
    let outer = body.parity * body.half_turn;
    (
        (if i == 0.0 { outer } else { 0.0 }, if j == 0.0 { middle } else { 0.0 }, if k == 0.0 { outer } else { 0.0 }),
        (if i == 1.0 { outer } else { 0.0 }, if j == 1.0 { middle } else { 0.0 }, if k == 1.0 { outer } else { 0.0 }),
        (if i == 2.0 { outer } else { 0.0 }, if j == 2.0 { middle } else { 0.0 }, if k == 2.0 { outer } else { 0.0 }),
    )
}

/// Return by rows the matrices from spinor to attitude and from canonical direction to momentum.
///
/// Args:
///     body: the reduction.
///     g: |L|.
///     attitude: at the epoch.
///     spinor: likewise.
pub fn matrices(body: &Reduction, g: f64, attitude: Four, spinor: Four) -> (Sixteen, Nine) {
    let (a0, a1, b0, b1) = spinor;
    let norm = (a0 * a0 + a1 * a1 + (b0 * b0 + b1 * b1)).sqrt();
    let a0 = a0 / norm;
    let a1 = a1 / norm;
    let b0 = b0 / norm;
    let b1 = b1 / norm;
    // (start frame)* (present frame) is linear in the spinor (Re A, Im A, Re B, Im B); the mirror reverses its vector
    let h = if body.long_axis { -body.parity } else { body.parity };
    let order = body.order;
    let f = h * body.half_turn;
    let p = _column(attitude, order, a0, -f * b1, h * b0, -f * a1);
    let q = _column(attitude, order, a1, f * b0, h * b1, f * a0);
    let r = _column(attitude, order, b0, -f * a1, -h * a0, f * b1);
    let s = _column(attitude, order, b1, f * a0, -h * a1, -f * b0);
    let size = g * body.momentum_scale;
    let (first, second, third) = axes_of(body);
    (
        (p.0, q.0, r.0, s.0, p.1, q.1, r.1, s.1, p.2, q.2, r.2, s.2, p.3, q.3, r.3, s.3),
        (
            size * first.0,
            size * first.1,
            size * first.2,
            size * second.0,
            size * second.1,
            size * second.2,
            size * third.0,
            size * third.1,
            size * third.2,
        ),
    )
}

/// Return whether the motion takes the full form, m ≤ ½, if it has a period.
pub fn is_full(body: &Reduction) -> bool {
    body.A.0 * body.P.0 <= -body.C.0 * body.S.0
}

pub fn _full_spinor(m: &Motion) -> Four {
    let zero = 0.0 * m.start.0;
    full_sums(m, (zero, zero, zero))
}

pub fn _complementary_spinor(m: &Motion) -> Four {
    let zero = 0.0 * m.start.0;
    let (a, b, c, e, factor, other, other_factor) = complementary_phase(m, (zero, zero, zero));
    complementary_sums(m, a, b, c, e.exp() * factor, other.exp() * other_factor)
}

/// Return the motion of a body whose momentum moves.
pub fn _moving(given: &Given) -> Motion {
    let body = given.body;
    let rates = given.rates;
    let full = is_full(&body) && !rates.separatrix;
    let (first, second) = phase_rates(full, &body, &rates);
    let at = if full { _full_arguments(given) } else { _complementary_arguments(given) };
    let kind = if full { 1.0 } else { 0.0 };
    let m = Motion {
        full: kind,
        first,
        second,
        start: at.start,
        series: at.series,
        nome: at.nome,
        parity: at.parity,
        to_attitude: SIXTEEN_ZEROS,
        to_momentum: NINE_ZEROS,
    };
    let spinor = if full { _full_spinor(&m) } else { _complementary_spinor(&m) };
    let (to_attitude, to_momentum) = matrices(&body, rates.G.0, given.attitude, spinor);
    Motion {
        full: kind,
        first,
        second,
        start: at.start,
        series: at.series,
        nome: at.nome,
        parity: at.parity,
        to_attitude,
        to_momentum,
    }
}

/// Return |Ω|/4π, the rate of half the angle of a permanent rotation, in turns.
pub fn _permanent_rate(body: &Reduction) -> Three {
    let (i1, i2, i3) = body.moments;
    let (x, y, z) = body.momentum;
    let none = 0.0 * body.root_P;
    let u = both::divide((x, none), (i1, none));
    let v = both::divide((y, none), (i2, none));
    let w = both::divide((z, none), (i3, none));
    let size = both::root_or_zero(both::add(both::add(both::square(u), both::square(v)), both::square(w)));
    let rate = both::scale(both::scale(both::multiply(size, both::INVERSE_TWO_PI), 0.5), body.rate_scale);
    let (high, low) = both::halves(rate.0);
    (high, low, rate.1)
}

/// Return the direction of Ω along the given axes, zero at rest.
pub fn _rotation_axis(moments: Three, momentum: Three) -> Three {
    let (i1, i2, i3) = moments;
    let (x, y, z) = momentum;
    let largest = larger(larger(x.abs(), y.abs()), z.abs());
    let largest = if largest > 0.0 { largest } else { 1.0 };
    let least = smaller(smaller(i1, i2), i3);
    let x = x / largest * (least / i1);
    let y = y / largest * (least / i2);
    let z = z / largest * (least / i3);
    let size = (x * x + y * y + z * z).sqrt();
    let size = if size > 0.0 { size } else { 1.0 };
    (x / size, y / size, z / size)
}

/// Return the motion of a body at rest, of a sphere, or in permanent rotation: (A, B) turns, and L stays.
pub fn _permanent(given: &Given) -> Motion {
    let zero = 0.0 * given.body.root_P;
    let one = zero + 1.0;
    let (x, y, z) = _rotation_axis(given.moments, given.momentum);
    let p = _turned(given.attitude, 1.0, zero, zero, zero);
    let q = _turned(given.attitude, 0.0, x, y, z);
    let (l1, l2, l3) = given.momentum;
    Motion {
        full: one,
        first: _permanent_rate(&given.body),
        second: (zero, zero, zero),
        start: (zero, zero),
        series: (one, zero, zero, zero, zero, zero, zero, zero, zero, zero),
        nome: (zero, zero, zero, zero, zero),
        parity: zero,
        to_attitude: (p.0, q.0, zero, zero, p.1, q.1, zero, zero, p.2, q.2, zero, zero, p.3, q.3, zero, zero),
        to_momentum: (zero, zero, l1, zero, zero, l2, zero, zero, l3),
    }
}

/// Return the constants of motion of a body.
pub fn motion_of(given: &Given) -> Motion {
    if given.rates.constant { _permanent(given) } else { _moving(given) }
}
