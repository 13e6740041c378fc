//! Reactions, torques and energies against Newton's and Euler's equations of all bodies, which are assembled here from plain data and share no
//! formula with the compiler; power balances; limits by hand; derivatives against differences; sweeps and other scalars.

mod carriage;
mod closed_forms;
mod cylinders;
mod derivatives;
mod five_bar;
mod four_bar;
mod friction;
mod gears;
mod guides;
mod joint;
mod newton_euler;
mod rollers;
mod rotor;
mod rows;
mod rssr;
mod scissors;
mod slider_crank;
mod solution;
mod statics;
mod trees;
mod tripod;
mod two_dyads;
mod units;

use joint::{Body, Kind};
use linkage::{Dimensions, Vector2};
use linkage_random::Random;
use newton_euler::Instant;

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

// Random mechanisms, speeds and loads; derivatives by inputs as motions in time.

/// Speed and acceleration of the only input.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rate {
    pub(crate) omega: f64,
    pub(crate) epsilon: f64,
}

impl Rate {
    pub(crate) fn any(random: &mut Random) -> Self {
        Self {
            omega: random.load(30.0),
            epsilon: random.load(500.0),
        }
    }

    pub(crate) const REST: Self = Self {
        omega: 0.0,
        epsilon: 0.0,
    };

    /// The same speed for ever.
    pub(crate) fn steady(self) -> Self {
        Self {
            epsilon: 0.0,
            ..self
        }
    }

    /// Velocity and acceleration of what has these derivatives by the input.
    pub(crate) fn of(self, [v, a]: [Vector; 2]) -> [Vector; 2] {
        [
            v * self.omega,
            a * (self.omega * self.omega) + v * self.epsilon,
        ]
    }

    /// A point with its derivatives, and those of the body's angle.
    pub(crate) fn plane(self, [p, v, a]: [Vector2<f64>; 3], turn: [f64; 2]) -> Body {
        let [v, a] = self.of([flat(v), flat(a)]);
        Body::new([flat(p), v, a], self.of(turn.map(|x| Vector::z() * x)))
    }

    /// A pivot on the frame.
    pub(crate) fn pivot(self, at: Vector2<f64>, turn: [f64; 2]) -> Body {
        self.plane([at, Vector2::zeros(), Vector2::zeros()], turn)
    }
}

/// Mechanisms with dimensions near the defaults and masses and stiffnesses of any proportion. `run` says whether it compared something.
#[track_caller]
pub(crate) fn each<M: Dimensions<N> + Default, const N: usize>(
    seed: u64,
    mut run: impl FnMut(M, &mut Random) -> bool,
) {
    let mut random = Random::new(seed);
    let mut compared = 0;
    for _ in 0..150 {
        let mut values = [0.0; N];
        for (value, parameter) in values.iter_mut().zip(M::default().parameters()) {
            let is_geometry = matches!(parameter.unit, "mm" | "m" | "rad" | "");
            *value = match is_geometry {
                true => parameter.nominal * random.between(0.94, 1.06),
                false => random.size(parameter.nominal),
            };
        }
        compared += usize::from(run(M::from_values(&values), &mut random));
    }
    assert!(compared >= 100, "only {compared} compared");
}

/// The rate of an energy, given by the speed: its derivative by the input is known, and it is quadratic in the speed.
pub(crate) fn energy_rate(energy: f64, by_input: f64, rate: Rate) -> f64 {
    by_input * rate.omega + 2.0 * energy / rate.omega * rate.epsilon
}
