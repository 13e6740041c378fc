//! Forces in the hook-needle drive of the Favorit warp-knitting machine: the reactions of its joints beside the
//! published ones, the driving torque, pins, and counterweights.
//!
//! The mechanism is that of the program `favorit`; bodies, joints and gravity are nine lines more. The published
//! reactions contain three errors:
//!
//! - Two angles of centres of mass were converted to radians twice.
//! - The inertia forces of the rod and the slider were computed with the rocker's mass.
//! - What the slider does to the rocker was left out.
//!
//! Other values of the parameters reproduce them from the same text: all 200 published numbers are met, but for three
//! misprints. Beside them stand the forces that the drive has at that speed, and those at its real one.

mod published;

use crate::check::Check;
use linkage::Vector2;
use linkage::balancing::{Balance, Figures, StaticMoment};
use linkage::pins::{Fit, Limit, Member, Mounting, Pin, Width, largest_load, standard_diameter};
use std::error::Error;
use std::f64::consts::TAU;

include!("../../mechanisms/favorit_forces.rs");

/// 1000 revolutions per minute, clockwise.
const MACHINE_SPEED: f64 = -1000.0 * TAU / 60.0;

/// The joints by the numbers of their points, in the order of the tables.
const JOINTS: [&str; 8] = ["R1", "R2", "R3", "R4", "R7", "R8", "R9", "R11"];

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let drive = Favorit::default().assemble()?;
    println!("{}", Favorit::STRUCTURE);
    let mut check = Check::default();
    print_cost(&mut check);

    let cycle: Vec<Forces> = cycle()
        .map(|phi12| drive.forces(phi12, MACHINE_SPEED))
        .collect();
    published::compare(&drive, &cycle, &mut check)?;
    check_balance(&drive, &mut check);
    print_torque(&drive, &mut check);
    print_pins(&cycle, &mut check)?;
    print(&mut check)?;
    check.finish()
}

/// Crank angles of one cycle, two turns, every half degree.
fn cycle() -> impl Iterator<Item = f64> {
    (0..1440).map(|i| (0.5 * f64::from(i) - 90.0).to_radians())
}

/// The reactions in the order of `JOINTS`: their sizes, in newtons.
fn sizes(forces: &Forces) -> [f64; 8] {
    let f = forces;
    [f.r1, f.r2, f.r3, f.r4, f.r7, f.r8, f.r9, f.r11].map(|reaction| reaction.norm())
}

/// All forces against the accelerations alone.
fn print_cost(check: &mut Check) {
    let cost = |name: &str| {
        let mut functions = Favorit::STRUCTURE.functions.iter();
        let function = functions.find(|function| function.name == name);
        function.map_or(f64::NAN, |function| f64::from(function.operations.total()))
    };
    let (forces, accelerations) = (cost("forces"), cost("accelerations"));
    let ratio = forces / accelerations;
    println!("Forces take {ratio:.2} times the operations of the accelerations alone.");
    check.holds("forces within 3 times the accelerations", ratio <= 3.0);
}

/// What the frame takes is the weight and what the masses resist.
fn check_balance(drive: &FavoritAssembly, check: &mut Check) {
    println!("\nForces on the whole drive, 1000 rpm:");
    let given = Favorit::default();
    let mass = given.m1 + given.m2 + given.m3 + given.m4 + given.m5 + given.m6;
    let weight = Vector2::new(0.0, -9.80665 * mass);
    let left = cycle().map(|phi12| {
        let forces = drive.forces(phi12, MACHINE_SPEED);
        let shaking = drive.shaking(phi12, MACHINE_SPEED).force;
        let sum = forces.r1 + forces.r4 + forces.r7 + weight + shaking;
        (sum.norm(), 0.0)
    });
    check.all_near("pivots, weight and inertia add up to 0, N", left, 1e-10);
}

// What a designer does with the forces: the motor's torque and the pins.

/// Torque and power over the cycle, in the direction in which the machine turns.
fn print_torque(drive: &FavoritAssembly, check: &mut Check) {
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
fn print_pins(cycle: &[Forces], check: &mut Check) -> Result<(), Box<dyn Error>> {
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

// Counterweights on the cranks: how quiet can they make the machine's bed?

/// Masses in kg at the places that the mechanism has for them: along and across the main crank, then the second
/// one.
type Masses = [f64; 4];

/// How far these places are from the pivots, in mm.
const RADIUS: f64 = 30.0;

/// The table, and what is checked of it.
#[derive(Default)]
struct Table {
    /// What masses leave of the force when they are mounted, and what their effects promise.
    left: Vec<(f64, f64)>,
    /// Peaks, and the least ones that are possible.
    peaks: Vec<(f64, f64)>,
}

/// The masses that make the shaking force small over a cycle, in its mean square or its peak.
fn print(check: &mut Check) -> Result<(), Box<dyn Error>> {
    let shaking = shaking(Favorit::default())?;
    let forces: Vec<_> = shaking.iter().map(|s| s.force).collect();
    let on_main: Vec<_> = shaking
        .iter()
        .map(|s| [s.effects[0], s.effects[1]])
        .collect();
    let on_second: Vec<_> = shaking
        .iter()
        .map(|s| [s.effects[2], s.effects[3]])
        .collect();
    let on_both: Vec<_> = shaking.iter().map(|s| s.effects).collect();
    println!(
        "
Counterweights against the shaking force at 1000 rpm, {RADIUS} mm from the pivots; angles from the cranks:
                            force, N  moment, N m     main crank   second crank
                          rms   peak         peak     kg     deg     kg     deg"
    );
    let mut table = Table::default();
    let none = Balance::new(&forces, &on_both)?.figures(&[0.0; 4]);
    table.row("none", [0.0; 4], none)?;
    table.rows("main", &Balance::new(&forces, &on_main)?, |[a, b]| {
        [a, b, 0.0, 0.0]
    })?;
    table.rows("second", &Balance::new(&forces, &on_second)?, |[a, b]| {
        [0.0, 0.0, a, b]
    })?;
    table.rows("both", &Balance::new(&forces, &on_both)?, |masses| masses)?;
    check.all_near("mounted, they leave what was computed, N", table.left, 1e-9);
    check.all_near("no masses leave smaller peaks, N", table.peaks, 1e-6);
    Ok(())
}

impl Table {
    /// Both kinds of balance by the masses of which `all` makes those of both cranks.
    fn rows<const N: usize>(
        &mut self,
        cranks: &str,
        balance: &Balance<N>,
        all: impl Fn([f64; N]) -> Masses,
    ) -> Result<(), Box<dyn Error>> {
        let [mean_square, peak] = [balance.mean_square()?, balance.peak()?];
        self.row(
            &format!("{cranks}, mean square"),
            all(mean_square.values),
            mean_square.after,
        )?;
        self.row(&format!("{cranks}, peak"), all(peak.values), peak.after)?;
        self.peaks.push((peak.after.peak, peak.bound));
        Ok(())
    }

    fn row(&mut self, name: &str, masses: Masses, promised: Figures) -> Result<(), Box<dyn Error>> {
        let shaking = shaking(with_masses(masses))?;
        let squares = shaking.iter().map(|s| s.force.norm_squared());
        let rms = (squares.sum::<f64>() / shaking.len() as f64).sqrt();
        let peak = largest_load(shaking.iter().map(|s| s.force))?.load;
        let moment = largest_load(shaking.iter().map(|s| s.moment))?.load * 1e-3;
        let [along_1, across_1, along_7, across_7] = masses;
        let weights = [weight([along_1, across_1])?, weight([along_7, across_7])?];
        println!(
            "  {name:<20} {rms:6.1} {peak:6.1} {moment:12.2} {}",
            weights.concat()
        );
        self.left
            .extend([(rms, promised.rms), (peak, promised.peak)]);
        Ok(())
    }
}

/// The one counterweight that two masses stand for.
fn weight(masses: [f64; 2]) -> Result<String, Box<dyn Error>> {
    if masses == [0.0; 2] {
        return Ok(format!("{:>7} {:>7}", "-", "-"));
    }
    let weight = StaticMoment::of_masses(masses, RADIUS).at_radius(RADIUS)?;
    Ok(format!(
        "{:7.3} {:7.1}",
        weight.mass,
        weight.angle().to_degrees()
    ))
}

fn with_masses([along_1, across_1, along_7, across_7]: Masses) -> Favorit {
    Favorit {
        along_1,
        across_1,
        along_7,
        across_7,
        ..Favorit::default()
    }
}

/// What the bed feels over the cycle.
fn shaking(drive: Favorit) -> Result<Vec<Shaking>, Box<dyn Error>> {
    let drive = drive.assemble()?;
    Ok(cycle()
        .map(|phi12| drive.shaking(phi12, MACHINE_SPEED))
        .collect())
}
