//! The report of a mechanism.

use linkage_engine::{Assembly, Heading, Mechanism};
use linkage_report::Report;
use linkage_runtime::Programs;

/// The contents of a page besides the mechanism.
#[derive(Debug)]
pub struct PageContents<'a> {
    /// The mechanism with its dimensions.
    pub assembly: &'a Assembly<'a>,
    /// Positions of the first input, in its unit.
    pub positions: &'a [f64],
    /// All arguments of each function, or the reason why they are not known. The first input has any
    /// value.
    pub arguments: Vec<Result<Vec<f64>, String>>,
    /// Programs with which the page computes for other dimensions.
    pub programs: Programs,
    /// The text of the mechanism.
    pub source: Option<String>,
    /// The version of a page that is written again.
    pub version: Option<u64>,
}

/// A report, and the remarks about functions that it does not show.
#[derive(Debug)]
pub struct PageReport {
    /// The report. Its notes contain the remarks.
    pub report: Report,
    /// The remarks, for a terminal.
    pub notes: Vec<String>,
}

/// Returns the number of columns of all functions.
#[must_use]
pub fn columns(mechanism: &Mechanism) -> usize {
    let headings = mechanism.headings().iter();
    headings.map(|heading| heading.columns.len()).sum()
}

/// Reports all functions over the positions of the first input.
///
/// # Panics
///
/// If the mechanism has no input, or not as many functions as the contents have arguments.
#[must_use]
pub fn report(mechanism: &Mechanism, contents: PageContents<'_>) -> PageReport {
    let mut report = basic_report(mechanism, &contents);
    let input = &mechanism.inputs()[0];
    let mut notes = Vec::new();
    let mut drawn = false;
    let mut reactions: Vec<(&str, &str)> = Vec::new();
    let functions = mechanism.headings().iter().zip(contents.arguments);
    for (function, (heading, arguments)) in functions.enumerate() {
        let is_input = |argument: &&str| *argument == input.name;
        let input_index = heading.arguments.iter().position(is_input);
        let arguments = shown_arguments(heading, input_index, arguments, drawn, input.name);
        let (input_index, arguments) = match arguments {
            Ok(known) => known,
            Err(why) => {
                let note = format!("`{}` is not shown: {why}", heading.function);
                report = report.note(note.clone());
                notes.push(note);
                continue;
            }
        };
        drawn |= heading.picture.is_some();
        let mut slices: Vec<&[f64]> = arguments.chunks(1).collect();
        slices[input_index] = contents.positions;
        report = report.table(&contents.assembly.calls(function, &slices));
        reactions.extend(reactions_of(mechanism, function));
        let constant = heading.arguments.iter().zip(&arguments);
        for (&name, &value) in constant.filter(|(name, _)| **name != input.name) {
            report = report.argument(name, value);
        }
    }
    if drawn {
        report = with_forces(report, &reactions);
    }
    PageReport { report, notes }
}

/// The report without its tables.
fn basic_report(mechanism: &Mechanism, contents: &PageContents<'_>) -> Report {
    let input = &mechanism.inputs()[0];
    let assembly = contents.assembly;
    let mut report = Report::new(mechanism.name(), input, contents.positions)
        .about(first_paragraph(&mechanism.compiled().documentation))
        .structure(mechanism.structure())
        .modes(assembly.modes())
        .dimensions_listed(mechanism.parameters(), assembly.dimensions())
        .programs(contents.programs);
    if let Some(version) = contents.version {
        report = report.version(version);
    }
    if let Some(text) = &contents.source {
        report = report.source(text.clone());
    }
    report
}

/// The place of the input among the arguments of a function, and all arguments; or the reason why
/// the function is not shown.
fn shown_arguments(
    heading: &Heading,
    input_index: Option<usize>,
    arguments: Result<Vec<f64>, String>,
    drawn: bool,
    input: &str,
) -> Result<(usize, Vec<f64>), String> {
    if drawn && heading.picture.is_some() {
        return Err("there is one drawing".to_owned());
    }
    match input_index {
        Some(index) => Ok((index, arguments?)),
        None => Err(format!("it does not take `{input}`")),
    }
}

/// The report with forces as arrows. Equal names of two functions are most likely one quantity.
fn with_forces(report: Report, reactions: &[(&str, &str)]) -> Report {
    let distinct = reactions.iter().enumerate().filter(|(index, (_, field))| {
        let mut before = reactions[..*index].iter();
        before.all(|(_, other)| other != field)
    });
    distinct.fold(report, |report, (_, (point, field))| {
        report.force(*point, *field)
    })
}

/// The points at which reactions of a function act, and the fields that they are.
fn reactions_of(mechanism: &Mechanism, function: usize) -> Vec<(&str, &str)> {
    let unit = mechanism.compiled();
    let Some(picture) = &unit.picture else {
        return Vec::new();
    };
    let at = |name: &str| {
        let mut joints = picture.declared_joints.iter();
        let (_, point) = joints.find(|(joint, _)| joint == name)?;
        Some(picture.points[*point].name.as_str())
    };
    let fields = unit.functions[function].fields.iter();
    let fields = fields.filter_map(|field| Some((at(field.reaction.as_ref()?)?, &field.name[..])));
    fields.collect()
}

/// Returns the lines of a text up to the first blank one, as one line.
pub(crate) fn first_paragraph(text: &str) -> String {
    let lines = text.lines().map(str::trim);
    let lines: Vec<&str> = lines.take_while(|line| !line.is_empty()).collect();
    lines.join(" ")
}
