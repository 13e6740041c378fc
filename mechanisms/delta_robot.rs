// A delta robot: three driven arms, a platform that moves without turning; and the inverse.

linkage::mechanism! {
    /// Drives to platform. The z axis points upwards, arms turn downwards from horizontal.
    pub struct Delta {
        unit mm;

        param base  = 160mm +- 20um;           // from the middle to the shafts
        param foot  = 45mm  +- 10um;           // from the platform's middle to the rods
        param arm1 = 200mm +- 20um;
        param arm2 = 200mm +- 20um;
        param arm3 = 200mm +- 20um;
        param rod1 = 420mm +- 20um;
        param rod2 = 420mm +- 20um;
        param rod3 = 420mm +- 20um;
        param zero1 = 0deg +- 20arcsec;        // of the drives
        param zero2 = 0deg +- 20arcsec;
        param zero3 = 0deg +- 20arcsec;

        input phi1 = 20deg in -20deg..60deg;
        input phi2 = 20deg in -20deg..60deg;
        input phi3 = 20deg in -20deg..60deg;

        const z = (0, 0, 1);
        let elbow1 = (base + arm1 * cos(phi1 + zero1), 0, -arm1 * sin(phi1 + zero1));
        let elbow2 = turn((base + arm2 * cos(phi2 + zero2), 0, -arm2 * sin(phi2 + zero2)), z, 120deg);
        let elbow3 = turn((base + arm3 * cos(phi3 + zero3), 0, -arm3 * sin(phi3 + zero3)), z, 240deg);

        unknown p = (0mm, 0mm, -350mm);
        let foot1 = p + (foot, 0, 0);
        let foot2 = p + turn((foot, 0, 0), z, 120deg);
        let foot3 = p + turn((foot, 0, 0), z, 240deg);
        loop distance(foot1, elbow1) = rod1;
        loop distance(foot2, elbow2) = rod2;
        loop distance(foot3, elbow3) = rod3;
    }

    impl Delta {
        /// The platform's middle.
        pub fn platform(phi1, phi2, phi3) -> Platform { p }
        /// With its Jacobian, its Hessian, and the distance from a singular position.
        pub fn motion(phi1, phi2, phi3) -> Motion {
            p, jacobian: velocity(p), hessian: acceleration(p), margin: margin(),
        }
        /// All joints, to draw the robot from.
        pub fn joints(phi1, phi2, phi3) -> Joints { elbow1, elbow2, elbow3, foot1, foot2, foot3 }
        /// What the dimensions and the drives do to the platform.
        pub fn accuracy(phi1, phi2, phi3) -> Accuracy { e: sensitivity(p) }
    }
}

linkage::mechanism! {
    /// Platform to drives: each arm is a loop of its own.
    pub struct Back {
        unit mm;

        param base = 160mm;
        param foot = 45mm;
        param arm  = 200mm;
        param rod  = 420mm;

        input x = 0mm    in -150mm..150mm;
        input y = 0mm    in -150mm..150mm;
        input z = -360mm in -450mm..-300mm;

        unknown phi1 = 20deg;
        unknown phi2 = 20deg;
        unknown phi3 = 20deg;
        const up = (0, 0, 1);
        // Each arm in the plane of its shaft: the platform is turned instead.
        let p1 = (x, y, z);
        let p2 = turn(p1, up, -120deg);
        let p3 = turn(p1, up, -240deg);
        let reach = (base - foot, 0, 0);
        loop distance(p1, reach + arm * (cos(phi1), 0, -sin(phi1))) = rod;
        loop distance(p2, reach + arm * (cos(phi2), 0, -sin(phi2))) = rod;
        loop distance(p3, reach + arm * (cos(phi3), 0, -sin(phi3))) = rod;
    }

    impl Back {
        pub fn drives(x, y, z) -> Drives { phi1, phi2, phi3 }
    }
}
