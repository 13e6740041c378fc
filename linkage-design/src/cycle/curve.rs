//! A quantity over the input, with its derivatives by input and parameters.

use std::boxed::Box;

use super::{Motion, Piece, PieceKey};
use linkage_analysis::summary;
use linkage_core::numeric::vector::dot;

type Jet<'a, A> = Box<dyn Fn(&A, f64) -> [f64; 3] + Send + Sync + 'a>;
type Slopes<'a, A, const N: usize> = Box<dyn Fn(&A, f64) -> [f64; N] + Send + Sync + 'a>;

/// A quantity of an assembly over its input, with its derivatives.
///
/// Anything with exact derivatives is one: a position, its `velocity`, an angle between links,
/// `margin()`, a torque or the size of a force.
pub struct Curve<'a, A, const N: usize> {
    jet: Jet<'a, A>,
    slopes: Slopes<'a, A, N>,
}

impl<'a, A, const N: usize> Curve<'a, A, N> {
    /// Builds a curve from two functions of an assembly and an input: the quantity with its first
    /// and second derivative by the input, and its derivatives by the parameters, `sensitivity(q)`.
    ///
    /// `velocity(q)` and `acceleration(q)` are the first two; for the curve of a velocity they are
    /// `acceleration(q)` and `jerk(q)`, and the slopes are `sensitivity(velocity(q))`.
    pub fn new(
        jet: impl Fn(&A, f64) -> [f64; 3] + Send + Sync + 'a,
        slopes: impl Fn(&A, f64) -> [f64; N] + Send + Sync + 'a,
    ) -> Self {
        Self {
            jet: Box::new(jet),
            slopes: Box::new(slopes),
        }
    }

    /// The length of a vector, such as a reaction: from the vector with its first and second
    /// derivative by the input, and its derivatives by the parameters. Where the vector is zero its
    /// length has no derivatives.
    pub fn length<const K: usize>(
        jet: impl Fn(&A, f64) -> [[f64; K]; 3] + Send + Sync + Clone + 'a,
        slopes: impl Fn(&A, f64) -> [[f64; K]; N] + Send + Sync + 'a,
    ) -> Self {
        let vector = jet.clone();
        let length = move |assembly: &A, input: f64| {
            let [f, v, a] = jet(assembly, input);
            let size = dot(&f, &f).sqrt();
            let rate = dot(&f, &v) / size;
            [size, rate, (dot(&v, &v) + dot(&f, &a) - rate * rate) / size]
        };
        let along = move |assembly: &A, input: f64| {
            let [f, ..] = vector(assembly, input);
            let size = dot(&f, &f).sqrt();
            slopes(assembly, input).map(|slope| dot(&f, &slope) / size)
        };
        Self::new(length, along)
    }

    /// The quantity and its derivatives by the input.
    pub(super) fn jet(&self, assembly: &A, input: f64) -> [f64; 3] {
        (self.jet)(assembly, input)
    }

    /// Its derivatives by the parameters.
    pub(super) fn slopes(&self, assembly: &A, input: f64) -> [f64; N] {
        (self.slopes)(assembly, input)
    }

    /// Its course over the whole range; `None` if it has gaps.
    pub(super) fn course<'s>(
        &'s self,
        motion: &'s Motion<'_, A>,
    ) -> Option<summary::Curve<3, impl Fn(f64) -> [f64; 3] + 's>> {
        let jet = |input: f64| self.jet(motion.assembly, input);
        let course = summary::Curve::new(motion.range, motion.positions, jet).ok()?;
        (!course.has_gaps()).then_some(course)
    }

    /// The piece at a place that the quantity itself chooses: a limit, or an end of the range.
    pub(super) fn piece(&self, motion: &Motion<'_, A>, at: f64, value: f64) -> Piece<N> {
        Piece {
            key: PieceKey::At(at),
            value,
            parameters: self.slopes(motion.assembly, at),
            auxiliary: std::vec::Vec::new(),
        }
    }
}
