//! How much tests try: what everybody waits for, or all that there is.

/// Whether `LINKAGE_LONG` asks for long runs.
#[must_use]
pub fn is_long() -> bool {
    std::env::var_os("LINKAGE_LONG").is_some()
}

/// One of so many, the first among them; all of them in long runs.
pub fn one_in<T>(count: usize, all: impl IntoIterator<Item = T>) -> impl Iterator<Item = T> {
    all.into_iter().step_by(if is_long() { 1 } else { count })
}
