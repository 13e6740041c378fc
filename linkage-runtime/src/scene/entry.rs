//! A function of a scene, with its result.

use super::handles::sealed::Handles;
use alloc::boxed::Box;
use alloc::vec::Vec;
use core::any::Any;

/// A function of a scene, with its sources.
pub(super) struct SceneEntry<'a, X> {
    /// The frame that the result is of; 0 if there is none.
    pub(super) frame: u64,
    /// The number of results so far.
    pub(super) version: u64,
    /// The earlier places that the result is made of, and which of their results it has seen.
    pub(super) sources: Vec<(usize, u64)>,
    function: Box<dyn Evaluate<X> + 'a>,
}

impl<'a, X> SceneEntry<'a, X> {
    pub(super) fn new(function: impl Evaluate<X> + 'a) -> Self {
        Self {
            frame: 0,
            version: 0,
            sources: Vec::new(),
            function: Box::new(function),
        }
    }

    /// A place whose function is given the results of others.
    pub(super) fn made_of(sources: Vec<usize>, function: impl Evaluate<X> + 'a) -> Self {
        Self {
            sources: sources.into_iter().map(|index| (index, 0)).collect(),
            ..Self::new(function)
        }
    }

    pub(super) fn put(&mut self, function: impl Evaluate<X> + 'a) {
        self.sources.clear();
        self.function = Box::new(function);
        self.invalidate();
    }

    pub(super) fn invalidate(&mut self) {
        self.frame = 0;
    }

    /// Evaluates for a frame. The places before this one have their results.
    pub(super) fn evaluate(&mut self, argument: &X, frame: u64, earlier: &[SceneEntry<'_, X>]) {
        self.function.evaluate(argument, earlier);
        for (index, seen) in &mut self.sources {
            *seen = earlier[*index].version;
        }
        self.frame = frame;
        self.version += 1;
    }

    /// The result of the last evaluation.
    pub(super) fn result(&self) -> Option<&dyn Any> {
        self.function.result()
    }
}

/// A function that keeps its result.
pub(super) trait Evaluate<X> {
    fn evaluate(&mut self, argument: &X, earlier: &[SceneEntry<'_, X>]);

    /// The result of the last evaluation.
    fn result(&self) -> Option<&dyn Any>;
}

/// Evaluates by returning the result.
pub(super) struct Returning<F, R> {
    function: F,
    result: Option<R>,
}

impl<F, R> Returning<F, R> {
    pub(super) fn new(function: F) -> Self {
        let result = None;
        Self { function, result }
    }
}

impl<X, R: 'static, F: FnMut(&X) -> R> Evaluate<X> for Returning<F, R> {
    fn evaluate(&mut self, argument: &X, _: &[SceneEntry<'_, X>]) {
        self.result = Some((self.function)(argument));
    }

    fn result(&self) -> Option<&dyn Any> {
        self.result.as_ref().map(|result| result as &dyn Any)
    }
}

/// Evaluates by writing into the result, which is a buffer.
pub(super) struct Filling<F, R> {
    function: F,
    result: R,
}

impl<F, R> Filling<F, R> {
    pub(super) fn new(result: R, function: F) -> Self {
        Self { function, result }
    }
}

impl<X, R: 'static, F: FnMut(&X, &mut R)> Evaluate<X> for Filling<F, R> {
    fn evaluate(&mut self, argument: &X, _: &[SceneEntry<'_, X>]) {
        (self.function)(argument, &mut self.result);
    }

    fn result(&self) -> Option<&dyn Any> {
        Some(&self.result)
    }
}

/// Evaluates from the results of earlier places.
pub(super) struct Joining<S, F, R> {
    sources: S,
    function: F,
    result: Option<R>,
}

impl<S, F, R> Joining<S, F, R> {
    pub(super) fn new(sources: S, function: F) -> Self {
        Self {
            sources,
            function,
            result: None,
        }
    }
}

impl<X, S: Handles, R: 'static, F: FnMut(S::Results<'_>) -> R> Evaluate<X> for Joining<S, F, R> {
    fn evaluate(&mut self, _: &X, earlier: &[SceneEntry<'_, X>]) {
        let results = self.sources.results(&|index| earlier[index].result());
        self.result = results.map(&mut self.function);
    }

    fn result(&self) -> Option<&dyn Any> {
        self.result.as_ref().map(|result| result as &dyn Any)
    }
}
