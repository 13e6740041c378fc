//! Counterweights on the cranks: how quiet can they make the machine's bed?

use super::{Favorit, MACHINE_SPEED, Shaking, cycle};
use crate::check::Check;
use linkage::balancing::{Balance, Figures, StaticMoment};
use linkage::pins::largest_load;
use std::error::Error;

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
pub(super) fn print(check: &mut Check) -> Result<(), Box<dyn Error>> {
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
