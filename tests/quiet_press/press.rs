//! The press, and what is wanted of it.

use linkage::design::{BestCycle, Compromise, Curve, CycleDesign, Figure, Peak, Stroke};
use std::error::Error;
use std::f64::consts::TAU;

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
pub(crate) fn open(
    stroke: f64,
) -> Result<CycleDesign<'static, Press, PressAssembly, N>, Box<dyn Error>> {
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
pub(crate) const SAMPLES: u32 = 1440;

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
