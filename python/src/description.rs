//! Functions, arguments and dimensions of a mechanism as tuples of Python.

use linkage_compiler::ir::{COMPONENTS, Field, Meaning, Shape, plain};
use linkage_engine::Mechanism;

/// Name, unit, nominal value and tolerance of a dimension.
pub(crate) type ParameterOf = (&'static str, &'static str, f64, f64);

/// Name, unit, reference, declared range and the ends of the range that is used.
pub(crate) type InputOf = (
    &'static str,
    &'static str,
    f64,
    Option<(f64, f64)>,
    (f64, f64),
);

/// Name, unit and default of an argument.
pub(crate) type ArgumentOf = (String, String, Option<f64>);

/// Name, documentation, indices of its arguments, fields and columns of a function.
pub(crate) type FunctionOf = (String, String, Vec<usize>, Vec<FieldOf>, Vec<ColumnOf>);

/// Name, documentation, unit, quantity, lengths of the arrays around the entries, and their kind:
/// `scalar`, `vector2`, `vector3`, `plane_frame` or `frame`.
pub(crate) type FieldOf = (String, String, String, String, Vec<usize>, String);

/// Name, unit, kind, number and origin of a column: `rate` has its order, `sensitivity` the index
/// of its parameter, and both the index of the column that is differentiated.
pub(crate) type ColumnOf = (String, String, &'static str, usize, Option<usize>);

/// Describes all functions of a mechanism.
pub(crate) fn functions(mechanism: &Mechanism) -> Vec<FunctionOf> {
    let functions = mechanism.compiled().functions.iter();
    let functions = functions.map(|function| {
        let columns = function.columns.iter().map(|column| {
            let (kind, number, of) = match column.meaning {
                Meaning::Value => ("value", 0, None),
                Meaning::Rate { order, of } => ("rate", order as usize, of),
                Meaning::Sensitivity { parameter, of } => ("sensitivity", parameter, of),
                Meaning::Margin => ("margin", 0, None),
                Meaning::Picture => ("picture", 0, None),
            };
            (column.name.clone(), column.unit.clone(), kind, number, of)
        });
        (
            plain(&function.name).to_owned(),
            function.documentation.trim().to_owned(),
            function.arguments.clone(),
            function.fields.iter().map(field).collect(),
            columns.collect(),
        )
    });
    functions.collect()
}

fn field(field: &Field) -> FieldOf {
    let mut lengths = Vec::new();
    let mut shape = &field.shape;
    while let Shape::Array(count, entry) = shape {
        lengths.push(*count);
        shape = entry;
    }
    let kind = match shape {
        Shape::Scalar | Shape::Array(..) => "scalar".to_owned(),
        Shape::Vector(count) => format!("vector{}", (*count).min(COMPONENTS.len())),
        Shape::PlaneFrame => "plane_frame".to_owned(),
        Shape::Frame => "frame".to_owned(),
    };
    (
        plain(&field.name).to_owned(),
        field.documentation.trim().to_owned(),
        field.unit.clone(),
        field.about.clone(),
        lengths,
        kind,
    )
}
