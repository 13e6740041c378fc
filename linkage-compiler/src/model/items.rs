//! The items of the struct block.

use super::embed::Embedding;
use super::library::Source;
use super::names::Resolver;
use super::passes::{Coordinate, Definition, Passes};
use super::place::{Context, Place};
use super::types::{
    Constant, Dimension, Expr, Input, LengthUnit, Let, Loop, Mechanism, Name, Type, Unknown,
};
use crate::diagnostic::text::nearest;
use crate::syntax::{
    Attribute, InputItem, Item, LoopItem, MechanismDef, NamedItem, UnitItem, UnknownItem, Word,
    documentation,
};

impl Resolver<'_> {
    /// All items, pass by pass.
    pub(super) fn items(&mut self, source: &Source) -> Mechanism {
        let definition = source.definition;
        let passes = Passes::of(definition);
        let unit = self.length_unit(&passes.units);
        self.unit = source.unit.unwrap_or(unit);
        let mut mechanism = Mechanism {
            name: definition.name.to_string(),
            documentation: documentation(&definition.attributes),
            unit: self.unit,
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
            origin: self.origins.add((&definition.name).into()),
        };
        for (position, item) in passes.constants {
            let context = Context {
                place: Place::Constant,
                item: position,
            };
            let name = Name::Const(mechanism.constants.len());
            let value = self.named(item, name, context);
            let name = item.name.to_string();
            mechanism.constants.push(Constant { name, value });
        }
        for (index, (position, item)) in passes.parameters.into_iter().enumerate() {
            let mut parameter = self.param_item(item, index, position);
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
                        .push(self.input_item(item, index, position));
                }
                Coordinate::Unknown(item) => {
                    let index = mechanism.unknowns.len();
                    let unknown = self.unknown_item(item, index, position);
                    mechanism.unknowns.push(unknown);
                }
            }
        }
        let frames = self.unknown_frames(&passes.frames, &mut mechanism);
        mechanism.arguments = self.arguments(&passes.arguments, &mechanism.inputs);
        self.coordinates_of_parts(&mut mechanism);
        for (position, item) in passes.definitions {
            let context = Context {
                place: Place::LetOrLoop,
                item: position,
            };
            match item {
                Definition::Let(item) => {
                    let name = Name::Let(mechanism.lets.len());
                    let value = self.named(item, name, context);
                    self.note_let(&value);
                    let name = item.name.to_string();
                    mechanism.lets.push(Let {
                        name,
                        value,
                        is_unknown_frame: false,
                    });
                }
                Definition::Loop(item) => {
                    let own = self.loop_item(item, context);
                    match item.redundant {
                        true => mechanism.redundant.push(own),
                        false => mechanism.loops.push(own),
                    }
                }
                Definition::Part(item) => self.part_item(item, position, &mut mechanism),
            }
        }
        mechanism.close_frames(frames);
        mechanism.placed.clone_from(&self.placed);
        self.mechanics(
            &passes.bodies,
            &passes.mechanics,
            &passes.parts,
            &mut mechanism,
        );
        mechanism
            .scalar_parameters
            .clone_from(&self.scalar_parameters);
        mechanism
    }

    /// What parts bring that does not depend on what they are given.
    fn coordinates_of_parts(&mut self, mechanism: &mut Mechanism) {
        for part in 0..self.parts.len() {
            let own = Embedding::new(&self.parts[part], &mechanism.lets, &[]);
            let Some(embedding) = own else { continue };
            mechanism.constants.extend(embedding.constants());
            mechanism.unknowns.extend(embedding.unknowns());
            for mut own in embedding.parameters() {
                let index = mechanism.parameters.len();
                own.first_scalar = self.add_scalars(&own.name, index, &own.ty);
                self.check_field(&own.name, part, &mechanism.parameters);
                mechanism.parameters.push(own);
            }
        }
    }

    fn length_unit(&mut self, items: &[&UnitItem]) -> LengthUnit {
        let Some((first, others)) = items.split_first() else {
            return LengthUnit::Metre;
        };
        for item in others {
            let help = "leave one of them out";
            self.diagnostics
                .error_with_help(item.span, "a second `unit`", help);
            self.diagnostics
                .error(first.span, "`unit` is first given here");
        }
        let text = first.unit.to_string();
        LengthUnit::from_name(&text).unwrap_or_else(|| {
            let names: Vec<&str> = LengthUnit::all().map(LengthUnit::word).collect();
            let help = match nearest(&text, names.iter().copied()) {
                Some(name) => format!("did you mean `{name}`?"),
                None => format!("length units are {}", names.join(" ")),
            };
            let fact = format!("`{text}` is not a length unit");
            self.diagnostics
                .error_with_help((&first.unit).into(), fact, help);
            LengthUnit::Metre
        })
    }

    /// Value of a constant or `let`. Zero stays zero: it fits every dimension under its name, too.
    fn named(&mut self, item: &NamedItem, name: Name, context: Context) -> Expr {
        let value = self.expression(&item.value, context);
        self.note_unitless(name, &value, None);
        let ty = match self.is_taken_for_length(name) {
            true => self.declared(name, &value.ty),
            false => value.ty.clone(),
        };
        self.set_type(name, ty, false);
        value
    }

    pub(super) fn set_type(&mut self, name: Name, ty: Type, bare_zero: bool) {
        if let Some(symbol) = self.symbol_mut(name) {
            symbol.ty = ty;
            symbol.bare_zero = bare_zero;
        }
    }

    fn input_item(&mut self, item: &InputItem, index: usize, position: usize) -> Input {
        let context = Context {
            place: Place::Input,
            item: position,
        };
        let mut reference = self.expression(&item.value, context);
        let mut range = item.range.as_ref().map(|(low, high)| {
            (
                self.expression(low, context),
                self.expression(high, context),
            )
        });
        self.refuse_frame_item(&mut reference, "an input is an angle or a length");
        let mut all: Vec<&mut Expr> = vec![&mut reference];
        if let Some((low, high)) = &mut range {
            all.extend([low, high]);
        }
        let ty = self.common_type(&mut all, "the reference and the range of an input");
        let bare_zero = all.iter().all(|value| matches!(value.ty, Type::Zero(_)));
        let ty = self.declared(Name::Input(index), &ty);
        all.into_iter().for_each(|value| value.settle(&ty));
        let beside = range.as_ref().map(|_| "the range");
        self.note_unitless(Name::Input(index), &reference, beside);
        let dimension = match &ty {
            Type::Scalar(dimension) => self.coordinate(*dimension, "an input", &item.value),
            Type::Error => None,
            other => {
                let fact = format!("an input is an angle or a length, found {other}");
                let help = "declare one input for each coordinate";
                self.diagnostics
                    .error_with_help(item.value.span, fact, help);
                None
            }
        };
        let ty = dimension.map_or(Type::Error, Type::Scalar);
        self.set_type(Name::Input(index), ty, bare_zero);
        Input {
            name: item.name.to_string(),
            dimension: dimension.unwrap_or(Dimension::NUMBER),
            reference,
            range,
            speed: self.rates[index][0],
            acceleration: self.rates[index][1],
            origin: self.origins.add((&item.name).into()),
        }
    }

    fn unknown_item(&mut self, item: &UnknownItem, index: usize, position: usize) -> Unknown {
        let name = Name::Unknown(index);
        let (ty, bare_zero, estimate) = match &item.estimate {
            Some(value) => {
                let context = Context {
                    place: Place::Estimate,
                    item: position,
                };
                let mut estimate = self.expression(value, context);
                self.refuse_frame_item(
                    &mut estimate,
                    "an unknown is an angle, a length or a point",
                );
                let bare_zero = matches!(estimate.ty, Type::Zero(_));
                let mut ty = self.declared(name, &estimate.ty);
                estimate.settle(&ty);
                self.note_unitless(name, &estimate, None);
                if let Some(dimension) = ty.dimension()
                    && self.coordinate(dimension, "an unknown", value).is_none()
                {
                    ty = Type::Error;
                }
                (ty, bare_zero, Some(estimate))
            }
            None => (self.declared(name, &self.zeros.of(name)), true, None),
        };
        self.set_type(name, ty.clone(), bare_zero);
        let origin = self.origins.add((&item.name).into());
        Unknown {
            name: item.name.to_string(),
            ty,
            estimate,
            of_part: false,
            origin,
        }
    }

    /// Inputs and unknowns are angles (or numbers) and lengths.
    fn coordinate(
        &mut self,
        dimension: Dimension,
        what: &str,
        value: &crate::syntax::Expr,
    ) -> Option<Dimension> {
        if dimension.is_number_or_angle() || dimension.fits(Dimension::LENGTH) {
            return Some(dimension);
        }
        let fact = format!("{what} is an angle or a length, found {dimension}");
        self.diagnostics
            .error_with_help(value.span, fact, "use another coordinate");
        None
    }

    fn loop_item(&mut self, item: &LoopItem, context: Context) -> Loop {
        let mut left = self.expression(&item.left, context);
        let mut right = self.expression(&item.right, context);
        let origin = self.origins.add(item.span);
        self.refuse_argument(&mut left, "a loop");
        self.refuse_argument(&mut right, "a loop");
        self.refuse_frame_loop(&mut left, &mut right, item.span);
        let Some(ty) = Type::common(&left.ty, &right.ty) else {
            if !left.ty.is_error() && !right.ty.is_error() {
                self.suspect_both(&left, &right);
                let (first, second) = self.both_types(&left, &right);
                let fact = format!("the sides of the loop differ: {first} = {second}");
                let help = self.mismatch_help(&left, &right);
                self.diagnostics.error_with_help(item.span, fact, help);
            }
            return Loop {
                left,
                right,
                origin,
            };
        };
        let ty = ty.settled();
        if let Some(dimension) = ty.dimension().filter(|dimension| !dimension.is_geometric()) {
            let fact =
                format!("a loop is about lengths and angles, found {dimension} on both sides");
            let help = "what moves does not depend on forces and times: divide by them";
            self.diagnostics.error_with_help(item.span, fact, help);
        }
        left.settle(&ty);
        right.settle(&ty);
        Loop {
            left,
            right,
            origin,
        }
    }
}

/// The length unit that a mechanism says, if it is one.
pub(super) fn length_unit(definition: &MechanismDef) -> Option<LengthUnit> {
    let mut items = definition.items.iter();
    items.find_map(|item| match item {
        Item::Unit(item) => LengthUnit::from_name(&item.unit.to_string()),
        _ => None,
    })
}
