//! The operations, each with one row of facts.
//!
//! Calls of `linkage_core::Scalar` in the compiler and the derivative in `differentiate` are
//! matches without a wildcard: an operation that is added here does not compile before they have
//! it. Tests require its function in C (`linkage-c`), in the engine of JavaScript and for
//! intervals. Rules of simplification are optional, except for those of symmetry, which follow from
//! the row.

mod row;
mod value;

use row::{ARC, arc, row, trigonometric};
pub use row::{Class, OperationRow, RustCall, Symmetry};
use value::{DEAD_POINT, WHOLE, angle_near, inverse_scale, one_of, root, select, sign};

/// A task on an operation, with code of its own for each.
pub trait Specialised<O> {
    /// Does it. Inlined always, with the operation as a constant.
    fn run(&mut self, operation: O);
}

/// An enumeration of operations with a row for each.
macro_rules! table {
    (
        $(#[$of_all:meta])*
        pub enum $Name:ident: $arity:literal {
            $($(#[$meta:meta])* $Variant:ident => $row:expr,)*
        }
    ) => {
        $(#[$of_all])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        pub enum $Name {
            $($(#[$meta])* $Variant,)*
        }

        impl $Name {
            /// All of them, in the order of the table.
            pub const ALL: &[Self] = &[$(Self::$Variant),*];

            /// Its result on numbers.
            // Inlined: a call of the function by its address takes longer than most operations.
            #[inline]
            pub fn apply(self, operands: [f64; $arity]) -> f64 {
                match self {
                    $(Self::$Variant => (const { $row }.value)(operands),)*
                }
            }

            /// Runs a task with the operation as a constant: the code of the task stands once for
            /// each operation, without a choice within it.
            #[inline(always)]
            pub fn specialised(self, task: &mut impl Specialised<Self>) {
                match self {
                    $(Self::$Variant => task.run(Self::$Variant),)*
                }
            }

            /// Returns its row in the table.
            pub fn row(self) -> &'static OperationRow<$arity> {
                match self {
                    $(Self::$Variant => const { &$row },)*
                }
            }
        }
    };
}

table! {
    /// Operations of one operand.
    pub enum Unary: 1 {
        /// `-a`
        Neg => OperationRow { call: RustCall::Operator('-'), latency: 1, ..row("neg", |[a]| -a) },
        /// `|a|`
        Abs => OperationRow { latency: 1, splits: true, never_negative: true, ..row("abs", |[a]| a.abs()) },
        /// The square root.
        Sqrt => OperationRow {
            latency: 20,
            time: 6,
            class: Class::Root,
            never_negative: true,
            partial: true,
            ..row("sqrt", |[a]| a.sqrt())
        },
        /// The sine. That and the cosine of one operand are computed together.
        Sin => OperationRow {
            class: Class::SineCosine,
            symmetry: Symmetry::Odd,
            call: RustCall::SinePair(0),
            ..trigonometric("sin", |[a]| libm::sin(a))
        },
        /// The cosine.
        Cos => OperationRow {
            class: Class::SineCosine,
            symmetry: Symmetry::Even,
            call: RustCall::SinePair(1),
            ..trigonometric("cos", |[a]| libm::cos(a))
        },
        /// The tangent.
        Tan => OperationRow {
            time: ARC,
            size: 50,
            partial: true,
            symmetry: Symmetry::Odd,
            ..trigonometric("tan", |[a]| a.tan())
        },
        /// The arc sine.
        Asin => OperationRow {
            splits: true,
            partial: true,
            symmetry: Symmetry::Odd,
            ..arc("asin", |[a]| a.asin())
        },
        /// The arc cosine.
        Acos => OperationRow { splits: true, partial: true, ..arc("acos", |[a]| a.acos()) },
        /// The arc tangent.
        Atan => OperationRow { symmetry: Symmetry::Odd, splits: true, ..arc("atan", |[a]| a.atan()) },
        /// `+1` for a number that is positive or `+0`, `-1` for a negative one: the derivative of
        /// `Abs`.
        Sign => OperationRow { latency: 20, splits: true, ..row("sign", |[a]| sign(a)) },
        /// The nearest whole number, of two the even one; right up to `2^51`.
        Round => OperationRow {
            latency: 8,
            size: 2,
            splits: true,
            ..row("whole", |[a]| (a + WHOLE) - WHOLE)
        },
        /// `slack(x)`: the most by which rounding turns a value negative that was computed from
        /// terms of the size `x`. That is 8 roundoffs of it, of the numbers that a program runs on,
        /// and therefore no constant. NaN where `x` is infinite.
        Slack => OperationRow {
            size: 2,
            splits: true,
            never_negative: true,
            ..row("slack", |[x]| DEAD_POINT * x.abs() + 0.0 * x)
        },
        /// A power of two near `1/|x|` (1 for 0 and non-finite numbers): scales lengths without
        /// rounding.
        InverseScale => OperationRow {
            latency: 20,
            size: 6,
            never_negative: true,
            ..row("inverse_scale", |[a]| inverse_scale(a))
        },
    }
}

table! {
    /// Operations of two operands.
    pub enum Binary: 2 {
        /// `a + b`
        Add => OperationRow {
            class: Class::Addition,
            call: RustCall::Operator('+'),
            ..row("+", |[a, b]| a + b)
        },
        /// `a - b`
        Sub => OperationRow {
            class: Class::Addition,
            call: RustCall::Operator('-'),
            ..row("-", |[a, b]| a - b)
        },
        /// `a * b`
        Mul => OperationRow {
            class: Class::Multiplication,
            call: RustCall::Operator('*'),
            ..row("*", |[a, b]| a * b)
        },
        /// `a / b`
        Div => OperationRow {
            latency: 15,
            time: 5,
            class: Class::Division,
            partial: true,
            call: RustCall::Operator('/'),
            ..row("/", |[a, b]| a / b)
        },
        /// `a / b`, NaN where that is infinite: a quotient by the root of a discriminant, or by a
        /// number that vanishes where the quotient has no meaning.
        Quotient => OperationRow {
            latency: 19,
            time: 6,
            size: 2,
            class: Class::Division,
            partial: true,
            call: RustCall::FusedMethod("quotient_with"),
            ..row("quotient", |[a, b]| a / b + 0.0 * (a / b))
        },
        /// `atan2(y, x)`
        Atan2 => OperationRow {
            latency: 15,
            class: Class::ArcTangent,
            splits: true,
            call: RustCall::FusedMethod("atan2_with"),
            ..arc("atan2", |[y, x]| libm::atan2(y, x))
        },
        /// `sqrt(x^2 + y^2)` without overflow.
        Hypot => OperationRow {
            latency: 15,
            time: 6,
            size: 20,
            class: Class::Root,
            never_negative: true,
            ..row("hypot", |[a, b]| libm::hypot(a, b))
        },
        /// NaN if an operand is; of two zeros the negative one.
        Min => OperationRow {
            latency: 15,
            size: 3,
            splits: true,
            ..row("min", |[a, b]| one_of(a, b, a < b, b < a))
        },
        /// NaN if an operand is; of two zeros the negative one.
        Max => OperationRow {
            latency: 15,
            size: 3,
            splits: true,
            ..row("max", |[a, b]| one_of(a, b, a > b, b > a))
        },
    }
}

table! {
    /// Operations of three operands.
    pub enum Ternary: 3 {
        /// `angle_near(y, x, guide)`: the argument of `x + i y`, plus the number of whole turns
        /// that brings it nearest to `guide`.
        AngleNear => OperationRow {
            latency: 4,
            class: Class::ArcTangent,
            splits: true,
            call: RustCall::FusedMethod("angle_near_with"),
            ..arc("angle_near", |[y, x, guide]| angle_near(y, x, guide))
        },
        /// `root(q, slack, size)`: the square root of `q`; 0 where `q` is negative by no more than
        /// `slack` times `size`, neither of them negative; NaN below that. An infinite `size` comes
        /// with a `q` that is no finite number either. It closes a group up to the dead point and
        /// refuses beyond.
        GuardedSqrt => OperationRow {
            latency: 15,
            time: 6,
            size: 5,
            class: Class::Root,
            never_negative: true,
            partial: true,
            call: RustCall::FusedMethod("root_with"),
            ..row("root", |[q, slack, size]| root(q, slack, size))
        },
        /// `select(s, a, b)`: `a` where `s >= 0`, `b` where it is negative, NaN where it is NaN.
        Select => OperationRow { size: 3, splits: true, ..row("select", |[s, a, b]| select(s, a, b)) },
    }
}

table! {
    /// A product and a sum. Only programs have them: contraction makes them, and the machine rounds
    /// once or twice as it can. On numbers here, twice. Each printer has its own code for them.
    pub enum Fused: 3 {
        /// `a * b + c`
        MulAdd => OperationRow { class: Class::MultiplyAdd, ..row("mul_add", |[a, b, c]| a * b + c) },
        /// `a * b - c`
        MulSub => OperationRow { class: Class::MultiplyAdd, ..row("mul_sub", |[a, b, c]| a * b - c) },
        /// `c - a * b`
        SubMul => OperationRow { class: Class::MultiplyAdd, ..row("sub_mul", |[a, b, c]| c - a * b) },
    }
}
