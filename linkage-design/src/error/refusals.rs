//! The refused starts of a search as text.

use core::fmt;
use std::string::String;

use super::Refusals;
use linkage_core::format::rounded;

/// One sentence, without causes that refused no start.
impl fmt::Display for Refusals {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "none of {} starts led to a mechanism that assembles over its whole range on one circuit and holds what must hold",
            self.starts
        )?;
        let mut between = ": ";
        let mut tell =
            |f: &mut fmt::Formatter<'_>, count: usize, what: &str, by: &[(String, usize)]| {
                if count == 0 {
                    return Ok(());
                }
                write!(f, "{between}{count} {what}")?;
                between = ", ";
                for (k, (name, count)) in by.iter().enumerate() {
                    write!(f, "{}{count} `{name}`", if k == 0 { " (" } else { ", " })?;
                }
                f.write_str(if by.is_empty() { "" } else { ")" })
            };
        tell(f, self.refused, "contradict relations", &self.relations)?;
        tell(
            f,
            self.open,
            "do not assemble where something is wanted",
            &[],
        )?;
        tell(
            f,
            self.broken,
            "end where a condition does not hold",
            &self.conditions,
        )?;
        tell(f, self.ended, "end at local optima", &[])?;
        tell(
            f,
            self.no_values,
            "of these optima have no values of the catalogues near them that hold all conditions",
            &[],
        )?;
        tell(
            f,
            self.not_whole,
            "of these optima do not run through the range",
            &[],
        )?;
        tell(
            f,
            self.unverified,
            "of these optima violate what must hold once they are assembled",
            &[],
        )?;
        for (name, by) in self.violated.iter().chain(&self.missed) {
            write!(f, "; the nearest misses `{name}` by {}", rounded(*by))?;
        }
        if let Some(nearest) = &self.nearest {
            write!(f, "; {nearest}")?;
        }
        if let Some(first) = &self.first {
            write!(f, "; the first start: {first}")?;
        }
        Ok(())
    }
}
