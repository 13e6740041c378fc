//! Over inputs.

use super::{
    FiveBar, Random, Rocker, RockerAssembly, RockerMotionColumns, WIDTH, angles, bits, check_row,
    numbers, single, swept,
};
use linkage::Scalar;

/// Lengths around blocks of 8, 16, 32 and 64 rows, and all short ones.
fn lengths() -> impl Iterator<Item = usize> {
    let around = |blocks: usize| 64 * blocks - 2..64 * blocks + 3;
    (0..=100).chain([2, 3, 5, 16].into_iter().flat_map(around))
}

fn every_length<T: Scalar>(unit: f64) {
    let linkage = Rocker::default()
        .cast::<T>()
        .assemble()
        .expect("it assembles");
    let mut random = Random::new(1);
    for len in lengths() {
        let phi: Vec<T> = angles(&mut random, len);
        let rows = swept(&linkage, &phi);
        assert_eq!(rows.len(), len);
        for (row, (found, &phi)) in rows.into_iter().zip(&phi).enumerate() {
            check_row(
                found,
                single(&linkage, phi),
                unit,
                &format!("row {row} of {len}"),
            );
        }
    }
}

#[test]
fn every_length_gives_the_rows_of_single_calls() {
    every_length::<f64>(f64::EPSILON);
    every_length::<f32>(f32::EPSILON.into());
}

/// So few rows are single calls.
const CALLS: usize = 3;

/// All rows by single calls.
fn called<T: Scalar>(linkage: &RockerAssembly<T>, phi: &[T]) -> Vec<[T; WIDTH]> {
    phi.iter().map(|&phi| single(linkage, phi)).collect()
}

fn every_place<T: Scalar>() {
    let linkage = Rocker::default()
        .cast::<T>()
        .assemble()
        .expect("it assembles");
    let mut random = Random::new(2);
    let mut phi: Vec<T> = angles(&mut random, 300);
    phi[17] = T::from_f64(f64::NAN);
    phi[250] = T::from_f64(f64::INFINITY);
    let all = bits(&swept(&linkage, &phi));
    assert!(
        all[17]
            .iter()
            .chain(&all[250])
            .all(|bits| *bits == u64::MAX)
    );
    for _ in 0..300 {
        let start = random.below(300);
        let end = start + random.below(301 - start);
        let part = bits(&swept(&linkage, &phi[start..end]));
        let expected = match end - start {
            0..=CALLS => bits(&called(&linkage, &phi[start..end])),
            _ => all[start..end].to_vec(),
        };
        assert_eq!(part, expected, "{start}..{end}");
    }
}

#[test]
fn a_row_is_the_same_wherever_it_stands() {
    every_place::<f64>();
    every_place::<f32>();
}

/// A single call has the instruction set that a sweep has, whatever the build's flags are; its sines are rounded in the same way in single
/// precision.
#[test]
fn a_row_is_that_of_a_single_call_to_the_last_bit_in_single_precision() {
    let linkage = Rocker::default()
        .cast::<f32>()
        .assemble()
        .expect("it assembles");
    let phi: Vec<f32> = angles(&mut Random::new(3), 300);
    assert_eq!(bits(&swept(&linkage, &phi)), bits(&called(&linkage, &phi)));
}

#[test]
fn slices_are_filled_and_nothing_beside_them() {
    let linkage = Rocker::default().assemble().expect("it assembles");
    let mut random = Random::new(3);
    for len in lengths() {
        let phi: Vec<f64> = angles(&mut random, len);
        let start = random.below(9);
        let mut buffers: [Vec<f64>; WIDTH] = std::array::from_fn(|_| vec![-7.0; len + 16]);
        let slices = buffers
            .each_mut()
            .map(|buffer| &mut buffer[start..start + len]);
        linkage.motion_sweep_slices(&phi, slices);
        let columns = linkage.motion_sweep(&phi);
        let rows: Vec<_> = columns.iter().map(|row| numbers(&row)).collect();
        for (column, buffer) in buffers.iter().enumerate() {
            let (before, rest) = buffer.split_at(start);
            let (inside, behind) = rest.split_at(len);
            assert!(before.iter().chain(behind).all(|x| *x == -7.0), "{len}");
            // So few columns are single calls.
            let apart = if len <= CALLS { 1e-12 } else { 0.0 };
            let differs = |x: f64, row: &[f64; WIDTH]| (x - row[column]).abs() > apart;
            let mut pairs = inside.iter().zip(&rows);
            assert!(!pairs.any(|(x, row)| differs(*x, row)), "{len}");
        }
    }
}

#[test]
fn columns_can_be_used_again() {
    let linkage = Rocker::default().assemble().expect("it assembles");
    let mut columns = RockerMotionColumns::new();
    assert!(columns.is_empty());
    for len in [40, 3, 0, 100, 64, 1] {
        let phi: Vec<f64> = angles(&mut Random::new(len as u64), len);
        linkage.motion_sweep_into(&phi, &mut columns);
        assert_eq!(columns, linkage.motion_sweep(&phi));
        assert_eq!((columns.len(), columns.psi().len()), (len, len));
    }
}

#[test]
fn two_inputs_go_side_by_side() {
    let linkage = FiveBar::default().assemble().expect("it assembles");
    let mut random = Random::new(4);
    for len in [1, 31, 32, 70] {
        let phi: Vec<f64> = angles(&mut random, len);
        let phase: Vec<f64> = (0..len).map(|_| random.between(-1.0, 1.0)).collect();
        let columns = linkage.motion_sweep(&phi, &phase);
        for (row, found) in columns.iter().enumerate() {
            let known = linkage.motion(phi[row], phase[row]);
            let near = |a: linkage::Vector2<f64>, b: linkage::Vector2<f64>, size: f64| {
                assert!((a - b).norm() <= 4.0 * f64::EPSILON * size, "{a} {b}");
            };
            near(found.point, known.point, 200.0);
            for i in 0..2 {
                near(found.v[i], known.v[i], 400.0);
                for j in 0..2 {
                    near(found.a[i][j], known.a[i][j], 2000.0);
                }
            }
        }
    }
}

// On many threads: the same to the last bit.

fn rows<T: Scalar>(columns: &RockerMotionColumns<T>) -> Vec<[u64; super::WIDTH]> {
    let rows: Vec<_> = columns.iter().map(|row| numbers(&row)).collect();
    bits(&rows)
}

fn lengths_about_tasks() -> impl Iterator<Item = usize> {
    let around = |tasks: usize| 2048 * tasks - 1..2048 * tasks + 2;
    [0, 1, 40, 1500]
        .into_iter()
        .chain([1, 2, 3, 5].into_iter().flat_map(around))
}

fn same<T: Scalar + Send + Sync>() {
    let mechanism = Rocker::default().cast::<T>();
    let linkage = mechanism.assemble().expect("it assembles");
    let mut columns = RockerMotionColumns::new();
    for len in lengths_about_tasks() {
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
