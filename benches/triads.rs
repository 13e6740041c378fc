//! Coupled groups against a crank-rocker timed in turn with them:
//! `RUSTFLAGS="-C target-cpu=x86-64-v3" cargo bench -p linkage-benches --bench triads`, and without the flags.
//!
//! The eye-needle drive (RR-RR-RR) and the two-crank drive (RR-RR-PR): position, both derivatives, and
//! the sensitivities to all dimensions as well; single calls, sweeps, sets of perturbed dimensions,
//! and `assemble()`. Every time is stated as a ratio to what the crank-rocker takes for a position alone
//! in the same way (single calls to single calls, sweeps to sweeps).

use linkage::mechanism;
use linkage_peers::mechanisms::{K1, K1Assembly, K1Point};
use linkage_peers::timing::{Candidate, Times, clock, interleave, only_tested};
use std::hint::black_box;
use std::time::Duration;

mechanism! {
    pub struct EyeNeedle {
        unit mm;
        param l12 = 50mm;
        param l23 = 272.5mm;
        param l34 = 81mm;
        param l45 = 104.5mm;
        param l35 = 174mm;
        param l46 = 104.5mm;
        param l57 = 261mm;
        param l78 = 136.8mm;
        param angle_578 = -25deg;
        param p6 = (195mm, 226mm);
        param p7 = (46mm, 533mm);
        input phi = 0deg in 0deg..360deg;
        unknown phi23 = 62deg;
        unknown phi34 = 146deg;
        unknown phi64 = 144deg;
        unknown phi75 = -99deg;
        let p3 = polar(l12, phi) + polar(l23, phi23);
        let p4 = p3 + polar(l34, phi34);
        let p5 = p3 + polar(l35, phi34 + triangle_angle(l34, l35, l45));
        loop p4 = p6 + polar(l46, phi64);
        loop p5 = p7 + polar(l57, phi75);
        let point = p7 + polar(l78, phi75 + angle_578);
    }

    impl EyeNeedle {
        pub fn position(phi) -> NeedlePosition { point }
        pub fn motion(phi) -> NeedleMotion { point, v: velocity(point), a: acceleration(point) }
        pub fn accuracy(phi) -> NeedleAccuracy {
            point, v: velocity(point), a: acceleration(point), e: sensitivity(point),
        }
    }
}

mechanism! {
    pub struct TwoCranks {
        unit mm;
        param l12 = 13mm;
        param l67 = 11mm;
        param p7 = (82mm, 22mm);
        param l23 = 68mm;
        param l64 = 85mm;
        param l34 = 66mm;
        param l35 = 40mm;
        param angle_435 = -65deg;
        param n1 = (28mm, 0mm);
        param guide = 90deg;
        input phi = 0deg in 0deg..360deg;
        unknown phi23 = 105deg;
        unknown phi34 = 29deg;
        unknown phi64 = 118deg;
        unknown s = 42mm;
        let p3 = polar(l12, -phi) + polar(l23, phi23);
        let point = n1 + polar(s, guide);
        loop p3 + polar(l34, phi34) = p7 + polar(l67, phi) + polar(l64, phi64);
        loop p3 + polar(l35, phi34 + angle_435) = point;
    }

    impl TwoCranks {
        pub fn position(phi) -> CranksPosition { point }
        pub fn motion(phi) -> CranksMotion { point, v: velocity(point), a: acceleration(point) }
        pub fn accuracy(phi) -> CranksAccuracy {
            point, v: velocity(point), a: acceleration(point), e: sensitivity(point),
        }
    }
}

/// Positions in one run.
const POSITIONS: usize = 1024;
/// The goals for single calls: position, both derivatives, sensitivities too.
const GOALS: [f64; 3] = [5.0, 5.0, 8.0];
/// The goal for `assemble()`, in nanoseconds.
const ASSEMBLE: f64 = 1e6;

#[inline(never)]
fn crank_rocker(linkage: &K1Assembly, phi: f64) -> K1Point {
    linkage.point(phi)
}

/// Times of one mechanism's functions, the crank-rocker's in the same run before them.
struct Rows {
    name: &'static str,
    single: [Times; 4],
    latency: [Times; 4],
    sweep: [Times; 4],
    sets: [Times; 4],
    assemble: Times,
    clock: Times,
}

/// Nothing, but not before `x` is known.
#[inline(always)]
fn after(x: f64) -> f64 {
    black_box(0.0) * x
}

macro_rules! rows {
    (
        $name:literal $mechanism:ident $assembly:ident; $perturb:expr;
        $($function:ident $result:ident $sweep:ident $into:ident $sets:ident $sets_into:ident),*
    ) => {{
        let time = Duration::from_millis(if only_tested() { 1 } else { 2500 });
        let step = std::f64::consts::TAU / POSITIONS as f64;
        let angles: Vec<f64> = (0..POSITIONS).map(|i| (i * 619 % POSITIONS) as f64 * step).collect();
        let angles = &angles;
        let base = K1::default();
        let other = &base.assemble().expect("the crank-rocker assembles");
        let nominal = $mechanism::default();
        let linkage = &nominal.assemble().expect("it assembles");
        let part = |i: usize| (i as f64 / POSITIONS as f64 - 0.5) * 2e-4;
        let perturb: fn(&$mechanism, f64) -> $mechanism = $perturb;
        let mechanisms: Vec<$mechanism> = (0..POSITIONS).map(|i| perturb(&nominal, part(i))).collect();
        let mechanisms = &mechanisms;
        let bases: Vec<K1> =
            (0..POSITIONS).map(|i| K1 { crank: base.crank * (1.0 + part(i)), ..base }).collect();
        let bases = &bases;
        let reached = linkage.position_sweep_sets(mechanisms, angles).iter().filter(|row| row.point.x.is_finite()).count();
        assert_eq!(reached, POSITIONS, "{}: a perturbed mechanism is NaN", $name);

        let (mut x, mut single, mut latency, mut sweep, mut sets) =
            (0.0, Vec::new(), Vec::new(), Vec::new(), Vec::new());
        let mut columns = other.point_sweep(angles);
        let mut rows = other.point_sweep_sets(bases, angles);
        single.push(Candidate::new("crank-rocker", POSITIONS, move || {
            for &phi in angles {
                black_box(&crank_rocker(other, phi));
            }
        }));
        latency.push(Candidate::new("crank-rocker, latency", POSITIONS, move || {
            for &phi in angles {
                let result = crank_rocker(other, phi + after(x));
                x = black_box(&result).tracer.x;
            }
        }));
        sweep.push(Candidate::new("crank-rocker, sweep", POSITIONS, move || {
            other.point_sweep_into(black_box(angles), &mut columns);
            black_box(&mut columns);
        }));
        sets.push(Candidate::new("crank-rocker, sets", POSITIONS, move || {
            other.point_sweep_sets_into(black_box(bases), angles, &mut rows);
            black_box(&mut rows);
        }));
        $(
            #[inline(never)]
            fn $function(linkage: &$assembly, phi: f64) -> $result {
                linkage.$function(phi)
            }
            single.push(Candidate::new(stringify!($function), POSITIONS, move || {
                for &phi in angles {
                    black_box(&$function(linkage, phi));
                }
            }));
            let mut x = 0.0;
            latency.push(Candidate::new(stringify!($function), POSITIONS, move || {
                for &phi in angles {
                    let result = $function(linkage, phi + after(x));
                    x = black_box(&result).point.x;
                }
            }));
            let mut columns = linkage.$sweep(angles);
            sweep.push(Candidate::new(stringify!($sweep), POSITIONS, move || {
                linkage.$into(black_box(angles), &mut columns);
                black_box(&mut columns);
            }));
            let mut rows = linkage.$sets(mechanisms, angles);
            sets.push(Candidate::new(stringify!($sets), POSITIONS, move || {
                linkage.$sets_into(black_box(mechanisms), angles, &mut rows);
                black_box(&mut rows);
            }));
        )*
        let assemble = Candidate::new("assemble", 1, || {
            black_box(black_box(&nominal).assemble().expect("it assembles"));
        });
        let candidates = single.into_iter().chain(latency).chain(sweep).chain(sets);
        let candidates = candidates.chain([assemble, clock()]).collect();
        let mut times = interleave(candidates, time).into_iter();
        let mut next = || times.next().expect("a time for each candidate");
        let mut four = || std::array::from_fn(|_| next());
        Rows {
            name: $name,
            single: four(),
            latency: four(),
            sweep: four(),
            sets: four(),
            assemble: next(),
            clock: next(),
        }
    }};
}

fn main() {
    let rows = [
        rows!(
            "eye needle" EyeNeedle EyeNeedleAssembly;
            |m, part| EyeNeedle { l23: m.l23 * (1.0 + part), l45: m.l45 * (1.0 - part), ..*m };
            position NeedlePosition position_sweep position_sweep_into position_sweep_sets position_sweep_sets_into,
            motion NeedleMotion motion_sweep motion_sweep_into motion_sweep_sets motion_sweep_sets_into,
            accuracy NeedleAccuracy accuracy_sweep accuracy_sweep_into accuracy_sweep_sets accuracy_sweep_sets_into
        ),
        rows!(
            "two cranks" TwoCranks TwoCranksAssembly;
            |m, part| TwoCranks { l23: m.l23 * (1.0 + part), l34: m.l34 * (1.0 - part), ..*m };
            position CranksPosition position_sweep position_sweep_into position_sweep_sets position_sweep_sets_into,
            motion CranksMotion motion_sweep motion_sweep_into motion_sweep_sets motion_sweep_sets_into,
            accuracy CranksAccuracy accuracy_sweep accuracy_sweep_into accuracy_sweep_sets accuracy_sweep_sets_into
        ),
    ];
    rows.iter().for_each(print);
}

fn print(rows: &Rows) {
    let fused = if cfg!(target_feature = "fma") {
        "with"
    } else {
        "without"
    };
    println!(
        "{}, built {fused} fused multiply-add. Medians (quartiles); c = core cycles.",
        rows.name
    );
    println!("                        over crank-rocker    goal       ns (c)");
    let sections = [
        ("single", &rows.single, Some(GOALS)),
        ("latency", &rows.latency, None),
        ("sweep", &rows.sweep, None),
        ("sets", &rows.sets, None),
    ];
    for (section, [base, functions @ ..], goals) in sections {
        println!(
            "{section:<8} {:<28} {}",
            "crank-rocker, position",
            cost(base, &rows.clock)
        );
        for (k, times) in functions.iter().enumerate() {
            let ratio = times.ratio(base);
            let goal = match goals {
                Some(goals) if ratio.median <= goals[k] => format!("{} met", goals[k]),
                Some(goals) => format!("{} MISSED", goals[k]),
                None => String::new(),
            };
            let name = ["position", "derivatives", "sensitivities"][k];
            println!(
                "{section:<8} {name:<14} {ratio:<20.2} {goal:<10} {}",
                cost(times, &rows.clock)
            );
        }
    }
    let assemble = rows.assemble.spread();
    let met = if assemble.median <= ASSEMBLE {
        "met"
    } else {
        "MISSED"
    };
    println!(
        "assemble {:.1} us (goal {:.0}, {met})\n",
        assemble.median / 1e3,
        ASSEMBLE / 1e3
    );
}

/// Nanoseconds and cycles per position.
fn cost(times: &Times, clock: &Times) -> String {
    let (time, cycles) = (times.spread().median, times.ratio(clock).median);
    format!("{time:8.2} ({cycles:6.1})")
}
