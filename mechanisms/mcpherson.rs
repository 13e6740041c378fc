// A McPherson strut by the travel of the wheel.

linkage::mechanism! {
    /// A left wheel: x points forwards, y outwards, z up. An arm is two rods from its ball joint.
    pub struct McPherson {
        unit mm;
        param front_rod = 346.04912945996555419mm;
        param rear_rod  = 446.84896777322872092mm;
        param tie_rod   = 350.19423182000014205mm;
        param top_mount = (-25mm, 580mm, 850mm);
        param front = (15mm, 380mm, 215mm);
        param rear  = (-300mm, 400mm, 222mm);
        param tie   = (-130mm, 350mm, 288mm);

        input travel = 0mm in -80mm..80mm;
        unknown carrier = frame((0mm, 760mm, 310mm), (1, 0, 0), (0, 0, 1));
        let ball = point_in(carrier, (5mm, -35mm, -120mm));
        loop distance(ball, front) = front_rod;
        loop distance(ball, rear) = rear_rod;
        loop distance(point_in(carrier, (-140mm, -60mm, -28mm)), tie) = tie_rod;
        // The damper's axis has the direction (-17, -72, 450) on the carrier; these two are perpendicular to it.
        let strut = top_mount - point_in(carrier, (-8mm, -108mm, 90mm));
        loop dot(strut, carrier.x + 17 / 450 * carrier.z) = 0;
        loop dot(strut, carrier.y + 72 / 450 * carrier.z) = 0;
        loop carrier.origin.z = 310mm + travel;

        let x = carrier.origin.x;
        let y = carrier.origin.y;
        let spindle = unit(0.0017 * carrier.x + carrier.y + 0.0087 * carrier.z);
        let toe = atan2(spindle.x, spindle.y);
        let camber = atan2(-spindle.z, norm((spindle.x, spindle.y)));
        let strut_length = norm(strut);
    }

    impl McPherson {
        pub fn wheel(travel) -> Wheel { toe, camber, x, y, strut_length }
        pub fn motion(travel) -> Motion {
            x: d(x, travel), y: d(y, travel), toe: d(toe, travel), camber: d(camber, travel),
            strut_length: d(strut_length, travel),
        }
        pub fn bends(travel) -> Bends {
            x: acceleration(x), y: acceleration(y), toe: acceleration(toe), camber: acceleration(camber),
            strut_length: acceleration(strut_length),
        }
        pub fn adjustment(travel) -> Adjustment {
            x: sensitivity(x), y: sensitivity(y), toe: sensitivity(toe), camber: sensitivity(camber),
        }
        pub fn picture(travel) -> Picture { shape: picture() }
    }
}
