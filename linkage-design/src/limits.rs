//! Bounds and linear relations of the variables.

use std::vec;
use std::vec::Vec;

use super::quadratic::{Face, Quadratic};

/// A linear relation: a sum of variables, each times a factor, is at most `most`, or exactly that.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Linear {
    pub(crate) terms: Vec<(usize, f64)>,
    pub(crate) most: f64,
    pub(crate) equality: bool,
}

impl Linear {
    /// Returns the distance to the limit.
    pub(crate) fn slack(&self, x: &[f64]) -> f64 {
        self.most - self.terms.iter().map(|&(j, a)| a * x[j]).sum::<f64>()
    }

    /// Returns true if it holds except for rounding.
    fn holds(&self, x: &[f64]) -> bool {
        let slack = self.slack(x);
        let least = -HOLDS * self.scale(x);
        slack >= least && (!self.equality || slack <= -least)
    }

    /// Returns true if it has nothing to spare and is no equality, which never has.
    pub(crate) fn is_active(&self, x: &[f64]) -> bool {
        !self.equality && self.slack(x) <= ACTIVE * self.scale(x)
    }

    /// Returns the size of the terms, for rounding.
    fn scale(&self, x: &[f64]) -> f64 {
        let parts: f64 = self.terms.iter().map(|&(j, a)| (a * x[j]).abs()).sum();
        parts.max(self.most.abs())
    }
}

/// A relation that is violated by less than this part of its terms holds: they are sums of rounded
/// numbers.
const HOLDS: f64 = 1e-11;

/// One with less to spare than this part of them is in the way: steps end on it except for
/// rounding.
const ACTIVE: f64 = 1e-9;

/// The region of the variables.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Limits {
    pub(crate) lower: Vec<f64>,
    pub(crate) upper: Vec<f64>,
    pub(crate) relations: Vec<Linear>,
}

impl Limits {
    pub(crate) fn len(&self) -> usize {
        self.lower.len()
    }

    /// Into the bounds.
    pub(crate) fn clamp(&self, x: &mut [f64]) {
        for ((x, low), high) in x.iter_mut().zip(&self.lower).zip(&self.upper) {
            *x = x.clamp(*low, *high);
        }
    }

    /// Returns true if bounds and relations hold.
    pub(crate) fn hold(&self, x: &[f64]) -> bool {
        self.bound(x) && self.relations.iter().all(|relation| relation.holds(x))
    }

    /// Returns the miss of the worst relation beyond rounding; `None` if all hold.
    pub(crate) fn missed(&self, x: &[f64]) -> Option<f64> {
        let missed = |relation: &Linear| {
            let slack = relation.slack(x);
            let by = if relation.equality {
                slack.abs()
            } else {
                -slack
            };
            (by > ACTIVE * relation.scale(x)).then_some(by)
        };
        self.relations.iter().filter_map(missed).reduce(f64::max)
    }

    /// Returns the relation that is missed most, by its number, and the size of the miss, unless it
    /// is a part of its terms or of the effect of the bounds' widths.
    pub(crate) fn worst(&self, x: &[f64]) -> Option<(usize, f64)> {
        let missed = |(k, relation): (usize, &Linear)| {
            let slack = relation.slack(x);
            let by = if relation.equality {
                slack.abs()
            } else {
                -slack
            };
            let width = |&(j, a): &(usize, f64)| (a * (self.upper[j] - self.lower[j])).abs();
            let widths: f64 = relation.terms.iter().map(width).sum();
            let holds = by <= ACTIVE * relation.scale(x).max(widths);
            (!holds).then_some((k, by))
        };
        let missed = self.relations.iter().enumerate().filter_map(missed);
        missed.max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// Returns true if all variables are within their bounds.
    pub(crate) fn bound(&self, x: &[f64]) -> bool {
        let within = |(x, (low, high)): (&f64, (&f64, &f64))| (low..=high).contains(&x);
        x.iter().zip(self.lower.iter().zip(&self.upper)).all(within)
    }

    /// The numbers of the relations that do not hold.
    pub(crate) fn broken(&self, x: &[f64]) -> Vec<usize> {
        let relations = self.relations.iter().enumerate();
        let broken = relations.filter(|(_, relation)| !relation.holds(x));
        broken.map(|(k, _)| k).collect()
    }

    /// The limits as faces for a step from `x`: bounds first, of which it gives the number, then
    /// relations.
    pub(crate) fn faces(&self, x: &[f64]) -> (Vec<Face>, usize) {
        let face = |normal, slack, equality| Face {
            normal,
            slack,
            equality,
        };
        let mut faces = Vec::new();
        for (j, x) in x.iter().enumerate() {
            let sides = [(1.0, x - self.lower[j]), (-1.0, self.upper[j] - x)];
            let finite = sides.into_iter().filter(|(_, slack)| slack.is_finite());
            faces.extend(finite.map(|(a, slack)| face(vec![(j, a)], slack, false)));
        }
        let bounds = faces.len();
        for relation in &self.relations {
            let normal = relation.terms.iter().map(|&(j, a)| (j, -a)).collect();
            faces.push(face(normal, relation.slack(x), relation.equality));
        }
        (faces, bounds)
    }

    /// Changes the slacks of faces that [`faces`](Self::faces) made to those for a step from `x`.
    pub(crate) fn put_slacks(&self, x: &[f64], faces: &mut [Face]) {
        let mut faces = faces.iter_mut();
        let mut put = |slack: f64| {
            if let Some(face) = faces.next() {
                face.slack = slack;
            }
        };
        for ((x, low), high) in x.iter().zip(&self.lower).zip(&self.upper) {
            let sides = [x - low, high - x].into_iter();
            sides.filter(|slack| slack.is_finite()).for_each(&mut put);
        }
        for relation in &self.relations {
            put(relation.slack(x));
        }
    }

    /// The place itself, or with equalities the nearest one at which these hold; `None` if there is
    /// none.
    pub(crate) fn on_equalities(&self, x: Vec<f64>) -> Option<Vec<f64>> {
        let equalities = self.relations.iter().filter(|relation| relation.equality);
        let relations: Vec<Linear> = equalities.cloned().collect();
        match relations.is_empty() {
            true => Some(x),
            false => Self {
                relations,
                ..self.clone()
            }
            .nearest(&x),
        }
    }

    /// The nearest place at which all hold, in the measure of the bounds' widths; `None` if there
    /// is none.
    pub(crate) fn nearest(&self, x: &[f64]) -> Option<Vec<f64>> {
        let mut near = x.to_vec();
        self.clamp(&mut near);
        if self.hold(&near) {
            return Some(near);
        }
        let n = self.len();
        let mut gram = vec![0.0; n * n];
        for j in 0..n {
            let width = self.upper[j] - self.lower[j];
            let width = if width > 0.0 && width.is_finite() {
                width
            } else {
                1.0
            };
            gram[j * n + j] = 1.0 / (width * width);
        }
        let (faces, _) = self.faces(&near);
        let mut program = Quadratic::default();
        if !program.solve(&gram, &vec![0.0; n], &faces) {
            return None;
        }
        near.iter_mut().zip(&program.d).for_each(|(x, d)| *x += d);
        self.clamp(&mut near);
        self.hold(&near).then_some(near)
    }
}
