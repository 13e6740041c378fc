//! Random mechanisms.

use linkage_analysis::tolerance::{Distribution, MonteCarlo, Samples, ToleranceError, Tolerances};
use linkage_runtime::{Dimensions, Parameter};

use super::near;

/// A triangle from its three sides: the height over the third, NaN if they do not close.
pub(super) struct Triangle(pub(super) [f64; 3]);

impl Dimensions<3> for Triangle {
    const PARAMETERS: &'static [Parameter] = &[
        side("a", 30.0, 0.03),
        side("b", 40.0, 0.06),
        side("c", 50.0, 0.0),
    ];

    fn from_values(values: &[f64; 3]) -> Self {
        Self(*values)
    }

    fn values(&self) -> [f64; 3] {
        self.0
    }
}

const fn side(name: &'static str, nominal: f64, tolerance: f64) -> Parameter {
    Parameter {
        name,
        unit: "mm",
        nominal,
        tolerance,
    }
}

impl Triangle {
    pub(super) fn foot(&self) -> f64 {
        let [a, b, c] = self.0;
        (a * a - b * b + c * c) / (2.0 * c)
    }

    pub(super) fn height(&self) -> f64 {
        (self.0[0].powi(2) - self.foot().powi(2)).sqrt()
    }
}

pub(super) const NOMINAL: Triangle = Triangle([30.0, 40.0, 50.0]);

pub(super) fn tolerances() -> Tolerances<3> {
    Tolerances::declared(Triangle::PARAMETERS).expect("they are valid")
}

pub(super) fn apex(triangles: &[Triangle], [x, y]: [&mut [f64]; 2]) {
    for (i, triangle) in triangles.iter().enumerate() {
        (x[i], y[i]) = (triangle.foot(), triangle.height());
    }
}

pub(super) fn study(study: MonteCarlo) -> Samples<3, 2> {
    study
        .run(&NOMINAL, &tolerances(), apex)
        .expect("there are mechanisms")
}

fn on_threads(threads: usize, count: usize) -> Samples<3, 2> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .expect("threads");
    pool.install(|| study(MonteCarlo::new(count).seed(11)))
}

#[test]
fn equal_on_any_number_of_threads() {
    let one = on_threads(1, 10_000);
    assert_eq!(one, on_threads(2, 10_000));
    assert_eq!(one, on_threads(5, 10_000));
    // A longer study begins with the shorter one.
    assert_eq!(one.values(1)[..9000], on_threads(3, 9000).values(1)[..]);
    assert_ne!(one, study(MonteCarlo::new(10_000).seed(12)));
}

/// The derivatives of foot and height by both sides that have a tolerance.
fn sensitivities() -> [[f64; 2]; 3] {
    let [a, b, c] = NOMINAL.0;
    let (x, y) = (NOMINAL.foot(), NOMINAL.height());
    let by_a = [a / c, (a - x * a / c) / y];
    let by_b = [-b / c, x * b / c / y];
    [by_a, by_b, [0.0, 0.0]]
}

#[test]
fn agreement_with_the_linear_analysis() {
    let effects = tolerances().effects(&sensitivities());
    for distribution in [
        Distribution::Normal,
        Distribution::Uniform,
        Distribution::Triangular,
    ] {
        let samples = study(MonteCarlo::new(100_000).distribution(distribution));
        for agreement in samples.agreement(&effects, [NOMINAL.foot(), NOMINAL.height()]) {
            assert!(agreement.within(0.001), "{distribution:?}\n{agreement}");
            near(agreement.ratio(), 1.0, 0.01);
            near(agreement.shift.value, 0.0, 4.0 * agreement.linear / 316.0);
            if distribution != Distribution::Normal {
                assert!(
                    agreement.farthest <= 1.001 * agreement.worst_case,
                    "{agreement}"
                );
            }
        }
    }
}

#[test]
fn a_distribution_for_each_parameter() {
    let of = |index| MonteCarlo::new(50_000).distribution_of(index, Distribution::Uniform);
    let deviation = |samples: &Samples<3, 2>| samples.statistics(0).deviation.value;
    let [a, b]: [f64; 2] = [0.6 * 0.03, 0.8 * 0.06];
    near(
        deviation(&study(of(0))),
        (a * a / 3.0 + b * b / 9.0).sqrt(),
        3e-4,
    );
    near(
        deviation(&study(of(1))),
        (a * a / 9.0 + b * b / 3.0).sqrt(),
        3e-4,
    );
    let refused = of(3)
        .run(&NOMINAL, &tolerances(), apex)
        .expect_err("it does not exist");
    assert_eq!(
        refused,
        ToleranceError::NoSuchParameter { index: 3, count: 3 }
    );
}

#[test]
fn percentiles_of_a_uniform_distribution() {
    let samples = MonteCarlo::new(40_000)
        .distribution(Distribution::Uniform)
        .run(&NOMINAL, &tolerances(), |triangles, [side]| {
            for (triangle, side) in triangles.iter().zip(side) {
                *side = triangle.0[1];
            }
        });
    let samples = samples.expect("there are mechanisms");
    for part in [0.01, 0.5, 0.9, 0.999] {
        let known = 39.94 + 0.12 * part;
        let found = samples.percentile(0, part, 0.999);
        assert!(found.low <= known && known <= found.high, "{part}: {found}");
        assert!(found.low <= found.value && found.value <= found.high);
        assert!(found.high - found.low < 0.004, "{found}");
    }
    let within = samples.part_within(0, 39.97, 40.03, 0.999);
    assert!(within.low < 0.5 && 0.5 < within.high && within.high - within.low < 0.02);
    assert!(samples.percentile(0, 1.5, 0.95).value.is_nan());
    assert_eq!(samples.percentile(0, 1e-9, 0.95).low, f64::NEG_INFINITY);
}

#[test]
fn what_cannot_be_assembled_is_counted() {
    // A flat triangle: about half of them do not close.
    let flat = Triangle([30.0, 20.0, 50.0]);
    let samples = MonteCarlo::new(20_000)
        .run(&flat, &tolerances(), apex)
        .expect("mechanisms");
    let [x, y] = [0, 1].map(|k| samples.statistics(k));
    assert_eq!((x.missing, x.count), (0, 20_000));
    assert!(
        y.missing > 9000 && y.missing < 11_000 && y.count + y.missing == 20_000,
        "{y}"
    );
    assert_eq!(samples.missing(), y.missing);
    assert!(y.mean.value > 0.0 && y.min >= 0.0);
    assert!(
        samples
            .part_within(1, f64::NEG_INFINITY, f64::INFINITY, 0.95)
            .value
            < 0.6
    );

    let never = Triangle([1.0, 1.0, 50.0]);
    let samples = MonteCarlo::new(100)
        .run(&never, &tolerances(), apex)
        .expect("mechanisms");
    let none = samples.statistics(1);
    assert_eq!((none.count, none.missing), (0, 100));
    assert!(none.mean.value.is_nan() && none.min.is_nan());
    assert!(samples.percentile(1, 0.5, 0.95).value.is_nan());
}

#[test]
fn progress_ends_with_all() {
    let mut seen = Vec::new();
    let reporting = MonteCarlo::new(30_000).progress(|progress| seen.push(progress));
    drop(study(reporting));
    assert!(seen.is_sorted_by_key(|p| p.done) && seen.iter().all(|p| p.count == 30_000));
    assert_eq!(seen.last().map(|p| p.done), Some(30_000));
}

#[test]
fn nothing_to_draw() {
    let refused = MonteCarlo::new(0).run(&NOMINAL, &tolerances(), apex);
    assert!(matches!(refused, Err(ToleranceError::Nothing { .. })));
    let one = study(MonteCarlo::new(1));
    assert_eq!(one.statistics(0).count, 1);
    assert!(one.statistics(0).deviation.value.is_nan());
}
