// SPDX-License-Identifier: MIT
//! Words of the formulas that a number's methods do not have, or have only since newer versions of Rust.

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
