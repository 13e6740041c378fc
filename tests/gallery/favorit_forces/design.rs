//! What a designer does with the forces: the motor's torque and the pins.

use super::{FavoritAssembly, Forces, JOINTS, MACHINE_SPEED, cycle, sizes};
use crate::check::Check;
use linkage::pins::{Fit, Limit, Member, Mounting, Pin, Width, largest_load, standard_diameter};
use std::error::Error;

/// Torque and power over the cycle, in the direction in which the machine turns.
pub(super) fn print_torque(drive: &FavoritAssembly, check: &mut Check) {
    println!("\nDriving torque at 1000 rpm:");
    println!("  phi12, deg  torque, N m  power, W");
    for step in 0..=24 {
        let degrees = 630.0 - 30.0 * f64::from(step);
        let torque = drive.forces(degrees.to_radians(), MACHINE_SPEED).torque * 1e-3;
        println!(
            "  {degrees:10.0} {torque:12.3} {:9.1}",
            torque * MACHINE_SPEED
        );
    }

    let (mut torques, mut powers, mut largest) = (Vec::new(), Vec::new(), 0.0_f64);
    for phi12 in cycle() {
        let torque = drive.forces(phi12, MACHINE_SPEED).torque;
        let energy = drive.energy(phi12, MACHINE_SPEED);
        torques.push(torque);
        powers.push((energy.power, torque * MACHINE_SPEED));
        powers.push((energy.power, energy.slope * MACHINE_SPEED));
        largest = largest.max(torque.abs());
    }
    let mean = torques.iter().sum::<f64>() / torques.len() as f64;
    let rounding = 1e-12 * largest;
    println!("  Largest: {:.3} N m.", largest * 1e-3);
    check.all_near(
        "power is what energy gains, N mm/s",
        powers,
        rounding * MACHINE_SPEED.abs(),
    );
    check.near("mean torque, with nothing to do, N mm", mean, 0.0, rounding);
}

/// Pins for the largest reactions of the cycle.
pub(super) fn print_pins(cycle: &[Forces], check: &mut Check) -> Result<(), Box<dyn Error>> {
    println!(
        "
Pins for the largest reactions at 1000 rpm. Assumed: quenched and tempered steel C45 with a tensile strength
of 700 MPa, of which reversed loads may use 0.15 in bending and 0.10 in shear; bronze bushes in rods 12 mm wide,
15 MPa; forks with cheeks of 6 mm, 50 MPa; loose fit."
    );
    println!("  joint  load, N  at phi12  needed, mm  taken, mm  by");
    let mut all_hold = true;
    // The last joint is the slider's guide.
    for (joint, name) in JOINTS[..7].iter().enumerate() {
        let largest = largest_load(cycle.iter().map(|forces| sizes(forces)[joint]))?;
        let pin = pin(largest.load);
        let size = pin.diameter()?;
        let diameter = standard_diameter(size.diameter).ok_or("no pin is thick enough")?;
        let phi12 = 0.5 * largest.position as f64 - 90.0;
        println!(
            "  {name:<5} {:8.1} {phi12:9.1} {:11.2} {diameter:10.0}  {}",
            largest.load, size.diameter, size.governing
        );
        all_hold &= pin.check(diameter)?.holds();
    }
    check.holds("all of them hold", all_hold);
    Ok(())
}

/// A pin in a fork, in N, mm and MPa.
fn pin(load: f64) -> Pin {
    let member = |width, pressure| Member {
        width: Width::Fixed(width),
        pressure: Limit::allowable(pressure),
    };
    Pin {
        load,
        mounting: Mounting::Clevis {
            fit: Fit::Loose,
            rod: member(12.0, 15.0),
            fork: member(6.0, 50.0),
        },
        bending: Limit::allowable(0.15 * 700.0),
        shear: Limit::allowable(0.10 * 700.0),
    }
}
