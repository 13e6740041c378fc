//! Effects of tolerances on the results of a function.

use linkage_analysis::tolerance::{Components, Tolerances};
use linkage_compiler::ir::{Field, Meaning, Shape};
use linkage_runtime::Parameter;

use crate::error::ToleranceError;
use crate::mechanism::Mechanism;

/// A quantity of a function with its derivatives by parameters: a field of sensitivities, or one
/// number of each of its entries where these are no numbers or vectors.
#[derive(Clone, Debug, PartialEq)]
pub struct SensitiveQuantity {
    /// The field, with the number of a component where it has further indices.
    pub name: String,
    /// The parameters, by index.
    pub parameters: Vec<usize>,
    /// For each of them, the columns of the components in a row of the function.
    pub columns: Vec<Vec<usize>>,
    /// The number of further parameters that change nothing.
    pub idle: usize,
}

/// Effects of tolerances at one position.
#[derive(Clone, Debug, PartialEq)]
pub struct ToleranceEffects {
    /// The longest error that is possible.
    pub worst: f64,
    /// The root of the sum of squares.
    pub statistical: f64,
    /// The length of each parameter's effect.
    pub parts: Vec<f64>,
    /// All definitions, and the contribution of each parameter, line by line.
    pub text: String,
}

impl SensitiveQuantity {
    /// Leaves out the parameters that change nothing in any of these rows of the function, as those
    /// of the other parts of a machine. All of them stay if none changes anything.
    #[must_use]
    pub fn acting(mut self, rows: &[Vec<f64>]) -> Self {
        let acts = |columns: &Vec<usize>| {
            let mut numbers = rows
                .iter()
                .flat_map(|row| columns.iter().map(|&column| row[column]));
            numbers.any(|x| x != 0.0)
        };
        let acting: Vec<bool> = self.columns.iter().map(acts).collect();
        let count = acting.iter().filter(|acting| **acting).count();
        if count > 0 {
            self.idle = acting.len() - count;
            let mut flags = acting.iter();
            self.parameters.retain(|_| flags.next() == Some(&true));
            let mut flags = acting.iter();
            self.columns.retain(|_| flags.next() == Some(&true));
        }
        self
    }

    /// Returns the effects of the tolerances of a mechanism at the position of a row of the
    /// function.
    ///
    /// # Errors
    ///
    /// For tolerances that are negative or no numbers; for more than 512 parameters.
    pub fn effects(
        &self,
        mechanism: &Mechanism,
        row: &[f64],
    ) -> Result<ToleranceEffects, ToleranceError> {
        let parameters = self.parameters.iter();
        let parameters: Vec<Parameter> = parameters
            .map(|&index| mechanism.parameters()[index])
            .collect();
        let values = self.columns.iter();
        let values: Vec<Vec<f64>> = values
            .map(|columns| columns.iter().map(|&column| row[column]).collect())
            .collect();
        effects(&parameters, &values)
    }
}

/// The quantities of a function that have derivatives by parameters.
pub(crate) fn sensitive_quantities(
    mechanism: &Mechanism,
    function: usize,
) -> Vec<SensitiveQuantity> {
    let compiled = &mechanism.compiled.functions[function];
    let mut first = 0;
    let mut all = Vec::new();
    for field in &compiled.fields {
        let width = width(&field.shape);
        let columns = &compiled.columns[first..first + width];
        let parameters: Vec<usize> = columns
            .iter()
            .filter_map(|column| match column.meaning {
                Meaning::Sensitivity { parameter, .. } => Some(parameter),
                Meaning::Value | Meaning::Rate { .. } | Meaning::Margin | Meaning::Picture => None,
            })
            .collect();
        if parameters.len() == width && width > 0 {
            all.extend(quantities(field, &parameters, first));
        }
        first += width;
    }
    all
}

/// The quantities of a field whose columns are derivatives by these parameters.
fn quantities(field: &Field, parameters: &[usize], first: usize) -> Vec<SensitiveQuantity> {
    // A derivative by one parameter has no index.
    let (entries, entry) = match &field.shape {
        Shape::Array(count, entry) if parameters.windows(2).any(|pair| pair[0] != pair[1]) => {
            (*count, &**entry)
        }
        whole => (1, whole),
    };
    let inner = width(entry);
    let together = match entry {
        Shape::Scalar | Shape::Vector(_) => inner,
        Shape::Array(..) | Shape::Frame | Shape::PlaneFrame => 1,
    };
    let part = |start: usize| {
        let components = start..start + together;
        let columns = |entry: usize| {
            let components = components.clone();
            components.map(move |k| first + entry * inner + k).collect()
        };
        SensitiveQuantity {
            name: match together == inner {
                true => field.name.clone(),
                false => format!("{}, number {}", field.name, start + 1),
            },
            parameters: (0..entries)
                .map(|entry| parameters[entry * inner])
                .collect(),
            columns: (0..entries).map(columns).collect(),
            idle: 0,
        }
    };
    (0..inner).step_by(together).map(part).collect()
}

fn width(shape: &Shape) -> usize {
    match shape {
        Shape::Scalar => 1,
        Shape::Vector(count) => *count,
        Shape::Array(count, entry) => count * width(entry),
        Shape::Frame => 12,
        Shape::PlaneFrame => 6,
    }
}

/// The effects on a quantity, from the components of its derivative by each parameter.
///
/// # Errors
///
/// For more parameters than are counted here.
fn effects(
    parameters: &[Parameter],
    values: &[Vec<f64>],
) -> Result<ToleranceEffects, ToleranceError> {
    match values.first().map_or(1, Vec::len) {
        1 => sized::<1>(parameters, values),
        2 => sized::<2>(parameters, values),
        _ => sized::<3>(parameters, values),
    }
}

fn sized<const K: usize>(
    parameters: &[Parameter],
    values: &[Vec<f64>],
) -> Result<ToleranceEffects, ToleranceError>
where
    [f64; K]: Components<K>,
{
    match parameters.len() {
        0..=8 => filled::<8, K>(parameters, values),
        9..=32 => filled::<32, K>(parameters, values),
        33..=128 => filled::<128, K>(parameters, values),
        129..=512 => filled::<512, K>(parameters, values),
        count => Err(ToleranceError(format!(
            "{count} dimensions, where this command analyses 512 at most; this is a limit of linkage"
        ))),
    }
}

/// Returns the declared tolerances of `N` parameters: after those of the mechanism come others
/// without a tolerance, which change no figure.
///
/// # Errors
///
/// For tolerances that cannot be analysed.
pub(crate) fn filled_up<const N: usize>(
    parameters: &[Parameter],
) -> Result<Tolerances<N>, ToleranceError> {
    let nothing = Parameter {
        name: "",
        unit: "",
        nominal: 0.0,
        tolerance: 0.0,
    };
    let mut all = parameters.to_vec();
    all.resize(N, nothing);
    Tolerances::declared(&all).map_err(|error| ToleranceError(error.to_string()))
}

fn filled<const N: usize, const K: usize>(
    parameters: &[Parameter],
    values: &[Vec<f64>],
) -> Result<ToleranceEffects, ToleranceError>
where
    [f64; K]: Components<K>,
{
    let mut sensitivities = [[0.0; K]; N];
    for (to, from) in sensitivities.iter_mut().zip(values) {
        to.copy_from_slice(from);
    }
    let tolerances = filled_up::<N>(parameters)?;
    let effects = tolerances.effects(&sensitivities);
    let text = effects.to_string();
    let lines: Vec<&str> = text.lines().collect();
    let count = lines.len() - (N - parameters.len());
    Ok(ToleranceEffects {
        worst: effects.worst_modulus(),
        statistical: effects.root_sum_square_modulus(),
        parts: effects.contributions()[..parameters.len()]
            .iter()
            .map(|part| part.modulus)
            .collect(),
        text: lines[..count].join("\n") + "\n",
    })
}
