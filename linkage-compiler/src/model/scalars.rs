//! Scalar parameters of parameters.

use super::components::COMPONENTS;
use super::types::{ScalarParameter, ScalarParameterId, Type};
use super::values::Values;

pub(super) fn add_scalars(
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
