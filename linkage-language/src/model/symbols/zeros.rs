//! Zeros without a unit, and unknowns without an estimate: assumptions about their types.

use crate::model::types::{Name, Type};

/// Assumptions about zeros.
#[derive(Clone, Default)]
pub(in crate::model) struct Zeros {
    /// Those that are lengths; the others are numbers.
    pub(in crate::model) lengths: Vec<Name>,
    /// Unknowns without an estimate that are vectors, with the number of their components.
    vectors: Vec<(Name, usize)>,
}

impl Zeros {
    /// These are lengths, all others numbers.
    pub(in crate::model) fn lengths(lengths: &[Name]) -> Self {
        Self {
            lengths: lengths.to_vec(),
            vectors: Vec::new(),
        }
    }

    /// Returns the zero that replaces a missing estimate.
    pub(in crate::model) fn zero_of(&self, name: Name) -> Type {
        let mut vectors = self.vectors.iter();
        let count = vectors.find_map(|(other_name, count)| (*other_name == name).then_some(*count));
        Type::Zero(count.unwrap_or(1))
    }

    fn is_length(&self, name: Name) -> bool {
        self.lengths.contains(&name)
    }

    /// With another choice for an unknown without an estimate.
    pub(in crate::model) fn with(&self, name: Name, components: usize, length: bool) -> Self {
        let mut other = self.clone();
        other.vectors.retain(|(other_name, _)| *other_name != name);
        if components > 1 {
            other.vectors.push((name, components));
        }
        if length && !self.is_length(name) {
            other.lengths.push(name);
        }
        if !length {
            other.lengths.retain(|other_name| *other_name != name);
        }
        other
    }
}
