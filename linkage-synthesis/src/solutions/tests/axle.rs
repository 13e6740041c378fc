//! A wheel carrier on five rods, by the height of the wheel: dimensions next to those of the
//! program `five_link_axle`. For optimised code, with `LINKAGE_LONG`.

use super::super::number::Number;
use super::super::*;
use super::{cross, dot};
use std::println;

/// On the chassis and on the carrier, mm.
const INNER: [[f64; 3]; 5] = [
    [94.0, 411.0, 445.0],
    [-72.0, 428.0, 442.0],
    [277.0, 476.0, 278.0],
    [-72.0, 275.0, 234.0],
    [-204.0, 329.0, 257.0],
];
const OUTER: [[f64; 3]; 5] = [
    [15.0, -70.0, 135.0],
    [-30.0, -75.0, 140.0],
    [40.0, -60.0, -105.0],
    [-25.0, -55.0, -120.0],
    [-150.0, -70.0, -58.0],
];
/// The wheel in the reference position, mm.
const WHEEL: [f64; 3] = [0.0, 760.0, 320.0];
/// Millimetres in the unit of places.
const UNIT: f64 = 1000.0;

/// Place of the wheel in the ground plane, then two directions of the carrier.
struct Axle;

impl Equations<8> for Axle {
    fn values<T: Number>(&self, &[a, b, x1, x2, x3, y1, y2, y3]: &[T; 8]) -> [T; 8] {
        let height = T::from(WHEEL[2] / UNIT);
        let (p, x, y) = ([a, b, height], [x1, x2, x3], [y1, y2, y3]);
        let z = cross(x, y);
        let (unit, one) = (T::from(UNIT), T::from(1.0));
        core::array::from_fn(|i| match i {
            5 => dot(x, x) - one,
            6 => dot(y, y) - one,
            7 => dot(x, y),
            rod => {
                let [u, v, w] = OUTER[rod].map(T::from);
                let inner = INNER[rod].map(T::from);
                let link =
                    [0, 1, 2].map(|k| unit * p[k] + u * x[k] + v * y[k] + w * z[k] - inner[k]);
                let known: [f64; 3] =
                    core::array::from_fn(|k| WHEEL[k] + OUTER[rod][k] - INNER[rod][k]);
                T::from(1.0 / (UNIT * UNIT)) * (dot(link, link) - T::from(dot(known, known)))
            }
        })
    }
}

/// Along each rod: along the second one the test leaves a point open, with all solutions there.
#[test]
fn an_axle_has_forty_assemblies_and_the_reference_position_is_among_them() {
    if !linkage_random::is_long() {
        return;
    }
    let known = [
        WHEEL[0] / UNIT,
        WHEEL[1] / UNIT,
        1.0,
        0.0,
        0.0,
        0.0,
        1.0,
        0.0,
    ];
    for row in 0..5 {
        let found = solutions_traced(&Axle, row).expect("it has some");
        println!("{} real, {:?}", found.real.len(), found.trace);
        assert!(found.is_complete(), "{row}: {:?}", found.trace);
        assert_eq!(found.real.len() + found.complex, 40);
        let is_reference = |one: &&Solution<8>| {
            let mut pairs = one.values.iter().zip(known);
            pairs.all(|(x, known)| (x - known).abs() <= one.error + 1e-13)
        };
        assert_eq!(found.real.iter().filter(is_reference).count(), 1);
    }
}
