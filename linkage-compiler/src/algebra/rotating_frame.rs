//! Vectors as seen from a link that turns: vectors that the link carries stand still there.

use linkage_symbolic::program::Unary;
use linkage_symbolic::{Ex, Graph, Node, V2, Vector};

use crate::algebra::equations::{AnglePair, AngleSum};
use crate::algebra::names::Names;
use crate::algebra::rules::{DerivativeRule, FromFrame, RotatingFrame, ToFrame};
use crate::algebra::solutions::Solutions;
use crate::algebra::turning_parts;
use crate::algebra::turning_parts::{TurningPart, terms_of_sum};

/// A vector from its rotating frame.
#[derive(Clone, Debug)]
pub(crate) struct InRotatingFrame<'m> {
    pub(crate) link_frame: RotatingFrame<'m>,
    /// The part that the link carries, along its axis and across.
    pub(crate) arm: V2<'m>,
    /// All else, in fixed coordinates.
    pub(crate) rest: V2<'m>,
    pub(crate) turns: AngleSum,
}

/// A vector from the link that carries `guide`, which points along `axis`, if that link carries a
/// part of the vector.
pub(crate) fn in_rotating_frame<'m>(
    names: &Names<'m>,
    solutions: &mut Solutions<'m>,
    guide: V2<'m>,
    axis: V2<'m>,
    vector: V2<'m>,
) -> Option<InRotatingFrame<'m>> {
    let parts = turning_parts::parts(names, guide);
    let [(angles, part)] = &parts.turning[..] else {
        return None;
    };
    if !(parts.fixed.is_zero() && part.is_fixed()) {
        return None;
    }
    let backward = part.backward()?;
    let turns = AngleSum {
        angles: angles.clone(),
        backward,
    };
    let (arm, rest) = split(names, vector, &turns)?;
    let zero = names.zero();
    let numbered = angles.iter().enumerate();
    let angle = numbered.fold(zero, |sum, (k, &turning)| {
        let angle = angle_of(names, turning);
        match backward >> k & 1 {
            0 => sum + angle,
            _ => sum - angle,
        }
    });
    let start = part.arm();
    if guide.is_unit() {
        // Turning does not stretch.
        start.mark_unit();
    }
    let (_, start) = start.length_and_unit();
    let link_frame = rotating_frame(names.graph, solutions, angle, start, axis);
    Some(InRotatingFrame {
        link_frame,
        arm: arm.turned(start.conjugate()),
        rest,
        turns,
    })
}

/// The part of a vector that turns with some angles, where these are 0, and the rest.
pub(crate) fn split<'m>(
    names: &Names<'m>,
    vector: V2<'m>,
    turns: &AngleSum,
) -> Option<(V2<'m>, V2<'m>)> {
    let mut parts = turning_parts::parts(names, vector).turning.into_iter();
    let (angles, part) = parts.find(|(angles, _)| *angles == turns.angles)?;
    if !part.is_fixed() || part.backward() != Some(turns.backward) {
        return None;
    }
    let rest = vector.map(|x| without(names, x, &angles));
    Some((part.arm(), rest))
}

/// The frame whose axis is computed as `axis`.
fn rotating_frame<'m>(
    graph: &'m Graph,
    solutions: &mut Solutions<'m>,
    angle: Ex<'m>,
    start: V2<'m>,
    axis: V2<'m>,
) -> RotatingFrame<'m> {
    let symbols = axis.map(|value| {
        let (symbol, node) = graph.unknown("axis".to_owned());
        graph.define(symbol, value.id());
        graph.ex(node)
    });
    let link_frame = RotatingFrame {
        angle,
        start,
        axis: symbols,
    };
    for (component, x) in symbols.components().enumerate() {
        let Node::Symbol(symbol) = x.node() else {
            unreachable!("just made");
        };
        let rule = DerivativeRule::Axis(Box::new((link_frame, component)));
        solutions.set_rule(symbol, rule);
    }
    link_frame
}

/// The terms of a sum that turn otherwise than with these angles alone.
pub(crate) fn without<'m>(names: &Names<'m>, x: Ex<'m>, angles: &[AnglePair]) -> Ex<'m> {
    let terms = terms_of_sum(x).into_iter();
    let terms = terms.filter(|(_, term)| turning_parts::factors(names, *term).0 != angles);
    let (early, late): (Vec<Ex>, Vec<Ex>) = terms
        .map(|(known, term)| known * term)
        .partition(|term| term.is_fixed());
    let all = early.into_iter().chain(late);
    all.fold(names.zero(), |sum, term| sum + term)
}

/// The angle of a cosine and a sine.
fn angle_of<'m>(names: &Names<'m>, (cosine, _): AnglePair) -> Ex<'m> {
    let cosine = names.graph.ex(cosine);
    match cosine.node() {
        Node::Unary(Unary::Cos, argument) => names.graph.ex(argument),
        _ => {
            let mut angles = names.angles.iter();
            let angle = angles.find(|angle| angle.unit[0] == cosine);
            angle.expect("the cosine of an angle").number
        }
    }
}

/// A vector of fixed coordinates along the axis of a frame and across.
pub(crate) fn to_frame<'m>(
    graph: &'m Graph,
    solutions: &mut Solutions<'m>,
    link_frame: RotatingFrame<'m>,
    vector: V2<'m>,
) -> V2<'m> {
    if vector.is_zero() {
        return vector;
    }
    let axis = link_frame.axis;
    let symbols = [axis.dot(vector), axis.cross(vector)].map(|value| {
        let (symbol, node) = graph.unknown("seen".to_owned());
        graph.define(symbol, value.id());
        (symbol, graph.ex(node))
    });
    let in_frame = Vector(symbols.map(|(_, x)| x));
    for (component, (symbol, _)) in symbols.into_iter().enumerate() {
        let seen = ToFrame {
            link_frame,
            vector,
            in_frame,
            component,
        };
        solutions.set_rule(symbol, DerivativeRule::ToFrame(Box::new(seen)));
    }
    in_frame
}

/// `base` and a vector along the axis of a frame and across, in fixed coordinates.
pub(crate) fn from_frame<'m>(
    graph: &'m Graph,
    solutions: &mut Solutions<'m>,
    link_frame: RotatingFrame<'m>,
    vector: V2<'m>,
    base: V2<'m>,
) -> V2<'m> {
    let [axis, across] = [link_frame.axis, link_frame.axis.perp()];
    let value = base + vector[0] * axis + vector[1] * across;
    let made = value.0.map(|value| {
        let (symbol, node) = graph.unknown("shown".to_owned());
        graph.define(symbol, value.id());
        (symbol, graph.ex(node))
    });
    for (component, (symbol, _)) in made.into_iter().enumerate() {
        let shown = FromFrame {
            link_frame,
            vector,
            base,
            component,
        };
        solutions.set_rule(symbol, DerivativeRule::FromFrame(Box::new(shown)));
    }
    Vector(made.map(|(_, x)| x))
}

impl<'m> TurningPart<'m> {
    fn is_fixed(&self) -> bool {
        self.rows.iter().flatten().all(|x| x.is_fixed())
    }
}
