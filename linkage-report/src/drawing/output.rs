//! A drawing as text and as a file.

use std::path::{Path, PathBuf};
use std::string::String;

use super::options::Drawing;
use super::{dxf, moving, picture, rows};
use linkage_formats::{ReportError, output_file};

impl Drawing<'_> {
    /// The drawing as SVG; its unit is a millimetre on paper.
    ///
    /// # Errors
    ///
    /// [`ReportError::Mistakes`] for a point that is not there, a scale that is none, and if the
    /// mechanism cannot be assembled at the position that is wanted, or at all.
    pub fn svg(&self) -> Result<String, ReportError> {
        let row = rows::possible_row(self)?;
        match self.seconds {
            Some(seconds) => moving::film(self, seconds),
            None => Ok(picture::picture_at(self, row, row).finish()),
        }
    }

    /// The drawing as DXF (release 12, which every such program reads), in the mechanism's unit of
    /// length: links, joints, paths, guides, gears, axes and names on a layer each, links, guides
    /// and joints of a part of a machine on the layer `part_` with its name, at the drawing's
    /// position, every number with all of its digits. In the plane links of three points and more
    /// are their outline; a mechanism in space is not projected, and its links are lines between
    /// their points.
    ///
    /// # Errors
    ///
    /// As [`svg`](Self::svg).
    pub fn dxf(&self) -> Result<String, ReportError> {
        dxf::drawing_dxf(self)
    }

    /// Writes the drawing, by the ending of the file's name, as SVG, [DXF](Self::dxf) or (with
    /// feature `png`) PNG.
    ///
    /// # Errors
    ///
    /// As [`svg`](Self::svg), if the file cannot be written, and for any other ending.
    pub fn write(&self, path: impl AsRef<Path>) -> Result<PathBuf, ReportError> {
        let path = path.as_ref();
        match path.extension().and_then(|ending| ending.to_str()) {
            Some("dxf") => output_file::file(path, self.dxf()?),
            _ => output_file::picture(path, &self.svg()?),
        }
    }
}
