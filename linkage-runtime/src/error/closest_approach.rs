//! Closest approach of loops that are not reached from their estimates.

use alloc::string::String;
use alloc::vec::Vec;
use core::fmt;
use linkage_core::format::{printed, rounded};
use linkage_core::range_check::joints_or_loops;

/// Closest approach of a group that is not reached from its estimates.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum ClosestApproach {
    /// They do not: by how much they miss where they come nearest to it, by the sum of squares, the
    /// farthest first. A loop that is not listed closes there. That is sought from the estimates
    /// on; elsewhere there may be assemblies.
    Misses(
        /// At least one.
        Vec<Missed>,
    ),
    /// They do: the links reach each other, and the estimates are too far off, or the assembly is
    /// at a dead point.
    Closes,
    /// It was not found out.
    Unknown,
}

/// The amount by which a loop does not close.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Missed {
    /// Its number, the first loop of the mechanism being 1.
    pub number: usize,
    /// The joint or link that it stands for; empty for a loop as it is written.
    pub joint: &'static str,
    /// Its left side without the right one; of vectors the length of that.
    pub by: f64,
    /// Its unit; empty for a number.
    pub unit: &'static str,
}

/// The number of loops that a message contains at most.
const TOLD: usize = 6;

/// Continues a sentence about estimates that do not lead to an assembly.
impl fmt::Display for ClosestApproach {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Misses(missed) => {
                f.write_str("where its loops come nearest to closing from there, ")?;
                for (index, missing) in missed.iter().take(TOLD).enumerate() {
                    match index {
                        0 => write!(f, "{missing}")?,
                        _ => write!(f, ", {} by {}", missing.name(), missing.amount())?,
                    }
                }
                if missed.len() > TOLD {
                    write!(f, ", and {} more by less", missed.len() - TOLD)?;
                }
                f.write_str(
                    ": there the links do not reach each other; change these lengths by about as much, or follow another assembly to these \
                     dimensions by `assemble_from`",
                )
            }
            Self::Closes => f.write_str(
                "its loops close all the same: the links reach each other, but the estimates are too far off, or the assembly is at a dead \
                 point; `assemble_from` follows an assembly of other dimensions to these",
            ),
            Self::Unknown => f.write_str(
                "the links do not reach each other, or the estimates are too far off",
            ),
        }
    }
}

impl Missed {
    fn name(&self) -> String {
        joints_or_loops(self.joint, &[self.number])
    }

    fn amount(&self) -> impl fmt::Display {
        let gap = if self.unit.is_empty() { "" } else { " " };
        let (by, unit) = (self.by, self.unit);
        printed(move |f| write!(f, "{}{gap}{unit}", rounded(by)))
    }
}

impl fmt::Display for Missed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} misses by {}", self.name(), self.amount())
    }
}

#[cfg(test)]
mod tests {
    use super::{ClosestApproach, Missed};
    use alloc::string::ToString;
    use alloc::vec;
    use alloc::vec::Vec;

    fn missed(number: usize, by: f64, unit: &'static str) -> Missed {
        Missed {
            number,
            joint: "",
            by,
            unit,
        }
    }

    #[test]
    fn what_misses_is_told_with_its_unit() {
        let linked = Missed {
            joint: "joint `c` of `rocker`",
            ..missed(5, 60.1, "mm")
        };
        let closest_approach = ClosestApproach::Misses(vec![linked, missed(2, -0.02, "")]);
        let text = closest_approach.to_string();
        let expected = "from there, joint `c` of `rocker` misses by 60.1 mm, loop 2 by -0.02: there the links do not reach each other";
        assert!(text.contains(expected), "{text}");
    }

    #[test]
    fn of_many_loops_the_farthest_are_told() {
        let nine: Vec<Missed> = (1..=9).map(|k| missed(k, 1.0, "m")).collect();
        let text = ClosestApproach::Misses(nine).to_string();
        let expected = ", loop 6 by 1 m, and 3 more by less: ";
        assert!(text.contains(expected), "{text}");
    }
}
