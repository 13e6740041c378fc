//! What dead points in a range look like.

use linkage::mechanism;

mechanism! {
    pub struct Stretched {
        unit mm;
        param crank = 80mm;
        const d = (100mm, 0mm);
        input phi = 60deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        let a = polar(crank, phi);
        loop a + polar(75mm, theta) = d + polar(80mm, psi);
    }
}

mechanism! {
    pub struct Folded {
        unit mm;
        input phi = 60deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        loop polar(20mm, phi) + polar(120mm, theta) = (100mm, 0) + polar(30mm, psi);
    }
}

// A coupler shorter than the crank.
mechanism! {
    pub struct Slider {
        unit mm;
        input phi = 10deg in 0deg..360deg;
        unknown theta = -10deg;
        unknown s = 90mm;
        loop polar(50mm, phi) + polar(40mm, theta) = (s, 0);
    }
}

mechanism! {
    pub struct Guide {
        unit mm;
        input phi = 10deg in 0deg..360deg;
        unknown theta = 10deg;
        unknown s = 90mm;
        loop polar(50mm, phi) + (60mm, 0) = polar(s, theta) + polar(20mm, theta + 90deg);
    }
}

// Two distances instead of a vector loop; a range of lengths.
mechanism! {
    pub struct Cylinder {
        unit mm;
        input s = 100mm in 40mm..230mm;
        unknown p = (20mm, 60mm);
        loop distance(p, (0, 0)) = 60mm;
        loop distance(p, (s, 0)) = 90mm;
    }
}

// Sides that are equal in pairs, crossed: it meets its other assembly without missing.
mechanism! {
    pub struct Crossed {
        unit mm;
        input phi = 60deg in 10deg..300deg;
        unknown theta = -60deg;
        unknown psi = -120deg;
        loop polar(40mm, phi) + polar(100mm, theta) = (100mm, 0) + polar(40mm, psi);
    }
}

// A parallelogram on a turned frame.
mechanism! {
    pub struct Turned {
        unit mm;
        input phi = 60deg in 10deg..300deg;
        unknown theta = 30deg;
        unknown psi = 100deg;
        loop polar(40mm, phi) + polar(100mm, theta) = polar(100mm, 30deg) + polar(40mm, psi - 40deg);
    }
}

fn main() {}
