//! One mechanism for each kind of group in space: its functions one position at a time, and their sweeps.
//!
//! The workspace builds this package with optimisation in every profile.
#![cfg(all(target_arch = "x86_64", target_os = "linux"))]

#[macro_use]
mod judge;

use linkage::mechanism;

mechanism! {
    /// A link between two ball joints, one on a crank and one on a rocker.
    pub struct Rssr {
        unit mm;
        param crank = 30mm;
        param coupler = 130mm;
        param rocker = 70mm;
        param pivot = (110mm, 30mm, -50mm);
        param tilt = 20deg;
        input phi = 0deg in 0deg..360deg;
        unknown psi = 102deg;
        let pin = turn((0, crank, 0), (1, 0, 0), phi);
        let end = pivot + turn((rocker, 0, 0), (0, sin(tilt), cos(tilt)), psi);
        loop distance(pin, end) = coupler;
    }
    impl Rssr {
        pub fn position(phi) -> RssrPosition { end, margin: margin() }
        pub fn motion(phi) -> RssrMotion { end, v: velocity(end), a: acceleration(end) }
        pub fn angles(phi) -> RssrAngles { psi, j: jerk(psi) }
        pub fn accuracy(phi) -> RssrAccuracy { e: sensitivity(end), s: sensitivity(velocity(psi)) }
    }
}

mechanism! {
    /// A link between two ball joints, one on a crank and one on a slide.
    pub struct Rssp {
        unit mm;
        param crank = 35mm;
        param rod = 150mm;
        param foot = (60mm, 40mm, -30mm);
        param along = (0.74, 0.52, 0.42);
        input phi = 0deg in 0deg..360deg;
        unknown s = 115mm;
        let pin = turn((crank, 0, 0), (0, 0, 1), phi);
        loop distance(pin, foot + s * along) = rod;
    }
    impl Rssp {
        pub fn position(phi) -> RsspPosition { s, margin: margin() }
        pub fn motion(phi) -> RsspMotion { s, v: velocity(s), a: acceleration(s), j: jerk(s) }
        pub fn accuracy(phi) -> RsspAccuracy { e: sensitivity(s), m: d(s, phi, rod) }
    }
}

mechanism! {
    /// A point on three legs, a second one on two legs and in a plane, a third one on a leg and a line.
    pub struct Points {
        unit mm;
        param leg = 300mm;
        param normal = (0.2, 1, 0.1);
        input x = 20mm in 0mm..40mm;
        input y = 30mm in 0mm..40mm;
        unknown p = (70mm, 60mm, 280mm);
        loop distance(p, (x, 0, 0)) = leg;
        loop distance(p, (200mm, y, 0)) = leg;
        loop distance(p, (50mm, 180mm, 0)) = leg;
        unknown q = (90mm, 40mm, 500mm);
        loop distance(q, p) = 230mm;
        loop distance(q, (200mm, 0, 400mm)) = 160mm;
        loop dot(normal, q - p) = 0;
        unknown r = (100mm, 0mm, 600mm);
        loop distance(r, q) = leg / 2;
        loop dot(normal, r) = 20mm;
        loop dot((1, 0, x / leg), r - q) = 0mm;
    }
    impl Points {
        pub fn position(x, y) -> PointsPosition { p, q, r, margin: margin() }
        pub fn motion(x, y) -> PointsMotion { p, v: velocity(p), a: acceleration(p) }
        pub fn last(x, y) -> PointsLast { v: velocity(r) }
        pub fn accuracy(x, y) -> PointsAccuracy { p, e: sensitivity(p, [leg]), f: sensitivity(q) }
    }
}

mechanism! {
    /// A direction at given angles to two others, and two shafts with a joint between them.
    pub struct Directions {
        param opening = 70deg;
        param bend = 30deg;
        input phi = 20deg in 0deg..360deg;
        let arm = turn((1, 0, 0), (0, sin(bend), cos(bend)), phi);
        unknown n = (0.6, -0.6, 0.6);
        loop norm(n) = 1;
        loop dot(n, (0, 0, 1)) = cos(opening);
        loop dot(n, arm) = cos(60deg);
        unknown psi = 20deg;
        loop dot(turn((0, 1, 0), (0, 0, 1), phi), turn((cos(bend), 0, -sin(bend)), (sin(bend), 0, cos(bend)), psi)) = 0;
    }
    impl Directions {
        pub fn direction(phi) -> DirectionsDirection { n, margin: margin() }
        pub fn motion(phi) -> DirectionsMotion { n, v: velocity(n), a: acceleration(n) }
        pub fn shaft(phi) -> DirectionsShaft { psi, v: velocity(psi), a: acceleration(psi) }
        pub fn accuracy(phi) -> DirectionsAccuracy { e: sensitivity(n), f: sensitivity(psi) }
    }
}

mechanism! {
    /// Loops of three rows: three slides; two slides and an angle.
    pub struct Rows {
        unit mm;
        param guide = (0.1, 0.2, 1);
        param crank = 30mm;
        input phi = 20deg in 0deg..360deg;
        let pin = turn((crank, 0, 5mm), (0.1, 0.2, 1), phi);
        unknown a = 30mm;
        unknown b = 10mm;
        unknown c = -6mm;
        loop a * (1, 0, 0.2) + b * (0, 1, 0.3) + c * guide = pin;
        unknown s = 0mm;
        unknown t = 95mm;
        unknown psi = 80deg;
        loop s * (1, 0, 0.2) + t * (0, 1, 0.3) + turn((0, 0, 90mm), (1, 0.3, 0), psi) = pin + (0, 0, 40mm);
    }
    impl Rows {
        pub fn slides(phi) -> RowsSlides { a, b, c, margin: margin() }
        pub fn motion(phi) -> RowsMotion { v: velocity(a), w: acceleration(c) }
        pub fn turned(phi) -> RowsTurned { s, t, psi, v: velocity(psi), w: acceleration(s), m: margin() }
        pub fn accuracy(phi) -> RowsAccuracy { e: sensitivity(c), f: sensitivity(psi) }
    }
}

check!(rssr: Rssr, RssrAssembly:
    position [position_sweep position_sweep_sets] (phi),
    motion [motion_sweep motion_sweep_sets] (phi),
    angles [angles_sweep angles_sweep_sets] (phi),
    accuracy [accuracy_sweep accuracy_sweep_sets] (phi));
check!(rssp: Rssp, RsspAssembly:
    position [position_sweep position_sweep_sets] (phi),
    motion [motion_sweep motion_sweep_sets] (phi),
    accuracy [accuracy_sweep accuracy_sweep_sets] (phi));
check!(points: Points, PointsAssembly:
    position [position_sweep position_sweep_sets] (x, y),
    motion [motion_sweep motion_sweep_sets] (x, y),
    last [last_sweep last_sweep_sets] (x, y),
    accuracy [accuracy_sweep accuracy_sweep_sets] (x, y));
check!(directions: Directions, DirectionsAssembly:
    direction [direction_sweep direction_sweep_sets] (phi),
    motion [motion_sweep motion_sweep_sets] (phi),
    shaft [shaft_sweep shaft_sweep_sets] (phi),
    accuracy [accuracy_sweep accuracy_sweep_sets] (phi));
check!(rows: Rows, RowsAssembly:
    slides [slides_sweep slides_sweep_sets] (phi),
    motion [motion_sweep motion_sweep_sets] (phi),
    turned [turned_sweep turned_sweep_sets] (phi),
    accuracy [accuracy_sweep accuracy_sweep_sets] (phi));
