//! Each operation alone, as everything that computes has it, and the operands that it is tried on.

use linkage::Scalar;
use linkage_random::Random;
use linkage_symbolic::program::{Binary, Fused, Ternary, Unary};

use crate::instruction::{binary, fused, ternary, unary};
use crate::numbers::SPECIAL;

/// An operation of any number of operands.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Operation {
    Unary(Unary),
    Binary(Binary),
    Ternary(Ternary),
    Fused(Fused),
}

impl Operation {
    /// All of all tables.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        let unary = Unary::ALL.iter().copied().map(Self::Unary);
        let binary = Binary::ALL.iter().copied().map(Self::Binary);
        let ternary = Ternary::ALL.iter().copied().map(Self::Ternary);
        let fused = Fused::ALL.iter().copied().map(Self::Fused);
        unary.chain(binary).chain(ternary).chain(fused)
    }

    /// How many operands it has.
    pub(crate) fn arity(self) -> usize {
        match self {
            Self::Unary(_) => 1,
            Self::Binary(_) => 2,
            Self::Ternary(_) | Self::Fused(_) => 3,
        }
    }

    /// As the printer has it, of three expressions.
    pub(crate) fn in_c(self, [a, b, c]: [&str; 3]) -> String {
        match self {
            Self::Unary(op) => unary(op, a),
            Self::Binary(op) => binary(op, a, b),
            Self::Ternary(op) => ternary(op, a, b, c),
            Self::Fused(op) => fused(op, a, b, c),
        }
    }

    /// As the interpreter has it.
    pub(crate) fn interpreted(self, [a, b, c]: [f64; 3]) -> f64 {
        match self {
            Self::Unary(op) => op.apply([a]),
            Self::Binary(op) => op.apply([a, b]),
            Self::Ternary(op) => op.apply([a, b, c]),
            Self::Fused(op) => op.apply([a, b, c]),
        }
    }

    /// As generated code has it where multiply-adds are not fused.
    pub(crate) fn in_rust(self, [a, b, c]: [f64; 3]) -> f64 {
        match self {
            Self::Unary(op) => match op {
                Unary::Neg => -a,
                Unary::Abs => Scalar::abs(a),
                Unary::Sqrt => Scalar::sqrt(a),
                Unary::Sin => a.sin_cos_with::<false>().0,
                Unary::Cos => a.sin_cos_with::<false>().1,
                Unary::Tan => Scalar::tan(a),
                Unary::Asin => Scalar::asin(a),
                Unary::Acos => Scalar::acos(a),
                Unary::Atan => Scalar::atan(a),
                Unary::Sign => Scalar::sign(a),
                Unary::InverseScale => a.inverse_scale(),
            },
            Self::Binary(op) => match op {
                Binary::Add => a + b,
                Binary::Sub => a - b,
                Binary::Mul => a * b,
                Binary::Div => a / b,
                Binary::Atan2 => a.atan2_with::<false>(b),
                Binary::Hypot => Scalar::hypot(a, b),
                Binary::Min => Scalar::min(a, b),
                Binary::Max => Scalar::max(a, b),
                Binary::Root => a.root(b),
            },
            Self::Ternary(op) => match op {
                Ternary::AngleNear => Scalar::angle_near_with::<false>(a, b, c),
                Ternary::Select => Scalar::select(a, b, c),
            },
            Self::Fused(op) => match op {
                Fused::MulAdd => Scalar::mul_add::<false>(a, b, c),
                Fused::MulSub => Scalar::mul_add::<false>(a, b, -c),
                Fused::SubMul => Scalar::mul_add::<false>(-a, b, c),
            },
        }
    }
}

/// How many random operands each operation is tried on.
const RANDOM: usize = 6000;

/// Operands of all kinds: every choice of special numbers, then random ones of any size, of like sizes, and small ones.
pub(crate) fn operands(operation: Operation) -> Vec<[f64; 3]> {
    let arity = operation.arity();
    let choices = SPECIAL.len().pow(arity as u32);
    let special = |choice: usize, place: usize| match place < arity {
        true => SPECIAL[choice / SPECIAL.len().pow(place as u32) % SPECIAL.len()],
        false => 0.0,
    };
    let special = (0..choices).map(|choice| [0, 1, 2].map(|place| special(choice, place)));
    let mut random = Random::new(arity as u64);
    let random = (0..RANDOM).map(|round| {
        let size = random.ratio(1e-3, 1e3);
        [0; 3].map(|_| match round % 3 {
            0 => f64::from_bits(random.bits()),
            1 => size * random.between(-1.0, 1.0),
            _ => random.between(-1.0, 1.0),
        })
    });
    special.chain(random).collect()
}
