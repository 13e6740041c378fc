//! Tolerances of least cost.

use linkage_analysis::tolerance::{
    Addition, Allocation, AllocationRule, Components, Costs, Requirement, Tolerances,
};

use super::allocation::{ADDITIONS, requirements, rules};
use super::eye_needle::parameters;
use super::{lengths, near};
use linkage_random::Random;

#[test]
fn least_cost_is_certified() {
    for addition in ADDITIONS {
        for requirement in requirements(addition) {
            for rule in &rules()[5..] {
                let found = requirement
                    .allocate(&parameters(), rule)
                    .expect("it is possible");
                let (cost, least) = costs(&found);
                assert!(
                    least <= cost && cost <= least * (1.0 + 1e-6),
                    "{addition:?} {cost} {least}"
                );
            }
        }
    }
}

/// No other rule with the same limit is cheaper.
#[test]
fn least_cost_is_least() {
    let cost = |found: &Allocation<13>| -> f64 {
        let tolerances = found.tolerances.values();
        parameters()
            .iter()
            .zip(tolerances)
            .map(|(p, t)| p.tolerance / t)
            .sum()
    };
    for addition in ADDITIONS {
        for requirement in requirements(addition) {
            let allocate = |rule| {
                requirement
                    .allocate(&parameters(), &rule)
                    .expect("possible")
            };
            let costs: Vec<f64> = rules()
                .into_iter()
                .map(|rule| cost(&allocate(rule)))
                .collect();
            assert!(
                costs.iter().all(|&other| costs[5] <= other * (1.0 + 1e-6)),
                "{costs:?}"
            );
        }
    }
}

fn costs<const N: usize>(found: &Allocation<N>) -> (f64, f64) {
    let least = found
        .least_possible_cost
        .expect("it is the rule of least cost");
    (found.cost.expect("it is the rule of least cost"), least)
}

/// One scalar result: the closed forms of Lagrange's multiplier.
#[test]
fn closed_forms() {
    let sensitivities = [0.5, -2.0, 0.1];
    let rule = AllocationRule::LeastCost(Costs {
        cost: [1.0, 2.0, 0.5],
        exponent: [1.0; 3],
    });
    let allocate = |addition| {
        let requirement = Requirement::new(0.1, addition)
            .position(&sensitivities)
            .expect("finite");
        requirement
            .allocate(&lengths::<3>(), &rule)
            .expect("it is possible")
    };
    // Worst case: t = L sqrt(c / |e|) / sum of sqrt(c |e|).
    let worst = allocate(Addition::WorstCase);
    let sum = 0.5_f64.sqrt() + 4.0_f64.sqrt() + 0.05_f64.sqrt();
    let known = [2.0_f64, 1.0, 5.0].map(|ratio| 0.1 * ratio.sqrt() / sum);
    for (t, known) in worst.tolerances.values().into_iter().zip(known) {
        near(t, known, 1e-13 * known);
    }
    // Statistical: t^3 in proportion to c / e^2.
    let statistical = allocate(Addition::Statistical).tolerances.values();
    let shape = [1.0 / 0.25, 2.0 / 4.0, 0.5 / 0.01_f64].map(f64::cbrt);
    let squares = shape
        .iter()
        .zip(sensitivities)
        .map(|(t, e)| (t * e).powi(2));
    let factor = 0.1 / squares.sum::<f64>().sqrt();
    for (t, shape) in statistical.into_iter().zip(shape) {
        near(t, factor * shape, 1e-13 * t);
    }
}

/// Exponents that differ: each cost falls at the same price per error.
#[test]
fn different_exponents() {
    let (e, exponent) = ([0.5, -2.0, 0.1, 1.0], [1.0, 2.0, 0.5, 3.0]);
    let cost = [1.0, 2.0, 0.5, 1e-3];
    let requirement = Requirement::new(0.1, Addition::WorstCase)
        .position(&e)
        .expect("it is finite");
    let rule = AllocationRule::LeastCost(Costs { cost, exponent });
    let found = requirement
        .allocate(&lengths::<4>(), &rule)
        .expect("it is possible");
    let t = found.tolerances.values();
    let price = |i: usize| exponent[i] * cost[i] / t[i].powf(exponent[i] + 1.0) / f64::abs(e[i]);
    for i in 1..4 {
        near(price(i) / price(0), 1.0, 1e-9);
    }
    let (cost, least) = costs(&found);
    near(least / cost, 1.0, 1e-9);
}

/// By modulus in the plane and in space: nothing nearby is cheaper.
#[test]
fn no_neighbour_is_cheaper() {
    let mut random = Random::new(5);
    for _ in 0..10 {
        let e: [[f64; 3]; 5] =
            std::array::from_fn(|_| std::array::from_fn(|_| random.between(-1.0, 1.0)));
        let cost: [f64; 5] = std::array::from_fn(|_| random.between(0.1, 2.0));
        let exponent: [f64; 5] = std::array::from_fn(|_| random.between(0.5, 2.0));
        let requirement = Requirement::new(0.1, Addition::WorstCase)
            .position(&e)
            .expect("it is finite");
        let rule = AllocationRule::LeastCost(Costs { cost, exponent });
        let found = requirement
            .allocate(&lengths::<5>(), &rule)
            .expect("it is possible");
        let (best, least) = costs(&found);
        assert!(best <= least * (1.0 + 1e-6), "{best} {least}");
        for _ in 0..300 {
            let shape = found
                .tolerances
                .values()
                .map(|t| t * random.between(0.8, 1.2));
            let other = Tolerances::new(&lengths::<5>(), &shape);
            let factor = 0.1 / requirement.error_of(&other.expect("they are valid"));
            let total: f64 = (0..5)
                .map(|i| cost[i] / (factor * shape[i]).powf(exponent[i]))
                .sum();
            assert!(total >= best * (1.0 - 1e-6), "{total} {best}");
        }
    }
}

/// Effects, costs and exponents of very different sizes, one position and several.
#[test]
fn certified_at_any_scale() {
    for seed in 0..12 {
        for positions in [1, 6] {
            at_any_scale::<1, 2>(seed, positions);
            at_any_scale::<6, 1>(seed, positions);
            at_any_scale::<9, 2>(seed, positions);
            at_any_scale::<5, 3>(seed, positions);
        }
    }
}

fn at_any_scale<const N: usize, const K: usize>(seed: u64, positions: usize)
where
    [f64; K]: Components<K>,
{
    let mut random = Random::new(seed);
    let mut size = || 10.0_f64.powf(random.between(-3.0, 3.0));
    let effect: [f64; N] = std::array::from_fn(|_| size());
    let cost: [f64; N] = std::array::from_fn(|_| size());
    let exponent = std::array::from_fn(|_| random.between(0.3, 4.0));
    let mut row = |scale: f64| std::array::from_fn(|_| scale * random.between(-1.0, 1.0));
    let rows: Vec<[[f64; K]; N]> = (0..positions).map(|_| effect.map(&mut row)).collect();
    for addition in ADDITIONS {
        let whole = Requirement::new(0.02, addition)
            .over(rows.clone())
            .expect("it is finite");
        for requirement in [whole.clone(), whole.by_component()] {
            let rule = AllocationRule::LeastCost(Costs { cost, exponent });
            let found = requirement
                .allocate(&lengths::<N>(), &rule)
                .expect("it is possible");
            let (cost, least) = costs(&found);
            assert!(
                found.error <= 0.02 && cost <= least * (1.0 + 1e-6),
                "{seed} {cost} {least}"
            );
        }
    }
}

/// Components that depend on different parameters.
#[test]
fn each_component_limits_its_own() {
    let effects = [[1.0, 0.0], [2.0, 0.0], [0.0, 1e-3]];
    let requirement = Requirement::new(0.1, Addition::WorstCase)
        .position(&effects)
        .expect("finite");
    let rule = AllocationRule::LeastCost(Costs {
        cost: [1.0; 3],
        exponent: [1.0; 3],
    });
    let found = requirement.by_component().allocate(&lengths::<3>(), &rule);
    let [a, b, c] = found.expect("it is possible").tolerances.values();
    near(a + 2.0 * b, 0.1, 1e-8);
    near(c, 100.0, 1e-2);
}
