//! Columns of a generated function that are a quantity's numbers and their derivatives.

use std::string::{String, ToString};
use std::vec::Vec;

use super::DesignError;
use linkage_core::Meaning;
use linkage_runtime::{Column, Heading, Parameter};

/// One number of a quantity.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Number {
    /// Its column.
    pub(crate) value: usize,
    /// The column of its derivative by the input.
    pub(crate) rate: Option<usize>,
    /// Parameters, and the columns of the derivatives by them.
    pub(crate) sensitivities: Vec<(usize, usize)>,
    /// True if it counts modulo whole turns.
    pub(crate) angle: bool,
}

/// The numbers of some quantities.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Numbers(Vec<Number>);

impl Numbers {
    /// Returns the numbers of these quantities, with the derivatives that the function has.
    pub(crate) fn all(heading: &Heading, quantities: &[String]) -> Self {
        let columns = heading.columns;
        let places = quantities
            .iter()
            .flat_map(|name| (0..columns.len()).filter(|&k| belongs(&columns[k], name)));
        Self(places.map(|value| number(columns, value)).collect())
    }

    /// All other numbers of which there are derivatives by these parameters.
    pub(crate) fn beside(heading: &Heading, quantity: &str, parameters: &[usize]) -> Self {
        let columns = heading.columns;
        let others = (0..columns.len())
            .filter(|&k| !belongs(&columns[k], quantity) && columns[k].meaning == Meaning::Value);
        let known = |number: &Number| {
            let by = |parameter: &usize| {
                number
                    .sensitivities
                    .iter()
                    .any(|(known, _)| known == parameter)
            };
            parameters.iter().all(by)
        };
        Self(others.map(|k| number(columns, k)).filter(known).collect())
    }

    /// Returns the same numbers, or the missing columns.
    pub(crate) fn find(
        heading: &Heading,
        quantities: &[String],
        rates: bool,
        parameters: &[Parameter],
        varied: &[usize],
    ) -> Result<Self, Vec<DesignError>> {
        let mut errors = Vec::new();
        for name in quantities {
            if !heading.columns.iter().any(|column| belongs(column, name)) {
                errors.push(DesignError::NoQuantity {
                    function: heading.function,
                    quantity: name.clone(),
                });
                continue;
            }
            let numbers = Self::all(heading, core::slice::from_ref(name));
            if rates && numbers.iter().any(|number| number.rate.is_none()) {
                errors.push(DesignError::NoVelocity {
                    function: heading.function,
                    quantity: name.clone(),
                });
            }
            let lacks = |parameter: &&usize| {
                let has = |number: &Number| {
                    number
                        .sensitivities
                        .iter()
                        .any(|(known, _)| known == *parameter)
                };
                !numbers.iter().all(has)
            };
            let missing: Vec<String> = varied
                .iter()
                .filter(lacks)
                .map(|&k| parameters[k].name.to_string())
                .collect();
            if !missing.is_empty() {
                errors.push(DesignError::NoSensitivity {
                    function: heading.function,
                    quantity: name.clone(),
                    missing,
                });
            }
        }
        match errors.is_empty() {
            true => Ok(Self::all(heading, quantities)),
            false => Err(errors),
        }
    }

    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &Number> {
        self.0.iter()
    }
}

/// Returns true for a column that is a number of the field.
fn belongs(column: &Column, field: &str) -> bool {
    let Some(rest) = column.name.strip_prefix(field) else {
        return false;
    };
    (rest.is_empty() || rest.starts_with(['.', '[']))
        && !matches!(
            column.meaning,
            Meaning::Sensitivity { .. } | Meaning::Picture
        )
}

fn number(columns: &[Column], value: usize) -> Number {
    let (quantity, order) = match columns[value].meaning {
        Meaning::Rate { order, of } => (of, order),
        _ => (Some(value), 0),
    };
    let is_rate = |column: &Column| match column.meaning {
        Meaning::Rate { order: other, of } => of.is_some() && of == quantity && other == order + 1,
        _ => false,
    };
    let sensitivity = |(k, column): (usize, &Column)| match column.meaning {
        Meaning::Sensitivity { parameter, of } if of == Some(value) => Some((parameter, k)),
        _ => None,
    };
    Number {
        value,
        rate: columns.iter().position(is_rate),
        sensitivities: columns.iter().enumerate().filter_map(sensitivity).collect(),
        angle: columns[value].unit == "rad" && order == 0,
    }
}
