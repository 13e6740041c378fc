//! The errors of a coupled group.

use super::group::{CoupledGroup, CoupledInput};
use crate::error::{AssemblyError, CoupledCause, CoupledError, GroupRef, Placed, Value};
use alloc::boxed::Box;
use linkage_core::numeric::continuation::{LeftOut, Refusal};
use linkage_core::numeric::roots::Unlisted;

impl CoupledInput {
    fn value(&self, value: f64) -> Value {
        Value {
            name: self.name,
            value,
            unit: self.unit,
            angle: self.range.turn,
        }
    }
}

impl CoupledGroup {
    pub(super) fn error(&self, cause: CoupledCause) -> AssemblyError {
        AssemblyError::Coupled(Box::new(CoupledError {
            group: self.reference(),
            cause,
        }))
    }

    pub(super) fn undefined(&self) -> AssemblyError {
        AssemblyError::Undefined {
            group: self.reference(),
        }
    }

    fn reference(&self) -> GroupRef {
        GroupRef::new(self.mechanism, self.group, self.described)
    }

    pub(super) fn leaves_out(&self, left_out: &LeftOut) -> AssemblyError {
        self.error(CoupledCause::LeavesOut {
            share: left_out.share,
            example: self.position(&left_out.at),
        })
    }

    pub(super) fn beside_dead_point(&self, x: &[f64]) -> AssemblyError {
        self.error(CoupledCause::BesideDeadPoint(self.position(x)))
    }

    fn position(&self, x: &[f64]) -> Placed {
        let pairs = self.inputs.iter().zip(x);
        Placed(pairs.map(|(input, &at)| input.value(at)).collect())
    }

    pub(super) fn refused(&self, refusal: Refusal) -> AssemblyError {
        let value = |at| match self.inputs {
            [first, ..] => first.value(at),
            [] => Value {
                name: "the input",
                value: at,
                unit: "",
                angle: false,
            },
        };
        match refusal {
            Refusal::TurningPoint { at } => self.error(CoupledCause::DeadPoint(value(at))),
            Refusal::NotConverging { at } => self.error(CoupledCause::NotFollowed(value(at))),
            Refusal::NotASolution => self.error(CoupledCause::Singular),
            Refusal::NotFinite => self.undefined(),
        }
    }

    /// The error for a figure that needs a listing of such a group.
    pub(crate) fn not_listed(&self) -> AssemblyError {
        self.error(CoupledCause::NotListed(Unlisted::Followed))
    }
}
