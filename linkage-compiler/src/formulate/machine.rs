//! The mechanism on numbers: one program for all groups, run by the interpreter at compile time.

use std::collections::HashMap;

use linkage_runtime::Scalar;
use linkage_runtime::numeric::coupled::{Grid, Table};
use linkage_symbolic::inline::Inliner;
use linkage_symbolic::interpret::{run, run_steps};
use linkage_symbolic::program::{Program, Source, Value};
use linkage_symbolic::schedule::{schedule_stages, schedule_whole};
use linkage_symbolic::{Graph, NodeId, evaluate};

use crate::algebra::{Algebra, Bound, Nominal};
use crate::lower::{ContinuousAngle, Coupled, coupled_groups, coupled_nodes};

use super::Formulation;

/// Where a group's numbers stand among the program's outputs.
#[derive(Clone, Debug, Default)]
pub(crate) struct Stage {
    /// Unknowns that are compared with their estimates here: (unknown, first output).
    pub(crate) unknowns: Vec<(usize, usize)>,
    pub(crate) gap: usize,
    pub(crate) slack: usize,
    pub(crate) margin: usize,
    pub(crate) slack_scale: usize,
    /// Instructions up to here compute this group and those before.
    pub(crate) end: usize,
}

/// The program with its data.
#[derive(Clone, Debug)]
pub(crate) struct Machine {
    program: Program,
    pub(crate) stages: Vec<Stage>,
    pub(crate) parameters: Vec<f64>,
    pub(crate) modes: Vec<f64>,
    pub(crate) centres: HashMap<usize, f64>,
    pub(crate) windings: HashMap<(usize, usize), f64>,
    /// Angles whose values the groups themselves use, and their outputs (cosine; the sine follows).
    pub(crate) valued: Vec<(usize, usize)>,
    /// The coupled groups, and what is prepared of each: nothing until it is closed.
    pub(crate) coupled: Vec<Coupled>,
    pub(crate) starts: Vec<Option<Start>>,
}

/// What is prepared of a coupled group.
#[derive(Clone, Debug)]
pub(crate) enum Start {
    Table(Table),
    Grid(Grid),
}

impl Start {
    /// The state near some inputs, then the least determinant that is certified.
    fn numbers(&self, group: &Coupled, inputs: &[f64]) -> Vec<f64> {
        let mut numbers = vec![0.0; group.size];
        let own: Vec<f64> = group.inputs.iter().map(|&input| inputs[input]).collect();
        let floor = match self {
            Self::Table(table) => table.state(own[0], &mut numbers),
            Self::Grid(grid) => grid.state(&own, &mut numbers),
        };
        numbers.push(floor);
        numbers
    }
}

impl Machine {
    pub(crate) fn new(algebra: &mut Algebra, formulation: &Formulation, nominal: &Nominal) -> Self {
        let mut inliner = Inliner::default();
        let own = coupled_nodes(algebra, formulation, &mut inliner);
        let mut lists: Vec<Vec<NodeId>> = Vec::new();
        let mut stages = Vec::new();
        let mut next = 0;
        for (index, solved) in formulation.groups.iter().enumerate() {
            let mut stage = Stage::default();
            let mut nodes = Vec::new();
            for &unknown in &solved.group.unknowns {
                if formulation.last_group_with(unknown) != Some(index) {
                    continue;
                }
                stage.unknowns.push((unknown, next + nodes.len()));
                nodes.extend(unknown_nodes(algebra, unknown));
            }
            stage.gap = next + nodes.len();
            stage.slack = stage.gap + 1;
            stage.margin = stage.gap + 2;
            stage.slack_scale = stage.gap + 3;
            let closed = &solved.closed;
            nodes.extend([closed.gap, closed.slack, closed.margin, closed.slack_scale]);
            next += nodes.len();
            lists.push(
                nodes
                    .iter()
                    .map(|&node| inliner.copy(&algebra.graph, node))
                    .collect(),
            );
            stages.push(stage);
        }
        let mut machine = Self {
            program: Program::default(),
            stages,
            parameters: nominal.parameters.clone(),
            modes: vec![1.0; formulation.modes()],
            centres: HashMap::new(),
            windings: HashMap::new(),
            valued: Vec::new(),
            coupled: coupled_groups(algebra, formulation, nominal, &own, |nodes| {
                schedule_whole(&inliner.target, nodes)
            }),
            starts: vec![None; own.len()],
        };
        let mut units = Vec::new();
        let valued = valued_angles(&inliner.target, &lists.concat());
        for angle in formulation.in_order(algebra, valued) {
            machine.valued.push((angle, next + units.len()));
            let symbols = &algebra.angles[angle];
            units.extend([symbols.cos_node, symbols.sin_node]);
        }
        for (group, own) in machine.coupled.iter_mut().zip(&own) {
            let needed = valued_angles(&inliner.target, &own.all());
            let last = machine
                .valued
                .iter()
                .rposition(|(angle, _)| needed.contains(angle));
            group.turning = last.map_or(0, |last| last + 1);
        }
        lists.push(
            units
                .iter()
                .map(|&node| inliner.copy(&algebra.graph, node))
                .collect(),
        );
        let (program, ends) = schedule_stages(&inliner.target, &lists);
        machine.program = program;
        for (stage, end) in machine.stages.iter_mut().zip(ends) {
            stage.end = end;
        }
        machine
    }

    /// The cosines among the outputs of angles that functions ask for and no group uses.
    pub(crate) fn outputs_of(
        &self,
        algebra: &Algebra,
        asked: &[ContinuousAngle],
    ) -> Vec<(usize, usize)> {
        let outputs = self.stages.iter().flat_map(|stage| &stage.unknowns);
        outputs
            .filter(|(unknown, _)| asked.iter().any(|angle| angle.unknown == *unknown))
            .filter_map(|&(unknown, output)| match algebra.bound[unknown] {
                Bound::Angle(angle) => Some((angle, output)),
                Bound::Lengths(_) => None,
            })
            .filter(|(angle, _)| self.valued.iter().all(|(valued, _)| valued != angle))
            .collect()
    }

    /// The values of the instructions `from..to` at given inputs; `values` holds those before.
    pub(crate) fn advance(&self, values: &mut Vec<f64>, from: usize, to: usize, inputs: &[f64]) {
        let states = self.states(inputs);
        run_steps(&self.program, from, to, values, |source| {
            self.load(source, inputs, &states)
        });
    }

    /// Runs a program of coupled group `number` at given inputs; `state` is what that group starts from.
    pub(crate) fn run_coupled(
        &self,
        number: usize,
        program: &Program,
        inputs: &[f64],
        state: &[f64],
    ) -> Vec<f64> {
        let mut states = self.states(inputs);
        states[number] = state.to_vec();
        run(program, |source| self.load(source, inputs, &states))
    }

    /// What is prepared of all coupled groups near some inputs.
    pub(crate) fn states(&self, inputs: &[f64]) -> Vec<Vec<f64>> {
        let starts = self.starts.iter().zip(&self.coupled);
        starts
            .map(|(start, group)| {
                start
                    .as_ref()
                    .map_or_else(Vec::new, |start| start.numbers(group, inputs))
            })
            .collect()
    }

    fn load(&self, source: Source, inputs: &[f64], states: &[Vec<f64>]) -> f64 {
        match source {
            Source::Parameter(index) => self.parameters[index],
            Source::Input(index) => inputs.get(index).copied().unwrap_or(f64::NAN),
            Source::Mode(index) => self.modes[index],
            Source::Centre(angle) => self.centres.get(&angle).copied().unwrap_or(f64::NAN),
            Source::Winding(angle, input) => {
                self.windings.get(&(angle, input)).copied().unwrap_or(0.0)
            }
            Source::State(group, component) => {
                states[group].get(component).copied().unwrap_or(f64::NAN)
            }
            Source::Limit => <f64 as Scalar>::CORRECTION_LIMIT,
            Source::Prepared(_) | Source::Carried(_) => f64::NAN,
        }
    }

    /// Nodes of the mechanism's graph at given inputs.
    pub(crate) fn evaluate(&self, graph: &Graph, nodes: &[NodeId], inputs: &[f64]) -> Vec<f64> {
        let states = self.states(inputs);
        evaluate(graph, nodes, |source| self.load(source, inputs, &states))
    }

    /// All values at given inputs.
    pub(crate) fn run(&self, values: &mut Vec<f64>, inputs: &[f64]) {
        values.clear();
        self.advance(values, 0, self.program.instructions.len(), inputs);
    }

    /// An output's value.
    pub(crate) fn output(&self, values: &[f64], output: usize) -> f64 {
        let Value(place) = self.program.outputs[output];
        values[place]
    }
}

/// The nodes of an unknown: cosine and sine of an angle, components of a length or point.
pub(crate) fn unknown_nodes(algebra: &Algebra, unknown: usize) -> Vec<NodeId> {
    match &algebra.bound[unknown] {
        Bound::Angle(angle) => {
            let angle = &algebra.angles[*angle];
            vec![angle.cos_node, angle.sin_node]
        }
        Bound::Lengths(symbols) => symbols.iter().map(|(_, node)| *node).collect(),
    }
}

/// The angles whose values nodes of a plain graph are computed from.
pub(crate) fn valued_angles(graph: &Graph, nodes: &[NodeId]) -> Vec<usize> {
    let mut angles: Vec<usize> = graph
        .symbols_of(nodes)
        .into_iter()
        .filter_map(|symbol| match graph.symbol(symbol).source {
            Some(Source::Centre(angle)) => Some(angle),
            _ => None,
        })
        .collect();
    angles.sort_unstable();
    angles
}
