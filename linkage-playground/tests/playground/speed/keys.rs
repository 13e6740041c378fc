//! Times from a key to its messages, and to the frame that shows the new drawing.

use linkage_browser::processor_times;
use serde_json::{Value, json};

use crate::page::Shown;

const KEYS: usize = 40;

/// Exchanges a digit of a number in the text, again and again. The times of each key in milliseconds:
/// until the new numbers are in the page, and until the frame that shows them.
const TYPED: &str = "(async (written, keys) => { \
     const { editor: { view, text }, compiler } = playground; \
     const pause = (time) => new Promise((done) => setTimeout(done, time)); \
     const at = text().indexOf(written) + written.length - 1; \
     const digit = Number(written.at(-1)); \
     const shown = () => document.body.dataset.shown; \
     const painted = () => new Promise((done) => requestAnimationFrame(() => { \
       const { port1, port2 } = new MessageChannel(); \
       port1.onmessage = () => done(performance.now()); \
       port2.postMessage(null); \
     })); \
     const times = []; \
     for (let key = 0; key < keys; key += 1) { \
       await pause(100); \
       while (compiler.isBusy) await pause(5); \
       const next = renewed(shown()); \
       const begin = performance.now(); \
       view.dispatch({ changes: { from: at, to: at + 1, insert: String((digit + key + 1) % 10) } }); \
       times.push([(await next) - begin, (await painted()) - begin]); \
     } \
     return times; })";

fn least(times: &Value, column: usize) -> f64 {
    let times = times.as_array().expect("a list").iter();
    let times = times.map(|key| key[column].as_f64().expect("a number"));
    times.fold(f64::INFINITY, f64::min)
}

/// Milliseconds from a key to its frame, at most.
const LIMITS: [(&str, &str, f64); 2] = [
    ("crank-rocker", "coupler = 120", 30.0),
    ("hook-needle", "l910 = 122.5", 80.0),
];

#[test]
#[ignore = "measures"]
fn keys_are_answered_in_time() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let mut late = Vec::new();
    for (example, written, limit) in LIMITS {
        shown.choose(example);
        assert!(shown.text().contains(written), "{example}");
        let typed = format!("{TYPED}({}, {KEYS})", json!(written));
        let times = shown.page.value(&typed);
        let [numbers, frame] = [0, 1].map(|column| least(&times, column));
        println!(
            "{example}: {numbers:.0} ms to messages and numbers, {frame:.0} ms to their frame"
        );
        for (thread, time) in processor_times(&mut shown.page, &typed) {
            let time = time / KEYS as f64;
            if time >= 0.5 {
                println!("    {time:.1} ms of the processor for a key: {thread}");
            }
        }
        if frame > limit {
            late.push(format!("{example}: {frame:.0} ms, at most {limit}"));
        }
    }
    assert!(late.is_empty(), "{late:?}");
}
