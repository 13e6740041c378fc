//! Sorted lists in little code: a dev build has one copy of a sort for each type and order, and that of the standard
//! library is long.

use alloc::vec::Vec;
use core::cmp::Ordering;

/// Returns the items in ascending order. Equal ones keep theirs.
pub(super) fn sorted<T: Copy>(items: &[T], compare: impl Fn(&T, &T) -> Ordering) -> Vec<T> {
    let order = sorted_indices(items.len(), &|a, b| compare(&items[a], &items[b]));
    let mut sorted = Vec::with_capacity(order.len());
    for index in order {
        sorted.push(items[index]);
    }
    sorted
}

/// The one sort for all types.
fn sorted_indices(count: usize, compare: &dyn Fn(usize, usize) -> Ordering) -> Vec<usize> {
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&a, &b| compare(a, b));
    order
}

#[cfg(test)]
mod tests {
    use super::sorted;
    use alloc::vec::Vec;

    #[test]
    fn equal_items_keep_their_order() {
        let items: Vec<(usize, usize)> = (0..50).map(|i| (i * 7 % 5, i)).collect();
        let mut expected = items.clone();
        expected.sort();
        assert_eq!(sorted(&items, |a, b| a.0.cmp(&b.0)), expected);
    }
}
