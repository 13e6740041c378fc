//! `rotate` is for the plane, `turn` for space.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param pivot = (10mm, 0);
        param far = (10mm, 0mm, 3mm);
        input phi = 30deg;
        let a = rotate(far, phi);
        let b = rotate(phi, far);
        let c = rotate(far, (0, 0, 1), phi);
        let e = turn(pivot, (0, 0, 1), phi);
        let g = turn(far, (0, 1), phi);
        let h = turn(far, phi, (0, 0, 1));
        let i = turn(far, phi);
        let j = angle(far);
        let k = polar(10mm, far);
    }
}

fn main() {}
