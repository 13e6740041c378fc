//! The closed forms of all groups, and the assembly at the reference inputs.

use std::rc::Rc;

use linkage_core::numeric::continuation::Terms;

use crate::algebra::{Algebra, Nominal};
use crate::checks;
use crate::diagnostic::{Reporter, Section};
use crate::ir::ContinuousAngle;
use crate::lower;
use crate::machine::{AtReference, Reference};
use crate::observer::PhaseObserver;
use crate::solve::{self, Formulation};
use crate::structure::Structure;

use super::check::check_ranges;
use super::closed_part::AssembledPart;
use super::parts::inner_parts;
use super::redundant::check_redundant;
use super::reference::assemble_reference;

/// A mechanism with every unknown expressed, assembled at its reference inputs.
#[derive(Debug)]
pub(crate) struct Assembled<'m> {
    pub(crate) formulation: Formulation<'m>,
    pub(crate) reference: Reference,
    /// The dimensions, with an estimate of every unknown.
    nominal: Nominal,
    /// The dimensions with the estimates as they are declared.
    written: Nominal,
}

impl<'m> Assembled<'m> {
    pub(crate) fn at_reference(&self) -> AtReference<'_> {
        AtReference {
            reference: &self.reference,
            nominal: &self.nominal,
            written: &self.written,
        }
    }

    /// Checks the declared ranges, and whether redundant loops follow from the others.
    ///
    /// `angles` are the angles whose values functions use.
    pub(crate) fn check(
        &mut self,
        algebra: &mut Algebra<'m>,
        angles: &[ContinuousAngle],
        reporter: &mut Reporter,
    ) {
        let Self {
            formulation,
            reference,
            nominal,
            ..
        } = self;
        if reference.closed {
            let reporter = &mut reporter.within(Section::Ranges);
            check_ranges(algebra, formulation, nominal, reference, angles, reporter);
            check_redundant(algebra, reference, nominal, reporter);
        }
    }

    /// Returns the assembly for mechanisms that have this one as a part; `None` if its loops do not
    /// close.
    pub(crate) fn into_part(self, algebra: &Algebra<'m>) -> Option<AssembledPart> {
        let is_closed = self.reference.closed;
        is_closed.then(|| AssembledPart::new(algebra, self.reference, self.nominal))
    }
}

/// Expresses all unknowns and assembles the mechanism at the reference inputs.
///
/// Tables over two inputs contain polynomials if these are accurate over the ranges, else slopes.
/// The accuracy is known only after a table is built. If it does not suffice, the groups are solved
/// a second time, from the same state of the algebra.
pub(crate) fn assemble<'m>(
    algebra: &mut Algebra<'m>,
    nominal: &Nominal,
    structure: Structure<'m>,
    parts: &[Rc<AssembledPart>],
    reporter: &mut Reporter,
    observer: &mut dyn PhaseObserver,
) -> Assembled<'m> {
    let mut attempt = |algebra: &mut Algebra<'m>, reporter: &mut Reporter, structure, terms| {
        let formulation = solve::formulate(algebra, nominal, structure, terms);
        checks::check_names_of_follower(algebra.mechanism, &formulation, reporter);
        observer.formulated(algebra, &formulation, nominal);
        let closure = lower::closure_programs(algebra, &formulation, nominal);
        let inner = inner_parts(algebra, nominal, parts);
        let mut complete = nominal.clone();
        let reference = assemble_reference(
            algebra,
            &formulation,
            closure,
            &mut complete,
            inner,
            reporter.reborrow(),
        )?;
        complete.complete(&reference.found);
        Some(Assembled {
            formulation,
            reference,
            nominal: complete,
            written: nominal.clone(),
        })
    };
    let (state, messages) = (algebra.state(), reporter.mark());
    let polynomials = attempt(algebra, reporter, structure.clone(), Terms::Polynomials);
    polynomials.unwrap_or_else(|| {
        algebra.restore(state);
        reporter.rewind(messages);
        attempt(algebra, reporter, structure, Terms::Slopes).expect("slopes serve all ranges")
    })
}
