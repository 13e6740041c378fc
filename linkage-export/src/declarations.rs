//! The declarations of a mechanism: data that all files of a printer read.

use linkage_compiler::ir::{CompiledMechanism, Function, Input, Scalar, Shape};

use crate::angles::AngleTables;
use crate::coupled::CoupledDeclaration;
use crate::refusals::Refusal;
use crate::renamed::Renamed;
use crate::scalars::CompoundType;

/// A mechanism in a target language: its names, types, arguments, tables, units and comments.
#[derive(Debug)]
pub struct Declarations<'a> {
    /// The compiled mechanism, for its programs.
    pub unit: &'a CompiledMechanism,
    /// The name in the declaration.
    pub title: &'a str,
    /// The name in the target language.
    pub name: String,
    /// The doc comment of the mechanism, without blanks at its ends.
    pub documentation: &'a str,
    /// The unit of all lengths, if unknowns are lengths.
    pub length: Option<&'a str>,
    /// The reference inputs as a text: `phi = 30 deg`.
    pub reference: String,
    /// The names of [`Target::ITEMS`](crate::Target::ITEMS), in their order.
    pub items: Vec<String>,
    /// The names of [`Target::LATER_ITEMS`](crate::Target::LATER_ITEMS), in their order.
    pub later_items: Vec<String>,
    /// The inputs, in the order in which programs count them.
    pub inputs: Vec<InputDeclaration<'a>>,
    /// The dimensions.
    pub dimensions: Vec<ParameterDeclaration<'a>>,
    /// Expressions of the scalars of all dimensions, in the order in which programs count them,
    /// behind that of the variable that contains the dimensions: `pivot.x`.
    pub scalars: Vec<String>,
    /// The functions of the user.
    pub functions: Vec<FunctionDeclaration<'a>>,
    /// The types of vectors and frames that dimensions and results have.
    pub types: Vec<CompoundType>,
    /// The reasons for which assembling fails.
    pub refusals: Vec<Refusal>,
    /// The tables of the continuous angles.
    pub angles: AngleTables,
    /// The groups without a closed form.
    pub coupled: Vec<CoupledDeclaration<'a>>,
    /// Names of the declaration that have another form.
    pub renamed: Vec<Renamed>,
    /// A beginning of names that nothing else in the files has: the name of the mechanism and
    /// `_own_`, in another form if that is taken.
    pub private: String,
}

/// A driving coordinate.
#[derive(Debug)]
pub struct InputDeclaration<'a> {
    /// The name as it is read.
    pub name: &'a str,
    /// The input.
    pub input: &'a Input,
    /// Its unit and range: `rad, from 0 deg to 360 deg`.
    pub note: String,
}

/// A parameter of the mechanism.
#[derive(Debug)]
pub struct ParameterDeclaration<'a> {
    /// Its name, type and comment.
    pub member: MemberDeclaration<'a>,
    /// The units, defaults and tolerances of its scalars.
    pub scalars: &'a [Scalar],
}

/// A member of a type: a dimension, or a result of a function.
#[derive(Debug)]
pub struct MemberDeclaration<'a> {
    /// The name in the target language.
    pub name: String,
    /// The declaration of the member, without its end.
    pub declaration: String,
    /// The doc comment of the user.
    pub documentation: &'a str,
    /// The arrangement of its scalars.
    pub shape: &'a Shape,
    /// Its quantity and unit: `velocity of s, in mm/rad`.
    pub note: String,
}

/// A function of the user.
#[derive(Debug)]
pub struct FunctionDeclaration<'a> {
    /// The function, for its program.
    pub function: &'a Function,
    /// The names of its items, in the order of
    /// [`Target::FUNCTION_ITEMS`](crate::Target::FUNCTION_ITEMS), without those that it does not
    /// have.
    pub items: Vec<String>,
    /// The arguments, in the order of the declaration.
    pub arguments: Vec<ArgumentDeclaration>,
    /// The results.
    pub fields: Vec<MemberDeclaration<'a>>,
    /// Its operations as a sentence.
    pub cost: String,
}

/// An argument of a function.
#[derive(Debug)]
pub struct ArgumentDeclaration {
    /// The name in the target language.
    pub name: String,
    /// The declaration of the argument, without its end.
    pub declaration: String,
    /// The index among the inputs, then the arguments of the mechanism: that of
    /// [`Source::Input`](linkage_symbolic::program::Source::Input) in programs.
    pub index: usize,
    /// Its unit, and the range of an input.
    pub note: String,
}

impl FunctionDeclaration<'_> {
    /// Returns the name of the argument that gives an input of programs, if the function takes it.
    pub fn argument(&self, input: usize) -> Option<&str> {
        let mut arguments = self.arguments.iter();
        let argument = arguments.find(|argument| argument.index == input)?;
        Some(&argument.name)
    }
}
