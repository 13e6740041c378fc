//! Four-bars that syntheses find, and their passage of the given poses or points: circuit, branch
//! and order.

use super::Pose;
use core::f64::consts::{PI, TAU};
use std::vec::Vec;

/// A four-bar linkage: two fixed joints, and two joints of the coupler, which is the body that is
/// moved.
///
/// Link 0 joins `fixed[0]` and `moving[0]`, link 1 the other two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FourBar {
    /// The joints of the frame.
    pub fixed: [[f64; 2]; 2],
    /// The joints of the coupler, in its own frame.
    pub moving: [[f64; 2]; 2],
}

/// The links of a four-bar that turn fully (Grashof's condition).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GrashofType {
    /// This link (0 or 1) turns fully, the other one of the frame rocks.
    Crank(usize),
    /// Both links of the frame turn fully.
    DoubleCrank,
    /// Both links of the frame rock; the coupler turns fully against all others.
    DoubleRocker,
    /// No link turns fully against another one: one circuit only.
    TripleRocker,
}

/// The configuration of a four-bar in a pose.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Visit {
    /// The set of positions that can be reached without taking joints apart, 0 or 1; always 0 for
    /// [`GrashofType::TripleRocker`].
    pub circuit: usize,
    /// For either link as the driving one: on which side of its dead points, 0 or 1.
    pub branch: [usize; 2],
}

/// The passage of a four-bar through poses.
#[derive(Clone, Debug, PartialEq)]
pub struct Passage {
    /// Circuit and branches at each pose.
    pub visits: Vec<Visit>,
    /// True if all are on one circuit, and a turn in one of both directions meets them in their
    /// order.
    pub in_order: bool,
}

impl Passage {
    /// Returns whether the poses can be reached from each other without taking joints apart.
    #[must_use]
    pub fn one_circuit(&self) -> bool {
        let mut circuits = self.visits.iter().map(|visit| visit.circuit);
        let first = circuits.next();
        circuits.all(|circuit| Some(circuit) == first)
    }

    /// Returns whether the link (0 or 1) drives through all poses without meeting a dead point.
    #[must_use]
    pub fn one_branch(&self, link: usize) -> bool {
        let mut branches = self.visits.iter().map(|visit| visit.branch[link]);
        let first = branches.next();
        self.one_circuit() && branches.all(|branch| Some(branch) == first)
    }
}

impl FourBar {
    /// Lengths of the frame, of link 0, of the coupler and of link 1, measured in this pose.
    #[must_use]
    pub fn lengths(&self, pose: &Pose) -> [f64; 4] {
        let [left, coupler, right, frame] = self.sides(pose).map(|[x, y]| x.hypot(y));
        [frame, left, coupler, right]
    }

    /// Returns the links that turn fully. Rounding decides next to a change point.
    #[must_use]
    pub fn turning(&self, pose: &Pose) -> GrashofType {
        match self.shortest(pose) {
            None => GrashofType::TripleRocker,
            Some(0) => GrashofType::Crank(0),
            Some(1) => GrashofType::DoubleRocker,
            Some(2) => GrashofType::Crank(1),
            Some(_) => GrashofType::DoubleCrank,
        }
    }

    /// Returns the passage of the coupler through poses, each of which it must be able to take.
    #[must_use]
    pub fn passage(&self, poses: &[Pose]) -> Passage {
        let Some(first) = poses.first() else {
            let visits = Vec::new();
            return Passage {
                visits,
                in_order: true,
            };
        };
        let shortest = self.shortest(first);
        let mut places = Vec::new();
        let visits = poses.iter().map(|pose| {
            let sides = self.sides(pose);
            let bend =
                |joint: usize| usize::from(cross(sides[(joint + 3) % 4], sides[joint]) < 0.0);
            // Joints that the shortest link does not touch never stretch.
            let circuit = shortest.map_or(0, |shortest| bend((shortest + 2) % 4));
            places.push(match shortest {
                Some(shortest) => angle(sides[(shortest + 3) % 4], sides[shortest]),
                None => self.place_of_triple_rocker(pose, bend(2) == 0),
            });
            let branch = [bend(2), bend(1)];
            Visit { circuit, branch }
        });
        let mut passage = Passage {
            visits: visits.collect(),
            in_order: false,
        };
        passage.in_order = passage.one_circuit() && is_in_order(&places);
        passage
    }

    /// Vectors from joint to joint: link 0, coupler, link 1, frame. Side `i` begins at joint `i`.
    fn sides(&self, pose: &Pose) -> [[f64; 2]; 4] {
        let [a, b] = self.fixed;
        let [x, y] = self.moving.map(|joint| pose.place(joint));
        [[a, x], [x, y], [y, b], [b, a]].map(|[from, to]| [to[0] - from[0], to[1] - from[1]])
    }

    /// The shortest side, if it turns fully.
    fn shortest(&self, pose: &Pose) -> Option<usize> {
        let lengths = self.sides(pose).map(|[x, y]| x.hypot(y));
        let order = |a: &usize, b: &usize| lengths[*a].total_cmp(&lengths[*b]);
        let shortest = (0..4).min_by(order)?;
        let longest = (0..4).max_by(order)?;
        let all: f64 = lengths.iter().sum();
        let grashof = 2.0 * (lengths[shortest] + lengths[longest]) < all;
        grashof.then_some(shortest)
    }

    /// A number that grows along the circuit: the angle of link 0, forth on one branch and back on
    /// the other one.
    fn place_of_triple_rocker(&self, pose: &Pose, forth: bool) -> f64 {
        let [link, .., frame] = self.sides(pose);
        let [frame_length, left, coupler, right] = self.lengths(pose);
        // The angle from the line of the frame; the link swings about this line, to one of its
        // sides or the other.
        let angle = angle([-frame[0], -frame[1]], link);
        let about_frame = left + frame_length > coupler + right;
        let swing = if about_frame {
            wrapped(angle)
        } else {
            wrapped(angle - PI)
        };
        // Within (-pi, pi), and each circuit is a turn of 2 pi: half of it for each branch.
        let part = 0.5 * (swing + PI);
        if forth { part } else { TAU - part }
    }
}

/// Returns whether numbers modulo a turn ascend, or descend, once around.
fn is_in_order(places: &[f64]) -> bool {
    let turns = places.iter().map(|position| position.rem_euclid(TAU));
    let turns: Vec<f64> = turns.collect();
    let next = turns.iter().cycle().skip(1);
    let descents = turns
        .iter()
        .zip(next)
        .filter(|(here, next)| next < here)
        .count();
    turns.len() < 3 || descents == 1 || descents + 1 == turns.len()
}

fn wrapped(angle: f64) -> f64 {
    angle - TAU * (angle / TAU).round()
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// Angle from one vector to another.
fn angle(from: [f64; 2], to: [f64; 2]) -> f64 {
    cross(from, to).atan2(from[0] * to[0] + from[1] * to[1])
}
