//! Floats at many turns: tables of coupled groups lose positions there, as the page says, and doubles do not.

use std::f64::consts::TAU;

use linkage_corpus::given::{Given, golden};

use crate::batch::{Batch, Number, Request, UNOPTIMISED};
use crate::machine::Compiler;

const POSITIONS: usize = 360;

/// How many positions of a turn have no number, so many turns on.
fn missing<T: Number>(batch: &Batch, given: &[Given], turns: u32) -> usize {
    let unit = &given[0].unit;
    let function = unit.functions.iter().position(|own| own.name == "motion");
    let function = function.expect("it has a motion");
    let dimensions: Vec<T> = unit.scalars().map(|own| T::from_f64(own.nominal)).collect();
    let request = |k: usize| Request {
        mechanism: 0,
        function,
        dimensions: dimensions.clone(),
        arguments: vec![T::from_f64(
            TAU * (f64::from(turns) + (k as f64 + 0.5) / POSITIONS as f64),
        )],
    };
    let requests: Vec<Request<T>> = (0..POSITIONS).map(request).collect();
    let results = batch.run(given, &requests).into_iter();
    results
        .filter(|(_, row)| row.iter().any(|x| x.lane(0).is_nan()))
        .count()
}

#[test]
fn tables_of_floats_lose_positions_from_650_turns_on() {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let given: Vec<Given> = golden()
        .into_iter()
        .filter(|own| own.name == "EyeNeedle")
        .collect();
    let single = Batch::new::<f32>(&compiler, "turns_single", &given, &UNOPTIMISED);
    let double = Batch::new::<f64>(&compiler, "turns_double", &given, &UNOPTIMISED);
    let counts = [0, 1, 100, 512, 640, 1000, 1024, 2048]
        .map(|turns| (turns, missing::<f32>(&single, &given, turns)));
    println!("{counts:?} of {POSITIONS}");
    for (turns, count) in counts {
        let share = count as f64 / POSITIONS as f64;
        let expected = match turns {
            1000 => 0.09,
            1024 => 0.18,
            2048 => 0.58,
            _ => 0.0,
        };
        assert!((share - expected).abs() < 0.03, "{turns} turns: {share}");
        assert_eq!(missing::<f64>(&double, &given, turns), 0, "{turns} turns");
    }
}
