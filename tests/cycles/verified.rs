//! Claims of searches against the mechanisms that they return: no false dwell, nothing worse than the start or than narrower bounds.
//!
//! `LINKAGE_LONG=1` judges 10,000 results of random problems, `LINKAGE_PROBLEMS=n` so many.

#[path = "../design/judge.rs"]
mod judge;

use super::drives::{Needle, Press};
use super::judged::{Goal, Keep, Tally, needle, press, rocker};
use super::{N, Rocker, RockerAssembly, design, speed, tip};
use judge::{follows, inputs};
use linkage::design::{
    Candidate, Chosen, CycleDesign, CycleObjective, DesignError, Dwell, Figure, Motion, Peak,
    Stroke, Verdict,
};
use linkage::summary::Curve;
use linkage_random::Random;
use std::f64::consts::TAU;

/// The start holds all conditions; the search alone ends with a missed band, or with a band that is none.
#[test]
fn wider_bounds_are_never_worse() {
    let mut tally = Tally::default();
    let of = Press::default().assemble().expect("assembles");
    let [high, low] = (0..=3600)
        .map(|k| of.motion(TAU * f64::from(k) / 3600.0).way)
        .fold([f64::MIN, f64::MAX], |[high, low], x| {
            [high.max(x), low.min(x)]
        });
    let course = Curve::new((0.0, TAU), 361, |phi| {
        let m = of.motion(phi);
        [m.way, m.v, m.a]
    });
    let stroke = course.expect("a turn").position().stroke();
    assert!((stroke - (high - low)).abs() < 1e-4 * stroke);
    for (band, parts) in [(0.05, [0.07, 0.08, 0.09]), (0.5, [0.09, 0.1, 0.11])] {
        let wanted = (Goal::Longest(band), Keep::Stroke(stroke));
        let worths = parts.map(|part| {
            let worth = press::judge(Press::default(), wanted, part, &mut tally);
            worth.expect("the start holds all conditions")
        });
        assert!(
            worths.windows(2).all(|pair| pair[0] < pair[1]),
            "{band}: {worths:?}"
        );
    }
    assert_eq!(
        [tally.false_claims, tally.worse_than_start],
        [0, 0],
        "{tally:?}"
    );
}

/// The published drive rests for 19.02 degrees within 0.02 mm. A search within 8 % claims 184, where its triangle is nearly flat.
#[test]
fn a_dwell_that_is_none_is_not_returned() {
    let of = Needle::default().assemble().expect("assembles");
    let course = Curve::new((0.0, TAU), 361, |phi| {
        let m = of.motion(phi);
        [m.way, m.v, m.a]
    });
    let course = course.expect("a turn");
    let keep = Keep::Stroke(course.position().stroke());
    let before = course.longest_dwell(0.02).expect("a dwell").interval.range;
    assert!((before.to_degrees() - 19.02).abs() < 0.01);
    let mut tally = Tally::default();
    let wanted = (Goal::Longest(0.02), keep);
    let after = needle::judge(Needle::default(), wanted, 0.08, &mut tally);
    let after = after.expect("the published drive holds all conditions");
    assert!(after.to_degrees() > 60.0, "{}", after.to_degrees());
    assert_eq!(
        [tally.false_claims, tally.worse_than_start],
        [0, 0],
        "{tally:?}"
    );
}

#[test]
fn claims_of_random_problems_hold() {
    let count = std::env::var("LINKAGE_PROBLEMS").ok();
    let count = count.and_then(|count| count.parse().ok());
    let long = std::env::var_os("LINKAGE_LONG").map(|_| 10_000);
    let results = count.or(long).unwrap_or(24);
    let mut random = Random::new(42);
    let mut tally = Tally::default();
    while tally.results + tally.errors < results {
        rocker::random(&mut random, &mut tally);
        press::random(&mut random, &mut tally);
        // In a build without optimisation a search of this drive takes seconds.
        if results > 1000 {
            needle::random(&mut random, &mut tally);
        }
    }
    println!("{tally:?}");
    assert_eq!(
        [tally.errors, tally.false_claims, tally.worse_than_start],
        [0; 3],
        "{tally:?}"
    );
    // Of bounds that make a search lose its way, the halves are met to the precision of searches only.
    assert!(tally.worse_than_half * 200 <= tally.results, "{tally:?}");
}

/// The verdict on an interval of a rocker: it is the change over the interval, whatever the variables of the search claim.
#[test]
fn a_verdict_is_computed_from_the_mechanism() {
    let rocker = Rocker::default();
    let assembly = rocker.assemble().expect("assembles");
    let motion = Motion {
        assembly: &assembly,
        range: (0.0, TAU),
        closed: true,
        positions: 121,
    };
    let assemble = |other: &Rocker| other.assemble().ok();
    let candidate = Candidate::new(&rocker, motion, &assemble);
    let wish: &dyn CycleObjective<Rocker, RockerAssembly, N> = &Dwell::longest(tip(), 1.0);
    let verdict = |from: f64, length: f64| -> Verdict {
        let chosen = Chosen {
            auxiliary: &[from, length, 0.0, 1.0],
            added: &[],
        };
        wish.verify(&candidate, chosen).expect("it turns")
    };
    // Across the seam of the turn, too.
    for (from, length) in [(0.3, 0.5), (6.0, 1.1), (-0.4, 2.0), (1.0, TAU)] {
        let ways: Vec<f64> = (0..=20_000)
            .map(|k| {
                let phi = from + length * f64::from(k) / 20_000.0;
                assembly.tip(phi).tip
            })
            .collect();
        let high = ways.iter().copied().fold(f64::MIN, f64::max);
        let low = ways.iter().copied().fold(f64::MAX, f64::min);
        let verdict = verdict(from, length);
        assert_eq!(verdict.goal, Some(-length));
        let by = verdict.conditions[0].by;
        assert!((by - (high - low - 1.0)).abs() < 1e-5, "{by} {high} {low}");
    }
}

/// An error of a search that did not converge does not ask for wider bounds, and has the numbers of the mechanism that comes nearest.
#[test]
fn a_search_that_is_lost_does_not_ask_for_wider_bounds() {
    let error = design()
        .want(Dwell::longest(tip(), 1.0))
        .want(Stroke(tip()).equal(100.0))
        .steps(1)
        .run()
        .expect_err("one step is not enough");
    let text = error.to_string();
    let DesignError::OutOfReach {
        nearest, settled, ..
    } = error
    else {
        panic!("{text}");
    };
    assert!(!settled && nearest.len() == 3, "{text}");
    assert!(
        text.contains("where the search did not converge (crank 5")
            && text.ends_with("narrow the bounds, begin with a mechanism that holds the conditions, or take more starts"),
        "{text}"
    );
}

// No mechanism is returned that does not run through the turn: results of random problems, followed by a solver that knows nothing of them.
// `LINKAGE_LONG=1` looks at 1000.

fn equations(bar: Rocker) -> impl Fn(f64, &[f64; 2]) -> [f64; 2] {
    move |phi, &[theta, psi]| {
        let x =
            bar.crank * phi.cos() + bar.coupler * theta.cos() - bar.frame - bar.rocker * psi.cos();
        let y = bar.crank * phi.sin() + bar.coupler * theta.sin() - bar.rocker * psi.sin();
        [x, y]
    }
}

/// The angles of coupler and rocker, from where the tip is on its arc.
fn angles(bar: &Rocker, assembly: &RockerAssembly, phi: f64) -> [f64; 2] {
    let psi = assembly.tip(phi).tip / bar.arm;
    let x = bar.frame + bar.rocker * psi.cos() - bar.crank * phi.cos();
    let y = bar.rocker * psi.sin() - bar.crank * phi.sin();
    [y.atan2(x), psi]
}

#[test]
fn results_run_through_the_turn() -> Result<(), DesignError> {
    let wanted = match std::env::var_os("LINKAGE_LONG") {
        Some(_) => 1000,
        None => 12,
    };
    let mut random = Random::new(64);
    let (mut results, mut refused) = (0, 0);
    while results < wanted {
        let (part, band) = (random.between(0.1, 0.6), random.between(0.3, 3.0));
        let design = CycleDesign::new(
            Rocker::default(),
            Rocker::assemble,
            Rocker::assemble_from,
            Rocker::circuits,
        )?;
        let design = ["crank", "coupler", "rocker", "frame"]
            .iter()
            .fold(design, |design, name| design.vary_by(name, part))
            .starts(6)
            .steps(60)
            .seed(random.bits());
        let run = match random.chance(0.5) {
            true => design.want(Dwell::longest(tip(), band)).run_all(),
            false => design.want(Peak(speed()).least()).run_all(),
        };
        let all = match run {
            Ok(all) => all,
            Err(DesignError::NotFound(_)) => {
                refused += 1;
                continue;
            }
            Err(error) => return Err(error),
        };
        results += all.len();
        for best in &all {
            let bar = best.mechanism;
            let angles: Vec<[f64; 2]> = inputs()
                .into_iter()
                .map(|phi| angles(&bar, &best.assembly, phi))
                .collect();
            let judged = follows(equations(bar), &angles);
            assert_eq!(judged, Ok(()), "{bar:?}");
        }
    }
    println!("{results} results run through the turn; {refused} problems had none");
    Ok(())
}
