//! A mechanism inside a function, one inside an `impl` block's function, and two of one name in two functions.

use linkage::mechanism;

struct Machine;

impl Machine {
    fn length(&self, phi: f64) -> f64 {
        mechanism! {
            struct Crank {
                input phi = 30deg;
                let tip = polar(2, phi);
            }

            impl Crank {
                fn tip(phi) -> Tip { tip }
            }
        }
        Crank::default()
            .assemble()
            .map_or(0.0, |c| c.tip(phi).tip.norm())
    }
}

fn length(phi: f64) -> f64 {
    mechanism! {
        struct Crank {
            input phi = 30deg;
            let tip = polar(3, phi);
        }

        impl Crank {
            fn tip(phi) -> Tip { tip }
        }
    }
    let crank = Crank::default().assemble().expect("no loop");
    crank.tip(phi).tip.norm()
}

fn main() {
    assert!((length(1.0) - 3.0).abs() < 1e-15);
    assert!((Machine.length(1.0) - 2.0).abs() < 1e-15);
}
