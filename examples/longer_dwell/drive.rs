//! The drive of the eye needles, and the problem of its longest dwell.

use linkage::design::{BestCycle, Curve, CycleDesign, Dwell, Figure, Stroke};
use linkage::mechanism;
use linkage::summary;
use std::error::Error;
use std::f64::consts::TAU;

mechanism! {
    /// The drive of the eye needles; the tolerance of the angle is 20 um at the needle.
    #[derive(Clone, Copy)]
    pub struct EyeNeedle {
        unit mm;

        param l12 = 50mm +- 20um;
        param l23 = 272.5mm +- 20um;
        param l34 = 81mm +- 20um;
        param l45 = 104.5mm +- 20um;
        param l35 = 174mm +- 20um;
        param l46 = 104.5mm +- 20um;
        param l57 = 261mm +- 20um;
        param l78 = 136.8mm +- 20um;
        param angle_578 = -25deg +- 30arcsec;
        param p6 = (195mm, 226mm) +- 20um;
        param p7 = (46mm, 533mm) +- 20um;

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

        // The needle's point, and its way along its arc.
        let p8 = p7 + polar(l78, phi75 + angle_578);
        let way = l78 * (phi75 + angle_578);
    }

    impl EyeNeedle {
        pub fn motion(phi) -> Motion { way, v: velocity(way), a: acceleration(way) }
        pub fn accuracy(phi) -> Accuracy { way, e: sensitivity(way) }
        pub fn picture(phi) -> Picture { shape: picture(), p8 }
    }
}
pub(crate) const N: usize = EyeNeedle::PARAMETERS.len();
/// The band of the dwell, in mm, and how far lengths may differ.
pub(crate) const BAND: f64 = 0.1;
pub(crate) const PART: f64 = 0.02;

/// A design problem of the drive.
pub(crate) type Problem = CycleDesign<'static, EyeNeedle, EyeNeedleAssembly, N>;
pub(crate) type Drive = BestCycle<EyeNeedle, EyeNeedleAssembly>;
pub(crate) fn jet(drive: &EyeNeedleAssembly, phi: f64) -> [f64; 3] {
    let Motion { way, v, a } = drive.motion(phi);
    [way, v, a]
}

pub(crate) fn way() -> Curve<'static, EyeNeedleAssembly, N> {
    Curve::new(jet, |drive, phi| drive.accuracy(phi).e)
}

pub(crate) fn course(
    drive: &EyeNeedleAssembly,
) -> Result<summary::Curve<3, impl Fn(f64) -> [f64; 3]>, Box<dyn Error>> {
    Ok(summary::Curve::new((0.0, TAU), 361, move |phi| {
        jet(drive, phi)
    })?)
}

/// The stroke of the published drive.
pub(crate) fn stroke() -> Result<f64, Box<dyn Error>> {
    let published = EyeNeedle::default().assemble()?;
    let stroke = course(&published)?.position().stroke();
    Ok(stroke)
}

/// The longest dwell from the published drive, with its stroke.
pub(crate) fn design(
    dwell: Dwell<'static, EyeNeedleAssembly, N>,
    stroke: f64,
) -> Result<Problem, Box<dyn Error>> {
    let published = EyeNeedle::default();
    let design = CycleDesign::new(
        published,
        EyeNeedle::assemble,
        EyeNeedle::assemble_from,
        EyeNeedle::circuits,
    )?;
    let lengths = EyeNeedle::PARAMETERS
        .iter()
        .filter(|parameter| parameter.unit == "mm");
    let design = lengths.fold(design, |design, length| design.vary_by(length.name, PART));
    Ok(design.want(dwell).want(Stroke(way()).equal(stroke)))
}
