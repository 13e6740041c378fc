//! Components of vectors of space and of the plane.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param height = 20mm;
        param pivot = (10mm, 0);
        unknown joint = (10mm, 20mm);
        unknown direction = (0, 0, 1);
        unknown both = (0mm, 30deg, 1);
        unknown four = (0, 0, 1, 0);
        let a = joint.z;
        let b = direction.w;
        let c = direction[2];
        let e = (pivot, height);
        let g = (direction, height);
        let h = direction * direction;
        loop direction = joint / height;
        loop norm(direction) = 1mm;
    }
}

fn main() {}
