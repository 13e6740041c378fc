//! Mechanisms that do not turn everywhere: a drive of coupled links, a six-bar with a notch, and one in space.

use super::super::judge::{follows, inputs};
use super::{Counts, search};
use linkage::design::{Design, DesignError, Interruption, Targets, Timing};
use linkage::{BranchEnd, mechanism};
use linkage_random::Random;

// The drive of an eye needle, whose four links only close together.

mechanism! {
    struct EyeNeedle {
        unit mm;
        param l12 = 50mm;
        param l23 = 272.5mm;
        param l34 = 81mm;
        param l45 = 104.5mm;
        param l35 = 174mm;
        param l46 = 104.5mm;
        param l57 = 261mm;
        param p6 = (195mm, 226mm);
        param p7 = (46mm, 533mm);
        input phi = 0deg in 0deg..360deg;
        unknown phi23 = 62deg;
        unknown phi34 = 146deg;
        unknown phi64 = 144deg;
        unknown phi75 = -99deg;
        let p2 = polar(l12, phi);
        let p3 = p2 + polar(l23, phi23);
        let p4 = p3 + polar(l34, phi34);
        let p5 = p3 + polar(l35, phi34 + triangle_angle(l34, l35, l45));
        loop p4 = p6 + polar(l46, phi64);
        loop p5 = p7 + polar(l57, phi75);
    }
    impl EyeNeedle {
        fn swing(phi) -> Swing { phi75, v: velocity(phi75), s: sensitivity(phi75) }
        fn angles(phi) -> Angles { phi23, phi34, phi64, phi75 }
    }
}

fn equations(drive: EyeNeedle) -> impl Fn(f64, &[f64; 4]) -> [f64; 4] {
    let cosine =
        (drive.l34.powi(2) + drive.l35.powi(2) - drive.l45.powi(2)) / (2.0 * drive.l34 * drive.l35);
    let corner = cosine.acos();
    move |phi, &[phi23, phi34, phi64, phi75]| {
        let along = |length: f64, angle: f64| [length * angle.cos(), length * angle.sin()];
        let [p2, rod] = [along(drive.l12, phi), along(drive.l23, phi23)];
        let p3 = [p2[0] + rod[0], p2[1] + rod[1]];
        let [to4, to5] = [along(drive.l34, phi34), along(drive.l35, phi34 + corner)];
        let [from6, from7] = [along(drive.l46, phi64), along(drive.l57, phi75)];
        [
            p3[0] + to4[0] - drive.p6.x - from6[0],
            p3[1] + to4[1] - drive.p6.y - from6[1],
            p3[0] + to5[0] - drive.p7.x - from7[0],
            p3[1] + to5[1] - drive.p7.y - from7[1],
        ]
    }
}

#[test]
fn coupled_drives_run_through_the_turn() -> Result<(), DesignError> {
    let mut random = Random::new(62);
    let mut counts = Counts::wanted(3, 1000);
    while counts.go_on() {
        let angles: Vec<[f64; 1]> = (0..3 + random.below(2))
            .map(|_| [random.between(-2.2, -1.4)])
            .collect();
        let wish = Targets::new("phi75", angles).timing(Timing::InOrder);
        let design = Design::new(
            EyeNeedle::default(),
            EyeNeedle::assemble,
            |drive: &EyeNeedle| drive.assemble().map(|assembly| vec![assembly]),
            EyeNeedle::circuits,
        )?
        .want(wish.computed_by(EyeNeedleAssembly::swing_sweep_sets_into));
        let design = EyeNeedle::PARAMETERS
            .iter()
            .fold(design, |design, own| design.vary_by(own.name, 0.25));
        let design = design.starts(4).steps(60).seed(random.bits());
        search(
            design,
            &mut counts,
            |drive: EyeNeedle, assembly: &EyeNeedleAssembly| {
                let angles: Vec<[f64; 4]> = inputs()
                    .into_iter()
                    .map(|phi| assembly.angles(phi))
                    .map(|at| [at.phi23, at.phi34, at.phi64, at.phi75])
                    .collect();
                follows(equations(drive), &angles)
            },
        )?;
    }
    // Dimensions that do not assemble over the whole turn have no values at all: what is hard about them is told as starts.
    counts.tell("drives of an eye needle", counts.refused + counts.open);
    Ok(())
}

// A six-bar that comes apart over a twenty-fourth part of a degree: crank and frame are almost alike, so that the other two links of its four-bar
// turn by half a turn while the crank passes the other pivot, and with them a point from which a link leads to a further rocker. It is too short
// for a part of this half turn. No sample is there, and none beside it tells.

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
        fn swing(phi) -> NotchSwing { chi, v: velocity(chi), s: sensitivity(chi) }
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

// A crank that drives a rocker about a skew axis by a link with two ball joints.

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
        fn swing(phi) -> SkewSwing { psi, v: velocity(psi), s: sensitivity(psi) }
    }
}

fn equations_in_space(bar: Skew) -> impl Fn(f64, &[f64; 1]) -> [f64; 1] {
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
            follows(equations_in_space(bar), &angles)
        })?;
    }
    counts.tell("spatial crank-rockers", counts.refused);
    Ok(())
}
