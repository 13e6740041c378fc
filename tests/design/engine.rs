//! A mechanism that is compiled at run time leads to the designs of the macro's, to the last bit.

use std::sync::atomic::AtomicBool;

use linkage::design::{Relation, Targets};
use linkage_engine::{DesignProblem, Mechanism, Variable, compile};

use super::LENGTHS;
use super::seeds::problems::{Problem, problems};

const TEXT: &str = include_str!("../../mechanisms/four_bar_paths.rs");

/// Starts of both searches.
const STARTS: usize = 64;

fn mechanism() -> Mechanism {
    let mut all = compile("four_bar_paths.rs", TEXT).expect("no mistake");
    all.pop().expect("one mechanism")
}

/// The problem of the engine that is `Problem::design` of the macro.
fn problem(given: &Problem, mechanism: &Mechanism) -> DesignProblem {
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
                &problem(&given, &mechanism),
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
    let mut wrong = problem(given, &mechanism);
    wrong.variables.push(Variable::By("crnk".to_owned(), 0.1));
    let macros = given
        .design()
        .expect("it assembles")
        .vary_by("crnk", 0.1)
        .run();
    assert_eq!(run(&wrong), macros.expect_err("a mistake").to_string());

    // A function without derivatives by the varied dimensions.
    let mut poor = problem(given, &mechanism);
    poor.targets[0].0 = mechanism.function("poor").expect("a function");
    assert!(run(&poor).contains("sensitivity"), "{}", run(&poor));
}

#[test]
fn a_cancelled_search_ends() {
    let mechanism = mechanism();
    let problem = problem(&problems()[0], &mechanism);
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
