//! Searches in parts: the listing of one search, for every division and through bytes.

use super::super::super::error::Unsolved;
use super::super::{NinePointsPart, NinePointsSearch, TRIPLES, nine_points};
use super::{PROBLEM_3, Planted, Problems};
use linkage_random::Random;
use std::vec::Vec;

/// A search along nine of the paths, of which three of problem 3 end at real solutions.
fn small<'a>(points: &[[f64; 2]; 9]) -> NinePointsSearch<'a> {
    let mut search = NinePointsSearch::new(points).expect("points");
    let starts = search.starts.iter().skip(150).step_by(9);
    search.starts = starts.take(9).copied().collect();
    search
}

/// The parts of a search, each through bytes, the last one first.
fn parts(search: &dyn Fn() -> NinePointsSearch<'static>, of: usize) -> Vec<NinePointsPart> {
    let part = |k: usize| {
        let part = search().part(k, of).follow().expect("paths");
        let read = NinePointsPart::read(&part.to_bytes());
        assert_eq!(read.as_ref(), Ok(&part));
        read.expect("the same")
    };
    (0..of).rev().map(part).collect()
}

#[test]
fn every_division_has_the_same_four_bars() {
    let search = || small(&PROBLEM_3);
    let one = search().follow().expect("paths");
    assert_eq!((one.done(), one.count()), (9, TRIPLES));
    let whole = search().run().expect("a listing");
    assert_eq!((whole.triples.len(), whole.complex), (3, 6));
    for of in [1, 4, 9] {
        let parts = parts(&search, of);
        let mut merged = parts[0].clone();
        for part in &parts[1..] {
            assert_eq!(merged.merge(part), Ok(()));
        }
        assert_eq!(merged, one);
        let listing = parts.into_iter().fold(search(), NinePointsSearch::known);
        assert_eq!(listing.run().as_ref(), Ok(&whole), "{of} parts");
    }
}

/// A search that is ended goes on from what it has, and paths without an end are followed again.
#[test]
fn missing_paths_are_followed() {
    let points = Planted::new(&mut Random::new(11)).points();
    let whole = small(&points).run().expect("a listing");
    let ended = small(&points)
        .progress(|progress| progress.done > 0)
        .follow();
    assert_eq!(ended.expect("a part").done(), 0);
    let known = small(&points).part(1, 3).follow().expect("paths");
    assert_eq!(known.done(), 3);
    assert_eq!(
        small(&points).known(known.clone()).run().as_ref(),
        Ok(&whole)
    );
    // A known end counts as it is.
    let mut doubtful = known.clone();
    let (certificate, _) = doubtful.ends.values_mut().flatten().next().expect("an end");
    certificate.real = None;
    let listing = small(&points).known(doubtful).run().expect("a listing");
    assert_eq!(listing.undecided, whole.undecided + 1);
    let mut lost = known;
    let end = lost.ends.values_mut().next().expect("a path");
    assert!(end.take().is_some());
    let read = NinePointsPart::read(&lost.to_bytes());
    assert_eq!(read.as_ref(), Ok(&lost));
    assert_eq!(small(&points).known(lost).run(), Ok(whole));
}

#[test]
fn other_parts_are_refused() {
    let part = small(&PROBLEM_3).part(0, 4).follow().expect("paths");
    let mut moved = PROBLEM_3;
    moved[3][1] += 1e-9;
    let other = small(&moved).known(part.clone());
    assert_eq!(other.run(), Err(Unsolved::OtherProblem));
    let twice = small(&PROBLEM_3).known(part.clone()).known(part.clone());
    assert_eq!(twice.follow(), Err(Unsolved::Repeated));
    for (k, of) in [(4, 4), (0, 0)] {
        let refused = small(&PROBLEM_3).part(k, of).follow();
        assert_eq!(refused, Err(Unsolved::Part { part: k, of }));
    }
    let bytes = part.to_bytes();
    for index in (0..bytes.len()).step_by(37) {
        let mut damaged = bytes.clone();
        damaged[index] ^= 4;
        assert_eq!(NinePointsPart::read(&damaged), Err(Unsolved::NoPart));
    }
    assert_eq!(NinePointsPart::read(&bytes[..40]), Err(Unsolved::NoPart));
}

/// Whole searches of a published problem and of a planted one.
#[test]
fn whole_searches_in_parts() {
    if !linkage_random::is_long() {
        return;
    }
    for points in [PROBLEM_3, Problems::new().next().0.points()] {
        let whole = nine_points(&points).expect("a listing");
        for of in [1, 4, 9] {
            let search = || NinePointsSearch::new(&points).expect("points");
            let parts = parts(&search, of);
            let listing = parts.into_iter().fold(search(), NinePointsSearch::known);
            assert_eq!(listing.run().as_ref(), Ok(&whole), "{of} parts");
        }
    }
}
