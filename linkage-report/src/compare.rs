//! Several designs side by side.

mod check;
mod data;
mod front;
mod picture;

use std::fs;
use std::path::{Path, PathBuf};
use std::string::{String, ToString};
use std::vec::Vec;

use super::SummaryRow;
use super::builder::Report;
use super::frame::Framed;
use super::summary;
use linkage_formats::colour::page_rules;
use linkage_formats::error::{ReportError, failed};
use linkage_formats::output_file;

const BODY: &str = include_str!("page/compare/page.html");
/// Nothing comes from elsewhere.
const POLICY: &str = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:; base-uri 'none'; form-action 'none'";
const STYLES: [&str; 2] = [
    include_str!("page/style.css"),
    include_str!("page/compare/compare.css"),
];
/// Joined in this order; the last one starts the page.
const SCRIPTS: [&str; 9] = [
    include_str!("page/dom.js"),
    include_str!("page/numbers.js"),
    include_str!("page/theme.js"),
    include_str!("page/compare/state.js"),
    include_str!("page/compare/drawing.js"),
    include_str!("page/compare/plot.js"),
    include_str!("page/compare/front.js"),
    include_str!("page/compare/tables.js"),
    include_str!("page/compare/start.js"),
];

/// Several designs side by side: drawing over drawing, curves over curves, a table of figures, and
/// the Pareto front of two or three objectives.
///
/// It is a page of one file, with only the data that it shows: of each design the points of its
/// drawing, the selected curves and its figures, at 361 positions at most.
///
/// ```no_run
/// # fn two(published: linkage_report::Report, found: linkage_report::Report)
/// # -> Result<(), linkage_report::ReportError> {
/// use linkage_report::{Aim, Compared, Comparison};
///
/// Comparison::new("Longer dwell")
///     .design(Compared::new("published", &published).figure("dwell", 0.794, "rad"))
///     .design(
///         Compared::new("within 2 %", &found)
///             .figure("dwell", 1.641, "rad")
///             .page("found/index.html"),
///     )
///     .curves(["slide", "v.x [mm/s]"])
///     .front([Aim::most("dwell"), Aim::least("slide: stroke")])
///     .write("compared")?;
/// # Ok(())
/// # }
/// ```
#[derive(Clone, Debug)]
pub struct Comparison<'a> {
    title: String,
    about: String,
    designs: Vec<Compared<'a>>,
    curves: Vec<String>,
    aims: Vec<Aim>,
}

/// A design of a [`Comparison`].
#[derive(Clone, Debug)]
pub struct Compared<'a> {
    name: String,
    report: &'a Report,
    figures: Vec<SummaryRow>,
    page: Option<String>,
}

/// The direction in which a figure improves.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Aim {
    figure: String,
    most: bool,
}

impl Aim {
    /// The figure should be small.
    #[must_use]
    pub fn least(figure: impl Into<String>) -> Self {
        let figure = figure.into();
        Self {
            figure,
            most: false,
        }
    }

    /// The figure should be large.
    #[must_use]
    pub fn most(figure: impl Into<String>) -> Self {
        let figure = figure.into();
        Self { figure, most: true }
    }
}

impl<'a> Compared<'a> {
    /// A design of this name, as its report tells it: with its picture, columns, dimensions and
    /// summary.
    #[must_use]
    pub fn new(name: impl Into<String>, report: &'a Report) -> Self {
        Self {
            name: name.into(),
            report,
            figures: Vec::new(),
            page: None,
        }
    }

    /// A figure, beside those of the report's summary, which are named `slide: stroke`.
    #[must_use]
    pub fn figure(mut self, name: &str, value: f64, unit: &str) -> Self {
        self.figures.push(SummaryRow::new("", name, value, unit));
        self
    }

    /// Sets the address of the design's page, relative to that of the comparison:
    /// `found/index.html`.
    #[must_use]
    pub fn page(mut self, address: impl Into<String>) -> Self {
        self.page = Some(address.into());
        self
    }

    /// All figures by name.
    fn all_figures(&self) -> Vec<(String, f64, String)> {
        let named = |row: SummaryRow| {
            let name = match row.quantity.as_str() {
                "" => row.what,
                quantity => std::format!("{quantity}: {}", row.what),
            };
            (name, row.value, row.unit)
        };
        let figures = self.figures.iter().cloned();
        figures
            .chain(summary::summary_rows(self.report))
            .map(named)
            .collect()
    }
}

impl<'a> Comparison<'a> {
    /// A comparison with this title.
    #[must_use]
    pub fn new(title: impl Into<String>) -> Self {
        Self {
            title: title.into(),
            about: String::new(),
            designs: Vec::new(),
            curves: Vec::new(),
            aims: Vec::new(),
        }
    }

    /// One or two sentences below the title.
    #[must_use]
    pub fn about(mut self, text: impl Into<String>) -> Self {
        self.about = text.into();
        self
    }

    /// Adds a design. The others are compared with the first one.
    #[must_use]
    pub fn design(mut self, design: Compared<'a>) -> Self {
        self.designs.push(design);
        self
    }

    /// The columns whose curves are laid over each other, named as in [`Report::plot`]. Without it:
    /// the values of the first design's functions.
    #[must_use]
    pub fn curves<'n>(mut self, columns: impl IntoIterator<Item = &'n str>) -> Self {
        self.curves
            .extend(columns.into_iter().map(ToString::to_string));
        self
    }

    /// Shows which designs are best where two or three objectives contradict each other: plots of
    /// one figure against another, on which a click shows or hides a design.
    #[must_use]
    pub fn front(mut self, aims: impl IntoIterator<Item = Aim>) -> Self {
        self.aims.extend(aims);
        self
    }

    /// The page.
    ///
    /// # Errors
    ///
    /// [`ReportError::Mistakes`] with all that does not fit together, in the designs' reports and
    /// between them.
    pub fn html(&self) -> Result<String, ReportError> {
        self.check()?;
        let framed = Framed {
            title: &self.title,
            index: None,
            policy: POLICY,
            style: &(STYLES.join("\n") + &page_rules(0)),
            body: BODY,
            data: ("comparison", &self.value().to_string()),
            script: &SCRIPTS.join("\n"),
        };
        Ok(framed.html())
    }

    /// Writes `index.html` into a folder, which is made if it is not there, and returns its path.
    ///
    /// # Errors
    ///
    /// As [`html`](Self::html), and if the file cannot be written.
    pub fn write(&self, folder: impl AsRef<Path>) -> Result<PathBuf, ReportError> {
        let html = self.html()?;
        let folder = folder.as_ref();
        fs::create_dir_all(folder).map_err(failed(folder))?;
        output_file::file(&folder.join("index.html"), html)
    }
}
