// SPDX-License-Identifier: MIT
//! Words of the formulas that a number's methods do not have, or have only since newer versions of Rust.

use crate::both::{two_product, two_sum};

const SUBNORMAL: f64 = 18014398509481984.0; // 2^54, which makes every number a normal one
const LARGEST_POWER: f64 = 8.98846567431158e307; // 2^1023
const SMALLEST_POWER: f64 = 2.004168360008973e-292; // 2^-969, 53 places above the smallest: what follows rounds once

/// Return e with ½ ≤ |x|/2^e < 1, and 0 for x = 0.
pub fn binary_exponent(x: f64) -> f64 {
    if x == 0.0 || !x.is_finite() {
        return 0.0;
    }
    match (x.to_bits() >> 52) & 2047 {
        0 => binary_exponent(x * SUBNORMAL) - 54.0,
        e => e as f64 - 1022.0,
    }
}

/// Return 2ⁿ x, for a whole number n.
pub fn times_power(mut x: f64, n: f64) -> f64 {
    let mut left = n.clamp(-4000.0, 4000.0) as i64;
    while left > 1023 {
        x *= LARGEST_POWER;
        left -= 1023;
    }
    while left < -1022 {
        x *= SMALLEST_POWER;
        left += 969;
    }
    x * f64::from_bits(((left + 1023) as u64) << 52)
}

/// Return the nearest whole number, the even one of two.
pub fn nearest(x: f64) -> f64 {
    const LEAST_WHOLE: f64 = 4503599627370496.0; // 2^52, from which on all numbers are whole
    if x.abs() < LEAST_WHOLE {
        ((x.abs() + LEAST_WHOLE) - LEAST_WHOLE).copysign(x)
    } else {
        x
    }
}

/// Return the larger of two numbers, the second where they are not in order.
pub fn larger(x: f64, y: f64) -> f64 {
    if x > y {
        x
    } else {
        y
    }
}

/// Return the smaller of two numbers, the second where they are not in order.
pub fn smaller(x: f64, y: f64) -> f64 {
    if x < y {
        x
    } else {
        y
    }
}

/// An unevaluated sum of floats, exact. Shewchuk 1997.
#[derive(Clone, Copy)]
pub struct Sum {
    count: usize,
    term: [f64; MOST_TERMS],
}

const MOST_TERMS: usize = 64;
const SWEEPS: usize = 5; // after which the last term and the others have all digits of a sum

/// Return a pair as a sum of two terms.
pub fn as_sum(x: (f64, f64)) -> Sum {
    let mut sum = Sum { count: 2, term: [0.0; MOST_TERMS] };
    (sum.term[0], sum.term[1]) = x;
    sum
}

/// Return x + y, with the terms of both.
pub fn join(mut x: Sum, y: Sum) -> Sum {
    let count = x.count + y.count;
    x.term[x.count..count].copy_from_slice(&y.term[..y.count]);
    Sum { count, ..x }
}

/// Return −x.
pub fn negated(x: Sum) -> Sum {
    Sum { term: x.term.map(|term| -term), ..x }
}

/// Return the exact product with a float, with twice as many terms.
pub fn multiply_terms(x: Sum, factor: f64) -> Sum {
    let mut product = Sum { count: 2 * x.count, ..x };
    for k in 0..x.count {
        (product.term[2 * k], product.term[2 * k + 1]) = two_product(x.term[k], factor);
    }
    product
}

/// Move the leading parts to the end; the sum stays exactly what it was. Ogita, Rump & Oishi 2005.
fn swept(mut x: Sum, times: usize) -> Sum {
    for _ in 0..times {
        for k in 1..x.count {
            (x.term[k], x.term[k - 1]) = two_sum(x.term[k - 1], x.term[k]);
        }
    }
    x
}

/// Return the sum as one of `count` terms at most, largest last, correct to 2^(-53 count) of its size.
pub fn compress(x: Sum, count: usize) -> Sum {
    if x.count <= count {
        return x;
    }
    let mut x = swept(x, count + 1);
    x.term.copy_within(x.count - count..x.count, 0);
    Sum { count, ..x }
}

/// Return the sum to double-double accuracy, whatever cancels, up to 2^-265.
pub fn distil(x: Sum) -> (f64, f64) {
    let x = swept(x, SWEEPS);
    let last = x.count - 1;
    two_sum(x.term[last], x.term[1..last].iter().fold(x.term[0], |rest, term| rest + term))
}
