//! What the machine is asked: what its organs do when, and how close its needles come.

use super::drives::{
    Eye, EyeWay, Hook, KnittingMachine, KnittingMachineAssembly, PressWay, SinkerWay,
};
use linkage::Vector2;
use linkage::clearance::{BestStep, Clearance, Nearest, PhaseError, Phases};
use linkage::cyclogram::{Band, Cyclogram, CyclogramError, Member};
use linkage::summary::{Curve, SummaryError, positions};
use linkage::tolerance::Tolerances;
use std::error::Error;
use std::f64::consts::TAU;

/// Derivatives by all parameters.
pub(crate) const DIMENSIONS: usize = KnittingMachine::PARAMETERS.len();
/// A turn of the shaft.
pub(crate) const CYCLE: (f64, f64) = (0.0, TAU);
/// From where roots are looked for: every five degrees.
const POSITIONS: usize = 73;
/// Where organs dwell, in mm.
pub(crate) const ENDS: [Band; 2] = [Band::Top(0.1), Band::Bottom(0.1)];
/// The eye needle at the lower end of its way.
pub(crate) const EYE_ENDS: [Band; 2] = [Band::Top(0.1), Band::Bottom(0.5)];

/// A quantity with its first two derivatives.
type Jet = [f64; 3];

pub(crate) fn lift(m: Hook) -> Jet {
    [m.tip.y, m.v.y, m.a.y]
}

pub(crate) fn eye_way(m: EyeWay) -> Jet {
    [m.way, m.v, m.a]
}

pub(crate) fn sinker_way(m: SinkerWay) -> Jet {
    [m.s, m.v, m.a]
}

pub(crate) fn press_way(m: PressWay) -> Jet {
    [m.way, m.v, m.a]
}

/// What the four organs do in a turn of the shaft, with what all dimensions do to that. The coarse look is taken from
/// sweeps.
pub(crate) fn cyclogram(machine: &KnittingMachineAssembly) -> Result<Cyclogram, Box<dyn Error>> {
    let shaft: Vec<f64> = positions(CYCLE, POSITIONS).collect();
    let (hook, eye) = (machine.hook_sweep(&shaft), machine.eye_way_sweep(&shaft));
    let (sinker, press) = (machine.sinker_sweep(&shaft), machine.press_sweep(&shaft));
    let hook = member(
        "hook",
        ENDS,
        |i| lift(hook.get(i)),
        |x| lift(machine.hook(x)),
    )?;
    let eye = member(
        "eye",
        EYE_ENDS,
        |i| eye_way(eye.get(i)),
        |x| eye_way(machine.eye_way(x)),
    )?;
    let sinker = member(
        "sinker",
        ENDS,
        |i| sinker_way(sinker.get(i)),
        |x| sinker_way(machine.sinker(x)),
    )?;
    let press = member(
        "press",
        ENDS,
        |i| press_way(press.get(i)),
        |x| press_way(machine.press(x)),
    )?;
    Ok(Cyclogram::new([
        hook.sensitivities(
            |x| machine.hook_accuracy(x).e.map(|e| e.y),
            |x| machine.hook_accuracy(x).rate.map(|e| e.y),
        ),
        eye.sensitivities(
            |x| machine.eye_way_accuracy(x).e,
            |x| machine.eye_way_accuracy(x).rate,
        ),
        sinker.sensitivities(
            |x| machine.sinker_accuracy(x).e,
            |x| machine.sinker_accuracy(x).rate,
        ),
        press.sensitivities(
            |x| machine.press_accuracy(x).e,
            |x| machine.press_accuracy(x).rate,
        ),
    ])?)
}

fn member(
    name: &str,
    bands: [Band; 2],
    row: impl Fn(usize) -> Jet,
    jet: impl Fn(f64) -> Jet,
) -> Result<Member, Box<dyn Error>> {
    let course = Curve::swept(CYCLE, POSITIONS, row, jet)?;
    Ok(Member::new(name, &course, &bands)?.unit("mm"))
}

/// The same with what the tolerances of all dimensions do to the angles.
pub(crate) fn with_tolerances(
    cyclogram: Cyclogram,
    tolerances: &Tolerances<DIMENSIONS>,
) -> Result<Cyclogram, CyclogramError> {
    let members = cyclogram.members().iter().cloned();
    let members = members.map(|member| member.tolerances(tolerances));
    Cyclogram::new(members.collect::<Result<Vec<_>, _>>()?)
}

/// A point with its first two derivatives.
type Point = [Vector2<f64>; 3];

fn hook(m: Hook) -> [Point; 1] {
    [[m.tip, m.v, m.a]]
}

fn eye(m: Eye) -> [Point; 1] {
    [[m.tip, m.v, m.a]]
}

/// Where the points of both needles are nearest to each other.
pub(crate) fn clearance(machine: &KnittingMachineAssembly) -> Result<Clearance<2>, SummaryError> {
    let shaft: Vec<f64> = positions(CYCLE, POSITIONS).collect();
    let (hooks, eyes) = (machine.hook_sweep(&shaft), machine.eye_sweep(&shaft));
    Clearance::swept(
        CYCLE,
        POSITIONS,
        |i| (hook(hooks.get(i)), eye(eyes.get(i))),
        |x| (hook(machine.hook(x)), eye(machine.eye(x))),
    )
}

/// What all dimensions do to such a distance.
pub(crate) fn sensitivity(
    machine: &KnittingMachineAssembly,
    nearest: &Nearest<2>,
) -> [f64; DIMENSIONS] {
    let hook = machine.hook_accuracy(nearest.at).e;
    let eye = machine.eye_accuracy(nearest.at).e;
    nearest.sensitivity([hook], [eye])
}

/// From -30 to 30 degrees.
const LEADS: (f64, f64) = (-TAU / 12.0, TAU / 12.0);

/// The lead of the eye needle that makes the least distance largest, and the best slot of a gear. The machine's eye
/// needle does not lead.
pub(crate) fn best_lead(
    machine: &KnittingMachineAssembly,
    slots: f64,
) -> Result<BestStep<2>, PhaseError> {
    let phases = Phases::new(
        CYCLE,
        POSITIONS,
        |x| hook(machine.hook(x)),
        |x| eye(machine.eye(x)),
    )?;
    phases.best_step(LEADS, TAU / slots)
}
