//! The mechanism as algebra: its expressions as graph nodes, its unknowns as symbols.
//!
//! Shared by the phases below the model: `structure` looks at the loops as polynomials in the unknowns, `solve`
//! gives the unknowns their definitions, `outputs` differentiates.

pub(crate) mod acting;
pub(crate) mod adjoint;
pub(crate) mod angle_reference;
pub(crate) mod bodies;
pub(crate) mod body_vectors;
pub(crate) mod calls;
pub(crate) mod carried;
pub(crate) mod choice;
pub(crate) mod constant_ratio;
pub(crate) mod course;
pub(crate) mod dependence;
pub(crate) mod derivatives;
pub(crate) mod elimination;
pub(crate) mod finite_numbers;
pub(crate) mod frame;
pub(crate) mod gradient;
pub(crate) mod implicit;
pub(crate) mod law;
pub(crate) mod links;
pub(crate) mod names;
pub(crate) mod nominal;
pub(crate) mod partial;
pub(crate) mod parts;
pub(crate) mod pivots;
pub(crate) mod preaccumulation;
pub(crate) mod reverse;
pub(crate) mod rotating_frame;
pub(crate) mod rows;
pub(crate) mod scalar;
pub(crate) mod solutions;
pub(crate) mod translate;
pub(crate) mod turns;
pub(crate) mod via_slider;

use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, Graph, Snapshot, SymbolId};

use crate::model::{Mechanism, Variable};

use derivatives::Derivatives;

pub(crate) use adjoint::Direction;
pub(crate) use angle_reference::{AngleReference, Phasor};
pub(crate) use bodies::{Bodies, Body, Scheme};
pub(crate) use carried::{coordinates, directions};
pub(crate) use constant_ratio::{ALIKE, ConstantRatio};
pub(crate) use course::clamped_curvatures;
pub(crate) use elimination::{CoreRow, Elimination, PrivateColumn};
pub(crate) use law::ends as ends_of_law;
pub(crate) use links::{Link, Rod};
pub(crate) use names::{Angle, Bound, Names, StandsFor};
pub(crate) use nominal::Nominal;
pub(crate) use pivots::{InOrder, Order};
pub(crate) use rotating_frame::Carrier;
pub(crate) use rows::{Carried, Distance, Links, Written};
pub(crate) use scalar::{Atom, Scalar};
pub(crate) use solutions::{AngleRule, Rule, Shortcuts, Solution, Solutions, Term, Turning};
pub(crate) use translate::{Translate, Value};
pub(crate) use via_slider::ViaSlider;

/// The graph and all that is known about its symbols.
#[derive(Debug)]
pub(crate) struct Algebra<'m> {
    pub(crate) mechanism: &'m Mechanism,
    pub(crate) graph: &'m Graph,
    /// What the names of the model are.
    pub(crate) names: Names<'m>,
    /// How the unknowns are found, and so how they are differentiated.
    pub(crate) solutions: Solutions<'m>,
    /// Derivatives found already.
    derivatives: Derivatives<'m>,
}

/// The state of an [`Algebra`] and its graph at some moment.
pub(crate) struct AlgebraState<'m> {
    graph: Snapshot,
    names: Names<'m>,
    solutions: Solutions<'m>,
    derivatives: Derivatives<'m>,
}

impl<'m> Algebra<'m> {
    /// The unknowns as symbols of an empty graph.
    pub(crate) fn new(mechanism: &'m Mechanism, graph: &'m Graph) -> Self {
        Self {
            mechanism,
            graph,
            names: Names::new(mechanism, graph),
            solutions: Solutions::default(),
            derivatives: Derivatives::default(),
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

    pub(crate) fn input(&self, index: usize) -> Ex<'m> {
        self.source(Source::Input(index))
    }

    /// What a program loads from `source`.
    pub(crate) fn source(&self, source: Source) -> Ex<'m> {
        self.graph.ex(self.graph.source(source))
    }

    pub(crate) fn zero(&self) -> Ex<'m> {
        self.graph.number(0.0)
    }

    pub(crate) fn one(&self) -> Ex<'m> {
        self.graph.number(1.0)
    }

    /// True if an expression is zero wherever it is evaluated.
    pub(crate) fn vanishes(&self, x: Ex<'m>) -> bool {
        frame::vanishes(x)
    }
}
