//! Arrays in little code: a dev build has one copy of a generic function for each closure, and that of the standard
//! library is long.

/// Returns the array with `value(index)` at each index. `N` is at least 1.
#[inline(always)]
pub(super) fn array<T: Copy, const N: usize>(mut value: impl FnMut(usize) -> T) -> [T; N] {
    let mut values = [value(0); N];
    let mut index = 1;
    while index < N {
        values[index] = value(index);
        index += 1;
    }
    values
}

#[cfg(test)]
mod tests {
    use super::array;

    #[test]
    fn values_are_in_order_of_their_indices() {
        assert_eq!(array(|index| 2 * index), [0, 2, 4]);
        assert_eq!(array(|index| index + 7), [7]);
    }
}
