//! The report of a mechanism.

use std::path::Path;

use linkage_engine::Mechanism;
use linkage_js::description;
use linkage_report::Report;
use linkage_runtime::Programs;

use crate::command::arguments_given::among;
use crate::command::declaration::declaration;
use crate::command::range;
use crate::command::sweep::{arguments, positions};
use crate::command::values::Dimensions;
use crate::failure::Failure;

/// Bytes for each number, about: the number, and its texts in the page and in all files.
const BYTES: usize = 100;

/// Options of a report.
pub(super) struct ReportOptions<'a> {
    /// The file with the mechanisms.
    pub(super) file: &'a Path,
    /// Dimensions other than those of the file, of all its mechanisms.
    pub(super) dimensions: &'a Dimensions,
    /// Arguments, as `omega=20rad/s`, of all mechanisms.
    pub(super) at: &'a [String],
    /// The number of positions.
    pub(super) steps: u32,
    /// The version of a page that is written again.
    pub(super) version: Option<u64>,
}

/// All functions over the range of the first input.
pub(super) fn report(
    options: &ReportOptions<'_>,
    mechanism: &Mechanism,
) -> Result<Report, Failure> {
    let input = &mechanism.inputs()[0];
    let dimensions = options.dimensions.known_to(mechanism);
    let assembly = range::assembled(&dimensions, mechanism)?;
    let positions = positions(mechanism, input, [None; 2], options.steps)?;
    let columns = mechanism
        .headings()
        .iter()
        .map(|heading| heading.columns.len());
    let positions = positions.held(columns.sum(), BYTES)?;
    let description = description(mechanism.name(), mechanism.compiled());
    let mut report = Report::new(mechanism.name(), input, &positions)
        .about(first_paragraph(&mechanism.compiled().documentation))
        .structure(mechanism.structure())
        .modes(assembly.modes())
        .dimensions_listed(mechanism.parameters(), assembly.dimensions())
        .programs(Programs {
            description: Box::leak(description.into_boxed_str()),
        });
    if let Some(version) = options.version {
        report = report.version(version);
    }
    if let Some(text) = declaration(options.file, mechanism.name()) {
        report = report.source(text);
    }
    let mut drawn = false;
    let mut reactions: Vec<(&str, &str)> = Vec::new();
    for (function, heading) in mechanism.headings().iter().enumerate() {
        let again = drawn && heading.picture.is_some();
        let argument_index = heading
            .arguments
            .iter()
            .position(|argument| *argument == input.name);
        // The input may be a constant argument in another mechanism of the file.
        let names = heading.arguments.iter().copied();
        let constant: Vec<&str> = names.filter(|name| *name != input.name).collect();
        let arguments_given = arguments(mechanism, function, &among(&constant, options.at))?;
        let why = match (again, argument_index, arguments_given.complete()) {
            (false, Some(argument_index), Ok(arguments_given)) => {
                drawn |= heading.picture.is_some();
                let mut slices: Vec<&[f64]> = arguments_given.chunks(1).collect();
                slices[argument_index] = &positions;
                report = report.table(&assembly.calls(function, &slices));
                reactions.extend(reactions_of(mechanism, function));
                let beside = heading.arguments.iter().zip(&arguments_given);
                for (&name, &value) in beside.filter(|(name, _)| **name != input.name) {
                    report = report.argument(name, value);
                }
                continue;
            }
            (true, ..) => "there is one drawing".to_owned(),
            (_, None, _) => format!("it does not take `{}`", input.name),
            (.., Err(why)) => why,
        };
        let note = format!("`{}` is not shown: {why}", heading.function);
        eprintln!("note: {}: {note}", mechanism.name());
        report = report.note(note);
    }
    if drawn {
        // Equal names of two functions are most likely one quantity.
        for (index, (point, field)) in reactions.iter().enumerate() {
            let is_first = reactions[..index].iter().all(|(_, other)| other != field);
            if is_first {
                report = report.force(*point, *field);
            }
        }
    }
    Ok(report)
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

fn first_paragraph(text: &str) -> String {
    let lines = text.lines().map(str::trim);
    let lines: Vec<&str> = lines.take_while(|line| !line.is_empty()).collect();
    lines.join(" ")
}
