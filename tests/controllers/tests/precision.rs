//! Single precision against double precision, on this machine: the digits that `docs/controllers.md` promises.

use linkage_controllers::{CrankRocker, QuickReturn, SliderCrank, SpatialCrankRocker, TogglePress};

/// The largest error of a length over a turn, as a part of the mechanism's size.
fn error(size: f64, single: impl Fn(f32) -> f32, double: impl Fn(f64) -> f64) -> f64 {
    let errors = (0..720).map(|k| {
        let phi = f32::to_radians(k as f32 / 2.0);
        (f64::from(single(phi)) - double(f64::from(phi))).abs() / size
    });
    errors.fold(0.0, f64::max)
}

#[test]
fn lengths_have_six_digits() {
    macro_rules! error {
        ($mechanism:ident, $size:literal, |$m:ident| $length:expr) => {{
            let double = $mechanism::default().assemble().expect("it assembles");
            let single = $mechanism::default().cast::<f32>().assemble();
            let single = single.expect("it assembles in single precision");
            let single = |phi| {
                let $m = single.motion(phi);
                $length
            };
            let double = |phi| {
                let $m = double.motion(phi);
                $length
            };
            (stringify!($mechanism), error($size, single, double))
        }};
    }
    for (name, error) in [
        error!(SliderCrank, 190.0, |m| m.ram),
        error!(CrankRocker, 120.0, |m| m.tracer.y),
        error!(QuickReturn, 600.0, |m| m.ram),
        error!(TogglePress, 360.0, |m| m.ram),
        error!(SpatialCrankRocker, 130.0, |m| m.b.x),
    ] {
        println!("{name}: {error:.1e}");
        assert!(error < 1e-6, "{name}: {error:e}");
    }
}
