// The ankle of a humanoid: two motors in the shank, two rods to the heel, a foot that pitches and rolls.

linkage::mechanism! {
    /// Foot to motors.
    pub struct ToMotors {
        unit mm;
        param height = 230mm;                  // of the motors' shafts above the joint
        param crank  = 60mm;
        param side   = 45mm;                   // of the rods' planes from the middle
        param heel   = 50mm;
        param rise   = 10mm;
        param rod    = 230mm;

        input pitch = 0deg in -45deg..25deg;
        input roll  = 0deg in -20deg..20deg;
        unknown left  = 0deg;
        unknown right = 0deg;
        const x = (1, 0, 0);
        const y = (0, 1, 0);
        let heel_left  = turn(turn((-heel,  side, rise), x, roll), y, pitch);
        let heel_right = turn(turn((-heel, -side, rise), x, roll), y, pitch);
        loop distance((0,  side, height) + turn((-crank, 0, 0), y, left),  heel_left)  = rod;
        loop distance((0, -side, height) + turn((-crank, 0, 0), y, right), heel_right) = rod;
    }

    impl ToMotors {
        pub fn motors(pitch, roll) -> Motors { left, right }
        /// With the Jacobian and the Hessian.
        pub fn motion(pitch, roll) -> Motion {
            left, right,
            left_by: velocity(left), right_by: velocity(right),
            left_bends: acceleration(left), right_bends: acceleration(right),
        }
    }
}

linkage::mechanism! {
    /// Motors to foot.
    pub struct ToFoot {
        unit mm;
        param height = 230mm;
        param crank  = 60mm;
        param side   = 45mm;
        param heel   = 50mm;
        param rise   = 10mm;
        param rod    = 230mm;

        input left  = 5deg in -36deg..43deg;
        input right = 5deg in -36deg..43deg;
        unknown pitch = 0deg;
        unknown roll  = 0deg;
        const x = (1, 0, 0);
        const y = (0, 1, 0);
        let heel_left  = turn(turn((-heel,  side, rise), x, roll), y, pitch);
        let heel_right = turn(turn((-heel, -side, rise), x, roll), y, pitch);
        loop distance((0,  side, height) + turn((-crank, 0, 0), y, left),  heel_left)  = rod;
        loop distance((0, -side, height) + turn((-crank, 0, 0), y, right), heel_right) = rod;
    }

    impl ToFoot {
        pub fn foot(left, right) -> Foot { pitch, roll, margin: margin() }
        /// With the Jacobian and the Hessian.
        pub fn tilt(left, right) -> Tilt {
            pitch, roll,
            pitch_by: velocity(pitch), roll_by: velocity(roll),
            pitch_bends: acceleration(pitch), roll_bends: acceleration(roll),
        }
    }
}
