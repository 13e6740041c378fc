//! What the report of each mechanism shows.

use crate::eye_needle::EyeNeedle;
use crate::favorit::Favorit;
use crate::spatial_crank_rocker::SpatialCrankRocker;
use crate::two_crank_triad::TwoCranks;
use linkage::Programs;
use linkage::report::Report;
use linkage::summary::{Curve, grashof, minimise};
use linkage_engine::Mechanism;
use linkage_js::description;
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

// The mechanisms that the command writes to start from, compiled by the engine.

/// The name of a template and its text.
pub(crate) type Template = (&'static str, &'static str);

macro_rules! templates {
    ($($name:literal),* $(,)?) => {
        /// All templates.
        pub(crate) const TEMPLATES: &[Template] = &[
            $(($name, include_str!(concat!("../../linkage-cli/src/templates/", $name, ".mech")))),*
        ];
    };
}

templates![
    "slider",
    "joints",
    "four-bar",
    "wiper",
    "clamp",
    "scissors",
    "leg",
    "quick-return",
    "toggle-press",
    "suspension",
    "boom",
    "pump-jack",
    "steering",
    "gripper",
    "cam",
    "geneva",
];

/// Positions over the range, as the command has them.
const TEMPLATE_POSITIONS: usize = 361;

/// Returns the report of a template with all functions that need no speed.
pub(crate) fn report(text: &str) -> Result<Report, Box<dyn Error>> {
    let mechanism: &'static Mechanism = Box::leak(Box::new(Mechanism::compile(text)?));
    let assembly = mechanism.assemble(&mechanism.dimensions())?;
    let input = &mechanism.inputs()[0];
    let positions = input.positions(TEMPLATE_POSITIONS);
    let description = description(mechanism.name(), mechanism.compiled());
    let words = mechanism.compiled().documentation.split_whitespace();
    let words: Vec<&str> = words.collect();
    let mut report = Report::new(mechanism.name(), input, &positions)
        .about(words.join(" "))
        .structure(mechanism.structure())
        .modes(assembly.modes())
        .dimensions_listed(mechanism.parameters(), assembly.dimensions())
        .programs(Programs {
            description: Box::leak(description.into_boxed_str()),
        })
        .source(text);
    for (function, heading) in mechanism.headings().iter().enumerate() {
        let indices = mechanism.compiled().functions[function].arguments.iter();
        let given: Option<Vec<f64>> = indices
            .map(|&argument| mechanism.default_argument(argument))
            .collect();
        let (Some(mut given), Some(index)) = (
            given,
            heading
                .arguments
                .iter()
                .position(|name| *name == input.name),
        ) else {
            continue;
        };
        let mut columns: Vec<&[f64]> = given.chunks(1).collect();
        columns[index] = &positions;
        report = report.table(&assembly.calls(function, &columns));
        drop(columns);
        given.swap_remove(index);
        let names = heading.arguments.iter().enumerate();
        let names = names.filter(|(k, _)| *k != index).map(|(_, name)| *name);
        for (name, value) in names.zip(given) {
            report = report.argument(name, value);
        }
    }
    Ok(report)
}

#[test]
fn no_template_is_left_out() -> Result<(), Box<dyn Error>> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../linkage-cli/src/templates");
    let files = std::fs::read_dir(folder)?.collect::<Result<Vec<_>, _>>()?;
    let mut names: Vec<String> = files
        .iter()
        .filter_map(|file| Some(file.path().file_stem()?.to_string_lossy().into_owned()))
        .collect();
    names.sort();
    let mut listed: Vec<&str> = TEMPLATES.iter().map(|(name, _)| *name).collect();
    listed.sort_unstable();
    assert_eq!(names, listed);
    Ok(())
}
