//! Equations along one of which the trace test leaves a point open.

use super::super::monodromy::{Fibre, Random};
use super::super::number::Number;
use super::super::trace::Trace;
use super::super::*;

/// `y = 1` and `y^12 - x^11 = 3`. With the second one held, `y` is as the 11/12th power of `x` far away, so that a point of the
/// curve along the first one goes to infinity as the 12th power of what is left of the form: out of the range of numbers
/// before it counts as gone.
struct Steep;

impl Equations<2> for Steep {
    fn values<T: Number>(&self, &[x, y]: &[T; 2]) -> [T; 2] {
        let power = |x: T, count: usize| (1..count).fold(x, |power, _| power * x);
        let difference = power(y, 12) - power(x, 11);
        [y - T::from(1.0), difference - T::from(3.0)]
    }
}

#[test]
fn a_row_that_leaves_a_point_open_is_left_for_another_one() {
    let mut random = Random::new();
    let given = Member::given(&Steep);
    let mut general = Fibre::find(&given, &mut random).expect("it has solutions");
    let alone = Trace::test(&mut general, 0, &mut random).expect("it can be made");
    assert_eq!((alone.degree, alone.open), (12, 1), "{alone:?}");

    let found = solutions_traced(&Steep, 0).expect("it has solutions");
    assert!(found.is_complete(), "{found:?}");
    assert_eq!((found.real.len(), found.complex), (1, 10));
    let trace = found.trace.expect("it was asked for");
    assert_eq!((trace.row, trace.degree, trace.open), (1, 11, 0));
    // Where the first one is passed, it is the one.
    let second = solutions_traced(&Steep, 1).expect("it has solutions");
    assert_eq!(second.trace.map(|trace| trace.row), Some(1));
}
