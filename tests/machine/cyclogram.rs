//! Dwells and extremes of three drives, with what dimensions do to their angles.

use crate::Outcome;
use crate::{TwoCranks, TwoNeedles};
use crate::{cyclogram, derivatives, number, radians};
use linkage::Parameter;
use linkage::cyclogram::{Band, Cyclogram, CyclogramError, Member, Motion};
use linkage::summary::{Curve, positions};
use linkage::tolerance::Tolerances;
use serde_json::Value;
use std::f64::consts::TAU;

const CYCLE: (f64, f64) = (0.0, TAU);
const POSITIONS: usize = 90;

/// A drive: its course and what dimensions do to it.
struct Drive<'a, const P: usize> {
    name: &'static str,
    /// How many turns of the reference's crank a turn of the shaft is.
    turns: f64,
    parameters: &'static [Parameter],
    jet: &'a dyn Fn(f64) -> [f64; 3],
    value: &'a dyn Fn(f64) -> [f64; P],
    rate: &'a dyn Fn(f64) -> [f64; P],
}

/// The largest differences: of angles as parts of a turn, of derivatives as parts of their largest.
#[derive(Debug, Default)]
struct Errors {
    angle: f64,
    value: f64,
    derivative: f64,
}

impl Errors {
    fn add(of: &mut f64, error: f64) {
        // Not `f64::max`, which would let a NaN pass.
        if error.abs() > *of || error.is_nan() {
            *of = error.abs();
        }
    }
}

impl<const P: usize> Drive<'_, P> {
    fn member(&self, bands: &[Band]) -> Result<Member, CyclogramError> {
        let rows: Vec<[f64; 3]> = positions(CYCLE, POSITIONS).map(self.jet).collect();
        let course = Curve::swept(CYCLE, POSITIONS, |i| rows[i], self.jet).expect("a course");
        let member = Member::new(self.name, &course, bands)?;
        Ok(member.unit("mm").sensitivities(self.value, self.rate))
    }

    /// Against the reference: all intervals of all dwells, and the limits.
    fn compare(&self, known: &Value) -> Errors {
        let mut errors = Errors::default();
        for dwell in known["dwells"].as_array().expect("dwells") {
            let band = number(&dwell["band"]);
            let upper = dwell["extreme"] == "upper";
            let band = if upper {
                Band::Top(band)
            } else {
                Band::Bottom(band)
            };
            let member = self.member(&[band]).expect("an organ");
            let dwells = member.intervals().filter(|(motion, _)| motion.is_dwell());
            let found: Vec<[f64; 2]> = dwells
                .map(|(_, at)| [at.from, at.from + at.range])
                .collect();
            let intervals = dwell["all_intervals_deg"].as_array().expect("intervals");
            assert_eq!(found.len(), intervals.len(), "{} {band}", self.name);
            for (found, interval) in found.iter().zip(intervals) {
                for k in 0..2 {
                    let known = radians(&interval[k]) / self.turns;
                    Errors::add(&mut errors.angle, (found[k] - known) / TAU);
                }
            }
        }
        self.compare_limits(known, &mut errors);
        errors
    }

    /// The limits are the events of an organ whose one band is a hair in the middle: between they turn without a
    /// dwell.
    fn compare_limits(&self, known: &Value, errors: &mut Errors) {
        let [low, high] = ["global_min", "global_max"].map(|name| number(&known[name]));
        let middle = 0.5 * (low + high);
        let member = self
            .member(&[Band::Between(middle, middle + 1e-3)])
            .expect("an organ");
        let turns = member
            .events()
            .iter()
            .enumerate()
            .filter(|(_, event)| !event.begins.is_dwell() && !event.ends.is_dwell());
        let turns: Vec<_> = turns.collect();
        let limits = known["extremes"].as_array().expect("extremes");
        assert_eq!(turns.len(), limits.len(), "{}", self.name);
        for ((index, event), limit) in turns.iter().zip(limits) {
            Errors::add(
                &mut errors.angle,
                (event.at - number(&limit["angle_rad"]) / self.turns) / TAU,
            );
            Errors::add(
                &mut errors.value,
                (event.value - number(&limit["value"])) / (high - low),
            );
            let angles = &limit["angle_sensitivity_rad_per_unit"];
            let mut known = derivatives(angles, self.name, self.parameters);
            if self.name == "eye" {
                // What leads does everything earlier.
                known[TwoNeedles::INDEX_LEAD] = -1.0;
            }
            let size = known.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
            let found = member.sensitivity(*index).expect("sensitivities");
            for (found, known) in found.iter().zip(&known) {
                Errors::add(&mut errors.derivative, (found * self.turns - known) / size);
            }
        }
    }

    /// The angles of bounds are shifted by dimensions as differences say, with bands that follow their limit.
    fn compare_bounds(&self, changed: impl Fn(usize, f64) -> Member, band: Band) {
        let member = self.member(&[band]).expect("an organ");
        for p in 0..P {
            let h = 1e-4
                * if self.parameters[p].unit == "rad" {
                    0.01
                } else {
                    1.0
                };
            let [more, less] = [h, -h].map(|h| changed(p, h));
            for (index, event) in member
                .events()
                .iter()
                .enumerate()
                .filter(|(_, event)| event.begins.is_dwell() || event.ends.is_dwell())
            {
                let difference = (more.events()[index].at - less.events()[index].at) / (2.0 * h);
                let found = member.sensitivity(index).expect("sensitivities")[p];
                let scale = member
                    .sensitivity(index)
                    .expect("sensitivities")
                    .iter()
                    .fold(0.0, |size: f64, x| size.max(x.abs()));
                let error = (found - difference) / scale;
                assert!(
                    error.abs() < 1e-6,
                    "{} {index} {event:?} {}: {found} {difference}",
                    self.name,
                    self.parameters[p].name
                );
            }
        }
    }
}

#[test]
fn three_drives() -> Outcome {
    let known = cyclogram();
    let needles = TwoNeedles {
        lead: 0.0,
        ..TwoNeedles::default()
    }
    .assemble()?;
    let hook = Drive {
        name: "hook",
        turns: 2.0,
        parameters: TwoNeedles::parameters(),
        jet: &|x| {
            let m = needles.height(x);
            [m.y, m.v, m.a]
        },
        value: &|x| needles.height_accuracy(x).e,
        rate: &|x| needles.height_rate(x).e,
    };
    let eye = Drive {
        name: "eye",
        turns: 1.0,
        parameters: TwoNeedles::parameters(),
        jet: &|x| {
            let m = needles.arc(x);
            [m.s, m.v, m.a]
        },
        value: &|x| needles.arc_accuracy(x).e,
        rate: &|x| needles.arc_rate(x).e,
    };
    let cranks = TwoCranks::default().assemble()?;
    let triad = Drive {
        name: "triad",
        turns: 1.0,
        parameters: TwoCranks::parameters(),
        jet: &|x| {
            let m = cranks.slide(x);
            [m.s, m.v, m.a]
        },
        value: &|x| cranks.slide_accuracy(x).e,
        rate: &|x| cranks.slide_rate(x).e,
    };
    let all = [
        hook.compare(&known["hook_needle"]),
        eye.compare(&known["eye_needle"]),
        triad.compare(&known["two_crank_triad"]),
    ];
    for errors in all {
        println!("{errors:?}");
        assert!(
            errors.angle < 1e-12 && errors.value < 1e-14 && errors.derivative < 1e-13,
            "{errors:?}"
        );
    }

    let nominal = TwoCranks::default();
    let changed = |p: usize, h: f64| {
        let mut values = linkage::Dimensions::values(&nominal);
        values[p] += h;
        let cranks = <TwoCranks as linkage::Dimensions<14>>::from_values(&values)
            .assemble()
            .expect("assembled");
        let course = Curve::new(CYCLE, POSITIONS, |x| {
            let m = cranks.slide(x);
            [m.s, m.v, m.a]
        });
        Member::new("triad", &course.expect("a course"), &[Band::Top(0.1)]).expect("an organ")
    };
    triad.compare_bounds(changed, Band::Top(0.1));

    let tolerances = Tolerances::<14>::complete(TwoCranks::parameters())?;
    let bands = [Band::Top(0.1), Band::Bottom(0.1)];
    let machine = Cyclogram::new([
        hook.member(&bands)?,
        eye.member(&bands)?,
        triad.member(&bands)?.tolerances(&tolerances)?,
    ])?;
    println!("{machine}");
    let motions: Vec<Motion> = machine.members()[2]
        .intervals()
        .map(|(motion, _)| motion)
        .collect();
    assert_eq!(
        motions,
        [
            Motion::Dwell(1),
            Motion::Advance,
            Motion::Dwell(0),
            Motion::Return
        ]
    );
    // Everything that is told of pairs of organs against the angles themselves.
    let both = machine.together(|motions| motions[0].is_dwell() && motions[1].is_dwell());
    let sampled = (0..36_000).filter(|i| {
        let x = TAU * (f64::from(*i) + 0.5) / 36_000.0;
        machine.members()[..2]
            .iter()
            .all(|member| member.motion(x).is_dwell())
    });
    let share = sampled.count() as f64 / 36_000.0;
    let found: f64 = both.iter().map(|interval| interval.range).sum();
    assert!(
        (found / TAU - share).abs() < 2e-4 && share > 0.01,
        "{both:?} {share}"
    );
    let turns: f64 = machine.moments().map(|moment| moment.after).sum();
    assert!((turns - TAU).abs() < 1e-12);
    Ok(())
}
