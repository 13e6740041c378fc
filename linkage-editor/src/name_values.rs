//! Values of names at the reference and over the range of the input, by a function that returns all
//! of them.

use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::ops::Range;

use linkage_compiler::{Checked, check_all};
use linkage_engine::{Assembly, Mechanism, Source};
use linkage_runtime::{Input, Table};
use proc_macro2::extra::invalidate_current_thread_spans;

use crate::analysis::offset_of_text;
use crate::facts::Facts;
use crate::outline::{NameKind, Outline};

/// The number of positions in the range of an input at which values are computed.
const POSITIONS: usize = 91;

/// The number of times that names without a value are left out before giving up.
const ATTEMPTS: usize = 3;

/// The values of the names of a mechanism.
#[derive(Clone, Debug, Default)]
pub(crate) struct Values {
    /// By name.
    pub(crate) names: BTreeMap<String, Value>,
    /// The estimates of unknowns, by name.
    pub(crate) estimates: BTreeMap<String, Value>,
    /// The input whose range is passed through: name, unit, lower and upper end.
    pub(crate) range: Option<(String, String, f64, f64)>,
}

/// A value.
#[derive(Clone, Debug)]
pub(crate) struct Value {
    /// At the reference, a number for each component.
    pub(crate) reference: Vec<f64>,
    /// Smallest and largest number of each component over the range; empty without a range.
    pub(crate) extremes: Vec<(f64, f64)>,
    /// The unit of the numbers.
    pub(crate) unit: String,
}

/// A quantity of the function: the name it is of, and whether it is its estimate.
#[derive(Clone)]
struct Quantity {
    name: String,
    is_estimate: bool,
    /// Its expression.
    text: String,
}

/// Computes the values of a mechanism of a text; empty if it cannot be assembled.
pub(crate) fn values(text: &str, outlines: &[Outline], facts: &Facts) -> Values {
    let Some(outline) = outlines
        .iter()
        .find(|outline| outline.mechanism.name == facts.mechanism)
    else {
        return Values::default();
    };
    let mut quantities = quantities(text, outline, facts);
    for _ in 0..ATTEMPTS {
        let probe = Probe::new(text, outlines, facts, &quantities);
        match probe.compiled() {
            Outcome::Compiled(mechanism) => {
                return evaluated(&mechanism, &probe.function, &quantities).unwrap_or_default();
            }
            Outcome::Refused(refused) if refused.is_empty() => break,
            Outcome::Refused(refused) => {
                let mut index = 0..;
                quantities.retain(|_| !refused.contains(&index.next().unwrap_or_default()));
            }
        }
    }
    Values::default()
}

/// Returns the operations that compute a name, as text; `None` if it has no value.
pub(crate) fn cost(text: &str, outlines: &[Outline], facts: &Facts, name: &str) -> Option<String> {
    let inputs = facts.inputs.iter().filter(|input| *input != name);
    let quantity = |name: &String| Quantity {
        name: name.clone(),
        is_estimate: false,
        text: name.clone(),
    };
    // Inputs cost nothing, and a function has to use each of its arguments.
    let name = name.to_owned();
    let quantities: Vec<Quantity> = [&name].into_iter().chain(inputs).map(quantity).collect();
    let probe = Probe::new(text, outlines, facts, &quantities);
    let Outcome::Compiled(mechanism) = probe.compiled() else {
        return None;
    };
    let function = mechanism.function(&probe.function).ok()?;
    let operations = mechanism.structure().functions[function].operations;
    match operations.total() {
        0 => None,
        _ => Some(operations.to_string()),
    }
}

/// Returns the quantities of all names with a value, and those of the estimates.
fn quantities(text: &str, outline: &Outline, facts: &Facts) -> Vec<Quantity> {
    let computed = facts.names.iter().filter(|(_, fact)| fact.is_computed);
    let computed = computed.map(|(name, _)| Quantity {
        name: name.clone(),
        is_estimate: false,
        text: name.clone(),
    });
    let unknowns = outline
        .names
        .iter()
        .filter(|name| name.kind == NameKind::Unknown);
    let estimates = unknowns.filter_map(|unknown| {
        facts
            .names
            .get(&unknown.name)
            .filter(|fact| fact.is_computed)?;
        Some(Quantity {
            name: unknown.name.clone(),
            is_estimate: true,
            text: format!("({})", text.get(unknown.value.clone()?)?),
        })
    });
    computed.chain(estimates).collect()
}

/// A text with one more function, and without those of the user.
struct Probe {
    text: String,
    function: String,
    mechanism: String,
    /// The bytes of each quantity.
    places: Vec<Range<usize>>,
}

/// The result of compiling it.
enum Outcome {
    Compiled(Box<Mechanism>),
    /// The indices of quantities with a mistake.
    Refused(Vec<usize>),
}

impl Probe {
    fn new(text: &str, outlines: &[Outline], facts: &Facts, quantities: &[Quantity]) -> Self {
        let mut function = "values".to_owned();
        let mut result = "Values".to_owned();
        while text.contains(&function) || text.contains(&result) {
            function.push('_');
            result.push('V');
        }
        let mut probe = without_functions(text, outlines);
        let inputs = facts.inputs.join(", ");
        probe += &format!(
            "\nimpl {} {{ fn {function}({inputs}) -> {result} {{ ",
            facts.mechanism
        );
        let mut places = Vec::new();
        for (index, quantity) in quantities.iter().enumerate() {
            let start = probe.len();
            probe += &format!("q{index}: {}, ", quantity.text);
            places.push(start..probe.len());
        }
        probe += "} }";
        Self {
            text: probe,
            function,
            mechanism: facts.mechanism.clone(),
            places,
        }
    }

    fn compiled(&self) -> Outcome {
        let outcome = self.outcome();
        invalidate_current_thread_spans();
        outcome.unwrap_or(Outcome::Refused(Vec::new()))
    }

    fn outcome(&self) -> Option<Outcome> {
        let source = Source::new("values.mech", &self.text).ok()?;
        let call = source.calls().first()?;
        let checked = check_all(call.tokens.clone()).into_iter();
        let mut checked = checked.map(Checked::in_any_range);
        let found = checked.find(|checked| checked.name.as_ref() == Some(&self.mechanism))?;
        if let Some(mechanism) = Mechanism::new(&found) {
            return Some(Outcome::Compiled(Box::new(mechanism)));
        }
        let faults = found.messages.iter();
        let offset = offset_of_text(&self.text);
        let faults = faults.map(|message| message.span.first.byte_range().start + offset);
        let refused = faults.filter_map(|start| {
            self.places
                .iter()
                .position(|location| location.contains(&start))
        });
        Some(Outcome::Refused(refused.collect()))
    }
}

/// Returns the text with blanks instead of the functions, whose programs are not needed.
fn without_functions(text: &str, outlines: &[Outline]) -> String {
    let mut bytes = text.as_bytes().to_vec();
    for block in outlines.iter().flat_map(|outline| &outline.implementations) {
        bytes[block.clone()].fill(b' ');
    }
    // Blocks begin and end at brackets, so no character is cut.
    String::from_utf8(bytes).unwrap_or_default()
}

fn evaluated(mechanism: &Mechanism, function: &str, quantities: &[Quantity]) -> Option<Values> {
    let number = mechanism.function(function).ok()?;
    let assembly = mechanism.assemble(&mechanism.dimensions()).ok()?;
    let reference = assembly.call(number, &mechanism.reference());
    let range = match mechanism.inputs() {
        [input] => passed(input).map(|(low, high)| (input, low, high)),
        _ => None,
    };
    let columns = range.map(|(_, low, high)| course(&assembly, number, low, high));
    let mut values = Values {
        range: range
            .map(|(input, low, high)| (input.name.to_owned(), input.unit.to_owned(), low, high)),
        ..Values::default()
    };
    let heading = mechanism.headings()[number];
    let fields = &mechanism.compiled().functions[number].fields;
    let mut first = 0;
    for (quantity, field) in quantities.iter().zip(fields) {
        let numbers = first..first + field.shape.width();
        first = numbers.end;
        let unit = heading
            .columns
            .get(numbers.start)
            .map_or("", |column| column.unit);
        let value = Value {
            reference: reference.get(numbers.clone())?.to_vec(),
            extremes: match &columns {
                Some(columns) => columns.get(numbers)?.to_vec(),
                None => Vec::new(),
            },
            unit: unit.to_owned(),
        };
        let into = match quantity.is_estimate {
            true => &mut values.estimates,
            false => &mut values.names,
        };
        into.insert(quantity.name.clone(), value);
    }
    Some(values)
}

/// Returns the range of an input that is passed through: the declared one, or a turn.
fn passed(input: &Input) -> Option<(f64, f64)> {
    let turn = (input.unit == "rad").then_some((input.reference - PI, input.reference + PI));
    input.range.or(turn)
}

/// Returns the extremes of all columns over a range.
fn course(assembly: &Assembly<'_>, function: usize, low: f64, high: f64) -> Vec<(f64, f64)> {
    let position = |k: usize| low + (high - low) * k as f64 / (POSITIONS - 1) as f64;
    let positions: Vec<f64> = (0..POSITIONS).map(position).collect();
    let columns = assembly.sweep(function, &[&positions]);
    let extremes = |column: &[f64]| {
        let finite = column.iter().copied().filter(|x| !x.is_nan());
        let least = finite.clone().fold(f64::INFINITY, f64::min);
        (least, finite.fold(f64::NEG_INFINITY, f64::max))
    };
    let count = columns.heading().columns.len();
    (0..count)
        .map(|index| extremes(columns.column(index)))
        .collect()
}
