//! Mechanisms within mechanisms: a part costs and gives what it does alone.

mod along;
mod costs;
mod frames;
mod places;
mod ten;

use linkage_compiler::ir::{CompiledMechanism, Coupled, PreparedTable};
use linkage_compiler::{Checked, check_all};
use linkage_core::Scalar;
use linkage_symbolic::interpret::run;
use linkage_symbolic::program::Source;

pub(super) fn checked(text: &str) -> Vec<Checked> {
    let all = check_all(text.parse().expect("tokens"));
    for own in &all {
        assert!(own.messages.is_empty(), "{:#?}", own.messages);
    }
    all
}

pub(super) fn unit<'c>(all: &'c [Checked], name: &str) -> &'c CompiledMechanism {
    let mut named = all.iter().filter(|own| own.name.as_deref() == Some(name));
    let unit = named.next().and_then(|own| own.unit.as_ref());
    unit.expect("a mechanism of that name without a mistake")
}

/// The results of a function, by its name; angles are those nearest to their estimates.
pub(super) fn results(
    unit: &CompiledMechanism,
    function: &str,
    dimensions: &[f64],
    inputs: &[f64],
) -> Vec<f64> {
    results_of(unit, function, dimensions, inputs, &[])
}

/// With arguments behind the inputs.
pub(super) fn results_of(
    unit: &CompiledMechanism,
    function: &str,
    dimensions: &[f64],
    inputs: &[f64],
    arguments: &[f64],
) -> Vec<f64> {
    let places = [inputs, arguments].concat();
    let modes = unit.modes();
    let states: Vec<Vec<f64>> = unit.coupled.iter().map(|own| state(own, inputs)).collect();
    let load = |source, prepared: &[f64]| match source {
        Source::Parameter(index) => dimensions[index],
        Source::Input(index) => places[index],
        Source::Mode(index) if modes[index] => 1.0,
        Source::Mode(_) => -1.0,
        Source::Prepared(slot) => prepared[slot],
        Source::Centre(angle) => unit.angles[angle].estimate,
        Source::Winding(..) => 0.0,
        Source::State(group, component) => states[group][component],
        Source::Limit => <f64 as Scalar>::CORRECTION_LIMIT,
        Source::Carried(_) => f64::NAN,
    };
    let prepared = run(&unit.prepare, |source| load(source, &[]));
    let results = run(&own(unit, function).called.program, |source| {
        load(source, &prepared)
    });
    assert!(
        results.iter().all(|x| x.is_finite()),
        "{function} at {inputs:?}: {results:?}"
    );
    results
}

/// What is prepared of a coupled group near some inputs, behind it the least determinant that is certified.
fn state(group: &Coupled, inputs: &[f64]) -> Vec<f64> {
    let mut numbers = vec![0.0; group.size];
    let own: Vec<f64> = group.inputs.iter().map(|&input| inputs[input]).collect();
    let floor = match group.start.as_ref().expect("it is closed") {
        PreparedTable::Table(table) => table.state(own[0], &mut numbers),
        PreparedTable::Grid(grid) => grid.state(&own, &mut numbers),
    };
    numbers.push(floor);
    numbers
}

fn own<'u>(unit: &'u CompiledMechanism, function: &str) -> &'u linkage_compiler::ir::Function {
    let mut functions = unit.functions.iter();
    let found = functions.find(|own| own.name == function);
    found.expect("a function of that name")
}

pub(super) fn defaults(unit: &CompiledMechanism) -> Vec<f64> {
    unit.scalars().map(|own| own.nominal).collect()
}
