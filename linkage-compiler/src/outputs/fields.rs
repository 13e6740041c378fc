//! Shapes and units of results.

use crate::ir::{Column, Field, Picture};
use crate::model::{
    Derived, EvaluatorDef, Expr, ExprKind, LengthUnit, MechanicalQuantity, Mechanism, Quantity,
    ScalarParameterId, Shape, Type, Variable,
};

use super::doc_text::about;

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
        let (numbers, behind) = rest.split_at(shape.width());
        rest = behind;
        numbers
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
                reaction: None,
                driven_acceleration: None,
            }
        }
        None => {
            let shape = Shape::from_type(&quantity.value.ty);
            let columns = own_columns(&shape);
            Field {
                name: quantity.field.clone(),
                documentation: quantity.documentation.clone(),
                shape,
                unit: match quantity.value.derived() {
                    Some(_) => units_of(columns),
                    // Types have no angle in the denominator: the unit of a quantity with such a
                    // derivative is not known from its type.
                    None if has_rate_of_angles(mechanism, definition, &quantity.value) => {
                        String::new()
                    }
                    None => unit_words(&quantity.value.ty, unit),
                },
                about: about(mechanism, definition, quantity),
                reaction: reaction(mechanism, &quantity.value),
                driven_acceleration: driven_acceleration(&quantity.value),
            }
        }
    };
    definition.quantities.iter().map(field).collect()
}

/// The name of the joint whose reaction a quantity is.
fn reaction(mechanism: &Mechanism, value: &Expr) -> Option<String> {
    match value.kind {
        ExprKind::Mechanics(MechanicalQuantity::Reaction(joint)) => {
            mechanism.joints[joint].name.clone()
        }
        _ => None,
    }
}

/// The input whose acceleration without drives a quantity is.
fn driven_acceleration(value: &Expr) -> Option<usize> {
    match value.kind {
        ExprKind::Mechanics(MechanicalQuantity::DrivenAcceleration(input)) => Some(input),
        _ => None,
    }
}

/// Returns true if a derivative by an angle, or one of an angle, is a part of it.
fn has_rate_of_angles(mechanism: &Mechanism, definition: &EvaluatorDef, value: &Expr) -> bool {
    let input_is = |input: usize| mechanism.inputs[input].dimension.angle;
    let parameter_is = |id: ScalarParameterId| mechanism.scalar_parameters[id.0].dimension.angle;
    value.parts().any(|part| {
        let (inner, by_angle) = match part.derived() {
            None => return false,
            Some(Derived::ByInputs(inner, _)) => {
                let inputs = definition.inputs.iter().copied();
                let mut drives = inputs.filter(|&input| input < mechanism.inputs.len());
                (inner, drives.any(input_is))
            }
            Some(Derived::ByParameters(inner, by)) => {
                (inner, by.iter().any(|&id| parameter_is(id)))
            }
            Some(Derived::By(inner, by)) => {
                let by_angle = by.iter().any(|&variable| match variable {
                    Variable::Input(input) => input_is(input),
                    Variable::Parameter(id) => parameter_is(id),
                });
                (inner, by_angle)
            }
        };
        by_angle
            || matches!(inner.ty, Type::Scalar(dimension) if dimension.angle)
            || inner.ty == Type::Frame
    })
}

/// The different units of numbers, in their order: `mm/mm and mm/rad`.
fn units_of(columns: &[Column]) -> String {
    let mut units: Vec<String> = Vec::new();
    for column in columns {
        let unit = match column.unit.as_str() {
            "" => "1".to_owned(),
            unit => ordered(unit),
        };
        if !units.contains(&unit) {
            units.push(unit);
        }
    }
    match &units[..] {
        [only] if only == "1" => String::new(),
        [before @ .., last] if !before.is_empty() => format!("{} and {last}", before.join(", ")),
        units => units.concat(),
    }
}

/// Factors below the line by the alphabet: `mm/(rad*mm)` and `mm/(mm*rad)` are the same unit.
fn ordered(unit: &str) -> String {
    let below = unit.split_once("/(");
    match below.and_then(|(above, below)| Some((above, below.strip_suffix(')')?))) {
        Some((above, below)) => {
            let mut factors: Vec<&str> = below.split('*').collect();
            factors.sort_unstable();
            format!("{above}/({})", factors.join("*"))
        }
        None => unit.to_owned(),
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
        Type::Frame | Type::PlaneFrame => format!("{}, its axes of length 1", length.name()),
        Type::Zero(_) | Type::Error => String::new(),
    }
}
