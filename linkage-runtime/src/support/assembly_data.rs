//! What an assembly consists of, behind fields that the module of the mechanism cannot reach.

/// What is prepared once and read from then on: nobody can change one part of it and leave the others as they were.
///
/// A struct that a macro makes belongs to the module of the call, which so may write to all of its fields; to these it may not. Both parts are read by
/// functions, not by methods, which rustc would suggest to users.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AssemblyData<Core, Starts = ()> {
    core: Core,
    starts: Starts,
}

impl<Core, Starts> AssemblyData<Core, Starts> {
    /// What sweeps copy into their loops, and the prepared starts of coupled groups.
    #[inline(always)]
    pub const fn new(core: Core, starts: Starts) -> Self {
        Self { core, starts }
    }

    /// What sweeps copy into their loops.
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
