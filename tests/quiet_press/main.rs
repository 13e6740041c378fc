//! A press that runs quietly: the least peak of the driving torque over the length of the rod, the place of the guide and the counterweights on
//! the crank, with the stroke kept and the force on the guide limited.
//!
//! The ram works against a die cushion, a spring that is pressed at the lower end of the stroke and gives its energy back. At
//! constant speed the drive must deliver what cushion, weights and inertia forces take, and the same work is returned half a turn later: the peak
//! of the torque decides about motor and gears.
//!
//! What the peak costs at the guide is a front of compromises, from the least peak alone to the least force on the guide alone; so is what shakes the
//! foundation, which is limited to what it was. The page in `target/comparisons/quiet_press` has them.
//!
//! The peak is checked in three ways: by samples, by other presses nearby, and by the least peak of counterweights alone, a linear problem that
//! `linkage::balancing` solves in another way and with a proof.

#[path = "../../examples/check/comparison.rs"]
mod check;
mod checks;
#[path = "../programs/folders.rs"]
mod folders;

use check::Check;
use checks::{compare, compare_counterweights, compare_front, compare_shaking};
use linkage::design::{
    BestCycle, Compromise, Curve, CycleDesign, Figure, Peak, RootMeanSquare, Stroke,
};
use linkage::report::{Aim, Compared, Comparison, Report};
use std::error::Error;
use std::f64::consts::TAU;
use std::path::{Path, PathBuf};

/// Compromises of peak and guide.
const COMPROMISES: usize = 6;

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let first = Press::default().assemble()?;
    let height = |phi: f64| first.motion(phi).ram;
    let stroke = height(0.25 * TAU) - height(0.75 * TAU);
    let peak = design(stroke)?.want(Peak(torque()).least()).run()?;
    let mild = design(stroke)?
        .want(RootMeanSquare(torque()).least())
        .run()?;
    println!(
        "Peaks of the driving torque at {:.0} turns a minute:",
        SPEED * 60.0 / TAU
    );
    print("as it was", &first);
    print("least peak", &peak.assembly);
    print("least mean square", &mild.assembly);
    print!("{peak}");

    let mut check = Check::default();
    let before = sampled(|phi| first.drive(phi, SPEED).t);
    check.holds(
        "the peak is less than a quarter of what it was",
        peak.goal < 0.25 * before,
    );
    compare(&peak, stroke, &mut check);
    compare_counterweights(&peak, &mut check)?;
    let square = |press: &PressAssembly| {
        (0..720)
            .map(|i| press.drive(TAU * f64::from(i) / 720.0, SPEED).t.powi(2))
            .sum::<f64>()
    };
    check.near(
        "root mean square, N m",
        1e-3 * (square(&mild.assembly) / 720.0).sqrt(),
        1e-3 * mild.goal,
        1e-6,
    );
    let lower = square(&mild.assembly) < square(&peak.assembly) && mild.goal < peak.goal;
    check.holds(
        "the least mean square is below that of the least peak",
        lower,
    );
    compare_shaking(&first, &peak, stroke, &mut check)?;
    let front = open(stroke)?.front(Peak(torque()).least(), Peak(side()).least(), COMPROMISES)?;
    compare_front(&front, &peak, &mut check);
    // Tests of pages look at it.
    compared(&first, &front, &folders::target("comparisons/quiet_press"))?;
    check.finish()
}

// A page of the press as it was and all compromises.

/// Writes the page; the first press is what the others are compared with.
fn compared(
    first: &PressAssembly,
    front: &[Trade],
    folder: &Path,
) -> Result<PathBuf, Box<dyn Error>> {
    let presses = || core::iter::once(first).chain(front.iter().map(|found| &found.best.assembly));
    let reports: Vec<Report> = presses().map(report).collect();
    let about = "Each press has the least peak of the driving torque for what its guide bears; the stroke is kept.";
    let mut comparison = Comparison::new("A quiet press").about(about);
    for (k, (press, report)) in presses().zip(&reports).enumerate() {
        let torque = 1e-3 * sampled(|phi| press.drive(phi, SPEED).t);
        let side = sampled(|phi| press.side(phi, SPEED).f.x);
        let name = match k {
            0 => "as it was".to_string(),
            _ => format!("guide {side:.0} N"),
        };
        let compared = Compared::new(name, report)
            .figure("peak of the torque", torque, "N m")
            .figure("force on the guide", side, "N");
        comparison = comparison.design(compared);
    }
    let comparison = comparison.curves(["ram", "t"]).front([
        Aim::least("peak of the torque"),
        Aim::least("force on the guide"),
    ]);
    Ok(comparison.write(folder)?)
}

fn report(press: &PressAssembly) -> Report {
    let input = &Press::INPUTS[0];
    let phi = input.positions(361);
    Report::new("Press", input, &phi)
        .dimensions(press.mechanism())
        .structure(Press::STRUCTURE)
        .table(&press.motion_sweep(&phi))
        .table(&press.drive_sweep(&phi, &[SPEED]))
        .table(&press.picture_sweep(&phi))
}

// The press, and what is wanted of it.

include!("../../mechanisms/quiet_press.rs");

pub(crate) const N: usize = Press::PARAMETERS.len();
/// 270 turns a minute, in rad/s.
pub(crate) const SPEED: f64 = 9.0 * std::f64::consts::PI;
/// What the guide bears, in N.
pub(crate) const SIDE: f64 = 105.0;

/// A press that was found, alone and among compromises.
pub(crate) type Found = BestCycle<Press, PressAssembly>;
pub(crate) type Trade = Compromise<Press, PressAssembly>;
pub(crate) type Drawn<'a> = Curve<'a, PressAssembly, N>;

pub(crate) fn torque() -> Drawn<'static> {
    let jet = |press: &PressAssembly, phi| {
        let Drive { t, v, a } = press.drive(phi, SPEED);
        [t, v, a]
    };
    Curve::new(jet, |press, phi| press.effects(phi, SPEED).e)
}

pub(crate) fn side() -> Drawn<'static> {
    let jet = |press: &PressAssembly, phi| {
        let side = press.side(phi, SPEED);
        [side.f.x, side.v.x, side.a.x]
    };
    Curve::new(jet, |press, phi| {
        press.side(phi, SPEED).e.map(|force| force.x)
    })
}

/// The size of the force that shakes the foundation.
pub(crate) fn shaking() -> Drawn<'static> {
    let jet = |press: &PressAssembly, phi| {
        let force = press.shaking(phi, SPEED);
        [force.f, force.v, force.a].map(|f| [f.x, f.y])
    };
    Curve::length(jet, |press, phi| {
        press.shaking(phi, SPEED).e.map(|f| [f.x, f.y])
    })
}

pub(crate) fn ram() -> Drawn<'static> {
    let jet = |press: &PressAssembly, phi| {
        let motion = press.motion(phi);
        [motion.ram, motion.v, motion.a]
    };
    Curve::new(jet, |press, phi| press.motion(phi).e)
}

/// What may be changed, and what must be kept: the stroke.
fn open(stroke: f64) -> Result<CycleDesign<'static, Press, PressAssembly, N>, Box<dyn Error>> {
    let design = CycleDesign::new(
        Press::default(),
        Press::assemble,
        Press::assemble_from,
        Press::circuits,
    )?;
    let design = design
        .vary("crank", 35.0, 45.0)
        .vary("rod", 120.0, 220.0)
        .vary("offset", -25.0, 25.0);
    let design = design
        .vary("ahead", -60.0, 60.0)
        .vary("across", -60.0, 60.0);
    Ok(design.want(Stroke(ram()).equal(stroke)))
}

/// With a guide that bears so much.
pub(crate) fn design(
    stroke: f64,
) -> Result<CycleDesign<'static, Press, PressAssembly, N>, Box<dyn Error>> {
    Ok(open(stroke)?.want(Peak(side()).at_most(SIDE)))
}

/// Samples of a turn: between them a peak of these torques rises by some 1e-6 of itself.
const SAMPLES: u32 = 1440;

/// The largest of a figure over samples of a turn, without its sign.
pub(crate) fn sampled(figure: impl Fn(f64) -> f64) -> f64 {
    let sample = |i: u32| figure(TAU * f64::from(i) / f64::from(SAMPLES)).abs();
    (0..SAMPLES).map(sample).fold(0.0, f64::max)
}

pub(crate) fn print(what: &str, press: &PressAssembly) {
    let peak = sampled(|phi| press.drive(phi, SPEED).t);
    let side = sampled(|phi| press.side(phi, SPEED).f.x);
    let Press {
        crank,
        rod,
        offset,
        ahead,
        across,
    } = *press.mechanism();
    println!(
        "{what:<22} {:6.3} N m, guide {side:5.1} N: crank {crank:.3}, rod {rod:.2}, offset {offset:.2} mm, masses {ahead:.3} and {across:.3} kg",
        1e-3 * peak
    );
}
