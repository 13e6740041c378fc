//! Groups without a closed form: tables in C against those of the runtime, for the dimensions of the declaration and for others.

use linkage_c::{Real, sources};
use linkage_compiler::ir::CompiledMechanism;

use crate::batch::{Batch, Number, Request, UNOPTIMISED};
use crate::machine::Compiler;
use linkage_corpus::given::{Given, exported};
use linkage_corpus::reference::Assembled;
use linkage_random::one_in;

/// Positions of each function over the range of the input.
const POSITIONS: usize = 100;

/// Mechanisms with such groups: with a table of a whole turn, a table with ends, a grid over two inputs.
pub(crate) fn all() -> Vec<Given> {
    let mut all = exported();
    all.retain(|own| !own.unit.coupled.is_empty());
    assert!(all.len() > 3, "there are some: {}", all.len());
    all.push(Given::text(&over_two_inputs(&triad("261mm"))));
    // A table with ends.
    all.push(Given::text(&triad("261mm").replace("360deg", "200deg")));
    all
}

/// A fourth of them, and the two of texts, where compiling takes long.
pub(crate) fn some() -> impl Iterator<Item = Given> {
    let mut all = all();
    let texts = all.split_off(all.len() - 2);
    one_in(4, all).chain(texts)
}

/// Requests for all functions over the range, and a little beyond.
fn requests<T: Number>(
    mechanism: usize,
    unit: &CompiledMechanism,
    dimensions: &[f64],
) -> Vec<Request<T>> {
    let mut requests = Vec::new();
    for (function, own) in unit.functions.iter().enumerate() {
        for position in 0..POSITIONS {
            let share = (position as f64 - 1.0) / (POSITIONS as f64 - 3.0);
            let argument = |&place: &usize| match unit.inputs.get(place) {
                Some(input) => {
                    let (low, high) = input.followed;
                    low + share * (high - low)
                }
                None => 1.5,
            };
            requests.push(Request {
                mechanism,
                function,
                dimensions: dimensions.iter().map(|x| T::from_f64(*x)).collect(),
                arguments: own
                    .arguments
                    .iter()
                    .map(|own| T::from_f64(argument(own)))
                    .collect(),
            });
        }
    }
    requests
}

fn defaults(unit: &CompiledMechanism) -> Vec<f64> {
    unit.scalars().map(|own| own.nominal).collect()
}

/// The largest difference of each function's results, in roundoffs of the largest result of its column; a result that only one of them has is
/// as many as one likes.
fn differences<T: Number>(c: &[Vec<T>], rust: &[Vec<f64>]) -> f64 {
    let columns = rust[0].len();
    let mut most = 0.0_f64;
    for column in 0..columns {
        let finite = rust.iter().map(|row| row[column]).filter(|x| x.is_finite());
        let size = finite.fold(0.0_f64, |most, x| most.max(x.abs())).max(1.0);
        for (c, rust) in c.iter().zip(rust) {
            let (c, rust) = (c[column].lane(0), rust[column]);
            most = most.max(match (c.is_nan(), rust.is_nan()) {
                (true, true) => 0.0,
                (false, false) => (c - rust).abs() / (size * T::ROUNDOFF),
                _ => f64::INFINITY,
            });
        }
    }
    most
}

#[test]
fn doubles_are_those_of_rust() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let given = all();
    let batch = Batch::new::<f64>(&compiler, "coupled_double", &given, &UNOPTIMISED);
    for (mechanism, Given { name, unit }) in given.iter().enumerate() {
        let requests = requests::<f64>(mechanism, unit, &defaults(unit));
        let results = batch.run(&given, &requests);
        let assembled = Assembled::new(unit, &defaults(unit)).expect("it is assembled");
        let mut finite = 0;
        for (request, (code, c)) in requests.iter().zip(&results) {
            assert_eq!(*code, 0, "{name}");
            let function = &unit.functions[request.function];
            let rust = assembled.call(function, &request.arguments);
            for (c, rust) in c.iter().zip(&rust) {
                let same = c.to_bits() == rust.to_bits() || (c.is_nan() && rust.is_nan());
                let at = &request.arguments;
                assert!(
                    same,
                    "{name}::{} at {at:?}: {c:e} in C, {rust:e} in Rust",
                    function.name
                );
                finite += usize::from(c.is_finite());
            }
        }
        println!(
            "{name}: {finite} finite results of {} calls",
            requests.len()
        );
        assert!(finite > requests.len(), "{name}");
    }
}

#[test]
fn singles_are_near_doubles() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let given = all();
    let batch = Batch::new::<f32>(&compiler, "coupled_single", &given, &UNOPTIMISED);
    for (mechanism, Given { name, unit }) in given.iter().enumerate() {
        let requests = requests::<f32>(mechanism, unit, &defaults(unit));
        let results = batch.run(&given, &requests);
        let assembled = Assembled::new(unit, &defaults(unit)).expect("it is assembled");
        for (function, own) in unit.functions.iter().enumerate() {
            let (mut c, mut rust) = (Vec::new(), Vec::new());
            for (request, (code, result)) in requests.iter().zip(&results) {
                assert_eq!(*code, 0, "{name}");
                if request.function == function {
                    let arguments: Vec<f64> =
                        request.arguments.iter().map(|x| f64::from(*x)).collect();
                    c.push(result.clone());
                    rust.push(assembled.call(own, &arguments));
                }
            }
            let most = differences(&c, &rust);
            println!("{name}::{}: {most:.1} roundoffs", own.name);
            // Roundings grow by the condition: by about ten, by up to 155 of a platform on six legs, and in rates by more.
            assert!(most < 1000.0, "{name}::{}: {most}", own.name);
        }
    }
}

/// A triad, its third leg of this length.
fn triad(length: &str) -> String {
    let text = include_str!("../../../linkage-compiler/tests/golden/eye_needle.mech");
    let moved = text.replacen("l57 = 261mm", &format!("l57 = {length}"), 1);
    assert!(length == "261mm" || moved != text, "the leg is there");
    moved
}

/// A triad whose third pivot moves up and down.
fn over_two_inputs(triad: &str) -> String {
    triad
        .replace(
            "unknown phi23",
            "input lift = 0mm in -4mm..4mm; unknown phi23",
        )
        .replace("= p7 +", "= p7 + (0, lift) +")
        .replace("(phi)", "(phi, lift)")
        .replace("velocity(p8)", "d(p8, phi)")
}

/// What assembling returns for another length of the leg, and how far results are from those of a mechanism that was declared with it.
/// `text` writes the mechanism.
fn moved<T: Number>(name: &str, length: f64, text: fn(&str) -> String) -> Option<(usize, f64)> {
    let compiler = Compiler::find()?;
    let given = [Given::text(&text("261mm"))];
    let batch = Batch::new::<T>(&compiler, name, &given, &UNOPTIMISED);
    let other = Given::text(&text(&format!("{length}mm")));
    let dimensions = defaults(&other.unit);
    let assembled = Assembled::new(&other.unit, &dimensions).expect("it is assembled");
    let requests = requests::<T>(0, &given[0].unit, &dimensions);
    let results = batch.run(&given, &requests);
    let mut most = 0.0_f64;
    for (function, own) in other.unit.functions.iter().enumerate() {
        let (mut c, mut rust) = (Vec::new(), Vec::new());
        for (request, (_, result)) in requests.iter().zip(&results) {
            if request.function == function {
                let arguments: Vec<f64> = request.arguments.iter().map(|x| x.lane(0)).collect();
                c.push(result.clone());
                rust.push(assembled.call(own, &arguments));
            }
        }
        most = most.max(differences(&c, &rust));
    }
    let code = results[0].0;
    assert!(results.iter().all(|own| own.0 == code), "one mechanism");
    Some((code, most))
}

/// Other dimensions are reached, and what is too far is refused.
fn reached_or_refused<T: Number>(name: &str, text: fn(&str) -> String) {
    for length in [261.02, 258.0, 266.0] {
        let Some((code, most)) = moved::<T>(name, length, text) else {
            return;
        };
        println!("{name}, {length} mm: {most:.1} roundoffs");
        assert!(code == 0 && most < 40.0, "{length} mm: {code}, {most}");
    }
    let (code, _) = moved::<T>(name, 300.0, text).expect("there is a compiler");
    let own = Given::text(&text("261mm"));
    let header = sources(&own.name, &own.unit, T::REAL)
        .expect("it can be exported")
        .header;
    assert!(
        header.contains(&format!("EYE_NEEDLE_LOOPS_1_2_TOO_FAR = {code}\n")),
        "{code}"
    );
}

#[test]
fn other_dimensions_of_doubles_are_reached_or_refused() {
    reached_or_refused::<f64>("moved_double", triad);
}

#[test]
fn other_dimensions_of_singles_are_reached_or_refused() {
    reached_or_refused::<f32>("moved_single", triad);
}

#[test]
fn other_dimensions_are_reached_or_refused_over_two_inputs() {
    reached_or_refused::<f64>("moved_grid", |length| over_two_inputs(&triad(length)));
}

#[test]
fn groups_over_no_input_are_refused() {
    let text = triad("261mm")
        .replace("polar(l12, phi)", "polar(l12, 0deg)")
        .replace("velocity(p8)", "phi")
        .replace("e: sensitivity", "phi, e: sensitivity");
    let own = Given::text(&text);
    let refused = sources(&own.name, &own.unit, Real::Double).expect_err("there is no input");
    assert_eq!(
        refused.to_string(),
        "EyeNeedle: phi23, phi34, phi64, phi75 are solved together without a closed form and depend on no input; exported C has such groups over \
         inputs only, a limit of ours. Turn a dimension into an input"
    );
}
