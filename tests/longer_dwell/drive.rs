//! The drive of the eye needles, and the problem of its longest dwell.

use linkage::design::{BestCycle, Curve, CycleDesign, Dwell, Figure, Stroke};
use linkage::summary;
use std::error::Error;
use std::f64::consts::TAU;

include!("../../mechanisms/longer_dwell.rs");
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
