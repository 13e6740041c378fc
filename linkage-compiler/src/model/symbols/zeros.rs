//! Zeros without a unit, and unknowns without an estimate: what they are taken for.

use crate::model::types::{Name, Type};

/// What zeros are taken for.
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

    /// The zero that stands for an estimate that is not given.
    pub(in crate::model) fn zero_of(&self, name: Name) -> Type {
        let mut vectors = self.vectors.iter();
        let count = vectors.find_map(|(own, count)| (*own == name).then_some(*count));
        Type::Zero(count.unwrap_or(1))
    }

    fn is_length(&self, name: Name) -> bool {
        self.lengths.contains(&name)
    }

    /// With another choice for an unknown without an estimate.
    pub(in crate::model) fn with(&self, name: Name, components: usize, length: bool) -> Self {
        let mut other = self.clone();
        other.vectors.retain(|(own, _)| *own != name);
        if components > 1 {
            other.vectors.push((name, components));
        }
        if length && !self.is_length(name) {
            other.lengths.push(name);
        }
        if !length {
            other.lengths.retain(|own| *own != name);
        }
        other
    }
}
