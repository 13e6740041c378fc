//! One function of a mechanism: its programs and the numbers of its result.

use linkage_symbolic::count::Count;
use linkage_symbolic::passes::stages::Stage;
use linkage_symbolic::program::Program;

use crate::model::Shape;

pub use linkage_core::Meaning;

/// A function of the `impl` block.
#[derive(Clone, Debug)]
pub struct Function {
    /// As declared.
    pub name: String,
    /// Its doc comment, line by line as written.
    pub documentation: String,
    /// What it takes, as places among inputs and arguments.
    pub arguments: Vec<usize>,
    /// The coupled groups whose prepared states it loads.
    pub states: Vec<usize>,
    /// What a call runs: loads prepared slots, parameters, inputs and states; outputs are the fields' scalars in order, each
    /// field flattened outermost index first, vector components innermost.
    pub called: Body,
    /// The same from a table that was prepared for other dimensions, or for derivatives and digits that the table does not
    /// have; `None` if that is no different.
    pub beside: Option<Body>,
    /// The same where the states of all coupled groups are solutions, as those of a follower are; `None` if there is no follower, or that is
    /// no different.
    pub settled: Option<Body>,
    /// The fields of the result.
    pub fields: Vec<Field>,
    /// What each output is.
    pub columns: Vec<Column>,
    /// In which direction derivatives by parameters were found, if there are any.
    pub sensitivities: Option<&'static str>,
}

impl Function {
    /// What its calls run, to be changed.
    pub(super) fn bodies_mut(&mut self) -> impl Iterator<Item = &mut Body> {
        let others = [self.beside.as_mut(), self.settled.as_mut()];
        std::iter::once(&mut self.called).chain(others.into_iter().flatten())
    }

    /// A sentence for the docs, a space in front, if there are derivatives by parameters.
    pub(crate) fn direction_note(&self) -> String {
        self.sensitivities.map_or_else(String::new, |direction| {
            format!(" Derivatives by parameters are computed {direction}.")
        })
    }
}

/// A program and what passes made of it.
#[derive(Clone, Debug, Default)]
pub struct Body {
    /// As a whole.
    pub program: Program,
    /// Cut into stages, for loops over many positions.
    pub stages: Vec<Stage>,
    /// What it costs.
    pub count: Count,
    /// Whether something hangs on the last bit of a sine ([`Program::compares_sines`]), so that calls may not round it in their own way.
    pub compares_sines: bool,
}

impl Body {
    /// Whether it takes longer than a call to other code for it, which is 1 to 2 ns: some ten operations without a sine, a root or a
    /// quotient are inlined into the loop that wants them, and then run with the instructions of the build; others choose those of the
    /// machine.
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
    /// As declared.
    pub name: String,
    /// Its doc comment, line by line as written.
    pub documentation: String,
    /// How its scalars are put together.
    pub shape: Shape,
    /// Words for the docs: `mm`, `rad`, `mm/rad`, nothing for a number, and for a picture.
    pub unit: String,
    /// What it is, for the docs: `` derivative of `p` by `phi` ``; nothing for what its name says.
    pub about: String,
}

impl Field {
    /// What it is and in which unit: `` derivative of `p` by `phi`, in mm/rad ``; nothing for a number that its name says all of.
    pub fn told(&self) -> String {
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
    /// What it was derived from.
    pub meaning: Meaning,
}
