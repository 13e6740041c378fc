//! A four-bar that exists is identified: its dimensions from 60 noisy positions.
//!
//! Readings of the rocker's angle alone cannot tell everything, and what they cannot tell is named, with what would.
//! Readings of the coupler point do, a few of them missing, one of them wrong. Then the same is done with the errors of
//! many other days: estimates must lie about the truth as their standard errors say.

use crate::check::Check;
use linkage::Dimensions;
use linkage::design::{Identification, Identified, Measured};
use linkage::tolerance::Uncertainties;
use linkage_random::Random;
use std::error::Error;
use std::f64::consts::TAU;

include!("../../mechanisms/calibrate.rs");

/// All parameters.
const COUNT: usize = 10;
/// Positions that are read.
const POSITIONS: usize = 60;
/// Standard deviation of a reading of the coupler point, in mm.
const POINT: f64 = 0.02;
/// Standard deviation of a reading of the rocker's angle, in radians.
const ANGLE: f64 = 2e-4;

/// The four-bar as it really is.
fn truth() -> FourBar {
    FourBar {
        base: [0.42, -0.27].into(),
        tilt: 0.004,
        zero: -0.007,
        frame: 140.31,
        crank: 49.84,
        coupler: 120.22,
        rocker: 100.35,
        arm: [59.71, 30.44].into(),
    }
}

fn inputs() -> Vec<f64> {
    (0..POSITIONS)
        .map(|i| TAU * i as f64 / POSITIONS as f64)
        .collect()
}

/// A normally distributed error of standard deviation 1: Box and Muller's.
fn error(random: &mut Random) -> f64 {
    let (u, v) = (1.0 - random.between(0.0, 1.0), random.between(0.0, TAU));
    (-2.0 * u.ln()).sqrt() * v.cos()
}

fn names() -> impl Iterator<Item = &'static str> {
    FourBar::PARAMETERS.iter().map(|parameter| parameter.name)
}

fn identification()
-> Result<Identification<'static, FourBar, FourBarAssembly, COUNT>, Box<dyn Error>> {
    let drawn = FourBar::default();
    Ok(Identification::new(drawn, drawn.assemble()?).unknown(names()))
}

/// Readings of the coupler point; the first day's have gaps and a mistake.
fn points(seed: u64) -> Result<Vec<[f64; 2]>, Box<dyn Error>> {
    let real = truth().assemble()?;
    let mut random = Random::new(seed);
    let read = inputs().into_iter().map(|phi| {
        let [x, y]: [f64; 2] = real.path(phi).tracer.into();
        [
            x + POINT * error(&mut random),
            y + POINT * error(&mut random),
        ]
    });
    let mut read: Vec<[f64; 2]> = read.collect();
    if seed == 0 {
        read[7] = [f64::NAN, f64::NAN];
        read[31][1] = f64::NAN;
        read[44][0] += 8.0 * POINT;
    }
    Ok(read)
}

fn from_points(read: Vec<[f64; 2]>) -> Result<Identified<FourBar, COUNT>, Box<dyn Error>> {
    let measured = Measured::new("tracer", read)
        .at_inputs(inputs())
        .deviations([POINT; 2]);
    let identification = identification()?;
    Ok(identification
        .measured(measured.computed_by(FourBarAssembly::path_sweep_sets_into))
        .run()?)
}

fn from_angles() -> Result<Identified<FourBar, COUNT>, Box<dyn Error>> {
    let real = truth().assemble()?;
    let mut random = Random::new(1000);
    let read = inputs()
        .into_iter()
        .map(|phi| [real.rocker(phi).psi + ANGLE * error(&mut random)]);
    let read: Vec<[f64; 1]> = read.collect();
    let measured = Measured::new("psi", read)
        .at_inputs(inputs())
        .deviations([ANGLE]);
    let offer = Measured::offer("tracer")
        .at_inputs(inputs())
        .deviations([POINT; 2]);
    Ok(identification()?
        .measured(measured.computed_by(FourBarAssembly::rocker_sweep_sets_into))
        .offered(offer.computed_by(FourBarAssembly::path_sweep_sets_into))
        .run()?)
}

/// The deviation of each estimate from the truth over its standard error.
fn off(found: &Identified<FourBar, COUNT>) -> [f64; COUNT] {
    let real = truth().values();
    let parameters = &found.parameters;
    std::array::from_fn(|i| (parameters[i].value - real[i]) / parameters[i].standard_error)
}

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let angles = from_angles()?;
    println!("From angles of the rocker:\n{angles}");
    check_angles(&mut check, &angles);
    let points = from_points(points(0)?)?;
    println!("\nFrom places of the coupler point:\n{points}");
    check_points(&mut check, &points)?;
    println!("\nOn {} other days:", DAYS);
    check_days(&mut check)?;
    check.finish()
}

fn check_angles(check: &mut Check, found: &Identified<FourBar, COUNT>) {
    let unseen: Vec<Vec<&str>> = found
        .undetermined
        .iter()
        .map(|own| own.parts.iter().map(|(name, _)| *name).collect())
        .collect();
    let scale = vec!["frame", "crank", "coupler", "rocker"];
    let alone = ["base.x", "base.y", "arm.x", "arm.y"].map(|name| vec![name]);
    check.holds("base and arm are not seen", unseen[..4] == alone);
    check.holds("nor is the scale of the loop", unseen[4..] == [scale]);
    let scale = &found.undetermined[4];
    check.holds(
        "which is said so",
        scale.words.starts_with("a common scale of"),
    );
    let real = truth();
    let told = scale
        .parts
        .iter()
        .map(|(_, change)| change / scale.parts[0].1);
    let lengths = ["frame", "crank", "coupler", "rocker"].map(|name| estimate(found, name));
    check.all_near(
        "its parts are the lengths",
        told.zip(lengths.map(|x| x / lengths[0])),
        1e-9,
    );
    let would = |own: &linkage::design::Undetermined| {
        own.remedies
            .iter()
            .any(|remedy| remedy.quantity.starts_with("tracer"))
    };
    let all = found.undetermined.iter().all(would);
    check.holds("places of the coupler point would tell all", all);
    let seen = off(found);
    let angles = [FourBar::INDEX_TILT, FourBar::INDEX_ZERO].map(|i| seen[i].abs());
    check.holds(
        "tilt and zero within four standard errors",
        angles.iter().all(|z| *z < 4.0),
    );
    let ratios = [real.crank, real.coupler, real.rocker].map(|x| x / real.frame);
    let found = lengths[1..].iter().map(|x| x / lengths[0]);
    check.all_near("proportions", found.zip(ratios), 2e-3);
}

fn estimate(found: &Identified<FourBar, COUNT>, name: &str) -> f64 {
    let named = found.parameters.iter().find(|own| own.name == name);
    named.map_or(f64::NAN, |own| own.value)
}

fn check_points(
    check: &mut Check,
    found: &Identified<FourBar, COUNT>,
) -> Result<(), Box<dyn Error>> {
    check.holds("everything is determined", found.undetermined.is_empty());
    check.holds(
        "missing readings are left out",
        found.residuals.len() == 2 * POSITIONS - 3,
    );
    let outliers: Vec<_> = found
        .outliers()
        .map(|own| (own.number, own.input))
        .collect();
    check.holds(
        "the wrong reading is found",
        outliers == [("tracer.x", inputs()[44])],
    );
    // Without it, all is as it should be.
    let mut good = points(0)?;
    good[44][0] = f64::NAN;
    let good = from_points(good)?;
    let freedom = good.degrees_of_freedom as f64;
    check.near(
        "sum of squares",
        good.sum_of_squares,
        freedom,
        4.0 * (2.0 * freedom).sqrt(),
    );
    check.holds("no other is wrong", good.outliers().count() == 0);
    check.all_near("off, in standard errors", off(&good).map(|z| (z, 0.0)), 4.0);
    Ok(())
}

// The same readings with the errors of many other days.

/// Days with other errors.
const DAYS: u64 = 100;

/// Estimates over many days against what each day says of itself.
fn check_days(check: &mut Check) -> Result<(), Box<dyn Error>> {
    let days = (1..=DAYS).map(|seed| from_points(points(seed)?));
    let days: Vec<_> = days.collect::<Result<_, _>>()?;
    let count = DAYS as f64;
    let all: Vec<[f64; COUNT]> = days.iter().map(off).collect();
    let mean = |of: &dyn Fn(&[f64; COUNT]) -> f64| all.iter().map(of).sum::<f64>() / count;
    for (i, name) in names().enumerate() {
        let bias = mean(&|day| day[i]);
        let spread = mean(&|day| (day[i] - bias).powi(2)).sqrt();
        let within = mean(&|day| f64::from(u8::from(day[i].abs() < 1.96)));
        // Four standard deviations of what is found from so many days.
        check.near(&format!("{name}: mean off"), bias, 0.0, 4.0 / count.sqrt());
        check.near(
            &format!("{name}: spread"),
            spread,
            1.0,
            4.0 / (2.0 * count).sqrt(),
        );
        check.near(
            &format!("{name}: part within 95 %"),
            within,
            0.95,
            4.0 * (0.95 * 0.05 / count).sqrt(),
        );
    }
    let freedom = days[0].degrees_of_freedom as f64;
    let squares = days.iter().map(|day| day.sum_of_squares).sum::<f64>() / count;
    check.near(
        "sum of squares",
        squares,
        freedom,
        4.0 * (2.0 * freedom / count).sqrt(),
    );
    // One correlation, and what one day's covariance says of the coupler point at another position.
    let (i, j) = (FourBar::INDEX_BASE_Y, FourBar::INDEX_COUPLER);
    let product = mean(&|day| day[i] * day[j]) / mean(&|day| day[i] * day[i]);
    let product = product * (mean(&|day| day[i] * day[i]) / mean(&|day| day[j] * day[j])).sqrt();
    check.near(
        "correlation of base.y and coupler",
        product,
        days[0].correlation(i, j),
        0.02,
    );
    let phi = 1.234;
    let real = truth().assemble()?.path(phi).tracer;
    let at = |day: &Identified<FourBar, COUNT>| {
        Ok::<_, Box<dyn Error>>(day.mechanism.assemble()?.path(phi))
    };
    let squares = days
        .iter()
        .map(|day| Ok((at(day)?.tracer.x - real.x).powi(2)));
    let spread = (squares.sum::<Result<f64, Box<dyn Error>>>()? / count).sqrt();
    let uncertain =
        Uncertainties::covariance(&days[0].mechanism.parameters(), days[0].covariance())?;
    let [x, _] = uncertain.budget(&at(&days[0])?.s).standard();
    check.near(
        "uncertainty of a place, in um",
        1e3 * x,
        1e3 * spread,
        4e3 * x / (2.0 * count).sqrt(),
    );
    Ok(())
}
