//! Rules by which symbols are differentiated that are computed from definitions.

use linkage_symbolic::{Ex, SymbolId, V2};

/// The rule by which a symbol with a definition is differentiated.
#[derive(Clone, Debug)]
pub(crate) enum DerivativeRule<'m> {
    /// Like this expression, which is equal to the definition.
    Follow(Ex<'m>),
    /// A component of the turn of a body.
    Rotation(Box<RotationRule<'m>>),
    /// The cosine, sine or value of an angle that a group solves for.
    Cosine(AngleRule<'m>),
    Sine(AngleRule<'m>),
    Value(AngleRule<'m>),
    /// A component of `z u`, a vector that turns with unknown `position` of a group.
    TurnedVector(Box<TurnedVector<'m>>),
    /// A component of a vector as seen from a link that turns.
    ToFrame(Box<ToFrame<'m>>),
    /// The other way round.
    FromFrame(Box<FromFrame<'m>>),
    /// A component of the axis of such a link.
    Axis(Box<(RotatingFrame<'m>, usize)>),
    /// Unknown `position` of a group.
    Unknown {
        group: usize,
        position: usize,
    },
    /// A derivative of unknown `position` of a group.
    Rate {
        group: usize,
        position: usize,
        by: Vec<SymbolId>,
    },
}

/// The rule of [`DerivativeRule::Rotation`].
#[derive(Clone, Debug)]
pub(crate) struct RotationRule<'m> {
    pub(crate) group: usize,
    pub(crate) body: usize,
    pub(crate) component: usize,
    /// It is the turn by the first one, differentiated by the others.
    pub(crate) by: Vec<SymbolId>,
    /// The same, of the body's directions and their derivatives: it is a quotient of large sums
    /// itself.
    pub(crate) equal: Ex<'m>,
}

/// An angle that is an unknown of a group.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AngleRule<'m> {
    pub(crate) group: usize,
    pub(crate) position: usize,
    /// The sense: -1 if the group works with its negative.
    pub(crate) sense: f64,
    /// Cosine and sine.
    pub(crate) unit: V2<'m>,
    /// The link that the group's unknown is measured from.
    pub(crate) link_frame: Option<RotatingFrame<'m>>,
}

impl AngleRule<'_> {
    /// Something about the group's own angle as of this one, or the other way round.
    pub(crate) fn sensed<'g>(&self, x: Ex<'g>) -> Ex<'g> {
        if self.sense < 0.0 { -x } else { x }
    }
}

/// The rule of [`DerivativeRule::TurnedVector`].
#[derive(Clone, Debug)]
pub(crate) struct TurnedVector<'m> {
    pub(crate) group: usize,
    pub(crate) position: usize,
    pub(crate) component: usize,
    /// The vector itself.
    pub(crate) vector: V2<'m>,
    pub(crate) z: V2<'m>,
    pub(crate) unit: V2<'m>,
}

/// The rule of [`DerivativeRule::ToFrame`].
#[derive(Clone, Debug)]
pub(crate) struct ToFrame<'m> {
    pub(crate) link_frame: RotatingFrame<'m>,
    /// In fixed coordinates.
    pub(crate) vector: V2<'m>,
    /// Along the axis and across.
    pub(crate) in_frame: V2<'m>,
    pub(crate) component: usize,
}

/// The rule of [`DerivativeRule::FromFrame`].
#[derive(Clone, Debug)]
pub(crate) struct FromFrame<'m> {
    pub(crate) link_frame: RotatingFrame<'m>,
    /// Along the axis and across.
    pub(crate) vector: V2<'m>,
    /// The vector that is added in fixed coordinates.
    pub(crate) base: V2<'m>,
    pub(crate) component: usize,
}

/// A link by a direction that is fixed to it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RotatingFrame<'m> {
    /// The angle by which it turns.
    pub(crate) angle: Ex<'m>,
    /// The axis at the angle 0, of length 1.
    pub(crate) start: V2<'m>,
    /// The axis.
    pub(crate) axis: V2<'m>,
}
