//! A whole machine: three linkages on one main shaft, and each frame evaluates what it needs.
//!
//! A small knitting machine. One linkage moves the needles and the tongues that close their hooks:
//! both are driven by the same rocker. An eccentric moves the sinkers, and another one the press,
//! which works in some courses only.

use crate::check::Check;
use linkage::{Scene, Structure};
use std::error::Error;

include!("../../mechanisms/machine.rs");

/// Operations of one call of a function.
fn operations(structure: &Structure, name: &str) -> u32 {
    let mut functions = structure.functions.iter();
    functions
        .find(|function| function.name == name)
        .map_or(0, |function| function.operations.total())
}

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let needles = NeedleDrive::default().assemble()?;
    let sinkers = SinkerDrive::default().assemble()?;
    let presses = PressDrive::default().assemble()?;

    let mut machine = Scene::new();
    let heights = machine.add(|phi: &f64| needles.heights(*phi));
    let motion = machine.add(|phi| needles.motion(*phi));
    let sinker = machine.add(|phi| sinkers.position(*phi));
    let press = machine.add(|phi| presses.position(*phi));
    machine.switch_off(motion);

    println!("Two courses, the press works in the second one; mm and degrees:");
    println!("         shaft   needle   tongue   sinker    press   evaluated");
    let mut evaluated = [0, 0];
    for frame in 0..12 {
        let course = frame / 6;
        match frame {
            0 => machine.switch_off(press),
            6 => machine.switch_on(press),
            _ => {}
        }
        let phi = f64::from(frame * 60).to_radians();
        let count = machine.update(phi);
        evaluated[course as usize] += count;

        let (Some(heights), Some(sinker)) = (machine.get(heights), machine.get(sinker)) else {
            return Err("needles and sinkers are on".into());
        };
        let press = machine.get(press).map(|press| press.press.to_degrees());
        println!(
            "       {:>7} {:>8.3} {:>8.3} {:>8.3} {:>8} {count:>11}",
            frame * 60,
            heights.needle,
            heights.tongue,
            sinker.sinker,
            press.map_or("-".into(), |press| format!("{press:.3}")),
        );
    }
    check.holds("2, then 3 functions in each frame", evaluated == [12, 18]);

    println!("What has not changed is not computed again:");
    let phi = 1.2;
    check.holds("a new angle: 3 functions", machine.update(phi) == 3);
    check.holds("the same once more: none", machine.update(phi) == 0);
    machine.switch_on(motion);
    check.holds(
        "the needles' motion, too: that alone",
        machine.update(phi) == 1,
    );
    if let (Some(motion), Some(heights)) = (machine.get(motion), machine.get(heights)) {
        check.near("needle, mm", motion.needle, heights.needle, 1e-12);
        let ahead = needles.needle(phi + 1e-6).needle - needles.needle(phi - 1e-6).needle;
        check.near("velocity, mm/rad", motion.v, ahead / 2e-6, 1e-7);
    }
    check.holds(
        "all are up to date",
        machine.get(motion).is_some() && machine.get(press).is_some(),
    );
    if let Some(sinker) = machine.get(sinker) {
        // A slider-crank with its eccentric 90 degrees ahead.
        let known = -4.0 * phi.sin() + (80.0_f64.powi(2) - (4.0 * phi.cos()).powi(2)).sqrt();
        check.near("sinker, mm", sinker.sinker, known, 1e-12);
    }

    println!("Other dimensions while the machine runs:");
    let longer = SinkerDrive {
        rod: 81.0,
        ..SinkerDrive::default()
    }
    .assemble()?;
    machine.set(sinker, move |phi| longer.position(*phi));
    check.holds("the sinkers alone", machine.update(phi) == 1);
    if let Some(sinker) = machine.get(sinker) {
        let known = -4.0 * phi.sin() + (81.0_f64.powi(2) - (4.0 * phi.cos()).powi(2)).sqrt();
        check.near("sinker, mm", sinker.sinker, known, 1e-12);
    }

    println!("Needle and tongue have the crank-rocker in common, operations:");
    let [needle, tongue, both] =
        ["needle", "tongue", "heights"].map(|name| operations(NeedleDrive::STRUCTURE, name));
    println!(
        "       needle {needle}, tongue {tongue}, one after the other {}",
        needle + tongue
    );
    println!("       together {both}");
    check.holds("together they cost less", both < needle + tongue);

    println!("Whole turns, into the same columns each time:");
    let mut turns = Scene::<Vec<f64>>::new();
    let path = turns.add_into(HeightsColumns::new(), |phi, out| {
        needles.heights_sweep_into(phi, out)
    });
    let turn: Vec<f64> = (0..360).map(|i| f64::from(i).to_radians()).collect();
    check.holds("the first time", turns.update_from(&turn) == 1);
    check.holds("not the second time", turns.update_from(&turn) == 0);
    if let Some(columns) = turns.get(path) {
        let needle = columns.needle().iter().copied();
        let lowest = needle.clone().fold(f64::INFINITY, f64::min);
        let highest = needle.fold(f64::NEG_INFINITY, f64::max);
        println!("       needle from {lowest:.3} to {highest:.3} mm");
        let single = turn.iter().map(|&phi| needles.needle(phi).needle);
        check.all_near(
            "sweep and single calls",
            columns.needle().iter().copied().zip(single),
            1e-12,
        );
    }
    check.finish()
}
