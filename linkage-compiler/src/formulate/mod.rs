//! Every unknown expressed: the closed form of each group, the assembly modes, the range check.
//!
//! One file for each form of group. A group's unknowns get definitions that are computed by the closed form; their
//! derivatives follow from the group's equations (see [`Solution`](crate::algebra::Solution)).

mod check;
mod machine;
mod quadratic;
mod reference;
mod rotor_and_slide;
mod scalar;
mod slide_on_rotor;
mod trigonometric;
mod two_rotors;
mod two_slides;
mod vector;
mod words;

use std::collections::HashMap;

use linkage_symbolic::program::{Source, Ternary};
use linkage_symbolic::{NodeId, SymbolId};

use crate::algebra::{Algebra, AngleRule, Rule, Solution, Turning};
use crate::model::{Dimension, Mechanism, Type};
use crate::structure::{Form, Group, Rotor, Structure};

pub(crate) use check::{candidate_rates, check_ranges};
pub(crate) use machine::valued_angles;
pub(crate) use reference::{Reference, assemble_reference};

/// What a kind of group tells about its solution.
#[derive(Clone, Debug)]
pub(crate) struct Closed {
    pub(crate) kind: &'static str,
    pub(crate) class: u8,
    pub(crate) order: u8,
    pub(crate) method: &'static str,
    /// Two solutions, told apart by a mode.
    pub(crate) two_modes: bool,
    /// `|det J|` over its largest value for these lengths.
    pub(crate) margin: NodeId,
    /// Positive where the group can be assembled, zero at the dead point, negative beyond; its scale is 1. For a group with
    /// one solution only its sign at the reference counts.
    pub(crate) slack: NodeId,
    /// By how much the group misses closing: positive if it cannot be assembled.
    pub(crate) gap: NodeId,
    /// What the gap is measured in.
    pub(crate) gap_in: GapIn,
}

/// What a gap is measured in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum GapIn {
    /// Like the two sides of the loop.
    Loop,
    /// Like the unknown.
    Unknown,
}

/// A group with its solution.
#[derive(Clone, Debug)]
pub(crate) struct Solved {
    pub(crate) group: Group,
    pub(crate) closed: Closed,
    /// Index among the assembly modes.
    pub(crate) mode: Option<usize>,
}

impl Solved {
    /// The dimension of the group's gap.
    pub(crate) fn gap_dimension(&self, mechanism: &Mechanism) -> Dimension {
        let equation = &mechanism.loops[self.group.loops[0]];
        let sides = [&equation.left.ty, &equation.right.ty];
        let of_loop = sides.into_iter().find_map(Type::dimension);
        let unknown = self
            .group
            .unknowns
            .first()
            .map(|&k| &mechanism.unknowns[k].ty);
        let dimension = match self.closed.gap_in {
            GapIn::Loop => of_loop,
            GapIn::Unknown => unknown.and_then(Type::dimension),
        };
        dimension.unwrap_or(Dimension::LENGTH)
    }
}

/// The mechanism with every unknown expressed.
#[derive(Debug, Default)]
pub(crate) struct Formulation {
    pub(crate) groups: Vec<Solved>,
    /// The group that a symbol belongs to.
    pub(crate) group_of: HashMap<SymbolId, usize>,
    pub(crate) mobility: usize,
}

impl Formulation {
    pub(crate) fn modes(&self) -> usize {
        self.groups
            .iter()
            .filter(|group| group.mode.is_some())
            .count()
    }

    /// The last group that finds an unknown.
    pub(crate) fn last_group_with(&self, unknown: usize) -> Option<usize> {
        self.groups
            .iter()
            .rposition(|solved| solved.group.unknowns.contains(&unknown))
    }

    /// Angles in the order in which their groups are solved.
    pub(crate) fn in_order(&self, algebra: &Algebra, mut angles: Vec<usize>) -> Vec<usize> {
        angles.sort_by_key(|&angle| self.group_of.get(&algebra.angles[angle].cos));
        angles
    }

    /// The groups that nodes are computed from, in order.
    pub(crate) fn groups_of(&self, algebra: &Algebra, nodes: &[NodeId]) -> Vec<usize> {
        let symbols = algebra.symbols_below(nodes);
        let mut groups: Vec<usize> = symbols
            .iter()
            .filter_map(|symbol| self.group_of.get(symbol).copied())
            .collect();
        groups.sort_unstable();
        groups.dedup();
        groups
    }
}

/// Gives every unknown its definition.
pub(crate) fn formulate(algebra: &mut Algebra, structure: Structure) -> Formulation {
    let mut formulation = Formulation {
        mobility: structure.mobility,
        ..Default::default()
    };
    for explicit in &structure.explicit {
        algebra.graph.define(explicit.symbol, explicit.value);
        algebra
            .rules
            .insert(explicit.symbol, Rule::Follow(explicit.value));
    }
    let mut modes = 0;
    for group in structure.groups {
        let first_symbol = algebra.graph.symbol_count();
        let index = algebra.solutions.len();
        let mut solver = Solver {
            algebra,
            index,
            mode: modes,
            defined: Vec::new(),
        };
        let mut closed = solver.solve(&group.form);
        let defined = std::mem::take(&mut solver.defined);
        if closed.class == 0 && group.finds_point(algebra.mechanism) {
            // A point on a line at a distance from another: the slide has no name, but the group is a dyad.
            closed = Closed {
                kind: "RRP",
                class: 2,
                order: 2,
                ..closed
            };
        }
        let made = algebra.graph.symbols_since(first_symbol);
        let number = formulation.groups.len();
        formulation
            .group_of
            .extend(defined.into_iter().chain(made).map(|s| (s, number)));
        let mode = closed.two_modes.then_some(modes);
        modes += usize::from(closed.two_modes);
        formulation.groups.push(Solved {
            group,
            closed,
            mode,
        });
    }
    formulation
}

/// Where the closed forms of one group are built.
struct Solver<'a, 'm> {
    algebra: &'a mut Algebra<'m>,
    /// Index of the group's solution.
    index: usize,
    /// Index of its mode, if it has one.
    mode: usize,
    /// The unknown symbols that were given definitions.
    defined: Vec<SymbolId>,
}

impl Solver<'_, '_> {
    fn solve(&mut self, form: &Form) -> Closed {
        match form {
            Form::TwoRotors {
                first,
                second,
                known,
            } => self.two_rotors(first, second, *known),
            Form::RotorAndSlide {
                rotor,
                slide,
                guide,
                known,
            } => self.rotor_and_slide(rotor, *slide, *guide, *known),
            Form::SlideOnRotor {
                rotor,
                slide,
                guide,
                known,
            } => self.slide_on_rotor(rotor, *slide, *guide, *known),
            Form::TwoSlides {
                slides,
                guides,
                known,
            } => self.two_slides(*slides, *guides, *known),
            Form::Trigonometric { angle, a, b, c } => self.trigonometric(*angle, *a, *b, *c),
            Form::Quadratic { symbol, a, b, c } => self.quadratic(*symbol, *a, *b, *c),
            Form::Linear { symbol, a, b } => self.linear(*symbol, *a, *b),
            Form::Relation { angle, value } => self.relation(*angle, value),
        }
    }

    /// The sign that tells the two solutions apart.
    fn mode_sign(&mut self) -> NodeId {
        self.algebra.graph.source(Source::Mode(self.mode))
    }

    /// Records what differentiation needs.
    fn push_solution(&mut self, solution: Solution) {
        self.algebra.solutions.push(solution);
    }

    /// Gives an unknown length its value.
    fn define_length(&mut self, symbol: SymbolId, value: NodeId, position: usize) {
        self.algebra.graph.define(symbol, value);
        let rule = Rule::Unknown {
            group: self.index,
            position,
        };
        self.algebra.rules.insert(symbol, rule);
        self.defined.push(symbol);
    }

    /// Gives an unknown angle its unit vector `(cos, sense sin)`, and its value from that.
    fn define_angle(&mut self, angle: usize, sense: f64, unit: [NodeId; 2], position: usize) {
        let symbols = self.algebra.angles[angle].clone();
        let [cos, turned] = unit;
        let sin = if sense < 0.0 {
            self.algebra.graph.neg(turned)
        } else {
            turned
        };
        let rule = AngleRule {
            group: self.index,
            position,
            sense,
            cos: symbols.cos_node,
            sin: symbols.sin_node,
        };
        self.algebra.graph.define(symbols.cos, cos);
        self.algebra.graph.define(symbols.sin, sin);
        self.algebra.rules.insert(symbols.cos, Rule::Cosine(rule));
        self.algebra.rules.insert(symbols.sin, Rule::Sine(rule));
        let guide = self.guide(angle, &[cos, sin]);
        let (y, x) = (symbols.sin_node, symbols.cos_node);
        let value = self.algebra.graph.ternary(Ternary::AngleNear, y, x, guide);
        self.algebra.graph.define(symbols.value, value);
        self.algebra.rules.insert(symbols.value, Rule::Value(rule));
        self.defined
            .extend([symbols.cos, symbols.sin, symbols.value]);
    }

    /// `centre + sum of winding * input`: within half a turn of the angle's value over the whole range.
    fn guide(&mut self, angle: usize, unit: &[NodeId]) -> NodeId {
        let inputs = self.algebra.inputs_below(unit);
        let graph = &mut self.algebra.graph;
        let mut guide = graph.source(Source::Centre(angle));
        for input in inputs {
            let winding = graph.source(Source::Winding(angle, input));
            let coordinate = graph.source(Source::Input(input));
            let turned = graph.mul(winding, coordinate);
            guide = graph.add(guide, turned);
        }
        guide
    }

    /// A symbol computed as `definition` and differentiated as `equal`.
    fn alias(&mut self, name: &str, definition: NodeId, equal: NodeId) -> NodeId {
        let (symbol, node) = self.algebra.graph.unknown(format!("{name} {}", self.index));
        self.algebra.graph.define(symbol, definition);
        self.algebra.rules.insert(symbol, Rule::Follow(equal));
        node
    }

    /// The vector `z u` that turns with unknown `position`, computed as `value`.
    fn turning(
        &mut self,
        value: [NodeId; 2],
        z: [NodeId; 2],
        unit: [NodeId; 2],
        position: usize,
    ) -> [NodeId; 2] {
        let group = self.index;
        let symbols = value.map(|value| {
            let (symbol, node) = self
                .algebra
                .graph
                .unknown(format!("link {group}.{position}"));
            self.algebra.graph.define(symbol, value);
            (symbol, node)
        });
        let vector = symbols.map(|(_, node)| node);
        for (component, (symbol, _)) in symbols.into_iter().enumerate() {
            let turning = Turning {
                group,
                position,
                component,
                vector,
                z,
                unit,
            };
            self.algebra
                .rules
                .insert(symbol, Rule::Turning(Box::new(turning)));
        }
        vector
    }

    /// The unit vector `(cos, sense sin)` of a rotor's angle.
    fn unit_of(&mut self, rotor: &Rotor) -> [NodeId; 2] {
        let angle = &self.algebra.angles[rotor.angle];
        let (cos, sin) = (angle.cos_node, angle.sin_node);
        let turned = if rotor.sense < 0.0 {
            self.algebra.graph.neg(sin)
        } else {
            sin
        };
        [cos, turned]
    }
}
