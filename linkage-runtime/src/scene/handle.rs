//! Names of functions.

use core::fmt;
use core::hash::{Hash, Hasher};
use core::marker::PhantomData;

/// Names a function of a [`Scene`](crate::Scene) and carries the type of its result.
pub struct Handle<R> {
    pub(super) scene: usize,
    pub(super) index: usize,
    pub(super) result: PhantomData<fn() -> R>,
}

// Derived implementations would ask `R` for the same traits.

impl<R> Clone for Handle<R> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<R> Copy for Handle<R> {}

impl<R> PartialEq for Handle<R> {
    fn eq(&self, other: &Self) -> bool {
        (self.scene, self.index) == (other.scene, other.index)
    }
}

impl<R> Eq for Handle<R> {}

impl<R> Hash for Handle<R> {
    fn hash<H: Hasher>(&self, state: &mut H) {
        (self.scene, self.index).hash(state);
    }
}

impl<R> fmt::Debug for Handle<R> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Handle").field(&self.index).finish()
    }
}
