//! An inertia about a point that is none of the body's.

use linkage::mechanism;

mechanism! {
    struct Lever {
        unit mm;
        param a = 40mm;
        input phi = 30deg in 0deg..360deg at omega, epsilon;
        let p = polar(a, phi);
        body lever = pin j on frame at (0mm, 0mm), turns phi, mass 1kg at p, inertia 3000kg*mm^2 at (20mm, 0mm);
    }
    impl Lever {
        fn torque(phi, omega, epsilon) -> Torque { t: torque(phi) }
    }
}

fn main() {}
