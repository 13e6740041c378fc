//! Readers of the files of other programs for linkages.
//!
//! [`import`] turns a file, or the address of a page, into a commented text in the language of
//! linkage. Each length has a comment with the band in which the rounding of the file leaves it.
//! Everything that could not be taken is a comment of the text and a warning.

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod page {}

mod choose;
mod csv_lines;
mod document;
mod drawn;
mod driven_motions;
mod error;
mod format;
mod hard_points;
mod imported;
mod joint_table;
mod linkage2;
mod mobility;
mod names;
mod number;
mod options;
mod placement;
mod pmks;
mod pylinkage;
mod pyslvs;
mod robots;
mod tidy;
mod wrapped;
mod writer;
mod xml;

use document::Document;

pub use drawn::{Drawn, DrawnPoint, Drive, Measure};
pub use error::ImportError;
pub use format::Format;
pub use imported::Import;
pub use options::Options;

/// Returns the mechanism of a file as text, with joints and links.
///
/// `name` is the name of the file, or an address. It decides the format, together with the first
/// bytes of the content, unless the options name one. For an address the content is empty: the
/// address itself has the mechanism.
///
/// # Errors
///
/// Files of no known format, that break their format, or that are larger than any mechanism.
pub fn import(content: &[u8], name: &str, options: &Options) -> Result<Import, ImportError> {
    let format = match options.format {
        Some(format) => format,
        None => Format::detected(content, name)?,
    };
    if options.closures.is_some() && format != Format::Urdf {
        return Err(ImportError::new(format!(
            "a file of the format `{}` takes no table of closures\nhelp: only URDF is a tree whose loops are closed elsewhere",
            format.name()
        )));
    }
    let document = match format {
        Format::Linkage => linkage2::read(content)?,
        Format::Pmks => pmks::read(content, name)?,
        Format::Pyslvs => pyslvs::read(content)?,
        Format::Pylinkage => pylinkage::read(content)?,
        Format::JointTable => joint_table::read(content)?,
        Format::Mjcf | Format::Urdf | Format::Sdf => {
            return robots::import(content, format, name, options);
        }
        Format::HardPoints => return hard_points::import(content, name, options),
    };
    written(document, name, options)
}

/// The message about a drawing of which no link is left, with all that was found out.
fn nothing_moves(document: &Document) -> ImportError {
    let facts = document.warnings.iter().chain(&document.remarks);
    let facts: Vec<&str> = facts.map(String::as_str).take(5).collect();
    ImportError::new(format!(
        "no link of the drawing moves\nhelp: {}",
        facts.join("; ")
    ))
}

/// Writes the mechanism of a drawing.
fn written(mut document: Document, name: &str, options: &Options) -> Result<Import, ImportError> {
    document.check()?;
    tidy::tidy(&mut document);
    if document.links.len() == 1 {
        return Err(nothing_moves(&document));
    }
    choose::named(&mut document, &options.inputs)?;
    choose::missing(&mut document);
    tidy::drop_dangling_links(&mut document);
    let is_address = name.contains("://");
    let file = names::file(name);
    let stem = names::stem(name);
    let called = match &options.mechanism {
        Some(mechanism) => mechanism,
        None if !document.name.trim().is_empty() => &document.name,
        None if is_address => "drawing",
        None => stem,
    };
    let type_name = names::type_name(called);
    let file = if is_address { "an address" } else { file };
    let (text, drawn) = writer::text(&mut document, &type_name, file);
    Ok(Import {
        text,
        drawn,
        warnings: document.warnings,
    })
}
