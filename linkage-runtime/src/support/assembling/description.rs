//! The data of a mechanism that its assembly needs.

use super::revolutions::Angle;
use crate::data::{AssemblyMode, Input, Parameter};
use crate::structure::Group;

/// The data of a mechanism that its assembly needs.
#[derive(Clone, Copy, Debug)]
pub struct Description {
    /// Name of the mechanism.
    pub name: &'static str,
    /// Its inputs.
    pub inputs: &'static [Input],
    /// Its scalar parameters, of which names and units are read.
    pub parameters: &'static [Parameter],
    /// Its groups in order.
    pub groups: &'static [Group],
    /// The parameters that the groups need, in the order of the groups, by their indices.
    pub needed: &'static [usize],
    /// The unit of the gap of each group.
    pub gap_units: &'static [&'static str],
    /// The number of prepared numbers.
    pub prepared: usize,
    /// The modes that the start estimates choose.
    pub modes: &'static [AssemblyMode],
    /// The continuous angles, in the order in which they are followed.
    pub angles: &'static [Angle],
}
