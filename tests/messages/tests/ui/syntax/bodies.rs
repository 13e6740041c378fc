//! Mistakes in bodies and joints: each is reported, the rest of the item is read.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        input phi = 30deg in 0deg..360deg at 3, epsilon;
        let p = (0, 0);
        let q = polar(10mm, phi);
        body crank = hinge on frame at p, turns phi, mass 2kg;
        body disc = pin j frame at p, turn phi, mass 1kg at q, mass 1,5kg at p;
        body block = slide on crank at q about dir(phi), turns phi, turns 0;
        pin on disc at q;
        pin k = disc at q;
        pin = crank on disc at q;
    }
}

fn main() {}
