//! All generated types have a type parameter `T`.

use linkage::mechanism;

mechanism! {
    pub struct T {
        unit mm;
        param crank = 50mm;
        input phi = 30deg;
    }
    impl T { pub fn motion(phi) -> Motion { p: polar(crank, phi) } }
}

fn main() {}
