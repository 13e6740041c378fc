//! No other masses do better: against search, against random masses, by conditions of optimality.

use linkage_analysis::balancing::{Balance, Components};

use super::near;
use linkage_random::Random;

type Data<const N: usize, const K: usize> = (Vec<[f64; K]>, Vec<[[f64; K]; N]>);

fn data<const N: usize, const K: usize>(random: &mut Random, count: usize) -> Data<N, K> {
    let mut vector = || core::array::from_fn(|_| random.between(-1.0, 1.0));
    let forces = (0..count).map(|_| vector()).collect();
    let effects = (0..count).map(|_| core::array::from_fn(|_| vector()));
    (forces, effects.collect())
}

/// The lowest value of a convex function between -10 and 10.
fn lowest(f: impl Fn(f64) -> f64) -> f64 {
    let (mut low, mut high) = (-10.0, 10.0);
    for _ in 0..90 {
        let third = (high - low) / 3.0;
        if f(low + third) < f(high - third) {
            high -= third;
        } else {
            low += third;
        }
    }
    f(0.5 * (low + high))
}

#[test]
fn search_in_two_variables_finds_the_same() {
    let mut random = Random::new(3);
    for count in [4, 9, 25] {
        let (forces, effects) = data::<2, 2>(&mut random, count);
        let balance = Balance::new(&forces, &effects).expect("it is valid");
        let peak = lowest(|x| lowest(|y| balance.figures(&[x, y]).peak));
        let found = balance.peak().expect("it is regular");
        near(found.after.peak, peak, 1e-9);
        assert!(found.bound <= peak && found.bound >= peak * (1.0 - 1e-9));
        let rms = lowest(|x| lowest(|y| balance.figures(&[x, y]).rms));
        let found = balance.mean_square().expect("it is regular");
        near(found.after.rms, rms, 1e-12);
    }
}

fn check<const N: usize, const K: usize>(random: &mut Random, count: usize)
where
    [f64; K]: Components<K>,
{
    let (forces, effects) = data::<N, K>(random, count);
    let balance = Balance::new(&forces, &effects).expect("it is valid");
    let peak = balance.peak().expect("it is regular");
    let mean = balance.mean_square().expect("it is regular");
    if N < count * K {
        assert!(
            peak.after.peak - peak.bound <= 1e-9 * peak.after.peak,
            "{peak:?}"
        );
    }
    assert!(peak.bound <= peak.after.peak && peak.after.peak <= peak.before.peak);
    assert!(mean.after.rms <= peak.after.rms + 1e-14 && peak.after.peak <= mean.after.peak + 1e-14);
    assert_eq!(mean.before, peak.before);

    // What the mean square leaves is perpendicular to all effects.
    for j in 0..N {
        let terms = forces.iter().zip(&effects).flat_map(|(force, row)| {
            (0..K).map(|k| {
                let sum: f64 = row.iter().zip(mean.values).map(|(e, z)| e[k] * z).sum();
                (force[k] + sum) * row[j][k]
            })
        });
        near(terms.sum(), 0.0, 1e-12 * count as f64);
    }
    // Other masses, near and far.
    for i in 0..60 {
        let size = 10_f64.powf(1.0 - f64::from(i) / 6.0);
        let change: [f64; N] = core::array::from_fn(|_| size * random.between(-1.0, 1.0));
        let other = |values: [f64; N]| core::array::from_fn(|j| values[j] + change[j]);
        assert!(balance.figures(&other(peak.values)).peak >= peak.bound);
        let rms = balance.figures(&other(mean.values)).rms;
        assert!(rms >= mean.after.rms * (1.0 - 1e-14));
    }
}

#[test]
fn no_other_masses_do_better() {
    let mut random = Random::new(5);
    for count in [6, 7, 12, 60] {
        for _ in 0..8 {
            check::<1, 1>(&mut random, count);
            check::<2, 1>(&mut random, count);
            check::<6, 1>(&mut random, count);
            check::<2, 2>(&mut random, count);
            check::<5, 2>(&mut random, count);
            check::<3, 3>(&mut random, count);
            check::<6, 3>(&mut random, count);
        }
    }
}

/// Forces of a slider-crank with a short rod, to high harmonics; masses on the crank and one on the rod.
#[test]
fn shaking_forces_of_a_slider_crank() {
    let harmonic = |phi: f64, n: f64, size: f64| size * (n * phi).cos();
    for count in [24, 360, 1440] {
        let forces: Vec<_> = super::angles(count)
            .map(|phi| {
                let along = harmonic(phi, 1.0, 800.0) + harmonic(phi, 2.0, 280.0);
                [along + harmonic(phi, 4.0, -25.0), 120.0 * phi.sin()]
            })
            .collect();
        let effects: Vec<_> = super::angles(count)
            .zip(super::crank(count))
            .map(|(phi, [a, b])| [a, b, [phi.cos() + 0.3 * (2.0 * phi).cos(), 0.4 * phi.sin()]])
            .collect();
        let balance = Balance::new(&forces, &effects).expect("it is valid");
        let found = balance.peak().expect("it is regular");
        assert!(found.after.peak - found.bound < 1e-11 * found.after.peak);
        assert!(found.after.peak < 0.5 * found.before.peak, "{found}");
    }
}
