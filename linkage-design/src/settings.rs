//! Settings of all searches: starts, steps, the end, reports of progress.

use core::fmt;
use core::sync::atomic::{AtomicBool, Ordering};
use std::boxed::Box;
use std::time::{Duration, Instant};

use linkage_core::format::rounded;

/// The progress of a search. Printed, it is a bar: `[#########---------------------] 320 of 1024,
/// least 0.0123`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Starts, or paths of a homotopy, that are done.
    pub done: usize,
    /// All of them. Of a homotopy more are followed if some have no end of their own.
    pub count: usize,
    /// The minimised value so far, not yet certified; infinite before there is one, and where
    /// nothing is minimised.
    pub least: f64,
}

/// Characters of a bar.
const BAR: usize = 30;

impl fmt::Display for Progress {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { done, count, least } = *self;
        let full = BAR * done.min(count) / count.max(1);
        write!(
            f,
            "[{}{}] {done} of {count}",
            "#".repeat(full),
            "-".repeat(BAR - full)
        )?;
        match least.is_finite() {
            true => write!(f, ", least {}", rounded(least)),
            false => Ok(()),
        }
    }
}

/// Whom a search tells how far it has come.
pub(crate) type Report<'a> = Box<dyn FnMut(Progress) + 'a>;

/// The settings of a search.
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

/// Results at the end of the time are rounded and certified for no longer than this part of the
/// limit.
const AFTERWARDS: f64 = 0.25;

/// When a search is to end before all is done.
#[derive(Clone, Copy, Debug)]
pub(crate) struct End<'a> {
    began: Instant,
    time: Option<Duration>,
    cancel: Option<&'a AtomicBool>,
}

impl End<'_> {
    /// True if results are not to be rounded and certified any more.
    pub(crate) fn is_over(&self) -> bool {
        let late = |time: Duration| self.began.elapsed() >= time.mul_f64(1.0 + AFTERWARDS);
        self.time.is_some_and(late) || self.is_cancelled()
    }

    /// The time limit if it has been reached.
    pub(crate) fn limit(&self) -> Option<Duration> {
        self.time.filter(|time| self.began.elapsed() >= *time)
    }

    fn is_cancelled(&self) -> bool {
        self.cancel.is_some_and(|flag| flag.load(Ordering::Relaxed))
    }

    /// Returns true if its time is over, or it has been cancelled.
    pub(crate) fn reached(&self) -> bool {
        self.limit().is_some() || self.is_cancelled()
    }
}

/// The methods with which a design problem sets its search, for its field `settings`. The arguments
/// are the texts about the defaults of `starts` and `steps`, and about work that is not begun once
/// the search is to end.
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

        #[doc = concat!("No ", $begun, " begun after this time, and what was found is rounded and certified for no longer than a quarter of it; \
            what is found then depends on the machine.")]
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
