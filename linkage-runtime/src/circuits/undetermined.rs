//! Groups that are at a dead point throughout: their links lie on each other, or in one line.

use super::branch::Undetermined;
use super::leaf::Leaf;
use super::levels::Levels;
use super::slab::Slab;
use super::unknowns::estimates;
use crate::error::GroupRef;
use linkage_core::range_check::Slack;

/// Slacks are squares of sines. Below this one everywhere, links lie on each other as well as a
/// drawing with some digits states it, and the sign of the slack may be that of a rounding error.
const FOLDED: f64 = 1e-14;

/// Returns true if the slack of a group vanishes at all samples of a slab. Of slacks without a
/// measure this is not known.
pub(super) fn is_folded(
    kind: Option<&Slack>,
    slab: &Slab,
    samples: usize,
    slack: &dyn Fn(f64) -> f64,
) -> bool {
    match kind {
        Some(Slack::Number) => {
            let last = samples.max(2);
            (0..=last).all(|index| {
                let u = 2.0 * (index as f64 / last as f64) - 1.0;
                slack(slab.x(u)).abs() <= FOLDED
            })
        }
        Some(Slack::Relative | Slack::Signed | Slack::Prepared) | None => false,
    }
}

/// Describes a group of this kind, given the assembly of the groups before it.
pub(super) fn described<M: Levels>(
    mechanism: &M,
    surveyor: &M::Assembly,
    group: usize,
    before: &Leaf,
) -> Undetermined {
    let searched = mechanism.searched();
    let slab = before.slab();
    let input = match before.known {
        Some(known) => known,
        None if slab.covers(searched.reference) => searched.reference,
        None => slab.x(0.0),
    };
    let is_known = |name: &str| {
        let mut found = searched.groups[..group].iter();
        found.any(|group| group.unknowns.contains(&name))
    };
    let mut unknowns = estimates(mechanism, surveyor, input);
    unknowns.retain(|unknown| is_known(unknown.name));
    Undetermined {
        group: GroupRef::new(searched.name, group, &searched.groups[group]),
        ends: before.inputs,
        input,
        unknowns,
    }
}
