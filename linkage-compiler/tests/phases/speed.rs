//! How long an expansion takes, in whatever build the tests run in: by the clock of this thread, which stands while others run.

use std::fs;
use std::path::Path;
use std::time::Duration;

use linkage_compiler::check;
use proc_macro2::TokenStream;

use super::compiled;

/// What the processor has worked for this thread.
#[cfg(unix)]
fn worked() -> Duration {
    use rustix::time::{ClockId, clock_gettime};
    Duration::try_from(clock_gettime(ClockId::ThreadCPUTime)).expect("it is not negative")
}

/// Without such a clock, the time that has passed.
#[cfg(not(unix))]
fn worked() -> Duration {
    use std::sync::LazyLock;
    use std::time::Instant;
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    START.elapsed()
}

/// The shortest of several runs: what it takes when the caches are warm and nothing else uses them.
pub(super) fn time(text: &str, runs: usize) -> Duration {
    let once = || {
        let tokens: TokenStream = text.parse().expect("tokens");
        let start = worked();
        let output = compiled(tokens);
        let taken = worked() - start;
        assert!(!output.to_string().contains("compile_error !"), "{output}");
        taken
    };
    (0..runs).map(|_| once()).min().expect("at least one run")
}

#[test]
fn favorit_expands_within_100_milliseconds() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/favorit.mech");
    let text = fs::read_to_string(path).expect("the mechanism can be read");
    let taken = time(&text, 40);
    println!("favorit: {taken:?}");
    assert!(taken < Duration::from_millis(100), "{taken:?}");
}

/// A platform on two driven legs and one of fixed length, from a reference where it moves freely to where the legs do not reach: no grid
/// over such ranges is filled before that is said.
#[test]
fn a_platform_that_comes_apart_is_refused_within_a_second() {
    let platform = |a: &str, b: &str| {
        let text = format!(
            "struct Platform {{ unit mm;
                input a = 70mm in {a}; input b = 206mm in {b};
                unknown c = (0mm, 50mm); unknown t = 0deg;
                let arm = polar(50mm, t);
                loop distance(c - arm, (0, 0)) = a;
                loop distance(c, (200mm, 0mm)) = b;
                loop distance(c + arm, (100mm, 170mm)) = 130mm;
            }}
            impl Platform {{ fn motion(a, b) -> Motion {{ c }} }}"
        );
        let tokens: TokenStream = text.parse().expect("tokens");
        let start = worked();
        let messages = check(tokens).messages;
        let taken = worked() - start;
        println!("{a}, {b}: {taken:?}");
        assert!(taken < Duration::from_secs(1), "{a}, {b}: {taken:?}");
        messages
    };
    for (a, b) in [
        ("50mm..90mm", "0mm..506mm"),
        ("50mm..90mm", "200mm..506mm"),
        ("1mm..90mm", "0mm..210mm"),
    ] {
        let messages = platform(a, b);
        let apart = "the mechanism comes apart in this range: loops 1, 2 and 3 (`c`, `t`) reach a dead point at `a = ";
        assert!(messages[0].text.starts_with(apart), "{messages:?}");
    }
    assert!(platform("68mm..72mm", "204mm..208mm").is_empty());
}

/// A plate on two lines and a cylinder, moved by two cylinders, over all of their strokes: a thousand cells, without optimisation. With
/// states of the wrong size it took twenty times as long.
#[test]
fn two_cylinders_are_prepared_within_three_seconds() {
    let text = "struct Plate { unit mm;
        input stroke1 = 149mm in 120.392mm..191.316mm;
        input stroke2 = 189.5mm in 113.7mm..265.3mm;
        unknown t = 169deg;
        let pin = (398mm, -253mm) + polar(45mm, t);
        loop distance((549mm, -298mm), (398mm, -253mm) + polar(45mm, t + 104deg)) = stroke1;
        unknown p = (240mm, -240mm);
        unknown k = 19deg;
        loop dot((298mm, -240.75mm) - p, dir(k + 67deg)) = 0;
        loop dot(pin - p, dir(k + 67deg)) = 0;
        loop distance((538.5mm, -197mm), p + polar(118mm, k)) = stroke2; }
        impl Plate { fn motion(stroke1, stroke2) -> Motion { p } }";
    let taken = time(text, 1);
    println!("two cylinders: {taken:?}");
    assert!(taken < Duration::from_secs(3), "{taken:?}");
}
