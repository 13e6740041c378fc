//! The links, guides, axes and wheels that meet in a point.

use linkage_symbolic::lookup::Set;

use crate::picture::by_point::ByPoint;
use crate::picture::guides::Guides;
use crate::picture::links::Links;

/// The links, guides and axes at each point.
pub(super) struct Meeting {
    pub(super) links: ByPoint,
    pub(super) sliders: ByPoint,
    pub(super) origins: ByPoint,
    pub(super) axes: Set<usize>,
    pub(super) wheels: Set<usize>,
}

impl Meeting {
    /// `axes`: the points that have one. `wheels`: the centres of wheels that the text has.
    pub(super) fn new(
        links: &Links,
        guides: &Guides,
        axes: Set<usize>,
        wheels: Set<usize>,
    ) -> Self {
        let guides_by_index = || guides.all.iter().enumerate();
        Self {
            links: ByPoint::of_lists(links.all.iter().map(|link| &link.points)),
            sliders: ByPoint::new(guides_by_index().map(|(index, guide)| (guide.slider, index))),
            origins: ByPoint::new(guides_by_index().map(|(index, guide)| (guide.origin, index))),
            axes,
            wheels,
        }
    }
}
