//! Links where they are drawn.

use std::collections::BTreeMap;

use crate::placement::Placement;

/// The body of each link, and the placement of the link's coordinates where it is drawn.
pub(super) type PlacedLinks<'t> = BTreeMap<&'t str, (usize, Placement)>;
