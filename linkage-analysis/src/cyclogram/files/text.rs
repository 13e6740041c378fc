//! Words of cyclograms in files, and the check of their style.

use std::string::{String, ToString};

use crate::cyclogram::{Member, Motion};
use linkage_formats::{CsvStyle, ReportError};

pub(super) const fn word(motion: Motion) -> &'static str {
    match motion {
        Motion::Advance => "advance",
        Motion::Dwell(_) => "dwell",
        Motion::Return => "return",
    }
}

pub(super) const fn index(motion: Motion) -> Option<usize> {
    match motion {
        Motion::Dwell(band) => Some(band),
        Motion::Advance | Motion::Return => None,
    }
}

/// The band of a dwell as text.
pub(super) fn band(organ: &Member, motion: Motion) -> String {
    index(motion).map_or_else(String::new, |band| organ.bands()[band].to_string())
}

pub(super) fn checked(style: &CsvStyle) -> Result<(), ReportError> {
    style
        .mistake()
        .map_or(Ok(()), |mistake| Err(mistake.into()))
}
