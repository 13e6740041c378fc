//! Several organs on one shaft: `cargo bench --bench machine`.
//!
//! A cyclogram of four organs with all switching angles and their sensitivities; the least distance of two needles
//! with its sensitivities to all 34 dimensions; the best phase of the two. Times are of everything after
//! `assemble()`, sweeps included.

use linkage::clearance::{Clearance, Phases};
use linkage::cyclogram::{Band, Cyclogram, Organ};
use linkage::summary::{Course, positions};
use linkage_peers::timing::{Candidate, interleave, only_tested};
use mechanisms::{TwoCranks, TwoCranksAssembly, TwoNeedles, TwoNeedlesAssembly};
use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::Duration;

#[path = "../tests/machine/mechanisms.rs"]
mod mechanisms;

const CYCLE: (f64, f64) = (0.0, TAU);
const POSITIONS: usize = 73;
const BANDS: [Band; 2] = [Band::Top(0.1), Band::Bottom(0.1)];

fn hook(needles: &TwoNeedlesAssembly, places: &[f64]) -> Organ {
    let rows = needles.height_sweep(places);
    let (y, v, a) = (rows.y(), rows.v(), rows.a());
    let course = Course::swept(
        CYCLE,
        POSITIONS,
        |i| [y[i], v[i], a[i]],
        |x| {
            let m = needles.height(x);
            [m.y, m.v, m.a]
        },
    );
    let organ = Organ::new("hook", &course.expect("a course"), &BANDS).expect("an organ");
    organ.sensitivities(
        |x| needles.height_accuracy(x).e,
        |x| needles.height_rate(x).e,
    )
}

fn eye(needles: &TwoNeedlesAssembly, places: &[f64]) -> Organ {
    let rows = needles.arc_sweep(places);
    let (s, v, a) = (rows.s(), rows.v(), rows.a());
    let course = Course::swept(
        CYCLE,
        POSITIONS,
        |i| [s[i], v[i], a[i]],
        |x| {
            let m = needles.arc(x);
            [m.s, m.v, m.a]
        },
    );
    let organ = Organ::new("eye", &course.expect("a course"), &BANDS).expect("an organ");
    organ.sensitivities(|x| needles.arc_accuracy(x).e, |x| needles.arc_rate(x).e)
}

fn slide(cranks: &TwoCranksAssembly, name: &str, places: &[f64]) -> Organ {
    let rows = cranks.slide_sweep(places);
    let (s, v, a) = (rows.s(), rows.v(), rows.a());
    let course = Course::swept(
        CYCLE,
        POSITIONS,
        |i| [s[i], v[i], a[i]],
        |x| {
            let m = cranks.slide(x);
            [m.s, m.v, m.a]
        },
    );
    let organ = Organ::new(name, &course.expect("a course"), &BANDS).expect("an organ");
    organ.sensitivities(|x| cranks.slide_accuracy(x).e, |x| cranks.slide_rate(x).e)
}

fn least(needles: &TwoNeedlesAssembly, places: &[f64]) -> [f64; 34] {
    let rows = needles.tips_sweep(places);
    let shapes =
        |m: mechanisms::Tips| ([[m.hook, m.hook_v, m.hook_a]], [[m.eye, m.eye_v, m.eye_a]]);
    let found = Clearance::swept(
        CYCLE,
        POSITIONS,
        |i| shapes(rows.get(i)),
        |x| shapes(needles.tips(x)),
    );
    let found = found.expect("a clearance");
    let nearest = found.least();
    let e = needles.accuracy(nearest.at);
    nearest.sensitivity([e.hook], [e.eye])
}

fn main() {
    let needles = TwoNeedles {
        lead: 0.0,
        ..TwoNeedles::default()
    };
    let needles = needles.assemble().expect("the needles close");
    let cranks = TwoCranks::default().assemble().expect("the drive closes");
    // Set 25 degrees off: the fourth organ.
    let other = TwoCranks {
        triad_m10: 0.4363,
        triad_m20: -0.4363,
        ..TwoCranks::default()
    };
    let other = other.assemble().expect("the drive closes");
    let places: Vec<f64> = positions(CYCLE, POSITIONS).collect();
    let candidates = vec![
        Candidate::new("cyclogram of four organs", 1, || {
            let organs = [
                hook(&needles, &places),
                eye(&needles, &places),
                slide(&cranks, "sinker", &places),
                slide(&other, "press", &places),
            ];
            black_box(Cyclogram::of(organs).expect("a cyclogram"));
        }),
        Candidate::new("least distance", 1, || {
            black_box(least(&needles, &places));
        }),
        Candidate::new("best phase", 1, || {
            let phases = Phases::of(
                CYCLE,
                POSITIONS,
                |x| {
                    let m = needles.hook(x);
                    [[m.p, m.v, m.a]]
                },
                |x| {
                    let m = needles.eye(x);
                    [[m.p, m.v, m.a]]
                },
            );
            let range = (-30f64.to_radians(), 30f64.to_radians());
            black_box(phases.expect("phases").best(range).expect("a best phase"));
        }),
    ];
    let time = match only_tested() {
        true => Duration::ZERO,
        false => Duration::from_secs(2),
    };
    for times in interleave(candidates, time) {
        println!("{:26} {:8.1} us", times.name, times.spread().median / 1e3);
    }
}
