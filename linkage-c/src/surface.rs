//! What users of the C see: names, types, comments.

use linkage_compiler::unit::{COMPONENTS, Column, Function, Shape, Unit, in_degrees};

use crate::Real;
use crate::names::{Names, Place, plain, snake};
use crate::range;
use crate::refusal::{Code, Why, codes};
use crate::shape::innermost;

/// The names and types of a mechanism in C.
#[derive(Debug)]
pub(crate) struct Surface<'a> {
    pub(crate) unit: &'a Unit,
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
    pub(crate) dimensions_type: String,
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

/// Components of frames.
const OF_FRAME: [&str; 4] = ["origin", "x", "y", "z"];

impl<'a> Surface<'a> {
    pub(crate) fn new(title: &str, unit: &'a Unit, real: Real) -> Self {
        let prefix = Names::new(Place::File, &[]).take(&snake(title));
        let mut names = Names::new(Place::File, &[&prefix]);
        let mut global = |name: &str| names.take(&format!("{prefix}_{name}"));
        let [dimensions_type, assemble, error] =
            ["dimensions", "assemble", "error"].map(&mut global);
        let vectors = ["xy", "xyz", "frame", "plane_frame"].map(&mut global);
        let functions = unit.functions.iter();
        let functions = functions.map(|own| evaluator(unit, own, &mut global));
        let functions = functions.collect();
        // After the functions: a user's function of one of these names keeps it.
        let range = range::Names::new(&mut global);
        let own = names.unused_beginning(&format!("{prefix}_own_"));
        let mut fields = Names::new(Place::Struct, &[]);
        let dimensions: Vec<Dimension<'a>> = unit
            .parameters
            .iter()
            .map(|parameter| {
                // Of a part's parameter: `hook_crank`.
                let name = parameter.name.replace('.', "_");
                Dimension {
                    name: fields.take(&name),
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
            dimensions_type,
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

    /// The number for a reason.
    pub(crate) fn code(&self, why: Why) -> usize {
        let place = self.codes.iter().position(|own| own.why == why);
        place.map_or(0, |place| place + 1)
    }

    /// The name of a constant or a macro.
    pub(crate) fn constant(&self, name: &str) -> String {
        format!("{}_{}", self.prefix, plain(name)).to_uppercase()
    }
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

fn evaluator<'a>(
    unit: &Unit,
    function: &'a Function,
    global: &mut dyn FnMut(&str) -> String,
) -> Evaluator<'a> {
    let name = plain(&function.name);
    // What else the function has in scope.
    let mut scope = Names::new(
        Place::Function,
        &["m", "count", "results", "result", "k", "inputs"],
    );
    let mut arguments = Vec::new();
    let mut argument_notes = Vec::new();
    for &place in &function.arguments {
        let (name, note) = match place.checked_sub(unit.inputs.len()) {
            None => (&unit.inputs[place].name, input_note(unit, place)),
            Some(place) => {
                let own = &unit.arguments[place];
                (&own.name, own.unit.clone())
            }
        };
        arguments.push(scope.take(name));
        argument_notes.push(note);
    }
    let mut names = Names::new(Place::Struct, &[]);
    let mut columns = &function.columns[..];
    let fields = function.fields.iter().map(|field| {
        let (own, rest) = columns.split_at(field.shape.width());
        columns = rest;
        Field {
            name: names.take(&field.name),
            documentation: &field.documentation,
            note: field_note(field, own),
            shape: field.shape.clone(),
        }
    });
    Evaluator {
        fields: fields.collect(),
        result: global(&format!("{name}_result")),
        sweep: (!arguments.is_empty()).then(|| global(&format!("{name}_sweep"))),
        name: global(&name),
        function,
        arguments,
        argument_notes,
    }
}

/// `rad, from -90 deg to 630 deg`
fn input_note(unit: &Unit, place: usize) -> String {
    let input = &unit.inputs[place];
    let words = if input.angle { "rad" } else { &input.unit };
    match input.range {
        Some((low, high)) => {
            let [low, high] = [low, high].map(|end| in_degrees(end, words));
            format!("{words}, from {low} to {high}")
        }
        None => words.to_owned(),
    }
}

fn dimension_note(scalars: &[linkage_compiler::unit::Scalar]) -> String {
    let unit = match &scalars[0].unit[..] {
        "" => "a number",
        unit => unit,
    };
    let tolerances: Vec<String> = scalars
        .iter()
        .map(|own| in_degrees(own.tolerance, &own.unit))
        .collect();
    match scalars.iter().any(|own| own.tolerance != 0.0) {
        true => format!("{unit}; tolerance {}", tolerances.join(", ")),
        false => unit.to_owned(),
    }
}

/// What it is with its unit, and what the entries of an array are.
fn field_note(field: &linkage_compiler::unit::Field, columns: &[Column]) -> String {
    let about = match &field.told()[..] {
        "" => "a number".to_owned(),
        // In C there is no mark for names.
        about => about.strip_prefix("in ").unwrap_or(about).replace('`', ""),
    };
    match field.shape {
        Shape::Array(..) => {
            let names: Vec<&str> = columns.iter().map(|own| &own.name[..]).collect();
            format!("{about}: {}", names.join(", "))
        }
        Shape::Scalar | Shape::Vector(_) | Shape::Frame | Shape::PlaneFrame => about,
    }
}
