//! What constants, parameters, inputs and estimates may use.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mm;
        input phi = 30deg;
        const twice = 2 * crank;
        param half = phi / 2;
        param tolerated = 3mm +- crank;
        input psi = 2 * phi;
        unknown theta = phi;
    }
}

fn main() {}
