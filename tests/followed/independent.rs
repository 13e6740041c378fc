//! Bodies on rods by nothing but Newton's method in many steps, with quaternions as orientations.

use nalgebra::{DMatrix, DVector, Matrix6, UnitQuaternion, Vector3, Vector6};

// A body on six rods, or on five rods and at a height, by nothing but Newton's method in many steps: six speeds of the body are unknown, and its
// orientation is a quaternion. The compiler's groups have nine unknowns or eight, and other equations.

/// Millimetres that count as much as a radian.
const RADIUS: f64 = 100.0;
/// A way is gone in so many steps at least; the largest change in a step, in radians, and the smallest step that is tried.
const STEPS: f64 = 100.0;
const LARGEST: f64 = 0.01;
const SHORTEST: f64 = 1e-10;

#[derive(Clone, Copy, Debug)]
pub(super) struct Pose {
    pub(super) p: Vector3<f64>,
    pub(super) turn: UnitQuaternion<f64>,
}

/// Joints in coordinates of the body and on the ground. Where there are five rods the height of the body counts as the sixth length.
#[derive(Clone, Debug)]
pub(super) struct Rods {
    pub(super) on_body: Vec<Vector3<f64>>,
    pub(super) on_ground: Vec<Vector3<f64>>,
}

impl Rods {
    fn along(&self, pose: &Pose) -> impl Iterator<Item = (Vector3<f64>, Vector3<f64>)> {
        let ends = self.on_body.iter().zip(&self.on_ground);
        ends.map(|(own, foot)| (pose.turn * own, pose.p + pose.turn * own - foot))
    }

    pub(super) fn lengths(&self, pose: &Pose) -> [f64; 6] {
        let mut lengths = [pose.p.z; 6];
        let rods = self.along(pose);
        rods.zip(&mut lengths)
            .for_each(|((_, rod), length)| *length = rod.norm());
        lengths
    }

    /// What the lengths do when the body moves: columns of ways in [`RADIUS`], then of turns.
    fn slopes(&self, pose: &Pose) -> Matrix6<f64> {
        let mut slopes = Matrix6::zeros();
        slopes[(5, 2)] = 1.0;
        for (row, (arm, rod)) in self.along(pose).enumerate() {
            let way = rod.normalize();
            let turn = arm.cross(&way) / RADIUS;
            let row_of = [way.x, way.y, way.z, turn.x, turn.y, turn.z];
            slopes.set_row(row, &Vector6::from(row_of).transpose());
        }
        slopes
    }

    /// Zero where the lengths do not hold the body.
    pub(super) fn hold(&self, pose: &Pose) -> f64 {
        self.slopes(pose).determinant()
    }

    /// The pose near this one with these lengths, if the body turns hardly and is held from the same side.
    fn near(&self, pose: &Pose, lengths: &[f64; 6], largest: f64) -> Option<Pose> {
        let mut here = *pose;
        let mut gone = 0.0;
        for _ in 0..12 {
            let off = Vector6::from(*lengths) - Vector6::from(self.lengths(&here));
            let step = self.slopes(&here).lu().solve(&(off / RADIUS))?;
            gone += step.norm();
            let is_small = gone <= largest;
            if !is_small {
                return None;
            }
            here.p += RADIUS * step.fixed_rows::<3>(0);
            let turn = Vector3::new(step[3], step[4], step[5]);
            here.turn = UnitQuaternion::new(turn) * here.turn;
            if step.norm() < 1e-14 {
                break;
            }
        }
        let settled = self.lengths(&here);
        let off = settled.iter().zip(lengths).map(|(a, b)| (a - b).abs());
        let is_there = off.fold(0.0, f64::max) < 1e-9;
        (is_there && self.hold(&here) * self.hold(pose) > 0.0).then_some(here)
    }

    /// Straight from the lengths of a pose to others, in steps that are `finer` times as short as usually.
    ///
    /// # Errors
    ///
    /// How far the way goes, and the pose there.
    pub(super) fn go(&self, from: &Pose, to: &[f64; 6], finer: f64) -> Result<Pose, (f64, Pose)> {
        let start = self.lengths(from);
        let (mut here, mut share, mut step) = (*from, 0.0, 1.0 / (STEPS * finer));
        while share < 1.0 {
            let next = f64::min(share + step, 1.0);
            let lengths = std::array::from_fn(|k| start[k] + (to[k] - start[k]) * next);
            match self.near(&here, &lengths, LARGEST / finer) {
                Some(there) => {
                    here = there;
                    share = next;
                    step = f64::min(2.0 * step, 1.0 / (STEPS * finer));
                }
                None if step < SHORTEST => return Err((share, here)),
                None => step *= 0.5,
            }
        }
        Ok(here)
    }

    /// What five rods miss by where their body, at its height, comes nearest to these lengths: by nothing but steepest descent.
    pub(super) fn nearest(&self, from: &Pose, lengths: &[f64; 6]) -> [f64; 5] {
        const RATE: f64 = 0.05;
        let mut here = *from;
        loop {
            let mut missed = Vector6::from(self.lengths(&here)) - Vector6::from(*lengths);
            missed[5] = 0.0;
            let mut steepest = self.slopes(&here).transpose() * (missed / RADIUS);
            steepest[2] = 0.0;
            if steepest.norm() < 1e-10 {
                return std::array::from_fn(|rod| missed[rod]);
            }
            here.p -= RATE * RADIUS * steepest.fixed_rows::<3>(0);
            let turn = Vector3::new(steepest[3], steepest[4], steepest[5]);
            here.turn = UnitQuaternion::new(-RATE * turn) * here.turn;
        }
    }
}

impl Pose {
    /// How far another pose is, in radians and [`RADIUS`].
    pub(super) fn away(&self, p: Vector3<f64>, x: Vector3<f64>, y: Vector3<f64>) -> f64 {
        let turned = (self.turn * Vector3::x() - x).norm() + (self.turn * Vector3::y() - y).norm();
        (self.p - p).norm() / RADIUS + turned
    }

    /// Shifted and turned at random.
    pub(super) fn moved(&self, random: &mut linkage_random::Random, way: f64, turn: f64) -> Self {
        let mut number = || random.between(-1.0, 1.0);
        let [shift, about] = [(); 2].map(|()| Vector3::new(number(), number(), number()));
        Self {
            p: self.p + way * shift,
            turn: UnitQuaternion::new(turn * about) * self.turn,
        }
    }
}

// Two bodies on rods by nothing but Newton's method in many steps: twelve speeds are unknown, and orientations are quaternions.

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
