//! Mistakes as messages.

use core::fmt;
use std::string::String;

use super::Mistake;
use linkage_core::format::printed;

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
            Self::NoDesign => f.write_str("a comparison without a design; add some"),
            Self::SameName { name } => write!(
                f,
                "two designs are called `{name}`; give one of them another name"
            ),
            Self::OtherPositions { name, first } => write!(
                f,
                "`{name}` was swept over other positions than `{first}`; sweep all designs over the same ones"
            ),
            Self::OtherUnit {
                name,
                design,
                units: [unit, first],
            } => write!(
                f,
                "`{name}` of `{design}` is in {unit:?}, that of the first design in {first:?}; give all in one unit"
            ),
            Self::Aims { count } => write!(
                f,
                "a front is of two or three wishes, which is our limit, and not of {count}; leave some, or add some"
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
