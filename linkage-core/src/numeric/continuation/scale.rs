//! The map of inputs to places in a range and slots of an index: no branch, no call, no panic.

use super::cell::Frame;
use core::hint::select_unpredictable;

/// Bits behind the point of a slot number.
const FRACTION: u32 = 20;

/// Adding this number leaves a number with so many bits behind the point.
const POINT: f64 = 6_755_399_441_055_744.0 / (1_u64 << FRACTION) as f64;

/// Adding and subtracting this number rounds to an integer.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// A map of inputs to places in the range and slots of the index.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scale {
    pub(super) frame: Frame,
    pub(super) rate: f64,
    /// The rate in a table that repeats, else 0.
    pub(super) turns: f64,
    slots: f64,
    last: f64,
    count: usize,
}

impl Scale {
    pub(super) fn new(frame: Frame, slots: u32, closed: bool) -> Self {
        let rate = if frame.length > 0.0 {
            1.0 / frame.length
        } else {
            0.0
        };
        Self {
            frame,
            rate,
            turns: if closed { rate } else { 0.0 },
            slots: f64::from(slots),
            last: f64::from(slots - 1),
            count: slots as usize,
        }
    }

    /// The place of an input, and a slot, from 0 to the last one whatever the input is.
    #[inline(always)]
    pub(super) fn find(&self, x: f64) -> (f64, usize) {
        let from_middle = x - self.frame.middle;
        let turns = (from_middle * self.turns + ROUND) - ROUND;
        let position = from_middle * self.rate - turns;
        // A maximum and a minimum are instructions; a choice between integers may become a branch.
        // NaN becomes 0.
        let slot = position * self.slots + 0.5 * self.slots;
        let slot = select_unpredictable(slot > 0.0, slot, 0.0);
        let slot = select_unpredictable(slot < self.last, slot, self.last);
        let fixed = (slot + POINT).to_bits() - POINT.to_bits();
        (position, (fixed >> FRACTION) as usize)
    }

    /// Returns the number of slots.
    #[inline(always)]
    pub(super) fn slots(&self) -> usize {
        self.count
    }

    /// The slot of an input, and how far from its centre the input is, in slots: from -1/2 to 1/2
    /// inside the range.
    #[inline(always)]
    pub(super) fn cell(&self, x: f64) -> (usize, f64) {
        let (position, slot) = self.find(x);
        let centre = slot as f64 + 0.5 - 0.5 * self.slots;
        (slot, position * self.slots - centre)
    }

    /// The input at the centre of a slot.
    pub(super) fn centre(&self, slot: usize) -> f64 {
        self.frame.x((slot as f64 + 0.5) / self.slots - 0.5)
    }

    /// The distance between centres.
    pub(super) fn spacing(&self) -> f64 {
        self.frame.length / self.slots
    }

    /// Returns the number of borders of slots: as many as slots where the range repeats.
    pub(super) fn corners(&self) -> usize {
        if self.repeats() {
            self.slots()
        } else {
            self.slots() + 1
        }
    }

    /// The slot above or below, if there is one.
    pub(super) fn neighbour(&self, slot: usize, up: bool) -> Option<usize> {
        let slots = self.slots();
        if self.repeats() {
            Some((slot + if up { 1 } else { slots - 1 }) % slots)
        } else if up {
            Some(slot + 1).filter(|&next| next < slots)
        } else {
            slot.checked_sub(1)
        }
    }

    fn repeats(&self) -> bool {
        self.turns != 0.0
    }
}

/// Zero up to this distance, NaN beyond it and for NaN: arithmetic, since a choice may become a
/// branch.
#[inline(always)]
pub(super) fn guard(distance: f64, most: f64) -> f64 {
    // All bits set if the sign is.
    let beyond = (most - distance.abs()).to_bits().cast_signed() >> (u64::BITS - 1);
    f64::from_bits(beyond.cast_unsigned()) + 0.0 * distance
}
