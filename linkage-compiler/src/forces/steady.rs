//! What only numbers tell of the motion: joints that move at a steady rate, rods that keep their length.

use linkage_symbolic::{Ex, Vn};

use super::Mechanics;
use super::freedom::Way;
use super::geometry::{Turns, turns_of};
use super::motion::By;
use super::positions::{EQUAL, Positions, SLOW};

impl<'m> Mechanics<'_, 'm> {
    /// Looks at some positions; those that do not close count for nothing.
    pub(super) fn look_at_motion(&mut self, positions: &Positions) {
        for body in 0..self.algebra.mechanism.bodies.len() {
            for way in self.ways(body) {
                self.look_at_way(&way, positions);
            }
            if let Some(along) = self.forces.geometry.rod(body)
                && self.keeps_its_length(along, positions)
            {
                self.forces.rigid_rods.push(body);
            }
        }
    }

    /// Whether a body moves in its own joint, and at a steady rate.
    fn look_at_way(&mut self, way: &Way<'m>, positions: &Positions) {
        let drives = 0..self.drives();
        let rates: Vec<Ex> = drives
            .map(|input| self.relative_rate(way, By::Input(input)))
            .collect();
        let rates = positions.numbers(&rates);
        let moves = rates.iter().flatten().any(|rate| rate.abs() > EQUAL);
        let way = (way.body, way.slides);
        if moves && all_alike(&rates) {
            self.forces.steady.push(way);
        }
        if !moves && !rates.is_empty() && !self.hangs_freely(way.0) {
            self.forces.still.push(way);
        }
    }

    /// True if a body's own joint lets it turn in every way: which of them rest says nothing of the others.
    fn hangs_freely(&self, body: usize) -> bool {
        let mechanism = self.algebra.mechanism;
        let joint = &mechanism.joints[mechanism.bodies[body].joint];
        turns_of(joint.kind) == Turns::Freely
    }

    /// True if `(V^2)'` is nothing beside `V^2`.
    fn keeps_its_length(&mut self, along: Vn<'m>, positions: &Positions) -> bool {
        let square = along.square();
        let mut numbers = vec![square];
        numbers.extend((0..self.drives()).map(|input| self.slope(square, By::Input(input))));
        let keeps = |numbers: &Vec<f64>| {
            let (square, slopes) = (numbers[0], &numbers[1..]);
            slopes.iter().all(|slope| slope.abs() < EQUAL * square)
        };
        let numbers = positions.numbers(&numbers);
        !numbers.is_empty() && numbers.iter().all(keeps)
    }
}

/// True if there are several and they do not differ.
fn all_alike(rates: &[Vec<f64>]) -> bool {
    let Some((first, others)) = rates.split_first() else {
        return false;
    };
    let like = |(a, b): (&f64, &f64)| (a - b).abs() <= EQUAL * b.abs().max(SLOW);
    !others.is_empty() && others.iter().all(|rates| rates.iter().zip(first).all(like))
}
