//! The sides of a loop have one dimension.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mm;
        input phi = 30deg;
        unknown theta = 40deg;
        unknown psi = 40deg;
        loop polar(crank, theta) = phi;
        loop theta = crank;
        loop crank * crank = dot((crank, 0), dir(psi));
    }
}

fn main() {}
