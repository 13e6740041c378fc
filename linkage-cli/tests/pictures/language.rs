//! Pictures of the language reference.

use linkage_report::{Plot, Report};

use crate::Picture;
use crate::rows::{lengths, report, rows};
use crate::sample::Page;

/// Positions over a turn: one for every third degree.
const POSITIONS: usize = 121;

/// The press with the path of its oiler.
pub(crate) fn pictures(page: &Page) -> Vec<Picture> {
    let press = page.mechanism("# Pictures", "Press");
    let assembly = press.assemble(&press.dimensions()).expect("it closes");
    let report = report("Press", &press, &assembly, "picture", POSITIONS);
    let drawing = report.drawing().expect("a picture").trace("oiler");
    Vec::from([Picture {
        path: "pictures/press.svg",
        svg: drawing.svg().expect("a drawing"),
    }])
}

/// Speed of the crank in rad/s and load in newtons, as the sample has them.
const AT: [(&str, f64); 3] = [("omega", 20.0), ("epsilon", 0.0), ("load", 500.0)];
/// Length in millimetres of an arrow of 1 N.
const NEWTON: f64 = 0.05;

/// The forces in the joints as arrows off the rod, where their names are legible, and the picture.
const DRAWN: &str = "
    fn arrows(phi, omega, epsilon, load) -> Arrows {
        wheel: -reaction(b), piston: -reaction(d), side: reaction(c)
    }
    fn shape(phi) -> Shape { shape: picture() }";

/// Forces in the press at a position, and all of them over a turn with the torque.
pub(crate) fn forces(page: &Page) -> Vec<Picture> {
    let press = page.with("# Forces", "Press", DRAWN);
    let assembly = press.assemble(&press.dimensions()).expect("it closes");
    let input = &press.inputs()[0];
    let turn = input.positions(POSITIONS);
    let forces = rows(&press, &assembly, "forces", &turn, &AT);
    let arrows = rows(&press, &assembly, "arrows", &turn, &AT);
    let shapes = rows(&press, &assembly, "shape", &turn, &[]);
    let report = Report::new("Forces on wheel and piston", input, &turn)
        .table(&shapes)
        .table(&arrows);
    let drawing = report
        .drawing()
        .expect("a picture")
        .names(false)
        .scale(1.0)
        .position(90f64.to_radians())
        .vector("p", "wheel", NEWTON)
        .vector("q", "piston", NEWTON)
        .vector("q", "side", NEWTON);
    let plot = Plot::new(input.name, input.unit, &turn)
        .title("Torque, and sizes of reactions")
        .size(760.0, 180.0)
        .curve("t", "N*mm", &forces["t"]);
    let plot = ["b", "d", "side"].iter().fold(plot, |plot, name| {
        plot.curve(name, "N", &lengths(&forces, name))
    });
    Vec::from([
        Picture {
            path: "forces/reactions.svg",
            svg: drawing.svg().expect("a drawing"),
        },
        Picture {
            path: "forces/turn.svg",
            svg: plot.svg().expect("a plot"),
        },
    ])
}

const DYADS: [(&str, &str, &str); 4] = [
    ("RRR", "FourBar", "loops/rrr.svg"),
    ("RRP", "SliderCrank", "loops/rrp.svg"),
    ("RPR", "SlottedLever", "loops/rpr.svg"),
    ("PRP", "SlottedCrank", "loops/prp.svg"),
];

/// A mechanism of each dyad of the plane.
pub(crate) fn loops(page: &Page) -> Vec<Picture> {
    let draw = |(kind, name, path)| {
        let mechanism = page.mechanism("## Dyads of the plane", name);
        assert_eq!(mechanism.structure().groups[0].kind, kind);
        let dimensions = mechanism.dimensions();
        let assembly = mechanism.assemble(&dimensions).expect("it closes");
        let report = report(kind, &mechanism, &assembly, "picture", POSITIONS);
        let drawing = report.drawing().expect("a picture").scale(1.0);
        let svg = drawing.svg().expect("a drawing");
        Picture { path, svg }
    };
    DYADS.map(draw).into()
}
