//! The words of the check of a range.

use alloc::format;
use alloc::string::{String, ToString};
use alloc::vec::Vec;

/// The help where a mechanism without a range passes through a change point.
pub const PASSES_HELP: &str =
    "give the input the range in which it is driven, `in LOW..HIGH`, or change a length";

/// The group that comes apart.
#[derive(Clone, Copy, Debug)]
pub struct Comes<'a> {
    /// Its loops: `loops 1 and 2`, or the joints that they stand for.
    pub loops: &'a str,
    /// True for more than one loop.
    pub several: bool,
    /// Its unknowns, in apostrophes.
    pub unknowns: &'a str,
}

impl Comes<'_> {
    /// ``the mechanism comes apart in this range: loop 1 (`theta`, `psi`) reaches``
    #[must_use]
    pub fn apart(&self) -> String {
        let reach = match self.several {
            false => "reaches",
            true => "reach",
        };
        format!(
            "the mechanism comes apart in this range: {} ({}) {reach}",
            self.loops, self.unknowns,
        )
    }
}

/// A dead point or a change point in a range.
#[derive(Clone, Copy, Debug)]
pub struct Reaches<'a> {
    /// The group that comes apart.
    pub group: Comes<'a>,
    /// True if the mechanism closes on both sides: a change point.
    pub change: bool,
    /// The input there: `` `phi = 30deg` ``.
    pub position: &'a str,
    /// More about the dead point, after a comma; may be empty.
    pub picture: &'a str,
    /// The ends of the stretch around the reference that works.
    pub works: [&'a str; 2],
    /// The ends of the range that is proposed instead.
    pub range: [&'a str; 2],
}

impl Reaches<'_> {
    /// Returns the text without the help.
    #[must_use]
    pub fn fact(&self) -> String {
        let (point, beyond) = match self.change {
            true => (
                "change",
                "; there two of its assemblies meet, and it may go on in either",
            ),
            false => ("dead", ""),
        };
        format!(
            "{} a {point} point at {}{}{beyond}; {}",
            self.group.apart(),
            self.position,
            self.picture,
            self.works()
        )
    }

    /// Returns the text of the help.
    #[must_use]
    pub fn help(&self) -> String {
        let other = match self.change {
            true => "change a length so that they do not meet",
            false => "change the lengths so that the links reach each other all the way",
        };
        format!("{}, or {other}", self.range())
    }

    /// `around the reference it works from 10deg to 170deg`
    #[must_use]
    pub fn works(&self) -> String {
        let [from, to] = self.works;
        format!("around the reference it works from {from} to {to}")
    }

    /// ``write `in 10deg..170deg` ``
    #[must_use]
    pub fn range(&self) -> String {
        let [low, high] = self.range;
        format!("write `in {low}..{high}`")
    }
}

/// Returns the text and the help for equations of a group without a finite value at a place. `range`
/// are the ends of the range that is proposed instead, if one is known.
#[must_use]
pub fn not_finite(
    group: Comes,
    position: &str,
    how: &str,
    range: Option<[&str; 2]>,
) -> [String; 2] {
    let restrict = match range {
        Some([low, high]) => format!("write `in {low}..{high}`"),
        None => "restrict the range".to_string(),
    };
    [
        format!(
            "{} a division by zero, or a root or an arc function out of its range at {position}{how}",
            group.apart()
        ),
        format!("{restrict}, or change what is not a finite number beyond it"),
    ]
}

/// A mechanism whose input has no range passes through a change point.
#[must_use]
pub fn passes(group: Comes, position: &str) -> String {
    format!(
        "at {position} the mechanism passes through a change point: from there {} ({}) can go on in another assembly",
        group.loops, group.unknowns
    )
}

/// `loop 2`, `loops 2 and 3`, `loops 1, 2 and 3`
#[must_use]
pub fn loop_list(numbers: &[usize]) -> String {
    let words: Vec<String> = numbers.iter().map(usize::to_string).collect();
    match &words[..] {
        [one] => format!("loop {one}"),
        [] => "no loop".to_string(),
        several => format!("loops {}", listed(several)),
    }
}

/// Returns the joints and links that the loops of a group stand for, or, if there are none, the
/// numbers of the loops.
#[must_use]
pub fn joints_or_loops(joints: &str, loops: &[usize]) -> String {
    match joints {
        "" => loop_list(loops),
        _ => joints.to_string(),
    }
}

/// `1`, `1 and 2`, `1, 2 and 3`
#[must_use]
pub fn listed(words: &[String]) -> String {
    match words {
        [] => String::new(),
        [one] => one.clone(),
        [before @ .., last] => format!("{} and {last}", before.join(", ")),
    }
}

/// `` `theta`, `psi` ``
#[must_use]
pub fn with_apostrophes(names: &[&str]) -> String {
    let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    names.join(", ")
}
