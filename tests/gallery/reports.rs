//! What the report of each mechanism shows.

use crate::eye_needle::EyeNeedle;
use crate::favorit::Favorit;
use crate::spatial_crank_rocker::SpatialCrankRocker;
use crate::two_crank_triad::TwoCranks;
use linkage::report::Report;
use linkage::summary::{Curve, grashof, minimise};
use std::error::Error;
use std::f64::consts::TAU;

type Made = Result<Report, Box<dyn Error>>;

/// Positions of a cycle that pages show.
const POSITIONS: usize = 721;
/// Positions from which roots are located.
const SCAN: usize = 720;

/// The hook-needle drive, with the forces of its masses at the speed of the machine.
pub(crate) fn favorit() -> Made {
    /// 1000 revolutions per minute, clockwise.
    const SPEED: f64 = -1000.0 * TAU / 60.0;
    let mechanism = Favorit::default();
    let linkage = mechanism.assemble()?;
    let forces = crate::favorit_forces::Favorit::default().assemble()?;
    let input = Favorit::INPUTS[0];
    let phi = input.positions(POSITIONS);
    let height = Curve::new(input.ends(), SCAN, |x| {
        let h = linkage.height(x);
        [h.y, h.v, h.a, h.j]
    })?;
    let angle = Curve::new(input.ends(), SCAN, |x| {
        let t = linkage.transmission(x);
        [t.mu, t.v, t.a]
    })?;
    let margin = minimise(input.ends(), SCAN, |x| linkage.transmission(x).margin)?;
    Ok(Report::new("Hook-needle drive", &input, &phi)
        .about(
            "Two cranks drive the hook needle of the Favorit warp-knitting machine. The second one turns backwards at half the \
             speed, so that a cycle takes two turns of the main crank.",
        )
        .note("Dimensions and masses as published; forces with the corrected mechanics, by the program `favorit_forces`.")
        .structure(Favorit::STRUCTURE)
        .modes(linkage.modes())
        .dimensions(&mechanism)
        .programs(Favorit::PROGRAMS)
        .programs(crate::favorit_forces::Favorit::PROGRAMS)
        .argument("omega", SPEED)
        .speed(SPEED, 0.0)
        .table(&linkage.picture_sweep(&phi))
        .table(&linkage.needle_sweep(&phi))
        .table(&linkage.transmission_sweep(&phi))
        .table(&forces.forces_sweep(&phi, &[SPEED]))
        .trace("p10")
        .course("p10.y", "mm", &height)
        .transmission("mu", &angle)
        .margin(&margin))
}

/// The eye-needle drive, with what the tolerances of its drawing do.
pub(crate) fn eye_needle() -> Made {
    let mechanism = EyeNeedle::default();
    let linkage = mechanism.assemble()?;
    let input = EyeNeedle::INPUTS[0];
    let phi = input.positions(POSITIONS);
    let rocker = Curve::new(input.ends(), SCAN, |x| {
        let r = linkage.rocker(x);
        [r.phi75, r.v, r.a]
    })?;
    let margin = minimise(input.ends(), SCAN, |x| linkage.posture(x).margin)?;
    let report = Report::new("Eye-needle drive", &input, &phi)
        .about(
            "A six-bar of a warp-knitting machine. Its ternary link hangs on three legs, a group of class III; the needle dwells \
             for a third of the cycle.",
        )
        .structure(EyeNeedle::STRUCTURE)
        .modes(linkage.modes())
        .dimensions(&mechanism)
        .programs(EyeNeedle::PROGRAMS)
        .table(&linkage.picture_sweep(&phi))
        .table(&linkage.accuracy_sweep(&phi))
        .table(&linkage.rocker_sweep(&phi))
        .trace("p8")
        .course("phi75", "rad", &rocker)
        .margin(&margin);
    // 0.2 mm of the needle's arc.
    let dwell = rocker.longest_dwell(0.2 / mechanism.l78);
    Ok(match dwell {
        Some(dwell) => report.dwell("phi75", "rad", &dwell),
        None => report,
    })
}

/// The straight-line drive with a triad whose third leg slides.
pub(crate) fn two_crank_triad() -> Made {
    let mechanism = TwoCranks::default();
    let linkage = mechanism.assemble()?;
    let input = TwoCranks::INPUTS[0];
    let phi = input.positions(POSITIONS);
    let slide = Curve::new(input.ends(), SCAN, |x| {
        let m = linkage.motion(x);
        [m.s, m.ds, m.dds]
    })?;
    Ok(Report::new("Straight-line drive with two cranks", &input, &phi)
        .about("Two cranks turn against each other and hold a ternary link, whose third joint slides on a straight guide.")
        .structure(TwoCranks::STRUCTURE)
        .modes(linkage.modes())
        .dimensions(&mechanism)
        .programs(TwoCranks::PROGRAMS)
        .table(&linkage.picture_sweep(&phi))
        .table(&linkage.motion_sweep(&phi))
        .trace("p8")
        .trace("p4")
        .course("s", "mm", &slide))
}

/// A crank and a rocker whose axes cross in space.
pub(crate) fn spatial_crank_rocker() -> Made {
    let mechanism = SpatialCrankRocker::default();
    let linkage = mechanism.assemble()?;
    let input = SpatialCrankRocker::INPUTS[0];
    let phi = input.positions(POSITIONS);
    let rocker = Curve::new(input.ends(), SCAN, |x| {
        let m = linkage.motion(x);
        [m.psi, m.dpsi, m.ddpsi]
    })?;
    Ok(Report::new("Spatial crank-rocker", &input, &phi)
        .about("A coupler with ball joints between a crank and a rocker about a tilted axis (RSSR), with a tool on the coupler.")
        .structure(SpatialCrankRocker::STRUCTURE)
        .modes(linkage.modes())
        .dimensions(&mechanism)
        .programs(SpatialCrankRocker::PROGRAMS)
        .table(&linkage.picture_sweep(&phi))
        .table(&linkage.motion_sweep(&phi))
        .trace("tip")
        .course("psi", "rad", &rocker))
}

include!("../../mechanisms/beyond_reach.rs");

/// A four-bar over a whole turn, of which it can do a part.
pub(crate) fn beyond_reach() -> Made {
    let mechanism = Rocking::default();
    let linkage = mechanism.assemble()?;
    let input = Rocking::INPUTS[0];
    let (low, high) = (-TAU / 2.0, TAU / 2.0);
    let phi: Vec<f64> = (0..POSITIONS)
        .map(|i| low + (high - low) * i as f64 / (POSITIONS - 1) as f64)
        .collect();
    let height = Curve::new((low, high), SCAN, |x| {
        let h = linkage.height(x);
        [h.y, h.v, h.a]
    })?;
    let Rocking {
        crank,
        coupler,
        rocker,
        ..
    } = mechanism;
    let kind = grashof(mechanism.pivot_d.norm(), crank, coupler, rocker)?;
    Ok(Report::new("Four-bar beyond its reach", &input, &phi)
        .about("The input is taken through a whole turn; where the links do not reach each other, there are gaps.")
        .structure(Rocking::STRUCTURE)
        .modes(linkage.modes())
        .dimensions(&mechanism)
        .programs(Rocking::PROGRAMS)
        .table(&linkage.picture_sweep(&phi))
        .table(&linkage.motion_sweep(&phi))
        .table(&linkage.accuracy_sweep(&phi))
        .speed(10.0, 0.0)
        .trace("tracer")
        .course("tracer.y", "mm", &height)
        .fact("Grashof", kind.to_string()))
}
