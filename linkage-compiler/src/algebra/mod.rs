//! The mechanism as algebra: its expressions as graph nodes, its unknowns as symbols.
//!
//! Shared by the phases below the model: `structure` looks at the loops as polynomials in the unknowns, `formulate`
//! gives the unknowns their definitions, `lower` differentiates.

mod adjoint;
mod calls;
mod dependence;
mod elimination;
mod frame;
mod implicit;
mod lengths;
mod nominal;
mod partial;
mod reverse;
mod scalar;
mod translate;
mod written;

use std::collections::{HashMap, HashSet};

use linkage_symbolic::program::Source;
use linkage_symbolic::{DerivativeMemo, Graph, NodeId, SymbolId};

use crate::model::{Mechanism, Type, Variable};

pub(crate) use adjoint::Direction;
pub(crate) use elimination::{CoreRow, Elimination, PrivateColumn};
pub(crate) use implicit::{AngleRule, Rule, Solution, Term, Turning};
pub(crate) use nominal::Nominal;
pub(crate) use scalar::{Atom, Scalar};
pub(crate) use translate::{Translate, Value};

/// An unknown angle. Loops see its cosine and sine; its value is computed only where somebody asks for it.
#[derive(Clone, Debug)]
pub(crate) struct Angle {
    pub(crate) cos: SymbolId,
    pub(crate) sin: SymbolId,
    pub(crate) value: SymbolId,
    pub(crate) cos_node: NodeId,
    pub(crate) sin_node: NodeId,
    pub(crate) value_node: NodeId,
    /// The model's unknown; `None` for an angle that the compiler introduced.
    pub(crate) unknown: Option<usize>,
    /// The unknown in whose place an introduced angle stands, and its start estimate.
    pub(crate) stands_for: Option<(usize, f64)>,
}

/// What an unknown of the model stands for.
#[derive(Clone, Debug)]
pub(crate) enum Bound {
    Angle(usize),
    /// A slide, or the components of an unknown point.
    Lengths(Vec<(SymbolId, NodeId)>),
}

/// The graph and all that is known about its symbols.
#[derive(Debug)]
pub(crate) struct Algebra<'m> {
    pub(crate) mechanism: &'m Mechanism,
    pub(crate) graph: &'m Graph,
    pub(crate) angles: Vec<Angle>,
    pub(crate) bound: Vec<Bound>,
    /// Vectors behind nodes that are their lengths: a loop `distance(a, b) = l` is solved by these.
    pub(crate) norms: HashMap<NodeId, Vec<NodeId>>,
    /// The same behind squares of lengths.
    pub(crate) squares: HashMap<NodeId, Vec<NodeId>>,
    /// Vectors known to be of length 1.
    units: HashSet<Vec<NodeId>>,
    pub(crate) rules: HashMap<SymbolId, Rule>,
    pub(crate) solutions: Vec<Solution>,
    memo: DerivativeMemo,
    rates: HashMap<(usize, Vec<SymbolId>), implicit::Rates>,
    partials: partial::Partials,
    adjoints: adjoint::Adjoints,
    gradients: HashMap<NodeId, reverse::Gradient>,
    lets: Vec<Option<Value>>,
    constants: Vec<Option<Value>>,
    /// Factors with which input angles turn vectors.
    turning: Vec<(Atom, f64)>,
    /// What `picture()` shows, once it has been found: points, then unit vectors.
    pub(crate) pictured: Vec<Vec<NodeId>>,
    /// Inputs that symbols depend on.
    inputs_of: HashMap<SymbolId, Vec<usize>>,
}

impl<'m> Algebra<'m> {
    pub(crate) fn new(mechanism: &'m Mechanism, graph: &'m Graph) -> Self {
        let mut algebra = Self {
            mechanism,
            graph,
            angles: Vec::new(),
            bound: Vec::new(),
            norms: HashMap::new(),
            squares: HashMap::new(),
            units: HashSet::new(),
            rules: HashMap::new(),
            solutions: Vec::new(),
            memo: DerivativeMemo::new(),
            rates: HashMap::new(),
            partials: Default::default(),
            adjoints: Default::default(),
            gradients: HashMap::new(),
            lets: vec![None; mechanism.lets.len()],
            constants: vec![None; mechanism.constants.len()],
            turning: Vec::new(),
            pictured: Vec::new(),
            inputs_of: HashMap::new(),
        };
        for (index, unknown) in mechanism.unknowns.iter().enumerate() {
            let bound = match unknown.ty {
                Type::Scalar(dimension) if dimension.half_lengths == 0 => {
                    Bound::Angle(algebra.add_angle(&unknown.name, Some(index)))
                }
                Type::Vector(count, _) => Bound::Lengths(
                    (0..count)
                        .map(|k| {
                            algebra
                                .graph
                                .unknown(format!("{}.{}", unknown.name, AXES[k]))
                        })
                        .collect(),
                ),
                _ => Bound::Lengths(vec![algebra.graph.unknown(unknown.name.clone())]),
            };
            algebra.bound.push(bound);
        }
        algebra
    }

    /// How many numbers an unknown of the model has.
    pub(crate) fn components_of(&self, unknown: usize) -> usize {
        match &self.bound[unknown] {
            Bound::Angle(_) => 1,
            Bound::Lengths(symbols) => symbols.len(),
        }
    }

    /// A new unknown angle.
    pub(crate) fn add_angle(&mut self, name: &str, unknown: Option<usize>) -> usize {
        let (cos, cos_node) = self.graph.unknown(format!("cos {name}"));
        let (sin, sin_node) = self.graph.unknown(format!("sin {name}"));
        let (value, value_node) = self.graph.unknown(name);
        self.graph.pair(cos, sin);
        self.angles.push(Angle {
            cos,
            sin,
            value,
            cos_node,
            sin_node,
            value_node,
            unknown,
            stands_for: None,
        });
        self.angles.len() - 1
    }

    /// The symbol that derivatives by a model variable refer to.
    pub(crate) fn variable(&mut self, variable: Variable) -> SymbolId {
        let source = match variable {
            Variable::Input(index) => Source::Input(index),
            Variable::Parameter(id) => Source::Parameter(id.0),
        };
        self.graph.source(source);
        self.graph.find_source(source).expect("just made")
    }

    /// The factors with which an input angle turns vectors (gear ratios).
    pub(crate) fn input_rates(&self, input: Atom) -> impl Iterator<Item = f64> {
        self.turning
            .iter()
            .filter(move |(atom, _)| *atom == input)
            .map(|(_, k)| *k)
    }

    pub(crate) fn input(&mut self, index: usize) -> NodeId {
        self.graph.source(Source::Input(index))
    }
}

/// Names of vector components.
pub(crate) const AXES: [&str; 3] = ["x", "y", "z"];
