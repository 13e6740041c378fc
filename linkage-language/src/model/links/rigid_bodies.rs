//! Bodies: links that are welded, or that share two joints, are one.

use super::linkage::{FRAME, Linkage};

/// The bodies of a linkage. The frame is the first of them.
pub(super) struct Bodies {
    pub(super) list: Vec<Body>,
    /// The body of each link.
    pub(super) of_link: Vec<usize>,
}

pub(super) struct Body {
    /// Its links, the first of which gives it its axes.
    pub(super) links: Vec<usize>,
    /// Its joints, each once.
    pub(super) joints: Vec<usize>,
}

impl Bodies {
    /// Returns the joint that the bodies of two links share.
    pub(super) fn shared_joint(&self, one: usize, other: usize) -> Option<usize> {
        let [one, other] = [one, other].map(|link| &self.list[self.of_link[link]].joints);
        one.iter().copied().find(|joint| other.contains(joint))
    }
}

impl Body {
    /// Returns the link that gives the body its axes and its name.
    pub(super) fn lead(&self) -> usize {
        self.links[0]
    }
}

/// Joins links until no two bodies share two joints.
pub(super) fn bodies(linkage: &Linkage) -> Bodies {
    let mut groups: Vec<Vec<usize>> = (0..linkage.links.len()).map(|link| vec![link]).collect();
    for [one, other] in &linkage.welds {
        let holds = |link: usize| move |group: &Vec<usize>| group.contains(&link);
        let first = groups.iter().position(holds(*one));
        let second = groups.iter().position(holds(*other));
        if let (Some(first), Some(second)) = (first, second) {
            join(&mut groups, first, second);
        }
    }
    while let Some((first, second)) = shared_twice(linkage, &groups) {
        join(&mut groups, first, second);
    }
    let mut of_link = vec![FRAME; linkage.links.len()];
    let mut list = Vec::new();
    for links in groups {
        for link in &links {
            of_link[*link] = list.len();
        }
        let joints = joints(linkage, &links);
        list.push(Body { links, joints });
    }
    Bodies { list, of_link }
}

fn join(groups: &mut Vec<Vec<usize>>, one: usize, other: usize) {
    if one == other {
        return;
    }
    let (first, second) = (one.min(other), one.max(other));
    let links = groups.remove(second);
    groups[first].extend(links);
    groups[first].sort_unstable();
}

/// Returns two bodies that share two joints.
fn shared_twice(linkage: &Linkage, groups: &[Vec<usize>]) -> Option<(usize, usize)> {
    let joints: Vec<Vec<usize>> = groups.iter().map(|links| joints(linkage, links)).collect();
    (0..groups.len()).find_map(|second| {
        let shared = |first: &usize| {
            let shared = joints[*first].iter();
            shared
                .filter(|joint| joints[second].contains(joint))
                .count()
                >= 2
        };
        // A rod of given length may lie beside another one only by mistake; the compiler tells.
        let fixed = |group: usize| {
            let links = groups[group].iter();
            links
                .map(|link| &linkage.links[*link])
                .all(|link| link.at.is_none() && link.length.is_none())
        };
        let mut others = 0..second;
        others
            .find(|first| shared(first) && fixed(*first) && fixed(second))
            .map(|first| (first, second))
    })
}

fn joints(linkage: &Linkage, links: &[usize]) -> Vec<usize> {
    let mut joints = Vec::new();
    for joint in links.iter().flat_map(|link| &linkage.links[*link].joints) {
        if !joints.contains(joint) {
            joints.push(*joint);
        }
    }
    joints
}
