//! The surface of a mechanism for users of the C: names, types, comments.

use linkage_compiler::ir::{CompiledMechanism, Shape};
use linkage_export::Declarations;

use super::constant::{CONSTANTS_OF_ALL, constant};
use super::declared::Declared;
use super::evaluator::Evaluator;
use super::range_names::{RangeNames, kind_constant};
use super::refusal::{Code, Why};
use crate::real::Real;

/// The names and types of a mechanism in C.
#[derive(Debug)]
pub(crate) struct Surface<'a> {
    /// The declarations; their name is the beginning of all names, and that of the struct.
    pub(crate) declarations: Declarations<'a>,
    pub(crate) real: Real,
    /// The name in the declaration, in letters of C.
    pub(crate) title: String,
    /// The signatures of the functions, in the order of the declarations.
    pub(crate) functions: Vec<Evaluator>,
    /// The results of `assemble`, after 0.
    pub(crate) codes: Vec<Code>,
    pub(crate) assemble: Declared,
    /// The function that returns the size of the struct of the mechanism.
    pub(crate) assembly_size: Declared,
    pub(crate) error: Declared,
    pub(crate) range: RangeNames,
    /// The function that checks a number.
    pub(crate) ok: Declared,
    /// A type that exists where constants have all their digits.
    pub(crate) constants: String,
    pub(crate) dimensions_type: String,
    pub(super) vectors: [String; 4],
}

impl Surface<'_> {
    /// The compiled mechanism, the beginning of all public names, and that of private ones.
    pub(crate) fn unit_and_prefixes(&self) -> (&CompiledMechanism, &str, &str) {
        let declarations = &self.declarations;
        (declarations.unit, &declarations.name, &declarations.private)
    }

    /// The types of vectors and frames that occur, each with its definition.
    pub(crate) fn vector_types(&self) -> Vec<String> {
        let types = self.declarations.types.iter().map(|declared| {
            let (name, members) = (&self.vectors[declared.number], declared.members.join(", "));
            let entry = match declared.entry {
                Shape::Vector(count) => &self.vectors[count - 2],
                _ => self.real.name(),
            };
            format!("typedef struct {name} {{ {entry} {members}; }} {name};\n")
        });
        types.collect()
    }

    /// All names that other files see.
    pub(crate) fn names(&self) -> Vec<String> {
        let of_functions = self.functions.iter().flat_map(|function| {
            let both = [&function.declared.name, &function.result].into_iter();
            both.chain(function.sweep.as_ref().map(|sweep| &sweep.name))
                .cloned()
        });
        let constants = CONSTANTS_OF_ALL.map(|name| self.constant(name));
        let prefix = &self.declarations.name;
        let others = [
            prefix,
            &self.dimensions_type,
            &self.assemble.name,
            &self.assembly_size.name,
            &self.error.name,
            &self.ok.name,
            &self.constants,
        ];
        let others = others.into_iter().chain(&self.vectors).cloned();
        let codes = self.codes.iter().map(|code| code.name.clone());
        others
            .chain(self.range.all(prefix))
            .chain(of_functions)
            .chain(codes)
            .chain(constants)
            .collect()
    }

    /// The number for a reason.
    pub(crate) fn code(&self, why: impl Into<Why>) -> usize {
        let why = why.into();
        let index = self.codes.iter().position(|entry| entry.why == why);
        index.map_or(0, |index| index + 1)
    }

    /// The name of a constant or a macro.
    pub(crate) fn constant(&self, name: &str) -> String {
        constant(&self.declarations.name, name)
    }

    /// The name of the constant of a kind of finding in a range.
    pub(crate) fn kind(&self, kind: &str) -> String {
        kind_constant(&self.declarations.name, kind)
    }
}
