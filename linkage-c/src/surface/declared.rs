//! Functions that the header declares.

/// A function that the header declares and the source defines.
#[derive(Debug)]
pub(crate) struct Declared {
    pub(crate) name: String,
    /// Its type, name and parameters, without the semicolon of a declaration.
    pub(crate) signature: String,
}
