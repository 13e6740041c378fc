//! The module is that of the text: every number of single calls and sweeps.

use linkage_engine::{Mechanism, Table};
use linkage_printed::slider_crank::SliderCrank;

const TEXT: &str = include_str!("../../../linkage-cli/src/templates/slider.mech");

#[test]
fn the_module_has_the_numbers_of_its_text() {
    let mechanism = Mechanism::compile(TEXT).expect("it has no mistake");
    let engine = mechanism
        .assemble(&mechanism.dimensions())
        .expect("it closes");
    let printed = SliderCrank::default().assemble().expect("it closes");
    assert_eq!(
        SliderCrank::STRUCTURE.to_string(),
        mechanism.structure().to_string()
    );
    let positions: Vec<f64> = (0..100).map(|k| 0.1 * f64::from(k)).collect();
    let stroke = mechanism.function("stroke").expect("a function");
    let (columns, expected) = (
        printed.stroke_sweep(&positions),
        engine.sweep(stroke, &[&positions]),
    );
    for (row, &phi) in positions.iter().enumerate() {
        let called = engine.call(stroke, &[phi]);
        assert_eq!(
            printed.stroke(phi).slide.to_bits(),
            called[0].to_bits(),
            "{phi}"
        );
        assert_eq!(
            columns.slide()[row].to_bits(),
            expected.column(0)[row].to_bits(),
            "{phi}"
        );
    }
}
