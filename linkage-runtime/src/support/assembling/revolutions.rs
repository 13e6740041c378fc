//! Centres and windings of continuous angles:
//! `angle = angle_near(.., centre + sum of winding * input)`.

use linkage_core::Scalar;

/// The centre of each angle, and the turns it makes for each turn of each input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Revolutions<C, W> {
    /// In radians.
    pub centres: C,
    /// Turns by angle and input.
    pub windings: W,
}

/// Revolutions of `A` angles with `I` inputs.
pub type ArrayRevolutions<T, const A: usize, const I: usize> = Revolutions<[T; A], [[T; I]; A]>;

impl<T: Scalar, const A: usize, const I: usize> ArrayRevolutions<T, A, I> {
    /// Those of one lane.
    #[must_use]
    pub fn lane(&self, lane: usize) -> ArrayRevolutions<f64, A, I> {
        Revolutions {
            centres: self.centres.map(|centre| centre.lane(lane)),
            windings: self.windings.map(|rates| rates.map(|one| one.lane(lane))),
        }
    }
}

/// An angle to follow.
#[derive(Clone, Copy, Debug)]
pub struct Angle {
    /// Its name.
    pub unknown: &'static str,
    /// Its value at the reference inputs, about.
    pub estimate: f64,
    /// The inputs it depends on.
    pub along: &'static [Along],
    /// The turns of each vector for a turn of each input. The angle stays within a quarter turn of
    /// their sum. `None` for a vector that turns with something else, too; empty without a closed
    /// form.
    pub phases: &'static [Option<&'static [f64]>],
}

/// The range of one input along which an angle is followed.
#[derive(Clone, Copy, Debug)]
pub struct Along {
    /// Index of the input.
    pub input: usize,
    /// Lower end; equal to the upper end where the angle is not followed along this input.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// Candidates for the winding.
    pub rates: &'static [f64],
}
