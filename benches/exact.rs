//! Exact synthesis: `cargo bench -p linkage-benches --bench exact`.
//!
//! Five poses, five pairs of turns, five points, a platform on six legs with 40 real assemblies; nine points on one thread and on two. Each listing
//! is asked whether it is complete.

#[path = "../tests/programs/hexapod/platform.rs"]
mod platform;

use linkage::design::exact::{
    Dyads, Functions, Pair, Pose, five_points, nine_points, solutions_traced,
};
use linkage_peers::timing::{Candidate, interleave, only_tested};
use platform::{DIETMAIER, LAST_LEG};
use std::error::Error;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Problem 3 of Wampler, Morgan and Sommese (1992), which has 64 real triples.
const NINE: [[f64; 2]; 9] = [
    [0.25, 0.00],
    [0.52, 0.10],
    [0.80, 0.70],
    [1.20, 1.00],
    [1.40, 1.30],
    [1.10, 1.48],
    [0.70, 1.40],
    [0.20, 1.00],
    [0.02, 0.40],
];

fn main() -> Result<(), Box<dyn Error>> {
    let poses = [
        ([-18.0, 54.9], 54.6),
        ([38.9, 77.8], 69.1),
        ([89.3, 141.0], 57.6),
        ([99.7, 204.2], 32.7),
        ([42.5, 196.5], 24.3),
    ]
    .map(|(point, angle): ([f64; 2], f64)| Pose::new(point, angle.to_radians()));
    // A rocker that turns by the logarithm of its crank's turn.
    let pairs: [Pair; 5] = [0.0, 0.3, 0.6, 0.9, 1.2].map(|input: f64| Pair {
        input,
        output: 0.9 * (1.0 + input).ln(),
    });
    let (fixed, points) = (
        [[0.0, 0.0], [4.0, 0.3]],
        [NINE[0], NINE[2], NINE[4], NINE[6], NINE[8]],
    );
    println!(
        "complete: five poses {}, five pairs {}",
        Dyads::of_poses(&poses)?.certified,
        Functions::of_five(&pairs)?.certified,
    );
    let candidates = vec![
        Candidate::new("five poses", 1, || {
            black_box(Dyads::of_poses(black_box(&poses)).is_ok());
        }),
        Candidate::new("and all four-bars of their pairs", 1, || {
            black_box(
                Dyads::of_poses(black_box(&poses))
                    .map(|dyads| dyads.four_bars())
                    .is_ok(),
            );
        }),
        Candidate::new("five pairs of turns", 1, || {
            black_box(Functions::of_five(black_box(&pairs)).is_ok());
        }),
        Candidate::new("five points of a path", 1, || {
            black_box(five_points(black_box(&points), black_box(fixed)).is_ok());
        }),
    ];
    let time = Duration::from_millis(if only_tested() { 1 } else { 1000 });
    for times in interleave(candidates, time) {
        println!(
            "{:<34} {:10.3} ms",
            times.name,
            1e-6 * times.spread().median
        );
    }
    if only_tested() {
        return Ok(());
    }
    for threads in [1, 2] {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()?;
        let began = Instant::now();
        let found = pool.install(|| solutions_traced(&DIETMAIER, LAST_LEG))?;
        println!(
            "a platform on {threads} threads: {:.2} s, {} real assemblies, complete: {}",
            began.elapsed().as_secs_f64(),
            found.real.len(),
            found.is_complete()
        );
        let began = Instant::now();
        let found = pool.install(|| nine_points(&NINE))?;
        println!(
            "nine points on {threads} threads: {:.2} s, {} real triples, complete: {}",
            began.elapsed().as_secs_f64(),
            found.triples.len(),
            found.is_complete()
        );
    }
    Ok(())
}
