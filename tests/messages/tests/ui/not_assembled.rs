//! Dimensions have no motion: only what is assembled has.

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
    let _ = Crank::default().motion(1.0);
    let _ = Crank::default().motion_sweep(&[1.0]);
}
