//! The operations, each with one row of facts.
//!
//! Calls of `linkage_core::Scalar` in the compiler and the derivative in `differentiate` are matches without a wildcard: an operation
//! that is added here does not compile before they have it. Tests require its function in C (`linkage-c`), in the engine of JavaScript
//! and for intervals. Rules of simplification are optional, except for those of symmetry, which follow from the row.

mod row;
mod value;

use row::{ARC, arc, row, trigonometric};
pub use row::{Call, Class, Row, Symmetry};
use value::{DEAD_POINT, WHOLE, angle_near, inverse_scale, one_of, root, select, sign};

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
            pub fn apply(self, operands: [f64; $arity]) -> f64 {
                (self.row().value)(operands)
            }

            /// What is known of it.
            pub fn row(self) -> &'static Row<$arity> {
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
        Neg => Row { call: Call::Operator('-'), latency: 1, ..row("neg", |[a]| -a) },
        /// `|a|`
        Abs => Row { latency: 1, splits: true, never_negative: true, ..row("abs", |[a]| a.abs()) },
        /// The square root.
        Sqrt => Row {
            latency: 20,
            time: 6,
            class: Class::Root,
            never_negative: true,
            partial: true,
            ..row("sqrt", |[a]| a.sqrt())
        },
        /// The sine. That and the cosine of one operand are computed together.
        Sin => Row {
            class: Class::SineCosine,
            symmetry: Symmetry::Odd,
            call: Call::SinePair(0),
            ..trigonometric("sin", |[a]| a.sin())
        },
        /// The cosine.
        Cos => Row {
            class: Class::SineCosine,
            symmetry: Symmetry::Even,
            call: Call::SinePair(1),
            ..trigonometric("cos", |[a]| a.cos())
        },
        /// The tangent.
        Tan => Row {
            time: ARC,
            size: 50,
            partial: true,
            symmetry: Symmetry::Odd,
            ..trigonometric("tan", |[a]| a.tan())
        },
        /// The arc sine.
        Asin => Row {
            splits: true,
            partial: true,
            symmetry: Symmetry::Odd,
            ..arc("asin", |[a]| a.asin())
        },
        /// The arc cosine.
        Acos => Row { splits: true, partial: true, ..arc("acos", |[a]| a.acos()) },
        /// The arc tangent.
        Atan => Row { symmetry: Symmetry::Odd, splits: true, ..arc("atan", |[a]| a.atan()) },
        /// `+1` for a number that is positive or `+0`, `-1` for a negative one: the derivative of `Abs`.
        Sign => Row { latency: 20, splits: true, ..row("sign", |[a]| sign(a)) },
        /// The nearest whole number, of two the even one; right up to `2^51`.
        Whole => Row {
            latency: 8,
            size: 2,
            splits: true,
            ..row("whole", |[a]| (a + WHOLE) - WHOLE)
        },
        /// `slack(x)`: by how much rounding may turn negative what was computed from terms of the size `x`: 8 roundoffs of it, of the
        /// numbers that a program runs on. No constant for that reason. NaN where `x` is infinite.
        Slack => Row {
            size: 2,
            splits: true,
            never_negative: true,
            ..row("slack", |[x]| DEAD_POINT * x.abs() + 0.0 * x)
        },
        /// A power of two near `1/|x|` (1 for 0 and non-finite numbers): scales lengths without rounding.
        InverseScale => Row {
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
        Add => Row {
            class: Class::Addition,
            call: Call::Operator('+'),
            ..row("+", |[a, b]| a + b)
        },
        /// `a - b`
        Sub => Row {
            class: Class::Addition,
            call: Call::Operator('-'),
            ..row("-", |[a, b]| a - b)
        },
        /// `a * b`
        Mul => Row {
            class: Class::Multiplication,
            call: Call::Operator('*'),
            ..row("*", |[a, b]| a * b)
        },
        /// `a / b`
        Div => Row {
            latency: 15,
            time: 5,
            class: Class::Division,
            partial: true,
            call: Call::Operator('/'),
            ..row("/", |[a, b]| a / b)
        },
        /// `a / b`, NaN where that is infinite: a quotient by the root of a discriminant. Only programs have it.
        Quotient => Row {
            latency: 19,
            time: 6,
            size: 2,
            class: Class::Division,
            partial: true,
            call: Call::FusedMethod("quotient_with"),
            ..row("quotient", |[a, b]| a / b + 0.0 * (a / b))
        },
        /// `atan2(y, x)`
        Atan2 => Row {
            latency: 15,
            class: Class::ArcTangent,
            splits: true,
            call: Call::FusedMethod("atan2_with"),
            ..arc("atan2", |[y, x]| y.atan2(x))
        },
        /// `sqrt(x^2 + y^2)` without overflow.
        Hypot => Row {
            latency: 15,
            time: 6,
            size: 20,
            class: Class::Root,
            never_negative: true,
            ..row("hypot", |[a, b]| a.hypot(b))
        },
        /// NaN if an operand is; of two zeros the negative one.
        Min => Row {
            latency: 15,
            size: 3,
            splits: true,
            ..row("min", |[a, b]| one_of(a, b, a < b, b < a))
        },
        /// NaN if an operand is; of two zeros the negative one.
        Max => Row {
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
        /// `angle_near(y, x, guide)`: the argument of `x + i y`, plus the number of whole turns that brings it nearest to
        /// `guide`.
        AngleNear => Row {
            latency: 4,
            class: Class::ArcTangent,
            splits: true,
            call: Call::FusedMethod("angle_near_with"),
            ..arc("angle_near", |[y, x, guide]| angle_near(y, x, guide))
        },
        /// `root(q, slack, size)`: the square root of `q`; 0 where `q` is negative by no more than `slack` times `size`, neither of them
        /// negative; NaN below that. An infinite `size` comes with a `q` that is no finite number either. It closes a group up to the dead point and refuses beyond.
        Root => Row {
            latency: 15,
            time: 6,
            size: 5,
            class: Class::Root,
            never_negative: true,
            partial: true,
            call: Call::FusedMethod("root_with"),
            ..row("root", |[q, slack, size]| root(q, slack, size))
        },
        /// `select(s, a, b)`: `a` where `s >= 0`, `b` where it is negative, NaN where it is NaN.
        Select => Row { size: 3, splits: true, ..row("select", |[s, a, b]| select(s, a, b)) },
    }
}

table! {
    /// A product and a sum. Only programs have them: contraction makes them, and the machine rounds once or twice as it can. On
    /// numbers here, twice. Each printer has its own code for them.
    pub enum Fused: 3 {
        /// `a * b + c`
        MulAdd => Row { class: Class::MultiplyAdd, ..row("mul_add", |[a, b, c]| a * b + c) },
        /// `a * b - c`
        MulSub => Row { class: Class::MultiplyAdd, ..row("mul_sub", |[a, b, c]| a * b - c) },
        /// `c - a * b`
        SubMul => Row { class: Class::MultiplyAdd, ..row("sub_mul", |[a, b, c]| c - a * b) },
    }
}
