//! Equations between the coordinates of joints: wheels, and joints that follow others.

use super::coordinates::Coordinate;
use super::coupling::Coupling;
use super::minimax::value;
use super::wheel_relations::Relation;
use super::xml::{Lines, numbers};

/// A polynomial is exact if it misses by less than this (radians, or parts of the size).
pub(super) const EXACT: f64 = 1e-10;

/// A joint as a polynomial of another one.
pub(super) struct JointPolynomial {
    pub(super) follower: usize,
    /// The joint that it follows; none for a joint that stands still.
    pub(super) leader: Option<usize>,
    /// That of the lowest power first.
    pub(super) coefficients: Vec<f64>,
    /// The size of the mechanism for a joint that slides, else 1.
    pub(super) scale: f64,
    /// The values of the joint over the ranges of the inputs.
    pub(super) ends: [f64; 2],
}

impl JointPolynomial {
    /// Returns the distance of the joint from its polynomial, as a part of the size for a length.
    pub(super) fn miss(&self, values: &[f64]) -> f64 {
        let x = self.leader.map_or(0.0, |leader| values[leader]);
        (values[self.follower] - value(&self.coefficients, x)) / self.scale
    }
}

/// A joint that moves as an input does.
pub(super) struct Leader {
    pub(super) coordinate: usize,
    /// Its limits from the reference; none for full turns, and for the joint that drives, whose
    /// limits are in the heading.
    pub(super) limits: Option<[f64; 2]>,
}

/// The equations between coordinates.
pub(super) struct Relations {
    /// Those of wheels.
    pub(super) wheels: Vec<Relation>,
    pub(super) polynomials: Vec<JointPolynomial>,
    /// The joints of inputs, if they were looked for.
    pub(super) leaders: Vec<Leader>,
}

impl Relations {
    /// Returns the numbers that are zero where all equations hold.
    pub(super) fn sums(&self, values: &[f64]) -> Vec<f64> {
        let wheels = self.wheels.iter().map(|relation| relation.sum(values));
        let polynomials = self.polynomials.iter().map(|found| found.miss(values));
        wheels.chain(polynomials).collect()
    }

    /// Returns the polynomials as couplings with their largest possible errors.
    pub(super) fn couplings(&self) -> Vec<Coupling> {
        let found = self.polynomials.iter();
        found
            .map(|found| Coupling {
                coordinate: found.follower,
                leader: found.leader.unwrap_or(found.follower),
                coefficients: found.coefficients.clone(),
                error: EXACT * found.scale,
                ends: found.ends,
            })
            .collect()
    }

    /// Returns the limits of a joint that moves as a further input does.
    pub(super) fn limits(&self, coordinate: usize) -> Option<[f64; 2]> {
        let mut leaders = self.leaders.iter();
        leaders
            .find(|leader| leader.coordinate == coordinate)?
            .limits
    }

    pub(super) fn is_empty(&self) -> bool {
        self.wheels.is_empty() && self.polynomials.is_empty()
    }
}

/// Writes the joints that follow others for MuJoCo, each with this number of coefficients.
pub(super) fn write_polynomials(
    polynomials: &[JointPolynomial],
    coordinates: &[Coordinate],
    powers: usize,
    lines: &mut Lines,
) {
    for found in polynomials {
        let name = |index: usize| &coordinates[index].name;
        let mut coefficients = found.coefficients.clone();
        coefficients.resize(powers, 0.0);
        let leader = found
            .leader
            .map(|leader| format!(" joint2=\"{}\"", name(leader)));
        lines.line(&format!(
            "<joint joint1=\"{}\"{} polycoef=\"{}\"/>",
            name(found.follower),
            leader.unwrap_or_default(),
            numbers(&coefficients)
        ));
    }
}
