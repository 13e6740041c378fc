//! A four-bar that drives a further rocker through its coupler point.

use super::super::judge::{follows, inputs};
use super::{Counts, search};
use linkage::design::{Design, DesignError, Targets, Timing};
use linkage::mechanism;
use linkage_random::Random;

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
