//! Declaration of all names of a struct block, before any item is resolved.

use super::name_counts::{Counts, next};
use super::part_names::{declare_names_of_parts, declare_part};
use crate::model::expression::refused_names::{check_new_name, check_reserved};
use crate::model::library::Source;
use crate::model::symbols::assumed_units::AssumedUnits;
use crate::model::symbols::declared_names::{Names, Symbol};
use crate::model::symbols::member_names::{LinkNames, MemberNames};
use crate::model::symbols::part_scopes::Parts;
use crate::model::symbols::scope::Scope;
use crate::model::symbols::sink::Sink;
use crate::model::symbols::values::Values;
use crate::model::symbols::zeros::Zeros;
use crate::model::types::{Name, Type};
use crate::syntax::{InputItem, Item, ItemName};

/// Declares all names of the struct block.
pub(in crate::model) fn declare_names(source: &Source, zeros: Zeros, sink: &mut Sink) -> Scope {
    let mut scope = Scope {
        names: Names::default(),
        parts: Parts::default(),
        members: MemberNames::default(),
        values: Values::default(),
        units: AssumedUnits::new(zeros),
    };
    let definition = source.definition;
    scope.members.links = LinkNames::new(definition);
    check_reserved(sink, &definition.name);
    let mut counts = Counts::new(&definition.items);
    let mut parts = source.parts.iter();
    for (position, item) in definition.items.iter().enumerate() {
        if let Some((declared, name)) = counts.next_name(item) {
            if declared.is_of_link() {
                scope.parts.quantities.insert(declared.to_string());
            }
            declare(
                &mut scope.names,
                &scope.parts,
                sink,
                &declared,
                position,
                name,
            );
        }
        if let (Item::Unknown(item), Some(symbol)) = (item, scope.names.symbols.last_mut()) {
            symbol.is_unknown_frame = item.is_frame();
        }
        if let Item::Input(input) = item {
            declare_rates(&mut scope, sink, input, position, &mut counts);
        }
        if let Item::Part(item) = item
            && let Some(found) = parts.next()
        {
            declare_part(
                &scope.names,
                &mut scope.parts,
                sink,
                item,
                position,
                found,
                &mut counts,
            );
        }
    }
    scope.values.input_count = counts.inputs;
    counts.unknowns += counts.unknowns_of_frames;
    declare_names_of_parts(&mut scope.names, &mut scope.parts, &mut counts);
    scope
}

/// The arguments that are speed and acceleration of an input.
fn declare_rates(
    scope: &mut Scope,
    sink: &mut Sink,
    input: &InputItem,
    item: usize,
    counts: &mut Counts,
) {
    let rates = [&input.speed, &input.acceleration].map(|ident| {
        let ident = ident.as_ref()?;
        let argument = next(&mut counts.arguments);
        declare(
            &mut scope.names,
            &scope.parts,
            sink,
            &ident.clone().into(),
            item,
            Name::Argument(argument),
        );
        Some(argument)
    });
    scope.values.rates.push(rates);
}

fn declare(
    names: &mut Names,
    parts: &Parts,
    sink: &mut Sink,
    declared: &ItemName,
    item: usize,
    name: Name,
) {
    check_reserved(sink, declared);
    check_new_name(names, parts, sink, declared);
    names.add_symbol(Symbol {
        name,
        text: declared.to_string(),
        ty: Type::Error,
        item,
        bare_zero: false,
        is_unknown_frame: false,
        span: declared.into(),
    });
}
