//! A changed design names its changes: on the page, on paper, in every file.

use std::fs;

use linkage_browser::{Page, printed_words};

use crate::pages::{CATCH, Live};

const LINE: &str = "changed: crank = 45.25 mm (50), lift = 20 deg (25)";

/// The words of the line below the title; nothing if there is none.
fn line(page: &mut Page) -> String {
    page.words("document.getElementById('changes').textContent")
}

/// The rows of the table of dimensions, cells between bars.
fn dimensions(page: &mut Page) -> String {
    page.words("[...document.querySelectorAll('[data-table=dimensions] tr')].map((row) => [...row.cells].map((cell) => cell.innerText.replace(/\\n/g, ' ')).join('|')).join('\\n')")
}

fn typed(page: &mut Page, name: &str, text: &str) {
    page.value(&format!(
        "(() => {{ const field = document.querySelector('input[data-dimension={name}]'); field.value = '{text}'; \
         field.dispatchEvent(new Event('change')); }})()"
    ));
}

fn changed(kind: &str) -> Option<Live> {
    let mut live = Live::golden_as("crank_rocker.mech", kind)?;
    assert_eq!(line(&mut live.page), "");
    typed(&mut live.page, "crank", "45.25");
    typed(&mut live.page, "lift", "20");
    Some(live)
}

#[test]
fn changes_stand_below_the_title_and_in_the_table() {
    let Some(mut live) = changed("changes_shown") else {
        return;
    };
    let page = &mut live.page;
    assert_eq!(line(page), LINE);
    let [_, title, _, height] = page.place("#title");
    assert!(page.place("#changes")[1] >= title + height);
    let table = dimensions(page);
    assert!(
        table.starts_with("dimension|nominal|tolerance|actual|unit\n"),
        "{table}"
    );
    assert!(
        table.contains("\ncrank|50|\u{b1} 0.012|45.25|mm\n"),
        "{table}"
    );
    assert!(table.contains("\nrocker|100|\u{b1} 0.02||mm\n"), "{table}");
    // Degrees first.
    assert!(
        table.contains(
            "\nlift|25 0.436332 rad|\u{b1} 0.00833333 \u{b1} 0.000145444 rad|20 0.349066 rad|deg"
        ),
        "{table}"
    );
    page.shoot("changes");
    typed(page, "lift", "25");
    assert_eq!(line(page), "changed: crank = 45.25 mm (50)");
    typed(page, "crank", "50");
    assert_eq!(line(page), "");
    let table = dimensions(page);
    assert!(table.contains("\ncrank|50|\u{b1} 0.012|mm\n"), "{table}");
    page.value("document.getElementById('undo').click()");
    assert_eq!(line(page), "changed: crank = 45.25 mm (50)");
    page.assert_quiet();
}

/// Another assembly is a change, too.
#[test]
fn another_assembly_is_named() {
    let Some(mut live) = Live::golden_as("crank_rocker.mech", "changes_assembly") else {
        return;
    };
    live.page
        .value("(() => { const select = document.getElementById('assembly'); select.dispatchEvent(new Event('focus')); select.value = 1; select.dispatchEvent(new Event('change')); })()");
    let said = line(&mut live.page);
    assert!(said.starts_with("changed: other assembly "), "{said}");
    live.page.assert_quiet();
}

/// The PDF of a changed design, read back.
#[test]
fn changes_are_printed() {
    let Some(mut live) = changed("changes_printed") else {
        return;
    };
    let words = |page: &mut Page, name: &str| {
        let file = page.print(name);
        printed_words(&fs::read(file).expect("a PDF"))
    };
    let printed = words(&mut live.page, "changed");
    assert!(printed.contains(LINE), "{printed}");
    for row in [
        "crank\n50\n\u{b1} 0.012\n45.25\nmm",
        "tolerance\nactual\nunit",
    ] {
        assert!(printed.contains(row), "{row:?} in {printed}");
    }
    live.page.value("document.getElementById('reset').click()");
    let printed = words(&mut live.page, "unchanged");
    assert!(
        !printed.contains("changed:") && !printed.contains("actual"),
        "{printed}"
    );
    assert!(printed.contains("crank\n50\n\u{b1} 0.012\nmm"), "{printed}");
    live.page.assert_quiet();
}

/// The texts of a saved picture.
fn texts(live: &mut Live, name: &str) -> String {
    let svg = live.file(name);
    live.page.words(&format!(
        "[...new DOMParser().parseFromString({}, 'image/svg+xml').querySelectorAll('text')].map((own) => own.textContent).join(' ')",
        serde_json::Value::from(svg)
    ))
}

#[test]
fn every_file_names_the_changes() {
    let Some(mut live) = changed("changes_files") else {
        return;
    };
    let files = live.page.words(
        "[...document.querySelectorAll('button[data-file]')].map((own) => own.dataset.file).join()",
    );
    assert_eq!(
        files,
        "data.json,path.csv,motion.csv,accuracy.csv,quality.csv,page.html,plots.svg,plots.png"
    );
    for name in ["path.csv", "motion.csv", "accuracy.csv", "quality.csv"] {
        let text = live.file(name);
        assert_eq!(
            text.lines().next(),
            Some(&*format!("\"# {LINE}\"")),
            "{name}"
        );
        assert!(
            text.lines()
                .nth(1)
                .expect("a head")
                .starts_with("phi [rad],")
        );
    }
    let data: serde_json::Value = serde_json::from_str(&live.file("data.json")).expect("JSON");
    assert_eq!(data["changed"]["dimensions"]["crank"], 45.25);
    let words = texts(&mut live, "plots.svg");
    assert!(words.contains(LINE), "{words}");
    // A copy of the page is the changed design again, whatever its address is.
    let copy = live.file("page.html");
    let shown = live.csv("motion");
    let file = crate::pages::beside("crank_rocker", "changes_files", "copy.html", &copy);
    let page = &mut live.page;
    page.value("delete document.body.dataset.ready; 0");
    page.load(&file);
    page.wait("document.body.dataset.ready === 'true' && location.pathname.endsWith('copy.html') && document.querySelectorAll('#live').length === 1");
    assert_eq!(line(page), LINE);
    for once in [
        "#live",
        "#changes",
        "#says",
        "#quantities",
        "#values",
        "#play",
        "#title",
        "#dimensions",
    ] {
        assert_eq!(
            page.number(&format!("document.querySelectorAll('{once}').length")),
            1.0,
            "{once}"
        );
    }
    page.value(CATCH);
    assert!(live.csv("motion") == shown);
    live.page.value("document.getElementById('reset').click()");
    assert_eq!(line(&mut live.page), "");
    let text = live.file("motion.csv");
    assert!(text.starts_with("phi [rad],"));
    let words = texts(&mut live, "plots.svg");
    assert!(!words.contains("changed"), "{words}");
    live.page.assert_quiet();
}

/// The drawing has the line below itself, and not over the mechanism.
#[test]
fn saved_drawings_name_the_changes() {
    let Some(mut live) = Live::example_as("favorit.rs", "changes_drawing") else {
        return;
    };
    let (name, nominal) = {
        let own = live
            .mechanism
            .parameters()
            .iter()
            .find(|own| own.unit == "mm" && own.nominal > 0.0)
            .expect("a length");
        (own.name, own.nominal)
    };
    let before = live.file("mechanism.svg");
    live.page
        .value(&format!("location.hash = '{name}={}'", nominal * 1.01));
    live.page
        .wait("document.getElementById('changes').textContent !== ''");
    let words = texts(&mut live, "mechanism.svg");
    let said = line(&mut live.page);
    assert!(
        said.starts_with(&format!("changed: {name} = ")) && words.ends_with(&said),
        "{words}"
    );
    let tall = |svg: &str| -> f64 {
        let (_, rest) = svg.split_once(" height=\"").expect("a height");
        rest.split('"')
            .next()
            .expect("an end")
            .parse()
            .expect("a number")
    };
    let after = live.file("mechanism.svg");
    assert!(tall(&after) > tall(&before) + 15.0);
    live.page.assert_quiet();
}
