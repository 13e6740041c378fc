// A wheel on five rods by the travel of the wheel and the shift of a rack on the fifth rod.

linkage::mechanism! {
    /// A left wheel: x points forwards, y outwards, z up.
    pub struct FiveLinkAxle {
        unit mm;
        param rod1 = 287.31515797117283314mm;
        param rod2 = 256.75864152935534645mm;
        param rod3 = 318.62987932709637832mm;
        param rod4 = 451.60823730308551581mm;
        param rod5 = 376.15422369023054744mm;
        // On the chassis; the rack shifts the fifth.
        param inner1 = (110mm, 420mm, 430mm);
        param inner2 = (-85mm, 435mm, 440mm);
        param inner3 = (265mm, 480mm, 265mm);
        param inner4 = (-60mm, 255mm, 215mm);
        param inner5 = (-190mm, 316mm, 258mm);
        // On the carrier, from the centre of the wheel.
        param outer1 = (15mm, -70mm, 135mm);
        param outer2 = (-30mm, -75mm, 140mm);
        param outer3 = (40mm, -60mm, -105mm);
        param outer4 = (-25mm, -55mm, -120mm);
        param outer5 = (-150mm, -70mm, -58mm);

        input travel = 0mm in -80mm..80mm;
        input rack   = 0mm in -15mm..15mm;
        unknown carrier = frame((0mm, 760mm, 320mm), (1, 0, 0), (0, 0, 1));
        let ball1 = point_in(carrier, outer1);
        let ball2 = point_in(carrier, outer2);
        let ball3 = point_in(carrier, outer3);
        let ball4 = point_in(carrier, outer4);
        let ball5 = point_in(carrier, outer5);
        let steered = inner5 + (0mm, rack, 0mm);
        loop distance(ball1, inner1) = rod1;
        loop distance(ball2, inner2) = rod2;
        loop distance(ball3, inner3) = rod3;
        loop distance(ball4, inner4) = rod4;
        loop distance(ball5, steered) = rod5;
        loop carrier.origin.z = 320mm + travel;

        let spindle = unit(0.0035 * carrier.x + carrier.y + 0.0175 * carrier.z);
        let toe = atan2(spindle.x, spindle.y);
        let camber = atan2(-spindle.z, norm((spindle.x, spindle.y)));
        // Where the wheel of 310 mm stands on the road: its lowest point.
        let up = unit((0, 0, 1) - spindle.z * spindle);
        let contact = carrier.origin - 310mm * up;
        let base = contact.x;
        let track = 2 * contact.y;
    }

    impl FiveLinkAxle {
        pub fn wheel(travel, rack) -> Wheel { toe, camber, track, base }
        pub fn motion(travel, rack) -> Motion {
            toe: velocity(toe), camber: velocity(camber), track: velocity(track), base: velocity(base),
            toe_bends: acceleration(toe), camber_bends: acceleration(camber),
            track_bends: acceleration(track), base_bends: acceleration(base),
        }
        /// The carrier as it moves, for the axis of its screw.
        pub fn body(travel, rack) -> Body { carrier, v: velocity(carrier.origin), w: omega(carrier) }
        /// Height of the roll centre over the road. Seen from the front the wheel turns about a point on the normal to the way of the point of the
        /// carrier that is its point of contact; the body rolls about where that normal meets the middle of the vehicle.
        // Written out three times: a quantity knows the names of the struct block only, and `let` takes no derivatives.
        pub fn roll(travel, rack) -> Roll {
            roll_centre: contact.y * (velocity(carrier.origin)[0] + cross(omega(carrier)[0], contact - carrier.origin)).y
                / (velocity(carrier.origin)[0] + cross(omega(carrier)[0], contact - carrier.origin)).z,
            shift: velocity(contact.y * (velocity(carrier.origin)[0] + cross(omega(carrier)[0], contact - carrier.origin)).y
                / (velocity(carrier.origin)[0] + cross(omega(carrier)[0], contact - carrier.origin)).z),
            by_dimensions: sensitivity(contact.y * (velocity(carrier.origin)[0] + cross(omega(carrier)[0], contact - carrier.origin)).y
                / (velocity(carrier.origin)[0] + cross(omega(carrier)[0], contact - carrier.origin)).z),
        }
        pub fn adjustment(travel, rack) -> Adjustment {
            toe: sensitivity(toe), camber: sensitivity(camber), track: sensitivity(track), base: sensitivity(base),
        }
        pub fn picture(travel, rack) -> Picture { shape: picture() }
    }
}
