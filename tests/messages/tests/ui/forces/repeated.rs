//! Two pins in one place hold twice what nothing holds elsewhere.

use linkage::mechanism;

mechanism! {
    struct Chain {
        unit mm;
        param a = 40mm;
        input x = 90mm in 80mm..95mm;
        unknown alpha = 100deg;
        unknown beta = 20deg;
        unknown gamma = -20deg;
        unknown psi = 100deg;
        let p = polar(a, alpha);
        let q = p + polar(60mm, beta);
        let r = (130mm, 0mm) + polar(50mm, psi);
        loop distance(p, (80mm, 0mm)) = x;
        loop distance(q, (130mm, -40mm)) = x + 30mm;
        loop q + polar(60mm, gamma) = r;

        body first = pin on frame at (0mm, 0mm), turns alpha;
        body second = pin on first at p, turns beta, mass 1kg at q;
        body third = pin on second at q, turns gamma;
        body last = pin e on frame at (130mm, 0mm), turns psi, mass 1kg at r;
        pin c = third on last at r;
        pin d = third on last at r;
    }
    impl Chain {
        fn forces(x) -> Forces { e: reaction(e) }
    }
}

fn main() {}
