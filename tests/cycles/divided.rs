//! Searches in parts: the optima of one search, for every division and through bytes.

use super::{N, Rocker, RockerAssembly, design, speed, tip};
use linkage::design::{
    BestCycle, Candidate, Chosen, Conditions, CycleDesign, CycleObjective, CyclePart, DesignError,
    Dwell, Figure, Highest, Peak, Stroke,
};
use linkage::tolerance::Tolerances;
use std::sync::atomic::{AtomicBool, Ordering};

type Problem<'a> = CycleDesign<'a, Rocker, RockerAssembly, N>;

/// Ten searches in two assemblies.
fn small<'a>() -> Problem<'a> {
    design()
        .want(Highest(tip()).least())
        .starts(5)
        .seed(3)
        .in_all_assemblies()
}

/// All numbers of the optima, exact as Rust prints them, and a value of each assembly.
fn printed(found: &Result<Vec<BestCycle<Rocker, RockerAssembly>>, DesignError>) -> String {
    let number = |best: &BestCycle<Rocker, RockerAssembly>| {
        let margins = (best.margin, best.margin_at, best.goal, best.converged);
        let counts = (best.steps, best.evaluations, best.hits, &best.at_bound);
        let dimensions = linkage::Dimensions::values(&best.mechanism);
        let tip = best.assembly.tip(0.7).tip;
        format!(
            "{dimensions:?} {:?} {margins:?} {counts:?} {tip:?}\n",
            best.auxiliary
        )
    };
    match found {
        Ok(all) => all.iter().map(number).collect(),
        Err(error) => format!("{error:?}"),
    }
}

/// A goal that adds a condition once, and knows an assembly only with that condition. It sets the
/// flag where it adds the condition.
struct Refined<'a, O>(O, &'a AtomicBool);

impl<O: CycleObjective<Rocker, RockerAssembly, N>> CycleObjective<Rocker, RockerAssembly, N>
    for Refined<'_, O>
{
    fn title(&self) -> String {
        self.0.title()
    }

    fn is_goal(&self) -> bool {
        true
    }

    fn evaluate(
        &self,
        candidate: &Candidate<'_, Rocker, RockerAssembly>,
        chosen: Chosen<'_>,
    ) -> Option<Conditions<N>> {
        self.0.evaluate(candidate, chosen)
    }

    fn known_by(
        &self,
        candidate: &Candidate<'_, Rocker, RockerAssembly>,
        chosen: Chosen<'_>,
    ) -> Option<Vec<f64>> {
        let added = chosen.added.first()?.first()?;
        Some(vec![*added, candidate.motion.assembly.tip(0.7).tip])
    }

    fn refine(
        &self,
        _: &Candidate<'_, Rocker, RockerAssembly>,
        chosen: Chosen<'_>,
    ) -> Vec<Vec<f64>> {
        self.1.store(true, Ordering::Relaxed);
        match chosen.added.is_empty() {
            true => vec![vec![2.5]],
            false => Vec::new(),
        }
    }
}

/// The search in so many parts, each through bytes, the last one first.
fn divided<'a>(problem: &dyn Fn() -> Problem<'a>, of: usize) -> String {
    let (mut done, mut count) = (0, 0);
    let mut whole = problem();
    for k in (0..of).rev() {
        let part = problem().part(k, of).descend().expect("descents");
        (done, count) = (done + part.done(), part.count());
        let read = CyclePart::read(&part.to_bytes());
        assert_eq!(read.as_ref(), Ok(&part));
        whole = whole.known(read.expect("the same"));
    }
    assert_eq!(done, count);
    let mut searched = 0;
    let found = whole.progress(|progress| searched = progress.count);
    let printed = printed(&found.run_all());
    assert_eq!(searched, 0);
    printed
}

#[test]
fn every_division_has_the_same_optima() {
    let wide = Tolerances::new(Rocker::PARAMETERS, &[0.05; N]).expect("as many");
    let worst = || {
        let dwell = Dwell::longest(tip(), 1.0).in_worst_case(&wide);
        design().want(dwell).starts(3)
    };
    let catalogue = || {
        let speed = Peak(speed()).least();
        design()
            .want(speed)
            .catalogue("frame", [138.0, 140.0, 142.0])
    };
    static ADDED: AtomicBool = AtomicBool::new(false);
    let refined = || {
        let goal = Refined(Highest(tip()).least(), &ADDED);
        design().want(goal).starts(3)
    };
    let problems: [&dyn Fn() -> Problem<'static>; 4] = [&small, &worst, &catalogue, &refined];
    for (problem, optima) in problems.into_iter().zip([2, 1, 1, 1]) {
        let whole = problem().run_all();
        assert!(whole.as_ref().is_ok_and(|all| all.len() >= optima));
        for of in [1, 4, 9] {
            assert_eq!(divided(problem, of), printed(&whole), "{of} parts");
        }
    }
}

#[test]
fn parts_have_the_same_descents_on_any_number_of_threads() {
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = pool.build().expect("a pool");
        pool.install(|| {
            let part = small().part(1, 4).descend().expect("descents");
            (part.to_bytes(), printed(&small().known(part).run_all()))
        })
    };
    let one = with(1);
    for threads in [2, 3, 7] {
        assert!(with(threads) == one, "{threads} threads");
    }
}

/// The error of one search, with the numbers of its first start.
#[test]
fn every_division_has_the_same_refusals() {
    let long = || {
        design()
            .want(Peak(speed()).least())
            .want(Stroke(tip()).at_least(1e3))
            .starts(4)
    };
    let whole = printed(&long().run_all());
    assert!(
        whole.contains("NotFound") && whole.contains("nearest"),
        "{whole}"
    );
    for of in [1, 4, 9] {
        assert_eq!(divided(&long, of), whole, "{of} parts");
    }
    let alone = || long().starts(1);
    assert_eq!(divided(&alone, 1), printed(&alone().run_all()));
}

/// An ended search goes on from what it has; a part that is missing is computed.
#[test]
fn missing_descents_are_made() {
    let whole = printed(&small().run_all());
    let stop = AtomicBool::new(false);
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    let begun = one.expect("a pool").install(|| {
        small()
            .cancel(&stop)
            .progress(|_| stop.store(true, Ordering::Relaxed))
            .descend()
    });
    let begun = begun.expect("descents");
    assert!((1..10).contains(&begun.done()), "{}", begun.done());
    assert_eq!(printed(&small().known(begun).run_all()), whole);
    let mut middle = small().part(1, 3).descend().expect("descents");
    let last = small().part(2, 3).descend().expect("descents");
    assert_eq!(middle.merge(&last), Ok(()));
    assert_eq!(middle.merge(&last), Err(DesignError::Repeated));
    assert_eq!(middle.done(), 7);
    assert_eq!(printed(&small().known(middle).run_all()), whole);
    // A cancelled search keeps no descent that it did not finish.
    let cancelled = small().cancel(&stop).descend().expect("descents");
    assert_eq!((cancelled.done(), cancelled.count()), (0, 10));
    let during = AtomicBool::new(false);
    let goal = Refined(Highest(tip()).least(), &during);
    let ended = design().want(goal).cancel(&during).descend();
    assert!(during.load(Ordering::Relaxed));
    assert_eq!(ended.expect("no descents").done(), 0);
}

#[test]
fn other_parts_are_refused() {
    let part = small().part(0, 4).descend().expect("descents");
    let refused = |design: Problem<'_>| design.run_all().err();
    for other in [
        small().seed(1),
        small().starts(6),
        small().steps(299),
        small().positions(61),
        small().vary_by("frame", 0.02),
        small().want(Stroke(tip()).at_most(1e3)),
    ] {
        let taken = other.known(part.clone()).descend().err();
        assert_eq!(taken, Some(DesignError::OtherProblem));
    }
    let alone = design().want(Highest(tip()).least()).starts(5).seed(3);
    assert_eq!(
        refused(alone.known(part.clone())),
        Some(DesignError::OtherProblem)
    );
    let twice = small().known(part.clone()).known(part.clone());
    assert_eq!(refused(twice), Some(DesignError::Repeated));
    for (k, of) in [(4, 4), (0, 0)] {
        let error = Some(DesignError::Part { part: k, of });
        assert_eq!(refused(small().part(k, of)), error);
    }
    let front = design().part(0, 2);
    let compromises = front.front(Highest(tip()).least(), Stroke(tip()).greatest(), 3);
    assert_eq!(compromises.err(), Some(DesignError::Undivided));
    let bytes = part.to_bytes();
    for index in (0..bytes.len()).step_by(37) {
        let mut damaged = bytes.clone();
        damaged[index] ^= 4;
        assert_eq!(CyclePart::read(&damaged), Err(DesignError::NoPart));
    }
    assert_eq!(CyclePart::read(&bytes[..40]), Err(DesignError::NoPart));
}
