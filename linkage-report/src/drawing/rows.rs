//! Rows of a report that a drawing shows.

use std::string::ToString;
use std::vec::Vec;

use super::options::Drawing;
use super::scatter::Scatter;
use crate::{accuracy, missing};
use linkage_formats::{Mistake, ReportError};

/// The row of the position that is shown, if nothing was asked for that is not there.
pub(super) fn possible_row(drawing: &Drawing<'_>) -> Result<usize, ReportError> {
    let mut mistakes = drawing.mistakes.clone();
    mistakes.extend(without_tolerances(drawing));
    match shown_row(drawing) {
        Ok(row) if mistakes.is_empty() => return Ok(row),
        Ok(_) => {}
        Err(mistake) => mistakes.push(mistake),
    }
    Err(ReportError::Mistakes(mistakes))
}

/// The row of the position that is shown.
pub(super) fn shown_row(drawing: &Drawing<'_>) -> Result<usize, Mistake> {
    let input = &drawing.report.input;
    let wanted = drawing.position.unwrap_or(input.reference);
    let positions = drawing.report.positions.iter().enumerate();
    let mut rows: Vec<(usize, f64)> = positions
        .map(|(row, x)| (row, (x - wanted).abs()))
        .collect();
    rows.sort_by(|a, b| a.1.total_cmp(&b.1));
    let candidates = if drawing.position.is_some() {
        1
    } else {
        rows.len()
    };
    let mut rows = rows.into_iter().take(candidates).map(|(row, _)| row);
    rows.find(|row| drawing.shown.is_assembled(*row))
        .ok_or_else(|| Mistake::NotAssembled {
            input: input.name.to_string(),
            unit: input.unit,
            at: drawing.position,
        })
}

/// Returns this many rows, at all ends of equal parts of the range. The last one repeats the first
/// where the range closes.
pub(super) fn even_rows(drawing: &Drawing<'_>, count: usize) -> Vec<usize> {
    let last = drawing.report.positions.len() - 1;
    let parts = match missing::is_periodic(drawing.report) {
        true => count.max(1),
        false => count.saturating_sub(1).max(1),
    };
    let row = |i: usize| (last * i + parts / 2) / parts;
    (0..count).map(row).collect()
}

/// Traced points without sensitivities, if ellipses are asked for and none has them.
pub(super) fn without_tolerances(drawing: &Drawing<'_>) -> Option<Mistake> {
    drawing.enlarged?;
    let sensitive = accuracy::sensitive(drawing.report);
    let names = drawing.traces.iter();
    let names: Vec<&str> = names
        .map(|&k| drawing.shown.picture.points[k].name)
        .collect();
    let mut points = drawing.traces.iter().zip(&names);
    let any = points.any(|(&point, name)| Scatter::new(point, name, &sensitive).is_some());
    (!any).then(|| Mistake::Unknown {
        kind: "traced point with sensitivities and tolerances",
        name: names.join(", "),
        known: sensitive
            .iter()
            .map(|sensitive| sensitive.name.to_string())
            .collect(),
    })
}
