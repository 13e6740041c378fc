//! Pictures of real mechanisms over their whole range: no link stretches, sliders stay on their guides, the frame stays.

mod eye_needle {
    include!("../../mechanisms/eye_needle.rs");
}
mod favorit {
    include!("../../mechanisms/favorit.rs");
}
mod headings;
mod placed;
mod spatial_crank_rocker {
    include!("../../mechanisms/spatial_crank_rocker.rs");
}
mod two_crank_triad {
    include!("../../mechanisms/two_crank_triad.rs");
}

use linkage::{GuideOn, PointKind, Table};

/// Steps over the range.
const STEPS: usize = 361;

/// One position of a picture.
struct Shape<'a> {
    table: &'a dyn Table,
    row: usize,
}

impl Shape<'_> {
    fn vector(&self, index: usize) -> Vec<f64> {
        let columns = self.table.heading().picture.expect("a picture");
        let count = columns.picture.dimension;
        let first = columns.first + index * count;
        (first..first + count)
            .map(|column| self.table.column(column)[self.row])
            .collect()
    }

    fn difference(&self, a: usize, b: usize) -> Vec<f64> {
        let (a, b) = (self.vector(a), self.vector(b));
        b.iter().zip(&a).map(|(b, a)| b - a).collect()
    }
}

fn norm(v: &[f64]) -> f64 {
    v.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

/// Everything that a picture says of itself.
#[track_caller]
fn expect_rigid(table: &dyn Table, size: f64) {
    let picture = table.heading().picture.expect("a picture").picture;
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * size;
    let start = Shape { table, row: 0 };
    let mut moved = 0.0_f64;
    for row in 0..table.rows() {
        let now = Shape { table, row };
        for link in picture.links {
            let pairs = link
                .points
                .iter()
                .flat_map(|&a| link.points.iter().map(move |&b| (a, b)));
            for (a, b) in pairs {
                let (first, own) = (norm(&start.difference(a, b)), norm(&now.difference(a, b)));
                assert!(
                    near(first, own),
                    "{} stretches from {first} to {own} in row {row}",
                    link.name
                );
            }
        }
        for (index, point) in picture.points.iter().enumerate() {
            let away = start
                .vector(index)
                .iter()
                .zip(now.vector(index))
                .map(|(a, b)| (a - b).abs())
                .sum();
            match point.kind {
                PointKind::Ground => assert!(near(away, 0.0), "{} moves", point.name),
                _ => moved = moved.max(away),
            }
        }
        for guide in picture.guides {
            let along = now.vector(picture.points.len() + guide.direction);
            assert!((norm(&along) - 1.0).abs() < 1e-12, "{}", guide.name);
            let arm = now.difference(guide.origin, guide.slider);
            let across: Vec<f64> = arm
                .iter()
                .zip(&along)
                .map(|(x, d)| x - dot(&arm, &along) * d)
                .collect();
            assert!(near(norm(&across), 0.0), "{} leaves its guide", guide.name);
            match guide.on {
                GuideOn::Frame => assert!(near(
                    norm(&start.vector(guide.origin)),
                    norm(&now.vector(guide.origin))
                )),
                GuideOn::Itself => {}
                GuideOn::Link(link) => {
                    for &point in picture.links[link].points {
                        let place = |shape: &Shape| {
                            let along = shape.vector(picture.points.len() + guide.direction);
                            dot(&shape.difference(point, guide.origin), &along)
                        };
                        assert!(
                            near(place(&start), place(&now)),
                            "{} leaves its link",
                            guide.name
                        );
                    }
                }
            }
        }
        for axis in picture.axes {
            let along = now.vector(picture.points.len() + axis.direction);
            assert!((norm(&along) - 1.0).abs() < 1e-12);
        }
    }
    assert!(moved > 0.01 * size, "nothing moves");
}

fn names(table: &dyn Table) -> (Vec<&'static str>, Vec<String>) {
    let picture = table.heading().picture.expect("a picture").picture;
    let points = picture.points.iter().map(|point| point.name).collect();
    let link = |link: &linkage::PictureLink| {
        let names: Vec<&str> = link
            .points
            .iter()
            .map(|&k| picture.points[k].name)
            .collect();
        format!("{}: {}", link.name, names.join(" "))
    };
    (points, picture.links.iter().map(link).collect())
}

#[test]
fn favorit() {
    let linkage = favorit::Favorit::default()
        .assemble()
        .expect("it assembles");
    let table = linkage.picture_sweep(&favorit::Favorit::INPUTS[0].positions(STEPS));
    expect_rigid(&table, 300.0);
    let (points, links) = names(&table);
    assert_eq!(
        points,
        [
            "pivot_1", "p2", "p3", "pivot_4", "p5", "p6", "pivot_7", "p8", "p9", "p10"
        ]
    );
    assert_eq!(
        links,
        [
            "l12: pivot_1 p2",
            "l23: p2 p3",
            "l34: pivot_4 p5 p6 p3",
            "l78: pivot_7 p8",
            "l89: p8 p9",
            "l910: p9 p10"
        ]
    );
    let guide = favorit::Favorit::PICTURE.guides[0];
    assert_eq!(
        (guide.name, guide.on, points[guide.slider]),
        ("slide", GuideOn::Link(2), "p9")
    );

    // The picture has the needle where the function has it.
    let needle = linkage.needle(1.0).p10;
    let shape = linkage.picture(1.0).shape;
    assert!((shape[9] - needle).norm() < 1e-12);
}

#[test]
fn eye_needle() {
    let linkage = eye_needle::EyeNeedle::default()
        .assemble()
        .expect("it assembles");
    let table = linkage.picture_sweep(&eye_needle::EyeNeedle::INPUTS[0].positions(STEPS));
    expect_rigid(&table, 600.0);
    let (_, links) = names(&table);
    assert_eq!(
        links,
        [
            "l12: l12/frame p2",
            "l23: p2 p3",
            "l34: p3 p4 p5",
            "l57: p7 p8 p5",
            "l46: p6 p4"
        ]
    );
}

#[test]
fn two_crank_triad() {
    let linkage = two_crank_triad::TwoCranks::default()
        .assemble()
        .expect("it assembles");
    let table = linkage.picture_sweep(&two_crank_triad::TwoCranks::INPUTS[0].positions(STEPS));
    expect_rigid(&table, 150.0);
    let guide = two_crank_triad::TwoCranks::PICTURE.guides[0];
    assert_eq!((guide.name, guide.on), ("s", GuideOn::Frame));
}

#[test]
fn spatial_crank_rocker() {
    use spatial_crank_rocker::SpatialCrankRocker;
    let linkage = SpatialCrankRocker::default()
        .assemble()
        .expect("it assembles");
    let table = linkage.picture_sweep(&SpatialCrankRocker::INPUTS[0].positions(STEPS));
    expect_rigid(&table, 250.0);
    let (_, links) = names(&table);
    assert_eq!(links, ["l12: l12/frame p2", "l43: p4 p3", "l23: p2 tip p3"]);
    assert_eq!(SpatialCrankRocker::PICTURE.axes.len(), 2);
}
