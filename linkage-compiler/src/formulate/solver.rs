//! What the closed forms of all kinds of groups share: giving unknowns their definitions and rules.

use linkage_symbolic::program::{Source, Ternary};
use linkage_symbolic::{NodeId, SymbolId};

use crate::algebra::{Algebra, AngleRule, Rule, Solution, Turning};
use crate::model::Dimension;
use crate::structure::{Form, Rotor};

use super::{Closed, Prepared};

/// Where the closed forms of one group are built.
pub(super) struct Solver<'a, 'm> {
    pub(super) algebra: &'a mut Algebra<'m>,
    /// Index of the group's solution.
    pub(super) index: usize,
    /// Index of its mode, if it has one.
    pub(super) mode: usize,
    /// Its index among the coupled groups, if it is one.
    pub(super) number: usize,
    /// The dimension of its loop.
    pub(super) dimension: Option<Dimension>,
    /// The unknown symbols that were given definitions.
    pub(super) defined: Vec<SymbolId>,
    /// For a coupled group.
    pub(super) prepared: Option<Prepared>,
}

impl Solver<'_, '_> {
    pub(super) fn solve(&mut self, form: &Form) -> Closed {
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
            Form::LinkToRotor {
                angle,
                cosine,
                sine,
                known,
                length,
            } => self.link_to_rotor(*angle, [*cosine, *sine], *known, *length),
            Form::LinkToSlide {
                slide,
                guide,
                known,
                length,
            } => self.link_to_slide(*slide, *guide, *known, *length),
            Form::Point {
                coordinates,
                spheres,
                planes,
            } => self.point(coordinates, spheres, planes),
            Form::ThreeSlides {
                slides,
                guides,
                known,
            } => self.three_slides(*slides, *guides, *known),
            Form::Relation { angle, value } => self.relation(*angle, value),
            Form::Coupled(coupled) => self.coupled(coupled),
        }
    }

    /// The sign that tells the two solutions apart.
    pub(super) fn mode_sign(&mut self) -> NodeId {
        self.algebra.graph.source(Source::Mode(self.mode))
    }

    /// Records what differentiation needs.
    pub(super) fn push_solution(&mut self, solution: Solution) {
        self.algebra.solutions.push(solution);
    }

    /// Gives an unknown length its value.
    pub(super) fn define_length(&mut self, symbol: SymbolId, value: NodeId, position: usize) {
        self.algebra.graph.define(symbol, value);
        let rule = Rule::Unknown {
            group: self.index,
            position,
        };
        self.algebra.rules.insert(symbol, rule);
        self.defined.push(symbol);
    }

    /// Gives an unknown angle its unit vector `(cos, sense sin)`, and its value from that.
    pub(super) fn define_angle(
        &mut self,
        angle: usize,
        sense: f64,
        unit: [NodeId; 2],
        position: usize,
    ) {
        self.declare_angle(angle, sense, position);
        let symbols = self.algebra.angles[angle].clone();
        let [cos, turned] = unit;
        let sin = if sense < 0.0 {
            self.algebra.graph.neg(turned)
        } else {
            turned
        };
        self.algebra.graph.define(symbols.cos, cos);
        self.algebra.graph.define(symbols.sin, sin);
        let guide = self.guide(angle, &[cos, sin]);
        let (y, x) = (symbols.sin_node, symbols.cos_node);
        let value = self.algebra.graph.ternary(Ternary::AngleNear, y, x, guide);
        self.algebra.graph.define(symbols.value, value);
        self.defined
            .extend([symbols.cos, symbols.sin, symbols.value]);
    }

    /// Says how an unknown angle is differentiated.
    pub(super) fn declare_angle(&mut self, angle: usize, sense: f64, position: usize) {
        let symbols = self.algebra.angles[angle].clone();
        let rule = AngleRule {
            group: self.index,
            position,
            sense,
            cos: symbols.cos_node,
            sin: symbols.sin_node,
        };
        let rules = &mut self.algebra.rules;
        rules.insert(symbols.cos, Rule::Cosine(rule));
        rules.insert(symbols.sin, Rule::Sine(rule));
        rules.insert(symbols.value, Rule::Value(rule));
    }

    /// `centre + sum of winding * input`: within half a turn of the angle's value over the whole range.
    pub(super) fn guide(&mut self, angle: usize, unit: &[NodeId]) -> NodeId {
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
    pub(super) fn alias(&mut self, name: &str, definition: NodeId, equal: NodeId) -> NodeId {
        let (symbol, node) = self.algebra.graph.unknown(format!("{name} {}", self.index));
        self.algebra.graph.define(symbol, definition);
        self.algebra.rules.insert(symbol, Rule::Follow(equal));
        node
    }

    /// The vector `z u` that turns with unknown `position`, computed as `value`.
    pub(super) fn turning(
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
    pub(super) fn unit_of(&mut self, rotor: &Rotor) -> [NodeId; 2] {
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
