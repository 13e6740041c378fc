//! Shapes and units of results.

use crate::model::{EvaluatorDef, LengthUnit, Mechanism, Quantity, Shape, Type};
use crate::unit::{Field, Picture};

/// The fields of a function's result.
pub(super) fn fields(
    mechanism: &Mechanism,
    definition: &EvaluatorDef,
    picture: Option<&Picture>,
) -> Vec<Field> {
    let unit = mechanism.unit;
    let field = |quantity: &Quantity| match picture.filter(|_| quantity.is_picture()) {
        Some(picture) => Field {
            name: quantity.field.clone(),
            documentation: quantity.documentation.clone(),
            shape: Shape::Array(
                picture.vectors(),
                Box::new(Shape::Vector(picture.dimension)),
            ),
            unit: format!(
                "points of `PICTURE` in {}, then its unit vectors",
                unit.name()
            ),
        },
        None => Field {
            name: quantity.field.clone(),
            documentation: quantity.documentation.clone(),
            shape: Shape::of(&quantity.value.ty),
            unit: unit_words(&quantity.value.ty, unit),
        },
    };
    definition.quantities.iter().map(field).collect()
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
