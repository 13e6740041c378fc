//! A six-bar that comes apart over a twenty-fourth part of a degree: crank and frame are almost alike, so that the other two links of its four-bar
//! turn by half a turn while the crank passes the other pivot, and with them a point from which a link leads to a further rocker. It is too short
//! for a part of this half turn. No sample is there, and none beside it tells.

use linkage::BranchEnd;
use linkage::design::{Design, DesignError, Interruption, Targets, Timing};
use linkage::mechanism;

mechanism! {
    struct Flip {
        unit mm;
        param frame = (-12.931582674540135mm, 37.852003507496576mm);
        param crank = 40.01mm;
        param coupler = 45mm;
        param rocker = 45mm;
        param arm = (20mm, 10mm);
        param rod = 100mm;
        param lever = 80mm;
        param pivot = (-115.6mm, -78.7mm);
        input phi = 30deg in 0deg..360deg;
        unknown theta = -145deg;
        unknown psi = -76deg;
        unknown rho = -174deg;
        unknown chi = 60deg;
        let a = polar(crank, phi);
        loop a + polar(coupler, theta) = frame + polar(rocker, psi);
        let p = a + rotate(arm, theta);
        loop p + polar(rod, rho) = pivot + polar(lever, chi);
    }
    impl Flip {
        fn swing(phi) -> Swing { chi, v: velocity(chi), s: sensitivity(chi) }
    }
}

/// By how much the link is too short, from lengths and angles alone.
fn missing(bar: &Flip, phi: f64) -> f64 {
    let (ax, ay) = (bar.crank * phi.cos(), bar.crank * phi.sin());
    let (dx, dy) = (bar.frame.x - ax, bar.frame.y - ay);
    // Coupler and rocker are of one length.
    let theta = dy.atan2(dx) + (0.5 * dx.hypot(dy) / bar.coupler).acos();
    let (sin, cos) = theta.sin_cos();
    let x = ax + cos * bar.arm.x - sin * bar.arm.y - bar.pivot.x;
    let y = ay + sin * bar.arm.x + cos * bar.arm.y - bar.pivot.y;
    x.hypot(y) - bar.rod - bar.lever
}

/// Where this changes its sign between two inputs.
fn end(bar: &Flip, mut low: f64, mut high: f64) -> f64 {
    let sign = missing(bar, low).signum();
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        match missing(bar, middle).signum() == sign {
            true => low = middle,
            false => high = middle,
        }
    }
    0.5 * (low + high)
}

#[test]
fn a_notch_between_all_samples_is_seen() -> Result<(), DesignError> {
    // The declared one is long enough.
    let bar = Flip {
        lever: 69.0,
        ..Flip::default()
    };
    let gap = [end(&bar, 1.899, 1.9), end(&bar, 1.9, 1.901)];
    assert!(
        gap[1] - gap[0] < 1e-3 && missing(&bar, 1.9) > 1.0,
        "{gap:?}"
    );
    let nominal = bar.assemble().expect("it assembles");
    let circuits = bar.circuits().expect("it assembles");
    let own = circuits
        .branches
        .iter()
        .filter(|branch| branch.assembly.modes() == nominal.modes());
    let own: Vec<_> = own.collect();
    let ends = own.iter().flat_map(|branch| branch.ends);
    let mut turning: Vec<f64> = ends
        .filter_map(|end| match end {
            BranchEnd::TurningPoint(x) => Some(x),
            _ => None,
        })
        .collect();
    turning.sort_by(f64::total_cmp);
    assert_eq!(turning.len(), 2, "{circuits}");
    for (end, expected) in turning.iter().zip(gap) {
        assert!((end - expected).abs() < 1e-9, "{end} {expected}");
    }
    assert!(own.iter().all(|branch| !branch.is_whole()), "{circuits}");

    // A search never returns it: what it wants is what the mechanism does, and nothing is in the way but the notch.
    let inputs = [0.5, 2.5, 3.5, 4.5];
    let wanted = inputs.map(|phi| [nominal.swing(phi).chi]);
    let wish = Targets::new("chi", wanted).timing(Timing::Given(inputs.to_vec()));
    let design = Design::new(bar, Flip::assemble, Flip::assemblies, Flip::circuits)?
        .vary("lever", 68.8, 69.2)
        .want(wish.computed_by(FlipAssembly::swing_sweep_sets_into))
        .starts(4);
    let why = match design.run() {
        Err(DesignError::NotFound(why)) => why,
        other => panic!("{:?}", other.map(|found| found.designs.len())),
    };
    let nearest = why.nearest.expect("it was found and refused");
    assert!(why.not_whole > 0 && nearest.sum < 1e-12, "{nearest:?}");
    assert!(matches!(nearest.why, Interruption::Ends(ends) if ends.len() == 2));
    Ok(())
}
