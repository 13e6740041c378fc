//! Andrews' mechanism in double-doubles: digits of the angle after 0.03 s.

use crate::double_double::DoubleDouble;
use crate::timing::best;
use linkage::Scalar;
use linkage::dynamics::Conservative;
use std::error::Error;
use std::hint::black_box;

include!("../../mechanisms/andrews.rs");
include!("../../mechanisms/andrews/decimals.rs");

/// Prints tolerance, relative error and ms.
pub(crate) fn print() -> Result<(), Box<dyn Error>> {
    let linkage = decimals::<DoubleDouble>(&Andrews::default())?.assemble()?;
    let texts = [START, "0.033", "0.03", ANGLE];
    let [start, moment, end, known] = texts.map(str::parse::<DoubleDouble>);
    let (start, moment, end, known) = (start?, moment?, end?, known?);
    let [zero, one, two] = [0.0, 1.0, 2.0].map(DoubleDouble::from_f64);
    let function = |beta: DoubleDouble| {
        let energy = linkage.energy(beta, one);
        [two * energy.kinetic, moment * beta - energy.potential]
    };
    println!("Andrews' mechanism in double-doubles: tolerance, relative error of beta, ms");
    for digits in [14, 18, 22, 26] {
        let energy = Conservative::new(function).start(start, zero);
        let energy = energy.force(|beta| linkage.terms(beta, zero, moment).force);
        let energy = energy.tolerance(10_f64.powi(-digits));
        let angle = energy.input(end)?;
        let time = best(|| {
            black_box(energy.input(black_box(end))).ok();
        });
        let error = ((angle - known) / known).lane(0).abs();
        println!("  1e-{digits} {error:8.1e} {:8.3} {angle}", 1e3 * time);
    }
    Ok(())
}
