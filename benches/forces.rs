//! Forces against the accelerations that they come from, timed in turn:
//! `RUSTFLAGS="-C target-cpu=x86-64-v3" cargo bench -p linkage-benches --bench forces`, and without the flags.
//!
//! The hook-needle drive with six bodies: the reactions of all eight joints and the driving torque, over the
//! accelerations of all centres of mass and of all links that turn unevenly; at a constant speed, and at a changing
//! one, which needs the velocities, too. Single calls, single calls of which each waits for the result before it
//! ("latency"), and sweeps.

use linkage::mechanism;
use linkage_peers::timing::{Candidate, Times, clock, interleave, only_tested};
use std::hint::black_box;
use std::time::Duration;

mechanism! {
    pub struct Drive {
        unit mm;
        param pivot_4 = (5mm, 150mm);
        param pivot_7 = (112.5mm, 3.5mm);
        param l12 = 5mm;
        param l23 = 46.5mm;
        param l34 = 123mm;
        param l45 = 13.5mm;
        param l78 = 10mm;
        param l89 = 160mm;
        param angle_345 = -62.5deg;
        input phi = -90deg in -90deg..630deg at omega, epsilon;
        unknown phi23 = 48deg;
        unknown phi43 = -78deg;
        let p2 = polar(l12, phi);
        let p3 = p2 + polar(l23, phi23);
        loop p3 = pivot_4 + polar(l34, phi43);
        let phi45 = phi43 + angle_345;
        let phi56 = phi45 + 90deg;
        unknown phi89 = 134deg;
        unknown slide = 18mm;
        let phi78 = 15deg - phi / 2;
        let p8 = pivot_7 + polar(l78, phi78);
        let p9 = p8 + polar(l89, phi89);
        loop p9 = pivot_4 + polar(l45, phi45) + polar(slide, phi56);

        param m1 = 129.94g;
        param m2 = 91.15g;
        param m3 = 2388.95g;
        param m4 = 165.48g;
        param m5 = 481.9g;
        param m6 = 4905.36g;
        param i1 = 31114.78g*mm^2;
        param i2 = 49663.7g*mm^2;
        param i3 = 8352890.86g*mm^2;
        param i4 = 50362.38g*mm^2;
        param i5 = 2093364.67g*mm^2;
        param i6 = 48083553.35g*mm^2;
        param r1 = 1.32mm;
        param r2 = 12.96mm;
        param r3 = 50.56mm;
        param r4 = 2.36mm;
        param r5 = 47.84mm;
        param r6 = 53.45mm;
        param angle_3 = 14.08deg;
        param angle_6 = 6.34deg;
        let c1 = polar(r1, phi);
        let c2 = p2 + polar(r2, phi23);
        let c3 = pivot_4 + polar(r3, phi43 + angle_3);
        let c4 = pivot_7 + polar(r4, phi78);
        let c5 = p8 + polar(r5, phi89);
        let c6 = p9 - polar(r6, phi56 + angle_6);
        gravity = (0, -9.80665m/s^2);
        body crank_1 = pin b1 on frame at (0, 0), turns phi, mass m1 at c1, inertia i1 at (0, 0);
        body coupler = pin b2 on crank_1 at p2, turns phi23, mass m2 at c2, inertia i2;
        body rocker = pin b4 on frame at pivot_4, turns phi43, mass m3 at c3, inertia i3;
        body crank_7 = pin b7 on frame at pivot_7, turns phi78, mass m4 at c4, inertia i4 at pivot_7;
        body rod = pin b8 on crank_7 at p8, turns phi89, mass m5 at c5, inertia i5;
        body slider = slide b11 on rocker at p9 along dir(phi56), turns phi56, mass m6 at c6, inertia i6;
        pin b3 = coupler on rocker at p3;
        pin b9 = rod on slider at p9;
    }

    impl Drive {
        /// What a constant speed needs.
        pub fn accelerations(phi) -> Accelerations {
            a1: acceleration(c1), a2: acceleration(c2), a3: acceleration(c3),
            a4: acceleration(c4), a5: acceleration(c5), a6: acceleration(c6),
            e23: acceleration(phi23), e43: acceleration(phi43), e89: acceleration(phi89),
        }

        pub fn forces(phi, omega) -> Forces {
            r1: reaction(b1), r2: reaction(b2), r3: reaction(b3), r4: reaction(b4),
            r7: reaction(b7), r8: reaction(b8), r9: reaction(b9), r11: reaction(b11),
            torque: torque(phi),
        }

        /// What a changing speed needs.
        pub fn motion(phi) -> Motion {
            v1: velocity(c1), v2: velocity(c2), v3: velocity(c3),
            v4: velocity(c4), v5: velocity(c5), v6: velocity(c6),
            w23: velocity(phi23), w43: velocity(phi43), w89: velocity(phi89),
            a1: acceleration(c1), a2: acceleration(c2), a3: acceleration(c3),
            a4: acceleration(c4), a5: acceleration(c5), a6: acceleration(c6),
            e23: acceleration(phi23), e43: acceleration(phi43), e89: acceleration(phi89),
        }

        pub fn run_up(phi, omega, epsilon) -> RunUp {
            r1: reaction(b1), r2: reaction(b2), r3: reaction(b3), r4: reaction(b4),
            r7: reaction(b7), r8: reaction(b8), r9: reaction(b9), r11: reaction(b11),
            torque: torque(phi),
        }
    }
}

/// Positions in one run.
const POSITIONS: usize = 1024;

/// The goal: all forces over the accelerations alone.
const GOAL: f64 = 3.0;

/// Nothing, but not before `x` is known.
#[inline(always)]
fn after(x: f64) -> f64 {
    black_box(0.0) * x
}

/// Candidates of one function: single calls, the same by latency, a sweep.
macro_rules! candidates {
    ($drive:ident $phi:ident;
     $($function:ident $sweep:ident $into:ident $result:ident.$number:ident; $($more:ident)*),* $(,)?) => {
        vec![$({
            #[inline(never)]
            fn single(drive: &DriveAssembly, phi: f64, $($more: f64),*) -> $result {
                drive.$function(phi, $($more),*)
            }
            let mut columns = $drive.$sweep($phi, $($more),*);
            let mut before = 0.0;
            [
                Candidate::new("one position", POSITIONS, || {
                    for i in 0..POSITIONS {
                        black_box(&single(&$drive, $phi[i], $($more[i]),*));
                    }
                }),
                Candidate::new("latency", POSITIONS, move || {
                    for i in 0..POSITIONS {
                        let result = single(&$drive, $phi[i] + after(before), $($more[i]),*);
                        black_box(&result);
                        before = result.$number.x;
                    }
                }),
                Candidate::new("sweep", POSITIONS, move || {
                    $drive.$into(black_box($phi), $($more,)* &mut columns);
                    black_box(&mut columns);
                }),
            ]
        }),*]
    };
}

fn main() {
    let time = Duration::from_millis(if only_tested() { 1 } else { 5000 });
    let drive = &Drive::default().assemble().expect("the drive assembles");
    let step = 2.0 * std::f64::consts::TAU / POSITIONS as f64;
    let phi: &[f64; POSITIONS] = &std::array::from_fn(|i| (i * 619 % POSITIONS) as f64 * step);
    let (omega, epsilon) = (&[-104.72; POSITIONS], &[30.0; POSITIONS]);
    let mut candidates: Vec<Candidate> = candidates![
        drive phi;
        accelerations accelerations_sweep accelerations_sweep_into Accelerations.a5;,
        forces forces_sweep forces_sweep_into Forces.r4; omega,
        motion motion_sweep motion_sweep_into Motion.a5;,
        run_up run_up_sweep run_up_sweep_into RunUp.r4; omega epsilon,
    ]
    .into_iter()
    .flatten()
    .collect();
    candidates.push(clock());
    let times = interleave(candidates, time);
    let (clock, times) = times.split_last().expect("the clock is the last one");
    let [accelerations, forces, motion, run_up] = std::array::from_fn(|i| &times[3 * i..3 * i + 3]);
    println!("{}", Drive::STRUCTURE);
    println!(
        "Eight reactions and the torque over the accelerations. Medians (quartiles); c = core cycles."
    );
    print("constant speed", accelerations, forces, clock);
    print("changing speed", motion, run_up, clock);
}

fn print(case: &str, accelerations: &[Times], forces: &[Times], clock: &Times) {
    println!("\n{case:<15} ratio                accelerations, ns (c)  forces, ns (c)");
    for (accelerations, forces) in accelerations.iter().zip(forces) {
        let ratio = forces.ratio(accelerations);
        let verdict = if ratio.median <= GOAL {
            "met"
        } else {
            "missed"
        };
        println!(
            "{:<15} {ratio:<20} {:<22} {:<16} goal {GOAL:.0} {verdict}",
            forces.name,
            cost(accelerations, clock),
            cost(forces, clock),
        );
    }
}

/// Nanoseconds and cycles per position.
fn cost(times: &Times, clock: &Times) -> String {
    let (time, cycles) = (times.spread().median, times.ratio(clock).median);
    format!("{time:6.2} ({cycles:5.1})")
}
