//! A mechanism's functions as they are in the expression graph, before slicing and scheduling:
//! tests compare the programs with them.

use std::sync::Mutex;

use linkage_symbolic::program::Source;
use linkage_symbolic::{Ex, Graph, NodeId, evaluate};
use proc_macro2::TokenStream;

use crate::algebra::{Algebra, Angle, Nominal};
use crate::driver::{Checked, Driver};
use crate::forces::Forces;
use crate::observer::PhaseObserver;
use crate::outputs::{State, requested};
use crate::solve::Formulation;

/// The expression graph of a mechanism, unknowns still being symbols with definitions.
#[derive(Debug, Default)]
pub struct Oracle {
    /// In a lock: a graph grows through a shared reference, and tests share an oracle.
    graph: Mutex<Graph>,
    functions: Vec<Vec<NodeId>>,
    /// For each angle of the graph, its start estimate.
    estimates: Vec<f64>,
}

impl Oracle {
    /// Returns the graph of a mechanism, and the result of [`check`](crate::check) for it. With a
    /// mistake there are no functions in the graph.
    pub fn new(body: TokenStream) -> (Self, Checked) {
        let mut oracle = Self::default();
        let checked = Driver::run(body, &mut oracle).last();
        (oracle, checked)
    }

    /// The results of a function, by its number, near the reference inputs, where angles are
    /// nearest to their estimates. `load` supplies parameters, inputs and modes.
    ///
    /// # Panics
    /// If there is no such function.
    pub fn evaluate(&self, function: usize, load: impl Fn(Source) -> f64) -> Vec<f64> {
        let graph = self.graph.lock().expect("nobody failed with it");
        let outputs = self.functions[function].iter();
        let outputs: Vec<Ex> = outputs.map(|&id| graph.ex(id)).collect();
        evaluate(&outputs, |source| match source {
            Source::Centre(angle) => self.estimates[angle],
            Source::Winding(..) => 0.0,
            other => load(other),
        })
    }
}

impl PhaseObserver for Oracle {
    fn formulated<'m>(
        &mut self,
        algebra: &mut Algebra<'m>,
        formulation: &Formulation<'m>,
        nominal: &Nominal,
    ) {
        let estimate = |angle: &Angle| angle.estimate(nominal);
        self.estimates = algebra.names.angles.iter().map(estimate).collect();
        algebra.tried(|algebra| {
            let functions = &algebra.mechanism.evaluators;
            let mut forces = Forces::new(algebra);
            let mut state = State {
                forces: &mut forces,
                formulation,
                drawn: Vec::new(),
                algebra: &mut *algebra,
            };
            let scalars = functions
                .iter()
                .map(|definition| requested(&mut state, definition));
            let ids = scalars.map(|all| all.into_iter().map(Ex::id).collect());
            self.functions = ids.collect();
            self.graph = Mutex::new(algebra.graph.clone());
        });
    }
}
