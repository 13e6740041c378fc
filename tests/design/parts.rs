//! The same designs by other ways: searches in parts, and mechanisms that are compiled at run time.

use super::reproducible::problems::{Problem, problems};
use super::{FourBar, FourBarAssembly, FourBarDesign, LENGTHS, evenly, points, problem};
use linkage::design::exact::NinePointsSearch;
use linkage::design::{DesignError, DesignPart, Objective, Relation, Targets};
use linkage_engine::{DesignProblem, Mechanism, Variable, compile};
use std::sync::atomic::{AtomicBool, Ordering};

// Searches in parts: the designs of one search, for every division and through bytes.

/// Points that no four-bar with this arm passes through, moved so far.
fn moved(by: f64) -> impl Objective<FourBar, FourBarAssembly> {
    let inputs = evenly(0.3, 0.9, 5);
    let moved: Vec<[f64; 2]> = points(&inputs)
        .iter()
        .map(|[x, y]| [x + by * y.sin(), *y])
        .collect();
    Targets::new("tracer", moved).computed_by(FourBarAssembly::path_sweep_sets_into)
}

/// 300 starts: the last block is not full.
fn small<'a>() -> FourBarDesign<'a> {
    problem().want(moved(3.0)).starts(300)
}

#[test]
fn every_division_has_the_same_designs() {
    let whole = small().run().expect("it can be found");
    assert!(whole.designs.len() > 4 && whole.refused > 0);
    for of in [1, 4, 9] {
        let mut done = 0;
        let mut design = small();
        // The last part comes first, each through bytes.
        for k in (0..of).rev() {
            let part = small().part(k, of).descend().expect("descents");
            done += part.done();
            assert_eq!(part.count(), 300);
            let read = DesignPart::read(&part.to_bytes());
            assert_eq!(read.as_ref(), Ok(&part));
            design = design.known(read.expect("the same"));
        }
        assert_eq!(done, 300);
        let mut evaluated = 0;
        let design = design.progress(|progress| evaluated = progress.count);
        assert_eq!(design.run().expect("it can be found"), whole, "{of} parts");
        assert_eq!(evaluated, 0);
    }
}

/// An ended search goes on from what it has; a part that is missing is computed.
#[test]
fn missing_descents_are_made() {
    let whole = small().run().expect("it can be found");
    let stop = AtomicBool::new(false);
    let begun = small()
        .cancel(&stop)
        .progress(|_| stop.store(true, Ordering::Relaxed))
        .descend()
        .expect("descents");
    assert!((1..300).contains(&begun.done()), "{}", begun.done());
    assert_eq!(small().known(begun).run(), Ok(whole.clone()));
    let middle = small().part(1, 3).descend().expect("descents");
    assert_eq!(small().known(middle).run(), Ok(whole));
}

#[test]
fn other_parts_are_refused() {
    let part = small().part(0, 4).descend().expect("descents");
    let refused = |design: FourBarDesign<'_>| design.descend().err();
    for other in [
        small().seed(1),
        small().starts(301),
        small().steps(299),
        small().vary("arm.x", 5.0, 60.0),
        problem().want(moved(3.001)).starts(300),
    ] {
        assert_eq!(
            refused(other.known(part.clone())),
            Some(DesignError::OtherProblem)
        );
    }
    let twice = small().known(part.clone()).known(part.clone());
    assert_eq!(refused(twice), Some(DesignError::Repeated));
    for (k, of) in [(4, 4), (0, 0)] {
        assert_eq!(
            refused(small().part(k, of)),
            Some(DesignError::Part { part: k, of })
        );
    }
    let bytes = part.to_bytes();
    for index in (0..bytes.len()).step_by(37) {
        let mut damaged = bytes.clone();
        damaged[index] ^= 4;
        assert_eq!(DesignPart::read(&damaged), Err(DesignError::NoPart));
    }
    assert_eq!(DesignPart::read(&bytes[..40]), Err(DesignError::NoPart));
}

/// Searches of designs and of nine points: a part has the same bytes.
#[test]
fn parts_have_the_same_bytes_on_any_number_of_threads() {
    let points: [[f64; 2]; 9] = std::array::from_fn(|k| [k as f64, (k * k % 7) as f64]);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = pool.build().expect("a pool");
        pool.install(|| {
            let descents = small().part(1, 4).descend().expect("descents");
            let search = NinePointsSearch::new(&points).expect("points");
            let paths = search.part(20, 150).follow().expect("paths");
            assert_eq!((descents.done(), paths.done()), (96, 9));
            [descents.to_bytes(), paths.to_bytes()]
        })
    };
    let one = with(1);
    for threads in [2, 3, 7] {
        assert!(with(threads) == one, "{threads} threads");
    }
}

// A mechanism that is compiled at run time leads to the designs of the macro's, to the last bit.

const TEXT: &str = include_str!("../../mechanisms/four_bar_paths.rs");

/// Starts of both searches.
const STARTS: usize = 64;

fn mechanism() -> Mechanism {
    let mut all = compile("four_bar_paths.rs", TEXT).expect("no mistake");
    all.pop().expect("one mechanism")
}

/// The problem of the engine that is `Problem::design` of the macro.
fn engine_problem(given: &Problem, mechanism: &Mechanism) -> DesignProblem {
    let [low, high] = given.lengths;
    let between = |name: &str, low, high| Variable::Between(name.to_owned(), low, high);
    let mut variables: Vec<Variable> = Vec::from(LENGTHS.map(|name| between(name, low, high)));
    variables.extend(["arm.x", "arm.y"].map(|name| between(name, -given.arm, given.arm)));
    if given.base > 0.0 {
        variables.extend(["base.x", "base.y"].map(|name| between(name, -given.base, given.base)));
        variables.push(between("tilt", 0.0, std::f64::consts::TAU));
    }
    let points = given.points.iter().copied();
    let targets = Targets::new("tracer", points).timing(given.timing.clone());
    DesignProblem {
        variables,
        relations: Relation::crank_turns(LENGTHS, 0.0),
        targets: vec![(mechanism.function("path").expect("a function"), targets)],
        starts: Some(STARTS),
        ..DesignProblem::default()
    }
}

#[test]
fn designs_are_those_of_the_macro() {
    let mechanism = mechanism();
    for given in problems() {
        let macros = given.design().expect("it assembles").starts(STARTS);
        let macros = macros.run().expect("designs");
        let found = mechanism
            .design(
                &mechanism.dimensions(),
                &engine_problem(&given, &mechanism),
                &AtomicBool::new(false),
                |_| (),
            )
            .expect("designs");
        assert_eq!(found.to_string(), macros.to_string(), "{}", given.name);
        for (one, other) in found.designs.iter().zip(&macros.designs) {
            let dimensions = linkage::Dimensions::values(&other.mechanism);
            assert_eq!(one.mechanism, dimensions, "{}", given.name);
            assert_eq!(one.sum.to_bits(), other.sum.to_bits(), "{}", given.name);
            assert_eq!(one.inputs, other.inputs, "{}", given.name);
            assert_eq!(one.residuals, other.residuals, "{}", given.name);
            assert_eq!(one.to_string(), other.to_string(), "{}", given.name);
        }
    }
}

#[test]
fn mistakes_are_those_of_the_macro() {
    let mechanism = mechanism();
    let given = &problems()[1];
    let run = |problem: &DesignProblem| {
        let dimensions = mechanism.dimensions();
        let found = mechanism.design(&dimensions, problem, &AtomicBool::new(false), |_| ());
        found.expect_err("a mistake").to_string()
    };
    let mut wrong = engine_problem(given, &mechanism);
    wrong.variables.push(Variable::By("crnk".to_owned(), 0.1));
    let macros = given
        .design()
        .expect("it assembles")
        .vary_by("crnk", 0.1)
        .run();
    assert_eq!(run(&wrong), macros.expect_err("a mistake").to_string());

    // A function without derivatives by the varied dimensions.
    let mut poor = engine_problem(given, &mechanism);
    poor.targets[0].0 = mechanism.function("poor").expect("a function");
    assert!(run(&poor).contains("sensitivity"), "{}", run(&poor));
}

#[test]
fn a_cancelled_search_ends() {
    let mechanism = mechanism();
    let problem = engine_problem(&problems()[0], &mechanism);
    let cancelled = AtomicBool::new(true);
    let found = mechanism.design(&mechanism.dimensions(), &problem, &cancelled, |_| ());
    let message = found.expect_err("no design").to_string();
    assert!(message.contains("cancel"), "{message}");
}

#[test]
fn other_mechanisms_are_refused() {
    let text = "pub struct Lever { unit mm; param l = 50mm; input phi = 30deg;
        let p = polar(l, phi); } impl Lever { pub fn f(phi) -> F { p } }";
    let mechanism = Mechanism::compile(text).expect("no mistake");
    let nothing = DesignProblem::default();
    let found = mechanism.design(&[50.0], &nothing, &AtomicBool::new(false), |_| ());
    let message = found.expect_err("no loops").to_string();
    assert_eq!(
        message,
        "a search is for mechanisms with one input and loops: Lever has 1 inputs and 0 groups"
    );
}
