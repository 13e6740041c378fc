//! Figures of a cycle that are to be least or greatest, or within limits.

use std::format;
use std::string::String;
use std::vec;
use std::vec::Vec;

use super::{Candidate, Check, Chosen, Conditions, CycleObjective, Motion, Piece, Verdict};
use linkage_core::format::rounded;

/// The pieces that a figure is made of.
#[derive(Clone, Debug, PartialEq)]
pub enum Pieces<const N: usize> {
    /// The figure is the largest of them.
    Largest(Vec<Piece<N>>),
    /// The figure is the smallest of them.
    Smallest(Vec<Piece<N>>),
}

/// A number that a cycle comes to.
pub trait Figure<A, const N: usize>: Sized {
    /// The name in messages.
    fn title(&self) -> String;

    /// The parts of it; `None` where the mechanism does not assemble over the range.
    fn pieces(&self, motion: &Motion<'_, A>) -> Option<Pieces<N>>;

    /// It is to be as small as possible: the goal.
    fn least(self) -> Requirement<Self> {
        Requirement {
            figure: self,
            sense: Sense::Least,
        }
    }

    /// It is to be as large as possible: the goal.
    fn greatest(self) -> Requirement<Self> {
        Requirement {
            figure: self,
            sense: Sense::Greatest,
        }
    }

    /// It must not be above a limit, in its own unit.
    fn at_most(self, limit: f64) -> Requirement<Self> {
        Requirement {
            figure: self,
            sense: Sense::AtMost(limit),
        }
    }

    /// It must not be below a limit, in its own unit.
    fn at_least(self, limit: f64) -> Requirement<Self> {
        Requirement {
            figure: self,
            sense: Sense::AtLeast(limit),
        }
    }

    /// It must have this value, in its own unit.
    fn equal(self, value: f64) -> Requirement<Self> {
        Requirement {
            figure: self,
            sense: Sense::Equal(value),
        }
    }
}

impl<A, F: Figure<A, N>, const N: usize> Figure<A, N> for &F {
    fn title(&self) -> String {
        (**self).title()
    }

    fn pieces(&self, motion: &Motion<'_, A>) -> Option<Pieces<N>> {
        (**self).pieces(motion)
    }
}

/// The sense of a requirement, with its limit.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Sense {
    Least,
    Greatest,
    AtMost(f64),
    AtLeast(f64),
    Equal(f64),
}

/// The requirement for a [`Figure`].
#[derive(Clone, Debug, PartialEq)]
pub struct Requirement<F> {
    figure: F,
    sense: Sense,
}

impl<F> Requirement<F> {
    /// The condition that the figure is as good as a limit, where this is a goal.
    pub(super) fn within(&self, limit: f64) -> Requirement<&F> {
        let sense = match self.sense {
            Sense::Greatest => Sense::AtLeast(limit),
            _ => Sense::AtMost(limit),
        };
        Requirement {
            figure: &self.figure,
            sense,
        }
    }

    /// The value of the figure; `None` where the mechanism does not assemble over the range.
    pub(super) fn value<A, const N: usize>(&self, motion: &Motion<'_, A>) -> Option<f64>
    where
        F: Figure<A, N>,
    {
        let piece = match &self.figure.pieces(motion)? {
            Pieces::Largest(all) => largest(all)?.value,
            Pieces::Smallest(all) => smallest(all)?.value,
        };
        Some(piece)
    }
}

impl<M, A, F: Figure<A, N> + Send + Sync, const N: usize> CycleObjective<M, A, N>
    for Requirement<F>
{
    fn title(&self) -> String {
        let title = self.figure.title();
        match self.sense {
            Sense::Least => format!("least {title}"),
            Sense::Greatest => format!("greatest {title}"),
            Sense::AtMost(limit) => format!("{title} of at most {}", rounded(limit)),
            Sense::AtLeast(limit) => format!("{title} of at least {}", rounded(limit)),
            Sense::Equal(value) => format!("{title} of {}", rounded(value)),
        }
    }

    fn is_goal(&self) -> bool {
        matches!(self.sense, Sense::Least | Sense::Greatest)
    }

    fn equations(&self) -> usize {
        usize::from(matches!(self.sense, Sense::Equal(_)))
    }

    fn reported_goal(&self, least: f64) -> f64 {
        if self.sense == Sense::Greatest {
            -least
        } else {
            least
        }
    }

    fn evaluate(&self, candidate: &Candidate<'_, M, A>, _: Chosen<'_>) -> Option<Conditions<N>> {
        let pieces = self.figure.pieces(&candidate.motion)?;
        let (goal, conditions) = match self.sense {
            Sense::Least => (upper(&pieces, 0.0), Vec::new()),
            Sense::Greatest => (lower(&pieces, 0.0), Vec::new()),
            Sense::AtMost(limit) => (Vec::new(), vec![upper(&pieces, limit)]),
            Sense::AtLeast(limit) => (Vec::new(), vec![lower(&pieces, limit)]),
            Sense::Equal(value) => (
                Vec::new(),
                vec![upper(&pieces, value), lower(&pieces, value)],
            ),
        };
        Some(Conditions {
            goal,
            conditions,
            ..Conditions::default()
        })
    }

    /// The figure alone, from a finer course.
    fn verify(&self, candidate: &Candidate<'_, M, A>, _: Chosen<'_>) -> Option<Verdict> {
        let value = self.value(&candidate.motion)?;
        let check = |by: f64, limit: f64| {
            let size = Some(limit.abs()).filter(|limit| *limit > 0.0);
            Vec::from([Check { by, size }])
        };
        let (goal, conditions) = match self.sense {
            Sense::Least => (Some(value), Vec::new()),
            Sense::Greatest => (Some(-value), Vec::new()),
            Sense::AtMost(limit) => (None, check(value - limit, limit)),
            Sense::AtLeast(limit) => (None, check(limit - value, limit)),
            Sense::Equal(limit) => (None, check((value - limit).abs(), limit)),
        };
        Some(Verdict { goal, conditions })
    }
}

/// The amount by which the figure is above a limit. The smallest of several has no other slopes
/// than those of its piece.
fn upper<const N: usize>(pieces: &Pieces<N>, limit: f64) -> Vec<Piece<N>> {
    match pieces {
        Pieces::Largest(all) => all.iter().map(|piece| piece.times(1.0, -limit)).collect(),
        Pieces::Smallest(all) => smallest(all)
            .map(|piece| piece.times(1.0, -limit))
            .into_iter()
            .collect(),
    }
}

/// The amount by which the figure is below a limit.
fn lower<const N: usize>(pieces: &Pieces<N>, limit: f64) -> Vec<Piece<N>> {
    match pieces {
        Pieces::Smallest(all) => all.iter().map(|piece| piece.times(-1.0, limit)).collect(),
        Pieces::Largest(all) => largest(all)
            .map(|piece| piece.times(-1.0, limit))
            .into_iter()
            .collect(),
    }
}

fn smallest<const N: usize>(pieces: &[Piece<N>]) -> Option<&Piece<N>> {
    pieces.iter().min_by(|a, b| a.value.total_cmp(&b.value))
}

fn largest<const N: usize>(pieces: &[Piece<N>]) -> Option<&Piece<N>> {
    pieces.iter().max_by(|a, b| a.value.total_cmp(&b.value))
}
