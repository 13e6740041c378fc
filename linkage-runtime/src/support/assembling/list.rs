//! Arrays and vectors.

#[cfg(feature = "alloc")]
use alloc::vec::Vec;

/// An array, whose length a generated mechanism knows at build time, or a vector.
pub trait List<X>: AsRef<[X]> + AsMut<[X]> + Clone {
    /// The list with these entries; `count` is the length of an array already.
    fn list(count: usize, entry: impl FnMut(usize) -> X) -> Self;

    /// A list of `count` times this entry, to be filled: less code than a function of the index.
    fn repeat(count: usize, entry: X) -> Self
    where
        X: Copy;
}

/// Rows of one length, in a list.
pub trait Table<X> {
    /// The table with this entry everywhere; arrays have their lengths already.
    fn filled(rows: usize, columns: usize, entry: X) -> Self;
}

impl<X: Copy, const R: usize, const C: usize> Table<X> for [[X; C]; R] {
    #[inline(always)]
    fn filled(_: usize, _: usize, entry: X) -> Self {
        [[entry; C]; R]
    }
}

#[cfg(feature = "alloc")]
impl<X: Copy> Table<X> for Vec<Vec<X>> {
    fn filled(rows: usize, columns: usize, entry: X) -> Self {
        alloc::vec![alloc::vec![entry; columns]; rows]
    }
}

impl<X: Clone, const N: usize> List<X> for [X; N] {
    #[inline(always)]
    fn list(_: usize, entry: impl FnMut(usize) -> X) -> Self {
        core::array::from_fn(entry)
    }

    #[inline(always)]
    fn repeat(_: usize, entry: X) -> Self
    where
        X: Copy,
    {
        [entry; N]
    }
}

#[cfg(feature = "alloc")]
impl<X: Clone> List<X> for Vec<X> {
    fn list(count: usize, entry: impl FnMut(usize) -> X) -> Self {
        (0..count).map(entry).collect()
    }

    fn repeat(count: usize, entry: X) -> Self
    where
        X: Copy,
    {
        alloc::vec![entry; count]
    }
}
