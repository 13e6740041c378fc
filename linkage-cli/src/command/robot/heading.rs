//! What both formats say of a model: its name, the joint that drives, remarks.

use super::coordinates::Coordinate;
use super::coupling::Coupling;

/// A range of an angle this near to a turn has no ends.
pub(super) const TURN: f64 = 1e-9;

/// The joint that drives.
pub(super) struct Driver {
    pub(super) name: String,
    /// Its value at the reference in formats that can shift it.
    pub(super) zero: f64,
    /// Its limits from the reference; none for full turns.
    pub(super) limits: Option<[f64; 2]>,
}

/// The name of a model, and remarks at its beginning.
pub(super) struct Heading {
    pub(super) name: String,
    pub(super) driver: Driver,
    pub(super) remarks: Vec<String>,
}

impl Heading {
    /// The degree and the error of a coupling.
    pub(super) fn remark(&self, coordinate: &Coordinate, coupling: &Coupling) -> String {
        let name = &coordinate.name;
        let unit = if coordinate.is_length() { "m" } else { "rad" };
        match coupling.coefficients.len() {
            0 => format!("{name} stands still"),
            terms => format!(
                "{name}: degree {}, error at most {:.3e} {unit}",
                terms - 1,
                coupling.error
            ),
        }
    }
}
