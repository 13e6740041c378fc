// Universal joints: a single one, and two that run evenly.

linkage::mechanism! {
    /// Three shafts: input and output, and one between them that is bent against both.
    ///
    /// The input shaft is the z axis, all shafts lie in the x-z plane.
    pub struct Cardan {
        param bend    = 30deg +- 5arcmin;   // from the first shaft to the second
        param back    = 30deg +- 5arcmin;   // from the second to the third: Z arrangement
        param twist   = 0deg  +- 30arcmin;  // between the forks of the second shaft

        input phi = 0deg in 0deg..1080deg;

        // Pins of the forks; the axis of a shaft that is bent by `b` is (sin b, 0, cos b).
        let pin_in = turn((0, 1, 0), (0, 0, 1), phi);
        let axis = (sin(bend), 0, cos(bend));
        let level = (cos(bend), 0, -sin(bend));
        unknown psi = 0deg;
        let pin_middle = turn(level, axis, psi);
        loop dot(pin_in, pin_middle) = 0;

        // The other fork of the second shaft, and the third shaft.
        let pin_next = turn(level, axis, psi + twist);
        let axis_out = (sin(bend - back), 0, cos(bend - back));
        unknown out = 0deg;
        let pin_out = turn((0, 1, 0), axis_out, out);
        loop dot(pin_next, pin_out) = 0;
    }

    impl Cardan {
        /// The second shaft, behind one joint.
        pub fn single(phi) -> Single { psi, ratio: velocity(psi), rise: acceleration(psi) }
        /// The third shaft, behind both.
        pub fn double(phi) -> Double { out, ratio: velocity(out) }
        /// What errors of the installation do to the third shaft's angle.
        pub fn accuracy(phi) -> Accuracy { e: sensitivity(out) }
        /// What the bend does to the second shaft's angle.
        pub fn bending(phi) -> Bending { by_bend: d(psi, bend) }
    }
}
