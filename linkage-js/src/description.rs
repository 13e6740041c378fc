//! What the engine knows of a mechanism: its numbers and its programs, as an object of JavaScript.

use linkage_compiler::ir::{CompiledMechanism, Coupled, Function, Input, Shape, Start, plain};
use linkage_core::numeric::continuation::Axis;
use linkage_core::numeric::roots::Variable;
use linkage_core::range_check::Slack;
use linkage_symbolic::program::Program;

use crate::instruction::{function, literal};
use crate::object::{Object, list, numbers, text};

/// A mechanism that is called `name`.
pub(crate) fn description(name: &str, unit: &CompiledMechanism) -> String {
    let inputs = unit.inputs.len();
    let program = |own: &Program| function(own, inputs);
    let modes = unit.modes().into_iter();
    let modes: Vec<f64> = modes.map(|plus| if plus { 1.0 } else { -1.0 }).collect();
    let references: Vec<f64> = unit.inputs.iter().map(|own| own.reference).collect();
    Object::new()
        .with("name", text(name))
        .with("dimensions", dimensions(unit))
        .with("inputs", list(unit.inputs.iter().map(input)))
        .with(
            "arguments",
            list(unit.arguments.iter().map(|own| {
                let own = Object::new()
                    .with("name", text(plain(&own.name)))
                    .with("unit", text(&own.unit));
                own.text()
            })),
        )
        .with("reference", numbers(&references))
        .with("modes", numbers(&modes))
        .with("groups", groups(unit))
        .with("angles", angles(unit))
        .with(
            "coupled",
            list((0..unit.coupled.len()).map(|number| coupled(unit, number))),
        )
        .with(
            "functions",
            list(unit.functions.iter().map(|own| evaluator(own, inputs))),
        )
        .with("slots", unit.prepare.outputs.len().to_string())
        .with("bearingNumbers", unit.bearings.outputs.len().to_string())
        .with(
            "prepare",
            format!(
                "(own, out) => ({})(own, null, null, out)",
                program(&unit.prepare)
            ),
        )
        .with(
            "bearings",
            format!(
                "(own, out) => ({})(own, null, null, out)",
                program(&unit.bearings)
            ),
        )
        .with("directions", program(&unit.directions))
        .with("gaps", program(&unit.gaps))
        .with("slacks", program(&unit.slacks()))
        .text()
}

fn dimensions(unit: &CompiledMechanism) -> String {
    list(unit.scalars().map(|own| {
        Object::new()
            .with("name", text(&own.name))
            .with("unit", text(&own.unit))
            .with("value", literal(own.nominal))
            .with("tolerance", literal(own.tolerance))
            .text()
    }))
}

fn input(own: &Input) -> String {
    let range = own.range.map(|(low, high)| numbers(&[low, high]));
    Object::new()
        .with("name", text(plain(&own.name)))
        .with("unit", text(&own.unit))
        .with("angle", own.angle.to_string())
        .with("reference", literal(own.reference))
        .with("range", range.unwrap_or_else(|| "null".to_owned()))
        .with("followed", numbers(&[own.followed.0, own.followed.1]))
        .with("rates", numbers(&own.rates))
        .text()
}

fn groups(unit: &CompiledMechanism) -> String {
    list(unit.groups.iter().map(|own| {
        Object::new()
            .with("kind", text(&own.kind))
            .with("loops", list(own.loops.iter().map(usize::to_string)))
            .with(
                "unknowns",
                list(own.unknowns.iter().map(|name| text(plain(name)))),
            )
            .with("unit", text(&own.gap_unit))
            .with("slack", text(slack(own.slack)))
            .with(
                "dimensions",
                list(own.parameters.iter().map(usize::to_string)),
            )
            .text()
    }))
}

fn slack(own: Slack) -> &'static str {
    match own {
        Slack::Number => "number",
        Slack::Relative => "relative",
        Slack::Signed => "signed",
        Slack::Prepared => "prepared",
    }
}

fn angles(unit: &CompiledMechanism) -> String {
    list(unit.angles.iter().map(|own| {
        let phases = own.phases.iter().map(|phase| {
            let turns = phase.turns.as_ref();
            turns.map_or_else(|| "null".to_owned(), |turns| numbers(turns))
        });
        Object::new()
            .with("name", text(plain(&unit.unknowns[own.unknown].name)))
            .with("estimate", literal(own.estimate))
            .with("inputs", list(own.inputs.iter().map(usize::to_string)))
            .with("phases", list(phases))
            .text()
    }))
}

/// A group without a closed form, with its state at the reference inputs.
fn coupled(unit: &CompiledMechanism, number: usize) -> String {
    let own = &unit.coupled[number];
    let lengths = own.variables.iter().flat_map(|variable| match variable {
        Variable::Unit => &[false, false][..],
        Variable::Length => &[true],
        Variable::Number => &[false],
        Variable::Point => &[true, true],
        Variable::Conjugate => &[],
    });
    let (axes, state, floor) = start(unit, own);
    Object::new()
        .with("group", own.group.to_string())
        .with("inputs", list(own.inputs.iter().map(usize::to_string)))
        .with("size", own.size.to_string())
        .with("turning", own.turning.to_string())
        .with("lengths", list(lengths.map(bool::to_string)))
        .with("axes", list(axes.iter().map(axis)))
        .with("state", numbers(&state))
        .with("determinant", literal(2.0 * floor))
        .with("correct", function(&own.correct, unit.inputs.len()))
        .text()
}

/// The ranges of its inputs, its state at the reference inputs, half of a determinant near it.
fn start(unit: &CompiledMechanism, own: &Coupled) -> (Vec<Axis>, Vec<f64>, f64) {
    let at: Vec<f64> = own
        .inputs
        .iter()
        .map(|&input| unit.inputs[input].reference)
        .collect();
    let mut state = vec![f64::NAN; own.size];
    match &own.start {
        Some(Start::Table(table)) => {
            let floor = table.state(at[0], &mut state);
            (vec![table.layout().axis], state, floor)
        }
        Some(Start::Grid(grid)) => {
            let floor = grid.state(&at, &mut state);
            (grid.layout().axes, state, floor)
        }
        None => unreachable!("what is printed has been closed"),
    }
}

fn axis(own: &Axis) -> String {
    Object::new()
        .with("middle", literal(own.middle))
        .with("length", literal(own.length))
        .with("repeats", literal(own.turns))
        .text()
}

fn evaluator(own: &Function, inputs: usize) -> String {
    let program = &own.called.program;
    let columns = own.columns.iter().map(|column| {
        Object::new()
            .with("name", text(&column.name))
            .with("unit", text(&column.unit))
            .text()
    });
    let fields = own.fields.iter();
    let fields =
        fields.map(|field| list([text(plain(&field.name)), shape(&field.shape)].into_iter()));
    Object::new()
        .with("name", text(plain(&own.name)))
        .with(
            "arguments",
            list(own.arguments.iter().map(usize::to_string)),
        )
        .with("coupled", (!own.states.is_empty()).to_string())
        .with("columns", list(columns))
        .with("fields", list(fields))
        .with("run", function(program, inputs))
        .text()
}

/// `null` for a number, else how many of what.
fn shape(own: &Shape) -> String {
    let number = || "null".to_owned();
    let many = |count: &usize, entry| list([count.to_string(), entry].into_iter());
    match own {
        Shape::Scalar => number(),
        Shape::Vector(count) => many(count, number()),
        Shape::Array(count, entry) => many(count, shape(entry)),
        Shape::Frame => many(&4, many(&3, number())),
        Shape::PlaneFrame => many(&3, many(&2, number())),
    }
}
