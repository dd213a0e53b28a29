// Answers cases of reference/rust, as run_polhode.c does those of polhode.h, but for floats that are given by their bits:
// each line in has kind (1 for a top), count of times, moments, momentum, attitude, epoch, mgl of a top, times.
use std::io::{stdin, stdout, BufRead, BufWriter, Write};

use polhode::{Error, FreeBody, LagrangeTop, State};

enum Motion {
    Free(FreeBody),
    Top(LagrangeTop),
}

const CODES: [Error; 7] = [
    Error::Moments,
    Error::Momentum,
    Error::Attitude,
    Error::Epoch,
    Error::Mgl,
    Error::Time,
    Error::OutOfRange,
];

fn code(error: Error) -> usize {
    1 + CODES.iter().position(|x| *x == error).unwrap()
}

impl Motion {
    fn new(is_top: bool, x: &[f64]) -> Result<Motion, Error> {
        let (moments, momentum) = ([x[0], x[1], x[2]], [x[3], x[4], x[5]]);
        let attitude = [x[6], x[7], x[8], x[9]];
        Ok(if is_top {
            Motion::Top(LagrangeTop::new(moments, x[11], momentum, attitude, x[10])?)
        } else {
            Motion::Free(FreeBody::new(moments, momentum, attitude, x[10])?)
        })
    }

    fn numbers(&self) -> (usize, [f64; 8]) {
        match self {
            Motion::Free(m) => (
                m.regime as usize,
                [
                    m.energy,
                    m.momentum_norm,
                    m.encircled_axis.map_or(-1.0, |k| k as f64),
                    m.modulus,
                    m.period,
                    m.precession_rate,
                    m.precession_per_period,
                    m.flip_interval,
                ],
            ),
            Motion::Top(m) => (
                m.regime as usize,
                [
                    m.energy,
                    m.lowest,
                    m.highest,
                    m.nutation_period,
                    m.precession_per_period,
                    m.spin_per_period,
                    0.0,
                    0.0,
                ],
            ),
        }
    }

    fn state(&self, t: f64) -> Result<State, Error> {
        match self {
            Motion::Free(m) => m.state(t),
            Motion::Top(m) => m.state(t),
        }
    }
}

fn main() {
    let mut out = BufWriter::new(stdout());
    for line in stdin().lock().lines() {
        let line = line.unwrap();
        let words: Vec<&str> = line.split_whitespace().collect();
        let given: Vec<f64> =
            words[2..].iter().map(|x| f64::from_bits(u64::from_str_radix(x, 16).unwrap())).collect();
        let motion = Motion::new(words[0] == "1", &given);
        let (regime, numbers) = motion.as_ref().map_or((0, [0.0; 8]), |m| m.numbers());
        write!(out, "{} {}", motion.as_ref().err().map_or(0, |e| code(*e)), regime).unwrap();
        let mut print = |x: f64| write!(out, " {:016x}", x.to_bits()).unwrap();
        numbers.into_iter().for_each(&mut print);
        for t in &given[12..] {
            let state = motion.as_ref().map_err(|e| *e).and_then(|m| m.state(*t));
            let late = if motion.is_ok() { state.err().map_or(0, code) } else { 0 };
            print(late as f64);
            let state = state.unwrap_or(State { attitude: [0.0; 4], momentum: [0.0; 3] });
            state.attitude.into_iter().chain(state.momentum).for_each(&mut print);
        }
        writeln!(out).unwrap();
    }
}
