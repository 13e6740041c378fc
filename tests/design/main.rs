//! Searches of dimensions: wishes with their derivatives, what must hold, messages.

mod derivatives;
mod evenly;
mod interruptions;
mod judge;
mod known;
mod messages;
mod reach;
mod reproducible;
mod seeds;
mod space;
mod verified;
mod whole;

use linkage::design::{Design, Relation};
use linkage::mechanism;

mechanism! {
    /// A four-bar with a coupler point, and a frame that may stand anywhere.
    pub struct FourBar {
        unit mm;
        param frame = 40mm;
        param crank = 15mm;
        param coupler = 35mm;
        param rocker = 30mm;
        param arm = (20mm, 10mm);
        param base = (0mm, 0mm);
        param tilt = 0deg;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        let a = base + polar(crank, phi + tilt);
        loop a + polar(coupler, theta) = base + polar(frame, tilt) + polar(rocker, psi);
        let tracer = a + rotate(arm, theta);
    }
    impl FourBar {
        /// A point with its derivatives.
        pub fn path(phi) -> Path { tracer, v: velocity(tracer), s: sensitivity(tracer) }
        /// A pose.
        pub fn pose(phi) -> Pose {
            tracer, theta,
            v: velocity(tracer), w: velocity(theta),
            s: sensitivity(tracer), t: sensitivity(theta),
        }
        /// A velocity as a quantity.
        pub fn speed(phi) -> Speed {
            v: velocity(psi), a: acceleration(psi), s: sensitivity(velocity(psi)), psi,
        }
        /// The velocity of the point as a quantity.
        pub fn going(phi) -> Going {
            v: velocity(tracer), a: acceleration(tracer), s: sensitivity(velocity(tracer)), tracer,
        }
        /// Without derivatives by the input, and by two parameters only.
        pub fn poor(phi) -> Poor { tracer, s: sensitivity(tracer, [crank, coupler]) }
    }
}

/// The lengths.
const LENGTHS: [&str; 4] = ["frame", "crank", "coupler", "rocker"];

type FourBarDesign<'a> = Design<'a, FourBar, FourBarAssembly, 9>;

/// A problem of the four-bar in which nothing varies.
fn problem_of_nothing<'a>() -> FourBarDesign<'a> {
    let design = Design::new(
        FourBar::default(),
        FourBar::assemble,
        FourBar::assemblies,
        FourBar::circuits,
    );
    design.expect("it assembles")
}

/// A problem of the four-bar, without a wish.
fn problem<'a>() -> FourBarDesign<'a> {
    let design = problem_of_nothing().hold(Relation::crank_turns(LENGTHS, 0.0));
    LENGTHS
        .iter()
        .fold(design, |design, name| design.vary(name, 5.0, 60.0))
}

/// The coupler point of the declared mechanism at some inputs.
fn points(inputs: &[f64]) -> Vec<[f64; 2]> {
    let linkage = FourBar::default().assemble().expect("it assembles");
    inputs
        .iter()
        .map(|&phi| linkage.path(phi).tracer.into())
        .collect()
}

/// Inputs that are evenly spaced from a first one.
fn evenly(first: f64, step: f64, count: usize) -> Vec<f64> {
    (0..count).map(|i| first + step * i as f64).collect()
}
