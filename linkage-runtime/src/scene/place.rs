//! A function of a scene, with its result.

use alloc::boxed::Box;
use core::any::Any;

/// Where a scene keeps a function.
pub(super) struct Place<'a, X> {
    /// The frame that the result is of; 0 if there is none.
    frame: u64,
    function: Box<dyn Evaluate<X> + 'a>,
}

impl<'a, X> Place<'a, X> {
    pub(super) fn new(function: impl Evaluate<X> + 'a) -> Self {
        Self {
            frame: 0,
            function: Box::new(function),
        }
    }

    pub(super) fn put(&mut self, function: impl Evaluate<X> + 'a) {
        self.function = Box::new(function);
        self.invalidate();
    }

    pub(super) fn invalidate(&mut self) {
        self.frame = 0;
    }

    /// Brings the result to a frame; true if that took an evaluation.
    pub(super) fn update(&mut self, argument: &X, frame: u64) -> bool {
        let stale = self.frame != frame;
        if stale {
            self.function.evaluate(argument);
            self.frame = frame;
        }
        stale
    }

    /// The result, if the function was evaluated for this frame.
    pub(super) fn result(&self, frame: u64) -> Option<&dyn Any> {
        if self.frame == 0 || self.frame != frame {
            return None;
        }
        self.function.result()
    }
}

/// A function that keeps its result.
pub(super) trait Evaluate<X> {
    fn evaluate(&mut self, argument: &X);

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
    fn evaluate(&mut self, argument: &X) {
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
    fn evaluate(&mut self, argument: &X) {
        (self.function)(argument, &mut self.result);
    }

    fn result(&self) -> Option<&dyn Any> {
        Some(&self.result)
    }
}
