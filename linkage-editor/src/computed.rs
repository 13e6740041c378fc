//! Values of the last texts that could be compiled.

use std::cell::OnceCell;
use std::sync::Arc;

use crate::name_values::{Values, values};
use crate::probe::Snapshot;

/// The relation of values to the present text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Age {
    /// They are its values.
    Present,
    /// They are those of an earlier text, until the present one is solved.
    Pending,
    /// They are those of an earlier text, because the present one has mistakes.
    BeforeMistakes,
}

/// The last text that could be compiled, and the last one with values.
#[derive(Debug, Default)]
pub(crate) struct Computed {
    /// True if values are computed where they are first needed, false if they are brought.
    pub(crate) is_lazy: bool,
    latest: Option<Compiled>,
    /// An earlier text with values, until those of the latest arrive.
    earlier: Option<Compiled>,
}

#[derive(Debug)]
struct Compiled {
    snapshot: Arc<Snapshot>,
    /// The values of each mechanism, in the order of the facts.
    values: OnceCell<Vec<Values>>,
}

/// The computation of the values of a text, in any thread.
#[derive(Debug)]
pub struct Evaluation {
    snapshot: Arc<Snapshot>,
}

/// The values of a text.
#[derive(Debug)]
pub struct Evaluated {
    snapshot: Arc<Snapshot>,
    values: Vec<Values>,
}

impl Evaluation {
    /// Computes the values of all names, and their operations. It takes about as long as
    /// [`Solving::run`](crate::Solving::run).
    #[must_use]
    pub fn run(self) -> Evaluated {
        Evaluated {
            values: values(&self.snapshot),
            snapshot: self.snapshot,
        }
    }
}

impl Computed {
    /// Notes a text that can be compiled. Returns the computation of its values.
    pub(crate) fn add(&mut self, snapshot: Snapshot) -> Evaluation {
        let snapshot = Arc::new(snapshot);
        let latest = Compiled {
            snapshot: Arc::clone(&snapshot),
            values: OnceCell::new(),
        };
        let before = self.latest.replace(latest);
        let before = before.filter(|before| before.values.get().is_some());
        self.earlier = before.or(self.earlier.take());
        Evaluation { snapshot }
    }

    /// Takes the values of the latest text; returns false for those of another one.
    pub(crate) fn take(&mut self, Evaluated { snapshot, values }: Evaluated) -> bool {
        let latest = self.latest.as_mut();
        let latest = latest.filter(|latest| Arc::ptr_eq(&latest.snapshot, &snapshot));
        let is_new = latest.is_some_and(|latest| latest.values.set(values).is_ok());
        if is_new {
            self.earlier = None;
        }
        is_new
    }

    /// Returns true if the values that are shown are those of the latest text.
    pub(crate) fn is_latest(&self) -> bool {
        let latest = self.latest.as_ref();
        latest.is_some_and(|latest| self.is_lazy || latest.values.get().is_some())
    }

    /// Returns the values of a mechanism.
    pub(crate) fn values(&self, mechanism: &str) -> Option<&Values> {
        if self.is_lazy
            && let Some(latest) = &self.latest
        {
            latest.values.get_or_init(|| values(&latest.snapshot));
        }
        self.finished(mechanism)
    }

    /// Returns the values of a mechanism, if they have been computed.
    pub(crate) fn finished(&self, mechanism: &str) -> Option<&Values> {
        let latest = self.latest.iter().chain(&self.earlier);
        let mut finished = latest.filter_map(|one| Some((one, one.values.get()?)));
        let (of, values) = finished.next()?;
        let mut facts = of.snapshot.facts.iter();
        values.get(facts.position(|facts| facts.mechanism == mechanism)?)
    }
}
