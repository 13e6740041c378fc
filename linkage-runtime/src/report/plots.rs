//! Plots of a report's columns.

use std::borrow::Cow;
use std::format;
use std::string::{String, ToString};
use std::vec::Vec;

use super::accuracy::Sensitive;
use super::panels::{TOGETHER, panels};
use super::rates::True;
use super::tables::Saved;
use super::units::{per_second, titled};
use super::{BandKind, Mistake, Plot, Report, ReportError};
use crate::format::rounded;
use crate::{Column, Meaning};

/// A column as it is asked for.
struct Found<'a> {
    name: &'static str,
    unit: Cow<'a, str>,
    values: Cow<'a, [f64]>,
    /// The table and index, unless it is a true velocity or acceleration.
    column: Option<(&'a Saved, usize)>,
}

impl Report {
    /// A plot of columns against the input. Quantities that the report has sensitivities of get bands of their tolerances.
    ///
    /// A column is named as in the program, `p10.x`. Where that is not enough, the function stands in front,
    /// `motion.p10.x`, or the unit behind, as in the head of a CSV file: `v.x [mm/s]` is the true velocity.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check), and for each name that is not there.
    pub fn plot<'n>(
        &self,
        columns: impl IntoIterator<Item = &'n str>,
    ) -> Result<Plot, ReportError> {
        self.check()?;
        let rates = self.true_rates();
        let mut mistakes = Vec::new();
        let mut plot = self.empty_plot();
        for name in columns {
            match self.find(&rates, name) {
                Some(found) => plot = self.with(plot, &found),
                None => mistakes.push(Mistake::Unknown {
                    kind: "column",
                    name: name.to_string(),
                    known: self.known(),
                }),
            }
        }
        if mistakes.is_empty() {
            Ok(plot)
        } else {
            Err(ReportError::Mistakes(mistakes))
        }
    }

    /// A plot of what tolerances do to each quantity with sensitivities: worst case and statistical error against the
    /// input. `None` if there are no sensitivities, dimensions or tolerances.
    ///
    /// # Errors
    ///
    /// As [`check`](Self::check).
    pub fn plot_errors(&self) -> Result<Option<Plot>, ReportError> {
        self.check()?;
        let sensitive = self.sensitive();
        if sensitive.is_empty() {
            return Ok(None);
        }
        let hues = self.hues();
        let mut plot = self
            .empty_plot()
            .title(format!("{}: errors by tolerances", self.title));
        for quantities in sensitive.chunks(TOGETHER / 2) {
            for quantity in quantities {
                for kind in [BandKind::WorstCase, BandKind::Statistical] {
                    let name = format!("{}, {}", quantity.name, kind.name());
                    plot = plot.curve(&name, &quantity.unit, &quantity.half(kind));
                    plot = plot.styled(hues.style(&quantity.name));
                    if kind == BandKind::Statistical {
                        plot = plot.thin();
                    }
                }
            }
            plot = plot.panel();
        }
        Ok(Some(plot))
    }

    /// The plots that belong to a report, with their names: values and derivatives of each function, true velocities and
    /// accelerations, errors by tolerances.
    pub(super) fn all_plots(&self) -> Result<Vec<(String, Plot)>, ReportError> {
        let rates = self.true_rates();
        let sensitive = self.sensitive();
        let hues = self.hues();
        let mut plots = Vec::new();
        for table in &self.tables {
            let function = table.heading.function;
            let columns = table.columns().filter(|(column, _)| is_plotted(column));
            let given = columns.map(|(column, values)| (column.name, column.unit, values));
            let plot = self
                .empty_plot()
                .title(format!("{}: {function}", self.title));
            let plot = panels(plot, &hues, given).map(|plot| banded(plot, table, &sensitive));
            plots.extend(plot.map(|plot| (function.to_string(), plot)));

            let rates = rates.iter().filter(|rate| rate.table == function);
            let rates = rates.map(|r| (r.column.name, r.unit.as_str(), r.values.as_slice()));
            let title = format!(
                "{}: {function}, true velocities and accelerations{}",
                self.title,
                self.at_speed()
            );
            let plot = self.empty_plot().title(title);
            plots.extend(panels(plot, &hues, rates).map(|plot| (format!("{function}-true"), plot)));
        }
        let errors = self.plot_errors()?;
        plots.extend(errors.map(|plot| (String::from("errors-by-tolerances"), plot)));
        Ok(plots)
    }

    /// ` at 10 rad/s`
    fn at_speed(&self) -> String {
        self.speed.map_or_else(String::new, |speed| {
            let unit = per_second(self.input.unit, 1);
            format!(" at {} {unit}", rounded(speed.omega))
        })
    }

    fn empty_plot(&self) -> Plot {
        Plot::new(self.input.name, self.input.unit, &self.positions).title(self.title.as_str())
    }

    fn with(&self, plot: Plot, found: &Found<'_>) -> Plot {
        let name = match found.column {
            Some((table, _)) if plot.has_curve(found.name, &found.unit) => {
                Cow::Owned(format!("{}.{}", table.heading.function, found.name))
            }
            _ => Cow::Borrowed(found.name),
        };
        let plot = plot.curve(&name, &found.unit, &found.values);
        let mut plot = plot.styled(self.hues().style(found.name));
        let sensitive = self.sensitive();
        let about = sensitive.iter().filter(|sensitive| {
            let of = sensitive.column.map(|index| (sensitive.table, index));
            match (of, found.column) {
                (Some((a, i)), Some((b, j))) => core::ptr::eq(a, b) && i == j,
                _ => false,
            }
        });
        for sensitive in about {
            for kind in [BandKind::WorstCase, BandKind::Statistical] {
                plot = plot.band(&name, kind, &sensitive.half(kind));
            }
        }
        plot
    }

    fn find<'a>(&'a self, rates: &'a [True], name: &str) -> Option<Found<'a>> {
        let named = |function: &str, column: &Column, unit: &str| {
            let titled = titled(column.name, unit);
            let rest = name
                .strip_prefix(function)
                .and_then(|rest| rest.strip_prefix('.'));
            [Some(name), rest]
                .into_iter()
                .flatten()
                .any(|name| name == column.name || name == titled)
        };
        let columns = self.tables.iter().flat_map(|table| {
            let columns = table.columns().enumerate();
            columns.map(move |(index, (column, values))| (table, index, column, values))
        });
        let columns = columns
            .filter(|(table, _, column, _)| named(table.heading.function, column, column.unit));
        // Of functions that all have it, one that has its sensitivities, too.
        let sensitive = self.sensitive();
        let is_banded = |table: &Saved, index: usize| {
            let is_it =
                |s: &Sensitive<'_>| s.column == Some(index) && core::ptr::eq(s.table, table);
            sensitive.iter().any(is_it)
        };
        let given = columns.min_by_key(|(table, index, ..)| !is_banded(table, *index));
        let given = given.map(|(table, index, column, values)| Found {
            name: column.name,
            unit: Cow::Borrowed(column.unit),
            values: Cow::Borrowed(values),
            column: Some((table, index)),
        });
        let mut rates = rates
            .iter()
            .filter(|rate| named(rate.table, rate.column, &rate.unit));
        given.or_else(|| {
            rates.next().map(|rate| Found {
                name: rate.column.name,
                unit: Cow::Borrowed(&rate.unit),
                values: Cow::Borrowed(&rate.values),
                column: None,
            })
        })
    }

    /// Name, unit and values of a column, as [`plot`](Self::plot) finds it.
    pub(super) fn series(&self, name: &str) -> Option<(&'static str, String, Vec<f64>)> {
        let rates = self.true_rates();
        let found = self.find(&rates, name)?;
        Some((
            found.name,
            found.unit.into_owned(),
            found.values.into_owned(),
        ))
    }

    pub(super) fn known(&self) -> Vec<String> {
        let columns = self.tables.iter().flat_map(|table| table.heading.columns);
        let columns = columns.filter(|column| column.meaning != Meaning::Picture);
        let columns = columns.map(|column| column.name.to_string());
        let rates = self.true_rates();
        let rates = rates
            .iter()
            .map(|rate| titled(rate.column.name, &rate.unit));
        columns.chain(rates).collect()
    }
}

/// The plot with bands about the quantities that the function has sensitivities of, too.
fn banded(plot: Plot, table: &Saved, sensitive: &[Sensitive<'_>]) -> Plot {
    let own = |about: &&Sensitive<'_>| about.column.is_some() && core::ptr::eq(about.table, table);
    sensitive.iter().filter(own).fold(plot, |plot, about| {
        [BandKind::WorstCase, BandKind::Statistical]
            .into_iter()
            .fold(plot, |plot, kind| {
                plot.band(&about.name, kind, &about.half(kind))
            })
    })
}

/// Whether a column is in the plots that are made unasked: sensitivities are too many, and points of the picture are in the
/// drawing.
fn is_plotted(column: &Column) -> bool {
    match column.meaning {
        Meaning::Value | Meaning::Rate { .. } | Meaning::Margin => true,
        Meaning::Sensitivity { .. } | Meaning::Picture => false,
    }
}
