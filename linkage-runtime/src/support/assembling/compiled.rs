//! A compiled mechanism.

use linkage_core::Scalar;

use super::description::Description;
use super::list::{List, Table};
use super::revolutions::Revolutions;
use crate::data::{AssemblyMode, Input};
use crate::support::assembly_data::{AssemblyData, Core};
use crate::support::stages::RowNumbersMut;

/// The revolutions of the angles of a mechanism.
pub type RevolutionsOf<C> = Revolutions<<C as Compiled>::Centres, <C as Compiled>::Windings>;

/// The data of an assembly, without the initial states of coupled groups.
pub type CoreOf<C> = Core<C, <C as Compiled>::Modes, RevolutionsOf<C>, <C as Compiled>::Prepared>;

/// The data of an assembly.
pub type DataOf<C> = AssemblyData<CoreOf<C>, <C as Compiled>::States>;

/// A mechanism with its dimensions: its description and its programs.
///
/// The macro prints it for the struct of the dimensions, the engine interprets the programs of a
/// text. All that assembles a mechanism is written once, over this trait. Programs are functions
/// without a branch; they have the instructions of the build, if nothing else is said.
pub trait Compiled: Clone {
    /// The numbers that it computes with, in lanes.
    type Scalar: Scalar;
    /// The mechanism of one lane.
    type Plain: Compiled<Scalar = f64, Plain = Self::Plain, Modes = Self::Modes>;
    /// The assembled mechanism.
    type Assembly: Clone;
    /// The mode of each group that has two.
    type Modes: List<AssemblyMode>;
    /// A number for each input.
    type Inputs: List<Self::Scalar>;
    /// A number for each continuous angle.
    type Centres: List<Self::Scalar>;
    /// Numbers for each continuous angle.
    type Windings: List<Self::Inputs> + Table<Self::Scalar>;
    /// The numbers that depend on dimensions, modes and revolutions alone.
    type Prepared: List<Self::Scalar> + RowNumbersMut<Self::Scalar>;
    /// The initial states of coupled groups in all lanes.
    type States: Clone;
    /// The inputs, and the states of coupled groups there.
    type Arguments;

    /// Its description.
    fn description(&self) -> &Description;

    /// The reference inputs.
    fn reference(&self) -> Self::Inputs {
        let inputs = self.description().inputs;
        let mut at = Self::Inputs::repeat(inputs.len(), Scalar::from_f64(0.0));
        references(inputs, at.as_mut());
        at
    }

    /// The modes that the start estimates choose.
    fn default_modes(&self) -> Self::Modes {
        let modes = self.description().modes;
        let mut default = Self::Modes::repeat(modes.len(), AssemblyMode::Plus);
        default.as_mut().copy_from_slice(modes);
        default
    }

    /// The assembly that has these data.
    fn assembly(data: DataOf<Self>) -> Self::Assembly;

    /// The data of an assembly.
    fn data(assembly: &Self::Assembly) -> &DataOf<Self>;

    /// The dimensions in the order of the parameters.
    fn dimensions(&self) -> impl AsRef<[Self::Scalar]>;

    /// The mechanism with other dimensions, each by its index.
    fn with_dimensions(&self, dimension: impl Fn(usize) -> Self::Scalar) -> Self;

    /// The mechanism in plain numbers, with other dimensions.
    fn plain(&self, dimension: impl Fn(usize) -> f64) -> Self::Plain;

    /// The mechanism of one lane.
    fn lane(&self, lane: usize) -> Self::Plain {
        let dimensions = self.dimensions();
        self.plain(|index| dimensions.as_ref()[index].lane(lane))
    }

    /// The arguments of programs at these inputs.
    fn arguments(&self, states: &Self::States, inputs: &Self::Inputs) -> Self::Arguments;

    /// Prepares an assembly: its numbers are put into `slots`. With `FUSED` only on machines with
    /// fused multiply-add.
    fn prepare<const FUSED: bool>(
        &self,
        modes: &Self::Modes,
        revolutions: &RevolutionsOf<Self>,
        slots: &mut impl RowNumbersMut<Self::Scalar>,
    );

    /// The gaps by which groups miss closing.
    fn gaps(
        &self,
        modes: &Self::Modes,
        prepared: &Self::Prepared,
        x: Self::Arguments,
    ) -> impl AsRef<[Self::Scalar]>;

    /// Cosine and sine of each continuous angle.
    fn directions(
        &self,
        modes: &Self::Modes,
        prepared: &Self::Prepared,
        x: Self::Arguments,
    ) -> impl AsRef<[[Self::Scalar; 2]]>;

    /// The vectors of the phases of all continuous angles, one angle after the other.
    fn bearings(&self, modes: &Self::Modes) -> impl AsRef<[[Self::Scalar; 2]]>;
}

/// Fills in the reference inputs. One function for all mechanisms: their code is compiled often
/// enough.
fn references<T: Scalar>(inputs: &[Input], at: &mut [T]) {
    for (at, input) in at.iter_mut().zip(inputs) {
        *at = T::from_f64(input.reference);
    }
}
