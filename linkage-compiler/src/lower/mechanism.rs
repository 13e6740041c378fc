//! All programs of a mechanism, scheduled in one place.

use linkage_symbolic::Ex;
use linkage_symbolic::program::{Instruction, Source};
use linkage_symbolic::schedule::{Slots, schedule, schedule_whole};

use crate::algebra::Algebra;
use crate::ir::{CompiledMechanism, Function};
use crate::machine::AtReference;
use crate::observer::PhaseObserver;
use crate::solve::Formulation;

use super::continuous_angles::continuous_angles;
use super::functions::{FunctionExpressions, angles_of_function, lower_function};
use super::groups::{AssemblySource, GroupNodes, find_turning, group_nodes, groups};
use super::missed::missed;
use super::passes::polish;
use super::plain::{plain, solved_groups, valued_angles};
use super::signature::signature;
use super::survey::{survey, surveyed};

/// Makes all programs of a mechanism: of its functions, of its coupled groups and of the assembly.
///
/// Prepared slots are shared by all programs. The order of the steps decides the order of operands
/// in sums: expressions that are needed by the assembly only are made after all others.
pub(crate) fn mechanism<'m>(
    algebra: &mut Algebra<'m>,
    formulation: &Formulation<'m>,
    at: AtReference,
    functions: Vec<FunctionExpressions>,
    observer: &mut dyn PhaseObserver,
) -> CompiledMechanism {
    let definitions = algebra.mechanism.evaluators.iter().enumerate();
    let functions = functions.into_iter().zip(definitions);
    // Of a picture without a link there has been a warning.
    let functions: Vec<_> = functions
        .filter(|(function, _)| !function.draws_nothing())
        .collect();
    let mut inliner = solved_groups(algebra, formulation);
    let gaps = formulation.groups.iter().map(|group| group.closed.gap);
    let gaps = plain(&mut inliner, &gaps.collect::<Vec<_>>());
    let survey = plain(&mut inliner, &survey(algebra, formulation));
    let closure = &at.reference.machine.closure;
    let nodes = group_nodes(algebra, formulation, at.nominal, &mut inliner, |prepared| {
        if closure.coupled[prepared.number].followed {
            AssemblySource::Estimates
        } else {
            AssemblySource::Listing
        }
    });

    let of_groups = nodes.iter().flat_map(GroupNodes::all);
    let of_assembly = gaps.iter().chain(&survey).copied().chain(of_groups);
    let mut angles = valued_angles(&inliner.target, &of_assembly.collect::<Vec<_>>());
    let expressed = || functions.iter().map(|(function, _)| function);
    angles.extend(expressed().flat_map(angles_of_function));
    angles.sort_unstable();
    angles.dedup();
    let angles = formulation.in_order(algebra, angles);
    let units = angles.iter().map(|&angle| algebra.names.angles[angle].unit);
    let units: Vec<Ex> = units.flat_map(|unit| unit.components()).collect();
    let units = plain(&mut inliner, &units);

    let mut slots = Slots::default();
    let graph = &inliner.target;
    let picture = expressed().find_map(|function| function.picture.clone());
    let functions: Vec<Function> = functions
        .into_iter()
        .map(|(function, (index, definition))| {
            lower_function(function, definition, index, &mut slots, observer)
        })
        .collect();
    let mut coupled = groups(algebra, formulation, at.nominal, &nodes, |nodes| {
        schedule(graph, nodes, &mut slots)
    });
    find_turning(&mut coupled, &nodes, graph, &angles);
    for (group, start) in coupled.iter_mut().zip(&at.reference.machine.starts) {
        group.start.clone_from(start);
    }
    let valued = valued_angles(graph, &survey);
    let last = angles.iter().rposition(|angle| valued.contains(angle));
    let [gaps, survey, directions] =
        [&gaps, &survey, &units].map(|nodes| schedule(graph, nodes, &mut slots));
    let (continuous, references) = continuous_angles(algebra, at.nominal, &angles);
    let references = plain(&mut inliner, &references);
    let mut compiled = CompiledMechanism {
        functions,
        coupled,
        gaps,
        survey,
        surveyed: surveyed(algebra, formulation),
        surveying: last.map_or(0, |last| last + 1),
        directions,
        prepare: slots.prepare(),
        angles: continuous,
        bearings: schedule_whole(&inliner.target, &references),
        picture,
        ..signature(algebra, formulation, at)
    };
    missed(algebra, formulation, &mut inliner, &mut compiled);
    renumber(&mut compiled, &angles);
    polish(&mut compiled, observer);
    compiled
}

/// Numbers centres and windings by the continuous angles only.
fn renumber(compiled: &mut CompiledMechanism, angles: &[usize]) {
    let number = |angle: usize| angles.iter().position(|&a| a == angle).unwrap_or(angle);
    for program in compiled.programs_mut() {
        for instruction in &mut program.instructions {
            if let Instruction::Load(Source::Centre(angle) | Source::Winding(angle, _)) =
                instruction
            {
                *angle = number(*angle);
            }
        }
    }
}
