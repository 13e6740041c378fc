//! The press, and what is wanted of it.

use linkage::design::{BestCycle, Compromise, Curve, CycleDesign, Figure, Peak, Stroke};
use linkage::mechanism;
use std::error::Error;
use std::f64::consts::TAU;

mechanism! {
    /// A press with a vertical ram, on whose crank two masses may be fixed: along it, and across it.
    #[derive(Clone, Copy)]
    pub struct Press {
        unit mm;
        param crank  = 40mm;
        param rod    = 160mm;
        param offset = 8mm;
        param ahead  = 0kg;
        param across = 0kg;

        input phi = 30deg in 0deg..360deg at omega;
        unknown theta = -100deg;
        unknown ram   = -140mm;
        let p = polar(crank, phi);
        let q = p + polar(rod, theta);
        loop q = (offset, ram);

        gravity = (0, -9.80665m/s^2);
        body wheel = pin on frame at (0, 0), turns phi, mass 3kg at p / 2, inertia 4000kg*mm^2,
            mass ahead at polar(100mm, phi), mass across at polar(100mm, phi + 90deg);
        body link  = pin on wheel at p, turns theta, mass 2kg at p + polar(rod / 3, theta), inertia 5000kg*mm^2;
        body block = slide guide on frame at q along (0, 1), mass 12kg at q;
        pin knee = link on block at q;
        spring 6N/mm from block at q to frame at (offset, -400mm), free 300mm;
    }
    impl Press {
        /// The driving torque, with its derivatives by the crank's angle.
        pub fn drive(phi, omega) -> Drive {
            t: torque(phi), v: velocity(torque(phi)), a: acceleration(torque(phi)),
        }
        /// What the dimensions do to it.
        pub fn effects(phi, omega) -> Effects { e: sensitivity(torque(phi)) }
        /// The force of the guide on the ram, which is horizontal.
        pub fn side(phi, omega) -> Side {
            f: reaction(guide), v: velocity(reaction(guide)), a: acceleration(reaction(guide)), e: sensitivity(reaction(guide)),
        }
        /// The force on the foundation.
        pub fn shaking(phi, omega) -> Shaking {
            f: shaking_force(), v: velocity(shaking_force()), a: acceleration(shaking_force()), e: sensitivity(shaking_force()),
        }
        pub fn motion(phi) -> Motion { ram, v: velocity(ram), a: acceleration(ram), e: sensitivity(ram) }
        pub fn picture(phi) -> Picture { shape: picture() }
    }
}

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
