//! Time from the first load to a mechanism that moves.

use linkage_browser::Page;

use crate::built::built;
use crate::page::FRAME;

const LOADS: usize = 7;
const LIMIT: f64 = 1500.0;

#[test]
#[ignore = "measures"]
fn the_mechanism_moves_in_time() {
    let Some(built) = built() else {
        return;
    };
    let mut times = Vec::new();
    for _ in 0..LOADS {
        // A page that shares nothing with the one before.
        let Some(mut page) = Page::empty() else {
            return;
        };
        page.still(false);
        page.load(&built.page);
        times.push(page.number(&format!(
            "new Promise((done) => {{ \
               let first; \
               const look = () => {{ \
                 const at = document.body?.dataset.shown && {FRAME}.getElementById('position').value; \
                 first ??= at; \
                 if (at !== first) done(performance.now()); \
                 else requestAnimationFrame(look); \
               }}; \
               look(); }})"
        )));
    }
    let least = times.iter().copied().fold(f64::INFINITY, f64::min);
    println!("first load to a moving mechanism: {least:.0} ms, all {times:.0?}");
    assert!(least <= LIMIT, "{least:.0} ms, at most {LIMIT}");
}
