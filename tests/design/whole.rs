//! No mechanism is returned that does not assemble over its whole range on one circuit.
//!
//! Random problems without Grashof's condition, so that most optima do not turn: what is listed is looked at by `circuits()`, and,
//! independently of it, by the lengths alone or by a solver of its own that follows the loops. `LINKAGE_LONG=1` looks at 10,000 results of
//! each kind, of coupled groups at 1000.

mod drive;

use super::judge::{follows, inputs};
use super::{FourBar, FourBarAssembly, LENGTHS};
use linkage::design::{Design, DesignError, Targets, Timing};
use linkage::{Dimensions, mechanism};
use linkage_random::Random;
use std::f64::consts::TAU;

/// Results that are looked at.
struct Counts {
    wanted: usize,
    results: usize,
    problems: usize,
    /// Optima that do not run through the turn.
    refused: usize,
    /// Starts that do not assemble.
    open: usize,
}

impl Counts {
    /// So many, or with `LINKAGE_LONG` so many.
    fn wanted(few: usize, many: usize) -> Self {
        let long = std::env::var_os("LINKAGE_LONG").is_some();
        Self {
            wanted: if long { many } else { few },
            results: 0,
            problems: 0,
            refused: 0,
            open: 0,
        }
    }

    fn go_on(&self) -> bool {
        self.results < self.wanted
    }

    /// What was looked at; `hard` of what was tried must have been refused, a tenth of the results at least.
    fn tell(&self, what: &str, hard: usize) {
        let Self {
            results,
            problems,
            refused,
            open,
            ..
        } = self;
        println!(
            "{results} {what} of {problems} problems run through the turn; {refused} optima did not, {open} starts do not assemble"
        );
        assert!(
            hard > results / 10,
            "the problems are not hard enough: {hard}"
        );
    }
}

/// Runs a search and has all its results looked at.
fn search<M, A, const N: usize>(
    design: Design<'_, M, A, N>,
    counts: &mut Counts,
    look: impl Fn(M, &A) -> Result<(), String>,
) -> Result<(), DesignError>
where
    M: Dimensions<N> + Copy + Send + Sync + std::fmt::Debug,
    A: Clone + Send + Sync,
{
    counts.problems += 1;
    let found = match design.run() {
        Err(DesignError::NotFound(why)) => {
            counts.refused += why.not_whole;
            counts.open += why.open;
            return Ok(());
        }
        other => other?,
    };
    counts.refused += found.not_whole;
    counts.open += found.open;
    counts.results += found.designs.len();
    for design in &found.designs {
        if let Err(why) = look(design.mechanism, &design.assembly) {
            panic!("{why}: {:?}", design.mechanism);
        }
    }
    Ok(())
}

#[test]
fn all_results_run_through_the_turn() -> Result<(), DesignError> {
    let mut random = Random::new(23);
    let mut counts = Counts::wanted(30, 10_000);
    while counts.go_on() {
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
        .want(Targets::new("tracer", points).computed_by(FourBarAssembly::path_sweep_sets_into))
        .vary("arm.x", -40.0, 40.0)
        .vary("arm.y", -40.0, 40.0)
        .starts(32)
        .seed(random.bits());
        for name in LENGTHS {
            design = design.vary(name, 5.0, 60.0);
        }
        search(design, &mut counts, |mechanism, assembly| {
            look(mechanism, assembly);
            Ok(())
        })?;
    }
    counts.tell("four-bars", counts.refused);
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

// A four-bar that drives a further rocker through its coupler point.

mechanism! {
    struct SixBar {
        unit mm;
        param frame = 40mm;
        param crank = 12mm;
        param coupler = 35mm;
        param rocker = 30mm;
        param arm = (20mm, 15mm);
        param rod = 45mm;
        param lever = 30mm;
        param pivot = (65mm, 20mm);
        input phi = 30deg in 0deg..360deg;
        unknown theta = 40deg;
        unknown psi = 80deg;
        unknown rho = 10deg;
        unknown chi = 120deg;
        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = (frame, 0) + polar(rocker, psi);
        let p = a + rotate(arm, theta);
        loop p + polar(rod, rho) = pivot + polar(lever, chi);
    }
    impl SixBar {
        fn swing(phi) -> Swing { chi, v: velocity(chi), s: sensitivity(chi) }
        fn angles(phi) -> Angles { theta, psi, rho, chi }
    }
}

/// Their loops as they are closed by hand.
fn equations(bar: SixBar) -> impl Fn(f64, &[f64; 4]) -> [f64; 4] {
    move |phi, &[theta, psi, rho, chi]| {
        let a = [bar.crank * phi.cos(), bar.crank * phi.sin()];
        let (sin, cos) = theta.sin_cos();
        let p = [
            a[0] + cos * bar.arm.x - sin * bar.arm.y,
            a[1] + sin * bar.arm.x + cos * bar.arm.y,
        ];
        [
            a[0] + bar.coupler * cos - bar.frame - bar.rocker * psi.cos(),
            a[1] + bar.coupler * sin - bar.rocker * psi.sin(),
            p[0] + bar.rod * rho.cos() - bar.pivot.x - bar.lever * chi.cos(),
            p[1] + bar.rod * rho.sin() - bar.pivot.y - bar.lever * chi.sin(),
        ]
    }
}

#[test]
fn six_bars_run_through_the_turn() -> Result<(), DesignError> {
    let mut random = Random::new(61);
    let mut counts = Counts::wanted(8, 10_000);
    while counts.go_on() {
        let angles: Vec<[f64; 1]> = (0..3 + random.below(3))
            .map(|_| [random.between(1.0, 2.8)])
            .collect();
        let wish = Targets::new("chi", angles).timing(Timing::InOrder);
        let design = Design::new(
            SixBar::default(),
            SixBar::assemble,
            SixBar::assemblies,
            SixBar::circuits,
        )?
        .want(wish.computed_by(SixBarAssembly::swing_sweep_sets_into));
        let design = SixBar::PARAMETERS
            .iter()
            .fold(design, |design, own| design.vary_by(own.name, 0.5));
        let design = design.starts(32).seed(random.bits());
        search(
            design,
            &mut counts,
            |bar: SixBar, assembly: &SixBarAssembly| {
                let circuits = bar.circuits().expect("it assembles");
                let mut whole = circuits.whole().filter(|branch| branch.closed);
                assert!(whole.any(|branch| branch.assembly.modes() == assembly.modes()));
                let angles: Vec<[f64; 4]> = inputs()
                    .into_iter()
                    .map(|phi| assembly.angles(phi))
                    .map(|at| [at.theta, at.psi, at.rho, at.chi])
                    .collect();
                follows(equations(bar), &angles)
            },
        )?;
    }
    counts.tell("six-bars", counts.refused);
    Ok(())
}
