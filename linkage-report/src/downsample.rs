//! Fewer rows, where a page with all of them would be slow.

use std::collections::BTreeSet;
use std::vec::Vec;

use super::BandKind;
use super::builder::Report;
use super::{accuracy, rates};

/// A page has no more rows. The limit is ours: a screen is a few thousand pixels wide, and browsers
/// draw tens of thousands of corners of each curve at every change.
const MOST: usize = 20_000;

/// Returns the rows that a page has, `None` for all: the first and the last one, the rows of the
/// extremes of all columns, both sides of every edge of a gap, and others at even distances.
pub(super) fn page_rows(report: &Report) -> Option<Vec<usize>> {
    let count = report.positions.len();
    if count <= MOST {
        return None;
    }
    let mut rows = BTreeSet::from([0, count - 1]);
    let columns = report.tables.iter().flat_map(|table| &table.values);
    columns.for_each(|values| add_marks(&mut rows, values));
    for rate in rates::true_rates(report) {
        add_marks(&mut rows, &rate.values);
    }
    for sensitive in accuracy::sensitive(report) {
        for kind in [BandKind::WorstCase, BandKind::Statistical] {
            add_marks(&mut rows, &sensitive.half(kind));
        }
    }
    let others = MOST.saturating_sub(rows.len());
    rows.extend((0..others).map(|i| (i + 1) * (count - 1) / (others + 1)));
    Some(rows.into_iter().collect())
}

/// Adds the rows of the extremes, and of both sides of all edges of gaps.
fn add_marks(rows: &mut BTreeSet<usize>, values: &[f64]) {
    let finite = || values.iter().enumerate().filter(|(_, x)| x.is_finite());
    let ends = [
        finite().min_by(|a, b| a.1.total_cmp(b.1)),
        finite().max_by(|a, b| a.1.total_cmp(b.1)),
    ];
    rows.extend(ends.into_iter().flatten().map(|(row, _)| row));
    for (row, pair) in values.windows(2).enumerate() {
        if pair[0].is_finite() != pair[1].is_finite() {
            rows.extend([row, row + 1]);
        }
    }
}
