//! Every operation of the table: generated code gives what the interpreter gives, or what is said here.

use linkage_compiler::ir::Generated;
use linkage_core::Scalar;
use linkage_corpus::numbers::SPECIAL;
use linkage_corpus::operations::{operations, program};
use linkage_random::Random;
use linkage_symbolic::interpret::{Arithmetic, run, run_by};
use linkage_symbolic::program::{Binary, Fused, Instruction, Program, Source, Ternary, Unary};

/// How many random operands each operation is tried on.
const RANDOM: usize = 6000;

/// Operands of all kinds: every choice of special numbers, then random ones of any size, of like sizes, and small ones.
fn operands(arity: usize) -> Vec<[f64; 3]> {
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

/// From here on the runtime has no sine.
const SINE_LIMIT: f64 = 1_073_741_824.0;

/// Whether generated Rust, unfused, may give `rust` where the interpreter gives another number.
fn allowed(operation: Instruction, [a, b, _]: [f64; 3], interpreted: f64, rust: f64) -> bool {
    match operation {
        // The runtime's own sine pair has no table and no branch: it is right to 0.80 units in the last place up to 1e5, to as many
        // roundoffs of 1 beyond, NaN where that would be noise, and the sine of -0 is +0.
        Instruction::Unary(Unary::Sin | Unary::Cos, _) => match a.abs() {
            size if size >= SINE_LIMIT => rust.is_nan(),
            0.0 => rust.to_bits() == 0,
            size if size > 1e5 => (rust - interpreted).abs() <= f64::EPSILON,
            _ => places(rust, interpreted) <= 1,
        },
        // So does its arc tangent. That of an infinite and a very large number is 0 within a few least normal numbers.
        Instruction::Binary(Binary::Atan2, ..) => {
            places(rust, interpreted) <= 1
                || (b == f64::INFINITY && (rust - interpreted).abs() <= 4.0 * f64::MIN_POSITIVE)
        }
        // Two roundings more than the library has. That finds an infinite length, if one component is infinite and the other NaN:
        // here NaN is passed on.
        Instruction::Binary(Binary::Hypot, ..) => match a.is_nan() || b.is_nan() {
            true => rust.is_nan(),
            false => places(rust, interpreted) <= 1,
        },
        // A turn in two parts is more exact than the interpreter's product; the sign of a zero angle is lost.
        Instruction::Ternary(Ternary::AngleNear, ..) => {
            let size = f64::max(interpreted.abs(), 1.0);
            (rust - interpreted).abs() <= 4.0 * f64::EPSILON * size
        }
        // The same instructions or functions of the library.
        Instruction::Unary(
            Unary::Neg
            | Unary::Abs
            | Unary::Sqrt
            | Unary::Tan
            | Unary::Asin
            | Unary::Acos
            | Unary::Atan
            | Unary::Sign
            | Unary::Round
            | Unary::Slack
            | Unary::InverseScale,
            _,
        )
        | Instruction::Binary(
            Binary::Add
            | Binary::Sub
            | Binary::Mul
            | Binary::Div
            | Binary::Quotient
            | Binary::Min
            | Binary::Max,
            ..,
        )
        | Instruction::Ternary(Ternary::Select | Ternary::GuardedSqrt, ..)
        | Instruction::Fused(Fused::MulAdd | Fused::MulSub | Fused::SubMul, ..) => false,
        Instruction::Constant(_)
        | Instruction::Load(_)
        | Instruction::SinCos(_)
        | Instruction::Second(_) => unreachable!("these are no operations"),
    }
}

/// How many numbers lie between two of one sign; very many for others.
fn places(a: f64, b: f64) -> u64 {
    match a.is_nan() || b.is_nan() {
        true => u64::MAX,
        false => a.to_bits().abs_diff(b.to_bits()),
    }
}

/// Equal to the last bit; any NaN is one.
fn same(a: f64, b: f64) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

fn input<T: Copy>(numbers: [T; 3]) -> impl Fn(Source) -> T {
    move |source| match source {
        Source::Input(index) => numbers[index],
        _ => unreachable!("there is nothing else"),
    }
}

#[test]
fn generated_code_computes_what_the_interpreter_does() {
    for operation in operations() {
        let program = program(operation);
        let all = operands(operation.operands().count());
        let mut others = 0;
        for &numbers in &all {
            let rust = run_by::<Generated<f64, false>>(&program, input(numbers))[0];
            let interpreted = run(&program, input(numbers))[0];
            if same(rust, interpreted) {
                continue;
            }
            others += 1;
            assert!(
                allowed(operation, numbers, interpreted, rust),
                "{operation:?} of {numbers:?}: {rust:e} in Rust, {interpreted:e} by the interpreter"
            );
        }
        println!("{operation:?}: {others} of {} differ", all.len());
    }
}

/// Where no rounding can tell what is fused, signs can: both kinds give these products and sums exactly.
#[test]
fn fused_operations_have_the_signs_of_the_others() {
    for &op in Fused::ALL {
        let [a, b, c] = [3.0, 5.0, 7.0];
        let fused = <Generated<f64, true> as Arithmetic>::fused(op, a, b, c);
        assert_eq!(fused, op.apply([a, b, c]), "{op:?}");
    }
}

/// Both results of a pair, with either arithmetic.
#[test]
fn a_pair_is_a_sine_and_a_cosine() {
    let mut program = Program::default();
    let angle = program.push(Instruction::Load(Source::Input(0)));
    let sine = program.push(Instruction::SinCos(angle));
    let cosine = program.push(Instruction::Second(sine));
    program.outputs.extend([sine, cosine]);
    for x in [0.3, -2.0, 40.0] {
        assert_eq!(run(&program, input([x; 3])), [x.sin(), x.cos()]);
        let (sine, cosine) = x.sin_cos_with::<false>();
        let generated = run_by::<Generated<f64, false>>(&program, input([x; 3]));
        assert_eq!(generated, [sine, cosine]);
    }
}
