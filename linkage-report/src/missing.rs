//! Gaps of the range, and periodic reports.

use core::f64::consts::TAU;
use std::vec::Vec;

use super::builder::Report;
use linkage_core::Meaning;
use linkage_runtime::Column;

/// A cycle closes if its ends differ by less: in turns, and in units of the largest value.
/// Positions and quantities are known better than this and are never so near by chance.
const CLOSED: f64 = 1e-9;

/// Input values between which some number is not finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Gap {
    pub(super) from: f64,
    pub(super) to: f64,
}

/// Ranges of positions in which some column is not finite, both ends included.
pub(super) fn gaps(report: &Report) -> Vec<Gap> {
    let mut gaps: Vec<Gap> = Vec::new();
    let mut open = false;
    for (row, &at) in report.positions.iter().enumerate() {
        let columns = report.tables.iter().flat_map(|table| &table.values);
        let missing = columns.map(|values| values[row]).any(|x| !x.is_finite());
        match gaps.last_mut() {
            Some(gap) if missing && open => gap.to = at,
            _ if missing => gaps.push(Gap { from: at, to: at }),
            _ => {}
        }
        open = missing;
    }
    gaps
}

/// Returns true if the positions are whole turns after which all quantities are as before, angles
/// except for whole turns.
pub(super) fn is_periodic(report: &Report) -> bool {
    let (Some(first), Some(last)) = (report.positions.first(), report.positions.last()) else {
        return false;
    };
    let turns = (last - first) / TAU;
    let whole = turns.round() != 0.0 && (turns - turns.round()).abs() < CLOSED;
    let mut columns = report.tables.iter().flat_map(|table| table.columns());
    report.input.unit == "rad" && whole && columns.all(|(column, values)| closes(column, values))
}

fn closes(column: &Column, values: &[f64]) -> bool {
    if !matches!(column.meaning, Meaning::Value | Meaning::Picture) {
        return true;
    }
    let (Some(first), Some(last)) = (values.first(), values.last()) else {
        return true;
    };
    let step = match column.unit {
        "rad" => (last - first) - TAU * ((last - first) / TAU).round(),
        _ => last - first,
    };
    let size = values.iter().map(|x| x.abs()).filter(|x| x.is_finite());
    step.abs() <= CLOSED * size.fold(1.0, f64::max)
}
