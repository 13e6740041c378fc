//! The test that neighbouring cells are on one solution.

use super::layout::{Layout, Places};
use alloc::vec;
use alloc::vec::Vec;

/// Two cells that agree this well at a place are on one solution.
const AGREEMENT: f64 = 1e-6;

/// The state at a place on the border of a cell.
#[derive(Clone, Debug)]
pub(super) enum BorderState {
    /// The solution there, which evaluators reach.
    Served(Vec<f64>),
    /// The solution there, which they do not reach.
    Missed(Vec<f64>),
    /// The solution does not exist there.
    Absent,
    /// It may exist.
    Unknown,
}

impl BorderState {
    fn state(&self) -> Option<&[f64]> {
        match self {
            Self::Served(state) | Self::Missed(state) => Some(state),
            Self::Absent | Self::Unknown => None,
        }
    }
}

/// The joint between a cell and its neighbours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Joint {
    /// With the same solution.
    Same,
    /// Somewhere on a face the solution exists for one of the cells only, as around a cusp: they
    /// may hold different assemblies.
    Unclear,
    /// With another solution.
    Other,
}

/// The states on the borders of all cells.
pub(super) struct Border<'a> {
    pub(super) places: &'a Places,
    /// The solution at the corners of the filled cells.
    corners: Vec<Option<Vec<f64>>>,
    /// The places of the filled cells.
    filled: Vec<Vec<BorderState>>,
}

impl<'a> Border<'a> {
    pub(super) fn new(layout: &Layout<'_>, places: &'a Places) -> Self {
        Self {
            places,
            corners: vec![None; layout.corners()],
            filled: vec![Vec::new(); layout.cells()],
        }
    }

    /// Returns the joint of a cell with all others at its corners, and with every neighbour on the
    /// whole face between them. The worst one counts.
    pub(super) fn joint(
        &self,
        layout: &Layout<'_>,
        cell: &[usize],
        places: &[BorderState],
    ) -> Joint {
        let at_corners = self.served_corners(places).map(|(corner, state)| {
            let other = &self.corners[layout.corner(cell, &self.places.offsets[corner])];
            other
                .as_ref()
                .map_or(Joint::Same, |other| same(other, state))
        });
        let sides = (0..cell.len()).flat_map(|axis| [false, true].map(|up| (axis, up)));
        let on_faces = sides.map(|(axis, up)| match layout.neighbour(cell, axis, up) {
            Some(next) if next != cell => {
                let other = &self.filled[layout.number(&next)];
                self.across(axis, up, places, other)
            }
            _ => Joint::Same,
        });
        at_corners.chain(on_faces).max().unwrap_or(Joint::Same)
    }

    /// Stores the states of a filled cell.
    pub(super) fn keep(&mut self, layout: &Layout<'_>, cell: &[usize], places: Vec<BorderState>) {
        for (corner, state) in self.served_corners(&places) {
            let number = layout.corner(cell, &self.places.offsets[corner]);
            self.corners[number].get_or_insert_with(|| state.clone());
        }
        self.filled[layout.number(cell)] = places;
    }

    /// Returns the joint of two cells on the upper or lower face of the first. A cell that is not
    /// filled joins with any other.
    fn across(
        &self,
        axis: usize,
        up: bool,
        places: &[BorderState],
        other: &[BorderState],
    ) -> Joint {
        if other.is_empty() {
            return Joint::Same;
        }
        let side = if up { 0.5 } else { -0.5 };
        let opposite = &self.places.opposite[axis];
        let all = self.places.offsets.iter().zip(places).zip(opposite);
        let on_face = all.filter(|((offsets, _), _)| offsets[axis] == side);
        let joints =
            on_face.map(
                |((_, here), &there)| match (here.state(), other[there].state()) {
                    (Some(one), Some(two)) => same(one, two),
                    (None, None) => Joint::Same,
                    _ => Joint::Unclear,
                },
            );
        joints.max().unwrap_or(Joint::Same)
    }

    fn served_corners<'p>(
        &self,
        places: &'p [BorderState],
    ) -> impl Iterator<Item = (usize, &'p Vec<f64>)> + use<'p> {
        let places = places.iter().take(self.places.corners).enumerate();
        places.filter_map(|(corner, border_state)| match border_state {
            BorderState::Served(state) => Some((corner, state)),
            _ => None,
        })
    }
}

/// Returns whether two states are of one solution.
pub(super) fn agree(one: &[f64], other: &[f64]) -> bool {
    let mut pairs = one.iter().zip(other);
    pairs.all(|(a, b)| (a - b).abs() <= AGREEMENT)
}

fn same(one: &[f64], other: &[f64]) -> Joint {
    if agree(one, other) {
        Joint::Same
    } else {
        Joint::Other
    }
}
