//! Axes of frames that are zero or parallel, everywhere or at the reference input.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        const none = (0, 0, 0);
        const flat = frame((0, 0, 0), (1, 2, 3), (-0.1, -0.2, -0.3));
        param arm = (20mm, 0mm, 10mm);
        param lean = 30deg;
        input lift = 30mm in 10mm..50mm;
        unknown s = 12mm;
        let zero = frame(arm, none, (0, 0, 1));
        let parallel = frame(arm, (cos(lean), sin(lean), 0), 2 * (cos(lean), sin(lean), 0));
        let right = frame(arm, (1, 0, 0), (0, lift, 2 * arm.z));
        let here = frame(arm, (0, 30mm, 20mm), (0, lift, 2 * arm.z));
        loop here.origin.x + s = lift + dot(here.x, arm);
    }
    impl M {
        pub fn all(lift) -> All { s, right, d: frame(arm, arm, -arm) }
    }
}

fn main() {}
