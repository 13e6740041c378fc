//! How certain the numbers of a position can be at all.

use crate::reference::{Reference, STEP};
use crate::{Big, Kind, Output, ROUNDOFF};

impl Reference<'_> {
    /// What a change of one roundoff in every datum, and one rounding of the result, does to the
    /// derivative of every output by the given data (to the outputs themselves for none).
    ///
    /// An angle is counted as if it were larger by one radian: its sine and cosine carry roundings
    /// of their own.
    pub fn uncertainty(&mut self, by: &[usize]) -> Vec<Big> {
        let mut sum = self.rounding(by);
        for index in 0..self.data.len() {
            let further: Vec<usize> = by.iter().copied().chain([index]).collect();
            for (sum, change) in sum.iter_mut().zip(self.derivative(&further)) {
                *sum = &*sum + change.abs() * &self.weights[index];
            }
        }
        sum.into_iter().map(|s| s * ROUNDOFF).collect()
    }

    /// The uncertainty with that of the unknowns taken together: an unknown may be as uncertain as
    /// any other one of its loops, where an angle counts times the lever with which it moves the
    /// loop, and an output as the unknowns make it.
    ///
    /// Linear equations are solved accurately in this sense only, by any method: where two links
    /// are of very different lengths or a derivative nearly vanishes, one component may be far more
    /// certain than the rest.
    pub fn joint_uncertainty(&mut self, by: &[usize]) -> Vec<Big> {
        let mut alone = self.uncertainty(by);
        let levers = &self.solution.levers;
        let joint = alone.iter().zip(levers).map(|(own, lever)| own * lever);
        let joint = joint.fold(Big::zero(), |most, own| most.max(&own));
        for (own, reach) in alone.iter_mut().zip(self.reaches()) {
            *own = own.max(&(&joint * reach));
        }
        alone
    }

    /// The margin, and what a change of one roundoff in every datum does to it; none if it is no determinant.
    pub fn margin(&self) -> Option<(Big, Big)> {
        let margin = |determinant: &Big, data: &[Big]| {
            let factor = self.system.margin_factor(data)?;
            Some(determinant.abs() * factor)
        };
        let here = margin(&self.solution.determinant, &self.data)?;
        let mut sum = here.clone();
        for (index, weight) in self.weights.iter().enumerate() {
            let mut data = self.data.clone();
            data[index] = &data[index] + &self.steps[index];
            let there = self.solution.moved_determinant(self.system, &data);
            let there = margin(&there, &data)?;
            sum = sum + (there - &here).abs() / &self.steps[index] * weight;
        }
        Some((here, sum * ROUNDOFF))
    }

    fn rounding(&mut self, by: &[usize]) -> Vec<Big> {
        if !by.is_empty() {
            return self.derivative(by).iter().map(Big::abs).collect();
        }
        let magnitude = |output: &Output| match output {
            Output::Value(value) | Output::Number(value) => value.abs(),
            Output::Angle(_) => Big::from(core::f64::consts::PI),
        };
        self.outputs.iter().map(magnitude).collect()
    }
}

// How strongly the loops pass an error on.

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
