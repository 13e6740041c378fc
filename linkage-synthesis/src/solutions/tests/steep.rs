//! Equations along one of which the trace test is not passed.

use super::super::monodromy::{Fibre, Random};
use super::super::number::Number;
use super::super::trace::Trace;
use super::super::*;

/// `y = 1` and `y^12 - x^11 = 3`. With the second one held, `y` is as the 11/12th power of `x` far
/// away. A point of the curve along the first one is as far away as the 12th power of a coefficient
/// of the form, where no loop leads to, and goes to infinity as the 12th power of the rest of the
/// form.
struct Steep;

impl Equations<2> for Steep {
    fn values<T: Number>(&self, &[x, y]: &[T; 2]) -> [T; 2] {
        let power = |x: T, count: usize| (1..count).fold(x, |power, _| power * x);
        let difference = power(y, 12) - power(x, 11);
        [y - T::from(1.0), difference - T::from(3.0)]
    }
}

#[test]
fn where_the_test_is_not_passed_along_a_row_it_is_made_along_another_one() {
    let mut random = Random::new();
    let given = Member::given(&Steep);
    let mut general = Fibre::find(&given, &mut random).expect("it has solutions");
    let alone = Trace::test(&mut general, 0, &mut random).expect("it can be made");
    assert!(!alone.passed(), "{alone:?}");
    assert_eq!(general.found.len(), 11);

    let found = solutions_traced(&Steep, 0).expect("it has solutions");
    assert!(found.is_complete(), "{found:?}");
    assert_eq!((found.real.len(), found.complex), (1, 10));
    let trace = found.trace.expect("it was asked for");
    assert_eq!((trace.row, trace.degree, trace.open), (1, 11, 0));
    // The second row is the one if the first row is passed.
    let second = solutions_traced(&Steep, 1).expect("it has solutions");
    assert_eq!(second.trace.map(|trace| trace.row), Some(1));
}
