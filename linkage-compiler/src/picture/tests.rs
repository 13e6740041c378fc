//! Tests that pictures do not depend on the form in which a mechanism is written.

mod guides;
mod links;
mod parts;
mod refused;
use crate::ir::CompiledMechanism;
use crate::{Checked, check};

fn compile(items: &str, functions: &str) -> (CompiledMechanism, Vec<String>) {
    let text = format!("struct M {{ unit mm; {items} }} impl M {{ {functions} }}");
    let Checked { unit, messages, .. } = check(text.parse().expect("tokens"));
    let texts = messages.into_iter().map(|message| message.text).collect();
    (unit.unwrap_or_default(), texts)
}

#[track_caller]
fn expect(items: &str, call: &str, expected: &str) {
    let (unit, messages) = compile(items, &format!("fn look(phi) -> Look {{ shape: {call} }}"));
    assert!(messages.is_empty(), "{messages:?}");
    let picture = unit.picture.expect("a picture");
    let numbers = unit.functions[0].called.program.outputs.len();
    assert_eq!(
        numbers,
        picture.dimension * picture.vectors(),
        "\n{picture}"
    );
    let picture = picture.to_string();
    // Joints, gears and drives are those of `tests/drawings`.
    let lines = |text: &str| -> Vec<String> {
        let words = ["point", "link", "guide", "arc", "cylinder", "axis"];
        let told = |line: &&str| {
            words
                .iter()
                .any(|word| line.starts_with(&format!("{word} ")))
        };
        let lines = text.lines().map(str::trim).filter(told);
        lines.map(str::to_owned).collect()
    };
    assert_eq!(lines(&picture), lines(expected), "\n{picture}");
}

#[track_caller]
fn expect_message(items: &str, functions: &str, part: &str) {
    let (_, messages) = compile(items, functions);
    assert!(
        messages.len() == 1 && messages[0].contains(part),
        "{messages:?}"
    );
}

const FOUR_BAR: &str =
    "param crank = 50mm; param coupler = 120mm; param rocker = 100mm; param base = 140mm;
    input phi = 30deg in 0deg..360deg; unknown theta = 40deg; unknown psi = 80deg;";

const FOUR_BAR_PICTURE: &str = "
    point crank/frame: Ground
    point crank/coupler: Joint
    point coupler/rocker: Joint
    point rocker/frame: Ground
    link crank: crank/frame, crank/coupler
    link coupler: crank/coupler, coupler/rocker
    link rocker: rocker/frame, coupler/rocker";
