// A crank that is too long for a part of its turn.

linkage::mechanism! {
    /// A four-bar whose crank cannot turn fully: it is shown over more than it can do.
    pub struct Rocking {
        unit mm;
        param pivot_d = (80mm +- 0.02mm, 0mm +- 0.02mm);
        param crank   = 60mm +- 12um;
        param coupler = 90mm +- 20um;
        param rocker  = 55mm +- 20um;
        param arm     = 60mm;
        param lift    = 35deg +- 30arcsec;
        input phi = 40deg;
        unknown theta = 10deg;
        unknown psi   = 70deg;
        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = pivot_d + polar(rocker, psi);
        let tracer = a + polar(arm, theta + lift);
    }
    impl Rocking {
        pub fn motion(phi) -> Motion { tracer, v: velocity(tracer), a: acceleration(tracer), psi, margin: margin() }
        pub fn accuracy(phi) -> Accuracy { tracer, e: sensitivity(tracer) }
        pub fn picture(phi) -> Picture { shape: picture() }
        pub fn height(phi) -> Height { y: tracer.y, v: velocity(tracer.y), a: acceleration(tracer.y) }
    }
}
