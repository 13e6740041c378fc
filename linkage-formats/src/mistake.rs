//! Contradictions within a report.

mod message;

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
    /// Two tables come from the same function, so that their columns would be ambiguous.
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
        /// The item that needs it.
        wanted: String,
        /// The functions of the tables that there are.
        functions: Vec<String>,
    },
    /// There is nothing of this name.
    Unknown {
        /// The missing item: `column`, `table`, `point`, `curve`, `argument`.
        kind: &'static str,
        /// The name.
        name: String,
        /// The names that there are.
        known: Vec<String>,
    },
    /// A column is a sensitivity to a parameter that the dimensions do not have: they are those of
    /// another mechanism.
    Parameter {
        /// The column.
        column: String,
        /// The index of the parameter.
        parameter: usize,
        /// The number of dimensions.
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
    /// The cells of CSV are ambiguous, since the separator occurs in numbers.
    Separator {
        /// The separator.
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
        /// The number of positions.
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
        /// The item.
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
        /// True if the first positions that differ rise.
        rises: bool,
    },
    /// Words have a control character, which neither SVG nor HTML can show.
    Control {
        /// The words: `the title`.
        what: String,
        /// The text before it.
        before: String,
        /// The character.
        character: char,
    },
    /// All positions are the same.
    Still {
        /// The input.
        input: String,
        /// The item with the name.
        at: f64,
    },
    /// A comparison of nothing.
    NoDesign,
    /// Two designs of a comparison have one name.
    SameName {
        /// The name.
        name: String,
    },
    /// Designs that are compared were swept over different positions, or inputs.
    OtherPositions {
        /// The design.
        name: String,
        /// The first design, which it differs from.
        first: String,
    },
    /// A column or a figure is in different units in different designs.
    OtherUnit {
        /// The column or figure.
        name: String,
        /// The design.
        design: String,
        /// Both units.
        units: [String; 2],
    },
    /// A front of other than two or three objectives.
    Aims {
        /// The number of objectives.
        count: usize,
    },
}
