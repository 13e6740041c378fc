//! A vector of the plane or of space, for formulas that are the same in both. A turn or a moment
//! has one component in the plane and three in space.

use std::fmt;
use std::ops::{Add, Div, Index, Mul, Neg, Sub};

use super::ex::Ex;
use super::vector::{V3, Vector};
use crate::graph::{Graph, NodeId};

/// A vector of at most three components.
#[derive(Clone, Copy)]
pub struct Vn<'g> {
    pub(super) graph: &'g Graph,
    /// Only the first `count` have a meaning.
    components: [NodeId; 3],
    count: usize,
}

/// The components of a vector of space.
const SPACE: usize = 3;

impl<'g> Vn<'g> {
    /// A vector of these nodes.
    ///
    /// # Panics
    ///
    /// Panics if there are more than three.
    pub(crate) fn new(graph: &'g Graph, ids: &[NodeId]) -> Self {
        let mut components = [NodeId(0); SPACE];
        components[..ids.len()].copy_from_slice(ids);
        Self {
            graph,
            components,
            count: ids.len(),
        }
    }

    /// The nodes alone, as they are stored.
    pub fn ids(&self) -> &[NodeId] {
        &self.components[..self.count]
    }

    /// Returns the number of components.
    pub fn len(&self) -> usize {
        self.count
    }

    /// True for a vector without components.
    pub fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// The components in order.
    pub fn iter(self) -> impl Iterator<Item = Ex<'g>> {
        (0..self.count).map(move |k| self.at(k))
    }

    /// One component.
    pub fn at(&self, component: usize) -> Ex<'g> {
        Ex::new(self.graph, self.ids()[component])
    }

    /// Another value for each component.
    #[must_use]
    pub fn map(mut self, mut other: impl FnMut(Ex<'g>) -> Ex<'g>) -> Self {
        for k in 0..self.count {
            self.components[k] = other(self.at(k)).id();
        }
        self
    }

    /// Component by component; a 0 may have fewer of them.
    fn zip(self, other: Self, join: impl Fn(Ex<'g>, Ex<'g>) -> Ex<'g>) -> Self {
        let count = self.count.max(other.count);
        let [a, b] = [self, other].map(|v| v.resized(count));
        let mut sum = a;
        for k in 0..count {
            sum.components[k] = join(a.at(k), b.at(k)).id();
        }
        sum
    }

    /// With so many components: zeros behind it, or without the last ones.
    #[must_use]
    pub fn resized(mut self, count: usize) -> Self {
        for k in self.count..count {
            self.components[k] = self.graph.zero();
        }
        self.count = count;
        self
    }

    /// The vector of space that it is, if it is one.
    pub fn in_space(self) -> Option<V3<'g>> {
        (self.count == SPACE).then(|| Vector(self.components.map(|id| Ex::new(self.graph, id))))
    }

    /// `arm x force`, this being the arm: a moment.
    #[must_use]
    pub fn moment_of(self, force: Self) -> Self {
        match (self.in_space(), force.in_space()) {
            (Some(arm), Some(force)) => arm.cross(force).into(),
            _ => {
                let [arm, force] = [self, force].map(|v| Vector([v.at(0), v.at(1)]));
                Vector([arm.cross(force)]).into()
            }
        }
    }

    /// `turn x arm`, this being the turn: how the end of an arm moves when it turns.
    #[must_use]
    pub fn sweeping(self, arm: Self) -> Self {
        match (self.in_space(), arm.in_space()) {
            (Some(turn), Some(arm)) => turn.cross(arm).into(),
            _ => self.at(0) * Self::from(Vector([arm.at(0), arm.at(1)]).perp()),
        }
    }

    /// The part along a unit vector.
    #[must_use]
    pub fn along(self, unit: Self) -> Self {
        unit.dot(self) * unit
    }

    /// The part across a unit vector.
    #[must_use]
    pub fn across(self, unit: Self) -> Self {
        self - self.along(unit)
    }

    /// True if every component is the constant 0.
    pub fn is_zero(self) -> bool {
        self.iter().all(Ex::is_zero)
    }
}

impl fmt::Debug for Vn<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.ids().fmt(f)
    }
}

impl PartialEq for Vn<'_> {
    fn eq(&self, other: &Self) -> bool {
        self.ids() == other.ids()
    }
}

impl Eq for Vn<'_> {}

impl<'g, const N: usize> From<Vector<'g, N>> for Vn<'g> {
    fn from(vector: Vector<'g, N>) -> Self {
        Self::new(vector.0[0].graph(), &vector.ids())
    }
}

impl<'g> Index<usize> for Vn<'g> {
    type Output = NodeId;

    fn index(&self, component: usize) -> &NodeId {
        &self.ids()[component]
    }
}

impl Add for Vn<'_> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        self.zip(other, |x, y| x + y)
    }
}

impl Sub for Vn<'_> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self.zip(other, |x, y| x - y)
    }
}

impl Neg for Vn<'_> {
    type Output = Self;

    fn neg(self) -> Self {
        self.map(|x| -x)
    }
}

impl<'g> Mul<Vn<'g>> for Ex<'g> {
    type Output = Vn<'g>;

    fn mul(self, vector: Vn<'g>) -> Vn<'g> {
        vector.map(|x| self * x)
    }
}

impl<'g> Div<Ex<'g>> for Vn<'g> {
    type Output = Self;

    fn div(self, divisor: Ex<'g>) -> Self {
        self.map(|x| x / divisor)
    }
}
