//! Slicing and ordering: from a plain graph to straight-line programs, split by when values are
//! known.

use crate::graph::{Binding, Graph, Node, NodeId, NodeNumbers};
use crate::lookup::Map;
use crate::program::{Binary, Instruction, Program, Source, Unary, Value};

/// The values that `assemble()` computes for all evaluators of a mechanism, in a graph of their
/// own: equal values of different graphs are one slot.
#[derive(Debug, Default)]
pub struct Slots {
    graph: Graph,
    nodes: Vec<NodeId>,
    index: Map<NodeId, usize>,
    /// The nodes in `graph` of the values of the graph that is scheduled now.
    copied: Map<NodeId, NodeId>,
}

impl Slots {
    fn slot(&mut self, source: &Graph, node: NodeId) -> usize {
        let copy = self.copy(source, node);
        *self.index.entry(copy).or_insert_with(|| {
            self.nodes.push(copy);
            self.nodes.len() - 1
        })
    }

    /// The same operations in the own graph, as they are: simplifying again would round differently
    /// beside other values.
    fn copy(&mut self, source: &Graph, root: NodeId) -> NodeId {
        let mut stack = vec![root];
        while let Some(&id) = stack.last() {
            let node = source.node(id);
            let waiting = stack.len();
            for operand in node.operands() {
                if !self.copied.contains_key(&operand) {
                    stack.push(operand);
                }
            }
            if stack.len() == waiting {
                let copy = self.copy_operation(source, node);
                self.copied.insert(id, copy);
                stack.pop();
            }
        }
        self.copied[&root]
    }

    /// An operation of values that are copied already.
    fn copy_operation(&self, source: &Graph, node: Node) -> NodeId {
        let new = |x: NodeId| self.copied[&x];
        let mut store = self.graph.store_mut();
        match node {
            Node::Constant(_) => store.intern(node),
            Node::Symbol(symbol) => {
                let symbol_source = source.symbol(symbol).source;
                store.source(symbol_source.expect("symbols of a plain graph have sources"))
            }
            Node::Unary(op, a) => store.intern(Node::Unary(op, new(a))),
            Node::Binary(op, a, b) => {
                let (mut a, mut b) = (new(a), new(b));
                // Which operand is first follows from the graph; equal values must be one slot.
                if matches!(op, Binary::Add | Binary::Mul) && b < a {
                    (a, b) = (b, a);
                }
                store.intern(Node::Binary(op, a, b))
            }
            Node::Ternary(op, a, b, c) => store.intern(Node::Ternary(op, new(a), new(b), new(c))),
        }
    }

    /// The program that computes all slots.
    pub fn prepare(&self) -> Program {
        schedule_whole(&self.graph, &self.nodes)
    }
}

/// Returns the program for `outputs` at a call: values that are known earlier come from slots, and
/// values that no output needs are left out.
pub fn schedule(graph: &Graph, outputs: &[NodeId], slots: &mut Slots) -> Program {
    slots.copied.clear();
    let mut slot = |node| slots.slot(graph, node);
    Scheduler::new(graph, Some(&mut slot)).run(outputs)
}

/// Returns the same program except for the numbers of its slots, to be counted and dropped: values
/// of `assemble()` are not recorded.
pub fn draft(graph: &Graph, outputs: &[NodeId]) -> Program {
    let mut count = 0;
    let mut slot = |_| {
        count += 1;
        count - 1
    };
    Scheduler::new(graph, Some(&mut slot)).run(outputs)
}

/// The program for `outputs` from parameters and inputs alone, without slots.
pub fn schedule_whole(graph: &Graph, outputs: &[NodeId]) -> Program {
    Scheduler::new(graph, None).run(outputs)
}

struct Scheduler<'a> {
    graph: &'a Graph,
    /// Numbers the values of `assemble()`.
    slots: Option<&'a mut dyn FnMut(NodeId) -> usize>,
    program: Program,
    values: NodeNumbers,
}

impl<'a> Scheduler<'a> {
    fn new(graph: &'a Graph, slots: Option<&'a mut dyn FnMut(NodeId) -> usize>) -> Self {
        Self {
            graph,
            slots,
            program: Program::default(),
            values: NodeNumbers::new(graph.len()),
        }
    }

    fn run(mut self, outputs: &[NodeId]) -> Program {
        for &output in outputs {
            self.visit(output);
        }
        self.program.outputs = outputs.iter().map(|output| self.value(*output)).collect();
        self.program
    }

    /// Appends all that `root` needs and is not there yet, operands first.
    fn visit(&mut self, root: NodeId) {
        let mut stack = vec![root];
        while let Some(&id) = stack.last() {
            if self.values.has(id) {
                stack.pop();
                continue;
            }
            let waiting = stack.len();
            if !self.is_slot(id) {
                for operand in self.operation(id).operands() {
                    if !self.values.has(operand) {
                        stack.push(operand);
                    }
                }
                // Of at most three operands the first comes first.
                if stack.len() > waiting + 1 {
                    let last = stack.len() - 1;
                    stack.swap(waiting, last);
                }
            }
            if stack.len() > waiting {
                continue;
            }
            let value = self.append(id);
            self.values.set(id, value.0);
            stack.pop();
        }
    }

    /// Returns the value of a node that is there.
    fn value(&self, id: NodeId) -> Value {
        Value(self.values.get(id).expect("operands come first"))
    }

    /// Returns the operation that is done for a node: a difference with a minus sign is the
    /// opposite difference.
    fn operation(&self, id: NodeId) -> Node {
        let node = self.graph.node(id);
        if let Node::Unary(Unary::Neg, inner) = node
            && let Node::Binary(Binary::Sub, a, b) = self.graph.node(inner)
        {
            return Node::Binary(Binary::Sub, b, a);
        }
        node
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
            && let Some(slot_of) = self.slots.as_mut()
        {
            let slot = slot_of(id);
            return self.program.push(Instruction::Load(Source::Prepared(slot)));
        }
        let instruction = match self.operation(id) {
            Node::Constant(bits) => Instruction::Constant(f64::from_bits(bits)),
            Node::Symbol(symbol) => match self.graph.symbol(symbol).source {
                Some(source) => Instruction::Load(source),
                None => unreachable!("symbols of a plain graph have sources"),
            },
            Node::Unary(op, a) => Instruction::Unary(op, self.value(a)),
            Node::Binary(op, a, b) => Instruction::Binary(op, self.value(a), self.value(b)),
            Node::Ternary(op, a, b, c) => {
                Instruction::Ternary(op, self.value(a), self.value(b), self.value(c))
            }
        };
        self.program.push(instruction)
    }
}
