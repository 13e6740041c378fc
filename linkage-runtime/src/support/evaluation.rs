//! The functions of an assembly: the programs that a call or a sweep of a function runs.

use core::marker::PhantomData;

use linkage_core::Scalar;

use super::assembly_data::AssemblyData;
use super::dispatch::{DataFunction, dispatch_function, inlined_function};
use super::stages::{StageData, Staged, once};
use crate::result_row::ResultRow;

/// The names of a function and of its arguments, for panics.
#[derive(Clone, Copy, Debug)]
pub struct FunctionNames<const I: usize> {
    /// The function.
    pub function: &'static str,
    /// Its arguments.
    pub arguments: [&'static str; I],
}

/// The result of a function of assemblies with the data `C` and the initial states `S`: `I`
/// arguments to `W` numbers. Its programs have `N` arguments, those of the function and then the
/// states of coupled groups.
pub trait Function<T, C, S, const I: usize, const N: usize, const W: usize>:
    ResultRow<T, W>
{
    /// The program of calls.
    type Called: Staged<T, C, N, W>;

    /// The program for dimensions, derivatives and digits that tables do not have.
    type Refining: Staged<T, C, N, W>;

    /// The source of the states.
    type States: States<T, S, I, N>;

    /// Names for panics.
    const NAMES: &'static FunctionNames<I>;
}

/// A source of the states of coupled groups: `I` arguments to these and the states, `N` numbers.
pub trait States<T, S, const I: usize, const N: usize> {
    /// Returns the arguments and the states there. With `FUSED` only on machines with fused
    /// multiply-add.
    fn extend<const FUSED: bool>(initial: &S, arguments: [T; I]) -> [T; N];

    /// Fills the states of the first `vectors` times `V` rows of the arguments. With `FUSED` only
    /// on machines with fused multiply-add.
    fn fill<const FUSED: bool, const V: usize, const B: usize>(
        initial: &S,
        arguments: &[[T; B]],
        vectors: usize,
        states: &mut [[T; B]],
    );
}

/// The source of no states, for functions without coupled groups.
#[derive(Clone, Copy, Debug)]
pub struct NoStates;

impl<T, S, const I: usize> States<T, S, I, I> for NoStates {
    #[inline(always)]
    fn extend<const FUSED: bool>(_: &S, arguments: [T; I]) -> [T; I] {
        arguments
    }

    #[inline(always)]
    fn fill<const FUSED: bool, const V: usize, const B: usize>(
        _: &S,
        _: &[[T; B]],
        _: usize,
        _: &mut [[T; B]],
    ) {
    }
}

/// The function whose result is `R`, at one position.
pub(super) struct FunctionCall<R, const N: usize, const W: usize>(PhantomData<fn() -> R>);

impl<T, C, S, R, const I: usize, const N: usize, const W: usize>
    DataFunction<AssemblyData<C, S>, T, R, I> for FunctionCall<R, N, W>
where
    T: Scalar,
    C: StageData<T>,
    R: Function<T, C, S, I, N, W>,
{
    #[inline(always)]
    fn value<const FUSED: bool>(data: &AssemblyData<C, S>, arguments: [T; I]) -> R {
        let arguments = R::States::extend::<FUSED>(AssemblyData::starts(data), arguments);
        evaluate::<R::Called, R::Refining, R, T, C, FUSED, N, W>(
            AssemblyData::core(data),
            arguments,
        )
    }
}

/// The result of a function by its program `P`. Scalars that refine the prepared values run the
/// program `Q`.
#[inline(always)]
pub fn evaluate<P, Q, R, T, C, const FUSED: bool, const N: usize, const W: usize>(
    core: &C,
    arguments: [T; N],
) -> R
where
    T: Scalar,
    C: StageData<T>,
    P: Staged<T, C, N, W>,
    Q: Staged<T, C, N, W>,
    R: ResultRow<T, W>,
{
    R::from_row(if const { T::REFINES } {
        once::<Q, T, C, FUSED, N, W>(core, arguments)
    } else {
        once::<P, T, C, FUSED, N, W>(core, arguments)
    })
}

/// The function whose result is `R`, by code for the instruction set of the machine.
#[inline(always)]
pub fn call<R, T, C, S, const I: usize, const N: usize, const W: usize>(
    data: &AssemblyData<C, S>,
    arguments: [T; I],
) -> R
where
    T: Scalar,
    C: StageData<T>,
    R: Function<T, C, S, I, N, W>,
{
    dispatch_function::<FunctionCall<R, N, W>, AssemblyData<C, S>, T, R, I>(data, arguments)
}

/// The function whose result is `R`, by code for the build's own instruction set, for functions
/// that are shorter than a call.
#[inline(always)]
pub fn call_inlined<R, T, C, S, const I: usize, const N: usize, const W: usize>(
    data: &AssemblyData<C, S>,
    arguments: [T; I],
) -> R
where
    T: Scalar,
    C: StageData<T>,
    R: Function<T, C, S, I, N, W>,
{
    inlined_function::<FunctionCall<R, N, W>, AssemblyData<C, S>, T, R, I>(data, arguments)
}
