//! Derivatives of powers and quotients in C against differences of positions in C.

use linkage_corpus::given::Given;
use linkage_corpus::quotients::{Precision, Quotients};

use crate::batch::{Batch, Number, Request};
use crate::machine::Compiler;

/// Seeds of random mechanisms.
const RANDOM: std::ops::RangeInclusive<u64> = 101..=106;

fn compare<T: Number>(language: &str, precision: Precision) {
    let Some(compiler) = Compiler::find() else {
        return;
    };
    let mut all = vec![Quotients::written()];
    all.extend(RANDOM.map(Quotients::random));
    let given: Vec<Given> = all.iter().map(|own| own.given.clone()).collect();
    let folder = format!("quotients_{}", T::REAL.name());
    let batch = Batch::new::<T>(&compiler, &folder, &given, &["-O1"]);
    for (mechanism, own) in all.iter().enumerate() {
        let numbers = |own: &[f64]| own.iter().map(|&x| T::from_f64(x)).collect();
        let requests = own.calls(precision).into_iter().map(|call| Request {
            mechanism,
            function: 0,
            dimensions: numbers(&call.dimensions),
            arguments: numbers(&[call.degrees.to_radians()]),
        });
        let results = batch.run::<T>(&given, &requests.collect::<Vec<_>>());
        let results = results.iter().map(|(code, own)| {
            assert_eq!(*code, 0, "it closes");
            own.iter().map(|x| x.lane(0)).collect()
        });
        own.check(language, precision, &results.collect::<Vec<_>>());
    }
}

#[test]
fn derivatives_are_differences_in_doubles() {
    compare::<f64>("C, double", Precision::DOUBLE);
}

#[test]
fn derivatives_are_differences_in_singles() {
    compare::<f32>("C, float", Precision::SINGLE);
}
