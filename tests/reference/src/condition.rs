//! How strongly the loops pass an error on.

use crate::reference::{Reference, STEP};
use crate::{Big, Kind, Output};

impl Reference<'_> {
    /// The condition number of every output: by how many lengths it moves at most when the loops
    /// are missed by one.
    ///
    /// For a dyad it is one over the determinant of its loop (each column divided by its length),
    /// times the lever with which the unknowns move the output, if that is longer than their own.
    /// For other systems it is the sum over all equations, which adds the errors of groups that
    /// build on each other.
    pub fn conditions(&mut self) -> Vec<f64> {
        if self.system.margin.is_some() {
            let own = 1.0 / self.determinant().abs();
            self.reaches()
                .iter()
                .map(|reach| own * reach.to_f64().max(1.0))
                .collect()
        } else {
            self.gains()
                .iter()
                .map(|gain| gain.to_f64().max(1.0))
                .collect()
        }
    }

    /// For every output by how much it changes at most when each unknown opens the loops by a unit
    /// of length.
    pub(crate) fn reaches(&mut self) -> &[Big] {
        if self.reaches.is_empty() {
            let mut sum = vec![Big::zero(); self.outputs.len()];
            let step = Big::power_of_two(STEP);
            for index in 0..self.solution.unknowns.len() {
                let mut unknowns = self.solution.unknowns.clone();
                let lever = &self.solution.levers[index];
                match self.system.unknowns[index].kind {
                    Kind::Angle => {
                        let turn = unknowns[index].quarter().times(&step);
                        unknowns[index] = unknowns[index].clone() + turn;
                    }
                    Kind::Ratio => unknowns[index].x = &unknowns[index].x + &step,
                    Kind::Length => unknowns[index].x = &unknowns[index].x + &(&step * lever),
                }
                let unit = match self.system.unknowns[index].kind {
                    Kind::Length => &step * (lever * lever),
                    _ => &step * lever,
                };
                let changes = self.changes(&self.data, &unknowns);
                for (sum, change) in sum.iter_mut().zip(changes) {
                    *sum = &*sum + change.abs() / &unit;
                }
            }
            self.reaches = sum;
        }
        &self.reaches
    }

    /// For every output by how much it changes at most when each equation is missed by a unit of
    /// length (a number: by the size of the mechanism).
    fn gains(&self) -> Vec<Big> {
        let mut sum = vec![Big::zero(); self.outputs.len()];
        let step = Big::power_of_two(STEP);
        for equation in 0..self.system.unknowns.len() {
            let (unknowns, miss) = self.solution.missed(self.system, equation, &step);
            let changes = self.changes(&self.data, &unknowns);
            for (sum, change) in sum.iter_mut().zip(changes) {
                *sum = &*sum + change.abs() / &miss;
            }
        }
        let size = self.system.size(&self.given());
        for (gain, output) in sum.iter_mut().zip(&self.outputs) {
            if let Output::Number(_) = output {
                *gain = &*gain * size;
            }
        }
        sum
    }
}
