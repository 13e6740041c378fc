//! The surface of a mechanism for users of the C: names, types, comments.

use linkage_compiler::ir::Shape;
use linkage_export::{Declarations, innermost};

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
    /// The types of vectors and frames that occur, each with its definition.
    pub(crate) fn vector_types(&self) -> Vec<String> {
        let Declarations {
            dimensions,
            functions,
            ..
        } = &self.declarations;
        let dimensions = dimensions.iter().map(|dimension| &dimension.member);
        let fields = functions.iter().flat_map(|function| &function.fields);
        let members = dimensions.chain(fields);
        let shapes: Vec<&Shape> = members.map(|member| innermost(member.shape)).collect();
        let number = self.real.name();
        let [xy, xyz, frame, plane_frame] = &self.vectors;
        let has = |wanted: &Shape| shapes.contains(&wanted);
        let [frames, plane_frames] = [Shape::Frame, Shape::PlaneFrame].map(|entry| has(&entry));
        let mut types = Vec::new();
        if has(&Shape::Vector(2)) || plane_frames {
            types.push(format!("typedef struct {xy} {{ {number} x, y; }} {xy};\n"));
        }
        if has(&Shape::Vector(3)) || frames {
            types.push(format!(
                "typedef struct {xyz} {{ {number} x, y, z; }} {xyz};\n"
            ));
        }
        if frames {
            types.push(format!(
                "typedef struct {frame} {{ {xyz} origin, x, y, z; }} {frame};\n"
            ));
        }
        if plane_frames {
            types.push(format!(
                "typedef struct {plane_frame} {{ {xy} origin, x, y; }} {plane_frame};\n"
            ));
        }
        types
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
