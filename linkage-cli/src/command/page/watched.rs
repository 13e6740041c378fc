//! A file that is watched while an editor writes it.

use std::fs;
use std::path::Path;
use std::thread::sleep;
use std::time::{Duration, Instant, SystemTime};

/// Interval between checks of the file.
const LOOK_EVERY: Duration = Duration::from_millis(100);

/// A file that has not changed for so long is complete, if it has no mistake. Some editors empty a
/// file and then write it.
const SETTLED: Duration = Duration::from_millis(100);

/// A file with mistakes may be half written: they are reported if it has not changed for so long.
const PATIENCE: Duration = Duration::from_millis(600);

/// The time of the last change of a file, and its length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Stamp {
    changed: SystemTime,
    length: u64,
}

impl Stamp {
    /// The stamp of a file; `None` if there is no such file, as while some editors replace it.
    pub(super) fn of_file(file: &Path) -> Option<Self> {
        let data = fs::metadata(file).ok()?;
        Some(Self {
            changed: data.modified().ok()?,
            length: data.len(),
        })
    }
}

/// Takes a file each time that it has changed and is complete. `seen` is the state that is known.
pub(super) fn follow(
    file: &Path,
    mut seen: Option<Stamp>,
    is_sound: impl Fn() -> bool,
    mut take: impl FnMut(),
) -> ! {
    let mut changed: Option<(Stamp, Instant)> = None;
    loop {
        sleep(LOOK_EVERY);
        let now = Stamp::of_file(file);
        changed = match (now, changed) {
            (None, _) => None,
            (now, _) if now == seen => None,
            (Some(now), Some((stamp, since))) if stamp == now => Some((now, since)),
            (Some(now), _) => Some((now, Instant::now())),
        };
        let Some((stamp, since)) = changed else {
            continue;
        };
        let unchanged = since.elapsed();
        if unchanged >= PATIENCE || unchanged >= SETTLED && is_sound() {
            seen = Some(stamp);
            changed = None;
            take();
        }
    }
}
