//! One function in a plain graph of its own: its code does not depend on other functions.

use linkage_symbolic::NodeId;
use linkage_symbolic::inline::Inliner;

use crate::algebra::Algebra;
use crate::diagnostic::Reporter;
use crate::lower::FunctionExpressions;
use crate::machine::AtReference;
use crate::model::EvaluatorDef;
use crate::picture;
use crate::solve::{Formulation, Prepared, Version};

use super::choice::Choice;
use super::quantity::Strategy;
use super::state::State;
use super::{columns, effort, fields, needs, quantity};

/// Expresses the results of a function, and leaves the algebra as it is.
///
/// Reports an argument list that does not fit the quantities, and a picture that cannot be drawn.
pub(super) fn express<'m>(
    state: &mut State<'_, 'm>,
    at: AtReference,
    inliner: &Inliner,
    definition: &'m EvaluatorDef,
    reporter: &mut Reporter,
) -> FunctionExpressions {
    let formulation = state.formulation;
    let mut forces = state.forces.clone();
    state.algebra.tried(|algebra| {
        let state = &mut State {
            algebra,
            forces: &mut forces,
            formulation,
            drawn: Vec::new(),
        };
        let asked = definition.asked_picture();
        // A mechanism that does not close has no picture.
        let picture = asked.filter(|_| at.reference.closed).map(|asked| {
            let found = picture::find(state.algebra, at, asked, reporter);
            state.drawn = found.vectors;
            found.picture
        });
        let directions = effort::directions(state.algebra, formulation, definition);
        let first = Strategy {
            direction: directions[0],
            ..Strategy::default()
        };
        let requested = quantity::request(state, definition, first);
        // The inputs of a picture that could not be found are not known.
        if asked.is_none() || !state.drawn.is_empty() {
            needs::check_inputs(state.algebra, definition, &requested, reporter);
        }
        let mut inliner = inliner.clone();
        let mut choice = Choice::first(&mut inliner, requested, first);
        choice.improve(state, &mut inliner, definition, &directions);
        let mut with_version = |asks: fn(&Prepared) -> bool, version| {
            with_version(
                state.algebra,
                formulation,
                &mut inliner,
                &choice,
                asks,
                version,
            )
        };
        let beside = with_version(|prepared| prepared.is_shorter_in_calls(), Version::Beside);
        let settled = with_version(|prepared| prepared.has_follower(), Version::Raw);
        let mechanism = state.algebra.mechanism;
        let columns = columns::columns(mechanism, definition, picture.as_ref());
        FunctionExpressions {
            beside,
            settled,
            direction: choice.direction(),
            formulas: choice.formulas,
            graph: inliner.target,
            fields: fields::fields(mechanism, definition, picture.as_ref(), &columns),
            columns,
            picture,
        }
    })
}

/// Returns the results with another version of the prepared states, if a coupled group needs it and
/// they differ.
fn with_version<'m>(
    algebra: &Algebra<'m>,
    formulation: &Formulation<'m>,
    inliner: &mut Inliner,
    choice: &Choice<'m>,
    asks: fn(&Prepared) -> bool,
    version: Version,
) -> Option<Vec<NodeId>> {
    if !formulation.prepared().any(|prepared| asks(prepared)) {
        return None;
    }
    for prepared in formulation.prepared() {
        prepared.define(algebra.graph, version);
    }
    let results = choice.renewed(inliner);
    Some(results).filter(|results| *results != choice.formulas.last)
}
