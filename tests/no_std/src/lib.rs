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

mod ankle;
mod around;

#[cfg(feature = "alloc")]
pub use ankle::ankle_tilt;
pub use ankle::{Ankle, Driven, Foot, ankle_motors, ankle_torques};
pub use around::pin_diameter;
#[cfg(feature = "alloc")]
pub use around::{counterweight, dwell, least_distance, swing};
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
        unknown leg_a = -37deg;
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
