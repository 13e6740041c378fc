//! A press that runs quietly: the least peak of the driving torque over the length of the rod, the place of the guide and the counterweights on
//! the crank, with the stroke kept and the force on the guide limited.
//!
//! The ram works against a die cushion, a spring that is pressed at the lower end of the stroke and gives its energy back. At
//! constant speed the drive must deliver what cushion, weights and inertia forces take, and the same work is returned half a turn later: the peak
//! of the torque decides about motor and gears.
//!
//! What the peak costs at the guide is a front of compromises, from the least peak alone to the least force on the guide alone; so is what shakes the
//! foundation, which is limited to what it was. The page in `target/comparisons/quiet_press` has them.
//!
//! The peak is checked in three ways: by samples, by other presses nearby, and by the least peak of counterweights alone, a linear problem that
//! `linkage::balancing` solves in another way and with a proof.

#[path = "../../examples/check/comparison.rs"]
mod check;
mod checks;
#[path = "../programs/folders.rs"]
mod folders;
mod page;
mod press;

use check::Check;
use checks::{compare, compare_counterweights, compare_front, compare_shaking};
use linkage::design::{Figure, Peak, RootMeanSquare};
use page::compared;
use press::{Press, PressAssembly, SPEED, design, open, print, sampled, side, torque};
use std::error::Error;
use std::f64::consts::TAU;

/// Compromises of peak and guide.
const COMPROMISES: usize = 6;

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let first = Press::default().assemble()?;
    let height = |phi: f64| first.motion(phi).ram;
    let stroke = height(0.25 * TAU) - height(0.75 * TAU);
    let peak = design(stroke)?.want(Peak(torque()).least()).run()?;
    let mild = design(stroke)?
        .want(RootMeanSquare(torque()).least())
        .run()?;
    println!(
        "Peaks of the driving torque at {:.0} turns a minute:",
        SPEED * 60.0 / TAU
    );
    print("as it was", &first);
    print("least peak", &peak.assembly);
    print("least mean square", &mild.assembly);
    print!("{peak}");

    let mut check = Check::default();
    let before = sampled(|phi| first.drive(phi, SPEED).t);
    check.holds(
        "the peak is less than a quarter of what it was",
        peak.goal < 0.25 * before,
    );
    compare(&peak, stroke, &mut check);
    compare_counterweights(&peak, &mut check)?;
    let square = |press: &PressAssembly| {
        (0..720)
            .map(|i| press.drive(TAU * f64::from(i) / 720.0, SPEED).t.powi(2))
            .sum::<f64>()
    };
    check.near(
        "root mean square, N m",
        1e-3 * (square(&mild.assembly) / 720.0).sqrt(),
        1e-3 * mild.goal,
        1e-6,
    );
    let lower = square(&mild.assembly) < square(&peak.assembly) && mild.goal < peak.goal;
    check.holds(
        "the least mean square is below that of the least peak",
        lower,
    );
    compare_shaking(&first, &peak, stroke, &mut check)?;
    let front = open(stroke)?.front(Peak(torque()).least(), Peak(side()).least(), COMPROMISES)?;
    compare_front(&front, &peak, &mut check);
    // Tests of pages look at it.
    compared(&first, &front, &folders::target("comparisons/quiet_press"))?;
    check.finish()
}
