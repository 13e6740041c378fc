//! A straight-line program as a flat list of statements.

use std::collections::BTreeMap;

use linkage_symbolic::program::{Fused, Instruction, Program, RustCall, Source, Ternary, Value};
use proc_macro2::{Delimiter, Ident, Literal, Span, TokenStream, TokenTree};
use quote::{format_ident, quote};

use super::code::Code;
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
pub(super) type Load<'a> = dyn Fn(Source, &mut Code) + 'a;

/// The statements of `program` over the scalar type `T`, where `__FUSED` says whether multiply-adds
/// are fused.
pub(super) fn statements(program: &Program, runs: Runs, load: &Load) -> TokenStream {
    let [all, _] = parts(program, runs, load, program.instructions.len());
    all
}

/// The [`statements`] of the first instructions, as many as `count`, and those of the others.
pub(super) fn parts(program: &Program, runs: Runs, load: &Load, count: usize) -> [TokenStream; 2] {
    let read = read(program);
    let long = program.instructions.len() > LONG;
    let mut first = Code::default();
    if long {
        first.stream(declarations(program, &read));
    }
    let mut parts = [first, Code::default()];
    let mut writer = Writer::new(program, runs);
    for (index, instruction) in program.instructions.iter().enumerate() {
        // Its pattern is part of the statement that computes it.
        if matches!(instruction, Instruction::Second(_)) {
            continue;
        }
        let code = &mut parts[usize::from(index >= count)];
        if !long {
            code.word("let");
        }
        writer.pattern(Value(index), &read, code);
        code.sign('=');
        match *instruction {
            Instruction::Load(source) => load(source, code),
            _ => writer.operation(instruction, code),
        }
        code.sign(';');
    }
    parts.map(Code::into_stream)
}

/// Writes operations of a program. Statements are most of the generated code, and the macro runs
/// without optimisation: names and the beginnings of calls are made once.
struct Writer<'a> {
    program: &'a Program,
    runs: Runs,
    names: Vec<Ident>,
    /// The code of methods, before the parentheses.
    methods: BTreeMap<(&'static str, Constants), Vec<TokenTree>>,
}

/// The constants that a method takes.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Constants {
    None,
    Fused,
    FusedInRows,
}

impl<'a> Writer<'a> {
    fn new(program: &'a Program, runs: Runs) -> Self {
        let values = 0..program.instructions.len();
        Self {
            program,
            runs,
            names: values.map(|k| name(Value(k))).collect(),
            methods: BTreeMap::new(),
        }
    }

    /// Writes the pattern that an instruction's result is bound to: sine and cosine come together,
    /// and a value that nothing reads has no name.
    fn pattern(&self, value: Value, read: &[bool], code: &mut Code) {
        let first = &self.names[value.0];
        if !matches!(self.program.instructions[value.0], Instruction::SinCos(_)) {
            code.ident(first);
            return;
        }
        let behind = value.0 + 1;
        let mut pair = Code::default();
        match read[value.0] {
            true => pair.ident(first),
            false => pair.word("_"),
        }
        pair.sign(',');
        match self.program.instructions.get(behind) {
            Some(Instruction::Second(_)) => pair.ident(&self.names[behind]),
            _ => pair.word("_"),
        }
        code.group(Delimiter::Parenthesis, pair.into_stream());
    }

    fn operation(&mut self, instruction: &Instruction, code: &mut Code) {
        match *instruction {
            Instruction::Constant(x) => {
                self.method("from_f64", Constants::None, code);
                code.group(Delimiter::Parenthesis, literal::float(x));
            }
            Instruction::Unary(operation, x) => self.call(operation.row().call, &[x], code),
            Instruction::Binary(operation, a, b) => self.call(operation.row().call, &[a, b], code),
            Instruction::Ternary(Ternary::Select, s, a, b) if is_nan(self.program, b) => {
                self.method("unless_negative", Constants::None, code);
                self.operands(&[s, a], None, code);
            }
            Instruction::Ternary(operation, a, b, c) => {
                self.call(operation.row().call, &[a, b, c], code);
            }
            Instruction::Fused(operation, a, b, c) => {
                self.method("mul_add", Constants::Fused, code);
                let negative = match operation {
                    Fused::MulAdd => None,
                    Fused::MulSub => Some(2),
                    Fused::SubMul => Some(0),
                };
                self.operands(&[a, b, c], negative, code);
            }
            Instruction::SinCos(x) => self.sin_cos(x, code),
            Instruction::Load(_) | Instruction::Second(_) => {
                unreachable!("the caller has written it")
            }
        }
    }

    /// Writes the code of an operation.
    fn call(&mut self, call: RustCall, operands: &[Value], code: &mut Code) {
        match call {
            RustCall::Operator(sign) => {
                if let [a, _] = operands {
                    code.ident(&self.names[a.0]);
                }
                code.sign(sign);
                if let [.., last] = operands {
                    code.ident(&self.names[last.0]);
                }
            }
            RustCall::Method(name) => {
                self.method(name, Constants::None, code);
                self.operands(operands, None, code);
            }
            RustCall::FusedMethod(name) => {
                self.method(name, Constants::Fused, code);
                self.operands(operands, None, code);
            }
            // Programs are paired before they are printed; alone they are right all the same.
            RustCall::SinePair(number) => {
                self.sin_cos(operands[0], code);
                code.sign('.');
                code.tree(Literal::usize_unsuffixed(number).into());
            }
        }
    }

    fn sin_cos(&mut self, x: Value, code: &mut Code) {
        let (name, constants) = match self.runs {
            Runs::Once => ("sin_cos_with", Constants::Fused),
            Runs::InRows => ("sin_cos_in_rows", Constants::FusedInRows),
            Runs::InRowsOrAlone => ("sin_cos_shortest", Constants::FusedInRows),
        };
        self.method(name, constants, code);
        self.operands(&[x], None, code);
    }

    /// Writes a method, before the parentheses.
    fn method(&mut self, name: &'static str, constants: Constants, code: &mut Code) {
        let known = self.methods.entry((name, constants));
        code.trees(known.or_insert_with(|| {
            let name = format_ident!("{name}");
            let tokens = match constants {
                Constants::None => quote!(T::#name),
                Constants::Fused => quote!(T::#name::<__FUSED>),
                Constants::FusedInRows => quote!(T::#name::<__FUSED, __ROWS>),
            };
            tokens.into_iter().collect()
        }));
    }

    /// Writes operands in parentheses, one of them with a minus sign.
    fn operands(&self, operands: &[Value], negative: Option<usize>, code: &mut Code) {
        let mut list = Code::default();
        for (index, operand) in operands.iter().enumerate() {
            if index > 0 {
                list.sign(',');
            }
            if negative == Some(index) {
                list.sign('-');
            }
            list.ident(&self.names[operand.0]);
        }
        code.group(Delimiter::Parenthesis, list.into_stream());
    }
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

fn declarations(program: &Program, read: &[bool]) -> TokenStream {
    let is_bound =
        |k: &usize| read[*k] || !matches!(program.instructions[*k], Instruction::SinCos(_));
    let bound = (0..program.instructions.len()).filter(is_bound);
    let names: Vec<Ident> = bound.map(|k| name(Value(k))).collect();
    names
        .chunks(TOGETHER)
        .map(|names| quote!(let (#(#names,)*);))
        .collect()
}

/// The outputs as an array.
pub(super) fn outputs(program: &Program) -> TokenStream {
    let names = program.outputs.iter().map(|v| name(*v));
    quote!([#(#names),*])
}

/// The outputs in pairs, `[[cosine, sine], ...]`.
pub(super) fn pairs(program: &Program) -> TokenStream {
    let pairs = program.outputs.chunks(2).map(|pair| {
        let names = pair.iter().map(|v| name(*v));
        quote!([#(#names),*])
    });
    quote!([#(#pairs),*])
}

/// Returns a call of a method for each number with its value. `method` is its code before the
/// parentheses.
pub(super) fn puts(
    method: TokenStream,
    values: impl Iterator<Item = (usize, Value)>,
) -> TokenStream {
    let method = Code::from(method);
    let mut code = Code::default();
    for (number, value) in values {
        let mut operands = Code::default();
        operands.tree(literal::index(number).into());
        operands.sign(',');
        operands.ident(&name(value));
        code.code(&method);
        code.group(Delimiter::Parenthesis, operands.into_stream());
        code.sign(';');
    }
    code.into_stream()
}

/// The temporary of a value.
pub(super) fn name(value: Value) -> Ident {
    Ident::new(&format!("__v{}", value.0), Span::mixed_site())
}

/// Marks the values that something is computed from, or that are results.
fn read(program: &Program) -> Vec<bool> {
    let mut read = vec![false; program.instructions.len()];
    for instruction in &program.instructions {
        // A second result comes with the first and is not computed from it.
        if !matches!(instruction, Instruction::Second(_)) {
            instruction.operands().for_each(|x| read[x.0] = true);
        }
    }
    program.outputs.iter().for_each(|x| read[x.0] = true);
    read
}
