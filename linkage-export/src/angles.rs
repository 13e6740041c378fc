//! Tables of the continuous angles: the data from which their revolutions are found.

use linkage_compiler::ir::CompiledMechanism;

/// The angles of a mechanism as flat tables.
#[derive(Clone, Debug, PartialEq)]
pub struct AngleTables {
    /// The value of each angle at the reference inputs, about.
    pub estimates: Vec<f64>,
    /// The index of the first vector of each angle, then the number of all.
    pub first_phase: Vec<usize>,
    /// For each vector, the turns that it makes for a turn of each input; `None` if it turns with
    /// something else, too.
    pub phase_turns: Vec<Option<Vec<f64>>>,
    /// The index of the first followed input of each angle, then the number of all.
    pub first_along: Vec<usize>,
    /// The inputs along which the angles are followed.
    pub along: Vec<FollowedInput>,
    /// The candidates for rates, input by input.
    pub rates: Vec<f64>,
}

/// An input along which an angle is followed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FollowedInput {
    /// The index among the inputs.
    pub input: usize,
    /// The lower end of the range.
    pub low: f64,
    /// The upper end of the range.
    pub high: f64,
    /// The index of the first candidate among [`AngleTables::rates`].
    pub first_rate: usize,
    /// The number of candidates.
    pub rates: usize,
}

impl AngleTables {
    /// The tables of a mechanism.
    pub(crate) fn new(unit: &CompiledMechanism) -> Self {
        let angles = &unit.angles;
        let first_rate = |input: usize| -> usize {
            let before = unit.inputs[..input].iter();
            before.map(|other| other.rates.len()).sum()
        };
        let along = angles.iter().flat_map(|angle| &angle.inputs).map(|&input| {
            let (low, high) = unit.inputs[input].followed;
            FollowedInput {
                input,
                low,
                high,
                first_rate: first_rate(input),
                rates: unit.inputs[input].rates.len(),
            }
        });
        let phases = angles.iter().flat_map(|angle| &angle.phases);
        let rates = unit.inputs.iter().flat_map(|input| &input.rates);
        Self {
            estimates: angles.iter().map(|angle| angle.estimate).collect(),
            first_phase: firsts(angles.iter().map(|angle| angle.phases.len())),
            phase_turns: phases.map(|phase| phase.turns.clone()).collect(),
            first_along: firsts(angles.iter().map(|angle| angle.inputs.len())),
            along: along.collect(),
            rates: rates.copied().collect(),
        }
    }
}

/// Returns the index of the first entry of each angle, and the end of all.
fn firsts(counts: impl Iterator<Item = usize>) -> Vec<usize> {
    let mut firsts = vec![0];
    let mut end = 0;
    for count in counts {
        end += count;
        firsts.push(end);
    }
    firsts
}
