//! The programs by which coupled groups are prepared: in `assemble()`, and at compile time by the interpreter.

use linkage_runtime::numeric::roots::Variable;
use linkage_symbolic::NodeId;
use linkage_symbolic::inline::Inliner;
use linkage_symbolic::program::Program;

use crate::algebra::{Algebra, Bound, Nominal};
use crate::formulate::{Definition, Formulation, Prepared, unknown_nodes};

/// What `assemble()` prepares of a coupled group.
#[derive(Clone, Debug)]
pub struct Coupled {
    /// Index among all groups.
    pub group: usize,
    /// The inputs that it depends on.
    pub inputs: Vec<usize>,
    /// Numbers in a state.
    pub size: usize,
    /// What the variables of its polynomials are.
    pub variables: Vec<Variable>,
    /// Equation and exponents of each term of the polynomials.
    pub terms: Vec<(usize, Vec<i8>)>,
    /// Real and imaginary part of each term's coefficient.
    pub system: Program,
    /// From a state: the state after one Newton step, the square of the correction, the determinant before it.
    pub correct: Program,
    /// From a state: cosine and sine, or length, of each of `unknowns`, then the reach of the links.
    pub placed: Program,
    /// The reach of the default mechanism.
    pub reach: f64,
    pub unknowns: Vec<Placed>,
    /// How many continuous angles, the first ones, must be followed before its programs can be run.
    pub turning: usize,
}

/// A number that assemblies are told apart by.
#[derive(Clone, Debug)]
pub struct Placed {
    /// Index in the model.
    pub unknown: usize,
    /// Of a point.
    pub component: Option<usize>,
    pub angle: bool,
    /// Start estimate at the reference inputs.
    pub estimate: f64,
}

/// The programs of a coupled group before they are scheduled: nodes of a plain graph.
#[derive(Clone, Debug)]
pub(crate) struct Nodes {
    pub(crate) system: Vec<NodeId>,
    pub(crate) correct: Vec<NodeId>,
    pub(crate) placed: Vec<NodeId>,
}

impl Nodes {
    pub(crate) fn all(&self) -> Vec<NodeId> {
        [&self.system[..], &self.correct, &self.placed].concat()
    }
}

/// Which of its meanings an unknown of a core has.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Version {
    Raw,
    Called,
    Beside,
}

/// Gives the unknowns of a core another meaning.
pub(crate) fn redefine(algebra: &mut Algebra, prepared: &Prepared, version: Version) {
    for definition in &prepared.core {
        let Definition {
            symbol,
            raw,
            called,
            beside,
        } = *definition;
        let meaning = match version {
            Version::Raw => raw,
            Version::Called => called,
            Version::Beside => beside,
        };
        algebra.graph.define(symbol, meaning);
    }
}

/// The programs of all coupled groups as nodes.
pub(crate) fn nodes(
    algebra: &mut Algebra,
    formulation: &Formulation,
    inliner: &mut Inliner,
) -> Vec<Nodes> {
    let mut all: Vec<Nodes> = Vec::new();
    for prepared in formulation.prepared() {
        let system = prepared.system.coefficients.concat();
        all.push(Nodes {
            system: super::copy(inliner, algebra, &system),
            correct: super::copy(inliner, algebra, &prepared.step),
            placed: Vec::new(),
        });
    }
    for (index, solved) in formulation.groups.iter().enumerate() {
        let Some(prepared) = &solved.prepared else {
            continue;
        };
        redefine(algebra, prepared, Version::Raw);
        inliner.forget();
        let own = placed_unknowns(algebra, formulation, index);
        let own: Vec<NodeId> = own
            .iter()
            .flat_map(|&unknown| unknown_nodes(algebra, unknown))
            .chain([prepared.reach])
            .collect();
        all[prepared.number].placed = super::copy(inliner, algebra, &own);
        redefine(algebra, prepared, Version::Called);
    }
    inliner.forget();
    all
}

/// The unknowns that a group is the last to find.
fn placed_unknowns(algebra: &Algebra, formulation: &Formulation, group: usize) -> Vec<usize> {
    let unknowns = 0..algebra.bound.len();
    unknowns
        .filter(|&unknown| formulation.last_group_with(unknown) == Some(group))
        .collect()
}

/// What else is known of the coupled groups; `programs` schedules nodes.
pub(crate) fn groups(
    algebra: &Algebra,
    formulation: &Formulation,
    nominal: &Nominal,
    nodes: &[Nodes],
    mut program: impl FnMut(&[NodeId]) -> Program,
) -> Vec<Coupled> {
    let mut groups = Vec::new();
    for (index, solved) in formulation.groups.iter().enumerate() {
        let Some(prepared) = &solved.prepared else {
            continue;
        };
        let own = &nodes[prepared.number];
        groups.push(Coupled {
            group: index,
            inputs: prepared.inputs.clone(),
            size: prepared.size,
            variables: prepared.system.variables.clone(),
            terms: prepared.system.terms.clone(),
            system: program(&own.system),
            correct: program(&own.correct),
            placed: program(&own.placed),
            turning: 0,
            reach: nominal.evaluate(&algebra.graph, &[prepared.reach])[0],
            unknowns: placed_unknowns(algebra, formulation, index)
                .into_iter()
                .flat_map(|unknown| placed(algebra, nominal, unknown))
                .collect(),
        });
    }
    groups
}

fn placed(algebra: &Algebra, nominal: &Nominal, unknown: usize) -> Vec<Placed> {
    let estimates = &nominal.estimates[unknown];
    let angle = matches!(algebra.bound[unknown], Bound::Angle(_));
    let several = estimates.len() > 1;
    let numbers = estimates.iter().enumerate();
    numbers
        .map(|(component, &estimate)| Placed {
            unknown,
            component: several.then_some(component),
            angle,
            estimate,
        })
        .collect()
}
