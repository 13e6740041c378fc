//! Groups in space.

mod figures;
mod identities;
mod joints;
mod margins;
mod parallel;
mod points;
mod rows;
mod rssp;
mod rssr;
mod scalars;
mod unit_vector;

use linkage_reference::{Limits, Random};
use nalgebra::Vector3;

const LIMITS: Limits = Limits {
    condition: 20.0,
    value: 10.0,
    margin: 10.0,
    first: 30.0,
    second: 100.0,
    third: 100.0,
};

/// A random unit vector.
fn direction(random: &mut Random) -> Vector3<f64> {
    let (height, turn) = (random.between(-1.0, 1.0), random.angle());
    let across = (1.0 - height * height).sqrt();
    Vector3::new(across * turn.cos(), across * turn.sin(), height)
}
