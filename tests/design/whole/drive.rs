//! The drive of an eye needle, whose four links only close together.

use super::super::judge::{follows, inputs};
use super::{Counts, search};
use linkage::design::{Design, DesignError, Targets, Timing};
use linkage::mechanism;
use linkage_random::Random;

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
