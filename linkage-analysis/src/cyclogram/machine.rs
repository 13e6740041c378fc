//! All members of a shaft.

use super::{CyclogramError, Lag, Member, Moment, Motion};
use crate::summary::Interval;
use alloc::vec::Vec;

/// The members of a machine over a cycle of its main shaft.
///
/// ```
/// use linkage_analysis::cyclogram::{Band, Cyclogram, Member};
/// use linkage_analysis::summary::Curve;
///
/// let member = |name: &str, lead: f64| -> Result<Member, Box<dyn std::error::Error>> {
///     let lift = |x: f64| [(x + lead).sin(), (x + lead).cos(), -(x + lead).sin()];
///     let curve = Curve::new((0.0, std::f64::consts::TAU), 90, lift)?;
///     Ok(Member::new(name, &curve, &[Band::Top(0.5)])?)
/// };
/// let machine = Cyclogram::new([member("hook", 0.0)?, member("eye", 20f64.to_radians())?])?;
/// assert_eq!(machine.to_string(), "\
/// cycle of 360 deg, from 0 to 360 deg
///
///  at, deg     after  organ  ends             begins
///  10.0000  100.0000  eye    advance          dwell (top 0.5)
///  30.0000   20.0000  hook   advance          dwell (top 0.5)
/// 130.0000  100.0000  eye    dwell (top 0.5)  return
/// 150.0000   20.0000  hook   dwell (top 0.5)  return
/// 250.0000  100.0000  eye    return           advance
/// 270.0000   20.0000  hook   return           advance
/// ");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub struct Cyclogram {
    pub(crate) members: Vec<Member>,
    pub(crate) range: (f64, f64),
    /// Indices of members and of their events, in order of the angle.
    order: Vec<[usize; 2]>,
}

impl Cyclogram {
    /// The members of a shaft, in the order in which they are listed and drawn.
    ///
    /// # Errors
    ///
    /// `Ranges` if two of them were followed over different ranges.
    pub fn new(members: impl IntoIterator<Item = Member>) -> Result<Self, CyclogramError> {
        let members: Vec<Member> = members.into_iter().collect();
        let range = members.first().map_or((0.0, 0.0), |member| member.range);
        if let Some(other) = members.iter().find(|member| member.range != range) {
            return Err(CyclogramError::Ranges {
                members: [&members[0], other].map(|member| member.name.clone()),
                ranges: [range, other.range],
            });
        }
        let events = |(member, one): (usize, &Member)| {
            (0..one.events.len()).map(move |event| [member, event])
        };
        let mut order: Vec<[usize; 2]> = members.iter().enumerate().flat_map(events).collect();
        order.sort_by(|&[a, i], &[b, k]| {
            let [x, y] = [members[a].events[i].at, members[b].events[k].at];
            x.total_cmp(&y)
        });
        Ok(Self {
            members,
            range,
            order,
        })
    }

    /// The members, as they were given.
    #[must_use]
    pub fn members(&self) -> &[Member] {
        &self.members
    }

    /// The member of this name.
    #[must_use]
    pub fn member(&self, name: &str) -> Option<&Member> {
        self.members.iter().find(|member| member.name == name)
    }

    /// The range of the shaft's angle: the cycle.
    #[must_use]
    pub fn range(&self) -> (f64, f64) {
        self.range
    }

    /// The events of all members, in order of the angle.
    pub fn moments(&self) -> impl ExactSizeIterator<Item = Moment<'_>> {
        let count = self.order.len();
        let event = |i: usize| {
            let [member, index] = self.order[i];
            let member = &self.members[member];
            (member, index, &member.events[index])
        };
        (0..count).map(move |i| {
            let (member, index, happened) = event(i);
            let before = event((i + count - 1) % count).2.at;
            let after = if i == 0 {
                happened.at - before + self.width()
            } else {
                happened.at - before
            };
            Moment {
                member,
                index,
                event: happened,
                after,
            }
        })
    }

    /// The intervals in which the simultaneous motions of all members, in the order of the members,
    /// satisfy a condition: `|motions| motions[0].is_dwell() && motions[1].is_dwell()` for overlaps
    /// of dwells. They are in order of the angle; an interval that goes across the seam is a single
    /// one.
    #[must_use]
    pub fn together(&self, condition: impl Fn(&[Motion]) -> bool) -> Vec<Interval> {
        let low = self.range.0;
        let mut motions: Vec<Motion> = self
            .members
            .iter()
            .map(|member| {
                member
                    .events
                    .last()
                    .map_or(Motion::Advance, |last| last.begins)
            })
            .collect();
        let at_seam = condition(&motions);
        let mut since = at_seam.then_some(low);
        let mut found: Vec<[f64; 2]> = Vec::new();
        for (i, &[member, event]) in self.order.iter().enumerate() {
            let event = &self.members[member].events[event];
            motions[member] = event.begins;
            // Several events at one angle are one change.
            let next = self.order.get(i + 1);
            if next.is_some_and(|&[other, index]| self.members[other].events[index].at == event.at)
            {
                continue;
            }
            match (since, condition(&motions)) {
                (None, true) => since = Some(event.at),
                (Some(from), false) => {
                    found.push([from, event.at]);
                    since = None;
                }
                _ => {}
            }
        }
        if let Some(from) = since {
            let whole = found.is_empty() && from == low;
            match found.first().filter(|_| at_seam && !whole) {
                // It goes on across the seam.
                Some(&[_, end]) => {
                    found.remove(0);
                    found.push([from, end + self.width()]);
                }
                None => found.push([from, self.range.1]),
            }
        }
        let interval = |[from, to]: [f64; 2]| Interval {
            from,
            to: if to > self.range.1 {
                to - self.width()
            } else {
                to
            },
            range: to - from,
        };
        let found = found.into_iter().map(interval);
        found.filter(|interval| interval.range > 0.0).collect()
    }

    /// Turn of the shaft from an event `a` to the next `b`.
    ///
    /// ```
    /// use linkage_analysis::cyclogram::{Band, Cyclogram, Motion, Member};
    /// use linkage_analysis::summary::Curve;
    ///
    /// let member = |name: &str, lead: f64| -> Result<Member, Box<dyn std::error::Error>> {
    ///     let lift = |x: f64| [(x + lead).sin(), (x + lead).cos(), -(x + lead).sin()];
    ///     let curve = Curve::new((0.0, std::f64::consts::TAU), 90, lift)?;
    ///     Ok(Member::new(name, &curve, &[Band::Top(0.5)])?.unit("mm"))
    /// };
    /// let machine = Cyclogram::new([member("hook", 0.0)?, member("eye", 20f64.to_radians())?])?;
    /// let hook = machine.begin("hook", Motion::Dwell(0)).expect("it dwells");
    /// let eye = machine.end("eye", Motion::Dwell(0)).expect("it dwells");
    /// let lag = machine.after(&hook, &eye);
    /// assert!((lag.angle - 100f64.to_radians()).abs() < 1e-14);
    /// assert_eq!(
    ///     lag.to_string(),
    ///     "eye's dwell (top 0.5 mm) ends 100.0000 deg after hook's dwell (top 0.5 mm) begins"
    /// );
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn after<'a>(&self, a: &Moment<'a>, b: &Moment<'a>) -> Lag<'a> {
        let cycle = self.width();
        let angle = (b.event.at - a.event.at) % cycle;
        Lag {
            from: *a,
            to: *b,
            angle: if angle < 0.0 { angle + cycle } else { angle },
        }
    }

    /// The first event of the cycle at which the member of this name begins a motion; `None` if
    /// there is no such member, or it never does that.
    #[must_use]
    pub fn begin(&self, member: &str, motion: Motion) -> Option<Moment<'_>> {
        self.moments()
            .find(|moment| moment.member.name() == member && moment.event.begins == motion)
    }

    /// The same where it ends a motion.
    #[must_use]
    pub fn end(&self, member: &str, motion: Motion) -> Option<Moment<'_>> {
        self.moments()
            .find(|moment| moment.member.name() == member && moment.event.ends == motion)
    }

    pub(super) fn width(&self) -> f64 {
        self.range.1 - self.range.0
    }
}
