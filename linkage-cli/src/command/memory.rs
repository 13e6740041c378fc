//! Refusal of results that the memory does not hold.

use std::fs;

use crate::failure::Failure;

/// Numbers that a command holds at once.
pub(super) struct Held {
    /// Positions of the input.
    pub(super) rows: usize,
    /// Numbers at each of them, the input among them.
    pub(super) columns: usize,
    /// Bytes that the command takes for each number, with the texts that it makes of it.
    pub(super) bytes: usize,
}

impl Held {
    /// Refuses more than the memory holds.
    pub(super) fn fits(&self) -> Result<(), Failure> {
        let needed = self.rows as u128 * self.columns as u128 * self.bytes as u128;
        let probe = |needed: usize| Vec::<u8>::new().try_reserve_exact(needed).is_ok();
        let granted = usize::try_from(needed).is_ok_and(probe);
        let free = free();
        if granted && free.is_none_or(|free| needed <= u128::from(free)) {
            return Ok(());
        }
        let Self { rows, columns, .. } = self;
        let free = free.map_or_else(String::new, |free| {
            format!(", and {} are free", gigabytes(free.into()))
        });
        Err(Failure::Told(format!(
            "{rows} rows of {columns} columns take about {} of memory here{free}\n\
             help: choose fewer `--steps`, or `linkage table`, which holds no rows",
            gigabytes(needed)
        )))
    }
}

fn gigabytes(bytes: u128) -> String {
    format!("{:.1} GB", bytes as f64 / 1e9)
}

/// Returns the bytes that this process can still take, where the system reports it: the free memory
/// of the machine, and of the limit of the container.
fn free() -> Option<u64> {
    let number = |path: &str| fs::read_to_string(path).ok()?.trim().parse::<u64>().ok();
    let limit = number("/sys/fs/cgroup/memory.max");
    let used = number("/sys/fs/cgroup/memory.current");
    let of_container = limit.zip(used);
    let of_container = of_container.map(|(limit, used)| limit.saturating_sub(used));
    let text = fs::read_to_string("/proc/meminfo").ok();
    let of_machine = text.as_deref().and_then(available);
    of_container.into_iter().chain(of_machine).min()
}

/// `MemAvailable:   12345 kB`
fn available(text: &str) -> Option<u64> {
    let line = text
        .lines()
        .find_map(|line| line.strip_prefix("MemAvailable:"))?;
    let kibibytes: u64 = line.trim().strip_suffix("kB")?.trim_end().parse().ok()?;
    Some(kibibytes * 1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn free_memory_is_read() {
        let text = "MemTotal:       24737380 kB\nMemFree:  1 kB\nMemAvailable:   23068672 kB\n";
        assert_eq!(available(text), Some(23_622_320_128));
        assert_eq!(available("MemTotal: 1 kB\n"), None);
    }

    #[test]
    fn only_too_many_rows_are_refused() {
        let held = |rows| Held {
            rows,
            columns: 5,
            bytes: 100,
        };
        assert!(held(1000).fits().is_ok());
        let refused = held(usize::MAX / 2)
            .fits()
            .err()
            .map(|error| error.to_string());
        let refused = refused.expect("no memory is as large");
        assert!(
            refused.starts_with(
                "error: 9223372036854775807 rows of 5 columns take about 4611686018427.4 GB"
            ),
            "{refused}"
        );
    }
}
