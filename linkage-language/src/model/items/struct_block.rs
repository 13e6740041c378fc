//! The items of the struct block.

use super::arc::resolve_arc;
use super::argument::resolve_arguments;
use super::coordinates::{resolve_input, resolve_unknown};
use super::definitions::{resolve_loop, resolve_named};
use super::link_elements::resolve_link_elements;
use super::parameter::resolve_parameter;
use super::scalars::add_scalars;
use super::unknown_frame::{close_frames, resolve_unknown_frames};
use crate::diagnostic::text::nearest;
use crate::model::declare::passes::{Coordinate, Definition, Passes};
use crate::model::library::Source;
use crate::model::mechanics::items::resolve_mechanics;
use crate::model::parts::embed::Embedding;
use crate::model::parts::item::{check_field, resolve_part};
use crate::model::symbols::part_scopes::Parts;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::site::{Context, Site};
use crate::model::symbols::values::Values;
use crate::model::types::{Constant, Dimension, LengthUnit, Let, LinkElements, Mechanism, Name};
use crate::model::units::conversion::dimension_of;
use crate::syntax::{Attribute, UnitItem, Word, documentation, find_unit};

/// All items, pass by pass.
pub(in crate::model) fn resolve_items(
    scope: &mut Scope,
    sink: &mut Sink,
    source: &Source,
) -> Mechanism {
    let definition = source.definition;
    let passes = Passes::sort(definition);
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
        frictions: Vec::new(),
        arcs: Vec::new(),
        evaluators: Vec::new(),
        links: definition.links.clone(),
        link_elements: LinkElements::default(),
        origin: sink.add_origin((&definition.name).into()),
    };
    for (position, item) in passes.constants {
        let context = Context {
            site: Site::Constant,
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
            site: Site::LetOrLoop,
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
                let equation = resolve_loop(scope, sink, item, context);
                if item.redundant {
                    mechanism.redundant.push(equation)
                } else {
                    mechanism.loops.push(equation)
                }
            }
            Definition::Part(item) => resolve_part(scope, sink, item, position, &mut mechanism),
        }
    }
    close_frames(&mut mechanism, frames);
    mechanism.placed.clone_from(&scope.parts.placed);
    resolve_mechanics(
        scope,
        sink,
        &passes.bodies,
        &passes.mechanics,
        &passes.parts,
        &mut mechanism,
    );
    for item in passes.arcs {
        mechanism.arcs.push(resolve_arc(scope, sink, item));
    }
    let elements = resolve_link_elements(scope, sink, &definition.link_elements);
    mechanism.link_elements.append(elements);
    mechanism
        .scalar_parameters
        .clone_from(&scope.values.scalar_parameters);
    mechanism
}

/// Adds the constants, unknowns and parameters of parts. They do not depend on the values that
/// parts are given.
fn embed_coordinates(
    parts: &Parts,
    values: &mut Values,
    sink: &mut Sink,
    mechanism: &mut Mechanism,
) {
    for part in 0..parts.scopes.len() {
        let embedding = Embedding::new(&parts.scopes[part], &mechanism.lets, &[]);
        let Some(embedding) = embedding else { continue };
        mechanism.constants.extend(embedding.constants());
        mechanism.unknowns.extend(embedding.unknowns());
        for mut parameter in embedding.parameters() {
            let index = mechanism.parameters.len();
            parameter.first_scalar = add_scalars(values, &parameter.name, index, &parameter.ty);
            check_field(parts, sink, &parameter.name, part, &mechanism.parameters);
            mechanism.parameters.push(parameter);
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
        let is_length =
            find_unit(&text).is_some_and(|unit| dimension_of(unit) == Dimension::LENGTH);
        let help = match nearest(&text, names.iter().copied()) {
            _ if is_length => format!(
                "`unit` takes {}; lengths may be written in `{text}` with each of them",
                names.join(" ")
            ),
            Some(name) => format!("did you mean `{name}`?"),
            None => format!("length units are {}", names.join(" ")),
        };
        let fact = if is_length {
            format!("results cannot have the unit `{text}`")
        } else {
            format!("`{text}` is not a length unit")
        };
        sink.error_with_help((&first.unit).into(), fact, help);
        LengthUnit::Metre
    })
}
