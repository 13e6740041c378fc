//! Readers of the files of other programs for linkages.
//!
//! [`import`] turns a file, or the address of a page, into a commented text in the language of
//! linkage. Each length has a comment with the band in which the rounding of the file leaves it.
//! Everything that could not be taken is a comment of the text and a warning.

mod error;
mod format;
mod options;

pub use error::ImportError;
pub use format::Format;
pub use options::Options;

/// A mechanism that was read from a file of another program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Import {
    /// The text of a file with one mechanism.
    pub text: String,
    /// Everything that could not be taken, or should be confirmed, one sentence each.
    pub warnings: Vec<String>,
}

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
    match format {
        Format::Linkage
        | Format::Pmks
        | Format::Pyslvs
        | Format::Pylinkage
        | Format::JointTable => Err(ImportError::new("this format is not read yet")),
    }
}
