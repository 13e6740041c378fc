//! The runtime's descriptions of coupled groups, as generated code has them as constants.

use linkage_compiler::ir::{CompiledMechanism, Coupled, ShownNumber};
use linkage_runtime::Group;
use linkage_runtime::support::{
    CoupledGroup, CoupledInput, CoupledLoop, CoupledUnknown, Range, Term, list_roots,
};

use super::forever::forever;

/// Returns the descriptions. `described` are all groups of the structure.
pub(super) fn groups(
    mechanism: &'static str,
    described: &'static [Group],
    unit: &CompiledMechanism,
) -> &'static [CoupledGroup] {
    let groups = unit.coupled.iter();
    let groups = groups.map(|coupled| group(mechanism, &described[coupled.group], unit, coupled));
    forever(groups.collect::<Vec<_>>())
}

fn group(
    mechanism: &'static str,
    described: &'static Group,
    unit: &CompiledMechanism,
    coupled: &Coupled,
) -> CoupledGroup {
    let unknowns = coupled.unknowns.iter().map(|placed| {
        let ShownNumber { name, unit, scale } = unit.shown(placed);
        CoupledUnknown {
            name: forever(name),
            estimate: placed.estimate,
            scale,
            unit: forever(unit),
            angle: placed.angle,
        }
    });
    let terms = coupled.terms.iter().map(|(equation, exponents)| Term {
        equation: *equation,
        exponents: forever(exponents.as_slice()),
    });
    let inputs = coupled.inputs.iter().map(|&index| {
        let input = &unit.inputs[index];
        let (low, high) = input.followed;
        CoupledInput {
            name: forever(input.name.as_str()),
            unit: forever(input.unit.as_str()),
            index,
            declared: input.range.is_some(),
            range: Range {
                low,
                high,
                turn: input.angle,
            },
        }
    });
    let missed = coupled.missed_loops.iter().map(|missed_loop| CoupledLoop {
        number: missed_loop.number,
        joint: forever(missed_loop.joint.as_str()),
        rows: missed_loop.rows,
        unit: forever(missed_loop.unit.as_str()),
        scale: missed_loop.scale,
    });
    CoupledGroup {
        mechanism,
        group: coupled.group,
        described,
        unknowns: forever(unknowns.collect::<Vec<_>>()),
        variables: forever(coupled.variables.as_slice()),
        terms: forever(terms.collect::<Vec<_>>()),
        list: list_roots,
        missed: forever(missed.collect::<Vec<_>>()),
        inputs: forever(inputs.collect::<Vec<_>>()),
        in_cells: coupled.in_cells,
        reach: coupled.reach,
        turning: coupled.turning,
    }
}
