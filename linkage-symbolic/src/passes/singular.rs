//! Quotients by the root of a discriminant have no value where the root is 0: NaN instead of an
//! infinity.
//!
//! A rate of a group is such a quotient. At a dead point it does not exist. At a change point its
//! limits are finite, but the dividend is 0 apart from rounding, and so would be the sign of an
//! infinity.

use crate::program::{Binary, Instruction, Program, Ternary, Unary, Value};

/// Marks each quotient whose divisor has a root of a discriminant as a factor.
pub fn mark(mut program: Program) -> Program {
    let of_root = factors(&program);
    for instruction in &mut program.instructions {
        if let Instruction::Binary(operation @ Binary::Div, _, divisor) = instruction
            && of_root[divisor.0]
        {
            *operation = Binary::Quotient;
        }
    }
    program
}

/// Returns true for each value that has a root of a discriminant as a factor.
fn factors(program: &Program) -> Vec<bool> {
    let mut of_root = Vec::with_capacity(program.instructions.len());
    for instruction in &program.instructions {
        let is = |x: Value| -> bool { of_root[x.0] };
        let has_root = match *instruction {
            Instruction::Ternary(Ternary::GuardedSqrt, ..) => true,
            Instruction::Unary(Unary::Neg | Unary::Abs, x) => is(x),
            Instruction::Binary(Binary::Mul, a, b) => is(a) || is(b),
            Instruction::Binary(Binary::Div, a, _) => is(a),
            _ => false,
        };
        of_root.push(has_root);
    }
    of_root
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interpret::run;
    use crate::program::Source;

    /// `x1 / (2 root(x0))`, `x1 / x0`
    fn quotients() -> Program {
        let mut program = Program::default();
        let [q, x] = [0, 1].map(|k| program.push(Instruction::Load(Source::Input(k))));
        let [one, two, slack] = [1.0, 2.0, 1e-15].map(|x| program.push(Instruction::Constant(x)));
        let root = program.push(Instruction::Ternary(Ternary::GuardedSqrt, q, slack, one));
        let divisor = program.push(Instruction::Binary(Binary::Mul, two, root));
        let rate = program.push(Instruction::Binary(Binary::Div, x, divisor));
        let plain = program.push(Instruction::Binary(Binary::Div, x, q));
        program.outputs = vec![rate, plain];
        program
    }

    #[test]
    fn a_quotient_by_a_root_that_is_zero_is_no_number() {
        let (written, marked) = (quotients(), mark(quotients()));
        assert_eq!(marked.mistake(), None);
        let at = |program: &Program, q: f64, x: f64| {
            run(program, |source| match source {
                Source::Input(0) => q,
                _ => x,
            })
        };
        for x in [1.0, -3.5, 0.0, -0.0, 1e100, f64::MIN_POSITIVE] {
            for q in [1.0, 0.3, 1e-300, 2e-16] {
                let [old, new] = [&written, &marked].map(|entry| at(entry, q, x));
                assert_eq!(old[0].to_bits(), new[0].to_bits(), "{x} {q}");
            }
            for q in [0.0, -1e-16] {
                assert!(at(&marked, q, x)[0].is_nan(), "{x} {q}");
            }
            // Other divisors are as they were.
            let [old, new] = [&written, &marked].map(|item| at(item, 0.0, x)[1]);
            assert!(old.to_bits() == new.to_bits() || old.is_nan() && new.is_nan());
        }
    }

    #[test]
    fn what_divides_by_no_root_stays() {
        let mut program = quotients();
        program.outputs.remove(0);
        let program = program.without_unused();
        assert_eq!(mark(program.clone()), program);
    }
}
