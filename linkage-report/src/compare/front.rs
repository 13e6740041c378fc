//! The Pareto front of designs.

use std::vec::Vec;

/// The designs that no other one beats: none is as good in all objectives and better in one.
/// `values` are those of each design, the smaller the better; a design with a number that is not
/// finite is none of the best.
pub(super) fn front(values: &[Vec<f64>]) -> Vec<bool> {
    let beats = |a: &[f64], b: &[f64]| {
        let pairs = || a.iter().zip(b);
        pairs().all(|(a, b)| a <= b) && pairs().any(|(a, b)| a < b)
    };
    let is_whole = |figures: &[f64]| figures.iter().all(|x| x.is_finite());
    let best = |figures: &Vec<f64>| {
        is_whole(figures)
            && !values
                .iter()
                .any(|other| is_whole(other) && beats(other, figures))
    };
    values.iter().map(best).collect()
}

#[cfg(test)]
mod tests {
    use super::front;
    use std::vec;

    #[test]
    fn nobody_beats_the_best() {
        let values = vec![
            vec![1.0, 5.0],
            vec![2.0, 3.0],
            vec![2.0, 4.0],
            vec![4.0, 1.0],
            vec![f64::NAN, 0.0],
            vec![2.0, 3.0],
            vec![f64::NEG_INFINITY, 0.0],
        ];
        assert_eq!(
            front(&values),
            [true, true, false, true, false, true, false]
        );
    }

    #[test]
    fn a_third_wish_saves_what_two_give_up() {
        let two = vec![vec![1.0, 1.0], vec![2.0, 2.0]];
        assert_eq!(front(&two), [true, false]);
        let three = vec![vec![1.0, 1.0, 1.0], vec![2.0, 2.0, 0.0]];
        assert_eq!(front(&three), [true, true]);
    }
}
