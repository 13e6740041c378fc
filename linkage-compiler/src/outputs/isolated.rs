//! One function in a plain graph of its own, as if no other stood beside it: what others ask for changes nothing in its code.

use linkage_symbolic::inline::Inliner;
use linkage_symbolic::program::{Instruction, Program, Source};
use linkage_symbolic::schedule::{Slots, schedule};
use linkage_symbolic::{Graph, NodeId};

use crate::algebra::{Algebra, Direction};
use crate::diagnostic::Reporter;
use crate::ir::{Body, Function, Picture};
use crate::lower::{Formulas, valued_angles};
use crate::model::EvaluatorDef;
use crate::observer::PhaseObserver;
use crate::picture;
use crate::solve::{Formulation, Prepared, Version};

use super::choice::Choice;
use super::quantity::Way;
use super::{AtReference, State, columns, effort, fields, needs, quantity};

/// A function before it is scheduled.
#[derive(Debug)]
pub(super) struct Alone {
    pub(super) graph: Graph,
    formulas: Formulas,
    /// The results for dimensions, derivatives or digits that a table does not know, if they differ.
    beside: Option<Vec<NodeId>>,
    /// The results where a follower stands, if they differ.
    settled: Option<Vec<NodeId>>,
    direction: Option<Direction>,
    /// What it shows, if it asks for a picture.
    pub(super) picture: Option<Picture>,
}

impl Alone {
    /// Finds the values of a function. An argument list that does not fit them is reported, and a picture that cannot be drawn.
    pub(super) fn new<'m>(
        state: &mut State<'_, 'm>,
        at: AtReference,
        inliner: &Inliner,
        definition: &'m EvaluatorDef,
        reporter: &mut Reporter,
    ) -> Self {
        let formulation = state.formulation;
        let mut forces = state.forces.clone();
        state.algebra.tried(|algebra| {
            let own = &mut State {
                algebra,
                forces: &mut forces,
                formulation,
                drawn: Vec::new(),
            };
            let asked = definition.asked_picture();
            // A mechanism that does not close has no picture.
            let picture = asked.filter(|_| at.reference.closed).map(|asked| {
                let found = picture::find(own.algebra, at.reference, at.nominal, asked, reporter);
                own.drawn = found.vectors;
                found.picture
            });
            let directions = effort::directions(own.algebra, formulation, definition);
            let first = Way {
                direction: directions[0],
                ..Way::default()
            };
            let requested = quantity::request(own, definition, first);
            // What a picture needs that could not be found is not known.
            if asked.is_none() || !own.drawn.is_empty() {
                needs::check_inputs(own.algebra, definition, &requested, reporter);
            }
            let mut inliner = inliner.clone();
            let mut choice = Choice::first(&mut inliner, requested, first);
            choice.improve(own, &mut inliner, definition, &directions);
            let mut other = |asks: fn(&Prepared) -> bool, version| {
                other(
                    own.algebra,
                    formulation,
                    &mut inliner,
                    &choice,
                    asks,
                    version,
                )
            };
            let beside = other(|own| own.is_shorter_in_calls(), Version::Beside);
            let settled = other(|own| own.has_follower(), Version::Raw);
            Self {
                beside,
                settled,
                picture,
                direction: choice.direction(),
                formulas: choice.formulas,
                graph: inliner.target,
            }
        })
    }

    /// The angles whose values it is computed from.
    pub(super) fn valued_angles(&self) -> Vec<usize> {
        let others = self.beside.iter().chain(&self.settled).flatten();
        let all: Vec<NodeId> = self.formulas.last.iter().chain(others).copied().collect();
        valued_angles(&self.graph, &all)
    }

    /// The function, which shares prepared slots with others.
    pub(super) fn function(
        self,
        algebra: &Algebra,
        index: usize,
        slots: &mut Slots,
        watch: &mut dyn PhaseObserver,
    ) -> Function {
        let definition = &algebra.mechanism.evaluators[index];
        self.formulas.show(&self.graph, index, watch);
        let program = schedule(&self.graph, &self.formulas.last, slots);
        let others = [&self.beside, &self.settled];
        let [beside, settled] = others.map(|outputs| {
            let outputs = outputs.as_ref()?;
            Some(body(schedule(&self.graph, outputs, slots)))
        });
        let picture = self.picture.as_ref();
        let columns = columns::columns(algebra.mechanism, definition, picture);
        Function {
            name: definition.name.clone(),
            documentation: definition.documentation.clone(),
            arguments: definition.inputs.clone(),
            states: states(&program),
            called: body(program),
            beside,
            settled,
            fields: fields::fields(algebra.mechanism, definition, picture, &columns),
            columns,
            sensitivities: self.direction.map(Direction::words),
        }
    }
}

fn body(program: Program) -> Body {
    Body {
        program,
        ..Body::default()
    }
}

/// The results with another version of the prepared states, if a coupled group asks for it and they differ.
fn other<'m>(
    algebra: &Algebra<'m>,
    formulation: &Formulation<'m>,
    inliner: &mut Inliner,
    choice: &Choice<'m>,
    asks: fn(&Prepared) -> bool,
    version: Version,
) -> Option<Vec<NodeId>> {
    if !formulation.prepared().any(|own| asks(own)) {
        return None;
    }
    for prepared in formulation.prepared() {
        prepared.define(algebra.graph, version);
    }
    let own = choice.renewed(inliner);
    Some(own).filter(|own| *own != choice.formulas.last)
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
