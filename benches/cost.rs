//! What a function costs, against what it was asked for: `cargo bench -p linkage-benches --bench cost`.
//!
//! Two mechanisms with a function for each request. Operations are those that the compiler counted
//! (`STRUCTURE`); times are of single calls and of sweeps, timed in turn.

use linkage::{FunctionInfo, Operations, mechanism};
use linkage_peers::timing::{Candidate, Times, clock, interleave, only_tested};
use std::hint::black_box;
use std::time::Duration;

mechanism! {
    /// K1, the crank-rocker.
    pub struct Four {
        unit mm;
        param crank   = 50mm;
        param coupler = 120mm;
        param rocker  = 100mm;
        param pivot_d = (140mm, 0mm);
        param arm     = 70mm;
        param lift    = 25deg;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi   = 80deg;
        let a = polar(crank, phi);
        let b = a + polar(coupler, theta);
        loop b = pivot_d + polar(rocker, psi);
        let tracer = a + polar(arm, theta + lift);
    }

    impl Four {
        pub fn one(phi) -> FourOne { tracer }
        pub fn all(phi) -> FourAll { a, b, tracer }
        pub fn velocity(phi) -> FourVelocity { tracer, v: velocity(tracer) }
        pub fn motion(phi) -> FourMotion { tracer, v: velocity(tracer), a: acceleration(tracer) }
        pub fn all_motion(phi) -> FourAllMotion {
            a, va: velocity(a), aa: acceleration(a), b, vb: velocity(b), ab: acceleration(b),
            tracer, v: velocity(tracer), at: acceleration(tracer),
        }
        pub fn by_one(phi) -> FourByOne { tracer, e: sensitivity(tracer, [coupler]) }
        pub fn by_seven(phi) -> FourBySeven { tracer, e: sensitivity(tracer) }
    }
}

mechanism! {
    /// K2, the drive of the hook needle.
    pub struct Needle {
        unit mm;
        param pivot_4 = (5mm, 150mm);
        param pivot_7 = (112.5mm, 3.5mm);
        param l12 = 5mm;
        param l23 = 46.5mm;
        param l34 = 123mm;
        param l45 = 13.5mm;
        param l78 = 10mm;
        param l89 = 160mm;
        param l910 = 122.5mm;
        param angle_345 = -62.5deg;
        input phi = -90deg in -90deg..630deg;
        unknown phi23 = 48deg;
        unknown phi43 = -78deg;
        let p2 = polar(l12, phi);
        let p3 = p2 + polar(l23, phi23);
        loop p3 = pivot_4 + polar(l34, phi43);
        let phi45 = phi43 + angle_345;
        let phi56 = phi45 + 90deg;
        let p5 = pivot_4 + polar(l45, phi45);
        unknown phi89 = 134deg;
        unknown slide = 18mm;
        let p8 = pivot_7 + polar(l78, 15deg - phi / 2);
        let p9 = p8 + polar(l89, phi89);
        loop p9 = p5 + polar(slide, phi56);
        let p10 = p9 - polar(l910, phi56);
    }

    impl Needle {
        pub fn one(phi) -> NeedleOne { p10 }
        pub fn first(phi) -> NeedleFirst { p3 }
        pub fn all(phi) -> NeedleAll { p2, p3, p5, p8, p9, p10 }
        pub fn velocity(phi) -> NeedleVelocity { p10, v: velocity(p10) }
        pub fn motion(phi) -> NeedleMotion { p10, v: velocity(p10), a: acceleration(p10) }
        pub fn all_motion(phi) -> NeedleAllMotion {
            p2, v2: velocity(p2), a2: acceleration(p2), p3, v3: velocity(p3), a3: acceleration(p3),
            p5, v5: velocity(p5), a5: acceleration(p5), p8, v8: velocity(p8), a8: acceleration(p8),
            p9, v9: velocity(p9), a9: acceleration(p9), p10, v: velocity(p10), a: acceleration(p10),
        }
        pub fn by_one(phi) -> NeedleByOne { p10, e: sensitivity(p10, [l23]) }
        pub fn by_seven(phi) -> NeedleBySeven {
            p10, e: sensitivity(p10, [l12, l23, l34, l45, l78, l89, l910])
        }
        pub fn by_twelve(phi) -> NeedleByTwelve { p10, e: sensitivity(p10) }
    }
}

/// Positions in one run.
const POSITIONS: usize = 1024;

/// A candidate for single calls and one for the sweep of each function.
macro_rules! candidates {
    ($linkage:ident, $angles:ident: $($function:ident $sweep:ident $into:ident),* $(,)?) => {
        vec![
            clock(),
            $(
                {
                    Candidate::new(stringify!($function), POSITIONS, move || {
                        for &phi in $angles {
                            black_box(&$linkage.$function(phi));
                        }
                    })
                },
                {
                    let mut columns = $linkage.$sweep($angles);
                    Candidate::new(stringify!($function), POSITIONS, move || {
                        $linkage.$into(black_box($angles), &mut columns);
                        black_box(&mut columns);
                    })
                },
            )*
        ]
    };
}

fn main() {
    let time = Duration::from_millis(if only_tested() { 1 } else { 5000 });
    let step = std::f64::consts::TAU / POSITIONS as f64;
    let angles: Vec<f64> = (0..POSITIONS).map(|i| i as f64 * step).collect();
    let angles = &angles;
    let four = &black_box(Four::default().assemble().expect("it assembles"));
    let needle = &black_box(Needle::default().assemble().expect("it assembles"));

    let candidates = candidates![four, angles:
        one one_sweep one_sweep_into,
        all all_sweep all_sweep_into,
        velocity velocity_sweep velocity_sweep_into,
        motion motion_sweep motion_sweep_into,
        all_motion all_motion_sweep all_motion_sweep_into,
        by_one by_one_sweep by_one_sweep_into,
        by_seven by_seven_sweep by_seven_sweep_into,
    ];
    print(
        "K1, crank-rocker: a, b and the tracer",
        Four::STRUCTURE.functions,
        &interleave(candidates, time),
    );

    let candidates = candidates![needle, angles:
        first first_sweep first_sweep_into,
        one one_sweep one_sweep_into,
        all all_sweep all_sweep_into,
        velocity velocity_sweep velocity_sweep_into,
        motion motion_sweep motion_sweep_into,
        all_motion all_motion_sweep all_motion_sweep_into,
        by_one by_one_sweep by_one_sweep_into,
        by_seven by_seven_sweep by_seven_sweep_into,
        by_twelve by_twelve_sweep by_twelve_sweep_into,
    ];
    print(
        "K2, needle: 6 points",
        Needle::STRUCTURE.functions,
        &interleave(candidates, time),
    );
}

/// What a function of a name asks for.
fn request(name: &str) -> &'static str {
    match name {
        "first" => "a point of the first dyad",
        "one" => "one point",
        "all" => "all points",
        "velocity" => "one point, velocity",
        "motion" => "one point, velocity, acceleration",
        "all_motion" => "all points, velocities, accelerations",
        "by_one" => "one point, 1 sensitivity",
        "by_seven" => "one point, 7 sensitivities",
        _ => "one point, 12 sensitivities",
    }
}

fn print(title: &str, functions: &[FunctionInfo], times: &[Times]) {
    println!("\n{title}; per position, medians; c = core cycles\n");
    println!(
        "{:<38}  operations  add  mul  div  sqrt  sin_cos  single, ns (c)    of one  sweep, ns (c)    of one",
        "asked for"
    );
    let (clock, pairs) = times.split_first().expect("the clock is timed first");
    let mut pairs = pairs.chunks_exact(2);
    let one = pairs
        .clone()
        .find(|pair| pair[0].name == "one")
        .expect("one point is asked for");
    pairs.by_ref().for_each(|pair| {
        let name = &pair[0].name;
        let listed = functions.iter().find(|function| function.name == name);
        let o = listed.map_or(Operations::default(), |function| function.operations);
        let cell = |index: usize| {
            let (time, cycles) = (pair[index].spread().median, pair[index].ratio(clock).median);
            let ratio = pair[index].ratio(&one[index]).median;
            format!("{time:6.2} ({cycles:5.1})  {ratio:8.2}")
        };
        println!(
            "{:<38}  {:>10}  {:>3}  {:>3}  {:>3}  {:>4}  {:>7}  {}  {}",
            request(name),
            o.total(),
            o.add,
            o.mul,
            o.div,
            o.sqrt,
            o.sin_cos,
            cell(0),
            cell(1),
        );
    });
}
