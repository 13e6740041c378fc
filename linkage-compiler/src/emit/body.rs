//! A straight-line program as a flat list of statements.

use std::collections::BTreeMap;

use linkage_symbolic::program::{
    Binary, Fused, Instruction, Program, Source, Ternary, Unary, Value,
};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::literal;

/// The statements of `program` over the scalar type `T`, where `__FUSED` says whether multiply-adds are fused; `load`
/// prints where a number comes from.
pub(super) fn statements(program: &Program, load: &dyn Fn(Source) -> TokenStream) -> TokenStream {
    let pairs = sine_pairs(program);
    let long = program.instructions.len() > LONG;
    let mut out = if long {
        declarations(program)
    } else {
        TokenStream::new()
    };
    let keyword = if long {
        TokenStream::new()
    } else {
        quote!(let)
    };
    for (index, instruction) in program.instructions.iter().enumerate() {
        let statement = statement(Value(index), *instruction, &pairs, load);
        if !statement.is_empty() {
            out.extend([keyword.clone(), statement]);
        }
    }
    out
}

/// Every `let` opens a scope inside the one before, and a debug build of a few thousand nested scopes overflows the stack of
/// the code generator. Longer programs declare their temporaries beforehand, many in one `let`.
const LONG: usize = 1000;

/// Temporaries in one declaration.
const TOGETHER: usize = 200;

fn declarations(program: &Program) -> TokenStream {
    let names: Vec<Ident> = (0..program.instructions.len())
        .map(|k| name(Value(k)))
        .collect();
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

/// The temporary of a value.
pub(super) fn name(value: Value) -> Ident {
    format_ident!("__v{}", value.0, span = Span::mixed_site())
}

/// The first sine and the first cosine of an operand; the earlier of the two computes both.
#[derive(Clone, Copy, Default)]
struct SinePair {
    sine: Option<Value>,
    cosine: Option<Value>,
}

fn sine_pairs(program: &Program) -> BTreeMap<Value, SinePair> {
    let mut pairs: BTreeMap<Value, SinePair> = BTreeMap::new();
    for (index, instruction) in program.instructions.iter().enumerate() {
        match *instruction {
            Instruction::Unary(Unary::Sin, x) => {
                pairs.entry(x).or_default().sine.get_or_insert(Value(index));
            }
            Instruction::Unary(Unary::Cos, x) => {
                pairs
                    .entry(x)
                    .or_default()
                    .cosine
                    .get_or_insert(Value(index));
            }
            _ => {}
        }
    }
    pairs
}

/// `name = expression;`, without `let`.
fn statement(
    value: Value,
    instruction: Instruction,
    pairs: &BTreeMap<Value, SinePair>,
    load: &dyn Fn(Source) -> TokenStream,
) -> TokenStream {
    let result = name(value);
    let expression = match instruction {
        Instruction::Constant(x) => {
            let x = literal::float(x);
            quote!(T::from_f64(#x))
        }
        Instruction::Load(source) => load(source),
        Instruction::Unary(operation @ (Unary::Sin | Unary::Cos), x) => {
            return sine_statement(value, operation, x, pairs[&x]);
        }
        Instruction::Unary(operation, x) => unary(operation, &name(x)),
        Instruction::Binary(operation, a, b) => binary(operation, &name(a), &name(b)),
        Instruction::Ternary(operation, a, b, c) => {
            ternary(operation, &name(a), &name(b), &name(c))
        }
        Instruction::Fused(operation, a, b, c) => fused(operation, &name(a), &name(b), &name(c)),
    };
    quote!(#result = #expression;)
}

fn sine_statement(value: Value, operation: Unary, operand: Value, pair: SinePair) -> TokenStream {
    let first = [pair.sine, pair.cosine].into_iter().flatten().min();
    let own = if operation == Unary::Sin {
        pair.sine
    } else {
        pair.cosine
    };
    if first == Some(value) {
        let operand = name(operand);
        let pattern = |value: Option<Value>| {
            value.map_or_else(
                || quote!(_),
                |v| {
                    let name = name(v);
                    quote!(#name)
                },
            )
        };
        let (sine, cosine) = (pattern(pair.sine), pattern(pair.cosine));
        return quote!((#sine, #cosine) = T::sin_cos_with::<__FUSED>(#operand););
    }
    match own {
        Some(own) if own != value => {
            let (result, own) = (name(value), name(own));
            quote!(#result = #own;)
        }
        _ => TokenStream::new(),
    }
}

fn unary(operation: Unary, x: &Ident) -> TokenStream {
    match operation {
        Unary::Neg => quote!(-#x),
        Unary::Abs => quote!(T::abs(#x)),
        Unary::Sqrt => quote!(T::sqrt(#x)),
        Unary::Sin => quote!(T::sin_cos_with::<__FUSED>(#x).0),
        Unary::Cos => quote!(T::sin_cos_with::<__FUSED>(#x).1),
        Unary::Tan => quote!(T::tan(#x)),
        Unary::Asin => quote!(T::asin(#x)),
        Unary::Acos => quote!(T::acos(#x)),
        Unary::Atan => quote!(T::atan(#x)),
        Unary::Sign => quote!(T::sign(#x)),
        Unary::InverseScale => quote!(T::inverse_scale(#x)),
    }
}

fn binary(operation: Binary, a: &Ident, b: &Ident) -> TokenStream {
    match operation {
        Binary::Add => quote!(#a + #b),
        Binary::Sub => quote!(#a - #b),
        Binary::Mul => quote!(#a * #b),
        Binary::Div => quote!(#a / #b),
        Binary::Atan2 => quote!(T::atan2_with::<__FUSED>(#a, #b)),
        Binary::Hypot => quote!(T::hypot(#a, #b)),
        Binary::Min => quote!(T::min(#a, #b)),
        Binary::Max => quote!(T::max(#a, #b)),
        Binary::Root => quote!(T::root(#a, #b)),
    }
}

fn ternary(operation: Ternary, a: &Ident, b: &Ident, c: &Ident) -> TokenStream {
    match operation {
        Ternary::AngleNear => quote!(T::angle_near_with::<__FUSED>(#a, #b, #c)),
        Ternary::Select => quote!(T::select(#a, #b, #c)),
    }
}

fn fused(operation: Fused, a: &Ident, b: &Ident, c: &Ident) -> TokenStream {
    match operation {
        Fused::MulAdd => quote!(T::mul_add::<__FUSED>(#a, #b, #c)),
        Fused::MulSub => quote!(T::mul_add::<__FUSED>(#a, #b, -#c)),
        Fused::SubMul => quote!(T::mul_add::<__FUSED>(-#a, #b, #c)),
    }
}
