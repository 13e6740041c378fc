//! All mechanisms of the golden files and of the examples: C against the same programs on the runtime's numbers.

use linkage_compiler::unit::Unit;
use linkage_random::Random;
use linkage_symbolic::program::{Instruction, Unary};

use crate::batch::{Batch, Number, Request};
use crate::given::{Given, exported};
use crate::machine::Compiler;
use crate::reference::Assembled;

/// Sets of dimensions of each mechanism, and positions for each: the defaults and the reference first.
const SETS: usize = 4;
const POSITIONS: usize = 12;

/// Dimensions near the defaults.
fn dimensions<T: Number>(unit: &Unit, set: usize, random: &mut Random) -> Vec<T> {
    let part = 0.03 * set as f64;
    let scalars = unit.scalars();
    let moved = scalars.map(|own| own.nominal * (1.0 + random.between(-part, part)));
    moved.map(T::from_f64).collect()
}

/// Arguments of a function: the reference, then places in the range and around it.
fn arguments<T: Number>(
    unit: &Unit,
    function: usize,
    position: usize,
    random: &mut Random,
) -> Vec<T> {
    let own = unit.functions[function].arguments.iter();
    let mut one = |&place: &usize| match unit.inputs.get(place) {
        Some(input) if position == 0 => input.reference,
        Some(input) => {
            let around = if input.angle { 7.0 } else { 0.3 * unit.longest };
            let (low, high) = input
                .range
                .unwrap_or((input.reference - around, input.reference + around));
            // Every third position may be far out of reach.
            let beyond = if position % 3 == 2 { 2.0 } else { 0.1 } * (high - low);
            random.between(low - beyond, high + beyond)
        }
        None => random.load(10.0),
    };
    own.map(|place| T::from_f64(one(place))).collect()
}

/// What is asked of all mechanisms, and what the reference gives: `None` where nothing is assembled.
fn asked<T: Number>(given: &[Given]) -> (Vec<Request<T>>, Vec<Option<Vec<T>>>) {
    let mut random = Random::new(18);
    let (mut requests, mut expected) = (Vec::new(), Vec::new());
    for (mechanism, Given { unit, name }) in given.iter().enumerate() {
        for set in 0..SETS {
            let dimensions: Vec<T> = dimensions(unit, set, &mut random);
            let assembled = Assembled::new(unit, &dimensions);
            assert!(
                set > 0 || assembled.is_some(),
                "{name} is assembled at its defaults"
            );
            for function in 0..unit.functions.len() {
                for position in 0..POSITIONS {
                    let arguments: Vec<T> = arguments(unit, function, position, &mut random);
                    let results = assembled
                        .as_ref()
                        .map(|own| own.call(&unit.functions[function], &arguments));
                    expected.push(results);
                    requests.push(Request {
                        mechanism,
                        function,
                        dimensions: dimensions.clone(),
                        arguments,
                    });
                }
            }
        }
    }
    (requests, expected)
}

/// Compares all results to the last bit; any NaN is one.
fn same<T: Number>(name: &str) {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let mut given = exported();
    given.retain(|own| own.unit.coupled.is_empty());
    let batch = Batch::new::<T>(&compiler, name, &given, &["-O1", "-ffp-contract=off"]);
    let (requests, expected) = asked::<T>(&given);
    let results = batch.run(&given, &requests);
    let (mut count, mut finite, mut different) = (0, 0, 0);
    for ((request, expected), (code, own)) in requests.iter().zip(&expected).zip(&results) {
        let Given { name, unit } = &given[request.mechanism];
        let function = &unit.functions[request.function].name;
        assert_eq!(*code == 0, expected.is_some(), "{name}: code {code}");
        for (index, (c, rust)) in own.iter().zip(expected.iter().flatten()).enumerate() {
            let (c, rust) = (c.lane(0), rust.lane(0));
            let same = c.to_bits() == rust.to_bits() || (c.is_nan() && rust.is_nan());
            // C's own tangents and arc functions round in other places than the library.
            let near = has_others(unit, request.function)
                && (c - rust).abs() <= 1e3 * T::ROUNDOFF * rust.abs().max(1.0);
            assert!(
                same || near,
                "{name}::{function}, result {index}: {c:e} in C, {rust:e} in Rust"
            );
            count += 1;
            finite += usize::from(c.is_finite());
            different += usize::from(!same);
        }
    }
    println!(
        "{name}: {} mechanisms, {count} results, {finite} of them finite, {different} by other functions",
        given.len()
    );
    assert!(
        count > 20_000 && finite > count / 2 && finite < count,
        "{finite} of {count}"
    );
}

/// Whether a function calls a tangent or an arc function that the user wrote.
fn has_others(unit: &Unit, function: usize) -> bool {
    let programs = [&unit.prepare, &unit.functions[function].called.program];
    let mut all = programs.iter().flat_map(|own| &own.instructions);
    all.any(|own| {
        matches!(
            own,
            Instruction::Unary(Unary::Tan | Unary::Asin | Unary::Acos | Unary::Atan, _)
        )
    })
}

#[test]
fn doubles_are_those_of_rust() {
    same::<f64>("doubles");
}

#[test]
fn singles_are_those_of_rust() {
    same::<f32>("singles");
}
