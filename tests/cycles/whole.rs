//! No mechanism is returned that does not run through the turn: results of random problems, followed by a solver that knows nothing of them.
//! `LINKAGE_LONG=1` looks at 1000.

#[path = "../design/judge.rs"]
mod judge;

use super::{Rocker, RockerAssembly, speed, tip};
use judge::{follows, inputs};
use linkage::design::{CycleDesign, DesignError, Dwell, Figure, Peak};
use linkage_random::Random;

fn equations(bar: Rocker) -> impl Fn(f64, &[f64; 2]) -> [f64; 2] {
    move |phi, &[theta, psi]| {
        let x =
            bar.crank * phi.cos() + bar.coupler * theta.cos() - bar.frame - bar.rocker * psi.cos();
        let y = bar.crank * phi.sin() + bar.coupler * theta.sin() - bar.rocker * psi.sin();
        [x, y]
    }
}

/// The angles of coupler and rocker, from where the tip is on its arc.
fn angles(bar: &Rocker, assembly: &RockerAssembly, phi: f64) -> [f64; 2] {
    let psi = assembly.tip(phi).tip / bar.arm;
    let x = bar.frame + bar.rocker * psi.cos() - bar.crank * phi.cos();
    let y = bar.rocker * psi.sin() - bar.crank * phi.sin();
    [y.atan2(x), psi]
}

#[test]
fn results_run_through_the_turn() -> Result<(), DesignError> {
    let wanted = match std::env::var_os("LINKAGE_LONG") {
        Some(_) => 1000,
        None => 12,
    };
    let mut random = Random::new(64);
    let (mut results, mut refused) = (0, 0);
    while results < wanted {
        let (part, band) = (random.between(0.1, 0.6), random.between(0.3, 3.0));
        let design = CycleDesign::new(
            Rocker::default(),
            Rocker::assemble,
            Rocker::assemble_from,
            Rocker::circuits,
        )?;
        let design = ["crank", "coupler", "rocker", "frame"]
            .iter()
            .fold(design, |design, name| design.vary_by(name, part))
            .starts(6)
            .steps(60)
            .seed(random.bits());
        let run = match random.chance(0.5) {
            true => design.want(Dwell::longest(tip(), band)).run_all(),
            false => design.want(Peak(speed()).least()).run_all(),
        };
        let all = match run {
            Ok(all) => all,
            Err(DesignError::NotFound(_)) => {
                refused += 1;
                continue;
            }
            Err(error) => return Err(error),
        };
        results += all.len();
        for best in &all {
            let bar = best.mechanism;
            let angles: Vec<[f64; 2]> = inputs()
                .into_iter()
                .map(|phi| angles(&bar, &best.assembly, phi))
                .collect();
            let judged = follows(equations(bar), &angles);
            assert_eq!(judged, Ok(()), "{bar:?}");
        }
    }
    println!("{results} results run through the turn; {refused} problems had none");
    Ok(())
}
