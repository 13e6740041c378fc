//! Shapes and units of results.

use crate::model::{EvaluatorDef, LengthUnit, Mechanism, Quantity, Shape, Type};
use crate::unit::{Column, Field, Picture};

use super::about::about;

/// The fields of a function's result, whose numbers are these columns.
pub(super) fn fields(
    mechanism: &Mechanism,
    definition: &EvaluatorDef,
    picture: Option<&Picture>,
    columns: &[Column],
) -> Vec<Field> {
    let unit = mechanism.unit;
    let mut rest = columns;
    let mut own_columns = |shape: &Shape| {
        let (own, behind) = rest.split_at(shape.width());
        rest = behind;
        own
    };
    let field = |quantity: &Quantity| match picture.filter(|_| quantity.is_picture()) {
        Some(picture) => {
            let shape = Shape::Array(
                picture.vectors(),
                Box::new(Shape::Vector(picture.dimension)),
            );
            own_columns(&shape);
            Field {
                name: quantity.field.clone(),
                documentation: quantity.documentation.clone(),
                shape,
                // Told by the words, since it is not that of all.
                unit: String::new(),
                about: format!(
                    "points of `PICTURE` in {}, then its unit vectors",
                    unit.name()
                ),
            }
        }
        None => {
            let shape = Shape::of(&quantity.value.ty);
            let columns = own_columns(&shape);
            Field {
                name: quantity.field.clone(),
                documentation: quantity.documentation.clone(),
                shape,
                unit: match quantity.value.derived() {
                    Some(_) => units_of(columns),
                    None => unit_words(&quantity.value.ty, unit),
                },
                about: about(mechanism, definition, quantity),
            }
        }
    };
    definition.quantities.iter().map(field).collect()
}

/// The different units of numbers, in their order: `mm/mm and mm/rad`.
fn units_of(columns: &[Column]) -> String {
    let mut units: Vec<&str> = Vec::new();
    for column in columns {
        let unit = match column.unit.as_str() {
            "" => "1",
            unit => unit,
        };
        if !units.contains(&unit) {
            units.push(unit);
        }
    }
    match &units[..] {
        ["1"] => String::new(),
        [before @ .., last] if !before.is_empty() => format!("{} and {last}", before.join(", ")),
        units => units.concat(),
    }
}

/// `mm`, `mm^2`, `rad`, nothing for a number; entries of an array may differ.
fn unit_words(ty: &Type, length: LengthUnit) -> String {
    match ty {
        Type::Scalar(dimension) | Type::Vector(_, dimension) => dimension.unit(length),
        Type::Array(entries) => {
            let words: Vec<String> = entries.iter().map(|e| unit_words(e, length)).collect();
            match words.first() {
                Some(first) if words.iter().all(|w| w == first) => first.clone(),
                _ => "various units".to_owned(),
            }
        }
        Type::Frame => format!("{}, its axes of length 1", length.name()),
        Type::Zero(_) | Type::Error => String::new(),
    }
}
