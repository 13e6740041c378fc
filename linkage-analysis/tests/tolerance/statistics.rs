//! What samples say, for samples that are known.

use linkage_analysis::tolerance::{Estimate, MonteCarlo, Samples, Tolerances};
use linkage_runtime::{Dimensions, Parameter};

use super::near;

struct Rod;

impl Dimensions<1> for Rod {
    const PARAMETERS: &'static [Parameter] = &[Parameter {
        name: "length",
        unit: "mm",
        nominal: 1.0,
        tolerance: 0.1,
    }];

    fn from_values(_: &[f64; 1]) -> Self {
        Self
    }

    fn values(&self) -> [f64; 1] {
        [1.0]
    }
}

/// So many samples, `value` of 0, 1, 2 and so on; few enough for one block.
fn samples(count: usize, value: impl Fn(f64) -> f64 + Sync) -> Samples<1, 1> {
    let tolerances = Tolerances::complete(Rod::PARAMETERS).expect("they are valid");
    MonteCarlo::new(count)
        .run(&Rod, &tolerances, |rods, [column]| {
            assert_eq!(rods.len(), count);
            (0..)
                .zip(column)
                .for_each(|(i, x)| *x = value(f64::from(i)));
        })
        .expect("there are mechanisms")
}

fn is(found: Estimate, [value, low, high]: [f64; 3], error: f64) {
    near(found.value, value, error);
    near(found.low, low, error);
    near(found.high, high, error);
}

/// Wilson's intervals, from his formula in 20 digits. Where all lie within or none, one end is exact.
#[test]
fn parts_have_the_score_interval() {
    let ten = samples(10, |i| i);
    let within = |low: f64, high: f64| ten.part_within(0, low, high, 0.95);
    is(
        within(2.0, 4.0),
        [0.3, 0.107_791_267_406_301, 0.603_221_852_538_855],
        1e-14,
    );
    is(within(20.0, 30.0), [0.0, 0.0, 0.277_532_799_862_889], 1e-14);
    is(within(0.0, 9.0), [1.0, 0.722_467_200_137_111, 1.0], 1e-14);
    // Both limits belong to it.
    near(within(2.0, 2.0).value, 0.1, 0.0);
    near(within(2.5, 2.75).value, 0.0, 0.0);
}

#[test]
fn percentiles_are_between_their_neighbours() {
    let ten = samples(10, |i| i);
    for (part, value) in [(0.5, 4.5), (0.25, 2.25), (0.9, 8.1), (1.0 / 9.0, 1.0)] {
        near(ten.percentile(0, part, 0.95).value, value, 1e-14);
    }
    // The second and the ninth of ten samples enclose the median with 95 %, as tables of order statistics say; of six the
    // first and the last; five are too few.
    is(ten.percentile(0, 0.5, 0.95), [4.5, 1.0, 8.0], 1e-14);
    is(
        samples(6, |i| i).percentile(0, 0.5, 0.95),
        [2.5, 0.0, 5.0],
        1e-14,
    );
    let few = samples(5, |i| i).percentile(0, 0.5, 0.95);
    assert_eq!((few.low, few.high), (f64::NEG_INFINITY, f64::INFINITY));
}

/// Mean, deviation and their intervals for 0 to 9: variance 55 / 6, kurtosis 1.775757.
#[test]
fn statistics_of_ten_numbers() {
    let ten = samples(10, |i| i).statistics(0);
    is(
        ten.mean,
        [4.5, 2.623_477_350_975_23, 6.376_522_649_024_77],
        1e-13,
    );
    is(
        ten.deviation,
        [
            3.027_650_354_097_49,
            2.201_256_977_691_41,
            3.854_043_730_503_57,
        ],
        1e-13,
    );
    assert_eq!(
        (ten.min, ten.max, ten.count, ten.missing),
        (0.0, 9.0, 10, 0)
    );
    // Two values only: the variance of the variance is 0.
    let sign = samples(10, |i| if i % 2.0 == 0.0 { 1.0 } else { -1.0 }).statistics(0);
    let deviation = (10.0_f64 / 9.0).sqrt();
    is(sign.deviation, [deviation; 3], 1e-14);
    // All equal.
    let same = samples(10, |_| 3.0).statistics(0);
    is(same.deviation, [0.0; 3], 0.0);
    is(same.mean, [3.0; 3], 0.0);
}

/// What cannot be assembled counts for the part, and for nothing else.
#[test]
fn missing_samples_are_not_within() {
    let half = samples(10, |i| if i % 2.0 == 0.0 { i } else { f64::NAN });
    near(half.part_within(0, 0.0, 9.0, 0.95).value, 0.5, 0.0);
    near(half.percentile(0, 0.5, 0.95).value, 4.0, 0.0);
    let statistics = half.statistics(0);
    assert_eq!((statistics.count, statistics.missing), (5, 5));
    near(statistics.mean.value, 4.0, 1e-15);
}
