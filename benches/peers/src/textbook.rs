//! K1 as textbooks have it: link angles by arc functions, rates by sines and cosines of differences
//! of these angles.

use crate::{Motion, Position, Sensitivities1};

/// How the angles are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The diagonal's angle by `atan2`, the angle between diagonal and coupler by `acos`.
    ArcCosine,
    /// The tangent of half of each angle from the expanded quadratic (Freudenstein's equation).
    HalfTangent,
}

/// K1 by angles.
#[derive(Clone, Copy, Debug)]
pub struct K1 {
    method: Method,
    a: f64,
    b: f64,
    c: f64,
    dx: f64,
    dy: f64,
    p: f64,
    u: f64,
}

/// The crank pin, and the angles of coupler and rocker.
struct Angles {
    pin: [f64; 2],
    coupler: f64,
    rocker: f64,
}

impl K1 {
    /// From the dimensions in the order of the mechanism's parameters.
    #[must_use]
    pub fn new(method: Method, [a, b, c, dx, dy, p, u]: [f64; 7]) -> Self {
        Self {
            method,
            a,
            b,
            c,
            dx,
            dy,
            p,
            u,
        }
    }

    fn angles(&self, phi: f64) -> Angles {
        let (sin, cos) = phi.sin_cos();
        let pin = [self.a * cos, self.a * sin];
        let (x, y) = (self.dx - pin[0], self.dy - pin[1]);
        let square = x * x + y * y;
        match self.method {
            Method::ArcCosine => {
                let diagonal = square.sqrt();
                let (b, c) = (self.b, self.c);
                let between = ((b * b + square - c * c) / (2.0 * b * diagonal)).acos();
                let coupler = y.atan2(x) + between;
                let end = [x - b * coupler.cos(), y - b * coupler.sin()];
                let rocker = (-end[1]).atan2(-end[0]);
                Angles {
                    pin,
                    coupler,
                    rocker,
                }
            }
            Method::HalfTangent => {
                let (b, c) = (self.b, self.c);
                // x cos + y sin = k, for the coupler and, with the other sign, for the rocker.
                let k = (b * b + square - c * c) / (2.0 * b);
                let coupler = 2.0 * ((y + (square - k * k).sqrt()) / (x + k)).atan();
                let k = (b * b - square - c * c) / (2.0 * c);
                let rocker = 2.0 * ((y + (square - k * k).sqrt()) / (x + k)).atan();
                Angles {
                    pin,
                    coupler,
                    rocker,
                }
            }
        }
    }

    fn tracer(&self, angles: &Angles) -> Position {
        let (sin, cos) = (angles.coupler + self.u).sin_cos();
        [angles.pin[0] + self.p * cos, angles.pin[1] + self.p * sin]
    }

    /// K1a.
    #[must_use]
    pub fn point(&self, phi: f64) -> Position {
        self.tracer(&self.angles(phi))
    }

    /// K1b.
    #[must_use]
    pub fn motion(&self, phi: f64) -> Motion {
        let angles = self.angles(phi);
        let Angles {
            pin,
            coupler,
            rocker,
        } = angles;
        let Self { a, b, c, p, .. } = *self;
        let transmission = (coupler - rocker).sin();
        let rate = a * (rocker - phi).sin() / (b * transmission);
        let rocker_rate = a * (coupler - phi).sin() / (c * transmission);
        let second = (c * rocker_rate * rocker_rate
            - a * (phi - rocker).cos()
            - b * rate * rate * (coupler - rocker).cos())
            / (b * transmission);
        let [x, y] = self.tracer(&angles);
        let (px, py) = (p * (coupler + self.u).cos(), p * (coupler + self.u).sin());
        [
            x,
            y,
            -pin[1] - rate * py,
            pin[0] + rate * px,
            -pin[0] - second * py - rate * rate * px,
            -pin[1] + second * px - rate * rate * py,
        ]
    }

    /// K1c.
    #[must_use]
    pub fn accuracy(&self, phi: f64) -> Sensitivities1 {
        let angles = self.angles(phi);
        let Angles {
            coupler, rocker, ..
        } = angles;
        let lever = self.b * (coupler - rocker).sin();
        let [x, y] = self.tracer(&angles);
        let (sin, cos) = (coupler + self.u).sin_cos();
        let (px, py) = (self.p * cos, self.p * sin);
        let a = (phi - rocker).cos() / lever;
        let b = (coupler - rocker).cos() / lever;
        let c = -1.0 / lever;
        let (dx, dy) = (-rocker.cos() / lever, -rocker.sin() / lever);
        [
            x,
            y,
            phi.cos() - a * py,
            phi.sin() + a * px,
            -b * py,
            b * px,
            -c * py,
            c * px,
            -dx * py,
            dx * px,
            -dy * py,
            dy * px,
            cos,
            sin,
            -py,
            px,
        ]
    }
}
