//! Against all combinations: convex sums of squares, each of whose branches has one optimum.

use super::{Local, rounded};
use crate::limits::Limits;
use core::cell::Cell;
use linkage_random::Random;
use std::vec::Vec;

const COUNT: usize = 4;
const VALUES: usize = 6;

/// A sum of squares of linear functions.
struct Sum {
    rows: Vec<([f64; COUNT], f64)>,
}

#[derive(Clone)]
struct Optimum {
    x: Vec<f64>,
    sum: f64,
}

impl Local for Optimum {
    fn varied(&self) -> &[f64] {
        &self.x
    }

    fn least(&self) -> f64 {
        self.sum
    }
}

impl Sum {
    fn sum_at(&self, x: &[f64]) -> f64 {
        let miss = |(row, target): &([f64; COUNT], f64)| {
            let sum: f64 = row.iter().zip(x).map(|(a, x)| a * x).sum();
            (sum - target) * (sum - target)
        };
        self.rows.iter().map(miss).sum()
    }

    /// The least within bounds, one variable after the other until none moves.
    fn least(&self, limits: &Limits, start: &[f64]) -> Optimum {
        let mut x = start.to_vec();
        limits.clamp(&mut x);
        for _ in 0..20_000 {
            let mut moved = 0.0_f64;
            for j in 0..COUNT {
                let (mut slope, mut bend) = (0.0, 0.0);
                for (row, target) in &self.rows {
                    let miss: f64 = row.iter().zip(&x).map(|(a, x)| a * x).sum::<f64>() - target;
                    slope += row[j] * miss;
                    bend += row[j] * row[j];
                }
                let next = (x[j] - slope / bend).clamp(limits.lower[j], limits.upper[j]);
                moved = moved.max((next - x[j]).abs());
                x[j] = next;
            }
            if moved < 1e-13 {
                break;
            }
        }
        let sum = self.sum_at(&x);
        Optimum { x, sum }
    }
}

/// Rows that are nearly parallel: the best value of one parameter depends on those of all others.
fn problem(random: &mut Random) -> (Sum, Vec<(usize, Vec<f64>)>, Limits) {
    let common: [f64; COUNT] = core::array::from_fn(|_| random.between(0.5, 1.5));
    let rows = (0..COUNT + 2).map(|_| {
        let row = common.map(|a| a + random.between(-0.3, 0.3));
        (row, random.between(8.0, 12.0))
    });
    let sum = Sum {
        rows: rows.collect(),
    };
    let list = |index: usize, random: &mut Random| {
        let mut values: Vec<f64> = (0..VALUES).map(|_| random.between(0.0, 5.0)).collect();
        values.sort_by(f64::total_cmp);
        (index, values)
    };
    let catalogues: Vec<(usize, Vec<f64>)> = (0..COUNT).map(|j| list(j, random)).collect();
    let limits = Limits {
        lower: catalogues.iter().map(|(_, values)| values[0]).collect(),
        upper: catalogues
            .iter()
            .map(|(_, values)| values[VALUES - 1])
            .collect(),
        relations: Vec::new(),
    };
    (sum, catalogues, limits)
}

#[test]
fn the_best_of_all_combinations_is_found() {
    let mut random = Random::new(31);
    let (mut far, mut descents) = (0, 0);
    for _ in 0..60 {
        let (sum, catalogues, limits) = problem(&mut random);
        let mut best = f64::INFINITY;
        for number in 0..VALUES.pow(COUNT as u32) {
            let digit = |j: usize| number / VALUES.pow(j as u32) % VALUES;
            let x: Vec<f64> = (0..COUNT).map(|j| catalogues[j].1[digit(j)]).collect();
            best = best.min(sum.sum_at(&x));
        }
        let relaxed = sum.least(&limits, &[2.0; COUNT]);
        let descend = |limits: &Limits, near: &Optimum| {
            descents += 1;
            Some(sum.least(limits, &near.x))
        };
        let found = rounded(&catalogues, &limits, relaxed.clone(), descend, &|| false)
            .expect("all combinations are allowed");
        assert!(
            (found.sum - best).abs() <= 1e-9 * best,
            "{} {best}",
            found.sum
        );
        let mut far_away = false;
        for ((index, values), x) in catalogues.iter().zip(&found.x) {
            assert!(values.contains(x), "{x} is none of {values:?}");
            let above = values.partition_point(|value| *value < relaxed.x[*index]);
            let below = values.iter().position(|value| value == x).unwrap_or(VALUES);
            far_away |= below > above || below + 1 < above;
        }
        far += usize::from(far_away);
    }
    // Many are none of the two values beside the optimum between them.
    assert!(far > 10, "{far}");
    assert!(descents < 60 * VALUES.pow(COUNT as u32) / 4, "{descents}");
}

/// Once the time is over no branch is begun any more, and the result is the best so far, or
/// nothing.
#[test]
fn it_ends_when_it_is_to() {
    let mut random = Random::new(32);
    let mut some = 0;
    for _ in 0..20 {
        let (sum, catalogues, limits) = problem(&mut random);
        let relaxed = sum.least(&limits, &[2.0; COUNT]);
        let run = |most: usize| {
            let count = Cell::new(0);
            let descend = |limits: &Limits, near: &Optimum| {
                count.set(count.get() + 1);
                Some(sum.least(limits, &near.x))
            };
            let ended = || count.get() >= most;
            let best = rounded(&catalogues, &limits, relaxed.clone(), descend, &ended);
            (count.get(), best)
        };
        let (all, best) = run(usize::MAX);
        let best = best.expect("there are values");
        assert!(run(0).1.is_none());
        let (count, half) = run(all - 1);
        assert_eq!(count, all - 1);
        if let Some(half) = half {
            some += 1;
            assert!(half.sum >= best.sum);
            let at_values = |((_, values), x): (&(usize, Vec<f64>), &f64)| values.contains(x);
            assert!(catalogues.iter().zip(&half.x).all(at_values));
        }
    }
    assert!(some > 10, "{some}");
}
