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
mod checks;
mod drive;
#[path = "../programs/folders.rs"]
mod folders;
mod page;

use check::Check;
use checks::{compare, compare_published, worst};
use drive::{BAND, Drive, EyeNeedle, N, design, stroke, way};
use linkage::Dimensions;
use linkage::design::Dwell;
use linkage::tolerance::Tolerances;
use page::{Design, compared};
use std::error::Error;
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
