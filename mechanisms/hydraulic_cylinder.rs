// A boom that a hydraulic cylinder lifts: the input is a length.

linkage::mechanism! {
    /// Boom on a pivot at the origin; the cylinder stands in front of it, below.
    pub struct Boom {
        unit m;

        param foot   = (0.6m +- 1mm, -0.8m +- 1mm);
        param arm    = 1.1m +- 1mm;           // from the boom's pivot to the piston rod's eye
        param closed = 1.2m +- 1mm;           // the cylinder without stroke, between its eyes
        param reach  = 3m;
        param bend   = -10deg;                // of the boom, between eye and tip

        input stroke = 0.3m in 0m..0.6m;

        unknown cylinder = 80deg;
        unknown lift     = 38deg;
        loop foot + polar(closed + stroke, cylinder) = polar(arm, lift);
        let tip = polar(reach, lift + bend);
    }

    impl Boom {
        /// Angles of cylinder and boom, and the tip.
        pub fn position(stroke) -> BoomPosition { cylinder, lift, tip }
        /// How fast boom and tip move with the stroke.
        pub fn motion(stroke) -> BoomMotion {
            rate: velocity(lift),
            height: velocity(tip.y),
            bend: acceleration(tip.y),
            margin: margin(),
        }
        /// What the dimensions do to the boom's angle.
        pub fn accuracy(stroke) -> BoomAccuracy { e: sensitivity(lift), dstroke: d(lift, stroke) }
    }
}
