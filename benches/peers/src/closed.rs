//! The closed forms of the kernels, written once for every number type of num-dual.
//!
//! Numbers that depend on dimensions alone have a type of their own, `K`: `f64`, where derivatives by
//! the input are wanted, costs less in every product.

use num_dual::DualNum;
use std::ops::{Add, Mul, Sub};

/// A number of num-dual.
pub trait Real: DualNum<Primitive = f64> + Copy {}
impl<D: DualNum<Primitive = f64> + Copy> Real for D {}

/// A number that may be combined with constants of the type `K`.
pub trait Over<K>:
    Real + Add<K, Output = Self> + Sub<K, Output = Self> + Mul<K, Output = Self>
{
}
impl<K, D> Over<K> for D where D: Real + Add<K, Output = D> + Sub<K, Output = D> + Mul<K, Output = D>
{}

/// A vector.
pub type Pair<D> = [D; 2];

/// Constants of K1.
#[derive(Clone, Copy, Debug)]
pub struct Constants1<K> {
    crank: K,
    pivot: Pair<K>,
    coupler_squared: K,
    /// Half of the difference of the squares of coupler and rocker.
    difference: K,
    /// The tracer's vector over the coupler's.
    tracer: Pair<K>,
}

impl<K: Real> Constants1<K> {
    /// From the dimensions in the order of the mechanism's parameters.
    #[must_use]
    pub fn new([a, b, c, dx, dy, p, u]: [K; 7]) -> Self {
        let (sin, cos) = u.sin_cos();
        Self {
            crank: a,
            pivot: [dx, dy],
            coupler_squared: b * b,
            difference: (b - c) * (b + c) * 0.5,
            tracer: [p * cos / b, p * sin / b],
        }
    }
}

/// The tracer of K1.
#[inline(always)]
pub fn point1<K: Copy, D: Over<K>>(k: &Constants1<K>, phi: D) -> Pair<D> {
    let (sin, cos) = phi.sin_cos();
    let a = [cos * k.crank, sin * k.crank];
    let base = [-(a[0] - k.pivot[0]), -(a[1] - k.pivot[1])];
    let square = base[0] * base[0] + base[1] * base[1];
    let along = square * 0.5 + k.difference;
    let across = (square * k.coupler_squared - along * along).sqrt();
    let inverse = square.recip();
    let coupler = [
        (along * base[0] - across * base[1]) * inverse,
        (along * base[1] + across * base[0]) * inverse,
    ];
    [
        a[0] + coupler[0] * k.tracer[0] - coupler[1] * k.tracer[1],
        a[1] + coupler[1] * k.tracer[0] + coupler[0] * k.tracer[1],
    ]
}

/// Constants of K2.
#[derive(Clone, Copy, Debug)]
pub struct Constants2<K> {
    main_crank: K,
    pivot_4: Pair<K>,
    /// From pivot 4 to pivot 7.
    pivots: Pair<K>,
    coupler_squared: K,
    /// Half of the difference of the squares of coupler and rocker.
    difference: K,
    /// The guide's direction over the rocker's vector.
    guide: Pair<K>,
    /// The second crank at the main crank's zero.
    second_crank: Pair<K>,
    rod_squared: K,
    needle: K,
    /// Distance of pivot 4 from the guide.
    offset: K,
}

impl<K: Real> Constants2<K> {
    /// From the dimensions in the order of the mechanism's parameters.
    #[must_use]
    pub fn new(d: [K; 12]) -> Self {
        let [
            p4x,
            p4y,
            p7x,
            p7y,
            l12,
            l23,
            l34,
            l45,
            l78,
            l89,
            l910,
            angle_345,
        ] = d;
        let (sin, cos) = (angle_345 + std::f64::consts::FRAC_PI_2).sin_cos();
        let start = std::f64::consts::PI / 12.0;
        Self {
            main_crank: l12,
            pivot_4: [p4x, p4y],
            pivots: [p7x - p4x, p7y - p4y],
            coupler_squared: l23 * l23,
            difference: (l23 - l34) * (l23 + l34) * 0.5,
            guide: [cos / l34, sin / l34],
            second_crank: [l78 * start.cos(), l78 * start.sin()],
            rod_squared: l89 * l89,
            needle: l910,
            offset: l45,
        }
    }
}

/// The needle's point of K2.
#[inline(always)]
pub fn point2<K: Copy, D: Over<K>>(k: &Constants2<K>, phi: D) -> Pair<D> {
    let (sin_half, cos_half) = (phi * 0.5).sin_cos();
    let (sin, cos) = (
        sin_half * cos_half * 2.0,
        -(sin_half * sin_half * 2.0 - 1.0),
    );
    let base = [
        -(cos * k.main_crank - k.pivot_4[0]),
        -(sin * k.main_crank - k.pivot_4[1]),
    ];
    let square = base[0] * base[0] + base[1] * base[1];
    let along = square * 0.5 + k.difference;
    let across = (square * k.coupler_squared - along * along).sqrt();
    let back = along - square;
    let inverse = square.recip();
    let rocker = [
        (back * base[0] + across * base[1]) * inverse,
        (back * base[1] - across * base[0]) * inverse,
    ];
    let guide = [
        rocker[0] * k.guide[0] - rocker[1] * k.guide[1],
        rocker[1] * k.guide[0] + rocker[0] * k.guide[1],
    ];
    let arm = [
        cos_half * k.second_crank[0] + sin_half * k.second_crank[1] + k.pivots[0],
        cos_half * k.second_crank[1] - sin_half * k.second_crank[0] + k.pivots[1],
    ];
    let along = guide[0] * arm[0] + guide[1] * arm[1];
    let distance = guide[0] * arm[1] - guide[1] * arm[0] + k.offset;
    let chord = (-(distance * distance - k.rod_squared)).sqrt();
    let needle = along - chord - k.needle;
    [
        needle * guide[0] + guide[1] * k.offset + k.pivot_4[0],
        needle * guide[1] - guide[0] * k.offset + k.pivot_4[1],
    ]
}
