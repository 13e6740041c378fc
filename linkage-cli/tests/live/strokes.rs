//! Both strokes of a cycle in pages, where it begins at a limit and where the quantity does not return.

use crate::pages::{self, Live};

/// The slider is farthest at the seam of the cycle, where its rate is nothing but roundoff; `ahead` goes on by a turn in each cycle, with a short way
/// back.
const PILGRIM: &str = "
    pub struct Pilgrim {
        unit mm;
        param crank = 50mm;
        param rod   = 120mm;
        param sway  = 2;
        input phi = 30deg in 0deg..360deg;
        unknown theta = -10deg;
        unknown s = 160mm;
        loop polar(crank, phi) + polar(rod, theta) = (s, 0mm);
        let ahead = phi + sway * sin(phi);
    }
    impl Pilgrim {
        pub fn motion(phi) -> Motion { s, w: velocity(s), ahead, v: velocity(ahead) }
    }";

/// The exact number of a figure after a change; none where there is no number.
fn figure(live: &mut Live, quantity: &str) -> Option<f64> {
    let text = live.page.words(&format!(
        "(() => {{ const row = [...document.querySelectorAll('#summary tr')].find((row) => row.cells[0].textContent === '{quantity}' && row.cells[1].textContent === 'time ratio'); \
         return row.querySelector('[data-exact]')?.dataset.exact ?? ''; }})()"
    ));
    text.parse().ok()
}

#[test]
fn strokes_are_those_of_cycles_that_return() {
    let Some(mut live) = Live::text("pilgrim", PILGRIM) else {
        return;
    };
    let row = |quantity: &str| {
        format!(
            r#"{{"at":null,"quantity":"{quantity}","unit":"","value":7.25,"what":"time ratio"}}"#
        )
    };
    let rows = ["s", "ahead"].map(row).join(",");
    let html = pages::html("pilgrim");
    let own = html.replacen("\"summary\":[]", &format!("\"summary\":[{rows}]"), 1);
    assert_ne!(html, own);
    let file = pages::beside("pilgrim", "live", "figures.html", &own);
    live.page.load(&file);
    live.page.wait("document.body.dataset.ready === 'true'");
    for (name, x) in [("rod", 130), ("crank", 41), ("rod", 97)] {
        live.page.value(&format!(
            "new Promise((done) => {{ addEventListener('hashchange', () => setTimeout(done), {{ once: true }}); location.hash = '{name}={x}'; }})"
        ));
        // Without an offset both strokes are half a turn.
        let ratio = figure(&mut live, "s").expect("one stroke and its return");
        assert!((ratio - 1.0).abs() < 1e-12, "{name} = {x}: {ratio}");
        assert_eq!(figure(&mut live, "ahead"), None, "{name} = {x}");
    }
    live.page.assert_quiet();
}
