//! The runtime's figures, whose types count the parameters.

use linkage_analysis::tolerance::{Components, Tolerances};
use linkage_runtime::Parameter;

use crate::failure::Failure;

/// Effects of tolerances at one position.
pub(super) struct Figures {
    /// The longest error that is possible.
    pub(super) worst: f64,
    /// The root of the sum of squares.
    pub(super) statistical: f64,
    /// The length of each parameter's effect.
    pub(super) parts: Vec<f64>,
    /// All definitions, and the contribution of each parameter.
    pub(super) text: String,
}

/// The figures of a quantity, from the components of its derivative by each parameter.
///
/// # Errors
///
/// For more parameters than are counted here.
pub(super) fn figures(parameters: &[Parameter], values: &[Vec<f64>]) -> Result<Figures, Failure> {
    match values.first().map_or(1, Vec::len) {
        1 => sized::<1>(parameters, values),
        2 => sized::<2>(parameters, values),
        _ => sized::<3>(parameters, values),
    }
}

fn sized<const K: usize>(parameters: &[Parameter], values: &[Vec<f64>]) -> Result<Figures, Failure>
where
    [f64; K]: Components<K>,
{
    match parameters.len() {
        0..=8 => filled::<8, K>(parameters, values),
        9..=32 => filled::<32, K>(parameters, values),
        33..=128 => filled::<128, K>(parameters, values),
        129..=512 => filled::<512, K>(parameters, values),
        count => Err(Failure::Told(format!(
            "{count} dimensions, where this command analyses 512 at most; this is a limit of linkage"
        ))),
    }
}

/// Filled up with parameters that have neither a tolerance nor an effect: they change no figure,
/// and stand last.
fn filled<const N: usize, const K: usize>(
    parameters: &[Parameter],
    values: &[Vec<f64>],
) -> Result<Figures, Failure>
where
    [f64; K]: Components<K>,
{
    let nothing = Parameter {
        name: "",
        unit: "",
        nominal: 0.0,
        tolerance: 0.0,
    };
    let mut all = parameters.to_vec();
    all.resize(N, nothing);
    let mut sensitivities = [[0.0; K]; N];
    for (to, from) in sensitivities.iter_mut().zip(values) {
        to.copy_from_slice(from);
    }
    let tolerances = Tolerances::<N>::declared(&all);
    let tolerances = tolerances.map_err(|error| Failure::Told(error.to_string()))?;
    let effects = tolerances.effects(&sensitivities);
    let text = effects.to_string();
    let lines: Vec<&str> = text.lines().collect();
    let count = lines.len() - (N - parameters.len());
    Ok(Figures {
        worst: effects.worst_modulus(),
        statistical: effects.root_sum_square_modulus(),
        parts: effects.contributions()[..parameters.len()]
            .iter()
            .map(|part| part.modulus)
            .collect(),
        text: lines[..count].join("\n") + "\n",
    })
}
