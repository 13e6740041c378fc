//! The items of the struct block.

use super::agreement::{common_type, mismatch_help};
use super::argument::{refuse_argument, resolve_arguments};
use super::embed::Embedding;
use super::expression::resolve_expression;
use super::frame_items::{refuse_frame_item, refuse_frame_loop};
use super::given::{check_field, resolve_part};
use super::library::Source;
use super::mechanics::resolve_mechanics;
use super::missing_units::{note_unitless, suspect_both_units};
use super::parameter::resolve_parameter;
use super::part::Parts;
use super::passes::{Coordinate, Definition, Passes};
use super::place::{Context, Place};
use super::plane_and_space::both_types;
use super::scalars::add_scalars;
use super::scope::Scope;
use super::sink::Sink;
use super::types::{
    Constant, Dimension, Expr, Input, LengthUnit, Let, Loop, Mechanism, Name, Type, Unknown,
};
use super::unknown_frame::resolve_unknown_frames;
use super::values::Values;
use crate::diagnostic::text::nearest;
use crate::syntax::{
    Attribute, InputItem, LoopItem, NamedItem, UnitItem, UnknownItem, Word, documentation,
};

/// All items, pass by pass.
pub(super) fn resolve_items(scope: &mut Scope, sink: &mut Sink, source: &Source) -> Mechanism {
    let definition = source.definition;
    let passes = Passes::of(definition);
    let unit = resolve_length_unit(sink, &passes.units);
    scope.units.length = source.unit.unwrap_or(unit);
    let mut mechanism = Mechanism {
        name: definition.name.to_string(),
        documentation: documentation(&definition.attributes),
        unit: scope.units.length,
        constants: Vec::new(),
        parameters: Vec::new(),
        scalar_parameters: Vec::new(),
        inputs: Vec::new(),
        unknowns: Vec::new(),
        lets: Vec::new(),
        loops: Vec::new(),
        redundant: Vec::new(),
        arguments: Vec::new(),
        parts: Vec::new(),
        leaves: Vec::new(),
        placed: Vec::new(),
        gravity: None,
        bodies: Vec::new(),
        joints: Vec::new(),
        loads: Vec::new(),
        elements: Vec::new(),
        evaluators: Vec::new(),
        origin: sink.add_origin((&definition.name).into()),
    };
    for (position, item) in passes.constants {
        let context = Context {
            place: Place::Constant,
            item: position,
        };
        let name = Name::Const(mechanism.constants.len());
        let value = resolve_named(scope, sink, item, name, context);
        let name = item.name.to_string();
        mechanism.constants.push(Constant { name, value });
    }
    for (index, (position, item)) in passes.parameters.into_iter().enumerate() {
        let mut parameter = resolve_parameter(scope, sink, item, index, position);
        let of_all = definition.attributes.iter();
        parameter.may_be_unused |= of_all.into_iter().any(Attribute::allows_unused);
        mechanism.parameters.push(parameter);
    }
    for (position, item) in passes.coordinates {
        match item {
            Coordinate::Input(item) => {
                let index = mechanism.inputs.len();
                mechanism
                    .inputs
                    .push(resolve_input(scope, sink, item, index, position));
            }
            Coordinate::Unknown(item) => {
                let index = mechanism.unknowns.len();
                let unknown = resolve_unknown(scope, sink, item, index, position);
                mechanism.unknowns.push(unknown);
            }
        }
    }
    let frames = resolve_unknown_frames(scope, sink, &passes.frames, &mut mechanism);
    mechanism.arguments = resolve_arguments(scope, sink, &passes.arguments, &mechanism.inputs);
    embed_coordinates(&scope.parts, &mut scope.values, sink, &mut mechanism);
    for (position, item) in passes.definitions {
        let context = Context {
            place: Place::LetOrLoop,
            item: position,
        };
        match item {
            Definition::Let(item) => {
                let name = Name::Let(mechanism.lets.len());
                let value = resolve_named(scope, sink, item, name, context);
                scope.values.note_let(&value);
                let name = item.name.to_string();
                mechanism.lets.push(Let {
                    name,
                    value,
                    is_unknown_frame: false,
                });
            }
            Definition::Loop(item) => {
                let own = resolve_loop(scope, sink, item, context);
                match item.redundant {
                    true => mechanism.redundant.push(own),
                    false => mechanism.loops.push(own),
                }
            }
            Definition::Part(item) => resolve_part(scope, sink, item, position, &mut mechanism),
        }
    }
    mechanism.close_frames(frames);
    mechanism.placed.clone_from(&scope.parts.placed);
    resolve_mechanics(
        scope,
        sink,
        &passes.bodies,
        &passes.mechanics,
        &passes.parts,
        &mut mechanism,
    );
    mechanism
        .scalar_parameters
        .clone_from(&scope.values.scalar_parameters);
    mechanism
}

/// What parts bring that does not depend on what they are given.
fn embed_coordinates(
    parts: &Parts,
    values: &mut Values,
    sink: &mut Sink,
    mechanism: &mut Mechanism,
) {
    for part in 0..parts.scopes.len() {
        let own = Embedding::new(&parts.scopes[part], &mechanism.lets, &[]);
        let Some(embedding) = own else { continue };
        mechanism.constants.extend(embedding.constants());
        mechanism.unknowns.extend(embedding.unknowns());
        for mut own in embedding.parameters() {
            let index = mechanism.parameters.len();
            own.first_scalar = add_scalars(values, &own.name, index, &own.ty);
            check_field(parts, sink, &own.name, part, &mechanism.parameters);
            mechanism.parameters.push(own);
        }
    }
}

fn resolve_length_unit(sink: &mut Sink, items: &[&UnitItem]) -> LengthUnit {
    let Some((first, others)) = items.split_first() else {
        return LengthUnit::Metre;
    };
    for item in others {
        let help = "leave one of them out";
        sink.error_with_help(item.span, "a second `unit`", help);
        sink.error(first.span, "`unit` is first given here");
    }
    let text = first.unit.to_string();
    LengthUnit::from_name(&text).unwrap_or_else(|| {
        let names: Vec<&str> = LengthUnit::all().map(LengthUnit::word).collect();
        let help = match nearest(&text, names.iter().copied()) {
            Some(name) => format!("did you mean `{name}`?"),
            None => format!("length units are {}", names.join(" ")),
        };
        let fact = format!("`{text}` is not a length unit");
        sink.error_with_help((&first.unit).into(), fact, help);
        LengthUnit::Metre
    })
}

/// Value of a constant or `let`. Zero stays zero: it fits every dimension under its name, too.
fn resolve_named(
    scope: &mut Scope,
    sink: &mut Sink,
    item: &NamedItem,
    name: Name,
    context: Context,
) -> Expr {
    let value = resolve_expression(scope, sink, &item.value, context);
    note_unitless(&scope.names, &mut scope.units, sink, name, &value, None);
    let ty = match scope.units.is_taken_for_length(name) {
        true => scope.units.declared(name, &value.ty),
        false => value.ty.clone(),
    };
    scope.names.set_type(name, ty, false);
    value
}

fn resolve_input(
    scope: &mut Scope,
    sink: &mut Sink,
    item: &InputItem,
    index: usize,
    position: usize,
) -> Input {
    let context = Context {
        place: Place::Input,
        item: position,
    };
    let mut reference = resolve_expression(scope, sink, &item.value, context);
    let mut range = item.range.as_ref().map(|(low, high)| {
        (
            resolve_expression(scope, sink, low, context),
            resolve_expression(scope, sink, high, context),
        )
    });
    refuse_frame_item(sink, &mut reference, "an input is an angle or a length");
    let mut all: Vec<&mut Expr> = vec![&mut reference];
    if let Some((low, high)) = &mut range {
        all.extend([low, high]);
    }
    let ty = common_type(
        &scope.names,
        &scope.units,
        sink,
        &mut all,
        "the reference and the range of an input",
    );
    let bare_zero = all.iter().all(|value| matches!(value.ty, Type::Zero(_)));
    let ty = scope.units.declared(Name::Input(index), &ty);
    all.into_iter().for_each(|value| value.settle(&ty));
    let beside = range.as_ref().map(|_| "the range");
    note_unitless(
        &scope.names,
        &mut scope.units,
        sink,
        Name::Input(index),
        &reference,
        beside,
    );
    let dimension = match &ty {
        Type::Scalar(dimension) => check_coordinate(sink, *dimension, "an input", &item.value),
        Type::Error => None,
        other => {
            let fact = format!("an input is an angle or a length, found {other}");
            let help = "declare one input for each coordinate";
            sink.error_with_help(item.value.span, fact, help);
            None
        }
    };
    let ty = dimension.map_or(Type::Error, Type::Scalar);
    scope.names.set_type(Name::Input(index), ty, bare_zero);
    Input {
        name: item.name.to_string(),
        dimension: dimension.unwrap_or(Dimension::NUMBER),
        reference,
        range,
        speed: scope.values.rates[index][0],
        acceleration: scope.values.rates[index][1],
        origin: sink.add_origin((&item.name).into()),
    }
}

fn resolve_unknown(
    scope: &mut Scope,
    sink: &mut Sink,
    item: &UnknownItem,
    index: usize,
    position: usize,
) -> Unknown {
    let name = Name::Unknown(index);
    let (ty, bare_zero, estimate) = match &item.estimate {
        Some(value) => {
            let context = Context {
                place: Place::Estimate,
                item: position,
            };
            let mut estimate = resolve_expression(scope, sink, value, context);
            refuse_frame_item(
                sink,
                &mut estimate,
                "an unknown is an angle, a length or a point",
            );
            let bare_zero = matches!(estimate.ty, Type::Zero(_));
            let mut ty = scope.units.declared(name, &estimate.ty);
            estimate.settle(&ty);
            note_unitless(&scope.names, &mut scope.units, sink, name, &estimate, None);
            if let Some(dimension) = ty.dimension()
                && check_coordinate(sink, dimension, "an unknown", value).is_none()
            {
                ty = Type::Error;
            }
            (ty, bare_zero, Some(estimate))
        }
        None => (
            scope.units.declared(name, &scope.units.zeros.zero_of(name)),
            true,
            None,
        ),
    };
    scope.names.set_type(name, ty.clone(), bare_zero);
    let origin = sink.add_origin((&item.name).into());
    Unknown {
        name: item.name.to_string(),
        ty,
        estimate,
        of_part: false,
        origin,
    }
}

/// Inputs and unknowns are angles (or numbers) and lengths.
fn check_coordinate(
    sink: &mut Sink,
    dimension: Dimension,
    what: &str,
    value: &crate::syntax::Expr,
) -> Option<Dimension> {
    if dimension.is_number_or_angle() || dimension.fits(Dimension::LENGTH) {
        return Some(dimension);
    }
    let fact = format!("{what} is an angle or a length, found {dimension}");
    sink.error_with_help(value.span, fact, "use another coordinate");
    None
}

fn resolve_loop(scope: &Scope, sink: &mut Sink, item: &LoopItem, context: Context) -> Loop {
    let mut left = resolve_expression(scope, sink, &item.left, context);
    let mut right = resolve_expression(scope, sink, &item.right, context);
    let origin = sink.add_origin(item.span);
    refuse_argument(&scope.names, &scope.values, sink, &mut left, "a loop");
    refuse_argument(&scope.names, &scope.values, sink, &mut right, "a loop");
    refuse_frame_loop(sink, &mut left, &mut right, item.span);
    let Some(ty) = Type::common(&left.ty, &right.ty) else {
        if !left.ty.is_error() && !right.ty.is_error() {
            suspect_both_units(&scope.units, sink, &left, &right);
            let (first, second) = both_types(&scope.names, &left, &right);
            let fact = format!("the sides of the loop differ: {first} = {second}");
            let help = mismatch_help(&scope.names, &scope.units, &left, &right);
            sink.error_with_help(item.span, fact, help);
        }
        return Loop {
            left,
            right,
            origin,
        };
    };
    let ty = ty.settled();
    if let Some(dimension) = ty.dimension().filter(|dimension| !dimension.is_geometric()) {
        let fact = format!("a loop is about lengths and angles, found {dimension} on both sides");
        let help = "what moves does not depend on forces and times: divide by them";
        sink.error_with_help(item.span, fact, help);
    }
    left.settle(&ty);
    right.settle(&ty);
    Loop {
        left,
        right,
        origin,
    }
}
