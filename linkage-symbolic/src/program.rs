//! Straight-line programs: what a sliced, scheduled graph becomes before it is printed as code.

use crate::graph::Binding;
use crate::operation::Class;
pub use crate::operation::{Binary, Fused, Ternary, Unary};

/// Where a program finds a number that it does not compute itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Source {
    /// A scalar parameter of the mechanism, by index.
    Parameter(usize),
    /// A driving coordinate, by index in the mechanism.
    Input(usize),
    /// The assembly mode of a group with two modes, by mode index: `+1` or `-1`.
    Mode(usize),
    /// The centre of a continuous angle, by index among the continuous angles.
    Centre(usize),
    /// How many turns a continuous angle makes for each turn of an input.
    Winding(usize, usize),
    /// A value computed once in `assemble()`, by slot.
    Prepared(usize),
    /// A value from the stage before, by index.
    Carried(usize),
    /// What is prepared of the solution of a coupled group near a position, by group (among the coupled ones) and
    /// component: an approximate state, then the least determinant that is certified.
    State(usize, usize),
    /// The largest correction of a prepared state that is certified.
    Limit,
}

impl Source {
    /// When a number is known.
    pub fn binding(self) -> Binding {
        match self {
            Self::Input(_) | Self::State(..) | Self::Limit | Self::Carried(_) => Binding::Call,
            Self::Parameter(_)
            | Self::Mode(_)
            | Self::Centre(_)
            | Self::Winding(..)
            | Self::Prepared(_) => Binding::Parameter,
        }
    }
}

/// The result of an earlier instruction, by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Value(pub usize);

/// One operation. Operands are results of earlier instructions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Instruction {
    /// A number.
    Constant(f64),
    /// A number from elsewhere.
    Load(Source),
    /// An operation of one operand.
    Unary(Unary, Value),
    /// An operation of two operands.
    Binary(Binary, Value, Value),
    /// An operation of three operands.
    Ternary(Ternary, Value, Value, Value),
    /// A product and a sum, rounded once or twice as the machine can.
    Fused(Fused, Value, Value, Value),
    /// Sine and cosine of an angle. Its value is the sine; the cosine is the [`Second`](Self::Second) result, right behind it.
    SinCos(Value),
    /// The second result of an instruction that has two.
    Second(Value),
}

impl Instruction {
    /// The values that it needs.
    pub fn operands(&self) -> impl Iterator<Item = Value> + use<> {
        let operands = match *self {
            Self::Constant(_) | Self::Load(_) => [None; 3],
            Self::Unary(_, a) | Self::SinCos(a) | Self::Second(a) => [Some(a), None, None],
            Self::Binary(_, a, b) => [Some(a), Some(b), None],
            Self::Ternary(_, a, b, c) | Self::Fused(_, a, b, c) => [Some(a), Some(b), Some(c)],
        };
        operands.into_iter().flatten()
    }

    /// In rough cycles: when its result is known after its operands.
    pub fn latency(&self) -> u32 {
        match self {
            Self::Constant(_) | Self::Load(_) => 0,
            Self::Unary(op, _) => op.row().latency,
            Self::Binary(op, ..) => op.row().latency,
            Self::Ternary(op, ..) => op.row().latency,
            Self::Fused(op, ..) => op.row().latency,
            Self::SinCos(_) => Unary::Sin.row().latency,
            Self::Second(_) => 0,
        }
    }

    /// In machine instructions, roughly; loads and constants come with what uses them.
    pub fn size(&self) -> u32 {
        match self {
            Self::Constant(_) | Self::Load(_) => 0,
            Self::Unary(op, _) => op.row().size,
            Self::Binary(op, ..) => op.row().size,
            Self::Ternary(op, ..) => op.row().size,
            Self::Fused(op, ..) => op.row().size,
            Self::SinCos(_) => Unary::Sin.row().size,
            Self::Second(_) => Unary::Cos.row().size,
        }
    }

    /// By throughput, an addition being 1; what is loaded was computed elsewhere.
    pub fn time(&self) -> u32 {
        match self {
            Self::Constant(_) | Self::Load(_) => 0,
            Self::Unary(op, _) => op.row().time,
            Self::Binary(op, ..) => op.row().time,
            Self::Ternary(op, ..) => op.row().time,
            Self::Fused(op, ..) => op.row().time,
            Self::SinCos(_) => Unary::Sin.row().time,
            Self::Second(_) => 0,
        }
    }

    /// As what it is counted; `None` for what costs nothing.
    pub fn class(&self) -> Option<Class> {
        Some(match self {
            Self::Constant(_) | Self::Load(_) | Self::Second(_) => return None,
            Self::Unary(op, _) => op.row().class,
            Self::Binary(op, ..) => op.row().class,
            Self::Ternary(op, ..) => op.row().class,
            Self::Fused(op, ..) => op.row().class,
            Self::SinCos(_) => Class::SineCosine,
        })
    }

    /// The same operation of other values.
    #[must_use]
    pub fn with_operands(self, other: impl Fn(Value) -> Value) -> Self {
        match self {
            Self::Constant(_) | Self::Load(_) => self,
            Self::Unary(operation, a) => Self::Unary(operation, other(a)),
            Self::Binary(operation, a, b) => Self::Binary(operation, other(a), other(b)),
            Self::Ternary(operation, a, b, c) => {
                Self::Ternary(operation, other(a), other(b), other(c))
            }
            Self::Fused(operation, a, b, c) => Self::Fused(operation, other(a), other(b), other(c)),
            Self::SinCos(a) => Self::SinCos(other(a)),
            Self::Second(a) => Self::Second(other(a)),
        }
    }
}

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

    /// Whether it compares an angle's direction with one that it does not compute: by a determinant, whose products are rounded one by one
    /// so that it is 0 where both are the same. With sines that are rounded in another way than those of what is prepared it would be 1e-16.
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

    /// What is wrong with the program; nothing if every pass kept to the rules: operands stand before their operations, outputs are
    /// there, a second result stands right behind what computes it.
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

    /// A sum or difference of products of sine or cosine of each of two angles with the factor that is prepared.
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
