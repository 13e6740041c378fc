//! The blocks belong to one mechanism.

use linkage::mechanism;

mechanism! {
    pub struct CrankRocker {
        input phi = 30deg;
    }

    impl CrankRoker {
        pub fn motion(phi) -> Motion { phi }
    }
}

mechanism! {
    pub struct First {
        input phi = 30deg;
    }

    pub struct Second {
        input phi = 30deg;
    }
}

mechanism! {
    pub struct Generic<T> {
        input phi = 30deg;
    }
}

fn main() {}
