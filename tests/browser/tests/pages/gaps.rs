//! Positions that cannot be assembled.

use crate::checks;
use linkage_browser::samples::{FourBar, Sheet, four_bar, written};
use linkage_browser::{Key, Page};
use linkage_report::Report;
use linkage_runtime::{Column, Heading, Input, Meaning};

#[test]
fn the_page_says_so_and_nothing_is_drawn_there() {
    let file = written(&four_bar("Swinging", FourBar::SWINGING), "swinging");
    let Some(mut page) = Page::open(&file) else {
        return;
    };
    checks::all(&mut page, "swinging");

    let report = checks::report(&mut page);
    let gaps = report["gaps"].as_array().expect("gaps");
    assert!(!gaps.is_empty());
    let words = page.words("document.querySelector('#gaps').innerText");
    assert!(
        words.contains("cannot be assembled") && words.contains("deg"),
        "{words}"
    );
    let shaded = page.number("document.querySelectorAll('.panel:first-child .gap').length");
    assert_eq!(shaded as usize, gaps.len());

    // The curve of a column with gaps begins as often as the column has stretches of numbers.
    let values = report["tables"][0]["columns"][0]["values"]
        .as_array()
        .expect("values");
    let begins = (0..values.len())
        .filter(|&i| !values[i].is_null() && (i == 0 || values[i - 1].is_null()))
        .count();
    assert!(begins > 0 && values.iter().any(serde_json::Value::is_null));
    let drawn = page.number("document.querySelector('.curve[data-column^=\"motion||tracer.x\"]').getAttribute('d').split('M').length - 1");
    assert_eq!(drawn as usize, begins);
    assert!(
        !page
            .words("document.querySelector('.curve').getAttribute('d')")
            .contains("NaN")
    );

    // At a dead point velocities grow beyond all bounds: the axis ends before, and the page says where they get.
    let cut = page.words("document.querySelector('.panel[data-unit=\"mm/s\"] .cut').innerText");
    assert!(cut.contains("go on beyond the axis"), "{cut}");
    assert!(page.holds("document.querySelector('.panel[data-unit=mm] .cut') === null"));

    let missing = values
        .iter()
        .position(serde_json::Value::is_null)
        .expect("a gap");
    checks::go_to(&mut page, missing);
    let said = page.words("document.querySelector('#impossible').innerText");
    assert!(said.contains("Cannot be assembled at"), "{said}");
    assert!(
        page.words("document.querySelector('.legend .value').innerText")
            .contains("none")
    );
    page.shoot("swinging-gap");
    page.key(Key::Right);
    page.assert_quiet();
}

static SPOTTED: Heading = Heading {
    function: "spotted",
    arguments: &["s"],
    columns: &[Column {
        name: "y",
        unit: "mm",
        meaning: Meaning::Value,
    }],
    picture: None,
};

/// Every other value is missing: some places are told, the others counted.
#[test]
fn many_gaps_are_no_litany() {
    let input = Input {
        name: "s",
        unit: "mm",
        reference: 0.0,
        range: Some((0.0, 40.0)),
    };
    let positions = input.positions(41);
    let spotted = Sheet::new(&SPOTTED, &positions, |s| {
        [if s % 2.0 > 0.5 { f64::NAN } else { s }]
    });
    let report = Report::new("Spotted", &input, &positions).table(&spotted);
    let Some(mut page) = Page::open(&written(&report, "spotted")) else {
        return;
    };
    let words = page.words("document.querySelector('#gaps').innerText");
    assert!(
        words.contains("at s = 1 mm, 3 mm, 5 mm, 7 mm, and 16 more: the mechanism"),
        "{words}"
    );
    let shaded = page.number("document.querySelectorAll('.plot .gap').length");
    assert_eq!(shaded as usize, 20);
    page.assert_quiet();
}
