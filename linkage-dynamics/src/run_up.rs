//! Run-up of a machine with its motor, and braking to rest.

use crate::computed_motion::{Ended, Motion};
use crate::equations_of_motion::{FromReduced, Reduced};
use crate::error::Interrupted;
use crate::event::Event;
use crate::machine::Machine;
use crate::motion_problem::Problem;
use crate::motor::Motor;
use std::error::Error;
use std::fmt;

/// The run-up of a machine from rest.
#[derive(Clone, Debug)]
pub struct RunUp {
    /// Time until the speed is reached, s.
    pub time: f64,
    /// Angle that the input turns until then, rad.
    pub angle: f64,
    /// Work of the motor, in moments of the mechanism.
    pub work: f64,
    /// Energy that becomes heat in the motor, in moments of the mechanism.
    pub heat: f64,
    /// The motion.
    pub motion: Motion<1>,
}

/// The stop of a machine by a brake.
#[derive(Clone, Debug)]
pub struct Stop {
    /// Time until rest, s.
    pub time: f64,
    /// Input at rest, rad.
    pub input: f64,
    /// Angle that the input turns until then, rad.
    pub angle: f64,
    /// Energy that becomes heat in the brake, in moments of the mechanism.
    pub heat: f64,
    /// The motion.
    pub motion: Motion<1>,
}

/// The reason why a machine does not reach a speed.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub enum NotReached {
    /// The speed is not reached within the time.
    Late {
        /// The wished speed, rad/s.
        wished: f64,
        /// The motion until the limit of time.
        motion: Box<Motion<1>>,
    },
    /// The motion ends before.
    Interrupted(Interrupted<1>),
}

impl fmt::Display for NotReached {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Late { wished, motion } => {
                let end = motion.end();
                write!(
                    f,
                    "the speed {wished} rad/s is not reached within {} s: it is {} rad/s at the input {}\nhelp: give \
                     more time, or use a stronger motor or brake",
                    end.time, end.speeds[0], end.inputs[0]
                )
            }
            Self::Interrupted(interrupted) => interrupted.fmt(f),
        }
    }
}

impl Error for NotReached {}

/// Starts a machine from rest with a motor, until its speed reaches `speed` (rad/s) for the first
/// time, within a time in s. The equation of the machine is without the motor.
///
/// # Errors
///
/// [`NotReached`]: the speed is not reached within the time, or the motion is interrupted.
pub fn run_up<F>(
    machine: &Machine<F>,
    motor: &Motor,
    speed: f64,
    within: f64,
) -> Result<RunUp, NotReached>
where
    F: Fn(f64, f64) -> Reduced,
{
    let drive = |omega: f64| motor.torque(omega);
    let stop = Event::speed(0, speed).rising().stop();
    let motion = follow(machine, drive, 0.0, stop, within, speed)?;
    let end = motion.end();
    Ok(RunUp {
        time: end.time,
        angle: end.inputs[0] - machine.start,
        work: motion.integral(|state| motor.torque(state.speeds[0]) * state.speeds[0]),
        heat: motion.integral(|state| motor.loss(state.speeds[0])),
        motion,
    })
}

/// Brakes a machine from a speed (rad/s, of either sign) to rest, within a time in s. `brake`
/// returns the size of the brake's moment at a speed; it acts against the motion.
///
/// # Errors
///
/// [`NotReached`]: the machine is not at rest within the time, or the motion is interrupted.
pub fn brake<F>(
    machine: &Machine<F>,
    speed: f64,
    brake: impl Fn(f64) -> f64,
    within: f64,
) -> Result<Stop, NotReached>
where
    F: Fn(f64, f64) -> Reduced,
{
    // Until rest the direction is that of the start: no jump for the integrator.
    let moment = |omega: f64| -speed.signum() * brake(omega);
    let motion = follow(
        machine,
        moment,
        speed,
        Event::reversal(0).stop(),
        within,
        0.0,
    )?;
    let end = motion.end();
    Ok(Stop {
        time: end.time,
        input: end.inputs[0],
        angle: end.inputs[0] - machine.start,
        heat: motion.integral(|state| -moment(state.speeds[0]) * state.speeds[0]),
        motion,
    })
}

/// Follows a machine with a further moment until an event.
fn follow<F: Fn(f64, f64) -> Reduced>(
    machine: &Machine<F>,
    moment: impl Fn(f64) -> f64,
    speed: f64,
    stop: Event<'_, 1>,
    within: f64,
    wished: f64,
) -> Result<Motion<1>, NotReached> {
    let equation = |_, [input]: [f64; 1], [omega]: [f64; 1]| {
        let Reduced {
            inertia,
            force: [force],
        } = (machine.equation)(input, omega);
        Reduced {
            inertia,
            force: [force + moment(omega)],
        }
    };
    let problem = Problem::with_equations(FromReduced(equation));
    let motion = problem
        .start([machine.start], [speed])
        .tolerance(machine.tolerance)
        .event(stop)
        .until(within)
        .map_err(NotReached::Interrupted)?;
    if motion.ended() == Ended::Time {
        let motion = Box::new(motion);
        return Err(NotReached::Late { wished, motion });
    }
    Ok(motion)
}
