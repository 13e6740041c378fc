//! Parameters that vary, within bounds and relations: names are looked up, and mistakes are
//! reported together.

use std::string::{String, ToString};
use std::vec::Vec;

use super::limits::{Limits, Linear};
use super::{DesignError, Relation, contradiction};
use linkage_runtime::{DimensionSet, Parameter};

/// The parameters that vary, by name.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Freedom {
    /// Parameters with their bounds.
    bounds: Vec<(String, f64, f64)>,
    /// Parameters that take some values only, which ascend.
    catalogues: Vec<(String, Vec<f64>)>,
    relations: Vec<Relation>,
}

/// The methods with which a design problem sets the parameters that vary, for its fields `nominal`,
/// `freedom` and `objectives`.
macro_rules! freedom_methods {
    () => {
        /// A parameter may vary between these bounds, both included: named as in `PARAMETERS`,
        /// `pivot.x` for a component.
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

        /// A parameter takes one of these values only, as lengths of a catalogue: instead of
        /// [`vary`](Self::vary).
        ///
        /// Each local optimum with the parameter anywhere between them is rounded by branch and
        /// bound: it may be at most the value below, or at least that above, and everything is
        /// optimised again, until all such parameters are at values.
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

        /// A number that follows from the dimensions must not be negative: `function` gives it with
        /// its derivatives by all parameters, in their order and units.
        #[must_use]
        pub fn hold_that(
            mut self,
            title: &str,
            function: impl Fn(&M) -> (f64, [f64; N]) + Send + Sync + 'a,
        ) -> Self {
            self.objectives
                .push(Box::new(Condition::new(title, function)));
            self
        }
    };
}
pub(crate) use freedom_methods;

/// The parameters that vary, by index.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Varied {
    /// Indices of the parameters that vary, in ascending order.
    pub(crate) indices: Vec<usize>,
    /// The limits of the variables in this order.
    pub(crate) limits: Limits,
    /// The parameters that take some values only, by their place in this order. The values ascend.
    pub(crate) catalogues: Vec<(usize, Vec<f64>)>,
    /// All mistakes. Without any the above means something.
    pub(crate) errors: Vec<DesignError>,
}

impl Freedom {
    pub(crate) fn vary(&mut self, name: &str, low: f64, high: f64) {
        self.bounds.push((name.to_string(), low, high));
    }

    /// Lets a parameter vary by a part of its size in a mechanism.
    pub(crate) fn vary_by<M: DimensionSet<N>, const N: usize>(
        &mut self,
        name: &str,
        part: f64,
        mechanism: &M,
    ) {
        let mut parameters = mechanism.declared().iter();
        let index = parameters.position(|parameter| parameter.name == name);
        let value = index.map_or(f64::NAN, |index| mechanism.numbers()[index]);
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

    /// Looks up parameters with their bounds, in the order in which they are named, and returns the
    /// mistakes. Bounds may be `infinite`, or must not.
    pub(crate) fn places(
        &self,
        parameters: &[Parameter],
        infinite: bool,
    ) -> (Vec<(usize, f64, f64)>, Vec<DesignError>) {
        let known = names(parameters);
        let (mut places, mut errors): (Vec<(usize, f64, f64)>, _) = (Vec::new(), Vec::new());
        for (name, low, high) in &self.bounds {
            let (name, low, high) = (name.clone(), *low, *high);
            let Some(index) = known.iter().position(|known| *known == name) else {
                let known = known.clone();
                errors.push(DesignError::NoParameter { name, known });
                continue;
            };
            if places.iter().any(|parameter| parameter.0 == index) {
                errors.push(DesignError::Twice { name });
                continue;
            }
            places.push((index, low, high));
            if !(low <= high && (infinite || (high - low).is_finite())) {
                errors.push(DesignError::Bounds { name, low, high });
            }
        }
        (places, errors)
    }

    /// Looks up parameters with their bounds, and relations between them.
    pub(crate) fn varied(&self, parameters: &[Parameter], values: &[f64]) -> Varied {
        let known = names(parameters);
        let (mut places, mut errors) = self.places(parameters, false);
        places.sort_by_key(|parameter| parameter.0);
        let indices: Vec<usize> = places.iter().map(|parameter| parameter.0).collect();
        let of = |relation: &Relation| linear(relation, &known, &indices, values, &mut errors);
        let limits = Limits {
            relations: self.relations.iter().map(of).collect(),
            lower: places.iter().map(|parameter| parameter.1).collect(),
            upper: places.iter().map(|parameter| parameter.2).collect(),
        };
        if self.bounds.is_empty() {
            errors.push(DesignError::Nothing {
                what: "no parameter may vary; call `vary`",
                objective: "a design problem".to_string(),
            });
        }
        let catalogues = self.catalogues.iter().filter_map(|(name, values)| {
            let index = known.iter().position(|known| known == name)?;
            let position = indices.iter().position(|known| *known == index)?;
            Some((position, values.clone()))
        });
        Varied {
            limits,
            catalogues: catalogues.collect(),
            indices,
            errors,
        }
    }

    /// All relations as text.
    pub(crate) fn relations(&self) -> Vec<String> {
        self.relations.iter().map(Relation::described).collect()
    }

    /// The relations that are no equalities and hold with nothing to spare, as text.
    pub(crate) fn active(&self, limits: &Limits, x: &[f64]) -> Vec<String> {
        let pairs = self.relations.iter().zip(&limits.relations);
        let active = pairs.filter(|(_, linear)| linear.is_active(x));
        active.map(|(relation, _)| relation.described()).collect()
    }

    /// Returns true if the relations leave anything within the bounds of these variables.
    pub(crate) fn consistent(
        &self,
        limits: &Limits,
        names: &[&'static str],
    ) -> Result<(), DesignError> {
        contradiction::consistent(&self.relations, limits, names)
    }
}

fn names(parameters: &[Parameter]) -> Vec<&'static str> {
    parameters.iter().map(|parameter| parameter.name).collect()
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
        let Some(index) = known.iter().position(|known| known == name) else {
            errors.push(DesignError::NoParameter {
                name: name.clone(),
                known: known.to_vec(),
            });
            continue;
        };
        match varied.iter().position(|varied| *varied == index) {
            Some(position) => linear.terms.push((position, *factor)),
            None => linear.most -= factor * values[index],
        }
    }
    linear
}
