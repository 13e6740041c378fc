//! Sizes and proportions that ask for care.

use linkage_analysis::balancing::{Balance, Solution};

use super::{angles, crank, near};
use linkage_random::Random;

type Rows = (Vec<[f64; 2]>, Vec<[[f64; 2]; 3]>);

fn rows(random: &mut Random, count: usize) -> Rows {
    let mut vector = || [random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
    let forces = (0..count).map(|_| vector()).collect();
    let effects = (0..count).map(|_| [vector(), vector(), vector()]);
    (forces, effects.collect())
}

fn both<const N: usize>(balance: &Balance<N>) -> [Solution<N>; 2] {
    [balance.mean_square(), balance.peak()].map(|solution| solution.expect("it is regular"))
}

/// Forces in other units, masses in other units: the same solution in these.
#[test]
fn units_do_not_matter() {
    let mut random = Random::new(5);
    for scales in [[1e-6, 1.0, 1e6], [1e6, 1e-6, 1e6], [1e-150, 1e150, 1.0]] {
        for force in [1e-6, 1e6, 1e-150, 1e150] {
            let (forces, effects) = rows(&mut random, 20);
            let known = both(&Balance::new(&forces, &effects).expect("it is valid"));
            let scaled: Vec<_> = forces.iter().map(|f| f.map(|x| force * x)).collect();
            let effects: Vec<_> = effects
                .iter()
                .map(|row| [0, 1, 2].map(|j| row[j].map(|x| scales[j] * x)))
                .collect();
            let found = both(&Balance::new(&scaled, &effects).expect("it is valid"));
            for (found, known) in found.into_iter().zip(known) {
                near(found.after.peak / force, known.after.peak, 1e-11);
                near(found.after.rms / force, known.after.rms, 1e-6);
                near(found.bound / force, known.bound, 1e-11);
                let values = found.values.into_iter().zip(known.values);
                for ((found, known), scale) in values.zip(scales) {
                    near(found * scale / force, known, 1e-5);
                }
            }
        }
    }
}

/// One position far above the others, or most of them without effect.
#[test]
fn positions_of_very_different_size() {
    let mut random = Random::new(6);
    for outlier in [1e3, 1e6, 1e9] {
        let (mut forces, effects) = rows(&mut random, 40);
        forces[17] = forces[17].map(|x| outlier * x);
        let balance = Balance::new(&forces, &effects).expect("it is valid");
        let peak = balance.peak().expect("it is regular");
        assert!(
            peak.after.peak - peak.bound <= 1e-9 * peak.after.peak,
            "{peak:?}"
        );

        let (forces, mut effects) = rows(&mut random, 40);
        effects[4..].fill([[0.0; 2]; 3]);
        let balance = Balance::new(&forces, &effects).expect("it is valid");
        let peak = balance.peak().expect("it is regular");
        assert!(
            peak.after.peak - peak.bound <= 1e-9 * peak.after.peak,
            "{peak:?}"
        );
    }
}

/// Two masses at almost the same place, whose difference still helps.
#[test]
fn effects_that_are_almost_alike() {
    for apart in [1e-3, 1e-6, 1e-9] {
        let forces: Vec<_> = angles(72)
            .map(|phi| [phi.cos(), (2.0 * phi).sin()])
            .collect();
        let effects: Vec<_> = angles(72)
            .map(|phi| {
                let one = [phi.cos(), 0.0];
                [one, [one[0], apart * (2.0 * phi).sin()]]
            })
            .collect();
        let balance = Balance::new(&forces, &effects).expect("it is valid");
        for solution in both(&balance) {
            assert!(solution.after.peak < 1e-15 / apart, "{apart}: {solution:?}");
        }
    }
}

/// Next to nothing is left: the bound is honest down to the rounding of the forces.
#[test]
fn forces_that_almost_vanish() {
    for rest in [1e-3, 1e-6, 1e-9, 1e-12] {
        let forces: Vec<_> = angles(60)
            .map(|phi| [phi.cos() + rest * (3.0 * phi).cos(), phi.sin()])
            .collect();
        let balance = Balance::new(&forces, &crank(60)).expect("it is valid");
        let peak = balance.peak().expect("it is regular");
        near(peak.after.peak, peak.bound, 1e-13);
        assert!(peak.after.peak <= rest * (1.0 + 1e-3));
        assert!(peak.bound >= rest * 0.5, "{rest}: {peak:?}");
    }
}

/// The same position many times, and positions without force.
#[test]
fn positions_that_say_the_same() {
    let mut random = Random::new(7);
    let (mut forces, mut effects) = rows(&mut random, 10);
    let known = Balance::new(&forces, &effects).expect("it is valid").peak();
    for i in 0..50 {
        forces.push(forces[i % 10]);
        effects.push(effects[i % 10]);
        forces.push([0.0; 2]);
        effects.push([[0.0; 2]; 3]);
    }
    let found = Balance::new(&forces, &effects).expect("it is valid").peak();
    let [known, found] = [known, found].map(|solution| solution.expect("it is regular"));
    near(found.after.peak, known.after.peak, 1e-11);
    near(found.bound, known.bound, 1e-11);
}
