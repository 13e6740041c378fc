//! Makes the file of the stored solutions:
//! `UPDATE=1 cargo test --release -p linkage-synthesis --lib stored_solutions`.
//!
//! A random complex four-bar passes complex points that belong to random turns of its coupler: one
//! solution of one problem. Followed around random loops in the space of points it comes back as
//! others (monodromy), which do so in turn, until several loops bring nothing new. That these are
//! all solutions is no proof, but they are as many as the literature has. The points are then
//! changed into those that are stored.

use super::super::super::path::Pace;
use super::super::cognates::Mark;
use super::super::equations::{Shifts, Unknowns};
use super::super::path::ParameterPath;
use super::super::search::{Certificate, Data, SolutionSearch};
use super::super::{TRIPLES, stored_solutions};
use linkage_core::numeric::complex::{Complex, ZERO};
use linkage_design::internals::in_parallel;
use linkage_random::Random;
use std::println;
use std::vec::Vec;

/// Loops without a new solution before we stop.
const IDLE: usize = 6;
const MOST_LOOPS: usize = 80;

fn unit(random: &mut Random) -> Complex {
    Complex::polar(random.between(0.0, core::f64::consts::TAU))
}

fn points(random: &mut Random) -> Shifts<Complex> {
    core::array::from_fn(|_| [unit(random), unit(random)])
}

/// A four-bar and points that it passes.
fn start(random: &mut Random) -> (Unknowns<Complex>, Shifts<Complex>) {
    let mut number = || Complex::new(random.between(-1.0, 1.0), random.between(-1.0, 1.0));
    let joints: [Complex; 8] = core::array::from_fn(|_| number());
    let [x, x_hat, a, a_hat, y, y_hat, b, b_hat] = joints;
    let (first, second) = ((x - a) * (x_hat - a_hat), (y - b) * (y_hat - b_hat));
    let mut unknowns = [ZERO; 24];
    unknowns[..8].copy_from_slice(&joints);
    let shifts = core::array::from_fn(|j| {
        let t = unit(random).scaled(random.between(0.7, 1.3));
        let u = t.inverse();
        [unknowns[8 + 2 * j], unknowns[9 + 2 * j]] = [t, u];
        // The link from a to the coupler is v, that from b is v + w: v v^ and (v + w)(v^ + w^) are
        // given.
        let (w, w_hat) = (t * (y - x) - (b - a), u * (y_hat - x_hat) - (b_hat - a_hat));
        let rest = second - first - w * w_hat;
        let root = (rest * rest - (w * w_hat * first).scaled(4.0)).root();
        let v = (rest + root) * w_hat.scaled(2.0).inverse();
        [v + a - t * x, first * v.inverse() + a_hat - u * x_hat]
    });
    (unknowns, shifts)
}

fn data(shifts: &Shifts<Complex>) -> Data {
    Data {
        plain: *shifts,
        wide: shifts.map(|pair| pair.map(Complex::wide)),
        discs: shifts.map(|pair| pair.map(super::super::super::ball::Ball::exact)),
    }
}

fn middle(certificate: &Certificate) -> Unknowns<Complex> {
    certificate.discs.map(|disc| disc.middle)
}

/// The ends of all paths that have one.
fn followed(
    from: &Shifts<Complex>,
    to: &Shifts<Complex>,
    arc: Complex,
    starts: &[Unknowns<Complex>],
) -> Vec<Unknowns<Complex>> {
    let data = data(to);
    let way = ParameterPath { from, to, arc };
    let ends = in_parallel(starts, |start| {
        let attempts = (0..2).map(Pace::of_attempt);
        attempts
            .into_iter()
            .find_map(|pace| data.end(start, &way, pace))
    });
    ends.iter()
        .flatten()
        .map(|(certificate, _)| middle(certificate))
        .collect()
}

/// All solutions of some complex points.
fn monodromy(random: &mut Random) -> (Shifts<Complex>, Vec<Unknowns<Complex>>) {
    let (first, there) = start(random);
    let base = points(random);
    let shown = data(&base);
    let mut search = SolutionSearch::default();
    for end in followed(&there, &base, unit(random), &[first]) {
        shown.shown(&end).map(|end| search.index_of(end));
    }
    let mut idle = 0;
    for turn in 0..MOST_LOOPS {
        let known: Vec<_> = search
            .found
            .iter()
            .map(|(certificate, _)| middle(certificate))
            .collect();
        let other = points(random);
        let out = followed(&base, &other, unit(random), &known);
        for end in followed(&other, &base, unit(random), &out) {
            shown.shown(&end).map(|end| search.index_of(end));
        }
        let new = search.found.len() - known.len();
        println!(
            "loop {turn}: {} triples, {} paths lost",
            search.found.len(),
            known.len() - out.len()
        );
        idle = if new == 0 { idle + 1 } else { 0 };
        if idle == IDLE && search.found.len() > 1 {
            break;
        }
    }
    (
        base,
        search
            .found
            .iter()
            .map(|(certificate, _)| middle(certificate))
            .collect(),
    )
}

/// The stored points' solutions, with certificates.
fn solutions(seed: u64) -> Vec<Certificate> {
    let mut random = Random::new(seed);
    let (base, known) = monodromy(&mut random);
    let stored = stored_solutions::shifts();
    let shown = data(&stored);
    let mut search = SolutionSearch::default();
    for _ in 0..4 {
        for end in followed(&base, &stored, unit(&mut random), &known) {
            shown.shown(&end).map(|end| search.index_of(end));
        }
        println!("{} triples at the stored points", search.found.len());
        if search.found.len() == known.len() {
            break;
        }
    }
    search
        .found
        .into_iter()
        .map(|(certificate, _)| certificate)
        .collect()
}

/// The file.
fn encoded(certificates: &[Certificate]) -> Vec<u8> {
    let of = |wanted: bool| {
        certificates
            .iter()
            .filter(move |certificate| certificate.real == Some(wanted))
    };
    let complex =
        of(false).filter_map(|certificate| Some((certificate, Mark::new(&certificate.discs)?)));
    // Some complex triples are their self_conjugate conjugates, each cognate that of another one.
    let (self_conjugate, pairs): (Vec<_>, Vec<_>) =
        complex.partition(|(_, mark)| !mark.mirrored().is_apart_from(mark));
    let first = pairs.iter().enumerate().filter(|(i, (_, mark))| {
        let mirrored = mark.mirrored();
        pairs[..*i]
            .iter()
            .all(|(_, other)| mirrored.is_apart_from(other))
    });
    let first = first.map(|(_, pair)| pair);

    let mut bytes = Vec::new();
    for count in [of(true).count(), self_conjugate.len()] {
        let count = u32::try_from(count).expect("fewer than 1442");
        bytes.extend(count.to_le_bytes());
    }
    let mut put = |number: Complex| {
        for part in [number.re, number.im] {
            bytes.extend((part as f32).to_le_bytes());
        }
    };
    for real in of(true) {
        [0, 2, 4, 6]
            .into_iter()
            .for_each(|i| put(real.discs[i].middle));
    }
    for (certificate, _) in self_conjugate.iter().chain(first) {
        certificate.discs[..8]
            .iter()
            .for_each(|disc| put(disc.middle));
    }
    bytes
}

/// The path of the file.
const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/src/nine_points/starts.bin");
/// Another one gives the same solutions in another order.
const SEED: u64 = 2;

#[test]
fn stored_solutions() {
    if std::env::var_os("UPDATE").is_none() {
        return;
    }
    let found = solutions(SEED);
    assert_eq!(found.len(), TRIPLES, "try another seed");
    let bytes = encoded(&found);
    assert_eq!(stored_solutions::decoded(&bytes).len(), TRIPLES);
    std::fs::write(FILE, &bytes).expect("the file can be written");
}
