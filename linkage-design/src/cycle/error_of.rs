//! The error that tolerances cause in a quantity, as a figure that a design makes small.

mod measure;

use std::boxed::Box;
use std::string::{String, ToString};
use std::vec::Vec;

use super::figures::places;
use super::{Figure, Motion, Piece, PieceKey, Pieces};
use linkage_analysis::summary::{Curve, Kind};
use linkage_analysis::tolerance::{Components, Tolerances, Uncertainties};
use measure::{Measure, Measured, Slopes};

/// The largest error that tolerances cause in a quantity, to first order: its slopes by the
/// parameters are second derivatives.
///
/// The error of a vector is the largest length of its error. It is looked for at given inputs, or
/// over [the whole range](Self::over_the_range).
///
/// ```
/// use linkage_runtime::Parameter;
/// use linkage_design::{ErrorOf, Figure, Motion, Pieces};
/// use linkage_analysis::tolerance::Tolerances;
///
/// // An arm of 100 mm that turns; its error is that of its end, from its length and its angle.
/// let parameters = [("arm", "mm", 0.1), ("zero", "rad", 0.002)];
/// let nominal = 0.0;
/// let parameters =
///     parameters.map(|(name, unit, tolerance)| Parameter { name, unit, nominal, tolerance });
/// let tolerances = Tolerances::<2>::declared(&parameters)?;
/// let slopes =
///     |arm: &f64, phi: f64| [[phi.cos(), phi.sin()], [-arm * phi.sin(), arm * phi.cos()]];
/// let second = |arm: &f64, phi: f64| {
///     let turned = [-phi.sin(), phi.cos()];
///     [[[0.0, 0.0], turned], [turned, [-arm * phi.cos(), -arm * phi.sin()]]]
/// };
/// let error = ErrorOf::worst_case(slopes, second, &tolerances, [0.5]);
/// let motion = Motion { assembly: &100.0, range: (0.0, 1.0), closed: false, positions: 2 };
/// let Some(Pieces::Largest(pieces)) = error.pieces(&motion) else { panic!() };
/// assert!((pieces[0].value - 0.1_f64.hypot(0.2)).abs() < 1e-15);
/// # Ok::<(), linkage_analysis::tolerance::ToleranceError>(())
/// ```
pub struct ErrorOf<'a, A, const N: usize> {
    slopes: By<'a, A, Slopes<N>>,
    second: By<'a, A, Vec<[[f64; N]; N]>>,
    /// The first and second derivatives of the slopes by the input.
    rates: Option<By<'a, A, [Slopes<N>; 2]>>,
    measure: Measure<N>,
    inputs: Vec<f64>,
}

/// A function of an assembly and an input.
type By<'a, A, R> = Box<dyn Fn(&A, f64) -> R + Send + Sync + 'a>;

fn by_component<V: Components<K>, const K: usize, const N: usize>(slopes: &[V; N]) -> Slopes<N> {
    let slopes = slopes.map(V::components);
    (0..K).map(|c| slopes.map(|slope| slope[c])).collect()
}

impl<'a, A, const N: usize> ErrorOf<'a, A, N> {
    /// The worst case, in which the effects of all tolerances add: at these inputs, of which the
    /// largest counts. `slopes` gives the derivatives by the parameters, `sensitivity(q)`, and
    /// `second` theirs, `sensitivity(sensitivity(q))`.
    ///
    /// That of a number is never below the worst case, and above it by no more than a thousandth of
    /// the root of the sum of squares for each parameter; that of a vector is exact, and its
    /// largest at every one of the worst corners. Where limits are not as far above the nominal
    /// dimensions as below, the error with all dimensions in the middle of their zones is a part of
    /// it.
    pub fn worst_case<V: Components<K>, const K: usize>(
        slopes: impl Fn(&A, f64) -> [V; N] + Send + Sync + 'a,
        second: impl Fn(&A, f64) -> [[V; N]; N] + Send + Sync + 'a,
        tolerances: &Tolerances<N>,
        inputs: impl IntoIterator<Item = f64>,
    ) -> Self {
        Self::new(slopes, second, Measure::WorstCase(*tolerances), inputs)
    }

    /// The root of the sum of squares of all effects: a standard deviation, if tolerances are
    /// standard deviations. It is the error about the middles of the zones.
    pub fn root_sum_square<V: Components<K>, const K: usize>(
        slopes: impl Fn(&A, f64) -> [V; N] + Send + Sync + 'a,
        second: impl Fn(&A, f64) -> [[V; N]; N] + Send + Sync + 'a,
        tolerances: &Tolerances<N>,
        inputs: impl IntoIterator<Item = f64>,
    ) -> Self {
        let mut squares = [[0.0; N]; N];
        for (k, tolerance) in tolerances.values().into_iter().enumerate() {
            squares[k][k] = tolerance * tolerance;
        }
        let title = "root sum square of errors";
        Self::new(slopes, second, Measure::Deviation(title, squares), inputs)
    }

    /// The standard uncertainty, correlations of the dimensions taken into account; of a vector the
    /// root of the trace of its covariance.
    pub fn standard<V: Components<K>, const K: usize>(
        slopes: impl Fn(&A, f64) -> [V; N] + Send + Sync + 'a,
        second: impl Fn(&A, f64) -> [[V; N]; N] + Send + Sync + 'a,
        uncertainties: &Uncertainties<N>,
        inputs: impl IntoIterator<Item = f64>,
    ) -> Self {
        let covariance = uncertainties.covariance_matrix();
        let measure = Measure::Deviation("standard uncertainty", covariance);
        Self::new(slopes, second, measure, inputs)
    }

    fn new<V: Components<K>, const K: usize>(
        slopes: impl Fn(&A, f64) -> [V; N] + Send + Sync + 'a,
        second: impl Fn(&A, f64) -> [[V; N]; N] + Send + Sync + 'a,
        measure: Measure<N>,
        inputs: impl IntoIterator<Item = f64>,
    ) -> Self {
        let components = move |assembly: &A, input: f64| {
            let second = second(assembly, input).map(|row| row.map(V::components));
            let of = |c: usize| second.map(|row| row.map(|slope| slope[c]));
            (0..K).map(of).collect()
        };
        Self {
            slopes: Box::new(move |assembly, input| by_component(&slopes(assembly, input))),
            second: Box::new(components),
            rates: None,
            measure,
            inputs: inputs.into_iter().collect(),
        }
    }

    /// The largest error over the whole range, too, where it is a root of its derivative by the
    /// input: `rates` gives the first and second derivatives of the slopes by the input,
    /// `sensitivity(velocity(q))` and `sensitivity(acceleration(q))`.
    #[must_use]
    pub fn over_the_range<V: Components<K>, const K: usize>(
        self,
        rates: impl Fn(&A, f64) -> [[V; N]; 2] + Send + Sync + 'a,
    ) -> Self {
        let rates = move |assembly: &A, input: f64| {
            let [first, second] = rates(assembly, input);
            [by_component(&first), by_component(&second)]
        };
        Self {
            rates: Some(Box::new(rates)),
            ..self
        }
    }

    fn piece(&self, assembly: &A, input: f64, key: PieceKey, measured: &Measured<N>) -> Piece<N> {
        let second = (self.second)(assembly, input);
        let pairs = || measured.weights.iter().zip(&second);
        let of = |weights: &[f64; N], second: &[[f64; N]; N], j: usize| -> f64 {
            (0..N).map(|k| weights[k] * second[k][j]).sum()
        };
        let along = |j: usize| {
            pairs()
                .map(|(weights, second)| of(weights, second, j))
                .sum()
        };
        Piece {
            key,
            value: measured.value,
            parameters: core::array::from_fn(along),
            auxiliary: Vec::new(),
        }
    }

    /// The figures at a given input, of which the largest counts.
    fn pieces_at_input(&self, assembly: &A, nth: usize, input: f64) -> Vec<Piece<N>> {
        let all = self.measure.candidates(&(self.slopes)(assembly, input));
        let piece = |measured: &Measured<N>| {
            let number = measured.way.wrapping_mul(self.inputs.len());
            let key = PieceKey::Nth(number.wrapping_add(nth));
            self.piece(assembly, input, key, measured)
        };
        all.iter().map(piece).collect()
    }

    /// Its limits over the range, of each way in which it may be the largest; `None` where the
    /// mechanism does not assemble.
    fn limits(&self, motion: &Motion<'_, A>) -> Option<Vec<Piece<N>>> {
        let Some(rates) = &self.rates else {
            return Some(Vec::new());
        };
        let assembly = motion.assembly;
        let mut pieces = Vec::new();
        for way in self.measure.ways() {
            let jet = |input: f64| {
                let slopes = (self.slopes)(assembly, input);
                let [first, second] = rates(assembly, input);
                self.measure.jet(way, [&slopes, &first, &second])
            };
            let course = Curve::new(motion.range, motion.positions, jet).ok()?;
            if course.has_gaps() {
                return None;
            }
            for (input, _) in places(course.position(), Kind::High) {
                let measured = self
                    .measure
                    .largest_of_way(way, &(self.slopes)(assembly, input));
                pieces.push(self.piece(assembly, input, PieceKey::At(input), &measured));
            }
        }
        Some(pieces)
    }
}

impl<A, const N: usize> Figure<A, N> for ErrorOf<'_, A, N> {
    fn title(&self) -> String {
        let kind = match self.measure {
            Measure::WorstCase(_) => "error in the worst case",
            Measure::Deviation(title, _) => title,
        };
        kind.to_string()
    }

    fn pieces(&self, motion: &Motion<'_, A>) -> Option<Pieces<N>> {
        let at = |(nth, &input): (usize, &f64)| self.pieces_at_input(motion.assembly, nth, input);
        let mut pieces: Vec<Piece<N>> = self.inputs.iter().enumerate().flat_map(at).collect();
        pieces.extend(self.limits(motion)?);
        let finite = !pieces.is_empty() && pieces.iter().all(|piece| piece.value.is_finite());
        finite.then_some(Pieces::Largest(pieces))
    }
}
