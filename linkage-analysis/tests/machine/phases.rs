//! Best phases against dense searches.

use crate::distance::distance;
use crate::motion::Moving;
use crate::{TAU, TURN};
use linkage_analysis::clearance::{Optimum, PhaseError, Phases};
use linkage_analysis::summary::SummaryError;
use linkage_random::Random;
use std::f64::consts::PI;

const DENSE: usize = 240;

#[test]
fn best_of_all_phases() {
    let mut random = Random::new(5);
    let mut kinds = std::collections::BTreeSet::new();
    for case in 0..9 {
        let point: Moving<2> = Moving::random(&mut random, 5.0);
        let bar: [Moving<2>; 2] = std::array::from_fn(|_| Moving::random(&mut random, 40.0));
        let phases = Phases::new(TURN, 91, |x| [point.at(x)], |x| bar.map(|end| end.at(x)));
        let phases = phases.expect("phases");
        // The whole cycle, and parts of it whose ends are no positions.
        let range = match case % 3 {
            0 => (-PI, PI),
            1 => (-1.3, 0.4),
            _ => (0.2, 0.9),
        };
        let best = phases.best(range).expect("a best phase");
        kinds.insert(best.optimum as u8);
        assert!(
            best.bound >= best.distance && best.bound <= best.distance * 1.0011 + 0.3,
            "{best:?}"
        );
        let truth = |phase: f64| {
            let at = |i: usize| {
                let x = TAU * i as f64 / DENSE as f64;
                let shape = bar.map(|end| end.at(x + phase)[0]);
                distance(&[point.at(x)[0]], &shape)
            };
            (0..DENSE).map(at).fold(f64::INFINITY, f64::min)
        };
        assert!(
            truth(best.phase) - best.distance < 0.5 && truth(best.phase) >= best.distance - 1e-9
        );
        let least = |phase: f64| {
            let clearance = phases.clearance(phase).expect("a clearance");
            clearance.least().distance
        };
        for i in 0..=24 {
            let phase = range.0 + (range.1 - range.0) * f64::from(i) / 24.0;
            let other = least(phase);
            assert!(
                other <= best.distance + 1e-12,
                "{other} at {phase}: {best:?}"
            );
            assert!(
                other <= truth(phase) + 1e-9,
                "{other} at {phase}, {}",
                truth(phase)
            );
        }
        for contact in &best.contacts {
            const H: f64 = 1e-6;
            let along = |phase: f64| {
                let found = phases.clearance(phase).expect("a clearance");
                let near = |a: f64| (a - contact.nearest.at).abs();
                let mut minima = found.minima().to_vec();
                minima.sort_by(|a, b| near(a.at).total_cmp(&near(b.at)));
                minima[0].distance
            };
            let slope = (along(best.phase + H) - along(best.phase - H)) / (2.0 * H);
            assert!(
                best.distance < 0.1 || (contact.slope - slope).abs() < 1e-4 * (1.0 + slope.abs()),
                "{slope} {contact:?}"
            );
        }
        let step = TAU / 36.0;
        let found = phases.best_step(range, step).expect("a step");
        let slots = (-18..=18)
            .map(|slot| f64::from(slot) * step)
            .filter(|phase| (range.0 - 1e-9..=range.1 + 1e-9).contains(phase));
        for phase in slots {
            let other = least(phase);
            assert!(
                other <= found.distance + 1e-12,
                "{other} at {phase}: {found:?}"
            );
        }
        assert!(
            (found.slot.angle - found.slot.step as f64 * step).abs() < 1e-15 && found.loss >= 0.0
        );
    }
    assert_eq!(kinds.len(), 3, "smooth, equal, end: {kinds:?}");
    assert!(kinds.contains(&(Optimum::Equal as u8)));
}

/// A narrow peak between the phases that a search begins with, beside wide ones that are lower: fast motions that fit
/// each other at one phase alone, there to the last digit. The narrowest ones are between two such phases, both of which
/// say that nothing rises there: only the bound of the second derivative knows better.
#[test]
fn narrow_peaks() {
    let wide = [(1.0, 6.0), (7.0, 4.0), (9.0, 5.0)];
    let narrow = [(1.0, 6.0), (31.0, 4.0), (37.0, 5.0)];
    let cases = [0.2, 0.19, 2.55, -1.1].map(|lead| (lead, wide, 145, 1e-9));
    let middles = [0.5, 2.5, -4.5].map(|step| (step * TAU / 16.0, narrow, 721, 1e-7));
    // Beside the peak 1e-10 of a radian are 3e-8 mm of the fastest motions.
    for (lead, waves, positions, near) in cases.into_iter().chain(middles) {
        let along = |x: f64| {
            let mut jet = [0.0; 3];
            for (n, size) in waves {
                let (sin, cos) = (n * x).sin_cos();
                jet[0] += size * cos;
                jet[1] -= size * n * sin;
                jet[2] -= size * n * n * cos;
            }
            jet
        };
        let first = |x: f64| [along(x).map(|x| [x, 0.0])];
        let second = |x: f64| {
            let [y, v, a] = along(x + lead);
            [[[y + 40.0, 0.0], [v, 0.0], [a, 0.0]]]
        };
        let phases = Phases::new(TURN, positions, first, second).expect("phases");
        let best = phases.best((-PI, PI)).expect("a best phase");
        assert!(
            (best.distance - 40.0).abs() < near && (best.phase + lead).abs() < 1e-9,
            "{lead}: {best:?}"
        );
        assert!(best.bound < 40.05);
    }
}

#[test]
fn messages() {
    let crank = |x: f64| {
        let (sin, cos) = x.sin_cos();
        [[[cos, sin], [-sin, cos], [-cos, -sin]]]
    };
    let line = |x: f64| [[[x, 0.0], [1.0, 0.0], [0.0; 2]]];
    let gap = |x: f64| {
        if x > 3.0 {
            [[[f64::NAN; 2]; 3]]
        } else {
            crank(x)
        }
    };
    let told = |error: PhaseError| error.to_string();
    let error = Phases::new(TURN, 73, crank, line)
        .map(|_| ())
        .expect_err("no cycle");
    assert_eq!(
        told(error),
        "the second organ does not repeat itself from 0 to 360 deg: its points or their derivatives differ by 6.28319\n\
         help: give the range of a whole cycle"
    );
    let error = Phases::new(TURN, 73, gap, crank)
        .map(|_| ())
        .expect_err("a gap");
    assert_eq!(
        told(error),
        "the first organ cannot be assembled at 38 of the positions, first at 175 deg: a phase would turn the other organ \
         past them"
    );
    let error = Phases::new(TURN, 1, crank, crank)
        .map(|_| ())
        .expect_err("one position");
    assert_eq!(
        error,
        PhaseError::Curve(SummaryError::Positions { positions: 1 })
    );
    let phases = Phases::new(TURN, 73, crank, |x| {
        crank(x).map(|p| [[p[0][0] + 5.0, p[0][1]], p[1], p[2]])
    })
    .expect("phases");
    assert_eq!(
        told(phases.best((1.0, 0.5)).expect_err("no range")),
        "the phases from 57.2958 to 28.6479 deg are none, infinite, or more than a cycle: give the lower one first"
    );
    assert!(phases.best((-4.0, 4.0)).is_err());
    assert_eq!(
        told(phases.best_step((0.1, 0.2), 0.25).expect_err("no step")),
        "no whole number of steps of 14.3239 deg lies from 5.72958 to 11.4592 deg"
    );
    // Two equal cranks side by side: without a phase they stay as far apart as their pivots, which is the best.
    let best = phases.best((-PI, PI)).expect("a best phase");
    assert!(
        (best.distance - 5.0).abs() < 1e-12 && best.phase.abs() < 1e-6,
        "{best:?}"
    );
}
