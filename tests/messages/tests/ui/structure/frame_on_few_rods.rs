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

fn main() {}
