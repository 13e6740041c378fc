//! Gears and belts as relations between the coordinates of joints.

use linkage_engine::{Assembly, Mechanism};

use super::coordinates::Coordinate;
use super::declared::{Declared, field};
use super::driven_joints::Motion;
use super::jointed_links::Freedom;
use super::results::Values;
use super::skeleton::{CONSTANTS, Skeleton};
use super::xml::{Lines, number, numbers};

/// A factor below this part of the largest one is rounding: the coordinate is not in the relation.
const ABSENT: f64 = 1e-12;

/// Coordinates whose multiples have the sum zero.
pub(super) struct Relation {
    /// The names of the wheels' bodies.
    name: String,
    /// Indices of coordinates, each with its factor.
    terms: Vec<(usize, f64)>,
}

impl Relation {
    /// Returns the sum at values of the coordinates: zero where the wheels turn as their sizes.
    pub(super) fn sum(&self, values: &[f64]) -> f64 {
        let terms = self.terms.iter();
        terms.map(|(index, factor)| factor * values[*index]).sum()
    }
}

/// Returns the relation of each pair of wheels.
pub(super) fn relations(
    declared: &Declared,
    mechanism: &Mechanism,
    assembly: &Assembly,
    skeleton: &Skeleton,
    motion: &Motion,
) -> Vec<Relation> {
    let coordinates = &motion.coordinates;
    let Ok(function) = mechanism.function(CONSTANTS) else {
        return Vec::new();
    };
    let values = Values::of_call(mechanism, assembly, function, &[]);
    let pairs = declared.wheels.iter().enumerate();
    let relations = pairs.map(|(index, pair)| {
        let ratio = values.number(&field("ratio", index));
        let [first, second] = pair.bodies;
        let mut factors = vec![0.0; coordinates.len()];
        let turns = [(second, 1.0), (first, -ratio), (pair.carrier, ratio - 1.0)];
        for (body, factor) in turns {
            add_turn(skeleton, coordinates, body, factor, &mut factors);
        }
        let name =
            |body: Option<usize>| body.map_or("frame", |body| skeleton.links[body].name.as_str());
        Relation {
            name: format!("{}_{}", name(first), name(second)),
            terms: terms(&factors),
        }
    });
    relations.collect()
}

/// Adds a multiple of the angle of a body: the sum of all hinges between the frame and the body.
fn add_turn(
    skeleton: &Skeleton,
    coordinates: &[Coordinate],
    body: Option<usize>,
    factor: f64,
    factors: &mut [f64],
) {
    let mut next = body;
    while let Some(link) = next {
        for (coordinate, sum) in coordinates.iter().zip(factors.iter_mut()) {
            let turns = match coordinate.freedom {
                Freedom::Hinge(_) => true,
                Freedom::Slide(_) | Freedom::Ball => false,
            };
            if turns && coordinate.link == link {
                *sum += factor;
            }
        }
        next = skeleton.links[link].parent;
    }
}

/// Returns the coordinates that a relation contains.
fn terms(factors: &[f64]) -> Vec<(usize, f64)> {
    let largest = factors
        .iter()
        .fold(0.0, |most: f64, next| most.max(next.abs()));
    let factors = factors.iter().copied().enumerate();
    factors
        .filter(|(_, factor)| factor.abs() > ABSENT * largest)
        .collect()
}

/// Writes the sums of three coordinates and more as tendons of MuJoCo, which have no effect alone.
pub(super) fn write_tendons(relations: &[Relation], coordinates: &[Coordinate], lines: &mut Lines) {
    let mut sums = relations.iter().filter(|relation| relation.terms.len() > 2);
    let Some(first) = sums.next() else { return };
    lines.open("<tendon>");
    for relation in std::iter::once(first).chain(sums) {
        lines.open(&format!("<fixed name=\"{}\">", relation.name));
        for (index, factor) in &relation.terms {
            lines.line(&format!(
                "<joint joint=\"{}\" coef=\"{}\"/>",
                coordinates[*index].name,
                number(*factor)
            ));
        }
        lines.close("fixed");
    }
    lines.close("tendon");
}

/// Writes the equations of relations for MuJoCo. They hold for the changes since the reference.
pub(super) fn write_equations(
    relations: &[Relation],
    coordinates: &[Coordinate],
    lines: &mut Lines,
) {
    for relation in relations {
        let name = |index: usize| &coordinates[index].name;
        match relation.terms[..] {
            [] => {}
            [(only, _)] => lines.line(&format!(
                "<joint joint1=\"{}\" polycoef=\"0 0 0 0 0\"/>",
                name(only)
            )),
            [(first, factor), (second, other)] => lines.line(&format!(
                "<joint joint1=\"{}\" joint2=\"{}\" polycoef=\"{}\"/>",
                name(second),
                name(first),
                numbers(&[0.0, -factor / other, 0.0, 0.0, 0.0])
            )),
            _ => lines.line(&format!(
                "<tendon tendon1=\"{}\" polycoef=\"0 0 0 0 0\"/>",
                relation.name
            )),
        }
    }
}
