//! The travels that files allow to motors.

use crate::document::Document;
use crate::driven_motions::DrivenMotion;

/// Returns a bound of a motion of motors, in radians from the drawing, or the nearer one that the
/// travels of its motors allow.
pub(super) fn limited(document: &Document, motion: &DrivenMotion, bound: f64) -> f64 {
    let followers = motion.followers.iter().copied();
    let motors = followers.chain([(motion.leader, 1.0)]);
    let sense = bound.signum();
    let allowed = motors.filter_map(|(input, ratio)| {
        let ends = document.inputs[input].travel?;
        let ways = ends.map(|end| sense * end.to_radians() / ratio);
        // A travel that begins beyond the drawing leaves no way back.
        Some(ways[0].max(ways[1]).max(0.0))
    });
    sense * allowed.fold(bound.abs(), f64::min)
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{PI, TAU};

    use super::*;
    use crate::document::{FRAME, Input, InputKind, LengthUnit};

    fn document(travels: &[Option<[f64; 2]>]) -> Document {
        let mut document = Document::new("a test", LengthUnit::Millimetre);
        let inputs = travels.iter().enumerate().map(|(link, travel)| Input {
            kind: InputKind::Crank {
                link,
                pivot: link,
                base: FRAME,
            },
            travel: *travel,
            speed: None,
            rate: None,
        });
        document.inputs = inputs.collect();
        document
    }

    fn range(travels: &[Option<[f64; 2]>], followers: &[(usize, f64)]) -> [f64; 2] {
        let motion = DrivenMotion {
            leader: 0,
            followers: followers.to_vec(),
            turns: 1,
        };
        [-TAU, TAU].map(|bound| limited(&document(travels), &motion, bound))
    }

    #[test]
    fn a_motor_moves_within_its_travel() {
        assert_eq!(range(&[None], &[]), [-TAU, TAU]);
        assert_eq!(range(&[Some([-90.0, 180.0])], &[]), [-0.5 * PI, PI]);
        assert_eq!(range(&[Some([90.0, 180.0])], &[]), [-0.0, PI]);
        assert_eq!(range(&[Some([-720.0, 720.0])], &[]), [-TAU, TAU]);
    }

    #[test]
    fn travels_of_motors_that_run_along_count() {
        let travels = [Some([-90.0, 180.0]), Some([-90.0, 180.0])];
        assert_eq!(range(&travels, &[(1, -1.0)]), [-0.5 * PI, 0.5 * PI]);
        assert_eq!(range(&travels, &[(1, 2.0)]), [-0.25 * PI, 0.5 * PI]);
    }
}
