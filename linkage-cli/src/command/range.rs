//! Effects of dimensions of the command line on the declared range: messages of the compiler's
//! kind, with the options under them.

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use linkage_engine::{Assembly, Mechanism};
use linkage_runtime::RangeReport;

use super::terminal::is_coloured;
use super::values::Dimensions;
use crate::failure::Failure;

/// Assembles a mechanism with other dimensions than those of the file, and warns of change points,
/// dead points and gaps in the range. The compiler has checked the dimensions of the file.
pub(super) fn assembled<'m>(
    given: &Dimensions,
    mechanism: &'m Mechanism,
) -> Result<Assembly<'m>, Failure> {
    let assembly = mechanism.assemble(&given.resolve(mechanism)?)?;
    if given.are_given() {
        eprint!(
            "{}",
            rendered(&Level::WARNING, given, &assembly.check_range())
        );
    }
    Ok(assembly)
}

/// All messages of a report, with the options that set the dimensions under each.
pub(super) fn rendered(level: &Level, given: &Dimensions, report: &RangeReport) -> String {
    let renderer = match is_coloured() {
        true => Renderer::styled(),
        false => Renderer::plain(),
    };
    let options = given.options();
    let mut text = match report.unchecked {
        Some(why) => format!("note: {}: {why}\n", report.mechanism),
        None => String::new(),
    };
    for message in report.messages() {
        let title = format!(
            "{}: {}\nhelp: {}",
            report.mechanism, message.fact, message.help
        );
        let snippet = Snippet::source(&options)
            .path("command line")
            .annotation(AnnotationKind::Primary.span(0..options.len()));
        let title = level.clone().primary_title(title);
        text += &renderer.render(&[title.element(snippet)]);
        text += "\n\n";
    }
    text
}
