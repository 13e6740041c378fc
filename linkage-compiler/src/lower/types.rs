//! What lowering hands to emission: straight-line programs and the shapes of their results.

use linkage_symbolic::program::Program;

use super::{Column, Coupled};
use crate::picture::Picture;

pub use crate::model::Shape;

/// Everything that becomes code.
#[derive(Clone, Debug, Default)]
pub struct Lowered {
    /// Computes all prepared slots in `assemble()`: loads parameters, modes, centres and windings; output `k` is slot
    /// `k`.
    pub prepare: Program,
    /// For each group in order, by how much it misses closing at given inputs: a length (or a number for an angle relation), positive if
    /// the group cannot be assembled, at most 0 if it can. Loads prepared slots and inputs (all inputs of the mechanism).
    pub gaps: Program,
    /// For each continuous angle `a`: outputs `2 a` and `2 a + 1` are its cosine and sine. Loads prepared slots and
    /// inputs. The centre and winding of angle `a` are not needed for its own outputs, only for later ones.
    pub angles: Program,
    pub continuous_angles: Vec<ContinuousAngle>,
    /// The smallest margin of all groups, then what their assemblies are told apart by: cosine and sine, or length, of every
    /// unknown. Loads prepared slots and inputs.
    pub survey: Program,
    /// The coupled groups in order.
    pub coupled: Vec<Coupled>,
    /// One for each function of the `impl` block, in order.
    pub evaluators: Vec<Evaluator>,
    /// What the function shows that asks for a picture.
    pub picture: Option<Picture>,
}

/// An unknown angle whose value (not only its direction) is used by some function.
#[derive(Clone, Debug)]
pub struct ContinuousAngle {
    /// Index in `Mechanism::unknowns`.
    pub unknown: usize,
    /// The inputs it depends on.
    pub inputs: Vec<usize>,
    /// Start estimate at the reference inputs, radians.
    pub estimate: f64,
}

#[derive(Clone, Debug)]
pub struct Evaluator {
    /// Index in `Mechanism::evaluators`.
    pub index: usize,
    /// Loads prepared slots, parameters and inputs; outputs are the fields' scalars in order, each field flattened
    /// outermost index first, vector components innermost.
    pub program: Program,
    /// The same from a table that was prepared for other dimensions, or for derivatives and digits that the table does not
    /// have; `None` if that is no different.
    pub beside: Option<Program>,
    /// The coupled groups whose prepared states it loads.
    pub states: Vec<usize>,
    pub fields: Vec<Field>,
    /// What each output is.
    pub columns: Vec<Column>,
    /// In which direction derivatives by parameters were found, if there are any.
    pub sensitivities: Option<&'static str>,
}

impl Evaluator {
    /// A sentence for the docs, a space in front, if there are derivatives by parameters.
    pub fn direction_note(&self) -> String {
        self.sensitivities.map_or_else(String::new, |direction| {
            format!(" Derivatives by parameters are computed {direction}.")
        })
    }
}

#[derive(Clone, Debug)]
pub struct Field {
    pub name: String,
    pub shape: Shape,
    /// Words for the docs: `mm`, `rad`, `mm/rad`, `1`, ...
    pub unit: String,
}
