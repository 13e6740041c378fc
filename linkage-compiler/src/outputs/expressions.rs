//! All functions of a mechanism as expressions.

use std::collections::{BTreeMap, BTreeSet};

use linkage_symbolic::inline::Inliner;
use linkage_symbolic::{Ex, Graph};

use crate::algebra::Algebra;
use crate::diagnostic::{Reporter, Section};
use crate::forces::{self, Forces};
use crate::lower::{FunctionExpressions, solved_groups};
use crate::machine::AtReference;
use crate::model::EvaluatorDef;
use crate::solve::Formulation;
use crate::structure::Scope;

use super::dependencies;
use super::isolated::express;
use super::part_graph::PartGraph;
use super::quantity::{self, Strategy};
use super::state::State;

/// Expresses all functions, in their order, and checks the bodies.
///
/// Functions of the motion come first: expressions of bodies in the graph would change the order of
/// operands in their sums. Functions of bodies follow the check.
pub(crate) fn expressions<'m>(
    algebra: &mut Algebra<'m>,
    formulation: &Formulation<'m>,
    at: AtReference,
    reporter: &mut Reporter,
) -> Vec<FunctionExpressions> {
    let inliner = solved_groups(algebra, formulation);
    let mut within = reporter.within(Section::Functions);
    let of_motion = functions_of_motion(algebra, formulation, at, &inliner, &mut within);
    let mut forces = Forces::new(algebra);
    if at.reference.closed {
        let mut within = reporter.within(Section::Bodies);
        forces::check(algebra, &mut forces, at.reference, at.nominal, &mut within);
    }
    let definitions = algebra.mechanism.evaluators.iter();
    let state = &mut State {
        algebra,
        forces: &mut forces,
        formulation,
        drawn: Vec::new(),
    };
    let mut within = reporter.within(Section::Functions);
    let functions = definitions.zip(of_motion).map(|(definition, expressed)| {
        expressed.unwrap_or_else(|| express(state, at, &inliner, definition, &mut within))
    });
    functions.collect()
}

/// The functions that need no bodies; `None` for the others.
fn functions_of_motion<'m>(
    algebra: &mut Algebra<'m>,
    formulation: &Formulation<'m>,
    at: AtReference,
    inliner: &Inliner,
    reporter: &mut Reporter,
) -> Vec<Option<FunctionExpressions>> {
    let mechanism = algebra.mechanism;
    let definitions = &mechanism.evaluators;
    let scopes = definitions
        .iter()
        .map(|definition| dependencies::scope(mechanism, formulation, definition));
    let scopes: Vec<Option<Scope>> = scopes.collect();
    // Functions of the same parts share a graph.
    let distinct: BTreeSet<&Scope> = scopes.iter().flatten().collect();
    let graphs = vec![Graph::new(); distinct.len()];
    let of_parts = distinct.into_iter().zip(&graphs).map(|(scope, graph)| {
        let part = PartGraph::new(algebra, formulation, at, scope, graph, reporter);
        (scope, part)
    });
    let mut of_parts: BTreeMap<&Scope, Option<PartGraph>> = of_parts.collect();
    let state = &mut State {
        algebra,
        forces: &mut Forces::default(),
        formulation,
        drawn: Vec::new(),
    };
    let functions = definitions.iter().zip(&scopes).map(|(definition, scope)| {
        if definition.asks_of_bodies() {
            return None;
        }
        let part = scope
            .as_ref()
            .and_then(|scope| of_parts.get_mut(scope)?.as_mut());
        Some(match part {
            Some(part) => part.function(at, definition, reporter),
            None => express(state, at, inliner, definition, reporter),
        })
    });
    functions.collect()
}

/// The results of one function as expressions of the mechanism's graph, with definitions.
pub(crate) fn requested<'m>(state: &mut State<'_, 'm>, definition: &EvaluatorDef) -> Vec<Ex<'m>> {
    quantity::request(state, definition, Strategy::default()).scalars
}
