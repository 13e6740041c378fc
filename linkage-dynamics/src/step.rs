//! One step of an integrator as a polynomial, stored by values at Chebyshev points.
//!
//! Dense output of Dormand and Prince's method of order 8 has degree 7, that of Radau's method has
//! degree 3. Eight values determine both, so that the polynomial does not depend on the integrator.

use crate::phase::Phase;
use crate::state::State;
use gauss_quad::GaussLegendre;
use std::num::NonZeroUsize;

/// Points of a Gauss rule over one step: exact for products of two polynomials of a step.
const QUADRATURE: NonZeroUsize = NonZeroUsize::new(8).unwrap();

/// One more than the highest degree of dense output.
pub(crate) const NODES: usize = 8;

/// Chebyshev points of the second kind over `0..1`: `(1 - cos(k pi / 7)) / 2`.
pub(crate) const POINTS: [f64; NODES] = [
    0.0,
    0.049_515_566_048_790_434,
    0.188_255_099_070_633_23,
    0.388_739_533_021_842_8,
    0.611_260_466_978_157_2,
    0.811_744_900_929_366_8,
    0.950_484_433_951_209_6,
    1.0,
];

/// A step that an integrator accepted.
#[derive(Clone, Debug)]
pub(crate) struct Step<const N: usize> {
    pub(crate) start: f64,
    pub(crate) width: f64,
    /// States at `POINTS`.
    pub(crate) nodes: [Phase<N>; NODES],
}

impl<const N: usize> Step<N> {
    /// Returns the position of a node.
    pub(crate) fn position(&self, node: usize) -> f64 {
        self.start + POINTS[node] * self.width
    }

    /// Returns the state at the end.
    pub(crate) fn end(&self) -> State<N> {
        State::new(self.start + self.width, self.nodes[NODES - 1])
    }

    /// Returns the state at a position, by the barycentric formula.
    pub(crate) fn state(&self, x: f64) -> State<N> {
        State::new(x, self.phase((x - self.start) / self.width))
    }

    /// Returns the state at a share of the step.
    fn phase(&self, share: f64) -> Phase<N> {
        let mut sum = Phase::ZERO;
        let mut weights = 0.0;
        for (k, (node, point)) in self.nodes.iter().zip(POINTS).enumerate() {
            let distance = share - point;
            if distance == 0.0 {
                return *node;
            }
            let end = k == 0 || k == NODES - 1;
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
            let weight = if end { 0.5 * sign } else { sign } / distance;
            weights += weight;
            sum.add_scaled(weight, node);
        }
        sum.scale(1.0 / weights);
        sum
    }

    /// Returns the part of the step up to a position.
    pub(crate) fn until(&self, x: f64) -> Self {
        let share = (x - self.start) / self.width;
        Self {
            start: self.start,
            width: x - self.start,
            nodes: POINTS.map(|point| self.phase(share * point)),
        }
    }
}

/// Returns the step that a position belongs to: the first or the last one outside of all; `None`
/// without steps.
pub(crate) fn step_at<const N: usize>(steps: &[Step<N>], x: f64) -> Option<&Step<N>> {
    let after = steps.partition_point(|step| step.start < x);
    steps.get(after.saturating_sub(1))
}

/// Returns the integral of a function of the state over steps, by a Gauss rule of 8 points over
/// each.
pub(crate) fn integral<const N: usize>(
    steps: &[Step<N>],
    function: impl Fn(&State<N>) -> f64,
) -> f64 {
    let rule = GaussLegendre::new(QUADRATURE);
    let integrals = steps.iter().map(|step| {
        let end = step.start + step.width;
        rule.integrate(step.start, end, |x| function(&step.state(x)))
    });
    integrals.sum()
}

/// Returns the integral of a function of the state from the first step up to each of the times,
/// which rise, by the same rule over each step and each part of one.
pub(crate) fn integrals<const N: usize>(
    steps: &[Step<N>],
    times: &[f64],
    function: impl Fn(&State<N>) -> f64,
) -> Vec<f64> {
    let rule = GaussLegendre::new(QUADRATURE);
    let mut sums = Vec::with_capacity(times.len());
    let mut sum = 0.0;
    for step in steps {
        let end = step.start + step.width;
        let mut from = step.start;
        while let Some(&time) = times.get(sums.len()).filter(|time| **time < end) {
            sum += rule.integrate(from, time, |x| function(&step.state(x)));
            sums.push(sum);
            from = time;
        }
        sum += rule.integrate(from, end, |x| function(&step.state(x)));
    }
    sums.resize(times.len(), sum);
    sums
}

#[cfg(test)]
mod tests {
    use super::{POINTS, Step, integrals};
    use crate::phase::Phase;

    /// A polynomial of degree 7 is reproduced between the nodes, also by a part of the step.
    #[test]
    fn degree_seven_is_exact() {
        let value = |x: f64| Phase {
            inputs: [x.powi(7) - 3.0 * x.powi(4) + 1.0],
            speeds: [7.0 * x.powi(6) - 12.0 * x.powi(3)],
        };
        let (start, width) = (0.25, 1.5);
        let nodes = POINTS.map(|point| value(start + width * point));
        let step = Step {
            start,
            width,
            nodes,
        };
        let part = step.until(1.1);
        for x in [0.25, 0.3, 0.77, 1.0, 1.1] {
            for step in [&step, &part] {
                let (state, exact) = (step.state(x), value(x));
                assert!((state.inputs[0] - exact.inputs[0]).abs() < 4e-14, "{x}");
                assert!((state.speeds[0] - exact.speeds[0]).abs() < 1e-13, "{x}");
            }
        }
        assert_eq!(part.end().time, 1.1);
    }

    /// The sum over parts of steps is that over whole ones, also where times are at their ends.
    #[test]
    fn integrals_add_up() {
        let steps = [(0.0, 1.0), (1.0, 0.5)].map(|(start, width)| Step {
            start,
            width,
            nodes: POINTS.map(|point| Phase {
                inputs: [start + width * point],
                speeds: [1.0],
            }),
        });
        let times = [0.0, 0.25, 1.0, 1.25, 1.5];
        let sums = integrals(&steps, &times, |state| state.inputs[0].powi(2));
        for (time, sum) in times.into_iter().zip(sums) {
            assert!((sum - f64::powi(time, 3) / 3.0).abs() < 1e-15, "{time}");
        }
    }

    #[test]
    fn points_are_those_of_chebyshev() {
        for (k, point) in POINTS.into_iter().enumerate() {
            let exact = (k as f64 * std::f64::consts::PI / 14.0).sin().powi(2);
            assert!((point - exact).abs() < 2e-16, "{k}");
        }
    }
}
