//! Numbers and words about the mechanism that emission prints, found by the earlier phases.

/// What emission needs beside the programs.
#[derive(Clone, Debug, Default)]
pub struct Facts {
    /// Default value of each scalar parameter, in the mechanism's unit.
    pub nominal: Vec<f64>,
    /// Tolerance of each scalar parameter; 0 where none is given.
    pub tolerance: Vec<f64>,
    pub inputs: Vec<InputFacts>,
    pub groups: Vec<GroupFacts>,
    pub mobility: usize,
    /// The length that counts like a radian where assemblies are compared with estimates.
    pub longest: f64,
}

#[derive(Clone, Debug)]
pub struct InputFacts {
    pub reference: f64,
    pub range: Option<(f64, f64)>,
    /// The range over which angles are followed, the reference twice if over none.
    pub followed: (f64, f64),
    /// Candidates for the turns that an unknown angle makes for each turn of this input.
    pub rates: Vec<f64>,
}

#[derive(Clone, Debug)]
pub struct GroupFacts {
    /// Class and order; 0 where the words do not apply (an angle relation).
    pub class: u8,
    pub order: u8,
    /// `RRR`, `RRP`, ...
    pub kind: String,
    /// Numbers of its loops, the first loop of the mechanism being 1.
    pub loops: Vec<usize>,
    pub unknowns: Vec<String>,
    /// Index among the assembly modes; `None` for a group with one solution.
    pub mode: Option<usize>,
    /// Whether its assemblies are listed and one is prepared.
    pub coupled: bool,
    /// The mode that the start estimates choose: true for `+1`.
    pub plus: bool,
    /// A sentence for `STRUCTURE`: which solution is used.
    pub method: &'static str,
    /// `mm`, `rad`: what the group's gap is measured in.
    pub gap_unit: String,
}
