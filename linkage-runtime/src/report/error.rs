//! What can be wrong with a report.

use core::fmt;
use std::error::Error;
use std::io;
use std::path::PathBuf;
use std::string::String;
use std::vec::Vec;

/// Why a report cannot be written.
#[derive(Debug)]
#[non_exhaustive]
pub enum ReportError {
    /// What does not fit together in the report: all that was found.
    Mistakes(Vec<Mistake>),
    /// A file cannot be written.
    File {
        /// The file or folder.
        path: PathBuf,
        /// What the system says.
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
            Self::File { path, error } => write!(f, "cannot write {}: {error}", path.display()),
        }
    }
}

impl Error for ReportError {
    fn source(&self) -> Option<&(dyn Error + 'static)> {
        match self {
            Self::Mistakes(_) => None,
            Self::File { error, .. } => Some(error),
        }
    }
}

impl From<Mistake> for ReportError {
    fn from(mistake: Mistake) -> Self {
        Self::Mistakes(Vec::from([mistake]))
    }
}

/// Something that does not fit together in a report.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Mistake {
    /// A table has not as many rows as the report has positions.
    Rows {
        /// The table's function.
        function: String,
        /// Its rows.
        rows: usize,
        /// The positions of the report.
        positions: usize,
    },
    /// Two tables come from the same function, so that their columns could not be told apart.
    Twice {
        /// The function.
        function: String,
    },
    /// More than one table has the columns of a picture.
    Pictures {
        /// Their functions.
        functions: Vec<String>,
    },
    /// Something needs a picture, and no table has its columns.
    NoPicture {
        /// What needs it.
        wanted: String,
        /// The functions of the tables that there are.
        functions: Vec<String>,
    },
    /// There is nothing of this name.
    Unknown {
        /// What is missing: `column`, `table`, `point`.
        kind: &'static str,
        /// The name.
        name: String,
        /// The names that there are.
        known: Vec<String>,
    },
    /// A column is a sensitivity to a parameter that the dimensions do not have: they are those of another mechanism.
    Parameter {
        /// The column.
        column: String,
        /// The index of the parameter.
        parameter: usize,
        /// How many dimensions there are.
        dimensions: usize,
    },
    /// A true acceleration needs the first derivative, too, since the input accelerates.
    Velocity {
        /// The column with the second derivative.
        column: String,
        /// The quantity that was differentiated, if the table has it.
        of: Option<String>,
    },
    /// There are fewer than two positions.
    Positions {
        /// How many there are.
        count: usize,
    },
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Rows {
                function,
                rows,
                positions,
            } => write!(
                f,
                "table `{function}` has {rows} rows, the report {positions} positions; sweep the positions that the report was made with"
            ),
            Self::Twice { function } => write!(
                f,
                "table `{function}` was added twice; add it once, or write a report for each of the mechanisms"
            ),
            Self::Pictures { functions } => write!(
                f,
                "several tables have a picture: {}; keep one of them",
                listed(functions)
            ),
            Self::NoPicture { wanted, functions } => write!(
                f,
                "{wanted} needs a picture, and no table has one ({}); add the sweep of a function with `picture()`",
                listed(functions)
            ),
            Self::Unknown { kind, name, known } => {
                write!(f, "no {kind} `{name}`; there is {}", listed(known))
            }
            Self::Parameter {
                column,
                parameter,
                dimensions,
            } => write!(
                f,
                "column `{column}` is a sensitivity to parameter {parameter}, but there are {dimensions} dimensions; give `dimensions` the mechanism that was swept"
            ),
            Self::Velocity { column, of } => {
                let of = of.as_deref().unwrap_or("the same quantity");
                write!(
                    f,
                    "the true acceleration of `{column}` needs the first derivative of {of}, since the input accelerates; add it to the function, or give `speed` the acceleration 0"
                )
            }
            Self::Positions { count } => write!(
                f,
                "{count} positions make no range; give at least two, as `Input::positions` does"
            ),
        }
    }
}

/// Names in back-ticks, or `nothing`.
fn listed(names: &[String]) -> impl fmt::Display + '_ {
    fmt::from_fn(move |f| {
        if names.is_empty() {
            return f.write_str("nothing");
        }
        for (index, name) in names.iter().enumerate() {
            let separator = if index == 0 { "" } else { ", " };
            write!(f, "{separator}`{name}`")?;
        }
        Ok(())
    })
}
