//! The mechanisms of the tutorial `docs/tutorial.md`, and its pictures.
//!
//! Positions and the dwell are those of circles and of a dense table.

use crate::check::Check;
use crate::folders;
use linkage::report::Report;
use linkage::summary::Curve;
use std::error::Error;
use std::f64::consts::TAU;
use std::fs;
use std::path::Path;

include!("../../mechanisms/tutorial.rs");

/// Positions over a turn.
const POSITIONS: usize = 361;
/// Within this the lever counts as resting.
const BAND: f64 = 0.5 / 360.0 * TAU;
/// Positions of the table that the dwell is compared with.
const DENSE: usize = 36_000;

#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let mut check = Check::default();
    compare_positions(&mut check)?;
    compare_dwell(&mut check)?;
    check.finish()
}

/// Writes the picture of each step.
fn draw(folder: &Path) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    let input = &TakeUp::INPUTS[0];
    let phi = input.positions(POSITIONS);

    let crank = Crank::default().assemble()?;
    let shapes = crank.shape_sweep(&phi);
    let report = Report::new("A bar that turns", input, &phi).table(&shapes);
    report
        .drawing()?
        .trace("a")
        .write(folder.join("crank.svg"))?;

    let four_bar = FourBar::default().assemble()?;
    let shapes = four_bar.shape_sweep(&phi);
    let report = Report::new("A loop", input, &phi).table(&shapes);
    let drawing = report.drawing()?.dimensions(true);
    drawing.write(folder.join("four_bar.svg"))?;
    let [_, other] = &FourBar::default().assemblies()?[..] else {
        return Err("a four-bar has two assemblies".into());
    };
    let shapes = other.shape_sweep(&phi);
    let report = Report::new("The other assembly", input, &phi).table(&shapes);
    report.drawing()?.write(folder.join("other.svg"))?;

    // A rocker so short that the links are stretched before the crank has turned fully.
    let short = FourBar {
        rocker: 18.0,
        ..FourBar::default()
    }
    .assemble()?;
    let reached: Vec<f64> = (0..=117)
        .map(|degrees| f64::from(degrees).to_radians())
        .collect();
    let shapes = short.shape_sweep(&reached);
    let report = Report::new("Stretched", input, &reached).table(&shapes);
    let drawing = report
        .drawing()?
        .position(reached[117])
        .ghosts(4)
        .trace("b");
    drawing.write(folder.join("stretched.svg"))?;

    let take_up = TakeUp::default().assemble()?;
    let shapes = take_up.shape_sweep(&phi);
    let motion = take_up.motion_sweep(&phi);
    let report = Report::new("Take-up lever", input, &phi)
        .table(&shapes)
        .table(&motion);
    let drawing = report.drawing()?.ghosts(6).trace("c").trace("eye");
    drawing.write(folder.join("take_up.svg"))?;
    let plot = report.plot(["swing", "v"])?;
    plot.title("Swing of the lever")
        .write(folder.join("swing.svg"))?;
    Ok(())
}

/// Where circles of `radius` and `other` about two points meet, on the left of the way from the first point to the second.
fn left_of(from: [f64; 2], radius: f64, to: [f64; 2], other: f64) -> [f64; 2] {
    let (x, y) = (to[0] - from[0], to[1] - from[1]);
    let square = x * x + y * y;
    let along = (square + radius * radius - other * other) / (2.0 * square);
    let across = (radius * radius / square - along * along).sqrt();
    [
        from[0] + along * x - across * y,
        from[1] + along * y + across * x,
    ]
}

/// The eye by circles, as one would find it with a pair of compasses.
fn eye_by_hand(phi: f64) -> [f64; 2] {
    let a = [14.0 * phi.cos(), 14.0 * phi.sin()];
    let b = left_of(a, 30.0, [33.0, -15.0], 36.0);
    let theta = (b[1] - a[1]).atan2(b[0] - a[0]) + 10_f64.to_radians();
    let c = [a[0] + 67.0 * theta.cos(), a[1] + 67.0 * theta.sin()];
    let pivot = [-4.0, 97.0];
    let d = left_of(pivot, 60.0, c, 37.5);
    [0, 1].map(|i| pivot[i] - 80.0 / 60.0 * (d[i] - pivot[i]))
}

fn compare_positions(check: &mut Check) -> Result<(), Box<dyn Error>> {
    let take_up = TakeUp::default().assemble()?;
    let pairs = (0..360).flat_map(|degrees| {
        let phi = f64::from(degrees).to_radians();
        let (eye, known) = (take_up.thread(phi).eye, eye_by_hand(phi));
        [(eye.x, known[0]), (eye.y, known[1])]
    });
    check.all_near("the eye, mm, against circles", pairs, 1e-11);
    Ok(())
}

fn compare_dwell(check: &mut Check) -> Result<(), Box<dyn Error>> {
    let take_up = TakeUp::default().assemble()?;
    let course = Curve::new((0.0, TAU), 360, |phi| {
        let m = take_up.motion(phi);
        [m.swing, m.v, m.a]
    })?;
    let dwell = course.longest_dwell(BAND).ok_or("no dwell")?.interval;
    println!("{}", course.describe("rad", "rad"));

    // The longest run of positions of a table over two turns whose highest and lowest differ by the band at most.
    let [pivot_x, pivot_y] = [-4.0, 97.0];
    let swing = |row: usize| {
        let [x, y] = eye_by_hand(row as f64 / DENSE as f64 * TAU);
        (pivot_y - y).atan2(pivot_x - x)
    };
    let table: Vec<f64> = (0..2 * DENSE).map(swing).collect();
    let mut longest = 0;
    for from in 0..DENSE {
        let (mut low, mut high) = (table[from], table[from]);
        let run = table[from..].iter().take_while(|angle| {
            (low, high) = (low.min(**angle), high.max(**angle));
            high - low <= BAND
        });
        longest = longest.max(run.count() - 1);
    }
    let known = longest as f64 * 360.0 / DENSE as f64;
    check.near("dwell, degrees", dwell.range.to_degrees(), known, 0.02);
    Ok(())
}

/// The page has the pictures that this program draws; `UPDATE=1` writes them.
#[test]
fn pictures_of_the_page_are_current() -> Result<(), Box<dyn Error>> {
    let folder = folders::target("tutorial");
    draw(&folder)?;
    if folders::is_update() {
        draw(&folders::docs("tutorial"))?;
    }
    let mut count = 0;
    for entry in fs::read_dir(folders::docs("tutorial"))? {
        let path = entry?.path();
        let name = path.file_name().ok_or("a file has a name")?;
        let drawn = fs::read_to_string(folder.join(name))?;
        assert_eq!(fs::read_to_string(&path)?, drawn, "{}", path.display());
        count += 1;
    }
    assert_eq!(count, 6);
    Ok(())
}
