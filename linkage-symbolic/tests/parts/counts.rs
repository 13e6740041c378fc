//! What programs cost.

use linkage_symbolic::count::{Count, time};
use linkage_symbolic::program::{
    Binary, Fused, Instruction, Program, Source, Ternary, Unary, Value,
};

/// The operations, of two inputs and the constant 0.5.
fn program(operations: &[Instruction]) -> Program {
    let mut instructions = vec![
        Instruction::Load(Source::Input(0)),
        Instruction::Load(Source::Input(1)),
        Instruction::Constant(0.5),
    ];
    instructions.extend(operations);
    Program {
        instructions,
        outputs: vec![Value(0)],
    }
}

fn unary(op: Unary, a: usize) -> Instruction {
    Instruction::Unary(op, Value(a))
}

fn binary(op: Binary, a: usize, b: usize) -> Instruction {
    Instruction::Binary(op, Value(a), Value(b))
}

#[test]
fn each_operation_counts_in_its_class() {
    let cases = [
        (vec![], Count::default()),
        (
            vec![
                binary(Binary::Add, 0, 1),
                binary(Binary::Sub, 0, 1),
                binary(Binary::Sub, 1, 0),
            ],
            Count {
                add: 3,
                ..Count::default()
            },
        ),
        (
            vec![
                binary(Binary::Mul, 0, 1),
                binary(Binary::Mul, 0, 2),
                binary(Binary::Mul, 0, 0),
            ],
            Count {
                mul: 3,
                ..Count::default()
            },
        ),
        (
            vec![binary(Binary::Div, 0, 1), binary(Binary::Div, 1, 0)],
            Count {
                div: 2,
                ..Count::default()
            },
        ),
        (
            vec![
                unary(Unary::Sqrt, 0),
                binary(Binary::Hypot, 0, 1),
                Instruction::Ternary(Ternary::GuardedSqrt, Value(0), Value(1), Value(1)),
            ],
            Count {
                sqrt: 3,
                ..Count::default()
            },
        ),
        (
            vec![
                Instruction::SinCos(Value(0)),
                Instruction::Second(Value(3)),
                unary(Unary::Cos, 1),
            ],
            Count {
                sin_cos: 2,
                ..Count::default()
            },
        ),
        (
            vec![
                binary(Binary::Atan2, 0, 1),
                Instruction::Ternary(Ternary::AngleNear, Value(0), Value(1), Value(2)),
            ],
            Count {
                atan2: 2,
                ..Count::default()
            },
        ),
        (
            vec![
                unary(Unary::Abs, 0),
                binary(Binary::Min, 0, 1),
                unary(Unary::Acos, 0),
                Instruction::Ternary(Ternary::Select, Value(0), Value(1), Value(2)),
            ],
            Count {
                other: 4,
                ..Count::default()
            },
        ),
    ];
    for (operations, expected) in cases {
        assert_eq!(
            Count::of_program(&program(&operations)),
            expected,
            "{operations:?}"
        );
    }
}

/// A machine without multiply-adds computes equal products once.
#[test]
fn equal_products_count_once() {
    let fused = |a, b, c| Instruction::Fused(Fused::MulAdd, Value(a), Value(b), Value(c));
    let operations = [
        binary(Binary::Mul, 0, 1),
        binary(Binary::Mul, 1, 0),
        fused(0, 1, 2),
        fused(1, 0, 0),
        fused(0, 0, 1),
    ];
    let expected = Count {
        mul: 2,
        add: 3,
        ..Count::default()
    };
    assert_eq!(Count::of_program(&program(&operations)), expected);
}

#[test]
fn time_is_the_sum_over_instructions() {
    let add = binary(Binary::Add, 0, 1);
    assert_eq!(
        time(&program(&[])),
        0,
        "what is loaded was computed elsewhere"
    );
    assert_eq!(time(&program(&[add; 7])), 7, "an addition is the unit");
    let pair = [Instruction::SinCos(Value(0)), Instruction::Second(Value(3))];
    let sine = unary(Unary::Sin, 0);
    assert_eq!(
        time(&program(&pair)),
        time(&program(&[sine])),
        "the cosine comes with the sine"
    );
    let all = [add, sine, binary(Binary::Div, 0, 1), unary(Unary::Atan, 0)];
    let parts = all.map(|own| time(&program(&[own])));
    assert_eq!(time(&program(&all)), parts.iter().sum::<u32>());
    assert!(parts.is_sorted_by(|a, b| a != b) && parts[1] > parts[2] && parts[3] > parts[1]);
}
