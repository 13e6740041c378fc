//! Where and when figures were measured.

use std::time::{SystemTime, UNIX_EPOCH};

/// Command, build, processor, date.
#[must_use]
pub fn describe(command: &str) -> String {
    let (build, processor, date) = (build(), processor(), date());
    format!("`{command}`, {build}; {processor}; {date}")
}

/// What the machine code may use.
#[must_use]
pub fn build() -> &'static str {
    if cfg!(target_feature = "avx512f") {
        "built with AVX-512"
    } else if cfg!(target_feature = "fma") {
        "built with fused multiply-add"
    } else {
        "default build"
    }
}

/// The name of the processor, as far as the system tells it.
#[must_use]
pub fn processor() -> String {
    let known = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let model = known
        .lines()
        .find_map(|line| line.strip_prefix("model name")?.split_once(':'));
    match model {
        Some((_, name)) => name.trim().to_owned(),
        None => std::env::consts::ARCH.to_owned(),
    }
}

/// Today as year-month-day, in UTC.
fn date() -> String {
    let seconds = SystemTime::now()
        .duration_since(UNIX_EPOCH)
        .map_or(0, |time| time.as_secs());
    let mut day = (seconds / 86_400) as i64;
    let mut year = 1970;
    let leap = |year: i64| year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
    while day >= 365 + i64::from(leap(year)) {
        day -= 365 + i64::from(leap(year));
        year += 1;
    }
    let february = 28 + i64::from(leap(year));
    let mut month = 1;
    for length in [31, february, 31, 30, 31, 30, 31, 31, 30, 31, 30] {
        if day < length {
            break;
        }
        day -= length;
        month += 1;
    }
    format!("{year}-{month:02}-{:02}", day + 1)
}
