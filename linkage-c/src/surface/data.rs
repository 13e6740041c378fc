//! The surface of a mechanism for users of the C: names, types, comments.

use linkage_compiler::ir::{CompiledMechanism, Function, Shape};

use super::constant::constant;
use super::declared::Declared;
use super::places::innermost;
use super::range_names::{OFF, RangeNames, kind_constant};
use super::refusal::{Code, Why};
use super::renamed::Renamed;
use crate::real::Real;

/// The names and types of a mechanism in C.
#[derive(Debug)]
pub(crate) struct Surface<'a> {
    pub(crate) unit: &'a CompiledMechanism,
    pub(crate) real: Real,
    /// The name in the declaration.
    pub(crate) title: String,
    /// The beginning of all names; also that of the struct.
    pub(crate) prefix: String,
    /// The beginning of names in the source alone.
    pub(crate) private: String,
    pub(crate) dimensions: Vec<Dimension<'a>>,
    /// Expressions of the scalars of all dimensions, behind that of the struct and a point.
    pub(crate) scalars: Vec<String>,
    pub(crate) functions: Vec<Evaluator<'a>>,
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
    /// Names of the declaration that have another form.
    pub(crate) renamed: Vec<Renamed>,
    pub(super) vectors: [String; 4],
}

/// A field of the struct of dimensions.
#[derive(Debug)]
pub(crate) struct Dimension<'a> {
    pub(crate) name: String,
    pub(crate) documentation: &'a str,
    pub(crate) shape: Shape,
    pub(crate) note: String,
    /// The default values.
    pub(crate) values: Vec<f64>,
}

/// A function of the user.
#[derive(Debug)]
pub(crate) struct Evaluator<'a> {
    pub(crate) function: &'a Function,
    pub(crate) declared: Declared,
    pub(crate) result: String,
    pub(crate) sweep: Option<Declared>,
    /// Names of the arguments in the function's order.
    pub(crate) arguments: Vec<String>,
    pub(crate) argument_notes: Vec<String>,
    pub(crate) fields: Vec<Field<'a>>,
}

/// A field of a result.
#[derive(Debug)]
pub(crate) struct Field<'a> {
    pub(crate) name: String,
    pub(crate) documentation: &'a str,
    pub(crate) shape: Shape,
    pub(crate) note: String,
}

/// The end of the macro that lets a file with finite mathematics include the header.
pub(crate) const FINITE_MATH: &str = "finite_math";

/// The end of the name of a type that exists where constants have all their digits: compilers print
/// it.
pub(super) const CONSTANTS: &str = "is_not_for_fsingle_precision_constant";

/// The ends of constants and macros that each mechanism has.
pub(super) const CONSTANTS_OF_ALL: [&str; 5] = ["ok", "defaults", "h", FINITE_MATH, OFF];

impl<'a> Surface<'a> {
    /// A declaration without the semicolon: `double e[3]`, `favorit_xy p`.
    pub(crate) fn declared(&self, name: &str, shape: &Shape) -> String {
        let [xy, xyz, frame, plane_frame] = &self.vectors;
        match shape {
            Shape::Scalar => format!("{} {name}", self.real.name()),
            Shape::Vector(2) => format!("{xy} {name}"),
            Shape::Vector(_) => format!("{xyz} {name}"),
            Shape::Frame => format!("{frame} {name}"),
            Shape::PlaneFrame => format!("{plane_frame} {name}"),
            Shape::Array(count, entry) => self.declared(&format!("{name}[{count}]"), entry),
        }
    }

    /// The types of vectors and frames that occur, each with its definition.
    pub(crate) fn vector_types(&self) -> Vec<String> {
        let dimensions = self.dimensions.iter().map(|dimension| &dimension.shape);
        let fields = self.functions.iter().flat_map(|function| &function.fields);
        let shapes: Vec<&Shape> = dimensions
            .chain(fields.map(|field| &field.shape))
            .map(innermost)
            .collect();
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
        let others = [
            &self.prefix,
            &self.dimensions_type,
            &self.assemble.name,
            &self.error.name,
            &self.ok.name,
            &self.constants,
        ];
        let others = others.into_iter().chain(&self.vectors).cloned();
        let codes = self.codes.iter().map(|code| code.name.clone());
        others
            .chain(self.range.all(&self.prefix))
            .chain(of_functions)
            .chain(codes)
            .chain(constants)
            .collect()
    }

    /// The number for a reason.
    pub(crate) fn code(&self, why: Why) -> usize {
        let index = self.codes.iter().position(|entry| entry.why == why);
        index.map_or(0, |index| index + 1)
    }

    /// The name of a constant or a macro.
    pub(crate) fn constant(&self, name: &str) -> String {
        constant(&self.prefix, name)
    }

    /// The name of the constant of a kind of finding in a range.
    pub(crate) fn kind(&self, kind: &str) -> String {
        kind_constant(&self.prefix, kind)
    }
}
