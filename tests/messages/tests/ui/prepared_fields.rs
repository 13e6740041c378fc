//! What is prepared fits the dimensions that it was assembled with: nobody can change the one without the other.

use linkage::mechanism;

mechanism! {
    pub struct Crank {
        unit mm;
        param crank = 50mm;
        input phi = 30deg;
    }
    impl Crank {
        pub fn motion(phi) -> Motion { p: polar(crank, phi) }
    }
}

fn main() {
    let mut linkage = Crank::default().assemble().unwrap();
    linkage.crank = 60.0;
    linkage.__sealed.core.__mechanism.crank = 60.0;
    let _ = linkage.prepared;
}
