// The mechanisms of the tutorial: a sketch, a crank, a four-bar, a six-bar with a dwell.

linkage::mechanism! {
    /// The first step: joints and links.
    pub struct Sketch {
        unit mm;
        input phi = 30deg in 0deg..360deg;
        joint o = (0mm, 0mm), a = (12.1mm, 7mm), b = (39mm, 20mm), p = (33mm, -15mm);
        link frame: o, p;
        link crank: o, a at phi length 14mm;
        link coupler: a, b length 30mm;
        link rocker: p, b length 36mm;
    }
    impl Sketch {
        pub fn motion(phi) -> SketchMotion { b, psi: rocker.angle }
    }
}

linkage::mechanism! {
    /// The second step: a bar that turns.
    pub struct Crank {
        unit mm;
        param crank = 14mm;
        input phi = 30deg in 0deg..360deg;
        let a = polar(crank, phi);
    }
    impl Crank {
        pub fn place(phi) -> Place { a }
        pub fn shape(phi) -> CrankShape { shape: picture() }
    }
}

linkage::mechanism! {
    /// The third step: a loop.
    pub struct FourBar {
        unit mm;
        param crank = 14mm;
        param coupler = 30mm;
        param rocker = 36mm;
        param pivot = (33mm, -15mm);
        input phi = 30deg in 0deg..360deg;
        unknown theta = 25deg;
        unknown psi = 80deg;
        let a = polar(crank, phi);
        let b = a + polar(coupler, theta);
        loop b = pivot + polar(rocker, psi);
    }
    impl FourBar {
        pub fn rocker(phi) -> Rocker { psi, v: velocity(psi) }
        pub fn shape(phi) -> FourBarShape { shape: picture() }
    }
}

linkage::mechanism! {
    /// The last step: the take-up lever of a sewing machine.
    pub struct TakeUp {
        unit mm;
        param crank = 14mm;
        param coupler = 30mm;
        param rocker = 36mm;
        param pivot = (33mm, -15mm);
        param arm = 67mm;
        param bend = 10deg;
        param rod = 37.5mm;
        param lever = 60mm;
        param lever_pivot = (-4mm, 97mm);
        param reach = 80mm;
        input phi = 30deg in 0deg..360deg;

        unknown theta = 25deg;
        unknown psi = 80deg;
        let a = polar(crank, phi);
        let b = a + polar(coupler, theta);
        loop b = pivot + polar(rocker, psi);

        unknown lean = 108deg;
        unknown swing = -14deg;
        let c = a + polar(arm, theta + bend);
        let d = c + polar(rod, lean);
        loop d = lever_pivot + polar(lever, swing);
        let eye = lever_pivot + polar(reach, swing + 180deg);
    }
    impl TakeUp {
        pub fn motion(phi) -> Motion { swing, v: velocity(swing), a: acceleration(swing) }
        pub fn thread(phi) -> Thread { eye, c }
        pub fn shape(phi) -> Shape { shape: picture() }
    }
}
