//! Reports in the words of the compiler.

use super::{RangeFinding, RangeFindingKind, RangeReport};
use crate::data::Input;
use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;
use core::fmt;
use linkage_core::range_check::{
    Comes, PASSES_HELP, Reaches, listed, not_finite, passes, position_as_written, rounded_inwards,
    rounded_to, significant, with_apostrophes,
};

/// A message of the check of a range.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RangeMessage {
    /// The fact.
    pub fact: String,
    /// The advice.
    pub help: String,
}

/// A stretch of the input that works, and the part of it within the range.
struct Works {
    stretch: [String; 2],
    range: [String; 2],
}

impl RangeReport {
    /// One message for the change points of each group, and one for everything else that was found,
    /// in the order of the inputs.
    #[must_use]
    pub fn messages(&self) -> Vec<RangeMessage> {
        let Some(input) = self.input else {
            return Vec::new();
        };
        let mut found: Vec<Vec<&RangeFinding>> = Vec::new();
        for finding in &self.findings {
            let change = RangeFindingKind::ChangePoint;
            let alike = |other: &&mut Vec<&RangeFinding>| {
                finding.kind == change && other[0].kind == change && other[0].group == finding.group
            };
            match found.iter_mut().find(alike) {
                Some(others) => others.push(finding),
                None => found.push(Vec::from([finding])),
            }
        }
        found
            .iter()
            .map(|alike| self.message(&input, alike))
            .collect()
    }

    fn message(&self, input: &Input, alike: &[&RangeFinding]) -> RangeMessage {
        let finding = alike[0];
        let group = &self.groups[finding.group];
        let loops = group.loop_names();
        let unknowns = with_apostrophes(group.unknowns);
        let group = Comes {
            loops: &loops,
            several: group.loops.len() != 1,
            unknowns: &unknowns,
        };
        let angle = input.unit == "rad";
        let at = |x: f64| {
            format!(
                "`{} = {}`",
                input.name,
                position_as_written(x, angle, input.unit)
            )
        };
        let positions: Vec<String> = alike.iter().map(|finding| at(finding.from)).collect();
        let positions = listed(&positions);
        let change = finding.kind == RangeFindingKind::ChangePoint;
        if finding.kind == RangeFindingKind::Undefined {
            let range = input.range.map(|_| self.works_within(input).range);
            let ends = range
                .as_ref()
                .map(|ends| ends.each_ref().map(String::as_str));
            let [fact, help] = not_finite(group, &positions, "", ends);
            return RangeMessage { fact, help };
        }
        if input.range.is_none() {
            return RangeMessage {
                fact: passes(group, &positions),
                help: PASSES_HELP.to_string(),
            };
        }
        let unit = self.units[finding.group];
        let miss = significant(finding.miss);
        let picture = match finding.kind {
            _ if finding.miss == 0.0 => String::new(),
            RangeFindingKind::Gap => format!(
                ", beyond which it misses by up to {miss}{unit}; it closes again at {}",
                at(finding.to)
            ),
            _ => format!(", beyond which it misses by up to {miss}{unit}"),
        };
        let Works { stretch, range } = self.works_within(input);
        let reaches = Reaches {
            group,
            change,
            position: &positions,
            picture: &picture,
            works: stretch.each_ref().map(String::as_str),
            range: range.each_ref().map(String::as_str),
        };
        RangeMessage {
            fact: reaches.fact(),
            help: reaches.help(),
        }
    }

    /// Returns the stretch around the reference that works.
    fn works_within(&self, input: &Input) -> Works {
        let angle = input.unit == "rad";
        let ([low, high], step) = rounded_inwards(self.works, input.reference, self.range, angle);
        let show = |x: f64| rounded_to(x, step, angle, input.unit);
        Works {
            stretch: [low, high].map(show),
            range: [low.max(self.range[0]), high.min(self.range[1])].map(show),
        }
    }
}

/// Each message with its help, after the name of the mechanism.
impl fmt::Display for RangeReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = self.mechanism;
        if let Some(why) = self.unchecked {
            return write!(f, "{name}: {why}");
        }
        let messages = self.messages();
        if let (Some(input), true) = (self.input, messages.is_empty()) {
            let [low, high] = self
                .range
                .map(|x| position_as_written(x, input.unit == "rad", input.unit));
            return write!(
                f,
                "{name}: no change point and no dead point for `{}` in {low}..{high}",
                input.name
            );
        }
        for (index, RangeMessage { fact, help }) in messages.iter().enumerate() {
            let between = if index == 0 { "" } else { "\n" };
            write!(f, "{between}{name}: {fact}\nhelp: {help}")?;
        }
        Ok(())
    }
}
