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
                    let mut latest = Binding::Constant;
                    for operand in instruction.operands() {
                        latest = latest.max(bindings[operand.0]);
                    }
                    latest
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
        let used = self.used(self.outputs.iter().copied());
        let mut places = Vec::with_capacity(used.len());
        let mut kept = Self::default();
        for (index, instruction) in self.instructions.iter().enumerate() {
            places.push(Value(kept.instructions.len()));
            if used[index] {
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

    /// Returns the program with the instructions for some outputs, by their numbers, before all
    /// others, and how many they are.
    #[must_use]
    pub fn beginning_with(&self, outputs: impl IntoIterator<Item = usize>) -> (Self, usize) {
        let mut used = self.used(outputs.into_iter().map(|k| self.outputs[k]));
        for (index, instruction) in self.instructions.iter().enumerate() {
            // A second result stays right after the first.
            if let Instruction::Second(first) = instruction {
                used[index] = used[first.0];
            }
        }
        let all = 0..used.len();
        let (first, rest): (Vec<usize>, Vec<usize>) = all.partition(|&index| used[index]);
        let mut places = vec![Value(0); used.len()];
        let mut ordered = Self::default();
        for &index in first.iter().chain(&rest) {
            let instruction = self.instructions[index].with_operands(|x| places[x.0]);
            places[index] = ordered.push(instruction);
        }
        ordered.outputs = self.outputs.iter().map(|x| places[x.0]).collect();
        (ordered, first.len())
    }

    /// Marks the values that some values depend on, with themselves.
    fn used(&self, values: impl IntoIterator<Item = Value>) -> Vec<bool> {
        let mut used = vec![false; self.instructions.len()];
        for value in values {
            used[value.0] = true;
        }
        for (index, instruction) in self.instructions.iter().enumerate().rev() {
            if used[index] {
                for operand in instruction.operands() {
                    used[operand.0] = true;
                }
            }
        }
        used
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
            for late in instruction.operands() {
                if late.0 >= index {
                    return Some(format!(
                        "v{index} = {instruction} stands before v{}",
                        late.0
                    ));
                }
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

    #[test]
    fn a_program_can_begin_with_some_outputs() {
        let mut program = Program::default();
        let slot = program.push(Instruction::Load(Source::Prepared(0)));
        let angle = program.push(Instruction::Load(Source::Input(0)));
        let sine = program.push(Instruction::SinCos(angle));
        let cosine = program.push(Instruction::Second(sine));
        let product = program.push(Instruction::Binary(Binary::Mul, slot, cosine));
        let sum = program.push(Instruction::Binary(Binary::Add, angle, sine));
        program.outputs = vec![product, sum, cosine];
        let (ordered, count) = program.beginning_with([1]);
        assert_eq!(count, 4);
        assert_eq!(ordered.mistake(), None);
        let instructions = &program.instructions;
        let operations = [1, 2, 3, 5, 0, 4].map(|k: usize| instructions[k].class());
        let found = ordered.instructions.iter().map(Instruction::class);
        assert_eq!(found.collect::<Vec<_>>(), operations);
        assert_eq!(ordered.part([1]), program.part([1]));
        // All outputs are still computed in the same way.
        assert_eq!(ordered.beginning_with([0, 1, 2]).1, 6);
        assert_eq!(ordered.beginning_with([]), (ordered.clone(), 0));
        assert_eq!(ordered.part([2]), program.part([2]));
    }
}
