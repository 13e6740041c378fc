//! One mechanism for every kind of triad: legs of two pins (RR), of a slider on the frame and a pin
//! (PR), of a pin and a slider on the ternary link (RP), in any combination.
//!
//! The first leg hangs on a crank. Leg `i` leads from the pivot `a_i` to the point `e_i` of the ternary
//! link by a vector of length and direction: one of them is the unknown `x_i`, the other one the
//! dimension `q_i`.

use crate::legs::{Leg, Point, turned};
use linkage::{AssemblyError, Circuits};

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

/// A sweep over many dimensions.
pub(crate) type Sets = fn(&Dimensions, &[Dimensions], &[f64]) -> Vec<[Point; 2]>;

/// A mechanism for one kind of triad.
pub(crate) struct Kind {
    pub(crate) name: &'static str,
    /// Degree of the characteristic polynomial, which is the largest number of assemblies.
    pub(crate) degree: usize,
    pub(crate) joints: [Joints; 3],
    /// Of the mechanism.
    pub(crate) structure: &'static linkage::Structure,
    /// As written.
    pub(crate) dimensions: fn() -> Dimensions,
    /// The assembly that the estimates choose.
    pub(crate) assemble: fn(&Dimensions) -> Result<Evaluate, String>,
    /// All assemblies at an input.
    pub(crate) assemblies: fn(&Dimensions, f64) -> Result<Vec<Evaluate>, String>,
    /// The assembly that the estimates choose for the first dimensions, followed to the second ones.
    pub(crate) assemble_from: fn(&Dimensions, &Dimensions) -> Result<Evaluate, AssemblyError>,
    /// A sweep of the assembly that the estimates choose for the first dimensions over others, each at an input of its own: point and
    /// direction of the ternary link.
    pub(crate) sets: Sets,
    /// All assemblies over a turn.
    pub(crate) circuits: fn(&Dimensions) -> Result<Circuits<Evaluate>, String>,
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
}

macro_rules! kinds {
    ($($module:ident $name:literal $degree:literal [$($joints:ident)*]
        crank $crank:literal pivots $a2:tt $a3:tt link $b:literal $c:literal $kappa:literal
        legs $(($($leg:tt)*) $q:literal $x:literal),*;
        theta $theta:literal
    )*) => {
        $(mod $module {
            use super::*;

            kinds!(@mechanism $crank $a2 $a3 $b $c $kappa $theta $(($($leg)*) $q $x)*);

            fn mechanism(d: &Dimensions) -> Mechanism {
                let [crank, a2x, a2y, a3x, a3y, b, c, kappa, q1, q2, q3] = *d;
                let (a2, a3) = ([a2x, a2y].into(), [a3x, a3y].into());
                Mechanism { crank, a2, a3, b, c, kappa, q1, q2, q3 }
            }

            fn evaluate(assembly: MechanismAssembly) -> Evaluate {
                Box::new(move |phi| {
                    let (p, m) = (assembly.position(phi), assembly.motion(phi));
                    let misses = [p.miss_2.x, p.miss_2.y, p.miss_3.x, p.miss_3.y];
                    Answer {
                        point: p.e1.into(),
                        direction: p.direction.into(),
                        miss: crate::largest(misses),
                        margin: p.margin,
                        velocity: m.v.into(),
                        acceleration: m.a.into(),
                    }
                })
            }

            pub(super) const KIND: Kind = Kind {
                name: $name,
                degree: $degree,
                joints: [$(Joints::$joints),*],
                structure: &Mechanism::STRUCTURE,
                dimensions: || {
                    let Mechanism { crank, a2, a3, b, c, kappa, q1, q2, q3 } = Mechanism::default();
                    [crank, a2.x, a2.y, a3.x, a3.y, b, c, kappa, q1, q2, q3]
                },
                assemble: |d| mechanism(d).assemble().map(evaluate).map_err(|why| why.to_string()),
                assemblies: |d, phi| {
                    let found = mechanism(d).assemblies_at(phi).map_err(|why| why.to_string())?;
                    Ok(found.into_iter().map(evaluate).collect())
                },
                assemble_from: |from, to| {
                    let first = mechanism(from).assemble()?;
                    mechanism(to).assemble_from(&first).map(evaluate)
                },
                sets: |from, sets, phi| {
                    let first = mechanism(from).assemble().expect("as written");
                    let sets: Vec<Mechanism> = sets.iter().map(mechanism).collect();
                    let rows = first.position_sweep_sets(&sets, phi);
                    rows.iter().map(|row| [row.e1.into(), row.direction.into()]).collect()
                },
                circuits: |d| {
                    let found = mechanism(d).circuits().map_err(|why| why.to_string())?;
                    let branches = found.branches.into_iter().map(|branch| linkage::Branch {
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
                    Ok(Circuits { cycle: found.cycle, input, branches: branches.collect(), meetings: found.meetings })
                },
            };
        })*

        /// All kinds.
        pub(crate) const KINDS: &[Kind] = &[$($module::KIND),*];
    };
    (@mechanism $crank:literal $a2:tt $a3:tt $b:literal $c:literal $kappa:literal $theta:literal
        ($($leg1:tt)*) $q1:literal $x1:literal
        ($($leg2:tt)*) $q2:literal $x2:literal
        ($($leg3:tt)*) $q3:literal $x3:literal
    ) => {
        linkage::mechanism! {
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
        }
    };
}

kinds! {
    three_links "RR-RR-RR" 6 [Rr Rr Rr]
    crank 18mm pivots (126mm, -13mm) (30mm, 139mm) link 110mm 107mm 75deg
    legs (polar(q1, x1)) 79mm 86deg, (polar(q2, x2)) 69mm -177deg, (polar(q3, x3)) 107mm -24deg;
    theta -71deg

    slider_on_the_frame "RR-RR-PR" 6 [Rr Rr Pr]
    crank 16mm pivots (92mm, 11mm) (64mm, 138mm) link 42mm 55mm 75deg
    legs (polar(q1, x1)) 103mm -39deg, (polar(q2, x2)) 84mm -119deg, (polar(x3, q3)) 95deg -251mm;
    theta -173deg

    slider_on_the_link "RR-RR-RP" 6 [Rr Rr Rp]
    crank 17mm pivots (111mm, 14mm) (108mm, 147mm) link 75mm 62mm 40deg
    legs (polar(q1, x1)) 119mm 76deg, (polar(q2, x2)) 95mm 157deg, (polar(x3, theta + q3)) 170deg -88mm;
    theta -106deg

    one_of_each "RR-PR-RP" 6 [Rr Pr Rp]
    crank 27mm pivots (96mm, -1mm) (28mm, 84mm) link 97mm 42mm 30deg
    legs (polar(q1, x1)) 102mm -21deg, (polar(x2, q2)) 170deg -121mm, (polar(x3, theta + q3)) -35deg 153mm;
    theta 1deg

    two_sliders_on_the_frame "RR-PR-PR" 4 [Rr Pr Pr]
    crank 22mm pivots (96mm, -18mm) (66mm, 81mm) link 102mm 87mm 75deg
    legs (polar(q1, x1)) 125mm 100deg, (polar(x2, q2)) -70deg -83mm, (polar(x3, q3)) 85deg 95mm;
    theta -47deg

    two_sliders_on_the_link "RR-RP-RP" 4 [Rr Rp Rp]
    crank 21mm pivots (152mm, 12mm) (29mm, 138mm) link 68mm 67mm 60deg
    legs (polar(q1, x1)) 119mm 116deg, (polar(x2, theta + q2)) 40deg -157mm, (polar(x3, theta + q3)) 160deg -18mm;
    theta -58deg

    two_on_the_frame_one_on_the_link "PR-PR-RP" 4 [Pr Pr Rp]
    crank 27mm pivots (137mm, 13mm) (103mm, 92mm) link 108mm 62mm 70deg
    legs (polar(x1, q1)) -65deg -67mm, (polar(x2, q2)) -5deg -243mm, (polar(x3, theta + q3)) 15deg 132mm;
    theta -158deg

    one_on_the_frame_two_on_the_link "PR-RP-RP" 4 [Pr Rp Rp]
    crank 16mm pivots (144mm, 6mm) (30mm, 144mm) link 78mm 44mm 65deg
    legs (polar(x1, q1)) 55deg 84mm, (polar(x2, theta + q2)) 15deg -31mm, (polar(x3, theta + q3)) 10deg 90mm;
    theta -45deg

    three_sliders_on_the_frame "PR-PR-PR" 2 [Pr Pr Pr]
    crank 35mm pivots (90mm, 12mm) (68mm, 102mm) link 107mm 89mm 85deg
    legs (polar(x1, q1)) 5deg 99mm, (polar(x2, q2)) -60deg -92mm, (polar(x3, q3)) -90deg 141mm;
    theta 142deg

    three_sliders_on_the_link "RP-RP-RP" 2 [Rp Rp Rp]
    crank 20mm pivots (128mm, 17mm) (82mm, 111mm) link 96mm 73mm 80deg
    legs (polar(x1, theta + q1)) 50deg 41mm, (polar(x2, theta + q2)) -15deg 19mm, (polar(x3, theta + q3)) -70deg 12mm;
    theta -16deg
}
