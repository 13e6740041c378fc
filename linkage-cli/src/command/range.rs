//! Effects of dimensions of the command line on the declared range: messages of the compiler's
//! kind, with the options under them.

use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};
use linkage_compiler::{length_as_written, shortened};
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
    warn_of_negative_lengths(given, mechanism)?;
    let assembly = mechanism.assemble(&given.resolve(mechanism)?)?;
    if given.are_given() {
        eprint!(
            "{}",
            rendered(&Level::WARNING, given, &assembly.check_range())
        );
    }
    Ok(assembly)
}

/// Warns of given lengths of links that are negative.
pub(super) fn warn_of_negative_lengths(
    given: &Dimensions,
    mechanism: &Mechanism,
) -> Result<(), Failure> {
    let values = given.resolve(mechanism)?;
    let parameters = mechanism.compiled().parameters.iter();
    let scalars = parameters.flat_map(|parameter| {
        let scalars = parameter.scalars.iter();
        scalars.map(|scalar| (scalar, parameter.is_link_length))
    });
    for ((scalar, is_link_length), value) in scalars.zip(values) {
        // The compiler has warned of the values of the file.
        if is_link_length && value < 0.0 && value != scalar.nominal {
            let (value, unit) = length_as_written(value, &scalar.unit);
            let fact = format!(
                "`{} = {value}{unit}` is negative, but it is the length of a link",
                shortened(&scalar.name)
            );
            let title = format!(
                "{}: {fact}\nhelp: write a positive length",
                mechanism.name()
            );
            eprint!("{}", titled(&Level::WARNING, &title, &given.options()));
        }
    }
    Ok(())
}

/// All messages of a report, with the options that set the dimensions under each.
pub(super) fn rendered(level: &Level, given: &Dimensions, report: &RangeReport) -> String {
    let mut text = match report.unchecked {
        Some(why) => format!("note: {}: {why}\n", report.mechanism),
        None => String::new(),
    };
    for message in report.messages() {
        let title = format!(
            "{}: {}\nhelp: {}",
            report.mechanism, message.fact, message.help
        );
        text += &titled(level, &title, &given.options());
    }
    text
}

/// A message with the options that it is about, and a blank line.
fn titled(level: &Level, title: &str, options: &str) -> String {
    let renderer = match is_coloured() {
        true => Renderer::styled(),
        false => Renderer::plain(),
    };
    let snippet = Snippet::source(options)
        .path("command line")
        .annotation(AnnotationKind::Primary.span(0..options.len()));
    let title = level.clone().primary_title(title);
    renderer.render(&[title.element(snippet)]) + "\n\n"
}
