//! All solutions of a square system of polynomial equations.
//!
//! The loops of a group of class III or higher are polynomial equations in the unit vectors and
//! lengths of the group. Their solutions are found by following the solutions of a simple system
//! while it is changed into the given one (a homotopy). Every variable lives on its own projective
//! line, so that solutions at zero and at infinity are points like any other; the number of paths
//! is known beforehand, and a listing is given only if every path is accounted for.

mod cauchy_endgame;
mod consistency;
mod continuum;
mod endgame;
mod evaluation;
mod homotopy;
mod listing;
mod path_samples;
mod path_trace;
mod path_tracker;
mod polynomial;
mod precise;
mod projective;
mod quadratic;
mod real;
mod rough_root;
mod start_system;
mod system;

pub use super::choose_assembly::MEETING;
pub use system::{
    HIGHEST_DEGREE, Listing, MOST_PATHS, MOST_VARIABLES, System, Term, Unlisted, Variable,
};

/// A function like [`solve`].
pub type Solve = fn(&System<'_>, &[[f64; 2]]) -> Result<Listing, Unlisted>;

/// Lists the solutions of a system with these coefficients (real and imaginary part for every
/// term). The same arguments always give the same listing, bit by bit.
///
/// The equations must be real, that is, hold for the reflection of every solution as well:
/// `1/conj(u)` of a unit vector, the conjugate of a length, conjugates exchanged for a point.
///
/// # Errors
///
/// See [`Unlisted`]; the work done is bounded in every case.
///
/// # Panics
///
/// If the system is malformed: other than one coefficient for every term, other than one exponent
/// for every variable, an equation without number, a `Point` without its `Conjugate`.
// Half of the code of this crate. A function to inline is built where it is called, so that a dev
// build of a program without coupled groups has none of it. The macro always needs it, and release
// builds have it once for all builds of the program.
#[cfg_attr(all(debug_assertions, not(feature = "host")), inline)]
pub fn solve(system: &System<'_>, coefficients: &[[f64; 2]]) -> Result<Listing, Unlisted> {
    system::check_form(system, coefficients);
    let mut target = polynomial::collect(system, coefficients)?;
    let paths = start_system::count(&target)?;
    // Few sizes, so that the code is not repeated for every one.
    match target.len() {
        1 | 2 => listing::list::<2>(system.variables, &mut target, paths),
        3 => listing::list::<3>(system.variables, &mut target, paths),
        4 => listing::list::<4>(system.variables, &mut target, paths),
        _ => listing::list::<MOST_VARIABLES>(system.variables, &mut target, paths),
    }
}
