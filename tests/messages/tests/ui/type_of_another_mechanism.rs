//! Two mechanisms of one module cannot both make a type `Motion`. Nothing else is told of it.

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

mechanism! {
    pub struct Guide {
        unit mm;
        input s = 30mm;
    }
    impl Guide {
        pub fn motion(s) -> Motion { end: (s, 0), twice: 2 * s }
    }
}

fn main() {
    let guide = Guide::default().assemble().unwrap();
    println!("{}", guide.motion(20.0).twice);
    println!("{}", guide.motion_sweep(&[20.0]).twice()[0]);
}
