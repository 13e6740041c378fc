//! Consistency checks: ends and positions of paths that show that a path has been lost.

use super::endgame::{PathEnd, Root};
use super::path_trace::Trace;
use super::projective::ProjectivePoint;
use alloc::vec::Vec;

/// Number of paths with an uncertain end.
pub(super) fn count<const N: usize>(traces: &[Trace<N>], roots: &[Root<N>]) -> usize {
    lost(traces) + meetings(traces) + duplicates(roots)
}

fn lost<const N: usize>(traces: &[Trace<N>]) -> usize {
    let lost = |trace: &&Trace<N>| matches!(trace.end, PathEnd::Lost);
    traces.iter().filter(lost).count()
}

/// Number of paths that have met another one on their way, which means that one of them has
/// jumped.
fn meetings<const N: usize>(traces: &[Trace<N>]) -> usize {
    const NEAR: f64 = 1e-5;
    let waypoints = traces.iter().map(|trace| {
        let (point, pivot) = trace.waypoint;
        (point, (0.1 * pivot).min(NEAR))
    });
    count_equal(waypoints.collect(), NEAR)
}

/// Number of isolated solutions that have been found before.
fn duplicates<const N: usize>(roots: &[Root<N>]) -> usize {
    const LONGEST: f64 = 0.1;
    let places = roots.iter().map(|root| (root.point, root.reach));
    count_equal(places.collect(), LONGEST)
}

/// Number of places that are nearer to another one than their radius; no radius is above
/// `largest`.
fn count_equal<const N: usize>(mut places: Vec<(ProjectivePoint<N>, f64)>, largest: f64) -> usize {
    places.sort_by(|a, b| a.0.key().total_cmp(&b.0.key()));
    let mut equal = 0;
    for (index, (point, radius)) in places.iter().enumerate() {
        let key = point.key();
        let near = places[index + 1..]
            .iter()
            .take_while(|(other, _)| other.key() - key <= largest);
        equal += near
            .filter(|(other, other_radius)| {
                let radius = radius.min(*other_radius);
                point.distance(other) < radius * radius
            })
            .count();
    }
    equal
}

/// Takes ends at multiple solutions for lost where no other path ends: several do at a solution
/// that is one.
pub(super) fn lose_single<const N: usize>(traces: &mut [Trace<N>]) {
    const NEAR: f64 = 1e-2;
    let multiple = traces
        .iter()
        .enumerate()
        .filter_map(|(index, trace)| match trace.end {
            PathEnd::Multiple(point) => Some((index, point)),
            _ => None,
        });
    let multiple: Vec<(usize, ProjectivePoint<N>)> = multiple.collect();
    for (index, point) in &multiple {
        let mut others = multiple.iter().filter(|(other, _)| other != index);
        if others.all(|(_, other)| point.distance(other) >= NEAR * NEAR) {
            traces[*index].end = PathEnd::Lost;
        }
    }
}
