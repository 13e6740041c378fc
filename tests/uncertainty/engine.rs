//! Random mechanisms of the engine are those of the macro, to the last bit.

use std::time::Duration;

use linkage::tolerance::{Distribution, ExtremeSample, MonteCarlo, Tolerances};
use linkage_engine::{Mechanism, RandomResults, RandomStudy, StudyPlan, compile};

use super::{CrankRocker, Outcome, PHI};

const COUNT: usize = 10_000;
const SEED: u64 = 5;

/// The mechanism of this test, by the engine.
fn mechanism() -> Mechanism {
    let mut all = compile("main.rs", include_str!("main.rs")).expect("no mistake");
    let place = all.iter().position(|one| one.name() == "CrankRocker");
    all.swap_remove(place.expect("the mechanism"))
}

fn plan(mechanism: &Mechanism) -> StudyPlan {
    StudyPlan {
        count: COUNT as u64,
        seed: SEED,
        distribution: Distribution::Normal,
        exceptions: vec![(CrankRocker::INDEX_ARM, Distribution::Uniform)],
        part: [0, 1],
        function: mechanism.function("path").expect("a function"),
        arguments: vec![PHI],
        columns: vec![0, 1],
    }
}

/// All of a study.
fn results(mechanism: &Mechanism, plan: &StudyPlan) -> RandomResults {
    let assembly = mechanism.assemble(&mechanism.dimensions());
    let assembly = assembly.expect("it assembles");
    let mut study = RandomStudy::new(&assembly, plan, |_, _| ()).expect("a study");
    while !study.is_done() {
        study.advance(Duration::from_millis(200));
    }
    study.results()
}

#[test]
fn mechanisms_are_those_of_the_macro() -> Outcome {
    let nominal = CrankRocker::default();
    let linkage = nominal.assemble()?;
    let tolerances = Tolerances::complete(CrankRocker::PARAMETERS)?;
    let macros = MonteCarlo::new(COUNT)
        .seed(SEED)
        .distribution_of(CrankRocker::INDEX_ARM, Distribution::Uniform)
        .stream(&nominal, &tolerances, |mechanisms, [x, y]| {
            let rows = linkage.path_sweep_sets(mechanisms, &[PHI]);
            let [px, py] = rows.tracer();
            x.copy_from_slice(px);
            y.copy_from_slice(py);
        })?;

    let mechanism = mechanism();
    let found = results(&mechanism, &plan(&mechanism));
    assert_eq!(found.done(), COUNT as u64);
    assert_eq!(found.missing(), macros.missing());
    for number in [0, 1] {
        assert_eq!(found.statistics(number), macros.statistics(number));
        let part = |part| found.percentile(number, part, 0.95);
        for of in [0.001, 0.5, 0.99] {
            assert_eq!(part(of), macros.percentile(number, of, 0.95));
        }
        let middle = found.statistics(number).mean.value;
        let limits = [middle - 0.01, middle + 0.02];
        assert_eq!(
            found.part_within(number, limits, 0.9),
            macros.part_within(number, limits[0], limits[1], 0.9)
        );
        assert_eq!(
            found.histogram(number, limits, 7),
            macros.histogram(number, limits, 7)
        );
        let extremes = found.extremes(number).expect("values");
        let expected = macros.extremes(number).expect("values");
        for (one, other) in extremes.iter().zip(expected) {
            let ExtremeSample {
                value,
                number,
                dimensions,
            } = other;
            assert_eq!((one.value, one.number), (value, number));
            assert_eq!(one.dimensions, dimensions);
        }
    }
    Ok(())
}

#[test]
fn parts_are_the_whole() {
    let mechanism = mechanism();
    let whole = plan(&mechanism);
    let part = |part| StudyPlan {
        part: [part, 3],
        ..plan(&mechanism)
    };
    let mut united = results(&mechanism, &part(2));
    assert!(united.done() < COUNT as u64);
    for other in [0, 1] {
        let bytes = results(&mechanism, &part(other)).to_bytes();
        united.merge(&bytes).expect("another part");
        assert!(united.merge(&bytes).is_err());
    }
    let whole = results(&mechanism, &whole);
    assert_eq!(united.to_bytes(), whole.to_bytes());
    let again = united.read(&whole.to_bytes()).expect("the same study");
    assert_eq!(again.statistics(0), whole.statistics(0));

    let other = StudyPlan {
        seed: SEED + 1,
        ..plan(&mechanism)
    };
    assert!(
        united
            .read(&results(&mechanism, &other).to_bytes())
            .is_err()
    );
}

#[test]
fn impossible_studies_are_refused() {
    let mechanism = mechanism();
    let refused = |plan: &StudyPlan| {
        let assembly = mechanism.assemble(&mechanism.dimensions());
        let assembly = assembly.expect("it assembles");
        let refused = RandomStudy::new(&assembly, plan, |_, _| ()).err();
        refused.expect("a mistake").to_string()
    };
    let without = StudyPlan {
        columns: Vec::new(),
        ..plan(&mechanism)
    };
    assert_eq!(refused(&without), "0 numbers, where a study has 1 to 4");
    let beyond = StudyPlan {
        part: [3, 3],
        ..plan(&mechanism)
    };
    assert!(refused(&beyond).contains("part"), "{}", refused(&beyond));
    let nothing = StudyPlan {
        count: 0,
        ..plan(&mechanism)
    };
    assert!(refused(&nothing).contains("mechanisms"));
}
