//! The programs of one function.

use linkage_symbolic::program::{Instruction, Program, Source};
use linkage_symbolic::schedule::{Slots, schedule};
use linkage_symbolic::{Graph, NodeId};

use crate::algebra::Direction;
use crate::ir::{Body, Column, Field, Function, Picture};
use crate::model::EvaluatorDef;
use crate::observer::PhaseObserver;

use super::formulas::Formulas;
use super::plain::valued_angles;

/// The results of one function as expressions in a plain graph of its own.
#[derive(Debug)]
pub(crate) struct FunctionExpressions {
    pub(crate) graph: Graph,
    pub(crate) formulas: Formulas,
    /// The results for dimensions, derivatives or digits that a table does not have, if they
    /// differ.
    pub(crate) beside: Option<Vec<NodeId>>,
    /// The results at the states of a follower, if they differ.
    pub(crate) settled: Option<Vec<NodeId>>,
    /// The direction in which derivatives with respect to parameters were found, if there are any.
    pub(crate) direction: Option<Direction>,
    /// The picture, if the function has one.
    pub(crate) picture: Option<Picture>,
    pub(crate) fields: Vec<Field>,
    pub(crate) columns: Vec<Column>,
}

impl FunctionExpressions {
    /// Returns true for a picture in which there is no link.
    pub(super) fn draws_nothing(&self) -> bool {
        let picture = self.picture.as_ref();
        picture.is_some_and(|picture| picture.points.is_empty())
    }
}

/// The angles whose values the results are computed from.
pub(super) fn angles_of_function(function: &FunctionExpressions) -> Vec<usize> {
    let others = function.beside.iter().chain(&function.settled).flatten();
    let nodes = function.formulas.last.iter().chain(others);
    valued_angles(&function.graph, &nodes.copied().collect::<Vec<_>>())
}

/// Schedules a function, whose prepared slots are shared with others.
pub(super) fn lower_function(
    function: FunctionExpressions,
    definition: &EvaluatorDef,
    index: usize,
    slots: &mut Slots,
    observer: &mut dyn PhaseObserver,
) -> Function {
    let FunctionExpressions {
        graph,
        formulas,
        beside,
        settled,
        direction,
        fields,
        columns,
        ..
    } = function;
    formulas.show(&graph, index, observer);
    let program = schedule(&graph, &formulas.last, slots);
    let [beside, settled] = [beside, settled].map(|outputs| {
        let outputs = outputs?;
        Some(body(schedule(&graph, &outputs, slots)))
    });
    Function {
        name: definition.name.clone(),
        documentation: definition.documentation.clone(),
        arguments: definition.inputs.clone(),
        states: states(&program),
        called: body(program),
        beside,
        settled,
        fields,
        columns,
        sensitivities: direction.map(Direction::doc_text),
    }
}

fn body(program: Program) -> Body {
    Body {
        program,
        ..Body::default()
    }
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
