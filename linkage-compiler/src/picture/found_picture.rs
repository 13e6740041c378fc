//! A picture, and the vectors that its points and directions are.

use crate::ir::Picture;
use linkage_symbolic::Vn;

/// A picture, and the vectors of its parts: points first, then directions.
#[derive(Clone, Debug, Default)]
pub(crate) struct FoundPicture<'m> {
    pub(crate) picture: Picture,
    pub(crate) vectors: Vec<Vn<'m>>,
}
