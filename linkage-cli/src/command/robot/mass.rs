//! Mass, centre and moments of inertia of a body.

use linkage_compiler::shortened;

use super::declared::{DeclaredBody, entry};
use super::metres::Metres;
use super::results::Values;
use super::space_vectors::{
    IDENTITY, Rotation, Vector, ZERO, difference, dot, product, scaled, sum, transposed,
};
use crate::failure::Failure;

/// The mass of a body with all that is fixed on it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Mass {
    pub(super) mass: f64,
    /// The centre, from the body's origin.
    pub(super) centre: Vector,
    /// About the centre, in fixed axes at the reference.
    pub(super) inertia: Rotation,
    /// True if the moments about two axes are not known and taken from the third.
    pub(super) is_completed: bool,
}

/// The directions in which the inertia of a body is declared.
#[derive(Clone, Copy)]
pub(super) struct InertiaAxes {
    /// From the axes of the body's frame to fixed ones.
    pub(super) frame: Rotation,
    /// The direction of a slender rod.
    pub(super) rod: Option<Vector>,
}

/// Returns the mass of a body, in kilograms and the unit of lengths.
pub(super) fn mass_of(
    body: &DeclaredBody,
    index: usize,
    constants: &Values,
    positions: &Values,
    axes: InertiaAxes,
) -> Result<Mass, Failure> {
    let entries: Vec<(f64, Vector)> = (0..body.mass_count())
        .map(|number| {
            let mass = entry("mass", index, number);
            expect_kilograms(body, constants.unit(&mass))?;
            let centre = positions.vector(&entry("centre", index, number));
            Ok((constants.number(&mass), centre))
        })
        .collect::<Result<_, Failure>>()?;
    let mass: f64 = entries.iter().map(|(mass, _)| mass).sum();
    let moments = entries.iter().map(|(mass, at)| scaled(*at, *mass));
    let centre = match mass == 0.0 {
        true => ZERO,
        false => scaled(moments.fold(ZERO, sum), 1.0 / mass),
    };
    let mut inertia = [ZERO; 3];
    for (mass, at) in &entries {
        add(&mut inertia, &of_point(*mass, difference(*at, centre)), 1.0);
    }
    let mut is_completed = false;
    for (number, (count, is_about_point)) in body.inertias().enumerate() {
        let name = entry("inertia", index, number);
        let numbers = (0..count).map(|component| format!("{name}_{component}"));
        let numbers: Vec<f64> = numbers
            .map(|name| {
                expect_kilograms(body, constants.unit(&name))?;
                Ok(constants.number(&name))
            })
            .collect::<Result<_, Failure>>()?;
        let tensor = tensor(&numbers, axes);
        is_completed |= numbers.len() == 1 && axes.rod.is_none();
        match is_about_point {
            false => add(&mut inertia, &tensor, 1.0),
            true => {
                // That of the whole body, its masses included.
                let at = positions.vector(&entry("about", index, number));
                inertia = tensor;
                add(&mut inertia, &of_point(mass, difference(at, centre)), -1.0);
            }
        }
    }
    Ok(Mass {
        mass,
        centre,
        inertia,
        is_completed,
    })
}

/// Masses in another unit than kilograms occur only as products of forces and times.
fn expect_kilograms(body: &DeclaredBody, unit: &str) -> Result<(), Failure> {
    match unit.is_empty() || unit.starts_with("kg") {
        true => Ok(()),
        false => Err(Failure::Told(format!(
            "a mass of `{}` is in `{}`\nhelp: write masses in kilograms or grams",
            shortened(&body.name),
            shortened(unit)
        ))),
    }
}

/// The tensor of one number, three, or nine, in fixed axes.
fn tensor(numbers: &[f64], axes: InertiaAxes) -> Rotation {
    let diagonal = |x: f64, y: f64, z: f64| [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]];
    let local = match (numbers, axes.rod) {
        (&[inertia], Some(along)) => {
            // Across a slender rod; about itself it has none.
            let across = |i: usize, j: usize| inertia * (IDENTITY[i][j] - along[i] * along[j]);
            return [0, 1, 2].map(|i| [0, 1, 2].map(|j| across(i, j)));
        }
        (&[inertia], None) => diagonal(inertia, inertia, inertia),
        (&[x, y, z], _) => diagonal(x, y, z),
        (&[a, b, c, d, e, f, g, h, i], _) => [[a, b, c], [d, e, f], [g, h, i]],
        _ => [ZERO; 3],
    };
    product(&product(&axes.frame, &local), &transposed(&axes.frame))
}

/// The inertia of a point mass at a distance.
fn of_point(mass: f64, at: Vector) -> Rotation {
    let square = dot(at, at);
    [0, 1, 2].map(|i| [0, 1, 2].map(|j| mass * (square * IDENTITY[i][j] - at[i] * at[j])))
}

fn add(sum: &mut Rotation, tensor: &Rotation, factor: f64) {
    for (row, other) in sum.iter_mut().zip(tensor) {
        for (number, other) in row.iter_mut().zip(other) {
            *number += factor * other;
        }
    }
}

/// Returns a mass in metres, its centre from an origin in metres.
pub(super) fn in_metres(mass: Mass, origin: Vector, metres: Metres) -> Mass {
    let centre = match mass.mass == 0.0 {
        true => ZERO,
        false => difference(metres.vector(mass.centre), origin),
    };
    Mass {
        centre,
        inertia: mass
            .inertia
            .map(|row| row.map(|moment| metres.square(moment))),
        ..mass
    }
}
