//! How certain the numbers of a position can be at all.

use crate::reference::Reference;
use crate::{Big, Output, ROUNDOFF};

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
