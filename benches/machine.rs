//! Several members on one shaft: `cargo bench -p linkage-benches --bench machine`.
//!
//! The machine of `mechanisms/knitting_machine.rs`: a cyclogram of its four members with all switching angles and their
//! sensitivities; the least distance of two needles with its sensitivities to all dimensions; the best phase of both and
//! the best slot of a gear. Times are of everything after `assemble()`, sweeps included. Behind it the best phases of three
//! and of four members, points that move by two harmonics: what a search of several phases takes beside the mechanism's
//! own functions.

mod drives {
    include!("../mechanisms/knitting_machine.rs");
}
#[path = "../tests/gallery/knitting_machine/members.rs"]
#[allow(dead_code, reason = "the gallery asks for more")]
mod members;
#[path = "../tests/machine/waves.rs"]
mod waves;

use drives::KnittingMachine;
use linkage::clearance::{BestPhases, PhaseError, PhaseSet, Phases};
use linkage_peers::timing::{Candidate, interleave, only_tested};
use std::hint::black_box;
use std::time::Duration;
use waves::{A, B, C, CYCLE, D, POSITIONS, RANGE, organ};

fn main() {
    let machine = KnittingMachine::default();
    let even = KnittingMachine {
        eye_lead: 0.0,
        ..machine
    };
    let (built, even) = (machine.assemble(), even.assemble());
    let (built, even) = (built.expect("it closes"), even.expect("it closes"));
    let mut candidates = vec![
        Candidate::new("assemble()", 1, || {
            black_box(black_box(&machine).assemble()).expect("it closes");
        }),
        Candidate::new("cyclogram, sensitivities", 1, || {
            black_box(members::cyclogram(black_box(&built)).expect("a cyclogram"));
        }),
        Candidate::new("least distance, sensitivities", 1, || {
            let found = members::clearance(black_box(&built)).expect("a clearance");
            black_box(members::sensitivity(&built, found.least()));
        }),
        Candidate::new("best phase, best of 48 slots", 1, || {
            let found = members::best_lead(black_box(&even), 48.0);
            black_box(found.expect("a best phase"));
        }),
        Candidate::new("best two phases, three members", 1, || {
            black_box(two_phases().expect("best phases"));
        }),
    ];
    // Seconds without optimisation.
    if !only_tested() {
        candidates.push(Candidate::new("best three phases, four members", 1, || {
            black_box(three_phases().expect("best phases"));
        }));
    }
    let time = match only_tested() {
        true => Duration::ZERO,
        false => Duration::from_secs(2),
    };
    for times in interleave(candidates, time) {
        println!("{:30} {:8.1} us", times.name, times.spread().median / 1e3);
    }
}

/// Three members, each pair of which may meet.
fn two_phases() -> Result<BestPhases<2, 2>, PhaseError> {
    let [a, b, c] = black_box([A, B, C]).map(organ);
    let ab = Phases::new(CYCLE, POSITIONS, a, b)?;
    let ac = Phases::new(CYCLE, POSITIONS, a, c)?;
    let bc = Phases::new(CYCLE, POSITIONS, b, c)?;
    PhaseSet::new()
        .pair(None, Some(0), &ab)
        .pair(None, Some(1), &ac)
        .pair(Some(0), Some(1), &bc)
        .best([RANGE; 2])
}

/// Four members, of which the last one may meet the second. There is room for two of them: more boxes than are looked at.
fn three_phases() -> Result<BestPhases<2, 3>, PhaseError> {
    let [a, b, c, d] = black_box([A, B, C, D]).map(organ);
    let ab = Phases::new(CYCLE, POSITIONS, a, b)?;
    let ac = Phases::new(CYCLE, POSITIONS, a, c)?;
    let bc = Phases::new(CYCLE, POSITIONS, b, c)?;
    let bd = Phases::new(CYCLE, POSITIONS, b, d)?;
    PhaseSet::new()
        .pair(None, Some(0), &ab)
        .pair(None, Some(1), &ac)
        .pair(Some(0), Some(1), &bc)
        .pair(Some(0), Some(2), &bd)
        .best([RANGE; 3])
}
