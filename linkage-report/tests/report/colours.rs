//! One colour for one quantity.

use crate::fixture::FourBar;
use crate::four_bar;
use crate::picture::{classed, lines};
use linkage_report::Plot;
use roxmltree::{Document, Node};

/// Colour and dashes of the curves of a plot, by name.
fn styles(plot: &Plot) -> Vec<(String, String, Option<String>)> {
    let svg = plot.svg().unwrap();
    let svg = Document::parse(&svg).unwrap();
    let lines = lines(&svg, "curve").into_iter();
    let style = |line: Node<'_, '_>| {
        let name = line.parent().unwrap().attribute("data-name").unwrap();
        let of = |name: &str| line.attribute(name).map(String::from);
        (
            String::from(name),
            of("stroke").unwrap(),
            of("stroke-dasharray"),
        )
    };
    lines.map(style).collect()
}

#[test]
fn a_quantity_has_its_colour_whatever_stands_beside_it() {
    let report = four_bar(FourBar::NOMINAL)
        .speed(20.0, 0.0)
        .trace("b")
        .trace("tracer");
    let plot = |names: &[&str]| styles(&report.plot(names.iter().copied()).unwrap());
    let all = plot(&[
        "tracer.x",
        "tracer.y",
        "v.x",
        "psi",
        "picture[b].x",
        "v.x [mm/s]",
    ]);
    for (name, colour, dash) in &all {
        let asked = if name == "v.x" { "motion.v.x" } else { name };
        let alone = plot(&[asked]);
        assert_eq!(alone[0], (name.clone(), colour.clone(), dash.clone()));
    }
    let of = |name: &str| all.iter().find(|style| style.0 == name).unwrap();
    let (x, y) = (of("tracer.x"), of("tracer.y"));
    assert!(
        x.1 == y.1 && x.2 != y.2,
        "a vector's components differ in dashes"
    );
    assert_ne!(of("picture[b].x").1, x.1);
    assert!(
        all.iter()
            .filter(|style| style.0 == "v.x")
            .all(|v| *v == *of("v.x"))
    );
    // The path of a point, and the point, have the colour of its curves.
    let svg = report.drawing().unwrap().svg().unwrap();
    let svg = Document::parse(&svg).unwrap();
    let path = |name: &str| {
        let paths = classed(&svg, "path");
        let path = paths
            .iter()
            .find(|path| path.attribute("data-name") == Some(name))
            .unwrap();
        let line = path
            .descendants()
            .find(|node| node.has_tag_name("polyline"))
            .unwrap();
        String::from(line.attribute("stroke").unwrap())
    };
    assert_eq!(path("tracer"), x.1);
    assert_eq!(path("b"), of("picture[b].x").1);
    let points = classed(&svg, "point");
    let tip = points
        .iter()
        .find(|point| point.attribute("data-point") == Some("tracer"));
    assert_eq!(tip.unwrap().attribute("fill"), Some(x.1.as_str()));
    // So has the arrow of a vector.
    let arrow = report
        .drawing()
        .unwrap()
        .vector("tracer", "v", 0.5)
        .svg()
        .unwrap();
    let arrow = Document::parse(&arrow).unwrap();
    let arrow = classed(&arrow, "vector")[0];
    let line = arrow.descendants().find(|node| node.has_tag_name("line"));
    assert_eq!(
        line.unwrap().attribute("stroke"),
        Some(of("v.x").1.as_str())
    );
    // Errors have the colours of what is in error.
    let errors = styles(&report.plot_errors().unwrap().unwrap());
    assert!(
        errors
            .iter()
            .all(|(name, colour, _)| !name.starts_with("tracer") || *colour == x.1)
    );
}
