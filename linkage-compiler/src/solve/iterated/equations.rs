//! The equations of a core: one across each private unknown, and the rows of loops without one.

use crate::algebra::partial;
use crate::solve::iterated::large;
use linkage_symbolic::{Ex, SymbolId, V2, Vector, substitute};

use crate::algebra::CoreRow;
use crate::solve::Solver;
use crate::structure::{Block, Core, Coupled, Private};

use super::large::Large;
use super::vector;

/// The equations of the core, in the symbols of the core alone, and all that is made of them.
pub(super) struct Equations<'f, 'm> {
    pub(super) form: &'f Coupled<'m>,
    /// The unknowns of the core as variables of derivatives.
    pub(super) variables: Vec<SymbolId>,
    /// The sum of the lengths of the links.
    pub(super) reach: Ex<'m>,
    /// A power of two near the inverse of the reach: lengths times this stand beside angles.
    pub(super) scale: Ex<'m>,
    /// 1 over the scale.
    pub(super) unit: Ex<'m>,
    pub(super) residuals: Vec<Ex<'m>>,
    pub(super) rows: Vec<CoreRow<'m>>,
    /// The derivatives of the residuals by the scaled unknowns.
    pub(super) matrix: Vec<Vec<Ex<'m>>>,
    /// What steps solve instead, if it is too large for cofactors.
    pub(super) large: Option<Large<'m>>,
}

/// A loop and where it stands.
#[derive(Clone, Copy)]
pub(super) struct Place<'f, 'm> {
    pub(super) block: &'f Block<'m>,
    /// Its first row among those of all loops.
    pub(super) first: usize,
}

impl<'m> Place<'_, 'm> {
    /// The rows of a vector loop without its private unknown.
    pub(super) fn rest(self) -> V2<'m> {
        Vector([self.block.rest[0], self.block.rest[1]])
    }
}

/// An unknown of the core as a column of a loop.
#[derive(Clone, Copy)]
struct Column<'m> {
    variable: SymbolId,
    /// What derivatives by it are multiplied by.
    scale: Ex<'m>,
}

impl<'f, 'm> Equations<'f, 'm> {
    /// The loops in order.
    pub(super) fn places(&self) -> impl Iterator<Item = Place<'f, 'm>> + use<'f, 'm> {
        let mut next = 0;
        self.form.blocks.iter().map(move |block| {
            let first = next;
            next += block.rows.len();
            Place { block, first }
        })
    }

    /// How many equations of the core a loop leaves.
    pub(super) fn count(&self, place: Place<'_, 'm>) -> usize {
        match place.block.private {
            Some(_) => 1,
            None => place.block.rows.len(),
        }
    }

    /// An unknown of the core over its scaled value.
    pub(super) fn unit_of(&self, core: Core) -> Ex<'m> {
        match core {
            Core::Angle(_) | Core::Length { number: true, .. } => self.one(),
            Core::Length { .. } => self.unit,
        }
    }

    /// What the rows of a loop are multiplied by. Vector loops and distances are lengths; what a scalar loop is, nobody knows.
    pub(super) fn row_scale(&self, block: &Block<'m>) -> Ex<'m> {
        match block.is_length() {
            true => self.scale,
            false => self.one(),
        }
    }

    /// What the derivatives of a loop by an unknown of the core are multiplied by.
    pub(super) fn column_scale(&self, block: &Block<'m>, core: Core) -> Ex<'m> {
        match (core, block.is_length()) {
            (Core::Angle(_) | Core::Length { number: true, .. }, _) => self.row_scale(block),
            (Core::Length { .. }, true) => self.one(),
            (Core::Length { .. }, false) => self.unit,
        }
    }

    fn columns(&self, block: &Block<'m>) -> Vec<Column<'m>> {
        let columns = self.variables.iter().zip(&self.form.core);
        let columns = columns.map(|(&variable, &core)| Column {
            variable,
            scale: self.column_scale(block, core),
        });
        columns.collect()
    }

    fn one(&self) -> Ex<'m> {
        self.scale.number(1.0)
    }
}

/// The equations of the core and their derivatives.
pub(super) fn core_equations<'m, 'f>(
    solver: &mut Solver<'_, 'm>,
    form: &'f Coupled<'m>,
) -> Equations<'f, 'm> {
    let positions = 0..form.core.len();
    let variables = positions.map(|k| partial::unknown_variable(solver.algebra, solver.index, k));
    let variables = variables.collect();
    let reach = reach(solver, form);
    let scale = reach.inverse_scale();
    let mut equations = Equations {
        form,
        variables,
        reach,
        scale,
        unit: 1.0 / scale,
        residuals: Vec::new(),
        rows: Vec::new(),
        matrix: Vec::new(),
        large: None,
    };
    for place in equations.places() {
        match &place.block.private {
            Some(private) => across_private(solver, &mut equations, place, private),
            None => row_by_row(solver, &mut equations, place),
        }
    }
    equations.large = form.is_large().then(|| large::large(solver, &equations));
    equations
}

/// The sum of the lengths of the links that do not depend on inputs.
fn reach<'m>(solver: &Solver<'_, 'm>, form: &Coupled<'m>) -> Ex<'m> {
    let angles = &solver.algebra.names.angles;
    let turns = |symbol| angles.iter().any(|angle| angle.cos == symbol);
    let vector_loops = form.blocks.iter().filter(|block| block.rows.len() > 1);
    let products = vector_loops.flat_map(|block| &block.terms);
    let links = products
        .filter(|product| matches!(product.powers[..], [(symbol, 1)] if turns(symbol)))
        .map(|product| product.coefficient.clone());
    let distances = form.blocks.iter().filter_map(|b| b.distance.as_ref());
    let fixed = links
        .chain(distances.map(|link| vec![link.length]))
        .filter(|link| link.iter().all(|x| x.is_fixed()));
    let zero = solver.algebra.zero();
    let sum = fixed.fold(zero, |sum, link| sum + vector(&link).length());
    match form.is_large() {
        true => sum + between_ends(solver, form),
        false => sum,
    }
}

/// Links that inputs change say nothing: instead of them, how far their fixed ends are from the origins of what moves. A platform whose
/// legs are all driven has no other size.
fn between_ends<'m>(solver: &Solver<'_, 'm>, form: &Coupled<'m>) -> Ex<'m> {
    let zero = solver.algebra.zero();
    let driven = form.blocks.iter().filter_map(|b| b.distance.as_ref());
    let driven = driven.filter(|link| !link.length.is_fixed());
    let unknowns = form.core.iter().flat_map(|core| match *core {
        Core::Angle(angle) => solver.algebra.names.angles[angle].symbols().to_vec(),
        Core::Length { symbol, .. } => vec![symbol],
    });
    let nothing = unknowns.map(|symbol| (symbol, zero)).collect();
    driven.fold(zero, |sum, link| {
        let end = substitute(&link.vector.0, &nothing);
        match end.iter().all(|x| x.is_fixed()) {
            true => sum + vector(&end).length(),
            false => sum,
        }
    })
}

/// The equations of a loop without a private unknown.
fn row_by_row<'m>(
    solver: &mut Solver<'_, 'm>,
    equations: &mut Equations<'_, 'm>,
    place: Place<'_, 'm>,
) {
    let Place { block, first } = place;
    let scale = equations.row_scale(block);
    let columns = equations.columns(block);
    for (row, &x) in block.rows.iter().enumerate() {
        equations.residuals.push(scale * x);
        let slope = |column: &Column<'m>| {
            column.scale * partial::partial(solver.algebra, x, column.variable)
        };
        equations.matrix.push(columns.iter().map(slope).collect());
        equations.rows.push(CoreRow {
            first: first + row,
            factors: vec![scale],
        });
    }
}

/// The equation of a loop across its private unknown.
fn across_private<'m>(
    solver: &mut Solver<'_, 'm>,
    equations: &mut Equations<'_, 'm>,
    place: Place<'_, 'm>,
    private: &Private<'m>,
) {
    let scale = equations.scale;
    let rest = place.rest();
    let columns = equations.columns(place.block);
    let slopes: Vec<V2> = columns
        .iter()
        .map(|column| rest.map(|x| partial::partial(solver.algebra, x, column.variable)))
        .collect();
    let columns = columns.into_iter().zip(slopes);
    let (residual, entries, multiplier): (_, Vec<Ex>, _) = match private {
        Private::Rotor(rotor) => {
            let link = scale * -rest;
            let length = scale * rotor.z.length();
            let residual = 0.5 * (length.square() - link.square());
            let entries = columns.map(|(column, slope)| link.dot(column.scale * slope));
            (residual, entries.collect(), link)
        }
        Private::Slide { guide, .. } => {
            let residual = guide.cross(scale * rest);
            let entries = columns.map(|(Column { variable, scale }, slope)| {
                let slope = scale * slope;
                let turning = guide.map(|x| partial::partial(solver.algebra, x, variable));
                guide.cross(slope) + turning.cross(scale * rest)
            });
            (residual, entries.collect(), guide.perp())
        }
    };
    equations.residuals.push(residual);
    equations.matrix.push(entries);
    equations.rows.push(CoreRow {
        first: place.first,
        factors: (scale * multiplier).0.to_vec(),
    });
}
