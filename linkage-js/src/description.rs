//! The description of a mechanism for the engine: its numbers and its programs, as an object of
//! JavaScript or as JSON.

use linkage_compiler::ir::{CompiledMechanism, Shape, plain};
use linkage_core::numeric::continuation::Axis;
use linkage_core::numeric::roots::Variable;
use linkage_core::range_check::Slack;
use linkage_export::{CoupledDeclaration, Declarations, FunctionDeclaration, InputDeclaration};
use linkage_symbolic::program::Program;

use crate::object::{Notation, Object, list, text};

/// The object of a mechanism.
pub(crate) fn description(declarations: &Declarations, notation: Notation) -> String {
    let Declarations { unit, .. } = declarations;
    let inputs = unit.inputs.len();
    let program = |input: &Program| notation.function(input, inputs);
    let modes = unit.modes().into_iter();
    let modes: Vec<f64> = modes.map(|plus| if plus { 1.0 } else { -1.0 }).collect();
    let references: Vec<f64> = unit.inputs.iter().map(|entry| entry.reference).collect();
    Object::new(notation)
        .with("name", text(declarations.title))
        .with("dimensions", dimensions(unit, notation))
        .with(
            "inputs",
            list(
                declarations
                    .inputs
                    .iter()
                    .map(|entry| input(entry, notation)),
            ),
        )
        .with(
            "arguments",
            list(unit.arguments.iter().map(|argument| {
                let argument = Object::new(notation)
                    .with("name", text(plain(&argument.name)))
                    .with("unit", text(&argument.unit));
                argument.text()
            })),
        )
        .with("reference", notation.numbers(&references))
        .with("modes", notation.numbers(&modes))
        .with("groups", groups(unit, notation))
        .with("angles", angles(unit, notation))
        .with(
            "coupled",
            list(
                declarations
                    .coupled
                    .iter()
                    .map(|group| coupled(unit, group, notation)),
            ),
        )
        .with(
            "functions",
            list(
                declarations
                    .functions
                    .iter()
                    .map(|item| evaluator(item, inputs, notation)),
            ),
        )
        .with("slots", unit.prepare.outputs.len().to_string())
        .with("bearingNumbers", unit.bearings.outputs.len().to_string())
        .with("prepare", notation.preparation(&unit.prepare, inputs))
        .with("bearings", notation.preparation(&unit.bearings, inputs))
        .with("directions", program(&unit.directions))
        .with("gaps", program(&unit.gaps))
        .with("slacks", program(&unit.slacks()))
        .text()
}

fn dimensions(unit: &CompiledMechanism, notation: Notation) -> String {
    list(unit.scalars().map(|scalar| {
        Object::new(notation)
            .with("name", text(&scalar.name))
            .with("unit", text(&scalar.unit))
            .with("value", notation.literal(scalar.nominal))
            .with("tolerance", notation.literal(scalar.tolerance))
            .text()
    }))
}

fn input(declaration: &InputDeclaration, notation: Notation) -> String {
    let declared = declaration.input;
    let range = declared
        .range
        .map(|(low, high)| notation.numbers(&[low, high]));
    Object::new(notation)
        .with("name", text(declaration.name))
        .with("unit", text(&declared.unit))
        .with("angle", declared.angle.to_string())
        .with("reference", notation.literal(declared.reference))
        .with("range", range.unwrap_or_else(|| "null".to_owned()))
        .with(
            "followed",
            notation.numbers(&[declared.followed.0, declared.followed.1]),
        )
        .with("rates", notation.numbers(&declared.rates))
        .text()
}

fn groups(unit: &CompiledMechanism, notation: Notation) -> String {
    list(unit.groups.iter().map(|group| {
        let described = Object::new(notation)
            .with("kind", text(&group.kind))
            .with("loops", list(group.loops.iter().map(usize::to_string)));
        let described = match &group.joints[..] {
            "" => described,
            joints => described.with("joints", text(joints)),
        };
        described
            .with(
                "unknowns",
                list(group.unknowns.iter().map(|name| text(plain(name)))),
            )
            .with("unit", text(&group.gap_unit))
            .with("slack", text(slack(group.slack)))
            .with(
                "dimensions",
                list(group.parameters.iter().map(usize::to_string)),
            )
            .text()
    }))
}

fn slack(kind: Slack) -> &'static str {
    match kind {
        Slack::Number => "number",
        Slack::Relative => "relative",
        Slack::Signed => "signed",
        Slack::Prepared => "prepared",
    }
}

fn angles(unit: &CompiledMechanism, notation: Notation) -> String {
    list(unit.angles.iter().map(|angle| {
        let phases = angle.phases.iter().map(|phase| {
            let turns = phase.turns.as_ref();
            turns.map_or_else(|| "null".to_owned(), |turns| notation.numbers(turns))
        });
        Object::new(notation)
            .with("name", text(plain(&unit.unknowns[angle.unknown].name)))
            .with("estimate", notation.literal(angle.estimate))
            .with("inputs", list(angle.inputs.iter().map(usize::to_string)))
            .with("phases", list(phases))
            .text()
    }))
}

/// A group without a closed form, with its state at the reference inputs.
fn coupled(
    unit: &CompiledMechanism,
    declaration: &CoupledDeclaration,
    notation: Notation,
) -> String {
    let group = declaration.group;
    let lengths = group.variables.iter().flat_map(|variable| match variable {
        Variable::Unit => &[false, false][..],
        Variable::Length => &[true],
        Variable::Number => &[false],
        Variable::Point => &[true, true],
        Variable::Conjugate => &[],
    });
    let references = group.inputs.iter();
    let references = references.map(|&input| unit.inputs[input].reference);
    let (state, floor) = declaration.state(&references.collect::<Vec<_>>());
    let Some(states) = &declaration.states else {
        unreachable!("what is printed has been closed")
    };
    Object::new(notation)
        .with("group", group.group.to_string())
        .with("inputs", list(group.inputs.iter().map(usize::to_string)))
        .with("size", group.size.to_string())
        .with("turning", group.turning.to_string())
        .with("lengths", list(lengths.map(bool::to_string)))
        .with(
            "axes",
            list(states.axes().iter().map(|along| axis(along, notation))),
        )
        .with("state", notation.numbers(&state))
        .with("determinant", notation.literal(2.0 * floor))
        .with(
            "correct",
            notation.function(&group.correct, unit.inputs.len()),
        )
        .text()
}

fn axis(along: &Axis, notation: Notation) -> String {
    Object::new(notation)
        .with("middle", notation.literal(along.middle))
        .with("length", notation.literal(along.length))
        .with("repeats", notation.literal(along.turns))
        .text()
}

fn evaluator(declaration: &FunctionDeclaration, inputs: usize, notation: Notation) -> String {
    let called = declaration.function;
    let program = &called.called.program;
    let columns = called.columns.iter().map(|column| {
        Object::new(notation)
            .with("name", text(&column.name))
            .with("unit", text(&column.unit))
            .text()
    });
    let fields = declaration.fields.iter();
    let fields = fields.map(|field| list([text(&field.name), shape(field.shape)].into_iter()));
    let arguments = declaration.arguments.iter();
    Object::new(notation)
        .with("name", text(&declaration.items[0]))
        .with(
            "arguments",
            list(arguments.map(|argument| argument.index.to_string())),
        )
        .with("coupled", (!called.states.is_empty()).to_string())
        .with("columns", list(columns))
        .with("fields", list(fields))
        .with("run", notation.function(program, inputs))
        .text()
}

/// Returns `null` for a number, else a list of the count and the shape of an entry.
fn shape(declared: &Shape) -> String {
    let number = || "null".to_owned();
    let many = |count: &usize, entry| list([count.to_string(), entry].into_iter());
    match declared {
        Shape::Scalar => number(),
        Shape::Vector(count) => many(count, number()),
        Shape::Array(count, entry) => many(count, shape(entry)),
        Shape::Frame => many(&4, many(&3, number())),
        Shape::PlaneFrame => many(&3, many(&2, number())),
    }
}
