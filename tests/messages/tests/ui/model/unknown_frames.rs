//! Unknown frames whose estimates are no frames, and derivatives that they do not have.

use linkage::mechanism;

mechanism! {
    pub struct Parallel {
        unit mm;
        input lift = 200mm;
        unknown body = frame((0mm, 0mm, 170mm), (1, 0, 0), (2, 0, 0));
        loop body.origin = (0mm, 0mm, lift);
        loop dot(body.x, (0, 0, 1)) = 0;
        loop dot(body.y, (0, 0, 1)) = 0;
        loop dot(body.y, (1, 0, 0)) = 0.1;
    }
    impl Parallel {
        pub fn pose(lift) -> ParallelPose { body }
    }
}

mechanism! {
    pub struct Numbers {
        unit mm;
        input lift = 200mm;
        unknown body = frame((0, 3, 170), (1, 0, 0), (0, 0, 1));
        unknown arm = frame((0mm, 3mm, lift), (1, 0, 0), (0, 0, 1));
        loop body.origin = (0mm, 0mm, lift);
        loop body = arm;
    }
    impl Numbers {
        pub fn pose(lift) -> NumbersPose { body }
    }
}

mechanism! {
    pub struct Derived {
        unit mm;
        param lift = 200mm;
        unknown body = frame((0mm, 0mm, 170mm), (1, 0, 0), (0, 0, 1));
        loop body.origin = (0mm, 0mm, lift);
        loop dot(body.x, (0, 0, 1)) = 0;
        loop dot(body.y, (0, 0, 1)) = 0;
        loop dot(body.y, (1, 0, 0)) = 0.1;
    }
    impl Derived {
        pub fn pose() -> DerivedPose { a: sensitivity(body), b: d(body.x, body) }
    }
}

fn main() {}
