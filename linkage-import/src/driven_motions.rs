//! Motors that run together: the angles of all follow from that of the slowest one.

use crate::document::{Document, InputKind};

/// More turns of the slowest motor are no period that a user expects.
const MOST_TURNS: u32 = 24;

/// A turn of the slowest motor is a period if all motors are this close to whole turns.
const WHOLE: f64 = 1e-9;

/// A motion of the drawing that one number describes: the change of an input.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct DrivenMotion {
    /// The input, as an index.
    pub(crate) leader: usize,
    /// Other inputs that move with it, and their changes as parts of its change.
    pub(crate) followers: Vec<(usize, f64)>,
    /// The turns of the input after which all motors are back.
    pub(crate) turns: u32,
}

/// Returns the motions of the inputs: one for all motors with a speed, and one for each other input.
pub(crate) fn driven_motions(document: &Document) -> Vec<DrivenMotion> {
    let rates: Vec<Option<f64>> = document
        .inputs
        .iter()
        .map(|input| match input.kind {
            InputKind::Crank { .. } => input.rate.filter(|rate| *rate != 0.0 && rate.is_finite()),
            InputKind::Length { .. } | InputKind::Position { .. } => None,
        })
        .collect();
    let rated = rates.iter().enumerate();
    let rated = rated.filter_map(|(index, rate)| Some((index, (*rate)?)));
    let slowest = rated.clone().min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    let motion = |leader: usize| {
        let followers: Vec<(usize, f64)> = match slowest {
            Some((slowest, rate)) if slowest == leader => rated
                .clone()
                .filter(|(index, _)| *index != leader)
                .map(|(index, other)| (index, other / rate))
                .collect(),
            _ => Vec::new(),
        };
        DrivenMotion {
            leader,
            turns: turns(&followers),
            followers,
        }
    };
    let leads = |index: &usize| match slowest {
        Some((slowest, _)) => rates[*index].is_none() || *index == slowest,
        None => true,
    };
    (0..rates.len()).filter(leads).map(motion).collect()
}

/// Returns the least number of turns after which all followers have made whole turns, or one.
fn turns(followers: &[(usize, f64)]) -> u32 {
    let is_period = |turns: &u32| {
        followers.iter().all(|(_, ratio)| {
            let turned = ratio * f64::from(*turns);
            (turned - turned.round()).abs() < WHOLE
        })
    };
    (1..=MOST_TURNS).find(is_period).unwrap_or(1)
}

/// Returns the change of each input for the changes of the leaders.
pub(crate) fn spread(motions: &[DrivenMotion], values: &[f64]) -> Vec<f64> {
    let followers = motions.iter().map(|motion| motion.followers.len());
    let mut spread = vec![0.0; motions.len() + followers.sum::<usize>()];
    for (motion, value) in motions.iter().zip(values) {
        spread[motion.leader] = *value;
        for (follower, ratio) in &motion.followers {
            spread[*follower] = ratio * value;
        }
    }
    spread
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::{FRAME, Input, LengthUnit};

    fn document(rates: &[Option<f64>]) -> Document {
        let mut document = Document::new("a test", LengthUnit::Millimetre);
        document.inputs = rates
            .iter()
            .enumerate()
            .map(|(link, rate)| Input {
                kind: InputKind::Crank {
                    link,
                    pivot: link,
                    base: FRAME,
                },
                travel: None,
                speed: None,
                rate: *rate,
            })
            .collect();
        document
    }

    #[test]
    fn the_slowest_motor_leads() {
        let found = driven_motions(&document(&[Some(90.0), None, Some(-60.0), Some(0.0)]));
        let leaders: Vec<usize> = found.iter().map(|motion| motion.leader).collect();
        assert_eq!(leaders, [1, 2, 3]);
        assert_eq!(found[1].followers, [(0, -1.5)]);
        assert_eq!(found[1].turns, 2);
        assert_eq!(spread(&found, &[7.0, 2.0, 5.0]), [-3.0, 7.0, 2.0, 5.0]);
    }

    #[test]
    fn motors_without_a_common_period_turn_once() {
        let found = driven_motions(&document(&[Some(1.0), Some(std::f64::consts::SQRT_2)]));
        assert_eq!((found.len(), found[0].turns), (1, 1));
    }
}
