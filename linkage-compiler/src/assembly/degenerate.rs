//! Groups whose shape leaves an unknown open, whatever the lengths: guides that are parallel, centres on one line, a joint
//! on its own axis.

use std::array::from_fn;

use linkage_symbolic::{Ex, SymbolId};

use crate::model::{Dimension, Type};
use crate::structure::{Form, Sphere};
use crate::vector::{Vector, cross, dot, minus, norm};

use super::reference::Assembly;
use crate::solve::Solved;

/// Sines below this are those of parallel vectors: the margin of such a group is below the limit of a dead point.
const PARALLEL: f64 = 1e-6;

/// Lengths below this share of others are zero.
const NOTHING: f64 = 1e-12;

/// A fact, and what to write.
type Reason = (String, String);

impl<'m> Assembly<'_, 'm> {
    /// What is degenerate about a group at the reference inputs.
    pub(super) fn degenerate(&self, solved: &Solved<'m>) -> Option<Reason> {
        match &solved.group.form {
            Form::TwoSlides { slides, guides, .. } => {
                let guides = guides.map(|guide| self.vector(&guide.0));
                self.guides(slides, &guides, 2)
            }
            Form::ThreeSlides { slides, guides, .. } => {
                let guides = guides.map(|guide| self.vector(&guide.0));
                self.guides(slides, &guides, 3)
            }
            Form::LinkToSlide { slide, guide, .. } => {
                self.guides(&[*slide], &[self.vector(&guide.0)], 3)
            }
            Form::LinkToRotor {
                angle,
                cosine,
                sine,
                known,
                length,
            } => {
                let [cosine, sine, known] = [cosine, sine, known].map(|v| self.vector(&v.0));
                let [length] = self.at_reference([*length]);
                let size = length.abs() + norm(known);
                self.link_to_rotor(*angle, [cosine, sine], known, size)
            }
            Form::Trigonometric { angle, a, b, c } => {
                let [a, b, c] = self.at_reference([*a, *b, *c]);
                (a.hypot(b) <= NOTHING * c.abs()).then(|| {
                    let angle = self.angle_name(*angle);
                    let fact = format!("it does not change with {angle}");
                    let help = format!(
                        "look for a vector that is turned by {angle} and lies along its axis, or that is zero"
                    );
                    (fact, help)
                })
            }
            Form::Linear { symbol, a, b } => {
                let [a, b] = self.at_reference([*a, *b]);
                (b.is_finite() && a.abs() <= NOTHING * b.abs()).then(|| {
                    let name = self.symbol_name(*symbol);
                    let fact = format!("it does not change with {name}");
                    (fact, format!("look for what multiplies {name} and is zero"))
                })
            }
            Form::Point {
                coordinates,
                spheres,
                planes,
            } => {
                let missing = (0..3).filter(|k| coordinates.iter().all(|(_, own)| own != k));
                let missing = missing.map(|k| [0, 1, 2].map(|i| if i == k { 1.0 } else { 0.0 }));
                let normals = planes.iter().map(|plane| self.vector(&plane.normal.0));
                self.point(solved, spheres, normals.chain(missing).collect())
            }
            Form::TwoRotors { .. }
            | Form::RotorAndSlide { .. }
            | Form::SlideOnRotor { .. }
            | Form::Quadratic { .. }
            | Form::Relation { .. }
            | Form::Coupled(_) => None,
        }
    }

    fn guides(&self, slides: &[SymbolId], guides: &[Vector], components: usize) -> Option<Reason> {
        // Which side of the loop a guide stands on is not known: of its two signs, one is shown.
        let show = |guide: Vector| {
            let first = guide.into_iter().find(|x| *x != 0.0).unwrap_or(1.0);
            direction(&guide.map(|x| x * first.signum() + 0.0)[..components])
        };
        let name = |k: usize| self.symbol_name(slides[k]);
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
        &self,
        angle: usize,
        [cosine, sine]: [Vector; 2],
        known: Vector,
        size: f64,
    ) -> Option<Reason> {
        let angle = self.angle_name(angle);
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

    fn point(
        &self,
        solved: &Solved<'m>,
        spheres: &[Sphere<'m>],
        normals: Vec<Vector>,
    ) -> Option<Reason> {
        let centres: Vec<Vector> = spheres
            .iter()
            .map(|sphere| {
                let [factor] = self.at_reference([sphere.factor]);
                self.vector(&sphere.known.0).map(|x| -x / factor)
            })
            .collect();
        let size = spheres
            .iter()
            .map(|sphere| self.at_reference([sphere.radius])[0].abs());
        let size = size
            .chain(centres.iter().map(|c| norm(*c)))
            .fold(0.0, f64::max);
        let dimension = solved.group.unknown_dimension(self.algebra.mechanism);
        let show = |v: Vector| {
            let dimension = dimension.unwrap_or(Dimension::LENGTH);
            self.words.vector(&Type::Vector(3, dimension), &v)
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
    fn at_reference<const N: usize>(&self, all: [Ex<'m>; N]) -> [f64; N] {
        let numbers = self.machine.evaluate(&all, &self.nominal.inputs);
        from_fn(|k| numbers[k])
    }

    /// Two or three components; a vector of the plane lies in space.
    fn vector<const N: usize>(&self, components: &[Ex<'m>; N]) -> Vector {
        let numbers = self.at_reference(*components);
        from_fn(|k| numbers.get(k).copied().unwrap_or(0.0))
    }

    pub(super) fn symbol_name(&self, symbol: SymbolId) -> String {
        format!("`{}`", self.algebra.graph.symbol(symbol).name)
    }

    /// The name of an unknown angle.
    pub(super) fn angle_name(&self, angle: usize) -> String {
        self.symbol_name(self.algebra.names.angles[angle].value)
    }
}

fn direction(v: &[f64]) -> String {
    let numbers = crate::words::numbers(v);
    format!("({})", numbers.join(", "))
}

fn parallel(a: Vector, b: Vector) -> bool {
    norm(cross(a, b)) < PARALLEL * norm(a) * norm(b)
}
