//! The miss is in the unit of the mechanism.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit inch;
        input s = 8inch in 6inch..10inch;
        unknown theta = 20deg;
        unknown t = 2inch;
        loop (0, s) + polar(3inch, theta) = (t, 0);
    }
}

fn main() {}
