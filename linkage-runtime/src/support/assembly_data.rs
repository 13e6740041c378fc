//! The data of an assembly, in fields that the module of the mechanism cannot reach.

use super::stages::StageData;

/// Data that are prepared once and only read afterwards: nobody can change one part and leave the
/// others as they were.
///
/// A struct that a macro makes belongs to the module of the call, which so may write to all of its
/// fields; to these it may not. Both parts are read by functions, not by methods, which rustc would
/// suggest to users.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AssemblyData<Core, Starts = ()> {
    core: Core,
    starts: Starts,
}

impl<Core, Starts> AssemblyData<Core, Starts> {
    /// Data that sweeps copy into their loops, and the initial states of coupled groups.
    #[inline(always)]
    pub const fn new(core: Core, starts: Starts) -> Self {
        Self { core, starts }
    }

    /// Data that sweeps copy into their loops.
    #[inline(always)]
    pub const fn core(data: &Self) -> &Core {
        &data.core
    }

    /// The prepared starts of coupled groups.
    #[inline(always)]
    pub const fn starts(data: &Self) -> &Starts {
        &data.starts
    }
}

/// Data that sweeps copy into their loops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Core<D, M, R, P> {
    /// The dimensions.
    pub dimensions: D,
    /// The mode of each group that has two.
    pub modes: M,
    /// The revolutions of the continuous angles.
    pub revolutions: R,
    /// The numbers that depend on all these alone.
    pub prepared: P,
}

impl<T, D, M, R, P: AsRef<[T]>> StageData<T> for Core<D, M, R, P> {
    #[inline(always)]
    fn prepared(&self) -> &[T] {
        self.prepared.as_ref()
    }
}

impl<D, M, R, P> Core<D, M, R, P> {
    /// The dimensions, the modes and the prepared numbers, which programs load.
    #[inline(always)]
    pub const fn loaded(&self) -> (&D, &M, &P) {
        (&self.dimensions, &self.modes, &self.prepared)
    }
}
