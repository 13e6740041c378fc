//! A warp-knitting machine: hook needle, eye needle, sinkers and press on one shaft, with phases as parameters.
//!
//! The drives are those of the programs `favorit`, `eye_needle`, `two_crank_triad` and `spatial_crank_rocker`, parts of
//! one mechanism. It answers what nobody asks of a drive by itself: what the members do when, where one of them is in the
//! frame of another, how close the needles come, what tolerances leave of that, which phase makes it largest.
//!
//! Everything is compared: with the drives alone, with machines built a little differently, with many positions, with
//! numbers of 60 digits. The page is in `target/knitting_machine`.

mod checks;
mod drives;
mod members;
mod published;

use crate::check::Check;
use crate::folders;
use drives::{EyeNeedle, HookNeedle, KnittingMachine, KnittingMachineAssembly, Press, Sinker};
use linkage::clearance::Clearance;
use linkage::cyclogram::Cyclogram;
use linkage::report::Report;
use linkage::summary::Curve;
use linkage::tolerance::Tolerances;
use linkage::{Scene, Structure};
use members::{CYCLE, DIMENSIONS};
use std::cell::Cell;
use std::error::Error;
use std::f64::consts::TAU;
use std::path::Path;

/// The gear on the shaft of the eye needle.
const SLOTS: f64 = 48.0;

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    let machine = KnittingMachine::default().assemble()?;
    let tolerances = Tolerances::<DIMENSIONS>::complete(KnittingMachine::PARAMETERS)?;
    println!("{}", KnittingMachine::STRUCTURE);

    let cyclogram = members::cyclogram(&machine)?;
    let told = members::with_tolerances(cyclogram.clone(), &tolerances)?;
    println!("What the members do, and how far tolerances shift it:\n{told}");
    let both = cyclogram.together(|motions| motions[0].is_dwell() && motions[1].is_dwell());
    for interval in both {
        println!(
            "hook needle and eye needle dwell together from {:.3} deg, for {:.3} deg",
            interval.from.to_degrees(),
            interval.range.to_degrees()
        );
    }
    print_path(&machine);
    let clearance = members::clearance(&machine)?;
    print_distance(&machine, &clearance);

    println!("What tolerances leave of it in the worst case:");
    checks::worst(&mut check, &machine, &clearance, &tolerances)?;

    println!("The lead of the eye needle that makes it largest, from -30 to 30 deg:");
    let even = KnittingMachine {
        eye_lead: 0.0,
        ..KnittingMachine::default()
    };
    let even = even.assemble()?;
    let slot = members::best_lead(&even, SLOTS)?;
    let best = &slot.best;
    println!(
        "       {:.6} deg: {:.6} mm; with a gear of {SLOTS} slots {} of them, {:.6} mm",
        best.phase.to_degrees(),
        best.distance,
        slot.slot.step,
        slot.distance
    );
    let (lead, distance) = checks::best_of_all(&even);
    check.near(
        "a search in quarters of a degree",
        best.phase,
        lead,
        0.25f64.to_radians(),
    );
    check.near("finds hardly less, mm", best.distance, distance, 1e-3);
    check.holds(
        "and not more",
        best.distance >= distance - 1e-3 * best.distance,
    );

    println!("Each drive alone:");
    checks::alone(&mut check, &machine)?;
    println!("Machines that are built a little differently:");
    checks::differences(&mut check, &machine, &clearance, &cyclogram)?;
    println!("Many positions:");
    checks::dense(&mut check, &machine, &clearance, &cyclogram);
    println!("Numbers of 60 digits:");
    published::clearance(&mut check, &machine, &clearance, best);
    published::cyclogram(&mut check, &cyclogram);
    println!("Operations of a frame, with parts switched on and off:");
    parts(&machine, &mut check);

    println!("The page:");
    write(
        &page(&machine, &told)?,
        &folders::target("knitting_machine"),
    )?;
    check.finish()
}

/// Its page, for the gallery.
pub(crate) fn report() -> Result<Report, Box<dyn Error>> {
    let machine = KnittingMachine::default().assemble()?;
    let tolerances = Tolerances::<DIMENSIONS>::complete(KnittingMachine::PARAMETERS)?;
    let cyclogram = members::with_tolerances(members::cyclogram(&machine)?, &tolerances)?;
    page(&machine, &cyclogram)
}

fn print_path(machine: &KnittingMachineAssembly) {
    println!(
        "\nThe eye needle's point as the hook needle's sees it, mm along the needle and across:"
    );
    println!("  shaft, deg      along     across");
    for degrees in (0..360).step_by(15).map(f64::from) {
        let seen = machine.seen(degrees.to_radians()).seen;
        println!("  {degrees:10.0} {:10.4} {:10.4}", seen.x, seen.y);
    }
}

/// The least distances, and the dimensions that matter most for the least of all.
fn print_distance(machine: &KnittingMachineAssembly, clearance: &Clearance<2>) {
    println!("\nWhere the needles are nearest:");
    for nearest in clearance.minima() {
        println!(
            "  {:10.5} deg {:12.8} mm",
            nearest.at.to_degrees(),
            nearest.distance
        );
    }
    println!("What its tolerances do to the least of them, um:");
    let e = members::sensitivity(machine, clearance.least());
    let effects = KnittingMachine::PARAMETERS.iter().zip(e);
    let effects = effects.map(|(own, e)| (own.name, 1e3 * e * own.tolerance));
    let mut effects: Vec<(&str, f64)> = effects.collect();
    effects.sort_by(|a, b| b.1.abs().total_cmp(&a.1.abs()));
    for (name, effect) in effects.iter().take(8) {
        println!("  {name:16} {effect:8.2}");
    }
}

// The page of the machine.

/// Every degree.
const POSITIONS: usize = 361;

/// What it shows: with the shifts by tolerances, if the cyclogram has them.
fn page(
    machine: &KnittingMachineAssembly,
    cyclogram: &Cyclogram,
) -> Result<Report, Box<dyn Error>> {
    let input = KnittingMachine::INPUTS[0];
    let shaft = input.positions(POSITIONS);
    let distance = Curve::new(CYCLE, 90, |x| {
        let m = machine.seen(x);
        [m.seen.norm(), m.seen.dot(&m.v) / m.seen.norm()]
    })?;
    Ok(Report::new("Knitting machine", &input, &shaft)
        .about("Hook needle, eye needle, sinkers and press on one shaft.")
        .note("Dimensions are those of the drives' own examples; phases and places are chosen.")
        .structure(KnittingMachine::STRUCTURE)
        .modes(machine.modes())
        .dimensions(machine.mechanism())
        .programs(KnittingMachine::PROGRAMS)
        .table(&machine.picture_sweep(&shaft))
        .table(&machine.hook_sweep(&shaft))
        .table(&machine.eye_way_sweep(&shaft))
        .table(&machine.sinker_sweep(&shaft))
        .table(&machine.press_sweep(&shaft))
        .table(&machine.seen_sweep(&shaft))
        // Along the shafts: x to the right, y upwards.
        .view(-TAU / 4.0, TAU / 4.0)
        .trace("hook.p10")
        .trace("eye.p8")
        .cyclogram(cyclogram)
        .course("distance of the needles", "mm", &distance))
}

/// Writes it into a folder, and a drawing without names as `front.svg`.
fn write(report: &Report, folder: &Path) -> Result<(), Box<dyn Error>> {
    report.write(folder)?;
    let front = report
        .drawing()?
        .names(false)
        .trace("eye.p8")
        .write(folder.join("front.svg"))?;
    println!("       {}", front.display());
    println!("       {}", folder.join("index.html").display());
    Ok(())
}

// Parts of the machine in a scene: what is off costs nothing, to the operation.

/// Operations of a call. There is no branch in it, so that is what every call costs.
pub(crate) fn operations(structure: &Structure, function: &str) -> u32 {
    let mut functions = structure.functions.iter();
    let own = functions.find(|own| own.name == function);
    own.map_or(u32::MAX, |own| own.operations.total())
}

pub(crate) fn parts(machine: &KnittingMachineAssembly, check: &mut Check) {
    let of = |function| operations(KnittingMachine::STRUCTURE, function);
    let [hook, eye, sinker, press] = ["hook", "eye", "sinker", "press"].map(of);
    let alone = [
        operations(HookNeedle::STRUCTURE, "motion"),
        operations(EyeNeedle::STRUCTURE, "motion"),
        operations(Sinker::STRUCTURE, "motion"),
        operations(Press::STRUCTURE, "motion"),
    ];
    let here = [hook, eye, sinker, press];
    println!("       in the machine {here:?}, alone {alone:?}");
    check.holds("every drive takes what it takes alone", here == alone);

    let done = Cell::new(0);
    let spend = |cost: u32| done.set(done.get() + cost);
    let mut scene = Scene::new();
    let hooks = scene.add(|x: &f64| {
        spend(hook);
        machine.hook(*x)
    });
    let eyes = scene.add(|x| {
        spend(eye);
        machine.eye(*x)
    });
    let sinkers = scene.add(|x| {
        spend(sinker);
        machine.sinker(*x)
    });
    let presses = scene.add(|x| {
        spend(press);
        machine.press(*x)
    });
    // Two additions and a norm: what both needles have computed is not computed again.
    let gaps = scene.add_of((hooks, eyes), |(hook, eye)| (eye.tip - hook.tip).norm());
    let cost = |scene: &mut Scene<'_, f64>, x: f64| {
        done.set(0);
        (scene.update(x), done.get())
    };
    let all = hook + eye + sinker + press;
    check.holds(
        "all on: four parts, and what two of them are to each other",
        cost(&mut scene, 0.1) == (5, all),
    );
    scene.switch_off(presses);
    check.holds(
        "without the press: as much less",
        cost(&mut scene, 0.2) == (4, all - press),
    );
    scene.switch_off(sinkers);
    check.holds(
        "without the sinkers, too",
        cost(&mut scene, 0.3) == (3, hook + eye),
    );
    check.holds("the same angle: nothing", cost(&mut scene, 0.3) == (0, 0));
    scene.switch_off(eyes);
    check.holds("the hook needle alone", cost(&mut scene, 0.4) == (1, hook));
    check.holds("and no distance", scene.get(gaps).is_none());
    scene.switch_on(eyes);
    check.holds(
        "the eye needle again: that, and the distance",
        cost(&mut scene, 0.4) == (2, eye),
    );
    let known = (machine.eye(0.4).tip - machine.hook(0.4).tip).norm();
    check.holds("which is the same", scene.get(gaps) == Some(&known));
}
