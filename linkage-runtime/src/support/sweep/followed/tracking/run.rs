//! All travellers, side by side in slots.

use super::groups::Groups;
use super::moving::Moving;
use super::slots::{SLOTS, Slots};
use super::tracker::{Tracker, Verdict};
use crate::columns::Columns;
use crate::support::CoupledGroup;
use alloc::vec::Vec;
use linkage_core::Scalar;

/// Takes all as far as they come: each row has the dimensions that are wanted, the inputs, and the
/// states at the dimensions of the mechanism. A row that arrives gets the states there, a blocked
/// one states that are not a number.
pub(crate) fn track_rows<M, const P: usize, const R: usize>(
    mechanism: &M,
    groups: &Groups,
    rows: &mut [[f64; R]],
) where
    M: Moving<P, R>,
{
    let columns = groups
        .spans
        .iter()
        .map(|span| Columns::new(span.size + 2, 0));
    let mut columns: Vec<Columns<f64>> = columns.collect();
    let mut slots = Slots::new(mechanism.dimensions());
    let mut waiting = 0..rows.len();
    let begin = |_| Tracker::new();
    let mut under_way: Vec<Tracker<R>> = waiting.by_ref().take(SLOTS).map(begin).collect();
    for (number, tracker) in under_way.iter_mut().enumerate() {
        slots.put(number, &rows[number]);
        tracker.begin(number, &rows[number], groups, &mut slots.lane(number));
    }
    loop {
        let mut slot = 0;
        while let Some(tracker) = under_way.get_mut(slot) {
            if tracker.leave(groups, rows) {
                match waiting.next() {
                    Some(number) => {
                        slots.put(slot, &rows[number]);
                        tracker.begin(number, &rows[number], groups, &mut slots.lane(slot));
                    }
                    None => {
                        under_way.swap_remove(slot);
                        slots.copy(under_way.len(), slot);
                    }
                }
            } else {
                slot += 1;
            }
        }
        if under_way.is_empty() {
            return;
        }
        slots.taken = under_way.len();
        for (at, (span, found)) in groups.spans.iter().zip(&mut columns).enumerate() {
            if under_way.iter().any(|tracker| tracker.wants(at)) {
                mechanism.correct(span.number, &slots, found);
                let group = &M::GROUPS[span.number];
                take(&mut under_way, &mut slots, groups, at, group, found);
            }
        }
    }
}

/// Passes the correction of a group, by its number among those that are followed, to all trackers
/// that wait for it.
fn take<const P: usize, const R: usize>(
    under_way: &mut [Tracker<R>],
    slots: &mut Slots<P, R>,
    groups: &Groups,
    at: usize,
    group: &CoupledGroup,
    found: &Columns<f64>,
) {
    let span = groups.spans[at];
    let outputs = found
        .column(span.size)
        .iter()
        .zip(found.column(span.size + 1));
    let mut verdicts = [None; SLOTS];
    let mut sound = [false; SLOTS];
    for (slot, (tracker, (&square, &determinant))) in under_way.iter_mut().zip(outputs).enumerate()
    {
        if tracker.wants(at) {
            let verdict = tracker.judge(span, Scalar::sqrt(square), determinant);
            verdicts[slot] = Some(verdict);
            sound[slot] = matches!(verdict, Verdict::Closer | Verdict::Settled);
        }
    }
    for (k, number) in span.state().enumerate() {
        slots.take(number, found.column(k), &sound);
    }
    for (slot, (tracker, verdict)) in under_way.iter_mut().zip(verdicts).enumerate() {
        if let Some(verdict) = verdict {
            tracker.go_on(verdict, groups, at, group, &mut slots.lane(slot));
        }
    }
}
