//! Estimates far from the assembly that is nearest to them: a typing error, a wrong sign in a loop, a slide on the other side.

use linkage::mechanism;

// 260 degrees for 80: the crossed assembly would be nearer.
mechanism! {
    pub struct TypedWrong {
        unit mm;
        param crank = 40mm;
        param coupler = 120mm;
        param rocker = 80mm;
        param base = 100mm;
        input phi = 60deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 260deg;
        loop polar(crank, phi) + polar(coupler, theta) = (base, 0) + polar(rocker, psi);
    }
}

// The rocker is subtracted on the other side.
mechanism! {
    pub struct WrongSign {
        unit mm;
        param crank = 40mm;
        param coupler = 120mm;
        param rocker = 80mm;
        param base = 100mm;
        input phi = 60deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 80deg;
        loop polar(crank, phi) + polar(coupler, theta) + polar(rocker, psi) = (base, 0);
    }
}

// A slider on the other side: it is found by a linear equation, which has one solution.
mechanism! {
    pub struct Slider {
        unit mm;
        input phi = 60deg;
        unknown s = 150mm;
        unknown t = 55mm;
        loop (s, 20mm) + polar(40mm, phi) = (-100mm, t);
    }
}

fn main() {}
