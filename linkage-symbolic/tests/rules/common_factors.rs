//! Sums that are computed as multiples of other sums.

use linkage_random::Random;
use linkage_symbolic::program::Binary;
use linkage_symbolic::{Graph, evaluate, share_common_factors};

use crate::exact::exact;
use crate::formula::{Formula, Operation};
use crate::numbers::{NUMBERS, Symbols, Values};
use crate::{ROUNDOFF, ROUNDS};

/// A sum, a multiple of it, and how many roundings more the one has that is computed from the other.
const MULTIPLES: [([&str; 2], i32); 7] = [
    (["p x + q y", "(p r) x + (q r) y"], 0),
    (["p x + q y", "(p r r) x + (q r r) y"], 0),
    (["p x - q y", "(p r) x - (q r) y"], 0),
    (["p x - q y", "(q r) y - (p r) x"], 0),
    (["p x + q y", "(k p) x + (k q) y"], 0),
    (["(p / r) x + (q / r) y", "p x + q y"], 1),
    // The quotients of 0.1 by 3 and of 0.007 by 0.21 are rounded to one number.
    (["(3 p) x + (0.1 q) y", "(0.21 p) x + (0.007 q) y"], 3),
];

#[test]
fn multiples_are_rounded_as_they_say() {
    let mut random = Random::new(16);
    for (texts, more) in MULTIPLES {
        let parse = |text| Formula::parse(text, Operation::Binary(Binary::Add));
        let sums = texts.map(parse);
        let graph = Graph::new();
        let symbols = Symbols::new(&graph, NUMBERS[0]);
        let plain = [0, 1].map(|k| sums[k].build(&graph, &symbols));
        let shared = share_common_factors(&graph, &plain);
        assert!(shared != plain, "{texts:?}: not shared");
        let nodes: Vec<_> = plain.iter().chain(&shared).map(|&x| graph.ex(x)).collect();
        for _ in 0..ROUNDS {
            let values = Values::new(&mut random, &symbols);
            let results = evaluate(&nodes, |source| values.of_source(source));
            for (k, sum) in sums.iter().enumerate() {
                let (plain, shared) = (results[k], results[k + 2]);
                let told = || format!("{}, {values:?}: {plain:e} became {shared:e}", texts[k]);
                if sum.letters().iter().any(|&x| values.of_letter(x).is_nan()) {
                    assert!(plain.is_nan() && shared.is_nan(), "{}", told());
                }
                let is_finite = |sum: &Formula| sum.in_range(&values).is_some_and(f64::is_finite);
                if sums.iter().all(is_finite) {
                    let limit = f64::from(sum.roundings() + more) * ROUNDOFF;
                    assert!(exact(sum, &values).error(shared) <= limit, "{}", told());
                }
            }
        }
    }
}
