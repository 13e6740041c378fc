//! What differentiation needs of a coupled group: private unknowns, terms, columns and how they are eliminated.

use crate::algebra::partial;
use linkage_symbolic::{Ex, V2};

use crate::algebra::{Body, Distance, Elimination, Links, PrivateColumn, Solution, Term, Written};
use crate::solve::Solver;
use crate::structure::{Block, Link, Private};

use super::equations::{Equations, Place};
use super::turns::carried;

/// Defines the private unknowns and records what differentiation needs.
pub(super) fn push_coupled<'m>(
    solver: &mut Solver<'_, 'm>,
    equations: &Equations<'_, 'm>,
    determinant: Ex<'m>,
) {
    let form = equations.form;
    let rows: usize = form.blocks.iter().map(|block| block.rows.len()).sum();
    let nothing = vec![solver.algebra.zero(); rows];
    let mut jacobian = vec![nothing.clone(); form.core.len()];
    let mut privates = Vec::new();
    let mut terms = Vec::new();
    for place in equations.places() {
        let Place { block, first } = place;
        if let Some(private) = &block.private {
            let own = define_private(solver, private, place.rest(), jacobian.len());
            let square = match private {
                Private::Rotor(rotor) => rotor.z.square(),
                Private::Slide { guide, .. } => square_of_guide(*guide),
            };
            let mut column = nothing.clone();
            column[first..first + 2].copy_from_slice(&own.0);
            jacobian.push(column);
            privates.push(PrivateColumn { first, square });
        }
        for (column, &variable) in jacobian.iter_mut().zip(&equations.variables) {
            for (entry, &x) in column[first..].iter_mut().zip(&block.rows) {
                *entry = partial::partial(solver.algebra, x, variable);
            }
        }
        terms.extend(terms_of(solver, place, &nothing));
    }
    let core = form.core.iter();
    let elimination = Elimination {
        rows: equations.rows.clone(),
        matrix: equations.matrix.clone(),
        units: core.map(|&core| equations.unit_of(core)).collect(),
        privates,
        scheme: equations.large.as_ref().map(|large| large.scheme.clone()),
    };
    solver.push_solution(Solution {
        terms,
        rows: match &equations.large {
            Some(large) => {
                let bodies = &large.scheme.bodies.all;
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
    solver: &mut Solver<'_, 'm>,
    private: &Private<'m>,
    rest: V2<'m>,
    position: usize,
) -> V2<'m> {
    match private {
        Private::Rotor(rotor) => {
            let unit = solver.unit_of(rotor);
            let link = solver.turning(-rest, rotor.z, unit, position);
            let direction = link.turned_back(rotor.z);
            solver.define_angle(rotor.angle, rotor.sense, direction, position);
            link.perp()
        }
        Private::Slide { slide, guide } => {
            let value = -(guide.dot(rest) / square_of_guide(*guide));
            solver.define_length(*slide, value, position);
            *guide
        }
    }
}

/// The terms of one loop among all rows.
fn terms_of<'m>(
    solver: &Solver<'_, 'm>,
    place: Place<'_, 'm>,
    nothing: &[Ex<'m>],
) -> Vec<Term<'m>> {
    let Place { block, first } = place;
    let graph = solver.algebra.graph;
    let terms = block.terms.iter().map(|product| {
        let mut coefficient = nothing.to_vec();
        coefficient[first..first + block.rows.len()].copy_from_slice(&product.coefficient);
        let mut factor = solver.algebra.one();
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

/// The rows of a loop. The difference of two links is that of their squares: as products its derivatives have more terms.
fn written<'m>(block: &Block<'m>, bodies: &[Body<'m>]) -> Vec<Written<'m>> {
    let row = |&row: &Ex<'m>| Written { row, links: None };
    let (Some(link), [own]) = (&block.distance, &block.rows[..]) else {
        return block.rows.iter().map(row).collect();
    };
    let less = link.less.as_ref();
    let row = match less {
        Some(less) => {
            let apart = link.vector.square() - less.vector.square();
            let wanted = link.length.difference_of_squares(less.length);
            0.5 * ((apart - wanted) / link.length)
        }
        None => *own,
    };
    let distance = |own: &Link<'m>| Distance {
        vector: own.vector,
        length: own.length,
        carried: carried(own.vector, bodies),
    };
    let links = Links {
        first: distance(link),
        less: less.map(|own| distance(own)),
    };
    vec![Written {
        row,
        links: Some(links),
    }]
}

fn square_of_guide(guide: V2) -> Ex {
    match guide.is_unit() {
        true => guide[0].number(1.0),
        false => guide.square(),
    }
}
