//! The memory and the time of imports.

use std::fs;
use std::time::Instant;

/// The most memory that mutated or huge files may add, in kilobytes: some copies of the largest one.
pub(crate) const MOST_KILOBYTES: u64 = 400_000;

/// Returns the largest memory of this process so far, in kilobytes, where the system has it.
pub(crate) fn peak() -> Option<u64> {
    let status = fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find(|line| line.starts_with("VmHWM:"))?;
    line.split_whitespace().nth(1)?.parse().ok()
}

/// Runs imports, and checks their memory and their time in seconds.
pub(crate) fn bounded(name: &str, seconds: u64, imports: impl FnOnce()) {
    let (before, started) = (peak(), Instant::now());
    imports();
    let taken = started.elapsed().as_secs();
    assert!(taken < seconds, "{name}: {taken} s");
    if let (Some(before), Some(after)) = (before, peak()) {
        let grown = after.saturating_sub(before);
        assert!(grown < MOST_KILOBYTES, "{name}: {grown} kB more");
    }
}
