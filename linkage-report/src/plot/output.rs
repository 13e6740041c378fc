//! A plot as text and as a file.

use std::path::{Path, PathBuf};
use std::string::String;

use super::builder::Plot;
use super::{mistakes, picture};
use linkage_formats::{ReportError, output_file};

impl Plot {
    /// The plot as SVG.
    ///
    /// # Errors
    ///
    /// [`ReportError::Mistakes`] if there is no curve or no value, if a value of the abscissa is
    /// not finite, if a curve or band has not as many values as the abscissa, if a band's curve is
    /// not there, or if words have control characters.
    pub fn svg(&self) -> Result<String, ReportError> {
        let mistakes = mistakes::all_mistakes(self);
        match mistakes.is_empty() {
            true => Ok(picture::drawn(self)),
            false => Err(ReportError::Mistakes(mistakes)),
        }
    }

    /// Writes the plot, by the ending of the file's name, as SVG or (with feature `png`) as PNG.
    ///
    /// # Errors
    ///
    /// As [`svg`](Self::svg), if the file cannot be written, and for any other ending.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<PathBuf, ReportError> {
        output_file::picture(path.as_ref(), &self.svg()?)
    }
}
