//! A mechanism's functions as they stand in the expression graph, before slicing and scheduling: what tests compare the
//! programs with.

use linkage_symbolic::program::Source;
use linkage_symbolic::{Graph, NodeId, evaluate};

use crate::algebra::{Algebra, Angle, Nominal};
use crate::diagnostic::{Diagnostics, Origins};
use crate::forces::Forces;
use crate::formulate::{Formulation, formulate};
use crate::lower::requested_nodes;
use crate::model::Mechanism;
use crate::structure::decompose;

/// The expression graph of a mechanism, unknowns still being symbols with definitions.
#[derive(Debug)]
pub struct Oracle {
    graph: Graph,
    functions: Vec<Vec<NodeId>>,
    /// For each angle of the graph, its start estimate.
    estimates: Vec<f64>,
}

impl Oracle {
    /// The graph of a mechanism that compiles without a message.
    pub fn new(mechanism: &Mechanism, origins: &Origins) -> Self {
        let graph = Graph::new();
        let mut algebra = Algebra::new(mechanism, &graph);
        let nominal = Nominal::of(&mut algebra);
        let mut diagnostics = Diagnostics::default();
        let structure = decompose(&mut algebra, &nominal, origins, &mut diagnostics);
        let formulation: Formulation = formulate(&mut algebra, structure);
        let mut forces = Forces::new(&mut algebra);
        let functions = mechanism
            .evaluators
            .iter()
            .map(|definition| {
                requested_nodes((&mut algebra, &mut forces, &formulation), definition)
            })
            .collect();
        let estimate = |angle: &Angle| angle.estimate(&nominal);
        let estimates = algebra.angles.iter().map(estimate).collect();
        Self {
            functions,
            estimates,
            graph,
        }
    }

    /// The results of a function near the reference inputs, where angles are nearest to their estimates. `load`
    /// supplies parameters, inputs and modes.
    pub fn evaluate(&self, function: usize, load: impl Fn(Source) -> f64) -> Vec<f64> {
        evaluate(
            &self.graph,
            &self.functions[function],
            |source| match source {
                Source::Centre(angle) => self.estimates[angle],
                Source::Winding(..) => 0.0,
                other => load(other),
            },
        )
    }
}
