//! The eye-needle drive of the program `eye_needle`, with a dwell twice as long: no length differs by more than 2 % from the published drive, and
//! the stroke of the needle is kept.
//!
//! While the needle dwells the other needles of the machine pass it, so that a longer dwell is a faster machine. It is wanted twice: for the drive
//! as it is drawn, and for the worst of all drives that are built with tolerances of 20 um on all thirteen dimensions, at the same angles of the
//! crank. The second one is made sure of by drives at the limits of their tolerances.
//!
//! The page in `target/comparisons/longer_dwell` lays both over the published drive.

#[path = "../../examples/check/comparison.rs"]
mod check;
mod drive;
#[path = "../programs/folders.rs"]
mod folders;

use check::Check;
use drive::{BAND, Drive, EyeNeedle, EyeNeedleAssembly, N, PART, course, design, jet, stroke, way};
use linkage::Dimensions;
use linkage::design::Dwell;
use linkage::report::{Aim, Compared, Comparison, Report};
use linkage::summary::Curve;
use linkage::tolerance::Tolerances;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::Instant;

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let published = EyeNeedle::default().assemble()?;
    let stroke = stroke()?;
    let tolerances = Tolerances::complete(EyeNeedle::PARAMETERS)?;
    let start = Instant::now();
    let drawn = design(Dwell::longest(way(), BAND), stroke)?.run()?;
    let between = Instant::now();
    let built = design(
        Dwell::longest(way(), BAND).in_worst_case(&tolerances),
        stroke,
    )?
    .run()?;
    println!(
        "As drawn, in {:.0} ms:\n{drawn}",
        1e3 * (between - start).as_secs_f64()
    );
    println!(
        "In the worst case, in {:.0} ms:\n{built}",
        1e3 * between.elapsed().as_secs_f64()
    );
    print_dimensions(&drawn, &built);

    let mut check = Check::default();
    println!("\nThe published drive:");
    let rest = compare_published(&published, &mut check)?;
    let published = Design {
        name: "published",
        assembly: &published,
        rest,
        band: worst(&published, rest, &tolerances, &mut check)?,
    };
    println!("\nThe drive as drawn:");
    compare(&drawn, stroke, &mut check)?;
    let drawn = searched("longest as drawn", &drawn, &tolerances, &mut check)?;
    println!("\nThe drive for the worst case:");
    compare(&built, stroke, &mut check)?;
    let built = searched("longest in the worst case", &built, &tolerances, &mut check)?;
    check.holds(
        "what is drawn for itself leaves the band when it is built",
        drawn.band > BAND,
    );
    check.holds(
        "what is made for the worst case does not",
        built.band <= BAND,
    );
    check.holds("and is shorter", built.rest[1] < drawn.rest[1]);
    let designs = [published, drawn, built];
    // Tests of pages look at it.
    compared(&designs, &folders::target("comparisons/longer_dwell"))?;
    check.finish()
}

/// A drive that was found, with the band that it needs when it is built.
fn searched<'a>(
    name: &'static str,
    drive: &'a Drive,
    tolerances: &Tolerances<N>,
    check: &mut Check,
) -> Result<Design<'a>, Box<dyn Error>> {
    let (assembly, rest) = (
        &drive.assembly,
        [drive.auxiliary[0][0], drive.auxiliary[0][1]],
    );
    let band = worst(assembly, rest, tolerances, check)?;
    Ok(Design {
        name,
        assembly,
        rest,
        band,
    })
}

fn print_dimensions(drawn: &Drive, built: &Drive) {
    println!("dimension       published       drawn   worst case");
    let drives =
        [EyeNeedle::default(), drawn.mechanism, built.mechanism].map(|drive| drive.values());
    for (k, parameter) in EyeNeedle::PARAMETERS.iter().enumerate() {
        let [published, drawn, built] = [0, 1, 2].map(|drive: usize| drives[drive][k]);
        println!(
            "{:<12} {published:12.4} {drawn:11.4} {built:12.4}",
            parameter.name
        );
    }
}

// A page with the drives over each other.

/// A drive that the page shows.
pub(crate) struct Design<'a> {
    pub(crate) name: &'static str,
    pub(crate) assembly: &'a EyeNeedleAssembly,
    /// Where it dwells, and for how long.
    pub(crate) rest: [f64; 2],
    /// The widest band over the dwell of drives that are built within the tolerances, in mm.
    pub(crate) band: f64,
}

/// Writes the page; the first drive is what the others are compared with.
fn compared(designs: &[Design<'_>], folder: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let mut reports = Vec::new();
    for design in designs {
        reports.push(report(design)?);
    }
    let about = format!(
        "No length differs by more than 2 % from the published drive, and the stroke is kept. The dwell is where the way of \
         the needle stays within {BAND} mm; built with tolerances of 20 um on all dimensions a drive needs the wider band."
    );
    let comparison = designs
        .iter()
        .zip(&reports)
        .fold(
            Comparison::new("A longer dwell").about(about),
            |all, (design, report)| {
                let compared = Compared::new(design.name, report)
                    .figure("dwell", design.rest[1].to_degrees(), "deg")
                    .figure("band when it is built", design.band, "mm");
                all.design(compared)
            },
        )
        .curves(["way", "v", "a"])
        .front([Aim::most("dwell"), Aim::least("band when it is built")]);
    Ok(comparison.write(folder)?)
}

fn report(design: &Design<'_>) -> Result<Report, Box<dyn Error>> {
    let input = &EyeNeedle::INPUTS[0];
    let phi = input.positions(361);
    let assembly = design.assembly;
    Ok(Report::new(design.name, input, &phi)
        .dimensions(assembly.mechanism())
        .structure(EyeNeedle::STRUCTURE)
        .table(&assembly.motion_sweep(&phi))
        .table(&assembly.picture_sweep(&phi))
        .trace("p8")
        .course("way", "mm", &course(assembly)?))
}

// What must hold of the drives, by other ways than those of the search.

/// Where the published drive dwells, and for how long; it was read off positions every half degree.
fn compare_published(
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
fn compare(drive: &Drive, stroke: f64, check: &mut Check) -> Result<(), Box<dyn Error>> {
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
fn worst(
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
