//! Groups in space that are beyond the general machinery.

use linkage::mechanism;

mechanism! {
    pub struct UnknownAxis {
        unknown n = (0, 0, 1);
        unknown psi = 140deg;
        let turned = turn((1, 0, 0), n, psi);
        loop norm(n) = 1;
        loop dot(n, (1, 0, 0)) = 0.1;
        loop turned.y = 0.3;
        loop turned.z = 0.3;
    }
    impl UnknownAxis {
        pub fn axis() -> Axis { n }
    }
}

fn main() {}
