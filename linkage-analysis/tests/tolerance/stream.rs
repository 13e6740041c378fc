//! Random mechanisms that are not kept.

use linkage_analysis::tolerance::{
    Distribution, MonteCarlo, Stream, Study, ToleranceError, Uncertainties,
};
use std::time::Duration;

use super::monte_carlo::{NOMINAL, Triangle, apex, study, tolerances};
use super::near;

const COUNT: usize = 20_500;

fn streamed(study: MonteCarlo) -> Stream<3, 2> {
    study
        .stream(&NOMINAL, &tolerances(), apex)
        .expect("there are mechanisms")
}

fn whole() -> Stream<3, 2> {
    streamed(MonteCarlo::new(COUNT).seed(11))
}

fn on_threads<R: Send>(threads: usize, work: impl FnOnce() -> R + Send) -> R {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
    pool.expect("threads").install(work)
}

#[test]
fn equal_on_any_number_of_threads_and_in_any_parts() {
    let whole = whole();
    assert_eq!(whole.done(), COUNT as u64);
    for threads in [1, 2, 3, 7] {
        assert!(
            whole == on_threads(threads, self::whole),
            "{threads} threads"
        );
    }
    for of in [1, 4, 9] {
        let part = |part| streamed(MonteCarlo::new(COUNT).seed(11).part(part, of));
        // The last one first, then those with even numbers, then the others.
        let order = (0..of).rev().take(1).chain((0..of - 1).step_by(2));
        let order = order.chain((1..of - 1).step_by(2));
        let merged = order.map(part).reduce(|mut all, part| {
            all.merge(&part).expect("another part");
            all
        });
        assert!(merged == Some(whole.clone()), "{of} parts");
    }
}

#[test]
fn results_are_those_of_all_values() {
    let (samples, stream) = (study(MonteCarlo::new(COUNT).seed(11)), whole());
    assert_eq!(stream.missing() as usize, samples.missing());
    for k in [0, 1] {
        let (found, known) = (stream.statistics(k), samples.statistics(k));
        let deviation = known.deviation.value;
        assert_eq!(found.count, known.count);
        near(found.mean.value, known.mean.value, 1e-12 * deviation);
        near(found.mean.high, known.mean.high, 1e-12 * deviation);
        near(found.deviation.value, deviation, 1e-12 * deviation);
        near(found.deviation.low, known.deviation.low, 1e-11 * deviation);
        near(found.skewness, known.skewness, 1e-10);
        assert_eq!((found.min, found.max), (known.min, known.max));
        near(stream.resolution(k), deviation / 16384.0, deviation / 5e5);
        let mut sorted = samples.values(k).to_vec();
        sorted.sort_unstable_by(f64::total_cmp);
        for part in [0.0001, 0.00135, 0.5, 0.9, 0.99865] {
            let found = stream.percentile(k, part, 0.95);
            let known = samples.percentile(k, part, 0.95);
            // Anywhere between the two neighbours: they are far apart where there are few.
            let rank = part * (sorted.len() - 1) as f64;
            let [below, above] = [rank.floor(), rank.ceil()].map(|rank| sorted[rank as usize]);
            let slack = stream.resolution(k);
            assert!(
                below - slack <= found.value && found.value <= above + slack,
                "{found}"
            );
            assert!(
                found.low <= known.low && known.low <= found.low + slack,
                "{found} {known}"
            );
            assert!(
                known.high <= found.high && found.high <= known.high + slack,
                "{found} {known}"
            );
        }
        let [low, high] = [
            known.mean.value - 0.7 * deviation,
            known.mean.value + 2.0 * deviation,
        ];
        let found = stream.part_within(k, low, high, 0.95);
        let exact = samples.part_within(k, low, high, 0.95);
        near(found.value, exact.value, 1e-4);
        near(found.low, exact.low, 1e-4);
    }
}

#[test]
fn extremes_have_their_mechanisms() {
    let (samples, stream) = (study(MonteCarlo::new(COUNT).seed(11)), whole());
    for k in [0, 1] {
        let values = samples.values(k);
        for extreme in stream.extremes(k).expect("there are values") {
            let first = values.iter().position(|&x| x == extreme.value);
            assert_eq!(first, Some(extreme.number as usize));
            let triangle = Triangle(extreme.dimensions);
            assert_eq!([triangle.foot(), triangle.height()][k], extreme.value);
        }
    }
}

#[test]
fn a_histogram_has_all_values() {
    let (samples, stream) = (study(MonteCarlo::new(COUNT).seed(11)), whole());
    let values = samples.values(1);
    let [low, high] = [24.0 - 0.05, 24.0 + 0.05];
    let histogram = stream.histogram(1, [low, high], 20);
    let width = (high - low) / 20.0;
    for (j, count) in histogram.iter().enumerate() {
        let [from, to] = [j, j + 1].map(|j| low + width * j as f64);
        let known = values.iter().filter(|&&x| from <= x && x < to).count() as f64;
        near(*count, known, 8.0);
    }
    let all = stream.histogram(1, [0.0, 100.0], 3);
    near(all.iter().sum(), COUNT as f64, 1e-6);
}

/// A sum of the sides: normal with a known deviation, and three distributions with known ones.
#[test]
fn linear_mechanisms_have_their_closed_forms() {
    let sum = |triangles: &[Triangle], [sum]: [&mut [f64]; 1]| {
        for (triangle, sum) in triangles.iter().zip(sum) {
            *sum = triangle.0[0] - triangle.0[1];
        }
    };
    for distribution in [
        Distribution::Normal,
        Distribution::TruncatedNormal,
        Distribution::Arcsine,
    ] {
        let study = MonteCarlo::new(100_000).distribution(distribution);
        let stream = study
            .stream(&NOMINAL, &tolerances(), sum)
            .expect("mechanisms");
        let known = distribution.deviation() * 0.03_f64.hypot(0.06);
        let found = stream.statistics(0);
        near(found.mean.value, -10.0, 4.0 * known / 316.0);
        near(found.deviation.value, known, 4.0 * known / 316.0);
        near(found.skewness, 0.0, 0.04);
        let limit = if distribution == Distribution::Normal {
            f64::INFINITY
        } else {
            0.09
        };
        assert!(found.max + 10.0 <= limit + 1e-12 && found.max + 10.0 > 1.5 * known);
    }
}

#[test]
fn measured_deviations_are_drawn() {
    let measured = [0.01, 0.02, -0.03, 0.0, 0.005];
    let side = |triangles: &[Triangle], [side]: [&mut [f64]; 1]| {
        for (triangle, side) in triangles.iter().zip(side) {
            *side = triangle.0[2];
        }
    };
    let study = MonteCarlo::new(40_000).measured(2, &measured);
    let stream = study
        .stream(&NOMINAL, &tolerances(), side)
        .expect("mechanisms");
    let found = stream.statistics(0);
    assert!(found.min >= 49.97 && found.min < 49.9702 && found.max <= 50.02);
    // A quarter of all is between two neighbours, evenly.
    for (part, known) in [(0.125, -0.015), (0.25, 0.0), (0.5, 0.005), (0.75, 0.01)] {
        near(stream.percentile(0, part, 0.95).value, 50.0 + known, 4e-4);
    }
    let refused = MonteCarlo::new(10).measured(1, &[0.0, f64::NAN]);
    let error = refused
        .stream(&NOMINAL, &tolerances(), apex)
        .expect_err("no number");
    assert!(matches!(
        error,
        ToleranceError::Measurement {
            index: 1,
            number: 1,
            ..
        }
    ));
}

#[test]
fn correlated_dimensions() {
    let uncertain = Uncertainties::new(&tolerances(), Distribution::Normal);
    let uncertain = uncertain
        .correlations(&[(0, 1, 1.0)])
        .expect("it is possible");
    let study = MonteCarlo::new(20_000).start_correlated(
        &NOMINAL,
        &uncertain,
        |triangles: &[Triangle], [rest]: [&mut [f64]; 1]| {
            for (triangle, rest) in triangles.iter().zip(rest) {
                // Twice as far as the first side, always.
                *rest = (triangle.0[1] - 40.0) - 2.0 * (triangle.0[0] - 30.0);
            }
        },
    );
    let stream = study.expect("all is normal").finish();
    let [least, largest] = stream.extremes(0).expect("there are values");
    assert!(least.value > -1e-12 && largest.value < 1e-12);
}

#[test]
fn a_study_goes_on_where_it_stopped() {
    let study = || -> Study<3, 2> {
        let study = MonteCarlo::new(COUNT).seed(11).part(1, 2);
        study
            .start(&NOMINAL, &tolerances(), apex)
            .expect("there are mechanisms")
    };
    let known = study().finish();
    let mut first = study();
    first.advance(Duration::ZERO);
    assert!(first.results().done() > 0 && !first.is_done());
    let bytes = first.results().to_bytes();
    let mut second = study();
    let read = second
        .results()
        .read(&bytes)
        .expect("they are of this study");
    assert!(&read == first.results());
    second.merge(&read).expect("nothing is there yet");
    assert!(second.merge(&read) == Err(ToleranceError::Repeated));
    let mut steps = 0;
    while !second.is_done() {
        second.advance(Duration::ZERO);
        steps += 1;
    }
    assert!(steps > 1);
    assert!(second.results() == &known);
}

#[test]
fn bytes_of_something_else() {
    let stream = whole();
    let bytes = stream.to_bytes();
    assert!(bytes.len() < 300_000, "{}", bytes.len());
    assert!(stream.read(&bytes) == Ok(stream.clone()));
    for length in [0, 5, 16, 17, 100, bytes.len() - 1] {
        assert!(
            stream.read(&bytes[..length]) == Err(ToleranceError::NoResults),
            "{length}"
        );
    }
    let longer = [&bytes[..], &[0]].concat();
    assert!(stream.read(&longer) == Err(ToleranceError::NoResults));
    let other = streamed(MonteCarlo::new(COUNT).seed(12));
    assert!(other.read(&bytes) == Err(ToleranceError::OtherStudy));
    let mut merged = other;
    assert!(merged.merge(&stream) == Err(ToleranceError::OtherStudy));
}

/// A byte that is another one is noticed, wherever it is.
#[test]
fn bytes_with_faults_are_no_results() {
    let stream = streamed(MonteCarlo::new(2000).seed(11));
    let bytes = stream.to_bytes();
    for k in (0..bytes.len()).step_by(7) {
        for fault in [0x01, 0x80, 0xa5] {
            let mut broken = bytes.clone();
            broken[k] ^= fault;
            assert!(
                stream.read(&broken) == Err(ToleranceError::NoResults),
                "byte {k}"
            );
        }
    }
}

#[test]
fn what_cannot_be_assembled() {
    let flat = Triangle([30.0, 20.0, 50.0]);
    let run = || MonteCarlo::new(20_000);
    let stream = run()
        .stream(&flat, &tolerances(), apex)
        .expect("mechanisms");
    let samples = run().run(&flat, &tolerances(), apex).expect("mechanisms");
    assert_eq!(stream.missing() as usize, samples.missing());
    assert_eq!(stream.statistics(1).missing, samples.statistics(1).missing);
    let all = [f64::NEG_INFINITY, f64::INFINITY].map(f64::from);
    let [found, known] = [
        stream.part_within(1, all[0], all[1], 0.95),
        samples.part_within(1, all[0], all[1], 0.95),
    ];
    near(found.value, known.value, 1e-12);

    let never = Triangle([1.0, 1.0, 50.0]);
    let stream = MonteCarlo::new(100)
        .stream(&never, &tolerances(), apex)
        .expect("mechanisms");
    let none = stream.statistics(1);
    assert_eq!((none.count, none.missing), (0, 100));
    assert!(none.mean.value.is_nan() && none.min.is_nan());
    assert!(stream.percentile(1, 0.5, 0.95).value.is_nan());
    assert_eq!(stream.extremes(1), None);
}

#[test]
fn parts_that_are_not_there() {
    for [part, of] in [[0, 0], [3, 3]] {
        let study = MonteCarlo::new(100).part(part, of);
        let refused = study.stream(&NOMINAL, &tolerances(), apex);
        assert!(matches!(refused, Err(ToleranceError::NoSuchPart { .. })));
    }
    // More parts than blocks: some have none.
    let parts = (0..9).map(|part| streamed(MonteCarlo::new(3000).part(part, 9)).done());
    assert_eq!(parts.sum::<u64>(), 3000);
}

/// Progress is that of the part.
#[test]
fn progress_of_a_part() {
    let mut last = None;
    let study = MonteCarlo::new(COUNT)
        .part(1, 3)
        .progress(|progress| last = Some(progress));
    let done = streamed(study).done() as usize;
    let last = last.expect("it was reported");
    assert_eq!((last.done, last.count), (done, done));
}
