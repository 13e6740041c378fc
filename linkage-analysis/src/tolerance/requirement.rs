//! An allowed error, at one position or many.

use alloc::vec;
use alloc::vec::Vec;
use core::array;

use super::modulus::farthest;
use super::{Effects, ToleranceError, Tolerances};
use crate::components::{Components, in_space, norm};

/// Kinds of addition of errors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Addition {
    /// All at their limits, with the worst signs.
    WorstCase,
    /// Independent: the root of the sum of squares.
    Statistical,
}

/// An allowed error of a quantity of `K` components, over positions with the sensitivities to `N`
/// parameters, to which tolerances are allocated.
///
/// ```
/// use linkage_runtime::Parameter;
/// use linkage_analysis::tolerance::{Addition, Requirement, AllocationRule};
///
/// let parameter = |name| Parameter { name, unit: "mm", nominal: 50.0, tolerance: 0.0 };
/// let parameters = ["a", "b"].map(parameter);
/// let requirement = Requirement::new(0.1, Addition::WorstCase).position(&[0.5, -2.0])?;
/// let allocation = requirement.allocate(&parameters, &AllocationRule::EqualEffect)?;
/// let [a, b] = allocation.tolerances.values();
/// assert!((a - 0.1).abs() < 1e-12 && (b - 0.025).abs() < 1e-12);
/// # Ok::<(), linkage_analysis::tolerance::ToleranceError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Requirement<const N: usize, const K: usize> {
    limit: f64,
    addition: Addition,
    by_component: bool,
    positions: Vec<[[f64; K]; N]>,
}

impl<const N: usize, const K: usize> Requirement<N, K> {
    /// The error vector may not be longer than `limit`, in the unit of the quantity.
    #[must_use]
    pub const fn new(limit: f64, addition: Addition) -> Self {
        Self {
            limit,
            addition,
            by_component: false,
            positions: Vec::new(),
        }
    }

    /// Each component may not be larger than the limit, instead of the whole vector.
    #[must_use]
    pub fn by_component(mut self) -> Self {
        self.by_component = true;
        self
    }

    /// At a position with these sensitivities, too.
    ///
    /// # Errors
    ///
    /// `NotFinite` for sensitivities that are NaN or infinite.
    pub fn position<V: Components<K>>(
        mut self,
        sensitivities: &[V; N],
    ) -> Result<Self, ToleranceError> {
        self.positions
            .push(array::from_fn(|i| sensitivities[i].components()));
        self.finite()
    }

    /// At positions with these sensitivities, too.
    ///
    /// # Errors
    ///
    /// As [`position`](Self::position).
    pub fn over<V: Components<K>>(
        mut self,
        positions: impl IntoIterator<Item = [V; N]>,
    ) -> Result<Self, ToleranceError> {
        let positions = positions
            .into_iter()
            .map(|position| position.map(V::components));
        self.positions.extend(positions);
        self.finite()
    }

    /// For the displacement from a start position to each of the positions given so far: their
    /// sensitivities minus those of the start.
    ///
    /// # Errors
    ///
    /// As [`position`](Self::position).
    pub fn relative_to<V: Components<K>>(mut self, start: &[V; N]) -> Result<Self, ToleranceError> {
        for position in &mut self.positions {
            for (row, start) in position.iter_mut().zip(start) {
                for (x, start) in row.iter_mut().zip(start.components()) {
                    *x -= start;
                }
            }
        }
        self.finite()
    }

    /// The allowed error.
    #[must_use]
    pub const fn limit(&self) -> f64 {
        self.limit
    }

    /// Kinds of addition of errors.
    #[must_use]
    pub const fn addition(&self) -> Addition {
        self.addition
    }

    /// The largest error that tolerances give over all positions.
    #[must_use]
    pub fn error_of(&self, tolerances: &Tolerances<N>) -> f64 {
        let errors = self
            .positions
            .iter()
            .map(|s| self.error(&Effects::new(*tolerances, s)));
        errors.fold(
            0.0,
            |max: f64, error| if error <= max { max } else { error },
        )
    }

    fn error(&self, effects: &Effects<N, K>) -> f64 {
        let largest = |components: [f64; K]| components.into_iter().fold(0.0, f64::max);
        match (self.addition, self.by_component) {
            (Addition::WorstCase, true) => largest(effects.worst_case()),
            (Addition::WorstCase, false) => effects.worst_modulus(),
            (Addition::Statistical, true) => largest(effects.root_sum_square()),
            (Addition::Statistical, false) => effects.root_sum_square_modulus(),
        }
    }

    /// The largest effect of each parameter over all positions, for a tolerance of 1.
    pub(super) fn largest_effects(&self) -> [f64; N] {
        let size = |row: &[f64; K]| {
            if self.by_component {
                row.iter().fold(0.0, |max: f64, x| max.max(x.abs()))
            } else {
                norm(row)
            }
        };
        array::from_fn(|i| {
            let sizes = self.positions.iter().map(|position| size(&position[i]));
            sizes.fold(0.0, f64::max)
        })
    }

    /// The limit must be positive and there must be positions.
    pub(super) fn check(&self) -> Result<(), ToleranceError> {
        if !(self.limit > 0.0 && self.limit.is_finite()) {
            return Err(ToleranceError::Limit { limit: self.limit });
        }
        if self.positions.is_empty() {
            return Err(ToleranceError::Nothing {
                what: "no positions",
            });
        }
        Ok(())
    }

    /// The conditions of the positions: of each the one that is tightest at some tolerances, or one
    /// for each component. A condition limits tolerances `t`, or their squares where errors add
    /// statistically: the vector `sum of row_i t_i` must not be longer than 1.
    pub(super) fn conditions(&self, tolerances: &[f64; N]) -> Vec<Vec<[f64; 3]>> {
        let plain = |x: f64| match self.addition {
            Addition::WorstCase => [x.abs(), 0.0, 0.0],
            Addition::Statistical => [x * x, 0.0, 0.0],
        };
        let mut conditions = Vec::new();
        for position in &self.positions {
            let rows = position.map(|row| row.map(|x| x / self.limit));
            match (self.by_component, self.addition) {
                (true, _) => {
                    let component = |k: usize| rows.iter().map(|row| plain(row[k])).collect();
                    conditions.extend((0..K).map(component));
                }
                (false, Addition::Statistical) => {
                    conditions.push(rows.iter().map(|row| plain(norm(row))).collect());
                }
                (false, Addition::WorstCase) => {
                    let vectors = rows.map(|row| in_space(&row));
                    conditions.push(with_worst_signs(&vectors, tolerances));
                }
            }
        }
        conditions
    }

    fn finite(self) -> Result<Self, ToleranceError> {
        for (position, rows) in self.positions.iter().enumerate() {
            if let Some(parameter) = rows
                .iter()
                .position(|row| row.iter().any(|x| !x.is_finite()))
            {
                return Err(ToleranceError::NotFinite {
                    position,
                    parameter,
                });
            }
        }
        Ok(self)
    }
}

/// The vectors with the signs of their longest sum.
fn with_worst_signs(vectors: &[[f64; 3]], tolerances: &[f64]) -> Vec<[f64; 3]> {
    let pairs = vectors.iter().zip(tolerances);
    let effects: Vec<_> = pairs.map(|(v, t)| v.map(|x| x * t)).collect();
    let signs = farthest(&effects).map_or_else(|| vec![1.0; vectors.len()], |corner| corner.signs);
    let signed = vectors.iter().zip(&signs);
    signed.map(|(v, sign)| v.map(|x| sign * x)).collect()
}
