//! The sweeps over mechanisms of a function whose coupled groups are followed to the dimensions of
//! each.

#[cfg(feature = "rayon")]
use super::followed::fill_followed_parallel;
use super::followed::{Followed, Moving, fill_followed};
use super::over_sets::rows;
use super::staged::{OverSets, SetStages};
use crate::result_columns::ResultColumns;
use crate::support::assembling::{Compiled, CoreOf, DataOf};
use crate::support::assembly_data::AssemblyData;
use crate::support::evaluation::Function;
use linkage_core::Scalar;

/// A program whose coupled groups can be followed, of a function of mechanisms with `P` dimensions
/// and the data `C`. A row of the mechanism has `Y` numbers.
pub trait FollowedStages<C, const P: usize, const Y: usize> {
    /// The mechanism that changes its dimensions.
    type Moving: Moving<P, Y>;

    /// The numbers of the function's rows after the dimensions, by their index in rows of the
    /// mechanism; `None` for speeds and loads, which these do not have.
    const PLACES: &'static [Option<usize>];

    /// The groups that the function uses, each with the first place and the size of its state.
    const GROUPS: &'static [(usize, usize, usize)];

    /// The mechanism in one lane.
    fn moving(core: &C, lane: usize) -> Self::Moving;
}

/// The results for many mechanisms.
///
/// # Panics
///
/// Panics if the arguments differ in length.
pub fn followed_sweep_sets<
    T,
    R,
    M,
    const P: usize,
    const I: usize,
    const N: usize,
    const Q: usize,
    const X: usize,
    const Y: usize,
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
    R: Function<
            T,
            CoreOf<M>,
            M::States,
            I,
            N,
            W,
            Refining: SetStages<M, P, Q, X> + FollowedStages<CoreOf<M>, P, Y>,
        >,
{
    let mut columns = ResultColumns::default();
    into_columns(data, "_sweep_sets", sets, arguments, &mut columns);
    columns
}

/// Works as [`followed_sweep_sets`], into columns.
///
/// # Panics
///
/// Panics if the arguments differ in length.
pub fn followed_sweep_sets_into<
    T,
    R,
    M,
    const P: usize,
    const I: usize,
    const N: usize,
    const Q: usize,
    const X: usize,
    const Y: usize,
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
    R: Function<
            T,
            CoreOf<M>,
            M::States,
            I,
            N,
            W,
            Refining: SetStages<M, P, Q, X> + FollowedStages<CoreOf<M>, P, Y>,
        >,
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
    const Y: usize,
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
    R: Function<
            T,
            CoreOf<M>,
            M::States,
            I,
            N,
            W,
            Refining: SetStages<M, P, Q, X> + FollowedStages<CoreOf<M>, P, Y>,
        >,
{
    let rows = rows::<T, R, M, P, I, N, Q, W>(data, sweep, sets, arguments);
    let core = AssemblyData::core(data);
    let kernel = OverSets::<M, R::Refining, P, N, Q>::new(core);
    let followed = followed::<R::Refining, CoreOf<M>, P, Y>(core);
    fill_followed::<T, R, _, _, P, Y, X, W>(&kernel, &rows, &followed, columns);
}

/// Works as [`followed_sweep_sets_into`], on all threads of rayon's current pool.
///
/// # Panics
///
/// Panics if the arguments differ in length.
#[cfg(feature = "rayon")]
pub fn followed_sweep_sets_parallel_into<
    T,
    R,
    M,
    const P: usize,
    const I: usize,
    const N: usize,
    const Q: usize,
    const X: usize,
    const Y: usize,
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
    R: Function<
            T,
            CoreOf<M>,
            M::States,
            I,
            N,
            W,
            Refining: SetStages<M, P, Q, X> + FollowedStages<CoreOf<M>, P, Y>,
        >,
{
    let rows = rows::<T, R, M, P, I, N, Q, W>(data, "_sweep_sets_parallel_into", sets, arguments);
    let core = AssemblyData::core(data);
    let kernel = OverSets::<M, R::Refining, P, N, Q>::new(core);
    let followed = followed::<R::Refining, CoreOf<M>, P, Y>(core);
    fill_followed_parallel::<T, R, _, _, P, Y, X, W>(&kernel, &rows, &followed, columns);
}

/// The part of the mechanism that the program `F` needs.
fn followed<F, C, const P: usize, const Y: usize>(
    core: &C,
) -> Followed<impl Fn(usize) -> F::Moving, P>
where
    F: FollowedStages<C, P, Y>,
{
    Followed {
        mechanism: |lane| F::moving(core, lane),
        places: F::PLACES,
        groups: F::GROUPS,
    }
}
