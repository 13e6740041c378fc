//! Many mechanisms on their straight ways to dimensions of their own, side by side: each takes its own steps, and all that want a
//! correction of a group get it together.

use super::super::Arguments;
use crate::generated::CoupledGroup;
use crate::generated::settle::{CONTRACTION, CORRECTIONS, FIRST, scaled, scales};
use crate::{Columns, Scalar};
use alloc::vec::Vec;

/// The first step, as a share of the way: the kernel has tried the whole.
const LENGTH: f64 = 0.25;

/// Where shorter steps were needed, the way is blocked, or next to it.
const SHORTEST: f64 = 1e-4;

/// The length of a step is chosen so that the first correction will be about this part of the largest one.
const WANTED: f64 = 0.5 * FIRST;

/// How much shorter or longer the next step may be.
const SHORTER: f64 = 1.0 / 8.0;
const LONGER: f64 = 4.0;

/// States are extrapolated by no more, in radians or scaled lengths: far less than the distance of another assembly.
const AHEAD: f64 = 0.25;

/// After a correction of this size the next one would be rounding, or nearly so: the kernel corrects what is left.
const SETTLED: f64 = 1e-5;

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

/// A coupled group that is followed.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub(super) number: usize,
    /// Of its state in a row; the floor stands behind that.
    pub(super) first: usize,
    pub(super) size: usize,
}

impl Place {
    fn floor(self) -> usize {
        self.first + self.size
    }
}

#[derive(Clone, Copy, PartialEq)]
enum Stage {
    /// The group that is corrected, by its place among those that are followed.
    Group(usize),
    Arrived,
    Blocked,
}

/// One mechanism on its way.
pub(super) struct Traveller<const P: usize, const R: usize> {
    from: [f64; P],
    to: [f64; P],
    /// The last place that was reached, how states change there for a share of the way, and the place that is tried.
    here: [f64; R],
    rates: [f64; R],
    next: [f64; R],
    share: f64,
    length: f64,
    stage: Stage,
    /// Which scale of lengths is tried.
    scale: usize,
    /// The largest correction now, how many there were, and the largest first one of the step.
    allowed: f64,
    corrections: usize,
    first: f64,
}

impl<const P: usize, const R: usize> Traveller<P, R> {
    /// At the dimensions `from`, whose states `row` has behind the dimensions that are wanted.
    pub(super) fn new(from: [f64; P], row: [f64; R], places: &[Place]) -> Self {
        let to = core::array::from_fn(|k| row[k]);
        let states = places
            .iter()
            .flat_map(|place| &row[place.first..=place.floor()]);
        let mut numbers = states.chain(&to);
        let mut traveller = Self {
            from,
            to,
            here: row,
            rates: [0.0; R],
            next: row,
            share: 0.0,
            length: 0.0,
            stage: Stage::Blocked,
            scale: 0,
            allowed: FIRST,
            corrections: 0,
            first: 0.0,
        };
        if numbers.all(|number| number.is_finite()) {
            traveller.set_out(LENGTH, places);
        }
        traveller
    }

    /// What it has when it has arrived.
    pub(super) fn arrived(&self) -> Option<&[f64; R]> {
        (self.stage == Stage::Arrived).then_some(&self.here)
    }

    /// Begins a step of about this length, or gives up.
    fn set_out(&mut self, length: f64, places: &[Place]) {
        if length < SHORTEST {
            self.stage = Stage::Blocked;
            return;
        }
        let states = places.iter().flat_map(|place| place.first..place.floor());
        let fastest = states
            .clone()
            .fold(0.0_f64, |most, k| most.max(self.rates[k].abs()));
        let length = length.min(AHEAD / fastest);
        self.length = length.min(1.0 - self.share);
        let share = self.share + self.length;
        self.next = self.here;
        for (k, dimension) in self.next[..P].iter_mut().enumerate() {
            let (from, to) = (self.from[k], self.to[k]);
            *dimension = match share < 1.0 {
                true => from + share * (to - from),
                false => to,
            };
        }
        for k in states {
            self.next[k] += self.length * self.rates[k];
        }
        self.first = 0.0;
        self.begin(0);
    }

    fn begin(&mut self, group: usize) {
        self.stage = Stage::Group(group);
        self.scale = 0;
        (self.allowed, self.corrections) = (FIRST, 0);
    }

    /// Takes a correction of the group `places[at]`: its outputs.
    fn take(
        &mut self,
        places: &[Place],
        at: usize,
        group: &CoupledGroup,
        output: impl Fn(usize) -> f64,
    ) {
        let place = places[at];
        let (size, determinant) = (Scalar::sqrt(output(place.size)), output(place.size + 1));
        let sound = size <= self.allowed
            && determinant * self.here[place.floor()] > 0.0
            && self.corrections < CORRECTIONS;
        if self.corrections == 0 {
            self.first = self.first.max(size);
        }
        if !sound {
            return self.refuse(places, at, group);
        }
        for (k, number) in self.next[place.first..place.floor()].iter_mut().enumerate() {
            *number = output(k);
        }
        if size > SETTLED {
            self.corrections += 1;
            self.allowed = CONTRACTION * size;
            return;
        }
        self.next[place.floor()] = 0.5 * determinant;
        match at + 1 < places.len() {
            true => self.begin(at + 1),
            false => self.arrive(places),
        }
    }

    /// Goes on from where a step has led.
    fn arrive(&mut self, places: &[Place]) {
        for k in places.iter().flat_map(|place| place.first..place.floor()) {
            self.rates[k] = (self.next[k] - self.here[k]) / self.length;
        }
        self.share += self.length;
        self.here = self.next;
        let longer = Scalar::sqrt(WANTED / self.first).clamp(SHORTER, LONGER);
        match self.share < 1.0 {
            true => self.set_out(longer * self.length, places),
            false => self.stage = Stage::Arrived,
        }
    }

    /// Tries another scale of lengths, or a shorter step.
    fn refuse(&mut self, places: &[Place], at: usize, group: &CoupledGroup) {
        let scale = self.scale + 1;
        if let Some(&factor) = scales(group.variables).get(scale) {
            self.begin(at);
            self.scale = scale;
            let state = places[at].first..places[at].floor();
            let other = scaled(group.variables, &self.here[state.clone()], factor);
            self.next[state].copy_from_slice(&other);
            return;
        }
        let shorter = Scalar::sqrt(WANTED / self.first);
        let shorter = if shorter > SHORTER {
            shorter.min(0.5)
        } else {
            SHORTER
        };
        self.set_out(shorter * self.length, places);
    }
}

/// Takes all travellers as far as they come.
pub(super) fn travel<M, const P: usize, const R: usize>(
    mechanism: &M,
    places: &[Place],
    travellers: &mut [Traveller<P, R>],
) where
    M: Moving<P, R>,
{
    let columns = places.iter().map(|place| Columns::new(place.size + 2, 0));
    let mut columns: Vec<Columns<f64>> = columns.collect();
    let mut rows = Vec::new();
    let mut under_way: Vec<&mut Traveller<P, R>> = travellers.iter_mut().collect();
    loop {
        under_way.retain(|traveller| matches!(traveller.stage, Stage::Group(_)));
        if under_way.is_empty() {
            return;
        }
        for (at, (place, columns)) in places.iter().zip(&mut columns).enumerate() {
            let wants = |traveller: &&mut &mut Traveller<P, R>| traveller.stage == Stage::Group(at);
            rows.clear();
            rows.extend(under_way.iter_mut().filter(wants).map(|own| own.next));
            mechanism.correct(place.number, &Rows(&rows), columns);
            let group = &M::GROUPS[place.number];
            for (row, traveller) in under_way.iter_mut().filter(wants).enumerate() {
                traveller.take(places, at, group, |column| columns.get(row, column));
            }
        }
    }
}
