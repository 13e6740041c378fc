//! What `assemble()` costs where functions return angles, whose turns are counted, and where they do not, and how many drives of a
//! coupled group a synthesis changes and moves in a second: `cargo bench -p linkage-benches --bench assembly`.

use linkage::mechanism;
use linkage_peers::timing::{Candidate, interleave, only_tested};
use linkage_random::Random;
use std::hint::black_box;
use std::time::Duration;

/// A crank-rocker; what is asked of it decides.
macro_rules! crank_rocker {
    ($name:ident, $result:ident { $($asked:tt)* }) => {
        mechanism! {
            pub struct $name {
                unit mm;
                param frame = 140mm;
                param crank = 50mm;
                param coupler = 120mm;
                param rocker = 100mm;
                input phi = 30deg in 0deg..360deg;
                unknown theta = 40deg;
                unknown psi = 80deg;
                let pin = polar(crank, phi) + polar(coupler, theta);
                loop pin = (frame, 0) + polar(rocker, psi);
            }
            impl $name {
                pub fn motion(phi) -> $result { $($asked)* }
            }
        }
    };
}

crank_rocker!(Pins, PinsMotion { pin });
crank_rocker!(Angles, AnglesMotion { theta, psi });

mechanism! {
    pub struct SliderCrank {
        unit mm;
        param crank = 40mm;
        param rod = 120mm;
        param offset = 5mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = -10deg;
        unknown slide = 150mm;
        loop polar(crank, phi) + polar(rod, theta) = (slide, offset);
    }
    impl SliderCrank {
        pub fn motion(phi) -> SliderCrankMotion { theta, slide }
    }
}

mechanism! {
    pub struct Shaper {
        unit mm;
        param pivot = (0mm, -100mm);
        param crank = 40mm;
        input phi = 30deg in 0deg..360deg;
        unknown psi = 70deg;
        unknown slide = 125mm;
        loop polar(crank, phi) = pivot + polar(slide, psi);
    }
    impl Shaper {
        pub fn motion(phi) -> ShaperMotion { psi }
    }
}

/// An eye-needle drive, a coupled group; what is asked of it decides whether angles are followed.
macro_rules! eye_needle {
    ($name:ident, $result:ident { $($asked:tt)* }) => {
        mechanism! {
            #[derive(Clone, Copy)]
            pub struct $name {
                unit mm;
                param l12 = 50mm;
                param l23 = 272.5mm;
                param l34 = 81mm;
                param l45 = 104.5mm;
                param l35 = 174mm;
                param l46 = 104.5mm;
                param l57 = 261mm;
                param p6 = (195mm, 226mm);
                param p7 = (46mm, 533mm);
                input phi = 0deg in 0deg..360deg;
                unknown phi23 = 62deg;
                unknown phi34 = 146deg;
                unknown phi64 = 144deg;
                unknown phi75 = -99deg;
                let p3 = polar(l12, phi) + polar(l23, phi23);
                let p5 = p3 + polar(l35, phi34 + triangle_angle(l34, l35, l45));
                loop p3 + polar(l34, phi34) = p6 + polar(l46, phi64);
                loop p5 = p7 + polar(l57, phi75);
            }
            impl $name {
                pub fn motion(phi) -> $result { $($asked)* }
            }
        }
    };
}

eye_needle!(EyeNeedle, EyeNeedleMotion { phi75 });
eye_needle!(Drive, DriveMotion { p5 });

/// Calls in one run.
const CALLS: usize = 64;

/// Drives in one run, and the positions of each.
const DRIVES: usize = 32;
const POSITIONS: usize = 72;

/// By how much of themselves links of drives differ from those of their neighbour.
const PARTS: [f64; 4] = [0.01, 0.02, 0.05, 0.1];

/// The goal for drives in a second, on one core.
const GOAL: f64 = 60e3;

fn assemblies() {
    let time = Duration::from_millis(if only_tested() { 1 } else { 3000 });
    let mut candidates = Vec::new();
    macro_rules! measure {
        ($name:literal, $nominal:expr, |$one:ident| $call:expr) => {{
            let $one = $nominal;
            candidates.push(Candidate::new($name, CALLS, move || {
                for _ in 0..CALLS {
                    let $one = black_box(&$one);
                    black_box(&$call);
                }
            }));
        }};
    }
    measure!("crank-rocker, points", Pins::default(), |one| one
        .assemble());
    measure!("crank-rocker, two angles", Angles::default(), |one| one
        .assemble());
    let single = Angles::default().cast::<f32>();
    measure!("crank-rocker, two angles, f32", single, |one| one
        .assemble());
    measure!("slider-crank, an angle", SliderCrank::default(), |one| one
        .assemble());
    measure!(
        "crank and slotted lever, an angle",
        Shaper::default(),
        |one| one.assemble()
    );
    measure!("eye-needle drive, an angle", EyeNeedle::default(), |one| {
        one.assemble()
    });
    let from = Angles::default().assemble().expect("it assembles");
    let other = Angles {
        rocker: 103.0,
        ..Angles::default()
    };
    measure!("crank-rocker, two angles: assemble_from", other, |one| one
        .assemble_from(&from));
    measure!(
        "crank-rocker, two angles: circuits",
        Angles::default(),
        |one| one.circuits()
    );
    for times in interleave(candidates, time) {
        println!("{:44} {:10.3} us", times.name, times.spread().median / 1e3);
    }
}

/// Eye-needle drives whose links differ by up to `part` from those of their neighbour, one of four links not at all.
fn neighbours(part: f64) -> Vec<Drive> {
    let mut random = Random::new(1917);
    let m = Drive::default();
    let drive = |_| {
        let links = [m.l12, m.l23, m.l34, m.l45, m.l35, m.l46, m.l57];
        let [l12, l23, l34, l45, l35, l46, l57] = random.near(links, part);
        Drive {
            l12,
            l23,
            l34,
            l45,
            l35,
            l46,
            l57,
            ..m
        }
    };
    (0..DRIVES).map(drive).collect()
}

/// Drives changed and moved in a second: as one sweep over sets, and one after the other.
fn drives(part: f64) {
    let time = Duration::from_millis(if only_tested() { 1 } else { 2500 });
    let step = std::f64::consts::TAU / POSITIONS as f64;
    let turn: Vec<f64> = (0..POSITIONS).map(|i| i as f64 * step).collect();
    let nominal = &Drive::default().assemble().expect("it assembles");
    let drives = &neighbours(part);
    let sets = drives.iter().flat_map(|drive| [*drive; POSITIONS]);
    let sets: Vec<Drive> = sets.collect();
    let angles: Vec<f64> = drives.iter().flat_map(|_| turn.iter().copied()).collect();
    let found = nominal.motion_sweep_sets(&sets, &angles);
    let moves = found.iter().filter(|row| row.p5.x.is_finite()).count();
    let assembles = drives.iter().filter(|drive| drive.assemble().is_ok());

    let mut rows = nominal.motion_sweep_sets(&sets, &angles);
    let together = Candidate::new("sweep_sets", DRIVES, || {
        nominal.motion_sweep_sets_into(black_box(&sets), &angles, &mut rows);
        black_box(&mut rows);
    });
    let mut columns = nominal.motion_sweep(&turn);
    let alone = Candidate::new("assemble each", DRIVES, || {
        for drive in drives {
            if let Ok(drive) = black_box(drive).assemble() {
                drive.motion_sweep_into(&turn, &mut columns);
                black_box(&mut columns);
            }
        }
    });
    let mut columns = nominal.motion_sweep(&turn);
    let from = Candidate::new("assemble_from each", DRIVES, || {
        for drive in drives {
            if let Ok(drive) = black_box(drive).assemble_from(nominal) {
                drive.motion_sweep_into(&turn, &mut columns);
                black_box(&mut columns);
            }
        }
    });
    let times = interleave(vec![together, alone, from], time);
    println!(
        "changed by up to {:.0} %: {:.1} % of positions are reached, {} of {DRIVES} drives assemble over the turn",
        100.0 * part,
        100.0 * moves as f64 / sets.len() as f64,
        assembles.count()
    );
    for own in &times {
        let a_second = 1e9 / own.spread().median;
        let met = match a_second >= GOAL {
            true => "met",
            false => "",
        };
        println!(
            "{:20} {a_second:8.0} drives a second {met:3}  over assembling each {:.3}",
            own.name,
            own.ratio(&times[1])
        );
    }
}

fn main() {
    assemblies();
    println!("eye-needle drives, {POSITIONS} positions each (goal {GOAL:.0} a second)");
    PARTS.into_iter().for_each(drives);
}
