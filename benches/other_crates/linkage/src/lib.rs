//! The four-bar in linkage.

linkage::mechanism! {
    /// A crank-rocker with a tracer point on its coupler.
    pub struct FourBar {
        unit mm;
        param a = 50mm;
        param b = 120mm;
        param c = 100mm;
        param dx = 140mm;
        param dy = 0mm;
        param p = 70mm;
        param u = 25deg;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        loop polar(a, phi) + polar(b, theta) = (dx, dy) + polar(c, psi);
        let q = polar(a, phi) + polar(p, theta + u);
    }
    impl FourBar {
        pub fn point(phi) -> Point { q }
        pub fn motion(phi) -> Motion { q, v: velocity(q), a: acceleration(q) }
        pub fn sensitivities(phi) -> Sensitivities { q, e: sensitivity(q) }
        pub fn rocker(phi) -> Rocker { psi, v: velocity(psi) }
    }
}
