//! How the unknowns are found: the equations of each group, and the rules by which symbols are differentiated.

use std::collections::BTreeSet;

use linkage_symbolic::lookup::Map;

use linkage_symbolic::{Ex, NodeId, SymbolId, V2};

use super::body_vectors::Aboard;
use super::partial::Solved;
use super::{Carrier, Elimination, Link, Rod, ViaSlider, Written};

/// How a symbol that lives by its definition is differentiated.
#[derive(Clone, Debug)]
pub(crate) enum Rule<'m> {
    /// Like this expression, which is equal to the definition.
    Follow(Ex<'m>),
    /// A component of the turn of a body.
    Turn(Box<TurnRule<'m>>),
    /// The cosine, sine or value of an angle that a group solves for.
    Cosine(AngleRule<'m>),
    Sine(AngleRule<'m>),
    Value(AngleRule<'m>),
    /// A component of `z u`, a vector that turns with unknown `position` of a group.
    Turning(Box<Turning<'m>>),
    /// A component of a vector as seen from a link that turns.
    Seen(Box<Seen<'m>>),
    /// The other way round.
    Shown(Box<Shown<'m>>),
    /// A component of the axis of such a link.
    Axis(Box<(Carrier<'m>, usize)>),
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

/// See [`Rule::Turn`].
#[derive(Clone, Debug)]
pub(crate) struct TurnRule<'m> {
    pub(super) group: usize,
    pub(super) body: usize,
    pub(super) component: usize,
    /// It is the turn by the first one, differentiated by the others.
    pub(super) by: Vec<SymbolId>,
    /// The same, of the body's directions and their derivatives: it is a quotient of large sums itself.
    pub(super) equal: Ex<'m>,
}

/// An angle that is an unknown of a group.
#[derive(Clone, Copy, Debug)]
pub(crate) struct AngleRule<'m> {
    pub(crate) group: usize,
    pub(crate) position: usize,
    /// -1 if the group works with its negative.
    pub(crate) sense: f64,
    /// Cosine and sine.
    pub(crate) unit: V2<'m>,
    /// The link that the group's unknown is measured from.
    pub(crate) carrier: Option<Carrier<'m>>,
}

impl AngleRule<'_> {
    /// Something about the group's own angle as of this one, or the other way round.
    pub(super) fn sensed<'g>(&self, x: Ex<'g>) -> Ex<'g> {
        if self.sense < 0.0 { -x } else { x }
    }
}

/// See [`Rule::Turning`].
#[derive(Clone, Debug)]
pub(crate) struct Turning<'m> {
    pub(crate) group: usize,
    pub(crate) position: usize,
    pub(crate) component: usize,
    /// The vector itself.
    pub(crate) vector: V2<'m>,
    pub(crate) z: V2<'m>,
    pub(crate) unit: V2<'m>,
}

/// See [`Rule::Seen`].
#[derive(Clone, Debug)]
pub(crate) struct Seen<'m> {
    pub(crate) carrier: Carrier<'m>,
    /// In fixed coordinates.
    pub(crate) vector: V2<'m>,
    /// Along the axis and across.
    pub(crate) own: V2<'m>,
    pub(crate) component: usize,
}

/// See [`Rule::Shown`].
#[derive(Clone, Debug)]
pub(crate) struct Shown<'m> {
    pub(crate) carrier: Carrier<'m>,
    /// Along the axis and across.
    pub(crate) vector: V2<'m>,
    /// What is added in fixed coordinates.
    pub(crate) base: V2<'m>,
    pub(crate) component: usize,
}

/// One term of a group's equations.
#[derive(Clone, Debug)]
pub(crate) struct Term<'m> {
    /// One for each equation.
    pub(crate) coefficient: Vec<Ex<'m>>,
    pub(crate) factor: Ex<'m>,
}

/// What differentiation needs to know of a solved group.
#[derive(Clone, Debug)]
pub(crate) struct Solution<'m> {
    pub(crate) terms: Vec<Term<'m>>,
    /// The equations as they were written, for groups whose derivatives are found from these; no rows for others.
    pub(crate) rows: Vec<Written<'m>>,
    /// Columns: the derivatives of the equations by each unknown.
    pub(crate) jacobian: Vec<Vec<Ex<'m>>>,
    pub(crate) determinant: Ex<'m>,
    /// For a coupled group; closed forms have one or two equations.
    pub(crate) elimination: Option<Elimination<'m>>,
    /// The links that turn with the first and the second of two unknowns. Their terms stand first.
    pub(crate) links: [Option<Link<'m>>; 2],
    /// For an equation that says how long a rod is.
    pub(crate) rod: Option<Rod<'m>>,
}

/// What derivatives may make use of: it changes what they cost and not what they are.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Shortcuts {
    /// Products that are known of links.
    pub(crate) products: bool,
    /// How bodies turn: what they carry turns with them.
    pub(crate) turns: bool,
}

/// The groups that are solved, and what follows for symbols.
#[derive(Clone, Debug, Default)]
pub(crate) struct Solutions<'m> {
    rules: Map<SymbolId, Rule<'m>>,
    /// By group.
    pub(crate) groups: Vec<Solution<'m>>,
    /// Loops with a guide on a link that turns, in order.
    pub(crate) other_sides: Vec<ViaSlider<'m>>,
    /// What derivatives make use of.
    pub(super) shortcuts: Shortcuts,
    /// What bodies carry, by component.
    pub(super) aboard: Map<NodeId, Aboard<'m>>,
    /// The places between parameters and the results of a function that all paths of some groups lead through.
    pub(super) narrow: BTreeSet<Solved>,
}

impl<'m> Solutions<'m> {
    /// Says how a symbol is differentiated.
    pub(crate) fn set_rule(&mut self, symbol: SymbolId, rule: Rule<'m>) {
        self.rules.insert(symbol, rule);
    }

    /// How a symbol is differentiated; `None` for what is given.
    pub(super) fn rule(&self, symbol: SymbolId) -> Option<&Rule<'m>> {
        self.rules.get(&symbol)
    }
}
