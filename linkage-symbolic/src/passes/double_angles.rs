//! One sine pair for an angle and its double, such as a crank and one that is geared to half its
//! speed.

use std::collections::{BTreeMap, BTreeSet};

use crate::program::{Binary, Instruction, Program, Value};

/// Replaces the sine and cosine of an angle by `2 s c` and `1 - 2 s^2` where those of half the
/// angle are computed anyway. They are rounded twice more.
pub fn share(program: Program) -> Program {
    let halves = halves(&program);
    if halves.is_empty() {
        return program;
    }
    let mut builder = Builder {
        whole: &program,
        halves: &halves,
        program: Program::default(),
        copies: vec![None; program.instructions.len()],
        pairs: BTreeMap::new(),
    };
    for index in 0..program.instructions.len() {
        builder.copy(Value(index));
    }
    let outputs = program.outputs.iter().map(|&x| builder.copy(x));
    builder.program.outputs = outputs.collect();
    builder.program.without_unused()
}

/// The sign, `-1` or `+1`, and the half of each angle.
type Halves = BTreeMap<Value, (f64, Value)>;

/// The angles whose halves have a sine pair of their own; halves are not halved again.
fn halves(program: &Program) -> Halves {
    let mut angles: Vec<Value> = program
        .instructions
        .iter()
        .filter_map(|instruction| match *instruction {
            Instruction::SinCos(x) => Some(x),
            _ => None,
        })
        .collect();
    angles.sort_unstable();
    // `k` and `x` of `k x`.
    let multiple = |angle: Value| match program.instructions[angle.0] {
        Instruction::Binary(Binary::Mul, k, x) => match program.instructions[k.0] {
            Instruction::Constant(k) => Some((k, x)),
            _ => None,
        },
        _ => None,
    };
    // The first half of each angle, with its factor.
    let mut halved: BTreeMap<Value, (Value, f64)> = BTreeMap::new();
    for &half in &angles {
        if let Some((k, angle)) = multiple(half).filter(|(k, _)| k.abs() == 0.5) {
            halved.entry(angle).or_insert((half, k));
        }
    }
    let mut halves = Halves::new();
    for &angle in &angles {
        let by_half = halved.get(&angle).copied();
        let by_double = multiple(angle).filter(|(k, _)| k.abs() == 2.0);
        let by_double = by_double.filter(|(_, half)| angles.binary_search(half).is_ok());
        let by_double = by_double.map(|(k, half)| (half, k));
        let found = by_half.into_iter().chain(by_double);
        if let Some((half, k)) = found.min_by_key(|(half, _)| *half) {
            halves.insert(angle, (k.signum(), half));
        }
    }
    let doubles: BTreeSet<Value> = halves.keys().copied().collect();
    halves.retain(|_, (_, half)| !doubles.contains(half));
    halves
}

struct Builder<'a> {
    whole: &'a Program,
    halves: &'a Halves,
    program: Program,
    /// The new positions of the values of the whole program.
    copies: Vec<Option<Value>>,
    /// Sine and cosine of angles, by angle of the whole program.
    pairs: BTreeMap<Value, [Value; 2]>,
}

impl Builder<'_> {
    fn copy(&mut self, value: Value) -> Value {
        if let Some(copy) = self.copies[value.0] {
            return copy;
        }
        let copy = match self.whole.instructions[value.0] {
            Instruction::SinCos(angle) => self.pair(angle)[0],
            Instruction::Second(pair) => {
                let Instruction::SinCos(angle) = self.whole.instructions[pair.0] else {
                    unreachable!("nothing else has two results");
                };
                self.pair(angle)[1]
            }
            instruction => {
                let operands: Vec<Value> = instruction.operands().collect();
                operands.iter().for_each(|&x| {
                    self.copy(x);
                });
                let copies = &self.copies;
                let moved = instruction.with_operands(|x| copies[x.0].unwrap_or(x));
                self.program.push(moved)
            }
        };
        self.copies[value.0] = Some(copy);
        copy
    }

    /// Sine and cosine of an angle.
    fn pair(&mut self, angle: Value) -> [Value; 2] {
        if let Some(&pair) = self.pairs.get(&angle) {
            return pair;
        }
        let pair = match self.halves.get(&angle) {
            Some(&(sign, half)) => self.doubled(sign, half),
            None => {
                let operand = self.copy(angle);
                let sine = self.program.push(Instruction::SinCos(operand));
                [sine, self.program.push(Instruction::Second(sine))]
            }
        };
        self.pairs.insert(angle, pair);
        pair
    }

    /// Sine and cosine of the double of an angle, or of its opposite.
    fn doubled(&mut self, sign: f64, half: Value) -> [Value; 2] {
        let [sin, cos] = self.pair(half);
        let two = self.program.push(Instruction::Constant(2.0));
        let twice = self.times(two, sin);
        let signed = match sign < 0.0 {
            false => twice,
            true => {
                let minus = self.program.push(Instruction::Constant(-2.0));
                self.times(minus, sin)
            }
        };
        let sine = self.times(signed, cos);
        let square = self.times(twice, sin);
        let one = self.program.push(Instruction::Constant(1.0));
        let cosine = self
            .program
            .push(Instruction::Binary(Binary::Sub, one, square));
        [sine, cosine]
    }

    fn times(&mut self, a: Value, b: Value) -> Value {
        self.program.push(Instruction::Binary(Binary::Mul, a, b))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interpret::run;
    use crate::passes::sine_pairs::pair;
    use crate::program::{Source, Unary};

    /// Sines and cosines of `x` and of `k x`.
    fn program(k: f64) -> Program {
        let unary = |operation, x| Instruction::Unary(operation, Value(x));
        pair(Program {
            instructions: vec![
                Instruction::Load(Source::Input(0)),
                unary(Unary::Cos, 0),
                Instruction::Constant(k),
                Instruction::Binary(Binary::Mul, Value(2), Value(0)),
                unary(Unary::Sin, 3),
                unary(Unary::Cos, 3),
                unary(Unary::Sin, 0),
            ],
            outputs: [1, 4, 5, 6].map(Value).to_vec(),
        })
    }

    fn angles(program: &Program) -> usize {
        let is_pair = |angle: &&Instruction| matches!(angle, Instruction::SinCos(_));
        program.instructions.iter().filter(is_pair).count()
    }

    #[test]
    fn an_angle_and_its_double_share_a_pair() {
        for k in [0.5, -0.5, 2.0, -2.0] {
            let written = program(k);
            let shared = share(written.clone());
            assert_eq!(angles(&shared), 1, "{k}");
            for x in [0.3, -1.1, 2.9, 40.0] {
                let pairs = run(&written, |_| x).into_iter().zip(run(&shared, |_| x));
                for (expected, found) in pairs {
                    assert!((expected - found).abs() < 4.0 * f64::EPSILON, "{k} {x}");
                }
            }
        }
    }

    #[test]
    fn other_multiples_stay() {
        for k in [1.0, 3.0, -1.5] {
            assert_eq!(share(program(k)), program(k));
        }
    }
}
