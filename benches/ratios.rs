//! Generated code against hand-derived C, both timed in turn, kernel by kernel:
//! `cargo bench -p linkage-benches --bench ratios`, with the instruction set that the goals are stated for:
//! `RUSTFLAGS="-C target-cpu=x86-64-v3" cargo bench -p linkage-benches --bench ratios`.
//!
//! "Single" is one position at a time, in random order: no function is inlined into the loop, in either language, and
//! the compiler cannot see who reads the result. "Latency" makes each input wait for the result before
//! it. C is compiled for the very machine and knows the dimensions, while ours takes them at run time; "own sine" is the same C with the
//! project's sine instead of that of the C library. "Sweep" is `*_sweep_into`, beside the same kernels in C as vector code with a sine of their own,
//! for the best instruction set of the machine; both are repeated, and timed apart from single calls.
//!
//! "Exported" is the same mechanism as `linkage-c` prints it, one position at a time, on a machine with fused multiply-adds
//! those of `--scalar fused`, compiled for that machine; its goal is 1.1 of ours. "Exported sweep" is the sweep of `--scalar double`,
//! compiled by `-O3 -march=native` alone, into rows; its goal is 1.5 of our sweep.
//!
//! The numbers of all are compared before they are timed.

use linkage_peers::timing::{Candidate, Spread, Times, clock, interleave, only_tested};
use linkage_peers::{Random, c, exported, mechanisms as m, space as s};
use std::hint::black_box;
use std::time::Duration;

/// Positions in one run.
const POSITIONS: usize = 1024;

/// Sweeps in one run, one behind the other: wide vectors come up to speed some microseconds after other code, and a sweep takes
/// only a few.
const REPEATS: usize = 16;

/// What the goals of the project are: time of a single call over that of C.
const GOALS: [(&str, Option<f64>); 12] = [
    ("K1a", Some(0.46)),
    ("K1b", Some(0.58)),
    ("K1c", Some(0.54)),
    ("K2a", Some(0.62)),
    ("K2b", Some(0.68)),
    ("K2c", Some(0.68)),
    ("K3a", None),
    ("K3b", None),
    ("K3c", None),
    ("K4a", None),
    ("K4b", None),
    ("K4c", None),
];

/// What exported C may take of the time of ours.
const EXPORTED: f64 = 1.1;

/// What an exported sweep may take of the time of ours.
const EXPORTED_SWEEP: f64 = 1.5;

/// What a sweep of a plane mechanism may take of the time of C in vectors, which has no guards.
const SWEEP: f64 = 1.0;

/// Times of one kernel: C, C with our sine, ours, exported C, the first three again by latency; both sweeps in rounds of their own; the
/// clock in each of them.
struct Row {
    c: Times,
    own_sine: Times,
    ours: Times,
    exported: Times,
    c_latency: Times,
    own_sine_latency: Times,
    ours_latency: Times,
    clock: Times,
    sweep: Times,
    c_sweep: Times,
    exported_sweep: Times,
    sweep_clock: Times,
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
    let three = s::K3::default();
    let four = s::K4::default();
    let (k3, c3) = (
        three.assemble().expect("K3 assembles"),
        c::space::K3::new(s::dimensions3(&three)),
    );
    let (k4, c4) = (
        four.assemble().expect("K4 assembles"),
        c::space::K4::new(s::dimensions4(&four)),
    );
    let e1 = exported::K1::new(m::dimensions1(&one));
    let e2 = exported::K2::new(m::dimensions2(&two));
    let e3 = exported::K3::new(s::dimensions3(&three));
    let e4 = exported::K4::new(s::dimensions4(&four));
    let mut random = Random::new(17);
    let mut all = |step: f64| -> [f64; POSITIONS] {
        let mut order: [usize; POSITIONS] = std::array::from_fn(|i| i);
        for i in 1..POSITIONS {
            order.swap(i, random.between(0.0, (i + 1) as f64) as usize);
        }
        order.map(|i| i as f64 * step)
    };
    let phi = &all(step);
    let [x, y, z] = &[(); 3].map(|()| all(step / 6.0));

    macro_rules! rows {
        ($($folded:ident $linkage:ident $c:ident $exported:ident $assembly:ident $function:ident $sweep:ident
           $module:ident $result:ident.$point:ident $columns:ident $numbers:ty;
           $first:ident $($more:ident)*),* $(,)?) => {
            [$({
                #[inline(never)]
                fn ours(linkage: &$module::$assembly, $first: f64, $($more: f64),*) -> $module::$result {
                    linkage.$function($first, $($more),*)
                }
                let mut before = 0.0;
                let mut numbers: $numbers = [0.0; _];
                for i in 0..POSITIONS {
                    $c.$function($first[i], $($more[i],)* &mut numbers);
                    agree(&numbers, &<$numbers>::from($linkage.$function($first[i], $($more[i]),*)));
                    for own_sine in [false, true] {
                        let mut folded: $numbers = [0.0; _];
                        match own_sine {
                            false => c::folded::$folded::<false>.$function($first[i], $($more[i],)* &mut folded),
                            true => c::folded::$folded::<true>.$function($first[i], $($more[i],)* &mut folded),
                        }
                        agree(&numbers, &folded);
                    }
                    agree(&numbers, &$exported.$function($first[i], $($more[i]),*).0);
                }
                let mut last = numbers;
                let mut own = numbers;
                let mut beside = numbers;
                let mut columns = $linkage.$sweep($first, $($more),*);
                let mut blocks = c::sweep::Columns::new(numbers.len(), POSITIONS);
                let mut rows = [{ let none: $numbers = [0.0; _]; none }; POSITIONS];
                $exported.$sweep($first, $($more,)* &mut rows);
                for (i, row) in rows.iter().enumerate() {
                    agree(row, &$exported.$function($first[i], $($more[i]),*).0);
                }
                let mut times = interleave(
                    vec![
                        Candidate::new("C", POSITIONS, || {
                            for i in 0..POSITIONS {
                                c::folded::$folded::<false>.$function($first[i], $($more[i],)* &mut numbers);
                                black_box(&mut numbers);
                            }
                        }),
                        Candidate::new("C, own sine", POSITIONS, || {
                            for i in 0..POSITIONS {
                                c::folded::$folded::<true>.$function($first[i], $($more[i],)* &mut beside);
                                black_box(&mut beside);
                            }
                        }),
                        Candidate::new("ours", POSITIONS, || {
                            for i in 0..POSITIONS {
                                black_box(&ours(&$linkage, $first[i], $($more[i]),*));
                            }
                        }),
                        Candidate::new("exported C", POSITIONS, || {
                            for i in 0..POSITIONS {
                                black_box(&$exported.$function($first[i], $($more[i]),*));
                            }
                        }),
                        Candidate::new("C, latency", POSITIONS, || {
                            for i in 0..POSITIONS {
                                c::folded::$folded::<false>.$function($first[i] + after(last[0]), $($more[i],)* &mut last);
                                black_box(&mut last);
                            }
                        }),
                        Candidate::new("C, own sine, latency", POSITIONS, || {
                            for i in 0..POSITIONS {
                                c::folded::$folded::<true>.$function($first[i] + after(own[0]), $($more[i],)* &mut own);
                                black_box(&mut own);
                            }
                        }),
                        Candidate::new("ours, latency", POSITIONS, || {
                            for i in 0..POSITIONS {
                                let result = ours(&$linkage, $first[i] + after(before), $($more[i]),*);
                                black_box(&result);
                                before = result.$point.x;
                            }
                        }),
                        clock(),
                    ],
                    time,
                ).into_iter();
                let mut sweeps = interleave(
                    vec![
                        Candidate::new("sweep", POSITIONS * REPEATS, || {
                            for _ in 0..REPEATS {
                                $linkage.$columns(black_box($first), $($more,)* &mut columns);
                                black_box(&mut columns);
                            }
                        }),
                        Candidate::new("sweep in C", POSITIONS * REPEATS, || {
                            for _ in 0..REPEATS {
                                $c.$sweep(black_box($first), $($more,)* &mut blocks);
                                black_box(&mut blocks);
                            }
                        }),
                        Candidate::new("exported sweep", POSITIONS * REPEATS, || {
                            for _ in 0..REPEATS {
                                $exported.$sweep(black_box($first), $($more,)* &mut rows);
                                black_box(&mut rows);
                            }
                        }),
                        clock(),
                    ],
                    time / 4,
                ).into_iter();
                let mut next_sweep = || sweeps.next().expect("a time for each candidate");
                let mut next = || times.next().expect("a time for each candidate");
                Row {
                    c: next(),
                    own_sine: next(),
                    ours: next(),
                    exported: next(),
                    c_latency: next(),
                    own_sine_latency: next(),
                    ours_latency: next(),
                    clock: next(),
                    sweep: next_sweep(),
                    c_sweep: next_sweep(),
                    exported_sweep: next_sweep(),
                    sweep_clock: next_sweep(),
                }
            }),*]
        };
    }
    let rows = rows![
        K1 k1 c1 e1 K1Assembly point point_sweep m K1Point.tracer point_sweep_into linkage_peers::Position; phi,
        K1 k1 c1 e1 K1Assembly motion motion_sweep m K1Motion.tracer motion_sweep_into linkage_peers::Motion; phi,
        K1 k1 c1 e1 K1Assembly accuracy accuracy_sweep m K1Accuracy.tracer accuracy_sweep_into linkage_peers::Sensitivities1; phi,
        K2 k2 c2 e2 K2Assembly point point_sweep m K2Point.p10 point_sweep_into linkage_peers::Position; phi,
        K2 k2 c2 e2 K2Assembly motion motion_sweep m K2Motion.p10 motion_sweep_into linkage_peers::Motion; phi,
        K2 k2 c2 e2 K2Assembly accuracy accuracy_sweep m K2Accuracy.p10 accuracy_sweep_into linkage_peers::Sensitivities2; phi,
        K3 k3 c3 e3 K3Assembly point point_sweep s K3Point.end point_sweep_into [f64; 3]; phi,
        K3 k3 c3 e3 K3Assembly motion motion_sweep s K3Motion.end motion_sweep_into [f64; 11]; phi,
        K3 k3 c3 e3 K3Assembly accuracy accuracy_sweep s K3Accuracy.end accuracy_sweep_into [f64; 27]; phi,
        K4 k4 c4 e4 K4Assembly point point_sweep s K4Point.p point_sweep_into [f64; 3]; x y z,
        K4 k4 c4 e4 K4Assembly motion motion_sweep s K4Motion.p motion_sweep_into [f64; 12]; x y z,
        K4 k4 c4 e4 K4Assembly curvature curvature_sweep s K4Curvature.p curvature_sweep_into [f64; 39]; x y z,
    ];
    print(&rows);
}

/// Nothing, but not before `x` is known.
#[inline(always)]
fn after(x: f64) -> f64 {
    black_box(0.0) * x
}

/// Asserts that two languages mean the same.
fn agree(c: &[f64], ours: &[f64]) {
    for (c, ours) in c.iter().zip(ours) {
        let error = (c - ours).abs();
        assert!(error <= 1e-11 * c.abs().max(100.0), "C {c}, ours {ours}");
    }
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
            "{name:<14}  {ratio:<19.3}  {:<8}  {:<19.3}  {}  {}",
            compared(ratio, *goal),
            row.ours_latency.ratio(&row.c_latency),
            cost(&row.c, &row.clock),
            cost(&row.ours, &row.clock),
        );
    }
    println!(
        "\nC, own sine     ours/own sine        latency              own sine/C           own sine, ns (c)"
    );
    for ((name, _), row) in GOALS.iter().zip(rows) {
        println!(
            "{name:<14}  {:<19.3}  {:<19.3}  {:<19.3}  {}",
            row.ours.ratio(&row.own_sine),
            row.ours_latency.ratio(&row.own_sine_latency),
            row.own_sine.ratio(&row.c),
            cost(&row.own_sine, &row.clock),
        );
    }
    println!("\nExported C      exported/ours        goal      exported, ns (c)");
    for ((name, _), row) in GOALS.iter().zip(rows) {
        let ratio = row.exported.ratio(&row.ours);
        let cost = cost(&row.exported, &row.clock);
        let goal = compared(ratio, Some(EXPORTED));
        println!("{name:<14}  {ratio:<19.3}  {goal:<8}  {cost}");
    }
    println!("\nExported sweep  exported/ours        goal      exported, ns (c)");
    for ((name, _), row) in GOALS.iter().zip(rows) {
        let ratio = row.exported_sweep.ratio(&row.sweep);
        let cost = cost(&row.exported_sweep, &row.sweep_clock);
        let goal = compared(ratio, Some(EXPORTED_SWEEP));
        println!("{name:<14}  {ratio:<19.3}  {goal:<8}  {cost}");
    }
    let set = c::sweep::instruction_set().unwrap_or("single calls");
    println!(
        "\nSweep           ours/C in {set:<9}  goal      ours/C, one position  C, ns (c)       ours, ns (c)"
    );
    for ((name, goal), row) in GOALS.iter().zip(rows) {
        let ratio = row.sweep.ratio(&row.c_sweep);
        println!(
            "{name:<14}  {ratio:<19.3}  {:<8}  {:<20.4}  {}  {}",
            compared(ratio, goal.map(|_| SWEEP)),
            row.sweep.spread().median / row.c.spread().median,
            cost(&row.c_sweep, &row.sweep_clock),
            cost(&row.sweep, &row.sweep_clock),
        );
    }
    let rounds = rows.iter().flat_map(|row| &row.clock.rounds);
    println!(
        "\nclock {:.2} GHz",
        Spread::of(rounds.map(|time| 1.0 / time))
    );
}

/// The goal of a ratio, and whether it is met.
fn compared(ratio: Spread, goal: Option<f64>) -> String {
    match goal {
        Some(goal) if ratio.median <= goal => format!("{goal:4.2} met"),
        Some(goal) => format!("{goal:4.2}"),
        None => String::new(),
    }
}

/// Nanoseconds and cycles per position.
fn cost(times: &Times, clock: &Times) -> String {
    let (time, cycles) = (times.spread().median, times.ratio(clock).median);
    format!("{time:6.2} ({cycles:5.1})")
}
