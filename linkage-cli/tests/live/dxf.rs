//! The drawing that a page saves for programs that construct.

use std::fs;
use std::path::Path;

use linkage_browser::REPORT;
use serde_json::Value;

use crate::pages::Live;

/// Moves to the position that is nearest to the reference, as the file beside the page.
const TO_REFERENCE: &str = "(() => { \
     const { input } = PAGE; \
     const away = input.values.map((x) => Math.abs(x - REFERENCE)); \
     const slider = document.getElementById('position'); \
     slider.value = away.indexOf(Math.min(...away)); \
     slider.dispatchEvent(new Event('input')); return 0; })()";

/// The groups of a file: a code and a value each.
fn groups(text: &str) -> Vec<(u16, String)> {
    let lines: Vec<&str> = text.lines().collect();
    let pairs = lines.chunks_exact(2);
    pairs
        .map(|pair| (pair[0].trim().parse().expect("a code"), pair[1].to_owned()))
        .collect()
}

/// Returns true if two values are equal, numbers up to roundoff.
fn are_equal(a: &str, b: &str, size: f64) -> bool {
    match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(a), Ok(b)) => (a - b).abs() <= 1e-12 * size,
        _ => a == b,
    }
}

fn saved(live: &mut Live, file: &str) -> String {
    live.page.value(&format!(
        "document.querySelector('button[data-file=\"{file}\"]').click()"
    ));
    live.page.words(
        "(async () => { while (window.saved.length === 0) await new Promise((done) => setTimeout(done, 5)); \
           return window.saved.pop().text(); })()",
    )
}

/// The `drawing.dxf` beside the page of a mechanism.
fn beside(name: &str) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("dxf_{name}"));
    fs::read_to_string(folder.join("drawing.dxf")).expect("the command writes it")
}

#[test]
fn the_page_saves_the_file_that_is_beside_it() {
    let drawings = "../linkage-compiler/tests/drawings";
    for (file, name) in [
        ("favorit.rs".to_owned(), "favorit"),
        ("mcpherson.rs".to_owned(), "mcpherson"),
        (format!("{drawings}/curved_slot.mech"), "curved_slot"),
        (format!("{drawings}/link_motion.mech"), "link_motion"),
        (
            format!("{drawings}/geared_five_bar.mech"),
            "geared_five_bar",
        ),
        (
            format!("{drawings}/oscillating_cylinder.mech"),
            "oscillating_cylinder",
        ),
        (format!("{drawings}/whitworth.mech"), "whitworth"),
    ] {
        let Some(mut live) = Live::example_as(&file, "dxf") else {
            continue;
        };
        let reference = live.mechanism.inputs()[0].reference;
        live.page.value(
            &TO_REFERENCE
                .replace("PAGE", REPORT)
                .replace("REFERENCE", &format!("{reference:?}")),
        );
        let (page, file) = (
            groups(&saved(&mut live, "mechanism.dxf")),
            groups(&beside(name)),
        );
        let numbers = file
            .iter()
            .filter_map(|(_, value)| value.parse::<f64>().ok());
        let size = numbers.fold(1.0, |size: f64, x| size.max(x.abs()));
        for (number, (a, b)) in page.iter().zip(&file).enumerate() {
            let equal = a.0 == b.0 && are_equal(&a.1, &b.1, size);
            assert!(
                equal,
                "{name}, group {number}: {a:?} on the page, {b:?} in the file"
            );
        }
        assert_eq!(page.len(), file.len(), "{name}");
    }
}

#[test]
fn the_drawing_of_a_changed_design_has_its_dimensions() {
    let Some(mut live) =
        Live::example_as("../linkage-compiler/tests/drawings/four_bar.mech", "dxf")
    else {
        return;
    };
    let mut dimensions = live.mechanism.dimensions();
    let name = live.mechanism.parameters()[0].name;
    let before = dimensions[0];
    dimensions[0] *= 1.04;
    live.set(&dimensions);
    let text = saved(&mut live, "mechanism.dxf");
    let changed = format!("changed: {name} = {} mm ({before})", dimensions[0]);
    assert!(text.contains(&changed), "{changed}");
    let link: Value = live.page.value(
        "JSON.parse(document.getElementById('report').textContent).picture.links.findIndex((link) => link.points.length === 2)",
    );
    assert_eq!(link, 0, "the crank is the first bar");
    let groups = groups(&text);
    let line = groups
        .iter()
        .position(|(code, value)| *code == 0 && value == "LINE");
    let ends: Vec<f64> = groups[line.expect("a bar") + 2..]
        .iter()
        .take(6)
        .map(|(_, value)| value.parse().expect("a number"))
        .collect();
    let length = (ends[3] - ends[0]).hypot(ends[4] - ends[1]);
    assert!((length - dimensions[0]).abs() < 1e-9 * length, "{length}");
}
