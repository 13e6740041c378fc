//! An axis through two points that meet at the reference input.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param arm = 20mm;
        input lift = 30mm in 10mm..50mm;
        unknown psi = 15deg;
        let axis = (0mm, 0mm, lift) - (0mm, 0mm, 30mm);
        loop dot(turn((arm, 0mm, 0mm), axis, psi), (1, 1, 0)) = 0.9 * arm;
    }
    impl M {
        pub fn angle(lift) -> Angle { psi }
    }
}

fn main() {}
