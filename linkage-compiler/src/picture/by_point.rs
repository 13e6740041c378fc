//! Lists by points: what is at a point is looked up, not looked for among all.

use linkage_symbolic::lookup::{Map, Set};

use super::guides::Guides;
use super::links::Links;

/// Places in a list by the points that they are about, in order.
#[derive(Clone, Debug, Default)]
pub(super) struct ByPoint(Map<usize, Vec<usize>>);

impl ByPoint {
    /// Of pairs of a point and a place; places in order.
    pub(super) fn new(pairs: impl IntoIterator<Item = (usize, usize)>) -> Self {
        let mut all: Map<usize, Vec<usize>> = Map::new();
        for (point, place) in pairs {
            all.entry(point).or_default().push(place);
        }
        Self(all)
    }

    /// Of lists of points.
    pub(super) fn of_lists<'a>(lists: impl IntoIterator<Item = &'a Vec<usize>>) -> Self {
        let lists = lists.into_iter().enumerate();
        Self::new(lists.flat_map(|(place, own)| own.iter().map(move |&point| (point, place))))
    }

    pub(super) fn of(&self, point: usize) -> &[usize] {
        self.0.get(&point).map_or(&[], Vec::as_slice)
    }
}

/// What links, guides and axes have at each point.
pub(super) struct Meeting {
    pub(super) links: ByPoint,
    pub(super) sliders: ByPoint,
    pub(super) origins: ByPoint,
    pub(super) axes: Set<usize>,
}

impl Meeting {
    /// `axes`: the points that have one.
    pub(super) fn new(links: &Links, guides: &Guides, axes: Set<usize>) -> Self {
        let all = || guides.all.iter().enumerate();
        Self {
            links: ByPoint::of_lists(links.all.iter().map(|link| &link.points)),
            sliders: ByPoint::new(all().map(|(place, own)| (own.slider, place))),
            origins: ByPoint::new(all().map(|(place, own)| (own.origin, place))),
            axes,
        }
    }
}

/// Names of which each is given once.
#[derive(Default)]
pub(super) struct Names {
    taken: Set<String>,
    /// By name as it was asked for: the last number behind it.
    last: Map<String, usize>,
}

impl Names {
    /// The name, with a number behind it if it is taken.
    pub(super) fn unique(&mut self, name: String) -> String {
        if self.taken.insert(name.clone()) {
            return name;
        }
        let last = self.last.entry(name.clone()).or_insert(1);
        loop {
            *last += 1;
            let numbered = format!("{name} {last}");
            if self.taken.insert(numbered.clone()) {
                return numbered;
            }
        }
    }
}
