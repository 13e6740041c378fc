//! Errors of a report.

use core::fmt;
use std::error::Error;
use std::io;
use std::path::{Path, PathBuf};
use std::vec::Vec;

use crate::mistake::Mistake;

/// Why a report cannot be written.
#[derive(Debug)]
#[non_exhaustive]
pub enum ReportError {
    /// Contradictions within the report: all that were found.
    Mistakes(Vec<Mistake>),
    /// Pictures are written as SVG, with feature `png` as PNG, by the ending of the file's name;
    /// this one is different.
    Ending {
        /// The file.
        path: PathBuf,
    },
    /// The system has no font, and a PNG without words would not be readable.
    #[cfg(feature = "png")]
    NoFont,
    /// A picture cannot be turned into pixels.
    #[cfg(feature = "png")]
    Pixels {
        /// Why.
        message: std::string::String,
    },
    /// A file cannot be written.
    File {
        /// The file or folder.
        path: PathBuf,
        /// The error of the system.
        error: io::Error,
    },
}

impl fmt::Display for ReportError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Mistakes(mistakes) => {
                for (index, mistake) in mistakes.iter().enumerate() {
                    let separator = if index == 0 { "" } else { "\n" };
                    write!(f, "{separator}{mistake}")?;
                }
                Ok(())
            }
            Self::Ending { path } if cfg!(feature = "png") => write!(
                f,
                "cannot write {}: pictures are written as .svg or .png",
                path.display()
            ),
            Self::Ending { path } => write!(
                f,
                "cannot write {}: pictures are written as .svg, with feature `png` also as .png",
                path.display()
            ),
            #[cfg(feature = "png")]
            Self::NoFont => f.write_str(
                "the system has no font to write a PNG's words with; install one, such as DejaVu Sans, or write .svg",
            ),
            #[cfg(feature = "png")]
            Self::Pixels { message } => write!(f, "no PNG can be made of the picture: {message}; write .svg"),
            Self::File { path, error } => write!(f, "cannot write {}: {error}", path.display()),
        }
    }
}

impl Error for ReportError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::File { error, .. } => Some(error),
            _ => None,
        }
    }
}

impl From<Mistake> for ReportError {
    fn from(mistake: Mistake) -> Self {
        Self::Mistakes(Vec::from([mistake]))
    }
}

/// Converts an error of the system for a file or folder.
pub fn failed(path: &Path) -> impl Fn(io::Error) -> ReportError {
    let path = path.to_path_buf();
    move |error| ReportError::File {
        path: path.clone(),
        error,
    }
}
