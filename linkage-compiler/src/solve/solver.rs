//! What the closed forms of all kinds of groups share: giving unknowns their definitions and rules.

use crate::algebra::dependence;
use crate::algebra::implicit;
use crate::solve::iterated;
use crate::solve::point;
use crate::solve::prp;
use crate::solve::quadratic;
use crate::solve::rpr;
use crate::solve::rrp;
use crate::solve::rrr;
use crate::solve::rssp;
use crate::solve::rssr;
use crate::solve::scalar;
use crate::solve::three_slides;
use crate::solve::trigonometric;
use linkage_core::numeric::continuation::Terms;
use linkage_symbolic::lookup::Map;
use linkage_symbolic::program::{Source, Ternary};
use linkage_symbolic::{Ex, SymbolId, V2, Vector};

use crate::algebra::{
    Algebra, AngleReference, AngleRule, Carrier, Nominal, Rule, Solution, Turning,
};
use crate::model::Dimension;
use crate::structure::{Form, Rotor};

use super::contour::Contour;
use super::{Closed, Prepared};

/// Where the closed forms of one group are built.
pub(super) struct Solver<'a, 'm> {
    pub(super) algebra: &'a mut Algebra<'m>,
    /// The mechanism as written.
    pub(super) nominal: &'a Nominal,
    /// Index of the group's solution.
    pub(super) index: usize,
    /// Index of its mode, if it has one.
    pub(super) mode: usize,
    /// Its index among the coupled groups, if it is one.
    pub(super) number: usize,
    /// The dimension of its loop.
    pub(super) dimension: Option<Dimension>,
    /// Unknowns that are expressions of others.
    pub(super) explicit: &'a Map<SymbolId, Ex<'m>>,
    /// Of the groups before, in order.
    pub(super) contours: &'a [Contour<'m>],
    /// The unknown symbols that were given definitions.
    pub(super) defined: Vec<SymbolId>,
    /// For a coupled group.
    pub(super) prepared: Option<Prepared<'m>>,
    /// What grids over two inputs know in their cells.
    pub(super) in_cells: Terms,
}

impl<'m> Solver<'_, 'm> {
    pub(super) fn solve(&mut self, form: &Form<'m>) -> Closed<'m> {
        match form {
            Form::TwoRotors {
                first,
                second,
                known,
            } => rrr::two_rotors(self, first, second, *known),
            Form::RotorAndSlide {
                rotor,
                slide,
                guide,
                known,
            } => rrp::rotor_and_slide(self, rotor, *slide, *guide, *known),
            Form::SlideOnRotor {
                rotor,
                slide,
                guide,
                known,
            } => rpr::slide_on_rotor(self, rotor, *slide, *guide, *known),
            Form::TwoSlides {
                slides,
                guides,
                known,
            } => prp::two_slides(self, *slides, *guides, *known),
            Form::Trigonometric { angle, a, b, c } => {
                trigonometric::trigonometric(self, *angle, *a, *b, *c)
            }
            Form::Quadratic { symbol, a, b, c } => quadratic::quadratic(self, *symbol, *a, *b, *c),
            Form::Linear { symbol, a, b } => scalar::linear(self, *symbol, *a, *b),
            Form::LinkToRotor {
                angle,
                cosine,
                sine,
                known,
                length,
            } => rssr::link_to_rotor(self, *angle, [*cosine, *sine], *known, *length),
            Form::LinkToSlide {
                slide,
                guide,
                known,
                length,
            } => rssp::link_to_slide(self, *slide, *guide, *known, *length),
            Form::Point {
                coordinates,
                spheres,
                planes,
            } => point::point(self, coordinates, spheres, planes),
            Form::ThreeSlides {
                slides,
                guides,
                known,
            } => three_slides::three_slides(self, *slides, *guides, *known),
            Form::Relation { angle, value } => scalar::relation(self, *angle, value),
            Form::Coupled(coupled) => iterated::coupled(self, coupled),
        }
    }

    /// The sign that tells the two solutions apart.
    pub(super) fn mode_sign(&self) -> Ex<'m> {
        self.algebra.source(Source::Mode(self.mode))
    }

    /// The symbol of an unknown, as it enters the group's equations.
    pub(super) fn unknown(&self, symbol: SymbolId) -> Ex<'m> {
        let graph = self.algebra.graph;
        graph.ex(graph.symbol_node(symbol))
    }

    /// Records what differentiation needs.
    pub(super) fn push_solution(&mut self, solution: Solution<'m>) {
        self.algebra.solutions.groups.push(solution);
    }

    /// Says what an unknown symbol is computed as and how it is differentiated.
    fn define(&mut self, symbol: SymbolId, value: Ex<'m>, rule: Rule<'m>) {
        self.algebra.graph.define(symbol, value.id());
        self.algebra.solutions.set_rule(symbol, rule);
        self.defined.push(symbol);
    }

    /// Gives an unknown length its value.
    pub(super) fn define_length(&mut self, symbol: SymbolId, value: Ex<'m>, position: usize) {
        let rule = Rule::Unknown {
            group: self.index,
            position,
        };
        self.define(symbol, value, rule);
    }

    /// Gives an angle the cosine, sine and value of another expression, which it is differentiated as, too.
    pub(super) fn define_relation(&mut self, angle: usize, values: [Ex<'m>; 3]) {
        let symbols = self.algebra.names.angles[angle].symbols();
        for (symbol, value) in symbols.into_iter().zip(values) {
            self.define(symbol, value, Rule::Follow(value));
        }
    }

    /// Gives an unknown angle its unit vector `(cos, sense sin)`, and its value from that.
    pub(super) fn define_angle(&mut self, angle: usize, sense: f64, unit: V2<'m>, position: usize) {
        self.define_angle_from(None, angle, sense, unit, position);
    }

    /// The same of an angle whose unknown is measured from a carrier.
    pub(super) fn define_angle_from(
        &mut self,
        carrier: Option<Carrier<'m>>,
        angle: usize,
        sense: f64,
        unit: V2<'m>,
        position: usize,
    ) {
        self.declare_angle_from(carrier, angle, sense, position);
        let unit = if sense < 0.0 { unit.conjugate() } else { unit };
        let graph = self.algebra.graph;
        let symbols = self.algebra.names.angles[angle].clone();
        for (symbol, component) in [symbols.cos, symbols.sin]
            .into_iter()
            .zip(unit.components())
        {
            graph.define(symbol, component.id());
        }
        let guide = self.guide(angle, unit);
        let [cos, sin] = symbols.unit.0;
        let value = sin.ternary(Ternary::AngleNear, cos, guide);
        graph.define(symbols.value, value.id());
        self.defined.extend(symbols.symbols());
    }

    /// Says what an angle keeps within a quarter turn of.
    pub(super) fn bear(&mut self, angle: usize, bearing: AngleReference<'m>) {
        self.algebra.names.angles[angle].bearing = Some(bearing);
    }

    /// Says how an unknown angle is differentiated.
    pub(super) fn declare_angle(&mut self, angle: usize, sense: f64, position: usize) {
        self.declare_angle_from(None, angle, sense, position);
    }

    fn declare_angle_from(
        &mut self,
        carrier: Option<Carrier<'m>>,
        angle: usize,
        sense: f64,
        position: usize,
    ) {
        let symbols = self.algebra.names.angles[angle].clone();
        let rule = AngleRule {
            group: self.index,
            position,
            sense,
            unit: symbols.unit,
            carrier,
        };
        let solutions = &mut self.algebra.solutions;
        solutions.set_rule(symbols.cos, Rule::Cosine(rule));
        solutions.set_rule(symbols.sin, Rule::Sine(rule));
        solutions.set_rule(symbols.value, Rule::Value(rule));
    }

    /// The direction of unknown `position` from a carrier.
    pub(super) fn direction_from_carrier(&mut self, unit: V2<'m>, position: usize) -> V2<'m> {
        let (graph, group) = (self.algebra.graph, self.index);
        let made = unit.0.map(|value| {
            let (symbol, node) = graph.unknown(format!("from carrier {group}.{position}"));
            graph.define(symbol, value.id());
            (symbol, graph.ex(node))
        });
        let [(cos, x), (sin, y)] = made;
        graph.pair(cos, sin);
        let rule = AngleRule {
            group,
            position,
            sense: 1.0,
            unit: Vector([x, y]),
            carrier: None,
        };
        self.algebra.solutions.set_rule(cos, Rule::Cosine(rule));
        self.algebra.solutions.set_rule(sin, Rule::Sine(rule));
        rule.unit
    }

    /// `centre + sum of winding * input`: within half a turn of the angle's value over the whole range.
    fn guide(&mut self, angle: usize, unit: V2<'m>) -> Ex<'m> {
        let inputs = dependence::inputs_below(self.algebra, &unit.0);
        let mut guide = self.algebra.source(Source::Centre(angle));
        for input in inputs {
            let winding = self.algebra.source(Source::Winding(angle, input));
            guide += winding * self.algebra.input(input);
        }
        guide
    }

    /// A symbol computed as `definition` and differentiated as `equal`.
    pub(super) fn alias(&mut self, name: &str, definition: Ex<'m>, equal: Ex<'m>) -> Ex<'m> {
        let name = format!("{name} {}", self.index);
        let rule = Rule::Follow(equal);
        implicit::symbol_for_value(self.algebra, name, definition, rule)
    }

    /// The vector `z u` that turns with unknown `position`, computed as `value`.
    pub(super) fn turning(
        &mut self,
        value: V2<'m>,
        z: V2<'m>,
        unit: V2<'m>,
        position: usize,
    ) -> V2<'m> {
        let (graph, group) = (self.algebra.graph, self.index);
        let symbols = value.0.map(|value| {
            let (symbol, _) = graph.unknown(format!("link {group}.{position}"));
            graph.define(symbol, value.id());
            symbol
        });
        let vector = Vector(symbols.map(|symbol| self.unknown(symbol)));
        for (component, symbol) in symbols.into_iter().enumerate() {
            let turning = Turning {
                group,
                position,
                component,
                vector,
                z,
                unit,
            };
            let rule = Rule::Turning(Box::new(turning));
            self.algebra.solutions.set_rule(symbol, rule);
        }
        vector
    }

    /// The unit vector `(cos, sense sin)` of a rotor's angle.
    pub(super) fn unit_of(&self, rotor: &Rotor<'m>) -> V2<'m> {
        let unit = self.algebra.names.angles[rotor.angle].unit;
        if rotor.sense < 0.0 {
            unit.conjugate()
        } else {
            unit
        }
    }
}
