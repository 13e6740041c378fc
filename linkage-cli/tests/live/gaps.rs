//! Where rows are missing: they are hatched, and the reason stands there.

use crate::pages::Live;

fn reason(live: &mut Live, address: &str) -> String {
    // Until it is read, what is shown is that of the address before.
    live.page.value(&format!(
        "new Promise((done) => {{ addEventListener('hashchange', () => setTimeout(done), {{ once: true }}); location.hash = '{address}'; }})"
    ));
    live.page.wait(
        "!document.getElementById('gaps').hidden && document.querySelector('.hatch') !== null",
    );
    live.page
        .words("document.getElementById('gaps').textContent")
}

/// The rocker and the coupler reach 10 mm less than the crank and the frame need at the outer dead point, which is at half a turn.
#[test]
fn the_length_that_is_too_short_is_named() {
    let Some(mut live) = Live::golden_as("crank_rocker.mech", "gaps") else {
        return;
    };
    let said = reason(&mut live, "rocker=60");
    assert!(
        said.contains(": rocker 10 mm too short at phi = 180 deg. Plots have gaps"),
        "{said}"
    );
    let said = reason(&mut live, "coupler=75");
    assert!(
        said.contains(": coupler 15 mm too short at phi = 180 deg."),
        "{said}"
    );
    // A crank of 75 mm with a frame of 140 mm and a coupler of 80 mm: it would have to be shorter.
    let said = reason(&mut live, "crank=90");
    assert!(
        said.contains("crank 10 mm too long at phi = 180 deg"),
        "{said}"
    );
    // A crank that is 30 mm long cannot be 50 mm too long.
    let said = reason(&mut live, "crank=30&coupler=20");
    assert!(
        said.contains(": coupler 50 mm too short at phi = 180 deg."),
        "{said}"
    );
    let strokes = "document.querySelectorAll('.panel .hatch').length === document.querySelectorAll('.panel .gap').length";
    assert!(live.page.holds(strokes));
    live.page.shoot("live-hatched");
    let inside = "(() => { const [gap, hatch] = ['.gap', '.hatch'].map((own) => document.querySelector('.panel ' + own).getBBox()); \
                  return hatch.width > 0.9 * gap.width && hatch.x >= gap.x - 0.02 && hatch.x + hatch.width <= gap.x + gap.width + 0.02 && hatch.y >= gap.y - 0.02; })()";
    assert!(live.page.holds(inside));
    live.page.value("document.getElementById('reset').click()");
    assert!(live.page.holds("document.getElementById('gaps').hidden"));
    assert!(live.page.holds("document.querySelector('.hatch') === null"));
    live.page.assert_quiet();
}

/// Rows exist on both sides of a change point, and next to it: only the warning says that the mechanism may go on in another assembly.
#[test]
fn a_change_point_is_told_with_its_places() {
    let Some(mut live) = Live::golden_as("crank_rocker.mech", "change_points") else {
        return;
    };
    let said = |live: &mut Live, address: &str| {
        live.page.value(&format!(
            "new Promise((done) => {{ addEventListener('hashchange', () => setTimeout(done), {{ once: true }}); location.hash = '{address}'; }})"
        ));
        live.page
            .words("document.getElementById('gaps').textContent")
    };
    let words = said(&mut live, "coupler=140&rocker=50");
    let expected = "At phi = 0 deg, 180 deg, 360 deg the mechanism passes through a change point: from there loop 1 (theta, psi) can go \
                    on in another assembly.";
    assert!(words.ends_with(expected), "{words}");
    let words = said(&mut live, "coupler=140&rocker=50.01");
    assert!(!words.contains("change point"), "{words}");
    live.page.assert_quiet();
}

/// Of a group without a closed form the page knows where its solution ends: there Rust's rows end, too.
#[test]
fn the_end_of_a_coupled_group_is_told() {
    let Some(mut live) = Live::example_as("eye_needle.rs", "gaps") else {
        return;
    };
    let said = reason(&mut live, "l57=150");
    let (_, rest) = said
        .split_once("comes to a dead point at phi = ")
        .unwrap_or_else(|| panic!("{said}"));
    let (places, _) = rest
        .split_once(", where this assembly ends")
        .unwrap_or_else(|| panic!("{said}"));
    let places: Vec<f64> = places
        .split(" and ")
        .map(|own| own.trim_end_matches(" deg").parse().expect("a place"))
        .collect();
    let names: Vec<&str> = live
        .mechanism
        .compiled()
        .unknowns
        .iter()
        .map(|own| own.name.as_str())
        .collect();
    assert!(
        names.iter().filter(|name| said.contains(*name)).count() >= 4,
        "{said}"
    );
    // The first rows without a value are beside them.
    let text = live.csv("rocker");
    let rows: Vec<Vec<&str>> = text
        .lines()
        .skip(1)
        .map(|line| line.split(',').collect())
        .collect();
    for pair in rows.windows(2) {
        if pair[0][1].is_empty() == pair[1][1].is_empty() {
            continue;
        }
        let [a, b] = [0, 1].map(|k| pair[k][0].parse::<f64>().expect("an input").to_degrees());
        let turned = |place: &f64| [place - 360.0, *place, place + 360.0];
        assert!(
            places
                .iter()
                .flat_map(turned)
                .any(|place| place >= a - 1e-3 && place <= b + 1e-3),
            "{a} to {b}: {said}"
        );
    }
    live.page.assert_quiet();
}
