//! Components of vectors.

/// Names of the components of a vector.
pub const COMPONENTS: [&str; 3] = ["x", "y", "z"];
