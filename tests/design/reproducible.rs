//! A seed gives the same designs, however many threads there are.

use super::{FourBarAssembly, FourBarDesign, evenly, points, problem};
use linkage::design::{DesignError, Targets};
use std::sync::atomic::AtomicBool;
use std::time::Duration;

fn small() -> FourBarDesign {
    let inputs = evenly(0.3, 0.9, 5);
    let moved: Vec<[f64; 2]> = points(&inputs)
        .iter()
        .map(|[x, y]| [x + 3.0 * y.sin(), *y])
        .collect();
    problem()
        .want(Targets::of("tracer", moved).computed_by(FourBarAssembly::path_sweep_sets_into))
        .starts(256)
}

#[test]
fn threads_do_not_matter() {
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .expect("a pool");
        pool.install(|| small().seed(3).run())
            .expect("it can be found")
    };
    let (one, three) = (with(1), with(3));
    assert_eq!(one.designs.len(), three.designs.len());
    for (a, b) in one.designs.iter().zip(&three.designs) {
        assert_eq!(
            (a.mechanism, a.sum, a.start, a.hits),
            (b.mechanism, b.sum, b.start, b.hits)
        );
    }
    assert_eq!(one.evaluations, three.evaluations);
    let other = small().seed(4).run().expect("it can be found");
    assert_ne!(one.best().mechanism, other.best().mechanism);
}

#[test]
fn progress_time_and_cancellation() {
    let mut done = Vec::new();
    let found = small()
        .progress(|p| done.push((p.done, p.count)))
        .run()
        .expect("it can be found");
    assert!(!found.ended_early);
    assert_eq!(done.last(), Some(&(256, 256)));
    assert!(done.windows(2).all(|pair| pair[0].0 < pair[1].0));

    let stop = AtomicBool::new(true);
    let told = Err(DesignError::NotFound(Box::default()));
    assert_eq!(small().cancel(&stop).run().map(|_| ()), told);
    assert_eq!(small().time_limit(Duration::ZERO).run().map(|_| ()), told);
}
