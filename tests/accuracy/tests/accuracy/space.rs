//! Groups in space.

mod figures;
mod joints;
mod margins;
mod points;
mod rows;
mod rssp;
mod rssr;
mod unit_vector;

use linkage_reference::{Limits, Random};
use nalgebra::Vector3;

const LIMITS: Limits = Limits::new([20.0, 10.0, 10.0], [30.0, 100.0, 100.0]);

/// A random unit vector.
fn direction(random: &mut Random) -> Vector3<f64> {
    let (height, turn) = (random.between(-1.0, 1.0), random.angle());
    let across = (1.0 - height * height).sqrt();
    Vector3::new(across * turn.cos(), across * turn.sin(), height)
}
