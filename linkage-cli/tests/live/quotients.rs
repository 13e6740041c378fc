//! Derivatives of powers and quotients against differences of positions: of the command, and in the tables that a page computes for changed dimensions.

use linkage_corpus::given::written;
use linkage_corpus::quotients::{Precision, Quotients};

use crate::pages::Live;

#[test]
fn derivatives_are_differences() {
    let text = &written("tests/corpus/tests/corpus/quotients.rs")[0];
    let Some(mut live) = Live::text("quotients", text) else {
        return;
    };
    let all = Quotients::written();
    let calls = all.calls(Precision::DOUBLE);
    let of_command = calls.iter().map(|call| {
        let assembly = live.mechanism.assemble(&call.dimensions);
        let assembly = assembly.expect("it closes");
        assembly.call(0, &[call.degrees.to_radians()])
    });
    let of_command: Vec<Vec<f64>> = of_command.collect();
    all.check("command", Precision::DOUBLE, &of_command);

    // One table for each set of dimensions, with a row for each degree.
    let mut tables: Vec<(Vec<f64>, Vec<Vec<f64>>)> = Vec::new();
    let of_page = calls.iter().map(|call| {
        let known = |own: &(Vec<f64>, _)| own.0 == call.dimensions;
        let table = tables.iter().position(known).unwrap_or_else(|| {
            live.set(&call.dimensions);
            tables.push((call.dimensions.clone(), rows(&live.csv("motion"))));
            tables.len() - 1
        });
        let rows = &tables[table].1;
        assert_eq!(rows.len(), 361);
        rows[call.degrees as usize][1..].to_vec()
    });
    let of_page: Vec<Vec<f64>> = of_page.collect();
    all.check("page", Precision::DOUBLE, &of_page);
}

/// The numbers of a table.
fn rows(csv: &str) -> Vec<Vec<f64>> {
    let rows = csv.lines().skip(1);
    let numbers = |row: &str| {
        row.split(',')
            .map(|word| word.parse().expect("a number"))
            .collect()
    };
    rows.map(numbers).collect()
}
