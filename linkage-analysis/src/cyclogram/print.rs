//! A cyclogram as a table to be read.

use super::{Cyclogram, Event, Moment, Motion};
use alloc::format;
use alloc::string::{String, ToString};
use core::fmt;
use linkage_core::format::rounded;

/// The events of all members in order of the angle, in degrees: angle, distance from the event
/// before, member, ending and beginning motion, and the shift by tolerances, if they were given.
impl fmt::Display for Cyclogram {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (low, high) = self.range();
        let [width, from, to] = [high - low, low, high].map(|x| rounded(x.to_degrees()));
        writeln!(f, "cycle of {width} deg, from {from} to {to} deg\n")?;
        let name = |moment: &Moment<'_>| moment.member.name().to_string();
        let ends = |moment: &Moment<'_>| described(moment, moment.event.ends);
        let widest = |word: &dyn Fn(&Moment<'_>) -> String, title: &str| {
            let words = self.moments().map(|moment| word(&moment).chars().count());
            words.max().unwrap_or(0).max(title.len())
        };
        let (names, endings) = (widest(&name, "organ"), widest(&ends, "ends"));
        let tolerances = self
            .members()
            .iter()
            .any(|member| member.shift(0).is_some());
        let shift = if tolerances { "  +- deg" } else { "" };
        writeln!(
            f,
            " at, deg     after{shift}  {:names$}  {:endings$}  begins",
            "organ", "ends"
        )?;
        for moment in self.moments() {
            let [at, after] = [moment.event.at, moment.after].map(f64::to_degrees);
            write!(f, "{at:8.4}  {after:8.4}")?;
            if tolerances {
                let shift = moment.member.shift(moment.index);
                let shift = shift.map(|shift| format!("{:.4}", shift.to_degrees()));
                write!(f, "  {:>6}", shift.unwrap_or_default())?;
            }
            let (name, ends, begins) = (
                name(&moment),
                ends(&moment),
                described(&moment, moment.event.begins),
            );
            writeln!(f, "  {name:names$}  {ends:endings$}  {begins}")?;
        }
        Ok(())
    }
}

/// A motion of the moment's member.
fn described(moment: &Moment<'_>, motion: Motion) -> String {
    motion
        .described(moment.member.bands(), &moment.member.unit)
        .to_string()
}

/// An event as a text: a dwell that begins or ends, or a motion that begins, such as
/// `hook's dwell (top 0.5 mm) ends`.
impl fmt::Display for Moment<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Event { begins, ends, .. } = *self.event;
        let (motion, word) = match (begins.is_dwell(), ends.is_dwell()) {
            (false, true) => (ends, "ends"),
            (true, _) | (false, false) => (begins, "begins"),
        };
        write!(
            f,
            "{}'s {} {word}",
            self.member.name(),
            described(self, motion)
        )
    }
}
