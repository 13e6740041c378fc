//! Machines: parts with their colours, switched on and off; the cyclogram; what is seen from a moving link.

use crate::checks;
use linkage_browser::samples::{FourBar, four_bar, lift, machine, spatial_machine, written};
use linkage_browser::{DESKTOP, Key, PHONE, Page};

fn page(name: &str) -> Option<Page> {
    Page::open(&written(&machine(), name))
}

/// The colours of the bodies of all links, in their order.
fn colours(page: &mut Page) -> Vec<String> {
    let words = page.words(
        "[...document.querySelectorAll('[data-link]')].map((l) => l.dataset.link + ' ' + getComputedStyle(l.querySelector('.body')).stroke).join('; ')",
    );
    let mut all: Vec<String> = words.split("; ").map(String::from).collect();
    all.sort();
    all
}

fn shown(page: &mut Page, kind: &str) -> String {
    page.words(&format!(
        "[...document.querySelectorAll('[data-{kind}]')].filter((n) => n.getBoundingClientRect().width > 0).map((n) => n.dataset.{kind}).sort().join(' ')"
    ))
}

#[test]
fn parts_have_colours_and_are_switched_on_and_off() {
    let Some(mut page) = page("machine") else {
        return;
    };
    checks::all(&mut page, "machine");
    page.screen(DESKTOP);
    page.value("document.querySelector('#position').focus()");
    page.key(Key::Home);
    for dark in [false, true] {
        page.dark(dark);
        let all = colours(&mut page);
        assert_eq!(all.len(), 7);
        for link in &all {
            let (name, colour) = link.split_once(' ').expect("a colour");
            let part = name.split('.').next().expect("a part");
            for other in &all {
                let same = other.starts_with(&format!("{part}."));
                assert_eq!(
                    other.ends_with(&format!(" {colour}")),
                    same,
                    "{link}; {other}"
                );
            }
            let own = |selector: &str| {
                format!("getComputedStyle({selector}).getPropertyValue('--colour')")
            };
            let legend = page.words(&own(&format!("[...document.querySelectorAll('[data-part]')].find((b) => b.textContent === '{part}').querySelector('.chip')")));
            let link = page.words(&own(&format!(
                "document.querySelector(\"[data-link='{name}']\")"
            )));
            assert_eq!(legend, link, "{part}");
        }
        page.value("scrollTo(0, 0)");
        page.shoot(if dark {
            "machine-dark"
        } else {
            "machine-light"
        });
    }
    page.click("#names");
    page.click("[data-part='0']");
    assert_eq!(
        shown(&mut page, "link"),
        "eye.coupler eye.crank eye.rocker press.crank press.rod"
    );
    // Where the press turns, too, the pivot stays.
    let points = shown(&mut page, "point");
    assert!(
        points.contains("hook.pivot") && !points.contains("hook.pin"),
        "{points}"
    );
    assert!(!shown(&mut page, "slider").contains("hook.lift"));
    assert_eq!(shown(&mut page, "trace"), "eye.tip");
    assert_eq!(shown(&mut page, "organ"), "hook.needle press");
    assert!(
        page.holds(
            "document.querySelector(\"[data-organ='hook.needle']\").classList.contains('off')"
        )
    );
    assert!(page.holds("document.querySelector('#impossible').hidden"));
    // By keys, too, which then are not those of the player.
    page.value("document.querySelector(\"[data-part='2']\").focus()");
    page.key(Key::Space);
    let pressed = "[...document.querySelectorAll('[data-part]')].map((b) => b.getAttribute('aria-pressed')).join(' ')";
    assert_eq!(page.words(pressed), "false true false");
    assert_eq!(
        page.words("document.querySelector('#play').ariaLabel"),
        "Play"
    );
    assert!(!shown(&mut page, "point").contains("hook.pivot"));
    page.shoot("machine-one");
    page.key(Key::Space);
    page.click("[data-part='0']");
    assert_eq!(page.words(pressed), "true true true");
    assert_eq!(shown(&mut page, "link").split(' ').count(), 7);
    page.screen(PHONE);
    let low = "Math.min(...[...document.querySelectorAll('#parts button:not([hidden]), #seen')].map((b) => b.getBoundingClientRect().height))";
    assert!(page.number(low) >= 40.0);
    page.value("scrollTo(0, 0)");
    page.shoot("machine-phone");
    page.value("document.querySelector('#cyclogram').scrollIntoView({ block: 'center', behavior: 'instant' })");
    page.dark(true);
    page.shoot("machine-phone-dark");
    for (dark, colours) in [(false, "light"), (true, "dark")] {
        for screen in [PHONE, DESKTOP] {
            page.screen(screen);
            page.dark(dark);
            page.value("document.querySelector('#overlaps').scrollIntoView({ block: 'center', behavior: 'instant' })");
            page.shoot(&format!("machine-overlaps-{}-{colours}", screen.name));
        }
    }
    page.assert_quiet();
}

/// What belongs to no part stays, whatever is switched off.
#[test]
fn curves_are_hidden_with_their_part() {
    let Some(mut page) = page("machine-curves") else {
        return;
    };
    page.screen(DESKTOP);
    let choose = |name: &str| {
        format!(
            "[...document.querySelectorAll('#quantities input[data-column]')].find((b) => b.dataset.column.includes('|{name}|')).click()"
        )
    };
    for name in ["picture[hook.needle].y", "picture[eye.tip].x"] {
        page.value(&choose(name));
    }
    let curves = "[...document.querySelectorAll('.legend tr[data-column]')].map((r) => r.dataset.column.split('|')[2]).join(' ')";
    let pale = "[...document.querySelectorAll('.choice.off')].map((l) => l.textContent.trim().split(' ')[0]).join(' ')";
    let all = "lift plate load picture[hook.needle].y picture[eye.tip].x";
    let sorted = |text: String| {
        let mut words: Vec<String> = text.split_whitespace().map(String::from).collect();
        words.sort();
        words.join(" ")
    };
    assert_eq!(sorted(page.words(curves)), sorted(all.to_owned()));
    assert_eq!(page.words(pale), "");
    page.click("[data-part='0']");
    assert_eq!(
        sorted(page.words(curves)),
        sorted("lift plate load picture[eye.tip].x".to_owned())
    );
    // The guide of the hook has a direction, which is the hook's, too.
    let gone = page.words(pale);
    assert!(
        gone.contains("picture[hook.pin].x") && !gone.contains("press") && !gone.contains("lift "),
        "{gone}"
    );
    page.click("[data-part='1']");
    assert_eq!(sorted(page.words(curves)), "lift plate");
    for name in ["lift", "plate", "load"] {
        page.value(&choose(name));
    }
    assert_eq!(
        page.words("document.querySelector('#panels').textContent"),
        "Choose quantities above, or show their parts."
    );
    page.click("[data-part='0']");
    page.click("[data-part='1']");
    assert_eq!(
        sorted(page.words(curves)),
        sorted("picture[hook.needle].y picture[eye.tip].x".to_owned())
    );
    assert_eq!(page.words(pale), "");
    page.assert_quiet();
}

#[test]
fn a_line_in_the_cyclogram_stands_where_the_shaft_does() {
    let Some(mut page) = page("machine-cyclogram") else {
        return;
    };
    let place = |page: &mut Page, degrees: f64| {
        let [left, _, wide, _] = page.place("#cyclogram .axes path:first-child");
        let [right, _, more, _] = page.place("#cyclogram .axes path:nth-last-child(3)");
        let (first, last) = (left + wide / 2.0, right + more / 2.0);
        first + (last - first) * degrees / 360.0
    };
    let line = |page: &mut Page| {
        let [left, _, wide, _] = page.place("#cyclogram .shaft .line");
        left + wide / 2.0
    };
    page.middle("#cyclogram");
    for row in [0, 1, 40, 120] {
        page.value(&format!(
            "(() => {{ const s = document.querySelector('#position'); s.value = {row}; s.dispatchEvent(new Event('input')); }})()"
        ));
        let expected = place(&mut page, 3.0 * f64::from(row));
        let found = line(&mut page);
        assert!(
            (found - expected).abs() < 0.6,
            "{found} instead of {expected}"
        );
    }
    let [_, top, _, tall] = page.place("#cyclogram svg");
    let at = (place(&mut page, 90.0), top + 0.4 * tall);
    page.click_at(at);
    assert_eq!(page.row(), 30);
    let to = (place(&mut page, 201.0), at.1);
    page.drag(at, to);
    assert_eq!(page.row(), 67);
    // What each event comes after is the one before it, and overlaps lead to where they begin.
    let follows = page.words(
        "(() => { const rows = [...document.querySelectorAll('[data-table=cyclogram] tbody tr')]; \
         const wrong = rows.filter((r, k) => !r.lastChild.textContent.startsWith(rows.at(k - 1).cells[0].textContent + \"'s \")); \
         return rows.length + ' ' + wrong.length + ' ' + rows[0].lastChild.textContent; })()",
    );
    assert_eq!(follows, "8 0 hook.needle's dwell (bottom 4 mm) ends");
    let overlap = "[...document.querySelectorAll('[data-table=overlaps] tbody tr')].find((r) => r.cells[0].querySelector('small').textContent === 'advance')";
    let [at, to, long] = [2, 3, 4]
        .map(|cell| page.number(&format!("parseFloat({overlap}.cells[{cell}].textContent)")));
    assert!(
        (to - at - long).rem_euclid(360.0) < 1e-3,
        "{at} {to} {long}"
    );
    page.value(&format!("{overlap}.querySelector('button').click()"));
    assert_eq!(page.row(), (at / 3.0).round() as usize);
    // The dwell of the needle begins where its lift comes into the band.
    let begins = page.number(
        "(() => { const r = [...document.querySelectorAll('[data-table=cyclogram] tbody tr')].find((r) => r.cells[0].textContent === 'hook.needle' && r.cells[2].textContent.startsWith('dwell (top')); \
         r.querySelector('button').click(); return parseFloat(r.cells[3].textContent); })()",
    );
    let band = lift(std::f64::consts::FRAC_PI_2)[0] - 3.0;
    assert!(
        (lift(begins.to_radians())[0] - band).abs() < 1e-4,
        "{begins}"
    );
    assert_eq!(page.row(), (begins / 3.0).round() as usize);
    page.on_paper();
    let [_, _, wide, _] = page.place("#cyclogram svg");
    assert!(wide > 300.0 && wide < 704.0, "{wide}");
    page.assert_quiet();
}

/// Where a point is in the page's data, and where its mark is on the screen.
fn seen(page: &mut Page, point: &str) -> [f64; 4] {
    let found = page.value(&format!(
        "(() => {{ const p = document.querySelector('[data-point=\"{point}\"]'); const m = p.querySelector('.mark'); \
         return [p.dataset.x, p.dataset.y, m.getAttribute('cx'), m.getAttribute('cy')].map(Number); }})()"
    ));
    [0, 1, 2, 3].map(|i| found[i].as_f64().expect("a place"))
}

fn stand_on(page: &mut Page, body: &str) {
    page.value(&format!(
        "(() => {{ const s = document.querySelector('#seen'); s.value = [...s.options].find((o) => o.textContent === '{body}').value; s.dispatchEvent(new Event('change')); }})()"
    ));
}

fn go(page: &mut Page, row: usize) {
    page.value(&format!(
        "(() => {{ const s = document.querySelector('#position'); s.value = {row}; s.dispatchEvent(new Event('input')); }})()"
    ));
}

/// A step as two ends tell it: along the way from the one to the other, and to the left of it.
fn within(ends: [[f64; 4]; 2], point: [f64; 4]) -> [f64; 2] {
    let [a, b] = ends;
    let (x, y) = (b[0] - a[0], b[1] - a[1]);
    let length = x.hypot(y);
    let (u, v) = (point[0] - a[0], point[1] - a[1]);
    [(x * u + y * v) / length, (x * v - y * u) / length]
}

#[test]
fn who_stands_on_a_link_sees_it_stand_still() {
    let Some(mut page) = page("machine-seen") else {
        return;
    };
    go(&mut page, 20);
    let names = ["hook.pin", "hook.needle", "eye.tip", "eye.pivot"];
    let rows = [20, 0, 47, 90, 120];
    let mut fixed = Vec::new();
    for row in rows {
        go(&mut page, row);
        fixed.push(names.map(|name| seen(&mut page, name)));
    }
    go(&mut page, 20);
    stand_on(&mut page, "hook.rod");
    let mut first = None;
    for (row, places) in rows.into_iter().zip(&fixed) {
        go(&mut page, row);
        let now = names.map(|name| seen(&mut page, name));
        let [pin, needle, ..] = now;
        let home = *first.get_or_insert([pin, needle]);
        for (place, home) in [pin, needle].into_iter().zip(home) {
            let apart = (0..4)
                .map(|i| (place[i] - home[i]).abs())
                .fold(0.0, f64::max);
            assert!(apart < 1e-9, "it moves by {apart} at row {row}");
        }
        // Everything else is where it is to the link.
        for point in [2, 3] {
            let expected = within([places[0], places[1]], places[point]);
            let found = within([pin, needle], now[point]);
            let apart = [0, 1].map(|i| (found[i] - expected[i]).abs());
            assert!(apart.iter().all(|x| *x < 1e-9), "{apart:?} at row {row}");
        }
    }
    let start = first.expect("a place");
    let apart = [0, 1].map(|i| (start[0][i] - fixed[0][0][i]).abs());
    assert!(
        apart.iter().all(|x| *x < 1e-9),
        "it stays where it was: {apart:?}"
    );
    // The path of the tip is the one that the link sees: through where the tip is in another row.
    go(&mut page, 47);
    let tip = seen(&mut page, "eye.tip");
    let nearest = page.number(&format!(
        "(() => {{ const p = document.querySelector('[data-trace=\"eye.tip\"]').getAttribute('d').match(/-?[\\d.]+/g).map(Number); \
         return Math.hypot(p[94] - {}, p[95] - {}); }})()",
        tip[2], tip[3]
    ));
    assert!(nearest < 0.02, "{nearest}");
    page.value("scrollTo(0, 0)");
    page.shoot("machine-seen");
    page.click("#back");
    for (row, places) in rows.into_iter().zip(&fixed) {
        go(&mut page, row);
        assert_eq!(names.map(|name| seen(&mut page, name)), *places);
    }
    assert!(page.holds(
        "document.querySelector('#back').hidden && document.querySelector('#seen').value === ''"
    ));
    // A double click on the link does the same, there and back.
    for standing in [true, false] {
        let place = page.middle("[data-link='hook.rod'] .body");
        page.double_click(place);
        assert_eq!(
            page.holds("document.querySelector('#back').hidden"),
            !standing
        );
    }
    // A slider goes straight: nothing turns about it.
    stand_on(&mut page, "slider hook.lift");
    let home = seen(&mut page, "hook.needle");
    go(&mut page, 70);
    assert_eq!(seen(&mut page, "hook.needle")[3], home[3]);
    let [x, y, ..] = seen(&mut page, "eye.pivot");
    let [from, to] = [120, 70].map(|row| lift(f64::from(row) * 3f64.to_radians())[0]);
    assert!(
        (x + 190.0).abs() < 1e-9 && (y - 30.0 - from + to).abs() < 1e-9,
        "{x} {y}"
    );
    page.assert_quiet();
}

/// A crank turns about its axis and the rocker has three points; who stands on the coupler between balls might turn about it.
#[test]
fn in_space_one_stands_on_what_tells_how_it_turns() {
    let file = written(&spatial_machine(), "machine-in-space");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    let offered =
        "[...document.querySelectorAll('#seen option')].map((o) => o.textContent).join('; ')";
    assert_eq!(page.words(offered), "the frame; crank; rocker");
    let at = |page: &mut Page, name: &str| {
        let found = page.value(&format!(
            "(() => {{ const d = document.querySelector('[data-point={name}]').dataset; return [d.x, d.y, d.z].map(Number); }})()"
        ));
        [0, 1, 2].map(|i| found[i].as_f64().expect("a place"))
    };
    let apart =
        |a: [f64; 3], b: [f64; 3]| (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt();
    let rows = [0, 45, 100, 180];
    let mut lengths = Vec::new();
    for row in rows {
        go(&mut page, row);
        let [p, q, tip] = ["p", "q", "tip"].map(|name| at(&mut page, name));
        lengths.push([apart(p, q), apart(p, tip)]);
    }
    for (body, fixed, path) in [
        ("crank", ["shaft", "p"], "q"),
        ("rocker", ["q", "tip"], "p"),
    ] {
        go(&mut page, 0);
        let home = fixed.map(|name| at(&mut page, name));
        let start = at(&mut page, path);
        stand_on(&mut page, body);
        for (row, lengths) in rows.into_iter().zip(&lengths) {
            go(&mut page, row);
            let now = fixed.map(|name| at(&mut page, name));
            assert!(apart(now[0], home[0]) < 1e-9 && apart(now[1], home[1]) < 1e-9);
            let [p, q, tip] = ["p", "q", "tip"].map(|name| at(&mut page, name));
            assert!((apart(p, q) - lengths[0]).abs() < 1e-9);
            assert!((apart(p, tip) - lengths[1]).abs() < 1e-9);
        }
        go(&mut page, 45);
        assert!(
            apart(at(&mut page, path), start) > 10.0,
            "{path} moves about {body}"
        );
        page.click("#back");
    }
    page.assert_quiet();
}

#[test]
fn without_parts_there_is_nothing_of_it() {
    let file = written(&four_bar("No machine", FourBar::TURNING), "no-machine");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    for id in ["parts", "cyclogram"] {
        assert_eq!(page.place(&format!("#{id}"))[3], 0.0, "{id}");
    }
    page.assert_quiet();
}
