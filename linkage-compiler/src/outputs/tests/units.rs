//! Tests of masses: they are given in kilograms for every length unit, and the programs convert
//! them.

use linkage_symbolic::program::{Instruction, Source};

use crate::Oracle;
use crate::ir::{CompiledMechanism, Scalar};

const ITEMS: &str = "input phi = 40deg at omega; param m = 129.94g +- 5g; param c = 20mm; param n = -2kg +- 1N*s^2/mm;
    argument payload = 3kg; let speed = omega * c; let energy = m * speed * speed / 2;";

fn compiled(items: &str, functions: &str) -> (CompiledMechanism, Oracle) {
    let text = format!("pub struct M {{ {items} {ITEMS} }} impl M {{ {functions} }}");
    let (oracle, checked) = Oracle::new(text.parse().expect("tokens"));
    assert!(checked.messages.is_empty(), "{:?}", checked.messages);
    (checked.unit.expect("there is no mistake"), oracle)
}

#[test]
fn fields_are_what_was_written() {
    for unit in ["m", "mm", "cm", "um", "inch"] {
        let (compiled, _) = compiled(&format!("unit {unit};"), "");
        let scalars: Vec<&Scalar> = compiled.scalars().collect();
        let nominal = [0, 2].map(|k| scalars[k].nominal);
        assert_eq!(nominal, [0.12994, -2.0], "{unit}");
        assert_eq!(scalars[0].tolerance, 0.005, "{unit}");
        let off = scalars[2].tolerance / 1000.0 - 1.0;
        assert!(off.abs() < 1e-15, "{unit}: {off}");
    }
}

#[test]
fn results_are_in_their_units() {
    let functions = "fn f(omega, payload) -> F { e: energy, s: sensitivity(energy, [m, c]), p: payload, q: m + payload,
        r: d(energy, m) * m, t: 1N / payload,
        u: 0 * 1N*mm + energy }";
    let (unit, oracle) = compiled("unit mm;", functions);
    // 0.5 kg, 30 mm, 4 rad/s, 8 kg.
    let results = oracle.evaluate(0, |source| match source {
        Source::Parameter(index) => [0.5, 30.0, 2.0][index],
        Source::Input(index) => [0.0, 4.0, 8.0][index],
        _ => f64::NAN,
    });
    let square = 120.0 * 120.0;
    let by_length = 0.5 * (4.0 * 4.0) * 30.0 / 1000.0;
    let energy = 0.5 * square / 2.0 / 1000.0;
    let expected = [
        energy,
        square / 2.0 / 1000.0,
        by_length,
        8.0,
        8.5,
        energy,
        125.0,
        energy,
    ];
    for (result, expected) in results.iter().zip(expected) {
        assert!(
            (result / expected - 1.0).abs() < 1e-14,
            "{results:?} {expected}"
        );
    }
    assert_eq!(results.len(), expected.len());
    let fields = unit.functions[0].fields.iter();
    let units: Vec<&str> = fields.map(|field| field.unit.as_str()).collect();
    let expected = [
        "N*mm",
        "N*mm/kg and N*mm/mm",
        "kg",
        "kg",
        "N*mm",
        "mm/s^2",
        "N*mm",
    ];
    assert_eq!(units, expected);
}

#[test]
fn scales_cost_nothing_where_they_cancel() {
    let (unit, _) = compiled("unit mm;", "fn f(omega) -> F { a: d(2 * energy, m) }");
    let program = &unit.functions[0].called.program;
    let constants = program
        .instructions
        .iter()
        .filter(|instruction| matches!(instruction, Instruction::Constant(_)));
    assert_eq!(constants.count(), 0, "{:?}", program.instructions);
}
