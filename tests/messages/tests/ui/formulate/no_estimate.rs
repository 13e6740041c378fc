//! Unknowns without an estimate where there are several assemblies: the message lists them as estimates.

use linkage::mechanism;

mechanism! {
    pub struct FourBar {
        unit mm;
        param crank = 40mm;
        input phi = 60deg in 0deg..360deg;
        unknown theta;
        unknown psi;
        loop polar(crank, phi) + polar(120mm, theta) = (100mm, 0) + polar(80mm, psi);
    }
}

// A slide and a point.
mechanism! {
    pub struct Others {
        input phi = 60deg;
        unknown theta;
        unknown s;
        loop polar(0.04m, phi) + polar(0.12m, theta) = (s, 0);
        unknown apex;
        loop distance(apex, (s, 0)) = 0.1m;
        loop distance(apex, (0, 0)) = 0.08m;
    }
}

// A triad.
mechanism! {
    pub struct Platform {
        unit mm;
        param leg = 50mm;
        input phi = 60deg in 20deg..100deg;
        unknown tilt;
        unknown leg_a;
        unknown leg_b;
        unknown leg_c;
        let a = polar(40mm, phi) + polar(leg, leg_a);
        loop a + polar(60mm, tilt) = (120mm, 0) + polar(leg, leg_b);
        loop a + polar(60mm, tilt + 60deg) = (60mm, 110mm) + polar(leg, leg_c);
    }
}

fn main() {}
