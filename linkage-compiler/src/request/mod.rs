//! What functions ask for, and the unit that computes it: quantities as expressions, directions of sensitivities, programs.

mod choice;
mod columns;
mod fields;
mod needs;
mod quantity;
mod signature;
#[cfg(test)]
mod tests;

use linkage_symbolic::inline::Inliner;
use linkage_symbolic::program::{Instruction, Program, Source};
use linkage_symbolic::schedule::{Slots, schedule};
use linkage_symbolic::{Ex, NodeId, Vn};

use crate::algebra::{Algebra, Direction, Nominal};
use crate::close::Reference;
use crate::diagnostic::Reporter;
use crate::forces::Forces;
use crate::formulate::{Formulation, Prepared, Version};
use crate::lower::{self, GroupNodes, group_nodes, groups, plain, valued_angles};
use crate::model::EvaluatorDef;
use crate::picture;
use crate::unit::{Body, ContinuousAngle, Function, Picture, Unit};
use crate::watch::Watch;

use choice::Choice;

/// A formulated mechanism, in which functions are asked for.
pub(crate) struct State<'a, 'm> {
    pub(crate) algebra: &'a mut Algebra<'m>,
    pub(crate) forces: &'a mut Forces<'m>,
    pub(crate) formulation: &'a Formulation<'m>,
    /// What `picture()` shows, once it has been found: points, then unit vectors.
    pub(crate) drawn: Vec<Vn<'m>>,
}

/// The mechanism at its reference position.
#[derive(Clone, Copy)]
pub(crate) struct AtReference<'a> {
    pub(crate) reference: &'a Reference,
    pub(crate) nominal: &'a Nominal,
}

/// Lowers all functions of the mechanism. An argument list that does not fit its quantities is reported, and a picture that
/// cannot be drawn.
pub(crate) fn unit<'m>(
    mut state: State<'_, 'm>,
    at: AtReference,
    reporter: &mut Reporter,
    watch: &mut dyn Watch,
) -> Unit {
    let mechanism = state.algebra.mechanism;
    let formulation = state.formulation;
    let mut inliner = Inliner::default();
    let functions = &mechanism.evaluators;
    let drawn = functions
        .iter()
        .position(|own| own.asked_picture().is_some());
    let mut choices = vec![Choice::default(); functions.len()];
    let others = (0..choices.len()).filter(|index| Some(*index) != drawn);
    for index in others.clone() {
        let definition = &functions[index];
        let requested = quantity::request(&mut state, definition, Direction::Forward);
        needs::check_inputs(state.algebra, definition, &requested, reporter);
        choices[index] = Choice::forward(&mut inliner, requested);
    }
    let gaps = formulation.groups.iter().map(|group| group.closed.gap);
    let gaps = plain(&mut inliner, &gaps.collect::<Vec<_>>());
    let survey = plain(&mut inliner, &survey(state.algebra, formulation));
    // Late, so that one function's other directions change nothing for the others.
    for index in others {
        choices[index].improve(&mut state, &mut inliner, &functions[index]);
    }
    // Last, so that a picture changes nothing for the functions beside it.
    let mut picture = None;
    if let Some(index) = drawn {
        let definition = &functions[index];
        picture = draw(&mut state, at, definition, reporter);
        let requested = quantity::request(&mut state, definition, Direction::Forward);
        // What a picture needs that could not be found is not known.
        if !state.drawn.is_empty() {
            needs::check_inputs(state.algebra, definition, &requested, reporter);
        }
        choices[index] = Choice::forward(&mut inliner, requested);
        choices[index].improve(&mut state, &mut inliner, definition);
    }

    let algebra = state.algebra;
    let nodes = group_nodes(algebra, formulation, &mut inliner);
    let beside = beside(algebra, formulation, &mut inliner, &choices);

    let outputs = choices.iter().flat_map(|choice| &choice.formulas.shared);
    let outputs = outputs.chain(beside.iter().flatten().flatten());
    let of_groups: Vec<NodeId> = nodes.iter().flat_map(GroupNodes::all).collect();
    let others = gaps.iter().chain(&survey).chain(&of_groups);
    let all: Vec<NodeId> = outputs.chain(others).copied().collect();
    let angles = formulation.in_order(algebra, valued_angles(&inliner.target, &all));
    let units = angles.iter().map(|&angle| algebra.names.angles[angle].unit);
    let units: Vec<Ex> = units.flat_map(|unit| unit.components()).collect();
    let units = plain(&mut inliner, &units);

    let mut slots = Slots::default();
    let graph = &inliner.target;
    let functions = choices.iter().enumerate().map(|(index, choice)| {
        let definition = &mechanism.evaluators[index];
        choice.formulas.show(graph, index, watch);
        let program = schedule(graph, &choice.formulas.shared, &mut slots);
        let beside = beside[index].as_ref();
        let beside = beside.map(|outputs| schedule(graph, outputs, &mut slots));
        Function {
            name: definition.name.clone(),
            arguments: definition.inputs.clone(),
            states: states(&program),
            called: body(program),
            beside: beside.map(body),
            fields: fields::fields(mechanism, definition, picture.as_ref()),
            columns: columns::columns(mechanism, definition, picture.as_ref()),
            sensitivities: choice.direction.map(Direction::words),
        }
    });
    let functions = functions.collect();
    let mut coupled = groups(algebra, formulation, at.nominal, &nodes, |nodes| {
        schedule(graph, nodes, &mut slots)
    });
    for (group, own) in coupled.iter_mut().zip(&nodes) {
        let valued = valued_angles(graph, &own.all());
        let last = angles.iter().rposition(|angle| valued.contains(angle));
        group.turning = last.map_or(0, |last| last + 1);
    }
    let mut unit = Unit {
        functions,
        coupled,
        gaps: schedule(graph, &gaps, &mut slots),
        survey: schedule(graph, &survey, &mut slots),
        directions: schedule(graph, &units, &mut slots),
        prepare: slots.prepare(graph),
        angles: angles
            .iter()
            .map(|&k| continuous(algebra, at.nominal, k))
            .collect(),
        picture,
        ..signature::signature(algebra, formulation, at)
    };
    renumber(&mut unit, &angles);
    lower::polish(&mut unit, watch);
    unit
}

fn body(program: Program) -> Body {
    Body {
        program,
        ..Body::default()
    }
}

/// What a function's picture shows; a mechanism that does not close has none.
fn draw<'m>(
    state: &mut State<'_, 'm>,
    at: AtReference,
    definition: &'m EvaluatorDef,
    reporter: &mut Reporter,
) -> Option<Picture> {
    let asked = definition.asked_picture().filter(|_| at.reference.closed)?;
    let found = picture::find(state.algebra, at.reference, at.nominal, asked, reporter);
    state.drawn = found.vectors;
    Some(found.picture)
}

/// The results of functions that use a table, for dimensions, derivatives or digits that the table does not know.
fn beside<'m>(
    algebra: &Algebra<'m>,
    formulation: &Formulation<'m>,
    inliner: &mut Inliner,
    choices: &[Choice<'m>],
) -> Vec<Option<Vec<NodeId>>> {
    if !formulation.prepared().any(Prepared::has_table) {
        return vec![None; choices.len()];
    }
    let define = |version| {
        for prepared in formulation.prepared() {
            prepared.define(algebra.graph, version);
        }
    };
    define(Version::Beside);
    let renewed = choices.iter().map(|choice| {
        let own = choice.renewed(inliner);
        Some(own).filter(|own| *own != choice.formulas.shared)
    });
    let outputs = renewed.collect();
    define(Version::Called);
    outputs
}

/// See [`Unit::survey`].
fn survey<'m>(algebra: &Algebra<'m>, formulation: &Formulation<'m>) -> Vec<Ex<'m>> {
    let margins = formulation.groups.iter().map(|group| group.closed.margin);
    let least = margins.fold(algebra.one(), |least, margin| least.min(margin));
    let unknowns = 0..algebra.names.bound.len();
    let found = unknowns.filter(|&k| formulation.last_group_with(k).is_some());
    let places = found.flat_map(|unknown| algebra.names.numbers_of(unknown));
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

/// The results of one function as expressions of the undigested graph.
pub(crate) fn requested<'m>(state: &mut State<'_, 'm>, definition: &EvaluatorDef) -> Vec<Ex<'m>> {
    quantity::request(state, definition, Direction::Forward).scalars
}

fn continuous<'m>(algebra: &mut Algebra<'m>, nominal: &Nominal, index: usize) -> ContinuousAngle {
    let angle = algebra.names.angles[index].clone();
    ContinuousAngle {
        unknown: angle.meant().unwrap_or(0),
        inputs: algebra.inputs_below(&angle.unit.0),
        estimate: angle.estimate(nominal),
    }
}

/// Centres and windings count the continuous angles only.
fn renumber(unit: &mut Unit, angles: &[usize]) {
    let number = |angle: usize| angles.iter().position(|&a| a == angle).unwrap_or(angle);
    for program in unit.programs_mut() {
        for instruction in &mut program.instructions {
            if let Instruction::Load(Source::Centre(angle) | Source::Winding(angle, _)) =
                instruction
            {
                *angle = number(*angle);
            }
        }
    }
}
