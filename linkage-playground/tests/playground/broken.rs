//! Texts that are broken at every character in the editor of the page, as while they are written.

use serde_json::{Value, json};

use crate::page::Shown;

/// Templates of all kinds: loops, links, courses, forces, several inputs.
const TEXTS: [&str; 10] = [
    "slider",
    "joints",
    "cam",
    "boom",
    "scissors",
    "geneva",
    "leg",
    "suspension",
    "steering",
    "toggle-press",
];

/// Keys of one call: the browser answers each call in time.
const KEYS: usize = 20;

/// Leaves out every so many-th character of a part of the text, one after the other, and asks
/// everything that an editor asks there. Times in milliseconds until the messages and the drawing of each broken
/// text, and until the other answers; and all answers that are failures.
const BROKEN: &str = "(async (first, end, step) => { \
     const { editor: { view, text }, compiler } = playground; \
     const whole = text(); \
     const places = [...whole].reduce((all, letter) => [...all, all.at(-1) + letter.length], [0]); \
     const shown = () => document.body.dataset.shown; \
     const found = { keys: [], answers: [], failures: [] }; \
     let out = null; \
     const put = () => (out === null ? [] : [{ from: out.from, insert: out.letter }]); \
     for (let k = first; k < Math.min(end, places.length - 1); k += step) { \
       const [from, to] = [places[k], places[k + 1]]; \
       const moved = out === null ? 0 : out.letter.length; \
       const changes = [...put(), { from: from - moved, to: to - moved }]; \
       const next = renewed(shown()); \
       const begin = performance.now(); \
       view.dispatch({ changes, selection: { anchor: from } }); \
       out = { from, letter: whole.slice(from, to) }; \
       found.keys.push((await next) - begin); \
       if (document.getElementById('messages').textContent.includes('the compiler has failed')) found.failures.push(text()); \
       const place = { text: text(), at: from, from, to: from }; \
       for (const work of ['hover', 'complete', 'signature', 'actions', 'hints', 'format']) { \
         const asked = performance.now(); \
         const answer = await compiler.ask({ do: work, ...place }); \
         found.answers.push(performance.now() - asked); \
         if (answer === null || /^\\{\"(panic|failure)\"/.test(answer)) found.failures.push(`${work}: ${answer}`); \
       } \
     } \
     const next = renewed(shown()); \
     view.dispatch({ changes: put() }); \
     await next; \
     return { ...found, isWhole: text() === whole }; })";

/// Milliseconds in order.
#[derive(Default)]
struct Times(Vec<f64>);

impl Times {
    fn add(&mut self, found: &Value) {
        let found = found.as_array().expect("a list").iter();
        self.0
            .extend(found.map(|time| time.as_f64().expect("a number")));
        self.0.sort_by(f64::total_cmp);
    }

    fn late(&self, limit: f64) -> usize {
        self.0.iter().filter(|time| **time > limit).count()
    }

    fn print(&self, name: &str, limit: f64) {
        println!(
            "{} {name}: median {:.0} ms, {} over {limit:.0} ms, last {:.0} ms",
            self.0.len(),
            self.0[self.0.len() / 2],
            self.late(limit),
            self.0[self.0.len() - 1]
        );
    }
}

/// Breaks all texts at every `step`th character. Returns the times of keys, and those of answers.
fn broken(shown: &mut Shown, step: usize) -> [Times; 2] {
    let [mut keys, mut answers] = [Times::default(), Times::default()];
    for (number, name) in TEXTS.iter().enumerate() {
        shown.choose(name);
        let letters = shown.text().chars().count();
        for first in (number * 7 % step..letters).step_by(step * KEYS) {
            let end = first + step * KEYS;
            let found = (shown.page).value(&format!("{BROKEN}({first}, {end}, {step})"));
            assert_eq!(found["failures"], json!([]), "{name}");
            assert_eq!(found["isWhole"], true, "{name}");
            assert_eq!(shown.messages(), "", "{name}");
            keys.add(&found["keys"]);
            answers.add(&found["answers"]);
        }
    }
    shown.page.assert_quiet();
    [keys, answers]
}

#[test]
fn the_page_answers_while_texts_are_broken() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let [keys, answers] = broken(&mut shown, 211);
    keys.print("keys", 80.0);
    answers.print("answers", 50.0);
    assert!(keys.0.len() > 50, "{} keys", keys.0.len());
}

/// Every character of ten mechanisms takes a quarter of an hour.
#[test]
#[ignore = "measures"]
fn broken_texts_are_answered_in_time() {
    let Some(mut shown) = Shown::open() else {
        return;
    };
    let [keys, answers] = broken(&mut shown, 1);
    keys.print("keys", 80.0);
    answers.print("answers", 50.0);
    // Other programs of the machine may hold a few answers up.
    assert!(keys.late(80.0) * 100 <= keys.0.len());
    assert!(answers.late(50.0) * 100 <= answers.0.len());
}
