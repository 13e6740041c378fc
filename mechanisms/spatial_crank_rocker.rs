// A spatial crank-rocker with an arbitrarily tilted rocker (RSSR).

linkage::mechanism! {
    /// A crank about the x axis and a rocker about an axis that is tilted twice.
    pub struct SpatialCrankRocker {
        unit mm;

        param l12 = 30mm;
        param p4 = (110mm, 30mm, -50mm);
        param gamma1 = 15deg;                  // the rocker's axis: from z about y,
        param gamma2 = -20deg;                 // then about the new x
        param l43 = 70mm;
        param l23 = 130mm;
        param angle_coupler = 90deg;           // of the frame's z axis to the coupler
        param angle_pin = 90deg;               // and to the pin of the crank
        param tool = (90mm, 15mm, -25mm);      // in the coupler's frame

        input phi = 0deg in 0deg..360deg;

        const x = (1, 0, 0);
        const y = (0, 1, 0);
        const z = (0, 0, 1);

        // Crank from the y axis, rocker from the new x axis.
        let p2 = turn(l12 * y, x, phi);
        let new_x = turn(x, y, gamma1);
        let axis = turn(turn(z, y, gamma1), new_x, gamma2);
        unknown psi = 100deg;
        let p3 = p4 + turn(l43 * new_x, axis, psi);
        loop distance(p2, p3) = l23;

        // The pin of the crank is parallel to the crank's axis.
        unknown upward = (0, 0.7, 0.7);
        loop norm(upward) = 1;
        loop dot(upward, p3 - p2) = l23 * cos(angle_coupler);
        loop dot(upward, x) = cos(angle_pin);
        let coupler = frame(p2, p3 - p2, upward);
        let tip = point_in(coupler, tool);
    }

    impl SpatialCrankRocker {
        /// The rocker and the tool point with their kinematic coefficients.
        pub fn motion(phi) -> Motion {
            psi, dpsi: velocity(psi), ddpsi: acceleration(psi),
            tip, v: velocity(tip), a: acceleration(tip),
        }
        /// All links, for drawings.
        pub fn picture(phi) -> Picture { shape: picture() }
        /// What all dimensions do to the tool point.
        pub fn accuracy(phi) -> Accuracy { tip, e: sensitivity(tip) }
        /// Joints, and the frame of the coupler.
        pub fn pose(phi) -> Pose { p2, p3, axis, coupler, margin: margin() }
    }
}
