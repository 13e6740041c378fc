//! No mechanism is returned that does not assemble over its whole range on one circuit.
//!
//! Random problems without Grashof's condition, so that most optima do not turn: what is listed is looked at by `circuits()`, and,
//! independently of it, by the lengths alone and at many inputs. `LINKAGE_LONG=1` looks at 10,000 results.

use super::{FourBar, FourBarAssembly, LENGTHS};
use linkage::design::{Design, DesignError, Targets};
use linkage_random::Random;
use std::f64::consts::TAU;

/// Results that are looked at.
fn wanted() -> usize {
    if std::env::var_os("LINKAGE_LONG").is_some() {
        10_000
    } else {
        30
    }
}

#[test]
fn all_results_run_through_the_turn() -> Result<(), DesignError> {
    let mut random = Random::new(23);
    let (mut results, mut refused, mut problems) = (0, 0, 0);
    while results < wanted() {
        let count = 3 + random.below(4);
        let points: Vec<[f64; 2]> = (0..count)
            .map(|_| [random.between(-40.0, 60.0), random.between(-40.0, 60.0)])
            .collect();
        let mut design = Design::new(
            FourBar::default(),
            FourBar::assemble,
            FourBar::assemblies,
            FourBar::circuits,
        )?
        .want(Targets::of("tracer", points).computed_by(FourBarAssembly::path_sweep_sets_into))
        .vary("arm.x", -40.0, 40.0)
        .vary("arm.y", -40.0, 40.0)
        .starts(32)
        .seed(random.bits());
        for name in LENGTHS {
            design = design.vary(name, 5.0, 60.0);
        }
        problems += 1;
        let found = match design.run() {
            Err(DesignError::NotFound(why)) => {
                refused += why.not_whole;
                continue;
            }
            other => other?,
        };
        refused += found.not_whole;
        for design in &found.designs {
            look(design.mechanism, &design.assembly);
        }
        results += found.designs.len();
    }
    println!(
        "{results} results of {problems} problems run through the turn; {refused} optima did not"
    );
    assert!(
        refused > results / 10,
        "the problems are hard enough: {refused} optima were refused"
    );
    Ok(())
}

fn look(mechanism: FourBar, assembly: &FourBarAssembly) {
    // By circuits: the assembly is one of those that run through the turn.
    let circuits = mechanism.circuits().expect("it assembles");
    let mut whole = circuits
        .whole()
        .filter(|branch| branch.closed && branch.margin > 0.0);
    assert!(
        whole.any(|branch| branch.assembly.modes() == assembly.modes()),
        "{mechanism:?}"
    );

    // By Grashof: the crank turns against the frame if one of the two is the shortest link, and shortest and longest together are
    // shorter than the other two.
    let mut lengths = [
        mechanism.frame,
        mechanism.crank,
        mechanism.coupler,
        mechanism.rocker,
    ];
    lengths.sort_by(f64::total_cmp);
    assert!(
        lengths[0] + lengths[3] < lengths[1] + lengths[2],
        "{mechanism:?}"
    );
    assert!(
        lengths[0] == mechanism.crank || lengths[0] == mechanism.frame,
        "{mechanism:?}"
    );

    // By its positions: every one is there, and none jumps.
    let phi: Vec<f64> = (0..=720).map(|i| TAU * f64::from(i) / 720.0).collect();
    let columns = assembly.path_sweep(&phi);
    let [x, y] = columns.tracer();
    assert!(
        x.iter().chain(y).all(|number| number.is_finite()),
        "{mechanism:?}"
    );
    assert!((x[0] - x[720]).abs() + (y[0] - y[720]).abs() < 1e-9);
}
