//! Which parameters may vary, within bounds and relations: as it is written, then names looked up, mistakes told together.

use alloc::string::{String, ToString};
use alloc::vec::Vec;

use super::limits::{Limits, Linear};
use super::{DesignError, Relation};
use crate::{Dimensions, Parameter};

/// What may vary, as it is written.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Freedom {
    /// Parameters with their bounds.
    bounds: Vec<(String, f64, f64)>,
    /// Parameters that take some values only, which ascend.
    catalogues: Vec<(String, Vec<f64>)>,
    relations: Vec<Relation>,
}

/// The methods by which a design problem says what may vary, for its fields `nominal` and `freedom`.
macro_rules! freedom_methods {
    () => {
        /// A parameter may vary between these bounds, both included: named as in `PARAMETERS`, `pivot.x` for a component.
        #[must_use]
        pub fn vary(mut self, name: &str, low: f64, high: f64) -> Self {
            self.freedom.vary(name, low, high);
            self
        }

        /// A parameter may vary by this part of its present size, 0.02 for two percent.
        #[must_use]
        pub fn vary_by(mut self, name: &str, part: f64) -> Self {
            self.freedom.vary_by(name, part, &self.nominal);
            self
        }

        /// A parameter takes one of these values only, as lengths of a catalogue: instead of [`vary`](Self::vary).
        ///
        /// Each local optimum with the parameter anywhere between them is rounded by branch and bound: one such parameter after the
        /// other is set to the values below and above, and everything else is optimised anew.
        #[must_use]
        pub fn catalogue(mut self, name: &str, values: impl IntoIterator<Item = f64>) -> Self {
            self.freedom.catalogue(name, values.into_iter().collect());
            self
        }

        /// A relation, or several, between parameters must hold.
        #[must_use]
        pub fn hold(mut self, relations: impl Into<Vec<Relation>>) -> Self {
            self.freedom.hold(relations.into());
            self
        }
    };
}
pub(crate) use freedom_methods;

/// What may vary, looked up.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Varied {
    /// Indices of the parameters that vary, in ascending order.
    pub(crate) indices: Vec<usize>,
    /// The limits of the variables in this order.
    pub(crate) limits: Limits,
    /// Which of them, by their place in this order, take some values only, which ascend.
    pub(crate) catalogues: Vec<(usize, Vec<f64>)>,
    /// All mistakes; what they are about is left out above.
    pub(crate) errors: Vec<DesignError>,
}

impl Freedom {
    pub(crate) fn vary(&mut self, name: &str, low: f64, high: f64) {
        self.bounds.push((name.to_string(), low, high));
    }

    /// By a part of the size that it has in a mechanism.
    pub(crate) fn vary_by<M: Dimensions<N>, const N: usize>(
        &mut self,
        name: &str,
        part: f64,
        mechanism: &M,
    ) {
        let own = M::PARAMETERS
            .iter()
            .position(|parameter| parameter.name == name);
        let value = own.map_or(f64::NAN, |index| mechanism.values()[index]);
        let room = part * value.abs();
        self.vary(name, value - room, value + room);
    }

    pub(crate) fn catalogue(&mut self, name: &str, mut values: Vec<f64>) {
        values.sort_by(f64::total_cmp);
        values.dedup();
        let [low, high] = [values.first(), values.last()].map(|x| x.copied().unwrap_or(f64::NAN));
        self.catalogues.push((name.to_string(), values));
        self.vary(name, low, high);
    }

    pub(crate) fn hold(&mut self, relations: Vec<Relation>) {
        self.relations.extend(relations);
    }

    /// Looks up parameters with their bounds, and relations between them.
    pub(crate) fn varied(&self, parameters: &[Parameter], values: &[f64]) -> Varied {
        let mut errors = Vec::new();
        let known: Vec<&'static str> = parameters.iter().map(|parameter| parameter.name).collect();
        let mut places: Vec<(usize, f64, f64)> = Vec::new();
        for (name, low, high) in &self.bounds {
            match known.iter().position(|own| own == name) {
                None => errors.push(DesignError::NoParameter {
                    name: name.clone(),
                    known: known.clone(),
                }),
                Some(_) if !(low <= high && (high - low).is_finite()) => {
                    errors.push(DesignError::Bounds {
                        name: name.clone(),
                        low: *low,
                        high: *high,
                    });
                }
                Some(index) if places.iter().any(|place| place.0 == index) => {
                    errors.push(DesignError::Twice { name: name.clone() });
                }
                Some(index) => places.push((index, *low, *high)),
            }
        }
        places.sort_by_key(|place| place.0);
        let indices: Vec<usize> = places.iter().map(|place| place.0).collect();
        let of = |relation: &Relation| linear(relation, &known, &indices, values, &mut errors);
        let limits = Limits {
            relations: self.relations.iter().map(of).collect(),
            lower: places.iter().map(|place| place.1).collect(),
            upper: places.iter().map(|place| place.2).collect(),
        };
        if self.bounds.is_empty() {
            errors.push(DesignError::Nothing {
                what: "no parameter may vary; call `vary`",
                wish: "a design problem".to_string(),
            });
        }
        let catalogues = self.catalogues.iter().filter_map(|(name, values)| {
            let index = known.iter().position(|own| own == name)?;
            let place = indices.iter().position(|own| *own == index)?;
            Some((place, values.clone()))
        });
        Varied {
            limits,
            catalogues: catalogues.collect(),
            indices,
            errors,
        }
    }

    /// All relations in words.
    pub(crate) fn relations(&self) -> Vec<String> {
        self.relations.iter().map(Relation::described).collect()
    }

    /// Whether the relations leave anything within the bounds.
    pub(crate) fn consistent(&self, limits: &Limits) -> Result<(), DesignError> {
        let middle = limits.lower.iter().zip(&limits.upper);
        let middle: Vec<f64> = middle.map(|(low, high)| 0.5 * (low + high)).collect();
        match limits.nearest(&middle) {
            Some(_) => Ok(()),
            None => Err(DesignError::Contradiction {
                relations: self.relations(),
            }),
        }
    }
}

/// A relation of the variables; parameters that do not vary count as numbers.
fn linear(
    relation: &Relation,
    known: &[&'static str],
    varied: &[usize],
    values: &[f64],
    errors: &mut Vec<DesignError>,
) -> Linear {
    let mut linear = Linear {
        terms: Vec::new(),
        most: relation.most,
        equality: relation.equality,
    };
    for (name, factor) in &relation.terms {
        let Some(index) = known.iter().position(|own| own == name) else {
            errors.push(DesignError::NoParameter {
                name: name.clone(),
                known: known.to_vec(),
            });
            continue;
        };
        match varied.iter().position(|own| *own == index) {
            Some(place) => linear.terms.push((place, *factor)),
            None => linear.most -= factor * values[index],
        }
    }
    linear
}
