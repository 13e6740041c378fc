//! The constants of generated code, each by one short call.

use linkage_core::Meaning;

use super::evaluation::FunctionNames;
use crate::data::{Operations, Parameter};
use crate::structure::FunctionInfo;
use crate::table::Column;

/// A scalar parameter.
#[must_use]
pub const fn parameter(
    name: &'static str,
    unit: &'static str,
    nominal: f64,
    tolerance: f64,
) -> Parameter {
    Parameter {
        name,
        unit,
        nominal,
        tolerance,
    }
}

/// Operation counts: additions, multiplications, divisions, roots, pairs of sine and cosine,
/// arctangents, others.
#[must_use]
pub const fn operations(counts: [u32; 7]) -> Operations {
    let [add, mul, div, sqrt, sin_cos, atan2, other] = counts;
    Operations {
        add,
        mul,
        div,
        sqrt,
        sin_cos,
        atan2,
        other,
    }
}

/// A function with its operation counts, in the order of [`operations`].
#[must_use]
pub const fn function(name: &'static str, counts: [u32; 7]) -> FunctionInfo {
    FunctionInfo {
        name,
        operations: operations(counts),
    }
}

/// The names of a function and of its arguments.
#[must_use]
pub const fn function_names<const I: usize>(
    function: &'static str,
    arguments: [&'static str; I],
) -> FunctionNames<I> {
    FunctionNames {
        function,
        arguments,
    }
}

/// A column of a quantity.
#[must_use]
pub const fn value(name: &'static str, unit: &'static str) -> Column {
    Column {
        name,
        unit,
        meaning: Meaning::Value,
    }
}

/// A column of a margin.
#[must_use]
pub const fn margin(name: &'static str, unit: &'static str) -> Column {
    Column {
        name,
        unit,
        meaning: Meaning::Margin,
    }
}

/// A column of a picture.
#[must_use]
pub const fn drawn(name: &'static str, unit: &'static str) -> Column {
    Column {
        name,
        unit,
        meaning: Meaning::Picture,
    }
}

/// A column of a derivative by the only input.
#[must_use]
pub const fn rate(name: &'static str, unit: &'static str, order: u32) -> Column {
    Column {
        name,
        unit,
        meaning: Meaning::Rate { order, of: None },
    }
}

/// A column of a derivative by a parameter.
#[must_use]
pub const fn sensitivity(name: &'static str, unit: &'static str, parameter: usize) -> Column {
    Column {
        name,
        unit,
        meaning: Meaning::Sensitivity {
            parameter,
            of: None,
        },
    }
}

/// The column of a derivative, of the quantity in column `of`.
#[must_use]
pub const fn derivative_of(of: usize, mut column: Column) -> Column {
    column.meaning = match column.meaning {
        Meaning::Rate { order, .. } => Meaning::Rate {
            order,
            of: Some(of),
        },
        Meaning::Sensitivity { parameter, .. } => Meaning::Sensitivity {
            parameter,
            of: Some(of),
        },
        other => other,
    };
    column
}
