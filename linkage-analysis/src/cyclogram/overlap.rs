//! Simultaneous motions of several members.

use super::{Cyclogram, Motion};
use crate::summary::Interval;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;

/// An interval in which two members do the same at once: both dwell, in whichever bands, both
/// advance or both return.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Overlap {
    /// The indices of the members, the lower one first.
    pub members: [usize; 2],
    /// The motion of each of them.
    pub motions: [Motion; 2],
    /// When both do it.
    pub interval: Interval,
}

/// All overlaps of a machine's members. Printed, they are a table.
#[derive(Clone, Debug)]
pub struct Overlaps<'a> {
    pub(crate) cyclogram: &'a Cyclogram,
    found: Vec<Overlap>,
}

impl Cyclogram {
    /// The intervals in which two members do the same at once: pair by pair, in the order of the
    /// members, each pair in the order of the angle. [`together`](Self::together) finds other
    /// simultaneous motions.
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
    /// assert_eq!(machine.overlaps().to_string(), "\
    /// from, deg   to, deg  for, deg  organs     both
    ///   30.0000  130.0000  100.0000  hook, eye  dwell (top 0.5), dwell (top 0.5)
    ///  150.0000  250.0000  100.0000  hook, eye  return
    ///  270.0000   10.0000  100.0000  hook, eye  advance
    /// ");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn overlaps(&self) -> Overlaps<'_> {
        let mut found = Vec::new();
        for later in 0..self.members.len() {
            for member in 0..later {
                found.extend(self.overlaps_of([member, later]));
            }
        }
        found.sort_by(|a: &Overlap, b| {
            let order = a.members.cmp(&b.members);
            order.then(a.interval.from.total_cmp(&b.interval.from))
        });
        Overlaps {
            cyclogram: self,
            found,
        }
    }

    fn overlaps_of(&self, members: [usize; 2]) -> Vec<Overlap> {
        let mut found = Vec::new();
        let [first, second] = members.map(|member| &self.members[member]);
        for (motion, interval) in first.intervals() {
            for (other, beside) in second.intervals() {
                if !alike(motion, other) {
                    continue;
                }
                let common = self.common(&interval, &beside).into_iter();
                found.extend(common.map(|interval| Overlap {
                    members,
                    motions: [motion, other],
                    interval,
                }));
            }
        }
        found
    }

    /// The common part of two intervals of the cycle: nothing, one interval, or two if both
    /// together are longer than a cycle.
    fn common(&self, a: &Interval, b: &Interval) -> Vec<Interval> {
        let (low, high) = self.range;
        let cycle = self.width();
        let turned = [-cycle, 0.0, cycle].into_iter().filter_map(|turn| {
            let from = a.from.max(b.from + turn);
            let to = (a.from + a.range).min(b.from + b.range + turn);
            (to > from).then_some([from, to])
        });
        let within = |x: f64| if x > high { x - cycle } else { x };
        let interval = |[from, to]: [f64; 2]| Interval {
            // An interval from the end of the range begins the next cycle.
            from: if from >= high {
                from - cycle
            } else {
                from.max(low)
            },
            to: within(to),
            range: to - from,
        };
        turned.map(interval).collect()
    }
}

const fn alike(a: Motion, b: Motion) -> bool {
    matches!(
        (a, b),
        (Motion::Advance, Motion::Advance)
            | (Motion::Dwell(_), Motion::Dwell(_))
            | (Motion::Return, Motion::Return)
    )
}

impl Overlaps<'_> {
    /// All of them, in order.
    #[must_use]
    pub fn all(&self) -> &[Overlap] {
        &self.found
    }

    /// The common motion, for dwells with their bands.
    fn described(&self, overlap: &Overlap) -> String {
        let motion = |k: usize| {
            let member = &self.cyclogram.members[overlap.members[k]];
            overlap.motions[k].described(member.bands(), &member.unit)
        };
        if overlap.motions[0].is_dwell() {
            format!("{}, {}", motion(0), motion(1))
        } else {
            motion(0).to_string()
        }
    }
}

/// One line for each, in degrees: begin, end and length, the members, and their common motion.
impl fmt::Display for Overlaps<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let names = |overlap: &Overlap| {
            let [a, b] = overlap
                .members
                .map(|member| self.cyclogram.members[member].name());
            format!("{a}, {b}")
        };
        let widths = self
            .found
            .iter()
            .map(|overlap| names(overlap).chars().count());
        let width = widths.max().unwrap_or(0).max("organs".len());
        writeln!(
            f,
            "from, deg   to, deg  for, deg  {:width$}  both",
            "organs"
        )?;
        for overlap in &self.found {
            let Interval { from, to, range } = overlap.interval;
            let [from, to, range] = [from, to, range].map(f64::to_degrees);
            let (names, both) = (names(overlap), self.described(overlap));
            writeln!(f, "{from:9.4} {to:9.4} {range:9.4}  {names:width$}  {both}")?;
        }
        Ok(())
    }
}
