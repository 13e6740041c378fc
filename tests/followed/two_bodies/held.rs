//! Two bodies on rods by nothing but Newton's method in many steps: twelve speeds are unknown, and orientations are quaternions.

use nalgebra::{DMatrix, DVector, UnitQuaternion, Vector3};

use crate::independent::Pose;

/// Millimetres that count as much as a radian.
const RADIUS: f64 = 100.0;

/// Where less than this is left of the determinant at the reference, a dead point is near.
const DEAD: f64 = 0.2;

/// Where a rod ends: on the ground, or on a body at a place of its own.
#[derive(Clone, Copy)]
pub(super) enum End {
    Ground(Vector3<f64>),
    On(usize, Vector3<f64>),
}

/// The rods of both bodies; the height of the first one is given, too.
pub(super) struct Held {
    pub(super) rods: Vec<[End; 2]>,
}

impl Held {
    /// What each rod reaches over.
    fn vectors(&self, poses: &[Pose; 2]) -> Vec<Vector3<f64>> {
        let place = |end| match end {
            End::Ground(place) => place,
            End::On(body, own) => {
                let pose: &Pose = &poses[body];
                pose.p + pose.turn * own
            }
        };
        let ends = self.rods.iter();
        ends.map(|&[from, to]| place(from) - place(to)).collect()
    }

    pub(super) fn lengths(&self, poses: &[Pose; 2]) -> Vec<f64> {
        let vectors = self.vectors(poses).into_iter();
        vectors.map(|vector| vector.norm()).collect()
    }

    /// What the lengths, and then the height, do when the bodies move: for each body ways in [`RADIUS`], then turns.
    fn slopes(&self, poses: &[Pose; 2]) -> DMatrix<f64> {
        let mut slopes = DMatrix::zeros(12, 12);
        for (row, (ends, vector)) in self.rods.iter().zip(self.vectors(poses)).enumerate() {
            for (end, way) in ends.iter().zip([vector.normalize(), -vector.normalize()]) {
                if let &End::On(body, own) = end {
                    let turn = (poses[body].turn * own).cross(&way) / RADIUS;
                    for k in 0..3 {
                        slopes[(row, 6 * body + k)] = way[k];
                        slopes[(row, 6 * body + 3 + k)] = turn[k];
                    }
                }
            }
        }
        slopes[(11, 2)] = 1.0;
        slopes
    }

    /// Where the bodies are for these lengths and this height, near where they are.
    pub(super) fn near(
        &self,
        poses: &[Pose; 2],
        lengths: &[f64],
        height: f64,
    ) -> Option<[Pose; 2]> {
        let mut here = *poses;
        for _ in 0..12 {
            let missed = self.lengths(&here);
            let missed = lengths
                .iter()
                .zip(&missed)
                .map(|(wanted, own)| wanted - own);
            let missed: Vec<f64> = missed.chain([height - here[0].p.z]).collect();
            let way = self
                .slopes(&here)
                .lu()
                .solve(&(DVector::from(missed) / RADIUS))?;
            for (body, pose) in here.iter_mut().enumerate() {
                let own = |k: usize| way[6 * body + k];
                pose.p += RADIUS * Vector3::new(own(0), own(1), own(2));
                pose.turn = UnitQuaternion::new(Vector3::new(own(3), own(4), own(5))) * pose.turn;
            }
            if way.norm() > 0.05 {
                return None;
            }
            if way.norm() < 1e-14 {
                break;
            }
        }
        Some(here)
    }

    /// Where the bodies are after the first one has moved by `travel`, and whether they are held from the same side, and well, all the way.
    pub(super) fn go(&self, poses: &[Pose; 2], travel: f64) -> Option<[Pose; 2]> {
        let (lengths, height) = (self.lengths(poses), poses[0].p.z);
        let hold = self.slopes(poses).determinant();
        let mut here = *poses;
        for step in 1..=40 {
            here = self.near(&here, &lengths, height + travel * f64::from(step) / 40.0)?;
            let still = self.slopes(&here).determinant() / hold;
            if still < DEAD {
                return None;
            }
        }
        Some(here)
    }
}
