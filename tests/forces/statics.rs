//! Limits by hand: loads on bodies without mass, at rest.

use linkage_interpreted::interpreted;

interpreted! {
    pub struct Slider {
        unit mm;
        param a = 40mm;
        param b = 120mm;
        param e = 5mm;
        argument press = 500N;
        input phi = 40deg in 0deg..360deg;
        unknown theta = -10deg;
        unknown x = 150mm;
        let p2 = polar(a, phi);
        loop p2 + polar(b, theta) = (x, e);
        body crank = pin j1 on frame at (0mm, 0mm), turns phi;
        body rod = pin j2 on crank at p2, turns theta;
        body slider = slide j4 on frame at (x, e) along (1, 0);
        pin j3 = rod on slider at (x, e);
        force (-press, 0) on slider at (x, e);
    }
    impl Slider {
        pub fn statics(phi, press) -> SliderStatics { f1: reaction(j1), f2: reaction(j2), f3: reaction(j3), f4: reaction(j4), t: torque(phi) }
        pub fn alone(phi, press) -> SliderAlone { t: torque(phi) }
    }
}

interpreted! {
    /// Two links in a line, nearly: what the ram presses with for each unit of torque grows without bound.
    pub struct Toggle {
        unit mm;
        param upper = 100mm;
        param lower = 110mm;
        argument press = 500N;
        input lean = 10deg in -30deg..30deg;
        unknown beta = -100deg;
        unknown y = -200mm;
        let knee = polar(upper, lean - 90deg);
        loop knee + polar(lower, beta) = (0, y);
        body link = pin j1 on frame at (0mm, 0mm), turns lean;
        body rod = pin j2 on link at knee, turns beta;
        body ram = slide j4 on frame at (0, y) along (0, 1);
        pin j3 = rod on ram at (0, y);
        force (0, press) on ram at (0, y);
    }
    impl Toggle {
        pub fn statics(lean, press) -> ToggleStatics { f2: reaction(j2), f4: reaction(j4), t: torque(lean), gain: press / torque(lean) }
    }
}

interpreted! {
    /// A slider on the x axis, held by a block on an arm that turns about the origin: parallel guides at phi = 0.
    pub struct Wedge {
        unit mm;
        argument press = 500N;
        input phi = 40deg in 1e-13rad..90deg;
        unknown x;
        unknown y;
        let p = polar(x, phi);
        loop p = (y, 0mm);
        body arm = pin j1 on frame at (0mm, 0mm), turns phi;
        body block = slide j2 on arm at p along dir(phi);
        body slider = slide j4 on frame at p along (1, 0);
        pin j3 = block on slider at p;
        force (-press, 0) on slider at p;
    }
    impl Wedge {
        pub fn statics(phi, press) -> WedgeStatics { f1: reaction(j1), f2: reaction(j2), f3: reaction(j3), f4: reaction(j4), m: margin() }
    }
}

interpreted! {
    /// Coupler and rocker are stretched at phi = 0, where the crank lies in their line, too: a change point.
    #[allow(deprecated)]
    pub struct Stretched {
        unit mm;
        param a = 30mm;
        param b = 70mm;
        param c = 50mm;
        param d = 90mm;
        argument load = 300N*mm;
        input phi = 40deg;
        unknown theta = -150deg;
        unknown psi = 20deg;
        let p2 = polar(a, phi);
        loop p2 + polar(b, theta) = (-d, 0mm) + polar(c, psi);
        body crank = pin j1 on frame at (0mm, 0mm), turns phi;
        body coupler = pin j2 on crank at p2, turns theta;
        body rocker = pin j4 on frame at (-d, 0mm), turns psi;
        pin j3 = coupler on rocker at p2 + polar(b, theta);
        torque load on rocker;
    }
    impl Stretched {
        pub fn statics(phi, load) -> StretchedStatics { f3: reaction(j3), t: torque(phi), m: margin(), w: velocity(psi) }
    }
}

#[track_caller]
fn close(found: f64, expected: f64, relative: f64) {
    assert!(
        (found - expected).abs() <= relative * expected.abs(),
        "{found:e} instead of {expected:e}"
    );
}

#[test]
fn slider_crank() {
    let linkage = Slider::default().assemble().expect("it assembles");
    for k in 0..72 {
        let phi = (5.0 * f64::from(k) + 1.0).to_radians();
        let found = linkage.statics(phi, 500.0);
        // The rod leans by beta; its force has the component press along the guide.
        let beta = ((40.0 * phi.sin() - 5.0) / 120.0_f64).asin();
        let side = 500.0 * beta.tan();
        let rod = linkage::Vector2::new(500.0, -side);
        // From the shaft through the rod to the slider: the same force.
        assert!((found.f1 - rod).norm() < 1e-10);
        assert!((found.f2 - rod).norm() < 1e-10);
        assert!((found.f3 + rod).norm() < 1e-10);
        assert!((found.f4 - linkage::Vector2::new(0.0, side)).norm() < 1e-10);
        let torque = -500.0 * 40.0 * (phi + beta).sin() / beta.cos();
        assert!((found.t - torque).abs() < 1e-9);
        assert!((linkage.alone(phi, 500.0).t - found.t).abs() < 1e-9);
    }
}

/// Down to 1e-12 radians from the dead point, the advantage is exact to rounding.
#[test]
fn toggle() {
    let linkage = Toggle::default().assemble().expect("it assembles");
    for exponent in -12..0 {
        for sign in [-1.0, 1.0] {
            let lean: f64 = sign * 0.37 * 10f64.powi(exponent);
            let found = linkage.statics(lean, 500.0);
            let knee = 100.0 * lean.sin();
            let tan = knee / (110.0 * 110.0 - knee * knee).sqrt();
            // The ram rises by knee + tan * height for each radian.
            let rise = knee + tan * 100.0 * lean.cos();
            close(found.gain, -1.0 / rise, 1e-13);
            close(found.t, -500.0 * rise, 1e-13);
            close(found.f2.x, -500.0 * tan, 1e-13);
            close(found.f2.y, -500.0, 1e-13);
            close(found.f4.x, 500.0 * tan, 1e-13);
        }
    }
}

/// Reactions grow as one over the margin, and keep all digits where the margin does.
#[test]
fn nearly_parallel_guides() {
    let linkage = Wedge::default().assemble().expect("it assembles");
    for exponent in -12..0 {
        let phi: f64 = 0.83 * 10f64.powi(exponent);
        let found = linkage.statics(phi, 500.0);
        close(found.m, phi.sin(), 1e-14);
        close(found.f2.x, 500.0, 1e-14);
        close(found.f2.y, -500.0 / phi.tan(), 1e-14);
        close(found.f4.y, 500.0 / phi.tan(), 1e-14);
        close(found.f2.norm(), 500.0 / found.m, 1e-14);
        assert!((found.f1 - found.f2).norm() <= 1e-14 * found.f2.norm());
        assert!((found.f3 + found.f2).norm() <= 1e-14 * found.f2.norm());
    }
}

/// Here one rounding of the lengths changes the margin by its square: the reaction keeps what is left.
#[test]
fn stretched_links() {
    let linkage = Stretched::default().assemble().expect("it assembles");
    let (a, b, c, d) = (30.0, 70.0, 50.0, 90.0_f64);
    for exponent in -6..0 {
        let phi: f64 = 0.83 * 10f64.powi(exponent);
        let found = linkage.statics(phi, 300.0);
        // (b + c)^2 less the square of the distance that the links bridge is 4 a d sin^2(phi / 2).
        let half: f64 = (a * d / (b * c)).sqrt() * (phi / 2.0).sin();
        let margin = 2.0 * half * (1.0 - half * half).sqrt();
        let inherent = 1e-15 / (margin * margin);
        close(found.m, margin, inherent);
        // The coupler's force at the rocker's end balances the torque.
        close(found.f3.norm(), 300.0 / (c * margin), inherent);
        close(found.t, -300.0 * found.w, inherent);
    }
}
