//! Loops that are too many: which of them hold nothing that others do not hold.

use linkage_symbolic::Graph;

use crate::message_format::loop_names;
use crate::mobility::loops::Loops;
use crate::mobility::null_space::{ZERO, null_vectors, transposed, used};
use crate::mobility::position::{LoopRows, Position};
use crate::mobility::{line, motion, rows};

/// The greatest number of dependences in a message.
const TOLD: usize = 3;

/// The surplus of loops at a position.
pub(crate) struct Overconstraint {
    /// Loops that could be left out, all together.
    pub(crate) spare: Vec<usize>,
    /// `loop 7 depends on loops 1, 2 and 3`, one behind the other.
    pub(crate) dependences: String,
    /// The motion of the mechanism all the same.
    pub(crate) motion: Option<String>,
}

/// The last loops that others make superfluous; nothing if there are none.
pub(crate) fn surplus(position: &Position<'_, '_>) -> Option<Overconstraint> {
    let graph = Graph::new();
    let rows = rows::rows(position, &Loops::new(position.mechanism, &graph))?;
    let mut held: Vec<usize> = Vec::new();
    let mut dependences: Vec<(usize, Vec<usize>)> = Vec::new();
    for row in 0..rows.loops.len() {
        held.push(row);
        if let Some(set) = rows.dependent_set(&held) {
            held.pop();
            dependences.push((row, set));
        }
    }
    let holds = |index: &usize| held.iter().any(|&row| rows.loops[row] == *index);
    let mut spare: Vec<usize> = dependences
        .iter()
        .map(|(row, _)| rows.loops[*row])
        .collect();
    spare.dedup();
    spare.retain(|index| !holds(index));
    let told: Vec<String> = dependences
        .iter()
        .take(TOLD)
        .map(|(row, set)| dependence_of(position, &rows, *row, set))
        .collect();
    let more = match dependences.len() - told.len() {
        0 => String::new(),
        more => format!("; and {more} more"),
    };
    (!dependences.is_empty()).then(|| Overconstraint {
        spare,
        dependences: format!("{}{more}", told.join("; ")),
        motion: motion::motion(position, &rows, ZERO),
    })
}

fn dependence_of(
    position: &Position<'_, '_>,
    rows: &LoopRows,
    row: usize,
    set: &[usize],
) -> String {
    let others = set.iter().filter(|&&other| other != row);
    let others: Vec<usize> = others.map(|&other| rows.loops[other]).collect();
    let mechanism = position.mechanism;
    let named = loop_names(mechanism, [&rows.loops[row]]);
    let shape = line::shape_of_links(position, rows, set);
    let because = shape.map_or_else(String::new, |shape| format!(", since their links {shape}"));
    if others.is_empty() {
        format!("{named} holds nothing")
    } else {
        format!(
            "{named} holds nothing that {} do not hold{because}",
            loop_names(mechanism, &others)
        )
    }
}

impl LoopRows {
    /// Those of some rows on which the last one depends, with itself; nothing if it does not. The
    /// rows before it are independent.
    fn dependent_set(&self, rows: &[usize]) -> Option<Vec<usize>> {
        let matrix: Vec<Vec<f64>> = rows.iter().map(|&row| self.matrix[row].clone()).collect();
        let weights = null_vectors(&transposed(&matrix), rows.len(), ZERO)
            .into_iter()
            .next()?;
        Some(used(&weights).into_iter().map(|k| rows[k]).collect())
    }
}
