//! Products that are added become multiply-adds, which machines with fused arithmetic do in one
//! step. Without it, equal products are one operation again: nothing is computed twice.

use crate::program::count::arrival_times;
use crate::program::{Binary, Fused, Instruction, Program, Unary, Value};

/// Replaces `a * b + c`, `a * b - c` and `c - a * b`, and removes the products that nobody uses any
/// more.
pub fn contract(mut program: Program) -> Program {
    let known = arrival_times(&program);
    let exact = compared_with_zero(&program);
    for (index, exact) in exact.into_iter().enumerate() {
        let stays = exact && is_of_two_products(&program, Value(index));
        if !stays && let Some(fused) = fuse(&program, &known, Value(index)) {
            program.instructions[index] = fused;
        }
    }
    program.without_unused()
}

/// Returns true for divisors and for operands of absolute values. A determinant of parallel
/// directions is 0 if both of its products are rounded, else it is the rounding error of one of
/// them. Squares have no difference to lose.
fn compared_with_zero(program: &Program) -> Vec<bool> {
    let mut exact = vec![false; program.instructions.len()];
    for instruction in &program.instructions {
        match *instruction {
            Instruction::Binary(Binary::Div, _, x) | Instruction::Unary(Unary::Abs, x) => {
                exact[x.0] = true;
            }
            _ => {}
        }
    }
    exact
}

/// Returns true if both operands are products that may cancel each other.
fn is_of_two_products(program: &Program, sum: Value) -> bool {
    let mut squares = 0;
    let products = program.instructions[sum.0].operands().all(|x| {
        let Instruction::Binary(Binary::Mul, a, b) = program.instructions[x.0] else {
            return false;
        };
        squares += usize::from(a == b);
        true
    });
    let is_sum = matches!(
        program.instructions[sum.0],
        Instruction::Binary(Binary::Add, ..)
    );
    products && !(is_sum && squares == 2)
}

/// The multiply-add for a sum or a difference. Of two products, the one that is known later is
/// fused: the other can be computed meanwhile.
fn fuse(program: &Program, known: &[u32], sum: Value) -> Option<Instruction> {
    let product = |value: Value| match program.instructions[value.0] {
        Instruction::Binary(Binary::Mul, x, y) => Some((x, y)),
        _ => None,
    };
    let Instruction::Binary(operation @ (Binary::Add | Binary::Sub), a, b) =
        program.instructions[sum.0]
    else {
        return None;
    };
    let first_is_later = known[a.0] > known[b.0];
    let fuses_first = product(a).is_some() && (product(b).is_none() || first_is_later);
    let (factors, term) = if fuses_first {
        (product(a), b)
    } else {
        (product(b), a)
    };
    let operation = match (operation, fuses_first) {
        (Binary::Add, _) => Fused::MulAdd,
        (_, true) => Fused::MulSub,
        (_, false) => Fused::SubMul,
    };
    factors.map(|(x, y)| Instruction::Fused(operation, x, y, term))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::Source;

    fn program(operations: &[Instruction], outputs: &[usize]) -> Program {
        let inputs = (0..4).map(|k| Instruction::Load(Source::Input(k)));
        Program {
            instructions: inputs.chain(operations.iter().copied()).collect(),
            outputs: outputs.iter().map(|&k| Value(k)).collect(),
        }
    }

    fn binary(operation: Binary, a: usize, b: usize) -> Instruction {
        Instruction::Binary(operation, Value(a), Value(b))
    }

    fn fused(operation: Fused, a: usize, b: usize, c: usize) -> Instruction {
        Instruction::Fused(operation, Value(a), Value(b), Value(c))
    }

    #[test]
    fn sums_and_differences_with_a_product_are_fused() {
        for (operation, swapped, expected) in [
            (Binary::Add, false, Fused::MulAdd),
            (Binary::Add, true, Fused::MulAdd),
            (Binary::Sub, false, Fused::MulSub),
            (Binary::Sub, true, Fused::SubMul),
        ] {
            let (a, b) = if swapped { (2, 4) } else { (4, 2) };
            let written = program(&[binary(Binary::Mul, 0, 1), binary(operation, a, b)], &[5]);
            let contracted = contract(written);
            assert_eq!(
                contracted.instructions[3..],
                [fused(expected, 0, 1, 2)],
                "{operation:?} {swapped}"
            );
        }
    }

    #[test]
    fn the_later_of_two_products_is_fused() {
        let operations = [
            binary(Binary::Mul, 0, 1),
            binary(Binary::Div, 2, 3),
            binary(Binary::Mul, 5, 0),
            binary(Binary::Sub, 4, 6),
        ];
        let contracted = contract(program(&operations, &[7]));
        assert_eq!(
            contracted.instructions.last(),
            Some(&fused(Fused::SubMul, 5, 0, 4))
        );
    }

    #[test]
    fn the_first_product_is_fused_if_it_is_later() {
        let operations = [
            binary(Binary::Div, 2, 3),
            binary(Binary::Mul, 4, 0),
            binary(Binary::Mul, 0, 1),
            binary(Binary::Sub, 5, 6),
        ];
        let contracted = contract(program(&operations, &[7]));
        let last = contracted.instructions.last();
        assert_eq!(last, Some(&fused(Fused::MulSub, 4, 0, 5)));
    }

    #[test]
    fn of_products_known_at_one_time_the_second_is_fused() {
        let operations = [
            binary(Binary::Mul, 0, 1),
            binary(Binary::Mul, 2, 3),
            binary(Binary::Sub, 4, 5),
        ];
        let contracted = contract(program(&operations, &[6]));
        let last = contracted.instructions.last();
        assert_eq!(last, Some(&fused(Fused::SubMul, 2, 3, 4)));
    }

    #[test]
    fn a_determinant_that_is_compared_with_zero_is_not_fused() {
        for last in [
            binary(Binary::Div, 0, 6),
            Instruction::Unary(Unary::Abs, Value(6)),
        ] {
            let operations = [
                binary(Binary::Mul, 0, 1),
                binary(Binary::Mul, 2, 3),
                binary(Binary::Sub, 4, 5),
                last,
            ];
            let written = program(&operations, &[7]);
            assert_eq!(contract(written.clone()), written);
        }
    }

    #[test]
    fn a_sum_of_squares_is_fused_a_difference_is_not() {
        for (last, fuses) in [(Binary::Add, true), (Binary::Sub, false)] {
            let operations = [
                binary(Binary::Mul, 0, 0),
                binary(Binary::Mul, 1, 1),
                binary(last, 4, 5),
                binary(Binary::Div, 2, 6),
            ];
            let contracted = contract(program(&operations, &[7]));
            let is_fused = |entry: &Instruction| matches!(entry, Instruction::Fused(..));
            assert_eq!(contracted.instructions.iter().any(is_fused), fuses);
        }
    }

    /// Its size is that of the sum, not of a rounding error.
    #[test]
    fn a_divisor_with_one_product_is_fused() {
        let operations = [
            binary(Binary::Mul, 0, 1),
            binary(Binary::Sub, 4, 2),
            binary(Binary::Div, 3, 5),
        ];
        let contracted = contract(program(&operations, &[6]));
        assert_eq!(contracted.instructions[4], fused(Fused::MulSub, 0, 1, 2));
    }

    #[test]
    fn a_product_that_is_asked_for_stays() {
        let operations = [binary(Binary::Mul, 0, 1), binary(Binary::Add, 4, 2)];
        let contracted = contract(program(&operations, &[4, 5]));
        assert_eq!(contracted.instructions[3], binary(Binary::Mul, 0, 1));
        assert_eq!(contracted.instructions[4], fused(Fused::MulAdd, 0, 1, 2));
    }
}
