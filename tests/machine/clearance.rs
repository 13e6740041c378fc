//! Least distances of two needles, what dimensions do to them, and the phases that make them largest.

use crate::Outcome;
use crate::{TwoNeedles, TwoNeedlesAssembly};
use crate::{derivatives, mutual, number, radians};
use linkage::Vector2;
use linkage::clearance::{Clearance, Nearest, Optimum, Phases};
use linkage::summary::positions;
use linkage::tolerance::Tolerances;
use serde_json::Value;
use std::f64::consts::TAU;

const CYCLE: (f64, f64) = (0.0, TAU);
const POSITIONS: usize = 97;
const PARAMETERS: usize = TwoNeedles::SCALARS;

type Point = [Vector2<f64>; 3];

pub(crate) fn placed(case: &Value, lead: f64) -> TwoNeedles {
    TwoNeedles {
        lead,
        dx: number(&case["placement"]["dx"]),
        dy: number(&case["placement"]["dy"]),
        ang: radians(&case["placement"]["ang_deg"]),
        ..TwoNeedles::default()
    }
}

/// As a user does it who wants it fast: the coarse look from a sweep.
fn clearance(needles: &TwoNeedlesAssembly) -> Clearance<2> {
    let places: Vec<f64> = positions(CYCLE, POSITIONS).collect();
    let rows = needles.tips_sweep(&places);
    let shapes = |m: crate::Tips| ([[m.hook, m.hook_v, m.hook_a]], [[m.eye, m.eye_v, m.eye_a]]);
    let found = Clearance::swept(
        CYCLE,
        POSITIONS,
        |i| shapes(rows[i]),
        |x| shapes(needles.tips(x)),
    );
    found.expect("assembled")
}

fn sensitivity(needles: &TwoNeedlesAssembly, nearest: &Nearest<2>) -> [f64; PARAMETERS] {
    let e = needles.accuracy(nearest.at);
    nearest.sensitivity([e.hook], [e.eye])
}

/// The largest difference as a share of the largest of the known numbers.
fn error(found: &[f64], known: &[f64]) -> f64 {
    let size = known.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    let differences = found.iter().zip(known).map(|(a, b)| (a - b).abs() / size);
    differences.fold(0.0, |largest, x| {
        if x > largest || x.is_nan() {
            x
        } else {
            largest
        }
    })
}

#[test]
fn two_needles() -> Outcome {
    for case in mutual()["cases"].as_array().expect("cases") {
        let needles = placed(case, radians(&case["lead_deg"])).assemble()?;
        let found = clearance(&needles);
        let minima = case["local_minima"].as_array().expect("minima");
        assert_eq!(found.minima().len(), minima.len());
        for (nearest, known) in found.minima().iter().zip(minima) {
            assert!((nearest.at - radians(&known["theta_deg"])).abs() < 1e-12 * TAU);
            assert!((nearest.distance - number(&known["distance"])).abs() < 1e-12);
            let bend = number(&known["second_derivative_per_rad2"]);
            assert!(
                (nearest.bend() / bend - 1.0).abs() < 1e-11,
                "{} {bend}",
                nearest.bend()
            );
        }
        let least = found.least();
        let of = |name: &str| derivatives(&case["least"][name], "", TwoNeedles::parameters());
        let value = error(&sensitivity(&needles, least), &of("value_sensitivity"));
        let (e, rate) = (needles.accuracy(least.at), needles.rates(least.at));
        let shift = least.shift([[e.hook, rate.hook]], [[e.eye, rate.eye]]);
        let shift = error(&shift, &of("angle_sensitivity"));
        println!("sensitivities: {value:.1e} of the distance, {shift:.1e} of its angle");
        assert!(value < 1e-12 && shift < 1e-11);

        // Every minimum with its own error: less is left than of the least distance alone.
        let tolerances = Tolerances::<PARAMETERS>::complete(TwoNeedles::parameters())?;
        let left = found.guaranteed(&tolerances, |nearest| sensitivity(&needles, nearest));
        let [alone] = tolerances
            .effects(&sensitivity(&needles, least))
            .worst_case();
        assert!(left.distance <= least.distance - alone && left.distance > 5.0);
        assert!((left.nominal - left.error - left.distance).abs() < 1e-15);
        println!(
            "least {:.4} mm, left {:.4} mm",
            least.distance, left.distance
        );
    }
    Ok(())
}

/// A difference turned back by the angle of a link is a point seen from that link.
#[test]
fn paths_in_a_moving_frame() -> Outcome {
    for case in mutual()["cases"].as_array().expect("cases") {
        let needles = placed(case, radians(&case["lead_deg"])).assemble()?;
        for known in case["eye_tip_in_hook_bar_frame"]
            .as_array()
            .expect("positions")
        {
            let found = needles.seen(radians(&known["theta_deg"]));
            let of = |x: &str, y: &str| Vector2::new(number(&known[x]), number(&known[y]));
            assert!((found.seen - of("xi", "eta")).norm() < 1e-11);
            assert!((found.v - of("dxi_per_rad", "deta_per_rad")).norm() < 1e-11);
        }
    }
    Ok(())
}

/// The needles as organs of their own: without a lead, so that the phase is the lead.
pub(crate) fn members(
    needles: &TwoNeedlesAssembly,
) -> (impl Fn(f64) -> [Point; 1], impl Fn(f64) -> [Point; 1]) {
    let hook = |x| {
        let m = needles.hook(x);
        [[m.p, m.v, m.a]]
    };
    let eye = |x| {
        let m = needles.eye(x);
        [[m.p, m.v, m.a]]
    };
    (hook, eye)
}

#[test]
fn best_leads() -> Outcome {
    let range = (-30f64.to_radians(), 30f64.to_radians());
    for case in mutual()["cases"].as_array().expect("cases") {
        let needles = placed(case, 0.0).assemble()?;
        let (hook, eye) = members(&needles);
        let phases = Phases::new(CYCLE, POSITIONS, hook, eye)?;
        let known = &case["best_lead"];
        let best = phases.best(range)?;
        println!(
            "lead {:.9} deg, {:.9} mm ({:?}), at most {:.6} mm, {} phases",
            best.phase.to_degrees(),
            best.distance,
            best.optimum,
            best.bound,
            best.probes
        );
        assert!((best.distance - number(&known["least_distance"])).abs() < 1e-12);
        let contacts = known["contacts"].as_array().expect("contacts");
        assert_eq!(best.contacts.len(), contacts.len());
        for (contact, known) in best.contacts.iter().zip(contacts) {
            assert!((contact.nearest.at - radians(&known["theta_deg"])).abs() < 1e-10);
            assert!((contact.slope - number(&known["dD_dlead"])).abs() < 1e-10);
        }
        let optimum = match known["kind"].as_str() {
            Some("two_equal_minima") => Optimum::Equal,
            _ => Optimum::Smooth,
        };
        assert_eq!(best.optimum, optimum);
        assert!(
            (best.phase - number(&known["lead_rad"])).abs() < 1e-12,
            "{}",
            best.phase
        );
        assert!(best.bound >= best.distance && best.bound <= best.distance * 1.0011);

        // All slots of a gear, one by one.
        let step = TAU / 48.0;
        let slots = (-4..=4).map(|slot| {
            let phase = f64::from(slot) * step;
            (
                slot,
                phases.clearance(phase).expect("assembled").least().distance,
            )
        });
        let (slot, distance) = slots
            .reduce(|a, b| if b.1 > a.1 { b } else { a })
            .expect("slots");
        let found = phases.best_step(range, step)?;
        assert_eq!(
            (found.slot.step, found.distance),
            (i64::from(slot), distance)
        );
        assert!((found.loss - (best.distance - distance)).abs() < 1e-12 && found.loss > 0.0);

        // A mechanism whose parameter is the lead.
        let lead = found.slot.angle;
        let other = clearance(&placed(case, lead).assemble()?);
        assert!((other.least().distance - distance).abs() < 1e-12);
    }
    Ok(())
}
