//! Sweeps give the rows of single calls: every length, every place, every scalar, over inputs and over mechanisms.

mod inputs;
mod panics;
mod parallel;
mod scalars;
mod sets;
mod singular;
mod space;

use linkage::{Scalar, mechanism};
use linkage_random::Random;

mechanism! {
    /// Crank-rocker with a coupler point.
    pub struct Rocker {
        unit mm;
        param crank = 40mm;
        param coupler = 120mm;
        param rocker = 80mm;
        param pivot = (100mm, 5mm);
        param arm = 60mm;
        param lift = 30deg;
        input phi = 40deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = pivot + polar(rocker, psi);
        let tracer = a + polar(arm, theta + lift);
    }
    impl Rocker {
        pub fn motion(phi) -> RockerMotion { tracer, v: velocity(tracer), psi, margin: margin() }
    }
}

mechanism! {
    /// Two inputs, and more columns than most.
    pub struct FiveBar {
        unit mm;
        param crank_1 = 30mm;
        param crank_2 = 25mm;
        param rod_1 = 90mm;
        param rod_2 = 85mm;
        param frame = 80mm;
        input phi = 70deg in 0deg..360deg;
        input phase = 25deg in -60deg..60deg;
        unknown alpha = 42deg;
        unknown beta = 76deg;
        let point = polar(crank_1, phi) + polar(rod_1, alpha);
        loop point = (frame, 0) + polar(crank_2, 2 * phi + phase) + polar(rod_2, beta);
    }
    impl FiveBar {
        pub fn motion(phi, phase) -> FiveBarMotion { point, v: velocity(point), a: acceleration(point) }
    }
}

mechanism! {
    /// Drag link: the driven crank turns with the driving one, and counts its turns.
    pub struct DragLink {
        unit mm;
        param frame = 20mm;
        param driving = 50mm;
        param coupler = 45mm;
        param driven = 60mm;
        input phi = 60deg in 0deg..720deg;
        unknown theta = 178deg;
        unknown psi = 130deg;
        loop polar(driving, phi) + polar(coupler, theta) = (frame, 0) + polar(driven, psi);
        let half = polar(driven, psi / 2);
    }
    impl DragLink {
        pub fn angles(phi) -> DragAngles { psi, half }
    }
}

/// Numbers of a `RockerMotion`.
const WIDTH: usize = 6;

/// A row by a single call.
fn single<T: Scalar>(linkage: &RockerAssembly<T>, phi: T) -> [T; WIDTH] {
    numbers(&linkage.motion(phi))
}

fn numbers<T: Scalar>(motion: &RockerMotion<T>) -> [T; WIDTH] {
    let RockerMotion {
        tracer,
        v,
        psi,
        margin,
    } = *motion;
    [tracer.x, tracer.y, v.x, v.y, psi, margin]
}

/// All rows by a sweep.
fn swept<T: Scalar>(linkage: &RockerAssembly<T>, phi: &[T]) -> Vec<[T; WIDTH]> {
    linkage
        .motion_sweep(phi)
        .iter()
        .map(|row| numbers(&row))
        .collect()
}

/// Each number to the last bit; all NaN are one.
fn bits<T: Scalar>(rows: &[[T; WIDTH]]) -> Vec<[u64; WIDTH]> {
    let number = |x: T| match x.lane(0) {
        x if x.is_nan() => u64::MAX,
        x => x.to_bits(),
    };
    rows.iter().map(|row| row.map(number)).collect()
}

/// Checks that two rows agree to four units of roundoff `unit` of the sizes of the mechanism: lengths and velocities of
/// up to 200, angles.
fn check_row<T: Scalar>(found: [T; WIDTH], known: [T; WIDTH], unit: f64, what: &str) {
    let sizes = [200.0, 200.0, 200.0, 200.0, 4.0, 4.0];
    for ((found, known), size) in found.into_iter().zip(known).zip(sizes) {
        let (found, known) = (found.lane(0), known.lane(0));
        let near = (found - known).abs() <= 4.0 * unit * size;
        assert!(
            near || found.is_nan() && known.is_nan(),
            "{what}: {found}, not {known}"
        );
    }
}

fn angles<T: Scalar>(random: &mut Random, count: usize) -> Vec<T> {
    (0..count).map(|_| T::from_f64(random.turn())).collect()
}
