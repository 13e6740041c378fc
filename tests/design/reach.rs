//! What is out of reach: by how much, and what is in the way.

use super::{FourBar, FourBarAssembly, LENGTHS, evenly, points};
use linkage::design::{Design, DesignError, Relation, Targets};

/// Text without its numbers, which are compared on their own.
fn numbers(text: &str) -> (String, Vec<f64>) {
    let mut words = Vec::new();
    let mut found = Vec::new();
    for word in text.split_inclusive([' ', '\n']) {
        let bare = word.trim_end_matches([' ', '\n', ':', ',', ';']);
        match bare.parse::<f64>() {
            Ok(number) => {
                found.push(number);
                words.push(word.replacen(bare, "#", 1));
            }
            Err(_) => words.push(word.to_string()),
        }
    }
    (words.concat(), found)
}

/// Points far away: which of them is missed by how much, in which unit, and which bounds are in the way.
#[test]
fn a_target_out_of_reach() {
    let far: Vec<[f64; 2]> = points(&evenly(0.2, 0.5, 4))
        .iter()
        .map(|[x, y]| [x + 300.0, *y])
        .collect();
    let wish = Targets::new("tracer", far.clone())
        .weights([2.0, 1.0])
        .computed_by(FourBarAssembly::path_sweep_sets_into);
    let design = Design::new(
        FourBar::default(),
        FourBar::assemble,
        FourBar::assemblies,
        FourBar::circuits,
    );
    let shorter = |bar: &FourBar| {
        let mut slopes = [0.0; 9];
        slopes[4] = -1.0;
        (38.0 - bar.arm.x, slopes)
    };
    let design = design
        .expect("it assembles")
        .vary("crank", 5.0, 20.0)
        .vary("base.x", -3.0, 3.0)
        .vary("arm.x", -40.0, 40.0)
        .hold(Relation::at_most([("base.x", 2.0), ("crank", 0.0)], 5.0))
        .hold_that("a short arm", shorter);
    let found = design
        .want(wish)
        .starts(32)
        .run()
        .expect("something is nearest");
    let best = found.best();
    // The farthest of all numbers, with their weights.
    let tracer: Vec<[f64; 2]> = best.inputs[1]
        .iter()
        .map(|&phi| best.assembly.path(phi).tracer.into())
        .collect();
    let misses = tracer
        .iter()
        .zip(&far)
        .map(|(own, far)| (own[0] - far[0]).abs());
    let (position, miss) = misses
        .enumerate()
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .expect("four points");
    let (words, found_numbers) = numbers(&best.to_string());
    let expected = format!(
        "sum of squares #, least margin #\n\
         targets of tracer: farthest by # mm in `tracer.x` at position # of #\n\
         {}the relation 2 base.x + 0 crank <= 5 is in the way\n\
         the condition `a short arm` is in the way\n",
        match best.at_bound.len() {
            0 => "",
            _ => "crank is at its bound # mm: beyond it the sum falls by # per mm\n",
        }
    );
    let expected = numbers(&expected).0;
    assert_eq!(words, expected);
    assert!(
        (found_numbers[2] - miss).abs() < 1e-4 * miss,
        "{found_numbers:?} {miss}"
    );
    assert_eq!(found_numbers[3..5], [position as f64 + 1.0, 4.0]);
    assert!(miss > 200.0 && (best.mechanism.base.x - 2.5).abs() < 1e-9);
    assert!((best.mechanism.arm.x - 38.0).abs() < 1e-6);
    assert!(
        found.to_string().contains("8 residuals, 7 variables"),
        "{found}"
    );
}

fn refused(relations: Vec<Relation>) -> DesignError {
    let wish = Targets::new("tracer", points(&[0.2])).at_inputs([0.2]);
    let design = Design::new(
        FourBar::default(),
        FourBar::assemble,
        FourBar::assemblies,
        FourBar::circuits,
    );
    let lengths = LENGTHS.iter();
    lengths
        .fold(design.expect("it assembles"), |design, name| {
            design.vary(name, 5.0, 60.0)
        })
        .hold(relations)
        .want(wish.computed_by(FourBarAssembly::path_sweep_sets_into))
        .run()
        .expect_err("they contradict each other")
}

/// Of all relations and bounds only those are told without which the others can hold, and by how much they miss.
#[test]
fn relations_that_contradict() {
    // Lengths are between 5 and 60.
    let error = refused(vec![Relation::at_least(
        [("crank", 1.0), ("frame", -2.0)],
        60.0,
    )]);
    assert_eq!(
        error.to_string(),
        "-crank + 2 frame <= -60 cannot hold with `frame` at least 5, `crank` at most 60: it is missed by at least 10; \
         widen one of these bounds, or leave one of these relations"
    );
    let error = refused(vec![
        Relation::at_most([("rocker", 1.0)], 70.0),
        Relation::exactly([("rocker", 1.0), ("coupler", -1.0)], 0.0),
        Relation::at_least([("rocker", 1.0), ("coupler", 1.0)], 90.0),
        Relation::at_most([("rocker", 1.0), ("frame", 1.0)], 42.0),
    ]);
    let DesignError::Contradiction {
        relations,
        bounds,
        missed,
    } = error
    else {
        panic!("{error}");
    };
    assert_eq!(
        relations,
        [
            "rocker - coupler = 0",
            "-rocker - coupler <= -90",
            "rocker + frame <= 42"
        ]
    );
    // A rocker of 45 mm and a frame of 5 mm.
    assert_eq!(bounds, ["`frame` at least 5"]);
    assert!((missed - 8.0).abs() < 1e-6, "{missed}");
}
