//! Results of a function over positions of its input.

use linkage_engine::{Assembly, Columns, Mechanism};
use linkage_report::Report;
use linkage_runtime::Input;

/// The results of a function at positions of the first input. `given` has its other arguments.
pub(crate) fn rows(
    mechanism: &Mechanism,
    assembly: &Assembly<'_>,
    function: &str,
    positions: &[f64],
    given: &[(&str, f64)],
) -> Columns {
    let index = mechanism.function(function).expect("a function");
    let slice = |name: &&str| match given.iter().find(|(own, _)| own == name) {
        Some((_, value)) => std::slice::from_ref(value),
        None if *name == mechanism.inputs()[0].name => positions,
        None => panic!("`{function}` takes `{name}`, too"),
    };
    let names = mechanism.headings()[index].arguments.iter();
    assembly.calls(index, &names.map(slice).collect::<Vec<_>>())
}

/// The lengths of a vector of the plane.
pub(crate) fn lengths(rows: &Columns, name: &str) -> Vec<f64> {
    let [x, y] = ["x", "y"].map(|axis| &rows[&format!("{name}.{axis}")[..]]);
    x.iter().zip(y).map(|(x, y)| x.hypot(*y)).collect()
}

/// Evenly spaced positions between two values of an input.
pub(crate) fn between(input: &Input, low: f64, high: f64, count: usize) -> Vec<f64> {
    let part = Input {
        range: Some((low, high)),
        ..*input
    };
    part.positions(count)
}

/// A report of one function over the range of the first input.
pub(crate) fn report(
    title: &str,
    mechanism: &Mechanism,
    assembly: &Assembly<'_>,
    function: &str,
    count: usize,
) -> Report {
    let input = &mechanism.inputs()[0];
    let positions = input.positions(count);
    let rows = rows(mechanism, assembly, function, &positions, &[]);
    Report::new(title, input, &positions)
        .dimensions_listed(mechanism.parameters(), assembly.dimensions())
        .table(&rows)
}
