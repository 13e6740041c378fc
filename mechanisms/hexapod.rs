// A platform on six legs: lengths from poses, poses from lengths.

linkage::mechanism! {
    /// Lengths to pose. No ranges: the poses that the legs reach are no box.
    pub struct ToPose {
        unit mm;
        input l1 = 454.35742mm;
        input l2 = 468.552604mm;
        input l3 = 488.341676mm;
        input l4 = 461.66999mm;
        input l5 = 410.067397mm;
        input l6 = 458.630351mm;
        unknown body = frame((10mm, -20mm, 400mm), (1, 0.15, 0.05), (0, 0, 1));
        loop distance(point_in(body, (150mm, -60mm, -14mm)), (310mm, 40mm, -12mm)) = l1;
        loop distance(point_in(body, (130mm, 85mm, 9mm)), (180mm, 275mm, 18mm)) = l2;
        loop distance(point_in(body, (10mm, 160mm, -11mm)), (-120mm, 300mm, -25mm)) = l3;
        loop distance(point_in(body, (-145mm, 75mm, 16mm)), (-325mm, 60mm, 10mm)) = l4;
        loop distance(point_in(body, (-120mm, -105mm, -7mm)), (-150mm, -290mm, 22mm)) = l5;
        loop distance(point_in(body, (35mm, -155mm, 12mm)), (205mm, -250mm, -8mm)) = l6;
    }

    impl ToPose {
        pub fn pose(l1, l2, l3, l4, l5, l6) -> Pose { body }
        pub fn rates(l1, l2, l3, l4, l5, l6) -> Rates { v: velocity(body.origin), w: omega(body) }
    }
}

linkage::mechanism! {
    /// Pose to lengths: the platform turned about z, then y, then x, all fixed.
    pub struct ToLegs {
        unit mm;
        input x = 12mm in -150mm..150mm;
        input y = -18mm in -150mm..150mm;
        input z = 420mm in 300mm..550mm;
        input roll  = 0deg in -30deg..30deg;
        input pitch = 0deg in -30deg..30deg;
        input yaw   = 0deg in -30deg..30deg;
        let p = (x, y, z);
        let ex = turn(turn(turn((1, 0, 0), (0, 0, 1), yaw), (0, 1, 0), pitch), (1, 0, 0), roll);
        let ez = turn(turn(turn((0, 0, 1), (0, 0, 1), yaw), (0, 1, 0), pitch), (1, 0, 0), roll);
        let body = frame(p, ex, ez);
        let l1 = distance(point_in(body, (150mm, -60mm, -14mm)), (310mm, 40mm, -12mm));
        let l2 = distance(point_in(body, (130mm, 85mm, 9mm)), (180mm, 275mm, 18mm));
        let l3 = distance(point_in(body, (10mm, 160mm, -11mm)), (-120mm, 300mm, -25mm));
        let l4 = distance(point_in(body, (-145mm, 75mm, 16mm)), (-325mm, 60mm, 10mm));
        let l5 = distance(point_in(body, (-120mm, -105mm, -7mm)), (-150mm, -290mm, 22mm));
        let l6 = distance(point_in(body, (35mm, -155mm, 12mm)), (205mm, -250mm, -8mm));
    }

    impl ToLegs {
        pub fn legs(x, y, z, roll, pitch, yaw) -> Legs { l1, l2, l3, l4, l5, l6 }
        /// With what the legs do when the platform is shifted.
        pub fn shifts(x, y, z, roll, pitch, yaw) -> Shifts {
            l1: velocity(l1), l2: velocity(l2), l3: velocity(l3),
            l4: velocity(l4), l5: velocity(l5), l6: velocity(l6),
        }
    }
}
