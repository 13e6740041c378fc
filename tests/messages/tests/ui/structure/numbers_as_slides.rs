//! Plain numbers are angles: slides need a unit of length.

use linkage::mechanism;

mechanism! {
    pub struct Slides {
        unit mm;
        input phi = 10deg in 0deg..20deg;
        unknown s = 50;
        unknown t = 50;
        unknown psi = 10deg;
        let end = (70mm, 20mm, phi * 1mm - 10mm) + turn((0, 60mm, 0), (1, 0, 0), psi);
        loop s * (3mm, 0, 0) + t * (1mm, 2mm, 0) = end;
    }

    impl Slides {
        pub fn place(phi) -> Place { s, t, psi }
    }
}

fn main() {}
