//! The order of the events of all organs, and what each of them follows.

use serde_json::{Value, json};
use std::string::{String, ToString};
use std::vec::Vec;

use super::{CsvStyle, ReportError, checked};
use crate::cyclogram::{Cyclogram, Member, Moment};
use crate::report::units::titled;

impl Cyclogram {
    /// The events of all organs as CSV, in order of the angle: where, by how much tolerances shift it, if they were given, what happens,
    /// and how long after what other event.
    ///
    /// # Errors
    ///
    /// [`ReportError::Mistakes`] if the style cannot tell cells apart.
    pub fn order_csv(&self, style: &CsvStyle) -> Result<String, ReportError> {
        checked(style)?;
        let (unit, shown) = style.shown("rad");
        let at = ["at", "+- at"].map(|name| titled(name, unit));
        let titles = [
            &at[0],
            &at[1],
            "event",
            &titled("after", unit),
            "after what",
        ];
        let mut text = style.line(titles.map(|title| style.word(title)));
        for [before, moment] in self.pairs() {
            let number = |x: f64| style.number(shown(x)).into();
            let shift = moment.member.shift(moment.index).unwrap_or(f64::NAN);
            let [what, follows] = [moment, before].map(|own| own.to_string());
            text.push_str(&style.line([
                number(moment.event.at),
                number(shift),
                style.word(&what),
                number(moment.after),
                style.word(&follows),
            ]));
        }
        Ok(text)
    }

    pub(super) fn order_value(&self) -> Vec<Value> {
        let index = |organ: &Member| {
            self.members
                .iter()
                .position(|own| core::ptr::eq(own, organ))
        };
        let moment = |[before, moment]: [Moment<'_>; 2]| {
            json!({
                "organ": index(moment.member),
                "event": moment.index,
                "at": moment.event.at,
                "after": moment.after,
                "follows": { "organ": index(before.member), "event": before.index },
            })
        };
        self.pairs().map(moment).collect()
    }

    /// Each event behind the one that it follows: the first of the cycle follows the last one.
    fn pairs(&self) -> impl Iterator<Item = [Moment<'_>; 2]> {
        let all: Vec<Moment<'_>> = self.moments().collect();
        let count = all.len();
        (0..count).map(move |k| [all[(k + count - 1) % count], all[k]])
    }
}
