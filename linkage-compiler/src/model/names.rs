//! What each name stands for, and where it may be used.

use std::collections::BTreeMap;

use proc_macro2::Ident;

use super::library::Source;
use super::mechanics::Scope;
use super::part::PartScope;
use super::place::{Context, refusal};
use super::types::{Course, Dimension, LengthUnit, Name, Placed, ScalarParameter, Type};
use super::unitless::Unitless;
use super::unknown_frame::Kind;
use super::zeros::Zeros;
use crate::diagnostic::{Diagnostics, Origins, SourceSpan};
use crate::syntax::{InputItem, Item};

/// One declared name.
pub(super) struct Symbol {
    pub(super) name: Name,
    pub(super) text: String,
    /// An error until the item has been resolved.
    pub(super) ty: Type,
    /// Position of its item in the struct block.
    pub(super) item: usize,
    /// Declared with a `0` that has no unit.
    pub(super) bare_zero: bool,
    /// A derived quantity that the user declares as an unknown.
    pub(super) is_unknown_frame: bool,
    pub(super) span: SourceSpan,
}

impl Symbol {
    /// The sort of its name in words.
    pub(super) fn kind(&self) -> &'static str {
        match self.is_unknown_frame {
            true => "an unknown",
            false => kind(self.name),
        }
    }
}

pub(super) struct Resolver<'a> {
    pub(super) symbols: Vec<Symbol>,
    by_name: BTreeMap<String, usize>,
    pub(super) unit: LengthUnit,
    pub(super) scalar_parameters: Vec<ScalarParameter>,
    /// How many inputs there are; in functions, arguments are counted behind them.
    pub(super) input_count: usize,
    /// For each derived quantity so far, an argument that it depends on.
    pub(super) arguments_of_lets: Vec<Option<usize>>,
    /// For each derived quantity so far, the course that it is.
    pub(super) courses_of_lets: Vec<Option<Course>>,
    /// Speeds and accelerations of each input.
    pub(super) rates: Vec<[Option<usize>; 2]>,
    pub(super) mechanics: Scope,
    pub(super) parts: Vec<PartScope>,
    /// Where parts stand, as far as they have been read.
    pub(super) placed: Vec<Placed>,
    /// Names whose number without a unit is taken for a length, and unknowns that are taken for vectors.
    pub(super) zeros: &'a Zeros,
    /// Names declared by numbers without a unit.
    pub(super) unitless: Vec<Unitless>,
    /// For each name, those of them that it would have its dimension from.
    pub(super) lacking: BTreeMap<Name, Vec<Name>>,
    /// Those of them that lengths were found beside.
    pub(super) suspects: Vec<Name>,
    pub(super) origins: &'a mut Origins,
    pub(super) diagnostics: &'a mut Diagnostics,
}

impl<'a> Resolver<'a> {
    /// Declares all names of the struct block.
    pub(super) fn new(
        source: &Source,
        zeros: &'a Zeros,
        origins: &'a mut Origins,
        diagnostics: &'a mut Diagnostics,
    ) -> Self {
        let mut resolver = Resolver {
            symbols: Vec::new(),
            by_name: BTreeMap::new(),
            unit: LengthUnit::Metre,
            scalar_parameters: Vec::new(),
            input_count: 0,
            arguments_of_lets: Vec::new(),
            courses_of_lets: Vec::new(),
            rates: Vec::new(),
            mechanics: Scope::default(),
            parts: Vec::new(),
            placed: Vec::new(),
            zeros,
            unitless: Vec::new(),
            lacking: BTreeMap::new(),
            suspects: Vec::new(),
            origins,
            diagnostics,
        };
        let definition = source.definition;
        resolver.check_reserved(&definition.name);
        let mut counts = Counts::of(&definition.items);
        let mut parts = source.parts.iter();
        for (position, item) in definition.items.iter().enumerate() {
            if let Some((ident, name)) = counts.next(item) {
                resolver.declare(ident, position, name);
            }
            if let (Item::Unknown(item), Some(symbol)) = (item, resolver.symbols.last_mut()) {
                symbol.is_unknown_frame = item.is_frame();
            }
            if let Item::Input(input) = item {
                resolver.declare_rates(input, position, &mut counts);
            }
            if let Item::Part(item) = item
                && let Some(found) = parts.next()
            {
                resolver.declare_part(item, position, found, &mut counts);
            }
        }
        resolver.input_count = counts.inputs;
        counts.unknowns += counts.unknowns_of_frames;
        resolver.declare_members_of_parts(&mut counts);
        resolver
    }

    /// The arguments that are speed and acceleration of an input.
    fn declare_rates(&mut self, input: &InputItem, item: usize, counts: &mut Counts) {
        let rates = [&input.speed, &input.acceleration].map(|ident| {
            let ident = ident.as_ref()?;
            let argument = next(&mut counts.arguments);
            self.declare(ident, item, Name::Argument(argument));
            Some(argument)
        });
        self.rates.push(rates);
    }

    fn declare(&mut self, ident: &Ident, item: usize, name: Name) {
        self.check_reserved(ident);
        self.check_new(ident);
        self.add_symbol(Symbol {
            name,
            text: ident.to_string(),
            ty: Type::Error,
            item,
            bare_zero: false,
            is_unknown_frame: false,
            span: ident.into(),
        });
    }

    /// Reports a name that stands for something else, too; true if it does not.
    pub(super) fn check_new(&mut self, ident: &Ident) -> bool {
        let text = ident.to_string();
        let symbol = self.find(&text).map(|symbol| symbol.span);
        let mut parts = self.parts.iter();
        let part = parts.find_map(|part| (part.name == text).then_some(part.span));
        if let Some(first) = symbol.or(part) {
            let fact = format!("the name `{text}` is defined twice");
            self.duplicate(&fact, &text, ident.into(), first);
            return false;
        }
        true
    }

    /// A name; of two that are the same, the first counts.
    pub(super) fn add_symbol(&mut self, symbol: Symbol) {
        let index = self.symbols.len();
        self.by_name.entry(symbol.text.clone()).or_insert(index);
        self.symbols.push(symbol);
    }

    /// The type of a declared value; what lacks a unit is a number or a length.
    pub(super) fn declared(&self, name: Name, ty: &Type) -> Type {
        match self.is_taken_for_length(name) {
            true => ty.with(Dimension::LENGTH),
            false => ty.settled(),
        }
    }

    pub(super) fn is_taken_for_length(&self, name: Name) -> bool {
        self.zeros.lengths.contains(&name)
    }

    pub(super) fn find(&self, text: &str) -> Option<&Symbol> {
        self.by_name.get(text).map(|index| &self.symbols[*index])
    }

    /// The declaration of an item, by the kind and number of its name.
    pub(super) fn symbol_mut(&mut self, name: Name) -> Option<&mut Symbol> {
        self.symbols.iter_mut().find(|symbol| symbol.name == name)
    }

    /// The symbol that a name may stand for here; reports it if there is none.
    pub(super) fn look_up(&mut self, ident: &Ident, context: Context) -> Option<(Name, Type)> {
        let text = ident.to_string();
        let Some(symbol) = self.find(&text) else {
            if self.is_part(&text) {
                self.lonely_part(&text, ident.into());
                return None;
            }
            if text == "PI" {
                return Some((Name::Pi, Type::NUMBER));
            }
            self.unknown_name(ident, Some(context));
            return None;
        };
        if let Some((fact, help)) = refusal(symbol, context) {
            self.diagnostics.error_with_help(ident.into(), fact, help);
            return None;
        }
        Some((symbol.name, symbol.ty.clone()))
    }

    /// Names of one sort, for help texts.
    pub(super) fn names_of(&self, wanted: fn(Name) -> bool) -> Vec<&str> {
        let symbols = self.symbols.iter().filter(|symbol| wanted(symbol.name));
        symbols.map(|symbol| symbol.text.as_str()).collect()
    }
}

/// How many names there are of each kind so far.
#[derive(Default)]
pub(super) struct Counts {
    pub(super) constants: usize,
    pub(super) parameters: usize,
    pub(super) inputs: usize,
    pub(super) unknowns: usize,
    pub(super) lets: usize,
    pub(super) arguments: usize,
    /// Unknowns that are frames: derived quantities in front of all others.
    frames: usize,
    /// What these consist of.
    unknowns_of_frames: usize,
}

impl Counts {
    /// Nothing counted yet; what is derived from unknown frames comes first.
    fn of(items: &[Item]) -> Self {
        let frames = items.iter().filter_map(|item| match item {
            Item::Unknown(item) if item.is_frame() => Some(item),
            _ => None,
        });
        Self {
            unknowns_of_frames: frames.clone().map(|item| Kind::of(item).unknowns()).sum(),
            lets: frames.count(),
            ..Self::default()
        }
    }

    /// The name of the value that an item declares, if it does. Names of bodies and joints are of their own.
    fn next<'i>(&mut self, item: &'i Item) -> Option<(&'i Ident, Name)> {
        Some(match item {
            Item::Const(item) => (&item.name, Name::Const(next(&mut self.constants))),
            Item::Param(item) => (&item.name, Name::Parameter(next(&mut self.parameters))),
            Item::Input(item) => (&item.name, Name::Input(next(&mut self.inputs))),
            Item::Unknown(item) if item.is_frame() => {
                (&item.name, Name::Let(next(&mut self.frames)))
            }
            Item::Unknown(item) => (&item.name, Name::Unknown(next(&mut self.unknowns))),
            Item::Let(item) => (&item.name, Name::Let(next(&mut self.lets))),
            Item::Argument(item) => (&item.name, Name::Argument(next(&mut self.arguments))),
            // What they declare follows behind all others.
            Item::Part(_) => return None,
            Item::Unit(_)
            | Item::Loop(_)
            | Item::Gravity(_)
            | Item::Body(_)
            | Item::Joint(_)
            | Item::Force(_)
            | Item::Torque(_)
            | Item::Spring(_)
            | Item::Damper(_) => return None,
        })
    }
}

pub(super) fn next(count: &mut usize) -> usize {
    *count += 1;
    *count - 1
}

/// The sort of a name in words.
pub(super) fn kind(name: Name) -> &'static str {
    match name {
        Name::Const(_) | Name::Pi => "a constant",
        Name::Parameter(_) => "a parameter",
        Name::Input(_) => "an input",
        Name::Unknown(_) => "an unknown",
        Name::Let(_) => "a derived quantity",
        Name::Argument(_) => "an argument",
    }
}
