//! Mechanisms without the standard library and without an allocator.
//!
//! What `cargo build -p linkage-no-std` proves: `linkage` with `libm` alone and everything that the macro generates
//! (dimensions, assembly, functions, and the error) name nothing of `std` or `alloc`, neither at the place of the call nor
//! by way of the prelude. It does not prove that a target without an operating system links; for that, build it with
//! `--target` for one, such as `thumbv7em-none-eabihf`. With `--features alloc` there are sweeps and lists of assemblies,
//! too.
//!
//! A build of the whole workspace unites the features of all its members and turns `std` on: only the command above,
//! for this package alone, is the proof.
#![no_std]

use linkage::pins::{Fit, Limit, Member, Mounting, Pin, PinError, Width};
use linkage::{AssemblyError, mechanism};

mechanism! {
    /// Crank-rocker four-bar with a gear on its rocker.
    pub struct CrankRocker {
        unit mm;
        param crank = 40mm +- 12um;
        param frame = (100mm, 0mm);
        input phi = 40deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        let a = polar(crank, phi);
        loop a + polar(120mm, theta) = frame + polar(80mm, psi);
        let tracer = a + polar(60mm, theta + 30deg);
        let gear = dir(psi / 3);
    }

    impl CrankRocker {
        /// Motion of the coupler point.
        pub fn motion(phi) -> Motion {
            tracer, psi, gear,
            v: velocity(tracer),
            a: acceleration(tracer),
            e: sensitivity(tracer, [crank]),
            margin: margin(),
        }
    }
}

/// The tracer's distance from the crank's pivot, in millimetres.
///
/// # Errors
///
/// If the links do not reach each other.
pub fn reach(crank: f64, phi: f64) -> Result<f64, AssemblyError> {
    let linkage = CrankRocker {
        crank,
        ..CrankRocker::default()
    }
    .assemble()?;
    Ok(linkage.motion(phi).tracer.norm())
}

/// The same in single precision, for small processors.
///
/// # Errors
///
/// If the links do not reach each other.
pub fn reach_in_single_precision(phi: f32) -> Result<f32, AssemblyError> {
    let linkage = CrankRocker::default().cast::<f32>().assemble()?;
    let tracer = linkage.motion(phi).tracer;
    Ok(tracer.x.abs() + tracer.y.abs())
}

/// The largest distance of a coarse sweep.
///
/// # Errors
///
/// If the links do not reach each other.
#[cfg(feature = "alloc")]
pub fn farthest(angles: &[f64]) -> Result<f64, AssemblyError> {
    let sweep = CrankRocker::default().assemble()?.motion_sweep(angles);
    let farthest = sweep.iter().map(|motion| motion.tracer.norm());
    Ok(farthest.fold(0.0, f64::max))
}

mechanism! {
    /// A ternary link on three legs: its table needs an allocator.
    pub struct Platform {
        unit mm;
        param leg = 50mm;
        input phi = 60deg in 20deg..100deg;
        unknown tilt = 20deg;
        unknown leg_a = 20deg;
        unknown leg_b = 100deg;
        unknown leg_c = 290deg;
        let a = polar(40mm, phi) + polar(leg, leg_a);
        loop a + polar(60mm, tilt) = (120mm, 0) + polar(leg, leg_b);
        loop a + polar(60mm, tilt + 60deg) = (60mm, 110mm) + polar(leg, leg_c);
    }

    impl Platform {
        /// Its first joint.
        pub fn joint(phi) -> Joint { a, v: velocity(a) }
    }
}

/// How far the platform's joint moves for each radian, and how many assemblies there are.
///
/// # Errors
///
/// If the links do not reach each other.
#[cfg(feature = "alloc")]
pub fn platform(leg: f64, phi: f64) -> Result<(f64, usize), AssemblyError> {
    let platform = Platform { leg };
    let speed = platform.assemble()?.joint(phi).v.norm();
    Ok((speed, platform.circuits()?.branches.len()))
}

mechanism! {
    /// A camera on a mast, looking at a point: a frame in space.
    pub struct Camera {
        param height = 2m;
        input pan = 0deg;
        let eye = (0, 0, height);
        let body = frame(eye, (5m * cos(pan), 5m * sin(pan), -height), (0, 0, 1));
    }

    impl Camera {
        /// Where the camera is.
        pub fn pose(pan) -> CameraPose { body, tip: point_in(body, (0.1m, 0, 0)) }
    }
}

/// The camera's turn out of its fixed place, in radians.
///
/// # Errors
///
/// None: nothing has to close.
pub fn camera_turn(pan: f64) -> Result<f64, AssemblyError> {
    let pose = Camera::default().assemble()?.pose(pan);
    Ok(pose.body.isometry().rotation.angle())
}

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
        input left = 5deg in -25deg..35deg;
        input right = 5deg in -25deg..35deg;
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
        /// Pitch and roll.
        pub fn tilt(left, right) -> Tilt { pitch, roll }
    }
}

/// The torques of the ankle's motors under these moments on the foot, in single precision.
///
/// # Errors
///
/// If the links do not reach each other.
pub fn ankle_torques(foot: [f32; 2], moments: [f32; 2]) -> Result<[f32; 2], AssemblyError> {
    let ankle = Ankle::default().cast::<f32>().assemble()?;
    let motors = ankle.motors(foot[0], foot[1]);
    let by_foot = linkage::jacobian::Jacobian::of_results([motors.left_by, motors.right_by]);
    Ok(by_foot.inverse().efforts(moments))
}

/// Pitch and roll of the foot: what both motors determine together is prepared on a grid.
///
/// # Errors
///
/// If the links do not reach each other.
#[cfg(feature = "alloc")]
pub fn ankle_tilt(motors: [f32; 2]) -> Result<[f32; 2], AssemblyError> {
    let foot = Foot::default().cast::<f32>().assemble()?;
    let tilt = foot.tilt(motors[0], motors[1]);
    Ok([tilt.pitch, tilt.roll])
}

/// The diameter of a clevis pin, loose in rod and fork, 10 mm and twice 5 mm wide.
///
/// # Errors
///
/// If the load is not positive.
pub fn pin_diameter(load: f64) -> Result<f64, PinError> {
    let member = |width| Member {
        width: Width::Fixed(width),
        pressure: Limit::allowable(30.0),
    };
    let pin = Pin {
        load,
        mounting: Mounting::Clevis {
            fit: Fit::Loose,
            rod: member(10.0),
            fork: member(5.0),
        },
        bending: Limit::new(400.0, 2.5),
        shear: Limit::new(250.0, 2.5),
    };
    Ok(pin.diameter()?.diameter)
}

/// The mass that leaves the least peak of forces.
///
/// # Errors
///
/// If there is nothing to balance.
#[cfg(feature = "alloc")]
pub fn counterweight(
    forces: &[[f64; 2]],
    effects: &[[[f64; 2]; 1]],
) -> Result<f64, linkage::balancing::BalanceError> {
    let [mass] = linkage::balancing::Balance::new(forces, effects)?
        .peak()?
        .values;
    Ok(mass)
}

/// How far the rocker swings, in radians.
///
/// # Errors
///
/// If it cannot be followed over the turn.
#[cfg(feature = "alloc")]
pub fn swing(rocker: impl Fn(f64) -> [f64; 2]) -> Result<f64, linkage::summary::SummaryError> {
    let turn = (0.0, core::f64::consts::TAU);
    let course = linkage::summary::Course::of(turn, 360, rocker)?;
    Ok(course.position().stroke())
}

/// Where the rocker's dwell within a band below its highest position begins, in radians of the shaft.
#[cfg(feature = "alloc")]
pub fn dwell(rocker: impl Fn(f64) -> [f64; 2], band: f64) -> Option<f64> {
    use linkage::cyclogram::{Band, Event, Motion, Organ};
    let turn = (0.0, core::f64::consts::TAU);
    let course = linkage::summary::Course::of(turn, 360, rocker).ok()?;
    let organ = Organ::new("rocker", &course, &[Band::Top(band)]).ok()?;
    let begins = |event: &&Event| event.begins == Motion::Dwell(0);
    organ.events().iter().find(begins).map(|event| event.at)
}

/// How close two points come.
///
/// # Errors
///
/// If they cannot be followed over the turn.
#[cfg(feature = "alloc")]
pub fn least_distance(
    points: impl Fn(f64) -> [[[f64; 2]; 3]; 2],
) -> Result<f64, linkage::summary::SummaryError> {
    let turn = (0.0, core::f64::consts::TAU);
    let pair = |x| points(x).map(|point| [point]).into();
    Ok(linkage::clearance::Clearance::of(turn, 90, pair)?
        .least()
        .distance)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_two_precisions_agree() -> Result<(), AssemblyError> {
        let linkage = CrankRocker::default().assemble()?;
        let tracer = linkage.motion(1.0).tracer;
        let single = reach_in_single_precision(1.0)?;
        assert!((f64::from(single) - tracer.x.abs() - tracer.y.abs()).abs() < 1e-3);
        assert_eq!(reach(40.0, 1.0)?, tracer.norm());
        Ok(())
    }

    #[test]
    fn a_crank_that_is_too_long_is_an_error() {
        assert!(reach(400.0, 1.0).is_err());
    }
}
