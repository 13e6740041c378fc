//! Ranges that are a single position, or beside the reference by less than a message shows of other numbers.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit inch;
        input phi = 30deg in 30deg..30deg;
        input psi = 30.00000001deg in 0deg..30deg;
        input s = 3mm in 5mm..1inch;
        let p = polar(s, phi + psi);
    }
}

fn main() {}
