//! The types of a function are seen as far as the function is, wherever the mechanism stands.

#![deny(missing_docs, unreachable_pub)]

mod outer {
    pub(super) mod inner {
        use linkage::mechanism;

        mechanism! {
            /// A crank.
            pub(super) struct Crank {
                unit mm;
                /// Its length.
                param crank = 50mm;
                input phi = 30deg;
            }
            impl Crank {
                /// Everywhere; beside [`Crank`].
                pub fn everywhere(phi) -> Everywhere { p: polar(crank, phi) }
                /// In the crate.
                pub(crate) fn crate_only(phi) -> CrateOnly { p: polar(crank, phi) }
                /// In `outer`.
                pub(super) fn above(phi) -> Above { p: polar(crank, phi) }
                /// In the root.
                pub(in super::super) fn further(phi) -> Further { p: polar(crank, phi) }
                /// In `outer`, by name.
                pub(in crate::outer) fn named(phi) -> Named { p: polar(crank, phi) }
                /// In `outer`, from here.
                pub(in self::super) fn from_here(phi) -> FromHere { p: polar(crank, phi) }
                /// Here.
                pub(self) fn here(phi) -> Here { p: polar(crank, phi) }
                /// Here, too.
                fn nowhere_else(phi) -> NowhereElse { p: polar(crank, phi) }
            }
        }

        macro_rules! crank {
            ($visibility:vis $name:ident $result:ident) => {
                mechanism! {
                    struct $name {
                        unit mm;
                        param crank = 50mm;
                        input phi = 30deg;
                    }
                    impl $name {
                        $visibility fn motion(phi) -> $result { p: polar(crank, phi) }
                    }
                }
            };
        }

        crank! { pub(super) Forwarded OfForwarded }
        crank! { Inherited OfInherited }

        /// A module below sees what is private here.
        mod below {
            pub(super) fn sum(
                here: super::Here,
                columns: &super::NowhereElseColumns,
                inherited: super::OfInherited,
            ) -> f64 {
                here.p.x + columns.get(0).p.x + inherited.p.x
            }
        }

        /// Names of the module above, as tests import them, beside own types of these names.
        mod shadowed {
            use super::*;

            mechanism! {
                struct Guide {
                    unit mm;
                    input s = 30mm;
                }
                impl Guide {
                    pub(super) fn here(s) -> Here { end: 2 * s }
                }
            }

            fn last(columns: &HereColumns) -> f64 {
                columns.get(0).end
            }

            pub(super) fn end() -> f64 {
                last(&Guide::default().assemble().unwrap().here_sweep(&[20.0]))
            }
        }

        pub(super) fn forwarded() -> OfForwarded {
            Forwarded::default().assemble().unwrap().motion(0.0)
        }

        pub(super) fn sum() -> f64 {
            let crank = Crank::default().assemble().unwrap();
            let inherited = Inherited::default().assemble().unwrap().motion(0.0);
            let below = below::sum(
                crank.here(0.0),
                &crank.nowhere_else_sweep(&[0.0]),
                inherited,
            );
            below + shadowed::end()
        }
    }

    use inner::{Above, Crank, CrateOnly, Everywhere, FromHere, Further, Named, OfForwarded};

    pub(super) fn sum() -> f64 {
        let crank = Crank::default().assemble().unwrap();
        let everywhere: Everywhere = crank.everywhere(0.0);
        let crate_only: CrateOnly = crank.crate_only(0.0);
        let above: Above = crank.above(0.0);
        let further: Further = crank.further(0.0);
        let named: Named = crank.named(0.0);
        let from_here: FromHere = crank.from_here(0.0);
        let forwarded: OfForwarded = inner::forwarded();
        let points = [
            everywhere.p,
            crate_only.p,
            above.p,
            further.p,
            named.p,
            from_here.p,
            forwarded.p,
        ];
        points.iter().map(|p| p.x).sum::<f64>() + inner::sum()
    }
}

/// In the body of a function the struct, its types and a derive that only the body knows belong to the body.
fn within_a_function() -> f64 {
    use std::hash::Hash as Hashed;

    linkage::mechanism! {
        struct Crank {
            unit mm;
            param crank = 50mm;
            input phi = 30deg;
        }
        impl Crank {
            pub(crate) fn motion(phi) -> Motion { p: polar(crank, phi) }
            #[derive(Hashed)]
            fn turned(phi) -> Turned { angle: phi }
        }
    }

    fn hash(hashed: impl Hashed) {
        hashed.hash(&mut std::collections::hash_map::DefaultHasher::new());
    }
    let crank = Crank::default().assemble().unwrap();
    hash(Turned { angle: 1u64 });
    let motion: Motion = crank.motion(0.0);
    let columns: MotionColumns = crank.motion_sweep(&[0.0]);
    let turned: Turned = crank.turned(0.0);
    motion.p.x + columns.get(0).p.x + turned.angle
}

fn main() {
    assert_eq!(outer::sum(), 540.0);
    assert_eq!(within_a_function(), 100.0);
}
