//! Mechanisms too far from the one of the tables for the steps of a kernel: the states of their
//! coupled groups are followed.

mod rows;
mod tracking;

use super::arguments::Arguments;
use super::blocks::rows;
use super::instruction_set::run;
use super::kernel::Kernel;
use crate::columns::Columns;
use crate::result_columns::ResultColumns;
use alloc::vec::Vec;
use linkage_core::{FUSED, Scalar};
use rows::Rows;
use tracking::{Groups, StateSpan, track_rows};

pub use tracking::Moving;

/// Rows that are followed together: enough for vectors of rows, few enough for the processor's
/// cache.
const TOGETHER: usize = 512;

/// A function's part of a mechanism that is followed.
#[derive(Clone, Copy, Debug)]
pub(super) struct Followed<F, const P: usize> {
    /// The mechanism of a lane, a [`Moving`].
    pub mechanism: F,
    /// Positions of inputs, states and floors of the function's rows in those of the mechanism;
    /// dimensions are first in both. `None` for speeds and loads, which the mechanism has not.
    pub places: &'static [Option<usize>],
    /// The groups that the function uses, each with the first place and the size of its state.
    pub groups: &'static [(usize, usize, usize)],
}

impl<F, const P: usize> Followed<F, P> {
    /// Evaluates rows that are not a number again, with followed states.
    fn complete<T, M, const R: usize, const I: usize, const W: usize>(
        &self,
        kernel: &impl Kernel<T, I, W>,
        arguments: &impl Arguments<T, I>,
        start: usize,
        columns: &mut [&mut [T]; W],
    ) where
        T: Scalar,
        M: Moving<P, R>,
        F: Fn(usize) -> M,
    {
        let mut numbers = Vec::new();
        let count = rows(columns);
        for number in 0..count {
            if (0..T::LANES).any(|lane| is_missing(columns, number, lane)) {
                numbers.push(number);
            }
            if numbers.len() == TOGETHER || number + 1 == count {
                self.anew(kernel, arguments, start, &numbers, columns);
                numbers.clear();
            }
        }
    }

    /// Evaluates some rows with followed states; where the way is blocked they stay as they are.
    fn anew<T, M, const R: usize, const I: usize, const W: usize>(
        &self,
        kernel: &impl Kernel<T, I, W>,
        arguments: &impl Arguments<T, I>,
        start: usize,
        numbers: &[usize],
        columns: &mut [&mut [T]; W],
    ) where
        T: Scalar,
        M: Moving<P, R>,
        F: Fn(usize) -> M,
    {
        let groups = self.groups.iter();
        let groups = groups.map(|&(number, first, size)| StateSpan {
            number,
            first,
            size,
        });
        let groups = Groups::new(groups.collect());
        let one = |&number: &usize| one_row(arguments, start + number);
        let mut completed: Vec<[T; I]> = numbers.iter().map(one).collect();
        let mut reached = alloc::vec![false; completed.len()];
        let (mut missing, mut ways) = (Vec::new(), Vec::new());
        for lane in 0..T::LANES {
            let rows = numbers.iter().enumerate();
            let rows_of_lane = rows.filter(|&(_, &number)| is_missing(columns, number, lane));
            missing.clear();
            missing.extend(rows_of_lane.map(|(at, _)| at));
            ways.clear();
            ways.extend(missing.iter().map(|&at| self.whole(&completed[at], lane)));
            track_rows(&(self.mechanism)(lane), &groups, &mut ways);
            for (&at, there) in missing.iter().zip(&ways) {
                if groups.have(there) {
                    self.put(&mut completed[at], lane, there);
                    reached[at] = true;
                }
            }
        }
        let kept = || reached.iter().zip(0..).filter(|(reached, _)| **reached);
        let rows: Vec<[T; I]> = kept().map(|(_, at)| completed[at]).collect();
        let mut found = Columns::new(W, rows.len());
        run(kernel, &Rows(&rows), 0, found.all_mut());
        for (index, column) in columns.iter_mut().enumerate() {
            for ((_, at), &value) in kept().zip(found.column(index)) {
                column[numbers[at]] = value;
            }
        }
    }

    /// One lane of a function's row as a row of the mechanism; NaN where the function has nothing.
    fn whole<T: Scalar, const R: usize, const I: usize>(
        &self,
        row: &[T; I],
        lane: usize,
    ) -> [f64; R] {
        let mut whole = [f64::NAN; R];
        let numbers = (0..P).map(Some).chain(self.places.iter().copied());
        for (number, value) in numbers.zip(row) {
            if let Some(number) = number {
                whole[number] = value.lane(lane);
            }
        }
        whole
    }

    /// Puts states into one lane of a function's row.
    fn put<T: Scalar, const R: usize, const I: usize>(
        &self,
        row: &mut [T; I],
        lane: usize,
        whole: &[f64; R],
    ) {
        for (index, value) in self.places.iter().zip(&mut row[P..]) {
            let &Some(index) = index else { continue };
            *value = T::from_lanes(|other| {
                if other == lane {
                    whole[index]
                } else {
                    value.lane(other)
                }
            });
        }
    }
}

/// Returns true if a result is no number.
fn is_missing<T: Scalar>(columns: &[&mut [T]], row: usize, lane: usize) -> bool {
    columns.iter().any(|column| column[row].lane(lane).is_nan())
}

fn one_row<T: Scalar, const I: usize>(arguments: &impl Arguments<T, I>, number: usize) -> [T; I] {
    let mut row = [[T::from_f64(0.0)]; I];
    arguments.block::<{ FUSED }, 1, 1>(number, 1, &mut row);
    row.map(|[value]| value)
}

/// Works as [`fill`](crate::support::fill). If results are not a number, the states of coupled
/// groups are followed to the dimensions of the row.
///
/// # Panics
///
/// Panics if the arguments differ in length.
pub(super) fn fill_followed<
    T,
    Q,
    M,
    F,
    const P: usize,
    const R: usize,
    const I: usize,
    const W: usize,
>(
    kernel: &impl Kernel<T, I, W>,
    arguments: &impl Arguments<T, I>,
    followed: &Followed<F, P>,
    columns: &mut ResultColumns<T, Q, W>,
) where
    T: Scalar,
    M: Moving<P, R>,
    F: Fn(usize) -> M,
{
    let columns = columns.columns_mut();
    columns.resize(arguments.check());
    let mut columns = columns.all_mut();
    run(
        kernel,
        arguments,
        0,
        columns.each_mut().map(|column| &mut **column),
    );
    followed.complete(kernel, arguments, 0, &mut columns);
}

/// Works as [`fill_followed`], on all threads of rayon's current pool.
///
/// # Panics
///
/// Panics if the arguments differ in length.
#[cfg(feature = "rayon")]
pub(super) fn fill_followed_parallel<
    T,
    Q,
    M,
    F,
    const P: usize,
    const R: usize,
    const I: usize,
    const W: usize,
>(
    kernel: &(impl Kernel<T, I, W> + Sync),
    arguments: &(impl Arguments<T, I> + Sync),
    followed: &Followed<F, P>,
    columns: &mut ResultColumns<T, Q, W>,
) where
    T: Scalar + Send + Sync,
    M: Moving<P, R>,
    F: Fn(usize) -> M + Sync,
{
    let columns = columns.columns_mut();
    columns.resize(arguments.check());
    super::parallel::split(0, columns.all_mut(), &|start, mut columns| {
        run(
            kernel,
            arguments,
            start,
            columns.each_mut().map(|column| &mut **column),
        );
        followed.complete(kernel, arguments, start, &mut columns);
    });
}
