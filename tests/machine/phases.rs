//! Several phases at once: against the references of one, and against dense searches of two and three.

use crate::Outcome;
use crate::waves::{A, B, C, CYCLE, D, POSITIONS, RANGE, member};
use crate::{mutual, number};
use linkage::clearance::{BestPhases, PhaseSet, Phases};
use std::f64::consts::TAU;

/// The least distance of two organs over the cycle: many positions, and a search around each that is lower than those
/// beside it.
fn dense(first: &dyn Fn(f64) -> [f64; 2], second: &dyn Fn(f64) -> [f64; 2], lead: f64) -> f64 {
    let at = |x: f64| {
        let (a, b) = (first(x), second(x + lead));
        (a[0] - b[0]).hypot(a[1] - b[1])
    };
    let spacing = TAU / 360.0;
    let row: Vec<f64> = (0..362).map(|k| at(f64::from(k) * spacing)).collect();
    let lows = (1..361).filter(|&k| row[k] <= row[k - 1] && row[k] <= row[k + 1]);
    let refined = lows.map(|k| {
        let (mut x, mut least, mut step) = (k as f64 * spacing, row[k], 0.5 * spacing);
        while step > 1e-7 {
            let beside = [x - step, x + step].map(|x| (x, at(x)));
            match beside.into_iter().find(|own| own.1 < least) {
                Some(own) => (x, least) = own,
                None => step *= 0.5,
            }
        }
        least
    });
    refined.fold(f64::INFINITY, f64::min)
}

/// Nothing of a grid is better, nor anything close by in any direction.
#[track_caller]
fn expect_best<const N: usize>(
    found: &BestPhases<2, N>,
    at: impl Fn([f64; N]) -> f64,
    (grid, open): (usize, f64),
) {
    assert!((at(found.phases) - found.distance).abs() < 1e-9);
    assert!(found.bound >= found.distance && found.bound < (1.0 + open) * found.distance);
    let place = |k: usize| RANGE.0 + (RANGE.1 - RANGE.0) * k as f64 / (grid - 1) as f64;
    for number in 0..grid.pow(N as u32) {
        let phases = core::array::from_fn(|k| place(number / grid.pow(k as u32) % grid));
        assert!(at(phases) <= found.distance + 1e-9, "{phases:?} {found:?}");
    }
    for step in [1e-2, 1e-4, 1e-6] {
        for number in 0..3_usize.pow(N as u32) {
            let phases = core::array::from_fn(|k| {
                let way = (number / 3_usize.pow(k as u32) % 3) as f64 - 1.0;
                (found.phases[k] + step * way).clamp(RANGE.0, RANGE.1)
            });
            assert!(at(phases) <= found.distance + 1e-9, "{phases:?} {found:?}");
        }
    }
}

#[test]
fn two_phases_of_three_organs() -> Outcome {
    let [a, b, c] = [A, B, C].map(member);
    let ab = Phases::new(CYCLE, POSITIONS, a, b)?;
    let ac = Phases::new(CYCLE, POSITIONS, a, c)?;
    let bc = Phases::new(CYCLE, POSITIONS, b, c)?;
    let set = PhaseSet::<2, 2>::new()
        .pair(None, Some(0), &ab)
        .pair(None, Some(1), &ac)
        .pair(Some(0), Some(1), &bc);
    let found = set.best([RANGE; 2])?;
    let [pa, pb, pc] = [a, b, c].map(|own| move |x: f64| own(x)[0][0]);
    let at = |[p, q]: [f64; 2]| {
        let pairs = [
            dense(&pa, &pb, p),
            dense(&pa, &pc, q),
            dense(&pb, &pc, q - p),
        ];
        pairs.into_iter().fold(f64::INFINITY, f64::min)
    };
    expect_best(&found, at, (21, 1.1e-3));
    // Three places are equally near, and nothing that makes all of them larger is left: shares of their slopes cancel.
    let [a, b, c] = &found.contacts[..] else {
        panic!("{found:?}")
    };
    assert_eq!([a.pair, b.pair, c.pair], [0, 1, 2]);
    let shares = [
        1.0,
        a.slopes[0] / c.slopes[0] * c.slopes[1] / b.slopes[1],
        -a.slopes[0] / c.slopes[0],
    ];
    assert!(shares.iter().all(|share| *share > 0.0), "{shares:?}");
    for contact in [a, b, c] {
        assert!((contact.nearest.distance - found.distance).abs() < 1e-12);
    }

    // All settings of two gears, one by one.
    let steps = [TAU / 24.0, TAU / 18.0];
    let gears = set.best_step([RANGE; 2], steps)?;
    let all = (-12..=12).flat_map(|p| (-9..=9).map(move |q| [p, q]));
    let of = |own: [i64; 2]| at([0, 1].map(|k| own[k] as f64 * steps[k]));
    let most = all.map(of).fold(0.0, f64::max);
    assert!((gears.distance - most).abs() < 1e-9);
    assert!((of(gears.slots.map(|slot| slot.step)) - most).abs() < 1e-9);
    assert!((gears.loss - (found.distance - gears.distance)).abs() < 1e-12);
    for (slot, phase) in gears.slots.iter().zip(found.phases) {
        assert!((slot.off - (slot.angle - phase)).abs() < 1e-15);
    }
    Ok(())
}

#[test]
fn three_phases_of_four_organs() -> Outcome {
    let [a, b, c, d] = [A, B, C, D].map(member);
    let ab = Phases::new(CYCLE, POSITIONS, a, b)?;
    let ac = Phases::new(CYCLE, POSITIONS, a, c)?;
    let bc = Phases::new(CYCLE, POSITIONS, b, c)?;
    let bd = Phases::new(CYCLE, POSITIONS, b, d)?;
    let set = PhaseSet::<2, 3>::new()
        .pair(None, Some(0), &ab)
        .pair(None, Some(1), &ac)
        .pair(Some(0), Some(1), &bc)
        .pair(Some(0), Some(2), &bd);
    let found = set.best([RANGE; 3])?;
    let [pa, pb, pc, pd] = [a, b, c, d].map(|own| move |x: f64| own(x)[0][0]);
    let at = |[p, q, r]: [f64; 3]| {
        let pairs = [
            dense(&pa, &pb, p),
            dense(&pa, &pc, q),
            dense(&pb, &pc, q - p),
            dense(&pb, &pd, r - p),
        ];
        pairs.into_iter().fold(f64::INFINITY, f64::min)
    };
    // The third and the fourth organ have room: there are more boxes than are looked at.
    expect_best(&found, at, (9, 5e-3));
    Ok(())
}

/// One phase of a set is that of the pair: the references of 40 digits hold.
#[test]
fn a_set_of_one_pair_has_its_best_lead() -> Outcome {
    let range = (-30f64.to_radians(), 30f64.to_radians());
    for case in mutual()["cases"].as_array().expect("cases") {
        let needles = super::clearance::placed(case, 0.0).assemble()?;
        let (hook, eye) = super::clearance::members(&needles);
        let phases = Phases::new(CYCLE, 97, hook, eye)?;
        let known = &case["best_lead"];
        let found = PhaseSet::<2, 1>::new()
            .pair(None, Some(0), &phases)
            .best([range])?;
        let back = PhaseSet::<2, 1>::new()
            .pair(Some(0), None, &phases)
            .best([range])?;
        for (set, sign) in [(&found, 1.0), (&back, -1.0)] {
            assert!((set.distance - number(&known["least_distance"])).abs() < 1e-11);
            let lead = sign * number(&known["lead_rad"]);
            // Turned the other way the optimum may be at another place of the range.
            assert!((set.phases[0] - lead).abs() < 1e-9, "{set:?}");
        }
        let contacts = known["contacts"].as_array().expect("contacts");
        assert_eq!(found.contacts.len(), contacts.len());
        for (contact, known) in found.contacts.iter().zip(contacts) {
            assert!((contact.slopes[0] - number(&known["dD_dlead"])).abs() < 1e-7);
        }
    }
    Ok(())
}
