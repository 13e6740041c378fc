//! Straight-line programs: a sliced, scheduled graph, before it is printed as code.

use super::instruction::{Instruction, Value};
use crate::graph::{Binding, Source};
use crate::operation::Binary;

/// A straight-line program: instructions in order of execution, results by index.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Program {
    /// Each computes one value, from those before it.
    pub instructions: Vec<Instruction>,
    /// The values that are results, in order.
    pub outputs: Vec<Value>,
}

impl Program {
    /// Appends an instruction; returns its value.
    pub fn push(&mut self, instruction: Instruction) -> Value {
        self.instructions.push(instruction);
        Value(self.instructions.len() - 1)
    }

    /// When each value is known.
    pub fn bindings(&self) -> Vec<Binding> {
        let mut bindings: Vec<Binding> = Vec::with_capacity(self.instructions.len());
        for instruction in &self.instructions {
            let binding = match instruction {
                Instruction::Load(source) => source.binding(),
                _ => {
                    let operands = instruction.operands().map(|x| bindings[x.0]);
                    operands.max().unwrap_or(Binding::Constant)
                }
            };
            bindings.push(binding);
        }
        bindings
    }

    /// Returns true if it compares an angle's direction with one that it does not compute, by a
    /// determinant. The products of a determinant are rounded one by one, so that it is 0 where
    /// both directions are equal. With sines that are rounded in another way than those of prepared
    /// values it would be 1e-16.
    pub fn compares_sines(&self) -> bool {
        let pair_of = |factor: Value| match self.instructions[factor.0] {
            Instruction::SinCos(_) => Some(factor),
            Instruction::Second(sine) => Some(sine),
            _ => None,
        };
        // The one factor of a product that is a sine or a cosine, and the pair that it is of.
        let sine = |product: Value| match self.instructions[product.0] {
            Instruction::Binary(Binary::Mul, a, b) => match [pair_of(a), pair_of(b)] {
                [Some(pair), None] => Some((a, pair)),
                [None, Some(pair)] => Some((b, pair)),
                _ => None,
            },
            _ => None,
        };
        self.instructions
            .iter()
            .any(|instruction| match *instruction {
                Instruction::Binary(Binary::Add | Binary::Sub, a, b) => {
                    matches!((sine(a), sine(b)), (Some((x, p)), Some((y, q))) if p == q && x != y)
                }
                _ => false,
            })
    }

    /// The program without values that no output depends on.
    #[must_use]
    pub fn without_unused(self) -> Self {
        let mut used = vec![false; self.instructions.len()];
        for output in &self.outputs {
            used[output.0] = true;
        }
        for (index, instruction) in self.instructions.iter().enumerate().rev() {
            if used[index] {
                instruction.operands().for_each(|x| used[x.0] = true);
            }
        }
        let mut places = Vec::with_capacity(used.len());
        let mut kept = Self::default();
        for (instruction, used) in self.instructions.into_iter().zip(used) {
            places.push(Value(kept.instructions.len()));
            if used {
                kept.push(instruction.with_operands(|x| places[x.0]));
            }
        }
        kept.outputs = self.outputs.iter().map(|x| places[x.0]).collect();
        kept
    }

    /// Returns the program that computes some of the outputs, by their numbers.
    #[must_use]
    pub fn part(&self, outputs: impl IntoIterator<Item = usize>) -> Self {
        let part = Self {
            instructions: self.instructions.clone(),
            outputs: outputs.into_iter().map(|k| self.outputs[k]).collect(),
        };
        part.without_unused()
    }

    /// Returns the prepared slots that the program loads, in the order of its instructions.
    pub fn prepared_slots(&self) -> impl Iterator<Item = usize> {
        let instructions = self.instructions.iter();
        instructions.filter_map(|instruction| match instruction {
            Instruction::Load(Source::Prepared(slot)) => Some(*slot),
            _ => None,
        })
    }

    /// Returns a mistake of the program, or nothing if every pass kept to the rules: operands
    /// precede their operations, outputs exist, and a second result is right after the instruction
    /// that computes it.
    pub fn mistake(&self) -> Option<String> {
        for (index, instruction) in self.instructions.iter().enumerate() {
            if let Some(late) = instruction.operands().find(|x| x.0 >= index) {
                return Some(format!(
                    "v{index} = {instruction} stands before v{}",
                    late.0
                ));
            }
            if let Instruction::Second(of) = instruction {
                let pair = self.instructions[of.0];
                if of.0 + 1 != index || !matches!(pair, Instruction::SinCos(_)) {
                    return Some(format!(
                        "v{index} is no second result of v{} = {pair}",
                        of.0
                    ));
                }
            }
        }
        let count = self.instructions.len();
        let missing = self.outputs.iter().find(|output| output.0 >= count)?;
        Some(format!("there is no v{}", missing.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::graph::Source;
    use crate::operation::Fused;

    /// A sum or difference of products of sine or cosine of each of two angles with the factor that
    /// is prepared.
    fn compares(operation: Binary, [first, second]: [usize; 2], fused: bool) -> bool {
        let mut program = Program::default();
        let factor = program.push(Instruction::Load(Source::Prepared(0)));
        let pairs = [0, 1].map(|input| {
            let angle = program.push(Instruction::Load(Source::Input(input)));
            let sine = program.push(Instruction::SinCos(angle));
            [sine, program.push(Instruction::Second(sine))]
        });
        let sines = pairs.concat();
        let mut product =
            |k: usize| program.push(Instruction::Binary(Binary::Mul, factor, sines[k]));
        let [a, b] = [first, second].map(&mut product);
        let last = match fused {
            true => Instruction::Fused(Fused::SubMul, factor, sines[first], b),
            false => Instruction::Binary(operation, a, b),
        };
        let last = program.push(last);
        program.outputs.push(last);
        program.compares_sines()
    }

    #[test]
    fn a_determinant_with_one_direction_of_its_own_compares_sines() {
        assert!(compares(Binary::Sub, [0, 1], false));
        assert!(compares(Binary::Add, [3, 2], false));
        // Of two angles, one twice, with what has been rounded already, no determinant.
        assert!(!compares(Binary::Sub, [0, 3], false));
        assert!(!compares(Binary::Sub, [1, 1], false));
        assert!(!compares(Binary::Sub, [0, 1], true));
        assert!(!compares(Binary::Div, [0, 1], false));
    }
}
