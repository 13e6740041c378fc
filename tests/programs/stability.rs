//! Why the formulas are what they are: errors on the way to a dead point.
//!
//! Each dyad with a square root is solved by the generated code and by three textbook ways, for
//! random geometries at relative distances from 1e-1 to 1e-15 from the dead point. The errors, from
//! a reference of 154 digits, are multiples of one roundoff of the mechanism's size times the condition
//! number: what inexact data do to any formula. The generated code stays below 10 everywhere. The
//! others do so for ordinary proportions; for others they lose many digits, or find no assembly
//! where there is one.
//!
//! The picture is `target/stability.svg`; `UPDATE=1` writes it into the documents as well.

mod dyads;
mod picture;
mod textbook;

use crate::check::Check;
use crate::folders;
use dyads::{DYADS, Dyad};
use linkage_reference::{
    Big, Output, Plane, Position, ROUNDOFF, Random, Reference, System, Unknown, approach, data,
    reach_gap,
};
use picture::{Curve, Panel};
use std::error::Error;

/// What the generated code stays below.
const LIMIT: f64 = 10.0;
/// Geometries at each distance.
const GEOMETRIES: usize = 12;

/// Prints and checks everything, and draws the picture.
#[test]
fn known_answers_are_met() -> Result<(), Box<dyn Error>> {
    let panels: Vec<Panel> = DYADS.iter().map(panel).collect();
    panels.iter().for_each(print);
    let mut check = Check::default();
    for (dyad, panel) in DYADS.iter().zip(&panels) {
        println!("\n{}", panel.title);
        check.holds("linkage stays below 10", largest(&panel.curves[0]) < LIMIT);
        let failing = |curve: &&Curve| dyad.failing.contains(&curve.name);
        for curve in panel.curves.iter().filter(failing) {
            let what = format!("{} loses more than three digits, or is NaN", curve.name);
            check.holds(&what, largest(curve) > 1e3);
        }
    }
    let drawn = picture::svg(&panels, LIMIT);
    std::fs::write(folders::target("stability.svg"), &drawn)?;
    if folders::is_update() {
        std::fs::write(folders::docs("stability.svg"), &drawn)?;
    }
    check.finish()
}

fn largest(curve: &Curve) -> f64 {
    curve
        .points
        .iter()
        .fold(0.0, |most, (_, error)| f64::max(most, *error))
}

/// The largest errors of every method at every distance.
fn panel(dyad: &Dyad) -> Panel {
    let mut random = Random::new(2026);
    let mut curves: Vec<Curve> = dyad
        .methods
        .iter()
        .map(|(name, _)| Curve {
            name,
            points: Vec::new(),
        })
        .collect();
    for half_decade in 2..=30 {
        let distance = -f64::from(half_decade) / 2.0;
        let mut errors = Vec::new();
        for _ in 0..GEOMETRIES {
            let geometry = (dyad.geometry)(&mut random);
            errors.extend(errors_at(dyad, &geometry, distance));
        }
        for (index, curve) in curves.iter_mut().enumerate() {
            let largest = errors.iter().map(|errors| errors[index]).reduce(f64::max);
            curve.points.extend(largest.map(|error| (distance, error)));
        }
    }
    Panel {
        title: dyad.title,
        curves,
    }
}

/// The error of every method for a geometry that is moved to a distance of `10^power` from the dead
/// point; nothing if it does not get there.
fn errors_at(dyad: &Dyad, geometry: &[f64], power: f64) -> Option<Vec<f64>> {
    let (&input, geometry) = geometry.split_last()?;
    let (changed, factor) = dyad.towards_dead_point;
    let distance = 10f64.powf(power);
    let mut data = approach(dyad.system, geometry, input, changed, factor, distance)?;
    data.push(input);
    let answers: Vec<Vec<f64>> = dyad
        .methods
        .iter()
        .map(|(_, method)| method(&data))
        .collect();
    let finite = |answer: &&Vec<f64>| answer.iter().all(|x| x.is_finite());
    let start = answers.iter().find(finite)?;
    let mut reference = Reference::new(dyad.system, &data, start)?;
    let conditions = reference.conditions();
    let lengths: Vec<usize> = (0..reference.outputs())
        .filter(|&k| !reference.is_angle(k))
        .collect();
    let size = lengths.iter().fold(dyad.system.size(&data), |size, &k| {
        size.max(reference.value(k).abs())
    });
    let error = |answer: &Vec<f64>| {
        lengths.iter().fold(0.0, |most, &k| {
            if answer[k].is_nan() {
                return f64::INFINITY;
            }
            let unit = Big::from(size * ROUNDOFF * conditions[k]);
            f64::max(most, (reference.error(k, answer[k]) / unit).to_f64())
        })
    };
    Some(answers.iter().map(error).collect())
}

fn print(panel: &Panel) {
    println!("\n{}", panel.title);
    print!("{:<24}", "distance");
    for power in (1..=15).step_by(2) {
        print!("{:>9}", format!("1e-{power}"));
    }
    println!();
    for curve in &panel.curves {
        print!("{:<24}", curve.name);
        for power in (1..=15).step_by(2) {
            let point = curve.points.iter().find(|(x, _)| *x == -f64::from(power));
            let figure = match point.map_or(0.0, |(_, error)| *error) {
                0.0 => "-".into(),
                x if x.is_infinite() => "NaN".into(),
                x if x < 1e3 => format!("{x:.2}"),
                x => format!("{x:.0e}"),
            };
            print!("{figure:>9}");
        }
        println!();
    }
}

// The dyads as equations, for the reference.

fn given_point(p: &Position) -> Plane {
    Plane::new(p.value("x").clone(), p.value("y").clone())
}

fn nothing_turned(_: &Position) -> Big {
    Big::one()
}

/// Two links between the origin and a given point.
pub(crate) const TWO_LINKS: System = System {
    name: "two links",
    data: data! {
        length "left" 60.0, "right" 80.0, "x" 100.0, "y" 30.0;
    },
    parameters: 3,
    unknowns: &[Unknown::angle("theta", 66.0), Unknown::angle("psi", 162.0)],
    residual: |p| {
        let miss = p.polar("left", "theta") - given_point(p) - p.polar("right", "psi");
        vec![miss.x, miss.y]
    },
    further: |p| {
        let pin = p.polar("left", "theta");
        Output::lengths([pin.x, pin.y])
    },
    gap: |p| {
        let [left, right] = ["left", "right"].map(|name| p.value(name).abs());
        let distance = given_point(p).norm();
        let stretched = &left + &right - &distance;
        let folded = distance - (&left - &right).abs();
        let nearer = if stretched < folded {
            stretched
        } else {
            folded
        };
        nearer / if left < right { left } else { right } * 0.5
    },
    turned: nothing_turned,
    margin: Some(|_| linkage_reference::Big::one()),
    ..System::PLAIN
};

/// A rod between a given point and a line through the origin.
pub(crate) const ROD_AND_GUIDE: System = System {
    name: "rod and guide",
    data: data! {
        length "rod" 100.0;
        degrees "gamma" 10.0;
        length "x" 20.0, "y" 30.0;
    },
    unknowns: &[Unknown::angle("theta", -5.0), Unknown::slide("s", 121.0)],
    residual: |p| {
        let slider = p.direction("gamma").times(p.slide("s"));
        let miss = given_point(p) + p.polar("rod", "theta") - slider;
        vec![miss.x, miss.y]
    },
    further: |_| Vec::new(),
    gap: |p| reach_gap(p.value("rod"), &p.direction("gamma").cross(&given_point(p))),
    ..TWO_LINKS
};

/// A given point on a line that turns with a link.
pub(crate) const TURNING_GUIDE: System = System {
    name: "turning guide",
    data: data! {
        length "offset" 30.0;
        degrees "beta" 60.0;
        length "x" 80.0, "y" 40.0;
    },
    unknowns: &[Unknown::angle("psi", 10.0), Unknown::slide("s", 71.0)],
    residual: |p| {
        let miss = corner(p) + p.direction("psi").times(p.slide("s")) - given_point(p);
        vec![miss.x, miss.y]
    },
    further: |p| {
        let corner = corner(p);
        Output::lengths([corner.x, corner.y])
    },
    gap: |p| reach_gap(&given_point(p).norm(), &p.polar("offset", "beta").y),
    ..TWO_LINKS
};

fn corner(p: &Position) -> Plane {
    p.polar("offset", "psi").turned(&p.direction("beta"))
}
