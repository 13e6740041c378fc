//! A result type is made in the module of the call, which has a type of that name from elsewhere: rustc says so at the word.

use linkage::mechanism;

mod other {
    pub struct Motion;
}

use other::Motion;

mechanism! {
    struct Crank {
        unit mm;
        param crank = 50mm;
        input phi = 30deg;
    }
    impl Crank {
        pub fn motion(phi) -> Motion { p: polar(crank, phi) }
    }
}

fn main() {}
