//! How many operations a program costs.

use linkage_symbolic::program::{Binary, Instruction, Program, Ternary, Unary, Value};
use proc_macro2::TokenStream;
use quote::quote;

use super::outline::Outline;

/// Operation counts, in the classes of the runtime's `Operations`. A multiply-add is a multiplication and an addition;
/// equal products count once.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Count {
    pub add: u32,
    pub mul: u32,
    pub div: u32,
    pub sqrt: u32,
    pub sin_cos: u32,
    pub atan2: u32,
    pub other: u32,
}

impl Count {
    pub(super) fn of(program: &Program) -> Self {
        let mut count = Self::default();
        let mut turned: Vec<Value> = Vec::new();
        let mut products: Vec<[Value; 2]> = Vec::new();
        for instruction in &program.instructions {
            match *instruction {
                Instruction::Constant(_) | Instruction::Load(_) => {}
                Instruction::Unary(Unary::Sin | Unary::Cos, operand) => turned.push(operand),
                Instruction::Unary(Unary::Sqrt, _) => count.sqrt += 1,
                Instruction::Unary(..) => count.other += 1,
                Instruction::Binary(Binary::Mul, a, b) => products.push([a.min(b), a.max(b)]),
                Instruction::Binary(operation, ..) => count.binary(operation),
                Instruction::Ternary(operation, ..) => count.ternary(operation),
                Instruction::Fused(_, a, b, _) => {
                    products.push([a.min(b), a.max(b)]);
                    count.add += 1;
                }
            }
        }
        count.sin_cos = distinct(turned);
        count.mul = distinct(products);
        count
    }

    fn binary(&mut self, operation: Binary) {
        let class = match operation {
            Binary::Add | Binary::Sub => &mut self.add,
            Binary::Mul => &mut self.mul,
            Binary::Div => &mut self.div,
            Binary::Hypot | Binary::Root => &mut self.sqrt,
            Binary::Atan2 => &mut self.atan2,
            Binary::Min | Binary::Max => &mut self.other,
        };
        *class += 1;
    }

    fn ternary(&mut self, operation: Ternary) {
        match operation {
            Ternary::AngleNear => self.atan2 += 1,
            Ternary::Select => self.other += 1,
        }
    }

    /// A literal of the runtime's `Operations`.
    pub(super) fn literal(&self, outline: &Outline) -> TokenStream {
        let runtime = &outline.runtime;
        let Self {
            add,
            mul,
            div,
            sqrt,
            sin_cos,
            atan2,
            other,
        } = *self;
        quote! {
            #runtime::Operations {
                add: #add, mul: #mul, div: #div, sqrt: #sqrt, sin_cos: #sin_cos, atan2: #atan2, other: #other,
            }
        }
    }

    /// `12 additions, 3 square roots`, or `none`.
    pub(super) fn words(&self) -> String {
        let classes = [
            (self.add, "addition", "additions"),
            (self.mul, "multiplication", "multiplications"),
            (self.div, "division", "divisions"),
            (self.sqrt, "square root", "square roots"),
            (self.sin_cos, "sine-cosine pair", "sine-cosine pairs"),
            (self.atan2, "arctangent", "arctangents"),
            (self.other, "other", "others"),
        ];
        let words: Vec<String> = classes
            .iter()
            .filter(|(n, ..)| *n > 0)
            .map(|(n, one, many)| format!("{n} {}", if *n == 1 { one } else { many }))
            .collect();
        if words.is_empty() {
            "none".to_owned()
        } else {
            words.join(", ")
        }
    }
}

fn distinct<V: Ord>(mut values: Vec<V>) -> u32 {
    values.sort_unstable();
    values.dedup();
    values.len() as u32
}
