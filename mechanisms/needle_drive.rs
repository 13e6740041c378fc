// The needle drive of a sewing machine in space.

linkage::mechanism! {
    /// The arm shaft is the x axis, z points upwards, the needle bar is vertical.
    pub struct NeedleDrive {
        unit mm;

        param crank     = 10mm +- 10um;
        param rod       = 48mm +- 15um;
        param pivot     = (45mm, 0mm, -50mm) +- 20um;
        param tilt      = 25deg +- 2arcmin;           // of the rocker's axis, from horizontal
        param short_arm = 38mm +- 15um;
        param long_arm  = 62mm +- 15um;
        param link      = 28mm +- 15um;
        param bar       = (104mm, 0mm);               // where the needle bar passes the shaft
        param below     = 70mm;                       // the needle's point below the bar's joint

        input phi = 0deg in 0deg..360deg;

        const x = (1, 0, 0);
        const y = (0, 1, 0);
        const z = (0, 0, 1);

        // One lever, two arms: the short one towards the shaft.
        let pin = turn(crank * y, x, phi);
        let axis = turn(-y, x, tilt);
        unknown psi = -7deg;
        let ball = pivot - turn(short_arm * x, axis, psi);
        loop distance(pin, ball) = rod;

        let eye = pivot + turn(long_arm * x, axis, psi);
        unknown height = -84mm;
        let joint = (bar.x, bar.y, 0) + height * z;
        loop distance(eye, joint) = link;
        let point = joint - below * z;
    }

    impl NeedleDrive {
        /// Height of the needle's point.
        pub fn needle(phi) -> Needle { z: point.z }
        /// With both derivatives, and the distance from a dead point.
        pub fn motion(phi) -> Motion {
            z: point.z, v: velocity(point.z), a: acceleration(point.z), margin: margin(),
        }
        /// All joints, to draw the machine from.
        pub fn joints(phi) -> Joints { pin, ball, pivot, axis, eye, joint, point }
        /// What the dimensions do to the needle.
        pub fn accuracy(phi) -> Accuracy { e: sensitivity(point.z) }
    }
}
