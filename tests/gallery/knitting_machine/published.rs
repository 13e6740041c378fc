//! The machine against numbers of 60 digits.

use super::drives::{KnittingMachine, KnittingMachineAssembly};
use super::members;
use crate::check::Check;
use linkage::clearance::{BestPhase, Clearance};
use linkage::cyclogram::{Band, Cyclogram, Member, Motion};

/// The lines of `reference.csv` that begin with a word: what else stands in their first cell, and the numbers.
fn lines(word: &str) -> Vec<(&'static str, Vec<f64>)> {
    let lines = include_str!("../../../mechanisms/knitting_machine/reference.csv").lines();
    let own = lines.filter_map(|line| {
        let mut cells = line.split(',');
        let first = cells.next()?;
        let (kind, name) = first.split_once(' ').unwrap_or((first, ""));
        // A cell that is no number fails its comparison.
        let numbers = cells.map(|cell| cell.parse().unwrap_or(f64::NAN)).collect();
        (kind == word).then_some((name, numbers))
    });
    own.collect()
}

pub(crate) fn clearance(
    check: &mut Check,
    machine: &KnittingMachineAssembly,
    found: &Clearance<2>,
    best: &BestPhase<2>,
) {
    let minima = lines("minimum");
    check.holds(
        "two places are near",
        found.minima().len() == 2 && minima.len() == 2,
    );
    for (nearest, (_, known)) in found.minima().iter().zip(&minima) {
        check.near("shaft, deg", nearest.at.to_degrees(), known[0], 1e-10);
        check.near("distance, mm", nearest.distance, known[1], 1e-12);
        check.near("its second derivative", nearest.bend(), known[2], 1e-9);
    }
    let e = members::sensitivity(machine, found.least());
    let known = lines("least");
    let all = KnittingMachine::PARAMETERS
        .iter()
        .zip(e)
        .map(|(parameter, e)| {
            let mut own = known.iter().filter(|(name, _)| *name == parameter.name);
            // Sinkers and press have nothing to do with it.
            (e, own.next().map_or(0.0, |(_, numbers)| numbers[0]))
        });
    check.holds("derivatives by 34 parameters are known", known.len() == 34);
    check.all_near("derivatives, mm per mm or rad", all, 1e-11);

    let seen = lines("seen");
    let pairs = seen.iter().flat_map(|(_, known)| {
        let m = machine.seen(known[0].to_radians());
        [m.seen.x, m.seen.y, m.v.x, m.v.y]
            .into_iter()
            .zip(known[1..].to_vec())
    });
    check.all_near("seen from the hook needle, 12 positions", pairs, 1e-11);
    check.holds("they are known", seen.len() == 12);
    for (_, known) in lines("best") {
        check.near("best lead, deg", best.phase.to_degrees(), known[0], 1e-10);
        check.near(
            "the least distance then, mm",
            best.distance,
            known[1],
            1e-12,
        );
    }
}

/// Where the dwells of all organs begin and end, each drive at its own angle.
pub(crate) fn cyclogram(check: &mut Check, cyclogram: &Cyclogram) {
    let known = lines("dwell");
    let dwells = |member: &Member| {
        member
            .intervals()
            .filter(|(motion, _)| motion.is_dwell())
            .count()
    };
    let all: usize = cyclogram.members().iter().map(dwells).sum();
    check.holds("all dwells are known", known.len() == all && all == 8);
    let nominal = KnittingMachine::default();
    for (name, known) in known {
        let (member, turns, lead) = match name.split(' ').next() {
            Some("hook") => (0, 2.0, 0.0),
            Some("eye") => (1, 1.0, nominal.eye_lead),
            Some("sinker") => (2, 1.0, nominal.sinker_lead),
            _ => (3, 1.0, nominal.press_lead),
        };
        let member = &cyclogram.members()[member];
        let is_meant = |band: &Band| matches!(band, Band::Top(_)) == name.ends_with("top");
        let band = member.bands().iter().position(is_meant);
        let mut dwells = member.intervals();
        let dwell = dwells.find(|(motion, _)| Some(*motion) == band.map(Motion::Dwell));
        let found = dwell.map_or([f64::NAN; 2], |(_, at)| [at.from, at.from + at.range]);
        // What leads does everything earlier, a turn later at the seam.
        let turn = |x: f64| (x.to_degrees() * turns).rem_euclid(360.0 * turns);
        let known = known.iter().map(|x| turn(x.to_radians() / turns - lead));
        let pairs = found.into_iter().map(turn).zip(known);
        check.all_near(&format!("dwell of the {name}, deg"), pairs, 1e-9);
    }
}
