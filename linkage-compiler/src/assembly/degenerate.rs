//! Groups whose shape leaves an unknown open for all lengths: guides that are parallel, centres on
//! one line, a joint on its own axis.

use std::array::from_fn;

use linkage_symbolic::{Ex, SymbolId};

use crate::model::{Dimension, Type};
use crate::structure::{Form, Sphere};
use crate::vector::{Vector, cross, dot, minus, norm};

use super::assembler::Assembly;
use crate::solve::Solved;

/// Sines below this are those of parallel vectors: the margin of such a group is below the limit of
/// a dead point.
const PARALLEL: f64 = 1e-6;

/// Lengths below this share of others are zero.
const NOTHING: f64 = 1e-12;

/// A fact, and the advice.
type Reason = (String, String);

/// Returns the reason why a group is degenerate at the reference inputs.
pub(super) fn degenerate<'m>(assembly: &Assembly<'_, 'm>, solved: &Solved<'m>) -> Option<Reason> {
    match &solved.group.form {
        Form::TwoSlides { slides, guides, .. } => {
            let guides = guides.map(|guide| vector(assembly, &guide.0));
            degenerate_guides(assembly, slides, &guides, 2)
        }
        Form::ThreeSlides { slides, guides, .. } => {
            let guides = guides.map(|guide| vector(assembly, &guide.0));
            degenerate_guides(assembly, slides, &guides, 3)
        }
        Form::LinkToSlide { slide, guide, .. } => {
            degenerate_guides(assembly, &[*slide], &[vector(assembly, &guide.0)], 3)
        }
        Form::LinkToRotor {
            angle,
            cosine,
            sine,
            known,
            length,
        } => {
            let [cosine, sine, known] = [cosine, sine, known].map(|v| vector(assembly, &v.0));
            let [length] = at_reference(assembly, [*length]);
            let size = length.abs() + norm(known);
            link_to_rotor(assembly, *angle, [cosine, sine], known, size)
        }
        Form::Trigonometric { angle, a, b, c } => {
            let [a, b, c] = at_reference(assembly, [*a, *b, *c]);
            (a.hypot(b) <= NOTHING * c.abs()).then(|| unchanged_by_angle(assembly, *angle))
        }
        Form::Parallel { angle, arm, .. } => {
            let [arm] = at_reference(assembly, [*arm]);
            (arm == 0.0).then(|| unchanged_by_angle(assembly, *angle))
        }
        Form::Linear { symbol, a, b } => {
            let [a, b] = at_reference(assembly, [*a, *b]);
            (b.is_finite() && a.abs() <= NOTHING * b.abs()).then(|| {
                let name = symbol_name(assembly, *symbol);
                let fact = format!("it does not change with {name}");
                (fact, format!("look for what multiplies {name} and is zero"))
            })
        }
        Form::Point {
            coordinates,
            spheres,
            planes,
        } => {
            let missing =
                (0..3).filter(|k| coordinates.iter().all(|(_, coordinate)| coordinate != k));
            let missing = missing.map(|k| [0, 1, 2].map(|i| if i == k { 1.0 } else { 0.0 }));
            let normals = planes.iter().map(|plane| vector(assembly, &plane.normal.0));
            point(assembly, solved, spheres, normals.chain(missing).collect())
        }
        Form::TwoRotors {
            first,
            second,
            known,
        } => {
            let [known, first, second] = [known, &first.z, &second.z].map(|v| {
                let [x, y] = at_reference(assembly, v.0);
                x.hypot(y)
            });
            (known <= NOTHING * first.max(second)).then(|| {
                let fact = "its two links have one pivot".to_owned();
                let help = "look for a pivot that is written twice, or a loop that repeats another";
                (fact, help.to_owned())
            })
        }
        Form::RotorAndSlide { .. }
        | Form::SlideOnRotor { .. }
        | Form::Quadratic { .. }
        | Form::Relation { .. }
        | Form::Coupled(_) => None,
    }
}

fn unchanged_by_angle(assembly: &Assembly<'_, '_>, angle: usize) -> Reason {
    let angle = angle_name(assembly, angle);
    let fact = format!("it does not change with {angle}");
    let help = format!(
        "look for a vector that is turned by {angle} and lies along its axis, or that is zero"
    );
    (fact, help)
}

fn degenerate_guides(
    assembly: &Assembly<'_, '_>,
    slides: &[SymbolId],
    guides: &[Vector],
    components: usize,
) -> Option<Reason> {
    // The side of the loop on which a guide is written is not known: of its two signs, one is
    // shown.
    let show = |guide: Vector| {
        let first = guide.into_iter().find(|x| *x != 0.0).unwrap_or(1.0);
        direction(&guide.map(|x| x * first.signum() + 0.0)[..components])
    };
    let name = |k: usize| symbol_name(assembly, slides[k]);
    let pairs = (0..guides.len()).flat_map(|b| (0..b).map(move |a| (a, b)));
    if let Some(k) = guides.iter().position(|guide| norm(*guide) == 0.0) {
        let fact = format!("the guide of {} is {}", name(k), show(guides[k]));
        return Some((fact, "write a direction, of any length".to_owned()));
    }
    for (a, b) in pairs {
        if parallel(guides[a], guides[b]) {
            let fact = format!(
                "the guides of {} and {} are parallel, {} and {}",
                name(a),
                name(b),
                show(guides[a]),
                show(guides[b])
            );
            return Some((fact, "choose guides that are not parallel".to_owned()));
        }
    }
    let [a, b, c] = *guides else { return None };
    let sine = dot(cross(a, b), c).abs() / (norm(a) * norm(b) * norm(c));
    (sine < PARALLEL).then(|| {
        let fact = format!(
            "the guides of {}, {} and {} are parallel to one plane, {}, {} and {}",
            name(0),
            name(1),
            name(2),
            show(a),
            show(b),
            show(c)
        );
        let help = "choose guides that are not all parallel to one plane";
        (fact, help.to_owned())
    })
}

fn link_to_rotor(
    assembly: &Assembly<'_, '_>,
    angle: usize,
    [cosine, sine]: [Vector; 2],
    known: Vector,
    size: f64,
) -> Option<Reason> {
    let angle = angle_name(assembly, angle);
    if norm(cosine) <= NOTHING * size {
        let fact = format!("the joint that {angle} moves lies on the axis of {angle}");
        return Some((fact, "give it a distance from the axis".to_owned()));
    }
    let seen = dot(known, cosine).hypot(dot(known, sine)) / norm(cosine);
    (seen <= NOTHING * (size + norm(cosine))).then(|| {
            let fact = format!(
                "the other end of the link lies on the axis of {angle}, equally far from the joint at every {angle}"
            );
            (fact, "move it away from the axis".to_owned())
        })
}

fn point<'m>(
    assembly: &Assembly<'_, 'm>,
    solved: &Solved<'m>,
    spheres: &[Sphere<'m>],
    normals: Vec<Vector>,
) -> Option<Reason> {
    let centres: Vec<Vector> = spheres
        .iter()
        .map(|sphere| {
            let [factor] = at_reference(assembly, [sphere.factor]);
            vector(assembly, &sphere.known.0).map(|x| -x / factor)
        })
        .collect();
    let size = spheres
        .iter()
        .map(|sphere| at_reference(assembly, [sphere.radius])[0].abs());
    let size = size
        .chain(centres.iter().map(|c| norm(*c)))
        .fold(0.0, f64::max);
    let dimension = solved.group.unknown_dimension(assembly.algebra.mechanism);
    let show = |v: Vector| {
        let dimension = dimension.unwrap_or(Dimension::LENGTH);
        assembly.words.vector(&Type::Vector(3, dimension), &v)
    };
    if normals.iter().any(|normal| norm(*normal) == 0.0) {
        let fact = "the normal of a plane is (0, 0, 0)".to_owned();
        return Some((fact, "write a direction, of any length".to_owned()));
    }
    for (k, b) in centres.iter().enumerate() {
        if centres[..k]
            .iter()
            .any(|a| norm(minus(*a, *b)) <= NOTHING * size)
        {
            let fact = format!("two of the centres coincide, at {}", show(*b));
            return Some((
                fact,
                "choose centres that differ from each other".to_owned(),
            ));
        }
    }
    match (&centres[..], &normals[..]) {
        ([a, b, c], _) if parallel(minus(*b, *a), minus(*c, *a)) => Some((
            format!(
                "the centres {}, {} and {} lie on one line, about which the point can turn",
                show(*a),
                show(*b),
                show(*c)
            ),
            "move one of them off the line through the others".to_owned(),
        )),
        ([a, b], [n]) if parallel(minus(*b, *a), *n) => Some((
            format!(
                "the line through the centres {} and {} is perpendicular to the plane, in which the point can move on a circle",
                show(*a),
                show(*b)
            ),
            "incline the plane, or move one of the centres".to_owned(),
        )),
        ([_], [m, n]) if parallel(*m, *n) => {
            let what = match dimension.is_some_and(|d| d.half_lengths == 0) {
                true => "known directions",
                false => "planes",
            };
            let normals = match what {
                "planes" => "the planes are parallel, their normals",
                _ => "the known directions are parallel,",
            };
            Some((
                format!("{normals} {} and {}", direction(m), direction(n)),
                format!("choose {what} that are not parallel"),
            ))
        }
        _ => None,
    }
}

/// Expressions as numbers.
fn at_reference<'m, const N: usize>(assembly: &Assembly<'_, 'm>, all: [Ex<'m>; N]) -> [f64; N] {
    let numbers = assembly.machine.evaluate(&all, &assembly.nominal.inputs);
    from_fn(|k| numbers[k])
}

/// Returns two or three components as a vector; a vector of the plane is embedded in space.
fn vector<'m, const N: usize>(assembly: &Assembly<'_, 'm>, components: &[Ex<'m>; N]) -> Vector {
    let numbers = at_reference(assembly, *components);
    from_fn(|k| numbers.get(k).copied().unwrap_or(0.0))
}

pub(super) fn symbol_name(assembly: &Assembly<'_, '_>, symbol: SymbolId) -> String {
    format!("`{}`", assembly.algebra.graph.symbol(symbol).name)
}

/// The name of an unknown angle.
pub(super) fn angle_name(assembly: &Assembly<'_, '_>, angle: usize) -> String {
    symbol_name(assembly, assembly.algebra.names.angles[angle].value)
}

fn direction(v: &[f64]) -> String {
    let numbers = crate::message_format::numbers(v);
    format!("({})", numbers.join(", "))
}

fn parallel(a: Vector, b: Vector) -> bool {
    norm(cross(a, b)) < PARALLEL * norm(a) * norm(b)
}
