//! Inputs and speeds as the state that an integrator advances.

use ivp::ivp::FirstOrderSystem;
use std::cell::Cell;

/// Inputs and speeds of a mechanism, or their rates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Phase<const N: usize> {
    pub(crate) inputs: [f64; N],
    pub(crate) speeds: [f64; N],
}

impl<const N: usize> Phase<N> {
    pub(crate) const ZERO: Self = Self {
        inputs: [0.0; N],
        speeds: [0.0; N],
    };

    /// Returns the phase of `2 N` components, inputs first.
    pub(crate) fn from_components(components: &[f64]) -> Self {
        let (inputs, speeds) = components.split_at(N);
        let mut phase = Self::ZERO;
        phase.inputs.copy_from_slice(inputs);
        phase.speeds.copy_from_slice(speeds);
        phase
    }

    /// Writes `2 N` components, inputs first.
    pub(crate) fn write(&self, components: &mut [f64]) {
        let (inputs, speeds) = components.split_at_mut(N);
        inputs.copy_from_slice(&self.inputs);
        speeds.copy_from_slice(&self.speeds);
    }

    /// Returns true if no component is NaN or infinite.
    pub(crate) fn is_finite(&self) -> bool {
        let components = self.inputs.iter().chain(&self.speeds);
        components.copied().all(f64::is_finite)
    }

    /// Adds a multiple of another phase.
    pub(crate) fn add_scaled(&mut self, factor: f64, other: &Self) {
        for i in 0..N {
            self.inputs[i] += factor * other.inputs[i];
            self.speeds[i] += factor * other.speeds[i];
        }
    }

    /// Multiplies all components.
    pub(crate) fn scale(&mut self, factor: f64) {
        for i in 0..N {
            self.inputs[i] *= factor;
            self.speeds[i] *= factor;
        }
    }
}

/// Rates of a state, as a function of the independent variable and the state.
pub(crate) trait Rates<const N: usize> {
    /// Returns the rates; a component that is not finite means that there are none.
    fn rates(&self, x: f64, phase: &Phase<N>) -> Phase<N>;
}

/// Rates for an integrator, with a note of states without rates.
pub(crate) struct Watched<'r, R, const N: usize> {
    rates: &'r R,
    /// The first state without rates since the last look.
    undefined: Cell<Option<(f64, Phase<N>)>>,
    /// Number of evaluations up to the last one without rates.
    last_undefined: Cell<usize>,
    evaluations: Cell<usize>,
}

impl<'r, R: Rates<N>, const N: usize> Watched<'r, R, N> {
    pub(crate) const fn new(rates: &'r R) -> Self {
        Self {
            rates,
            undefined: Cell::new(None),
            last_undefined: Cell::new(0),
            evaluations: Cell::new(0),
        }
    }

    /// Returns the first state without rates since the last call, with its independent variable.
    pub(crate) fn take_undefined(&self) -> Option<(f64, Phase<N>)> {
        self.undefined.take()
    }

    /// Returns true if one of the last `count` evaluations had no rates.
    pub(crate) fn was_undefined(&self, count: usize) -> bool {
        self.last_undefined.get() + count > self.evaluations.get() && self.last_undefined.get() > 0
    }

    /// Returns the number of evaluations.
    pub(crate) fn evaluations(&self) -> usize {
        self.evaluations.get()
    }
}

impl<R: Rates<N>, const N: usize> FirstOrderSystem for Watched<'_, R, N> {
    #[inline]
    fn derivative(&self, x: f64, state: &[f64], rates: &mut [f64]) {
        let phase = Phase::from_components(state);
        let found = self.rates.rates(x, &phase);
        found.write(rates);
        self.evaluations.set(self.evaluations.get() + 1);
        if !found.is_finite() {
            self.last_undefined.set(self.evaluations.get());
            if self.undefined.get().is_none() {
                self.undefined.set(Some((x, phase)));
            }
        }
    }
}
