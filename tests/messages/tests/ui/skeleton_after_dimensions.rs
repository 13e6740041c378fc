//! After a wrong dimension the rest of the code has its types: one message.

use linkage::mechanism;

mechanism! {
    pub struct M {
        unit mm;
        param crank = 40mm;
        input phi = 40deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        loop polar(crank, phi) + polar(120mm, theta) = (100mm, 0) + polar(80mm, psi);
        let a = crank + phi;
        let b = polar(crank, phi);
    }

    impl M {
        pub fn motion(phi) -> Motion { v: velocity(b), psi }
    }
}

fn main() {
    let linkage = M::default().assemble().expect("the links reach each other");
    let motion = linkage.motion(1.0);
    let speed: f64 = motion.v.x.hypot(motion.v.y);
    let columns = linkage.motion_sweep(&[0.0, 1.0]);
    println!("{speed} {} {:?} {:?}", motion.psi.sin(), columns.psi(), M::PARAMETERS);
    println!("{:?}", M::default().circuits().map(|circuits| circuits.branches.len()));
    let _ = M { crank: 41.0, ..M::default() };
}
