//! Outputs of a report: data, pages, plots and drawings.

use std::path::{Path, PathBuf};
use std::string::String;
use std::vec::Vec;

use super::builder::Report;
use super::drawing::Drawing;
use super::plot::Plot;
use super::{check, csv, json, page, plots, write};
use linkage_formats::ReportError;

impl Report {
    /// Checks that all parts fit together. Every output calls it first.
    ///
    /// # Errors
    ///
    /// [`ReportError::Mistakes`] with all that was found.
    pub fn check(&self) -> Result<(), ReportError> {
        check::check(self)
    }

    /// Everything as JSON: numbers with the digits that they have, in the units beside them, angles
    /// in radians. A number that is not finite is `null`. Numbers stand there once: where a column
    /// has those of an earlier one, as points of the picture do, there is `{"table": 0, "column":
    /// 3}` in their place.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check).
    pub fn json(&self) -> Result<String, ReportError> {
        json::report_json(self)
    }

    /// The table of a function: the input, its columns, then the true velocities and accelerations
    /// that follow from them.
    ///
    /// The first line has names and units, `phi [rad],p.x [mm],v.x [mm/rad]`. Numbers have the
    /// digits that it takes to read them back exactly, unless [`csv_style`](Self::csv_style) says
    /// something else; a number that is not finite is an empty cell.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check), and if there is no table of this function.
    pub fn csv(&self, function: &str) -> Result<String, ReportError> {
        csv::table_csv(self, function)
    }

    /// An interactive page as one file that needs no network: the moving mechanism, plots, tables.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check).
    pub fn html(&self) -> Result<String, ReportError> {
        page::page_html(self)
    }

    /// Returns the data of the page as JSON, for the host of a [`page_view`](crate::page_view).
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check).
    #[doc(hidden)]
    pub fn page_data(&self) -> Result<String, ReportError> {
        json::page_json(self)
    }

    /// A plot of columns against the input. Quantities that the report has sensitivities of get
    /// bands of their tolerances.
    ///
    /// A column is named as in the program, `p10.x`. Where that is not enough, the function stands
    /// in front, `motion.p10.x`, or the unit behind, as in the head of a CSV file: `v.x [mm/s]` is
    /// the true velocity.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check), and for each name that is not there.
    pub fn plot<'n>(
        &self,
        columns: impl IntoIterator<Item = &'n str>,
    ) -> Result<Plot, ReportError> {
        plots::plot_columns(self, columns)
    }

    /// Plots the effect of tolerances on each quantity with sensitivities: worst case and
    /// statistical error against the input. `None` if there are no sensitivities, dimensions or
    /// tolerances.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check).
    pub fn plot_errors(&self) -> Result<Option<Plot>, ReportError> {
        plots::plot_errors(self)
    }

    /// A drawing of the mechanism.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check), and if no table has the columns of a picture.
    pub fn drawing(&self) -> Result<Drawing<'_>, ReportError> {
        Drawing::new(self)
    }

    /// Writes everything into a folder, which is made if it is not there, and returns the files:
    ///
    /// | file | content |
    /// |---|---|
    /// | `index.html` | the interactive page |
    /// | `data.json` | all data |
    /// | `FUNCTION.csv` | each table |
    /// | `cyclogram.svg`, `cyclogram.csv` | the [cyclogram](Self::cyclogram), if there is one |
    /// | `cyclogram-order.csv`, `cyclogram-overlaps.csv` | events in order; simultaneous motions |
    /// | `drawing.svg` | the mechanism to scale, if a table has a picture |
    /// | `drawing.dxf` | the same, true to size, for programs that construct |
    /// | `plots/FUNCTION.svg` | values and derivatives |
    /// | `plots/FUNCTION-true.svg` | true velocities and accelerations |
    /// | `version.js` | which [version](Self::version) it is, if that was said |
    /// | `plots/errors-by-tolerances.svg` | errors over the range, if there are tolerances |
    ///
    /// Files of an earlier report are replaced when all files are complete: where one cannot be
    /// written, as on a full disk, the earlier report stays as it is. Files that it had and this
    /// one has not stay, too.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check), and if a file cannot be written.
    pub fn write(&self, folder: impl AsRef<Path>) -> Result<Vec<PathBuf>, ReportError> {
        write::write_report(self, folder)
    }
}
