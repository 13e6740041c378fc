//! Prepared states for every lane of a scalar.

use alloc::vec::Vec;
use linkage_core::Scalar;
use linkage_core::numeric::continuation::Lookup;

/// Most lanes whose states are looked up side by side.
const LANES: usize = 16;

/// The table of a group: one for every lane, since each lane has dimensions of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Coupled<const S: usize> {
    first: Lookup<S>,
    others: Vec<Lookup<S>>,
}

impl<const S: usize> Coupled<S> {
    /// The look-up of every lane, NaN where there is none.
    pub(super) fn new<T: Scalar>(lookup: impl Fn(usize) -> Option<Lookup<S>>) -> Self {
        let lookup = |lane| lookup(lane).unwrap_or_else(Lookup::nothing);
        Self {
            first: lookup(0),
            others: (1..T::LANES).map(lookup).collect(),
        }
    }

    /// The state at `x` and the floor, without derivatives. With `FUSED` only on machines with
    /// fused multiply-add.
    #[must_use]
    #[inline(always)]
    pub fn at<T: Scalar, const FUSED: bool>(&self, x: T) -> ([T; S], T) {
        if T::LANES == 1 {
            return constants(self.first.at_with::<FUSED>(x.lane(0)));
        }
        by_lane::<T, S>(|lane| match lane {
            0 => self.first.at_with::<FUSED>(x.lane(0)),
            _ => self.others[lane - 1].at_with::<FUSED>(x.lane(lane)),
        })
    }

    /// Writes the results of [`at`](Self::at) for the first `vectors` times `V` of `x`, to the last
    /// bit: the numbers of the state and then the floor, a column each.
    #[inline(always)]
    pub fn fill<T: Scalar, const FUSED: bool, const V: usize, const B: usize>(
        &self,
        x: &[T; B],
        vectors: usize,
        columns: &mut [[T; B]],
    ) {
        if T::VECTORISES {
            return self.first.fill::<T, FUSED, V, B>(x, vectors, columns);
        }
        for (row, x) in x.iter().enumerate().take(vectors * V) {
            put(self.at::<T, FUSED>(*x), row, columns);
        }
    }
}

/// Writes a state and its floor into a row of columns.
#[inline(always)]
pub(super) fn put<T: Copy, const S: usize, const B: usize>(
    (state, floor): ([T; S], T),
    row: usize,
    columns: &mut [[T; B]],
) {
    for (column, number) in columns.iter_mut().zip(state.iter().chain([&floor])) {
        column[row] = *number;
    }
}

/// A state as constants of the scalar.
#[inline(always)]
pub(super) fn constants<T: Scalar, const S: usize>((state, floor): ([f64; S], f64)) -> ([T; S], T) {
    (state.map(T::from_f64), T::from_f64(floor))
}

/// Looks up the states of all lanes.
pub(super) fn by_lane<T: Scalar, const S: usize>(
    look_up: impl Fn(usize) -> ([f64; S], f64),
) -> ([T; S], T) {
    const {
        assert!(
            T::LANES <= LANES,
            "more lanes than are looked up side by side"
        )
    };
    let mut rows = [([0.0; S], 0.0); LANES];
    for (lane, row) in rows.iter_mut().take(T::LANES).enumerate() {
        *row = look_up(lane);
    }
    let mut state = [T::from_f64(0.0); S];
    for (index, number) in state.iter_mut().enumerate() {
        *number = T::from_lanes(|lane| rows[lane].0[index]);
    }
    (state, T::from_lanes(|lane| rows[lane].1))
}
