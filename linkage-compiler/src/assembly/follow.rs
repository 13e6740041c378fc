//! Following angles whose values are used over the ranges of the inputs.

use std::f64::consts::PI;

use linkage_core::numeric::winding::{Centre, follow};
use linkage_symbolic::program::{Program, Ternary};

use crate::algebra::{Algebra, Nominal, constant_ratio};
use crate::machine::{Machine, followed_range};

use super::ranges::Grid;

/// An angle this near to half a turn from its guide cannot be distinguished from one on the other
/// side.
const LIMIT: f64 = 0.98 * PI;

/// An angle that strays over the range of an input, by their numbers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Unfollowed {
    pub(super) angle: usize,
    pub(super) input: usize,
}

/// Finds centres and windings of angles whose values are used; each comes with the output of its
/// cosine. Returns the first angle that cannot be followed.
pub(super) fn follow_angles(
    algebra: &Algebra,
    nominal: &Nominal,
    machine: &mut Machine,
    angles: &[(usize, usize)],
) -> Option<Unfollowed> {
    angles.iter().find_map(|&(angle, output)| {
        let direction = machine.part([output, output + 1]);
        let mut numbers = Numbers {
            nominal,
            machine,
            direction,
        };
        numbers.follow(algebra, angle)
    })
}

/// The mechanism on numbers, with the program that computes cosine and sine of one angle.
struct Numbers<'a> {
    nominal: &'a Nominal,
    machine: &'a mut Machine,
    direction: Program,
}

impl Numbers<'_> {
    /// Finds centre and windings of an angle, unless it cannot be followed.
    fn follow(&mut self, algebra: &Algebra, angle: usize) -> Option<Unfollowed> {
        let inputs = self.nominal.inputs.len();
        let estimate = algebra.names.angles[angle].estimate(self.nominal);
        let here = self.angle(&self.nominal.inputs, estimate);
        let mut centre = Centre::new(here);
        for input in 0..inputs {
            let (low, high) = followed_range(algebra, self.nominal, input);
            let at = self.nominal.inputs[input];
            if low == high {
                continue;
            }
            let rates = constant_ratio::candidate_rates(&algebra.names, input);
            let mut position = self.nominal.inputs.clone();
            let mut direction = self.machine.staged(&self.direction);
            let found = follow(low, high, at, here, &rates, |x| {
                position[input] = x;
                self.machine.run_staged(&mut direction, &position);
                [direction.output(0), direction.output(1)]
            });
            let Some(winding) = found else {
                return Some(Unfollowed { angle, input });
            };
            centre.add(winding, at);
            self.machine.windings.insert((angle, input), winding.turns);
        }
        self.machine.centres.insert(angle, centre.value());
        let declared = self.nominal.ranges.iter().flatten().count();
        let strays = declared > 1 && !self.stays_near_its_guide(angle);
        strays.then(|| Unfollowed {
            angle,
            input: inputs - 1,
        })
    }

    fn direction(&self, inputs: &[f64]) -> [f64; 2] {
        let outputs = self.machine.run_part(&self.direction, inputs);
        [outputs[0], outputs[1]]
    }

    /// The angle at given inputs that is nearest to `guide`.
    fn angle(&self, inputs: &[f64], guide: f64) -> f64 {
        let [cos, sin] = self.direction(inputs);
        Ternary::AngleNear.apply([sin, cos, guide])
    }

    /// Checks for several inputs that the angle, followed from neighbour to neighbour over a grid,
    /// is the one nearest to its guide.
    fn stays_near_its_guide(&self, angle: usize) -> bool {
        let all: Vec<usize> = (0..self.nominal.inputs.len()).collect();
        let grid = Grid::new(self.nominal, &all);
        let mut followed = Vec::with_capacity(grid.count);
        for position in 0..grid.count {
            let inputs = grid.inputs(self.nominal, position);
            let windings = &self.machine.windings;
            let turned = inputs
                .iter()
                .enumerate()
                .map(|(input, x)| windings.get(&(angle, input)).copied().unwrap_or(0.0) * x);
            let guide = self.machine.centres[&angle] + turned.sum::<f64>();
            let near = grid
                .before(position)
                .map_or(guide, |before| followed[before]);
            let value = self.angle(&inputs, near);
            if (value - guide).abs() > LIMIT {
                return false;
            }
            followed.push(if value.is_nan() { near } else { value });
        }
        true
    }
}
