//! Small strictly convex quadratic programs: Goldfarb and Idnani's dual method.
//!
//! It starts from the free minimum and adds violated faces one by one, so that a step of which few
//! bounds are active costs little more than a factorisation. Source: D. Goldfarb, A. Idnani, "A
//! numerically stable dual method for solving strictly convex quadratic programs", Mathematical
//! Programming 27 (1983).

mod factor;
#[cfg(test)]
mod tests;

use factor::Factor;
use linkage_core::numeric::vector::dot;
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
    /// Cholesky's factor `L` of `G`.
    factor: Factor,
    /// The minimum.
    pub(crate) d: Vec<f64>,
    /// The active faces.
    pub(crate) active: Vec<usize>,
    /// Their multipliers.
    pub(crate) multipliers: Vec<f64>,
    /// `L^-1 normal` of the active faces, `n` numbers of each.
    images: Vec<f64>,
    /// An orthonormal basis of the images, and its coordinates of each: `n` numbers of each, those
    /// of later vectors are zero.
    basis: Vec<f64>,
    triangle: Vec<f64>,
    scratch: Scratch,
}

/// A vector in the basis, with what is computed from it.
#[derive(Clone, Debug, Default)]
struct Scratch {
    image: Vec<f64>,
    coordinates: Vec<f64>,
    /// The part of the image beside the basis.
    rest: Vec<f64>,
    duals: Vec<f64>,
    direction: Vec<f64>,
}

impl Quadratic {
    /// Solves it for the lower triangle of `G`, row by row; `false` if `G` is not positive definite
    /// or the faces leave nothing.
    pub(crate) fn solve(&mut self, gram: &[f64], gradient: &[f64], faces: &[Face]) -> bool {
        self.n = gradient.len();
        if !self.factor.compute(gram, self.n) {
            return false;
        }
        self.d.clear();
        self.d.extend(gradient.iter().map(|g| -g));
        self.factor.forward(&mut self.d, 0);
        self.factor.backward(&mut self.d);
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
        let mut scratch = core::mem::take(&mut self.scratch);
        let reached = self.go_to(faces, k, &mut scratch);
        self.scratch = scratch;
        reached
    }

    fn go_to(&mut self, faces: &[Face], k: usize, scratch: &mut Scratch) -> bool {
        let face = &faces[k];
        let value = face.value(&self.d);
        // An equality is approached from the side where it is negative.
        let sign = if face.equality && value > 0.0 {
            -1.0
        } else {
            1.0
        };
        self.image(face, sign, &mut scratch.image);
        let size = dot(&scratch.image, &scratch.image);
        let mut multiplier = 0.0;
        loop {
            scratch.split(&self.basis);
            self.duals(&scratch.coordinates, &mut scratch.duals);
            let left = dot(&scratch.rest, &scratch.rest);
            let full = match left > DEPENDENT * DEPENDENT * size {
                true => (-sign * face.value(&self.d)).max(0.0) / left,
                false => f64::INFINITY,
            };
            let (partial, leaving) = self.first_to_leave(faces, &scratch.duals);
            if full.is_infinite() && leaving.is_none() {
                // An equality that others imply and that holds is no contradiction.
                return face.equality
                    && full.is_infinite()
                    && face.value(&self.d).abs() <= 1e-9 * self.scale(face);
            }
            let step = full.min(partial);
            for (multiplier, dual) in self.multipliers.iter_mut().zip(&scratch.duals) {
                *multiplier -= step * dual;
            }
            multiplier += step;
            if full.is_finite() {
                let direction = &mut scratch.direction;
                direction.clone_from(&scratch.rest);
                self.factor.backward(direction);
                for (d, z) in self.d.iter_mut().zip(direction) {
                    *d += step * *z;
                }
            }
            if full <= partial {
                self.active.push(k);
                self.multipliers.push(multiplier);
                self.images.extend_from_slice(&scratch.image);
                self.extend_basis(scratch);
                return true;
            }
            if let Some(position) = leaving {
                self.remove(position, scratch);
            }
        }
    }

    /// `L^-1` times the normal of a face with a sign.
    fn image(&self, face: &Face, sign: f64, image: &mut Vec<f64>) {
        image.clear();
        image.resize(self.n, 0.0);
        let mut from = self.n;
        for &(j, a) in &face.normal {
            image[j] = sign * a;
            from = from.min(j);
        }
        self.factor.forward(image, from);
    }

    fn scale(&self, face: &Face) -> f64 {
        let parts: f64 = face
            .normal
            .iter()
            .map(|&(j, a)| (a * self.d[j]).abs())
            .sum();
        parts + face.slack.abs() + f64::MIN_POSITIVE
    }

    /// Returns the effect of a step on the multipliers: the triangle solved for the coordinates.
    fn duals(&self, coordinates: &[f64], duals: &mut Vec<f64>) {
        duals.clear();
        duals.extend_from_slice(coordinates);
        let at = |row: usize, column: usize| self.triangle[column * self.n + row];
        for i in (0..duals.len()).rev() {
            let later: f64 = (i + 1..duals.len()).map(|j| at(i, j) * duals[j]).sum();
            duals[i] = (duals[i] - later) / at(i, i);
        }
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

    /// Adds the vector of an image that has been split.
    fn extend_basis(&mut self, split: &Scratch) {
        let length = dot(&split.rest, &split.rest).sqrt();
        self.basis.extend(split.rest.iter().map(|x| x / length));
        self.triangle.extend_from_slice(&split.coordinates);
        self.triangle.push(length);
        self.triangle.resize(self.basis.len(), 0.0);
    }

    /// Removes an active face. The scratch keeps its image.
    fn remove(&mut self, position: usize, scratch: &mut Scratch) {
        self.active.remove(position);
        self.multipliers.remove(position);
        let first = position * self.n;
        self.images.drain(first..first + self.n);
        // Those before it do not depend on it.
        self.basis.truncate(first);
        self.triangle.truncate(first);
        let image = core::mem::take(&mut scratch.image);
        for later in position..self.active.len() {
            scratch.image.clear();
            let later = &self.images[later * self.n..][..self.n];
            scratch.image.extend_from_slice(later);
            scratch.split(&self.basis);
            self.extend_basis(scratch);
        }
        scratch.image = image;
    }
}

impl Scratch {
    /// Splits the image into its coordinates in a basis and the rest; twice, because once loses
    /// digits.
    fn split(&mut self, basis: &[f64]) {
        let n = self.image.len().max(1);
        self.rest.clone_from(&self.image);
        self.coordinates.clear();
        self.coordinates.resize(basis.len() / n, 0.0);
        for _ in 0..2 {
            for (coordinate, q) in self.coordinates.iter_mut().zip(basis.chunks_exact(n)) {
                let part = dot(&self.rest, q);
                *coordinate += part;
                for (r, q) in self.rest.iter_mut().zip(q) {
                    *r -= part * q;
                }
            }
        }
    }
}
