//! Names in drawings keep clear of what is drawn, at positions over the whole range.

use crate::JOBS;
use roxmltree::{Document, Node};
use std::error::Error;

type Place = [f64; 2];

/// Average width of a letter, height of letters above their line and below it, in millimetres.
const LETTER: f64 = 1.9;
const LETTERS: Place = [2.3, 0.7];
/// Distance of the places of a name that are looked at.
const STEP: f64 = 0.35;

/// Something that is drawn: a polygon, a bar, or a circle, with half the width of its stroke.
struct Solid {
    what: String,
    corners: Vec<Place>,
    half: f64,
}

impl Solid {
    /// Whether its box reaches into an area: most are far from most names.
    fn near(&self, [left, top, right, bottom]: [f64; 4]) -> bool {
        let out = |axis: usize, low: f64, high: f64| {
            let own = || self.corners.iter().map(|corner| corner[axis]);
            own().all(|x| x < low - self.half) || own().all(|x| x > high + self.half)
        };
        !out(0, left, right) && !out(1, top, bottom)
    }

    fn has(&self, place: Place) -> bool {
        let next = self.corners.iter().cycle().skip(1);
        let sides: Vec<(Place, Place)> = self.corners.iter().copied().zip(next.copied()).collect();
        let turns = sides
            .iter()
            .map(|(a, b)| (b[0] - a[0]) * (place[1] - a[1]) - (b[1] - a[1]) * (place[0] - a[0]));
        let turns: Vec<f64> = turns.collect();
        let inside = self.corners.len() > 2
            && (turns.iter().all(|turn| *turn > 0.0) || turns.iter().all(|turn| *turn < 0.0));
        inside || sides.iter().any(|side| apart(place, *side) < self.half)
    }
}

fn apart(place: Place, (a, b): (Place, Place)) -> f64 {
    let (u, v) = (b[0] - a[0], b[1] - a[1]);
    let square = u * u + v * v;
    let along = (place[0] - a[0]) * u + (place[1] - a[1]) * v;
    let part = if square > 0.0 {
        (along / square).clamp(0.0, 1.0)
    } else {
        0.0
    };
    (place[0] - a[0] - part * u).hypot(place[1] - a[1] - part * v)
}

fn number(node: Node<'_, '_>, name: &str) -> f64 {
    let value = node.attribute(name).and_then(|text| text.parse().ok());
    value.unwrap_or(0.0)
}

fn is(node: &Node<'_, '_>, classes: &[&str]) -> bool {
    let own = node.attribute("class").unwrap_or_default();
    own.split(' ').any(|class| classes.contains(&class))
}

/// Links, blocks, barrels, feet and joints.
fn solids(svg: &Document<'_>) -> Vec<Solid> {
    let bodies = ["link", "slider", "cylinder", "pivot"];
    let polygons = svg
        .descendants()
        .filter(|node| node.has_tag_name("polygon"));
    let polygons = polygons.filter(|node| node.ancestors().any(|above| is(&above, &bodies)));
    let polygons = polygons.filter_map(|node| {
        let corner = |pair: &str| {
            let (x, y) = pair.split_once(',')?;
            Some([x.parse().ok()?, y.parse().ok()?])
        };
        let corners = node.attribute("points")?.split(' ').map(corner);
        Some(Solid {
            what: format!("{:?}", node.parent()?.attribute("data-name")),
            corners: corners.collect::<Option<_>>()?,
            half: 0.5 * number(node, "stroke-width"),
        })
    });
    let circles = svg.descendants().filter(|node| is(node, &["point"]));
    let circles = circles.map(|node| Solid {
        what: format!("{:?}", node.attribute("data-point")),
        corners: vec![[number(node, "cx"), number(node, "cy")]],
        half: number(node, "r") + 0.5 * number(node, "stroke-width"),
    });
    polygons.chain(circles).collect()
}

/// Names with their left, top, right, bottom.
fn names<'a>(svg: &'a Document<'a>) -> Vec<(&'a str, [f64; 4])> {
    let texts = svg.descendants().filter(|node| is(node, &["name"]));
    let names = texts.filter_map(|node| {
        let words = node.text()?;
        let half = 0.5 * LETTER * words.chars().count() as f64;
        let [x, y] = ["x", "y"].map(|name| number(node, name));
        Some((words, [x - half, y - LETTERS[0], x + half, y + LETTERS[1]]))
    });
    names.collect()
}

/// What lies below names.
fn covered(svg: &str) -> Result<Vec<String>, Box<dyn Error>> {
    let svg = Document::parse(svg)?;
    let (solids, names) = (solids(&svg), names(&svg));
    assert!(!names.is_empty() && solids.len() > names.len());
    let mut found = Vec::new();
    for (index, (name, area)) in names.iter().enumerate() {
        let [left, top, right, bottom] = *area;
        for (other, to) in &names[..index] {
            if left < to[2] && to[0] < right && top < to[3] && to[1] < bottom {
                found.push(format!("`{name}` on the name `{other}`"));
            }
        }
        let steps = |from: f64, to: f64| {
            let count = ((to - from) / STEP).ceil();
            (0..=count as usize).map(move |i| from + (to - from) * i as f64 / count)
        };
        let places: Vec<Place> = steps(left, right)
            .flat_map(|x| steps(top, bottom).map(move |y| [x, y]))
            .collect();
        for solid in solids.iter().filter(|solid| solid.near(*area)) {
            if places.iter().any(|place| solid.has(*place)) {
                found.push(format!("`{name}` on {}", solid.what));
            }
        }
    }
    Ok(found)
}

#[test]
fn names_keep_clear_of_what_is_drawn() -> Result<(), Box<dyn Error>> {
    for (name, make) in JOBS {
        let report = make()?;
        let table = report.csv("picture")?;
        let inputs = table.lines().skip(1).map(|line| line.split(',').next());
        let positions: Vec<f64> = inputs.flatten().map(str::parse).collect::<Result<_, _>>()?;
        let parts = if name == "favorit" { 60 } else { 12 };
        let mut seen = 0;
        for i in 0..=parts {
            let at = positions[i * (positions.len() - 1) / parts];
            // Where it cannot be assembled there is nothing to see.
            let Ok(svg) = report.drawing()?.position(at).svg() else {
                continue;
            };
            let found = covered(&svg)?;
            assert!(found.is_empty(), "{name} at {at}: {}", found.join(", "));
            seen += 1;
        }
        assert!(2 * seen > parts, "{name} at {seen} positions");
    }
    Ok(())
}
