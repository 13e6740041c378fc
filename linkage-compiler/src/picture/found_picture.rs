//! A picture, and the vectors that its points and directions are.

use linkage_symbolic::Vn;

use crate::ir::Picture;

/// A picture, and the vectors of its parts: points first, then directions.
#[derive(Clone, Debug, Default)]
pub(crate) struct FoundPicture<'m> {
    pub(crate) picture: Picture,
    pub(crate) vectors: Vec<Vn<'m>>,
}
