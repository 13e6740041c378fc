//! Several organs on one shaft: `cargo bench --bench machine`.
//!
//! The machine of the example `knitting_machine`: a cyclogram of its four organs with all switching angles and their
//! sensitivities; the least distance of two needles with its sensitivities to all dimensions; the best phase of both and
//! the best slot of a gear. Times are of everything after `assemble()`, sweeps included.

#[path = "../examples/knitting_machine/drives.rs"]
#[allow(unreachable_pub, reason = "a part of an example")]
mod drives;
#[path = "../examples/knitting_machine/organs.rs"]
#[allow(dead_code, reason = "the example asks for more")]
mod organs;

use drives::KnittingMachine;
use linkage_peers::timing::{Candidate, interleave, only_tested};
use std::hint::black_box;
use std::time::Duration;

fn main() {
    let machine = KnittingMachine::default();
    let even = KnittingMachine {
        eye_lead: 0.0,
        ..machine
    };
    let (built, even) = (machine.assemble(), even.assemble());
    let (built, even) = (built.expect("it closes"), even.expect("it closes"));
    let candidates = vec![
        Candidate::new("assemble()", 1, || {
            black_box(black_box(&machine).assemble()).expect("it closes");
        }),
        Candidate::new("cyclogram, sensitivities", 1, || {
            black_box(organs::cyclogram(black_box(&built)).expect("a cyclogram"));
        }),
        Candidate::new("least distance, sensitivities", 1, || {
            let found = organs::clearance(black_box(&built)).expect("a clearance");
            black_box(organs::sensitivity(&built, found.least()));
        }),
        Candidate::new("best phase, best of 48 slots", 1, || {
            let found = organs::best_lead(black_box(&even), 48.0);
            black_box(found.expect("a best phase"));
        }),
    ];
    let time = match only_tested() {
        true => Duration::ZERO,
        false => Duration::from_secs(2),
    };
    for times in interleave(candidates, time) {
        println!("{:30} {:8.1} us", times.name, times.spread().median / 1e3);
    }
}
