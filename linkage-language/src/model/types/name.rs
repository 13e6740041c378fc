//! Names as numbers: each kind of name is counted by itself, in the order of declaration.

/// A name; each index counts its own kind in the order of declaration.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Name {
    Const(usize),
    Parameter(usize),
    Input(usize),
    Unknown(usize),
    Let(usize),
    Argument(usize),
    /// `PI`
    Pi,
}

/// Index into `Mechanism::scalar_parameters`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ScalarParameterId(pub usize);

/// A variable of derivatives.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Variable {
    Input(usize),
    Parameter(ScalarParameterId),
}
