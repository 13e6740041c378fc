//! Without the prelude, and with every lint that generated code could trip over denied.

#![no_implicit_prelude]
#![deny(
    warnings,
    missing_docs,
    missing_debug_implementations,
    unused,
    unreachable_pub
)]
#![forbid(unsafe_code)]

::linkage::mechanism! {
    /// Slider-crank.
    pub struct SliderCrank {
        unit mm;
        /// Length of the crank.
        param crank = 30mm +- 1um;
        param rod = 120mm;
        #[allow(unused)]
        param unused = 3mm;
        const alike = 3mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = -10deg;
        unknown s = 150mm;
        let a = polar(crank, phi);
        let nowhere = 2 * a;
        loop a + polar(rod, theta) = (s, 0);
    }

    impl SliderCrank {
        /// Motion of the slide.
        pub fn motion(phi) -> Motion { s, v: velocity(s), a: acceleration(s), j: jerk(s), e: sensitivity(s) }
        pub fn margin(phi) -> Margin { m: margin() }
    }
}

::linkage::mechanism! {
    /// A ternary link on three legs.
    pub struct Platform {
        unit mm;
        param leg = 50mm;
        input phi = 60deg in 20deg..100deg;
        unknown tilt = 20deg;
        unknown leg_a = -37deg;
        unknown leg_b = 100deg;
        unknown leg_c = 290deg;
        let a = polar(40mm, phi) + polar(leg, leg_a);
        loop a + polar(60mm, tilt) = (120mm, 0) + polar(leg, leg_b);
        loop a + polar(60mm, tilt + 60deg) = (60mm, 110mm) + polar(leg, leg_c);
    }

    impl Platform {
        /// Its first joint.
        pub fn joint(phi) -> Joint { a, tilt, v: velocity(a), e: sensitivity(tilt) }
    }
}

/// A module of its own, with a private mechanism nobody uses in full.
pub mod inner {
    ::linkage::mechanism! {
        struct Private {
            param pi = 3.25;
            input phi = 30deg;
            let a = polar(pi, phi);
        }

        impl Private {
            fn point(phi) -> Point { a }
        }
    }

    /// Uses it.
    pub fn run() -> f64 {
        let private = ::std::result::Result::unwrap(Private::assemble(
            &<Private as ::std::default::Default>::default(),
        ));
        private.point(0.0).a.x
    }
}

fn main() {
    let mechanism = <SliderCrank as ::std::default::Default>::default();
    let linkage = ::std::result::Result::unwrap(mechanism.assemble());
    ::std::assert_eq!(linkage.motion(0.0).s, 150.0);
    ::std::assert!(linkage.margin(0.0).m > 0.9);
    ::std::assert_eq!(inner::run(), 3.25);
}
