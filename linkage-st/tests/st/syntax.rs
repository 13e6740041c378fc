//! The part of structured text that is printed, as a tree.

use std::collections::BTreeMap;

/// A file.
#[derive(Debug, Default)]
pub(crate) struct File {
    pub(crate) types: BTreeMap<String, Vec<Variable>>,
    pub(crate) functions: BTreeMap<String, Unit>,
    pub(crate) blocks: BTreeMap<String, Unit>,
}

/// A function, or a function block.
#[derive(Debug, Default)]
pub(crate) struct Unit {
    pub(crate) name: String,
    pub(crate) inputs: Vec<Variable>,
    /// `VAR_IN_OUT` and `VAR_OUTPUT`.
    pub(crate) others: Vec<Variable>,
    /// `VAR` and `VAR_TEMP`.
    pub(crate) variables: Vec<Variable>,
    pub(crate) body: Vec<Statement>,
}

/// A variable or a member of a type.
#[derive(Clone, Debug)]
pub(crate) struct Variable {
    pub(crate) name: String,
    pub(crate) kind: Kind,
    pub(crate) initial: Option<Initial>,
}

/// A type.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Kind {
    Real,
    Integer,
    Boolean,
    /// Sizes, and the type of the entries.
    Array(Vec<usize>, Box<Kind>),
    Named(String),
}

/// An initial value.
#[derive(Clone, Debug)]
pub(crate) enum Initial {
    Number(f64),
    Members(Vec<(String, Initial)>),
}

/// A statement.
#[derive(Debug)]
pub(crate) enum Statement {
    Assign(Vec<Step>, Expression),
    If(Vec<(Expression, Vec<Statement>)>),
}

/// A part of the path to a variable.
#[derive(Clone, Debug)]
pub(crate) enum Step {
    Name(String),
    Entry(Vec<usize>),
}

/// An expression.
#[derive(Debug)]
pub(crate) enum Expression {
    Real(f64),
    Integer(i64),
    Boolean(bool),
    Path(Vec<Step>),
    Unary(&'static str, Box<Expression>),
    Binary(&'static str, Box<[Expression; 2]>),
    Call(String, Vec<Expression>),
}
