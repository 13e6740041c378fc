//! Newton-Raphson on K1's loop, written by hand for this loop: two unknowns, Cramer's rule with one division, the crank's sine and
//! cosine taken once, a fixed number of iterations. It begins at the position before, or where rates at the position before say that the
//! links have got to. Once by the links' angles, as is usual, once by the coupler's vector, which needs no sine.

use crate::plain::{K1, Placed};
use crate::{Motion, Position, Sensitivities1};

/// What is iterated.
pub trait Unknowns: Copy {
    /// From a position that is known.
    fn of(at: &Placed) -> Self;

    /// Where they get to when the crank turns by `step`, from the rates of the coupler at the position `at`.
    fn moved(self, k1: &K1, at: &Placed, rates: [f64; 2], step: f64) -> Self;

    /// One iteration.
    fn improved(self, k1: &K1, pin: [f64; 2]) -> Self;

    /// Vectors of coupler and rocker.
    fn vectors(self, k1: &K1, pin: [f64; 2]) -> [[f64; 2]; 2];
}

/// The angles of coupler and rocker.
#[derive(Clone, Copy, Debug)]
pub struct Angles {
    coupler: f64,
    rocker: f64,
}

/// The coupler's vector.
#[derive(Clone, Copy, Debug)]
pub struct Vector([f64; 2]);

/// K1 at the position that it was last asked for.
#[derive(Clone, Copy, Debug)]
pub struct Newton<U> {
    k1: K1,
    iterations: usize,
    predicts: bool,
    phi: f64,
    unknowns: U,
    at: Placed,
    rates: [f64; 2],
}

#[inline(always)]
fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

#[inline(always)]
fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// A vector of this length and angle.
#[inline(always)]
fn polar(length: f64, angle: f64) -> [f64; 2] {
    let (sin, cos) = angle.sin_cos();
    [length * cos, length * sin]
}

impl Unknowns for Angles {
    fn of(at: &Placed) -> Self {
        Self {
            coupler: at.coupler[1].atan2(at.coupler[0]),
            rocker: at.rocker[1].atan2(at.rocker[0]),
        }
    }

    #[inline(always)]
    fn moved(self, k1: &K1, at: &Placed, [first, second]: [f64; 2], step: f64) -> Self {
        let (a, e, f) = (at.pin, at.coupler, at.rocker);
        let per_square = 1.0 / k1.rocker_squared;
        let between = dot(e, f);
        let rocker = (first * between + dot(f, a)) * per_square;
        let rocker_second =
            (second * between + first * first * at.height - cross(f, a)) * per_square;
        let half = 0.5 * step * step;
        Self {
            coupler: self.coupler + step * first + half * second,
            rocker: self.rocker + step * rocker + half * rocker_second,
        }
    }

    #[inline(always)]
    fn improved(self, k1: &K1, pin: [f64; 2]) -> Self {
        let [e, f] = self.vectors(k1, pin);
        let rest = [
            pin[0] + e[0] - k1.pivot[0] - f[0],
            pin[1] + e[1] - k1.pivot[1] - f[1],
        ];
        let inverse = 1.0 / cross(e, f);
        Self {
            coupler: self.coupler - dot(rest, f) * inverse,
            rocker: self.rocker - dot(rest, e) * inverse,
        }
    }

    #[inline(always)]
    fn vectors(self, k1: &K1, _: [f64; 2]) -> [[f64; 2]; 2] {
        [
            polar(k1.coupler, self.coupler),
            polar(k1.rocker, self.rocker),
        ]
    }
}

impl Unknowns for Vector {
    fn of(at: &Placed) -> Self {
        Self(at.coupler)
    }

    #[inline(always)]
    fn moved(self, _: &K1, _: &Placed, [first, second]: [f64; 2], step: f64) -> Self {
        let Self([x, y]) = self;
        let half = 0.5 * step * step;
        let along = 1.0 - half * first * first;
        let across = step * first + half * second;
        Self([along * x - across * y, along * y + across * x])
    }

    #[inline(always)]
    fn improved(self, k1: &K1, pin: [f64; 2]) -> Self {
        let [e, f] = self.vectors(k1, pin);
        // Half of how far both squares of lengths are off.
        let first = 0.5 * (dot(e, e) - k1.coupler * k1.coupler);
        let second = 0.5 * (dot(f, f) - k1.rocker_squared);
        let inverse = 1.0 / cross(e, f);
        Self([
            e[0] - (first * f[1] - second * e[1]) * inverse,
            e[1] - (second * e[0] - first * f[0]) * inverse,
        ])
    }

    #[inline(always)]
    fn vectors(self, k1: &K1, pin: [f64; 2]) -> [[f64; 2]; 2] {
        let Self(e) = self;
        [
            e,
            [pin[0] + e[0] - k1.pivot[0], pin[1] + e[1] - k1.pivot[1]],
        ]
    }
}

impl<U: Unknowns> Newton<U> {
    /// At the position `phi`, which it is told: a guess could lead to the other assembly.
    #[must_use]
    pub fn new(dimensions: [f64; 7], iterations: usize, predicts: bool, phi: f64) -> Self {
        let k1 = K1::new(dimensions);
        let at = k1.place(phi);
        Self {
            k1,
            iterations,
            predicts,
            phi,
            unknowns: U::of(&at),
            at,
            rates: k1.rates(&at),
        }
    }

    /// Goes to a position.
    #[inline(always)]
    fn go(&mut self, phi: f64) {
        let [direction, pin] = self.k1.crank(phi);
        let mut unknowns = self.unknowns;
        if self.predicts {
            unknowns = unknowns.moved(&self.k1, &self.at, self.rates, phi - self.phi);
        }
        for _ in 0..self.iterations {
            unknowns = unknowns.improved(&self.k1, pin);
        }
        let [coupler, rocker] = unknowns.vectors(&self.k1, pin);
        self.unknowns = unknowns;
        self.phi = phi;
        self.at = Placed {
            direction,
            pin,
            coupler,
            rocker,
            height: cross(coupler, rocker),
            along: dot(
                coupler,
                [self.k1.pivot[0] - pin[0], self.k1.pivot[1] - pin[1]],
            ),
        };
    }

    /// The point.
    #[inline(always)]
    pub fn point(&mut self, phi: f64) -> Position {
        self.go(phi);
        if self.predicts {
            self.rates = self.k1.rates(&self.at);
        }
        self.k1.point(&self.at)
    }

    /// The point with both derivatives by the input.
    #[inline(always)]
    pub fn motion(&mut self, phi: f64) -> Motion {
        self.go(phi);
        self.rates = self.k1.rates(&self.at);
        self.k1.motion_at(&self.at, self.rates)
    }

    /// The point, then its derivatives by every dimension.
    #[inline(always)]
    pub fn accuracy(&mut self, phi: f64) -> Sensitivities1 {
        self.go(phi);
        if self.predicts {
            self.rates = self.k1.rates(&self.at);
        }
        self.k1.accuracy(&self.at)
    }
}
