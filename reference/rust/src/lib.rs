// SPDX-License-Identifier: MIT
// Copyright (c) 2026 The polhode developers; the licence is the file LICENSE of the repository.
//! How rigid bodies rotate, exactly at any time: the free body and the Lagrange top. No dependencies.
//!
//! Quaternions `[w, x, y, z]` take body to space, momentum and moments are along the principal axes, everything is in SI
//! units. The modules beside this file are printed from the formulas of polhode in Python.
//!
//! ```
//! let body = polhode::FreeBody::new([1.0, 2.0, 3.0], [0.3, 1.8, 1.5], [1.0, 0.0, 0.0, 0.0], 0.0)?;
//! assert_eq!(format!("{:.10}", body.period), "10.6801200814");
//! let state = body.state(1e9)?;
//! assert_eq!(format!("{:.10}", state.momentum[0]), "0.0889905243");
//! # Ok::<(), polhode::Error>(())
//! ```
#![forbid(unsafe_code)]

use std::fmt;

#[rustfmt::skip]
mod both;
#[rustfmt::skip]
mod free_body;
#[rustfmt::skip]
mod lagrange_top;
mod words;

pub const VERSION: &str = "0.2.0";

/// Of a phase, which has 104 bits: beyond it hardly a digit is left.
const MOST_RADIANS: f64 = 1e27;
/// A quaternion further from unit length is taken for a mistake, not for rounding.
const UNIT_TOLERANCE: f64 = 1e-6;

/// What a motion cannot be made of, or asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Error {
    Moments,
    Momentum,
    Attitude,
    Epoch,
    Mgl,
    Time,
    OutOfRange,
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        f.write_str(match self {
            Error::Moments => {
                "moments must be three positive finite numbers [kg m2]; of a top the first two must be equal"
            }
            Error::Momentum => "momentum must be three finite numbers [kg m2/s]",
            Error::Attitude => "attitude must be a unit quaternion, scalar first: divide it by its norm",
            Error::Epoch => "epoch must be a finite number [s]",
            Error::Mgl => "mgl must be a finite number [N m]",
            Error::Time => {
                "time must be finite, and since the epoch, times the rate of rotation, at most 1e27 rad"
            }
            Error::OutOfRange => {
                "moments, momentum or their ratios leave the range of doubles: choose other units"
            }
        })
    }
}

impl std::error::Error for Error {}

/// Attitude, a quaternion `[w, x, y, z]`, and momentum along the body's axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State {
    pub attitude: [f64; 4],
    pub momentum: [f64; 3],
}

/// Numbers of a state as the formulas list them.
type Listed = (f64, f64, f64, f64, f64, f64, f64);

impl From<Listed> for State {
    fn from(s: Listed) -> State {
        State { attitude: [s.0, s.1, s.2, s.3], momentum: [s.4, s.5, s.6] }
    }
}

fn are_finite(values: &[f64]) -> bool {
    values.iter().all(|x| x.is_finite())
}

fn length(values: &[f64]) -> f64 {
    values.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Refuse what neither motion is made of.
fn checked(moments: &[f64; 3], momentum: &[f64; 3], attitude: &[f64; 4], epoch: f64) -> Result<(), Error> {
    if !moments.iter().all(|x| *x > 0.0 && x.is_finite()) {
        return Err(Error::Moments);
    }
    if !are_finite(momentum) {
        return Err(Error::Momentum);
    }
    if !((length(attitude) - 1.0).abs() < UNIT_TOLERANCE) {
        return Err(Error::Attitude);
    }
    if epoch.is_finite() {
        Ok(())
    } else {
        Err(Error::Epoch)
    }
}

fn fastest(moments: &[f64; 3], momentum: &[f64; 3]) -> f64 {
    (0..3).map(|k| (momentum[k] / moments[k]).abs()).fold(0.0, f64::max)
}

fn kinetic_energy(moments: &[f64; 3], momentum: &[f64; 3]) -> f64 {
    0.5 * (0..3).map(|k| momentum[k] / moments[k] * momentum[k]).sum::<f64>()
}

/// Return the time since the epoch, exactly, in two numbers; refuse times whose phases have hardly a digit left.
fn since(t: f64, epoch: f64, fastest: f64) -> Result<(f64, f64), Error> {
    let elapsed = both::two_sum(t, -epoch);
    if elapsed.0.abs() * fastest <= MOST_RADIANS {
        Ok(elapsed)
    } else {
        Err(Error::Time)
    }
}

/// How a free body moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FreeRegime {
    Rest,
    Spherical,
    Permanent,
    Symmetric,
    ShortAxis,
    LongAxis,
    Separatrix,
}

const FREE_REGIMES: [FreeRegime; 7] = [
    FreeRegime::Rest,
    FreeRegime::Spherical,
    FreeRegime::Permanent,
    FreeRegime::Symmetric,
    FreeRegime::ShortAxis,
    FreeRegime::LongAxis,
    FreeRegime::Separatrix,
];

/// Torque-free motion of a rigid body. What is infinite is `INFINITY`, what is undefined `NAN`.
#[derive(Clone, Copy)]
pub struct FreeBody {
    pub regime: FreeRegime,
    /// Index of the axis that the polhode goes round.
    pub encircled_axis: Option<usize>,
    /// [J]
    pub energy: f64,
    /// [kg m²/s]
    pub momentum_norm: f64,
    pub modulus: f64,
    /// After which the momentum is back along the body's axes [s].
    pub period: f64,
    /// Mean rate at which the encircled axis turns about the momentum [rad/s].
    pub precession_rate: f64,
    /// That times the period [rad].
    pub precession_per_period: f64,
    /// Half the period, undefined of a symmetric body [s].
    pub flip_interval: f64,
    /// Of the cap that the polhode cuts off about the encircled axis [sr].
    pub solid_angle: f64,
    epoch: f64,
    fastest: f64,
    motion: free_body::Motion,
}

impl FreeBody {
    /// Prepare a free body.
    ///
    /// * `moments`: principal moments [kg m²], in any order.
    /// * `momentum`: at the epoch, along the principal axes [kg m²/s].
    /// * `attitude`: unit quaternion at the epoch, body to space.
    /// * `epoch`: [s].
    pub fn new(moments: [f64; 3], momentum: [f64; 3], attitude: [f64; 4], epoch: f64) -> Result<FreeBody, Error> {
        checked(&moments, &momentum, &attitude, epoch)?;
        let size = length(&attitude);
        let [q0, q1, q2, q3] = attitude.map(|x| x / size);
        let ([i1, i2, i3], [x, y, z]) = (moments, momentum);
        let body = free_body::reduction((i1, i2, i3), (x, y, z));
        let rates = free_body::frequencies(&body);
        let numbers = free_body::numbers(&body, &rates);
        let motion = free_body::motion_of(&free_body::Given {
            moments: (i1, i2, i3),
            momentum: (x, y, z),
            attitude: (q0, q1, q2, q3),
            body,
            rates,
        });
        let regime = FREE_REGIMES[numbers.regime as usize];
        let fastest = fastest(&moments, &momentum);
        let (a, b, p, q) = (motion.first, motion.second, motion.to_momentum, motion.to_attitude);
        let sizes = [
            fastest, a.0, a.1, a.2, b.0, b.1, b.2, p.0, p.1, p.2, p.3, p.4, p.5, p.6, p.7, p.8, q.0, q.1, q.4, q.5, q.8,
            q.9, q.12, q.13,
        ];
        if !are_finite(&sizes) {
            return Err(Error::OutOfRange);
        }
        Ok(FreeBody {
            regime,
            encircled_axis: if numbers.encircled_axis < 0.0 { None } else { Some(numbers.encircled_axis as usize) },
            energy: kinetic_energy(&moments, &momentum),
            momentum_norm: rates.G.0 * body.momentum_scale,
            modulus: numbers.modulus,
            period: numbers.period,
            precession_rate: numbers.precession_rate,
            precession_per_period: numbers.precession_per_period,
            flip_interval: if regime == FreeRegime::Symmetric { f64::NAN } else { 0.5 * numbers.period },
            solid_angle: numbers.solid_angle,
            epoch,
            fastest,
            motion,
        })
    }

    /// Return attitude and momentum at a time [s].
    pub fn state(&self, t: f64) -> Result<State, Error> {
        let (elapsed, rest) = since(t, self.epoch, self.fastest)?;
        Ok(free_body::state_at(&self.motion, elapsed, rest).into())
    }
}

/// How a Lagrange top moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TopRegime {
    Rest,
    Sleeping,
    Hanging,
    Steady,
    Free,
    Planar,
    Undulating,
    Cusp,
    Loop,
    Separatrix,
}

const TOP_REGIMES: [TopRegime; 10] = [
    TopRegime::Rest,
    TopRegime::Sleeping,
    TopRegime::Hanging,
    TopRegime::Steady,
    TopRegime::Free,
    TopRegime::Planar,
    TopRegime::Undulating,
    TopRegime::Cusp,
    TopRegime::Loop,
    TopRegime::Separatrix,
];

/// Motion of a heavy symmetric top about a fixed point. What is infinite is `INFINITY`, what is undefined `NAN`.
#[derive(Clone, Copy)]
pub struct LagrangeTop {
    pub regime: TopRegime,
    /// Zero potential where the axis is level [J].
    pub energy: f64,
    /// Limits of the cosine of the tilt from the upward vertical.
    pub lowest: f64,
    pub highest: f64,
    /// Of a steady top that of its smallest nutations [s].
    pub nutation_period: f64,
    /// Azimuth gained by the axis in a period, unreduced [rad].
    pub precession_per_period: f64,
    /// The body's own turn in a period, unreduced [rad].
    pub spin_per_period: f64,
    epoch: f64,
    fastest: f64,
    motion: lagrange_top::Motion,
}

impl LagrangeTop {
    /// Prepare a Lagrange top; space z is up, the third axis is that of symmetry.
    ///
    /// * `moments`: I1, I1, I3 about the pivot [kg m²].
    /// * `mgl`: weight times the distance from the pivot to the centre of mass along the third axis, negative below [N m].
    /// * `momentum`: at the epoch, along the body's axes [kg m²/s].
    /// * `attitude`: unit quaternion at the epoch, body to space.
    /// * `epoch`: [s].
    pub fn new(
        moments: [f64; 3],
        mgl: f64,
        momentum: [f64; 3],
        attitude: [f64; 4],
        epoch: f64,
    ) -> Result<LagrangeTop, Error> {
        checked(&moments, &momentum, &attitude, epoch)?;
        if moments[0] != moments[1] {
            return Err(Error::Moments);
        }
        if !mgl.is_finite() {
            return Err(Error::Mgl);
        }
        let top = lagrange_top::reduction(moments.into(), mgl, momentum.into(), attitude.into());
        let points = lagrange_top::turning_points(&top);
        let rates = lagrange_top::frequencies(&top, &points);
        let integrals = lagrange_top::integrals_of(&top, &points, &rates);
        let at = lagrange_top::arguments(&top, &points, &rates, &integrals);
        let numbers = lagrange_top::numbers(&top, &points, &rates);
        let motion = lagrange_top::motion_of(&lagrange_top::Given { top, points, rates, at, axial: momentum[2] });
        let fastest = fastest(&moments, &momentum) + (mgl.abs() / moments[0]).sqrt();
        let (a, b, c, p) = (motion.first, motion.second, motion.third, motion.phases);
        let sizes = [
            fastest, a.0, a.1, a.2, b.0, b.1, b.2, c.0, c.1, c.2, p.0, p.1, p.2, p.3, motion.start.0, motion.rates.0,
            motion.rates.1,
        ];
        if !are_finite(&sizes) {
            return Err(Error::OutOfRange);
        }
        let [w, x, y, z] = attitude;
        let (up, down) = (w * w + z * z, x * x + y * y);
        Ok(LagrangeTop {
            regime: TOP_REGIMES[numbers.regime as usize],
            energy: kinetic_energy(&moments, &momentum) + mgl * (up - down) / (up + down),
            lowest: numbers.lowest,
            highest: numbers.highest,
            nutation_period: numbers.period,
            precession_per_period: numbers.precession_per_period,
            spin_per_period: numbers.spin_per_period,
            epoch,
            fastest,
            motion,
        })
    }

    /// Return attitude and momentum at a time [s].
    pub fn state(&self, t: f64) -> Result<State, Error> {
        let (elapsed, rest) = since(t, self.epoch, self.fastest)?;
        Ok(lagrange_top::state_at(&self.motion, elapsed, rest).into())
    }
}
