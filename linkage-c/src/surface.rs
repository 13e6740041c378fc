//! What users of the C see: names, types, comments.

mod evaluator;
mod notes;

use linkage_compiler::ir::{COMPONENTS, CompiledMechanism, Function, Shape};

use self::evaluator::{Scope, evaluator};
use self::notes::dimension_note;
use crate::Real;
use crate::checks::{CONSTANTS, FINITE_MATH};
use crate::names::{self, Names, Place, plain, snake_letters};
use crate::refusal::{Code, Why, codes};
use crate::renamed::{Log, Renamed};
use crate::{range, shape::innermost};

/// The names and types of a mechanism in C.
#[derive(Debug)]
pub(crate) struct Surface<'a> {
    pub(crate) unit: &'a CompiledMechanism,
    pub(crate) real: Real,
    /// As the user called it.
    pub(crate) title: String,
    /// What all names begin with; also that of the struct.
    pub(crate) prefix: String,
    /// The beginning of names in the source alone.
    pub(crate) own: String,
    pub(crate) dimensions: Vec<Dimension<'a>>,
    /// Expressions of the scalars of all dimensions, behind that of the struct and a point.
    pub(crate) scalars: Vec<String>,
    pub(crate) functions: Vec<Evaluator<'a>>,
    /// What `assemble` may return, after 0.
    pub(crate) codes: Vec<Code>,
    pub(crate) assemble: String,
    pub(crate) error: String,
    pub(crate) range: range::Names,
    /// The function that checks a number.
    pub(crate) ok: String,
    /// A type that exists where constants have all their digits.
    pub(crate) constants: String,
    pub(crate) dimensions_type: String,
    /// Names of the declaration that have another form.
    pub(crate) renamed: Vec<Renamed>,
    vectors: [String; 4],
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
    pub(crate) name: String,
    pub(crate) result: String,
    pub(crate) sweep: Option<String>,
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

/// The ends of constants and macros that each mechanism has.
const CONSTANTS_OF_ALL: [&str; 5] = ["ok", "defaults", "h", FINITE_MATH, range::OFF];

/// Components of frames.
const OF_FRAME: [&str; 4] = ["origin", "x", "y", "z"];

impl<'a> Surface<'a> {
    pub(crate) fn new(title: &str, unit: &'a CompiledMechanism, real: Real) -> Self {
        let prefix = names::prefix(title, |prefix| {
            let codes = codes(title, prefix, unit).into_iter().map(|own| own.name);
            let others = CONSTANTS_OF_ALL.map(|name| constant(prefix, name));
            codes.chain(others).collect()
        });
        let mut renamed = Log::default();
        let usual = snake_letters(title);
        renamed.note(|| format!("the mechanism `{title}`"), &usual, &prefix);
        let mut names = Names::new(Place::File, &[&prefix]);
        let mut global = |name: &str| names.take(&format!("{prefix}_{name}"));
        let [dimensions_type, assemble, error, ok, constants] =
            ["dimensions", "assemble", "error", "ok", CONSTANTS].map(&mut global);
        let vectors = ["xy", "xyz", "frame", "plane_frame"].map(&mut global);
        // A member of C++ is not called like the type of another one.
        let types: Vec<&str> = vectors.iter().map(String::as_str).collect();
        let functions = unit.functions.iter();
        let functions = functions.map(|own| {
            let scope = Scope {
                unit,
                prefix: &prefix,
                types: &types,
            };
            evaluator(scope, own, &mut global, &mut renamed)
        });
        let functions: Vec<Evaluator<'a>> = functions.collect();
        // After the functions: a user's function of one of these names keeps it.
        let range = range::Names::new(&mut global);
        let arguments = functions.iter().flat_map(|own| &own.arguments);
        let own = names.unused_beginning(&format!("{prefix}_own_"), arguments);
        let mut fields = Names::new(Place::Struct, &types);
        let dimensions: Vec<Dimension<'a>> = unit
            .parameters
            .iter()
            .map(|parameter| {
                // Of a part's parameter: `hook_crank`.
                let usual = parameter.name.replace('.', "_");
                let name = fields.take(&usual);
                renamed.note(
                    || format!("the parameter `{}`", parameter.name),
                    &usual,
                    &name,
                );
                Dimension {
                    name,
                    documentation: &parameter.documentation,
                    shape: parameter.shape.clone(),
                    note: dimension_note(&parameter.scalars),
                    values: parameter.scalars.iter().map(|own| own.nominal).collect(),
                }
            })
            .collect();
        let scalars = dimensions.iter();
        let scalars = scalars
            .flat_map(|own| places(&own.name, &own.shape))
            .collect();
        Self {
            codes: codes(title, &prefix, unit),
            title: plain(title),
            unit,
            real,
            own,
            dimensions,
            scalars,
            functions,
            assemble,
            error,
            range,
            ok,
            constants,
            dimensions_type,
            renamed: renamed.0,
            vectors,
            prefix,
        }
    }

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
        let dimensions = self.dimensions.iter().map(|own| &own.shape);
        let fields = self.functions.iter().flat_map(|own| &own.fields);
        let shapes: Vec<&Shape> = dimensions
            .chain(fields.map(|own| &own.shape))
            .map(innermost)
            .collect();
        let number = self.real.name();
        let [xy, xyz, frame, plane_frame] = &self.vectors;
        let has = |wanted: &Shape| shapes.contains(&wanted);
        let [frames, plane_frames] = [Shape::Frame, Shape::PlaneFrame].map(|own| has(&own));
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
        let of_functions = self.functions.iter().flat_map(|own| {
            let both = [&own.name, &own.result].into_iter();
            both.chain(&own.sweep).cloned()
        });
        let constants = CONSTANTS_OF_ALL.map(|name| self.constant(name));
        let others = [
            &self.prefix,
            &self.dimensions_type,
            &self.assemble,
            &self.error,
            &self.ok,
            &self.constants,
        ];
        let others = others.into_iter().chain(&self.vectors).cloned();
        let codes = self.codes.iter().map(|own| own.name.clone());
        others
            .chain(self.range.all(self))
            .chain(of_functions)
            .chain(codes)
            .chain(constants)
            .collect()
    }

    /// The number for a reason.
    pub(crate) fn code(&self, why: Why) -> usize {
        let place = self.codes.iter().position(|own| own.why == why);
        place.map_or(0, |place| place + 1)
    }

    /// The name of a constant or a macro.
    pub(crate) fn constant(&self, name: &str) -> String {
        constant(&self.prefix, name)
    }
}

fn constant(prefix: &str, name: &str) -> String {
    format!("{prefix}_{}", plain(name)).to_uppercase()
}

/// Expressions of all scalars of something, in the order in which programs count them.
pub(crate) fn places(name: &str, shape: &Shape) -> Vec<String> {
    match shape {
        Shape::Scalar => vec![name.to_owned()],
        Shape::Vector(count) => COMPONENTS[..*count]
            .iter()
            .map(|axis| format!("{name}.{axis}"))
            .collect(),
        Shape::Array(count, entry) => {
            let entries = (0..*count).flat_map(|k| places(&format!("{name}[{k}]"), entry));
            entries.collect()
        }
        Shape::Frame => {
            let vectors = OF_FRAME.iter();
            let vectors =
                vectors.flat_map(|own| places(&format!("{name}.{own}"), &Shape::Vector(3)));
            vectors.collect()
        }
        Shape::PlaneFrame => {
            let vectors = OF_FRAME[..3].iter();
            let vectors =
                vectors.flat_map(|own| places(&format!("{name}.{own}"), &Shape::Vector(2)));
            vectors.collect()
        }
    }
}
