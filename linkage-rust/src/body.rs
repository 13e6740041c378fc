//! A straight-line program as a flat list of statements.

use linkage_symbolic::program::{Fused, Instruction, Program, RustCall, Source, Ternary, Value};

use super::code::put;
use super::literal;

/// The number of times that a program runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Runs {
    /// For one position.
    Once,
    /// For one position, or where `__ROWS` says so for many side by side.
    InRows,
    /// Like `InRows`, and nothing depends on the last bit of a sine.
    InRowsOrAlone,
}

/// Writes the expression that a number is loaded from.
pub(super) type Load<'a> = dyn Fn(Source, &mut String) + 'a;

/// The statements of `program` over the scalar type `T`, where `__FUSED` says whether multiply-adds
/// are fused.
pub(super) fn statements(program: &Program, runs: Runs, load: &Load) -> String {
    let [all, _] = parts(program, runs, load, program.instructions.len());
    all
}

/// The [`statements`] of the first instructions, as many as `count`, and those of the others.
pub(super) fn parts(program: &Program, runs: Runs, load: &Load, count: usize) -> [String; 2] {
    let long = program.instructions.len() > LONG;
    let writer = Writer::new(program, runs, load);
    let first = match long {
        true => writer.declarations(),
        false => String::new(),
    };
    let mut parts = [first, String::new()];
    for (index, instruction) in program.instructions.iter().enumerate() {
        // Its pattern is part of the statement that computes it.
        if matches!(instruction, Instruction::Second(_)) || !writer.bound[index] {
            continue;
        }
        let code = &mut parts[usize::from(index >= count)];
        if !long {
            code.push_str("let ");
        }
        writer.pattern(Value(index), code);
        code.push('=');
        writer.operation(instruction, code);
        code.push_str(";\n");
    }
    parts
}

/// Writes operations of a program.
struct Writer<'a> {
    program: &'a Program,
    runs: Runs,
    load: &'a Load<'a>,
    names: Vec<String>,
    /// The number of operands that each value is. A result has a name, too, and counts twice.
    uses: Vec<usize>,
    /// True for the values that have a name: the others are written where they are used.
    bound: Vec<bool>,
}

impl<'a> Writer<'a> {
    fn new(program: &'a Program, runs: Runs, load: &'a Load<'a>) -> Self {
        let values = 0..program.instructions.len();
        let uses = uses(program);
        let bound = bound(program, &uses);
        Self {
            program,
            runs,
            load,
            names: values.map(|k| name(Value(k))).collect(),
            uses,
            bound,
        }
    }

    /// Writes the pattern that an instruction's result is bound to: sine and cosine come together,
    /// and a value that nothing reads has no name.
    fn pattern(&self, value: Value, code: &mut String) {
        let first = &self.names[value.0];
        if !matches!(self.program.instructions[value.0], Instruction::SinCos(_)) {
            code.push_str(first);
            return;
        }
        let behind = value.0 + 1;
        code.push('(');
        code.push_str(match self.uses[value.0] {
            0 => "_",
            _ => first,
        });
        code.push(',');
        code.push_str(match self.program.instructions.get(behind) {
            Some(Instruction::Second(_)) => &self.names[behind],
            _ => "_",
        });
        code.push(')');
    }

    /// Writes a value as the operand of an operator.
    fn factor(&self, value: Value, code: &mut String) {
        let is_operator = match self.program.instructions[value.0] {
            Instruction::Unary(operation, _) => is_operator(operation.row().call),
            Instruction::Binary(operation, ..) => is_operator(operation.row().call),
            _ => false,
        };
        if is_operator && !self.bound[value.0] {
            code.push('(');
            self.operand(value, code);
            code.push(')');
        } else {
            self.operand(value, code);
        }
    }

    /// Writes a value as an operand.
    fn operand(&self, value: Value, code: &mut String) {
        match self.bound[value.0] {
            true => code.push_str(&self.names[value.0]),
            false => self.operation(&self.program.instructions[value.0], code),
        }
    }

    fn operation(&self, instruction: &Instruction, code: &mut String) {
        match *instruction {
            Instruction::Load(source) => (self.load)(source, code),
            Instruction::Constant(x) => {
                code.push_str("T::from_f64(");
                code.push_str(&literal::float_text(x));
                code.push(')');
            }
            Instruction::Unary(operation, x) => self.call(operation.row().call, &[x], code),
            Instruction::Binary(operation, a, b) => self.call(operation.row().call, &[a, b], code),
            Instruction::Ternary(Ternary::Select, s, a, b) if is_nan(self.program, b) => {
                code.push_str("T::unless_negative");
                self.operands(&[s, a], None, code);
            }
            Instruction::Ternary(operation, a, b, c) => {
                self.call(operation.row().call, &[a, b, c], code);
            }
            Instruction::Fused(operation, a, b, c) => {
                code.push_str("T::mul_add::<__FUSED>");
                let negative = match operation {
                    Fused::MulAdd => None,
                    Fused::MulSub => Some(2),
                    Fused::SubMul => Some(0),
                };
                self.operands(&[a, b, c], negative, code);
            }
            Instruction::SinCos(x) => self.sin_cos(x, code),
            Instruction::Second(_) => unreachable!("it has no statement"),
        }
    }

    /// Writes the code of an operation.
    fn call(&self, call: RustCall, operands: &[Value], code: &mut String) {
        match call {
            RustCall::Operator(sign) => {
                if let [a, _] = operands {
                    self.factor(*a, code);
                }
                code.push(sign);
                if let [.., last] = operands {
                    self.factor(*last, code);
                }
            }
            RustCall::Method(name) => {
                code.push_str("T::");
                code.push_str(name);
                self.operands(operands, None, code);
            }
            RustCall::FusedMethod(name) => {
                code.push_str("T::");
                code.push_str(name);
                code.push_str("::<__FUSED>");
                self.operands(operands, None, code);
            }
            // Programs are paired before they are printed; alone they are right all the same.
            RustCall::SinePair(number) => {
                self.sin_cos(operands[0], code);
                put(format_args!(".{number}"), code);
            }
        }
    }

    fn sin_cos(&self, x: Value, code: &mut String) {
        code.push_str(match self.runs {
            Runs::Once => "T::sin_cos_with::<__FUSED>",
            Runs::InRows => "T::sin_cos_in_rows::<__FUSED, __ROWS>",
            Runs::InRowsOrAlone => "T::sin_cos_shortest::<__FUSED, __ROWS>",
        });
        self.operands(&[x], None, code);
    }

    /// Writes operands in parentheses, one of them with a minus sign.
    fn operands(&self, operands: &[Value], negative: Option<usize>, code: &mut String) {
        let mut before = '(';
        for (index, operand) in operands.iter().enumerate() {
            code.push(before);
            before = ',';
            if negative == Some(index) {
                code.push('-');
                self.factor(*operand, code);
            } else {
                self.operand(*operand, code);
            }
        }
        code.push(')');
    }

    /// The declarations of all names.
    fn declarations(&self) -> String {
        let is_named = |k: &usize| {
            let is_sine = matches!(self.program.instructions[*k], Instruction::SinCos(_));
            self.bound[*k] && (self.uses[*k] > 0 || !is_sine)
        };
        let named = (0..self.names.len()).filter(is_named);
        let names: Vec<&str> = named.map(|k| &self.names[k][..]).collect();
        let together = names.chunks(TOGETHER);
        together
            .map(|names| format!("let ({},);", names.join(",")))
            .collect()
    }
}

fn is_operator(call: RustCall) -> bool {
    matches!(call, RustCall::Operator(_))
}

/// The most operations in an expression, one within the other.
const DEPTH: usize = 4;

/// Marks the values that have a name: those with several uses, and those at the depth limit.
fn bound(program: &Program, uses: &[usize]) -> Vec<bool> {
    let mut depths = vec![0; uses.len()];
    let instructions = program.instructions.iter().enumerate();
    let bound = instructions.map(|(index, instruction)| {
        let below = instruction.operands().map(|value| depths[value.0]);
        let depth = below.fold(0, usize::max);
        let (is_whole, depth) = match instruction {
            Instruction::Load(_) | Instruction::Constant(_) => (true, depth),
            Instruction::SinCos(_) | Instruction::Second(_) => (false, depth),
            _ => (depth < DEPTH, depth + 1),
        };
        let is_bound = uses[index] != 1 || !is_whole;
        let is_dropped = uses[index] == 0
            && matches!(instruction, Instruction::Load(_) | Instruction::Constant(_));
        depths[index] = if is_bound { 0 } else { depth };
        is_bound && !is_dropped
    });
    bound.collect()
}

/// Returns true if a value is always NaN.
fn is_nan(program: &Program, value: Value) -> bool {
    matches!(program.instructions[value.0], Instruction::Constant(x) if x.is_nan())
}

/// Every `let` opens a scope inside the one before, and a debug build of a few thousand nested
/// scopes overflows the stack of the code generator. Longer programs declare their temporaries
/// beforehand, many in one `let`.
const LONG: usize = 1000;

/// Temporaries in one declaration.
const TOGETHER: usize = 200;

/// The outputs as an array.
pub(super) fn outputs(program: &Program) -> String {
    array(&program.outputs)
}

/// The outputs in pairs, `[[cosine, sine], ...]`.
pub(super) fn pairs(program: &Program) -> String {
    let pairs: Vec<String> = program.outputs.chunks(2).map(array).collect();
    format!("[{}]", pairs.join(","))
}

/// Values as an array.
pub(super) fn array(values: &[Value]) -> String {
    let names: Vec<String> = values.iter().map(|value| name(*value)).collect();
    format!("[{}]", names.join(","))
}

/// Returns a call of a method for each number with its value. `method` is its code before the
/// parentheses.
pub(super) fn puts(method: &str, values: impl Iterator<Item = (usize, Value)>) -> String {
    let mut code = String::new();
    for (number, value) in values {
        put(
            format_args!("{method}({number},{});\n", name(value)),
            &mut code,
        );
    }
    code
}

/// The temporary of a value.
fn name(value: Value) -> String {
    format!("__v{}", value.0)
}

/// The number of operands that each value is, and two more for each result that it is.
fn uses(program: &Program) -> Vec<usize> {
    let mut uses = vec![0; program.instructions.len()];
    for instruction in &program.instructions {
        match *instruction {
            // A second result comes with the first and is not computed from it.
            Instruction::Second(_) => {}
            Instruction::Ternary(Ternary::Select, s, a, b) if is_nan(program, b) => {
                uses[s.0] += 1;
                uses[a.0] += 1;
            }
            _ => instruction.operands().for_each(|x| uses[x.0] += 1),
        }
    }
    program.outputs.iter().for_each(|x| uses[x.0] += 2);
    uses
}
