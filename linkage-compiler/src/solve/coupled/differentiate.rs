//! The solution of a coupled group for differentiation: private unknowns, terms, columns and their
//! elimination.

use linkage_symbolic::{Ex, V2};

use crate::algebra::{
    Algebra, Body, Distance, Elimination, Links, PrivateColumn, Solution, Term, WrittenRow,
    derivatives::partial,
};
use crate::solve::group_context::GroupContext;
use crate::solve::{definitions, unknowns};
use crate::structure::{Block, Private, SpaceLink};

use super::equations::{BlockAtRow, Equations};
use super::rotation_variation::carried;

/// Defines the private unknowns and records the solution for differentiation.
pub(super) fn push_coupled<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    equations: &Equations<'_, 'm>,
    determinant: Ex<'m>,
) {
    let form = equations.form;
    let rows: usize = form.blocks.iter().map(|block| block.rows.len()).sum();
    let nothing = vec![algebra.zero(); rows];
    let mut jacobian = vec![nothing.clone(); form.core.len()];
    let mut privates = Vec::new();
    let mut terms = Vec::new();
    for loop_rows in equations.blocks_with_rows() {
        let BlockAtRow { block, first } = loop_rows;
        if let Some(private) = &block.private {
            let private_column =
                define_private(algebra, group, private, loop_rows.rest(), jacobian.len());
            let square = match private {
                Private::Rotor(rotor) => rotor.z.square(),
                Private::Slide { guide, .. } => square_of_guide(*guide),
            };
            let mut column = nothing.clone();
            column[first..first + 2].copy_from_slice(&private_column.0);
            jacobian.push(column);
            privates.push(PrivateColumn { first, square });
        }
        for (column, &variable) in jacobian.iter_mut().zip(&equations.variables) {
            for (entry, &x) in column[first..].iter_mut().zip(&block.rows) {
                *entry = partial::partial(algebra, x, variable);
            }
        }
        terms.extend(terms_of(algebra, loop_rows, &nothing));
    }
    let core = form.core.iter();
    let elimination = Elimination {
        rows: equations.rows.clone(),
        matrix: equations.matrix.clone(),
        units: core.map(|&core| equations.unit_of(core)).collect(),
        privates,
        scheme: equations.large.as_ref().map(|large| large.scheme.clone()),
    };
    algebra.solutions.groups.push(Solution {
        terms,
        rows: match &equations.large {
            Some(large) => {
                let bodies = &large.scheme.bodies.list;
                let blocks = form.blocks.iter();
                blocks.flat_map(|block| written(block, bodies)).collect()
            }
            None => Vec::new(),
        },
        jacobian,
        determinant,
        elimination: Some(elimination),
        links: [None; 2],
        rod: None,
    });
}

/// Defines the private unknown of a loop; returns its column.
fn define_private<'m>(
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    private: &Private<'m>,
    rest: V2<'m>,
    position: usize,
) -> V2<'m> {
    match private {
        Private::Rotor(rotor) => {
            let unit = unknowns::unit_of(algebra, rotor);
            let link = definitions::turning(algebra, group, -rest, rotor.z, unit, position);
            let direction = link.turned_back(rotor.z);
            definitions::define_angle(
                algebra,
                group,
                rotor.angle,
                rotor.sense,
                direction,
                position,
            );
            link.perp()
        }
        Private::Slide { slide, guide } => {
            let value = -(guide.dot(rest) / square_of_guide(*guide));
            definitions::define_length(algebra, group, *slide, value, position);
            *guide
        }
    }
}

/// The terms of one loop among all rows.
fn terms_of<'m>(
    algebra: &Algebra<'m>,
    loop_rows: BlockAtRow<'_, 'm>,
    nothing: &[Ex<'m>],
) -> Vec<Term<'m>> {
    let BlockAtRow { block, first } = loop_rows;
    let graph = algebra.graph;
    let terms = block.terms.iter().map(|product| {
        let mut coefficient = nothing.to_vec();
        coefficient[first..first + block.rows.len()].copy_from_slice(&product.coefficient);
        let mut factor = algebra.one();
        for &(symbol, power) in &product.powers {
            for _ in 0..power {
                factor = factor * graph.ex(graph.symbol_node(symbol));
            }
        }
        Term {
            coefficient,
            factor,
        }
    });
    terms.collect()
}

/// The rows of a loop. The difference of two links is that of their squares: as products its
/// derivatives have more terms.
fn written<'m>(block: &Block<'m>, bodies: &[Body<'m>]) -> Vec<WrittenRow<'m>> {
    let row = |&row: &Ex<'m>| WrittenRow { row, links: None };
    let (Some(link), [row_itself]) = (&block.distance, &block.rows[..]) else {
        return block.rows.iter().map(row).collect();
    };
    let less = link.less.as_ref();
    let row = match less {
        Some(less) => {
            let apart = link.vector.square() - less.vector.square();
            let wanted = link.length.difference_of_squares(less.length);
            0.5 * ((apart - wanted) / link.length)
        }
        None => *row_itself,
    };
    let distance = |link: &SpaceLink<'m>| Distance {
        vector: link.vector,
        length: link.length,
        carried: carried(link.vector, bodies),
    };
    let links = Links {
        first: distance(link),
        less: less.map(|less| distance(less)),
    };
    vec![WrittenRow {
        row,
        links: Some(links),
    }]
}

fn square_of_guide(guide: V2) -> Ex {
    if guide.is_unit() {
        guide[0].number(1.0)
    } else {
        guide.square()
    }
}
