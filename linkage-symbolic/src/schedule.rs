//! Slicing and ordering: from a plain graph to straight-line programs, split by when values are known.

use crate::unordered::Map;
use std::collections::BTreeMap;

use crate::contract::contract;
use crate::double_angles;
use crate::graph::{Binding, Graph, Node, NodeId};
use crate::program::{Binary, Instruction, Program, Source, Unary, Value};

/// From this many divisions by one divisor, one reciprocal and products are cheaper. Two independent divisions are
/// faster than a reciprocal and two dependent products.
const SHARED_DIVISIONS: usize = 3;

/// The values that `assemble()` computes for all evaluators of a mechanism.
#[derive(Debug, Default)]
pub struct Slots {
    nodes: Vec<NodeId>,
    index: Map<NodeId, usize>,
}

impl Slots {
    fn slot(&mut self, node: NodeId) -> usize {
        *self.index.entry(node).or_insert_with(|| {
            self.nodes.push(node);
            self.nodes.len() - 1
        })
    }

    /// The program that computes all slots.
    pub fn prepare(&self, graph: &Graph) -> Program {
        polish(Scheduler::new(graph, &self.nodes, None).run(&self.nodes))
    }
}

/// The program for `outputs` at a call: what is known earlier comes from slots, what no output needs is not in it, an
/// angle and its double share a sine pair, and sums of products are contracted.
pub fn schedule(graph: &Graph, outputs: &[NodeId], slots: &mut Slots) -> Program {
    polish(Scheduler::new(graph, outputs, Some(slots)).run(outputs))
}

fn polish(program: Program) -> Program {
    contract(double_angles::share(program))
}

/// The program for `outputs` from parameters and inputs alone, without slots.
pub fn schedule_whole(graph: &Graph, outputs: &[NodeId]) -> Program {
    Scheduler::new(graph, outputs, None).run(outputs)
}

/// Like [`schedule_whole`] for several lists of outputs one after the other. Returns the number of instructions up to
/// and including each list too: a prefix of the program computes the first lists.
pub fn schedule_stages(graph: &Graph, stages: &[Vec<NodeId>]) -> (Program, Vec<usize>) {
    let outputs = stages.concat();
    let mut scheduler = Scheduler::new(graph, &outputs, None);
    let mut ends = Vec::new();
    for stage in stages {
        stage.iter().for_each(|&output| scheduler.visit(output));
        ends.push(scheduler.program.instructions.len());
    }
    (scheduler.run(&outputs), ends)
}

struct Scheduler<'a> {
    graph: &'a Graph,
    slots: Option<&'a mut Slots>,
    /// Divisors with enough divisions, and their reciprocals once computed.
    reciprocals: Map<NodeId, Option<Value>>,
    program: Program,
    values: Map<NodeId, Value>,
    one: Option<Value>,
}

impl<'a> Scheduler<'a> {
    fn new(graph: &'a Graph, outputs: &[NodeId], slots: Option<&'a mut Slots>) -> Self {
        let mut divisions: BTreeMap<NodeId, usize> = BTreeMap::new();
        for id in graph.reachable(outputs) {
            if let Node::Binary(Binary::Div, _, divisor) = graph.node(id)
                && graph.binding(divisor) == Binding::Call
            {
                *divisions.entry(divisor).or_default() += 1;
            }
        }
        divisions.retain(|_, count| *count >= SHARED_DIVISIONS);
        Self {
            graph,
            slots,
            reciprocals: divisions
                .into_keys()
                .map(|divisor| (divisor, None))
                .collect(),
            program: Program::default(),
            values: Map::new(),
            one: None,
        }
    }

    fn run(mut self, outputs: &[NodeId]) -> Program {
        for &output in outputs {
            self.visit(output);
        }
        self.program.outputs = outputs.iter().map(|output| self.values[output]).collect();
        self.program
    }

    /// Appends all that `root` needs and is not there yet, operands first.
    fn visit(&mut self, root: NodeId) {
        let mut stack = vec![root];
        while let Some(&id) = stack.last() {
            if self.values.contains_key(&id) {
                stack.pop();
                continue;
            }
            let waiting = stack.len();
            if !self.is_slot(id) {
                let operands = self.operands(id);
                stack.extend(
                    operands
                        .iter()
                        .rev()
                        .filter(|x| !self.values.contains_key(x)),
                );
            }
            if stack.len() > waiting {
                continue;
            }
            let value = self.append(id);
            self.values.insert(id, value);
            stack.pop();
        }
    }

    /// What is done for a node: a difference with a minus sign is the opposite difference.
    fn operation(&self, id: NodeId) -> Node {
        let node = self.graph.node(id);
        if let Node::Unary(Unary::Neg, inner) = node
            && let Node::Binary(Binary::Sub, a, b) = self.graph.node(inner)
        {
            return Node::Binary(Binary::Sub, b, a);
        }
        node
    }

    /// What must be computed before a node: the 1 of a shared reciprocal comes with that.
    fn operands(&self, id: NodeId) -> Vec<NodeId> {
        match self.operation(id) {
            Node::Binary(Binary::Div, a, b)
                if self.reciprocals.contains_key(&b)
                    && self.graph.constant_value(a) == Some(1.0) =>
            {
                vec![b]
            }
            node => node.operands().collect(),
        }
    }

    fn is_slot(&self, id: NodeId) -> bool {
        self.slots.is_some()
            && self.graph.binding(id) == Binding::Parameter
            && !matches!(self.load(id), Some(Source::Parameter(_)))
    }

    fn load(&self, id: NodeId) -> Option<Source> {
        match self.graph.node(id) {
            Node::Symbol(symbol) => self.graph.symbol(symbol).source,
            _ => None,
        }
    }

    fn append(&mut self, id: NodeId) -> Value {
        if self.is_slot(id)
            && let Some(slots) = self.slots.as_mut()
        {
            let slot = slots.slot(id);
            return self.push(Instruction::Load(Source::Prepared(slot)));
        }
        let instruction = match self.operation(id) {
            Node::Constant(bits) => Instruction::Constant(f64::from_bits(bits)),
            Node::Symbol(symbol) => match self.graph.symbol(symbol).source {
                Some(source) => Instruction::Load(source),
                None => unreachable!("symbols of a plain graph have sources"),
            },
            Node::Binary(Binary::Div, a, b) if self.reciprocals.contains_key(&b) => {
                let reciprocal = self.reciprocal(b);
                match self.graph.constant_value(a) {
                    Some(1.0) => return reciprocal,
                    _ => Instruction::Binary(Binary::Mul, self.values[&a], reciprocal),
                }
            }
            Node::Unary(op, a) => Instruction::Unary(op, self.values[&a]),
            Node::Binary(op, a, b) => Instruction::Binary(op, self.values[&a], self.values[&b]),
            Node::Ternary(op, a, b, c) => {
                Instruction::Ternary(op, self.values[&a], self.values[&b], self.values[&c])
            }
        };
        self.push(instruction)
    }

    fn reciprocal(&mut self, divisor: NodeId) -> Value {
        if let Some(Some(value)) = self.reciprocals.get(&divisor) {
            return *value;
        }
        let one = match self.one {
            Some(one) => one,
            None => self.push(Instruction::Constant(1.0)),
        };
        self.one = Some(one);
        let value = self.push(Instruction::Binary(Binary::Div, one, self.values[&divisor]));
        self.reciprocals.insert(divisor, Some(value));
        value
    }

    fn push(&mut self, instruction: Instruction) -> Value {
        self.program.instructions.push(instruction);
        Value(self.program.instructions.len() - 1)
    }
}
