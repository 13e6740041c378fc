//! Every operation of the table: C gives what the interpreter gives, and generated Rust what is said here.

use linkage_symbolic::program::{Binary, Fused, Ternary, Unary};

use crate::machine::{Compiler, Entry};
use crate::mechanisms::same;
use crate::operations::{Operation, operands};

#[test]
fn operations_give_the_same_in_c() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let entry = |own: Operation| Entry {
        call: format!("*out = {};", own.in_c(["in[0]", "in[1]", "in[2]"])),
        takes: 3,
        gives: 1,
    };
    let entries: Vec<Entry> = Operation::all().map(entry).collect();
    let mut requests = Vec::new();
    let mut expected = Vec::new();
    for (index, own) in Operation::all().enumerate() {
        for numbers in operands(own) {
            requests.push((index, numbers.to_vec()));
            expected.push((own, numbers, own.interpreted(numbers)));
        }
    }
    let executable = compiler.compile("operations", "#include \"linkage.h\"\n", &entries);
    let results = executable.run(&requests);
    assert_eq!(results.len(), expected.len(), "a result for each request");
    for ((own, numbers, interpreted), c) in expected.into_iter().zip(&results) {
        assert!(
            same(*c, interpreted),
            "{own:?} of {numbers:?}: {c:e} in C, {interpreted:e} by the interpreter"
        );
    }
    println!("{} operations, {} results", entries.len(), results.len());
}

/// From here on the runtime has no sine.
const SINE_LIMIT: f64 = 1_073_741_824.0;

/// Whether generated Rust, unfused, may give `rust` where the interpreter gives another number.
fn allowed(operation: Operation, [a, b, _]: [f64; 3], interpreted: f64, rust: f64) -> bool {
    match operation {
        // The runtime's own sine pair has no table and no branch: it is right to 0.80 units in the last place up to 1e5, to as many
        // roundoffs of 1 beyond, NaN where that would be noise, and the sine of -0 is +0.
        Operation::Unary(Unary::Sin | Unary::Cos) => match a.abs() {
            size if size >= SINE_LIMIT => rust.is_nan(),
            0.0 => rust.to_bits() == 0,
            size if size > 1e5 => (rust - interpreted).abs() <= f64::EPSILON,
            _ => places(rust, interpreted) <= 1,
        },
        // So does its arc tangent. That of an infinite and a very large number is 0 within a few least normal numbers.
        Operation::Binary(Binary::Atan2) => {
            places(rust, interpreted) <= 1
                || (b == f64::INFINITY && (rust - interpreted).abs() <= 4.0 * f64::MIN_POSITIVE)
        }
        // Two roundings more than the library has. That finds an infinite length, if one component is infinite and the other NaN:
        // here NaN is passed on.
        Operation::Binary(Binary::Hypot) => match a.is_nan() || b.is_nan() {
            true => rust.is_nan(),
            false => places(rust, interpreted) <= 1,
        },
        // Of a zero it is that zero, whatever the scale: the discriminant of what is not finite is not zero.
        Operation::Binary(Binary::Root) => a == 0.0 && !b.is_finite() && rust.to_bits() == 0,
        // A turn in two parts is more exact than the interpreter's product; the sign of a zero angle is lost.
        Operation::Ternary(Ternary::AngleNear) => {
            let size = f64::max(interpreted.abs(), 1.0);
            (rust - interpreted).abs() <= 4.0 * f64::EPSILON * size
        }
        // The same instructions or functions of the library.
        Operation::Unary(
            Unary::Neg
            | Unary::Abs
            | Unary::Sqrt
            | Unary::Tan
            | Unary::Asin
            | Unary::Acos
            | Unary::Atan
            | Unary::Sign
            | Unary::InverseScale,
        )
        | Operation::Binary(
            Binary::Add | Binary::Sub | Binary::Mul | Binary::Div | Binary::Min | Binary::Max,
        )
        | Operation::Ternary(Ternary::Select)
        | Operation::Fused(Fused::MulAdd | Fused::MulSub | Fused::SubMul) => false,
    }
}

/// How many numbers lie between two of one sign; very many for others.
fn places(a: f64, b: f64) -> u64 {
    match a.is_nan() || b.is_nan() {
        true => u64::MAX,
        false => a.to_bits().abs_diff(b.to_bits()),
    }
}

#[test]
fn generated_rust_gives_what_is_said() {
    for own in Operation::all() {
        let all = operands(own);
        let mut others = 0;
        for &numbers in &all {
            let (rust, interpreted) = (own.in_rust(numbers), own.interpreted(numbers));
            if same(rust, interpreted) {
                continue;
            }
            others += 1;
            assert!(
                allowed(own, numbers, interpreted, rust),
                "{own:?} of {numbers:?}: {rust:e} in Rust, {interpreted:e} by the interpreter"
            );
        }
        println!("{own:?}: {others} of {} differ", all.len());
    }
}
