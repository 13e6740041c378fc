//! Links that the user lists must be rigid, and move.

use crate::diagnostic::text::list;
use crate::diagnostic::{OriginId, Reporter};
use crate::ir::{Picture, PointKind};
use crate::message_format::numbers;
use crate::model::Mechanism;
use crate::picture::marks::{Asked, Spot};
use crate::picture::samples::Samples;
use crate::picture::sketch::Sketch;

pub(super) fn check_lists(
    mechanism: &Mechanism,
    sketch: &Sketch,
    samples: &Samples,
    reporter: &mut Reporter,
) {
    for asked in &sketch.asked {
        let first = samples.same[asked.points[0]];
        if asked
            .points
            .iter()
            .all(|&point| samples.same[point] == first)
        {
            let fact = "these points are always at the same place: this is no link";
            reporter.error_with_help(asked.origin, fact, "list different points of the link");
        } else if let Some(fact) = stretched(mechanism, &sketch.points, samples, asked) {
            let help = "a link is rigid: list points that keep their distances";
            reporter.error_with_help(asked.origin, fact, help);
        } else if asked.points.iter().all(|&point| samples.is_fixed(point)) {
            let fact = "none of these points moves: this is no link, but the frame";
            reporter.error_with_help(asked.origin, fact, "leave the list out");
        }
    }
}

/// Warns of loops of which the picture shows nothing.
pub(super) fn warn_of_undrawn_loops(picture: &Picture, origin: OriginId, reporter: &mut Reporter) {
    let numbers: Vec<String> = picture.undrawn.iter().map(usize::to_string).collect();
    let (loops, lie) = match numbers.len() {
        0 => return,
        1 => ("loop", "it lies"),
        _ => ("loops", "they lie"),
    };
    let fact = format!(
        "{loops} {} not drawn: components of vectors do not tell where in space {lie}",
        match &numbers[..] {
            [one] => format!("{one} is"),
            [first @ .., last] => format!("{} and {last} are", first.join(", ")),
            [] => String::new(),
        }
    );
    let help = "write the loop with whole vectors, or list the points of its links: `picture([a, b], ...)`";
    reporter.warning_with_help(origin, fact, help);
}

/// Warns of points that move, but that no link of the picture carries.
pub(super) fn warn_of_loose_points(picture: &Picture, origin: OriginId, reporter: &mut Reporter) {
    let loose = picture.points.iter();
    let loose = loose.filter(|point| point.kind == PointKind::Loose);
    let names: Vec<&str> = loose.map(|point| point.name.as_str()).collect();
    let [first, ..] = names[..] else {
        return;
    };
    let (moves, them) = match names.len() {
        1 => ("moves", "it"),
        _ => ("move", "them"),
    };
    let fact = format!(
        "{} {moves}, but no link of the picture carries {them}",
        list(&names)
    );
    let help = format!(
        "where the loops do not tell of a link, list its points: `picture([{first}, ...])`"
    );
    reporter.warning_with_help(origin, fact, &help);
}

/// Two points of a list whose distance changes, with the numbers.
fn stretched(
    mechanism: &Mechanism,
    points: &[Spot],
    samples: &Samples,
    asked: &Asked,
) -> Option<String> {
    let name = |index: usize| {
        let title = points[asked.points[index]].name.as_ref();
        title.map_or_else(
            || format!("point {}", index + 1),
            |title| format!("`{}`", title.text),
        )
    };
    let count = asked.points.len();
    let pairs = (0..count).flat_map(|a| (a + 1..count).map(move |b| (a, b)));
    for (a, b) in pairs {
        let distances = samples.distances(asked.points[a], asked.points[b]);
        if samples.keep_distance_as_written(asked.points[a], asked.points[b]) {
            continue;
        }
        let other = distances.iter().copied().fold(distances[0], |far, length| {
            if (length - distances[0]).abs() > (far - distances[0]).abs() {
                length
            } else {
                far
            }
        });
        let unit = mechanism.unit.name();
        let lengths = numbers(&[distances[0], other]);
        return Some(format!(
            "a link that stretches: from {} to {} it is {} {unit} at the reference input, {} {unit} elsewhere",
            name(a),
            name(b),
            lengths[0],
            lengths[1],
        ));
    }
    None
}
