//! Results of a function over positions of its input.

use linkage_engine::{Assembly, Mechanism};
use linkage_report::Report;
use linkage_runtime::{Heading, Input, Table};

/// The results of a function, column by column.
pub(crate) struct Rows {
    heading: &'static Heading,
    columns: Vec<Vec<f64>>,
    count: usize,
}

impl Rows {
    /// Evaluates a function at positions of the first input. `given` has its other arguments.
    pub(crate) fn new(
        mechanism: &Mechanism,
        assembly: &Assembly<'_>,
        function: &str,
        positions: &[f64],
        given: &[(&str, f64)],
    ) -> Self {
        let mut headings = mechanism.headings().iter();
        let index = headings
            .position(|heading| heading.function == function)
            .unwrap_or_else(|| panic!("no function `{function}`"));
        let heading = mechanism.headings()[index];
        let mut columns = vec![Vec::with_capacity(positions.len()); heading.columns.len()];
        for &x in positions {
            let argument = |name: &&str| match given.iter().find(|(own, _)| own == name) {
                Some((_, value)) => *value,
                None if *name == mechanism.inputs()[0].name => x,
                None => panic!("`{function}` takes `{name}`, too"),
            };
            let arguments: Vec<f64> = heading.arguments.iter().map(argument).collect();
            for (column, number) in columns.iter_mut().zip(assembly.call(index, &arguments)) {
                column.push(number);
            }
        }
        Self {
            heading,
            columns,
            count: positions.len(),
        }
    }

    /// The values of a column.
    pub(crate) fn named(&self, name: &str) -> &[f64] {
        let mut columns = self.heading.columns.iter();
        let index = columns.position(|column| column.name == name);
        &self.columns[index.unwrap_or_else(|| panic!("no column `{name}`"))]
    }

    /// The lengths of a vector of the plane.
    pub(crate) fn lengths(&self, name: &str) -> Vec<f64> {
        let [x, y] = ["x", "y"].map(|axis| self.named(&format!("{name}.{axis}")));
        x.iter().zip(y).map(|(x, y)| x.hypot(*y)).collect()
    }
}

impl Table for Rows {
    fn heading(&self) -> &'static Heading {
        self.heading
    }

    fn rows(&self) -> usize {
        self.count
    }

    fn column(&self, index: usize) -> &[f64] {
        &self.columns[index]
    }
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
    let rows = Rows::new(mechanism, assembly, function, &positions, &[]);
    Report::new(title, input, &positions)
        .dimensions_listed(mechanism.parameters(), assembly.dimensions())
        .table(&rows)
}
