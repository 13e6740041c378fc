//! The sweeps of a function over mechanisms.

use super::arguments::Sets;
use super::extended::Extended;
use super::fill::fill_results;
#[cfg(feature = "rayon")]
use super::parallel::fill_parallel;
use super::staged::{OverSets, SetStages};
use crate::result_columns::ResultColumns;
use crate::support::assembling::{Compiled, CoreOf, DataOf};
use crate::support::assembly_data::AssemblyData;
use crate::support::evaluation::Function;
use linkage_core::Scalar;

/// The rows of a sweep: mechanisms by their `P` dimensions, arguments, and states after them.
pub(super) type SetRows<
    'a,
    M,
    T,
    S,
    F,
    const P: usize,
    const I: usize,
    const N: usize,
    const Q: usize,
> = Extended<'a, Sets<'a, M, T, P, I, Q>, S, F, Q, I, N>;

/// The results for many mechanisms.
///
/// # Panics
///
/// Panics if the arguments differ in length.
pub fn sweep_sets<
    T,
    R,
    M,
    const P: usize,
    const I: usize,
    const N: usize,
    const Q: usize,
    const X: usize,
    const W: usize,
>(
    data: &DataOf<M>,
    sets: &[M],
    arguments: [&[T]; I],
) -> ResultColumns<T, R, W>
where
    T: Scalar,
    M: Compiled<Scalar = T>,
    CoreOf<M>: Copy,
    R: Function<T, CoreOf<M>, M::States, I, N, W, Refining: SetStages<M, P, Q, X>>,
{
    let mut columns = ResultColumns::default();
    into_columns(data, "_sweep_sets", sets, arguments, &mut columns);
    columns
}

/// Works as [`sweep_sets`], into columns.
///
/// # Panics
///
/// Panics if the arguments differ in length.
pub fn sweep_sets_into<
    T,
    R,
    M,
    const P: usize,
    const I: usize,
    const N: usize,
    const Q: usize,
    const X: usize,
    const W: usize,
>(
    data: &DataOf<M>,
    sets: &[M],
    arguments: [&[T]; I],
    columns: &mut ResultColumns<T, R, W>,
) where
    T: Scalar,
    M: Compiled<Scalar = T>,
    CoreOf<M>: Copy,
    R: Function<T, CoreOf<M>, M::States, I, N, W, Refining: SetStages<M, P, Q, X>>,
{
    into_columns(data, "_sweep_sets_into", sets, arguments, columns);
}

/// One loop for both sweeps into columns; `sweep` is the ending of the name of the sweep.
fn into_columns<
    T,
    R,
    M,
    const P: usize,
    const I: usize,
    const N: usize,
    const Q: usize,
    const X: usize,
    const W: usize,
>(
    data: &DataOf<M>,
    sweep: &'static str,
    sets: &[M],
    arguments: [&[T]; I],
    columns: &mut ResultColumns<T, R, W>,
) where
    T: Scalar,
    M: Compiled<Scalar = T>,
    CoreOf<M>: Copy,
    R: Function<T, CoreOf<M>, M::States, I, N, W, Refining: SetStages<M, P, Q, X>>,
{
    let rows: SetRows<'_, M, T, M::States, R::States, P, I, N, Q> =
        rows::<T, R, M, P, I, N, Q, W>(data, sweep, sets, arguments);
    let kernel = OverSets::<M, R::Refining, P, N, Q>::new(AssemblyData::core(data));
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
    R,
    M,
    const P: usize,
    const I: usize,
    const N: usize,
    const Q: usize,
    const X: usize,
    const W: usize,
>(
    data: &DataOf<M>,
    sets: &[M],
    arguments: [&[T]; I],
    columns: &mut ResultColumns<T, R, W>,
) where
    T: Scalar + Send + Sync,
    M: Compiled<Scalar = T, States: Sync> + Sync,
    CoreOf<M>: Copy + Sync,
    R: Function<T, CoreOf<M>, M::States, I, N, W, Refining: SetStages<M, P, Q, X>>,
{
    let rows = rows::<T, R, M, P, I, N, Q, W>(data, "_sweep_sets_parallel_into", sets, arguments);
    let kernel = OverSets::<M, R::Refining, P, N, Q>::new(AssemblyData::core(data));
    fill_parallel::<T, R, X, W>(&kernel, &rows, columns);
}

/// The rows of a sweep.
#[inline(always)]
pub(super) fn rows<
    'a,
    T,
    R,
    M,
    const P: usize,
    const I: usize,
    const N: usize,
    const Q: usize,
    const W: usize,
>(
    data: &'a DataOf<M>,
    sweep: &'static str,
    sets: &'a [M],
    slices: [&'a [T]; I],
) -> SetRows<'a, M, T, M::States, R::States, P, I, N, Q>
where
    T: Scalar,
    M: Compiled<Scalar = T>,
    R: Function<T, CoreOf<M>, M::States, I, N, W>,
{
    let sets = Sets {
        names: R::NAMES,
        sweep,
        sets,
        slices,
    };
    Extended::new(sets, AssemblyData::starts(data))
}
