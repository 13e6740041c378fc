//! Search for the revolutions of continuous angles.

use linkage_core::Scalar;
use linkage_core::numeric::winding::{Centre, follow, uniform};

use super::compiled::{Compiled, RevolutionsOf};
use super::description::Description;
use super::list::{List, Table};
use super::preparation::prepared;
use super::revolutions::{Along, Angle, Revolutions};

/// Centres at the start estimates, no winding: right at the reference position.
pub(super) fn at_estimates<C: Compiled>(mechanism: &C) -> RevolutionsOf<C> {
    let Description { angles, inputs, .. } = *mechanism.description();
    let zero = C::Scalar::from_f64(0.0);
    let mut revolutions = Revolutions {
        centres: C::Centres::repeat(angles.len(), zero),
        windings: C::Windings::filled(angles.len(), inputs.len(), zero),
    };
    estimates(angles, revolutions.centres.as_mut());
    revolutions
}

fn estimates<T: Scalar>(angles: &[Angle], centres: &mut [T]) {
    for (centre, angle) in centres.iter_mut().zip(angles) {
        *centre = T::from_f64(angle.estimate);
    }
}

/// Sets revolutions by those of plain numbers: centres, and the windings of each angle, by `set`.
pub(super) fn set_from<C: Compiled, P: Compiled<Scalar = f64>>(
    revolutions: &mut RevolutionsOf<C>,
    plain: &RevolutionsOf<P>,
    set: impl Fn(&mut [C::Scalar], &[f64]),
) {
    set(revolutions.centres.as_mut(), plain.centres.as_ref());
    let plain = plain.windings.as_ref();
    for (angle, windings) in revolutions.windings.as_mut().iter_mut().enumerate() {
        set(windings.as_mut(), plain[angle].as_ref());
    }
}

/// Finds the revolutions of every lane by `search`.
///
/// # Errors
///
/// The name of the angle that cannot be followed.
pub(super) fn by_lane<C: Compiled>(
    mechanism: &C,
    mut search: impl FnMut(usize) -> Result<RevolutionsOf<C::Plain>, &'static str>,
) -> Result<RevolutionsOf<C>, &'static str> {
    let mut found = at_estimates(mechanism);
    for lane in 0..C::Scalar::LANES {
        let one = search(lane)?;
        set_from::<C, C::Plain>(&mut found, &one, |lanes, numbers| {
            set_lane(lanes, lane, numbers);
        });
    }
    Ok(found)
}

/// Sets one lane. One function for all mechanisms: their code is compiled often enough.
fn set_lane<T: Scalar>(lanes: &mut [T], lane: usize, numbers: &[f64]) {
    for (lanes, &number) in lanes.iter_mut().zip(numbers) {
        *lanes = T::from_lanes(|i| if i == lane { number } else { lanes.lane(i) });
    }
}

/// Finds the revolutions of the first `count` angles one after the other: from the vectors of their
/// phases, in the order of the angles, where one of them decides, else by following the angle along
/// its inputs. From the reference position, or from `at` if it does not assemble there. The
/// directions of an angle may depend on the revolutions of the angles before it.
///
/// # Errors
///
/// The name of the first angle that cannot be followed.
pub(super) fn wind<C: Compiled<Scalar = f64>>(
    mechanism: &C,
    modes: &C::Modes,
    states: &C::States,
    count: usize,
    at: &C::Inputs,
) -> Result<RevolutionsOf<C>, &'static str> {
    if count == 0 {
        return Ok(at_estimates(mechanism));
    }
    let reference = mechanism.reference();
    match wind_from(mechanism, modes, states, count, &reference) {
        Err(_) if at.as_ref() != reference.as_ref() => {
            wind_from(mechanism, modes, states, count, at)
        }
        result => result,
    }
}

fn wind_from<C: Compiled<Scalar = f64>>(
    mechanism: &C,
    modes: &C::Modes,
    states: &C::States,
    count: usize,
    start: &C::Inputs,
) -> Result<RevolutionsOf<C>, &'static str> {
    let mut revolutions = at_estimates(mechanism);
    let bearings = mechanism.bearings(modes);
    let mut phases = bearings.as_ref();
    for (index, angle) in mechanism.description().angles[..count].iter().enumerate() {
        let prepared = prepared(mechanism, modes, &revolutions);
        let direction = |changed: Option<(usize, f64)>| {
            let mut inputs = start.clone();
            if let Some((input, x)) = changed {
                inputs.as_mut()[input] = x;
            }
            let x = mechanism.arguments(states, &inputs);
            mechanism.directions(modes, &prepared, x).as_ref()[index]
        };
        let windings = revolutions.windings.as_mut()[index].as_mut();
        let centre = wind_one(angle, &mut phases, start.as_ref(), windings, &direction)?;
        revolutions.centres.as_mut()[index] = centre;
    }
    Ok(revolutions)
}

/// Cosine and sine of an angle at the start, or where one input has another value.
type Direction<'a> = &'a dyn Fn(Option<(usize, f64)>) -> [f64; 2];

/// Centre and windings of one angle, from the first of `phases`, which are its vectors, or by
/// following it. One function for all mechanisms: their code is compiled often enough.
fn wind_one(
    angle: &Angle,
    phases: &mut &[[f64; 2]],
    start: &[f64],
    windings: &mut [f64],
    direction: Direction<'_>,
) -> Result<f64, &'static str> {
    let (vectors, rest) = phases.split_at(angle.phases.len());
    *phases = rest;
    let [cosine, sine] = direction(None);
    let here = <f64 as Scalar>::angle_near(sine, cosine, angle.estimate);
    if !here.is_finite() {
        return Err(angle.unknown);
    }
    match uniform(vectors, angle.phases, &start, here) {
        Some((centre, turns)) => {
            windings.copy_from_slice(turns);
            Ok(centre)
        }
        None => follow_inputs(angle, start, here, windings, direction).ok_or(angle.unknown),
    }
}

/// Centre and windings of an angle that is `here` at the start, followed along each of its inputs.
fn follow_inputs(
    angle: &Angle,
    start: &[f64],
    here: f64,
    windings: &mut [f64],
    direction: Direction<'_>,
) -> Option<f64> {
    windings.fill(0.0);
    let mut centre = Centre::new(here);
    for &Along {
        input,
        low,
        high,
        rates,
    } in angle.along
    {
        let x = start[input];
        let (low, high) = (low.min(x), high.max(x));
        if low == high {
            continue;
        }
        let along = follow(low, high, x, here, rates, |x| direction(Some((input, x))))?;
        windings[input] = along.turns;
        centre.add(along, x);
    }
    Some(centre.value())
}
