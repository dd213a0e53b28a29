// What both motions keep, and what is refused; tests/twins of the repository compares states with exact ones.
use polhode::{Error, FreeBody, FreeRegime, LagrangeTop, TopRegime};

const IDENTITY: [f64; 4] = [1.0, 0.0, 0.0, 0.0];
const MOMENTS: [f64; 3] = [1.0, 2.0, 3.0];
const MOMENTUM: [f64; 3] = [0.3, 1.8, 1.5];
const LEANING: [f64; 4] = [0.8, 0.6, 0.0, 0.0];
const ROUNDING: f64 = 1e-14;

fn turned(q: [f64; 4], v: [f64; 3]) -> [f64; 3] {
    let [w, x, y, z] = q;
    let t = [2.0 * (y * v[2] - z * v[1]), 2.0 * (z * v[0] - x * v[2]), 2.0 * (x * v[1] - y * v[0])];
    [
        v[0] + w * t[0] + (y * t[2] - z * t[1]),
        v[1] + w * t[1] + (z * t[0] - x * t[2]),
        v[2] + w * t[2] + (x * t[1] - y * t[0]),
    ]
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
}

#[test]
fn a_free_body_keeps_its_momentum_in_space() {
    let body = FreeBody::new(MOMENTS, MOMENTUM, IDENTITY, 0.0).unwrap();
    assert_eq!((body.regime, body.encircled_axis), (FreeRegime::ShortAxis, Some(2)));
    for t in [0.0, 1.7, -23.0, 1e9] {
        let state = body.state(t).unwrap();
        assert!(distance(&turned(state.attitude, state.momentum), &MOMENTUM) < ROUNDING);
    }
}

#[test]
fn a_motion_begins_as_it_is_given() {
    let body = FreeBody::new(MOMENTS, MOMENTUM, LEANING, 7.0).unwrap().state(7.0).unwrap();
    let top = LagrangeTop::new([1.0, 1.0, 0.5], 1.0, MOMENTUM, LEANING, 7.0).unwrap().state(7.0).unwrap();
    for state in [body, top] {
        assert!(distance(&state.attitude, &LEANING) < ROUNDING);
        assert!(distance(&state.momentum, &MOMENTUM) < ROUNDING);
    }
}

#[test]
fn after_a_period_the_momentum_is_back() {
    let body = FreeBody::new(MOMENTS, MOMENTUM, IDENTITY, 0.0).unwrap();
    assert!(distance(&body.state(body.period).unwrap().momentum, &MOMENTUM) < ROUNDING);
}

#[test]
fn a_top_with_a_cusp_comes_to_rest_at_its_highest() {
    let top = LagrangeTop::new([1.0, 1.0, 0.5], 1.0, [0.0, 0.0, 2.5], LEANING, 0.0).unwrap();
    assert_eq!(top.regime, TopRegime::Cusp);
    let state = top.state(top.nutation_period).unwrap();
    assert!(distance(&state.momentum, &[0.0, 0.0, 2.5]) < 10.0 * ROUNDING);
    let [w, x, y, z] = state.attitude;
    assert!((w * w + z * z - (x * x + y * y) - top.highest).abs() < ROUNDING);
}

#[test]
fn what_cannot_be_is_refused() {
    let body = |moments, momentum, attitude, epoch| FreeBody::new(moments, momentum, attitude, epoch).map(|_| ());
    assert_eq!(body([1.0, 2.0, 0.0], MOMENTUM, IDENTITY, 0.0), Err(Error::Moments));
    assert_eq!(body(MOMENTS, [f64::NAN, 0.0, 0.0], IDENTITY, 0.0), Err(Error::Momentum));
    assert_eq!(body(MOMENTS, MOMENTUM, [1.0, 1.0, 0.0, 0.0], 0.0), Err(Error::Attitude));
    assert_eq!(body(MOMENTS, MOMENTUM, IDENTITY, f64::INFINITY), Err(Error::Epoch));
    let top = |moments, mgl| LagrangeTop::new(moments, mgl, MOMENTUM, IDENTITY, 0.0).map(|_| ());
    assert_eq!(top(MOMENTS, 1.0), Err(Error::Moments));
    assert_eq!(top([1.0, 1.0, 2.0], f64::NAN), Err(Error::Mgl));
    let motion = FreeBody::new(MOMENTS, MOMENTUM, IDENTITY, 0.0).unwrap();
    assert_eq!(motion.state(1e30), Err(Error::Time));
    assert_eq!(motion.state(f64::NAN), Err(Error::Time));
    assert!(Error::Time.to_string().contains("at most 1e27 rad"));
}
