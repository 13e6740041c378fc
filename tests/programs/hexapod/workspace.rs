//! A slice of the workspace: places of the platform's origin at one height and in one orientation.

use super::geometry::{FEET, JOINTS};
use super::{TURN, ToLegsAssembly, ToPoseFollower, even, listed, rotation};
use crate::check::Check;
use nalgebra::Vector3;
use std::error::Error;
use std::fmt::Write;
use std::path::Path;

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

pub(crate) fn show(
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
