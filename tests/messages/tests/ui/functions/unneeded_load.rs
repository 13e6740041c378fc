//! Loads that no quantity of the function needs.

use linkage::mechanism;

mechanism! {
    struct Press {
        unit mm;
        param crank = 30mm;
        param rod = 120mm;
        input phi = 30deg in 0deg..360deg at omega;
        unknown theta = -10deg;
        unknown x = 140mm;
        let p = polar(crank, phi);
        let q = p + polar(rod, theta);
        loop q = (x, 0mm);

        body wheel = pin a on frame at (0mm, 0mm), turns phi, mass 0.1kg at p / 2;
        body link = pin b on wheel at p, turns theta, mass 0.2kg at (p + q) / 2;
        body piston = slide c on frame at q along (1, 0), mass 1kg at q;
        pin d = link on piston at q;
        argument load = 100N;
        force (-load, 0N) on piston at q;
    }
    impl Press {
        fn energy(phi, omega, load) -> Energy { e: kinetic_energy() }
        fn forces(phi, omega, load) -> Forces { d: reaction(d) }
    }
}

fn main() {}
