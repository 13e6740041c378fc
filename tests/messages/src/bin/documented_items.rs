//! Documentation on every item and quantity, also on those that become no item of Rust.

#![deny(warnings, missing_docs)]

use linkage::mechanism;

mechanism! {
    /// Two bars that hold a point.
    pub struct Dyad {
        /// Millimetres.
        unit mm;
        /// The far pivot.
        const far = (60mm, 0mm);
        /// The near pivot.
        param near = (0mm, 0mm);
        /// From -180 to 180 degrees.
        input phi = 0.3rad in -PI..PI;
        /// Held by the bars.
        unknown tip = (40mm, 40mm);
        /// On the crank.
        let pin = near + polar(20mm, phi);
        /// The first bar.
        loop distance(pin, tip) = 50mm;
        // The second bar.
        loop 70mm = distance(far, tip);
    }

    impl Dyad {
        /// Where the tip is.
        pub fn tip(phi) -> Tip {
            /// The tip itself.
            tip,
            /// Its derivative.
            v: velocity(tip),
        }
    }
}

fn main() {
    let dyad = Dyad::default().assemble().expect("the bars reach the tip");
    for phi in [-3.0, 0.0, 3.0] {
        let tip = dyad.tip(phi).tip;
        assert!(((tip.x - 60.0).hypot(tip.y) - 70.0).abs() < 1e-12);
    }
}
