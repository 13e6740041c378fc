//! Scales of errors: of parameters, and of quantities that were not read.

use std::vec::Vec;

use super::reading::ReadingRow;
use super::setup::Identification;
use crate::limits::Limits;
use linkage_runtime::Dimensions;

/// Returns the rows of the other quantities of the functions in use, as if they were read as
/// exactly: numbers of the same unit, and lengths and angles by the largest length. Quantities of
/// other units are left out.
pub(super) fn unread_rows<M: Dimensions<N> + Copy, A, const N: usize>(
    identification: &Identification<'_, M, A, N>,
    mechanism: &M,
    unknown: &[usize],
    rows: &[ReadingRow],
) -> Vec<ReadingRow> {
    let deviation = |is: &dyn Fn(&str) -> bool| {
        let deviations = rows
            .iter()
            .filter(|row| is(row.unit))
            .map(|row| row.deviation);
        deviations.min_by(f64::total_cmp)
    };
    let largest = largest_length(identification);
    let exactness = |unit: &str| {
        let known = deviation(&|other| other == unit);
        known.or_else(|| match unit {
            "rad" => Some(deviation(&is_length)? / largest),
            unit if is_length(unit) => Some(deviation(&|other| other == "rad")? * largest),
            _ => None,
        })
    };
    let sources = identification.sources.iter().chain(&identification.offers);
    let all =
        sources.flat_map(|source| source.beside(&identification.assembly, mechanism, unknown));
    let read = |row: &ReadingRow| rows.iter().any(|other| other.number == row.number);
    let others = all.filter(|row| !read(row)).filter_map(|row| {
        let deviation = exactness(row.unit).filter(|exactness| exactness.is_normal())?;
        Some(ReadingRow { deviation, ..row })
    });
    others.collect()
}

/// The largest of all lengths that the fit begins with; 0 if there are none.
fn largest_length<M: Dimensions<N> + Copy, A, const N: usize>(
    identification: &Identification<'_, M, A, N>,
) -> f64 {
    let all = M::PARAMETERS.iter().zip(identification.start.values());
    let lengths = all.filter(|(parameter, _)| is_length(parameter.unit));
    lengths.fold(0.0, |most, (_, value)| most.max(value.abs()))
}

/// Returns the possible error of each parameter: the distance of its bounds, or its own size. It is
/// the largest length where a length is 0 or nearly, one radian for an angle, and 1 for a number
/// that is 0.
pub(super) fn ranges<M: Dimensions<N> + Copy, A, const N: usize>(
    identification: &Identification<'_, M, A, N>,
    limits: &Limits,
    start: &[f64],
    unknown: &[usize],
) -> Vec<f64> {
    let unit = |j: usize| M::PARAMETERS[unknown[j]].unit;
    let largest = largest_length(identification);
    let range = |j: usize| {
        let width = limits.upper[j] - limits.lower[j];
        let size = start[j].abs();
        match unit(j) {
            _ if width > 0.0 && width.is_finite() => width,
            "rad" => 1.0,
            // Less than a hundredth of the largest length is a coordinate that happens to be small.
            unit if is_length(unit) && largest > 0.0 => size.max(0.01 * largest),
            _ if size > 0.0 => size,
            _ => 1.0,
        }
    };
    (0..start.len()).map(range).collect()
}

/// Returns true for a unit of lengths; parameters without it are angles and numbers.
fn is_length(unit: &str) -> bool {
    !unit.is_empty() && unit != "rad" && !unit.contains(['/', '*', '^'])
}
