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

use super::check::{ClosedMechanism, check_ranges};
use super::closed_part::AssembledPart;
use super::parts::inner_parts;
use super::redundant::check_redundant;
use super::reference::assemble_reference;
use super::refused_range::RefusedRange;

/// A mechanism with every unknown expressed, assembled at its reference inputs.
#[derive(Debug)]
pub(crate) struct Assembled<'m> {
    pub(crate) formulation: Formulation<'m>,
    pub(crate) reference: Reference,
    /// The dimensions, with an estimate of every unknown.
    nominal: Nominal,
    /// The dimensions with ranges and estimates as they are declared.
    written: Nominal,
    /// The refusal of the declared ranges, if `nominal` has narrower ones.
    refused: Option<RefusedRange>,
}

impl<'m> Assembled<'m> {
    pub(crate) fn at_reference(&self) -> AtReference<'_> {
        AtReference {
            reference: &self.reference,
            nominal: &self.nominal,
            written: &self.written,
        }
    }

    /// Checks the declared ranges. `angles` are the angles whose values functions use.
    pub(crate) fn check_ranges(
        &mut self,
        algebra: &mut Algebra<'m>,
        angles: &[ContinuousAngle],
        reporter: &mut Reporter,
    ) {
        let reporter = &mut reporter.within(Section::Ranges);
        let refused = self.refused.take();
        if !self.reference.closed {
            if let Some(refused) = refused {
                refused.report(algebra.mechanism, None, reporter);
            }
            return;
        }
        let Self {
            formulation,
            reference,
            nominal,
            written,
            ..
        } = self;
        let closed = ClosedMechanism {
            formulation,
            nominal,
            written,
            reference,
            refused,
        };
        check_ranges(algebra, closed, angles, reporter);
    }

    /// Checks whether redundant loops follow from the others.
    pub(crate) fn check_redundant(&self, algebra: &mut Algebra<'m>, reporter: &mut Reporter) {
        if self.reference.closed {
            let reporter = &mut reporter.within(Section::Ranges);
            check_redundant(algebra, &self.reference, &self.nominal, reporter);
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
        let (reference, refused) = assemble_reference(
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
            refused,
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
