//! The values of a parameter at which an event is at a wanted angle.

use super::error::SettingError;
use super::search::SettingSearch;
use super::value::Setting;
use crate::cyclogram::event::Event;
use crate::cyclogram::member::Member;
use alloc::vec::Vec;

/// The values of a parameter at which an event of a member is at a wanted angle, in their order: a
/// phase between two drives of one member, a dimension. (A member that is turned as a whole needs
/// no search: [`Member::lead`].)
///
/// `build` makes the member with a value of the parameter out of `range`, with
/// [sensitivities](Member::sensitivities), of which `parameter` is the index; `event` selects the
/// events. Values with which there is no member are passed over. Roots are found by
/// Newton's method with the sensitivity of the event, between values on both sides of them, to the
/// last digits. Before that 33 values, evenly over the range, are looked at.
///
/// ```
/// use linkage_analysis::cyclogram::{Band, Member, set_event};
/// use linkage_analysis::summary::Curve;
/// use std::f64::consts::TAU;
///
/// // A sinker on two eccentrics; the second one can be turned on the shaft.
/// let sinker = |lead: f64| -> Result<Member, Box<dyn std::error::Error>> {
///     let lift = |x: f64| {
///         let ((s, c), (s2, c2)) = (x.sin_cos(), (2.0 * x + lead).sin_cos());
///         [10.0 * c + 3.0 * c2, -10.0 * s - 6.0 * s2, -10.0 * c - 12.0 * c2]
///     };
///     let by_lead = |x: f64| [-3.0 * (2.0 * x + lead).sin()];
///     let its_rate = |x: f64| [-6.0 * (2.0 * x + lead).cos()];
///     let curve = Curve::new((0.0, TAU), 90, lift)?;
///     Ok(Member::new("sinker", &curve, &[Band::Top(1.0)])?.sensitivities(by_lead, its_rate))
/// };
/// let wanted = 25f64.to_radians();
/// let settings = set_event((-1.0, 1.0), 0, sinker, |event| event.ends.is_dwell(), wanted)?;
/// let found = &settings[0];
/// assert!((found.member.events()[found.event].at - wanted).abs() < 1e-14);
///
/// // Where an angle is out of reach, the message has the nearest one.
/// let error = set_event((-1.0, 1.0), 0, sinker, |event| event.ends.is_dwell(), 2.0).unwrap_err();
/// let expected = "no event of `sinker` that is meant is at 114.592 deg: the nearest angle is ";
/// assert!(error.to_string().starts_with(expected));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// `Unbuilt`, `NoEvent`, `Parameter` without a sensitivity to the parameter, `Unreached` with the
/// nearest angle.
pub fn set_event<E>(
    range: (f64, f64),
    parameter: usize,
    build: impl FnMut(f64) -> Result<Member, E>,
    event: impl Fn(&Event) -> bool,
    angle: f64,
) -> Result<Vec<Setting>, SettingError<E>> {
    let search = SettingSearch {
        build,
        event,
        parameter,
        angle,
        range,
        member: None,
    };
    search.run()
}
