//! Observer of an integrator's steps: dense output, states without rates, the end of the motion.

use crate::phase::{Phase, Rates, Watched};
use crate::step::{NODES, POINTS, Step};
use ivp::dense::StepInterpolant;
use ivp::solout::{ControlFlag, SolOut};

/// A receiver of accepted steps.
pub(crate) trait Receive<const N: usize> {
    /// Returns true if the step between two states is needed with dense output.
    fn needs_nodes(&self, before: &Phase<N>, after: &Phase<N>) -> bool;

    /// Receives a step with dense output; returns false to end the motion.
    fn step(&mut self, step: Step<N>) -> bool;

    /// Receives the end of a step that needs no dense output; returns false to end the motion.
    fn end(&mut self, x: f64, phase: &Phase<N>) -> bool;
}

/// The reason why a call of the integrator ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Finding {
    /// None of the observer.
    None,
    /// Dense output begins or ends.
    Switch,
    /// A state of the step has no rates.
    Undefined,
    /// The receiver ended the motion.
    End,
}

/// The last state, and what happens with the next.
pub(crate) struct Observer<'o, 'r, R, V, const N: usize> {
    watched: &'o Watched<'r, R, N>,
    receiver: &'o mut V,
    pub(crate) x: f64,
    pub(crate) phase: Phase<N>,
    pub(crate) end: f64,
    pub(crate) finding: Finding,
    /// True if the integrator has dense output.
    pub(crate) has_nodes: bool,
    /// Number of evaluations at the end of a step, without and with dense output.
    last_evaluations: [usize; 2],
}

impl<'o, 'r, R: Rates<N>, V: Receive<N>, const N: usize> Observer<'o, 'r, R, V, N> {
    pub(crate) fn new(
        watched: &'o Watched<'r, R, N>,
        receiver: &'o mut V,
        (x, phase): (f64, Phase<N>),
        end: f64,
        last_evaluations: [usize; 2],
    ) -> Self {
        let has_nodes = receiver.needs_nodes(&phase, &phase);
        Self {
            watched,
            receiver,
            x,
            phase,
            end,
            finding: Finding::None,
            has_nodes,
            last_evaluations,
        }
    }

    /// Notes a finding, which ends the call.
    fn interrupt(&mut self, finding: Finding) -> ControlFlag {
        self.finding = finding;
        ControlFlag::Interrupt
    }

    /// Returns the states at the nodes of a step.
    fn nodes(
        &self,
        x: f64,
        after: Phase<N>,
        interpolant: &StepInterpolant<'_>,
    ) -> [Phase<N>; NODES] {
        let mut nodes = [after; NODES];
        nodes[0] = self.phase;
        // The components of a phase, at most eight on the stack.
        let mut few = [0.0; 8];
        let mut many = vec![0.0; if 2 * N > few.len() { 2 * N } else { 0 }];
        let components = few.get_mut(..2 * N).unwrap_or(&mut many);
        for (node, point) in nodes.iter_mut().zip(POINTS).take(NODES - 1).skip(1) {
            interpolant.interpolate(self.x + point * (x - self.x), components);
            *node = Phase::from_components(components);
        }
        nodes
    }
}

impl<R: Rates<N>, V: Receive<N>, const N: usize> SolOut for Observer<'_, '_, R, V, N> {
    fn solout(
        &mut self,
        before: f64,
        x: &mut f64,
        state: &mut [f64],
        interpolant: Option<&StepInterpolant<'_>>,
    ) -> ControlFlag {
        // The first report is the first state.
        if *x == before {
            return ControlFlag::Continue;
        }
        let after = Phase::from_components(state);
        let last = self.last_evaluations[usize::from(self.has_nodes)];
        if self.watched.was_undefined(last) || !after.is_finite() {
            return self.interrupt(Finding::Undefined);
        }
        let needs_nodes = self.receiver.needs_nodes(&self.phase, &after);
        if needs_nodes && !self.has_nodes {
            self.has_nodes = true;
            return self.interrupt(Finding::Switch);
        }
        // The last step is clipped to the end, up to rounding.
        let is_last = (self.end - *x).abs() <= 4.0 * f64::EPSILON * self.end.abs();
        let x = if is_last { self.end } else { *x };
        let goes_on = match interpolant.filter(|_| needs_nodes) {
            Some(interpolant) => self.receiver.step(Step {
                start: self.x,
                width: x - self.x,
                nodes: self.nodes(x, after, interpolant),
            }),
            None => self.receiver.end(x, &after),
        };
        (self.x, self.phase) = (x, after);
        let _ = self.watched.take_undefined();
        if !goes_on {
            return self.interrupt(Finding::End);
        }
        if self.has_nodes && !needs_nodes {
            self.has_nodes = false;
            return self.interrupt(Finding::Switch);
        }
        ControlFlag::Continue
    }
}
