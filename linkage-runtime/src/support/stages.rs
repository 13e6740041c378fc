//! Functions as the stages of their programs: generated code states each stage once, and runs at
//! one position ([`once`]) or over the rows of a sweep.

use linkage_core::Scalar;

/// The numbers of a row.
///
/// As methods of a trait they are inlined always; a closure would be called.
pub trait RowNumbers<T> {
    /// Number `k`.
    fn number(&self, k: usize) -> T;
}

/// The numbers of a row, to write to.
pub trait RowNumbersMut<T> {
    /// Changes number `k`.
    fn put(&mut self, k: usize, value: T);
}

impl<T, const N: usize> RowNumbersMut<T> for [T; N] {
    #[inline(always)]
    fn put(&mut self, k: usize, value: T) {
        self[k] = value;
    }
}

#[cfg(feature = "alloc")]
impl<T> RowNumbersMut<T> for alloc::vec::Vec<T> {
    fn put(&mut self, k: usize, value: T) {
        self[k] = value;
    }
}

/// The data that a stage reads: those of an assembly, or others without prepared numbers.
pub trait StageData<T> {
    /// The numbers that are prepared once for many rows.
    #[inline(always)]
    fn prepared(&self) -> &[T] {
        &[]
    }
}

impl<T, C: StageData<T>> StageData<T> for &C {
    #[inline(always)]
    fn prepared(&self) -> &[T] {
        C::prepared(self)
    }
}

/// A row as a stage reads and writes it: its numbers are the arguments of the function, which are
/// inputs, other arguments and states.
pub trait StageRow<T>: RowNumbers<T> {
    /// Prepared number `k`.
    fn prepared(&self, k: usize) -> T;

    /// Number `k` that an earlier stage has kept.
    fn kept(&self, k: usize) -> T;

    /// Keeps number `k` for later stages.
    fn keep(&mut self, k: usize, value: T);

    /// Finishes result `k`.
    fn finish(&mut self, k: usize, value: T);
}

/// The results that a stage has finished, on the way into the columns of a sweep.
pub trait FinishedRows {
    /// Writes result `k` of the finished rows.
    fn write(&mut self, k: usize);
}

/// Stage `K` of a function, without a branch.
pub trait Stage<T, C, const K: usize> {
    /// Computes the stage for one row. With `FUSED` only on machines with fused multiply-add;
    /// `ROWS` for rows side by side.
    fn row<const FUSED: bool, const ROWS: bool>(core: &C, row: &mut impl StageRow<T>);

    /// Writes the results that the stage finishes; there are none unless it is written out.
    #[inline(always)]
    fn write(_rows: &mut impl FinishedRows) {}
}

/// A function of an assembly with the data `C`, as its stages: `N` arguments to `W` numbers.
pub trait Staged<T, C, const N: usize, const W: usize>: Sized {
    /// True if sweeps have code for AVX-512, too: generated code sets it unless it is built for
    /// debugging. It is no faster without, its results are the same, and its build takes a tenth
    /// longer.
    const WIDE: bool;

    /// The numbers that stages keep for later ones, in `B` rows.
    type Memory<const B: usize>: Memory<T>;

    /// Runs the stages, one after the other.
    fn run(stages: &mut impl RunStages<T, C, Self>);
}

/// Runs stages of the function `F`.
pub trait RunStages<T, C, F> {
    /// Runs stage `K`.
    fn stage<const K: usize>(&mut self)
    where
        F: Stage<T, C, K>;
}

/// Numbers of rows.
pub trait Memory<T> {
    /// All numbers are `value`.
    fn filled(value: T) -> Self;

    /// Number `k` of a row.
    fn number(&self, k: usize, row: usize) -> T;

    /// Changes number `k` of a row.
    fn put(&mut self, k: usize, row: usize, value: T);

    /// Number `k` of row `lane` of a vector of `V` rows.
    fn number_in<const V: usize>(&self, k: usize, vector: usize, lane: usize) -> T;

    /// Changes number `k` of row `lane` of a vector of `V` rows.
    fn put_in<const V: usize>(&mut self, k: usize, vector: usize, lane: usize, value: T);
}

/// `N` columns of `B` rows, where no vector crosses a cache line.
#[derive(Clone, Copy, Debug)]
#[repr(align(64))]
pub struct Block<T, const B: usize, const N: usize>(
    /// The columns.
    pub [[T; B]; N],
);

impl<T: Copy, const B: usize, const N: usize> Memory<T> for Block<T, B, N> {
    #[inline(always)]
    fn filled(value: T) -> Self {
        Self([[value; B]; N])
    }

    #[inline(always)]
    fn number(&self, k: usize, row: usize) -> T {
        self.0[k][row]
    }

    #[inline(always)]
    fn put(&mut self, k: usize, row: usize, value: T) {
        self.0[k][row] = value;
    }

    #[inline(always)]
    fn number_in<const V: usize>(&self, k: usize, vector: usize, lane: usize) -> T {
        self.0[k].as_chunks::<V>().0[vector][lane]
    }

    #[inline(always)]
    fn put_in<const V: usize>(&mut self, k: usize, vector: usize, lane: usize, value: T) {
        self.0[k].as_chunks_mut::<V>().0[vector][lane] = value;
    }
}

/// The results of a function at one position.
#[inline(always)]
pub fn once<F, T, C, const FUSED: bool, const N: usize, const W: usize>(
    core: &C,
    arguments: [T; N],
) -> [T; W]
where
    F: Staged<T, C, N, W>,
    T: Scalar,
    C: StageData<T>,
{
    let zero = T::from_f64(0.0);
    let mut once = Once::<T, C, F::Memory<1>, FUSED, N, W> {
        core,
        arguments,
        memory: F::Memory::<1>::filled(zero),
        results: [zero; W],
    };
    F::run(&mut once);
    once.results
}

/// One position.
struct Once<'a, T, C, M, const FUSED: bool, const N: usize, const W: usize> {
    core: &'a C,
    arguments: [T; N],
    memory: M,
    results: [T; W],
}

impl<T: Copy, C, M, const FUSED: bool, const N: usize, const W: usize> RowNumbers<T>
    for Once<'_, T, C, M, FUSED, N, W>
{
    #[inline(always)]
    fn number(&self, k: usize) -> T {
        self.arguments[k]
    }
}

impl<T, C, M, const FUSED: bool, const N: usize, const W: usize> StageRow<T>
    for Once<'_, T, C, M, FUSED, N, W>
where
    T: Copy,
    C: StageData<T>,
    M: Memory<T>,
{
    #[inline(always)]
    fn prepared(&self, k: usize) -> T {
        self.core.prepared()[k]
    }

    #[inline(always)]
    fn kept(&self, k: usize) -> T {
        self.memory.number(k, 0)
    }

    #[inline(always)]
    fn keep(&mut self, k: usize, value: T) {
        self.memory.put(k, 0, value);
    }

    #[inline(always)]
    fn finish(&mut self, k: usize, value: T) {
        self.results[k] = value;
    }
}

impl<T, C, F, M, const FUSED: bool, const N: usize, const W: usize> RunStages<T, C, F>
    for Once<'_, T, C, M, FUSED, N, W>
where
    T: Copy,
    C: StageData<T>,
    M: Memory<T>,
{
    #[inline(always)]
    fn stage<const K: usize>(&mut self)
    where
        F: Stage<T, C, K>,
    {
        F::row::<FUSED, false>(self.core, self);
    }
}
