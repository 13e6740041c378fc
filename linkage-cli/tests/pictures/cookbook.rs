//! Pictures of the cookbook.

use linkage_analysis::balancing::Balance;
use linkage_report::{Plot, Report};

use crate::Picture;
use crate::rows::{between, report, rows};
use crate::sample::Page;

/// Positions over a turn: one for every third degree.
const POSITIONS: usize = 121;

pub(crate) fn pictures(page: &Page) -> Vec<Picture> {
    let [open, crossed] = both_assemblies(page);
    Vec::from([
        open,
        crossed,
        circuits(page),
        dwell(page),
        counterweight(page),
    ])
}

fn both_assemblies(page: &Page) -> [Picture; 2] {
    let shape = "fn shape(phi) -> Shape { shape: picture() }";
    let four_bar = page.with("# Both assemblies", "FourBar", shape);
    let all = four_bar.assemblies(&four_bar.dimensions(), &four_bar.reference());
    let all = all.expect("it closes");
    assert_eq!(all.len(), 2, "a four-bar has two assemblies");
    let draw = |index: usize, title: &str, path| {
        let report = report(title, &four_bar, &all[index], "shape", POSITIONS);
        let drawing = report.drawing().expect("a picture").names(false);
        let svg = drawing.svg().expect("a drawing");
        Picture { path, svg }
    };
    [
        draw(0, "The first assembly", "cookbook/open.svg"),
        draw(1, "The second assembly", "cookbook/crossed.svg"),
    ]
}

/// The rocker's angle of both assemblies over the reach of the crank.
fn circuits(page: &Page) -> Picture {
    let rocking = page.mechanism("# All circuits", "Rocking");
    let dimensions = rocking.dimensions();
    let circuits = rocking.circuits(&dimensions).expect("one input");
    let circuits = circuits.expect("it closes");
    let input = &rocking.inputs()[0];
    let [low, high] = circuits.branches[0].ends.map(|end| end.x());
    // Closer to each other at the ends, where the angle changes fastest.
    let steps = between(input, -1.0, 1.0, POSITIONS);
    let bend = |step: f64| (0.5 * std::f64::consts::PI * step).sin();
    let middle = 0.5 * (low + high);
    let positions = steps
        .iter()
        .map(|step| middle + 0.5 * (high - low) * bend(*step));
    let positions: Vec<f64> = positions.collect();
    let plot = Plot::new(input.name, input.unit, &positions).size(760.0, 260.0);
    let plot = circuits
        .branches
        .iter()
        .zip(["first assembly", "second assembly"])
        .fold(
            plot.title("Angle psi of the rocker"),
            |plot, (branch, name)| {
                let rows = rows(&rocking, &branch.assembly, "rocker", &positions, &[]);
                plot.curve(name, "rad", &rows["psi"])
            },
        );
    Picture {
        path: "cookbook/circuit.svg",
        svg: plot.svg().expect("a plot"),
    }
}

/// How far below its limit the slide may be in its dwell, in millimetres.
const DWELL: f64 = 0.5;

/// The slide next to its limit, with its worst case and the bound of the dwell.
fn dwell(page: &Page) -> Picture {
    let accuracy = "fn near(phi) -> Near { slide, e: sensitivity(slide) }";
    let press = page.with("# The tolerance of a dwell", "Press", accuracy);
    let assembly = press.assemble(&press.dimensions()).expect("it closes");
    let input = &press.inputs()[0];
    let end = 12f64.to_radians();
    let positions = between(input, -end, end, POSITIONS);
    let rows = rows(&press, &assembly, "near", &positions, &[]);
    let limit = rows["slide"].iter().copied().fold(f64::MIN, f64::max);
    let bound = vec![limit - DWELL; positions.len()];
    let report = Report::new("The slide near its limit", input, &positions)
        .dimensions_listed(press.parameters(), assembly.dimensions())
        .table(&rows);
    let plot = report.plot(["slide"]).expect("a column");
    let plot = plot
        .size(760.0, 260.0)
        .curve("bound of the dwell", "mm", &bound);
    Picture {
        path: "cookbook/dwell.svg",
        svg: plot.svg().expect("a plot"),
    }
}

/// The shaking force over a turn, without and with the counterweight.
fn counterweight(page: &Page) -> Picture {
    let engine = page.mechanism("# A counterweight", "Engine");
    let input = &engine.inputs()[0];
    let turn = input.positions(POSITIONS);
    let speed = [("omega", 100.0)];
    let mut dimensions = engine.dimensions();
    let shaking = |dimensions: &[f64]| {
        let assembly = engine.assemble(dimensions).expect("it closes");
        rows(&engine, &assembly, "shaking", &turn, &speed)
    };
    let before = shaking(&dimensions);
    // The last position is the first one.
    let cycle = 0..POSITIONS - 1;
    let vector =
        |name: &str, row: usize| ["x", "y"].map(|axis| before[&format!("{name}.{axis}")[..]][row]);
    let forces: Vec<[f64; 2]> = cycle.clone().map(|row| vector("f", row)).collect();
    let effects: Vec<[[f64; 2]; 2]> = cycle
        .map(|row| ["by[ahead]", "by[across]"].map(|name| vector(name, row)))
        .collect();
    let balance = Balance::new(&forces, &effects).and_then(|own| own.mean_square());
    for (name, mass) in ["ahead", "across"]
        .iter()
        .zip(balance.expect("masses").values)
    {
        let mut parameters = engine.parameters().iter();
        let index = parameters.position(|own| own.name == *name);
        dimensions[index.expect("a mass")] = mass;
    }
    let after = shaking(&dimensions);
    let plot = Plot::new(input.name, input.unit, &turn)
        .title("Shaking force at 100 rad/s")
        .size(760.0, 260.0)
        .curve("x, without", "N", &before["f.x"])
        .curve("x, with", "N", &after["f.x"])
        .curve("y, with", "N", &after["f.y"]);
    Picture {
        path: "cookbook/shaking.svg",
        svg: plot.svg().expect("a plot"),
    }
}
