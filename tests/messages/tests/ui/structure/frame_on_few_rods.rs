//! Bodies that too few loops hold, none, and too many; and estimates that are no frames.

use linkage::mechanism;

mechanism! {
    pub struct TooFew {
        unit mm;
        input lift = 200mm;
        unknown body = frame((0mm, 0mm, 170mm), (1, 0, 0), (0, 0, 1));
        loop distance(body.origin, (100mm, 0mm, 0mm)) = lift;
        loop distance(body.origin, (-50mm, 85mm, 0mm)) = 200mm;
        loop distance(body.origin, (-50mm, -85mm, 0mm)) = 200mm;
        loop distance(point_in(body, (60mm, 0mm, 0mm)), (80mm, 70mm, 0mm)) = 190mm;
        loop distance(point_in(body, (60mm, 0mm, 0mm)), (80mm, -70mm, 0mm)) = 190mm;
    }
    impl TooFew {
        pub fn pose(lift) -> Pose { body }
    }
}

mechanism! {
    pub struct Free {
        unit mm;
        input lift = 200mm;
        unknown y = 80mm;
        unknown body = frame((0mm, 0mm, 170mm), (1, 0, 0), (0, 0, 1));
        loop y = 0.5 * lift;
    }
    impl Free {
        pub fn pose(lift) -> FreePose { body, y }
    }
}

mechanism! {
    pub struct TooMany {
        unit mm;
        input lift = 200mm;
        unknown body = frame((0mm, 0mm, 170mm), (1, 0, 0), (0, 0, 1));
        loop distance(body.origin, (100mm, 0mm, 0mm)) = lift;
        loop distance(body.origin, (-50mm, 85mm, 0mm)) = 200mm;
        loop distance(body.origin, (-50mm, -85mm, 0mm)) = 200mm;
        loop distance(point_in(body, (60mm, 0mm, 0mm)), (80mm, 70mm, 0mm)) = 190mm;
        loop distance(point_in(body, (60mm, 0mm, 0mm)), (80mm, -70mm, 0mm)) = 190mm;
        loop distance(point_in(body, (10mm, 50mm, 0mm)), (0mm, 80mm, 0mm)) = 180mm;
        loop distance(point_in(body, (10mm, -50mm, 0mm)), (0mm, -80mm, 0mm)) = 180mm;
    }
    impl TooMany {
        pub fn pose(lift) -> ManyPose { body }
    }
}

mechanism! {
    /// Enough rods, of which three in one plane lead to one point.
    pub struct NotHeld {
        unit mm;
        input lift = 200mm;
        unknown body = frame((0mm, 0mm, 170mm), (1, 0, 0), (0, 0, 1));
        loop distance(body.origin, (100mm, 0mm, 0mm)) = lift;
        loop distance(body.origin, (-50mm, 85mm, 0mm)) = 200mm;
        loop distance(body.origin, (-50mm, -85mm, 0mm)) = 200mm;
        loop distance(point_in(body, (60mm, 0mm, 0mm)), (80mm, 70mm, 0mm)) = 190mm;
        loop distance(point_in(body, (60mm, 0mm, 0mm)), (80mm, -70mm, 0mm)) = 190mm;
        loop distance(point_in(body, (60mm, 0mm, 0mm)), (80mm, 0mm, 0mm)) = 180mm;
    }
    impl NotHeld {
        pub fn pose(lift) -> NotHeldPose { body }
    }
}

mechanism! {
    /// Two rods too many: the last one leads to a point that three rods hold.
    pub struct Eight {
        unit mm;
        input lift = 200mm;
        unknown body = frame((0mm, 0mm, 170mm), (1, 0, 0), (0, 0, 1));
        loop distance(body.origin, (100mm, 0mm, 0mm)) = lift;
        loop distance(body.origin, (-50mm, 85mm, 0mm)) = 200mm;
        loop distance(body.origin, (-50mm, -85mm, 0mm)) = 200mm;
        loop distance(point_in(body, (60mm, 0mm, 0mm)), (80mm, 70mm, 0mm)) = 190mm;
        loop distance(point_in(body, (60mm, 0mm, 0mm)), (80mm, -70mm, 0mm)) = 190mm;
        loop distance(point_in(body, (10mm, 50mm, 0mm)), (0mm, 80mm, 0mm)) = 180mm;
        loop distance(point_in(body, (10mm, -50mm, 0mm)), (0mm, -80mm, 0mm)) = 180mm;
        loop distance(body.origin, (0mm, 120mm, 0mm)) = 210mm;
    }
    impl Eight {
        pub fn pose(lift) -> EightPose { body }
    }
}

mechanism! {
    /// Two rods too many that close all the same: the point to which they lead runs on a circle about the line of their other ends.
    pub struct Closing {
        unit mm;
        input lift = 200mm;
        unknown body = frame((0mm, 0mm, 170mm), (1, 0, 0), (0, 0, 1));
        loop distance(body.origin, (100mm, 0mm, 0mm)) = lift;
        loop distance(body.origin, (-50mm, 85mm, 0mm)) = 200mm;
        loop distance(body.origin, (-50mm, -85mm, 0mm)) = 200mm;
        loop distance(point_in(body, (60mm, 0mm, 0mm)), (80mm, 70mm, 0mm)) = 190mm;
        loop distance(point_in(body, (60mm, 0mm, 0mm)), (80mm, -70mm, 0mm)) = 190mm;
        loop distance(point_in(body, (10mm, 50mm, 0mm)), (0mm, 80mm, 0mm)) = 180mm;
        loop distance(point_in(body, (60mm, 0mm, 0mm)), (80mm, 0mm, 0mm)) = 176.6352173265569mm;
        loop distance(point_in(body, (60mm, 0mm, 0mm)), (80mm, 35mm, 0mm)) = 180.0694310536911mm;
    }
    impl Closing {
        pub fn pose(lift) -> ClosingPose { body }
    }
}

fn main() {}
