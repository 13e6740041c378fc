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
mod page;
mod published;
mod scene;

use crate::check::Check;
use crate::folders;
use drives::{KnittingMachine, KnittingMachineAssembly};
use linkage::clearance::Clearance;
use linkage::report::Report;
use linkage::tolerance::Tolerances;
use members::DIMENSIONS;
use std::error::Error;

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
    scene::parts(&machine, &mut check);

    println!("The page:");
    page::write(
        &page::report(&machine, &told)?,
        &folders::target("knitting_machine"),
    )?;
    check.finish()
}

/// Its page, for the gallery.
pub(crate) fn report() -> Result<Report, Box<dyn Error>> {
    let machine = KnittingMachine::default().assemble()?;
    let tolerances = Tolerances::<DIMENSIONS>::complete(KnittingMachine::PARAMETERS)?;
    let cyclogram = members::with_tolerances(members::cyclogram(&machine)?, &tolerances)?;
    page::report(&machine, &cyclogram)
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
