//! Proof that a state is a solution and that there is no other one beside it.

use super::Residuals;
use crate::numeric::inverse::inverse;
use crate::numeric::roots::Variable;
use crate::scalar::Enclosure;
use alloc::vec::Vec;

/// The box in which a solution is alone: half its side is tried from the largest to the smallest
/// one.
const LARGEST: f64 = 1e-2;
/// The accuracy of a solution below which it counts as a multiple one for numbers of 16 digits.
const SMALLEST: f64 = 1e-10;
const SMALLER: f64 = 0.1;

/// The rounding error of each product in a sum; twice the largest possible one.
const ROUNDING: f64 = f64::EPSILON;

/// Half the side of a box about a state in which exactly one solution is, if that can be proven:
/// the largest of some.
///
/// Over the box, `state - C F(state) + (1 - C F')(box - state)` contains all solutions in it, where
/// `F'` bounds all derivatives there and `C` is any matrix, best the inverse of one of them. If it
/// is inside the box there is a solution, and no second one (R. Krawczyk, *Newton-Algorithmen zur
/// Bestimmung von Nullstellen mit Fehlerschranken*, 1969).
pub(super) fn isolation(
    residuals: &mut dyn Residuals,
    variables: &[Variable],
    x: &[f64],
    state: &[f64],
) -> Option<f64> {
    let mut equations = Equations {
        residuals,
        variables,
        x,
        state,
    };
    let missed = equations.missed()?;
    let mut half = LARGEST;
    while half >= SMALLEST {
        if equations.holds_one(&missed, half) {
            return Some(half);
        }
        half *= SMALLER;
    }
    None
}

/// The equations about a state: those of the group, then the lengths of its unit vectors.
struct Equations<'e> {
    residuals: &'e mut dyn Residuals,
    variables: &'e [Variable],
    x: &'e [f64],
    state: &'e [f64],
}

/// Between a centre less and plus a radius.
struct Ball {
    centre: f64,
    radius: f64,
}

impl Ball {
    fn around([low, high]: [f64; 2]) -> Self {
        let centre = 0.5 * low + 0.5 * high;
        let radius = (high - centre).max(centre - low).next_up();
        Self { centre, radius }
    }

    fn size(&self) -> f64 {
        self.centre.abs() + self.radius
    }
}

impl Equations<'_> {
    fn values(&mut self, state: &[Enclosure]) -> Vec<Enclosure> {
        let mut all = self.residuals.residuals(self.x, state);
        let mut index = 0;
        for variable in self.variables {
            index += match variable {
                Variable::Unit => {
                    let [cos, sin] = [state[index], state[index + 1]];
                    all.push(cos * cos + sin * sin - Enclosure::between(1.0, 1.0));
                    2
                }
                _ => 1,
            };
        }
        all
    }

    /// Returns bounds of the errors of the equations in the state; none if they are not as many as
    /// its numbers.
    fn missed(&mut self) -> Option<Vec<f64>> {
        let state = self.state.iter().map(|&x| Enclosure::between(x, x));
        let values = self.values(&state.collect::<Vec<_>>()).into_iter();
        let missed: Vec<f64> = values
            .map(|value| Ball::around(value.range()).size())
            .collect();
        let is_known = missed.len() == self.state.len() && missed.iter().all(|x| x.is_finite());
        is_known.then_some(missed)
    }

    /// The derivatives by each number of the state over a box, by column.
    fn slopes(&mut self, half: f64) -> Vec<Vec<Ball>> {
        let ends = self.state.iter().map(|&x| [x - half, x + half]);
        let ends: Vec<[f64; 2]> = ends.collect();
        let beside: Vec<Enclosure> = ends
            .iter()
            .map(|&[a, b]| Enclosure::between(a, b))
            .collect();
        let columns = ends.iter().enumerate().map(|(column, &[low, high])| {
            let mut state = beside.clone();
            state[column] = Enclosure::over(low, high);
            let values = self.values(&state).into_iter();
            values.map(|value| Ball::around(value.slopes())).collect()
        });
        columns.collect()
    }

    /// Returns whether exactly one solution is in a box.
    fn holds_one(&mut self, missed: &[f64], half: f64) -> bool {
        let slopes = self.slopes(half);
        let count = missed.len();
        let centres: Vec<Vec<f64>> = (0..count)
            .map(|row| slopes.iter().map(|column| column[row].centre).collect())
            .collect();
        let Some(inverse) = inverse(centres) else {
            return false;
        };
        let most = 2.0 * (count as f64) * ROUNDING;
        inverse.iter().enumerate().all(|(row, weights)| {
            let off: f64 = weights.iter().zip(missed).map(|(w, x)| w.abs() * x).sum();
            let left = slopes.iter().enumerate().map(|(column, slopes)| {
                let start = if row == column { 1.0 } else { 0.0 };
                let parts = || weights.iter().zip(slopes);
                let centre: f64 = parts().fold(start, |left, (w, slope)| left - w * slope.centre);
                let sizes: f64 = parts().map(|(w, slope)| w.abs() * slope.size()).sum();
                let aside: f64 = parts().map(|(w, slope)| w.abs() * slope.radius).sum();
                centre.abs() + aside + most * (start + sizes)
            });
            let left: f64 = left.sum();
            // Sums of positive numbers; not true where one is not known.
            (1.0 + most) * (off + left * half) < half
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::continuation::{Correction, Step};
    use alloc::vec;

    /// Two links of length 1 from `(0, 0)` and `(d, 0)` meet: the direction of the first, and how
    /// far up they meet.
    struct Triangle;

    impl Correction for Triangle {
        fn correct(&mut self, _: &[f64], _: &mut [f64]) -> Step {
            unreachable!("nothing is corrected")
        }
    }

    impl Residuals for Triangle {
        fn residuals(&mut self, x: &[f64], state: &[Enclosure]) -> Vec<Enclosure> {
            let one = Enclosure::between(1.0, 1.0);
            let [cos, sin, height] = [state[0], state[1], state[2]];
            let away = cos - Enclosure::between(x[0], x[0]);
            vec![away * away + sin * sin - one, height - sin]
        }
    }

    const VARIABLES: [Variable; 2] = [Variable::Unit, Variable::Length];

    fn alone(d: f64, state: [f64; 3]) -> Option<f64> {
        isolation(&mut Triangle, &VARIABLES, &[d], &state)
    }

    #[test]
    fn a_solution_is_alone_up_to_about_where_the_other_one_is() {
        // At d = 2 both solutions meet; before, they are 2 sin apart.
        for (sin, least) in [
            (0.8, 1e-2),
            (1e-2, 1e-3),
            (1e-3, 1e-4),
            (1e-5, 1e-6),
            (1e-7, 1e-8),
        ] {
            let cos = (1.0_f64 - sin * sin).sqrt();
            let half = alone(2.0 * cos, [cos, sin, sin]).expect("it is proven");
            assert!(
                half >= 0.99 * least && half < sin,
                "{half:e} beside {sin:e}"
            );
        }
    }

    #[test]
    fn what_is_no_solution_or_a_double_one_is_not_proven() {
        assert_eq!(alone(2.0, [1.0, 0.0, 0.0]), None);
        // Off by more than the largest box.
        assert_eq!(alone(1.2, [0.8, 0.6, 0.6]), None);
        assert_eq!(alone(1.2, [f64::NAN, 0.8, 0.8]), None);
        // What is off by little is near a solution.
        assert!(alone(1.2, [0.6 + 1e-5, 0.8, 0.8]).is_some_and(|half| half > 1e-4));
        // Links that do not reach each other.
        assert_eq!(alone(2.0 + 1e-12, [1.0, 0.0, 0.0]), None);
    }
}
