// A double wishbone by the travel of the wheel and the shift of the rack.

linkage::mechanism! {
    /// A left wheel: x points forwards, y outwards, z up. An arm is two rods from its ball joint.
    pub struct DoubleWishbone {
        unit mm;
        param upper_front_rod = 249.59767627123454452mm;
        param upper_rear_rod  = 231.66570743206686351mm;
        param lower_front_rod = 372.08869910278113686mm;
        param lower_rear_rod  = 373.43004699675681025mm;
        param tie_rod         = 273.33130080545111253mm;
        param upper_front = (95mm, 455mm, 505mm);
        param upper_rear  = (-125mm, 480mm, 490mm);
        param tie         = (-125mm, 422mm, 267mm);
        const lower_front = (170mm, 380mm, 225mm);
        const lower_rear  = (-190mm, 400mm, 215mm);

        input travel = 0mm in -80mm..80mm;
        input rack   = 0mm in -40mm..40mm;
        unknown carrier = frame((0mm, 770mm, 320mm), (1, 0, 0), (0, 0, 1));
        let upper = point_in(carrier, (-12mm, -90mm, 200mm));
        let lower = point_in(carrier, (10mm, -55mm, -120mm));
        let outer = point_in(carrier, (-135mm, -75mm, -62mm));
        loop distance(upper, upper_front) = upper_front_rod;
        loop distance(upper, upper_rear) = upper_rear_rod;
        loop distance(lower, lower_front) = lower_front_rod;
        loop distance(lower, lower_rear) = lower_rear_rod;
        loop distance(outer, tie + (0mm, rack, 0mm)) = tie_rod;
        loop carrier.origin.z = 320mm + travel;

        let x = carrier.origin.x;
        let y = carrier.origin.y;
        let spindle = unit(0.0017 * carrier.x + carrier.y + 0.0087 * carrier.z);
        let toe = atan2(spindle.x, spindle.y);
        let camber = atan2(-spindle.z, norm((spindle.x, spindle.y)));
    }

    impl DoubleWishbone {
        pub fn wheel(travel, rack) -> Wheel { toe, camber, x, y }
        pub fn motion(travel, rack) -> Motion {
            x: velocity(x), y: velocity(y), toe: velocity(toe), camber: velocity(camber),
            x_bends: acceleration(x), y_bends: acceleration(y),
            toe_bends: acceleration(toe), camber_bends: acceleration(camber),
        }
        pub fn adjustment(travel, rack) -> Adjustment {
            x: sensitivity(x), y: sensitivity(y), toe: sensitivity(toe), camber: sensitivity(camber),
        }
        pub fn picture(travel, rack) -> Picture { shape: picture() }
    }
}
