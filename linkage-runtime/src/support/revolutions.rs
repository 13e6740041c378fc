//! Centres and windings of continuous angles:
//! `angle = angle_near(.., centre + sum of winding * input)`.

use linkage_core::Scalar;
use linkage_core::numeric::winding::{Centre, follow, uniform};

/// The centre of each of `A` angles, and the turns it makes for each turn of each of `I` inputs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Revolutions<T, const A: usize, const I: usize> {
    /// In radians.
    pub centres: [T; A],
    /// Turns by angle and input.
    pub windings: [[T; I]; A],
}

impl<T: Scalar, const A: usize, const I: usize> Revolutions<T, A, I> {
    /// Centres at the start estimates, no winding: right at the reference position.
    pub fn at_estimates(estimates: [f64; A]) -> Self {
        Self {
            centres: estimates.map(T::from_f64),
            windings: [[T::from_f64(0.0); I]; A],
        }
    }

    /// Those of one lane.
    #[must_use]
    pub fn lane(&self, lane: usize) -> Revolutions<f64, A, I> {
        Revolutions {
            centres: self.centres.map(|centre| centre.lane(lane)),
            windings: self.windings.map(|rates| rates.map(|one| one.lane(lane))),
        }
    }
}

impl<const A: usize, const I: usize> Revolutions<f64, A, I> {
    /// The same in another scalar.
    #[must_use]
    pub fn cast<T: Scalar>(&self) -> Revolutions<T, A, I> {
        Revolutions {
            centres: self.centres.map(T::from_f64),
            windings: self.windings.map(|rates| rates.map(T::from_f64)),
        }
    }
}

/// An angle to follow; `X` are numbers for all inputs.
#[derive(Clone, Copy, Debug)]
pub struct Angle<X: 'static> {
    /// Its name.
    pub unknown: &'static str,
    /// Its value at the reference inputs, about.
    pub estimate: f64,
    /// The inputs it depends on.
    pub along: &'static [Along],
    /// The turns of each vector for a turn of each input. The angle stays within a quarter turn of
    /// their sum. `None` for a vector that turns with something else, too; empty without a closed
    /// form.
    pub phases: &'static [Option<X>],
}

/// The range of one input along which an angle is followed.
#[derive(Clone, Copy, Debug)]
pub struct Along {
    /// Index of the input.
    pub input: usize,
    /// Lower end; equal to the upper end where the angle is not followed along this input.
    pub low: f64,
    /// Upper end.
    pub high: f64,
    /// Candidates for the winding.
    pub rates: &'static [f64],
}

/// Finds the turns of every lane by `search`.
///
/// # Errors
///
/// The name of the angle that cannot be followed.
pub fn revolutions<T: Scalar, const A: usize, const I: usize>(
    mut search: impl FnMut(usize) -> Result<Revolutions<f64, A, I>, &'static str>,
) -> Result<Revolutions<T, A, I>, &'static str> {
    let mut revolutions = Revolutions::at_estimates([0.0; A]);
    for lane in 0..T::LANES {
        let one = search(lane)?;
        let set =
            |lanes: T, one: f64| T::from_lanes(|i| if i == lane { one } else { lanes.lane(i) });
        for angle in 0..A {
            revolutions.centres[angle] = set(revolutions.centres[angle], one.centres[angle]);
            for input in 0..I {
                revolutions.windings[angle][input] = set(
                    revolutions.windings[angle][input],
                    one.windings[angle][input],
                );
            }
        }
    }
    Ok(revolutions)
}

/// Finds the turns of the first `count` angles one after the other: from the vectors of their
/// phases, in the order of the angles, where one of them decides, else by following the angle along
/// its inputs. From the reference position, or from `at` if it does not assemble there. `prepare`
/// gives the directions `[cosine, sine]` of all angles as a function of the inputs; those of an
/// angle may depend on the turns of the angles before it.
///
/// # Errors
///
/// The name of the first angle that cannot be followed.
pub fn wind<const A: usize, const I: usize, D: Fn([f64; I]) -> [[f64; 2]; A]>(
    angles: &[Angle<[f64; I]>; A],
    phases: &[[f64; 2]],
    count: usize,
    reference: [f64; I],
    at: [f64; I],
    prepare: impl Fn(&Revolutions<f64, A, I>) -> D,
) -> Result<Revolutions<f64, A, I>, &'static str> {
    match wind_from(angles, phases, count, reference, &prepare) {
        Err(_) if at != reference => wind_from(angles, phases, count, at, &prepare),
        result => result,
    }
}

fn wind_from<const A: usize, const I: usize, D: Fn([f64; I]) -> [[f64; 2]; A]>(
    angles: &[Angle<[f64; I]>; A],
    mut phases: &[[f64; 2]],
    count: usize,
    start: [f64; I],
    prepare: impl Fn(&Revolutions<f64, A, I>) -> D,
) -> Result<Revolutions<f64, A, I>, &'static str> {
    let mut turns = Revolutions::at_estimates(core::array::from_fn(|angle| angles[angle].estimate));
    for (index, angle) in angles.iter().enumerate().take(count) {
        let (vectors, rest) = phases.split_at(angle.phases.len());
        phases = rest;
        let directions = prepare(&turns);
        let (centre, windings) =
            wind_one(angle, vectors, &start, |x| directions(*x)[index]).ok_or(angle.unknown)?;
        turns.centres[index] = centre;
        turns.windings[index] = windings;
    }
    Ok(turns)
}

/// Centre and windings of one angle, from the vectors of its phases or by following it. `direction`
/// is its cosine and sine.
pub fn wind_one<X: AsRef<[f64]> + AsMut<[f64]> + Clone>(
    angle: &Angle<X>,
    phases: &[[f64; 2]],
    start: &X,
    direction: impl Fn(&X) -> [f64; 2],
) -> Option<(f64, X)> {
    let [cosine, sine] = direction(start);
    let here = <f64 as Scalar>::angle_near(sine, cosine, angle.estimate);
    if !here.is_finite() {
        return None;
    }
    uniform(phases, angle.phases, start, here)
        .or_else(|| follow_inputs(angle, start, here, direction))
}

/// Centre and windings of an angle that is `here` at the start, followed along each of its inputs.
fn follow_inputs<X: AsRef<[f64]> + AsMut<[f64]> + Clone>(
    angle: &Angle<X>,
    start: &X,
    here: f64,
    direction: impl Fn(&X) -> [f64; 2],
) -> Option<(f64, X)> {
    let mut windings = start.clone();
    windings.as_mut().fill(0.0);
    let mut centre = Centre::new(here);
    for &Along {
        input,
        low,
        high,
        rates,
    } in angle.along
    {
        let x = start.as_ref()[input];
        let (low, high) = (low.min(x), high.max(x));
        if low == high {
            continue;
        }
        let along = follow(low, high, x, here, rates, |x| {
            let mut inputs = start.clone();
            inputs.as_mut()[input] = x;
            direction(&inputs)
        })?;
        windings.as_mut()[input] = along.turns;
        centre.add(along, x);
    }
    Some((centre.value(), windings))
}
