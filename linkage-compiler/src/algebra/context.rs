//! The mechanism as algebra: its names, its solved groups, and the derivatives that were found.

use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, Graph, Snapshot, SymbolId};

use crate::algebra::memo::DerivativeMemos;
use crate::algebra::names::Names;
use crate::algebra::solutions::Solutions;
use crate::algebra::translate::Translate;
use crate::algebra::value::Value;
use crate::algebra::vanish;
use crate::model::{Expr, Mechanism, Variable};

/// The graph and all that is known about its symbols.
#[derive(Debug)]
pub(crate) struct Algebra<'m> {
    pub(crate) mechanism: &'m Mechanism,
    pub(crate) graph: &'m Graph,
    /// The symbols and values of the model's names.
    pub(crate) names: Names<'m>,
    /// The ways in which the unknowns are found, and with them the rules of their derivatives.
    pub(crate) solutions: Solutions<'m>,
    /// Derivatives found already.
    pub(crate) derivatives: DerivativeMemos<'m>,
}

impl<'m> Translate<'m> for Algebra<'m> {
    fn names(&mut self) -> &mut Names<'m> {
        &mut self.names
    }

    fn quantity(&mut self, expr: &Expr) -> Value<'m> {
        self.names.quantity(expr)
    }
}

/// The state of an [`Algebra`] and its graph at some moment.
pub(crate) struct AlgebraState<'m> {
    graph: Snapshot,
    names: Names<'m>,
    solutions: Solutions<'m>,
    derivatives: DerivativeMemos<'m>,
}

impl<'m> Algebra<'m> {
    /// The unknowns as symbols of an empty graph.
    pub(crate) fn new(mechanism: &'m Mechanism, graph: &'m Graph) -> Self {
        Self {
            mechanism,
            graph,
            names: Names::new(mechanism, graph),
            solutions: Solutions::default(),
            derivatives: DerivativeMemos::default(),
        }
    }

    /// Runs `question`, then undoes all its changes to the graph and to the algebra.
    pub(crate) fn tried<R>(&mut self, question: impl FnOnce(&mut Self) -> R) -> R {
        let state = self.state();
        let answer = question(self);
        self.restore(state);
        answer
    }

    /// Returns the current state, for [`restore`](Self::restore).
    pub(crate) fn state(&self) -> AlgebraState<'m> {
        AlgebraState {
            graph: self.graph.snapshot(),
            names: self.names.clone(),
            solutions: self.solutions.clone(),
            derivatives: self.derivatives.clone(),
        }
    }

    /// Undoes all changes to the graph and to the algebra since `state`.
    pub(crate) fn restore(&mut self, state: AlgebraState<'m>) {
        self.graph.restore(state.graph);
        self.derivatives = state.derivatives;
        self.solutions = state.solutions;
        self.names = state.names;
    }

    /// The symbol that derivatives by a model variable refer to.
    pub(crate) fn variable(&self, variable: Variable) -> SymbolId {
        let source = match variable {
            Variable::Input(index) => Source::Input(index),
            Variable::Parameter(id) => Source::Parameter(id.0),
        };
        self.graph.source(source);
        self.graph.find_source(source).expect("just made")
    }

    /// Returns the value of an input.
    pub(crate) fn input(&self, index: usize) -> Ex<'m> {
        self.names.input(index)
    }

    /// Returns the value that a program loads from `source`.
    pub(crate) fn source(&self, source: Source) -> Ex<'m> {
        self.names.source(source)
    }

    pub(crate) fn zero(&self) -> Ex<'m> {
        self.graph.number(0.0)
    }

    pub(crate) fn one(&self) -> Ex<'m> {
        self.graph.number(1.0)
    }

    /// True if an expression is zero wherever it is evaluated.
    pub(crate) fn vanishes(&self, x: Ex<'m>) -> bool {
        vanish::vanishes(x)
    }
}
