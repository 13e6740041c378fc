// Three linkages on one main shaft.

linkage::mechanism! {
    /// Needles and tongues: a crank-rocker, and two rods on its rocker.
    pub struct NeedleDrive {
        unit mm;
        param crank = 12mm;
        param coupler = 60mm;
        param rocker = 45mm;
        param pivot = (60mm, -20mm);
        param needle_arm = 70mm;
        param needle_rod = 50mm;
        param tongue_arm = 60mm;
        param tongue_rod = 40mm;

        input phi = 0deg in 0deg..360deg;
        unknown theta = 24deg;
        unknown psi = 81deg;
        loop polar(crank, phi) + polar(coupler, theta) = pivot + polar(rocker, psi);

        unknown needle_lean = 90deg;
        unknown needle = 31mm;
        loop pivot + polar(needle_arm, psi - 80deg) + polar(needle_rod, needle_lean) = (130mm, needle);

        unknown tongue_lean = 80deg;
        unknown tongue = 30mm;
        loop pivot + polar(tongue_arm, psi - 70deg) + polar(tongue_rod, tongue_lean) = (125mm, tongue);
    }

    impl NeedleDrive {
        pub fn needle(phi) -> Needle { needle }
        pub fn tongue(phi) -> Tongue { tongue }
        /// Both together: the crank-rocker is evaluated once.
        pub fn heights(phi) -> Heights { needle, tongue }
        /// What the drive has to accelerate.
        pub fn motion(phi) -> NeedleMotion { needle, v: velocity(needle), a: acceleration(needle) }
    }
}

linkage::mechanism! {
    /// Sinkers: an eccentric and a slide.
    pub struct SinkerDrive {
        unit mm;
        param eccentric = 4mm;
        param rod = 80mm;
        param phase = 90deg;
        input phi = 0deg in 0deg..360deg;
        unknown lean = 0deg;
        unknown sinker = 80mm;
        loop polar(eccentric, phi + phase) + polar(rod, lean) = (sinker, 0);
    }
    impl SinkerDrive {
        pub fn position(phi) -> Sinker { sinker }
    }
}

linkage::mechanism! {
    /// Press: an eccentric and a rocker.
    pub struct PressDrive {
        unit mm;
        param eccentric = 3mm;
        param coupler = 50mm;
        param rocker = 30mm;
        param pivot = (45mm, 30mm);
        input phi = 0deg in 0deg..360deg;
        unknown theta = 70deg;
        unknown press = 140deg;
        loop polar(eccentric, phi) + polar(coupler, theta) = pivot + polar(rocker, press);
    }
    impl PressDrive {
        pub fn position(phi) -> Press { press, margin: margin() }
    }
}
