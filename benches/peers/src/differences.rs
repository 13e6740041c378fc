//! Derivatives of K1 as central differences of the generated position.

use crate::mechanisms::{K1, K1Assembly};
use crate::{Motion, Sensitivities1};
use linkage::AssemblyError;

/// Step of the first difference by the input, near the one with the smallest error.
const FIRST: f64 = 1.0 / 131_072.0;
/// Step of the second difference.
const SECOND: f64 = 1.0 / 4096.0;
/// Steps of the dimensions, relative to their size.
const RELATIVE: f64 = 1.0 / 131_072.0;

/// The linkage, and two linkages for each dimension: one with more, one with less of it.
#[derive(Clone, Debug)]
pub struct Differences1 {
    linkage: K1Assembly,
    changed: Vec<[K1Assembly; 2]>,
    factors: Vec<f64>,
}

impl Differences1 {
    /// Assembles all linkages.
    ///
    /// # Errors
    /// If one of them does not close.
    pub fn new(mechanism: &K1) -> Result<Self, AssemblyError> {
        let mut changed = Vec::new();
        let mut factors = Vec::new();
        for index in 0..7 {
            let size = if index == 6 { 1.0 } else { 128.0 };
            let step = size * RELATIVE;
            let moved = |by: f64| {
                let mut mechanism = *mechanism;
                *dimension(&mut mechanism, index) += by;
                mechanism
            };
            let (more, less) = (moved(step), moved(-step));
            // The difference that the rounded dimensions really have.
            let difference =
                *dimension(&mut more.clone(), index) - *dimension(&mut less.clone(), index);
            changed.push([more.assemble()?, less.assemble()?]);
            factors.push(1.0 / difference);
        }
        Ok(Self {
            linkage: mechanism.assemble()?,
            changed,
            factors,
        })
    }

    /// K1b by five positions.
    #[must_use]
    pub fn motion(&self, phi: f64) -> Motion {
        let at = |by: f64| self.linkage.point(phi + by).tracer;
        let here = at(0.0);
        let first = (at(FIRST) - at(-FIRST)) * (0.5 / FIRST);
        let second = (at(SECOND) - here * 2.0 + at(-SECOND)) * (1.0 / (SECOND * SECOND));
        [here.x, here.y, first.x, first.y, second.x, second.y]
    }

    /// K1c by fifteen positions.
    #[must_use]
    pub fn accuracy(&self, phi: f64) -> Sensitivities1 {
        let here = self.linkage.point(phi).tracer;
        let mut row = [here.x; 16];
        row[1] = here.y;
        for ((cells, [more, less]), factor) in row[2..]
            .chunks_exact_mut(2)
            .zip(&self.changed)
            .zip(&self.factors)
        {
            let change = (more.point(phi).tracer - less.point(phi).tracer) * *factor;
            cells.copy_from_slice(&[change.x, change.y]);
        }
        row
    }
}

fn dimension(mechanism: &mut K1, index: usize) -> &mut f64 {
    match index {
        0 => &mut mechanism.crank,
        1 => &mut mechanism.coupler,
        2 => &mut mechanism.rocker,
        3 => &mut mechanism.pivot_d.x,
        4 => &mut mechanism.pivot_d.y,
        5 => &mut mechanism.arm,
        _ => &mut mechanism.lift,
    }
}
