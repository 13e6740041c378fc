//! Triads with a leg of two slides (PP), which leaves the ternary link its direction: the other two legs
//! hold its place.
//!
//! The second leg hangs on the crank. The first one slides on a fixed guide at the angle `q1` and on a
//! guide at the angle `p1` in the ternary link, whose direction is `tau`.

use std::sync::LazyLock;

use crate::compile;
use crate::kinds::Joints;
use crate::legs::{Leg, Point, turned};
use linkage_engine::{Assembly, Mechanism};

/// Crank, `a1`, `a3`, sides and angle of the ternary link, `tau`, `p1`, `q1`, `q2`, `q3`.
pub(crate) type Dimensions = [f64; 13];

/// What a mechanism says about one position.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Answer {
    /// The first point of the ternary link.
    pub(crate) point: Point,
    /// The largest component by which the loops are missed.
    pub(crate) miss: f64,
}

/// One assembly of a mechanism.
pub(crate) type Evaluate = Box<dyn Fn(f64) -> Answer>;

/// A mechanism for one kind of triad.
pub(crate) struct Kind {
    pub(crate) name: &'static str,
    /// The largest number of assemblies.
    pub(crate) degree: usize,
    pub(crate) joints: [Joints; 2],
    pub(crate) mechanism: LazyLock<Mechanism>,
}

impl Kind {
    /// The same mechanism for the independent count.
    pub(crate) fn legs(&self, d: &Dimensions, phi: f64) -> [Leg; 3] {
        let [crank, _, _, a3x, a3y, b, c, kappa, tau, _, _, q2, q3] = *d;
        let leg = |joints, pivot, q, at| match joints {
            Joints::Rr => Leg::Rr {
                pivot,
                length: q,
                at,
            },
            Joints::Pr => Leg::Pr {
                pivot,
                angle: q,
                at,
            },
            Joints::Rp => Leg::Rp {
                pivot,
                angle: q,
                at,
            },
        };
        [
            Leg::Pp { direction: tau },
            leg(self.joints[0], turned([crank, 0.0], phi), q2, [b, 0.0]),
            leg(self.joints[1], [a3x, a3y], q3, turned([c, 0.0], kappa)),
        ]
    }

    /// The dimensions as written.
    pub(crate) fn dimensions(&self) -> Dimensions {
        let dimensions = self.mechanism.dimensions();
        dimensions.try_into().expect("as declared")
    }

    /// All assemblies at an input.
    pub(crate) fn assemblies(
        &'static self,
        d: &Dimensions,
        phi: f64,
    ) -> Result<Vec<Evaluate>, String> {
        let found = self.mechanism.assemblies(d, &[phi]);
        let found = found.map_err(|why| why.to_string())?;
        Ok(found.into_iter().map(evaluate).collect())
    }
}

fn evaluate(assembly: Assembly<'static>) -> Evaluate {
    Box::new(move |phi| {
        let p = assembly.results("position", &[phi]);
        let misses = ["miss_2", "miss_3"].map(|miss| p.vector::<2>(miss));
        Answer {
            point: p.vector("e1"),
            miss: crate::largest(misses.concat()),
        }
    })
}

/// A kind with the text of its mechanism.
macro_rules! kinds {
    ($($name:literal $degree:literal [$($joints:ident)*]
        crank $crank:literal pivots $a1:tt $a3:tt link $b:literal $c:literal $kappa:literal $tau:literal
        slides $p1:literal $q1:literal $x1:literal $y1:literal
        legs ($($leg2:tt)*) $q2:literal $x2:literal, ($($leg3:tt)*) $q3:literal $x3:literal
    )*) => {
        /// All kinds.
        pub(crate) static KINDS: [Kind; 6] = [$(Kind {
            name: $name,
            degree: $degree,
            joints: [$(Joints::$joints),*],
            mechanism: LazyLock::new(|| compile(stringify! {
                struct Mechanism {
                    unit mm;
                    param crank = $crank;
                    param a1 = $a1;
                    param a3 = $a3;
                    param b = $b;
                    param c = $c;
                    param kappa = $kappa;
                    param tau = $tau;
                    param p1 = $p1;
                    param q1 = $q1;
                    param q2 = $q2;
                    param q3 = $q3;
                    input phi = 30deg in 0deg..360deg;
                    unknown x1 = $x1;
                    unknown y1 = $y1;
                    unknown x2 = $x2;
                    unknown x3 = $x3;
                    let e1 = a1 + polar(x1, q1) + polar(y1, tau + p1);
                    let e2 = polar(crank, phi) + $($leg2)*;
                    let e3 = a3 + $($leg3)*;
                    loop e1 + polar(b, tau) = e2;
                    loop e1 + polar(c, tau + kappa) = e3;
                }

                impl Mechanism {
                    fn position(phi) -> Position {
                        e1,
                        miss_2: e1 + polar(b, tau) - e2,
                        miss_3: e1 + polar(c, tau + kappa) - e3,
                    }
                }
            })),
        }),*];
    };
}

kinds! {
    "PP-RR-RR" 2 [Rr Rr]
    crank 21mm pivots (143mm, 16mm) (62mm, 116mm) link 104mm 42mm 45deg -5deg
    slides 85deg -170deg 119mm -7mm
    legs (polar(q2, x2)) 114mm -16deg, (polar(q3, x3)) 101mm -93deg

    "PP-RR-PR" 2 [Rr Pr]
    crank 17mm pivots (131mm, -19mm) (39mm, 101mm) link 50mm 88mm 85deg 35deg
    slides 110deg -160deg 261mm 18mm
    legs (polar(q2, x2)) 129mm -143deg, (polar(x3, q3)) -150deg 245mm

    "PP-RR-RP" 2 [Rr Rp]
    crank 17mm pivots (93mm, -7mm) (66mm, 94mm) link 42mm 95mm 45deg 40deg
    slides 110deg -115deg -12mm 4mm
    legs (polar(q2, x2)) 115mm 12deg, (polar(x3, tau + q3)) -30deg 38mm

    "PP-PR-PR" 1 [Pr Pr]
    crank 33mm pivots (127mm, -14mm) (76mm, 106mm) link 100mm 46mm 80deg 35deg
    slides 65deg -175deg 175mm -24mm
    legs (polar(x2, q2)) -50deg 15mm, (polar(x3, q3)) -140deg 182mm

    "PP-PR-RP" 1 [Pr Rp]
    crank 18mm pivots (97mm, -20mm) (78mm, 139mm) link 69mm 81mm 45deg -40deg
    slides 85deg -10deg -163mm 126mm
    legs (polar(x2, q2)) 35deg 77mm, (polar(x3, tau + q3)) 170deg -45mm

    "PP-RP-RP" 1 [Rp Rp]
    crank 19mm pivots (125mm, 14mm) (36mm, 93mm) link 72mm 90mm 50deg 25deg
    slides 115deg 100deg -118mm 201mm
    legs (polar(x2, tau + q2)) -155deg -63mm, (polar(x3, tau + q3)) -70deg -30mm
}
