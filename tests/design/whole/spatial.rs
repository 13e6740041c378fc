//! A crank that drives a rocker about a skew axis by a link with two ball joints.

use super::super::judge::{follows, inputs};
use super::{Counts, search};
use linkage::design::{Design, DesignError, Targets, Timing};
use linkage::mechanism;
use linkage_random::Random;

mechanism! {
    struct Skew {
        unit mm;
        param crank = 30mm;
        param rod = 130mm;
        param rocker = 70mm;
        param pivot = (110mm, 30mm, -50mm);
        input phi = 0deg in 0deg..360deg;
        unknown psi = 100deg;
        let p2 = turn((0mm, crank, 0mm), (1, 0, 0), phi);
        let p3 = pivot + turn((rocker, 0mm, 0mm), (0, 0.6, 0.8), psi);
        loop distance(p2, p3) = rod;
    }
    impl Skew {
        fn swing(phi) -> Swing { psi, v: velocity(psi), s: sensitivity(psi) }
    }
}

fn equations(bar: Skew) -> impl Fn(f64, &[f64; 1]) -> [f64; 1] {
    move |phi, &[psi]| {
        let p2 = [0.0, bar.crank * phi.cos(), bar.crank * phi.sin()];
        // The arm is square to its axis: it turns from x towards the axis times x, (0, 0.8, -0.6).
        let (sin, cos) = psi.sin_cos();
        let arm = [
            bar.rocker * cos,
            0.8 * bar.rocker * sin,
            -0.6 * bar.rocker * sin,
        ];
        let pivot = [bar.pivot.x, bar.pivot.y, bar.pivot.z];
        let square: f64 = (0..3).map(|k| (pivot[k] + arm[k] - p2[k]).powi(2)).sum();
        [(square - bar.rod * bar.rod) / bar.rod]
    }
}

#[test]
fn spatial_rockers_run_through_the_turn() -> Result<(), DesignError> {
    let mut random = Random::new(63);
    let mut counts = Counts::wanted(20, 10_000);
    while counts.go_on() {
        let angles: Vec<[f64; 1]> = (0..2 + random.below(3))
            .map(|_| [random.between(0.8, 2.6)])
            .collect();
        let wish = Targets::new("psi", angles).timing(Timing::InOrder);
        let design = Design::new(
            Skew::default(),
            Skew::assemble,
            Skew::assemblies,
            Skew::circuits,
        )?
        .want(wish.computed_by(SkewAssembly::swing_sweep_sets_into));
        let design = Skew::PARAMETERS
            .iter()
            .fold(design, |design, own| design.vary_by(own.name, 0.7));
        let design = design.starts(32).seed(random.bits());
        search(design, &mut counts, |bar: Skew, assembly: &SkewAssembly| {
            let angles: Vec<[f64; 1]> = inputs()
                .into_iter()
                .map(|phi| [assembly.swing(phi).psi])
                .collect();
            follows(equations(bar), &angles)
        })?;
    }
    counts.tell("spatial crank-rockers", counts.refused);
    Ok(())
}
