//! Over mechanisms.

use super::{DragLink, Random, Rocker, WIDTH, angles, bits, check_row, numbers, single};
use linkage::{Scalar, mechanism};

/// Dimensions within some per cent of the default ones.
fn similar<T: Scalar>(random: &mut Random) -> Rocker<T> {
    let mut of = |nominal: f64| T::from_f64(nominal * random.between(0.97, 1.03));
    let mut rocker = Rocker::default().cast::<T>();
    rocker.crank = of(40.0);
    rocker.coupler = of(120.0);
    rocker.rocker = of(80.0);
    rocker.pivot.x = of(100.0);
    rocker.pivot.y = of(5.0);
    rocker.arm = of(60.0);
    rocker.lift = of(0.5);
    rocker
}

fn swept<T: Scalar>(sets: &[Rocker<T>], phi: &[T]) -> Vec<[T; WIDTH]> {
    let linkage = Rocker::default()
        .cast::<T>()
        .assemble()
        .expect("it assembles");
    let columns = linkage.motion_sweep_sets(sets, phi);
    columns.iter().map(|row| numbers(&row)).collect()
}

fn every_length<T: Scalar>(unit: f64) {
    let mut random = Random::new(5);
    for len in (0..=70).chain([95, 96, 97, 129]) {
        let sets: Vec<Rocker<T>> = (0..len).map(|_| similar(&mut random)).collect();
        let phi: Vec<T> = angles(&mut random, len);
        let rows = swept(&sets, &phi);
        assert_eq!(rows.len(), len);
        for (index, row) in rows.into_iter().enumerate() {
            let known = single(&sets[index].assemble().expect("it assembles"), phi[index]);
            check_row(row, known, unit, &format!("row {index} of {len}"));
        }
    }
}

#[test]
fn every_set_is_as_if_assembled_by_itself() {
    every_length::<f64>(f64::EPSILON);
    every_length::<f32>(f32::EPSILON.into());
}

#[test]
fn one_element_is_for_all() {
    let mut random = Random::new(6);
    for len in [0, 1, 2, 31, 32, 33, 100] {
        let sets: Vec<Rocker> = (0..len).map(|_| similar(&mut random)).collect();
        let repeated = bits(&swept(&sets, &vec![1.25; len]));
        assert_eq!(bits(&swept(&sets, &[1.25])), repeated, "{len}");
    }
}

#[test]
fn a_set_is_the_same_wherever_it_stands() {
    let mut random = Random::new(7);
    let sets: Vec<Rocker> = (0..200).map(|_| similar(&mut random)).collect();
    let phi: Vec<f64> = angles(&mut random, 200);
    let all = bits(&swept(&sets, &phi));
    for _ in 0..100 {
        let start = random.below(200);
        let end = start + random.below(201 - start);
        let part = bits(&swept(&sets[start..end], &phi[start..end]));
        assert_eq!(part, all[start..end], "{start}..{end}");
    }
}

#[test]
fn what_cannot_be_assembled_is_nan_in_its_row_alone() {
    let mut random = Random::new(8);
    let mut sets: Vec<Rocker> = (0..100).map(|_| similar(&mut random)).collect();
    let good = swept(&sets, &[0.7]);
    for set in sets.iter_mut().step_by(7) {
        set.pivot.x = 1000.0;
        assert!(set.assemble().is_err());
    }
    sets[1].crank = f64::NAN;
    for (index, (row, good)) in swept(&sets, &[0.7]).into_iter().zip(good).enumerate() {
        let bad = index % 7 == 0 || index == 1;
        assert!(
            row.iter().all(|x| x.is_nan() == bad),
            "row {index}: {row:?}"
        );
        assert!(bad || row == good, "row {index}");
    }
}

#[test]
fn the_mode_is_that_of_the_assembly() {
    let [_, other] = Rocker::default().assemblies().expect("both assemble")[..] else {
        panic!("a dyad has two assemblies");
    };
    let mut random = Random::new(9);
    let sets: Vec<Rocker> = (0..40).map(|_| similar(&mut random)).collect();
    let columns = other.motion_sweep_sets(&sets, &[0.7]);
    for (row, set) in columns.iter().zip(&sets) {
        let assemblies = set.assemblies().expect("both assemble");
        let known = assemblies
            .iter()
            .find(|linkage| linkage.modes() == other.modes());
        let known = single(known.expect("it has both modes"), 0.7);
        check_row(numbers(&row), known, f64::EPSILON, "other mode");
    }
}

#[test]
fn angles_count_their_turns() {
    let linkage = DragLink::default().assemble().expect("it assembles");
    let mut random = Random::new(10);
    let mut of = |nominal: f64| nominal * random.between(0.98, 1.02);
    let sets: Vec<DragLink> = (0..150)
        .map(|_| DragLink {
            frame: of(20.0),
            driving: of(50.0),
            coupler: of(45.0),
            driven: of(60.0),
        })
        .collect();
    // Six turns, three more than the range of the input has on one side.
    let phi: Vec<f64> = (0..150).map(|row| 0.25 * f64::from(row) - 6.0).collect();
    let mut previous = f64::NEG_INFINITY;
    for (index, row) in linkage.angles_sweep_sets(&sets, &phi).iter().enumerate() {
        let known = sets[index]
            .assemble()
            .expect("it assembles")
            .angles(phi[index]);
        assert!(
            (row.psi - known.psi).abs() <= 8.0 * f64::EPSILON * 40.0,
            "row {index}"
        );
        assert!(
            (row.half - known.half).norm() <= 8.0 * f64::EPSILON * 60.0 * 40.0,
            "row {index}"
        );
        assert!(row.psi > previous - 0.2, "row {index}");
        previous = row.psi;
    }
    assert!(previous > 30.0);
}

// Exactly parallel guides have no solution, however multiply-adds are rounded.

mechanism! {
    /// A point on two guides, one of which turns.
    pub struct Guides {
        unit mm;
        param beta = 100deg;
        param target = (70mm, 30mm);
        input phi = 10deg in 0deg..90deg;
        unknown s = 75mm;
        unknown t = 17mm;
        loop polar(s, phi) + polar(t, beta) = target;
    }
    impl Guides {
        pub fn slides(phi) -> Slides { s, t, slope: d(s, phi) }
    }
}

/// Sines that are compared are the same ones everywhere.
#[test]
fn rows_of_guides_are_single_calls_to_the_last_bit() {
    let linkage = Guides::default().assemble().expect("closes");
    let angles: Vec<f64> = (0..1000).map(|i| 0.0017 * f64::from(i)).collect();
    let rows = linkage.slides_sweep(&angles);
    let bits = |slides: Slides| [slides.s, slides.t, slides.slope].map(f64::to_bits);
    for (row, phi) in angles.into_iter().enumerate() {
        assert_eq!(bits(rows.get(row)), bits(linkage.slides(phi)), "{phi}");
    }
}

#[test]
fn parallel_guides_have_no_position() {
    let angles: Vec<f64> = (1..400).map(|i| 0.004 * f64::from(i)).collect();
    for &beta in &angles {
        let nominal = Guides::default();
        let linkage = nominal.assemble().expect("closes");
        let parallel = Guides { beta, ..nominal };
        let single = match parallel.assemble() {
            Ok(linkage) => linkage.slides(beta),
            Err(error) => panic!("{error}"),
        };
        let row = linkage.slides_sweep_sets(&[parallel], &[beta]).get(0);
        for slides in [single, row] {
            assert!(
                !slides.s.is_finite() && !slides.t.is_finite() && !slides.slope.is_finite(),
                "{beta}: {slides:?}"
            );
        }
    }
}
