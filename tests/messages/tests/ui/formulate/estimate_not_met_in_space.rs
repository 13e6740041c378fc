//! Directions and points far from their estimates.

use linkage::mechanism;

mechanism! {
    pub struct Tripod {
        unit mm;
        unknown tip = (0mm, 0mm, 170mm);
        loop distance(tip, (100mm, 0mm, 0mm)) = 120mm;
        loop distance(tip, (-50mm, 90mm, 0mm)) = 120mm;
        loop distance(tip, (-50mm, -90mm, 0mm)) = 120mm;
    }
}

mechanism! {
    pub struct Direction {
        unit mm;
        input phi = 20deg;
        unknown across = (0, 0.9, 0.1);
        loop norm(across) = 1;
        loop dot(across, (1, 0, 0)) = 0;
        loop dot(across, turn((0, 1, 0), (1, 0, 0), phi)) = 0.1;
    }
}

// A triad.
mechanism! {
    pub struct Platform {
        unit mm;
        param crank = 40mm;
        param leg = 50mm;
        input phi = 60deg in 20deg..100deg;
        unknown tilt = 20deg;
        unknown leg_a = 20deg;
        unknown leg_b = 200deg;
        unknown leg_c = 290deg;
        let a = polar(crank, phi) + polar(leg, leg_a);
        loop a + polar(60mm, tilt) = (120mm, 0) + polar(leg, leg_b);
        loop a + polar(60mm, tilt + 60deg) = (60mm, 110mm) + polar(leg, leg_c);
    }
}

fn main() {}
