// SPDX-License-Identifier: MIT
//! The invariants of a top, summed exactly: near the separatrix c, F and D vanish together, and what is left of them
//! decides. polhode's `lagrange_top/_reduction.py` tells how.

use crate::both::{divide, scale, two_product, two_sum};
use crate::lagrange_top::Reduction;
use crate::words::{binary_exponent, times_power};

type Pair = (f64, f64);
/// An unevaluated sum, exact. Shewchuk 1997.
type Sum = Vec<f64>;

const TINY: f64 = -200.0; // binary exponents: of a displacement that is scaled up, and of what it becomes
const LIFTED: f64 = -150.0;

fn of(x: Pair) -> Sum {
    vec![x.0, x.1]
}

fn times(x: &[f64], factor: f64) -> Sum {
    x.iter().flat_map(|term| of(two_product(*term, factor))).collect()
}

fn product(x: &[f64], y: &[f64]) -> Sum {
    y.iter().flat_map(|factor| times(x, *factor)).collect()
}

fn scaled(x: &[f64], power_of_two: f64) -> Sum {
    x.iter().map(|term| term * power_of_two).collect()
}

fn joined(x: Sum, y: Sum) -> Sum {
    x.into_iter().chain(y).collect()
}

/// Move the leading part to the end; the sum stays exactly what it was. Ogita, Rump & Oishi 2005.
fn sweep(x: &mut [f64]) {
    for k in 1..x.len() {
        let (sum, error) = two_sum(x[k - 1], x[k]);
        x[k - 1] = error;
        x[k] = sum;
    }
}

/// Return the sum to double-double accuracy, whatever cancels, up to 2^-265.
fn distilled(mut x: Sum) -> Pair {
    (0..5).for_each(|_| sweep(&mut x));
    let last = x.len() - 1;
    two_sum(x[last], x[1..last].iter().fold(x[0], |rest, term| rest + term))
}

/// Return the sum as one of `count` floats, largest last, correct to 2^(-53 count) of its size.
fn compressed(mut x: Sum, count: usize) -> Sum {
    if x.len() > count {
        (0..=count).for_each(|_| sweep(&mut x));
        x.drain(..x.len() - count);
    }
    x
}

fn two_products(a: f64, b: f64, c: f64, d: f64) -> Sum {
    joined(of(two_product(a, b)), of(two_product(c, d)))
}

fn squares(x: f64, y: f64) -> Sum {
    two_products(x, x, y, y)
}

/// Scale a tiny displacement from the vertical up; exactly at the threshold of sleeping, where it grows like t, drop it.
fn lift(g: Pair, momentum: &mut [f64; 3], q: &mut [f64; 4]) -> f64 {
    let [w, x, y, z] = *q;
    let (cosine, sine) = (w.abs().max(z.abs()), x.abs().max(y.abs()));
    let displacement = cosine.min(sine).max(momentum[0].abs()).max(momentum[1].abs());
    let (upright, exponent) = (cosine >= sine, binary_exponent(displacement));
    if !(displacement > 0.0 && exponent < TINY && g.0 > 0.0) {
        return 0.0;
    }
    let is_threshold = upright && scale(g, 2.0) == two_product(momentum[2], momentum[2]);
    let (lift, kept) = if is_threshold { (0.0, 0.0) } else { (LIFTED - exponent, 1.0) };
    let up = |value: f64| kept * times_power(value, lift);
    let (first, second) = if upright { (1, 2) } else { (0, 3) };
    *momentum = [up(momentum[0]), up(momentum[1]), momentum[2]];
    q[first] = up(q[first]);
    q[second] = up(q[second]);
    lift
}

/// Return the reduction of a top.
pub fn reduced(moments: [f64; 3], mgl: f64, momentum: [f64; 3], q: [f64; 4]) -> Reduction {
    let [w, x, y, z] = q;
    let (reversed, weight, of_moment) = (mgl < 0.0, mgl.abs(), binary_exponent(moments[0]));
    // a centre of mass below is one above on the reversed axis: a half turn about the first body axis
    let mut q = if reversed { [-x, w, z, -y] } else { q };
    let side = if reversed { -1.0 } else { 1.0 };
    let largest = momentum.iter().fold(0.0, |size: f64, l| size.max(l.abs()));
    let mut of_momentum = binary_exponent(largest);
    if weight > 0.0 {
        // the larger of |L| and √(mgl I1), without forming a product that may overflow
        let half = (0.5 * (of_moment + binary_exponent(weight) + 1.0)).floor();
        of_momentum = if largest > 0.0 { of_momentum.max(half) } else { half };
    }
    let down = |value: f64| times_power(value, -of_momentum);
    let (i1, i3) = (times_power(moments[0], -of_moment), times_power(moments[2], -of_moment));
    let mut l = [down(momentum[0]), down(side * momentum[1]), down(side * momentum[2])];
    let scaled_weight = down(times_power(weight, of_moment - of_momentum));
    let g = scale(two_product(scaled_weight, i1), 2.0);
    let size = compressed(joined(squares(q[1], q[2]), squares(q[0], q[3])), 4);
    let lift = lift(g, &mut l, &mut q);
    Reduction {
        moments: (i1, i3),
        momentum: (l[0], l[1], l[2]),
        quaternion: (q[0], q[1], q[2], q[3]),
        reversed,
        lift,
        momentum_scale: times_power(1.0, of_momentum),
        rate_scale: times_power(1.0, of_momentum - of_moment),
        ..invariants(g, &size, l, q)
    }
}

/// Return the polynomials of the given numbers over |q|²; `size` is |q|² of the quaternion as given, for as a pair it would
/// leave F of a planar top only 32 digits of what cancels.
fn invariants(g: Pair, size: &[f64], l: [f64; 3], q: [f64; 4]) -> Reduction {
    let [w, x, y, z] = q;
    let [l1, l2, l3] = l;
    let (s, t) = (squares(x, y), squares(w, z));
    let (real, imaginary) = (two_products(x, w, y, z), two_products(x, z, -y, w));
    let in_phase = compressed(joined(times(&real, l1), times(&imaginary, -l2)), 4);
    let twist = compressed(scaled(&joined(times(&real, l2), times(&imaginary, l1)), 2.0), 4);
    let c = compressed(joined(twist.clone(), times(&s, -2.0 * l3)), 4);
    let c_plus = compressed(joined(twist.clone(), times(&t, 2.0 * l3)), 4);
    let w2 = squares(l1, l2);
    let fall = scaled(&product(&of(g), &s), -2.0);
    let energy = compressed(joined(product(size, &w2), fall), 5);
    let f = compressed(joined(energy.clone(), times(&c, -l3)), 5);
    let rest = joined(of(scale(g, 2.0)), of(two_product(l3, -l3)));
    let d = compressed(joined(product(size, &rest), scaled(&energy, -1.0)), 5);
    let lean = compressed(joined(times(&energy, l3), scaled(&product(&of(g), &c), -1.0)), 6);
    let n = distilled(size.to_vec());
    let over = |sum: &Sum| divide(distilled(sum.clone()), n);
    Reduction {
        moments: (0.0, 0.0),
        momentum: (0.0, 0.0, 0.0),
        quaternion: (0.0, 0.0, 0.0, 0.0),
        reversed: false,
        lift: 0.0,
        momentum_scale: 0.0,
        rate_scale: 0.0,
        size: n,
        G: g,
        s0: scale(over(&s), 2.0),
        t0: scale(over(&t), 2.0),
        u0: over(&joined(t.clone(), scaled(&s, -1.0))),
        p: scale(over(&in_phase), -2.0),
        c: over(&c),
        c_plus: over(&c_plus),
        twist: over(&twist),
        F: over(&f),
        D: over(&d),
        w2: distilled(w2),
        lean: over(&lean),
    }
}
