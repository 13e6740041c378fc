//! Search for the revolutions of continuous angles.

use linkage_core::Scalar;
use linkage_core::numeric::winding::{Centre, follow, uniform};

use super::compiled::{Compiled, RevolutionsOf};
use super::list::List;
use super::preparation::prepared;
use super::revolutions::{Along, Angle, Revolutions};

/// Centres at the start estimates, no winding: right at the reference position.
pub(super) fn at_estimates<C: Compiled>(mechanism: &C) -> RevolutionsOf<C> {
    let description = mechanism.description();
    let angles = description.angles;
    constant::<C>(
        mechanism,
        |angle| C::Scalar::from_f64(angles[angle].estimate),
        |_, _| C::Scalar::from_f64(0.0),
    )
}

/// Revolutions with these numbers.
pub(super) fn constant<C: Compiled>(
    mechanism: &C,
    centre: impl FnMut(usize) -> C::Scalar,
    winding: impl Fn(usize, usize) -> C::Scalar,
) -> RevolutionsOf<C> {
    let description = mechanism.description();
    let (angles, inputs) = (description.angles.len(), description.inputs.len());
    Revolutions {
        centres: List::list(angles, centre),
        windings: List::list(angles, |angle| {
            List::list(inputs, |input| winding(angle, input))
        }),
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
        let set = |lanes: &mut C::Scalar, number: f64| {
            *lanes = C::Scalar::from_lanes(|i| if i == lane { number } else { lanes.lane(i) });
        };
        let centres = found.centres.as_mut().iter_mut();
        for (lanes, centre) in centres.zip(one.centres.as_ref()) {
            set(lanes, *centre);
        }
        let windings = found.windings.as_mut().iter_mut();
        for (lanes, windings) in windings.zip(one.windings.as_ref()) {
            for (lanes, winding) in lanes.as_mut().iter_mut().zip(windings.as_ref()) {
                set(lanes, *winding);
            }
        }
    }
    Ok(found)
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
    let angles = mechanism.description().angles;
    for (index, angle) in angles.iter().enumerate().take(count) {
        let (vectors, rest) = phases.split_at(angle.phases.len());
        phases = rest;
        let prepared = prepared(mechanism, modes, &revolutions);
        let direction = |x: &C::Inputs| {
            let x = mechanism.arguments(states, x);
            mechanism.directions(modes, &prepared, x).as_ref()[index]
        };
        let mut along = |input: usize, x: f64| {
            let mut inputs = start.clone();
            inputs.as_mut()[input] = x;
            direction(&inputs)
        };
        let here = direction(start);
        let windings = revolutions.windings.as_mut()[index].as_mut();
        let centre = wind_one(angle, vectors, start.as_ref(), here, windings, &mut along);
        revolutions.centres.as_mut()[index] = centre.ok_or(angle.unknown)?;
    }
    Ok(revolutions)
}

/// Centre and windings of one angle, from the vectors of its phases or by following it. `here` is
/// its cosine and sine at the start, `direction` those where an input has another value.
#[inline]
fn wind_one(
    angle: &Angle,
    phases: &[[f64; 2]],
    start: &[f64],
    here: [f64; 2],
    windings: &mut [f64],
    direction: &mut dyn FnMut(usize, f64) -> [f64; 2],
) -> Option<f64> {
    let [cosine, sine] = here;
    let here = <f64 as Scalar>::angle_near(sine, cosine, angle.estimate);
    if !here.is_finite() {
        return None;
    }
    match uniform(phases, angle.phases, &start, here) {
        Some((centre, turns)) => {
            windings.copy_from_slice(turns);
            Some(centre)
        }
        None => follow_inputs(angle, start, here, windings, direction),
    }
}

/// Centre and windings of an angle that is `here` at the start, followed along each of its inputs.
/// One function for all mechanisms: their code is compiled often enough.
fn follow_inputs(
    angle: &Angle,
    start: &[f64],
    here: f64,
    windings: &mut [f64],
    direction: &mut dyn FnMut(usize, f64) -> [f64; 2],
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
        let along = follow(low, high, x, here, rates, |x| direction(input, x))?;
        windings[input] = along.turns;
        centre.add(along, x);
    }
    Some(centre.value())
}
