//! Words inside the macro in rust-analyzer: hovers, definitions, renaming, completions.

use linkage_analyzer::{Analyzer, Project, is_there};

/// A drive with joints and links.
const JOINTS: &str = "linkage::mechanism! {
    struct Crank {
        unit mm;
        param radius = 12mm;
        input phi = 0deg;
        let tip = polar(radius, phi);
    }
    pub struct FourBar {
        unit mm;
        input phi = 60deg in 0deg..360deg;
        joint a = (0mm, 0mm), d = (140mm, 0mm);
        joint b = (25mm, 43.3mm), c = (115mm, 96.8mm);
        link frame: a, d;
        link crank: a, b at phi;
        link coupler: b, c;
        link rocker: c, d;
        part wheel: Crank { phi = 2 * phi };
        let span = distance(b, wheel.tip);
        let half = coupler.length / 2;
    }
    impl FourBar {
        pub fn motion(phi) -> Motion { c, span, half }
    }
}

pub fn position() -> f64 {
    let motion = FourBar::default().assemble().map(|bar| bar.motion(1.0));
    motion.map_or(f64::NAN, |motion| motion.span)
}
";

/// A slider-crank and its use.
const SLIDER: &str = "linkage::mechanism! {
    pub struct SliderCrank {
        unit mm;
        /// Length of the crank.
        param crank = 40mm +- 10um;
        param rod = 120mm;
        input phi = 30deg in 0deg..360deg;
        unknown theta = -10deg;
        unknown s = 150mm;
        let pin = polar(crank, phi);
        loop pin + polar(rod, theta) = (s, 5mm);
    }
    impl SliderCrank {
        /// Place of the slider.
        pub fn stroke(phi) -> Stroke { s, v: velocity(s), tilt: theta }
    }
}

pub fn place() -> f64 {
    let bar = SliderCrank { crank: 41.0, ..SliderCrank::default() };
    bar.assemble().map_or(f64::NAN, |bar| bar.stroke(1.0).s)
}
";

/// Names that are words of clauses, too.
const WORDS: &str = "linkage::mechanism! {
    pub struct Press {
        unit mm;
        param mass = 2kg;
        input at = 0deg in 0deg..360deg;
        unknown turns = 10deg;
        let point = (10.5mm, 0mm);
        let pin = (0mm, 0mm);
        gravity = (0, -9.8m/s^2);
        loop turns = at;
        body arm = pin on frame at point, turns turns, mass mass at point;
    }
    impl Press {
        pub fn motion(at) -> Motion { turns, point, pin }
    }
}

pub fn index() -> usize {
    Press::INDEX_MASS
}
";

const MODULES: [(&str, &str); 6] = [
    ("words", WORDS),
    ("slider", SLIDER),
    ("joints", JOINTS),
    (
        "mcpherson",
        include_str!("../../../mechanisms/mcpherson.rs"),
    ),
    (
        "crank_rocker",
        include_str!("../../../mechanisms/crank_rocker.rs"),
    ),
    (
        "geared",
        include_str!("../../../mechanisms/geared_five_bar.rs"),
    ),
];

/// The offset of a word in a text that has it once.
#[track_caller]
fn at(text: &str, context: &str, word: &str) -> usize {
    assert_eq!(text.matches(context).count(), 1, "{context}");
    text.find(context).expect("it is there") + context.find(word).expect("it is in the context")
}

/// One program and one server for all questions: it takes seconds to start.
#[test]
fn names_are_known_inside_the_macro() {
    if !is_there() {
        return;
    }
    let project = Project::new(&MODULES);
    let mut analyzer = Analyzer::new(project.folder());
    words_have_meanings_and_definitions(&project, &mut analyzer);
    parts_and_links_lead_to_their_words(&project, &mut analyzer);
    words_of_the_language_are_no_names(&project, &mut analyzer);
    words_are_offered_where_nothing_is_written(&project, &mut analyzer);
    completions_are_names_of_the_mechanism(&project, &mut analyzer);
    generated_methods_are_offered_and_private_ones_are_not(&project, &mut analyzer);
    a_name_is_renamed_everywhere(&project, &mut analyzer);
}

fn opened(project: &Project, analyzer: &mut Analyzer, module: &str) -> &'static str {
    analyzer.open(&project.file(module));
    let mut modules = MODULES.iter();
    modules
        .find(|(name, _)| *name == module)
        .expect("a module")
        .1
}

fn words_have_meanings_and_definitions(project: &Project, analyzer: &mut Analyzer) {
    let text = opened(project, analyzer, "slider");
    let mut hover = |context, word| analyzer.hover(at(text, context, word));
    for piece in [
        "pub crank: T",
        "Length of the crank.",
        "In mm; default 40, tolerance 0.01.",
    ] {
        let shown = hover("polar(crank", "crank");
        assert!(shown.contains(piece), "{shown}");
    }
    let shown = hover("polar(rod, theta)", "theta");
    for piece in ["theta: f64", "`unknown theta = -10deg`", "an angle"] {
        assert!(shown.contains(piece), "{shown}");
    }
    let shown = hover("loop pin", "pin");
    for piece in [
        "pin: [f64; 2]",
        "`let pin = polar(crank, phi)`",
        "a plane vector of lengths",
    ] {
        assert!(shown.contains(piece), "{shown}");
    }
    let shown = hover("loop pin", "loop");
    let of_language = shown.find("An equation that the links close");
    // The server shows its meaning in Rust, too.
    assert!(
        of_language.is_some() && of_language < shown.find("Loop indefinitely"),
        "{shown}"
    );
    let shown = hover("pin + polar", "polar");
    assert!(shown.contains("The plane vector of a length"), "{shown}");
    let shown = hover("velocity(s)", "velocity");
    assert!(
        shown.contains("The derivative with respect to the input"),
        "{shown}"
    );
    let mut lines = |context, word| -> Vec<u64> {
        let found = analyzer.definitions(at(text, context, word));
        found.into_iter().map(|location| location.line).collect()
    };
    assert_eq!(lines("polar(crank", "crank"), [5]);
    assert_eq!(lines("polar(rod, theta)", "theta"), [8]);
    assert_eq!(lines("tilt: theta", "theta"), [8]);
    assert_eq!(lines("fn stroke(phi)", "phi"), [15, 7]);
    // From generated items to the words that made them.
    assert_eq!(lines("bar.stroke(1.0)", "stroke"), [15]);
    assert_eq!(lines("(1.0).s", "s"), [15]);
    assert_eq!(lines("crank: 41.0", "crank"), [5]);
    assert_eq!(lines("= SliderCrank {", "SliderCrank"), [2]);
}

fn parts_and_links_lead_to_their_words(project: &Project, analyzer: &mut Analyzer) {
    let text = opened(project, analyzer, "joints");
    let mut lines = |context, word| -> Vec<u64> {
        let found = analyzer.definitions(at(text, context, word));
        found.into_iter().map(|location| location.line).collect()
    };
    // With the field of the result that it is.
    assert_eq!(lines("link rocker: c, d", "c,"), [12, 22]);
    assert_eq!(lines("link rocker: c, d", "d"), [11]);
    assert_eq!(lines("distance(b, wheel.tip)", "wheel"), [17]);
    assert_eq!(lines("distance(b, wheel.tip)", "tip"), [6]);
    assert_eq!(lines("coupler.length", "coupler"), [15]);
    assert_eq!(lines("Crank { phi = 2", "phi"), [5]);
    let shown = analyzer.hover(at(text, "coupler.length", "length"));
    assert!(shown.contains("`param coupler.length = "), "{shown}");
}

fn words_of_the_language_are_no_names(project: &Project, analyzer: &mut Analyzer) {
    let text = opened(project, analyzer, "words");
    for (context, word, meaning) in [
        (
            "arm = pin on",
            "pin",
            "A joint about which two bodies turn.",
        ),
        ("on frame", "frame", "The link that does not move."),
        ("frame at", "at", "The point, direction or position of it"),
        (
            "0deg in",
            "in",
            "The range in which the mechanism must work",
        ),
        ("unit mm", "mm", "millimetre"),
        ("2kg", "kg", "kilogram"),
        ("10.5mm", "mm", "millimetre"),
        ("m/s^2", "s^", "second"),
    ] {
        let shown = analyzer.hover(at(text, context, word));
        assert!(shown.contains(meaning), "{context}: {shown}");
    }
    for (context, word) in [("arm = pin on", "pin"), ("on frame", "frame")] {
        let renamed = analyzer.renamed(at(text, context, word), "other_name");
        assert!(renamed.is_err(), "{renamed:?}");
    }
    // The point of that name is another one.
    let renamed = analyzer.renamed(at(text, "let pin", "pin"), "pivot");
    let renamed = renamed.expect("a name");
    assert!(
        renamed.contains("let pivot =") && renamed.contains("arm = pin on"),
        "{renamed}"
    );
    let index = analyzer.definitions(at(text, "INDEX_MASS", "INDEX"));
    assert_eq!(index.len(), 1);
    assert_eq!((index[0].line, index[0].word.as_str()), (4, "mass"));
    let text = opened(project, analyzer, "joints");
    let renamed = analyzer.renamed(at(text, "link frame", "frame"), "other_name");
    assert!(renamed.is_err(), "{renamed:?}");
    let shown = analyzer.hover(at(text, "b at phi", "at"));
    assert!(
        shown.contains("The direction from the first joint"),
        "{shown}"
    );
}

fn words_are_offered_where_nothing_is_written(project: &Project, analyzer: &mut Analyzer) {
    let text = opened(project, analyzer, "slider");
    for (piece, new, before, offered, missing) in [
        // Items, at the beginning and at the end of the block.
        ("    param rod", "\n    param rod", "", "unknown", "theta"),
        (
            "(s, 5mm);",
            "(s, 5mm);\n        ",
            "(s, 5mm);\n        ",
            "unknown",
            "theta",
        ),
        ("(s, 5mm);", "(s, 5mm); li", "; li", "link", "theta"),
        // Names.
        (
            "loop pin + polar",
            "loop pin +  + polar",
            "loop pin + ",
            "theta",
            "param",
        ),
        (
            "polar(rod, theta)",
            "polar(rod, )",
            "(rod, ",
            "theta",
            "param",
        ),
        (
            "tilt: theta }",
            "tilt: theta,  }",
            "tilt: theta, ",
            "velocity",
            "param",
        ),
        // Words within items.
        ("30deg in", "30deg i", "30deg i", "at", "theta"),
        ("= -10deg;", "= -10deg ;", "= -10deg ", "redundant", "theta"),
        ("unit mm", "unit m", "unit m", "cm", "theta"),
    ] {
        let changed = text.replace(piece, new);
        analyzer.change(&changed);
        let found = analyzer.completions(at(&changed, new, before) + before.len());
        let has = |name: &str| found.iter().any(|label| label == name);
        assert!(has(offered) && !has(missing), "{new}: {found:?}");
        // They would be written as raw identifiers.
        assert!(
            !has("let") && !has("loop") && !has("in"),
            "{new}: {found:?}"
        );
    }
}

fn completions_are_names_of_the_mechanism(project: &Project, analyzer: &mut Analyzer) {
    let text = opened(project, analyzer, "slider");
    let names = [
        "crank", "rod", "phi", "theta", "s", "pin", "polar", "velocity",
    ];
    let item = "loop pin + polar(rod, theta) = (s, 5mm);";
    for (half, cursor) in [
        ("loop pin + polar(rod, th) = (s, 5mm);", "th"),
        ("loop pin + polar(rod, t", "(rod, t"),
        ("loop pi", "loop pi"),
        ("loop pin + polar(rod, theta) = (s, o);", "= (s, o"),
    ] {
        let changed = text.replace(item, half);
        analyzer.change(&changed);
        let offset = at(&changed, half, cursor) + cursor.len();
        let found = analyzer.completions(offset);
        for name in names {
            assert!(found.iter().any(|label| label == name), "{half}: {found:?}");
        }
        // Nothing of Rust, except for two methods of all types.
        let of_rust = found
            .iter()
            .filter(|label| label.contains(" as ") || label.contains("(as"));
        assert!(of_rust.count() <= 2, "{half}: {found:?}");
        let shown = analyzer.hover(at(&changed, "unknown theta", "theta"));
        assert!(shown.contains("theta: f64"), "{half}: {shown}");
    }
}

fn generated_methods_are_offered_and_private_ones_are_not(
    project: &Project,
    analyzer: &mut Analyzer,
) {
    let text = opened(project, analyzer, "slider");
    let line = "let bar = SliderCrank::default();\n    bar.";
    let changed = text.replace(
        "let bar = SliderCrank {",
        &format!("{line}\n    let bar = SliderCrank {{"),
    );
    analyzer.change(&changed);
    let found = analyzer.completions(at(&changed, line, line) + line.len());
    assert!(
        found.iter().any(|label| label.starts_with("assemble")),
        "{found:?}"
    );
    assert!(
        found.iter().all(|label| !label.starts_with("__")),
        "{found:?}"
    );
    // In another module.
    let text = opened(project, analyzer, "joints");
    let path = "let motion = crate::slider::;";
    let changed = text.replace(
        "let motion = FourBar",
        &format!("{path} let motion = FourBar"),
    );
    analyzer.change(&changed);
    let found = analyzer.completions(at(&changed, path, ";"));
    assert!(
        found.iter().any(|label| label == "SliderCrank"),
        "{found:?}"
    );
    assert!(
        found.iter().all(|label| !label.starts_with("__")),
        "{found:?}"
    );
}

/// The mechanisms of a file as their tokens.
fn mechanisms(text: &str) -> proc_macro2::TokenStream {
    let file: proc_macro2::TokenStream = text.parse().expect("brackets have partners");
    let mut tokens = file.into_iter().skip_while(
        |token| !matches!(token, proc_macro2::TokenTree::Ident(word) if word == "mechanism"),
    );
    match tokens.nth(2) {
        Some(proc_macro2::TokenTree::Group(group)) => group.stream(),
        other => panic!("the braces of a macro: {other:?}"),
    }
}

/// The words of a text that may be names, with the offset of each.
fn words(text: &str) -> Vec<(usize, &str)> {
    let mut start = None;
    let mut found = Vec::new();
    for (offset, letter) in text.char_indices() {
        let is_part = letter.is_alphanumeric() || letter == '_';
        match (start, is_part) {
            (None, true) => start = Some(offset),
            (Some(first), false) => {
                found.push((first, &text[first..offset]));
                start = None;
            }
            (None, false) | (Some(_), true) => {}
        }
    }
    found
}

fn a_name_is_renamed_everywhere(project: &Project, analyzer: &mut Analyzer) {
    let mut renamed = 0;
    for (module, _) in MODULES {
        let text = opened(project, analyzer, module);
        assert!(is_sound(text), "{module}");
        for (offset, name) in declared(text) {
            // At the declaration and at the last use.
            let last = words(text)
                .into_iter()
                .rev()
                .find(|(_, word)| *word == name);
            for offset in [Some(offset), last.map(|(offset, _)| offset)]
                .into_iter()
                .flatten()
            {
                let Ok(changed) = analyzer.renamed(offset, "other_name") else {
                    continue;
                };
                assert!(
                    is_sound(&changed),
                    "{module}: `{name}` at {offset}\n{changed}"
                );
                renamed += 1;
            }
        }
    }
    assert!(renamed > 60, "{renamed}");
}

/// The names after the words of items, each with its offset.
fn declared(text: &str) -> Vec<(usize, &str)> {
    let all = words(text);
    let items = [
        "struct", "fn", "param", "input", "unknown", "let", "argument", "part", "body", "joint",
        "link",
    ];
    let pairs = all.windows(2).filter(|pair| {
        items.contains(&pair[0].1) && text[pair[0].0 + pair[0].1.len()..pair[1].0] == *" "
    });
    let end = text.find("\n}\n").expect("the macro ends");
    pairs
        .map(|pair| pair[1])
        .filter(|(offset, _)| *offset < end)
        .collect()
}

/// True if the names of all mechanisms are known.
fn is_sound(text: &str) -> bool {
    let mechanisms = linkage_compiler::Driver::resolve(mechanisms(text));
    mechanisms.iter().all(|(_, model)| model.is_some())
}
