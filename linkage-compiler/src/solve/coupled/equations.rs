//! The equations of a core: one across each private unknown, and the rows of loops without one.

use linkage_symbolic::{Ex, NodeId, SymbolId, V2, Vector, Vn, substitute};

use crate::algebra::{Algebra, CoreRow, derivatives::partial, nominal};
use crate::solve::group_context::GroupContext;
use crate::structure::{Block, Core, Coupled, Private, Product};

use super::large_system::LargeSystem;

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
    /// The system that steps solve instead, if the core is too large for cofactors.
    pub(super) large: Option<LargeSystem<'m>>,
}

/// A loop and where it stands.
#[derive(Clone, Copy)]
pub(super) struct BlockAtRow<'f, 'm> {
    pub(super) block: &'f Block<'m>,
    /// Its first row among those of all loops.
    pub(super) first: usize,
}

impl<'m> BlockAtRow<'_, 'm> {
    /// The rows of a vector loop without its private unknown.
    pub(super) fn rest(self) -> V2<'m> {
        Vector([self.block.rest[0], self.block.rest[1]])
    }
}

/// An unknown of the core as a column of a loop.
#[derive(Clone, Copy)]
struct Column<'m> {
    variable: SymbolId,
    /// The factor of derivatives with respect to it.
    scale: Ex<'m>,
}

impl<'f, 'm> Equations<'f, 'm> {
    /// The loops in order.
    pub(super) fn blocks_with_rows(
        &self,
    ) -> impl Iterator<Item = BlockAtRow<'f, 'm>> + use<'f, 'm> {
        let mut next = 0;
        self.form.blocks.iter().map(move |block| {
            let first = next;
            next += block.rows.len();
            BlockAtRow { block, first }
        })
    }

    /// The number of equations of the core that a loop leaves.
    pub(super) fn count(&self, loop_rows: BlockAtRow<'_, 'm>) -> usize {
        match loop_rows.block.private {
            Some(_) => 1,
            None => loop_rows.block.rows.len(),
        }
    }

    /// An unknown of the core over its scaled value.
    pub(super) fn unit_of(&self, core: Core) -> Ex<'m> {
        match core {
            Core::Angle(_) | Core::Length { number: true, .. } => self.one(),
            Core::Length { .. } => self.unit,
        }
    }

    /// The factor of the rows of a loop. Vector loops and distances are lengths; the dimension of a
    /// scalar loop is unknown.
    pub(super) fn row_scale(&self, block: &Block<'m>) -> Ex<'m> {
        if block.is_length() {
            self.scale
        } else {
            self.one()
        }
    }

    /// The factor of a loop's derivatives with respect to an unknown of the core.
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
    algebra: &mut Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    form: &'f Coupled<'m>,
) -> Equations<'f, 'm> {
    let positions = 0..form.core.len();
    let variables = positions.map(|k| partial::unknown_variable(algebra, group.index, k));
    let variables = variables.collect();
    let reach = reach(algebra, group, form);
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
    for loop_rows in equations.blocks_with_rows() {
        match &loop_rows.block.private {
            Some(private) => across_private(algebra, &mut equations, loop_rows, private),
            None => row_by_row(algebra, &mut equations, loop_rows),
        }
    }
    equations
}

/// The sum of the lengths of the links that do not depend on inputs. Loops without such a link have
/// the size of the lengths that turn in them: if lengths of a state were not about 1, steps along
/// them would be taken for steps to another assembly.
fn reach<'m>(algebra: &Algebra<'m>, group: &GroupContext<'_, 'm>, form: &Coupled<'m>) -> Ex<'m> {
    let angles = &algebra.names.angles;
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
    let zero = algebra.zero();
    let sum = fixed.fold(zero, |sum, link| sum + vector(&link).length());
    let has_links = !sum.is_zero();
    if has_links && !form.is_large() {
        return sum;
    }
    let sum = sum + between_ends(algebra, form);
    if sum.is_zero() {
        largest_arm(algebra, group, form)
    } else {
        sum
    }
}

/// The largest length that turns with unknown angles alone in scalar loops; a number if all of them
/// depend on inputs.
fn largest_arm<'m>(
    algebra: &Algebra<'m>,
    group: &GroupContext<'_, 'm>,
    form: &Coupled<'m>,
) -> Ex<'m> {
    let directions: Vec<SymbolId> = algebra
        .names
        .angles
        .iter()
        .flat_map(|angle| [angle.cos, angle.sin])
        .collect();
    let turns = |product: &&Product<'m>| {
        let mut symbols = product.powers.iter();
        !product.powers.is_empty() && symbols.all(|(symbol, _)| directions.contains(symbol))
    };
    let scalar_loops = form.blocks.iter();
    let scalar_loops = scalar_loops
        .filter(|block| block.between_lengths && block.rows.len() == 1 && block.distance.is_none());
    let products = scalar_loops.flat_map(|block| &block.terms).filter(turns);
    let arms: Vec<Ex> = products
        .map(|product| product.coefficient[0].abs())
        .collect();
    let fixed = arms.iter().copied().filter(|arm| arm.is_fixed());
    fixed.reduce(Ex::max).unwrap_or_else(|| {
        let lengths = nominal::at_estimates(&algebra.names, group.nominal, &arms);
        algebra
            .graph
            .number(lengths.into_iter().fold(0.0, f64::max))
    })
}

/// The sum of the distances between the fixed ends of driven links and the origins of moving
/// bodies. Driven links have no length of their own, and a platform whose legs are all driven has
/// no other size.
fn between_ends<'m>(algebra: &Algebra<'m>, form: &Coupled<'m>) -> Ex<'m> {
    let zero = algebra.zero();
    let driven = form.blocks.iter().filter_map(|b| b.distance.as_ref());
    let driven = driven.filter(|link| !link.length.is_fixed());
    let unknowns = form.core.iter().flat_map(|core| match *core {
        Core::Angle(angle) => algebra.names.angles[angle].symbols().to_vec(),
        Core::Length { symbol, .. } => vec![symbol],
    });
    let nothing = unknowns.map(|symbol| (symbol, zero)).collect();
    driven.fold(zero, |sum, link| {
        let end = substitute(&link.vector.0, &nothing);
        if end.iter().all(|x| x.is_fixed()) {
            sum + vector(&end).length()
        } else {
            sum
        }
    })
}

/// The equations of a loop without a private unknown.
fn row_by_row<'m>(
    algebra: &mut Algebra<'m>,
    equations: &mut Equations<'_, 'm>,
    loop_rows: BlockAtRow<'_, 'm>,
) {
    let BlockAtRow { block, first } = loop_rows;
    let scale = equations.row_scale(block);
    let columns = equations.columns(block);
    for (row, &x) in block.rows.iter().enumerate() {
        equations.residuals.push(scale * x);
        let slope =
            |column: &Column<'m>| column.scale * partial::partial(algebra, x, column.variable);
        equations.matrix.push(columns.iter().map(slope).collect());
        equations.rows.push(CoreRow {
            first: first + row,
            factors: vec![scale],
        });
    }
}

/// The equation of a loop across its private unknown.
fn across_private<'m>(
    algebra: &mut Algebra<'m>,
    equations: &mut Equations<'_, 'm>,
    loop_rows: BlockAtRow<'_, 'm>,
    private: &Private<'m>,
) {
    let scale = equations.scale;
    let rest = loop_rows.rest();
    let columns = equations.columns(loop_rows.block);
    let slopes: Vec<V2> = columns
        .iter()
        .map(|column| rest.map(|x| partial::partial(algebra, x, column.variable)))
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
                let turning = guide.map(|x| partial::partial(algebra, x, variable));
                guide.cross(slope) + turning.cross(scale * rest)
            });
            (residual, entries.collect(), guide.perp())
        }
    };
    equations.residuals.push(residual);
    equations.matrix.push(entries);
    equations.rows.push(CoreRow {
        first: loop_rows.first,
        factors: (scale * multiplier).0.to_vec(),
    });
}

/// One component for each row of a loop, as a vector.
pub(super) fn vector<'m>(rows: &[Ex<'m>]) -> Vn<'m> {
    let ids: Vec<NodeId> = rows.iter().map(|x| x.id()).collect();
    rows[0].graph().components(&ids)
}
