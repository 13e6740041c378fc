//! All assemblies of platforms on six legs, and a slice of a workspace.

use super::geometry::{FEET, JOINTS};
use super::platform::{DIETMAIER, LAST_LEG, Platform};
use super::{TURN, ToLegsAssembly, ToPoseFollower, even, listed, numbers, rotation};
use crate::check::Check;
use linkage::design::exact::{Solution, solutions_traced};
use nalgebra::Vector3;
use serde_json::Value;
use std::error::Error;
use std::fmt::Write;
use std::path::Path;

// A slice of the workspace: places of the platform's origin at one height and in one orientation.

/// Lengths that the legs have, in mm.
const SHORTEST: f64 = 370.0;
const LONGEST: f64 = 540.0;
/// Half the side of the slice, its height, and the side of a cell.
const HALF: i32 = 240;
const HEIGHT: f64 = 420.0;
const CELL: i32 = 12;
/// Beyond it the platform is told as badly held.
const WORST: f64 = 150.0;

/// A place that all legs reach, and the condition there; none where the follower did not come.
struct Place {
    x: i32,
    y: i32,
    condition: Option<f64>,
}

pub(super) fn show(
    check: &mut Check,
    start: ToPoseFollower<'_>,
    to_legs: &ToLegsAssembly,
    folder: &Path,
) -> Result<(), Box<dyn Error>> {
    let places = places(start, to_legs);
    let lost = places.iter().filter(|place| place.condition.is_none());
    let (all, lost) = (places.len(), lost.count());
    println!(
        "       {all} cells of {CELL} mm within reach of the legs, {lost} not reached by the follower"
    );
    check.holds("some are reached, not all", all > lost && all < cells());
    // By the lengths alone, without the mechanism.
    let reached = in_reach_by_hand();
    check.holds("the reach is that of six shells", reached == all);
    std::fs::create_dir_all(folder)?;
    let file = folder.join("workspace.svg");
    std::fs::write(&file, picture(&places)?)?;
    println!("       {}", file.display());
    Ok(())
}

/// How many cells the slice has.
fn cells() -> usize {
    let side = side();
    side.len() * side.len()
}

/// The middles of the cells along one side.
fn side() -> Vec<i32> {
    (-HALF / CELL..=HALF / CELL).map(|k| k * CELL).collect()
}

/// All places in reach of the legs, each on a straight way of the lengths from the reference.
fn places(start: ToPoseFollower<'_>, to_legs: &ToLegsAssembly) -> Vec<Place> {
    let [roll, pitch, yaw] = TURN;
    let mut places = Vec::new();
    for x in side() {
        for y in side() {
            let legs = listed(&to_legs.legs(x.into(), y.into(), HEIGHT, roll, pitch, yaw));
            if !legs.iter().all(|leg| (SHORTEST..=LONGEST).contains(leg)) {
                continue;
            }
            let [a, b, c, d, e, f] = legs;
            let mut at = start;
            let followed = at.follow(a, b, c, d, e, f).is_ok();
            // Another pose with the same legs is not this place.
            let wanted = Vector3::new(x.into(), y.into(), HEIGHT);
            let here = followed && (at.pose().body.origin - wanted).norm() < 1e-6;
            let condition = here.then(|| even(&at));
            places.push(Place { x, y, condition });
        }
    }
    places
}

/// The number of cells in the reach of six legs, from the distances of their joints.
fn in_reach_by_hand() -> usize {
    let turn = rotation(TURN);
    let within = |x: i32, y: i32| {
        let shift = Vector3::new(x.into(), y.into(), HEIGHT);
        FEET.iter().zip(&JOINTS).all(|(foot, joint)| {
            let leg = shift + turn * Vector3::from(*joint) - Vector3::from(*foot);
            (SHORTEST..=LONGEST).contains(&leg.norm())
        })
    };
    let side = side();
    let rows = side
        .iter()
        .map(|&x| side.iter().filter(|&&y| within(x, y)).count());
    rows.sum()
}

/// Dark where the platform is held well; red where the follower did not come or came to another pose.
fn picture(places: &[Place]) -> Result<String, std::fmt::Error> {
    let (border, legend) = (40, 70);
    let size = 2 * (HALF + border);
    let mut svg = String::new();
    writeln!(
        svg,
        r#"<svg xmlns="http://www.w3.org/2000/svg" width="{size}" height="{}" font-family="sans-serif" font-size="13">"#,
        size + legend
    )?;
    writeln!(svg, r#"<rect width="100%" height="100%" fill="white"/>"#)?;
    for place in places {
        let colour = place.condition.map_or("#c0392b".to_string(), |condition| {
            let share = (condition / WORST).min(1.0);
            format!("hsl(210, 60%, {:.0}%)", 30.0 + 60.0 * share)
        });
        // x to the right, y upwards.
        let (left, top) = (
            HALF + border + place.x - CELL / 2,
            HALF + border - place.y - CELL / 2,
        );
        writeln!(
            svg,
            r#"<rect x="{left}" y="{top}" width="{CELL}" height="{CELL}" fill="{colour}"/>"#
        )?;
    }
    let (low, high, middle) = (border, size - border, HALF + border);
    writeln!(
        svg,
        r#"<path d="M{low} {middle}H{high}M{middle} {low}V{high}" stroke="gray" stroke-width="0.5"/>"#
    )?;
    let lines = [
        format!("Origin at {HEIGHT} mm; roll, pitch and yaw {TURN:?} rad."),
        format!("Legs of {SHORTEST} to {LONGEST} mm; cells of {CELL} mm."),
        format!("Condition from 1, dark, to {WORST} and more, pale; red: not reached."),
    ];
    for (line, text) in (0..).zip(&lines) {
        writeln!(
            svg,
            r#"<text x="{border}" y="{}">{text}</text>"#,
            size + 10 + 20 * line
        )?;
    }
    writeln!(svg, "</svg>")?;
    Ok(svg)
}

// All assemblies of platforms: of the one that P. Dietmaier found in 1998 all 40 are real, of the one that is followed here eight at one end of the
// path, and six at the other.

/// Lists all assemblies and compares them with solutions in 80 digits.
pub(super) fn show_assemblies(check: &mut Check) -> Result<(), Box<dyn Error>> {
    let known: Vec<Value> =
        serde_json::from_str(include_str!("../../../mechanisms/hexapod/dietmaier.json"))?;
    check.holds("40 known assemblies, all of them real", known.len() == 40);
    compare(check, &DIETMAIER, &known, 1.0)?;
    let ends: Vec<Value> =
        serde_json::from_str(include_str!("../../../mechanisms/hexapod/assemblies.json"))?;
    for (known, real) in ends.iter().zip([8, 6]) {
        let platform = followed(numbers::<6>(&known["legs"])?);
        let known = known["poses"].as_array().ok_or("there are known poses")?;
        check.holds("so many are known to be real", known.len() == real);
        compare(check, &platform, known, 1000.0)?;
    }
    Ok(())
}

/// The platform that is followed here, in millionths of a millimetre; its place is in metres.
fn followed(legs: [f64; 6]) -> Platform {
    let whole = |x: f64| (x * 1e6).round();
    Platform {
        unit: 1e9,
        base: FEET.map(|own| own.map(whole)),
        platform: JOINTS.map(|own| own.map(whole)),
        legs: legs.map(whole),
    }
}

/// `unit` is what the known places count of the unit of the platform's.
fn compare(
    check: &mut Check,
    platform: &Platform,
    known: &[Value],
    unit: f64,
) -> Result<(), Box<dyn Error>> {
    let found = solutions_traced(platform, LAST_LEG)?;
    let trace = found.trace.ok_or("the test was asked for")?;
    println!(
        "       {} real, {} complex, {} undecided; no more over {} loops; trace test: {} points, their sum linear to {:.0e}",
        found.real.len(),
        found.complex,
        found.undecided,
        found.idle,
        trace.degree,
        trace.miss
    );
    check.holds(
        "40 assemblies, real and complex",
        found.real.len() + found.complex == 40 && found.real.len() == known.len(),
    );
    check.holds("none is missing", found.is_complete());
    let known = known.iter().map(|own| unknowns(own, unit));
    let known: Vec<[f64; 9]> = known.collect::<Result<_, _>>()?;
    let mut met: Vec<usize> = Vec::new();
    let mut pairs = Vec::new();
    for solution in &found.real {
        let nearest = (0..known.len())
            .min_by(|&a, &b| off(solution, &known[a]).total_cmp(&off(solution, &known[b])))
            .ok_or("there are known solutions")?;
        met.push(nearest);
        pairs.extend(solution.values.into_iter().zip(known[nearest]));
    }
    // Roundoffs of numbers up to 1: the solutions are certified with more digits.
    check.all_near("places and directions", pairs, 2.5e-16);
    let errors = found.real.iter().map(|solution| (solution.error, 0.0));
    check.all_near("bounds of their errors", errors, 2.5e-16);
    met.sort_unstable();
    check.holds(
        "each known one is found once",
        met.into_iter().eq(0..known.len()),
    );
    Ok(())
}

fn unknowns(known: &Value, unit: f64) -> Result<[f64; 9], Box<dyn Error>> {
    let [p, x, y] = ["p", "x", "y"].map(|part| numbers::<3>(&known[part]));
    let all = [p?.map(|place| place / unit), x?, y?].concat();
    all.try_into().map_err(|_| "three vectors".into())
}

fn off(solution: &Solution<9>, known: &[f64; 9]) -> f64 {
    let pairs = solution.values.iter().zip(known);
    pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
