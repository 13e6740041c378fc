//! The error of printing.

use std::error::Error;
use std::fmt::{self, Display, Formatter};

/// Why a mechanism is not printed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Refused {
    pub(crate) message: String,
}

impl Display for Refused {
    fn fmt(&self, f: &mut Formatter) -> fmt::Result {
        f.write_str(&self.message)
    }
}

impl Error for Refused {}
