//! Vectors as seen from a link that turns: what the link carries along stands still there.

use crate::algebra::parts;
use linkage_symbolic::program::Unary;
use linkage_symbolic::{Ex, Node, V2, Vector};

use super::parts::{Part, Turning, spread};
use super::solutions::{Seen, Shown};
use super::{Algebra, Rule};

/// A link by a direction that is fixed to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Carrier<'m> {
    /// By which it turns.
    pub(crate) angle: Ex<'m>,
    /// Where it points when that is 0; of length 1.
    pub(crate) start: V2<'m>,
    /// Where it points.
    pub(crate) axis: V2<'m>,
}

/// A vector from its carrier.
#[derive(Clone, Debug)]
pub(crate) struct Carried<'m> {
    pub(crate) carrier: Carrier<'m>,
    /// The part that the link carries, along its axis and across.
    pub(crate) arm: V2<'m>,
    /// All else, in fixed coordinates.
    pub(crate) rest: V2<'m>,
    pub(crate) turns: Turns,
}

/// What a vector turns with.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Turns {
    pub(super) angles: Vec<Turning>,
    /// A bit for each that it turns against.
    pub(super) backward: usize,
}

/// A vector from the link that carries `guide`, which points along `axis`, if that link carries a part of the vector.
pub(crate) fn carried<'m>(
    algebra: &mut Algebra<'m>,
    guide: V2<'m>,
    axis: V2<'m>,
    vector: V2<'m>,
) -> Option<Carried<'m>> {
    let parts = parts::parts(algebra, guide);
    let [(angles, own)] = &parts.turning[..] else {
        return None;
    };
    if !(parts.fixed.is_zero() && own.is_fixed()) {
        return None;
    }
    let backward = own.backward()?;
    let turns = Turns {
        angles: angles.clone(),
        backward,
    };
    let (arm, rest) = split(algebra, vector, &turns)?;
    let zero = algebra.zero();
    let numbered = angles.iter().enumerate();
    let angle = numbered.fold(zero, |sum, (k, &turning)| {
        let angle = number_of(algebra, turning);
        match backward >> k & 1 {
            0 => sum + angle,
            _ => sum - angle,
        }
    });
    let start = own.arm();
    if guide.is_unit() {
        // Turning does not stretch.
        start.mark_unit();
    }
    let (_, start) = start.length_and_unit();
    let carrier = carrier(algebra, angle, start, axis);
    Some(Carried {
        carrier,
        arm: arm.turned(start.conjugate()),
        rest,
        turns,
    })
}

/// The part of a vector that turns with some angles, where these are 0, and the rest.
pub(super) fn split<'m>(
    algebra: &Algebra<'m>,
    vector: V2<'m>,
    turns: &Turns,
) -> Option<(V2<'m>, V2<'m>)> {
    let mut parts = parts::parts(algebra, vector).turning.into_iter();
    let (angles, part) = parts.find(|(angles, _)| *angles == turns.angles)?;
    if !part.is_fixed() || part.backward() != Some(turns.backward) {
        return None;
    }
    let rest = vector.map(|x| without(algebra, x, &angles));
    Some((part.arm(), rest))
}

/// The carrier whose axis is computed as `axis`.
fn carrier<'m>(
    algebra: &mut Algebra<'m>,
    angle: Ex<'m>,
    start: V2<'m>,
    axis: V2<'m>,
) -> Carrier<'m> {
    let symbols = axis.map(|value| {
        let (symbol, node) = algebra.graph.unknown("axis".to_owned());
        algebra.graph.define(symbol, value.id());
        algebra.graph.ex(node)
    });
    let carrier = Carrier {
        angle,
        start,
        axis: symbols,
    };
    for (component, x) in symbols.components().enumerate() {
        let Node::Symbol(symbol) = x.node() else {
            unreachable!("just made");
        };
        let rule = Rule::Axis(Box::new((carrier, component)));
        algebra.solutions.set_rule(symbol, rule);
    }
    carrier
}

/// The terms of a sum that turn otherwise than with these angles alone.
pub(super) fn without<'m>(algebra: &Algebra<'m>, x: Ex<'m>, angles: &[Turning]) -> Ex<'m> {
    let terms = spread(x).into_iter();
    let terms = terms.filter(|(_, term)| parts::factors(algebra, *term).0 != angles);
    let (early, late): (Vec<Ex>, Vec<Ex>) = terms
        .map(|(known, term)| known * term)
        .partition(|term| term.is_fixed());
    let all = early.into_iter().chain(late);
    all.fold(algebra.zero(), |sum, term| sum + term)
}

/// The angle of a cosine and a sine.
fn number_of<'m>(algebra: &Algebra<'m>, (cosine, _): Turning) -> Ex<'m> {
    let cosine = algebra.graph.ex(cosine);
    match cosine.node() {
        Node::Unary(Unary::Cos, argument) => algebra.graph.ex(argument),
        _ => {
            let mut angles = algebra.names.angles.iter();
            let angle = angles.find(|own| own.unit[0] == cosine);
            angle.expect("the cosine of an angle").number
        }
    }
}

/// A vector of fixed coordinates along the axis of a carrier and across.
pub(crate) fn seen<'m>(algebra: &mut Algebra<'m>, carrier: Carrier<'m>, vector: V2<'m>) -> V2<'m> {
    if vector.is_zero() {
        return vector;
    }
    let axis = carrier.axis;
    let symbols = [axis.dot(vector), axis.cross(vector)].map(|value| {
        let (symbol, node) = algebra.graph.unknown("seen".to_owned());
        algebra.graph.define(symbol, value.id());
        (symbol, algebra.graph.ex(node))
    });
    let own = Vector(symbols.map(|(_, x)| x));
    for (component, (symbol, _)) in symbols.into_iter().enumerate() {
        let seen = Seen {
            carrier,
            vector,
            own,
            component,
        };
        algebra
            .solutions
            .set_rule(symbol, Rule::Seen(Box::new(seen)));
    }
    own
}

/// `base` and a vector along the axis of a carrier and across, in fixed coordinates.
pub(crate) fn shown<'m>(
    algebra: &mut Algebra<'m>,
    carrier: Carrier<'m>,
    vector: V2<'m>,
    base: V2<'m>,
) -> V2<'m> {
    let [axis, across] = [carrier.axis, carrier.axis.perp()];
    let value = base + vector[0] * axis + vector[1] * across;
    let made = value.0.map(|value| {
        let (symbol, node) = algebra.graph.unknown("shown".to_owned());
        algebra.graph.define(symbol, value.id());
        (symbol, algebra.graph.ex(node))
    });
    for (component, (symbol, _)) in made.into_iter().enumerate() {
        let shown = Shown {
            carrier,
            vector,
            base,
            component,
        };
        algebra
            .solutions
            .set_rule(symbol, Rule::Shown(Box::new(shown)));
    }
    Vector(made.map(|(_, x)| x))
}

impl<'m> Part<'m> {
    fn is_fixed(&self) -> bool {
        self.rows.iter().flatten().all(|x| x.is_fixed())
    }
}
