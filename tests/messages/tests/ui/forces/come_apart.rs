//! Bodies and joints that do not fit the motion.

use linkage::mechanism;

mechanism! {
    struct Press {
        unit mm;
        param crank = 30mm;
        param rod = 120mm;
        input phi = 30deg in 0deg..360deg at omega, epsilon;
        unknown theta = -10deg;
        unknown x = 140mm;
        let p = polar(crank, phi);
        let q = p + polar(rod, theta);
        loop q = (x, 0mm);

        body wheel = pin a on frame at (10mm, 0mm), turns phi, mass 0.1kg at p / 2;
        body link = pin b on wheel at p, turns -theta, mass 0.2kg at q / 2;
        body piston = slide c on frame at q along (1, 1), turns theta, mass 1kg at q;
        pin d = link on piston at q;
    }
    impl Press {
        fn forces(phi, omega) -> Forces { a: reaction(a) }
    }
}

fn main() {}
