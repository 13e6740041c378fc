//! A point that does not stay with its body, a pin in which nothing turns.

use linkage::mechanism;

mechanism! {
    struct Lever {
        unit mm;
        param a = 40mm;
        input phi = 30deg in 0deg..360deg at omega, epsilon;
        let p = polar(a, phi);
        body lever = pin j on frame at (0mm, 0mm), turns phi, mass 1kg at p, inertia 3000kg*mm^2 at (20mm, 0mm);
        spring 3N/mm from frame at (0mm, 100mm) to lever at (a, 0mm);
        damper 1N*s/mm from frame at p / 2 to lever at p;
    }
    impl Lever {
        fn torque(phi, omega, epsilon) -> Torque { t: torque(phi) }
    }
}

mechanism! {
    struct Flag {
        unit mm;
        input phi = 30deg in 0deg..360deg at omega;
        body post = pin j on frame at (0mm, 0mm), turns 30deg, mass 1kg at (50mm, 0mm);
        body crank = pin k on frame at (0mm, 0mm), turns phi, mass 1kg at polar(30mm, phi);
    }
    impl Flag {
        fn forces(phi, omega) -> Forces { j: reaction(j), k: reaction(k) }
    }
}

fn main() {}
