//! Loops that are one too many and miss the others by little: dimensions that were written with too
//! few digits, as those of a strut between two points of one plate.

use linkage_symbolic::lookup::Map;
use linkage_symbolic::{Ex, substitute};

use crate::algebra::names::Names;
use crate::algebra::{Bound, Nominal};
use crate::message_format::loop_names;
use crate::model::Mechanism;
use crate::structure::equations::{Coordinate, CoordinateKind, Equation};
use crate::structure::link_faults;
use crate::structure::loops_together::{positions, simultaneous_loops};
use crate::structure::redundant::{RedundantLoops, coordinates_of_one};
use crate::structure::simultaneous::{SimultaneousLoops, largest};

/// Loops that miss by more than this share of the longest link are not meant to close.
const NEAR: f64 = 1e-6;

/// The share up to which a loop that is written as `redundant` may miss.
const ACCEPTED: f64 = 1e-9;

/// Checks if a loop with more equations than it has unknowns of its own nearly repeats the others,
/// and returns by how much it misses.
pub(crate) fn nearly_redundant<'m>(
    names: &Names<'m>,
    nominal: &Nominal,
    surplus: &Equation<'m>,
    equations: &[Equation<'m>],
    coordinates: &[Coordinate],
) -> Option<RedundantLoops> {
    let found_alone = coordinates_of_one(names, surplus, equations, coordinates);
    let (mut alone, mut shared) = (Vec::new(), Vec::new());
    for (k, coordinate) in coordinates.iter().enumerate() {
        let list = match found_alone.contains(&k) {
            true => &mut alone,
            false => &mut shared,
        };
        list.push(coordinate.clone());
    }
    let others = equations.iter().filter(|e| e.loops != surplus.loops);
    let others: Vec<Equation> = others.cloned().collect();
    if others.is_empty() {
        return None;
    }
    let others = simultaneous_loops(names, nominal, &others, &shared)?;
    let mut one = simultaneous_loops(names, nominal, std::slice::from_ref(surplus), &alone)?;
    if let Some(link) = surplus.distance.as_ref().filter(|link| link.less.is_none()) {
        one.rows = vec![link.vector.length() - link.length];
    }
    let places = positions(names, nominal);
    let moves = places.iter().any(|inputs| *inputs != places[0]);
    let (mut near, mut near_alone) = (others.estimates.clone(), one.estimates.clone());
    let mut most = 0.0;
    let mut length = None;
    let mut size = 0.0;
    for (number, inputs) in places.iter().enumerate() {
        let at = Nominal {
            inputs: inputs.clone(),
            ..nominal.clone()
        };
        near = others.closed(near, &at)?;
        let rows = others.substituted(&one.rows, &near);
        let here = SimultaneousLoops {
            rows: rows.clone(),
            coordinates: one.coordinates,
            symbols: one.symbols.clone(),
            estimates: one.estimates.clone(),
            scales: one.scales.clone(),
        };
        let (found, miss) = here.nearest(near_alone, &at)?;
        near_alone = found;
        most = f64::max(most, miss);
        if number == 0 {
            length = strut(names, &rows, &alone, &at);
            size = largest(others.slopes(&near, &at).iter().flatten());
        }
    }
    let is_near = most <= NEAR * size;
    if !moves || !is_near {
        return None;
    }
    let unit = names.mechanism.unit.name();
    let loops = loop_names(names.mechanism, &surplus.loops);
    let linked = nearly_fitting_link(names.mechanism, &surplus.loops, length.as_ref(), unit);
    let help = match length {
        Some((length, unknown)) => format!(
            "if this strut is to follow from the others, leave `{unknown}` and {loops} out, or write the distance of its ends \
             instead, `loop distance(..., ...) = {length}{unit} redundant;`; if it is to hold something, make a dimension, an \
             angle or an input an `unknown`"
        ),
        None if most <= ACCEPTED * size => format!(
            "if it is to follow from the others, leave {loops} out, or write `redundant` at its end; if it is to hold something, \
             make a dimension, an angle or an input an `unknown`"
        ),
        None => format!(
            "if it is to follow from the others, leave {loops} out, or write more digits of its dimensions and `redundant` at its \
             end; if it is to hold something, make a dimension, an angle or an input an `unknown`"
        ),
    };
    Some(RedundantLoops {
        fact: match linked {
            Some(_) => {
                format!("; with these dimensions it misses by no more than {most:.1e}{unit}")
            }
            None => format!(
                "; with these dimensions it misses the other loops by no more than {most:.1e}{unit}"
            ),
        },
        help: linked.unwrap_or(help),
    })
}

/// Returns the advice for a link that nearly repeats others; `None` for a loop as it is written.
fn nearly_fitting_link(
    mechanism: &Mechanism,
    loops: &[usize],
    length: Option<&(f64, String)>,
    unit: &str,
) -> Option<String> {
    let link = link_faults::link_to_leave_out(mechanism, loops)?;
    let distance = link_faults::distance_of_ends(mechanism, loops);
    let check = match (distance, length) {
        (Some(distance), Some((length, _))) => {
            format!(", or write `loop {distance} = {length}{unit} redundant;` in its place")
        }
        _ => String::new(),
    };
    Some(format!(
        "if it is to follow from the others, leave {link} out{check}; if it is to hold something, leave out another link, or an input"
    ))
}

/// Returns the length that a strut needs, and the name of its angle, if the loop has no other
/// unknown of its own. In `rows` all other unknowns are numbers.
fn strut<'m>(
    names: &Names<'m>,
    rows: &[Ex<'m>],
    alone: &[Coordinate],
    at: &Nominal,
) -> Option<(f64, String)> {
    let ([coordinate], [_, _]) = (alone, rows) else {
        return None;
    };
    let (CoordinateKind::Angle(_), Some(unknown)) = (coordinate.kind, coordinate.unknown) else {
        return None;
    };
    let Bound::Angle(index) = names.bound[unknown] else {
        return None;
    };
    let symbols = names.angles[index].symbols().into_iter();
    let nothing: Map<_, _> = symbols
        .map(|symbol| (symbol, names.graph.number(0.0)))
        .collect();
    let ends = at.evaluate(&substitute(rows, &nothing));
    let length = ends[0].hypot(ends[1]);
    // More digits than `redundant` needs.
    let length = format!("{length:.11e}").parse().unwrap_or(length);
    Some((length, names.mechanism.unknowns[unknown].name.clone()))
}
