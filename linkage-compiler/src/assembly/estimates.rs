//! Compares start estimates with the assemblies of a group, and lists assemblies as text to copy.

use std::f64::consts::{FRAC_PI_3, PI, TAU};

use linkage_symbolic::program::Ternary;

use crate::algebra::Bound;
use crate::model::Dimension;
use crate::solve::Solved;

use super::assembler::Assembly;

/// An angle farther than this from its estimate is not the one that was meant: estimates are read
/// off a drawing to some ten degrees, and two assemblies are seldom nearer to each other.
const FAR_ANGLE: f64 = FRAC_PI_3;

/// A length farther off than this share of the mechanism's size is not the one that was meant.
const FAR_SHARE: f64 = 0.5;

/// An unknown of the other sign farther off than this part of the allowed difference has an
/// estimate of the wrong sign: smaller ones are estimates about zero.
const OTHER_SIGN: f64 = 0.5;

/// The rounding that may be added to a difference that is just allowed.
const ROUNDING: f64 = 1e-9;

/// The largest number of assemblies listed in a message: all of a triad.
pub(super) const LISTED: usize = 6;

/// The position of the unknowns in an assembly of a group.
#[derive(Clone, Debug)]
pub(super) struct Position {
    /// Each unknown with its components; angles are those nearest to their estimates.
    values: Vec<(usize, Vec<f64>)>,
    /// The distance from the estimates; infinite for an assembly that does not close.
    pub(super) distance: f64,
}

/// Returns the unknowns in which this position differs from a neighbour by more than a hundredth of
/// the largest difference; `yardstick` is the difference that counts like a radian.
pub(super) fn differing(
    position: &Position,
    other: &Position,
    yardstick: impl Fn(usize) -> f64,
) -> Vec<usize> {
    const LITTLE: f64 = 0.01;
    let mut all: Vec<(usize, f64)> = Vec::new();
    for ((unknown, numbers), (_, other)) in position.values.iter().zip(&other.values) {
        let off = numbers.iter().zip(other).map(|(a, b)| (a - b).abs());
        all.push((*unknown, off.fold(0.0, f64::max) / yardstick(*unknown)));
    }
    let most = all.iter().fold(0.0, |most: f64, (_, off)| most.max(*off));
    let differing = all.into_iter().filter(|(_, off)| *off > LITTLE * most);
    differing.map(|(unknown, _)| unknown).collect()
}

/// The method that found the assembly of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Choice {
    /// Chosen among all assemblies of the group.
    Listed,
    /// Chosen among all assemblies of the group except some that meet at a dead point.
    ListedApart,
    /// Followed from its estimates.
    Followed,
}

impl Choice {
    /// Returns the text after a number of assemblies.
    pub(super) fn beside(self) -> &'static str {
        match self {
            Self::Listed | Self::Followed => "",
            Self::ListedApart => " beside those that meet at a dead point",
        }
    }
}

/// An unknown that is not where its estimate is.
struct Unmet<'p> {
    unknown: usize,
    value: &'p [f64],
    /// The difference divided by the allowed one.
    excess: f64,
}

/// An unknown angle by its cosine and sine: the value that is nearest to its estimate.
pub(super) fn angle_near_estimate(
    assembly: &Assembly<'_, '_>,
    unknown: usize,
    [cos, sin]: [f64; 2],
) -> f64 {
    let estimate = assembly.nominal.estimates[unknown][0];
    Ternary::AngleNear.apply([sin, cos, estimate])
}

/// The angle from the estimate of a link to its direction, of a link that is no unknown of the
/// mechanism: it is estimated by the points that it joins.
pub(super) fn link_from_estimate(
    assembly: &Assembly<'_, '_>,
    angle: usize,
    [cos, sin]: [f64; 2],
) -> f64 {
    let drawn = assembly.algebra.names.angles[angle].drawn;
    Ternary::AngleNear.apply([sin, cos, drawn]) - drawn
}

/// The unknowns of an assembly, compared with their estimates; `links` are the differences of
/// links.
pub(super) fn position(
    assembly: &Assembly<'_, '_>,
    values: Vec<(usize, Vec<f64>)>,
    links: &[f64],
) -> Position {
    let estimated = values
        .iter()
        .filter(|(unknown, _)| is_estimated(assembly, *unknown));
    let differences = estimated.flat_map(|(unknown, value)| {
        let unit = assembly.yardstick(*unknown);
        let limit = match assembly.algebra.names.bound[*unknown] {
            Bound::Angle(_) => PI,
            Bound::Lengths(_) => f64::INFINITY,
        };
        let pairs = value.iter().zip(&assembly.nominal.estimates[*unknown]);
        pairs.map(move |(x, estimate)| ((x - estimate) / unit).clamp(-limit, limit))
    });
    let distance = differences.chain(links.iter().copied());
    let distance = distance.map(|x| x * x).sum::<f64>().sqrt();
    Position {
        distance: match distance.is_nan() {
            true => f64::INFINITY,
            false => distance,
        },
        values,
    }
}

/// `theta = 60deg, psi = 120deg`
pub(super) fn shown(assembly: &Assembly<'_, '_>, position: &Position) -> String {
    let values = position.values.iter();
    let words = values.map(|(unknown, value)| assembly.words.unknown_value(*unknown, value));
    words.collect::<Vec<_>>().join(", ")
}

/// Keeps the values of the unknowns without an estimate.
pub(super) fn keep_found(assembly: &mut Assembly<'_, '_>, chosen: &Position) {
    let open = chosen.values.iter();
    let open = open.filter(|(unknown, _)| !is_estimated(assembly, *unknown));
    assembly.found.extend(open.cloned().collect::<Vec<_>>());
}

/// Reports unknowns without an estimate of a group whose assemblies the other estimates do not
/// distinguish, the nearest assembly first; returns false if there is none.
pub(super) fn lacks_estimates(
    assembly: &mut Assembly<'_, '_>,
    solved: &Solved,
    all: &[&Position],
    choice: Choice,
) -> bool {
    let unknowns = all.iter().take(1).flat_map(|position| &position.values);
    let unknowns = unknowns.map(|(unknown, _)| *unknown);
    let open: Vec<usize> = unknowns.filter(|k| !is_estimated(assembly, *k)).collect();
    let [first, ..] = open[..] else {
        return false;
    };
    let message = format!(
        "{} {} no estimate{}, and {}\n\
             help: write the estimates of the assembly that is meant",
        assembly.words.unknowns(&open),
        if open.len() == 1 { "has" } else { "have" },
        assembly.words.at_reference(&assembly.nominal.inputs),
        listed(assembly, solved, all, choice),
    );
    let origin = assembly.algebra.mechanism.unknowns[first].origin;
    assembly.reporter.error(origin, message);
    true
}

pub(super) fn is_estimated(assembly: &Assembly<'_, '_>, unknown: usize) -> bool {
    let item = &assembly.algebra.mechanism.unknowns[unknown];
    item.of_part || item.estimate.is_some()
}

/// Reports an assembly whose unknowns are far from their estimates, among all assemblies of the
/// group, the nearest first; returns false if it reported one.
pub(super) fn meets_estimates(
    assembly: &mut Assembly<'_, '_>,
    solved: &Solved,
    all: &[&Position],
    choice: Choice,
) -> bool {
    let Some(unmet) = all.first().and_then(|chosen| worst(assembly, chosen)) else {
        if let Some(chosen) = all.first() {
            warn_of_sign(assembly, solved, chosen);
        }
        return true;
    };
    let item = &assembly.algebra.mechanism.unknowns[unmet.unknown];
    let coordinate = assembly.words.coordinate(&item.ty, unmet.value);
    let estimate = &assembly.nominal.estimates[unmet.unknown];
    let difference = difference(assembly, unmet.unknown, unmet.value);
    let loops = assembly.words.loops(&solved.group.loops);
    let message = format!(
        "`{}` is found at {coordinate}, {difference} its estimate {}{}; {}\n\
             help: look for a wrong sign or number in {loops}, or write the estimates of the assembly that is meant",
        item.name,
        assembly.words.coordinate(&item.ty, estimate),
        assembly.words.at_reference(&assembly.nominal.inputs),
        listed(assembly, solved, all, choice),
    );
    let estimate = item.estimate.as_ref();
    let origin = estimate.map_or(item.origin, |estimate| estimate.origin);
    let is_written = estimate.is_some() && !item.of_part;
    let span = assembly.reporter.span_between([origin; 2]);
    let message = assembly.reporter.error(origin, message);
    if is_written {
        message.suggest(format!("take the estimate {coordinate}"), span, coordinate);
    }
    false
}

/// Warns of the estimates that are allowed, and would be nearer with the other sign.
fn warn_of_sign(assembly: &mut Assembly<'_, '_>, solved: &Solved, chosen: &Position) {
    for (unknown, value) in &chosen.values {
        let item = &assembly.algebra.mechanism.unknowns[*unknown];
        let ([x], [estimate]) = (&value[..], &assembly.nominal.estimates[*unknown][..]) else {
            continue;
        };
        let Some(written) = &item.estimate else {
            continue;
        };
        let is_other_sign = x * estimate < 0.0 && excess(assembly, *unknown, value) > OTHER_SIGN;
        // A half turn is an angle with both signs.
        if !is_other_sign || (x + estimate).abs() >= (x - estimate).abs() {
            continue;
        }
        let coordinate = assembly.words.coordinate(&item.ty, value);
        let fact = format!(
            "`{}` is found at {coordinate}, {} its estimate {}{}: of the other sign",
            item.name,
            difference(assembly, *unknown, value),
            assembly.words.coordinate(&item.ty, &[*estimate]),
            assembly.words.at_reference(&assembly.nominal.inputs),
        );
        let help = format!(
            "if this assembly is meant, write `unknown {};`; otherwise look for a wrong sign in {}",
            assembly.words.unknown_value(*unknown, value),
            assembly.words.loops(&solved.group.loops)
        );
        let origin = written.origin;
        let is_of_part = item.of_part;
        let span = assembly.reporter.span_between([origin; 2]);
        let message = assembly.reporter.warning_with_help(origin, fact, help);
        if !is_of_part {
            message.suggest(format!("take the estimate {coordinate}"), span, coordinate);
        }
    }
}

/// `loop 1 has two assemblies:`, and each on a line as estimates that can be copied.
fn listed(
    assembly: &Assembly<'_, '_>,
    solved: &Solved,
    all: &[&Position],
    choice: Choice,
) -> String {
    let loops = assembly.words.loops(&solved.group.loops);
    let has = match solved.group.loops.len() {
        1 => "has",
        _ => "have",
    };
    let count = match all.len() {
        1 => "one assembly".to_owned(),
        2 => "two assemblies".to_owned(),
        more if more > LISTED => format!("{more} assemblies, the nearest of them"),
        more => format!("{more} assemblies"),
    };
    let lines = all.iter().take(LISTED).map(|position| {
        let values = position.values.iter();
        let items = values.map(|(unknown, value)| {
            let within_a_turn = match assembly.algebra.names.bound[*unknown] {
                Bound::Angle(_) => value.iter().map(|angle| angle % TAU).collect(),
                Bound::Lengths(_) => value.clone(),
            };
            let words = assembly.words.unknown_value(*unknown, &within_a_turn);
            format!("unknown {words};")
        });
        format!("\n    {}", items.collect::<Vec<_>>().join(" "))
    });
    let lines: String = lines.collect();
    match choice {
        Choice::Listed | Choice::ListedApart => {
            format!("{loops} {has} {count}{}:{lines}", choice.beside())
        }
        Choice::Followed => {
            format!(
                "{loops} cannot be listed, and {has} this assembly where the estimates lead:{lines}"
            )
        }
    }
}

/// The unknown that is farthest from its estimate, if that is too far.
fn worst<'p>(assembly: &Assembly<'_, '_>, position: &'p Position) -> Option<Unmet<'p>> {
    let all = position.values.iter().map(|(unknown, value)| Unmet {
        unknown: *unknown,
        value,
        excess: excess(assembly, *unknown, value),
    });
    let worst = all.max_by(|a, b| a.excess.total_cmp(&b.excess))?;
    (worst.excess > 1.0 + ROUNDING).then_some(worst)
}

/// Returns the distance of an unknown from its estimate, divided by the allowed one.
fn excess(assembly: &Assembly<'_, '_>, unknown: usize, value: &[f64]) -> f64 {
    if !is_estimated(assembly, unknown) {
        return 0.0;
    }
    let difference = distance(assembly, unknown, value);
    match is_direction(assembly, unknown) {
        true => difference / FAR_ANGLE,
        false => difference / (FAR_SHARE * size_with(assembly, value)),
    }
}

/// Returns the size of the mechanism with this value: a slide can extend it, a point does not.
fn size_with(assembly: &Assembly<'_, '_>, value: &[f64]) -> f64 {
    match value {
        [slide] => assembly.size.max(slide.abs()),
        _ => assembly.size,
    }
}

/// `108deg from`, `95mm from`
fn difference(assembly: &Assembly<'_, '_>, unknown: usize, value: &[f64]) -> String {
    let difference = distance(assembly, unknown, value);
    let dimension = match is_direction(assembly, unknown) {
        true => Dimension::ANGLE,
        false => Dimension::LENGTH,
    };
    format!("{} from", assembly.words.rounded(dimension, difference))
}

/// Returns true for angles and for vectors of numbers, of which only the direction counts.
fn is_direction(assembly: &Assembly<'_, '_>, unknown: usize) -> bool {
    let dimension = assembly.algebra.mechanism.unknowns[unknown].ty.dimension();
    dimension.is_some_and(|dimension| dimension.half_lengths == 0)
}

/// Returns the difference between an unknown and its estimate: an angle or a length.
fn distance(assembly: &Assembly<'_, '_>, unknown: usize, value: &[f64]) -> f64 {
    let estimate = &assembly.nominal.estimates[unknown];
    let length = |v: &mut dyn Iterator<Item = f64>| v.fold(0.0, |sum: f64, x| sum.hypot(x));
    let pairs = || value.iter().zip(estimate);
    match (is_direction(assembly, unknown), value) {
        (true, [angle]) => (angle - estimate[0]).abs(),
        (true, _) => {
            let [size, other] = [value, estimate].map(|v| length(&mut v.iter().copied()));
            let product: f64 = pairs().map(|(x, e)| (x / size) * (e / other)).sum();
            // A vector of zeros points nowhere, which estimates nothing.
            match product.is_nan() {
                true => 0.0,
                false => product.clamp(-1.0, 1.0).acos(),
            }
        }
        (false, _) => length(&mut pairs().map(|(x, e)| x - e)),
    }
}
