//! The length of a vector of angles, on either side.

use linkage::mechanism;

mechanism! {
    pub struct Left {
        unknown t = 10deg;
        loop norm(t * (1, 2)) = 0;
    }
}

mechanism! {
    pub struct Right {
        unknown t = 10deg;
        loop 0 = norm(t * (1, 2));
    }
}

mechanism! {
    pub struct Components {
        unknown t = 10deg;
        loop 0 = norm((t, 2 * t));
    }
}

fn main() {}
