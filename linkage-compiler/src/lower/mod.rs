//! From requested quantities to programs: differentiate, simplify, slice, share, split by binding time, schedule.

mod choice;
mod columns;
mod cost;
mod coupled;
mod fields;
mod needs;
mod quantity;
#[cfg(test)]
mod tests;
mod types;

use linkage_symbolic::NodeId;
use linkage_symbolic::inline::Inliner;
use linkage_symbolic::program::{Binary, Instruction, Program, Source};
use linkage_symbolic::schedule::{Slots, schedule};

use crate::algebra::{Algebra, Direction, Nominal};
use crate::diagnostic::{Diagnostics, Origins};
use crate::forces::Forces;
use crate::formulate::{Formulation, Prepared, Reference, unknown_nodes, valued_angles};
use crate::model::EvaluatorDef;
use crate::picture::{self, Picture};

use choice::Choice;
use coupled::{Version, redefine};

pub use columns::{Column, Meaning};
pub use coupled::{Coupled, Placed};
pub(crate) use coupled::{Nodes, groups as coupled_groups, nodes as coupled_nodes};
pub use types::{ContinuousAngle, Evaluator, Field, Lowered, Shape};

/// Lowers all functions of the mechanism. An argument list that does not fit its quantities is reported, and a picture that
/// cannot be drawn.
pub(crate) fn lower(
    (algebra, forces, formulation): (&mut Algebra, &mut Forces, &Formulation),
    (reference, nominal): (&Reference, &Nominal),
    origins: &Origins,
    diagnostics: &mut Diagnostics,
) -> Lowered {
    let mechanism = algebra.mechanism;
    let mut inliner = Inliner::default();
    let drawn = mechanism
        .evaluators
        .iter()
        .position(|own| own.asked_picture().is_some());
    let mut choices = vec![Choice::default(); mechanism.evaluators.len()];
    let others = (0..choices.len()).filter(|index| Some(*index) != drawn);
    for index in others.clone() {
        let definition = &mechanism.evaluators[index];
        let whole = (&mut *algebra, &mut *forces, formulation);
        let request = quantity::request(whole, definition, Direction::Forward);
        needs::check_inputs(algebra, definition, &request, origins, diagnostics);
        choices[index] = Choice::forward(algebra, &mut inliner, &request);
    }
    let gaps: Vec<NodeId> = formulation
        .groups
        .iter()
        .map(|group| group.closed.gap)
        .collect();
    let gaps = copy(&mut inliner, algebra, &gaps);
    let survey = survey(algebra, formulation);
    let survey = copy(&mut inliner, algebra, &survey);
    // Late, so that one function's other directions change nothing for the others.
    for index in others {
        choices[index].improve(
            (&mut *algebra, &mut *forces, formulation),
            &mut inliner,
            &mechanism.evaluators[index],
        );
    }
    // Last, so that a picture changes nothing for the functions beside it.
    let mut picture = None;
    if let Some(index) = drawn {
        let definition = &mechanism.evaluators[index];
        picture = draw(
            algebra,
            (reference, nominal),
            definition,
            origins,
            diagnostics,
        );
        let whole = (&mut *algebra, &mut *forces, formulation);
        let request = quantity::request(whole, definition, Direction::Forward);
        // What a picture needs that could not be found is not known.
        if !algebra.pictured.is_empty() {
            needs::check_inputs(algebra, definition, &request, origins, diagnostics);
        }
        choices[index] = Choice::forward(algebra, &mut inliner, &request);
        let whole = (&mut *algebra, &mut *forces, formulation);
        choices[index].improve(whole, &mut inliner, definition);
    }

    let nodes = coupled_nodes(algebra, formulation, &mut inliner);
    let beside = beside(algebra, formulation, &mut inliner, &choices);

    let outputs = choices.iter().flat_map(|choice| &choice.outputs);
    let outputs = outputs.chain(beside.iter().flatten().flatten());
    let of_groups: Vec<NodeId> = nodes.iter().flat_map(Nodes::all).collect();
    let others = gaps.iter().chain(&survey).chain(&of_groups);
    let all: Vec<NodeId> = outputs.chain(others).copied().collect();
    let angles = formulation.in_order(algebra, valued_angles(&inliner.target, &all));
    let units: Vec<NodeId> = angles
        .iter()
        .flat_map(|&angle| {
            [
                algebra.angles[angle].cos_node,
                algebra.angles[angle].sin_node,
            ]
        })
        .collect();
    let units = copy(&mut inliner, algebra, &units);

    let mut slots = Slots::default();
    let graph = &inliner.target;
    let evaluators = choices.iter().enumerate().map(|(index, choice)| {
        let definition = &mechanism.evaluators[index];
        let program = schedule(graph, &choice.outputs, &mut slots);
        let beside = beside[index].as_ref();
        let beside = beside.map(|outputs| schedule(graph, outputs, &mut slots));
        Evaluator {
            index,
            states: states(&program),
            program,
            beside,
            fields: fields::fields(mechanism, definition, picture.as_ref()),
            columns: columns::columns(mechanism, definition, picture.as_ref()),
            sensitivities: choice.direction.map(Direction::words),
        }
    });
    let evaluators = evaluators.collect();
    let mut coupled = coupled_groups(algebra, formulation, nominal, &nodes, |nodes| {
        schedule(graph, nodes, &mut slots)
    });
    for (group, own) in coupled.iter_mut().zip(&nodes) {
        let valued = valued_angles(graph, &own.all());
        let last = angles.iter().rposition(|angle| valued.contains(angle));
        group.turning = last.map_or(0, |last| last + 1);
    }
    let mut lowered = Lowered {
        evaluators,
        coupled,
        gaps: schedule(graph, &gaps, &mut slots),
        survey: schedule(graph, &survey, &mut slots),
        angles: schedule(graph, &units, &mut slots),
        prepare: slots.prepare(graph),
        continuous_angles: Vec::new(),
        picture: None,
    };
    lowered.continuous_angles = angles
        .iter()
        .map(|&k| continuous(algebra, nominal, k))
        .collect();
    renumber(&mut lowered, &angles);
    lowered.picture = picture;
    lowered
}

/// What a function's picture shows; a mechanism that does not close has none.
fn draw<'m>(
    algebra: &mut Algebra<'m>,
    (reference, nominal): (&Reference, &Nominal),
    definition: &'m EvaluatorDef,
    origins: &Origins,
    diagnostics: &mut Diagnostics,
) -> Option<Picture> {
    let asked = definition.asked_picture().filter(|_| reference.closed)?;
    let picture = picture::find(algebra, (reference, nominal), asked, origins, diagnostics);
    algebra.pictured = picture.vectors().map(<[NodeId]>::to_vec).collect();
    Some(picture)
}

/// The results of functions that use a table, for dimensions, derivatives or digits that the table does not know.
fn beside(
    algebra: &mut Algebra,
    formulation: &Formulation,
    inliner: &mut Inliner,
    choices: &[Choice],
) -> Vec<Option<Vec<NodeId>>> {
    if !formulation.prepared().any(Prepared::has_table) {
        return vec![None; choices.len()];
    }
    let define = |algebra: &mut Algebra, version| {
        for prepared in formulation.prepared() {
            redefine(algebra, prepared, version);
        }
    };
    define(algebra, Version::Beside);
    inliner.forget();
    let outputs = choices
        .iter()
        .map(|choice| Some(choice.renewed(algebra, inliner)).filter(|own| *own != choice.outputs));
    let outputs = outputs.collect();
    define(algebra, Version::Called);
    inliner.forget();
    outputs
}

/// See [`Lowered::survey`].
fn survey(algebra: &mut Algebra, formulation: &Formulation) -> Vec<NodeId> {
    let graph = &mut algebra.graph;
    let one = graph.one();
    let margins = formulation.groups.iter().map(|group| group.closed.margin);
    let least = margins.fold(one, |least, margin| {
        graph.binary(Binary::Min, least, margin)
    });
    let found = (0..algebra.bound.len()).filter(|&k| formulation.last_group_with(k).is_some());
    let places = found.flat_map(|unknown| unknown_nodes(algebra, unknown));
    std::iter::once(least).chain(places).collect()
}

/// The coupled groups whose prepared states a program loads.
fn states(program: &Program) -> Vec<usize> {
    let loads = program.instructions.iter();
    let mut groups: Vec<usize> = loads
        .filter_map(|instruction| match instruction {
            Instruction::Load(Source::State(group, _)) => Some(*group),
            _ => None,
        })
        .collect();
    groups.sort_unstable();
    groups.dedup();
    groups
}

/// The results of one function as nodes of the expression graph.
pub(crate) fn requested_nodes(
    whole: (&mut Algebra, &mut Forces, &Formulation),
    definition: &EvaluatorDef,
) -> Vec<NodeId> {
    quantity::request(whole, definition, Direction::Forward).nodes
}

fn copy(inliner: &mut Inliner, algebra: &Algebra, nodes: &[NodeId]) -> Vec<NodeId> {
    nodes
        .iter()
        .map(|&node| inliner.copy(&algebra.graph, node))
        .collect()
}

fn continuous(algebra: &mut Algebra, nominal: &Nominal, index: usize) -> ContinuousAngle {
    let angle = algebra.angles[index].clone();
    ContinuousAngle {
        unknown: angle.meant().unwrap_or(0),
        inputs: algebra.inputs_below(&[angle.cos_node, angle.sin_node]),
        estimate: angle.estimate(nominal),
    }
}

/// Centres and windings count the continuous angles only.
fn renumber(lowered: &mut Lowered, angles: &[usize]) {
    let number = |angle: usize| angles.iter().position(|&a| a == angle).unwrap_or(angle);
    let evaluators = lowered
        .evaluators
        .iter_mut()
        .flat_map(|own| [Some(&mut own.program), own.beside.as_mut()]);
    let groups = lowered
        .coupled
        .iter_mut()
        .flat_map(|own| [&mut own.system, &mut own.correct, &mut own.placed]);
    let Lowered {
        prepare,
        gaps,
        angles: directions,
        survey,
        ..
    } = lowered;
    let programs = [prepare, gaps, directions, survey];
    for program in evaluators.flatten().chain(groups).chain(programs) {
        renumber_program(program, number);
    }
}

fn renumber_program(program: &mut Program, number: impl Fn(usize) -> usize) {
    for instruction in &mut program.instructions {
        if let Instruction::Load(Source::Centre(angle) | Source::Winding(angle, _)) = instruction {
            *angle = number(*angle);
        }
    }
}
