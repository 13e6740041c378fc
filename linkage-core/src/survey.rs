//! Input of the search for circuits: the range of an input, and the assemblies of each group.

/// The range of an input whose assemblies are looked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cycle {
    /// Lower end of the range.
    pub low: f64,
    /// Upper end of the range.
    pub high: f64,
    /// True if the input is an angle in radians. Over a full turn, assemblies that continue each
    /// other from one turn to the next belong to one circuit.
    pub angle: bool,
    /// At how many inputs the assemblies of coupled groups are listed, both ends included. A
    /// circuit that exists between two neighbouring inputs only is not found.
    pub samples: usize,
}

impl Cycle {
    /// A range of an angle that differs from a full turn by less, in radians, is one: users write
    /// 360 degrees.
    pub const TURN: f64 = 1e-9;

    /// The length of the range if it is a full turn.
    #[must_use]
    pub fn turn(&self) -> Option<f64> {
        let length = self.high - self.low;
        // The absolute value is there without a standard library, too.
        let aside = (length - core::f64::consts::TAU).max(core::f64::consts::TAU - length);
        (self.angle && aside < Self::TURN).then_some(length)
    }
}

/// The assemblies of a group.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// One.
    Single,
    /// Two, wherever it can be assembled: the index of the mode.
    Modes(usize),
    /// Those on the curve of its solutions: the index among the coupled groups.
    Coupled(usize),
}
