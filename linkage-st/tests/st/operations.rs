//! Every operation alone: structured text against the runtime.

use linkage_corpus::given::Given;
use linkage_corpus::operations::{operations, program};
use linkage_corpus::programs::{Named, as_functions};
use linkage_corpus::reference::run;
use linkage_random::Random;
use linkage_symbolic::program::{Binary, Instruction, Program, Source, Ternary, Unary};

use crate::mechanisms::Read;

/// Zeros, infinities, NaN, subnormal numbers, and numbers whose squares are none.
const SPECIAL: [f64; 16] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    2.0,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::NAN,
    5e-324,
    -5e-323,
    f64::MIN_POSITIVE,
    -f64::MIN_POSITIVE,
    f64::MAX,
    f64::MIN,
    1e200,
    -1e-200,
];

const RANDOM: usize = 600;

fn operands(arity: usize) -> Vec<Vec<f64>> {
    let count = SPECIAL.len();
    let special = (0..count.pow(arity as u32)).map(|choice| {
        let one = |k: u32| {
            if (k as usize) < arity {
                SPECIAL[choice / count.pow(k) % count]
            } else {
                0.0
            }
        };
        [0, 1, 2].map(one).to_vec()
    });
    let mut random = Random::new(arity as u64);
    let random = (0..RANDOM).map(|round| {
        let size = match round % 3 {
            0 => random.ratio(1e-30, 1e30),
            1 => random.ratio(1e-3, 1e5),
            _ => 1.0,
        };
        [0; 3].map(|_| size * random.between(-1.0, 1.0)).to_vec()
    });
    special.chain(random).collect()
}

/// Whether results may differ: tangents and arc functions are the controller's; in angles, zeros have no sign, and an
/// infinite length is 2^500.
fn near(operation: Instruction, operands: &[f64], text: f64, rust: f64) -> bool {
    match operation {
        Instruction::Unary(Unary::Tan | Unary::Asin | Unary::Acos | Unary::Atan, _) => {
            let noise = matches!(operation, Instruction::Unary(Unary::Tan, _))
                && operands[0].abs() >= 2.0_f64.powi(30);
            noise || (text - rust).abs() <= 3.0 * f64::EPSILON * rust.abs()
        }
        Instruction::Binary(Binary::Atan2, ..) | Instruction::Ternary(Ternary::AngleNear, ..) => {
            let vector = &operands[..2];
            let zeros = vector
                .iter()
                .any(|own| *own == 0.0 && own.is_sign_negative());
            let infinite = vector.iter().any(|own| own.is_infinite());
            zeros || (infinite && (text - rust).abs() < 1e-140)
        }
        _ => false,
    }
}

#[test]
fn operations_are_those_of_rust() {
    let programs: Vec<Program> = operations().into_iter().map(program).collect();
    let named = programs.iter().map(|program| Named {
        name: String::new(),
        program,
        stage: None,
    });
    let unit = as_functions(&named.collect::<Vec<_>>());
    let read = Read::new(&Given {
        name: "Operations".to_owned(),
        unit: unit.clone(),
    });
    let (mut mechanism, code) = read.assembled(None);
    assert_eq!(code, 0);
    let mut count = 0;
    for (index, operation) in operations().into_iter().enumerate() {
        for operands in operands(operation.operands().count()) {
            let rust = run(&programs[index], |source| match source {
                Source::Input(index) => operands[index],
                _ => unreachable!("there is nothing else"),
            })[0];
            let function = &unit.functions[index];
            let arguments: Vec<f64> = function
                .arguments
                .iter()
                .map(|&own| operands[own])
                .collect();
            let text = read.call(&mut mechanism, &function.name, &arguments)[0];
            let same = text.to_bits() == rust.to_bits() || (text.is_nan() && rust.is_nan());
            assert!(
                same || near(operation, &operands, text, rust),
                "{operation:?} of {operands:?}: {text:e} in structured text, {rust:e} in Rust"
            );
            count += 1;
        }
    }
    println!("{count} results");
}
