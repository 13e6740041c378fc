//! The programs of a coupled group.

use alloc::vec::Vec;
use linkage_core::numeric::continuation::{Correction, Residuals, Step};

/// The programs of a group.
pub trait CoupledPrograms: Residuals {
    /// The coefficients of the polynomial system at the inputs `x`, real and imaginary part.
    fn system(&mut self, x: &[f64]) -> Vec<[f64; 2]>;

    /// The unknowns with start estimates: cosine and sine of an angle; a length, and the factor
    /// that brings it to the size of the default mechanism, for which the estimates are.
    fn placed(&mut self, x: &[f64], state: &[f64]) -> Vec<[f64; 2]>;

    /// The state where the unknowns are estimated, of a group that is followed from there.
    fn estimate(&mut self, _x: &[f64]) -> Vec<f64> {
        Vec::new()
    }

    /// The left sides of the loops without the right ones in a state, by component, of a group that
    /// is followed; then those of the loops that make its bodies rigid.
    fn missed(&mut self, _x: &[f64], _state: &[f64]) -> Vec<f64> {
        Vec::new()
    }
}

/// The programs of mechanisms without coupled groups: there are none.
#[derive(Clone, Copy, Debug)]
pub enum NoPrograms {}

impl Correction for NoPrograms {
    fn correct(&mut self, _x: &[f64], _state: &mut [f64]) -> Step {
        match *self {}
    }
}

impl Residuals for NoPrograms {}

impl CoupledPrograms for NoPrograms {
    fn system(&mut self, _x: &[f64]) -> Vec<[f64; 2]> {
        match *self {}
    }

    fn placed(&mut self, _x: &[f64], _state: &[f64]) -> Vec<[f64; 2]> {
        match *self {}
    }
}
