//! The ankle of a humanoid both ways, with Jacobians and Hessians, in double and in single precision.

use linkage::jacobian::Jacobian;
use linkage::{AssemblyError, Scalar, mechanism};

mechanism! {
    /// The ankle of a humanoid, from the foot to its two motors.
    pub struct Ankle {
        unit mm;
        param crank = 60mm;
        input pitch = 0deg in -45deg..25deg;
        input roll = 0deg in -20deg..20deg;
        unknown left = 0deg;
        unknown right = 0deg;
        const x = (1, 0, 0);
        const y = (0, 1, 0);
        let heel_left = turn(turn((-50mm, 45mm, 10mm), x, roll), y, pitch);
        let heel_right = turn(turn((-50mm, -45mm, 10mm), x, roll), y, pitch);
        loop distance((0, 45mm, 230mm) + turn((-crank, 0, 0), y, left), heel_left) = 230mm;
        loop distance((0, -45mm, 230mm) + turn((-crank, 0, 0), y, right), heel_right) = 230mm;
    }

    impl Ankle {
        /// The motors, their Jacobian and Hessian.
        pub fn motors(pitch, roll) -> Motors {
            left, right,
            left_by: velocity(left), right_by: velocity(right),
            left_bends: acceleration(left), right_bends: acceleration(right),
        }
    }

    /// The same from the motors to the foot.
    pub struct Foot {
        unit mm;
        param crank = 60mm;
        input left = 5deg in -40deg..45deg;
        input right = 5deg in -40deg..45deg;
        unknown pitch = 0deg;
        unknown roll = 0deg;
        const x = (1, 0, 0);
        const y = (0, 1, 0);
        let heel_left = turn(turn((-50mm, 45mm, 10mm), x, roll), y, pitch);
        let heel_right = turn(turn((-50mm, -45mm, 10mm), x, roll), y, pitch);
        loop distance((0, 45mm, 230mm) + turn((-crank, 0, 0), y, left), heel_left) = 230mm;
        loop distance((0, -45mm, 230mm) + turn((-crank, 0, 0), y, right), heel_right) = 230mm;
    }

    impl Foot {
        /// Pitch and roll, their Jacobian and Hessian.
        pub fn tilt(left, right) -> Tilt {
            pitch, roll,
            pitch_by: velocity(pitch), roll_by: velocity(roll),
            pitch_bends: acceleration(pitch), roll_bends: acceleration(roll),
        }
    }
}

/// Two angles with what a drive needs: by row the derivatives by the two others, and the second ones.
#[derive(Clone, Copy, Debug)]
pub struct Driven<T> {
    /// The angles.
    pub angles: [T; 2],
    /// Their first derivatives.
    pub by: [[T; 2]; 2],
    /// Their second derivatives.
    pub bends: [[[T; 2]; 2]; 2],
}

/// The motors of a foot with this pitch and roll.
///
/// # Errors
///
/// If the links do not reach each other.
pub fn ankle_motors<T: Scalar>([pitch, roll]: [T; 2]) -> Result<Driven<T>, AssemblyError> {
    let m = Ankle::default().cast::<T>().assemble()?.motors(pitch, roll);
    Ok(Driven {
        angles: [m.left, m.right],
        by: [m.left_by, m.right_by],
        bends: [m.left_bends, m.right_bends],
    })
}

/// The torques of the ankle's motors under these moments on the foot.
///
/// # Errors
///
/// If the links do not reach each other.
pub fn ankle_torques<T: Scalar>(foot: [T; 2], moments: [T; 2]) -> Result<[T; 2], AssemblyError> {
    let by_foot = Jacobian::of_results(ankle_motors(foot)?.by);
    Ok(by_foot.inverse().efforts(moments))
}

/// Pitch and roll of the foot: what both motors determine together is prepared on a grid.
///
/// # Errors
///
/// If the links do not reach each other.
#[cfg(feature = "alloc")]
pub fn ankle_tilt<T: Scalar>([left, right]: [T; 2]) -> Result<Driven<T>, AssemblyError> {
    let t = Foot::default().cast::<T>().assemble()?.tilt(left, right);
    Ok(Driven {
        angles: [t.pitch, t.roll],
        by: [t.pitch_by, t.roll_by],
        bends: [t.pitch_bends, t.roll_bends],
    })
}

#[cfg(test)]
#[path = "../../../mechanisms/ankle/known.rs"]
mod known;
#[cfg(test)]
mod tests {
    //! Against a solution in 60 digits. The way back is compared by what undoes the way there.

    use super::known::{KNOWN, Known};
    use super::*;

    trait Tested: Scalar + Into<f64> {
        const ROUNDOFF: f64;
    }

    impl Tested for f64 {
        const ROUNDOFF: f64 = f64::EPSILON;
    }

    impl Tested for f32 {
        const ROUNDOFF: f64 = f32::EPSILON as f64;
    }

    /// So many roundoffs of 1 are allowed: those of the angles that go in, times what the loops make of them.
    fn close<T: Tested>(found: T, expected: f64, roundoffs: f64) {
        let found: f64 = found.into();
        let off = (found - expected).abs() / T::ROUNDOFF;
        assert!(
            off <= roundoffs,
            "{found} instead of {expected}: {off} roundoffs"
        );
    }

    fn foot<T: Scalar>(known: &Known) -> [T; 2] {
        known.foot.map(|angle| T::from_f64(angle.to_radians()))
    }

    fn motors_are_right<T: Tested>() {
        for known in &KNOWN {
            let found = ankle_motors::<T>(foot(known)).expect("it reaches");
            for (k, angle) in found.angles.into_iter().enumerate() {
                close(angle, known.motors[k], 8.0);
                (0..2).for_each(|i| close(found.by[k][i], known.jacobian[k][i], 40.0));
                for (i, j) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                    close(found.bends[k][i][j], known.hessian[k][i + j], 80.0);
                }
            }
        }
    }

    #[test]
    fn motors_in_both_precisions() {
        motors_are_right::<f64>();
        motors_are_right::<f32>();
    }

    /// Torques do the work of the moments: the transposed Jacobian of the solution in 60 digits brings them back.
    fn torques_are_right<T: Tested>() {
        let moments = [30.0, 8.0];
        for known in &KNOWN {
            let torques =
                ankle_torques::<T>(foot(known), moments.map(T::from_f64)).expect("it reaches");
            for (i, moment) in moments.into_iter().enumerate() {
                let back: f64 = (0..2)
                    .map(|k| known.jacobian[k][i] * torques[k].into())
                    .sum();
                close(T::from_f64(back), moment, 2000.0);
            }
        }
    }

    #[test]
    fn torques_in_both_precisions() {
        torques_are_right::<f64>();
        torques_are_right::<f32>();
    }

    /// With `J` and `H` of the way there: `B J = 1` and `B' (J, J) + B H = 0`.
    #[cfg(feature = "alloc")]
    fn tilt_is_right<T: Tested>() {
        for known in &KNOWN {
            let back = ankle_tilt::<T>(known.motors.map(T::from_f64)).expect("it reaches");
            for (k, angle) in back.angles.into_iter().enumerate() {
                close(angle, known.foot[k].to_radians(), 40.0);
                let by = back.by[k].map(Into::into);
                let bends = back.bends[k].map(|row| row.map(Into::into));
                for i in 0..2 {
                    let straight: f64 = (0..2).map(|m| by[m] * known.jacobian[m][i]).sum();
                    close(T::from_f64(straight), f64::from(u8::from(i == k)), 200.0);
                }
                for (i, j) in [(0, 0), (0, 1), (1, 1)] {
                    let j_of = |m: usize, i: usize| known.jacobian[m][i];
                    let curved: f64 = (0..4)
                        .map(|n| bends[n / 2][n % 2] * j_of(n / 2, i) * j_of(n % 2, j))
                        .sum();
                    let along: f64 = (0..2).map(|m| by[m] * known.hessian[m][i + j]).sum();
                    close(T::from_f64(curved + along), 0.0, 2000.0);
                }
            }
        }
    }

    #[cfg(feature = "alloc")]
    #[test]
    fn the_way_back_in_both_precisions() {
        tilt_is_right::<f64>();
        tilt_is_right::<f32>();
    }
}
