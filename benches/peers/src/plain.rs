//! K1 in plain Rust, as an engineer writes it for speed: unit vectors, the closed form of the dyad, the loop differentiated by hand,
//! and the standard library's sine and cosine.

use crate::{Motion, Position, Sensitivities1};

/// What depends on the dimensions alone.
#[derive(Clone, Copy, Debug)]
pub struct K1 {
    pub(crate) crank: f64,
    pub(crate) coupler: f64,
    pub(crate) rocker: f64,
    pub(crate) pivot: [f64; 2],
    crank_squared: f64,
    coupler_squared: f64,
    pub(crate) rocker_squared: f64,
    /// Half of the difference of the squares of coupler and rocker.
    difference: f64,
    /// The tracer's vector over the coupler's.
    tracer: [f64; 2],
    per_coupler: f64,
    per_arm: f64,
}

/// The mechanism at a position, however it was found.
#[derive(Clone, Copy, Debug)]
pub struct Placed {
    /// The crank's direction.
    pub(crate) direction: [f64; 2],
    pub(crate) pin: [f64; 2],
    /// From the crank pin to the end of the coupler.
    pub(crate) coupler: [f64; 2],
    /// From the pivot to the same point.
    pub(crate) rocker: [f64; 2],
    /// `coupler x rocker`, also the height of the triangle times its base.
    pub(crate) height: f64,
    /// The coupler's part along the base, times the base.
    pub(crate) along: f64,
}

impl K1 {
    /// From the dimensions in the order of the mechanism's parameters.
    #[must_use]
    pub fn new([crank, coupler, rocker, dx, dy, arm, lift]: [f64; 7]) -> Self {
        let (sin, cos) = lift.sin_cos();
        Self {
            crank,
            coupler,
            rocker,
            pivot: [dx, dy],
            crank_squared: crank * crank,
            coupler_squared: coupler * coupler,
            rocker_squared: rocker * rocker,
            difference: (coupler - rocker) * (coupler + rocker) * 0.5,
            tracer: [arm * cos / coupler, arm * sin / coupler],
            per_coupler: 1.0 / coupler,
            per_arm: 1.0 / arm,
        }
    }

    /// The crank's direction and pin.
    #[inline(always)]
    pub(crate) fn crank(&self, phi: f64) -> [[f64; 2]; 2] {
        let (sin, cos) = phi.sin_cos();
        [[cos, sin], [self.crank * cos, self.crank * sin]]
    }

    /// The dyad in closed form, its end to the left of the line from crank pin to pivot.
    #[inline(always)]
    #[must_use]
    pub fn place(&self, phi: f64) -> Placed {
        let [direction, pin] = self.crank(phi);
        let base = [self.pivot[0] - pin[0], self.pivot[1] - pin[1]];
        let square = base[0] * base[0] + base[1] * base[1];
        let along = 0.5 * square + self.difference;
        let height = (self.coupler_squared * square - along * along).sqrt();
        let inverse = 1.0 / square;
        let coupler = [
            (along * base[0] - height * base[1]) * inverse,
            (along * base[1] + height * base[0]) * inverse,
        ];
        Placed {
            direction,
            pin,
            coupler,
            rocker: [coupler[0] - base[0], coupler[1] - base[1]],
            height,
            along,
        }
    }

    /// The tracer from the crank pin.
    #[inline(always)]
    fn lever(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [along, across] = self.tracer;
        [along * x - across * y, along * y + across * x]
    }

    /// The point.
    #[inline(always)]
    #[must_use]
    pub fn point(&self, at: &Placed) -> Position {
        let lever = self.lever(at.coupler);
        [at.pin[0] + lever[0], at.pin[1] + lever[1]]
    }

    /// First and second derivative of the coupler's angle by the crank's.
    #[inline(always)]
    pub(crate) fn rates(&self, at: &Placed) -> [f64; 2] {
        let (a, e, f) = (at.pin, at.coupler, at.rocker);
        let inverse = 1.0 / at.height;
        let first = (f[0] * a[1] - f[1] * a[0]) * inverse;
        let square = first * first;
        let second = f[0] * a[0] + f[1] * a[1]
            - self.crank_squared
            - square * at.along
            - 2.0 * first * (e[0] * a[0] + e[1] * a[1]);
        [first, second * inverse]
    }

    /// The point with both derivatives by the input, from [`Self::rates`].
    #[inline(always)]
    #[must_use]
    pub(crate) fn motion_at(&self, at: &Placed, [first, second]: [f64; 2]) -> Motion {
        let (a, t) = (at.pin, self.lever(at.coupler));
        let square = first * first;
        [
            a[0] + t[0],
            a[1] + t[1],
            -a[1] - first * t[1],
            a[0] + first * t[0],
            -a[0] - second * t[1] - square * t[0],
            -a[1] + second * t[0] - square * t[1],
        ]
    }

    /// The point with both derivatives by the input.
    #[inline(always)]
    #[must_use]
    pub fn motion(&self, at: &Placed) -> Motion {
        self.motion_at(at, self.rates(at))
    }

    /// The point, then its derivatives by every dimension. A dimension turns the coupler by so much.
    #[inline(always)]
    #[must_use]
    pub fn accuracy(&self, at: &Placed) -> Sensitivities1 {
        let (a, u, f, t) = (at.pin, at.direction, at.rocker, self.lever(at.coupler));
        let inverse = 1.0 / at.height;
        let by_crank = -(f[0] * u[0] + f[1] * u[1]) * inverse;
        let by_coupler = (at.along * self.per_coupler - self.coupler) * inverse;
        let by_rocker = self.rocker * inverse;
        let [by_x, by_y] = [f[0] * inverse, f[1] * inverse];
        [
            a[0] + t[0],
            a[1] + t[1],
            u[0] - by_crank * t[1],
            u[1] + by_crank * t[0],
            -by_coupler * t[1],
            by_coupler * t[0],
            -by_rocker * t[1],
            by_rocker * t[0],
            -by_x * t[1],
            by_x * t[0],
            -by_y * t[1],
            by_y * t[0],
            t[0] * self.per_arm,
            t[1] * self.per_arm,
            -t[1],
            t[0],
        ]
    }
}
