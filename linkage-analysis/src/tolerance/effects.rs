//! Effects of tolerances on a quantity at one position.

use alloc::vec::Vec;
use core::array;
use core::fmt;

use super::given::Tolerances;
use super::modulus;
use crate::components::{Components, in_space, norm};
use linkage_core::format::rounded;

/// The error of a quantity of `K` components that each of `N` tolerances allows, to first order:
/// sensitivity times tolerance.
///
/// Errors are those from the value that nominal dimensions give. Where [limits](Tolerances::limits)
/// do not lie symmetrically about a nominal dimension, the middle of its zone gives a part that is
/// always there, the [shift](Self::shift).
///
/// All figures are in the unit of the quantity. They are NaN where a sensitivity is NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Effects<const N: usize, const K: usize> {
    tolerances: Tolerances<N>,
    effects: [[f64; K]; N],
    /// The effect of the middle of each zone.
    shifts: [[f64; K]; N],
}

/// The part of one parameter in the error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contribution<const K: usize> {
    /// Name of the parameter.
    pub name: &'static str,
    /// Unit of the tolerance.
    pub unit: &'static str,
    /// Its tolerance.
    pub tolerance: f64,
    /// The error when the dimension is too large by its tolerance, counted from the middle of its
    /// zone.
    pub effect: [f64; K],
    /// The length of `effect`.
    pub modulus: f64,
    /// Its part of the worst case by modulus: `effect` with its sign, and the effect of the middle
    /// of the zone, along the direction of the worst error, divided by that error. The parts sum up
    /// to 1.
    pub share_of_worst_case: f64,
    /// Its part of the variance: the square of `modulus` over the sum of squares. The parts sum up
    /// to 1.
    pub share_of_variance: f64,
}

impl<const N: usize> Tolerances<N> {
    /// The effect of each tolerance on a quantity with these sensitivities.
    ///
    /// Where a sensitivity is NaN, because the mechanism cannot be assembled, all figures that it
    /// enters are NaN.
    #[must_use]
    pub fn effects<V: Components<K>, const K: usize>(
        &self,
        sensitivities: &[V; N],
    ) -> Effects<N, K> {
        Effects::new(*self, &sensitivities.map(V::components))
    }
}

impl<const N: usize, const K: usize> Effects<N, K> {
    pub(super) fn new(tolerances: Tolerances<N>, sensitivities: &[[f64; K]; N]) -> Self {
        let times = |values: &[f64; N]| {
            array::from_fn(|i| sensitivities[i].map(|component| component * values[i]))
        };
        Self {
            tolerances,
            effects: times(&tolerances.values()),
            shifts: times(tolerances.middles()),
        }
    }

    /// The error of the displacement from a start position, where these are the effects here and
    /// `start` those there, by the same tolerances: a dimension that shifts both positions alike
    /// has no effect.
    #[must_use]
    pub fn relative_to(&self, start: &Self) -> Self {
        Self {
            tolerances: self.tolerances,
            effects: differences(&self.effects, &start.effects),
            shifts: differences(&self.shifts, &start.shifts),
        }
    }

    /// The error when every dimension is in the middle of its zone: the mean error to first order,
    /// 0 if all zones lie symmetrically about their nominal dimensions.
    #[must_use]
    pub fn shift(&self) -> [f64; K] {
        array::from_fn(|k| self.shifts.iter().map(|shift| shift[k]).sum())
    }

    /// Sensitivity times tolerance of each parameter.
    #[must_use]
    pub const fn effects(&self) -> &[[f64; K]; N] {
        &self.effects
    }

    /// The tolerances.
    #[must_use]
    pub const fn tolerances(&self) -> &Tolerances<N> {
        &self.tolerances
    }

    /// The largest error of each component: the sum of the sizes of its effects, and of its shift.
    ///
    /// Different dimensions make different components large, so these errors need not occur
    /// together: see [`worst_modulus`](Self::worst_modulus).
    #[must_use]
    pub fn worst_case(&self) -> [f64; K] {
        let shift = self.shift();
        let sum = self.by_component(|effects| effects.map(f64::abs).sum());
        array::from_fn(|k| sum[k] + shift[k].abs())
    }

    /// The largest length of the error vector: the longest sum of effects over all choices of
    /// signs, exactly, in `n log n` steps for plane vectors (`n^3` in space).
    #[must_use]
    pub fn worst_modulus(&self) -> f64 {
        modulus::farthest(&self.vectors()).map_or(f64::NAN, |corner| norm(&corner.sum))
    }

    /// The error vector that is longest, and the signs of the errors that give it; 0 for a
    /// parameter without effect. Without a shift the opposite signs give the opposite vector.
    #[must_use]
    pub fn worst_vector(&self) -> ([f64; K], [f64; N]) {
        match modulus::farthest(&self.vectors()) {
            Some(corner) => {
                // All sums lie symmetrically about 0, the shift among them: it may be the opposite
                // sum that is meant.
                let way = if corner.signs.get(N).is_some_and(|&sign| sign < 0.0) {
                    -1.0
                } else {
                    1.0
                };
                (
                    array::from_fn(|k| way * corner.sum[k]),
                    array::from_fn(|i| way * corner.signs[i]),
                )
            }
            None => ([f64::NAN; K], [f64::NAN; N]),
        }
    }

    /// The root of the sum of squares of each component: the error about the [shift](Self::shift)
    /// at three standard deviations, if the tolerances are three standard deviations of independent
    /// errors.
    #[must_use]
    pub fn root_sum_square(&self) -> [f64; K] {
        let mut column = [0.0; N];
        array::from_fn(|k| {
            for (to, effect) in column.iter_mut().zip(&self.effects) {
                *to = effect[k];
            }
            norm(&column)
        })
    }

    /// The root of the sum of squares of all components: the square root of the trace of the
    /// covariance matrix, three times the root mean square length of the error vector.
    #[must_use]
    pub fn root_sum_square_modulus(&self) -> f64 {
        norm(&self.root_sum_square())
    }

    /// The error when every dimension is at its upper limit: errors of equal sign. It is no bound,
    /// since effects cancel each other.
    #[must_use]
    pub fn algebraic_sum(&self) -> [f64; K] {
        let shift = self.shift();
        let sum = self.by_component(|effects| effects.sum());
        array::from_fn(|k| sum[k] + shift[k])
    }

    /// The contribution of each parameter.
    #[must_use]
    pub fn contributions(&self) -> [Contribution<K>; N] {
        let (worst, signs) = self.worst_vector();
        let square = |v: &[f64; K]| v.iter().map(|x| x * x).sum::<f64>();
        let variance: f64 = self.effects.iter().map(square).sum();
        let share = |part: f64, whole: f64| if whole == 0.0 { 0.0 } else { part / whole };
        array::from_fn(|i| {
            let effect = self.effects[i];
            let along: f64 = effect
                .iter()
                .zip(&worst)
                .zip(&self.shifts[i])
                .map(|((e, w), shift)| (e * signs[i] + shift) * w)
                .sum();
            let parameter = &self.tolerances.parameters()[i];
            Contribution {
                name: parameter.name,
                unit: parameter.unit,
                tolerance: parameter.tolerance,
                effect,
                modulus: norm(&effect),
                share_of_worst_case: share(along, square(&worst)),
                share_of_variance: share(square(&effect), variance),
            }
        })
    }

    /// All effects, and the shift if there is one.
    fn vectors(&self) -> Vec<[f64; 3]> {
        let shift = self.shift();
        let effects = self.effects.iter();
        let mut vectors: Vec<_> = effects.map(in_space).collect();
        if shift != [0.0; K] {
            vectors.push(in_space(&shift));
        }
        vectors
    }

    fn by_component(&self, sum: fn(&mut dyn Iterator<Item = f64>) -> f64) -> [f64; K] {
        array::from_fn(|k| sum(&mut self.effects.iter().map(|effect| effect[k])))
    }
}

/// Two tables: the figures by definition, and the contributions of the parameters.
impl<const N: usize, const K: usize> fmt::Display for Effects<N, K> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = &["x", "y", "z"][..K.min(3)];
        let rows = [
            (
                "algebraic sum",
                self.algebraic_sum(),
                norm(&self.algebraic_sum()),
            ),
            ("worst case", self.worst_case(), self.worst_modulus()),
            (
                "root sum square",
                self.root_sum_square(),
                self.root_sum_square_modulus(),
            ),
        ];
        head(f, "definition", names, &["modulus"])?;
        for (name, components, modulus) in rows {
            row(f, name, &components, modulus)?;
            writeln!(f)?;
        }
        writeln!(f)?;
        head(
            f,
            "parameter",
            names,
            &["modulus", "of worst", "of variance"],
        )?;
        for part in self.contributions() {
            row(f, part.name, &part.effect, part.modulus)?;
            let shares = [part.share_of_worst_case, part.share_of_variance];
            // The sum makes a zero positive.
            let [worst, variance] = shares.map(|share| 100.0 * share + 0.0);
            writeln!(f, " {worst:>10.1} % {variance:>10.1} %")?;
        }
        Ok(())
    }
}

fn differences<const N: usize, const K: usize>(
    here: &[[f64; K]; N],
    start: &[[f64; K]; N],
) -> [[f64; K]; N] {
    array::from_fn(|i| array::from_fn(|k| here[i][k] - start[i][k]))
}

fn head(f: &mut fmt::Formatter<'_>, title: &str, names: &[&str], more: &[&str]) -> fmt::Result {
    write!(f, "{title:<16}")?;
    for name in names.iter().chain(more) {
        write!(f, " {name:>12}")?;
    }
    writeln!(f)
}

fn row(f: &mut fmt::Formatter<'_>, name: &str, components: &[f64], modulus: f64) -> fmt::Result {
    write!(f, "{name:<16}")?;
    for &x in components.iter().chain([&modulus]) {
        write!(f, " {:>12}", alloc::format!("{}", rounded(x)))?;
    }
    Ok(())
}
