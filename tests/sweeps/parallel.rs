//! On many threads: the same to the last bit.

use super::{Random, Rocker, RockerMotionColumns, angles, bits, numbers};
use linkage::Scalar;

fn rows<T: Scalar>(columns: &RockerMotionColumns<T>) -> Vec<[u64; super::WIDTH]> {
    let rows: Vec<_> = columns.iter().map(|row| numbers(&row)).collect();
    bits(&rows)
}

fn lengths() -> impl Iterator<Item = usize> {
    let around = |tasks: usize| 2048 * tasks - 1..2048 * tasks + 2;
    [0, 1, 40, 1500]
        .into_iter()
        .chain([1, 2, 3, 5].into_iter().flat_map(around))
}

fn same<T: Scalar + Send + Sync>() {
    let mechanism = Rocker::default().cast::<T>();
    let linkage = mechanism.assemble().expect("it assembles");
    let mut columns = RockerMotionColumns::new();
    for len in lengths() {
        let mut random = Random::new(len as u64);
        let phi: Vec<T> = angles(&mut random, len);
        linkage.motion_sweep_parallel_into(&phi, &mut columns);
        assert_eq!(rows(&columns), rows(&linkage.motion_sweep(&phi)), "{len}");

        let mut sets = vec![mechanism; len];
        for set in &mut sets {
            set.arm = T::from_f64(random.between(50.0, 70.0));
        }
        linkage.motion_sweep_sets_parallel_into(&sets, &phi, &mut columns);
        assert_eq!(
            rows(&columns),
            rows(&linkage.motion_sweep_sets(&sets, &phi)),
            "{len}"
        );
        linkage.motion_sweep_sets_parallel_into(&sets, &phi[..len.min(1)], &mut columns);
        let serial = linkage.motion_sweep_sets(&sets, &phi[..len.min(1)]);
        assert_eq!(rows(&columns), rows(&serial), "{len}");
    }
}

#[test]
fn parallel_sweeps_are_the_same() {
    same::<f64>();
    same::<f32>();
}
