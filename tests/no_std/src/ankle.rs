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
mod tests;
