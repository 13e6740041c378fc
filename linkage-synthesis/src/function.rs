//! Function generation: four-bars whose links of the frame turn together by given angles.
//!
//! With the frame of length 1 from (0, 0) to (1, 0), Freudenstein's equation (Transactions of the
//! ASME 77, 1955) is
//!
//! `cos(i - o) = K1 cos(o) - K2 cos(i) + K3`, `K1 = 1 / crank`, `K2 = 1 / rocker`,
//! `K3 = (1 + crank^2 + rocker^2 - coupler^2) / (2 crank rocker)`
//!
//! for the angles `i` of the crank and `o` of the rocker.

mod ratios;
mod verified;

use super::Pose;
use super::burmester::Dyads;
use super::error::{self, Unsolved};
use super::four_bar::{FourBar, Passage};
use super::guides::Pivots;
use core::f64::consts::{FRAC_PI_2, PI};
use linkage_core::numeric::complex::Complex;
use nalgebra::{Matrix3, Matrix4, SVD};
use ratios::{ratios, row};
use std::vec::Vec;

/// Turns of both links that belong together, rad, from starts that are free or given.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pair {
    /// Turn of the crank.
    pub input: f64,
    /// Turn of the rocker.
    pub output: f64,
}

/// A four-bar that turns one link by the other; the frame has length 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FunctionFourBar {
    /// Length of the link that is turned by the inputs, from (0, 0).
    pub crank: f64,
    /// Length of the coupler.
    pub coupler: f64,
    /// Length of the link that is turned by the outputs, from (1, 0).
    pub rocker: f64,
    /// Angle of the crank at input 0, rad.
    pub input_start: f64,
    /// Angle of the rocker at output 0, rad.
    pub output_start: f64,
}

/// The four-bars that meet the pairs.
#[derive(Clone, Debug, PartialEq)]
pub struct Functions {
    /// The real ones.
    pub four_bars: Vec<FunctionFourBar>,
    /// The number of those that are complex, or have an imaginary length.
    pub complex: usize,
    /// The number of those at infinity (their frame vanishes beside the links), too close to others
    /// to decide, or not closed at all pairs with rounded lengths.
    pub undecided: usize,
    /// True if the count is shown: as of [`Dyads`] for five pairs; for fewer, roots of a linear or
    /// quadratic equation that are clear of rounding.
    pub certified: bool,
}

/// The given start of an angle; the other one is free.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum GivenStart {
    /// Angle of the crank at input 0, rad.
    Input(f64),
    /// Angle of the rocker at output 0, rad.
    Output(f64),
}

impl Pair {
    /// A pair of turns.
    #[must_use]
    pub const fn new(input: f64, output: f64) -> Self {
        Self { input, output }
    }

    /// With the links of the frame exchanged.
    fn mirrored(self) -> Self {
        Self::new(-self.output, -self.input)
    }
}

/// Both joints of the frame are at 0 as seen from the crank: a link whose joints are not so near is
/// another one.
const FRAME: f64 = 1e-6;

/// Below this part of the largest singular value or coefficient, rounding decides.
const LEAST: f64 = 1e-12;

impl Functions {
    /// Three pairs, both starts given: at most one four-bar.
    ///
    /// # Errors
    ///
    /// `NotFinite`; `Equal` pairs; `Dependent` pairs.
    pub fn of_three(
        pairs: &[Pair; 3],
        input_start: f64,
        output_start: f64,
    ) -> Result<Self, Unsolved> {
        checked(pairs)?;
        let rows = pairs.map(|pair| row(input_start + pair.input, output_start + pair.output));
        let matrix = Matrix3::from_fn(|i, j| rows[i][j]);
        let svd = SVD::new(matrix, true, true);
        let rank = svd.singular_values[2] / svd.singular_values[0];
        let right = nalgebra::Vector3::from_fn(|i, _| rows[i][3]);
        let solved = svd.solve(&right, 0.0).ok().filter(|_| rank > LEAST);
        let k = solved.ok_or(Unsolved::Dependent { rank, least: LEAST })?;
        let found = FunctionFourBar::of_ratios([k[0], k[1], k[2]], [input_start, output_start]);
        Ok(Self::new([found].into_iter().collect(), pairs, true))
    }

    /// Four pairs, one start given: at most two four-bars.
    ///
    /// # Errors
    ///
    /// `NotFinite`; `Equal` pairs; `Dependent` pairs.
    pub fn of_four(pairs: &[Pair; 4], start: GivenStart) -> Result<Self, Unsolved> {
        checked(pairs)?;
        match start {
            GivenStart::Input(start) => Self::with_input_start(pairs, start),
            GivenStart::Output(start) => {
                let mut found = Self::with_input_start(&pairs.map(Pair::mirrored), PI - start)?;
                for four_bar in &mut found.four_bars {
                    *four_bar = four_bar.mirrored();
                }
                Ok(found.verified(pairs))
            }
        }
    }

    /// Five pairs, both starts free: at most three four-bars.
    ///
    /// Seen from the crank, the rocker takes five poses; the coupler is a link that leads it
    /// through them (Burmester). The frame is another such link, so that three are left.
    ///
    /// # Errors
    ///
    /// `NotFinite`; `Equal` pairs; `Dependent` pairs.
    pub fn of_five(pairs: &[Pair; 5]) -> Result<Self, Unsolved> {
        checked(pairs)?;
        let poses = pairs.map(|pair| {
            let joint = Complex::polar(-pair.input);
            Pose::new(joint.into(), pair.output - pair.input)
        });
        let dyads = Dyads::of_poses(&poses)?;
        let mut links: Vec<Pivots> = dyads.links().collect();
        let far = |link: &Pivots| {
            let numbers = [link.fixed, link.moving].into_iter().flatten();
            numbers.map(f64::abs).fold(0.0, f64::max)
        };
        let near = (0..links.len()).filter(|&k| far(&links[k]) < FRAME);
        let frame = near.min_by(|&a, &b| far(&links[a]).total_cmp(&far(&links[b])));
        let sliders = dyads.real.len() - links.len();
        if let Some(frame) = frame {
            links.remove(frame);
        }
        let found = Self {
            four_bars: links
                .iter()
                .map(|link| FunctionFourBar::of_link(link, &poses[0]))
                .collect(),
            complex: dyads.complex,
            undecided: dyads.undecided + sliders,
            certified: dyads.certified,
        };
        Ok(found.verified(pairs))
    }

    fn with_input_start(pairs: &[Pair; 4], start: f64) -> Result<Self, Unsolved> {
        // Turns of the rocker from a start `s`: rows are linear in its cosine and sine.
        let at = |turn: f64| pairs.map(|pair| row(start + pair.input, turn + pair.output));
        let (cosine, sine) = (at(0.0), at(FRAC_PI_2));
        let determinant = |third: &[[f64; 4]; 4], fourth: &[[f64; 4]; 4]| {
            let element = |i: usize, j: usize| match j {
                0 => third[i][0],
                3 => fourth[i][3],
                _ => cosine[i][j],
            };
            Matrix4::from_fn(element).determinant()
        };
        let quadratic = [
            determinant(&cosine, &cosine),
            determinant(&cosine, &sine) + determinant(&sine, &cosine),
            determinant(&sine, &sine),
        ];
        let [a, b, c] = quadratic;
        let largest = a.abs().max(b.abs()).max(c.abs());
        if largest <= LEAST {
            return Err(Unsolved::Dependent {
                rank: largest,
                least: LEAST,
            });
        }
        // The tangent of the start, as a direction that may be upright.
        let discriminant = b * b - 4.0 * a * c;
        let clear = discriminant.abs() > LEAST * largest * largest;
        if discriminant < 0.0 {
            return Ok(Self {
                four_bars: Vec::new(),
                complex: 2,
                undecided: 0,
                certified: clear,
            });
        }
        let larger = -0.5 * (b + discriminant.sqrt().copysign(b));
        // a cos^2 + b cos sin + c sin^2 = 0
        let starts = [f64::atan2(larger, c), f64::atan2(a, larger)];
        let found = starts.map(|turn| {
            let ratios = ratios(&at(turn))?;
            FunctionFourBar::of_ratios(ratios, [start, turn])
        });
        Ok(Self::new(found.into_iter().collect(), pairs, clear))
    }

    fn new(found: Vec<Option<FunctionFourBar>>, pairs: &[Pair], certified: bool) -> Self {
        let count = found.len();
        let four_bars: Vec<_> = found.into_iter().flatten().collect();
        let found = Self {
            complex: count - four_bars.len(),
            four_bars,
            undecided: 0,
            certified,
        };
        found.verified(pairs)
    }
}

impl FunctionFourBar {
    /// The coupler as a body: its frame has its origin at the crank pin and its x axis towards the
    /// rocker pin.
    #[must_use]
    pub fn four_bar(&self) -> FourBar {
        FourBar {
            fixed: [[0.0, 0.0], [1.0, 0.0]],
            moving: [[0.0, 0.0], [self.coupler, 0.0]],
        }
    }

    /// Returns the pose of the coupler at a pair of turns, and the difference between the distance
    /// of both pins and its length.
    #[must_use]
    pub fn pose(&self, pair: &Pair) -> (Pose, f64) {
        let crank = Complex::polar(self.input_start + pair.input).scaled(self.crank);
        let rocker = Complex::polar(self.output_start + pair.output).scaled(self.rocker);
        let coupler = rocker + Complex::new(1.0, 0.0) - crank;
        let pose = Pose::new(crank.into(), coupler.angle());
        (pose, coupler.size() - self.coupler)
    }

    /// Returns the passage of the four-bar through the pairs: circuits, branches, order.
    #[must_use]
    pub fn passage(&self, pairs: &[Pair]) -> Passage {
        let poses: Vec<Pose> = pairs.iter().map(|pair| self.pose(pair).0).collect();
        self.four_bar().passage(&poses)
    }

    /// Builds a four-bar from Freudenstein's ratios; `None` if a length is imaginary or infinite.
    fn of_ratios([k1, k2, k3]: [f64; 3], [input, output]: [f64; 2]) -> Option<Self> {
        let (crank, rocker) = (1.0 / k1, 1.0 / k2);
        let square = 1.0 + crank * crank + rocker * rocker - 2.0 * crank * rocker * k3;
        // A negative length is a length in the opposite direction.
        let start = |start: f64, length: f64| if length < 0.0 { start + PI } else { start };
        (square > 0.0 && square.is_finite()).then(|| Self {
            crank: crank.abs(),
            coupler: square.sqrt(),
            rocker: rocker.abs(),
            input_start: start(input, crank),
            output_start: start(output, rocker),
        })
    }

    fn of_link(link: &Pivots, pose: &Pose) -> Self {
        let (crank, rocker) = (Complex::from(link.fixed), Complex::from(link.moving));
        Self {
            crank: crank.size(),
            coupler: link.length(pose),
            rocker: rocker.size(),
            input_start: crank.angle(),
            output_start: rocker.angle(),
        }
    }

    /// With the links of the frame exchanged, seen in a mirror: the frame is from (0, 0) to (1, 0)
    /// again.
    fn mirrored(self) -> Self {
        Self {
            crank: self.rocker,
            rocker: self.crank,
            input_start: PI - self.output_start,
            output_start: PI - self.input_start,
            ..self
        }
    }
}

fn checked(pairs: &[Pair]) -> Result<(), Unsolved> {
    let numbers: Vec<[f64; 2]> = pairs.iter().map(|pair| [pair.input, pair.output]).collect();
    error::check(&numbers)
}
