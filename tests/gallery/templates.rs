//! The mechanisms that the command writes to start from, compiled by the engine.

use linkage::Programs;
use linkage::report::Report;
use linkage_engine::Mechanism;
use linkage_js::description;
use std::error::Error;

/// The name of a template and its text.
pub(crate) type Template = (&'static str, &'static str);

macro_rules! templates {
    ($($name:literal),* $(,)?) => {
        /// All templates.
        pub(crate) const TEMPLATES: &[Template] = &[
            $(($name, include_str!(concat!("../../linkage-cli/src/templates/", $name, ".mech")))),*
        ];
    };
}

templates![
    "slider",
    "joints",
    "four-bar",
    "wiper",
    "clamp",
    "scissors",
    "leg",
    "quick-return",
    "toggle-press",
    "suspension",
    "boom",
    "pump-jack",
    "steering",
    "gripper",
    "cam",
    "geneva",
];

/// Positions over the range, as the command has them.
const POSITIONS: usize = 361;

/// Returns the report of a template with all functions that need no speed.
pub(crate) fn report(text: &str) -> Result<Report, Box<dyn Error>> {
    let mechanism: &'static Mechanism = Box::leak(Box::new(Mechanism::compile(text)?));
    let assembly = mechanism.assemble(&mechanism.dimensions())?;
    let input = &mechanism.inputs()[0];
    let positions = input.positions(POSITIONS);
    let description = description(mechanism.name(), mechanism.compiled());
    let words = mechanism.compiled().documentation.split_whitespace();
    let words: Vec<&str> = words.collect();
    let mut report = Report::new(mechanism.name(), input, &positions)
        .about(words.join(" "))
        .structure(mechanism.structure())
        .modes(assembly.modes())
        .dimensions_listed(mechanism.parameters(), assembly.dimensions())
        .programs(Programs {
            description: Box::leak(description.into_boxed_str()),
        })
        .source(text);
    for (function, heading) in mechanism.headings().iter().enumerate() {
        let indices = mechanism.compiled().functions[function].arguments.iter();
        let given: Option<Vec<f64>> = indices
            .map(|&argument| mechanism.default_argument(argument))
            .collect();
        let (Some(mut given), Some(index)) = (
            given,
            heading
                .arguments
                .iter()
                .position(|name| *name == input.name),
        ) else {
            continue;
        };
        let mut columns: Vec<&[f64]> = given.chunks(1).collect();
        columns[index] = &positions;
        report = report.table(&assembly.calls(function, &columns));
        drop(columns);
        given.swap_remove(index);
        let names = heading.arguments.iter().enumerate();
        let names = names.filter(|(k, _)| *k != index).map(|(_, name)| *name);
        for (name, value) in names.zip(given) {
            report = report.argument(name, value);
        }
    }
    Ok(report)
}

#[test]
fn no_template_is_left_out() -> Result<(), Box<dyn Error>> {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../linkage-cli/src/templates");
    let files = std::fs::read_dir(folder)?.collect::<Result<Vec<_>, _>>()?;
    let mut names: Vec<String> = files
        .iter()
        .filter_map(|file| Some(file.path().file_stem()?.to_string_lossy().into_owned()))
        .collect();
    names.sort();
    let mut listed: Vec<&str> = TEMPLATES.iter().map(|(name, _)| *name).collect();
    listed.sort_unstable();
    assert_eq!(names, listed);
    Ok(())
}
