//! The sweeps of a function over its arguments.

use core::marker::PhantomData;

use super::arguments::Inputs;
use super::extended::Extended;
use super::fill;
use super::staged::OverInputs;
use crate::result_columns::ResultColumns;
use crate::support::assembly_data::AssemblyData;
use crate::support::dispatch::as_in_sweeps;
use crate::support::evaluation::{Function, FunctionCall};
use crate::support::stages::StageData;
use linkage_core::Scalar;

/// The results at many positions.
///
/// # Panics
///
/// Panics if the arguments differ in length.
pub fn sweep<T, C, S, R, const I: usize, const N: usize, const W: usize>(
    data: &AssemblyData<C, S>,
    arguments: [&[T]; I],
) -> ResultColumns<T, R, W>
where
    T: Scalar,
    C: StageData<T> + Copy,
    R: Function<T, C, S, I, N, W>,
{
    let mut columns = ResultColumns::default();
    into_columns(data, "_sweep", arguments, &mut columns);
    columns
}

/// Works as [`sweep`], into columns.
///
/// # Panics
///
/// Panics if the arguments differ in length.
pub fn sweep_into<T, C, S, R, const I: usize, const N: usize, const W: usize>(
    data: &AssemblyData<C, S>,
    arguments: [&[T]; I],
    columns: &mut ResultColumns<T, R, W>,
) where
    T: Scalar,
    C: StageData<T> + Copy,
    R: Function<T, C, S, I, N, W>,
{
    into_columns(data, "_sweep_into", arguments, columns);
}

/// One loop for both sweeps into columns; `sweep` is the ending of the name of the sweep.
fn into_columns<T, C, S, R, const I: usize, const N: usize, const W: usize>(
    data: &AssemblyData<C, S>,
    sweep: &'static str,
    arguments: [&[T]; I],
    columns: &mut ResultColumns<T, R, W>,
) where
    T: Scalar,
    C: StageData<T> + Copy,
    R: Function<T, C, S, I, N, W>,
{
    let rows = rows::<T, C, S, R, I, N, W>(data, sweep, arguments);
    let core = AssemblyData::core(data);
    let call = |index| {
        as_in_sweeps::<FunctionCall<R, N, W>, _, T, R, I>(data, fill::row_of(&arguments, index))
    };
    if const { T::REFINES } {
        let kernel = OverInputs::<_, R::Refining>::new(core);
        fill::fill_or_call::<T, R, N, W>(&kernel, &rows, columns, call);
    } else {
        let kernel = OverInputs::<_, R::Called>::new(core);
        fill::fill_or_call::<T, R, N, W>(&kernel, &rows, columns, call);
    }
}

/// The function whose result is `R`, for sweeps into slices, which do not say that.
#[derive(Debug)]
pub struct Slices<R>(PhantomData<fn() -> R>);

impl<R> Slices<R> {
    /// Works as [`sweep`], into slices.
    ///
    /// # Panics
    ///
    /// Panics if the arguments or slices differ in length.
    pub fn sweep<T, C, S, const I: usize, const N: usize, const W: usize>(
        data: &AssemblyData<C, S>,
        arguments: [&[T]; I],
        slices: [&mut [T]; W],
    ) where
        T: Scalar,
        C: StageData<T> + Copy,
        R: Function<T, C, S, I, N, W>,
    {
        let rows = rows::<T, C, S, R, I, N, W>(data, "_sweep_slices", arguments);
        let core = AssemblyData::core(data);
        let function = R::NAMES.function;
        if const { T::REFINES } {
            let kernel = OverInputs::<_, R::Refining>::new(core);
            fill::fill_slices::<T, N, W>(function, &kernel, &rows, slices);
        } else {
            let kernel = OverInputs::<_, R::Called>::new(core);
            fill::fill_slices::<T, N, W>(function, &kernel, &rows, slices);
        }
    }
}

/// Works as [`sweep_into`], on all threads of rayon's current pool.
///
/// # Panics
///
/// Panics if the arguments differ in length.
#[cfg(feature = "rayon")]
pub fn sweep_parallel_into<T, C, S, R, const I: usize, const N: usize, const W: usize>(
    data: &AssemblyData<C, S>,
    arguments: [&[T]; I],
    columns: &mut ResultColumns<T, R, W>,
) where
    T: Scalar + Send + Sync,
    C: StageData<T> + Copy + Sync,
    S: Sync,
    R: Function<T, C, S, I, N, W>,
{
    use super::parallel::fill_parallel;

    let rows = rows::<T, C, S, R, I, N, W>(data, "_sweep_parallel_into", arguments);
    let core = AssemblyData::core(data);
    if const { T::REFINES } {
        let kernel = OverInputs::<_, R::Refining>::new(core);
        fill_parallel::<T, R, N, W>(&kernel, &rows, columns);
    } else {
        let kernel = OverInputs::<_, R::Called>::new(core);
        fill_parallel::<T, R, N, W>(&kernel, &rows, columns);
    }
}

/// The rows of a sweep: arguments, and states after them.
#[inline(always)]
fn rows<'a, T, C, S, R, const I: usize, const N: usize, const W: usize>(
    data: &'a AssemblyData<C, S>,
    sweep: &'static str,
    slices: [&'a [T]; I],
) -> Extended<'a, Inputs<'a, T, I>, S, R::States, I, I, N>
where
    R: Function<T, C, S, I, N, W>,
{
    let inputs = Inputs {
        names: R::NAMES,
        sweep,
        slices,
    };
    Extended::new(inputs, AssemblyData::starts(data))
}
