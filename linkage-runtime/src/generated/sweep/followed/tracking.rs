//! Many mechanisms on their straight ways to dimensions of their own, side by side: each takes its own steps, and whoever has arrived makes
//! room for the next.

pub(super) mod groups;
mod path_samples;
mod slots;
mod tracker;

use super::super::Arguments;
use crate::generated::CoupledGroup;
use crate::{Columns, Scalar};
use alloc::vec::Vec;
use groups::Groups;
use slots::{SLOTS, Slots};
use tracker::{Tracker, Verdict};

/// A mechanism whose inputs stay while its `P` dimensions change, on plain numbers. A row of `R` numbers is the dimensions, all inputs,
/// then for each coupled group its state and floor.
pub trait Moving<const P: usize, const R: usize> {
    /// The coupled groups in order.
    const GROUPS: &'static [CoupledGroup];

    /// The dimensions of the tables.
    fn dimensions(&self) -> [f64; P];

    /// One Newton step of a group for every row: the numbers of its state, the square of the step, the determinant before it.
    fn correct(&self, group: usize, rows: &impl Arguments<f64, R>, columns: &mut Columns<f64>);
}

/// Rows as they are.
pub(super) struct Rows<'a, T, const I: usize>(pub(super) &'a [[T; I]]);

impl<T: Scalar, const I: usize> Arguments<T, I> for Rows<'_, T, I> {
    fn check(&self) -> usize {
        self.0.len()
    }

    #[inline(always)]
    fn block<const FUSED: bool, const V: usize, const B: usize>(
        &self,
        start: usize,
        rows: usize,
        block: &mut [[T; B]; I],
    ) {
        for lane in 0..rows.min(B) {
            let row = &self.0[(start + lane).min(self.0.len() - 1)];
            for (column, value) in block.iter_mut().zip(row) {
                column[lane] = *value;
            }
        }
    }
}

/// Takes all as far as they come: each row has the dimensions that are wanted, the inputs, and the states at the dimensions of the mechanism.
/// Who arrives gets the states there, who is blocked states that are not a number.
pub(super) fn track<M, const P: usize, const R: usize>(
    mechanism: &M,
    groups: &Groups,
    rows: &mut [[f64; R]],
) where
    M: Moving<P, R>,
{
    let columns = groups
        .places
        .iter()
        .map(|place| Columns::new(place.size + 2, 0));
    let mut columns: Vec<Columns<f64>> = columns.collect();
    let mut slots = Slots::new(mechanism.dimensions());
    let mut waiting = 0..rows.len();
    let begin = |_| Tracker::new();
    let mut trackers: Vec<Tracker<R>> = waiting.by_ref().take(SLOTS).map(begin).collect();
    for (number, own) in trackers.iter_mut().enumerate() {
        slots.put(number, &rows[number]);
        own.begin(number, &rows[number], groups, &mut slots.lane(number));
    }
    loop {
        let mut slot = 0;
        while let Some(own) = trackers.get_mut(slot) {
            if own.leave(groups, rows) {
                match waiting.next() {
                    Some(number) => {
                        slots.put(slot, &rows[number]);
                        own.begin(number, &rows[number], groups, &mut slots.lane(slot));
                    }
                    None => {
                        trackers.swap_remove(slot);
                        slots.copy(trackers.len(), slot);
                    }
                }
            } else {
                slot += 1;
            }
        }
        if trackers.is_empty() {
            return;
        }
        slots.taken = trackers.len();
        for (at, (place, found)) in groups.places.iter().zip(&mut columns).enumerate() {
            if trackers.iter().any(|own| own.wants(at)) {
                mechanism.correct(place.number, &slots, found);
                let group = &M::GROUPS[place.number];
                take(&mut trackers, &mut slots, groups, at, group, found);
            }
        }
    }
}

/// What has been found for a group, by its place among those that are followed, goes to all that want it.
fn take<const P: usize, const R: usize>(
    trackers: &mut [Tracker<R>],
    slots: &mut Slots<P, R>,
    groups: &Groups,
    at: usize,
    group: &CoupledGroup,
    found: &Columns<f64>,
) {
    let place = groups.places[at];
    let outputs = found
        .column(place.size)
        .iter()
        .zip(found.column(place.size + 1));
    let mut verdicts = [None; SLOTS];
    let mut sound = [false; SLOTS];
    for (slot, (own, (&square, &determinant))) in trackers.iter_mut().zip(outputs).enumerate() {
        if own.wants(at) {
            let verdict = own.judge(place, Scalar::sqrt(square), determinant);
            verdicts[slot] = Some(verdict);
            sound[slot] = matches!(verdict, Verdict::Closer | Verdict::Settled);
        }
    }
    for (k, number) in place.state().enumerate() {
        slots.take(number, found.column(k), &sound);
    }
    for (slot, (own, verdict)) in trackers.iter_mut().zip(verdicts).enumerate() {
        if let Some(verdict) = verdict {
            own.go_on(verdict, groups, at, group, &mut slots.lane(slot));
        }
    }
}
