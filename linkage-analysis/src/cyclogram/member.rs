//! One member over a cycle.

use super::{Band, BandMistake, Cause, CyclogramError, Event, Motion};
use crate::summary::{Curve, CurveEvent, CurveEventKind, Interval};
use alloc::string::String;
use alloc::vec::Vec;

/// A working member of a machine over a cycle of the shaft.
///
/// ```
/// use linkage_analysis::cyclogram::{Band, Motion, Member};
/// use linkage_analysis::summary::Curve;
///
/// // A yoke of 40 mm that dwells, within 5 mm, at both ends of its stroke.
/// let yoke = |phi: f64| [40.0 * phi.sin(), 40.0 * phi.cos(), -40.0 * phi.sin()];
/// let curve = Curve::new((0.0, std::f64::consts::TAU), 90, yoke)?;
/// let member = Member::new("yoke", &curve, &[Band::Top(5.0), Band::Bottom(5.0)])?;
/// let motions: Vec<Motion> = member.intervals().map(|(motion, _)| motion).collect();
/// assert_eq!(motions, [Motion::Dwell(0), Motion::Return, Motion::Dwell(1), Motion::Advance]);
/// let begin = member.events()[0].at;
/// assert!((begin - (35.0f64 / 40.0).asin()).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Member {
    pub(super) name: String,
    pub(crate) unit: String,
    pub(super) range: (f64, f64),
    pub(super) limits: [f64; 2],
    pub(super) bands: Vec<Band>,
    pub(super) events: Vec<Event>,
    /// For each band, the place of its limit.
    pub(super) references: Vec<Option<f64>>,
    /// For each event, the derivatives of its angle with respect to the parameters.
    pub(super) sensitivities: Vec<f64>,
    /// For each event, its shift by tolerances.
    pub(super) shifts: Vec<f64>,
}

impl Member {
    /// Builds a member from the curve of a quantity over a cycle, and the bands in which it dwells.
    /// A rising quantity is an advance: reverse its sign if it is the other way.
    ///
    /// A band begins and ends where the quantity passes its bound, at roots to the last digits. The
    /// highest and the lowest position are the first ones of the highest and lowest limits.
    ///
    /// # Errors
    ///
    /// `NoCycle` if the range is none, `Gap` if there is a position that cannot be assembled,
    /// `Still` if it does not move, `Bands` for bands without width, that are not reached, that
    /// hold the whole motion, or that overlap: all of them.
    pub fn new<const N: usize, F: Fn(f64) -> [f64; N]>(
        name: impl Into<String>,
        curve: &Curve<N, F>,
        bands: &[Band],
    ) -> Result<Self, CyclogramError> {
        let member = name.into();
        if curve.has_gaps() {
            let parts = curve.parts();
            let parts = parts.iter().map(|part| (part.from, part.to)).collect();
            return Err(CyclogramError::Gap { member, parts });
        }
        let range = curve.range();
        if !curve.is_cycle() {
            let values = curve.ends();
            return Err(CyclogramError::NoCycle {
                member,
                range,
                values,
            });
        }
        let [lowest, highest] = [curve.position().lowest, curve.position().highest];
        let limits = [lowest.value, highest.value];
        if curve.position().limits().next().is_none() {
            let value = lowest.value;
            return Err(CyclogramError::Still { member, value });
        }
        let mistakes = mistakes(bands, limits);
        if !mistakes.is_empty() {
            return Err(CyclogramError::Bands {
                member,
                limits,
                mistakes,
            });
        }
        let references = bands.iter().map(|band| match band {
            Band::Top(_) => Some(highest.at),
            Band::Bottom(_) => Some(lowest.at),
            Band::Between(..) => None,
        });
        Ok(Self {
            name: member,
            unit: String::new(),
            range,
            limits,
            bands: bands.to_vec(),
            events: events(curve, bands, limits),
            references: references.collect(),
            sensitivities: Vec::new(),
            shifts: Vec::new(),
        })
    }

    /// Says the unit of the quantity, `mm`, for tables and messages.
    #[must_use]
    pub fn unit(mut self, unit: impl Into<String>) -> Self {
        self.unit = unit.into();
        self
    }

    /// Its name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The range of the shaft's angle: its cycle.
    #[must_use]
    pub fn range(&self) -> (f64, f64) {
        self.range
    }

    /// Its bands, in the order in which they were given.
    #[must_use]
    pub fn bands(&self) -> &[Band] {
        &self.bands
    }

    /// The lowest and the highest position.
    #[must_use]
    pub fn limits(&self) -> [f64; 2] {
        self.limits
    }

    /// The angles at which motions end and begin, in order.
    #[must_use]
    pub fn events(&self) -> &[Event] {
        &self.events
    }

    /// The motion in each interval. The first interval begins with the first event, the last one
    /// ends with it, across the seam.
    pub fn intervals(&self) -> impl ExactSizeIterator<Item = (Motion, Interval)> {
        let count = self.events.len();
        let width = self.range.1 - self.range.0;
        (0..count).map(move |i| {
            let (event, next) = (&self.events[i], &self.events[(i + 1) % count]);
            let over = if i + 1 == count { width } else { 0.0 };
            let interval = Interval {
                from: event.at,
                to: next.at,
                range: next.at + over - event.at,
            };
            (event.begins, interval)
        })
    }

    /// The motion at an angle of the range.
    #[must_use]
    pub fn motion(&self, angle: f64) -> Motion {
        let next = self.events.partition_point(|event| event.at <= angle);
        match next {
            0 => self.events[0].ends,
            next => self.events[next - 1].begins,
        }
    }

    /// The lead of the member on the shaft with which its event of this index happens at `angle`,
    /// from minus half to half a cycle: a lead of `x` makes everything `x` earlier.
    /// [`nearest_slot`](super::nearest_slot) sets it in steps.
    ///
    /// # Panics
    ///
    /// If there is no such event.
    #[must_use]
    pub fn lead(&self, event: usize, angle: f64) -> f64 {
        let cycle = self.range.1 - self.range.0;
        let lead = (self.events[event].at - angle) % cycle;
        match lead {
            lead if lead > 0.5 * cycle => lead - cycle,
            lead if lead < -0.5 * cycle => lead + cycle,
            lead => lead,
        }
    }
}

/// All that is wrong with the bands of a motion between these limits.
fn mistakes(bands: &[Band], limits: [f64; 2]) -> Vec<BandMistake> {
    let [lowest, highest] = limits;
    let mut mistakes = Vec::new();
    let mut good: Vec<(Band, [f64; 2])> = Vec::new();
    for &band in bands {
        let width = match band {
            Band::Top(width) | Band::Bottom(width) => width,
            Band::Between(low, high) => high - low,
        };
        let [low, high] = band.bounds(limits);
        if !(width.is_finite() && width > 0.0) {
            mistakes.push(BandMistake::Width { band });
        } else if low >= highest || high <= lowest {
            mistakes.push(BandMistake::Unreached { band });
        } else if low <= lowest && high >= highest {
            mistakes.push(BandMistake::Whole { band });
        } else {
            // Beyond the limits bands may overlap.
            let within = [low.max(lowest), high.min(highest)];
            let overlaps = good.iter().filter_map(|&(other, [a, b])| {
                let by = within[1].min(b) - within[0].max(a);
                let bands = [other, band];
                (by > 0.0).then_some(BandMistake::Overlap { bands, by })
            });
            mistakes.extend(overlaps);
            good.push((band, within));
        }
    }
    mistakes
}

fn events<const N: usize, F: Fn(f64) -> [f64; N]>(
    curve: &Curve<N, F>,
    bands: &[Band],
    limits: [f64; 2],
) -> Vec<Event> {
    let bounds: Vec<[f64; 2]> = bands.iter().map(|band| band.bounds(limits)).collect();
    let marks = curve.events(bounds.as_flattened());
    let motion = |a: &CurveEvent<N>, b: &CurveEvent<N>| {
        let [from, to] = [a.jet[0], b.jet[0]];
        let middle = from + 0.5 * (to - from);
        let inside = |[low, high]: &[f64; 2]| middle >= *low && middle <= *high;
        match bounds.iter().position(inside) {
            Some(band) => Motion::Dwell(band),
            None if to > from => Motion::Advance,
            None => Motion::Return,
        }
    };
    let count = marks.len();
    let motions: Vec<Motion> = (0..count)
        .map(|i| motion(&marks[i], &marks[(i + 1) % count]))
        .collect();
    let event = |i: usize| {
        let (mark, ends) = (&marks[i], motions[(i + count - 1) % count]);
        (ends != motions[i]).then(|| Event {
            at: mark.at,
            value: mark.jet[0],
            slope: mark.jet[1],
            bend: mark.jet.get(2).copied().unwrap_or(f64::NAN),
            cause: match mark.sign {
                CurveEventKind::Level(level) => Cause::Bound { band: level / 2 },
                CurveEventKind::Turn(_) => Cause::Turn,
            },
            ends,
            begins: motions[i],
        })
    };
    let mut events: Vec<Event> = (0..count).filter_map(event).collect();
    events.sort_by(|a, b| a.at.total_cmp(&b.at));
    events
}
