//! Programs: their text, what is unused in them, their mistakes.

use linkage_symbolic::Binding;
use linkage_symbolic::interpret::{run, run_steps};
use linkage_symbolic::program::{
    Binary, Fused, Instruction, Program, Source, Ternary, Unary, Value,
};

fn binary(op: Binary, a: usize, b: usize) -> Instruction {
    Instruction::Binary(op, Value(a), Value(b))
}

/// Three loads, then operations; all of their values are results.
fn program(operations: &[Instruction]) -> Program {
    let mut instructions = vec![
        Instruction::Load(Source::Input(0)),
        Instruction::Load(Source::Parameter(4)),
        Instruction::Constant(-0.25),
    ];
    instructions.extend(operations);
    let outputs = (3..instructions.len()).map(Value).collect();
    Program {
        instructions,
        outputs,
    }
}

/// One of each kind, with operands in an order that is not the order of their places.
fn each_kind() -> Program {
    let fused = |op| Instruction::Fused(op, Value(2), Value(0), Value(1));
    program(&[
        Instruction::Unary(Unary::Sqrt, Value(1)),
        binary(Binary::Sub, 1, 0),
        binary(Binary::Div, 0, 2),
        binary(Binary::Atan2, 1, 0),
        Instruction::Ternary(Ternary::Select, Value(2), Value(0), Value(1)),
        Instruction::SinCos(Value(1)),
        Instruction::Second(Value(8)),
        fused(Fused::MulAdd),
        fused(Fused::MulSub),
        fused(Fused::SubMul),
    ])
}

#[test]
fn the_text_tells_operands_in_their_order() {
    let text = "\
v0 = input 0
v1 = parameter 4
v2 = -0.25
v3 = sqrt v1
v4 = v1 - v0
v5 = v0 / v2
v6 = atan2 v1 v0
v7 = select v2 v0 v1
v8 = sin_cos v1
v9 = second v8
v10 = v2 * v0 + v1
v11 = v2 * v0 - v1
v12 = v1 - v2 * v0
return v3 v4 v5 v6 v7 v8 v9 v10 v11 v12
";
    assert_eq!(each_kind().to_string(), text);
    assert_eq!(binary(Binary::Add, 7, 5).to_string(), "v7 + v5");
    assert_eq!(binary(Binary::Mul, 5, 7).to_string(), "v5 * v7");
}

#[test]
fn every_source_has_its_own_text_and_time() {
    let sources = [
        (Source::Parameter(1), "parameter 1", Binding::Parameter),
        (Source::Input(2), "input 2", Binding::Call),
        (Source::Mode(3), "mode 3", Binding::Parameter),
        (Source::Centre(4), "centre 4", Binding::Parameter),
        (Source::Winding(5, 6), "winding 5 6", Binding::Parameter),
        (Source::Prepared(7), "prepared 7", Binding::Parameter),
        (Source::Carried(8), "carried 8", Binding::Call),
        (Source::State(9, 10), "state 9 10", Binding::Call),
        (Source::Limit, "limit", Binding::Call),
    ];
    for (source, text, binding) in sources {
        assert_eq!(
            (source.to_string().as_str(), source.binding()),
            (text, binding)
        );
    }
}

#[test]
fn programs_run_as_their_text_reads() {
    let (x, p, k) = (0.6_f64, 1.7_f64, -0.25);
    let load = |source| if source == Source::Input(0) { x } else { p };
    let expected = [
        p.sqrt(),
        p - x,
        x / k,
        libm::atan2(p, x),
        p,
        libm::sin(p),
        libm::cos(p),
        k * x + p,
        k * x - p,
        p - k * x,
    ];
    assert_eq!(run(&each_kind(), load), expected);
    // Step by step, from values of which the last are to be forgotten.
    let mut steps = vec![x, p, k, f64::NAN];
    run_steps(&each_kind(), 3, 5, &mut steps, load);
    assert_eq!(steps, [x, p, k, expected[0], expected[1]]);
    run_steps(&each_kind(), 4, 13, &mut steps, load);
    assert_eq!(steps[3..], expected);
}

#[test]
fn values_are_known_when_their_operands_are() {
    let program = program(&[
        binary(Binary::Add, 1, 2),
        binary(Binary::Add, 1, 0),
        Instruction::Unary(Unary::Neg, Value(2)),
        binary(Binary::Mul, 3, 4),
    ]);
    let [constant, early, late] = [Binding::Constant, Binding::Parameter, Binding::Call];
    assert_eq!(
        program.bindings(),
        [late, early, constant, early, late, constant, late]
    );
}

#[test]
fn what_no_output_needs_is_dropped() {
    let mut written = each_kind();
    written.outputs = vec![Value(9), Value(4), Value(9)];
    let kept = written.clone().without_unused();
    let text = "\
v0 = input 0
v1 = parameter 4
v2 = v1 - v0
v3 = sin_cos v1
v4 = second v3
return v4 v2 v4
";
    assert_eq!(kept.to_string(), text);
    assert_eq!(each_kind().without_unused(), each_kind());
}

#[test]
fn mistakes_are_told() {
    assert_eq!(each_kind().mistake(), None);
    let late = |operation| program(&[operation]).mistake();
    let cases = [
        (
            late(binary(Binary::Add, 0, 4)),
            "v3 = v0 + v4 stands before v4",
        ),
        (
            late(binary(Binary::Sub, 3, 0)),
            "v3 = v3 - v0 stands before v3",
        ),
        (
            late(Instruction::Second(Value(2))),
            "v3 is no second result of v2 = -0.25",
        ),
        (
            program(&[
                Instruction::SinCos(Value(0)),
                binary(Binary::Add, 0, 1),
                Instruction::Second(Value(3)),
            ])
            .mistake(),
            "v5 is no second result of v3 = sin_cos v0",
        ),
        (
            Program {
                outputs: vec![Value(1), Value(3)],
                ..program(&[])
            }
            .mistake(),
            "there is no v3",
        ),
    ];
    for (found, expected) in cases {
        assert_eq!(found.as_deref(), Some(expected));
    }
}

/// Loads come with what uses them, a second result with the first; a multiply-add is no slower than its product.
#[test]
fn costs_are_those_of_the_operations() {
    let free = [Instruction::Load(Source::Limit), Instruction::Constant(3.0)];
    for own in free {
        assert_eq!(
            (own.latency(), own.size(), own.time(), own.class()),
            (0, 0, 0, None)
        );
    }
    let program = each_kind();
    let of = |k: usize| program.instructions[k];
    assert_eq!(of(3).latency(), Unary::Sqrt.row().latency);
    assert_eq!(of(5).latency(), Binary::Div.row().latency);
    assert_eq!(of(7).size(), Ternary::Select.row().size);
    assert_eq!(of(10).size(), Fused::MulAdd.row().size);
    let sine = Instruction::Unary(Unary::Sin, Value(0));
    assert_eq!(
        (of(8).latency(), of(8).time()),
        (sine.latency(), sine.time())
    );
    assert_eq!((of(9).latency(), of(9).time(), of(9).class()), (0, 0, None));
    assert_eq!(
        of(8).size() + of(9).size(),
        2 * sine.size(),
        "both are computed"
    );
    let slow = [3, 5, 6, 8].map(|k| of(k).latency() > of(4).latency());
    assert_eq!(
        slow, [true; 4],
        "roots, divisions and angles take longer than sums"
    );
    let large = [6, 8].map(|k| of(k).size() > 10 * of(4).size() && of(k).time() > of(5).time());
    assert_eq!(large, [true; 2], "functions are called");
}
