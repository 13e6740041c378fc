//! Every operation alone: C against the runtime.

use linkage_c::Real;
use linkage_random::Random;
use linkage_symbolic::program::{Instruction, Program, Source, Unary};

use crate::batch::{Batch, Number, Request};
use crate::machine::Compiler;
use linkage_corpus::given::Given;
use linkage_corpus::operations::{operations, program};
use linkage_corpus::programs::{Named, as_functions};
use linkage_corpus::reference::run;

/// Zeros, infinities, NaN, subnormal numbers, and numbers whose squares are none.
fn special(real: Real) -> Vec<f64> {
    let (least, normal, large) = match real {
        Real::Double | Real::Fused => (f64::from_bits(1), f64::MIN_POSITIVE, f64::MAX),
        Real::Single => (
            f64::from(f32::from_bits(1)),
            f64::from(f32::MIN_POSITIVE),
            f64::from(f32::MAX),
        ),
    };
    let mut special = vec![
        0.0,
        1.0,
        f64::INFINITY,
        least,
        9.0 * least,
        normal,
        large,
        large.sqrt() * 1e3,
    ];
    special.extend(special.clone().iter().map(|x| -x));
    special.push(f64::NAN);
    special
}

/// How many random operands each operation is tried on.
const RANDOM: usize = 4000;

fn operands<T: Number>(arity: usize) -> Vec<Vec<T>> {
    let special = special(T::REAL);
    let choices = special.len().pow(arity as u32);
    let place = |choice: usize, place: usize| match place < arity {
        true => special[choice / special.len().pow(place as u32) % special.len()],
        false => 0.0,
    };
    let chosen =
        (0..choices).map(|choice| [0, 1, 2].map(|k| T::from_f64(place(choice, k))).to_vec());
    let mut random = Random::new(arity as u64);
    let random = (0..RANDOM).map(|round| {
        let size = match round % 3 {
            0 => random.ratio(1e-30, 1e30),
            1 => random.ratio(1e-3, 1e5),
            _ => 1.0,
        };
        let operands = [0; 3].map(|_| T::from_f64(size * random.between(-1.0, 1.0)));
        operands.to_vec()
    });
    chosen.chain(random).collect()
}

/// Whether C and Rust may differ: in tangents and arc functions, which are C's own.
fn near(operation: Instruction, c: f64, rust: f64, roundoff: f64) -> bool {
    let other = matches!(
        operation,
        Instruction::Unary(Unary::Tan | Unary::Asin | Unary::Acos | Unary::Atan, _)
    );
    // The tangent is a quotient of two that are right to 0.83 units in the last place; the arc functions have an argument that was rounded.
    other && (c - rust).abs() <= 3.0 * roundoff * rust.abs()
}

fn compare<T: Number>(name: &str) {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let programs: Vec<Program> = operations().into_iter().map(program).collect();
    let named = programs.iter().map(|program| Named {
        name: String::new(),
        program,
        stage: None,
    });
    let given = [Given {
        name: "Operations".to_owned(),
        unit: as_functions(&named.collect::<Vec<_>>()),
    }];
    let batch = Batch::new::<T>(&compiler, name, &given, &["-O2", "-ffp-contract=off"]);
    let mut requests = Vec::new();
    for (function, operation) in operations().iter().enumerate() {
        let arity = operation.operands().count();
        requests.extend(operands::<T>(arity).into_iter().map(|arguments| Request {
            mechanism: 0,
            function,
            dimensions: Vec::new(),
            arguments,
        }));
    }
    let results = batch.run(&given, &requests);
    for (request, (_, own)) in requests.iter().zip(&results) {
        let operation = operations()[request.function];
        let rust = run(&programs[request.function], |source| match source {
            Source::Input(index) => request.arguments[index],
            _ => unreachable!("there is nothing else"),
        });
        let (c, rust) = (own[0].lane(0), rust[0].lane(0));
        let same = c.to_bits() == rust.to_bits() || (c.is_nan() && rust.is_nan());
        // The sine of a large angle is noise, and no number here; the library computes the tangent.
        let large = matches!(operation, Instruction::Unary(Unary::Tan, _))
            && c.is_nan()
            && request.arguments[0].lane(0).abs() >= 2.0_f64.powi(20);
        assert!(
            same || large || near(operation, c, rust, T::ROUNDOFF),
            "{operation:?} of {:?}: {c:e} in C, {rust:e} in Rust",
            request.arguments
        );
    }
    println!("{name}: {} results", results.len());
}

#[test]
fn operations_on_doubles_are_those_of_rust() {
    compare::<f64>("operations_double");
}

#[test]
fn operations_on_singles_are_those_of_rust() {
    compare::<f32>("operations_single");
}
