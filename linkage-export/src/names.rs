//! Names of the user as names of the target language.

use std::collections::BTreeSet;

use crate::target::{Scope, Target};

/// The names of one scope, each once.
#[derive(Clone, Debug)]
pub(crate) struct Names<'t, T> {
    target: &'t T,
    scope: Scope,
    taken: BTreeSet<String>,
}

impl<'t, T: Target> Names<'t, T> {
    /// A scope without names.
    pub(crate) fn new(target: &'t T, scope: Scope) -> Self {
        Self {
            target,
            scope,
            taken: BTreeSet::new(),
        }
    }

    /// The same scope with names that are taken.
    #[must_use]
    pub(crate) fn with<'a>(mut self, taken: impl IntoIterator<Item = &'a String>) -> Self {
        let keys = taken.into_iter().map(|name| self.target.key(name));
        self.taken.extend(keys);
        self
    }

    /// Returns the name in the target language of something of the user, which nothing else in the
    /// scope gets. It is the user's own name if the language allows it.
    pub(crate) fn take(&mut self, wanted: &str) -> String {
        let mut name = self.target.spelled(wanted, self.scope);
        while self.target.is_reserved(&name, self.scope)
            || self.taken.contains(&self.target.key(&name))
        {
            name = self.target.altered(&name);
        }
        self.taken.insert(self.target.key(&name));
        name
    }

    /// Returns a beginning that no name of the scope has, and none of `others`.
    pub(crate) fn unused_beginning<'a>(
        &self,
        wanted: &str,
        others: impl Iterator<Item = &'a String> + Clone,
    ) -> String {
        let others = others.map(|name| self.target.key(name));
        let mut beginning = wanted.to_owned();
        let is_used = |beginning: &str| {
            let key = self.target.key(beginning);
            let mut names = self.taken.iter().cloned().chain(others.clone());
            names.any(|name| name.starts_with(&key))
        };
        while is_used(&beginning) {
            beginning.push('x');
        }
        beginning
    }
}
