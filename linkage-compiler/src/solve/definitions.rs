//! Definitions and rules of unknowns: their expressions, and how they are differentiated.

use linkage_symbolic::program::{Source, Ternary};
use linkage_symbolic::{Ex, SymbolId, V2, Vector};

use crate::algebra::{
    Algebra, AngleReference, AngleRule, DerivativeRule, RotatingFrame, TurnedVector,
    derivatives::by_rule, derivatives::dependence,
};
use crate::solve::group_context::GroupContext;
use crate::solve::unknowns;

/// The sign that tells the two solutions apart.
pub(super) fn mode_sign<'m>(algebra: &Algebra<'m>, group: &GroupContext<'_, 'm>) -> Ex<'m> {
    algebra.source(Source::Mode(group.mode))
}

/// Sets the expression of an unknown symbol, and the rule of its derivatives.
fn define<'m>(
    algebra: &mut Algebra<'m>,
    symbol: SymbolId,
    value: Ex<'m>,
    rule: DerivativeRule<'m>,
) {
    algebra.graph.define(symbol, value.id());
    algebra.solutions.set_rule(symbol, rule);
}

/// Gives an unknown length its value.
pub(super) fn define_length<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    symbol: SymbolId,
    value: Ex<'m>,
    position: usize,
) {
    let rule = DerivativeRule::Unknown {
        group: group.index,
        position,
    };
    define(algebra, symbol, value, rule);
}

/// Gives an angle the cosine, sine and value of another expression, which it is differentiated as,
/// too.
pub(super) fn define_relation<'m>(algebra: &mut Algebra<'m>, angle: usize, values: [Ex<'m>; 3]) {
    let symbols = algebra.names.angles[angle].symbols();
    for (symbol, value) in symbols.into_iter().zip(values) {
        define(algebra, symbol, value, DerivativeRule::Follow(value));
    }
}

/// Gives an unknown angle its unit vector `(cos, sense sin)`, and its value from that.
pub(super) fn define_angle<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    angle: usize,
    sense: f64,
    unit: V2<'m>,
    position: usize,
) {
    define_angle_from(algebra, group, None, angle, sense, unit, position);
}

/// The same of an angle whose unknown is measured from a link_frame.
pub(super) fn define_angle_from<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    link_frame: Option<RotatingFrame<'m>>,
    angle: usize,
    sense: f64,
    unit: V2<'m>,
    position: usize,
) {
    declare_angle_from(algebra, group, link_frame, angle, sense, position);
    let unit = if sense < 0.0 { unit.conjugate() } else { unit };
    let graph = algebra.graph;
    let symbols = algebra.names.angles[angle].clone();
    for (symbol, component) in [symbols.cos, symbols.sin]
        .into_iter()
        .zip(unit.components())
    {
        graph.define(symbol, component.id());
    }
    let guide = guide(algebra, angle, unit);
    let [cos, sin] = symbols.unit.0;
    let value = sin.ternary(Ternary::AngleNear, cos, guide);
    graph.define(symbols.value, value.id());
}

/// Sets the direction within a quarter turn of which an angle stays.
pub(super) fn bear<'m>(algebra: &mut Algebra<'m>, angle: usize, bearing: AngleReference<'m>) {
    algebra.names.angles[angle].reference = Some(bearing);
}

/// Says how an unknown angle is differentiated.
pub(super) fn declare_angle<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    angle: usize,
    sense: f64,
    position: usize,
) {
    declare_angle_from(algebra, group, None, angle, sense, position);
}

fn declare_angle_from<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    link_frame: Option<RotatingFrame<'m>>,
    angle: usize,
    sense: f64,
    position: usize,
) {
    let symbols = algebra.names.angles[angle].clone();
    let rule = AngleRule {
        group: group.index,
        position,
        sense,
        unit: symbols.unit,
        link_frame,
    };
    let solutions = &mut algebra.solutions;
    solutions.set_rule(symbols.cos, DerivativeRule::Cosine(rule));
    solutions.set_rule(symbols.sin, DerivativeRule::Sine(rule));
    solutions.set_rule(symbols.value, DerivativeRule::Value(rule));
}

/// The direction of unknown `position` from a link_frame.
pub(super) fn direction_from_carrier<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    unit: V2<'m>,
    position: usize,
) -> V2<'m> {
    let (graph, group) = (algebra.graph, group.index);
    let made = unit.0.map(|value| {
        let (symbol, node) = graph.unknown(format!("from link_frame {group}.{position}"));
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
        link_frame: None,
    };
    algebra
        .solutions
        .set_rule(cos, DerivativeRule::Cosine(rule));
    algebra.solutions.set_rule(sin, DerivativeRule::Sine(rule));
    rule.unit
}

/// `centre + sum of winding * input`: within half a turn of the angle's value over the whole range.
fn guide<'m>(algebra: &mut Algebra<'m>, angle: usize, unit: V2<'m>) -> Ex<'m> {
    let inputs =
        dependence::inputs_below(algebra.graph, &mut algebra.derivatives.dependence, &unit.0);
    let mut guide = algebra.source(Source::Centre(angle));
    for input in inputs {
        let winding = algebra.source(Source::Winding(angle, input));
        guide += winding * algebra.input(input);
    }
    guide
}

/// A symbol computed as `definition` and differentiated as `equal`.
pub(super) fn alias<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    name: &str,
    definition: Ex<'m>,
    equal: Ex<'m>,
) -> Ex<'m> {
    let name = format!("{name} {}", group.index);
    let rule = DerivativeRule::Follow(equal);
    by_rule::symbol_for_value(
        algebra.graph,
        &mut algebra.solutions,
        name,
        definition,
        rule,
    )
}

/// The vector `z u` that turns with unknown `position`, computed as `value`.
pub(super) fn turning<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    value: V2<'m>,
    z: V2<'m>,
    unit: V2<'m>,
    position: usize,
) -> V2<'m> {
    let (graph, group) = (algebra.graph, group.index);
    let symbols = value.0.map(|value| {
        let (symbol, _) = graph.unknown(format!("link {group}.{position}"));
        graph.define(symbol, value.id());
        symbol
    });
    let vector = Vector(symbols.map(|symbol| unknowns::unknown(algebra, symbol)));
    for (component, symbol) in symbols.into_iter().enumerate() {
        let turning = TurnedVector {
            group,
            position,
            component,
            vector,
            z,
            unit,
        };
        let rule = DerivativeRule::TurnedVector(Box::new(turning));
        algebra.solutions.set_rule(symbol, rule);
    }
    vector
}
