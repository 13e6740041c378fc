//! The generated functions of one mechanism for each kind of group: no conditional jump, and no call but one sine and
//! cosine for each driving angle and one arctangent for each angle that was asked for.
//!
//! The workspace builds this package with optimisation in every profile.
#![cfg(all(target_arch = "x86_64", target_os = "linux"))]

use std::hint::black_box;

use linkage::{Operations, mechanism};
use linkage_machine_code::{Findings, inspect};

mechanism! {
    pub struct Rrr {
        unit mm;
        param crank = 40mm;
        param coupler = 120mm;
        param rocker = 80mm;
        param frame = 100mm;
        param arm = 60mm;
        param lift = 30deg;
        input phi = 40deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = (frame, 0) + polar(rocker, psi);
        let tracer = a + polar(arm, theta + lift);
    }
    impl Rrr {
        pub fn position(phi) -> RrrPosition { tracer, margin: margin() }
        pub fn motion(phi) -> RrrMotion { tracer, v: velocity(tracer), a: acceleration(tracer) }
        pub fn angles(phi) -> RrrAngles { theta, psi, j: jerk(psi) }
        pub fn accuracy(phi) -> RrrAccuracy { e: sensitivity(tracer), s: sensitivity(velocity(psi)) }
    }
}

mechanism! {
    pub struct Rrp {
        unit mm;
        param crank = 40mm;
        param rod = 150mm;
        param offset = 10mm;
        param guide = 5deg;
        input phi = 40deg in 0deg..360deg;
        unknown tilt = -10deg;
        unknown s = 178mm;
        loop polar(crank, phi) + polar(rod, tilt) = rotate((s, offset), guide);
        let middle = polar(crank, phi) + polar(rod / 2, tilt);
    }
    impl Rrp {
        pub fn position(phi) -> RrpPosition { middle, s, margin: margin() }
        pub fn motion(phi) -> RrpMotion { s, v: velocity(s), a: acceleration(s), w: velocity(tilt) }
        pub fn angles(phi) -> RrpAngles { tilt }
        pub fn accuracy(phi) -> RrpAccuracy { e: sensitivity(s), m: d(s, phi, offset) }
    }
}

mechanism! {
    pub struct Rpr {
        unit mm;
        param crank = 40mm;
        param frame = 100mm;
        param offset = 8mm;
        param arm = 150mm;
        input phi = 40deg in 0deg..360deg;
        unknown psi = 100deg;
        unknown s = 120mm;
        loop (0, frame) + polar(crank, phi) = rotate((s, offset), psi);
        let tip = polar(arm, psi);
    }
    impl Rpr {
        pub fn position(phi) -> RprPosition { tip, s, margin: margin() }
        pub fn motion(phi) -> RprMotion { tip, v: velocity(tip), a: acceleration(tip) }
        pub fn angles(phi) -> RprAngles { psi }
        pub fn accuracy(phi) -> RprAccuracy { e: sensitivity(tip), m: d(psi, phi, crank) }
    }
}

mechanism! {
    pub struct Prp {
        unit mm;
        param rod = 100mm;
        param guide = 80deg;
        input phi = 30deg in 0deg..360deg;
        unknown across = 87mm;
        unknown up = -50mm;
        loop polar(up, guide) + polar(rod, phi) = (across, 0);
    }
    impl Prp {
        pub fn position(phi) -> PrpPosition { across, up, margin: margin() }
        pub fn motion(phi) -> PrpMotion { v: velocity(across), a: acceleration(up) }
        pub fn accuracy(phi) -> PrpAccuracy { e: sensitivity(across) }
    }
}

mechanism! {
    /// Scalar loops, a cylinder, gears and two inputs; the second dyad rides on the first.
    pub struct Chain {
        unit mm;
        param foot = (60mm, -80mm);
        param arm = 110mm;
        param closed = 120mm;
        param rod = 70mm;
        param pin = 40mm;
        input stroke = 30mm in 0mm..60mm;
        input phi = 20deg in 0deg..40deg;
        unknown cylinder = 80deg;
        unknown lift = 38deg;
        loop foot + polar(closed + stroke, cylinder) = polar(arm, lift);
        let gear = 30deg - phi / 2;
        let tip = polar(arm, lift);
        unknown swing = 100deg;
        loop distance(tip + polar(pin, swing), tip + (30mm, 0mm) + polar(10mm, gear)) = rod;
        unknown s = 197mm;
        loop distance((s, 0), tip) = 130mm;
        unknown turned = -76deg;
        loop turned = -2 * lift;
        let last = tip + polar(pin, turned);
    }
    impl Chain {
        pub fn position(stroke) -> ChainPosition { tip, s, last, margin: margin() }
        pub fn motion(stroke, phi) -> ChainMotion { swing, v: velocity(swing), a: acceleration(swing) }
        pub fn lengths(stroke) -> ChainLengths { n: norm(last), w: velocity(norm(last)), c: abs(last.x) }
        pub fn accuracy(stroke) -> ChainAccuracy { e: sensitivity(s), f: sensitivity(turned) }
    }
}

/// Checks the functions of a mechanism: each is called from a function that is not inlined.
macro_rules! check {
    ($mechanism:ident, $assembly:ident: $($function:ident($($input:ident),*) -> $result:ident),* $(,)?) => {
        let _ = black_box($mechanism::default().assemble().expect("it assembles"));
        $({
            #[inline(never)]
            fn kernel(linkage: &$assembly, result: &mut $result, $($input: f64),*) {
                *result = linkage.$function($($input),*);
            }
            let name = concat!(stringify!($mechanism), "::", stringify!($function));
            let function = $mechanism::STRUCTURE
                .functions
                .iter()
                .find(|f| f.name == stringify!($function))
                .expect("it is listed");
            judge(name, &inspect(kernel as *const ()), &function.operations);
        })*
    };
}

fn judge(name: &str, findings: &Findings, operations: &Operations) {
    println!("{name}: {findings:?}");
    assert!(
        findings.branches.is_empty(),
        "{name} branches: {findings:?}"
    );
    assert!(findings.strange.is_empty(), "{name}: {findings:?}");
    // One call gives both sine and cosine, or two calls one each.
    let pairs = operations.sin_cos as usize;
    assert!(
        (pairs..=2 * pairs).contains(&findings.sin_cos),
        "{name}: {findings:?} {operations}"
    );
    assert_eq!(
        findings.atan2, operations.atan2 as usize,
        "{name}: {findings:?} {operations}"
    );
    // Unoptimised code would be many times as long.
    let sum = u64::from(operations.total()) as usize;
    assert!(findings.instructions > sum / 2, "{name}: {findings:?}");
    assert!(
        findings.instructions < 6 * sum + 100,
        "{name}: {findings:?} {operations}"
    );
}

#[test]
fn rrr() {
    check!(Rrr, RrrAssembly:
        position(phi) -> RrrPosition, motion(phi) -> RrrMotion,
        angles(phi) -> RrrAngles, accuracy(phi) -> RrrAccuracy);
}

#[test]
fn rrp() {
    check!(Rrp, RrpAssembly:
        position(phi) -> RrpPosition, motion(phi) -> RrpMotion,
        angles(phi) -> RrpAngles, accuracy(phi) -> RrpAccuracy);
}

#[test]
fn rpr() {
    check!(Rpr, RprAssembly:
        position(phi) -> RprPosition, motion(phi) -> RprMotion,
        angles(phi) -> RprAngles, accuracy(phi) -> RprAccuracy);
}

#[test]
fn prp() {
    check!(Prp, PrpAssembly:
        position(phi) -> PrpPosition, motion(phi) -> PrpMotion, accuracy(phi) -> PrpAccuracy);
}

#[test]
fn chain() {
    check!(Chain, ChainAssembly:
        position(stroke) -> ChainPosition, motion(stroke, phi) -> ChainMotion,
        lengths(stroke) -> ChainLengths, accuracy(stroke) -> ChainAccuracy);
}

#[inline(never)]
fn branching(x: f64, steps: u32) -> f64 {
    (0..steps).fold(x, |x, _| if x > 1.0 { x.exp() } else { 2.0 * x })
}

#[inline(never)]
fn calls_a_branching_function(x: f64, steps: u32) -> f64 {
    1.0 + branching(x, steps)
}

#[inline(never)]
fn elementary(x: f64, y: f64) -> f64 {
    let (sin, cos) = x.sin_cos();
    sin * cos + y.atan2(sin)
}

#[test]
fn a_branch_is_found_also_behind_a_call() {
    assert!(black_box(branching(0.3, 4)).is_finite());
    assert!(black_box(calls_a_branching_function(0.3, 4)).is_finite());
    assert!(!inspect(branching as *const ()).branches.is_empty());
    assert!(
        !inspect(calls_a_branching_function as *const ())
            .branches
            .is_empty()
    );
}

#[test]
fn elementary_functions_are_known() {
    assert!(black_box(elementary(0.3, 4.0)).is_finite());
    let findings = inspect(elementary as *const ());
    assert!(
        (1..=2).contains(&findings.sin_cos) && findings.atan2 == 1,
        "{findings:?}"
    );
    assert!(
        findings.branches.is_empty() && findings.strange.is_empty(),
        "{findings:?}"
    );
}
