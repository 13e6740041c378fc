//! Scalar parameters of parameters.

use crate::model::symbols::values::Values;
use crate::model::types::{COMPONENTS, ScalarParameter, ScalarParameterId, Type};

pub(in crate::model) fn add_scalars(
    values: &mut Values,
    name: &str,
    parameter: usize,
    ty: &Type,
) -> ScalarParameterId {
    let first = ScalarParameterId(values.scalar_parameters.len());
    if let (Some(count), Some(dimension)) = (ty.components(), ty.dimension()) {
        for letter in COMPONENTS.iter().take(count) {
            let name = if count == 1 {
                name.to_owned()
            } else {
                format!("{name}.{letter}")
            };
            let scalar = ScalarParameter {
                name,
                parameter,
                dimension,
            };
            values.scalar_parameters.push(scalar);
        }
    }
    first
}
