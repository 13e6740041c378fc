//! The angles whose values are used, and the expressions that count their turns.

use linkage_symbolic::Ex;

use crate::algebra::derivatives::dependence;
use crate::algebra::{Algebra, Nominal, Phasor};
use crate::ir::{ContinuousAngle, Phase};

/// The angles, and the coefficients of all their phases.
pub(super) fn continuous_angles<'m>(
    algebra: &mut Algebra<'m>,
    nominal: &Nominal,
    angles: &[usize],
) -> (Vec<ContinuousAngle>, Vec<Ex<'m>>) {
    let mut coefficients = Vec::new();
    let angles = angles.iter().map(|&index| {
        let angle = algebra.names.angles[index].clone();
        let phasors = angle
            .reference
            .and_then(|bearing| bearing.phasors(&algebra.names));
        let phasors = phasors.unwrap_or_default();
        coefficients.extend(
            phasors
                .iter()
                .flat_map(|phasor| phasor.coefficient.components()),
        );
        ContinuousAngle {
            unknown: angle.meant().unwrap_or(0),
            inputs: dependence::inputs_below(
                algebra.graph,
                &mut algebra.derivatives.dependence,
                &angle.unit.0,
            ),
            estimate: angle.estimate(nominal),
            phases: phasors
                .iter()
                .map(|phasor| phase(algebra, phasor))
                .collect(),
        }
    });
    (angles.collect(), coefficients)
}

fn phase(algebra: &Algebra, phasor: &Phasor) -> Phase {
    let turns = phasor.rates.as_ref().map(|rates| {
        let mut turns = vec![0.0; algebra.mechanism.inputs.len()];
        for &(input, rate) in rates {
            turns[input] += rate;
        }
        turns
    });
    Phase { turns }
}
