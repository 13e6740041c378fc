//! Tests that one function's code does not depend on other functions: neither on their existence
//! nor on their order.

use std::hash::{DefaultHasher, Hash, Hasher};

use linkage_symbolic::program::{Binary, Instruction, Source, Value};

use super::{ITEMS, PIN, RRR};
use crate::check;
use crate::ir::CompiledMechanism;

fn unit(items: &str, functions: &[&str]) -> CompiledMechanism {
    let functions: Vec<String> = functions
        .iter()
        .map(|name| format!("pub fn {name}"))
        .collect();
    let functions = functions.join("\n");
    let text = format!("pub struct M {{ {ITEMS} {items} }} impl M {{ {functions} }}");
    let checked = check(text.parse().expect("tokens"));
    let messages: Vec<&str> = checked
        .messages
        .iter()
        .map(|message| &*message.text)
        .collect();
    assert!(messages.is_empty(), "{messages:?}");
    checked.unit.expect("it resolves")
}

/// Returns a number for each slot that identifies its computation, independent of other slots.
fn slots(unit: &CompiledMechanism) -> Vec<u64> {
    let mut values: Vec<u64> = Vec::new();
    for instruction in &unit.prepare.instructions {
        let mut operands: Vec<u64> = instruction.operands().map(|x| values[x.0]).collect();
        match instruction {
            Instruction::Binary(Binary::Add | Binary::Mul, ..) => operands.sort_unstable(),
            Instruction::Fused(..) => operands[..2].sort_unstable(),
            _ => {}
        }
        let mut hasher = DefaultHasher::new();
        let operation = instruction.with_operands(|_| Value(0));
        (operation.to_string(), operands).hash(&mut hasher);
        values.push(hasher.finish());
    }
    let outputs = unit.prepare.outputs.iter();
    outputs.map(|x| values[x.0]).collect()
}

/// Returns a function's program, with the computations of slots instead of their numbers.
fn code(unit: &CompiledMechanism, function: usize) -> Vec<String> {
    let slots = slots(unit);
    let program = &unit.functions[function].called.program;
    let instructions = program.instructions.iter();
    let instructions = instructions.map(|instruction| match *instruction {
        Instruction::Load(Source::Prepared(slot)) => format!("slot {}", slots[slot]),
        _ => instruction.to_string(),
    });
    instructions
        .chain([format!("{:?}", program.outputs)])
        .collect()
}

#[track_caller]
fn expect_independence(items: &str, functions: &[&str]) {
    let together = unit(items, functions);
    let mut reversed = functions.to_vec();
    reversed.reverse();
    let reversed = unit(items, &reversed);
    for (index, text) in functions.iter().enumerate() {
        let alone = unit(items, &[text]);
        let expected = code(&alone, 0);
        let other = functions.len() - 1 - index;
        for (unit, index) in [(&together, index), (&reversed, other)] {
            assert_eq!(code(unit, index), expected, "{text}");
        }
    }
}

#[test]
fn motions_and_sensitivities() {
    expect_independence(
        &format!("{RRR} {PIN}"),
        &[
            "sensitive(phi) -> Sensitive { s: sensitivity(k), t: sensitivity(velocity(t)) }",
            "motion(phi) -> Motion { k, v: velocity(k), a: acceleration(k) }",
            "angles(phi) -> Angles { t, p }",
            "place(phi) -> Place { k }",
        ],
    );
}

#[test]
fn forces() {
    expect_independence(
        "param m = 120g; param n = 300g; param i = 40kg*mm^2;
         unknown t = -20deg; unknown x = 150mm;
         let q = polar(a, phi); let r = q + polar(b, t);
         loop r = polar(x, lift / 4) + (e, e);
         body crank = pin j1 on frame at (0mm, 0mm), turns phi, mass m at q / 2;
         body rod = pin j2 on crank at q, turns t, mass n at (q + r) / 2, inertia i;
         body slider = slide j4 on frame at r along dir(lift / 4), mass m at r + (0, e);
         pin j3 = rod on slider at r;",
        &[
            "guide(phi, omega, epsilon) -> Guide { f: reaction(j4) }",
            "drive(phi, omega, epsilon) -> Drive { t: torque(phi), r: reaction(j1) }",
            "by_mass(phi, omega, epsilon) -> ByMass { s: d(torque(phi), m, a) }",
            "place(phi) -> Place { r }",
        ],
    );
}

#[test]
fn coupled_groups() {
    expect_independence(
        "unknown t1 = 20deg; unknown t2 = 100deg; unknown t3 = 290deg; unknown u = 10deg;
         let k = polar(3 * e, phi) + polar(d / 2, t1);
         loop k + polar(c - 20mm, u) = (b, 0) + polar(d / 2, t2);
         loop k + polar(c - 20mm, u + 60deg) = (b / 2, d + 10mm) + polar(d / 2, t3);",
        &[
            "motion(phi) -> Motion { v: velocity(k) }",
            "place(phi) -> Place { u, k }",
        ],
    );
}
