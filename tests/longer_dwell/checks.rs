//! What must hold of the drives, by other ways than those of the search.

use crate::check::Check;
use crate::drive::{BAND, Drive, EyeNeedle, EyeNeedleAssembly, N, PART, course, jet};
use linkage::Dimensions;
use linkage::summary::Curve;
use linkage::tolerance::Tolerances;
use std::error::Error;

/// Where the published drive dwells, and for how long; it was read off positions every half degree.
pub(crate) fn compare_published(
    published: &EyeNeedleAssembly,
    check: &mut Check,
) -> Result<[f64; 2], Box<dyn Error>> {
    let ways: Vec<f64> = (0..1440)
        .map(|i| jet(published, (0.5 * f64::from(i % 720)).to_radians())[0])
        .collect();
    let steps = |from: usize| {
        let (mut low, mut high) = (f64::MAX, f64::MIN);
        let stays = |way: &&f64| {
            (low, high) = (low.min(**way), high.max(**way));
            high - low <= BAND
        };
        ways[from..].iter().take_while(stays).count() - 1
    };
    let longest = (0..720).map(steps).max().unwrap_or(0);
    check.near("dwell by samples, degrees", 0.5 * longest as f64, 45.5, 0.0);
    let exact = course(published)?
        .longest_dwell(BAND)
        .ok_or("no dwell")?
        .interval;
    check.near("exactly", exact.range.to_degrees(), 46.217, 1e-3);
    Ok([exact.from, exact.range])
}

/// What must hold of a drive, by other ways than those of the search.
pub(crate) fn compare(drive: &Drive, stroke: f64, check: &mut Check) -> Result<(), Box<dyn Error>> {
    let found = course(&drive.assembly)?;
    let dwell = found.longest_dwell(BAND).ok_or("no dwell")?;
    println!("  dwell of {:.4} degrees", drive.goal.to_degrees());
    check.holds("at least 94 degrees", drive.goal.to_degrees() >= 94.0);
    check.holds(
        "as long by the roots of the course",
        dwell.interval.range >= drive.goal - 1e-9,
    );
    check.near("stroke, mm", found.position().stroke(), stroke, 1e-8);
    let pairs = drive
        .mechanism
        .values()
        .into_iter()
        .zip(EyeNeedle::default().values());
    let within = pairs
        .clone()
        .all(|(new, old)| (new - old).abs() <= PART * old.abs() * (1.0 + 1e-12));
    check.holds("no length differs by more than 2 %", within);
    let circuits = drive.mechanism.circuits()?;
    let whole = circuits
        .whole()
        .any(|branch| branch.closed && branch.margin == drive.margin);
    check.holds(
        "assembled over the whole turn on one circuit",
        whole && drive.margin > 0.5,
    );
    check.holds("the search has converged", drive.converged);
    Ok(())
}

/// The widest band over a dwell, from and for so many radians, of drives whose dimensions are all at limits of their tolerances, or anywhere
/// within.
pub(crate) fn worst(
    drive: &EyeNeedleAssembly,
    [from, length]: [f64; 2],
    tolerances: &Tolerances<N>,
    check: &mut Check,
) -> Result<f64, Box<dyn Error>> {
    let (values, tolerances) = (drive.mechanism().values(), tolerances.values());
    let band = |changes: [f64; N]| -> Result<f64, Box<dyn Error>> {
        let other = EyeNeedle::from_values(&std::array::from_fn(|k| {
            values[k] + changes[k] * tolerances[k]
        }));
        let assembly = other.assemble_from(drive)?;
        Ok(
            Curve::new((from, from + length), 60, |phi| jet(&assembly, phi))?
                .position()
                .stroke(),
        )
    };
    // One in a hundred of all corners; in an optimised build all of them.
    let step = if cfg!(debug_assertions) { 101 } else { 1 };
    let (mut corners, mut inside) = (0.0_f64, 0.0_f64);
    for corner in (0..1_u32 << N).step_by(step) {
        let sign = |k: usize| if corner >> k & 1 == 1 { 1.0 } else { -1.0 };
        corners = corners.max(band(std::array::from_fn(sign))?);
        // A number between -1 and 1 for each dimension, from the bits of a multiple of the corner's number.
        let part = |k: usize| {
            f64::from(
                (corner + 1)
                    .wrapping_mul(2_654_435_761)
                    .rotate_left(5 * k as u32)
                    >> 16,
            ) / 32_768.0
                - 1.0
        };
        inside = inside.max(band(std::array::from_fn(part))?);
    }
    println!(
        "  widest band over the dwell: {corners:.6} mm at limits of tolerances, {inside:.6} mm within them"
    );
    check.holds("it is wider at limits", inside <= corners);
    Ok(corners)
}
