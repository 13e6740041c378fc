//! Colours of messages.

use std::io::{self, IsTerminal};

/// Returns true if messages are coloured.
pub(super) fn is_coloured() -> bool {
    io::stderr().is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|word| word.is_empty())
}
