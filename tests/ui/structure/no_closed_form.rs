//! An equation that no known form fits.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input phi = 60deg;
        unknown s = 10mm;
        loop s * s * s = 1mm * 1mm * 1mm * phi;
    }
}

fn main() {}
