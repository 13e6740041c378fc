//! A changed design names its changes: on the page, on paper, in every file.

use std::fs;
use std::path::Path;
use std::process::Command;

use linkage_browser::{Page, printed_words};

use crate::pages::{CATCH, Live, saved_file};

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
        "(() => {{ const field = document.querySelector('input[data-dimension=\"{name}\"]'); field.value = '{text}'; \
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
        "data.json,CrankRocker.mech,path.csv,motion.csv,accuracy.csv,quality.csv,picture.csv,page.html,mechanism.svg,mechanism.png,plots.svg,plots.png,moving.svg,moving.webm,moving.gif,mechanism.dxf"
    );
    let tables = ["path", "motion", "accuracy", "quality", "picture"];
    for name in tables.map(|table| format!("{table}.csv")) {
        let text = live.file(&name);
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

/// The text of a changed design is a mechanism with these defaults: the command computes the page's table from it.
#[test]
fn the_text_is_the_changed_design() {
    let Some(mut live) = changed("changes_text") else {
        return;
    };
    typed(&mut live.page, "pivot_d.y", "-7,5");
    let text = live.file("CrankRocker.mech");
    assert!(
        text.starts_with(
            "// changed: pivot_d.y = -7.5 mm (0), crank = 45.25 mm (50), lift = 20 deg (25)\n    /// Crank-rocker"
        ),
        "{text}"
    );
    for line in [
        "param pivot_d = (140mm +- 0.02mm, -7.5mm +- 0.02mm);",
        "param crank   = 45.25mm  +- 12um;             // a public field",
        "param lift    = 20deg +- 30arcsec;",
        "param coupler = 120mm +- 20um;",
    ] {
        assert!(text.contains(line), "{line} in {text}");
    }
    let shown = live.csv("motion");
    let file = crate::pages::beside("crank_rocker", "changes_text", "changed.mech", &text);
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    let output = command.args(["table"]).arg(&file).arg("motion").output();
    let output = output.expect("it runs");
    let printed = String::from_utf8(output.stdout).expect("text");
    assert_eq!(printed.lines().next(), shown.lines().next());
    let numbers = |text: &str| -> Vec<f64> {
        let rows = text.lines().skip(1);
        let words = rows.flat_map(|row| row.split(','));
        words.map(|word| word.parse().expect("a number")).collect()
    };
    let [printed, shown] = [printed.as_str(), shown.as_str()].map(numbers);
    assert_eq!(printed.len(), 361 * 8);
    assert_eq!(printed.len(), shown.len());
    // Degrees are rounded once in the text, and twice in the page.
    for (command, page) in printed.iter().zip(&shown) {
        assert!((command - page).abs() < 1e-11, "{command}, {page}");
    }
    // The report's own text is as it was.
    live.page.value("document.getElementById('reset').click()");
    let text = live.file("CrankRocker.mech");
    assert!(
        text.contains("param crank   = 50mm  +- 12um;") && !text.contains("changed"),
        "{text}"
    );
    live.page.assert_quiet();
}

/// Defaults of every form, and what is not in the text.
#[test]
fn defaults_of_every_form_are_replaced() {
    let text = "
    // struct Forms { param crank = 1mm; }
    pub struct Other { unit mm; param crank = 7mm; input phi = 30deg in 0deg..90deg; let end = polar(crank, phi); }
    impl Other { pub fn motion(phi) -> OtherMotion { end } }
    pub struct Forms {
        unit mm;
        const base = (1mm, 2mm);
        /* param crank = 2mm; */
        param crank = 2 * (20mm + 1mm); // param crank = 3mm;
        param pivot = (10mm, -(2mm + 1mm)) +- 0.1mm;
        param tool =
            polar(5mm, 30deg);
        param size = 2 +- 0.1;
        part arm: Other { phi = phi };
        input phi = 30deg in 0deg..90deg;
        let end = pivot + polar(crank * size, phi) + tool + base;
    }
    impl Forms { pub fn motion(phi) -> FormsMotion { end, other: arm.end } }";
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("forms");
    fs::create_dir_all(&folder).expect("a folder");
    fs::write(folder.join("forms.mech"), text).expect("a file");
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    let output = command
        .args(["page", "forms.mech", "--mechanism", "Forms"])
        .current_dir(&folder)
        .output();
    let output = output.expect("it runs");
    assert!(output.status.success(), "{output:?}");
    let Some(mut page) = Page::open(&folder.join("forms_page/index.html")) else {
        return;
    };
    page.value(CATCH);
    for (name, value) in [
        ("crank", "43"),
        ("pivot.y", "-4"),
        ("tool.x", "6"),
        ("size", "1.5"),
        ("arm.crank", "8"),
    ] {
        typed(&mut page, name, value);
    }
    let changed = saved_file(&mut page, "Forms.mech");
    let expected = text
        .replace("2 * (20mm + 1mm);", "43mm;")
        .replace("-(2mm + 1mm)) +- 0.1mm", "-4mm) +- 0.1mm")
        .replace("2 +- 0.1", "1.5 +- 0.1");
    let (notes, rest) = changed.split_once("\n\n").expect("notes before the text");
    assert_eq!(format!("\n{rest}"), expected);
    assert!(
        notes.ends_with("\n// not part of this text: tool.x, arm.crank"),
        "{notes}"
    );
    page.assert_quiet();
}

/// Drawn joints of the frame, in lists, and lengths of links. A length that is drawn has no number.
#[test]
fn joints_and_lengths_are_replaced() {
    let text = "
    pub struct Drawn {
        unit mm;
        joint a = (0mm, 0mm), d = (140mm, 0mm);  // joint d = (1mm, 2mm)
        joint b = (25mm, 43.3mm), c = (115mm, 96.8mm);
        input phi = 60deg in 0deg..360deg;
        link frame: a, d;
        link crank: a, b at phi;
        link coupler: b, c;
        link rocker: d, c length 100mm +- 0.05mm;
    }
    impl Drawn { pub fn motion(phi) -> DrawnMotion { psi: rocker.angle } }";
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("drawn_joints");
    fs::create_dir_all(&folder).expect("a folder");
    fs::write(folder.join("drawn.mech"), text).expect("a file");
    let mut command = Command::new(env!("CARGO_BIN_EXE_linkage"));
    let output = command
        .args(["page", "drawn.mech"])
        .current_dir(&folder)
        .output();
    let output = output.expect("it runs");
    assert!(output.status.success(), "{output:?}");
    let Some(mut page) = Page::open(&folder.join("drawn_page/index.html")) else {
        return;
    };
    page.value(CATCH);
    for (name, value) in [
        ("d.x", "141"),
        ("d.y", "-2"),
        ("rocker.length", "99.5"),
        ("coupler.length", "105"),
    ] {
        typed(&mut page, name, value);
    }
    let changed = saved_file(&mut page, "Drawn.mech");
    let expected = text
        .replace("(140mm, 0mm)", "(141mm, -2mm)")
        .replace("length 100mm", "length 99.5mm");
    let (notes, rest) = changed.split_once("\n\n").expect("notes before the text");
    assert_eq!(format!("\n{rest}"), expected);
    assert!(
        notes.ends_with("\n// not part of this text: coupler.length"),
        "{notes}"
    );
    page.assert_quiet();
}

/// Lines of DXF in an order of their own, numbers without their last digits: outlines may begin at other corners.
fn entities(dxf: &str) -> Vec<String> {
    let rounded = |line: &str| match line.parse::<f64>() {
        Ok(number) => format!("{:.9}", number + 0.0),
        Err(_) => line.to_owned(),
    };
    let mut lines: Vec<String> = dxf.lines().map(rounded).collect();
    lines.sort();
    lines
}

/// The drawing for other programs is that of the report, and of a changed design has its places and its line.
#[test]
fn the_drawing_is_saved_for_other_programs() {
    for name in ["favorit.rs", "spatial_crank_rocker.rs"] {
        let Some(mut live) = Live::example_as(name, "dxf") else {
            return;
        };
        let stem = name.trim_end_matches(".rs");
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("dxf_{stem}"));
        let of_report = fs::read_to_string(folder.join("drawing.dxf")).expect("it was written");
        let caption = of_report
            .lines()
            .find(|line| line.contains(", lengths in "));
        let caption = caption.expect("a caption").to_owned();
        let row = (0..361).find(|row| {
            live.page.value(&format!("(() => {{ const slider = document.getElementById('position'); slider.value = {row}; slider.dispatchEvent(new Event('input')); }})()"));
            let shown = live.page.words("document.querySelector('#readout b').textContent");
            caption.starts_with(&format!("{shown}, "))
        });
        assert!(row.is_some(), "{caption}");
        let of_page = live.file("mechanism.dxf");
        assert_eq!(entities(&of_page), entities(&of_report), "{name}");
        // Codes and values take turns.
        assert_eq!(of_page.lines().count() % 2, 0);
        let (dimension, nominal) = {
            let mut all = live.mechanism.parameters().iter();
            let own = all
                .find(|own| own.unit != "rad" && own.nominal > 0.0)
                .expect("a length");
            (own.name, own.nominal)
        };
        live.page.value(&format!(
            "location.hash = '{dimension}={}'",
            nominal * 1.001
        ));
        live.page
            .wait("document.getElementById('changes').textContent !== ''");
        let said = line(&mut live.page);
        let changed = live.file("mechanism.dxf");
        assert!(
            changed.starts_with(&format!("999\r\n{said}\r\n")),
            "{}",
            &changed[..80]
        );
        assert!(changed.contains(&format!("  1\r\n{said}\r\n")));
        assert_ne!(entities(&changed), entities(&of_page));
        live.page.assert_quiet();
    }
}
