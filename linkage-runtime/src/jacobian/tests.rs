use super::{Jacobian, SingularityKind, singularities};
use std::vec::Vec;

/// A turn by an angle with the sine 3/5, in the plane of two coordinates, times a matrix.
fn turned(mut rows: [[f64; 3]; 3], first: usize, second: usize) -> [[f64; 3]; 3] {
    let (a, b) = (rows[first], rows[second]);
    rows[first] = core::array::from_fn(|k| (4.0 * a[k] - 3.0 * b[k]) / 5.0);
    rows[second] = core::array::from_fn(|k| (3.0 * a[k] + 4.0 * b[k]) / 5.0);
    rows
}

/// A matrix with these singular values, turned on both sides.
fn with_values(values: [f64; 3]) -> Jacobian<f64, 3> {
    let diagonal = core::array::from_fn(|row| {
        core::array::from_fn(|column| if row == column { values[row] } else { 0.0 })
    });
    let rows = turned(turned(diagonal, 0, 1), 1, 2);
    let columns = super::vectors::transposed(rows);
    Jacobian::of_inputs(turned(turned(columns, 0, 2), 0, 1))
}

fn close(found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() <= tolerance * expected.abs(),
        "{found} instead of {expected}"
    );
}

#[test]
fn singular_values_are_those_that_were_put_in() {
    for values in [[3.0, 2.0, 0.5], [1.0, 1.0, 1.0], [7.0, 7.0, 1e-3]] {
        let jacobian = with_values(values);
        let found = jacobian.singular_values();
        // The entries of the matrix are rounded in proportion to the largest one.
        let rounding = 2e-15 * values[0] / values[2];
        (0..3).for_each(|k| close(found[k], values[k], rounding));
        close(jacobian.condition(), values[0] / values[2], rounding);
        close(jacobian.manipulability(), values.iter().product(), rounding);
        close(jacobian.determinant(), values.iter().product(), rounding);
    }
    let golden = Jacobian::of_results([[1.0, 1.0], [0.0, 1.0]]).singular_values();
    let ratio = 0.5 * (1.0 + 5.0_f64.sqrt());
    close(golden[0], ratio, 1e-15);
    close(golden[1], 1.0 / ratio, 1e-15);
}

#[test]
fn small_singular_values_keep_their_digits() {
    // Columns of very different lengths, by exact powers of two: (3, 4) and (4, -3) / 2^40, turned
    // against each other.
    let small = 2.0_f64.powi(-40);
    let jacobian = Jacobian::of_inputs([[3.0, 4.0], [4.0 * small, -3.0 * small]]);
    let [large, least] = jacobian.singular_values();
    close(large, 5.0, 1e-15);
    close(least, 5.0 * small, 1e-15);
}

#[test]
fn both_ways_undo_each_other() {
    let jacobian = with_values([5.0, 0.3, 0.02]);
    let rates = [0.3, -1.7, 0.9];
    let back = jacobian.inputs_of(jacobian.results_of(rates));
    (0..3).for_each(|k| close(back[k], rates[k], 1e-13));
    let inverse = jacobian.inverse();
    let rates_of_inverse = inverse.results_of(jacobian.results_of(rates));
    (0..3).for_each(|k| close(rates_of_inverse[k], rates[k], 1e-13));
    // The work of efforts in the inputs is that of loads in the results.
    let loads = [4.0, 1.0, -2.0];
    let efforts = jacobian.efforts(loads);
    let work = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    close(
        work(efforts, rates),
        work(loads, jacobian.results_of(rates)),
        1e-12,
    );
    let again = jacobian.loads(efforts);
    (0..3).for_each(|k| close(again[k], loads[k], 1e-12));
}

#[test]
fn signs_of_determinants_are_right() {
    let swapped = Jacobian::of_results([[0.0, 2.0], [3.0, 0.0]]);
    close(swapped.determinant(), -6.0, 1e-15);
    let zero: Jacobian<f64, 2> = Jacobian::of_results([[0.0, 2.0], [0.0, 5.0]]);
    assert_eq!(zero.determinant(), 0.0);
    assert!(zero.condition().is_infinite());
    assert!(zero.inputs_of([1.0, 1.0]).iter().any(|x| !x.is_finite()));
    let odd = Jacobian::of_results([[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0_f32]]);
    assert!((odd.determinant() + 1.0).abs() < 1e-6);
    let alone = Jacobian::of_results([[-4.0]]);
    assert_eq!([alone.determinant(), alone.condition()], [-4.0, 1.0]);
}

#[test]
fn units_are_taken_out() {
    let jacobian = Jacobian::of_results([[6.0, 8.0], [1.0, 2.0]]).in_units([2.0, 1.0], [1.0, 0.5]);
    assert_eq!(jacobian.rows(), [[3.0, 2.0], [1.0, 1.0]]);
}

#[test]
fn zeros_poles_and_ends_are_told_apart() {
    // Zero at 0.3, a pole with a change of sign at 1.1, a root's pole that ends at 2.
    let slope = |x: f64| (x - 0.3) / (1.1 - x) / (2.0 - x).sqrt();
    let found = singularities(|x| Jacobian::of_results([[slope(x)]]), [0.0, 3.0], 40);
    let expected = [
        (0.3, SingularityKind::First),
        (1.1, SingularityKind::Second),
        (2.0, SingularityKind::Second),
    ];
    let found: Vec<_> = found
        .iter()
        .map(|jacobian| (jacobian.at, jacobian.kind))
        .collect();
    assert_eq!(found.len(), expected.len());
    for ((at, kind), (known, expected)) in found.into_iter().zip(expected) {
        close(at, known, 1e-15);
        assert_eq!(kind, expected);
    }
    // A root's pole at 2, of which the last stretch is not served: a hundredth of a step, and a
    // tenth.
    for (rest, kind) in [
        (1e-3, SingularityKind::Second),
        (1e-2, SingularityKind::End),
    ] {
        let served = |x: f64| {
            if x > 2.0 - rest {
                f64::NAN
            } else {
                3.0 / (2.0 - x).sqrt()
            }
        };
        let ends = singularities(|x| Jacobian::of_results([[served(x)]]), [0.0, 3.0], 30);
        assert_eq!(ends.len(), 1);
        close(ends[0].at, 2.0 - rest, 1e-15);
        assert_eq!(ends[0].kind, kind, "{rest}");
    }
    let ends = singularities(
        |x: f64| Jacobian::of_results([[if x < 0.7 { f64::NAN } else { 2.0 + x }]]),
        [0.0, 1.0],
        8,
    );
    assert_eq!(ends.len(), 1);
    close(ends[0].at, 0.7, 1e-15);
    assert_eq!(ends[0].kind, SingularityKind::End);
}
