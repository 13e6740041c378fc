//! Random mechanisms in constant memory: `cargo bench -p linkage-benches --bench monte_carlo`, with `-- long` also percentiles of
//! 1e8 mechanisms beside those of all values, which takes 2 GB and a minute.
//!
//! A crank-rocker whose five lengths are normally distributed, at one position. Processor time is that of all threads, and the least of
//! some runs. Memory is the most that the process has had.

use linkage::mechanism;
use linkage::tolerance::{MonteCarlo, Stream, Tolerances};
use std::time::{Duration, Instant};

mechanism! {
    struct Rocker {
        unit mm;
        param crank = 50mm +- 12um;
        param coupler = 120mm +- 20um;
        param rocker = 100mm +- 20um;
        param frame = 140mm +- 20um;
        param arm = 70mm +- 15um;
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = (frame, 0) + polar(rocker, psi);
        let tracer = a + polar(arm, theta);
    }
    impl Rocker {
        fn height(phi) -> Height { y: tracer.y }
    }
}

/// The position.
const PHI: f64 = 1.2;

/// Limits: processor time of a mechanism in nanoseconds, memory in MB, error of a percentile in deviations.
const TIME: f64 = 20.0;
const MEMORY: u64 = 64;
const PERCENTILE: f64 = 1e-4;

fn main() {
    // As a test, once and short.
    let is_tested = std::env::args().any(|argument| argument == "--test");
    let (count, repeats) = if is_tested {
        (20_000, 1)
    } else {
        (20_000_000, 5)
    };
    println!("{count} mechanisms, five normal dimensions, one position");
    let time = row("stream", count, repeats, |count| drop(study(count)));
    let met = compared(time <= TIME);
    println!("{:<28} {TIME:6.1} ns of processor time each{met}", "limit");
    row("drawn and evaluated alone", count, repeats, evaluated);
    let memory = peak();
    let met = compared(memory <= MEMORY);
    println!("memory: {memory} MB at most, for any number of mechanisms; limit {MEMORY} MB{met}");
    row("all values, sorted", count / 10, repeats, |count| {
        drop(kept(count))
    });
    if std::env::args().any(|argument| argument == "long") {
        percentiles(100_000_000);
    }
}

fn mechanism() -> (Rocker, RockerAssembly, Tolerances<5>) {
    let nominal = Rocker::default();
    let assembly = nominal.assemble().expect("it closes");
    let tolerances = Tolerances::complete(Rocker::PARAMETERS).expect("all have one");
    (nominal, assembly, tolerances)
}

fn study(count: usize) -> Stream<5, 1> {
    let (nominal, assembly, tolerances) = mechanism();
    let results = MonteCarlo::new(count).stream(&nominal, &tolerances, |drawn, [y]| {
        y.copy_from_slice(assembly.height_sweep_sets(drawn, &[PHI]).y());
    });
    results.expect("there are mechanisms")
}

/// Draws and evaluates, with nothing to be kept but a number that is not.
fn evaluated(count: usize) {
    let (nominal, assembly, tolerances) = mechanism();
    let results = MonteCarlo::new(count).stream(&nominal, &tolerances, |drawn, []| {
        std::hint::black_box(assembly.height_sweep_sets(drawn, &[PHI]));
    });
    drop(results.expect("there are mechanisms"));
}

fn kept(count: usize) -> linkage::tolerance::Samples<5, 1> {
    let (nominal, assembly, tolerances) = mechanism();
    let results = MonteCarlo::new(count).run(&nominal, &tolerances, |drawn, [y]| {
        y.copy_from_slice(assembly.height_sweep_sets(drawn, &[PHI]).y());
    });
    results.expect("there are mechanisms")
}

/// Prints the least times of some runs. Returns the processor time of a mechanism in nanoseconds.
fn row(name: &str, count: usize, repeats: usize, work: impl Fn(usize)) -> f64 {
    let times = (0..repeats).map(|_| {
        let (wall, processor) = (Instant::now(), processor_time());
        work(count);
        (processor_time() - processor, wall.elapsed())
    });
    let (processor, wall) = times.min().expect("it ran");
    let each = |time: Duration| time.as_secs_f64() / count as f64 * 1e9;
    println!(
        "{name:<28} {:6.1} ns of processor time each, {:6.1} ns of wall time",
        each(processor),
        each(wall)
    );
    each(processor)
}

fn compared(is_met: bool) -> &'static str {
    if is_met { ", met" } else { "" }
}

/// The largest difference of two percentiles from those of all values, in deviations.
fn percentiles(count: usize) {
    let stream = study(count);
    let samples = kept(count);
    let deviation = samples.statistics(0).deviation.value;
    for part in [0.001_35, 0.998_65] {
        let [found, known] = [
            stream.percentile(0, part, 0.95),
            samples.percentile(0, part, 0.95),
        ];
        let error = (found.value - known.value).abs() / deviation;
        println!(
            "percentile {:7.3}: {error:.1e} deviations from that of all values, limit {PERCENTILE:.0e}{}",
            100.0 * part,
            compared(error <= PERCENTILE)
        );
    }
}

/// Processor time of the process, from the system's table.
fn processor_time() -> Duration {
    // User and system time in hundredths of a second, behind the name in parentheses.
    let text = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    let fields = text
        .rsplit(')')
        .next()
        .unwrap_or_default()
        .split_whitespace();
    let ticks: u64 = fields
        .skip(11)
        .take(2)
        .filter_map(|field| field.parse::<u64>().ok())
        .sum();
    Duration::from_millis(10 * ticks)
}

/// The most memory that the process has had, in MB.
fn peak() -> u64 {
    let text = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = text.lines().find(|line| line.starts_with("VmHWM"));
    let kilobytes = line.and_then(|line| line.split_whitespace().nth(1)?.parse::<u64>().ok());
    kilobytes.unwrap_or(0) / 1024
}
