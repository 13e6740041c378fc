//! Continuation with about 32 digits, for paths whose ends 16 digits do not determine.
//!
//! The coefficients have no more than 16 digits, in any computation. So an end counts only if it
//! does not depend on their last places: it must stay where it is, far from all others, when every
//! coefficient is changed by a rounding. Ends that the coefficients do not determine, such as those
//! of paths that meet at infinity to rounding, stay uncertain.

mod path_tracker;
#[cfg(test)]
mod tests;
mod wide_equations;

use super::endgame::{PathEnd, Root};
use super::homotopy::Homotopy;
use super::path_trace::Trace;
use super::polynomial::Polynomial;
use super::projective::ProjectivePoint;
use super::rough_root::rough_root;
use super::system::Variable;
use alloc::vec::Vec;
use path_tracker::Reached;
use wide_equations::Equations;

/// An end that roundings of coefficients move by more than this part of its distance from others is
/// not certain.
const STEADY: f64 = 0.1;
/// Distances below this are roundings of places.
const ROUNDING: f64 = 1e-15;
/// The reach of a solution, as a part of its distance from others.
const REACH: f64 = 0.3;
const LONGEST_REACH: f64 = 0.1;
/// A point nearer than this to its reflection may be real; far out, as a part of the inverse.
const NEARLY_REAL: f64 = 0.1;

/// The end of a path, and how far it is moved by roundings of coefficients.
struct ReachedEnd<const N: usize> {
    path: usize,
    point: ProjectivePoint<N>,
    moved: f64,
}

/// Paths of a listing, with all that is needed to follow them on.
struct Pursuit<'a, const N: usize> {
    homotopy: &'a mut Homotopy<N>,
    variables: &'a [Variable],
    traces: &'a mut [Trace<N>],
    equations: Equations<N>,
}

/// Follows the paths without a certain end on: first those that are lost, then those that are
/// blurred. Where ends become known, paths that seemed to lead to infinity are asked, too: the same
/// numbers have said so.
pub(super) fn pursue<const N: usize>(
    homotopy: &mut Homotopy<N>,
    variables: &[Variable],
    target: &[Polynomial],
    attempt: usize,
    traces: &mut [Trace<N>],
) {
    let lost = paths(traces, |end| matches!(end, PathEnd::Lost));
    let blurred = paths(traces, |end| matches!(end, PathEnd::Blurred));
    if lost.is_empty() && blurred.is_empty() {
        return;
    }
    let mut pursuit = Pursuit {
        homotopy,
        variables,
        traces,
        equations: Equations::new(target, attempt),
    };
    if !pursuit.become_known(&lost) {
        return;
    }
    if pursuit.become_known(&blurred) || !lost.is_empty() {
        for path in paths(pursuit.traces, |end| matches!(end, PathEnd::Outside)) {
            pursuit.become_known(&[path]);
        }
    }
}

/// The paths with such an end.
fn paths<const N: usize>(traces: &[Trace<N>], such: impl Fn(&PathEnd<N>) -> bool) -> Vec<usize> {
    let such = traces
        .iter()
        .enumerate()
        .filter(|(_, trace)| such(&trace.end));
    such.map(|(path, _)| path).collect()
}

impl<const N: usize> Pursuit<'_, N> {
    /// Returns whether the ends of all these paths become known. Otherwise none does: a single one
    /// that is uncertain spoils the number of solutions, and one that is lost the listing, so that
    /// no others are followed.
    fn become_known(&mut self, paths: &[usize]) -> bool {
        let mut found = Vec::with_capacity(paths.len());
        for &path in paths {
            let here = match self.reached(path) {
                Some(Reached::End(point, moved)) => {
                    found.push(ReachedEnd { path, point, moved });
                    continue;
                }
                Some(Reached::Here(point)) => Some(point),
                None => None,
            };
            self.reconsider(path, here.as_ref());
            if matches!(self.traces[path].end, PathEnd::Lost) {
                return false;
            }
        }
        let roots = found.iter().map(|end| end.root(self.traces, &found));
        let roots = roots.collect::<Option<Vec<Root<N>>>>();
        let roots = roots.filter(|roots| roots.len() == paths.len());
        for (index, end) in found.iter().enumerate() {
            match &roots {
                Some(roots) => self.traces[end.path].end = PathEnd::Regular(roots[index]),
                None => self.reconsider(end.path, Some(&end.point)),
            }
        }
        roots.is_some()
    }

    fn reached(&mut self, path: usize) -> Option<Reached<N>> {
        let (t, point) = self.traces[path].mark.as_ref()?;
        path_tracker::follow(self.homotopy, &mut self.equations, *t, point)
    }

    /// A circle around an end stays away from real points, but a path that turns off within it may
    /// not, nor one that seemed to lead to infinity: it is lost if it has come near.
    fn reconsider(&mut self, path: usize, point: Option<&ProjectivePoint<N>>) {
        let end = &mut self.traces[path].end;
        let may_be_real = |point: &ProjectivePoint<N>| {
            let gaps = point.gaps(self.variables);
            // Of two numbers far out both inverses are near 0.
            let size = |j: usize| match point.is_outer(j, self.variables) {
                true => rough_root(point.x[j].square()),
                false => 1.0,
            };
            (0..N).all(|j| gaps[j] < NEARLY_REAL * size(j))
        };
        let doubtful = match end {
            PathEnd::Blurred => point.is_none_or(may_be_real),
            PathEnd::Outside => point.is_some_and(may_be_real),
            PathEnd::Regular(_) | PathEnd::Multiple(_) | PathEnd::Lost => false,
        };
        if doubtful {
            *end = PathEnd::Lost;
        }
    }
}

impl<const N: usize> ReachedEnd<N> {
    /// The isolated solution, unless it may be one of the others.
    fn root(&self, traces: &[Trace<N>], found: &[Self]) -> Option<Root<N>> {
        let known = traces.iter().filter_map(|trace| match &trace.end {
            PathEnd::Regular(root) => Some(&root.point),
            PathEnd::Multiple(point) => Some(point),
            PathEnd::Outside | PathEnd::Blurred | PathEnd::Lost => None,
        });
        let others = found.iter().filter(|other| other.path != self.path);
        let all = known.chain(others.map(|other| &other.point));
        let apart = rough_root(
            all.map(|point| point.distance(&self.point))
                .fold(1.0, f64::min),
        );
        (self.moved.max(ROUNDING) < STEADY * apart).then(|| Root {
            point: self.point,
            reach: (REACH * apart).min(LONGEST_REACH),
        })
    }
}
