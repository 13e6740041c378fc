//! Recorder of a motion: steps, events and dead points in the order of time.

use crate::computed_motion::{Ended, Motion};
use crate::dead_point::{dead_point, dead_point_ahead};
use crate::equations_of_motion::Equations;
use crate::error::Cause;
use crate::event::{Event, EventSearch};
use crate::observer::Receive;
use crate::phase::Phase;
use crate::state::State;
use crate::step::Step;
use crate::stepper::{Counts, Settings};

/// A motion that grows by steps.
pub(crate) struct Recorder<'e, 'a, E, const N: usize> {
    equations: &'e E,
    search: EventSearch<'e, 'a, N>,
    settings: Settings,
    most_steps: usize,
    keeps_steps: bool,
    has_events: bool,
    /// The largest speed of each input.
    fastest: [f64; N],
    motion: Motion<N>,
    cause: Option<Cause<N>>,
}

impl<'e, 'a, E: Equations<N>, const N: usize> Recorder<'e, 'a, E, N> {
    pub(crate) fn new(
        equations: &'e E,
        events: &'e [Event<'a, N>],
        settings: Settings,
        most_steps: usize,
        keeps_steps: bool,
        motion: Motion<N>,
    ) -> Self {
        Self {
            equations,
            search: EventSearch::new(events, &motion.start),
            settings,
            most_steps,
            keeps_steps,
            has_events: !events.is_empty(),
            fastest: motion.start.speeds.map(f64::abs),
            motion,
            cause: None,
        }
    }

    /// Returns the motion, and the cause of its end if that is not its time or an event. A motion
    /// that has halted may be at a dead point.
    pub(crate) fn into_motion(
        mut self,
        counts: Counts,
        has_halted: bool,
    ) -> (Motion<N>, Option<Cause<N>>) {
        if has_halted && self.cause.is_none() {
            self.cause = self.dead_point_ahead(0.0, true);
        }
        self.motion.evaluations = counts.evaluations;
        self.motion.rejected = counts.rejected;
        (self.motion, self.cause)
    }

    /// Returns the dead point directly after the end, as a cause.
    fn dead_point_ahead(&self, least: f64, is_last: bool) -> Option<Cause<N>> {
        let end = &self.motion.end;
        let found = dead_point_ahead(self.equations, end, &self.fastest, least, is_last);
        found.map(|(state, input)| Cause::DeadPoint { state, input })
    }

    /// Looks for a dead point ahead of the end; returns true if there is none.
    fn is_free(&mut self) -> bool {
        let end = self.motion.end;
        for (fastest, speed) in self.fastest.iter_mut().zip(end.speeds) {
            *fastest = fastest.max(speed.abs());
        }
        self.cause = self.dead_point_ahead(self.settings.absolute, false);
        self.cause.is_none()
    }

    /// Returns true if another step is allowed.
    fn goes_on(&mut self) -> bool {
        let most = self.most_steps;
        if self.motion.accepted >= most {
            let state = self.motion.end;
            self.cause = Some(Cause::Steps { state, most });
        }
        self.cause.is_none()
    }
}

impl<E: Equations<N>, const N: usize> Receive<N> for Recorder<'_, '_, E, N> {
    /// A speed that changes its sign may be a dead point.
    fn needs_nodes(&self, before: &Phase<N>, after: &Phase<N>) -> bool {
        let mut speeds = before.speeds.iter().zip(&after.speeds);
        self.keeps_steps || self.has_events || speeds.any(|(a, b)| a * b < 0.0)
    }

    fn step(&mut self, mut step: Step<N>) -> bool {
        if !self.goes_on() {
            return false;
        }
        let tolerance = |size: f64| self.settings.absolute + self.settings.relative * size;
        let dead = dead_point(self.equations, &step, tolerance);
        if let Some((time, _)) = dead {
            step = step.until(time);
        }
        if let Some(stop) = self.search.add(&step, &mut self.motion.occurrences) {
            let step = step.until(stop.state.time);
            self.motion.append(step, self.keeps_steps);
            self.motion.ended = Ended::Event(stop.event);
            return false;
        }
        self.motion.append(step, self.keeps_steps);
        if let Some((_, input)) = dead {
            let state = self.motion.end;
            self.cause = Some(Cause::DeadPoint { state, input });
            return false;
        }
        self.is_free()
    }

    fn end(&mut self, x: f64, phase: &Phase<N>) -> bool {
        if !self.goes_on() {
            return false;
        }
        self.motion.end = State::new(x, *phase);
        self.motion.accepted += 1;
        self.is_free()
    }
}
