//! Loops that are too many: which of them hold nothing that others do not hold.

use crate::mobility::line;
use crate::mobility::motion;
use linkage_symbolic::Graph;

use super::loops::Loops;
use super::null_space::{ZERO, transposed, used, vectors};
use super::{Position, Rows};
use crate::message_format::loop_list;

/// So many dependences are told.
const TOLD: usize = 3;

/// What is too much where the unknowns stand.
pub(crate) struct Surplus {
    /// Loops that could be left out, all together.
    pub(crate) spare: Vec<usize>,
    /// `loop 7 depends on loops 1, 2 and 3`, one behind the other.
    pub(crate) dependences: String,
    /// How the mechanism moves all the same.
    pub(crate) motion: Option<String>,
}

/// The last loops that others make superfluous; nothing if there are none.
pub(crate) fn surplus(position: &Position<'_, '_>) -> Option<Surplus> {
    let graph = Graph::new();
    let rows = position.rows(&Loops::new(position.mechanism, &graph))?;
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
    (!dependences.is_empty()).then(|| Surplus {
        spare,
        dependences: format!("{}{more}", told.join("; ")),
        motion: motion::motion(position, &rows, ZERO),
    })
}

fn dependence_of(position: &Position<'_, '_>, rows: &Rows, row: usize, set: &[usize]) -> String {
    let others = set.iter().filter(|&&other| other != row);
    let others: Vec<usize> = others.map(|&other| rows.loops[other]).collect();
    let own = loop_list([&rows.loops[row]]);
    let shape = line::shape_of_links(position, rows, set);
    let because = shape.map_or_else(String::new, |shape| format!(", since their links {shape}"));
    match others.is_empty() {
        true => format!("{own} holds nothing"),
        false => format!(
            "{own} holds nothing that {} do not hold{because}",
            loop_list(&others)
        ),
    }
}

impl Rows {
    /// Those of some rows on which the last one depends, with itself; nothing if it does not. The rows before it are independent.
    fn dependent_set(&self, rows: &[usize]) -> Option<Vec<usize>> {
        let matrix: Vec<Vec<f64>> = rows.iter().map(|&row| self.matrix[row].clone()).collect();
        let weights = vectors(&transposed(&matrix), rows.len(), ZERO)
            .into_iter()
            .next()?;
        Some(used(&weights).into_iter().map(|k| rows[k]).collect())
    }
}
