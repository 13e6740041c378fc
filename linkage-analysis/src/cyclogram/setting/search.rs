//! The search for such values.

use super::error::SettingError;
use super::value::{Setting, VALUES};
use crate::cyclogram::event::Event;
use crate::cyclogram::member::Member;
use alloc::string::String;
use alloc::vec::Vec;

/// Steps to a root: halvings alone leave nothing between two numbers after as many as these.
const STEPS: usize = 64;
/// Roundoffs of the value below which a step changes nothing any more.
const ROUNDOFFS: f64 = 2.0;
/// Greatest distance from the wanted angle, in radians, of an event that is at it: the angle has
/// more digits unless the curve hardly passes its bound. A jump is farther away.
const REACHED: f64 = 1e-9;
/// Roots of one event that are no farther apart than this part of the range are one: each is known
/// to some roundoffs over the slope.
const SAME: f64 = 1e-9;

/// One event with one value of the parameter.
#[derive(Clone, Copy, Debug)]
struct EventAt {
    value: f64,
    /// The excess of its angle over the wanted one, from minus half to half a cycle.
    off: f64,
    /// Its angle.
    at: f64,
    /// The derivative of its angle by the parameter.
    slope: f64,
    event: usize,
}

pub(super) struct SettingSearch<B, W> {
    pub(super) build: B,
    pub(super) event: W,
    pub(super) parameter: usize,
    pub(super) angle: f64,
    pub(super) range: (f64, f64),
    /// Name and cycle of the member, once it has been built.
    pub(super) member: Option<(String, f64)>,
}

impl<E, B: FnMut(f64) -> Result<Member, E>, W: Fn(&Event) -> bool> SettingSearch<B, W> {
    pub(super) fn run(mut self) -> Result<Vec<Setting>, SettingError<E>> {
        let mut looks: Vec<Vec<EventAt>> = Vec::with_capacity(VALUES);
        let mut first = None;
        for value in crate::summary::positions(self.range, VALUES) {
            match (self.build)(value) {
                Ok(member) => looks.push(self.events_at(value, &member)?),
                Err(error) => {
                    first = first.or(Some(error));
                    looks.push(Vec::new());
                }
            }
        }
        let range = self.range;
        if let (None, Some(error)) = (&self.member, first) {
            return Err(SettingError::Unbuilt { range, error });
        }
        let (member, _) = self.member.clone().unwrap_or_default();
        let mut nearest: Option<EventAt> = None;
        let mut roots: Vec<EventAt> = Vec::new();
        let mut take = |event_at: EventAt| {
            if nearest.is_none_or(|best| event_at.off.abs() < best.off.abs()) {
                nearest = Some(event_at);
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
            None => Err(SettingError::NoEvent { range, member }),
            Some(nearest) if roots.is_empty() => Err(SettingError::Unreached {
                member,
                wanted: self.angle,
                nearest: nearest.at,
                value: nearest.value,
                range,
            }),
            Some(_) => Ok(roots
                .into_iter()
                .filter_map(|root| self.setting(root))
                .collect()),
        }
    }

    fn setting(&mut self, event_at: EventAt) -> Option<Setting> {
        let member = (self.build)(event_at.value).ok()?;
        Some(Setting {
            value: event_at.value,
            member,
            event: event_at.event,
        })
    }

    /// The events that are meant, with a value of the parameter.
    fn events_at(&mut self, value: f64, member: &Member) -> Result<Vec<EventAt>, SettingError<E>> {
        let (low, high) = member.range();
        self.member
            .get_or_insert_with(|| (member.name().into(), high - low));
        let meant = member.events().iter().enumerate();
        let meant = meant.filter(|(_, event)| (self.event)(event));
        let event_at = |(event, happening): (usize, &Event)| {
            let sensitivities = member.sensitivity(event);
            match sensitivities.and_then(|sensitivities| sensitivities.get(self.parameter)) {
                Some(&slope) => Ok(EventAt {
                    value,
                    off: member.lead(event, self.angle),
                    at: happening.at,
                    slope,
                    event,
                }),
                None => Err(SettingError::Parameter {
                    member: member.name().into(),
                    parameter: self.parameter,
                    sensitivities: sensitivities.map(<[f64]>::len),
                }),
            }
        };
        meant.map(event_at).collect()
    }

    /// The same event with another value; `None` where there is none.
    fn with_value(&mut self, value: f64, beside: EventAt) -> Option<EventAt> {
        let member = (self.build)(value).ok()?;
        let events_at = self.events_at(value, &member).ok()?;
        let expected = EventAt {
            value,
            off: beside.off + (value - beside.value) * beside.slope,
            ..beside
        };
        events_at.into_iter().min_by(|a, b| {
            (a.off - expected.off)
                .abs()
                .total_cmp(&(b.off - expected.off).abs())
        })
    }

    /// Between two values, where the angle turns back: its derivative changes its sign there.
    /// `None` where it does not.
    fn turn(&mut self, mut low: EventAt, mut high: EventAt) -> Option<EventAt> {
        if low.slope * high.slope >= 0.0 || self.is_turned(low, high) {
            return None;
        }
        for _ in 0..STEPS {
            let middle = 0.5 * (low.value + high.value);
            if middle <= low.value || middle >= high.value {
                break;
            }
            let next = self.with_value(middle, low)?;
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
    fn root(&mut self, mut low: EventAt, mut high: EventAt) -> Option<EventAt> {
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
            let next = self.with_value(value, best)?;
            // Steps that do not even halve the remaining interval: the interval is halved between
            // them.
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
        // An event that jumps across the angle is never at it.
        (best.off.abs() <= REACHED).then_some(best)
    }

    /// Returns true if the sign changes at the seam of the cycle, and not at the event.
    fn is_turned(&self, low: EventAt, high: EventAt) -> bool {
        let cycle = self.member.as_ref().map_or(0.0, |member| member.1);
        (low.off - high.off).abs() > 0.5 * cycle
    }
}

/// Among the events with the next value, which one is the same as this one: that where its
/// derivative leads.
fn nearest_to(events_at: &[EventAt], before: EventAt) -> Option<EventAt> {
    let away = |other: &EventAt| {
        let slope = 0.5 * (before.slope + other.slope);
        (before.off + slope * (other.value - before.value) - other.off).abs()
    };
    let found = events_at.iter().min_by(|a, b| away(a).total_cmp(&away(b)));
    found.copied()
}
