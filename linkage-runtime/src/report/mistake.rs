//! What does not fit together in a report.

use crate::words::printed;
use core::fmt;
use std::string::String;
use std::vec::Vec;

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
        /// What is missing: `column`, `table`, `point`, `curve`, `argument`.
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
    /// A curve or band has not as many values as the abscissa of its plot.
    Length {
        /// The curve, or the curve that the band is about.
        name: String,
        /// Its values.
        values: usize,
        /// The values of the abscissa.
        positions: usize,
    },
    /// A plot without any curve.
    NoCurve,
    /// A plot over no values at all.
    NoAbscissa {
        /// The quantity that it is over.
        name: String,
    },
    /// The cells of CSV could not be told apart: what stands between columns stands in numbers, too.
    Separator {
        /// What is between columns.
        separator: String,
        /// The decimal mark.
        decimal: char,
    },
    /// A drawing's scale is not positive and finite.
    Scale {
        /// The scale.
        scale: f64,
    },
    /// A cycle of a drawing that moves takes no positive and finite time.
    Seconds {
        /// The time, in seconds.
        seconds: f64,
    },
    /// A drawing in space is asked to move.
    MovesInSpace,
    /// A drawing that is asked to move has something at some positions only.
    Changes,
    /// The mechanism cannot be assembled where it is to be drawn.
    NotAssembled {
        /// The input.
        input: String,
        /// Its unit.
        unit: &'static str,
        /// The position that is wanted; `None` if it cannot be assembled at any position.
        at: Option<f64>,
    },
    /// There are fewer than two positions.
    Positions {
        /// How many there are.
        count: usize,
    },
    /// A cyclogram is over the angle of a shaft, which the report's input is not.
    NoShaft {
        /// The input.
        input: String,
        /// Its unit.
        unit: &'static str,
    },
    /// A table would be written into the file of the cyclogram.
    File {
        /// Its function.
        function: String,
    },
    /// A position or a speed is not finite.
    NotFinite {
        /// What it is.
        what: String,
        /// The number.
        value: f64,
    },
    /// Positions neither rise nor fall all the way.
    Turning {
        /// The input.
        input: String,
        /// The first position that does not go on.
        index: usize,
        /// The one before it, and itself.
        values: [f64; 2],
        /// Whether the first positions that differ rise.
        rises: bool,
    },
    /// Words have a control character, which neither SVG nor HTML can show.
    Control {
        /// The words: `the title`.
        what: String,
        /// What stands before it.
        before: String,
        /// The character.
        character: char,
    },
    /// All positions are the same.
    Still {
        /// The input.
        input: String,
        /// Where it stands.
        at: f64,
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
                "column `{column}` is a sensitivity to parameter {parameter}, beyond the {dimensions} of the dimensions; give `dimensions` the mechanism that was swept"
            ),
            Self::Velocity { column, of } => {
                let of = of.as_deref().unwrap_or("the same quantity");
                write!(
                    f,
                    "the true acceleration of `{column}` needs the first derivative of {of}, since the input accelerates; add it to the function, or give `speed` the acceleration 0"
                )
            }
            Self::Length {
                name,
                values,
                positions,
            } => write!(
                f,
                "`{name}` has {values} values, the abscissa {positions}; give one for each"
            ),
            Self::NoAbscissa { name } => write!(f, "the plot is over no value of `{name}`; give some"),
            Self::NotFinite { what, value } => write!(f, "{what} is {value}; give a finite number"),
            Self::Turning {
                input,
                index,
                values: [before, value],
                rises,
            } => {
                write!(f, "position {index} of `{input}` is {value} after {before}, ")?;
                if before == value {
                    return f.write_str("which is the same; give each position once");
                }
                let first = if *rises { "rise" } else { "fall" };
                write!(
                    f,
                    "on the way back, while the first ones {first}; give positions that only rise or only fall, and write a report for each such stretch"
                )
            }
            Self::Control {
                what,
                before,
                character,
            } => write!(
                f,
                "{what} has the control character U+{:04X} after {before:?}, which pictures and pages cannot show; leave it out",
                u32::from(*character)
            ),
            Self::Still { input, at } => write!(
                f,
                "`{input}` is {at} at all positions; give the input a range, or the report other positions"
            ),
            Self::Separator { separator, decimal } => write!(
                f,
                "columns with {separator:?} between them and numbers with {decimal:?} for the decimal point cannot be told apart when they are read; take \";\" and ',', or \",\" and '.'"
            ),
            Self::NoShaft { input, unit } => write!(
                f,
                "a cyclogram is over an angle in rad, and the input `{input}` is {}; give the report the shaft as its input",
                if unit.is_empty() {
                    String::from("a number")
                } else {
                    std::format!("in {unit}")
                }
            ),
            Self::File { function } => write!(
                f,
                "the table of `{function}` and the cyclogram would both be `{function}.csv`; give the function another name"
            ),
            Self::NoCurve => f.write_str("the plot has no curve; add one with `curve`"),
            Self::Scale { scale } => write!(
                f,
                "{scale} is no scale; give a positive number, 1 for the true size"
            ),
            Self::Seconds { seconds } => write!(
                f,
                "a cycle takes {seconds} s; give a positive number of seconds"
            ),
            Self::MovesInSpace => f.write_str(
                "drawings of mechanisms in space do not move, which is a limit of ours; the page of the report moves and turns them",
            ),
            Self::Changes => f.write_str(
                "the drawing cannot move, since something is shown at some positions only; draw single positions, or look at the page of the report",
            ),
            Self::NotAssembled {
                input,
                unit,
                at: Some(at),
            } => write!(
                f,
                "the mechanism cannot be drawn at {input} = {at} {unit}, since it cannot be assembled there; draw another position"
            ),
            Self::NotAssembled { .. } => f.write_str(
                "the mechanism cannot be drawn, since it cannot be assembled at any position; check its dimensions",
            ),
            Self::Positions { count } => write!(
                f,
                "a report needs two positions or more, and has {count}; `Input::positions` gives evenly spaced ones"
            ),
        }
    }
}

/// Names in back-ticks, or `nothing`.
fn listed(names: &[String]) -> impl fmt::Display + '_ {
    printed(move |f| {
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
