//! A straight-line program as a flat list of statements.

use linkage_symbolic::program::{Fused, Instruction, Program, RustCall, Source, Ternary, Value};
use proc_macro2::{Ident, Literal, Punct, Spacing, Span, TokenStream};
use quote::{ToTokens, format_ident, quote};

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

/// The statements of `program` over the scalar type `T`, where `__FUSED` says whether multiply-adds
/// are fused; `load` prints the expression that a number is loaded from.
pub(super) fn statements(
    program: &Program,
    runs: Runs,
    load: &dyn Fn(Source) -> TokenStream,
) -> TokenStream {
    let [all, _] = parts(program, runs, load, program.instructions.len());
    all
}

/// The [`statements`] of the first instructions, as many as `count`, and those of the others.
pub(super) fn parts(
    program: &Program,
    runs: Runs,
    load: &dyn Fn(Source) -> TokenStream,
    count: usize,
) -> [TokenStream; 2] {
    let read = read(program);
    let long = program.instructions.len() > LONG;
    let first = if long {
        declarations(program, &read)
    } else {
        TokenStream::new()
    };
    let mut parts = [first, TokenStream::new()];
    let keyword = if long {
        TokenStream::new()
    } else {
        quote!(let)
    };
    for (index, instruction) in program.instructions.iter().enumerate() {
        let value = Value(index);
        let expression = match *instruction {
            Instruction::Constant(x) => {
                let x = literal::float(x);
                quote!(T::from_f64(#x))
            }
            Instruction::Load(source) => load(source),
            Instruction::Unary(operation, x) => call(operation.row().call, runs, &[name(x)]),
            Instruction::Binary(operation, a, b) => {
                call(operation.row().call, runs, &[a, b].map(name))
            }
            Instruction::Ternary(Ternary::Select, s, a, b) if is_nan(program, b) => {
                let [s, a] = [s, a].map(name);
                quote!(T::unless_negative(#s, #a))
            }
            Instruction::Ternary(operation, a, b, c) => {
                call(operation.row().call, runs, &[a, b, c].map(name))
            }
            Instruction::Fused(operation, a, b, c) => {
                fused(operation, &name(a), &name(b), &name(c))
            }
            Instruction::SinCos(x) => sin_cos(runs, &name(x)),
            // Its pattern is part of the statement that computes it.
            Instruction::Second(_) => continue,
        };
        let pattern = pattern(program, value, &read);
        let part = usize::from(index >= count);
        parts[part].extend(quote!(#keyword #pattern = #expression;));
    }
    parts
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

/// The temporary of a value.
pub(super) fn name(value: Value) -> Ident {
    format_ident!("__v{}", value.0, span = Span::mixed_site())
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

/// The pattern that an instruction's result is bound to: sine and cosine come together, and a value
/// that nothing reads has no name.
fn pattern(program: &Program, value: Value, read: &[bool]) -> TokenStream {
    let first = name(value);
    if !matches!(program.instructions[value.0], Instruction::SinCos(_)) {
        return quote!(#first);
    }
    let behind = Value(value.0 + 1);
    let sine = if read[value.0] {
        quote!(#first)
    } else {
        quote!(_)
    };
    let cosine = match program.instructions.get(behind.0) {
        Some(Instruction::Second(_)) => name(behind).into_token_stream(),
        _ => quote!(_),
    };
    quote!((#sine, #cosine))
}

fn sin_cos(runs: Runs, x: &Ident) -> TokenStream {
    match runs {
        Runs::Once => quote!(T::sin_cos_with::<__FUSED>(#x)),
        Runs::InRows => quote!(T::sin_cos_in_rows::<__FUSED, __ROWS>(#x)),
        Runs::InRowsOrAlone => quote!(T::sin_cos_shortest::<__FUSED, __ROWS>(#x)),
    }
}

/// The code of an operation.
fn call(call: RustCall, runs: Runs, operands: &[Ident]) -> TokenStream {
    match call {
        RustCall::Operator(sign) => {
            let sign = Punct::new(sign, Spacing::Alone);
            match operands {
                [a, b] => quote!(#a #sign #b),
                _ => quote!(#sign #(#operands)*),
            }
        }
        RustCall::Method(name) => {
            let name = format_ident!("{name}");
            quote!(T::#name(#(#operands),*))
        }
        RustCall::FusedMethod(name) => {
            let name = format_ident!("{name}");
            quote!(T::#name::<__FUSED>(#(#operands),*))
        }
        // Programs are paired before they are printed; alone they are right all the same.
        RustCall::SinePair(number) => {
            let (pair, number) = (
                sin_cos(runs, &operands[0]),
                Literal::usize_unsuffixed(number),
            );
            quote!(#pair.#number)
        }
    }
}

fn fused(operation: Fused, a: &Ident, b: &Ident, c: &Ident) -> TokenStream {
    match operation {
        Fused::MulAdd => quote!(T::mul_add::<__FUSED>(#a, #b, #c)),
        Fused::MulSub => quote!(T::mul_add::<__FUSED>(#a, #b, -#c)),
        Fused::SubMul => quote!(T::mul_add::<__FUSED>(-#a, #b, #c)),
    }
}
