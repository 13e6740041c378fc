//! Changes that are offered: each is made, and the text has the mistake no more.

use linkage_editor::{Document, Fix};

use crate::{after, template, text};

/// Makes a change.
fn changed(document: &mut Document, fix: &Fix) {
    let mut edits = fix.edits.clone();
    edits.sort_by_key(|edit| std::cmp::Reverse(edit.range.start));
    let text = document.text().to_owned();
    let new = edits.into_iter().fold(text, |text, edit| {
        Document::edit(&text, edit.range, &edit.text)
    });
    document.set_text(&new);
}

/// The change whose title begins so, at the end of a piece of the text.
fn offered(document: &Document, piece: &str, title: &str) -> Fix {
    let place = after(document, piece);
    let all = document.actions(place..place);
    let found = all
        .iter()
        .find(|action| action.fix.title.starts_with(title));
    found.unwrap_or_else(|| panic!("{all:?}")).fix.clone()
}

/// A template with another text in the place of a piece.
fn edited(name: &str, piece: &str, new: &str) -> Document {
    let old = text(name);
    assert!(old.contains(piece), "{piece}");
    Document::new(name, &old.replacen(piece, new, 1))
}

/// Makes an offered change, after which there is no message.
fn mended(mut document: Document, piece: &str, title: &str) -> String {
    assert!(!document.diagnostics().is_empty(), "a mistake");
    let fix = offered(&document, piece, title);
    changed(&mut document, &fix);
    assert_eq!(document.diagnostics(), [], "{}", document.text());
    document.text().to_owned()
}

#[test]
fn a_range_that_works() {
    let rocking = "struct Rocking { unit mm; input phi = 50deg in 0deg..360deg;
        unknown theta = 10deg; unknown psi = 60deg;
        loop polar(90mm, phi) + polar(30mm, theta) = (100mm, 0) + polar(90mm, psi); }
        impl Rocking { pub fn f(phi) -> F { psi } }";
    let text = mended(
        Document::new("rocking.mech", rocking),
        "in 0deg",
        "write `in 36.",
    );
    assert!(text.contains("input phi = 50deg in 36."), "{text}");
}

#[test]
fn ranges_that_work_for_several_inputs() {
    let boom = edited("boom", "in 900mm..1250mm", "in 900mm..2500mm");
    mended(boom, "in 900mm", "write `in ");
}

#[test]
fn units() {
    let slider = edited("slider", "input phi = 30deg", "input phi = 30");
    mended(slider, "input phi = 30", "write `30deg`");
    let slider = edited("slider", "param rod    = 120mm +- 20um", "param rod = 120");
    mended(slider, "param rod = 120", "write `120mm`");
}

/// A slider-crank with a coordinate in the place of `OFFSET`.
const SLIDER: &str = "struct Slider {
    unit mm;
    /// The crank's angle.
    input phi = 30deg in 0deg..360deg;
    unknown theta = -10deg;
    unknown s = 150mm;
    loop polar(40mm, phi) + polar(120mm, theta) = (s, OFFSET);
}
impl Slider { pub fn stroke(phi) -> Stroke { s } }
";

/// A four-bar by its joints and links.
const FOUR_BAR: &str = "pub struct FourBar {
    unit mm;
    input phi = 60deg in 0deg..360deg;
    joint a = (0mm, 0mm), d = (140mm, 0mm);
    joint b = (25mm, 43.30127mm), c = (115mm, 96.8mm);
    link frame: a, d;
    /// It turns about `a`.
    link crank: a, b at phi;
    link coupler: b, c;
    link rocker: d, c;
}
impl FourBar { pub fn f(phi) -> F { c } }
";

/// A document of a text with another text in the place of a piece.
fn replaced(text: &str, piece: &str, new: &str) -> Document {
    assert!(text.contains(piece), "{piece}");
    Document::new("replaced.mech", &text.replacen(piece, new, 1))
}

#[test]
fn a_coordinate_gets_its_unit() {
    for (written, caret, number) in [("5", "(s, 5", "5mm"), ("3mm - 2.5", "3mm - 2.5", "2.5mm")] {
        let slider = replaced(SLIDER, "OFFSET", written);
        let text = mended(slider, caret, &format!("write `{number}`"));
        let offset = written.replace(number.trim_end_matches("mm"), number);
        assert!(text.contains(&format!("= (s, {offset});")), "{text}");
    }
}

#[test]
fn a_missing_semicolon() {
    let slider = SLIDER.replace("OFFSET", "5mm");
    let slider = replaced(&slider, "in 0deg..360deg;", "in 0deg..360deg // the crank");
    let text = mended(slider, "in 0deg..360deg", "write `;`");
    assert!(text.contains("in 0deg..360deg; // the crank"), "{text}");
}

/// The new item is before the first link and its comment.
#[test]
fn a_missing_frame() {
    let bar = replaced(FOUR_BAR, "    link frame: a, d;\n", "");
    let text = mended(bar, "pub struct Fou", "add `link frame: a, d;`");
    assert_eq!(text, FOUR_BAR);
}

#[test]
fn a_forgotten_input_of_a_driven_link() {
    let line = "input phi = 60deg in 0deg..360deg";
    let bar = replaced(FOUR_BAR, &format!("    {line};\n"), "");
    let text = mended(bar, "at phi", &format!("declare `{line}`"));
    let lines = format!("    {line};\n    /// It turns about `a`.\n    link crank");
    assert!(text.contains(&lines), "{text}");
}

#[test]
fn a_forgotten_input_of_a_loop() {
    let slider = SLIDER.replace("OFFSET", "5mm");
    let line = "input phi = 30deg in 0deg..360deg;";
    let without = replaced(&slider, line, "");
    let text = mended(
        without,
        "mm, phi",
        "declare `input phi = 0deg in 0deg..360deg`",
    );
    assert!(
        text.contains("    input phi = 0deg in 0deg..360deg;\n    loop"),
        "{text}"
    );
    // The other inputs of a mechanism are known: another name is a value.
    let with_input = replaced(&slider, "mm, phi", "mm, psi");
    let caret = after(&with_input, "mm, psi");
    let mut offered = with_input.actions(caret..caret).into_iter();
    assert!(offered.all(|action| !action.fix.title.contains("input")));
}

#[test]
fn words_of_a_function_that_are_meant() {
    let slider = SLIDER.replace("OFFSET", "5mm");
    let input = replaced(&slider, "stroke(phi)", "stroke(ph)");
    let caret = after(&input, "stroke(ph");
    let titles = input.actions(caret..caret).into_iter();
    let titles: Vec<String> = titles.map(|action| action.fix.title).collect();
    assert!(
        titles.iter().all(|title| !title.starts_with("declare")),
        "{titles:?}"
    );
    mended(input, "stroke(ph", "write `phi`");
    let block = replaced(&slider, "impl Slider", "impl Slyder");
    let caret = after(&block, "impl Slyder");
    assert_eq!(block.actions(caret..caret).len(), 1);
    mended(block, "impl Slyder", "write `Slider`");
}

#[test]
fn marks_that_are_meant() {
    let slider = SLIDER.replace("OFFSET", "5mm");
    mended(
        replaced(&slider, "theta = -10deg", "theta == -10deg"),
        "theta ==",
        "write `=`",
    );
    let comma = replaced(&slider, "unknown s = 150mm", "unknown s = 150,5mm");
    let text = mended(comma, "s = 150,", "write `150.5mm`");
    assert!(text.contains("unknown s = 150.5mm;"), "{text}");
}

#[test]
fn functions_that_are_meant() {
    let quantity = edited("slider", "velocity(slide)", "velocty(slide)");
    mended(quantity, "velocty", "write `velocity`");
    let function = edited("slider", "polar(crank", "ploar(crank");
    mended(function, "ploar", "write `polar`");
}

#[test]
fn signs_of_formulas() {
    let slider = edited("slider", "input phi = 30deg", "input phi = 30°");
    mended(slider, "input phi = 30", "write `deg`");
    let slider = edited("slider", "120mm +- 20um", "120mm ± 20um");
    mended(slider, "120mm ", "write `+-`");
}

#[test]
fn slips_in_numbers() {
    let slider = edited("slider", "120mm +- 20um", "120mmm +- 20um");
    mended(slider, "120m", "write `120mm`");
    let slider = edited("slider", "120mm +- 20um", "120,5mm +- 20um");
    mended(slider, "120,", "write `120.5mm`");
}

#[test]
fn a_tolerance_gets_its_unit() {
    let slider = edited("slider", "120mm +- 20um", "120mm +- 0.02");
    let text = mended(slider, "+- 0.02", "write `0.02mm`");
    assert!(text.contains("120mm +- 0.02mm"), "{text}");
}

#[test]
fn names_that_are_meant() {
    let slider = edited("slider", "polar(crank, phi)", "polar(cank, phi)");
    mended(slider, "polar(cank", "write `crank`");
}

#[test]
fn computed_estimates() {
    let mut slider = template("slider");
    let hints = slider.hints();
    assert!(hints.iter().any(|hint| hint.is_solution), "{hints:?}");
    let fix = offered(&slider, "unknown slide", "take all computed estimates");
    assert_eq!(fix.edits.len(), 2);
    changed(&mut slider, &fix);
    assert_eq!(slider.diagnostics(), []);
    let hints = slider.hints();
    assert!(hints.iter().all(|hint| !hint.is_solution), "{hints:?}");
}

#[test]
fn an_estimate_of_another_assembly() {
    let slider = edited("slider", "unknown slide = 150mm", "unknown slide = 15mm");
    let text = mended(slider, "unknown slide = 15mm", "take the estimate");
    assert!(text.contains("unknown slide = 153."), "{text}");
}

#[test]
fn unknown_words_are_declared() {
    let slider = edited("slider", "    unknown theta = -10deg;", "");
    let text = mended(slider, "polar(rod, theta", "declare `unknown theta = 0deg`");
    assert!(
        text.contains("\n    unknown theta = 0deg;\n    loop pin"),
        "{text}"
    );
}

#[test]
fn words_that_can_be_no_value_are_not_declared() {
    for (name, piece, new) in [
        ("slider", "let pin = polar(", "let pin = plr("),
        ("slider", "let pin", "lett"),
        ("slider", "polar(crank", "polar(cank"),
        ("joints", "link rod: k", "link rod: kkk"),
    ] {
        let document = edited(name, piece, new);
        assert!(!document.diagnostics().is_empty(), "{new}");
        let place = after(&document, new.trim_end_matches('('));
        let all = document.actions(place..place);
        let mut titles = all.iter().map(|action| &action.fix.title);
        assert!(
            titles.all(|title| !title.starts_with("declare")),
            "{new}: {all:?}"
        );
    }
}

#[test]
fn a_picture_is_added_once() {
    let drawn = "    /// The links, for the drawing.\n    pub fn shape(phi) -> Shape { shape: picture() }\n";
    let mut slider = edited("slider", drawn, "");
    let fix = offered(&slider, "unit mm", "add a function with `picture()`");
    changed(&mut slider, &fix);
    assert_eq!(slider.diagnostics(), []);
    let place = after(&slider, "unit mm");
    let again = slider.actions(place..place);
    assert!(
        again
            .iter()
            .all(|action| !action.fix.title.contains("picture")),
        "{again:?}"
    );

    let mut crank = Document::new(
        "a",
        "struct Crank { unit mm; param r = 3mm; input phi = 0deg; let p = polar(r, phi); }",
    );
    let fix = offered(&crank, "unit mm", "add a function with `picture()`");
    changed(&mut crank, &fix);
    assert!(crank.text().contains("impl Crank {"), "{}", crank.text());
}

#[test]
fn the_direction_of_a_driven_link_that_is_drawn() {
    let text = mended(
        edited("joints", "input phi = 60deg", "input phi = 75deg"),
        "link crank",
        "write `",
    );
    assert!(text.contains("input phi = 59.999"), "{text}");
}

/// A loop without an unknown takes a link of unknown angle and length.
#[test]
fn a_loop_gets_its_missing_term() {
    let text = "pub struct Closed {
    unit mm;
    param a = (0mm, 0mm);
    param b = (30mm, 40mm);
    input phi = 30deg in 0deg..360deg;
    loop a = b;
}
impl Closed { pub fn f(phi) -> F { x: polar(10mm, phi) } }
";
    let mut document = Document::new("closed.mech", text);
    let fix = offered(
        &document,
        "loop a",
        "add a link with unknown angle and length",
    );
    let is_open = |document: &Document| {
        let mut all = document.diagnostics().iter();
        all.any(|diagnostic| diagnostic.message.contains("contains no unknown"))
    };
    assert!(is_open(&document));
    changed(&mut document, &fix);
    assert!(!is_open(&document), "{}", document.text());
    let lines =
        "unknown theta = 0deg;\n    unknown length = 10mm;\n    loop a = b + polar(length, theta);";
    assert!(document.text().contains(lines), "{}", document.text());
}

/// One change gives all coordinates their unit.
#[test]
fn coordinates_get_their_unit() {
    let text = "pub struct Drawn {
    unit mm;
    input phi = 60deg in 0deg..360deg;
    joint a = (0, 0), d = (140, 0);
    joint b = (25, 43.30127), c = (115, 96.8);
    link frame: a, d;
    link crank: a, b at phi;
    link coupler: b, c;
    link rocker: d, c;
}
impl Drawn { pub fn f(phi) -> F { c } }
";
    let mended = mended(
        Document::new("drawn.mech", text),
        "(0, 0), d",
        "write `mm` after each number",
    );
    assert!(
        mended.contains("joint b = (25mm, 43.30127mm), c = (115mm, 96.8mm);"),
        "{mended}"
    );
}
