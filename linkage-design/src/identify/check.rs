//! Checks of the inputs of an identification.

use std::string::ToString;
use std::vec::Vec;

use super::rows;
use super::setup::Identification;
use crate::error::DesignError;
use crate::limits::Limits;
use linkage_runtime::Dimensions;

/// The places of the unknown parameters and their limits, or all that is wrong.
pub(super) fn check<M: Dimensions<N> + Copy, A, const N: usize>(
    identification: &Identification<'_, M, A, N>,
) -> Result<(Vec<usize>, Limits), DesignError> {
    let (places, mut errors) = identification.freedom.places(M::PARAMETERS, true);
    let unknown: Vec<usize> = places.iter().map(|parameter| parameter.0).collect();
    let index_of = |name: &str| {
        M::PARAMETERS
            .iter()
            .position(|parameter| parameter.name == name)
    };
    let missing = |name: &str| DesignError::NoParameter {
        name: name.to_string(),
        known: M::PARAMETERS
            .iter()
            .map(|parameter| parameter.name)
            .collect(),
    };
    let nothing = |what| DesignError::Nothing {
        what,
        objective: "identification".to_string(),
    };
    if places.is_empty() && errors.is_empty() {
        errors.push(nothing("no unknown parameters"));
    }
    if identification.sources.is_empty() {
        errors.push(nothing("nothing was measured"));
    }
    for source in identification.sources.iter().chain(&identification.offers) {
        errors.extend(source.check(M::PARAMETERS, &unknown));
    }
    for direct in &identification.direct {
        match index_of(&direct.name) {
            None => errors.push(missing(&direct.name)),
            Some(index) if !unknown.contains(&index) => errors.push(nothing(
                "a parameter was measured itself that is not unknown; name it with `unknown`",
            )),
            Some(_) => {}
        }
        let is_valid = direct.deviation > 0.0 && direct.deviation.is_finite();
        if !is_valid {
            errors.push(DesignError::Deviation {
                quantity: direct.name.clone(),
                deviation: direct.deviation,
            });
        }
    }
    // Either none is known or all are: a scatter is no measure of both.
    if !rows::estimates_deviations(identification) {
        let without = identification
            .sources
            .iter()
            .filter(|source| !source.has_deviations());
        let quantities: Vec<_> = without
            .map(|source| source.quantity().to_string())
            .collect();
        if !quantities.is_empty() {
            errors.push(DesignError::SomeDeviations { quantities });
        }
    }
    let limits = Limits {
        lower: places.iter().map(|parameter| parameter.1).collect(),
        upper: places.iter().map(|parameter| parameter.2).collect(),
        relations: Vec::new(),
    };
    DesignError::all(errors).map(|()| (unknown, limits))
}

/// The mechanism that the fit begins with must assemble where there are readings.
pub(super) fn must_assemble<M: Dimensions<N> + Copy, A, const N: usize>(
    identification: &Identification<'_, M, A, N>,
    start: &[f64],
    unknown: &[usize],
) -> Result<(), DesignError> {
    let rows = rows::rows(identification, start, unknown);
    if rows.is_empty() {
        return Err(DesignError::Nothing {
            what: "all readings are missing",
            objective: "identification".to_string(),
        });
    }
    let open = rows
        .iter()
        .filter(|row| row.difference.is_nan() || row.slopes.iter().any(|slope| !slope.is_finite()));
    let inputs: Vec<f64> = open.map(|row| row.input).collect();
    match inputs.first() {
        None => Ok(()),
        Some(&input) => Err(DesignError::StartOpen {
            input,
            open: inputs.len(),
            count: rows.len(),
        }),
    }
}
