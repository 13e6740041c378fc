//! The flywheel for a wished degree of unevenness.

use crate::equations_of_motion::Reduced;
use crate::machine::Machine;
use crate::steady::{NotSteady, SteadyState, steady_state};

/// Steps of the secant method.
const SECANT_STEPS: usize = 50;

/// A flywheel on the shaft of the input.
#[derive(Clone, Debug)]
pub struct Flywheel {
    /// Moment of inertia, in moments times s^2: with `unit mm` in N*mm*s^2, which are 1000 kg*mm^2.
    pub inertia: f64,
    /// The steady state with the flywheel.
    pub steady_state: SteadyState,
}

/// Finds the smallest flywheel with which the degree of unevenness is at most a wished one.
///
/// The inverse of the unevenness is nearly linear in the inertia. The secant method starts with
/// that line.
///
/// # Errors
///
/// [`NotSteady`] as for [`steady_state`], or if the steps end elsewhere.
pub fn flywheel<F>(machine: &Machine<F>, wished: f64, near: f64) -> Result<Flywheel, NotSteady>
where
    F: Fn(f64, f64) -> Reduced,
{
    if !(wished > 0.0 && wished.is_finite()) {
        return Err(NotSteady::NotPositive(wished));
    }
    let with = |inertia: f64, near: f64| {
        let equation = |input: f64, omega: f64| {
            let Reduced {
                inertia: [[alone]],
                force,
            } = (machine.equation)(input, omega);
            Reduced {
                inertia: [[alone + inertia]],
                force,
            }
        };
        let Machine {
            start,
            period,
            tolerance,
            ..
        } = *machine;
        let machine = Machine {
            equation,
            start,
            period,
            tolerance,
        };
        steady_state(&machine, near)
    };
    let found = with(0.0, near)?;
    let mut unevenness = found.unevenness();
    if unevenness <= wished {
        return Ok(Flywheel {
            inertia: 0.0,
            steady_state: found,
        });
    }
    let near = found.mean_speed();
    let alone = (machine.equation)(found.slowest().0, near).inertia[0][0];
    let excess = |unevenness: f64| wished / unevenness - 1.0;
    let mut before = (0.0, excess(unevenness));
    let mut inertia = alone * (unevenness / wished - 1.0);
    for _ in 0..SECANT_STEPS {
        let found = with(inertia, near)?;
        unevenness = found.unevenness();
        let off = excess(unevenness);
        if off.abs() <= machine.tolerance.sqrt() * 1e-3 {
            return Ok(Flywheel {
                inertia,
                steady_state: found,
            });
        }
        let next = inertia - off * (inertia - before.0) / (off - before.1);
        before = (inertia, off);
        // Towards zero by a factor of ten at most.
        inertia = next.max(0.1 * inertia);
    }
    Err(NotSteady::NoFlywheel { wished, unevenness })
}
