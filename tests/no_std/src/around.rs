//! What stands beside mechanisms: pins, counterweights, summaries, cyclograms, clearances.

use linkage::pins::{Fit, Limit, Member, Mounting, Pin, PinError, Width};

/// The diameter of a clevis pin, loose in rod and fork, 10 mm and twice 5 mm wide.
///
/// # Errors
///
/// If the load is not positive.
pub fn pin_diameter(load: f64) -> Result<f64, PinError> {
    let member = |width| Member {
        width: Width::Fixed(width),
        pressure: Limit::allowable(30.0),
    };
    let pin = Pin {
        load,
        mounting: Mounting::Clevis {
            fit: Fit::Loose,
            rod: member(10.0),
            fork: member(5.0),
        },
        bending: Limit::new(400.0, 2.5),
        shear: Limit::new(250.0, 2.5),
    };
    Ok(pin.diameter()?.diameter)
}

/// The mass that leaves the least peak of forces.
///
/// # Errors
///
/// If there is nothing to balance.
#[cfg(feature = "alloc")]
pub fn counterweight(
    forces: &[[f64; 2]],
    effects: &[[[f64; 2]; 1]],
) -> Result<f64, linkage::balancing::BalanceError> {
    let [mass] = linkage::balancing::Balance::new(forces, effects)?
        .peak()?
        .values;
    Ok(mass)
}

/// How far the rocker swings, in radians.
///
/// # Errors
///
/// If it cannot be followed over the turn.
#[cfg(feature = "alloc")]
pub fn swing(rocker: impl Fn(f64) -> [f64; 2]) -> Result<f64, linkage::summary::SummaryError> {
    let turn = (0.0, core::f64::consts::TAU);
    let course = linkage::summary::Curve::new(turn, 360, rocker)?;
    Ok(course.position().stroke())
}

/// Where the rocker's dwell within a band below its highest position begins, in radians of the shaft.
#[cfg(feature = "alloc")]
pub fn dwell(rocker: impl Fn(f64) -> [f64; 2], band: f64) -> Option<f64> {
    use linkage::cyclogram::{Band, Event, Member, Motion};
    let turn = (0.0, core::f64::consts::TAU);
    let course = linkage::summary::Curve::new(turn, 360, rocker).ok()?;
    let member = Member::new("rocker", &course, &[Band::Top(band)]).ok()?;
    let begins = |event: &&Event| event.begins == Motion::Dwell(0);
    member.events().iter().find(begins).map(|event| event.at)
}

/// How close two points come.
///
/// # Errors
///
/// If they cannot be followed over the turn.
#[cfg(feature = "alloc")]
pub fn least_distance(
    points: impl Fn(f64) -> [[[f64; 2]; 3]; 2],
) -> Result<f64, linkage::summary::SummaryError> {
    let turn = (0.0, core::f64::consts::TAU);
    let pair = |x| points(x).map(|point| [point]).into();
    Ok(linkage::clearance::Clearance::new(turn, 90, pair)?
        .least()
        .distance)
}
