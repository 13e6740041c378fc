//! Half of an angle that turns too unevenly to be followed.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input t = 1mm in 0mm..10mm;
        unknown theta = 1rad;
        unknown r = 10mm;
        loop rotate((10mm, 0), t * t / (1mm * 1mm)) = polar(r, theta);
        let half = dir(theta / 2);
    }

    impl M {
        pub fn half(t) -> Half { half }
    }
}

fn main() {}
