// The quick return of a shaper: crank and slotted lever (RPR), then a rod to the ram (RRP).

linkage::mechanism! {
    /// Shaper drive; the lever's pivot is the origin, the crank's pivot stands above it.
    pub struct QuickReturn {
        unit mm;

        param frame  = 300mm;
        param crank  = 120mm;
        param lever  = 600mm;
        param rod    = 200mm;
        param height = 575mm;      // of the ram's path above the lever's pivot

        input phi = 90deg in 0deg..360deg;

        unknown along = 420mm;     // from the lever's pivot to the crank pin
        unknown psi   = 90deg;
        loop (0, frame) + polar(crank, phi) = polar(along, psi);

        unknown tilt = -7deg;
        unknown ram  = 200mm;
        loop polar(lever, psi) + polar(rod, tilt) = (ram, height);
    }

    impl QuickReturn {
        /// Lever, rod and ram.
        pub fn position(phi) -> Position { along, psi, tilt, ram }
        /// The ram and its kinematic coefficients.
        pub fn stroke(phi) -> Stroke { ram, v: velocity(ram), a: acceleration(ram) }
    }
}
