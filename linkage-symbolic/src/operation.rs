//! The operations, each with all that is known of it in one row.
//!
//! What a row cannot say is a `match` without a wildcard: the derivative in `differentiate`, what printers write. So an operation
//! that is added here does not compile until everything knows it; simplification is a matter of choice.

use std::f64::consts::TAU;

/// What is known of an operation of so many operands.
#[derive(Clone, Copy, Debug)]
pub struct Row<const ARITY: usize> {
    /// In texts: a word, or the sign that stands between both operands.
    pub name: &'static str,
    /// What it computes, on numbers.
    pub value: fn([f64; ARITY]) -> f64,
    /// In rough cycles: when its result is known after its operands. It decides which of two products is fused, so a change of it
    /// changes last digits where multiply-adds are.
    pub latency: u32,
    /// By throughput, an addition being 1: what it costs where much else is computed beside it.
    pub time: u32,
    /// In machine instructions, roughly: how much of what a processor looks ahead it takes.
    pub size: u32,
    /// As what it is counted.
    pub class: Class,
    /// True for a function that is a different formula on different sides of some value.
    pub splits: bool,
    /// True if its value is no negative number, whatever the operands are; it may be -0, or NaN.
    pub never_negative: bool,
    /// True if it has no finite value for some finite operands. What is too large for a number is another matter.
    pub partial: bool,
}

/// The classes in which operations are counted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    Addition,
    Multiplication,
    /// Both of them.
    MultiplyAdd,
    Division,
    Root,
    SineCosine,
    ArcTangent,
    Other,
}

/// A row with the columns that most operations share.
const fn row<const ARITY: usize>(name: &'static str, value: fn([f64; ARITY]) -> f64) -> Row<ARITY> {
    Row {
        name,
        value,
        latency: 4,
        time: 1,
        size: 1,
        class: Class::Other,
        splits: false,
        never_negative: false,
        partial: false,
    }
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
        Neg => Row { latency: 1, ..row("neg", |[a]| -a) },
        /// `|a|`
        Abs => Row { latency: 1, splits: true, never_negative: true, ..row("abs", |[a]| a.abs()) },
        /// The square root.
        Sqrt => Row { latency: 20, time: 6, class: Class::Root, never_negative: true, partial: true, ..row("sqrt", |[a]| a.sqrt()) },
        /// The sine. That and the cosine of one operand are computed together.
        Sin => Row { class: Class::SineCosine, ..trigonometric("sin", |[a]| a.sin()) },
        /// The cosine.
        Cos => Row { class: Class::SineCosine, ..trigonometric("cos", |[a]| a.cos()) },
        /// The tangent.
        Tan => Row { time: ARC, size: 50, partial: true, ..trigonometric("tan", |[a]| a.tan()) },
        /// The arc sine.
        Asin => Row { splits: true, partial: true, ..arc("asin", |[a]| a.asin()) },
        /// The arc cosine.
        Acos => Row { splits: true, partial: true, ..arc("acos", |[a]| a.acos()) },
        /// The arc tangent.
        Atan => Row { splits: true, ..arc("atan", |[a]| a.atan()) },
        /// `+1` for a number that is positive or `+0`, `-1` for a negative one: the derivative of `Abs`.
        Sign => Row { latency: 20, splits: true, ..row("sign", |[a]| sign(a)) },
        /// The nearest whole number, of two the even one; right up to `2^51`.
        Whole => Row { latency: 8, size: 2, splits: true, ..row("whole", |[a]| (a + WHOLE) - WHOLE) },
        /// `slack(x)`: by how much rounding may turn negative what was computed from terms of the size `x`: 8 roundoffs of it, of the
        /// numbers that a program runs on. No constant for that reason. NaN where `x` is infinite.
        Slack => Row { size: 2, splits: true, never_negative: true, ..row("slack", |[x]| DEAD_POINT * x.abs() + 0.0 * x) },
        /// A power of two near `1/|x|` (1 for 0 and non-finite numbers): scales lengths without rounding.
        InverseScale => Row { latency: 20, size: 6, never_negative: true, ..row("inverse_scale", |[a]| inverse_scale(a)) },
    }
}

table! {
    /// Operations of two operands.
    pub enum Binary: 2 {
        /// `a + b`
        Add => Row { class: Class::Addition, ..row("+", |[a, b]| a + b) },
        /// `a - b`
        Sub => Row { class: Class::Addition, ..row("-", |[a, b]| a - b) },
        /// `a * b`
        Mul => Row { class: Class::Multiplication, ..row("*", |[a, b]| a * b) },
        /// `a / b`
        Div => Row { latency: 15, time: 5, class: Class::Division, partial: true, ..row("/", |[a, b]| a / b) },
        /// `a / b`, NaN where that is infinite: a quotient by the root of a discriminant. Only programs have it.
        Quotient => Row {
            latency: 19,
            time: 6,
            size: 2,
            class: Class::Division,
            partial: true,
            ..row("quotient", |[a, b]| a / b + 0.0 * (a / b))
        },
        /// `atan2(y, x)`
        Atan2 => Row { latency: 15, class: Class::ArcTangent, splits: true, ..arc("atan2", |[y, x]| y.atan2(x)) },
        /// `sqrt(x^2 + y^2)` without overflow.
        Hypot => Row { latency: 15, time: 6, size: 20, class: Class::Root, never_negative: true, ..row("hypot", |[a, b]| a.hypot(b)) },
        /// NaN if an operand is; of two zeros the negative one.
        Min => Row { latency: 15, size: 3, splits: true, ..row("min", |[a, b]| one_of(a, b, a < b, b < a)) },
        /// NaN if an operand is; of two zeros the negative one.
        Max => Row { latency: 15, size: 3, splits: true, ..row("max", |[a, b]| one_of(a, b, a > b, b > a)) },
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
            ..row("root", |[q, slack, size]| root(q, slack, size))
        },
        /// `select(s, a, b)`: `a` where `s >= 0`, `b` where it is negative, NaN where it is NaN.
        Select => Row { size: 3, splits: true, ..row("select", |[s, a, b]| select(s, a, b)) },
    }
}

table! {
    /// A product and a sum. Only programs have them: contraction makes them, and the machine rounds once or twice as it can. On
    /// numbers here, twice.
    pub enum Fused: 3 {
        /// `a * b + c`
        MulAdd => Row { class: Class::MultiplyAdd, ..row("mul_add", |[a, b, c]| a * b + c) },
        /// `a * b - c`
        MulSub => Row { class: Class::MultiplyAdd, ..row("mul_sub", |[a, b, c]| a * b - c) },
        /// `c - a * b`
        SubMul => Row { class: Class::MultiplyAdd, ..row("sub_mul", |[a, b, c]| c - a * b) },
    }
}

/// What an arc function or a tangent costs by throughput.
const ARC: u32 = 30;

const fn trigonometric(name: &'static str, value: fn([f64; 1]) -> f64) -> Row<1> {
    Row {
        latency: 20,
        time: 20,
        size: 20,
        ..row(name, value)
    }
}

const fn arc<const ARITY: usize>(name: &'static str, value: fn([f64; ARITY]) -> f64) -> Row<ARITY> {
    Row {
        latency: 20,
        time: ARC,
        size: 50,
        ..row(name, value)
    }
}

/// Roundoffs of the scale by which a discriminant may be negative at the dead point: what its terms are rounded by.
const DEAD_POINT: f64 = 8.0 * f64::EPSILON;

/// Added and taken away again, it leaves whole numbers: the numbers beside it have no digits behind the point.
const WHOLE: f64 = 1.5 / f64::EPSILON;

fn sign(a: f64) -> f64 {
    if a.is_nan() {
        a
    } else if a >= 0.0 {
        1.0
    } else {
        -1.0
    }
}

fn inverse_scale(x: f64) -> f64 {
    if x == 0.0 || !x.is_finite() {
        return 1.0;
    }
    // The exponent alone, mirrored, and kept within what normal numbers have.
    let exponent = (x.to_bits() >> 52) & 0x7ff;
    f64::from_bits((2046 - exponent.clamp(1, 2045)) << 52)
}

/// The one that is to be taken. Of two zeros the standard library may take either, and does so by machine; this is what generated
/// code takes.
fn one_of(a: f64, b: f64, first: bool, second: bool) -> f64 {
    if a.is_nan() || b.is_nan() {
        f64::NAN
    } else if first {
        a
    } else if second {
        b
    } else {
        // Equal: they differ in the sign at most.
        f64::from_bits(a.to_bits() | b.to_bits())
    }
}

fn root(q: f64, slack: f64, size: f64) -> f64 {
    match slack * size + q >= 0.0 {
        // Not the root of -0.
        true if q > 0.0 => q.sqrt(),
        true => 0.0,
        false => f64::NAN,
    }
}

fn angle_near(y: f64, x: f64, guide: f64) -> f64 {
    let angle = y.atan2(x);
    angle + TAU * ((guide - angle) / TAU).round_ties_even()
}

fn select(s: f64, a: f64, b: f64) -> f64 {
    if s.is_nan() {
        s
    } else if s >= 0.0 {
        a
    } else {
        b
    }
}
