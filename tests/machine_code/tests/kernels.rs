//! One mechanism for each kind of group: its functions one position at a time, and their sweeps.
//!
//! The workspace builds this package with optimisation in every profile.
#![cfg(all(target_arch = "x86_64", target_os = "linux"))]

#[macro_use]
mod judge;

use linkage::mechanism;

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

mechanism! {
    pub struct Laws {
        unit mm;
        param lift = 20mm;
        param lead = 15deg;
        input phi = 40deg in 0deg..360deg;
        let s = piecewise(phi, [
            (lead, 0mm), (120deg, lift, modified_sine), (150deg, lift), (240deg, 5mm, poly345),
            (300deg, 0mm, modified_trapezoid), (lead + 360deg, 0mm),
        ]);
        let t = spline(phi, [(0deg, 0mm), (90deg, 4mm), (200deg, lift), (290deg, 6mm), (360deg, 0mm)]);
    }
    impl Laws {
        pub fn position(phi) -> LawsPosition { s, t }
        pub fn motion(phi) -> LawsMotion { v: velocity(s), a: acceleration(s), j: jerk(s), w: velocity(t) }
    }
}

check!(laws: Laws, LawsAssembly:
    position [position_sweep position_sweep_sets] (phi),
    motion [motion_sweep motion_sweep_sets] (phi));
check!(rrr: Rrr, RrrAssembly:
    position [position_sweep position_sweep_sets] (phi),
    motion [motion_sweep motion_sweep_sets] (phi),
    angles [angles_sweep angles_sweep_sets] (phi),
    accuracy [accuracy_sweep accuracy_sweep_sets] (phi));
check!(rrp: Rrp, RrpAssembly:
    position [position_sweep position_sweep_sets] (phi),
    motion [motion_sweep motion_sweep_sets] (phi),
    angles [angles_sweep angles_sweep_sets] (phi),
    accuracy [accuracy_sweep accuracy_sweep_sets] (phi));
check!(rpr: Rpr, RprAssembly:
    position [position_sweep position_sweep_sets] (phi),
    motion [motion_sweep motion_sweep_sets] (phi),
    angles [angles_sweep angles_sweep_sets] (phi),
    accuracy [accuracy_sweep accuracy_sweep_sets] (phi));
check!(prp: Prp, PrpAssembly:
    position [position_sweep position_sweep_sets] (phi),
    motion [motion_sweep motion_sweep_sets] (phi),
    accuracy [accuracy_sweep accuracy_sweep_sets] (phi));
check!(chain: Chain, ChainAssembly:
    position [position_sweep position_sweep_sets] (stroke),
    motion [motion_sweep motion_sweep_sets] (stroke, phi),
    lengths [lengths_sweep lengths_sweep_sets] (stroke),
    accuracy [accuracy_sweep accuracy_sweep_sets] (stroke));
