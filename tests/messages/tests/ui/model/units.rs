//! Units where they do not belong, and units that are hidden.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param m = 3kg;
        input phi = 3N;
        unknown psi = 20deg;
        argument load = (1N, 2N);
        let a = 3mm + mm;
        let b = 2 * m^2;
        let c = mm^2;
        let d = 3N*s^2/m + 2kg;
        loop psi * load = phi;
        loop psi * 3N = 2N;
    }
}

fn main() {}
