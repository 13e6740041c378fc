//! Sweeps give the rows of single calls: every length, every place, every scalar, over inputs and over mechanisms.

mod inputs;
mod sets;
mod space;

use linkage::{Scalar, mechanism};
use linkage_random::Random;

mechanism! {
    /// Crank-rocker with a coupler point.
    pub struct Rocker {
        unit mm;
        param crank = 40mm;
        param coupler = 120mm;
        param rocker = 80mm;
        param pivot = (100mm, 5mm);
        param arm = 60mm;
        param lift = 30deg;
        input phi = 40deg in 0deg..360deg;
        unknown theta = 20deg;
        unknown psi = 60deg;
        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = pivot + polar(rocker, psi);
        let tracer = a + polar(arm, theta + lift);
    }
    impl Rocker {
        pub fn motion(phi) -> RockerMotion { tracer, v: velocity(tracer), psi, margin: margin() }
    }
}

mechanism! {
    /// Two inputs, and more columns than most.
    pub struct FiveBar {
        unit mm;
        param crank_1 = 30mm;
        param crank_2 = 25mm;
        param rod_1 = 90mm;
        param rod_2 = 85mm;
        param frame = 80mm;
        input phi = 70deg in 0deg..360deg;
        input phase = 25deg in -60deg..60deg;
        unknown alpha = 42deg;
        unknown beta = 76deg;
        let point = polar(crank_1, phi) + polar(rod_1, alpha);
        loop point = (frame, 0) + polar(crank_2, 2 * phi + phase) + polar(rod_2, beta);
    }
    impl FiveBar {
        pub fn motion(phi, phase) -> FiveBarMotion { point, v: velocity(point), a: acceleration(point) }
    }
}

mechanism! {
    /// Drag link: the driven crank turns with the driving one, and counts its turns.
    pub struct DragLink {
        unit mm;
        param frame = 20mm;
        param driving = 50mm;
        param coupler = 45mm;
        param driven = 60mm;
        input phi = 60deg in 0deg..720deg;
        unknown theta = 178deg;
        unknown psi = 130deg;
        loop polar(driving, phi) + polar(coupler, theta) = (frame, 0) + polar(driven, psi);
        let half = polar(driven, psi / 2);
    }
    impl DragLink {
        pub fn angles(phi) -> DragAngles { psi, half }
    }
}

/// Numbers of a `RockerMotion`.
const WIDTH: usize = 6;

/// A row by a single call.
fn single<T: Scalar>(linkage: &RockerAssembly<T>, phi: T) -> [T; WIDTH] {
    numbers(&linkage.motion(phi))
}

fn numbers<T: Scalar>(motion: &RockerMotion<T>) -> [T; WIDTH] {
    let RockerMotion {
        tracer,
        v,
        psi,
        margin,
    } = *motion;
    [tracer.x, tracer.y, v.x, v.y, psi, margin]
}

/// All rows by a sweep.
fn swept<T: Scalar>(linkage: &RockerAssembly<T>, phi: &[T]) -> Vec<[T; WIDTH]> {
    linkage
        .motion_sweep(phi)
        .iter()
        .map(|row| numbers(&row))
        .collect()
}

/// Each number to the last bit; all NaN are one.
fn bits<T: Scalar>(rows: &[[T; WIDTH]]) -> Vec<[u64; WIDTH]> {
    let number = |x: T| match x.lane(0) {
        x if x.is_nan() => u64::MAX,
        x => x.to_bits(),
    };
    rows.iter().map(|row| row.map(number)).collect()
}

/// Checks that two rows agree to four units of roundoff `unit` of the sizes of the mechanism: lengths and velocities of
/// up to 200, angles.
fn check_row<T: Scalar>(found: [T; WIDTH], known: [T; WIDTH], unit: f64, what: &str) {
    let sizes = [200.0, 200.0, 200.0, 200.0, 4.0, 4.0];
    for ((found, known), size) in found.into_iter().zip(known).zip(sizes) {
        let (found, known) = (found.lane(0), known.lane(0));
        let near = (found - known).abs() <= 4.0 * unit * size;
        assert!(
            near || found.is_nan() && known.is_nan(),
            "{what}: {found}, not {known}"
        );
    }
}

fn angles<T: Scalar>(random: &mut Random, count: usize) -> Vec<T> {
    (0..count).map(|_| T::from_f64(random.turn())).collect()
}

// Lengths that do not belong together.

#[test]
#[should_panic(expected = "motion_sweep: `phi` has 3 elements, `phase` has 2")]
fn inputs_of_different_lengths() {
    let linkage = FiveBar::default().assemble().expect("it assembles");
    let _ = linkage.motion_sweep(&[1.0; 3], &[0.1; 2]);
}

#[test]
#[should_panic(expected = "motion_sweep_slices: there are 5 positions, but slice 4 has 4 elements")]
fn a_slice_that_is_too_short() {
    let linkage = Rocker::default().assemble().expect("it assembles");
    let mut buffer = [0.0; 29];
    let mut rest = &mut buffer[..];
    let slices = [5, 5, 5, 5, 4, 5].map(|len| {
        let (slice, behind) = std::mem::take(&mut rest).split_at_mut(len);
        rest = behind;
        slice
    });
    linkage.motion_sweep_slices(&[1.0; 5], slices);
}

#[test]
#[should_panic(
    expected = "motion_sweep_sets: there are 4 mechanisms, but `phase` has 3 elements; give it 4 or 1"
)]
fn neither_one_input_nor_one_for_each_mechanism() {
    let linkage = FiveBar::default().assemble().expect("it assembles");
    let _ = linkage.motion_sweep_sets(&[FiveBar::default(); 4], &[1.0], &[0.1; 3]);
}

#[test]
#[should_panic(
    expected = "motion_sweep_sets: there are 2 mechanisms, but `phi` has 0 elements; give it 2 or 1"
)]
fn no_input_for_mechanisms() {
    let linkage = Rocker::default().assemble().expect("it assembles");
    let _ = linkage.motion_sweep_sets(&[Rocker::default(); 2], &[]);
}

#[test]
#[should_panic(expected = "motion_sweep_into: `phi` has 3 elements, `phase` has 2")]
fn inputs_of_different_lengths_into_columns() {
    let linkage = FiveBar::default().assemble().expect("it assembles");
    linkage.motion_sweep_into(&[1.0; 3], &[0.1; 2], &mut Default::default());
}

#[test]
#[should_panic(
    expected = "motion_sweep_sets_into: there are 4 mechanisms, but `phase` has 3 elements; give it 4 or 1"
)]
fn inputs_for_mechanisms_into_columns() {
    let linkage = FiveBar::default().assemble().expect("it assembles");
    let mechanisms = [FiveBar::default(); 4];
    linkage.motion_sweep_sets_into(&mechanisms, &[1.0], &[0.1; 3], &mut Default::default());
}

// Other scalars: their sweeps are single calls, one after the other.

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
            assert_eq!(row, numbers(&sets.get(index)), "set {index} of {len}");
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
