//! Numbers that programs load, and when values are known.

/// The earliest moment at which a value is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Binding {
    /// At compile time.
    Constant,
    /// In `assemble()`: depends on parameters, modes and windings alone.
    Parameter,
    /// At every call: depends on a driving coordinate.
    Call,
}

/// The origin of a number that a program does not compute itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Source {
    /// A scalar parameter of the mechanism, by index.
    Parameter(usize),
    /// A driving coordinate, by index in the mechanism.
    Input(usize),
    /// The assembly mode of a group with two modes, by mode index: `+1` or `-1`.
    Mode(usize),
    /// The centre of a continuous angle, by index among the continuous angles.
    Centre(usize),
    /// The number of turns of a continuous angle for each turn of an input.
    Winding(usize, usize),
    /// A value computed once in `assemble()`, by slot.
    Prepared(usize),
    /// A value from the stage before, by index.
    Carried(usize),
    /// A prepared number of the solution of a coupled group near a position, by group (among the
    /// coupled ones) and component: an approximate state, then the least determinant that is
    /// certified.
    State(usize, usize),
    /// The largest correction of a prepared state that is certified.
    Limit,
}

impl Source {
    /// When a number is known.
    pub fn binding(self) -> Binding {
        match self {
            Self::Input(_) | Self::State(..) | Self::Limit | Self::Carried(_) => Binding::Call,
            Self::Parameter(_)
            | Self::Mode(_)
            | Self::Centre(_)
            | Self::Winding(..)
            | Self::Prepared(_) => Binding::Parameter,
        }
    }
}
