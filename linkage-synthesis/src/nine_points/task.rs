//! Nine points against the first one, and the four-bars of a solution.

use super::super::Pose;
use super::super::certificate::Certificate;
use super::super::error::{self, Unsolved};
use super::super::four_bar::FourBar;
use super::super::task::{self, Shift};
use super::equations::{self, ALL};
use super::result::{PathFourBar, Triple};
use super::{cognates, curve};
use linkage_core::numeric::complex::Complex;

/// Nine points against the first one.
pub(super) struct Task {
    pub(super) first: [f64; 2],
    pub(super) unit: f64,
    pub(super) shifts: [Shift; 8],
}

impl Task {
    pub(super) fn new(points: &[[f64; 2]; 9]) -> Result<Self, Unsolved> {
        error::check(points)?;
        curve::check(points)?;
        let [first, others @ ..] = *points;
        let shifts = others.map(|point| Shift::between(first, point));
        let unit = task::unit(shifts.iter().map(|shift| shift.narrow()));
        Ok(Self {
            first,
            unit,
            shifts: shifts.map(|shift| shift.scaled(1.0 / unit)),
        })
    }

    pub(super) fn plain(&self) -> equations::Shifts<Complex> {
        self.shifts.map(|shift| shift.wide().map(Complex::narrow))
    }

    pub(super) fn triple(&self, certificate: &Certificate<ALL>) -> Triple {
        let shifts = self.plain();
        let first = certificate.discs.map(|disc| disc.middle);
        let second = cognates::cognate(&first, &shifts);
        let third = cognates::cognate(&cognates::exchanged(&first), &shifts);
        let radii = certificate.discs[..8].iter().map(|disc| disc.radius);
        Triple {
            four_bars: [first, second, third].map(|unknowns| self.four_bar(&unknowns)),
            error: radii.fold(0.0, f64::max) * self.unit,
        }
    }

    pub(super) fn four_bar(&self, unknowns: &equations::Unknowns<Complex>) -> PathFourBar {
        let length = |number: Complex| number.scaled(self.unit);
        let position = |shift: Complex| (length(shift) + self.first.into()).into();
        let [x, _, a, _, y, _, b, ..] = *unknowns;
        let four_bar = FourBar {
            fixed: [a, b].map(position),
            moving: [x, y].map(|joint| length(joint).into()),
        };
        let poses = core::array::from_fn(|j| match j {
            0 => Pose::new(self.first, 0.0),
            _ => Pose::new(
                position(self.shifts[j - 1].narrow()),
                unknowns[6 + 2 * j].angle(),
            ),
        });
        let passage = four_bar.passage(&poses);
        PathFourBar {
            four_bar,
            poses,
            passage,
        }
    }
}
