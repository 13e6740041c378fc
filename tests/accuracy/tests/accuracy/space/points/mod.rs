//! An unknown point at given distances from known points, or in known planes.

mod one_distance;
pub(crate) mod three_distances;
mod two_distances;

use crate::space::direction;
use linkage_reference::{Big, Output, Position, Random, Space};
use nalgebra::{Matrix3, Vector3};

/// The input at the reference, in every mechanism of this module.
const PHI: f64 = 30.0 * core::f64::consts::PI / 180.0;

/// The end of a crank that turns about the y axis.
fn pin(p: &Position) -> Space {
    let pin = p.polar("crank", "phi");
    Space::new(pin.x, 0.0, -pin.y)
}

fn pin_of(crank: f64) -> Vector3<f64> {
    crank * Vector3::new(PHI.cos(), 0.0, -PHI.sin())
}

fn distance(p: &Position, from: &Space, length: &str) -> Big {
    (p.space("p") - from.clone()).norm() - p.value(length)
}

/// By how much the point misses a plane, as a length.
fn plane(p: &Position, normal: &str, height: &str) -> Big {
    p.space("p").dot(&p.space(normal)) - p.value(height)
}

fn outputs(p: &Position) -> Vec<Output> {
    p.space("p").components().map(Output::Value).to_vec()
}

/// The plane of the points whose distances from two known points have the given difference of
/// squares: normal and offset.
fn radical([one, two]: [(&Space, &Big); 2]) -> (Space, Big) {
    let square = |v: &Space, length: &Big| v.dot(v) - length * length;
    let offset = square(two.0, two.1) - square(one.0, one.1);
    ((two.0.clone() - one.0.clone()), offset * 0.5)
}

/// Three random directions (of distances or of normals) from which a point is found in the given
/// assembly mode: the sign of their determinant.
fn directions(random: &mut Random, sign: f64) -> [Vector3<f64>; 3] {
    let all = [0; 3].map(|_| direction(random));
    let determinant = Matrix3::from_columns(&all).determinant();
    if determinant * sign < 0.0 {
        all.map(|v| -v)
    } else {
        all
    }
}
