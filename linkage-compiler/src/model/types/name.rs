//! Names as numbers: each kind of name is counted by itself, in the order of declaration.

/// What a name stands for; each index counts its own kind in declaration order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Name {
    Const(usize),
    Parameter(usize),
    Input(usize),
    Unknown(usize),
    Let(usize),
    Argument(usize),
    /// `PI`
    Pi,
}

/// Index into [`Mechanism::scalar_parameters`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct ScalarParameterId(pub usize);

/// What one can differentiate by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Variable {
    Input(usize),
    Parameter(ScalarParameterId),
}
