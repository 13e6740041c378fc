//! The published reactions: with the conventions that they were computed with, and beside the drive's own.

use super::{Favorit, FavoritAssembly, Forces, JOINTS, MACHINE_SPEED, sizes};
use crate::check::Check;
use crate::favorit::columns;
use linkage::AssemblyError;

/// One row of the table: the sizes of all reactions, in newtons.
type Row = [f64; 8];

/// Cells that do not fit their neighbours: joint, row, and by how much the print is too large, in newtons.
const MISPRINTS: [(&str, usize, f64); 3] = [("R7", 16, 1.0), ("R11", 16, 1.0), ("R11", 18, 1.0)];

/// The published reactions against those of its conventions, then beside the drive's: at that speed, and over the
/// `cycle` at the machine's.
pub(super) fn compare(
    drive: &FavoritAssembly,
    cycle: &[Forces],
    check: &mut Check,
) -> Result<(), AssemblyError> {
    // The nominal -104.72 rad/s, taken for degrees per second.
    let speed = MACHINE_SPEED.to_radians();
    let (rocker, needle) = (rocker_side().assemble()?, needle_side().assemble()?);
    let as_published: Vec<Row> = crank_angles()
        .map(|phi12| {
            let of_rocker = sizes(&rocker.forces(phi12, speed));
            let of_needle = sizes(&needle.forces(phi12, speed));
            std::array::from_fn(|joint| match joint {
                0..4 => of_rocker[joint],
                _ => of_needle[joint],
            })
        })
        .collect();
    check_published(&as_published, check);

    let true_rows: Vec<Row> = crank_angles()
        .map(|phi12| sizes(&drive.forces(phi12, speed)))
        .collect();
    print_rows(&as_published, &true_rows);

    let at_speed: Vec<Row> = cycle.iter().map(sizes).collect();
    print_ranges(&as_published, &true_rows, &at_speed);
    println!("\nThe rocker's bearing, R4 in newtons:");
    let ranges = [&as_published, &true_rows, &at_speed].map(|rows| range(rows, 3));
    let [(least, most), (true_least, true_most), (_, largest)] = ranges;
    check.near("published, least", least, 21.6, 0.05);
    check.near("published, largest", most, 22.3, 0.05);
    check.near("at that speed, least", true_least, 52.9, 0.05);
    check.near("at that speed, largest", true_most, 59.8, 0.05);
    check.near("at 1000 rpm, largest", largest, 426.7, 0.05);
    let all = at_speed.iter().flatten();
    check.holds("... of all reactions", all.copied().all(|r| r <= largest));
    Ok(())
}

/// The main crank from row to row: back by 30 degrees.
fn crank_angles() -> impl Iterator<Item = f64> {
    (0..25).map(|row| (630.0 - 30.0 * f64::from(row)).to_radians())
}

/// Crank, coupler and rocker as published: nothing of the needle reaches the rocker.
fn rocker_side() -> Favorit {
    let given = Favorit::default();
    Favorit {
        angle_3: given.angle_3.to_radians(),
        m5: 0.0,
        i5: 0.0,
        m6: 0.0,
        i6: 0.0,
        ..given
    }
}

/// Crank, rod and slider as published: the rocker's mass in the inertia forces, and the right weights.
fn needle_side() -> Favorit {
    let given = Favorit::default();
    let excess = |mass: f64| (given.m3 - mass) * 9.80665;
    Favorit {
        angle_6: given.angle_6.to_radians(),
        m5: given.m3,
        m6: given.m3,
        lift_5: excess(given.m5),
        lift_6: excess(given.m6),
        ..given
    }
}

fn check_published(computed: &[Row], check: &mut Check) {
    println!("\nWith the publication's conventions:");
    let columns = columns(include_str!("../../../mechanisms/favorit/reactions.csv"));
    let names = columns.iter().map(|(name, _)| *name);
    let complete = names.eq(JOINTS) && columns.iter().all(|(_, values)| values.len() == 25);
    check.holds("8 columns of 25 rows", complete);
    let is_misprint =
        |name: &str, row: usize| MISPRINTS.iter().any(|own| (own.0, own.1) == (name, row));
    for ((name, printed), joint) in columns.iter().zip(0..) {
        let as_printed = (0..printed.len()).filter(|&row| !is_misprint(name, row));
        let pairs = as_printed.map(|row| (computed[row][joint], printed[row]));
        check.all_near(name, pairs, 0.005 + 1e-9);
    }
    for (name, row, too_large) in MISPRINTS {
        let misprints = columns
            .iter()
            .zip(0..)
            .filter(|((column, _), _)| *column == name);
        for ((_, printed), joint) in misprints {
            let what = format!("{name}, row {row}, misprinted by {too_large:.0} N");
            check.near(
                &what,
                computed[row][joint],
                printed[row] - too_large,
                0.005 + 1e-9,
            );
        }
    }
}

fn print_rows(published: &[Row], drive: &[Row]) {
    println!(
        "\nReactions in newtons at 1.8277 rad/s: as published (left), and of the drive (right)"
    );
    let titles = JOINTS.map(|joint| format!("{joint:>6}")).concat();
    println!("  phi12{titles}  |{titles}");
    for ((phi12, left), right) in crank_angles().zip(published).zip(drive) {
        let [left, right] = [left, right].map(|row| row.map(|r| format!("{r:6.2}")).concat());
        println!("  {:5.0}{left}  |{right}", phi12.to_degrees());
    }
}

fn print_ranges(published: &[Row], drive: &[Row], at_speed: &[Row]) {
    println!("\nLeast and largest:");
    println!("       as published     1.8277 rad/s         1000 rpm");
    for (joint, name) in JOINTS.iter().enumerate() {
        let ranges = [published, drive, at_speed].map(|rows| {
            let (least, most) = range(rows, joint);
            format!("{least:8.2} {most:7.2}")
        });
        println!("  {name:<3}{}", ranges.join(" "));
    }
}

/// The least and the largest value of a column.
fn range(rows: &[Row], joint: usize) -> (f64, f64) {
    let column = rows.iter().map(|row| row[joint]);
    column.fold((f64::INFINITY, 0.0), |(least, most), r| {
        (r.min(least), r.max(most))
    })
}
