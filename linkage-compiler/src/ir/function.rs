//! One function of a mechanism: its programs and the numbers of its result.

use linkage_symbolic::count::Count;
use linkage_symbolic::passes::stages::Stage;
use linkage_symbolic::program::Program;

use crate::model::Shape;

pub use linkage_core::Meaning;

/// A function of the `impl` block.
#[derive(Clone, Debug)]
pub struct Function {
    /// The name as declared.
    pub name: String,
    /// Its doc comment, line by line as written.
    pub documentation: String,
    /// The arguments that it takes, as indices among inputs and arguments.
    pub arguments: Vec<usize>,
    /// The coupled groups whose prepared states it loads.
    pub states: Vec<usize>,
    /// The program that a call runs: loads prepared slots, parameters, inputs and states; outputs
    /// are the fields' scalars in order, each field flattened outermost index first, vector
    /// components innermost.
    pub called: Body,
    /// The same from a table that was prepared for other dimensions, or for derivatives and digits
    /// that the table does not have; `None` if that is no different.
    pub beside: Option<Body>,
    /// The same for states of all coupled groups that are solutions, as those of a follower are;
    /// `None` if there is no follower, or if the program is no different.
    pub settled: Option<Body>,
    /// The fields of the result.
    pub fields: Vec<Field>,
    /// The description of each output.
    pub columns: Vec<Column>,
    /// In which direction derivatives by parameters were found, if there are any.
    pub sensitivities: Option<&'static str>,
}

impl Function {
    /// The programs that its calls run, to be changed.
    pub(super) fn bodies_mut(&mut self) -> impl Iterator<Item = &mut Body> {
        let others = [self.beside.as_mut(), self.settled.as_mut()];
        std::iter::once(&mut self.called).chain(others.into_iter().flatten())
    }

    /// A sentence for the docs, a space in front, if there are derivatives by parameters.
    pub fn direction_note(&self) -> String {
        self.sensitivities.map_or_else(String::new, |direction| {
            format!(" Derivatives by parameters are computed {direction}.")
        })
    }
}

/// A program and the results of passes over it.
#[derive(Clone, Debug, Default)]
pub struct Body {
    /// The program as a whole.
    pub program: Program,
    /// Cut into stages, for loops over many positions.
    pub stages: Vec<Stage>,
    /// Its cost.
    pub count: Count,
    /// True if something depends on the last bit of a sine ([`Program::compares_sines`]), so that
    /// calls may not round it in their own way.
    pub compares_sines: bool,
}

impl Body {
    /// Returns true if it takes longer than a call to other code for it, which is 1 to 2 ns. Some
    /// ten operations without a sine, a root or a quotient are inlined into the loop that uses
    /// them, and then run with the instructions of the build; others choose those of the machine.
    pub fn is_worth_a_call(&self) -> bool {
        const FEW: u32 = 12;
        let Count {
            add,
            mul,
            div,
            sqrt,
            sin_cos,
            atan2,
            other,
        } = self.count;
        div + sqrt + sin_cos + atan2 > 0 || add + mul + other > FEW
    }
}

/// A field of a function's result.
#[derive(Clone, Debug)]
pub struct Field {
    /// The name as declared.
    pub name: String,
    /// Its doc comment, line by line as written.
    pub documentation: String,
    /// The arrangement of its scalars.
    pub shape: Shape,
    /// Words for the docs: `mm`, `rad`, `mm/rad`, nothing for a number, and for a picture.
    pub unit: String,
    /// The quantity, for the docs: `` derivative of `p` by `phi` ``; empty if the name describes
    /// it.
    pub about: String,
    /// The joint whose reaction the field is.
    pub reaction: Option<String>,
    /// The input, by index, whose acceleration without drives the field is.
    pub driven_acceleration: Option<usize>,
}

impl Field {
    /// Returns the quantity and its unit: `` derivative of `p` by `phi`, in mm/rad ``; empty for a
    /// number that its name describes completely.
    pub fn description(&self) -> String {
        match (self.about.as_str(), self.unit.as_str()) {
            (about, "") => about.to_owned(),
            ("", unit) => format!("in {unit}"),
            (about, unit) => format!("{about}, in {unit}"),
        }
    }
}

/// One number of a result.
#[derive(Clone, Debug, PartialEq)]
pub struct Column {
    /// `p.x`, `e[crank].y`
    pub name: String,
    /// `mm`, `rad/mm^2`, nothing for a number.
    pub unit: String,
    /// The origin that it was derived from.
    pub meaning: Meaning,
}
