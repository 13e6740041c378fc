//! The loops of the kernels as lists of links.

use super::{Angle, Length, Link, Newton, Placed};
use std::f64::consts::FRAC_PI_2;

/// K1.
pub type K1 = Newton<2, 7>;
/// K2.
pub type K2 = Newton<4, 12>;

/// The angle of an unknown.
fn unknown(index: usize) -> Angle {
    Angle {
        unknown: Some(index),
        ..Angle::default()
    }
}

/// A multiple of the input, and a constant.
fn driven(input: f64, constant: f64) -> Angle {
    Angle {
        input,
        constant,
        ..Angle::default()
    }
}

fn link(row: usize, sign: f64, dimension: usize, angle: Angle) -> Link {
    Link {
        row,
        sign,
        length: Length::Dimension(dimension),
        angle,
        placed: Placed::default(),
    }
}

/// A point given by two dimensions.
fn pivot(row: usize, sign: f64, dimension: usize) -> [Link; 2] {
    [
        link(row, sign, dimension, driven(0.0, 0.0)),
        link(row, sign, dimension + 1, driven(0.0, FRAC_PI_2)),
    ]
}

impl K1 {
    /// From the dimensions in the order of the mechanism's parameters.
    #[must_use]
    pub fn new(dimensions: [f64; 7]) -> Self {
        let crank = link(0, 1.0, 0, driven(1.0, 0.0));
        let mut loops = vec![
            crank,
            link(0, 1.0, 1, unknown(0)),
            link(0, -1.0, 2, unknown(1)),
        ];
        loops.extend(pivot(0, -1.0, 3));
        let lift = Angle {
            dimension: Some(6),
            ..unknown(0)
        };
        Self {
            dimensions,
            loops,
            path: vec![crank, link(0, 1.0, 5, lift)],
            iterations: 3,
            unknowns: [0.7, 1.4].into(),
        }
    }
}

impl K2 {
    /// From the dimensions in the order of the mechanism's parameters.
    #[must_use]
    pub fn new(dimensions: [f64; 12]) -> Self {
        let arm = Angle {
            dimension: Some(11),
            ..unknown(1)
        };
        let guide = Angle {
            constant: FRAC_PI_2,
            ..arm
        };
        let second_crank = driven(-0.5, 15f64.to_radians());
        let mut loops = vec![
            link(0, 1.0, 4, driven(1.0, 0.0)),
            link(0, 1.0, 5, unknown(0)),
            link(0, -1.0, 6, unknown(1)),
            link(2, 1.0, 8, second_crank),
            link(2, 1.0, 9, unknown(2)),
            link(2, -1.0, 7, arm),
            Link {
                length: Length::Unknown(3),
                ..link(2, -1.0, 0, guide)
            },
        ];
        loops.extend(pivot(0, -1.0, 0));
        loops.extend(pivot(2, 1.0, 2));
        loops.extend(pivot(2, -1.0, 0));
        let mut path = vec![
            link(0, 1.0, 8, second_crank),
            link(0, 1.0, 9, unknown(2)),
            link(0, -1.0, 10, guide),
        ];
        path.extend(pivot(0, 1.0, 2));
        Self {
            dimensions,
            loops,
            path,
            iterations: 3,
            unknowns: [0.84, -1.36, 2.34, 18.0].into(),
        }
    }
}
