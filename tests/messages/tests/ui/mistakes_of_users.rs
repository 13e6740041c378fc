//! Mistakes of programs that use mechanisms: generated types do not have what they use, or are not what they expect.

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

/// Dimensions have no motion: only an assembly has.
fn not_assembled() {
    let _ = Crank::default().motion(1.0);
    let _ = Crank::default().motion_sweep(&[1.0]);
}

/// What is prepared fits the dimensions that it was assembled with: nobody can change the one without the other.
fn prepared_fields() {
    let mut linkage = Crank::default().assemble().unwrap();
    linkage.crank = 60.0;
    linkage.__sealed.core.__mechanism.crank = 60.0;
    let _ = linkage.prepared;
}

/// A mistake in the mechanism does not hide one in the code that uses it.
mod and_type_error {
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

    fn user() {
        let linkage = M::default().assemble().expect("the links reach each other");
        let motion = linkage.motion(1.0);
        let speed: f64 = motion.v.x.hypot(motion.v.y);
        let columns = linkage.motion_sweep(&[0.0, 1.0]);
        println!("{speed} {} {:?} {:?}", motion.psi.sin(), columns.psi(), M::PARAMETERS);
        let name: &str = motion.psi;
    }
}

fn main() {}
