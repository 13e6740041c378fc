//! Work on several threads, if there are some.

use std::vec::Vec;

/// Returns the results of work on all items, in their order.
#[cfg(feature = "rayon")]
pub fn in_parallel<T: Sync, R: Send>(items: &[T], work: impl Fn(&T) -> R + Sync + Send) -> Vec<R> {
    use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
    items.par_iter().map(work).collect()
}

/// Returns the results of work on all items, in their order.
#[cfg(not(feature = "rayon"))]
pub fn in_parallel<T, R>(items: &[T], work: impl Fn(&T) -> R) -> Vec<R> {
    items.iter().map(work).collect()
}

/// Returns the number of threads that work on items.
pub(crate) fn threads() -> usize {
    #[cfg(feature = "rayon")]
    return rayon::current_num_threads();
    #[cfg(not(feature = "rayon"))]
    return 1;
}
