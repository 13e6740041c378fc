//! Names of dimensions and types in messages.

use std::fmt::{self, Display, Formatter};

use super::dimension::Dimension;
use super::value_type::Type;

/// Halves of length, force and time; with its article, and in the plural.
type Known = ((i32, i32, i32), &'static str, &'static str);

const KNOWN: [Known; 16] = [
    ((0, 0, 0), "a number", "numbers"),
    ((2, 0, 0), "a length", "lengths"),
    ((0, 0, 2), "a time", "times"),
    ((0, 0, -2), "a frequency", "frequencies"),
    ((2, 0, -2), "a speed", "speeds"),
    ((2, 0, -4), "an acceleration", "accelerations"),
    ((0, 2, 0), "a force", "forces"),
    ((2, 2, 0), "a moment", "moments"),
    ((2, 2, -2), "a power", "powers"),
    ((-2, 2, 4), "a mass", "masses"),
    ((2, 2, 4), "a moment of inertia", "moments of inertia"),
    ((-2, 2, 0), "a stiffness", "stiffnesses"),
    ((-2, 2, 2), "a damping", "dampings"),
    ((2, 2, 2), "a damping of rotation", "dampings of rotation"),
    ((-4, 2, 0), "a pressure", "pressures"),
    ((0, 0, -4), "a frequency squared", "frequencies squared"),
];

const KNOWN_ANGLES: [Known; 3] = [
    ((0, 0, 0), "an angle", "angles"),
    ((0, 0, -2), "an angular speed", "angular speeds"),
    (
        (0, 0, -4),
        "an angular acceleration",
        "angular accelerations",
    ),
];

impl Dimension {
    fn known(self) -> Option<&'static Known> {
        let angles = KNOWN_ANGLES.iter().filter(|_| self.angle);
        angles
            .chain(&KNOWN)
            .find(|(powers, ..)| *powers == self.powers())
    }

    /// In the plural, for the components of a vector.
    fn plural(self) -> String {
        self.known()
            .map_or_else(|| self.product(), |(.., plural)| (*plural).to_owned())
    }

    /// `force*length^-1`; `mass*length`, if it was given in kilograms and no power of time remains.
    fn product(self) -> String {
        let masses = if self.half_times == 2 * self.half_forces {
            self.half_kilograms.clamp(0, self.half_forces.max(0))
        } else {
            0
        };
        let powers = [
            ("mass", masses),
            ("force", self.half_forces - masses),
            ("length", self.half_lengths + masses),
            ("time", self.half_times - 2 * masses),
        ];
        let factors: Vec<String> = powers
            .into_iter()
            .filter(|(_, halves)| *halves != 0)
            .map(|(word, halves)| raised(word, halves))
            .collect();
        factors.join("*")
    }
}

/// A word and its power, given in halves: `mm`, `mm^2`, `mm^(1/2)`.
pub(in crate::model) fn raised(word: &str, halves: i32) -> String {
    match halves {
        2 => word.to_owned(),
        _ if halves % 2 == 0 => format!("{word}^{}", halves / 2),
        _ => format!("{word}^({halves}/2)"),
    }
}

/// With its article: `a number`, `an angle`, `a force`, `a length^2`.
impl Display for Dimension {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self.known() {
            Some((_, singular, _)) => f.write_str(singular),
            None => write!(f, "a {}", self.product()),
        }
    }
}

/// With its article: `a length`, `a plane vector of lengths`.
impl Display for Type {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        match self {
            Type::Scalar(dimension) => write!(f, "{dimension}"),
            Type::Vector(3, dimension) => write!(f, "a space vector of {}", dimension.plural()),
            Type::Vector(_, dimension) => write!(f, "a plane vector of {}", dimension.plural()),
            Type::Array(entries) if entries.len() == 1 => f.write_str("an array of 1 entry"),
            Type::Array(entries) => write!(f, "an array of {} entries", entries.len()),
            Type::Frame => f.write_str("a frame"),
            Type::PlaneFrame => f.write_str("a frame of the plane"),
            Type::Zero(1) => f.write_str("zero"),
            Type::Zero(3) => f.write_str("a space vector of zeros"),
            Type::Zero(_) => f.write_str("a plane vector of zeros"),
            Type::Error => f.write_str("an error"),
        }
    }
}
