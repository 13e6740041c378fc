//! Rows of readings at a place.

use std::vec::Vec;

use super::reading::{ReadingRow, Sources};
use super::setup::Identification;
use linkage_runtime::Dimensions;

pub(super) fn mechanism<M: Dimensions<N> + Copy, A, const N: usize>(
    identification: &Identification<'_, M, A, N>,
    x: &[f64],
    unknown: &[usize],
) -> M {
    let mut values = identification.start.values();
    for (&index, &x) in unknown.iter().zip(x) {
        values[index] = x;
    }
    M::from_values(&values)
}

pub(super) fn rows<M: Dimensions<N> + Copy, A, const N: usize>(
    identification: &Identification<'_, M, A, N>,
    x: &[f64],
    unknown: &[usize],
) -> Vec<ReadingRow> {
    let mechanism = mechanism(identification, x, unknown);
    let mut rows = rows_of(identification, &identification.sources, &mechanism, unknown);
    let parameters = M::PARAMETERS;
    for direct in &identification.direct {
        let index = unknown
            .iter()
            .position(|&index| parameters[index].name == direct.name);
        let Some(index) = index else { continue };
        let mut slopes = std::vec![0.0; unknown.len()];
        slopes[index] = 1.0;
        rows.push(ReadingRow {
            number: parameters[unknown[index]].name,
            unit: parameters[unknown[index]].unit,
            input_name: "",
            input: f64::NAN,
            reading: direct.value,
            difference: x[index] - direct.value,
            deviation: direct.deviation,
            slopes,
        });
    }
    rows
}

pub(super) fn rows_of<M: Dimensions<N> + Copy, A, const N: usize>(
    identification: &Identification<'_, M, A, N>,
    sources: &Sources<'_, M, A>,
    mechanism: &M,
    unknown: &[usize],
) -> Vec<ReadingRow> {
    let rows = sources
        .iter()
        .map(|source| source.rows(&identification.assembly, mechanism, unknown));
    rows.flatten().collect()
}

/// Without any standard deviations they are found from the scatter of the readings.
pub(super) fn estimates_deviations<M: Dimensions<N> + Copy, A, const N: usize>(
    identification: &Identification<'_, M, A, N>,
) -> bool {
    !identification
        .sources
        .iter()
        .any(|source| source.has_deviations())
        && identification.direct.is_empty()
}
