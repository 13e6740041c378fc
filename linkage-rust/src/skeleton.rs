//! The items of a mechanism that has mistakes: names and types as far as they can be known, with
//! bodies that panic. Code that uses the mechanism still has its types, and editors their
//! completions, while the mistake is repaired.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::iter;

use proc_macro2::{Ident, TokenStream};
use quote::format_ident;

use super::outline::{self, Component, Field, Function, Input, Outline, Parameter, params, plain};
use crate::items::{results, types};
use crate::{
    assembly, block, constructors, dimensions, follower, guess::Guess, mechanism, picture,
    range_check, structure, table,
};
use linkage_compiler::ir::Picture;
use linkage_language::model::{
    ASSEMBLY, COLUMNS, COMPONENTS, Mechanism, MotionWord, Shape, Sweep, TYPE_PARAMETER,
};
use linkage_language::syntax::{ExprKind, FunctionDef, Item, MechanismDef, Word};

/// All public items with `unimplemented!()` bodies; `mechanism` gives better types where it is
/// known.
pub(crate) fn skeleton(
    krate: &TokenStream,
    def: &MechanismDef,
    mechanism: Option<&Mechanism>,
) -> TokenStream {
    let names = || iter::once(&def.name).chain(def.functions.iter().map(|f| &f.result));
    if names().any(|name| name == TYPE_PARAMETER) {
        // No other item of this name next to the type parameter would compile.
        return TokenStream::new();
    }
    let outline = sketch(krate, def, mechanism);
    let mut code = mechanism::items(&outline);
    code.extend(mechanism::constants(&outline, &structure::empty(&outline)));
    if asks_for_picture(def) {
        code.extend(picture::items(&outline, &Picture::default(), ""));
    }
    code.extend(dimensions::items(&outline));
    code.extend(assembly::items(&outline));
    let has_loop = def.items.iter().any(|item| matches!(item, Item::Loop(_)));
    if has_loop {
        code.extend(constructors::circuits(&outline));
        code.extend(follower::skeleton(&outline));
        code.extend(range_check::items(&outline));
    }
    for function in &outline.functions {
        code.extend(results(&outline, function));
        code.extend(table::items(&outline, function, &[]));
    }
    let follower = |outline: &Outline| match has_loop {
        true => follower::skeleton_types(outline),
        false => TokenStream::new(),
    };
    let mut items = types(&outline, follower);
    items.extend(block::items(&outline, &code));
    items
}

fn asks_for_picture(def: &MechanismDef) -> bool {
    let mut quantities = def
        .functions
        .iter()
        .flat_map(|function| &function.quantities);
    quantities.any(
        |quantity| matches!(&quantity.value.kind, ExprKind::Call(name, _) if name == MotionWord::Picture.word()),
    )
}

fn sketch<'a>(
    krate: &TokenStream,
    def: &'a MechanismDef,
    mechanism: Option<&Mechanism>,
) -> Outline<'a> {
    let guess = Guess::new(def);
    let mut seen = CollectedNames::default();
    let mut parameters: Vec<Parameter> = params(def)
        .filter(|param| seen.first(&param.name.field()))
        .map(|param| {
            let text = param.name.to_string();
            let known = mechanism.and_then(|m| m.parameters.iter().find(|p| p.name == text));
            let shape = known.map_or_else(|| guess.parameter(param), |p| Shape::from_type(&p.ty));
            let components = components(&param.name.field(), &shape);
            Parameter {
                name: param.name.field(),
                attributes: Cow::Borrowed(&param.attributes[..]),
                shape,
                components,
            }
        })
        .collect();
    parameters.extend(parameters_of_parts(&parameters, mechanism));
    let mut seen = CollectedNames::default();
    let inputs = outline::inputs(def)
        .filter(|name| seen.first(name))
        .map(|name| Input {
            name,
            unit: String::new(),
            reference: 0.0,
            range: None,
        })
        .collect();
    let (mut names, mut types) = (CollectedNames::default(), CollectedNames::default());
    types.all([def.name.clone(), format_ident!("{}{ASSEMBLY}", def.name)]);
    let functions = def
        .functions
        .iter()
        .filter(|function| {
            let (name, result) = (&function.name, &function.result);
            let swept = Sweep::all().map(|sweep| format_ident!("{name}{}", sweep.word()));
            let columns = format_ident!("{result}{COLUMNS}");
            names.all(std::iter::once(name.clone()).chain(swept))
                && types.all([result.clone(), columns])
        })
        .map(|function| sketch_function(function, def, &guess, mechanism))
        .collect();
    Outline {
        parameters,
        inputs,
        functions,
        ..Outline::empty(krate, def)
    }
}

/// The fields of parts, if they are known.
fn parameters_of_parts<'a>(
    declared: &[Parameter],
    mechanism: Option<&Mechanism>,
) -> Vec<Parameter<'a>> {
    let all = mechanism.iter().flat_map(|mechanism| &mechanism.parameters);
    let of_parts = all.filter(|parameter| parameter.name.contains('.'));
    let fields = of_parts.map(|parameter| {
        let (name, attributes) = outline::of_part(&parameter.name, &parameter.documentation);
        let shape = Shape::from_type(&parameter.ty);
        Parameter {
            components: components(&name, &shape),
            name,
            attributes,
            shape,
        }
    });
    fields
        .filter(|field| declared.iter().all(|declared| declared.name != field.name))
        .collect()
}

fn sketch_function<'a>(
    def: &'a FunctionDef,
    whole: &MechanismDef,
    guess: &Guess,
    mechanism: Option<&Mechanism>,
) -> Function<'a> {
    let known = mechanism.and_then(|m| m.evaluators.iter().find(|e| def.name == e.name));
    let is_drive = |name: &&Ident| outline::inputs(whole).any(|input| input == *name);
    let drives = def.inputs.iter().filter(is_drive).count();
    let mut seen = CollectedNames::default();
    let fields: Vec<Field> = def
        .quantities
        .iter()
        .filter(|quantity| seen.first(&quantity.field))
        .map(|quantity| {
            let known = known.and_then(|e| e.quantities.iter().find(|q| quantity.field == q.field));
            let known = known.filter(|q| !q.is_picture());
            let shape = known.map_or_else(
                || guess.shape(&quantity.value, drives),
                |q| Shape::from_type(&q.value.ty),
            );
            outline::field(quantity, shape, String::new())
        })
        .collect();
    let mut seen = CollectedNames::default();
    let arguments = def.inputs.iter().filter(|name| seen.first(name)).collect();
    Function {
        arguments,
        ..outline::function(def, fields)
    }
}

/// Names met so far: the second of two items with one name is left out.
#[derive(Default)]
struct CollectedNames(BTreeSet<String>);

impl CollectedNames {
    fn first(&mut self, name: &Ident) -> bool {
        self.0.insert(plain(name))
    }

    /// True if none of them has been met.
    fn all(&mut self, names: impl IntoIterator<Item = Ident>) -> bool {
        let mut new = true;
        for name in names {
            new &= self.first(&name);
        }
        new
    }
}

fn components(name: &Ident, shape: &Shape) -> Vec<Component> {
    let name = plain(name);
    let names = match shape {
        Shape::Vector(n) => COMPONENTS[..(*n).min(3)]
            .iter()
            .map(|c| format!("{name}.{c}"))
            .collect(),
        Shape::Scalar | Shape::Array(..) | Shape::Frame | Shape::PlaneFrame => vec![name],
    };
    names
        .into_iter()
        .map(|name| Component {
            name,
            unit: String::new(),
            nominal: 0.0,
            tolerance: 0.0,
        })
        .collect()
}
