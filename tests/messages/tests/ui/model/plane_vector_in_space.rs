//! Vectors of the plane beside vectors of space.

use linkage::mechanism;

mechanism! {
    pub struct M {
        param crank = 50mm;
        param pivot = (10mm, 0);
        param far = (10mm, 0mm, 3mm);
        input phi = 30deg;
        unknown joint = (10mm, 20mm);
        unknown knee = (10mm, 20mm, 30mm);
        let pin = pivot + polar(crank, phi);
        let a = far - pin;
        let b = far + polar(crank, phi);
        let c = far + (crank, 0);
        let e = distance(pin, far);
        let g = dot(dir(phi), (0, 0, 1));
        let h = cross((0, 0, 1), rotate(pivot, phi));
        let k = far + (pivot + pin);
        loop distance(joint, far) = crank;
        loop pivot + far = knee;
        loop pivot = knee;
    }
    impl M {
        pub fn reach(phi) -> Reach { gap: far - pin }
    }
}

fn main() {}
