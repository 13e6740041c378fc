use super::*;
use crate::numeric::continuation::Correction;
use crate::scalar::Enclosure;

/// A correction, and errors over boxes.
struct Group<C, R>(C, R);

impl<C: FnMut(&[f64], &mut [f64]) -> Step, R> Correction for Group<C, R> {
    fn correct(&mut self, x: &[f64], state: &mut [f64]) -> Step {
        (self.0)(x, state)
    }
}

impl<C, R> Residuals for Group<C, R>
where
    C: FnMut(&[f64], &mut [f64]) -> Step,
    R: FnMut(&[f64], &[Enclosure]) -> Vec<Enclosure>,
{
    fn residuals(&mut self, x: &[f64], state: &[Enclosure]) -> Vec<Enclosure> {
        (self.1)(x, state)
    }
}

fn number(x: f64) -> Enclosure {
    Enclosure::between(x, x)
}

/// Two links of length 1 from `(0, 0)` and `(d, 0)` meet: the angle of the first, and how far up
/// they meet.
fn triangle(x: &[f64], state: &mut [f64]) -> Step {
    let d = x[0];
    let length = (state[0] * state[0] + state[1] * state[1]).sqrt();
    let [cos, sin] = [state[0] / length, state[1] / length];
    // (cos - d)^2 + sin^2 = 1 and h = sin
    let miss = (cos - d).powi(2) + sin * sin - 1.0;
    let slope = 2.0 * d * sin;
    let turn = -miss / slope;
    let rise = sin + cos * turn - state[2];
    // To second order, as generated code turns.
    let versine = 0.5 * turn * turn;
    state[0] = cos - sin * turn - cos * versine;
    state[1] = sin + cos * turn - sin * versine;
    state[2] += rise;
    Step {
        size: (turn * turn + rise * rise).sqrt(),
        determinant: slope,
    }
}

/// Returns the closure error.
fn missed(x: &[f64], state: &[Enclosure]) -> Vec<Enclosure> {
    let [cos, sin, height] = [state[0], state[1], state[2]];
    let away = cos - number(x[0]);
    Vec::from([away * away + sin * sin - number(1.0), height - sin])
}

const VARIABLES: [Variable; 2] = [Variable::Unit, Variable::Length];

fn found(d: f64, angle: f64) -> Result<f64, Astray> {
    let (sin, cos) = angle.sin_cos();
    let mut group = Group(triangle, missed);
    let state = from_estimate(&mut group, &VARIABLES, &[d], &[cos, sin, 0.0])?;
    assert!((state[2] - state[1]).abs() < 1e-12);
    Ok(state[1].atan2(state[0]))
}

#[test]
fn a_rough_estimate_leads_to_the_assembly_on_its_side() {
    for angle in [0.1, 0.5, 1.0, 1.5, 2.5] {
        let above = found(1.2, angle).expect("it is found");
        assert!((above - 0.6_f64.acos()).abs() < 1e-12, "{angle}: {above}");
        let below = found(1.2, -angle).expect("it is found");
        assert!((below + 0.6_f64.acos()).abs() < 1e-12, "{angle}: {below}");
    }
}

#[test]
fn links_that_do_not_reach_each_other_end_at_a_dead_point() {
    let astray = found(2.1, 1.0).expect_err("nothing is there");
    let Astray::DeadPoint { left, at } = astray else {
        panic!("{astray:?}")
    };
    // At the estimate both links end at one place for d = 2 cos 1, and the dead point is met at d =
    // 2.
    let missed = |d: f64| 1.0 + d * d - 2.0 * d * 1.0_f64.cos() - 1.0;
    let ends = (missed(2.1) - (2.1_f64 * 2.1 - 2.0 * 2.1)) / missed(2.1);
    assert!((1.0 - left - ends).abs() < 0.02, "{left} {ends}");
    // Both links lie along the base.
    assert!(at[1].atan2(at[0]).abs() < 0.1, "{at:?}");
}

#[test]
fn an_estimate_without_a_value_is_no_dead_point() {
    let astray = found(f64::NAN, 1.0).expect_err("nothing is there");
    assert_eq!(astray, Astray::NoValue);
}

#[test]
fn what_is_not_proven_is_no_solution() {
    let off = |_: &[f64], state: &[Enclosure]| Vec::from([number(1e-3), state[2] - state[1]]);
    let (sin, cos) = 0.5_f64.sin_cos();
    let found = from_estimate(
        &mut Group(triangle, off),
        &VARIABLES,
        &[1.2],
        &[cos, sin, 0.0],
    );
    assert!(matches!(found, Err(Astray::Singular(_))), "{found:?}");
}

#[test]
fn a_solution_on_a_curve_of_solutions_is_refused_with_another_one() {
    // x^2 + y^2 = 1 twice, a little apart: the correction goes to the circle and stays where it
    // meets it.
    let circle = |_: &[f64], state: &mut [f64]| {
        let square = state[0] * state[0] + state[1] * state[1];
        let share = 0.5 * (1.0 - square) / square;
        let correction = [share * state[0], share * state[1]];
        state[0] += correction[0];
        state[1] += correction[1];
        Step {
            size: correction[0].hypot(correction[1]),
            determinant: 1e-17,
        }
    };
    let twice = |_: &[f64], state: &[Enclosure]| {
        let square = state[0] * state[0] + state[1] * state[1] - number(1.0);
        Vec::from([square, square])
    };
    let variables = [Variable::Length; 2];
    let astray = from_estimate(&mut Group(circle, twice), &variables, &[], &[0.6, 0.9]);
    let Err(Astray::Movable([a, b])) = astray else {
        panic!("{astray:?}")
    };
    for state in [&a, &b] {
        assert!((state[0].hypot(state[1]) - 1.0).abs() < 1e-12);
    }
    assert!((a[0] - b[0]).abs() > 1e-8);
}
