//! What the search for circuits is told: the range of an input, and group by group which assemblies there are.

/// The range of an input whose assemblies are looked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cycle {
    /// Lower end of the range.
    pub low: f64,
    /// Upper end of the range.
    pub high: f64,
    /// Whether the input is an angle in radians. Over a full turn, assemblies that continue each other from one turn to the
    /// next belong to one circuit.
    pub angle: bool,
    /// At how many inputs the assemblies of coupled groups are listed, both ends included. A circuit that exists between two
    /// neighbouring inputs only is not found.
    pub samples: usize,
}

/// What assemblies of a group there are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// One.
    Single,
    /// Two, wherever it can be assembled: the index of the mode.
    Modes(usize),
    /// Those on the curve of its solutions: the index among the coupled groups.
    Coupled(usize),
}
