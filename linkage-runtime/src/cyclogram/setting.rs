//! The value of a parameter at which an event is at a wanted angle.

use super::{Event, Organ};
use crate::words::rounded;
use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;

/// So many values of the parameter are looked at, evenly over its range, before anything is located: an event that does more between
/// two of them than turn back once is missed.
const VALUES: usize = 33;
/// Steps to a root: halvings alone leave nothing between two numbers after as many as these.
const STEPS: usize = 64;
/// A step that is less than so many roundoffs of the value changes nothing any more.
const ROUNDOFFS: f64 = 2.0;
/// An event that is no farther from the wanted angle, in radians, is at it: its own angle has more digits unless it hardly passes its
/// bound. What jumps is farther.
const REACHED: f64 = 1e-9;
/// Roots of one event that are no farther apart than this part of the range are one: each is known to some roundoffs over the slope.
const SAME: f64 = 1e-9;

/// A value of the parameter at which the event is at the wanted angle.
#[derive(Clone, Debug)]
pub struct Setting {
    /// The value.
    pub value: f64,
    /// The organ with it.
    pub organ: Organ,
    /// The index of the event.
    pub event: usize,
}

/// Why an event cannot be set to an angle. `E` is what building an organ fails with.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum SettingError<E> {
    /// No organ can be built with any value that was looked at.
    Unbuilt {
        /// The range of the parameter.
        range: (f64, f64),
        /// Why there is none with the first value.
        error: E,
    },
    /// The organs have no such event.
    NoEvent {
        /// The range of the parameter.
        range: (f64, f64),
        /// The organ.
        organ: String,
    },
    /// The organ has no sensitivities, or none to this parameter.
    Parameter {
        /// The organ.
        organ: String,
        /// The index of the parameter.
        parameter: usize,
        /// How many parameters the sensitivities are by; `None` if there are none.
        sensitivities: Option<usize>,
    },
    /// The event is nowhere at the wanted angle.
    Unreached {
        /// The organ.
        organ: String,
        /// The wanted angle.
        wanted: f64,
        /// The nearest angle that was found: at the values that are looked at, the ends of the range among them, and where the
        /// angle turns back between them.
        nearest: f64,
        /// At this value of the parameter.
        value: f64,
        /// The range of the parameter.
        range: (f64, f64),
    },
}

/// One event with one value of the parameter.
#[derive(Clone, Copy, Debug)]
struct Place {
    value: f64,
    /// By how much its angle is more than the wanted one, from minus half to half a cycle.
    off: f64,
    /// Its angle.
    at: f64,
    /// The derivative of its angle by the parameter.
    slope: f64,
    event: usize,
}

struct Search<B, W> {
    build: B,
    event: W,
    parameter: usize,
    angle: f64,
    range: (f64, f64),
    /// Name and cycle of the organ, once it has been built.
    organ: Option<(String, f64)>,
}

/// The values of a parameter at which an event of an organ is at a wanted angle, in their order: a phase between two drives of one organ,
/// a dimension. (An organ that is turned as a whole needs no search: [`Organ::lead`].)
///
/// `build` makes the organ with a value of the parameter out of `range`, with [sensitivities](Organ::sensitivities), of which
/// `parameter` is the index; `event` says which events are meant. Values with which there is no organ are passed over. Roots are found
/// by Newton's method with the sensitivity of the event, between values on both sides of them, to the last digits. Before that 33 values,
/// evenly over the range, are looked at.
///
/// ```
/// use linkage_runtime::cyclogram::{Band, Organ, set_event};
/// use linkage_runtime::summary::Course;
/// use std::f64::consts::TAU;
///
/// // A sinker on two eccentrics; the second one can be turned on the shaft.
/// let sinker = |lead: f64| -> Result<Organ, Box<dyn std::error::Error>> {
///     let lift = |x: f64| {
///         let ((s, c), (s2, c2)) = (x.sin_cos(), (2.0 * x + lead).sin_cos());
///         [10.0 * c + 3.0 * c2, -10.0 * s - 6.0 * s2, -10.0 * c - 12.0 * c2]
///     };
///     let by_lead = |x: f64| [-3.0 * (2.0 * x + lead).sin()];
///     let its_rate = |x: f64| [-6.0 * (2.0 * x + lead).cos()];
///     let course = Course::of((0.0, TAU), 90, lift)?;
///     Ok(Organ::new("sinker", &course, &[Band::Top(1.0)])?.sensitivities(by_lead, its_rate))
/// };
/// let wanted = 25f64.to_radians();
/// let settings = set_event((-1.0, 1.0), 0, sinker, |event| event.ends.is_dwell(), wanted)?;
/// let found = &settings[0];
/// assert!((found.organ.events()[found.event].at - wanted).abs() < 1e-14);
///
/// // Where an angle is out of reach, the message has the nearest one.
/// let error = set_event((-1.0, 1.0), 0, sinker, |event| event.ends.is_dwell(), 2.0).unwrap_err();
/// assert!(error.to_string().starts_with("no event of `sinker` that is meant is at 114.592 deg: the nearest angle is "));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// `Unbuilt`, `NoEvent`, `Parameter` without a sensitivity to the parameter, `Unreached` with the nearest angle.
pub fn set_event<E>(
    range: (f64, f64),
    parameter: usize,
    build: impl FnMut(f64) -> Result<Organ, E>,
    event: impl Fn(&Event) -> bool,
    angle: f64,
) -> Result<Vec<Setting>, SettingError<E>> {
    let search = Search {
        build,
        event,
        parameter,
        angle,
        range,
        organ: None,
    };
    search.run()
}

impl<E, B: FnMut(f64) -> Result<Organ, E>, W: Fn(&Event) -> bool> Search<B, W> {
    fn run(mut self) -> Result<Vec<Setting>, SettingError<E>> {
        let mut looks: Vec<Vec<Place>> = Vec::with_capacity(VALUES);
        let mut first = None;
        for value in crate::summary::positions(self.range, VALUES) {
            match (self.build)(value) {
                Ok(organ) => looks.push(self.places(value, &organ)?),
                Err(error) => {
                    first = first.or(Some(error));
                    looks.push(Vec::new());
                }
            }
        }
        let range = self.range;
        if let (None, Some(error)) = (&self.organ, first) {
            return Err(SettingError::Unbuilt { range, error });
        }
        let (organ, _) = self.organ.clone().unwrap_or_default();
        let mut nearest: Option<Place> = None;
        let mut roots: Vec<Place> = Vec::new();
        let mut take = |place: Place| {
            if nearest.is_none_or(|own| place.off.abs() < own.off.abs()) {
                nearest = Some(place);
            }
        };
        for pair in looks.windows(2) {
            pair.iter().flatten().copied().for_each(&mut take);
            for &low in &pair[0] {
                let Some(high) = nearest_to(&pair[1], low) else {
                    continue;
                };
                let stretches = match self.turn(low, high) {
                    Some(turn) => {
                        take(turn);
                        Vec::from([[low, turn], [turn, high]])
                    }
                    None => Vec::from([[low, high]]),
                };
                for [low, high] in stretches {
                    roots.extend(self.root(low, high));
                }
            }
        }
        roots.sort_by(|a, b| a.value.total_cmp(&b.value));
        // One that ends two stretches is found twice.
        let near = SAME * (range.1 - range.0).abs();
        roots.dedup_by(|a, b| (a.value - b.value).abs() <= near && a.event == b.event);
        match nearest {
            None => Err(SettingError::NoEvent { range, organ }),
            Some(nearest) if roots.is_empty() => Err(SettingError::Unreached {
                organ,
                wanted: self.angle,
                nearest: nearest.at,
                value: nearest.value,
                range,
            }),
            Some(_) => Ok(roots
                .into_iter()
                .filter_map(|own| self.setting(own))
                .collect()),
        }
    }

    fn setting(&mut self, place: Place) -> Option<Setting> {
        let organ = (self.build)(place.value).ok()?;
        Some(Setting {
            value: place.value,
            organ,
            event: place.event,
        })
    }

    /// The events that are meant, with a value of the parameter.
    fn places(&mut self, value: f64, organ: &Organ) -> Result<Vec<Place>, SettingError<E>> {
        let (low, high) = organ.range();
        self.organ
            .get_or_insert_with(|| (organ.name().into(), high - low));
        let meant = organ.events().iter().enumerate();
        let meant = meant.filter(|(_, event)| (self.event)(event));
        let place = |(event, own): (usize, &Event)| {
            let all = organ.sensitivity(event);
            match all.and_then(|all| all.get(self.parameter)) {
                Some(&slope) => Ok(Place {
                    value,
                    off: organ.lead(event, self.angle),
                    at: own.at,
                    slope,
                    event,
                }),
                None => Err(SettingError::Parameter {
                    organ: organ.name().into(),
                    parameter: self.parameter,
                    sensitivities: all.map(<[f64]>::len),
                }),
            }
        };
        meant.map(place).collect()
    }

    /// The same event with another value; `None` where there is none.
    fn at(&mut self, value: f64, beside: Place) -> Option<Place> {
        let organ = (self.build)(value).ok()?;
        let places = self.places(value, &organ).ok()?;
        let expected = Place {
            value,
            off: beside.off + (value - beside.value) * beside.slope,
            ..beside
        };
        places.into_iter().min_by(|a, b| {
            (a.off - expected.off)
                .abs()
                .total_cmp(&(b.off - expected.off).abs())
        })
    }

    /// Between two values, where the angle turns back: its derivative changes its sign there. `None` where it does not.
    fn turn(&mut self, mut low: Place, mut high: Place) -> Option<Place> {
        if low.slope * high.slope >= 0.0 || self.is_turned(low, high) {
            return None;
        }
        for _ in 0..STEPS {
            let middle = 0.5 * (low.value + high.value);
            if middle <= low.value || middle >= high.value {
                break;
            }
            let next = self.at(middle, low)?;
            if next.slope * low.slope > 0.0 {
                low = next;
            } else {
                high = next;
            }
        }
        Some(if low.off.abs() < high.off.abs() {
            low
        } else {
            high
        })
    }

    /// The root between two values at which the event is on different sides of the wanted angle.
    fn root(&mut self, mut low: Place, mut high: Place) -> Option<Place> {
        if low.off * high.off > 0.0 || self.is_turned(low, high) {
            return None;
        }
        let mut best = if low.off.abs() < high.off.abs() {
            low
        } else {
            high
        };
        let size = (self.range.1 - self.range.0).abs().max(best.value.abs());
        let mut halve = false;
        for _ in 0..STEPS {
            let middle = 0.5 * (low.value + high.value);
            if best.off == 0.0 || middle <= low.value || middle >= high.value {
                break;
            }
            let newton = best.value - best.off / best.slope;
            let inside = newton > low.value && newton < high.value && !halve;
            let value = if inside { newton } else { middle };
            if (value - best.value).abs() <= ROUNDOFFS * f64::EPSILON * size {
                break;
            }
            let next = self.at(value, best)?;
            // Steps that do not even halve what is left: the interval is halved between them.
            halve = !halve && next.off.abs() > 0.5 * best.off.abs();
            if next.off * low.off > 0.0 {
                low = next;
            } else {
                high = next;
            }
            if next.off.abs() < best.off.abs() {
                best = next;
            }
        }
        // What jumps across the angle is never at it.
        (best.off.abs() <= REACHED).then_some(best)
    }

    /// Whether what changes its sign between two values is the way round the cycle, and not the event.
    fn is_turned(&self, low: Place, high: Place) -> bool {
        let cycle = self.organ.as_ref().map_or(0.0, |organ| organ.1);
        (low.off - high.off).abs() > 0.5 * cycle
    }
}

/// Among the events with the next value, which one is the same as this one: that where its derivative leads.
fn nearest_to(places: &[Place], own: Place) -> Option<Place> {
    let away = |other: &Place| {
        let slope = 0.5 * (own.slope + other.slope);
        (own.off + slope * (other.value - own.value) - other.off).abs()
    };
    let found = places.iter().min_by(|a, b| away(a).total_cmp(&away(b)));
    found.copied()
}

impl<E: fmt::Display> fmt::Display for SettingError<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unbuilt { range, error } => write!(
                f,
                "there is no organ with any of the {VALUES} values from {} to {} of the parameter that were looked at; with the first \
                 one: {error}",
                rounded(range.0),
                rounded(range.1)
            ),
            Self::NoEvent { range, organ } => write!(
                f,
                "`{organ}` has no event that is meant, with any of the {VALUES} values from {} to {} of the parameter that were \
                 looked at",
                rounded(range.0),
                rounded(range.1)
            ),
            Self::Parameter {
                organ,
                parameter,
                sensitivities: Some(count),
            } => write!(
                f,
                "`{organ}` has sensitivities to {count} parameters, and none with the index {parameter}"
            ),
            Self::Parameter { organ, .. } => write!(
                f,
                "`{organ}` has no sensitivities, which lead to the wanted angle\nhelp: call `sensitivities` on the organ that is built"
            ),
            Self::Unreached {
                organ,
                wanted,
                nearest,
                value,
                range,
            } => write!(
                f,
                "no event of `{organ}` that is meant is at {} deg: the nearest angle is {} deg, where the parameter is {} (from {} to \
                 {})\nhelp: give a wider range, or change another parameter",
                rounded(wanted.to_degrees()),
                rounded(nearest.to_degrees()),
                rounded(*value),
                rounded(range.0),
                rounded(range.1)
            ),
        }
    }
}

impl<E: fmt::Debug + fmt::Display> core::error::Error for SettingError<E> {}
