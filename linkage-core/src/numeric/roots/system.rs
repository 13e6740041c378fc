//! Systems of polynomial equations, and lists of their solutions.

use alloc::vec::Vec;
use core::fmt;

/// Most variables of a system.
pub const MOST_VARIABLES: usize = 8;
/// Highest degree of a variable in an equation (its highest exponent less its lowest).
pub const HIGHEST_DEGREE: usize = 12;
/// Most paths that are followed.
pub const MOST_PATHS: usize = 4096;

/// The kind of a variable, and hence its real values.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variable {
    /// A unit vector `exp(i angle)`; real where its absolute value is 1. Its exponents may be
    /// negative, and it is never 0.
    Unit,
    /// A length, best scaled to about 1; real where it is a real number.
    Length,
    /// A number, as a component of a direction; real where it is a real number. Unlike a length it
    /// has no scale.
    Number,
    /// A point `x + i y`; the next variable is its `Conjugate`. Real where the two are conjugates.
    Point,
    /// `x - i y` of the `Point` before it.
    Conjugate,
}

/// A term of an equation; its coefficient is given separately.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Term<'a> {
    /// Index of the equation.
    pub equation: usize,
    /// Exponent of every variable.
    pub exponents: &'a [i8],
}

/// The shape of a system of as many equations as variables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct System<'a> {
    /// The variables.
    pub variables: &'a [Variable],
    /// The terms of all equations, in any order.
    pub terms: &'a [Term<'a>],
}

/// The solutions of a system.
#[derive(Clone, Debug, PartialEq)]
pub struct Listing {
    /// Real and imaginary part of every variable, for every real solution; in ascending order of
    /// the first variable (by its angle from -pi to pi, or its value), then of the next ones.
    pub real: Vec<Vec<[f64; 2]>>,
    /// Multiple solutions that may be real, made real; off by up to
    /// [`MEETING`](crate::numeric::choose_assembly::MEETING), in ones and sizes of variables. No
    /// more of them than `multiple`.
    pub meeting: Vec<Vec<[f64; 2]>>,
    /// Number of isolated solutions, real and complex, in which no variable is infinite and no
    /// unit vector is 0. Multiple solutions are not counted.
    pub complex: usize,
    /// Number of paths that end in multiple solutions, or in solutions too close together to be
    /// distinguished, as next to a turning point. None of these is among `real`.
    pub multiple: usize,
    /// Number of paths that end at no real point, too far out or too close to others for
    /// coefficients of 16 digits to decide. Isolated solutions there are not counted as `complex`.
    pub blurred: usize,
    /// Number of paths followed.
    pub paths: usize,
}

/// Why the solutions of a system could not be listed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Unlisted {
    /// The system has more variables than [`MOST_VARIABLES`], or a variable has a degree above
    /// [`HIGHEST_DEGREE`].
    TooLarge {
        /// Number of variables.
        variables: usize,
        /// Highest degree of a variable in an equation.
        degree: usize,
    },
    /// The number of paths is above [`MOST_PATHS`].
    TooManyPaths {
        /// Number of paths; `u64::MAX` if there are more.
        paths: u64,
        /// Most paths that are followed.
        most: u64,
    },
    /// Some paths could not be followed to their ends without doubt, however small the steps and
    /// with twice the digits.
    Lost {
        /// Number of paths without a certain end.
        lost: usize,
        /// Number of paths followed.
        paths: usize,
    },
    /// They were not asked for: one solution is followed from an estimate.
    Followed,
    /// A coefficient is NaN or infinite.
    NotFinite,
    /// The solutions are not isolated points (or singular in several directions), or an equation
    /// does not depend on the variables.
    Degenerate,
}

impl fmt::Display for Unlisted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::TooLarge { variables, degree } => write!(
                f,
                "a system of {variables} variables and degree {degree} is too large: at most \
                 {MOST_VARIABLES} variables and degree {HIGHEST_DEGREE}"
            ),
            Self::TooManyPaths { paths, most } => {
                write!(f, "{paths} paths to follow, at most {most} are followed")
            }
            Self::Lost { lost, paths } => {
                write!(f, "{lost} of {paths} paths have no certain end")
            }
            Self::Followed => f.write_str("a solution is followed from its estimates alone"),
            Self::NotFinite => f.write_str("a coefficient is not finite"),
            Self::Degenerate => f.write_str("the solutions may not be isolated"),
        }
    }
}

impl core::error::Error for Unlisted {}

/// Panics if the system is malformed.
pub(super) fn check_form(system: &System<'_>, coefficients: &[[f64; 2]]) {
    let variables = system.variables;
    assert_eq!(
        system.terms.len(),
        coefficients.len(),
        "one coefficient for every term"
    );
    for term in system.terms {
        assert!(term.equation < variables.len(), "no such equation");
        assert_eq!(
            term.exponents.len(),
            variables.len(),
            "one exponent for every variable"
        );
    }
    for (j, &variable) in variables.iter().enumerate() {
        let point_before = j > 0 && variables[j - 1] == Variable::Point;
        assert_eq!(
            variable == Variable::Conjugate,
            point_before,
            "a point comes with its conjugate"
        );
    }
    assert_ne!(
        variables.last(),
        Some(&Variable::Point),
        "a point comes with its conjugate"
    );
}
