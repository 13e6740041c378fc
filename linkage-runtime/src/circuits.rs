//! Which assemblies run through the whole range of an input, and where the others end.

mod ends;
mod print;

use crate::numeric::range::{first_failure, minimum};
use alloc::vec::Vec;
use ends::Side;

/// The range of an input whose assemblies are looked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cycle {
    /// Lower end of the range.
    pub low: f64,
    /// Upper end of the range.
    pub high: f64,
    /// Whether the input is an angle in radians. Over a full turn, assemblies that continue each other from one turn to the
    /// next belong to one circuit.
    pub angle: bool,
    /// At how many inputs the assemblies are listed, both ends included. One that exists between two neighbouring inputs
    /// only is not found.
    pub samples: usize,
}

/// All assemblies over the range of an input.
///
/// Printed, it is a table; angles are in degrees.
#[derive(Clone, Debug, PartialEq)]
pub struct Circuits<A> {
    /// The range.
    pub cycle: Cycle,
    /// The assemblies, in the order of the inputs where they were found.
    pub branches: Vec<Branch<A>>,
}

/// An assembly and how far it reaches.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch<A> {
    /// The assembly.
    pub assembly: A,
    /// Number of its circuit. Without being taken apart, a mechanism reaches all assemblies of a circuit, through turning
    /// points, and no other.
    pub circuit: usize,
    /// Where it begins and ends.
    pub ends: [BranchEnd; 2],
    /// Whether it is the same again after a full turn of the input.
    pub closed: bool,
    /// Its smallest margin, 0 at a turning point.
    pub margin: f64,
    /// The input where the margin is smallest.
    pub at: f64,
}

/// Where an assembly begins or ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BranchEnd {
    /// With the range.
    Range(f64),
    /// At a turning point, a dead point of the input, where it meets another assembly of its circuit.
    TurningPoint(f64),
    /// It is not known beyond this input, although there is no turning point.
    Lost(f64),
}

impl BranchEnd {
    /// The input.
    #[must_use]
    pub fn x(self) -> f64 {
        match self {
            Self::Range(x) | Self::TurningPoint(x) | Self::Lost(x) => x,
        }
    }
}

impl<A> Branch<A> {
    /// Whether it runs through the whole range.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        let through = |end: &BranchEnd| matches!(end, BranchEnd::Range(_));
        self.ends.iter().all(through)
    }
}

impl<A> Circuits<A> {
    /// The assemblies that run through the whole range.
    pub fn whole(&self) -> impl Iterator<Item = &Branch<A>> {
        self.branches.iter().filter(|branch| branch.is_whole())
    }
}

/// How close the places of one assembly are, relative to their size: at one input, and at a turning point, where they
/// are extrapolated.
const SAME: f64 = 1e-6;
const MEETING: f64 = 1e-3;

/// A range of an angle that differs from a full turn by less, in radians, is one: users write 360 degrees.
const TURN: f64 = 1e-9;

/// Margins that are looked at along an assembly.
const MARGINS: usize = 360;

/// Finds all assemblies over a range, how far each reaches, and where its margin is smallest.
///
/// `list` gives the assemblies at an input; an error there counts as none, unless every input has one. `margin` is the
/// margin of an assembly at an input, NaN where it is not assembled; `place` are numbers by which assemblies
/// differ, such as the coordinates of a point, or sines and cosines of angles: they must change smoothly with the input.
/// Turning points are located to about 1e-9 of the range.
///
/// # Errors
///
/// The first error of `list` if it fails at all inputs.
///
/// ```
/// use linkage_runtime::{Cycle, circuits};
///
/// // y^2 = 1 - x^2: two assemblies that meet at x = -1 and x = 1.
/// let y = |sign: &f64, x: f64| sign * (1.0 - x * x).sqrt();
/// let cycle = Cycle { low: -2.0, high: 2.0, angle: false, samples: 9 };
/// let found = circuits(
///     &cycle,
///     |x| if x.abs() < 1.0 { Ok(vec![1.0, -1.0]) } else { Err("out of reach") },
///     |sign, x| y(sign, x).abs(),
///     |sign, x| vec![y(sign, x)],
/// )?;
/// assert_eq!(found.branches.len(), 2);
/// assert!((found.branches[0].ends[1].x() - 1.0).abs() < 1e-9);
/// assert_eq!(found.branches[0].circuit, found.branches[1].circuit);
/// # Ok::<(), &str>(())
/// ```
pub fn circuits<A, E>(
    cycle: &Cycle,
    mut list: impl FnMut(f64) -> Result<Vec<A>, E>,
    margin: impl Fn(&A, f64) -> f64,
    place: impl Fn(&A, f64) -> Vec<f64>,
) -> Result<Circuits<A>, E> {
    let mut found: Vec<Found<A>> = Vec::new();
    let (mut error, mut listed) = (None, false);
    for index in 0..cycle.samples.max(2) {
        let x = cycle.sample(index);
        let all = match list(x) {
            Ok(all) => all,
            Err(new) => {
                error = error.or(Some(new));
                continue;
            }
        };
        listed = true;
        for assembly in all {
            let here = place(&assembly, x);
            let known = |one: &Found<A>| {
                one.covers(x) && near(&place(&one.assembly, x), &here, size(&here), SAME)
            };
            if margin(&assembly, x).is_nan() || found.iter().any(known) {
                continue;
            }
            let sides = [-1.0, 1.0].map(|side| {
                let at = cycle.failure(x, side, |x| margin(&assembly, x));
                let margin = |x| margin(&assembly, x);
                Side::new(cycle, at, side, &here, margin, |x| place(&assembly, x))
            });
            found.push(Found { assembly, sides });
        }
    }
    if let (Some(error), false) = (error, listed) {
        return Err(error);
    }
    lose_gaps(cycle, &mut found);
    let numbers = numbers(cycle, &found);
    let branches = found.into_iter().zip(numbers).map(|(one, circuit)| {
        let (at, least) = one.least(&margin);
        Branch {
            ends: [one.sides[0].end, one.sides[1].end],
            closed: one.sides[0].meets(&one.sides[1], cycle),
            assembly: one.assembly,
            circuit,
            margin: least,
            at,
        }
    });
    Ok(Circuits {
        cycle: *cycle,
        branches: branches.collect(),
    })
}

impl Cycle {
    fn sample(&self, index: usize) -> f64 {
        let last = self.samples.max(2) - 1;
        if index == last {
            return self.high;
        }
        self.low + (self.high - self.low) * (index as f64 / last as f64)
    }

    /// Where an assembly at `x` ends above or below (`side` 1 or -1).
    fn failure(&self, x: f64, side: f64, margin: impl Fn(f64) -> f64) -> Option<f64> {
        let end = side * if side > 0.0 { self.high } else { self.low };
        let along = |y: f64| margin(side * y);
        let start = side * x;
        if start >= end {
            return None;
        }
        first_failure(start, end, start, MARGINS, along).map(|failure| side * failure.at)
    }

    /// Whether the range is a full turn.
    fn is_turn(&self) -> bool {
        self.angle && ((self.high - self.low) - core::f64::consts::TAU).abs() < TURN
    }
}

/// An assembly and its two ends.
struct Found<A> {
    assembly: A,
    sides: [Side; 2],
}

impl<A> Found<A> {
    /// Whether `x` is between the ends.
    fn covers(&self, x: f64) -> bool {
        self.sides[0].inside <= x && x <= self.sides[1].inside
    }

    /// Where the margin is smallest, and the margin there.
    fn least(&self, margin: impl Fn(&A, f64) -> f64) -> (f64, f64) {
        for side in &self.sides {
            if let BranchEnd::TurningPoint(x) = side.end {
                return (x, 0.0);
            }
        }
        let [low, high] = [self.sides[0].inside, self.sides[1].inside];
        minimum(low, high, MARGINS, |x| margin(&self.assembly, x))
    }
}

/// At a turning point two assemblies end on the same side. Two ends that face each other across a narrow gap, with no partner of their
/// own, are places where one assembly is nearly singular and was lost.
fn lose_gaps<A>(cycle: &Cycle, found: &mut [Found<A>]) {
    let ends = || (0..found.len()).flat_map(|one| [(one, 0), (one, 1)]);
    let side = |(one, k): (usize, usize)| &found[one].sides[k];
    let alone = |end: &(usize, usize)| {
        ends().all(|other| other == *end || !side(other).meets(side(*end), cycle))
    };
    let lost: Vec<(usize, usize)> = ends()
        .filter(alone)
        .filter(|&end| ends().any(|other| side(other).faces(side(end), cycle)))
        .collect();
    for (one, k) in lost {
        found[one].sides[k].lose();
    }
}

/// The circuits that the assemblies belong to, numbered from 0.
fn numbers<A>(cycle: &Cycle, found: &[Found<A>]) -> Vec<usize> {
    let mut numbers: Vec<usize> = (0..found.len()).collect();
    for (one, first) in found.iter().enumerate() {
        for (other, second) in found.iter().enumerate().skip(one) {
            let sides = |a: usize, b: usize| first.sides[a].meets(&second.sides[b], cycle);
            if (0..2).any(|a| (0..2).any(|b| sides(a, b))) {
                let (low, high) = (
                    numbers[one].min(numbers[other]),
                    numbers[one].max(numbers[other]),
                );
                for number in &mut numbers {
                    if *number == high {
                        *number = low;
                    }
                }
            }
        }
    }
    // Without gaps, in order of appearance.
    let mut order: Vec<usize> = Vec::new();
    for number in &mut numbers {
        let known = order.iter().position(|known| known == number);
        *number = known.unwrap_or_else(|| {
            order.push(*number);
            order.len() - 1
        });
    }
    numbers
}

/// Whether places are the same, within a share of this size.
fn near(a: &[f64], b: &[f64], size: f64, share: f64) -> bool {
    let close = |(a, b): (&f64, &f64)| (a - b).abs() <= share * size;
    a.iter().zip(b).all(close)
}

/// The largest of some numbers.
fn size(place: &[f64]) -> f64 {
    place.iter().fold(0.0, |size: f64, x| size.max(x.abs()))
}
