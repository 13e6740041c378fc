//! Tables and files: nothing is lost.

use crate::checks;
use linkage_browser::samples::{FourBar, four_bar, many, roundoff, written};
use linkage_browser::{Key, Page, SMALL_PHONE};
use serde_json::Value;

fn page(name: &str) -> Option<Page> {
    Page::open(&written(&four_bar("Tables", FourBar::TURNING), name))
}

fn table(page: &mut Page, name: &str) -> String {
    page.words(&format!(
        "document.querySelector('[data-table={name:?}]').innerText.replace(/\\t/g, '|')"
    ))
}

#[test]
fn what_is_known_is_told() {
    let Some(mut page) = page("tables") else {
        return;
    };
    let dimensions = table(&mut page, "dimensions");
    assert!(
        dimensions.contains("crank|50|\u{b1} 0.012||mm"),
        "{dimensions}"
    );
    assert!(
        dimensions.contains("rocker|100|\u{b1} 0.02|100.01|mm"),
        "{dimensions}"
    );
    let groups = table(&mut page, "groups");
    assert!(
        groups.contains("1|RRR|2|2|+|1|theta, psi|intersection of two circles"),
        "{groups}"
    );
    let operations = table(&mut page, "operations");
    assert!(
        operations.contains("motion|61|21 add, 34 mul, 3 div, 1 sqrt, 1 sin_cos, 1 atan2"),
        "{operations}"
    );
    // Degrees, radians on a line below.
    let value = page.words("document.querySelector('[data-table=summary] .amount').innerText");
    let lines: Vec<&str> = value.lines().collect();
    assert_eq!(lines.len(), 2, "{value}");
    let [_, b, _] = FourBar::TURNING.points(1.0);
    let radians = b[1].atan2(b[0] - FourBar::TURNING.frame);
    assert!(
        checks::is_short_for(lines[0], radians.to_degrees()),
        "{value}"
    );
    let below = lines[1].trim_end_matches(" rad");
    assert!(checks::is_short_for(below, radians), "{value}");
    let unit = page.words("document.querySelector('[data-table=summary] tr:has(.amount small) td:last-child').textContent");
    assert_eq!(unit, "deg");
    let facts = table(&mut page, "facts");
    assert!(
        facts.contains("a test with <b>letters</b> & signs </script>"),
        "{facts}"
    );
    assert!(
        facts.starts_with("Speed of phi|62.8319 rad/s (600 revolutions per minute)\nmade by"),
        "{facts}"
    );
    let accuracy = table(&mut page, "accuracy");
    assert!(
        accuracy.contains("tracer.x|0.") && accuracy.contains("tracer.y|0."),
        "{accuracy}"
    );
    page.click(".scroll:has([data-table=accuracy]) + details summary");
    let parts = table(&mut page, "contributions tracer.x");
    assert!(parts.contains("arm|0.0"), "{parts}");
    page.shoot("tables");
    page.assert_quiet();
}

#[test]
fn places_in_tables_lead_there() {
    let Some(mut page) = page("places") else {
        return;
    };
    page.click("[data-table=summary] .place");
    assert_eq!(page.row(), 57, "1 rad is nearest to 57 deg");

    // In sight without scrolling sideways.
    page.screen(SMALL_PHONE);
    let [left, _, width, _] = page.place("[data-table=summary] .place");
    assert!(
        left >= 0.0 && left + width <= f64::from(SMALL_PHONE.width),
        "from {left}, {width} wide"
    );
    page.assert_quiet();
}

#[test]
fn all_values_of_a_position() {
    let Some(mut page) = page("values") else {
        return;
    };
    checks::go_to(&mut page, 123);
    page.click("#values summary");
    page.wait("document.querySelector('[data-value]').textContent !== ''");
    let report = checks::report(&mut page);
    for table in report["tables"].as_array().expect("tables") {
        for column in table["columns"].as_array().expect("columns") {
            let key = [
                &table["function"],
                &Value::from(""),
                &column["name"],
                &column["unit"],
            ]
            .map(|part| part.as_str().expect("words"))
            .join("|");
            let cell = format!("document.querySelector('[data-value={key:?}]')");
            let value = column["values"][123].as_f64().expect("a number");
            // Angles are in degrees, and have their radians at the end of the row.
            let cell = match column["unit"].as_str() {
                Some("rad") => {
                    let shown = page.words(&format!("{cell}.textContent"));
                    let unit = page.words(&format!("{cell}.nextSibling.textContent"));
                    assert!(
                        checks::is_short_for(&shown, value.to_degrees()),
                        "{key}: {shown}"
                    );
                    assert_eq!(unit, "deg", "{key}");
                    format!("{cell}.parentNode.querySelector('small [data-exact]')")
                }
                _ => cell,
            };
            let shown = page.words(&format!("{cell}.textContent"));
            assert!(checks::is_short_for(&shown, value), "{key}: {shown}");
            // What is left out is told where the pointer rests.
            let all = page.words(&format!("{cell}.title || {cell}.textContent"));
            assert_eq!(all.parse(), Ok(value), "{key}: {all}");
        }
    }
    page.shoot("values");
    page.assert_quiet();
}

/// What the clipboard gets when this is selected, by lines and columns.
fn copied(page: &mut Page, select: &str) -> Vec<Vec<String>> {
    let text = page.words(&format!(
        "(() => {{ {select}; const event = new ClipboardEvent('copy', {{ clipboardData: new DataTransfer(), bubbles: true, cancelable: true }}); \
         document.body.dispatchEvent(event); return event.defaultPrevented ? event.clipboardData.getData('text/plain') : 'left to the browser'; }})()"
    ));
    let lines = text.lines().filter(|line| !line.is_empty());
    lines
        .map(|line| line.split('\t').map(String::from).collect())
        .collect()
}

/// Numbers are short to read; who copies them gets all of their digits.
#[test]
fn copies_have_all_digits() {
    let Some(mut page) = page("copies") else {
        return;
    };
    let report = checks::report(&mut page);
    let whole =
        "getSelection().selectAllChildren(document.querySelector('[data-table=accuracy] tbody'))";
    let lines = copied(&mut page, whole);
    let known = report["accuracy"].as_array().expect("accuracy");
    assert_eq!(lines.len(), known.len(), "{lines:?}");
    for (line, known) in lines.iter().zip(known) {
        assert_eq!(line[0], known["quantity"]);
        for (cell, name) in [(1, "worst"), (2, "statistical")] {
            assert_eq!(line[cell].parse().ok(), known[name].as_f64(), "{line:?}");
        }
    }
    // A double click selects one number, which is a text by itself.
    let number = "((n, end) => getSelection().setBaseAndExtent(n, 0, n, end ?? n.length))";
    let first = "document.querySelector('[data-table=accuracy] td.number').firstChild";
    let lines = copied(&mut page, &format!("{number}({first})"));
    let all = known[0]["worst"].as_f64();
    assert_eq!(lines[0][0].parse().ok(), all, "{lines:?}");
    let part = format!("{number}({first}, 3)");
    assert_eq!(copied(&mut page, &part), [["left to the browser"]]);
    page.assert_quiet();
}

/// What a button gives to save.
fn saved(page: &mut Page, name: &str) -> String {
    page.value("window.caught = null; URL.createObjectURL = (blob) => { blob.text().then((text) => { window.caught = text; }); return 'data:,'; };");
    page.click(&format!("[data-file={name:?}]"));
    page.wait("window.caught !== null");
    page.words("window.caught")
}

/// The numbers below the head, to the last bit.
fn bits(csv: &str) -> Vec<Option<u64>> {
    let fields = csv.split("\r\n").skip(1).flat_map(|line| line.split(','));
    fields
        .map(|field| field.parse().ok().map(f64::to_bits))
        .collect()
}

/// The files that the buttons give have every number to the last bit.
#[test]
fn files_hold_the_data() {
    let report = four_bar("Files", FourBar::TURNING);
    let Some(mut page) = Page::open(&written(&report, "files")) else {
        return;
    };
    let json: Value = serde_json::from_str(&saved(&mut page, "data.json")).expect("JSON");
    let original: Value = serde_json::from_str(&report.json().expect("no mistakes")).expect("JSON");
    assert_eq!(json, original);

    let csv = saved(&mut page, "motion.csv");
    let original = report.csv("motion").expect("no mistakes");
    assert_eq!(csv.lines().next(), original.lines().next());
    assert_eq!(bits(&csv), bits(&original));
    assert!(bits(&csv).len() > 361 * 17);
}

#[test]
fn files_hold_the_sign_of_zero() {
    let report = roundoff();
    let Some(mut page) = Page::open(&written(&report, "zeros")) else {
        return;
    };
    let original = bits(&report.csv("guided").expect("no mistakes"));
    assert!(original.contains(&Some((-0.0_f64).to_bits())));
    assert_eq!(bits(&saved(&mut page, "guided.csv")), original);
}

// Pages of more positions than they show.

#[test]
fn a_page_says_how_many_positions_it_has() {
    let Some(mut page) = Page::open(&written(&many(30_001), "thinned")) else {
        return;
    };
    let report = checks::report(&mut page);
    let rows = report["input"]["values"].as_array().map_or(0, Vec::len);
    assert!((19_000..=20_000).contains(&rows), "{rows}");
    let said = page.words("document.querySelector('#thinned').innerText");
    assert!(
        said.starts_with(&format!("This page has {rows} of 30001 positions")),
        "{said}"
    );
    page.key(Key::End);
    assert_eq!(page.row(), rows - 1);
    page.shoot("thinned");
    page.assert_quiet();
}
