//! Small strictly convex quadratic programs: Goldfarb and Idnani's dual method.
//!
//! It starts from the free minimum and adds violated faces one by one, so that a step of which few
//! bounds are active costs little more than a factorisation. Source: D. Goldfarb, A. Idnani, "A
//! numerically stable dual method for solving strictly convex quadratic programs", Mathematical
//! Programming 27 (1983).

use linkage_core::numeric::cholesky::{factor, forward};
use linkage_core::numeric::vector::dot;
use std::vec;
use std::vec::Vec;

/// A half space `normal . d + slack >= 0`, or with `equality` the plane itself.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Face {
    /// Places and values of the normal that are not zero.
    pub(crate) normal: Vec<(usize, f64)>,
    /// The distance of the origin on the inner side.
    pub(crate) slack: f64,
    /// True if the minimum must be on the plane.
    pub(crate) equality: bool,
}

impl Face {
    fn value(&self, d: &[f64]) -> f64 {
        self.slack + self.normal.iter().map(|&(j, a)| a * d[j]).sum::<f64>()
    }
}

/// A face holds that is violated by less than this part of the terms of its value: some hundred
/// roundoffs.
const HOLDS: f64 = 1e-13;
/// A normal of which less than this part is left outside of the active ones depends on them.
const DEPENDENT: f64 = 1e-11;
/// Faces that are added before the search is given up, for each variable and face: cycles come from
/// rounding alone.
const TURNS: usize = 4;

/// `minimum of 1/2 d'Gd + g'd` within faces, with the memory to solve it again without allocating.
#[derive(Clone, Debug, Default)]
pub(crate) struct Quadratic {
    n: usize,
    /// Lower triangle of Cholesky's factor of `G`, row by row.
    factor: Vec<f64>,
    /// The minimum.
    pub(crate) d: Vec<f64>,
    /// The active faces.
    pub(crate) active: Vec<usize>,
    /// Their multipliers.
    pub(crate) multipliers: Vec<f64>,
    /// `L^-1 normal` of the active faces.
    images: Vec<Vec<f64>>,
    /// An orthonormal basis of the images, and its coordinates of each.
    basis: Vec<Vec<f64>>,
    triangle: Vec<Vec<f64>>,
}

impl Quadratic {
    /// Solves it for the lower triangle of `G`, row by row; `false` if `G` is not positive definite
    /// or the faces leave nothing.
    pub(crate) fn solve(&mut self, gram: &[f64], gradient: &[f64], faces: &[Face]) -> bool {
        self.n = gradient.len();
        if !self.factorise(gram) {
            return false;
        }
        self.d.clear();
        self.d.extend(gradient.iter().map(|g| -g));
        forward(&self.factor, &mut self.d);
        backward(&self.factor, self.n, &mut self.d);
        self.active.clear();
        self.multipliers.clear();
        self.images.clear();
        self.basis.clear();
        self.triangle.clear();
        let equalities = (0..faces.len()).filter(|&k| faces[k].equality);
        for k in equalities {
            if !self.add(faces, k) {
                return false;
            }
        }
        for _ in 0..TURNS * (self.n + faces.len()) {
            match self.most_violated(gram, faces) {
                None => return true,
                Some(k) => {
                    if !self.add(faces, k) {
                        return false;
                    }
                }
            }
        }
        false
    }

    fn factorise(&mut self, gram: &[f64]) -> bool {
        self.factor.clear();
        self.factor.extend_from_slice(gram);
        let positive = |_, rest: f64| (rest > 0.0 && rest.is_finite()).then_some(rest);
        factor(&mut self.factor, self.n, positive).is_some()
    }

    /// The face that is violated most, in the measure of `G`'s diagonal, which has no units.
    fn most_violated(&self, gram: &[f64], faces: &[Face]) -> Option<usize> {
        let mut worst = None;
        let mut depth = 0.0;
        for (k, face) in faces.iter().enumerate() {
            let value = face.value(&self.d);
            if value >= 0.0 || self.active.contains(&k) {
                continue;
            }
            let parts: f64 = face
                .normal
                .iter()
                .map(|&(j, a)| (a * self.d[j]).abs())
                .sum();
            if -value <= HOLDS * (parts + face.slack.abs()) {
                continue;
            }
            let weight = |&(j, a): &(usize, f64)| a * a / gram[j * self.n + j];
            let size: f64 = face.normal.iter().map(weight).sum();
            let violation = -value / size.sqrt();
            if violation > depth {
                (worst, depth) = (Some(k), violation);
            }
        }
        worst
    }

    /// Goes to the face `k`, and lets go of active faces whose multiplier vanishes on the way.
    fn add(&mut self, faces: &[Face], k: usize) -> bool {
        let face = &faces[k];
        let value = face.value(&self.d);
        // An equality is approached from the side where it is negative.
        let sign = if face.equality && value > 0.0 {
            -1.0
        } else {
            1.0
        };
        let mut image = vec![0.0; self.n];
        for &(j, a) in &face.normal {
            image[j] = sign * a;
        }
        forward(&self.factor, &mut image);
        let size = dot(&image, &image);
        let mut multiplier = 0.0;
        loop {
            let (coordinates, mut rest) = self.split(&image);
            let duals = self.duals(&coordinates);
            let left = dot(&rest, &rest);
            let full = match left > DEPENDENT * DEPENDENT * size {
                true => (-sign * face.value(&self.d)).max(0.0) / left,
                false => f64::INFINITY,
            };
            let (partial, leaving) = self.first_to_leave(faces, &duals);
            if full.is_infinite() && leaving.is_none() {
                // An equality that others imply and that holds is no contradiction.
                return face.equality
                    && full.is_infinite()
                    && face.value(&self.d).abs() <= 1e-9 * self.scale(face);
            }
            let step = full.min(partial);
            for (multiplier, dual) in self.multipliers.iter_mut().zip(&duals) {
                *multiplier -= step * dual;
            }
            multiplier += step;
            if full.is_finite() {
                backward(&self.factor, self.n, &mut rest);
                for (d, z) in self.d.iter_mut().zip(&rest) {
                    *d += step * z;
                }
            }
            if full <= partial {
                self.active.push(k);
                self.multipliers.push(multiplier);
                self.images.push(image);
                self.triangle.push(coordinates);
                let (_, rest) = self.split(&self.images[self.images.len() - 1]);
                let length = dot(&rest, &rest).sqrt();
                self.basis.push(rest.iter().map(|x| x / length).collect());
                if let Some(column) = self.triangle.last_mut() {
                    column.push(length);
                }
                return true;
            }
            if let Some(position) = leaving {
                self.remove(position);
            }
        }
    }

    fn scale(&self, face: &Face) -> f64 {
        let parts: f64 = face
            .normal
            .iter()
            .map(|&(j, a)| (a * self.d[j]).abs())
            .sum();
        parts + face.slack.abs() + f64::MIN_POSITIVE
    }

    /// Coordinates in the basis, and the rest; twice, because once loses digits.
    fn split(&self, image: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let mut rest = image.to_vec();
        let mut coordinates = vec![0.0; self.basis.len()];
        for _ in 0..2 {
            for (coordinate, q) in coordinates.iter_mut().zip(&self.basis) {
                let part = dot(&rest, q);
                *coordinate += part;
                for (r, q) in rest.iter_mut().zip(q) {
                    *r -= part * q;
                }
            }
        }
        (coordinates, rest)
    }

    /// Returns the effect of a step on the multipliers: the triangle solved for the coordinates.
    fn duals(&self, coordinates: &[f64]) -> Vec<f64> {
        let mut r = coordinates.to_vec();
        for i in (0..r.len()).rev() {
            let later: f64 = (i + 1..r.len()).map(|j| self.triangle[j][i] * r[j]).sum();
            r[i] = (r[i] - later) / self.triangle[i][i];
        }
        r
    }

    fn first_to_leave(&self, faces: &[Face], duals: &[f64]) -> (f64, Option<usize>) {
        let mut first = (f64::INFINITY, None);
        for (position, dual) in duals.iter().enumerate() {
            if *dual > 0.0 && !faces[self.active[position]].equality {
                let step = self.multipliers[position].max(0.0) / dual;
                if step < first.0 {
                    first = (step, Some(position));
                }
            }
        }
        first
    }

    fn remove(&mut self, position: usize) {
        self.active.remove(position);
        self.multipliers.remove(position);
        let images = {
            self.images.remove(position);
            core::mem::take(&mut self.images)
        };
        self.basis.clear();
        self.triangle.clear();
        for image in &images {
            let (mut coordinates, rest) = self.split(image);
            let length = dot(&rest, &rest).sqrt();
            coordinates.push(length);
            self.triangle.push(coordinates);
            self.basis.push(rest.iter().map(|x| x / length).collect());
        }
        self.images = images;
    }
}

/// Solves `L' x = right` in place.
fn backward(l: &[f64], n: usize, x: &mut [f64]) {
    for i in (0..n).rev() {
        x[i] /= l[i * n + i];
        let known = x[i];
        for j in 0..i {
            x[j] -= l[i * n + j] * known;
        }
    }
}

#[cfg(test)]
mod tests;
