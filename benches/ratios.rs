//! Generated code against hand-derived C, both timed in turn, kernel by kernel:
//! `cargo bench --bench ratios`, with the instruction set that the goals are stated for:
//! `RUSTFLAGS="-C target-cpu=x86-64-v3" cargo bench --bench ratios`.
//!
//! "Single" is one position at a time: no function is inlined into the loop, in either language, and
//! the compiler cannot see who reads the result. "Latency" makes each input wait for the result before
//! it. "Sweep" is `*_sweep_into`, beside the same kernels in C as vector code with a sine of their own,
//! for the best instruction set of the machine.

use linkage_peers::timing::{Candidate, Spread, Times, clock, interleave, only_tested};
use linkage_peers::{c, mechanisms as m};
use std::hint::black_box;
use std::time::Duration;

/// Positions in one run.
const POSITIONS: usize = 1024;

/// What the goals of the project are: time of a single call over that of C.
const GOALS: [(&str, f64); 6] = [
    ("K1a", 0.55),
    ("K1b", 0.75),
    ("K1c", 0.75),
    ("K2a", 0.68),
    ("K2b", 0.75),
    ("K2c", 0.75),
];

/// Times of one kernel: C, ours, both again by latency, both sweeps, the clock.
struct Row {
    c: Times,
    ours: Times,
    c_latency: Times,
    ours_latency: Times,
    sweep: Times,
    c_sweep: Times,
    clock: Times,
}

fn main() {
    let time = Duration::from_millis(if only_tested() { 1 } else { 2500 });
    let one = m::K1::default();
    let two = m::K2::default();
    let (k1, c1) = (
        one.assemble().expect("K1 assembles"),
        c::K1::new(m::dimensions1(&one)),
    );
    let (k2, c2) = (
        two.assemble().expect("K2 assembles"),
        c::K2::new(m::dimensions2(&two)),
    );
    let step = std::f64::consts::TAU / POSITIONS as f64;
    let angles: Vec<f64> = (0..POSITIONS)
        .map(|i| (i * 619 % POSITIONS) as f64 * step)
        .collect();
    let angles = &angles;

    macro_rules! rows {
        ($($linkage:ident $c:ident $assembly:ident $function:ident $sweep:ident
           $result:ident.$point:ident $columns:ident $numbers:ty),* $(,)?) => {
            [$({
                #[inline(never)]
                fn ours(linkage: &m::$assembly, phi: f64) -> m::$result {
                    linkage.$function(phi)
                }
                let mut x = 0.0;
                let mut numbers: $numbers = $linkage.$function(angles[0]).into();
                let mut last = numbers;
                let mut columns = $linkage.$sweep(angles);
                let mut blocks = c::sweep::Columns::new(numbers.len(), POSITIONS);
                let mut times = interleave(
                    vec![
                        Candidate::new("C", POSITIONS, || {
                            for &phi in angles {
                                $c.$function(phi, &mut numbers);
                                black_box(&mut numbers);
                            }
                        }),
                        Candidate::new("ours", POSITIONS, || {
                            for &phi in angles {
                                black_box(&ours(&$linkage, phi));
                            }
                        }),
                        Candidate::new("C, latency", POSITIONS, || {
                            for &phi in angles {
                                $c.$function(phi + after(last[0]), &mut last);
                                black_box(&mut last);
                            }
                        }),
                        Candidate::new("ours, latency", POSITIONS, || {
                            for &phi in angles {
                                let result = ours(&$linkage, phi + after(x));
                                black_box(&result);
                                x = result.$point.x;
                            }
                        }),
                        Candidate::new("sweep", POSITIONS, || {
                            $linkage.$columns(black_box(angles), &mut columns);
                            black_box(&mut columns);
                        }),
                        Candidate::new("sweep in C", POSITIONS, || {
                            $c.$sweep(black_box(angles), &mut blocks);
                            black_box(&mut blocks);
                        }),
                        clock(),
                    ],
                    time,
                ).into_iter();
                let mut next = || times.next().expect("a time for each candidate");
                Row {
                    c: next(),
                    ours: next(),
                    c_latency: next(),
                    ours_latency: next(),
                    sweep: next(),
                    c_sweep: next(),
                    clock: next(),
                }
            }),*]
        };
    }
    let rows = rows![
        k1 c1 K1Assembly point point_sweep K1Point.tracer point_sweep_into linkage_peers::Position,
        k1 c1 K1Assembly motion motion_sweep K1Motion.tracer motion_sweep_into linkage_peers::Motion,
        k1 c1 K1Assembly accuracy accuracy_sweep K1Accuracy.tracer accuracy_sweep_into linkage_peers::Sensitivities1,
        k2 c2 K2Assembly point point_sweep K2Point.p10 point_sweep_into linkage_peers::Position,
        k2 c2 K2Assembly motion motion_sweep K2Motion.p10 motion_sweep_into linkage_peers::Motion,
        k2 c2 K2Assembly accuracy accuracy_sweep K2Accuracy.p10 accuracy_sweep_into linkage_peers::Sensitivities2,
    ];
    print(&rows);
}

/// Nothing, but not before `x` is known.
#[inline(always)]
fn after(x: f64) -> f64 {
    black_box(0.0) * x
}

fn print(rows: &[Row]) {
    let fused = if cfg!(target_feature = "fma") {
        "with"
    } else {
        "without"
    };
    println!("Built {fused} fused multiply-add. Medians (quartiles); c = core cycles.\n");
    println!(
        "One position    ours/C               goal      latency, ours/C      C, ns (c)       ours, ns (c)"
    );
    for ((name, goal), row) in GOALS.iter().zip(rows) {
        let ratio = row.ours.ratio(&row.c);
        println!(
            "{name:<14}  {ratio:<19.3}  {goal:4.2} {:<3}  {:<19.3}  {}  {}",
            if ratio.median <= *goal { "met" } else { "" },
            row.ours_latency.ratio(&row.c_latency),
            cost(&row.c, &row.clock),
            cost(&row.ours, &row.clock),
        );
    }
    let set = c::sweep::instruction_set().unwrap_or("single calls");
    println!(
        "\nSweep           ours/C in {set:<9}  ours/C, one position  C, ns (c)       ours, ns (c)"
    );
    for ((name, _), row) in GOALS.iter().zip(rows) {
        println!(
            "{name:<14}  {:<19.3}  {:<20.4}  {}  {}",
            row.sweep.ratio(&row.c_sweep),
            row.sweep.ratio(&row.c),
            cost(&row.c_sweep, &row.clock),
            cost(&row.sweep, &row.clock),
        );
    }
    let rounds = rows.iter().flat_map(|row| &row.clock.rounds);
    println!(
        "\nclock {:.2} GHz",
        Spread::of(rounds.map(|time| 1.0 / time))
    );
}

/// Nanoseconds and cycles per position.
fn cost(times: &Times, clock: &Times) -> String {
    let (time, cycles) = (times.spread().median, times.ratio(clock).median);
    format!("{time:6.2} ({cycles:5.1})")
}
