//! A judge of positions that knows nothing of what it judges: loop equations as they are written by hand, followed through the turn by Newton's
//! method in steps that a change of the solution keeps short.

use linkage::nalgebra::{Const, DimMin, SMatrix, SVector, ToTypenum};
use std::f64::consts::TAU;

/// Positions of a turn that are compared, the last one that of the first.
pub(crate) const POSITIONS: usize = 720;

/// Unknowns change by less in a step, rad; where they change faster it becomes shorter.
const STEP: f64 = 0.02;
/// A step that is shorter goes nowhere: the mechanism stands at a dead point.
const LEAST: f64 = 1e-9;
/// Differences for derivatives, rad.
const DIFFERENCE: f64 = 1e-6;

/// Inputs of the positions.
pub(crate) fn inputs() -> Vec<f64> {
    let share = |i| i as f64 / POSITIONS as f64;
    (0..=POSITIONS).map(|i| TAU * share(i)).collect()
}

/// Whether angles, of which those at all [`inputs`] are given, are one solution of these equations that comes back to its beginning without
/// a dead point; else where it is not.
pub(crate) fn follows<const U: usize>(
    equations: impl Fn(f64, &[f64; U]) -> [f64; U],
    angles: &[[f64; U]],
) -> Result<(), String>
where
    Const<U>: DimMin<Const<U>, Output = Const<U>> + ToTypenum,
{
    let slopes = |x: f64, at: &[f64; U]| {
        let mut matrix = SMatrix::<f64, U, U>::zeros();
        for k in 0..U {
            let moved = |by: f64| {
                let mut moved = *at;
                moved[k] += by;
                SVector::from(equations(x, &moved))
            };
            let column = (moved(DIFFERENCE) - moved(-DIFFERENCE)) / (2.0 * DIFFERENCE);
            matrix.set_column(k, &column);
        }
        matrix
    };
    // The solution near a place, and the determinant there.
    let settled = |x: f64, mut at: [f64; U]| {
        let mut way = 0.0;
        for _ in 0..12 {
            let matrix = slopes(x, &at);
            let step = matrix.lu().solve(&SVector::from(equations(x, &at)))?;
            at.iter_mut()
                .zip(step.iter())
                .for_each(|(at, step)| *at -= step);
            way += step.norm();
            if way > STEP || !way.is_finite() {
                return None;
            }
            if step.norm() < 1e-11 {
                return Some((at, slopes(x, &at).determinant()));
            }
        }
        None
    };
    let apart = |a: &[f64; U], b: &[f64; U]| {
        let pairs = a.iter().zip(b).map(|(a, b)| (0.5 * (a - b)).sin().abs());
        pairs.fold(0.0, f64::max)
    };
    let mut x = 0.0;
    let (mut at, sign) = settled(x, angles[0]).ok_or("its first position is none")?;
    let mut length = TAU / POSITIONS as f64;
    for (index, (there, own)) in inputs().into_iter().zip(angles).enumerate() {
        while x < there {
            let step = length.min(there - x);
            let next = settled(x + step, at).filter(|(next, determinant)| {
                let way = next.iter().zip(&at).map(|(a, b)| (a - b).abs());
                way.fold(0.0, f64::max) < STEP && determinant * sign > 0.0
            });
            match next {
                Some((next, _)) => {
                    x = if step < there - x { x + step } else { there };
                    at = next;
                    length = (1.5 * length).min(TAU / POSITIONS as f64);
                }
                None => length = 0.5 * step,
            }
            if length < LEAST {
                return Err(format!("it stops at {x}"));
            }
        }
        if apart(&at, own) > 1e-7 {
            return Err(format!(
                "position {index} is of another assembly: {at:?}, {own:?}"
            ));
        }
    }
    match apart(&angles[0], &at) < 1e-7 {
        true => Ok(()),
        false => Err("it does not come back".to_string()),
    }
}

/// It refuses what is none: a four-bar that stops, one that jumps, one that is another after a turn.
#[test]
fn the_judge_refuses() {
    let four_bar = |crank: f64| {
        move |phi: f64, [theta, psi]: &[f64; 2]| {
            let x = crank * phi.cos() + 120.0 * theta.cos() - 140.0 - 100.0 * psi.cos();
            let y = crank * phi.sin() + 120.0 * theta.sin() - 100.0 * psi.sin();
            [x, y]
        }
    };
    // By the diagonal from the crank's end to the other pivot.
    let closed = |crank: f64, sign: f64| {
        let angles = inputs().into_iter().map(|phi| {
            let (x, y) = (140.0 - crank * phi.cos(), -crank * phi.sin());
            let d = x.hypot(y);
            let at_a = ((d * d + 120.0_f64.powi(2) - 100.0_f64.powi(2)) / (240.0 * d)).acos();
            let theta = y.atan2(x) + sign * at_a;
            let (bx, by) = (120.0 * theta.cos() - x, 120.0 * theta.sin() - y);
            [theta, by.atan2(bx)]
        });
        angles.collect::<Vec<_>>()
    };
    let good = closed(50.0, 1.0);
    assert_eq!(follows(four_bar(50.0), &good), Ok(()));
    let mut jumping = good.clone();
    jumping[400..].copy_from_slice(&closed(50.0, -1.0)[400..]);
    let told = follows(four_bar(50.0), &jumping).expect_err("it jumps");
    assert!(told.starts_with("position 400"), "{told}");
    let told = follows(four_bar(90.0), &closed(90.0, 1.0)).expect_err("it stops");
    assert!(told.starts_with("it stops"), "{told}");
    let half = |phi: f64, [angle]: &[f64; 1]| [(angle - 0.5 * phi).sin()];
    let angles: Vec<[f64; 1]> = inputs().into_iter().map(|phi| [0.5 * phi]).collect();
    assert_eq!(
        follows(half, &angles),
        Err("it does not come back".to_string())
    );
}
