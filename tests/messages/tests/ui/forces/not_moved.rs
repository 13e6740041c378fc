//! A joint that leaves a motion free which nothing moves and nothing holds.

use linkage::mechanism;

mechanism! {
    struct Rssr {
        unit mm;
        param crank = 40mm;
        param rod = 180mm;
        param rocker = 90mm;
        param pivot = (150mm, 20mm, -60mm);
        input phi = 20deg in 0deg..360deg at omega;
        unknown psi = 100deg;
        let p = turn((0, crank, 0), (1, 0, 0), phi);
        let q = pivot + turn((rocker, 0, 0), (0, 0, 1), psi);
        loop distance(p, q) = rod;

        body wheel = pin a on frame at (0, 0, 0) about (1, 0, 0), turns phi, mass 1kg at (0, 0, 0);
        body coupler = ball b on wheel at p, turns q - p, mass 200g at (p + q) / 2;
        body lever = cylinder c on frame at pivot about (0, 0, 1), turns psi, mass 500g at q;
        ball d = coupler on lever at q;
    }
    impl Rssr {
        fn forces(phi, omega) -> Forces { c: reaction(c) }
    }
}

fn main() {}
