//! The sweeps of a function over mechanisms.

use super::arguments::Sets;
use super::extended::Extended;
use super::fill::fill_results;
#[cfg(feature = "rayon")]
use super::parallel::fill_parallel;
use super::staged::{OverSets, SetStages};
use crate::result_columns::ResultColumns;
use crate::support::assembly_data::AssemblyData;
use crate::support::evaluation::Function;
use linkage_core::Scalar;

/// The rows of a sweep: mechanisms by their `P` dimensions, arguments, and states after them.
pub(super) type SetRows<'a, M, T, D, S, F, const I: usize, const N: usize, const Q: usize> =
    Extended<'a, Sets<'a, M, T, D, I, Q>, S, F, Q, I, N>;

/// The results for many mechanisms; `dimensions` are those of a mechanism.
///
/// # Panics
///
/// Panics if the arguments differ in length.
pub fn sweep_sets<
    T,
    C,
    S,
    R,
    M,
    D,
    const P: usize,
    const I: usize,
    const N: usize,
    const Q: usize,
    const X: usize,
    const W: usize,
>(
    data: &AssemblyData<C, S>,
    sets: &[M],
    dimensions: D,
    arguments: [&[T]; I],
) -> ResultColumns<T, R, W>
where
    T: Scalar,
    C: Copy,
    R: Function<T, C, S, I, N, W, Refining: SetStages<T, C, P, Q, X>>,
    D: Fn(&M) -> [T; P],
{
    let mut columns = ResultColumns::default();
    into_columns(
        data,
        "_sweep_sets",
        sets,
        dimensions,
        arguments,
        &mut columns,
    );
    columns
}

/// Works as [`sweep_sets`], into columns.
///
/// # Panics
///
/// Panics if the arguments differ in length.
pub fn sweep_sets_into<
    T,
    C,
    S,
    R,
    M,
    D,
    const P: usize,
    const I: usize,
    const N: usize,
    const Q: usize,
    const X: usize,
    const W: usize,
>(
    data: &AssemblyData<C, S>,
    sets: &[M],
    dimensions: D,
    arguments: [&[T]; I],
    columns: &mut ResultColumns<T, R, W>,
) where
    T: Scalar,
    C: Copy,
    R: Function<T, C, S, I, N, W, Refining: SetStages<T, C, P, Q, X>>,
    D: Fn(&M) -> [T; P],
{
    into_columns(
        data,
        "_sweep_sets_into",
        sets,
        dimensions,
        arguments,
        columns,
    );
}

/// One loop for both sweeps into columns; `sweep` is the ending of the name of the sweep.
fn into_columns<
    T,
    C,
    S,
    R,
    M,
    D,
    const P: usize,
    const I: usize,
    const N: usize,
    const Q: usize,
    const X: usize,
    const W: usize,
>(
    data: &AssemblyData<C, S>,
    sweep: &'static str,
    sets: &[M],
    dimensions: D,
    arguments: [&[T]; I],
    columns: &mut ResultColumns<T, R, W>,
) where
    T: Scalar,
    C: Copy,
    R: Function<T, C, S, I, N, W, Refining: SetStages<T, C, P, Q, X>>,
    D: Fn(&M) -> [T; P],
{
    let rows: SetRows<'_, M, T, D, S, R::States, I, N, Q> =
        rows::<T, C, S, R, M, D, I, N, Q, W>(data, sweep, sets, dimensions, arguments);
    let kernel = OverSets::<_, R::Refining, P, N, Q>::new(AssemblyData::core(data));
    fill_results::<T, R, X, W>(&kernel, &rows, columns);
}

/// Works as [`sweep_sets_into`], on all threads of rayon's current pool.
///
/// # Panics
///
/// Panics if the arguments differ in length.
#[cfg(feature = "rayon")]
pub fn sweep_sets_parallel_into<
    T,
    C,
    S,
    R,
    M,
    D,
    const P: usize,
    const I: usize,
    const N: usize,
    const Q: usize,
    const X: usize,
    const W: usize,
>(
    data: &AssemblyData<C, S>,
    sets: &[M],
    dimensions: D,
    arguments: [&[T]; I],
    columns: &mut ResultColumns<T, R, W>,
) where
    T: Scalar + Send + Sync,
    C: Copy + Sync,
    S: Sync,
    M: Sync,
    R: Function<T, C, S, I, N, W, Refining: SetStages<T, C, P, Q, X>>,
    D: Fn(&M) -> [T; P] + Sync,
{
    let rows = rows::<T, C, S, R, M, D, I, N, Q, W>(
        data,
        "_sweep_sets_parallel_into",
        sets,
        dimensions,
        arguments,
    );
    let kernel = OverSets::<_, R::Refining, P, N, Q>::new(AssemblyData::core(data));
    fill_parallel::<T, R, X, W>(&kernel, &rows, columns);
}

/// The rows of a sweep.
#[inline(always)]
pub(super) fn rows<
    'a,
    T,
    C,
    S,
    R,
    M,
    D,
    const I: usize,
    const N: usize,
    const Q: usize,
    const W: usize,
>(
    data: &'a AssemblyData<C, S>,
    sweep: &'static str,
    sets: &'a [M],
    dimensions: D,
    slices: [&'a [T]; I],
) -> SetRows<'a, M, T, D, S, R::States, I, N, Q>
where
    R: Function<T, C, S, I, N, W>,
{
    let sets = Sets {
        names: R::NAMES,
        sweep,
        sets,
        slices,
        dimensions,
    };
    Extended::new(sets, AssemblyData::starts(data))
}
