//! The second loop comes apart before the first one; the input is a length.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input s = 100mm in 40mm..130mm;
        unknown alpha = 30deg;
        unknown beta = 150deg;
        unknown gamma = -25deg;
        unknown t = 80mm;
        loop polar(60mm, alpha) = (s, 0) + polar(60mm, beta);
        loop polar(60mm, alpha) + polar(30mm, gamma) = (t, 20mm);
    }
}

fn main() {}
