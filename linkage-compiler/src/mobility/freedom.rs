//! Motions that the loops leave free, and the loops that leave them.

use linkage_symbolic::Graph;

use crate::message_format::loop_names;
use crate::mobility::loops::Loops;
use crate::mobility::position::{LoopRows, Position};
use crate::mobility::{line, motion, null_space, rows};

/// Returns the motion of the mechanism at a dead point, or shortly before one, and the loops that
/// leave it free; nothing where it is not singular.
pub(crate) fn freedom(position: &Position<'_, '_>) -> Option<String> {
    let graph = Graph::new();
    let rows = rows::rows(position, &Loops::new(position.mechanism, &graph))?;
    sentence(position, &rows, null_space::NEARLY_ZERO)
}

/// Returns the motion of the mechanism where too few loops hold it.
pub(crate) fn motion_left(position: &Position<'_, '_>) -> Option<String> {
    let graph = Graph::new();
    let rows = rows::rows(position, &Loops::new(position.mechanism, &graph))?;
    sentence(position, &rows, null_space::ZERO)
}

fn sentence(position: &Position<'_, '_>, rows: &LoopRows, last: f64) -> Option<String> {
    let motion = motion::motion(position, rows, last)?;
    let dependent = dependent(rows, last).into_iter().next();
    Some(
        match dependent.and_then(|rows_of_set| dependence(position, rows, &rows_of_set)) {
            Some(why) => format!("{motion}, since {why}"),
            None => motion,
        },
    )
}

/// The rows of each set that does not hold independently, none of which could be left out of it.
fn dependent(rows: &LoopRows, last: f64) -> Vec<Vec<usize>> {
    let transposed = null_space::transposed(&rows.matrix);
    let all = null_space::null_vectors(&transposed, rows.matrix.len(), last).into_iter();
    all.map(|weights| null_space::used(&weights)).collect()
}

/// Returns the loops that depend on each other, if these rows do.
fn dependence(position: &Position<'_, '_>, rows: &LoopRows, dependent: &[usize]) -> Option<String> {
    let loops: Vec<usize> = dependent.iter().map(|&k| rows.loops[k]).collect();
    if let Some(shape) = line::shape_of_links(position, rows, dependent) {
        let linked = loops
            .iter()
            .all(|&k| position.mechanism.loops[k].of.is_some());
        let links = if linked { "" } else { "the links of " };
        return Some(format!(
            "{links}{} {shape}",
            loop_names(position.mechanism, &loops)
        ));
    }
    (loops.len() > 1).then(|| {
        format!(
            "{} do not hold independently of each other",
            loop_names(position.mechanism, &loops)
        )
    })
}
