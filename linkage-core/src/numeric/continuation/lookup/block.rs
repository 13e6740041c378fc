//! Many look-ups in one table: the common steps of all rows run side by side, and only the
//! polynomials of each row's cell run row by row.

use super::super::cell::OUTSIDE;
use super::super::scale::guard;
use super::{Lookup, cell, polynomials};
use crate::scalar::Scalar;
use core::hint::black_box;
use core::mem::MaybeUninit;

/// `B` numbers where no vector crosses a cache line.
#[repr(align(64))]
struct Column<X, const B: usize>([X; B]);

impl<X, const B: usize> Column<X, B> {
    #[inline(always)]
    fn vector<const V: usize>(&self, vector: usize) -> &[X; V] {
        &self.0.as_chunks().0[vector]
    }

    #[inline(always)]
    fn vector_mut<const V: usize>(&mut self, vector: usize) -> &mut [X; V] {
        &mut self.0.as_chunks_mut().0[vector]
    }
}

impl<const S: usize> Lookup<S> {
    /// Returns the result of [`at_with`](Self::at_with) for the first `vectors` times `V` of `x`,
    /// to the last bit: the numbers of the state and then the floor, a column each.
    #[allow(
        unsafe_code,
        reason = "rows that are written before they are read are not cleared"
    )]
    #[inline(always)]
    pub fn fill<T: Scalar, const FUSED: bool, const V: usize, const B: usize>(
        &self,
        x: &[T; B],
        vectors: usize,
        columns: &mut [[T; B]],
    ) {
        let vectors = vectors.min(B / V);
        let (mut places, mut slots) = (Column([0.0; B]), Column([0; B]));
        for vector in 0..vectors {
            let (places, slots) = (places.vector_mut(vector), slots.vector_mut(vector));
            self.find_all::<T, V>(&x.as_chunks().0[vector], places, slots);
        }
        // Not cleared: that takes as long as a part of the look-up.
        let mut states = Column([const { MaybeUninit::uninit() }; B]);
        let mut floors = Column([0.0; B]);
        // Registers: what stands in memory is read anew behind each box.
        let (index, cells) = (&*self.index, &*self.cells);
        for row in 0..vectors * V {
            // Nothing is moved across this: look-ups of several rows at once would be gathers,
            // which are slow.
            black_box(());
            let cell = cell(index, cells, slots.0[row]);
            let t = cell.t(places.0[row]);
            states.0[row].write(polynomials::<FUSED, S>(&cell.coefficients, t));
            places.0[row] = t;
            floors.0[row] = cell.floor;
        }
        for vector in 0..vectors {
            // SAFETY: the loop over rows has written as many vectors as this one reads.
            let states = unsafe { states.vector::<V>(vector).map(|row| row.assume_init()) };
            let lanes = guarded::<T, S, V>(&states, places.vector(vector), floors.vector(vector));
            for (column, lanes) in columns.iter_mut().zip(lanes.0.iter().chain([&lanes.1])) {
                column.as_chunks_mut().0[vector] = *lanes;
            }
        }
    }

    /// Places and slots of several inputs.
    #[inline(always)]
    fn find_all<T: Scalar, const V: usize>(
        &self,
        x: &[T; V],
        places: &mut [f64; V],
        slots: &mut [usize; V],
    ) {
        for lane in 0..V {
            (places[lane], slots[lane]) = self.scale.find(x[lane].lane(0));
        }
    }
}

/// States and floors as lanes, floors NaN far outside the cell, of which `t` says where.
#[inline(always)]
fn guarded<T: Scalar, const S: usize, const V: usize>(
    states: &[[f64; S]; V],
    t: &[f64; V],
    floors: &[f64; V],
) -> ([[T; V]; S], [T; V]) {
    let mut lanes = ([[T::from_f64(0.0); V]; S], [T::from_f64(0.0); V]);
    for lane in 0..V {
        let guard = guard(t[lane], OUTSIDE);
        for (column, number) in lanes.0.iter_mut().zip(&states[lane]) {
            column[lane] = T::from_f64(*number);
        }
        lanes.1[lane] = T::from_f64(floors[lane] + guard);
    }
    lanes
}
