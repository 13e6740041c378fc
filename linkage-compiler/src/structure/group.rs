//! Groups in an order in which they can be solved: the result of the structural analysis.

use linkage_symbolic::{Ex, SymbolId};

use crate::model::{Dimension, Mechanism, Type};
use crate::structure::form::Form;

/// One Assur group.
#[derive(Clone, Debug)]
pub(crate) struct Group<'m> {
    /// Indices of its loops in the mechanism.
    pub(crate) loops: Vec<usize>,
    /// That of them which is solved; the others were eliminated, or are solved with it.
    pub(crate) written: usize,
    /// Indices of the unknowns that it finds, in the model.
    pub(crate) unknowns: Vec<usize>,
    pub(crate) form: Form<'m>,
}

impl Group<'_> {
    /// True if it finds both components of an unknown point by an angle.
    pub(crate) fn finds_point(&self, mechanism: &Mechanism) -> bool {
        let point = |&k: &usize| mechanism.unknowns[k].ty.components() == Some(2);
        matches!(self.form, Form::Trigonometric { .. }) && self.unknowns.iter().any(point)
    }

    /// The dimension of both sides of the loop that is solved.
    pub(crate) fn loop_dimension(&self, mechanism: &Mechanism) -> Option<Dimension> {
        let equation = &mechanism.loops[self.written];
        let sides = [&equation.left.ty, &equation.right.ty];
        sides.into_iter().find_map(Type::dimension)
    }

    /// The dimension of its links, if its loop is about lengths or squares of lengths.
    pub(crate) fn link_dimension(&self, mechanism: &Mechanism) -> Option<Dimension> {
        let of_loop = self.loop_dimension(mechanism)?;
        Some(match of_loop.half_lengths {
            4 => Dimension::LENGTH,
            _ => of_loop,
        })
    }

    /// The dimension of its first unknown.
    pub(crate) fn unknown_dimension(&self, mechanism: &Mechanism) -> Option<Dimension> {
        let unknown = self.unknowns.first()?;
        mechanism.unknowns[*unknown].ty.dimension()
    }

    /// True for a linear loop whose factor of the unknown is no number.
    pub(crate) fn factor_has_unit(&self, mechanism: &Mechanism) -> bool {
        let halves = |dimension: Option<Dimension>| dimension.map(|d| d.half_lengths);
        let (of_loop, of_unknown) = (
            self.loop_dimension(mechanism),
            self.unknown_dimension(mechanism),
        );
        matches!(self.form, Form::Linear { .. }) && halves(of_loop) != halves(of_unknown)
    }
}

/// An unknown that is an explicit expression of others and was eliminated before its group was
/// solved.
#[derive(Clone, Debug)]
pub(crate) struct Explicit<'m> {
    pub(crate) symbol: SymbolId,
    pub(crate) value: Ex<'m>,
}

/// The groups in an order in which they can be solved.
#[derive(Clone, Debug, Default)]
pub(crate) struct Structure<'m> {
    pub(crate) groups: Vec<Group<'m>>,
    pub(crate) explicit: Vec<Explicit<'m>>,
    /// Inputs + unknowns - equations.
    pub(crate) mobility: usize,
}
