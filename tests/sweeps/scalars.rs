//! Other scalars: their sweeps are single calls, one after the other.

use super::{Random, Rocker, single, swept};
use linkage::Scalar;

/// Sweeps over inputs and over mechanisms give exactly what single calls give.
fn same<T: Scalar>(lanes: impl Fn(&mut Random) -> T) {
    let mechanism = Rocker::default().cast::<T>();
    let linkage = mechanism.assemble().expect("it assembles");
    let mut random = Random::new(11);
    for len in [0, 1, 7, 40] {
        let phi: Vec<T> = (0..len).map(|_| lanes(&mut random)).collect();
        let rows = swept(&linkage, &phi);
        let sets = linkage.motion_sweep_sets(&vec![mechanism; len], &phi);
        assert_eq!((rows.len(), sets.len()), (len, len));
        for (index, row) in rows.into_iter().enumerate() {
            assert_eq!(row, single(&linkage, phi[index]), "row {index} of {len}");
            assert_eq!(
                row,
                super::numbers(&sets.get(index)),
                "set {index} of {len}"
            );
        }
    }
}

#[test]
fn dual_numbers() {
    use linkage::Dual;
    use num_dual::Dual64;

    same(|random| Dual(Dual64::new(random.between(0.0, 6.0), 1.0)));

    let linkage = Rocker::default().cast().assemble().expect("it assembles");
    let phi: Vec<Dual<Dual64>> = (0..40)
        .map(|row| Dual(Dual64::new(0.15 * f64::from(row), 1.0)))
        .collect();
    for motion in linkage.motion_sweep(&phi).iter() {
        assert!((motion.tracer.x.0.eps - motion.v.x.0.re).abs() < 1e-12);
        assert!((motion.tracer.y.0.eps - motion.v.y.0.re).abs() < 1e-12);
    }
}

#[test]
fn lanes() {
    use linkage::Lanes;
    use simba::simd::{AutoF64x4, WideF64x4};

    same(|random| Lanes::<WideF64x4>::from_lanes(|_| random.between(0.0, 6.0)));
    same(|random| Lanes::<AutoF64x4>::from_lanes(|_| random.between(0.0, 6.0)));
}
