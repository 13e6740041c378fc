//! Hook-needle drive of the Favorit warp-knitting machine, against its published tables.
//!
//! Two cranks drive the needle: the main crank 1-2 swings the rocker 3-4-5-6 through the coupler
//! 2-3 (dyad RRR); the guide 5-6 is fixed on that rocker, and a slider on it is moved by the second
//! crank 7-8 through the rod 8-9 (dyad RRP on a moving guide). The needle 9-10 is part of the
//! slider. The second crank turns backwards at half the speed, so that one cycle takes two turns.
//!
//! All 63 published columns agree to their last digit. `UPDATE=1` writes the picture of the README.

use crate::check::Check;
use crate::folders;
use linkage::report::Report;
use linkage::{true_acceleration, true_velocity};
use std::error::Error;
use std::f64::consts::{PI, TAU};

include!("../../mechanisms/favorit.rs");

/// 1000 revolutions per minute, clockwise.
const MACHINE_SPEED: f64 = -1000.0 * TAU / 60.0;

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let linkage = Favorit::default().assemble()?;
    println!("{}", Favorit::STRUCTURE);
    print_needle(&linkage);

    println!("\nAgainst the publication:");
    let mut check = Check::default();
    let columns = columns(include_str!("../../mechanisms/favorit/tables.csv"));
    let complete = columns.len() == 63 && columns.iter().all(|(_, rows)| rows.len() == 25);
    check.holds("63 columns of 25 rows", complete);

    // Row i belongs to -90 + 150 i degrees. Two turns are one cycle, so it is taken back into it.
    let crank_angle = |row: usize| (150.0 * row as f64 % 720.0 - 90.0).to_radians();
    // The nominal -104.72 rad/s, taken for degrees per second.
    let speed = MACHINE_SPEED.to_radians();
    let rows: Vec<Row> = (0..25)
        .map(|i| published_row(&linkage, crank_angle(i), speed))
        .collect();
    for (name, printed) in &columns {
        check.all_near(name, differences(name, printed, &rows), 0.005 + 1e-9);
    }

    let labelled = |i: usize| (-90.0 - 30.0 * i as f64).rem_euclid(720.0).to_radians();
    let by_label: Vec<Row> = (0..25)
        .map(|i| published_row(&linkage, labelled(i), speed))
        .collect();
    let off = |(name, printed): &&(&str, Vec<f64>)| {
        differences(name, printed, &by_label).any(|(difference, _)| difference.abs() > 0.0051)
    };
    let wrong = columns.iter().filter(off).count();
    println!(
        "
Where the publication is wrong:
- Row labels: they count 0, 30, ... 720 degrees, but row i was computed at the crank angles
  phi12 = -90 + 150 i and phi78 = 60 - 75 i degrees. Taken at its labels (30 degrees of the
  main crank from row to row), {wrong} of 63 columns fail.
- Speed: all rates belong to {speed:.4} rad/s. The machine's 1000 rpm are {MACHINE_SPEED:.2} rad/s;
  that figure was taken for degrees per second. True velocities are {factor:.2} times, true
  accelerations {square:.0} times the printed ones.
- Printed link angles are reduced to one turn: they are compared modulo 360 degrees.",
        factor = 180.0 / PI,
        square = (180.0 / PI).powi(2),
    );
    check.finish()
}

/// The needle over one cycle, in the direction in which the machine turns, at its real speed.
fn print_needle(linkage: &FavoritAssembly) {
    println!(
        "Needle point, main crank at {:.0} rpm:",
        MACHINE_SPEED * 60.0 / TAU
    );
    println!("  phi12, deg    x, mm    y, mm   vx, m/s   vy, m/s  ax, m/s2  ay, m/s2");
    for step in 0..=24 {
        let degrees = 630.0 - 30.0 * f64::from(step);
        let n = linkage.needle(degrees.to_radians());
        let v = true_velocity(n.v, MACHINE_SPEED) * 1e-3;
        let a = true_acceleration(n.v, n.a, MACHINE_SPEED, 0.0) * 1e-3;
        println!(
            "  {degrees:10.0} {:8.3} {:8.3} {:9.4} {:9.4} {:9.2} {:9.2}",
            n.p10.x, n.p10.y, v.x, v.y, a.x, a.y
        );
    }
}

/// One row of the tables: names and values, in the printed units.
type Row = Vec<(String, f64)>;

fn published_row(linkage: &FavoritAssembly, phi12: f64, speed: f64) -> Row {
    let m = linkage.motion(phi12);
    let points = [
        ("2", m.p2, m.v2, m.a2),
        ("3", m.p3, m.v3, m.a3),
        ("5", m.p5, m.v5, m.a5),
        ("6", m.p6, m.v6, m.a6),
        ("8", m.p8, m.v8, m.a8),
        ("9", m.p9, m.v9, m.a9),
        ("10", m.p10, m.v10, m.a10),
    ];
    let angles = [
        ("23", m.phi23, m.om23, m.eps23),
        ("43", m.phi43, m.om43, m.eps43),
        ("45", m.phi45, m.om45, m.eps45),
        ("56", m.phi56, m.om56, m.eps56),
        ("78", m.phi78, m.om78, m.eps78),
        ("89", m.phi89, m.om89, m.eps89),
        ("910", m.phi910, m.om910, m.eps910),
    ];
    let mut row = Row::new();
    for (name, p, v, a) in points {
        for (axis, i) in [("X", 0), ("Y", 1)] {
            // mm, and rates in 1e-5 m: one hundredth of a millimetre.
            row.push((format!("P{name}{axis}"), p[i]));
            row.push((format!("V{name}{axis}"), 100.0 * speed * v[i]));
            row.push((format!("A{name}{axis}"), 100.0 * speed * speed * a[i]));
        }
    }
    for (name, angle, first, second) in angles {
        row.push((format!("phi{name}"), angle.to_degrees()));
        row.push((format!("om{name}"), 100.0 * speed * first));
        row.push((format!("eps{name}"), 100.0 * speed * speed * second));
    }
    row
}

/// Computed minus printed for each row of a column (angles modulo a turn), paired with zero.
fn differences<'a>(
    name: &'a str,
    printed: &'a [f64],
    rows: &'a [Row],
) -> impl Iterator<Item = (f64, f64)> + 'a {
    printed.iter().zip(rows).map(move |(printed, row)| {
        let computed = row
            .iter()
            .find(|(label, _)| label == name)
            .map_or(f64::NAN, |(_, x)| *x);
        let difference = computed - printed;
        let turns = if name.starts_with("phi") {
            (difference / 360.0).round()
        } else {
            0.0
        };
        (difference - 360.0 * turns, 0.0)
    })
}

/// The columns of a printed table: lines `name,unit,25 values`, the row labels left out.
pub(crate) fn columns(table: &'static str) -> Vec<(&'static str, Vec<f64>)> {
    let columns = table
        .lines()
        .filter(|line| !line.starts_with('#') && !line.starts_with("label"));
    columns
        .map(|line| {
            let mut cells = line.split(',');
            let name = cells.next().unwrap_or_default();
            // A cell that is no number fails its comparison.
            let values = cells
                .skip(1)
                .map(|cell| cell.parse().unwrap_or(f64::NAN))
                .collect();
            (name, values)
        })
        .collect()
}

// The drive as a drawing that moves.

/// Positions of its cycle of two turns, one for each four degrees.
const POSITIONS: usize = 181;
/// Seconds of a cycle: slow enough for both cranks to be followed.
const CYCLE: f64 = 6.0;

fn moving() -> Result<String, Box<dyn Error>> {
    let linkage = Favorit::default().assemble()?;
    let phi = Favorit::INPUTS[0].positions(POSITIONS);
    let shapes = linkage.picture_sweep(&phi);
    let report = Report::new("Hook-needle drive", &Favorit::INPUTS[0], &phi).table(&shapes);
    Ok(report.drawing()?.trace("p10").moving(CYCLE).svg()?)
}

/// The README shows this drawing; `UPDATE=1` writes it.
#[test]
fn the_picture_of_the_readme_is_current() -> Result<(), Box<dyn Error>> {
    let drawn = moving()?;
    let file = folders::docs("favorit.svg");
    if folders::is_update() {
        std::fs::write(&file, &drawn)?;
    }
    assert!(
        drawn == std::fs::read_to_string(file)?,
        "docs/favorit.svg is not current"
    );
    // Of a page that is read over the network.
    assert!(drawn.len() < 60_000, "{} bytes", drawn.len());
    Ok(())
}
