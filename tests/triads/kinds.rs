//! One mechanism for every kind of triad: legs of two pins (RR), of a slider on the frame and a pin
//! (PR), of a pin and a slider on the ternary link (RP), in any combination.
//!
//! The first leg hangs on a crank. Leg `i` leads from the pivot `a_i` to the point `e_i` of the ternary
//! link by a vector of length and direction: one of them is the unknown `x_i`, the other one the
//! dimension `q_i`.

use std::sync::LazyLock;

use crate::compile;
use crate::legs::{Leg, Point, turned};
use linkage_engine::{Assembly, AssemblyError, Branch, Circuits, Mechanism};

/// Crank, `a2`, `a3`, sides and angle of the ternary link, `q1`, `q2`, `q3`.
pub(crate) type Dimensions = [f64; 11];

/// What a mechanism says about one position.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Answer {
    /// The first point of the ternary link.
    pub(crate) point: Point,
    /// Its direction.
    pub(crate) direction: Point,
    /// The largest component by which the loops are missed.
    pub(crate) miss: f64,
    pub(crate) margin: f64,
    /// Velocity and acceleration of the third point.
    pub(crate) velocity: Point,
    pub(crate) acceleration: Point,
}

/// One assembly of a mechanism.
pub(crate) type Evaluate = Box<dyn Fn(f64) -> Answer>;

/// The legs' kinds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Joints {
    Rr,
    Pr,
    Rp,
}

/// A mechanism for one kind of triad.
pub(crate) struct Kind {
    pub(crate) name: &'static str,
    /// Degree of the characteristic polynomial, which is the largest number of assemblies.
    pub(crate) degree: usize,
    pub(crate) joints: [Joints; 3],
    pub(crate) mechanism: LazyLock<Mechanism>,
}

impl Kind {
    /// The same mechanism for the independent count.
    pub(crate) fn legs(&self, d: &Dimensions, phi: f64) -> [Leg; 3] {
        let [crank, a2x, a2y, a3x, a3y, b, c, kappa, q @ ..] = *d;
        let pivots = [turned([crank, 0.0], phi), [a2x, a2y], [a3x, a3y]];
        let ends = [[0.0, 0.0], [b, 0.0], turned([c, 0.0], kappa)];
        std::array::from_fn(|i| {
            let (pivot, at) = (pivots[i], ends[i]);
            match self.joints[i] {
                Joints::Rr => Leg::Rr {
                    pivot,
                    length: q[i],
                    at,
                },
                Joints::Pr => Leg::Pr {
                    pivot,
                    angle: q[i],
                    at,
                },
                Joints::Rp => Leg::Rp {
                    pivot,
                    angle: q[i],
                    at,
                },
            }
        })
    }

    /// The dimensions as written.
    pub(crate) fn dimensions(&self) -> Dimensions {
        let dimensions = self.mechanism.dimensions();
        dimensions.try_into().expect("as declared")
    }

    /// The assembly that the estimates choose.
    pub(crate) fn assemble(&'static self, d: &Dimensions) -> Result<Evaluate, String> {
        let assembly = self.mechanism.assemble(d);
        assembly.map(evaluate).map_err(|why| why.to_string())
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

    /// The assembly that the estimates choose for the first dimensions, followed to the second ones.
    pub(crate) fn assemble_from(
        &'static self,
        from: &Dimensions,
        to: &Dimensions,
    ) -> Result<Evaluate, AssemblyError> {
        let first = self.mechanism.assemble(from)?;
        self.mechanism.assemble_from(to, &first).map(evaluate)
    }

    /// A sweep of the assembly that the estimates choose for the first dimensions over others, each at an input of its own: point and
    /// direction of the ternary link.
    pub(crate) fn sets(
        &self,
        from: &Dimensions,
        sets: &[Dimensions],
        phi: &[f64],
    ) -> Vec<[Point; 2]> {
        let first = self.mechanism.assemble(from).expect("as written");
        let column = |k: usize| sets.iter().map(|set| set[k]).collect();
        let columns: Vec<Vec<f64>> = (0..from.len()).map(column).collect();
        let columns: Vec<&[f64]> = columns.iter().map(Vec::as_slice).collect();
        let position = self.mechanism.function("position").expect("it has one");
        let found = first.sweep_sets(position, &columns, &[phi]);
        let of = |name: &str, row: usize| found[name][row];
        let row = |row: usize| {
            let point = [of("e1.x", row), of("e1.y", row)];
            [point, [of("direction.x", row), of("direction.y", row)]]
        };
        (0..sets.len()).map(row).collect()
    }

    /// All assemblies over a turn.
    pub(crate) fn circuits(&'static self, d: &Dimensions) -> Result<Circuits<Evaluate>, String> {
        let found = self.mechanism.circuits(d).expect("it has one input");
        let found = found.map_err(|why| why.to_string())?;
        let branches = found.branches.into_iter().map(|branch| Branch {
            assembly: evaluate(branch.assembly),
            circuit: branch.circuit,
            ends: branch.ends,
            closed: branch.closed,
            margin: branch.margin,
            at: branch.at,
            input: branch.input,
            unknowns: branch.unknowns,
        });
        let input = found.input;
        Ok(Circuits {
            cycle: found.cycle,
            input,
            branches: branches.collect(),
            meetings: found.meetings,
            undetermined: found.undetermined,
        })
    }
}

fn evaluate(assembly: Assembly<'static>) -> Evaluate {
    Box::new(move |phi| {
        let (p, m) = (
            assembly.results("position", &[phi]),
            assembly.results("motion", &[phi]),
        );
        let misses = ["miss_2", "miss_3"].map(|miss| p.vector::<2>(miss));
        Answer {
            point: p.vector("e1"),
            direction: p.vector("direction"),
            miss: crate::largest(misses.concat()),
            margin: p["margin"],
            velocity: m.vector("v"),
            acceleration: m.vector("a"),
        }
    })
}

/// A kind with the text of its mechanism.
macro_rules! kinds {
    ($($name:literal $degree:literal [$($joints:ident)*]
        crank $crank:literal pivots $a2:tt $a3:tt link $b:literal $c:literal $kappa:literal
        legs ($($leg1:tt)*) $q1:literal $x1:literal,
            ($($leg2:tt)*) $q2:literal $x2:literal,
            ($($leg3:tt)*) $q3:literal $x3:literal;
        theta $theta:literal
    )*) => {
        /// All kinds.
        pub(crate) static KINDS: [Kind; 10] = [$(Kind {
            name: $name,
            degree: $degree,
            joints: [$(Joints::$joints),*],
            mechanism: LazyLock::new(|| compile(stringify! {
                struct Mechanism {
                    unit mm;
                    param crank = $crank;
                    param a2 = $a2;
                    param a3 = $a3;
                    param b = $b;
                    param c = $c;
                    param kappa = $kappa;
                    param q1 = $q1;
                    param q2 = $q2;
                    param q3 = $q3;
                    input phi = 30deg in 0deg..360deg;
                    unknown x1 = $x1;
                    unknown x2 = $x2;
                    unknown x3 = $x3;
                    unknown theta = $theta;
                    let e1 = polar(crank, phi) + $($leg1)*;
                    let e2 = a2 + $($leg2)*;
                    let e3 = a3 + $($leg3)*;
                    loop e1 + polar(b, theta) = e2;
                    loop e1 + polar(c, theta + kappa) = e3;
                }

                impl Mechanism {
                    fn position(phi) -> Position {
                        e1, direction: dir(theta), margin: margin(),
                        miss_2: e1 + polar(b, theta) - e2,
                        miss_3: e1 + polar(c, theta + kappa) - e3,
                    }
                    fn motion(phi) -> Motion { v: velocity(e3), a: acceleration(e3) }
                }
            })),
        }),*];
    };
}

kinds! {
    "RR-RR-RR" 6 [Rr Rr Rr]
    crank 18mm pivots (126mm, -13mm) (30mm, 139mm) link 110mm 107mm 75deg
    legs (polar(q1, x1)) 79mm 86deg, (polar(q2, x2)) 69mm -177deg, (polar(q3, x3)) 107mm -24deg;
    theta -71deg

    "RR-RR-PR" 6 [Rr Rr Pr]
    crank 16mm pivots (92mm, 11mm) (64mm, 138mm) link 42mm 55mm 75deg
    legs (polar(q1, x1)) 103mm -39deg, (polar(q2, x2)) 84mm -119deg, (polar(x3, q3)) 95deg -251mm;
    theta -173deg

    "RR-RR-RP" 6 [Rr Rr Rp]
    crank 17mm pivots (111mm, 14mm) (108mm, 147mm) link 75mm 62mm 40deg
    legs (polar(q1, x1)) 119mm 76deg, (polar(q2, x2)) 95mm 157deg, (polar(x3, theta + q3)) 170deg -88mm;
    theta -106deg

    "RR-PR-RP" 6 [Rr Pr Rp]
    crank 27mm pivots (96mm, -1mm) (28mm, 84mm) link 97mm 42mm 30deg
    legs (polar(q1, x1)) 102mm -21deg, (polar(x2, q2)) 170deg -121mm, (polar(x3, theta + q3)) -35deg 153mm;
    theta 1deg

    "RR-PR-PR" 4 [Rr Pr Pr]
    crank 22mm pivots (96mm, -18mm) (66mm, 81mm) link 102mm 87mm 75deg
    legs (polar(q1, x1)) 125mm 100deg, (polar(x2, q2)) -70deg -83mm, (polar(x3, q3)) 85deg 95mm;
    theta -47deg

    "RR-RP-RP" 4 [Rr Rp Rp]
    crank 21mm pivots (152mm, 12mm) (29mm, 138mm) link 68mm 67mm 60deg
    legs (polar(q1, x1)) 119mm 116deg, (polar(x2, theta + q2)) 40deg -157mm, (polar(x3, theta + q3)) 160deg -18mm;
    theta -58deg

    "PR-PR-RP" 4 [Pr Pr Rp]
    crank 27mm pivots (137mm, 13mm) (103mm, 92mm) link 108mm 62mm 70deg
    legs (polar(x1, q1)) -65deg -67mm, (polar(x2, q2)) -5deg -243mm, (polar(x3, theta + q3)) 15deg 132mm;
    theta -158deg

    "PR-RP-RP" 4 [Pr Rp Rp]
    crank 16mm pivots (144mm, 6mm) (30mm, 144mm) link 78mm 44mm 65deg
    legs (polar(x1, q1)) 55deg 84mm, (polar(x2, theta + q2)) 15deg -31mm, (polar(x3, theta + q3)) 10deg 90mm;
    theta -45deg

    "PR-PR-PR" 2 [Pr Pr Pr]
    crank 35mm pivots (90mm, 12mm) (68mm, 102mm) link 107mm 89mm 85deg
    legs (polar(x1, q1)) 5deg 99mm, (polar(x2, q2)) -60deg -92mm, (polar(x3, q3)) -90deg 141mm;
    theta 142deg

    "RP-RP-RP" 2 [Rp Rp Rp]
    crank 20mm pivots (128mm, 17mm) (82mm, 111mm) link 96mm 73mm 80deg
    legs (polar(x1, theta + q1)) 50deg 41mm, (polar(x2, theta + q2)) -15deg 19mm, (polar(x3, theta + q3)) -70deg 12mm;
    theta -16deg
}
