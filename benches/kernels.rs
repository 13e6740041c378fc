//! The kernels K1 and K2: `cargo bench -p linkage-benches --bench kernels`, some of them with a filter such as
//! `-- k1_motion`.
//!
//! "Single" is one position at a time: the results pass through `black_box`, so that no two positions
//! are computed together. The rows of this table are timed one after the other;
//! `cargo bench -p linkage-benches --bench ratios` times them in turn, which is better for comparisons.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use linkage_peers::{Motion, Position, Sensitivities1, Sensitivities2, c, mechanisms as m};
use std::f64::consts::TAU;

/// Positions in one run.
const POSITIONS: usize = 1024;

fn main() {
    divan::main();
}

fn angles() -> Vec<f64> {
    let step = TAU / POSITIONS as f64;
    (0..POSITIONS).map(|i| i as f64 * step).collect()
}

macro_rules! kernel {
    ($name:ident: $mechanism:ident, $dimensions:ident, $function:ident, $sweep:ident, $into:ident, $numbers:ty) => {
        mod $name {
            use super::*;

            #[divan::bench]
            fn single(bencher: Bencher) {
                let linkage = m::$mechanism::default().assemble().expect("it assembles");
                let angles = angles();
                bencher.counter(ItemsCount::new(POSITIONS)).bench_local(|| {
                    for &phi in &angles {
                        black_box(&linkage.$function(phi));
                    }
                });
            }

            #[divan::bench]
            fn sweep(bencher: Bencher) {
                let linkage = m::$mechanism::default().assemble().expect("it assembles");
                let angles = angles();
                let mut columns = linkage.$sweep(&angles);
                bencher.counter(ItemsCount::new(POSITIONS)).bench_local(|| {
                    linkage.$into(black_box(&angles), &mut columns);
                    black_box(&mut columns);
                });
            }

            #[divan::bench]
            fn c_single(bencher: Bencher) {
                let kernel = c::$mechanism::new(m::$dimensions(&m::$mechanism::default()));
                let angles = angles();
                let mut numbers: $numbers = [0.0; _];
                bencher.counter(ItemsCount::new(POSITIONS)).bench_local(|| {
                    for &phi in &angles {
                        kernel.$function(phi, &mut numbers);
                        black_box(&mut numbers);
                    }
                });
            }
        }
    };
}

kernel!(k1a_point: K1, dimensions1, point, point_sweep, point_sweep_into, Position);
kernel!(k1b_motion: K1, dimensions1, motion, motion_sweep, motion_sweep_into, Motion);
kernel!(k1c_accuracy: K1, dimensions1, accuracy, accuracy_sweep, accuracy_sweep_into, Sensitivities1);
kernel!(k2a_point: K2, dimensions2, point, point_sweep, point_sweep_into, Position);
kernel!(k2b_motion: K2, dimensions2, motion, motion_sweep, motion_sweep_into, Motion);
kernel!(k2c_accuracy: K2, dimensions2, accuracy, accuracy_sweep, accuracy_sweep_into, Sensitivities2);
