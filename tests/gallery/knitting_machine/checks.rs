//! The machine against its drives alone, against differences, against a dense search.

use super::drives::{
    EyeNeedle, HookNeedle, KnittingMachine, KnittingMachineAssembly, Press, Sinker,
};
use super::members::{self, DIMENSIONS};
use crate::check::Check;
use linkage::clearance::Clearance;
use linkage::cyclogram::{Band, Cyclogram, Member, Motion};
use linkage::tolerance::Tolerances;
use linkage::{Dimensions, Vector2};
use std::error::Error;
use std::f64::consts::TAU;

type Outcome = Result<(), Box<dyn Error>>;

/// Every drive by itself, at the same angles: equal to the last bit.
pub(crate) fn alone(check: &mut Check, machine: &KnittingMachineAssembly) -> Outcome {
    let (hook, eye) = (
        HookNeedle::default().assemble()?,
        EyeNeedle::default().assemble()?,
    );
    let (sinker, press) = (Sinker::default().assemble()?, Press::default().assemble()?);
    let mut equal = [true; 4];
    for step in 0..=360 {
        let x = TAU * f64::from(step) / 360.0;
        let (m, own) = (machine.hook(x), hook.motion(x));
        equal[0] &= bits(plain([m.tip, m.v, m.a])) == bits(plain([own.p10, own.v, own.a]));
        let (m, own) = (machine.eye(x), eye.motion(x));
        equal[1] &= bits(plain([m.tip, m.v, m.a])) == bits(plain([own.p8, own.v, own.a]));
        let (m, own) = (machine.sinker(x), sinker.motion(x));
        equal[2] &= bits([m.s, m.v, m.a]) == bits([own.s, own.v, own.a]);
        let (m, own) = (machine.press(x), press.motion(x));
        equal[3] &= bits([m.way, m.v, m.a]) == bits([own.way, own.v, own.a]);
    }
    for (part, equal) in ["hook needle", "eye needle", "sinker", "press"]
        .iter()
        .zip(equal)
    {
        check.holds(&format!("{part}: 361 positions, to the last bit"), equal);
    }
    Ok(())
}

fn plain([p, v, a]: [Vector2<f64>; 3]) -> [f64; 6] {
    [p.x, p.y, v.x, v.y, a.x, a.y]
}

fn bits<const N: usize>(numbers: [f64; N]) -> [u64; N] {
    numbers.map(f64::to_bits)
}

/// The machine with another value of one parameter.
fn changed(by: f64, parameter: usize) -> Result<KnittingMachineAssembly, Box<dyn Error>> {
    let mut values = KnittingMachine::default().values();
    values[parameter] += by;
    Ok(KnittingMachine::from_values(&values).assemble()?)
}

/// Sensitivities against machines that are built a little differently: a length, an angle and a phase of each organ.
pub(crate) fn differences(
    check: &mut Check,
    machine: &KnittingMachineAssembly,
    clearance: &Clearance<2>,
    cyclogram: &Cyclogram,
) -> Outcome {
    let least = members::sensitivity(machine, clearance.least());
    for parameter in [
        KnittingMachine::INDEX_EYE_LEAD,
        KnittingMachine::INDEX_SINKER_LEAD,
        KnittingMachine::INDEX_HOOK_L34,
        KnittingMachine::INDEX_HOOK_START_78,
        KnittingMachine::INDEX_EYE_L57,
        KnittingMachine::INDEX_EYE_TURNED,
        KnittingMachine::INDEX_SINKER_L35,
        KnittingMachine::INDEX_PRESS_GAMMA1,
    ] {
        let declared = &KnittingMachine::PARAMETERS[parameter];
        let h = if declared.unit == "rad" { 1e-6 } else { 1e-4 };
        let [more, less] = [changed(h, parameter)?, changed(-h, parameter)?];
        let distances = [members::clearance(&more)?, members::clearance(&less)?];
        let [a, b] = distances.map(|found| found.least().distance);
        let name = declared.name;
        let what = format!("least distance by {name}");
        check.near(&what, least[parameter], (a - b) / (2.0 * h), 1e-5);

        let [more, less] = [members::cyclogram(&more)?, members::cyclogram(&less)?];
        let pairs = cyclogram
            .members()
            .iter()
            .zip(more.members().iter().zip(less.members()));
        let pairs = pairs.flat_map(|(member, (more, less))| {
            (0..member.events().len()).map(move |event| {
                let [a, b] = [more, less].map(|member| member.events()[event].at);
                let found = member
                    .sensitivity(event)
                    .map_or(f64::NAN, |all| all[parameter]);
                (found, (a - b) / (2.0 * h))
            })
        });
        check.all_near(&format!("all events by {name}, rad"), pairs, 1e-5);
    }
    Ok(())
}

/// A machine in which every dimension has its worst value: what is left of the distance, but for the second order.
pub(crate) fn worst(
    check: &mut Check,
    machine: &KnittingMachineAssembly,
    clearance: &Clearance<2>,
    tolerances: &Tolerances<DIMENSIONS>,
) -> Outcome {
    let left = clearance.guaranteed(tolerances, |nearest| members::sensitivity(machine, nearest));
    println!(
        "       {:.4} mm at {:.2} deg of the shaft, of {:.4} mm",
        left.distance,
        left.at.to_degrees(),
        left.nominal
    );
    let mut places = clearance.minima().iter();
    let place = places.find(|nearest| nearest.at == left.at);
    let e = members::sensitivity(machine, place.ok_or("it is one of the minima")?);
    let nominal = KnittingMachine::default().values();
    let tolerances = tolerances.values();
    let built = std::array::from_fn(|i| nominal[i] - tolerances[i].copysign(e[i]));
    let built = KnittingMachine::from_values(&built).assemble()?;
    let distance = members::clearance(&built)?.least().distance;
    // The second order is the square of some hundredths of a millimetre over its length, times a lever of ten.
    check.near(
        "a machine that is built so, mm",
        distance,
        left.distance,
        5e-3,
    );
    Ok(())
}

/// Positions of a turn in the dense search.
const DENSE: usize = 1440;

/// What roots say against many positions: nothing is nearer, and every organ does what it is said to do.
pub(crate) fn dense(
    check: &mut Check,
    machine: &KnittingMachineAssembly,
    clearance: &Clearance<2>,
    cyclogram: &Cyclogram,
) {
    let angle = |i: usize| (i as f64 + 0.5) / DENSE as f64 * TAU;
    let shaft: Vec<f64> = (0..DENSE).map(angle).collect();
    let (hooks, eyes) = (machine.hook_sweep(&shaft), machine.eye_sweep(&shaft));
    let (ways, sinkers) = (machine.eye_way_sweep(&shaft), machine.sinker_sweep(&shaft));
    let presses = machine.press_sweep(&shaft);
    let distances = (0..DENSE).map(|i| (hooks.get(i).tip - eyes.get(i).tip).norm());
    let dense = distances.fold(f64::INFINITY, f64::min);
    let found = clearance.least().distance;
    // Half the spacing beside the minimum, at its curvature.
    let above = 0.5 * clearance.least().bend() * (0.5 * TAU / DENSE as f64).powi(2);
    check.holds("no position is nearer", dense >= found - 1e-12);
    check.near(
        "the nearest of 1440 positions, mm",
        dense,
        found,
        1.001 * above,
    );

    let jets = |i: usize| {
        [
            members::lift(hooks.get(i)),
            members::eye_way(ways.get(i)),
            members::sinker_way(sinkers.get(i)),
            members::press_way(presses.get(i)),
        ]
    };
    let wrong = (0..DENSE).filter(|&i| {
        let mut members = cyclogram.members().iter().zip(jets(i));
        members.any(|(member, jet)| member.motion(shaft[i]) != motion(member, jet))
    });
    check.holds(
        "all organs do at all of them what they are said to do",
        wrong.count() == 0,
    );
}

/// What an organ does, from the quantity itself.
fn motion(member: &Member, [y, v, _]: [f64; 3]) -> Motion {
    let [low, high] = member.limits();
    let within = |band: &Band| match *band {
        Band::Top(width) => y >= high - width,
        Band::Bottom(width) => y <= low + width,
        Band::Between(low, high) => (low..=high).contains(&y),
    };
    match member.bands().iter().position(within) {
        Some(band) => Motion::Dwell(band),
        None if v > 0.0 => Motion::Advance,
        None => Motion::Return,
    }
}

/// The least distance at evenly spaced leads from -30 to 30 degrees, each from as many positions: the best of them.
pub(crate) fn best_of_all(machine: &KnittingMachineAssembly) -> (f64, f64) {
    let shaft: Vec<f64> = (0..DENSE).map(|i| TAU * i as f64 / DENSE as f64).collect();
    let (hooks, eyes) = (machine.hook_sweep(&shaft), machine.eye_sweep(&shaft));
    let points = |rows: &dyn Fn(usize) -> Vector2<f64>| (0..DENSE).map(rows).collect::<Vec<_>>();
    let (hooks, eyes) = (points(&|i| hooks.get(i).tip), points(&|i| eyes.get(i).tip));
    let reach = DENSE / 12;
    let least = |lead: usize| {
        let ahead = DENSE - reach + lead;
        let distances = (0..DENSE).map(|i| (hooks[i] - eyes[(i + ahead) % DENSE]).norm_squared());
        (lead, distances.fold(f64::INFINITY, f64::min).sqrt())
    };
    let best = (0..=2 * reach).map(least);
    let best = best.reduce(|a, b| if b.1 > a.1 { b } else { a });
    let (lead, distance) = best.unwrap_or((0, f64::NAN));
    ((lead as f64 - reach as f64) / DENSE as f64 * TAU, distance)
}
