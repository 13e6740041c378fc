//! How a search is run, whatever it searches: starts, steps, when it ends, whom it tells.

use alloc::boxed::Box;
use core::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// How far a search has come.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Starts that are done.
    pub done: usize,
    /// All starts.
    pub count: usize,
    /// The least sum so far, not yet certified; infinite before there is one.
    pub least: f64,
}

/// Whom a search tells how far it has come.
pub(crate) type Report<'a> = Box<dyn FnMut(Progress) + 'a>;

/// How a search is run.
pub(crate) struct Settings<'a> {
    pub(crate) starts: usize,
    pub(crate) seed: u64,
    /// The most steps of a descent.
    pub(crate) steps: usize,
    pub(crate) time: Option<Duration>,
    pub(crate) cancel: Option<&'a AtomicBool>,
    pub(crate) progress: Option<Report<'a>>,
}

impl<'a> Settings<'a> {
    pub(crate) fn new(starts: usize, steps: usize) -> Self {
        Self {
            starts,
            seed: 0,
            steps,
            time: None,
            cancel: None,
            progress: None,
        }
    }

    /// When a search that begins now is to end.
    pub(crate) fn end(&self) -> End<'a> {
        End {
            began: Instant::now(),
            time: self.time,
            cancel: self.cancel,
        }
    }
}

/// When a search is to end before all is done.
#[derive(Clone, Copy, Debug)]
pub(crate) struct End<'a> {
    began: Instant,
    time: Option<Duration>,
    cancel: Option<&'a AtomicBool>,
}

impl End<'_> {
    /// Whether its time is over, or it has been cancelled.
    pub(crate) fn reached(&self) -> bool {
        self.time.is_some_and(|time| self.began.elapsed() >= time)
            || self.cancel.is_some_and(|flag| flag.load(Ordering::Relaxed))
    }
}

/// The methods by which a design problem says how it is searched, for its field `settings`; what `starts` and `steps` are without them, and what
/// is not begun any more once the search is to end.
macro_rules! settings_methods {
    ($starts:literal, $steps:literal, $begun:literal) => {
        #[doc = $starts]
        #[must_use]
        pub fn starts(mut self, starts: usize) -> Self {
            self.settings.starts = starts;
            self
        }

        /// Another seed gives other starts.
        #[must_use]
        pub fn seed(mut self, seed: u64) -> Self {
            self.settings.seed = seed;
            self
        }

        #[doc = $steps]
        #[must_use]
        pub fn steps(mut self, steps: usize) -> Self {
            self.settings.steps = steps;
            self
        }

        #[doc = concat!("No ", $begun, " begun after this time; what is found then depends on the machine.")]
        #[must_use]
        pub fn time_limit(mut self, time: Duration) -> Self {
            self.settings.time = Some(time);
            self
        }

        #[doc = concat!("No ", $begun, " begun once this is true.")]
        #[must_use]
        pub fn cancel(mut self, flag: &'a AtomicBool) -> Self {
            self.settings.cancel = Some(flag);
            self
        }
    };
}
pub(crate) use settings_methods;
