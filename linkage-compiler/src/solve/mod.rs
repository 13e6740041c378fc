//! Every unknown expressed: the closed form of each group.
//!
//! One file for each form of group. A group's unknowns get definitions that are computed by the closed form; their
//! derivatives follow from the group's equations (see [`Solution`](crate::algebra::Solution)).

pub(crate) mod circles;
pub(crate) mod contour;
pub(crate) mod iterated;
pub(crate) mod longest;
pub(crate) mod plane;
pub(crate) mod point;
pub(crate) mod prp;
pub(crate) mod quadratic;
pub(crate) mod rpr;
pub(crate) mod rrp;
pub(crate) mod rrr;
pub(crate) mod rssp;
pub(crate) mod rssr;
pub(crate) mod scalar;
pub(crate) mod solver;
pub(crate) mod space;
pub(crate) mod three_slides;
pub(crate) mod trigonometric;

use crate::algebra::dependence;
use std::borrow::Cow;

use linkage_core::numeric::continuation::Terms;
use linkage_symbolic::lookup::Map;

use linkage_symbolic::{Ex, SymbolId};

use crate::algebra::{Algebra, Nominal, Rule};
use crate::model::{Dimension, Mechanism};
use crate::structure::{Group, Structure};

use contour::Contour;
use solver::Solver;

pub(crate) use iterated::{Prepared, Version};

/// What a kind of group tells about its solution.
#[derive(Clone, Debug)]
pub(crate) struct Closed<'m> {
    pub(crate) kind: Cow<'static, str>,
    pub(crate) class: u8,
    pub(crate) order: u8,
    pub(crate) method: &'static str,
    /// Two solutions, told apart by a mode.
    pub(crate) two_modes: bool,
    /// `|det J|` over its largest value for these lengths.
    pub(crate) margin: Ex<'m>,
    /// Positive where the group can be assembled, zero at the dead point, negative beyond. For a group with one
    /// solution it changes sign there.
    pub(crate) slack: Ex<'m>,
    /// What the slack is measured by: its value at the reference makes the slack a number of about 1.
    pub(crate) slack_scale: Ex<'m>,
    /// By how much the group misses closing: positive if it cannot be assembled.
    pub(crate) gap: Ex<'m>,
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
    /// Like the links: the loop is about their lengths or squares of them.
    Link,
}

/// A group with its solution.
#[derive(Clone, Debug)]
pub(crate) struct Solved<'m> {
    pub(crate) group: Group<'m>,
    pub(crate) closed: Closed<'m>,
    /// Index among the assembly modes.
    pub(crate) mode: Option<usize>,
    /// For a coupled group.
    pub(crate) prepared: Option<Prepared<'m>>,
}

impl Solved<'_> {
    /// The dimension of the group's gap.
    pub(crate) fn gap_dimension(&self, mechanism: &Mechanism) -> Dimension {
        let dimension = match self.closed.gap_in {
            GapIn::Loop => self.group.loop_dimension(mechanism),
            GapIn::Unknown => self.group.unknown_dimension(mechanism),
            GapIn::Link => self.group.link_dimension(mechanism),
        };
        dimension.unwrap_or(Dimension::LENGTH)
    }
}

/// The mechanism with every unknown expressed.
#[derive(Debug, Default)]
pub(crate) struct Formulation<'m> {
    pub(crate) groups: Vec<Solved<'m>>,
    /// The group that a symbol belongs to.
    pub(crate) group_of: Map<SymbolId, usize>,
    pub(crate) mobility: usize,
}

impl<'m> Formulation<'m> {
    /// What grids over two inputs know in their cells.
    pub(crate) fn in_cells(&self) -> Terms {
        let mut over_two = self.prepared().filter(|own| own.inputs.len() == 2);
        match over_two.any(|own| own.in_cells == Terms::Slopes) {
            true => Terms::Slopes,
            false => Terms::Polynomials,
        }
    }

    pub(crate) fn modes(&self) -> usize {
        self.groups
            .iter()
            .filter(|group| group.mode.is_some())
            .count()
    }

    /// What is prepared for the coupled groups, in order.
    pub(crate) fn prepared(&self) -> impl Iterator<Item = &Prepared<'m>> {
        self.groups
            .iter()
            .filter_map(|group| group.prepared.as_ref())
    }

    /// The last group that finds an unknown.
    pub(crate) fn last_group_with(&self, unknown: usize) -> Option<usize> {
        self.groups
            .iter()
            .rposition(|solved| solved.group.unknowns.contains(&unknown))
    }

    /// Angles in the order in which their groups are solved.
    pub(crate) fn in_order(&self, algebra: &Algebra<'m>, mut angles: Vec<usize>) -> Vec<usize> {
        angles.sort_by_key(|&angle| self.group_of.get(&algebra.names.angles[angle].cos));
        angles
    }

    /// The groups that expressions are computed from, in order.
    pub(crate) fn groups_of(&self, algebra: &Algebra<'m>, all: &[Ex<'m>]) -> Vec<usize> {
        let symbols = dependence::symbols_below(algebra, all);
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
pub(crate) fn formulate<'m>(
    algebra: &mut Algebra<'m>,
    nominal: &Nominal,
    structure: Structure<'m>,
    in_cells: Terms,
) -> Formulation<'m> {
    let mut formulation = Formulation {
        mobility: structure.mobility,
        ..Default::default()
    };
    let mut explicit_values = Map::new();
    let mut contours = Vec::new();
    for explicit in &structure.explicit {
        let value = explicit.value;
        explicit_values.insert(explicit.symbol, value);
        algebra.graph.define(explicit.symbol, value.id());
        let rule = Rule::Follow(value);
        algebra.solutions.set_rule(explicit.symbol, rule);
    }
    let (mut modes, mut coupled) = (0, 0);
    for group in structure.groups {
        let first_symbol = algebra.graph.symbol_count();
        let index = algebra.solutions.groups.len();
        let dimension = group.loop_dimension(algebra.mechanism);
        let mut solver = Solver {
            algebra,
            nominal,
            index,
            mode: modes,
            number: coupled,
            dimension,
            explicit: &explicit_values,
            contours: &contours,
            defined: Vec::new(),
            prepared: None,
            in_cells,
        };
        let mut closed = solver.solve(&group.form);
        let contour = Contour::of(&group.form, &solver);
        let defined = std::mem::take(&mut solver.defined);
        let prepared = solver.prepared.take();
        contours.extend(contour);
        coupled += usize::from(prepared.is_some());
        if closed.class == 0 && group.finds_point(algebra.mechanism) {
            // A point on a line at a distance from another: the slide has no name, but the group is a dyad.
            closed = Closed {
                kind: "RRP".into(),
                class: 2,
                order: 2,
                ..closed
            };
        }
        if group.factor_has_unit(algebra.mechanism) {
            // Nothing says how large the factor could be.
            closed.margin = algebra.one();
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
            prepared,
        });
    }
    formulation
}
