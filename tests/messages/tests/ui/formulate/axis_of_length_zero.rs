//! Axes and unit vectors without a direction, for the default dimensions.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        const first = (1, 2, 2);
        const second = 2 * first;
        param arm = (40mm, 0mm, 0mm);
        param left = (0mm, 10mm, 0mm);
        param right = (0mm, 10mm, 0mm);
        param axis = (0, 0, 0);
        input phi = 60deg;
        let a = turn(arm, (0, 0, 0), phi);
        let b = turn(arm, axis, phi);
        let c = turn(arm, cross(first, second), phi);
        let along = right - left;
        let e = turn(arm, along, phi);
        let g = unit(left - right);
    }
    impl M {
        pub fn pins(phi) -> Pins { a, b, c, e, g }
    }
}

fn main() {}
