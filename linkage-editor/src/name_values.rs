//! Values of names at the reference and over the range of the input, by a function that returns all
//! of them; their operations, by a function for each.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use linkage_engine::{Assembly, Mechanism};
use linkage_runtime::{Input, Table};

use crate::declaration::NameKind;
use crate::facts::{Fact, Facts};
use crate::probe::{Outcome, Request, Snapshot, compiled_with};

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
    /// The operations that compute unknowns and derived quantities, by name, as text.
    pub(crate) costs: BTreeMap<String, String>,
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

/// A quantity: the name it is of, and whether it is its estimate.
#[derive(Clone)]
struct Quantity {
    name: String,
    is_estimate: bool,
    /// True if its operations are counted.
    has_cost: bool,
    /// Its expression.
    text: String,
}

/// Computes the values of all mechanisms of a text, in the order of its facts; empty for one that
/// cannot be assembled.
pub(crate) fn values(snapshot: &Snapshot) -> Vec<Values> {
    let facts = snapshot.facts.iter();
    let mut all: Vec<Vec<Quantity>> = facts.map(|facts| quantities(snapshot, facts)).collect();
    for _ in 0..ATTEMPTS {
        let requests = all.iter().zip(&snapshot.facts);
        let requests = requests.map(|(quantities, facts)| request(quantities, facts));
        let (requests, owners): (Vec<_>, Vec<_>) = requests.unzip();
        let outcomes = compiled_with(snapshot, &requests);
        let mut is_complete = true;
        for ((quantities, owners), outcome) in all.iter_mut().zip(&owners).zip(&outcomes) {
            if let Outcome::Refused(expressions) = outcome {
                is_complete &= expressions.is_empty();
                let refused: Vec<usize> = expressions.iter().map(|&index| owners[index]).collect();
                let mut index = 0..;
                quantities.retain(|_| !refused.contains(&index.next().unwrap_or_default()));
            }
        }
        if is_complete {
            let found = outcomes.iter().zip(&all);
            return found
                .map(|(outcome, all)| found_values(outcome, all))
                .collect();
        }
    }
    vec![Values::default(); snapshot.facts.len()]
}

fn found_values(outcome: &Outcome, quantities: &[Quantity]) -> Values {
    match outcome {
        Outcome::Compiled(mechanism) => evaluated(mechanism, quantities).unwrap_or_default(),
        Outcome::Refused(_) => Values::default(),
    }
}

/// Returns a function of all quantities and one of each whose operations are counted, and the index
/// of the quantity to which each expression of them belongs.
fn request(quantities: &[Quantity], facts: &Facts) -> (Request, Vec<usize>) {
    let texts = quantities.iter().map(|quantity| quantity.text.clone());
    let mut functions = vec![texts.collect::<Vec<String>>()];
    let mut owners: Vec<usize> = (0..quantities.len()).collect();
    let costs = quantities.iter().enumerate();
    for (index, quantity) in costs.filter(|(_, quantity)| quantity.has_cost) {
        // Inputs cost nothing, and a function has to use each of its arguments.
        let expressions = std::iter::once(&quantity.name).chain(&facts.inputs);
        functions.push(expressions.cloned().collect());
        owners.resize(owners.len() + 1 + facts.inputs.len(), index);
    }
    let request = Request {
        mechanism: facts.mechanism.clone(),
        inputs: facts.inputs.clone(),
        functions,
    };
    (request, owners)
}

/// Returns the quantities of all names with a value, and those of the estimates.
fn quantities(Snapshot { text, outlines, .. }: &Snapshot, facts: &Facts) -> Vec<Quantity> {
    let mut outlines = outlines.iter();
    let outline = outlines.find(|outline| outline.mechanism.name == facts.mechanism);
    let declared = |name: &str| outline?.names.iter().find(|declared| declared.name == name);
    let computed = facts.names.iter().filter(|(_, fact)| fact.is_computed);
    let computed = computed.map(|(name, _)| Quantity {
        name: name.clone(),
        is_estimate: false,
        has_cost: declared(name).is_some_and(|declared| declared.kind.has_cost()),
        text: name.clone(),
    });
    let names = outline.iter().flat_map(|outline| &outline.names);
    let unknowns = names.filter(|name| name.kind == NameKind::Unknown);
    let estimates = unknowns.filter_map(|unknown| {
        let is_computed = |fact: &&Fact| fact.is_computed;
        facts.names.get(&unknown.name).filter(is_computed)?;
        Some(Quantity {
            name: unknown.name.clone(),
            is_estimate: true,
            has_cost: false,
            text: format!("({})", text.get(unknown.value.clone()?)?),
        })
    });
    computed.chain(estimates).collect()
}

/// Returns the values of the quantities of the first function, and the operations of the others.
fn evaluated(mechanism: &Mechanism, quantities: &[Quantity]) -> Option<Values> {
    let number = 0;
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
        costs: costs(mechanism, quantities),
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

/// Returns the operations of the functions after the first, by the names of their quantities.
fn costs(mechanism: &Mechanism, quantities: &[Quantity]) -> BTreeMap<String, String> {
    let functions = mechanism.structure().functions.iter().skip(1);
    let names = quantities.iter().filter(|quantity| quantity.has_cost);
    let costs = names.zip(functions);
    let costs = costs.filter(|(_, function)| function.operations.total() > 0);
    costs
        .map(|(quantity, function)| (quantity.name.clone(), function.operations.to_string()))
        .collect()
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
