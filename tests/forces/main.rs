//! Reactions, torques and energies against Newton's and Euler's equations of all bodies, which are assembled here from plain data and share no
//! formula with the compiler; power balances; limits by hand; derivatives against differences; sweeps and other scalars.

mod body;
mod carriage;
mod closed_forms;
mod cylinder;
mod cylinders;
mod derivatives;
mod driven;
mod five_bar;
mod four_bar;
mod friction;
mod geared_lever;
mod gears;
mod guides;
mod joint;
mod loads;
mod newton_euler;
mod quick_return;
mod rollers;
mod rotor;
mod rows;
mod rssp;
mod rssr;
mod samples;
mod scissors;
mod slider_crank;
mod solution;
mod statics;
mod trees;
mod triads;
mod tripod;
mod two_dyads;
mod unbalance;
mod units;

use body::Body;
use joint::Kind;
use linkage_random::Random;
use newton_euler::Instant;
use samples::{Rate, each, energy_rate};

type Vector = nalgebra::Vector3<f64>;

/// Newtons per kilogram and mm/s^2.
const NEWTON: f64 = 1e-3;

/// A pin of the plane.
fn pin() -> Kind {
    Kind::Pin(Vector::z())
}

/// A vector of the plane in space.
fn flat(v: linkage::Vector2<f64>) -> Vector {
    Vector::new(v.x, v.y, 0.0)
}

/// A moment of inertia of the plane.
fn disc(inertia: f64) -> nalgebra::Matrix3<f64> {
    nalgebra::Matrix3::from_diagonal(&Vector::new(0.0, 0.0, inertia))
}
