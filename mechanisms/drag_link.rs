// A drag link: both cranks make whole turns, and half of the driven angle drives a second dyad.

linkage::mechanism! {
    /// Drag link, a 2:1 gear on its driven crank's shaft, and a rocker driven from the gear.
    pub struct DragLink {
        unit mm;

        param frame   = 20mm;
        param driving = 50mm;
        param coupler = 45mm;
        param driven  = 60mm;

        input phi = 60deg in 0deg..720deg;

        unknown theta = 178deg;
        unknown psi   = 130deg;
        loop polar(driving, phi) + polar(coupler, theta) = (frame, 0) + polar(driven, psi);

        param eccentric = 15mm;
        param rod       = 70mm;
        param rocker    = 40mm;
        param pivot     = (-45mm, 0mm);

        let half = psi / 2;
        unknown tilt  = 158deg;
        unknown swing = 81deg;
        loop (frame, 0) + polar(eccentric, half) + polar(rod, tilt) = pivot + polar(rocker, swing);
    }

    impl DragLink {
        /// The driven crank and the rocker.
        pub fn angles(phi) -> DragAngles { psi, swing }
        /// Speed ratios, and the distance from a dead point.
        pub fn rates(phi) -> DragRates {
            driven: d(psi, phi),
            rocker: d(swing, phi),
            margin: margin(),
        }
    }
}
