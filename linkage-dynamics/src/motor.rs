//! Motors by their torque over speed.

use std::error::Error;
use std::fmt;

/// A motor: its torque over the speed of its shaft, and the speed at which it has no torque.
///
/// Torques are in the moments of the mechanism, `N*mm` with `unit mm`, and speeds in rad/s. Power
/// and loss are then in moments per second. The curves are steady: currents and magnetic fields
/// follow the speed without delay.
#[derive(Clone, Debug, PartialEq)]
pub struct Motor {
    curve: Curve,
    /// Revolutions of the motor in one of the input.
    ratio: f64,
}

#[derive(Clone, Debug, PartialEq)]
enum Curve {
    Induction {
        synchronous: f64,
        breakdown_torque: f64,
        breakdown_slip: f64,
        stator_ratio: f64,
    },
    /// A line from the torque at rest to the speed without torque.
    Line { stall: f64, no_load: f64 },
    /// Speeds in order and their torques, and the speed without torque.
    Table {
        points: Vec<(f64, f64)>,
        no_load: f64,
    },
}

impl Motor {
    /// Creates an induction motor from its synchronous speed (rad/s), its breakdown torque and the
    /// slip there (0.1 to 0.4 as a rule), by the formula of Kloss:
    /// `T = 2 Tb / (s / sb + sb / s)` with the slip `s = 1 - omega / omega_s`. Above the synchronous
    /// speed it brakes.
    ///
    /// The formula neglects the resistance of the stator, and with it the loss there:
    /// [`stator`](Self::stator) adds it.
    #[must_use]
    pub const fn induction(synchronous: f64, breakdown_torque: f64, breakdown_slip: f64) -> Self {
        Self::new(Curve::Induction {
            synchronous,
            breakdown_torque,
            breakdown_slip,
            stator_ratio: 0.0,
        })
    }

    /// Creates a motor with permanent magnets, or of constant excitation, from its voltage (V), the
    /// resistance of its armature (ohm) and its constant `k` (moment per ampere):
    /// `T = k (U - k' omega) / R`. `volts_per_speed` is `k'` in V*s; it is `k` if moments are in
    /// N*m, and `k / 1000` if moments are in N*mm.
    #[must_use]
    pub const fn dc(voltage: f64, resistance: f64, constant: f64, volts_per_speed: f64) -> Self {
        Self::new(Curve::Line {
            stall: constant * voltage / resistance,
            no_load: voltage / volts_per_speed,
        })
    }

    /// Creates a motor from points of its curve: speeds in rising order and their torques, with
    /// straight lines between them and beyond both ends.
    ///
    /// Integrators make short steps at the corners: a few dozen points are better than thousands.
    ///
    /// # Errors
    ///
    /// [`MotorError`] if there are less than two points, a number is not finite, speeds do not rise,
    /// or no torque is zero: the loss needs the speed without load.
    pub fn table(points: &[(f64, f64)]) -> Result<Self, MotorError> {
        if points.len() < 2 {
            return Err(MotorError::Few(points.len()));
        }
        let is_finite = |point: &(f64, f64)| point.0.is_finite() && point.1.is_finite();
        if let Some(index) = points.iter().position(|point| !is_finite(point)) {
            return Err(MotorError::NotFinite(index));
        }
        let falls = |pair: &[(f64, f64)]| pair[1].0 <= pair[0].0;
        if let Some(index) = points.windows(2).position(falls) {
            return Err(MotorError::Order(index + 1));
        }
        let zero = points.windows(2).rev().find_map(|pair| {
            let [(a, low), (b, high)] = [pair[0], pair[1]];
            (low * high <= 0.0 && low != high).then(|| a + (b - a) * low / (low - high))
        });
        let no_load = zero.ok_or(MotorError::NoZero)?;
        let points = points.to_vec();
        Ok(Self::new(Curve::Table { points, no_load }))
    }

    const fn new(curve: Curve) -> Self {
        Self { curve, ratio: 1.0 }
    }

    /// Adds the loss in the stator of an induction motor: its resistance over that of the rotor,
    /// referred to the stator. Other motors do not change.
    #[must_use]
    pub fn stator(mut self, ratio: f64) -> Self {
        if let Curve::Induction { stator_ratio, .. } = &mut self.curve {
            *stator_ratio = ratio;
        }
        self
    }

    /// Puts a gear without loss between motor and input: the motor makes `ratio` revolutions in one
    /// of the input. Speeds and torques of the result are those of the input.
    #[must_use]
    pub fn geared(mut self, ratio: f64) -> Self {
        self.ratio *= ratio;
        self
    }

    /// Returns the torque on the input at a speed of the input.
    #[must_use]
    pub fn torque(&self, speed: f64) -> f64 {
        self.ratio * self.shaft_torque(self.ratio * speed)
    }

    /// Returns the speed of the input at which the motor has no torque, rad/s.
    #[must_use]
    pub fn no_load_speed(&self) -> f64 {
        let shaft = match &self.curve {
            Curve::Induction { synchronous, .. } => *synchronous,
            Curve::Line { no_load, .. } | Curve::Table { no_load, .. } => *no_load,
        };
        shaft / self.ratio
    }

    /// Returns the power that becomes heat in the motor at a speed of the input.
    ///
    /// It is `T (omega_0 - omega)` with the speed `omega_0` without torque: the slip power of an
    /// induction motor, and `I^2 R` of a motor with constant excitation. A table has it by the same
    /// formula. Losses by friction and in the iron are not in it.
    #[must_use]
    pub fn loss(&self, speed: f64) -> f64 {
        let stator_ratio = match &self.curve {
            Curve::Induction { stator_ratio, .. } => *stator_ratio,
            Curve::Line { .. } | Curve::Table { .. } => 0.0,
        };
        self.torque(speed) * (self.no_load_speed() - speed) * (1.0 + stator_ratio)
    }

    fn shaft_torque(&self, speed: f64) -> f64 {
        match &self.curve {
            Curve::Induction {
                synchronous,
                breakdown_torque,
                breakdown_slip,
                stator_ratio: _,
            } => {
                // The formula times slip over slip: it has no pole at the synchronous speed.
                let slip = 1.0 - speed / synchronous;
                let squares = slip * slip + breakdown_slip * breakdown_slip;
                2.0 * breakdown_torque * breakdown_slip * slip / squares
            }
            Curve::Line { stall, no_load } => stall * (1.0 - speed / no_load),
            Curve::Table { points, .. } => {
                let after = points.partition_point(|point| point.0 < speed);
                let after = after.clamp(1, points.len() - 1);
                let [(a, low), (b, high)] = [points[after - 1], points[after]];
                low + (high - low) * ((speed - a) / (b - a))
            }
        }
    }
}

/// A mistake in the table of a motor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MotorError {
    /// The table has only this number of points.
    Few(usize),
    /// The point of this index has a number that is not finite.
    NotFinite(usize),
    /// The speed of this index is not larger than the speed before.
    Order(usize),
    /// No torque is zero.
    NoZero,
}

impl fmt::Display for MotorError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Few(count) => write!(f, "the table has {count} points\nhelp: give two or more"),
            Self::NotFinite(index) => write!(f, "point {index} of the table is not finite"),
            Self::Order(index) => write!(
                f,
                "speed {index} of the table is not larger than the speed before\nhelp: sort the points by speed"
            ),
            Self::NoZero => write!(
                f,
                "the torque of the table is nowhere zero\nhelp: append the speed without load, with a torque of zero"
            ),
        }
    }
}

impl Error for MotorError {}

#[cfg(test)]
mod tests {
    use super::{Motor, MotorError};

    /// Kloss: the breakdown torque at the breakdown slip, half of it and less at rest.
    #[test]
    fn induction_by_kloss() {
        let motor = Motor::induction(157.0, 60.0, 0.2);
        assert!((motor.torque(157.0 * 0.8) - 60.0).abs() < 1e-12);
        assert!((motor.torque(0.0) - 120.0 / (5.0 + 0.2)).abs() < 1e-12);
        assert_eq!(motor.torque(157.0), 0.0);
        assert!(motor.torque(160.0) < 0.0);
        // The slip power.
        let expected = motor.torque(100.0) * 57.0;
        assert!((motor.loss(100.0) - expected).abs() < 1e-10);
        assert!((motor.stator(0.5).loss(100.0) - 1.5 * expected).abs() < 1e-10);
    }

    /// The loss of a DC motor is that of its current in the resistance.
    #[test]
    fn dc_loss_is_that_of_its_current() {
        let motor = Motor::dc(24.0, 0.5, 0.1, 0.1);
        let current = (24.0 - 0.1 * 100.0) / 0.5;
        assert!((motor.torque(100.0) - 0.1 * current).abs() < 1e-12);
        assert!((motor.loss(100.0) - current * current * 0.5).abs() < 1e-9);
        // With a gear power and loss remain.
        let geared = motor.clone().geared(5.0);
        assert!((geared.torque(20.0) - 5.0 * motor.torque(100.0)).abs() < 1e-12);
        assert!((geared.loss(20.0) - motor.loss(100.0)).abs() < 1e-9);
    }

    #[test]
    fn tables_are_checked() {
        let motor = Motor::table(&[(0.0, 8.0), (80.0, 10.0), (100.0, 0.0)]);
        let motor = motor.expect("a table");
        assert_eq!([motor.torque(40.0), motor.torque(90.0)], [9.0, 5.0]);
        assert_eq!([motor.torque(110.0), motor.no_load_speed()], [-5.0, 100.0]);
        let cases: [(&[(f64, f64)], MotorError); 4] = [
            (&[(0.0, 1.0)], MotorError::Few(1)),
            (&[(0.0, 1.0), (f64::NAN, 0.0)], MotorError::NotFinite(1)),
            (&[(1.0, 1.0), (1.0, 0.0)], MotorError::Order(1)),
            (&[(0.0, 1.0), (1.0, 2.0)], MotorError::NoZero),
        ];
        for (points, error) in cases {
            assert_eq!(Motor::table(points), Err(error));
        }
    }
}
