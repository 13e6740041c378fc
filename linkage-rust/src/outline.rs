//! The generated items: names, types and docs, with or without the programs of functions.

use std::borrow::Cow;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::code::{self, Code};
use super::spanned::aside;
use super::{count, docs, drawing};
use linkage_compiler::ir::{self, CompiledMechanism};
use linkage_language::model::{ASSEMBLY, COLUMNS, COMPONENTS, Shape};
use linkage_language::syntax::{
    Attribute, FunctionDef, Item, MechanismDef, ParamItem, QuantityDef,
};

/// The body of a function of a mechanism with errors.
const WITHOUT_PROGRAM: &str = "::core::unimplemented!(\"the mechanism has errors\")";

/// The surface of one mechanism.
#[derive(Clone)]
pub(super) struct Outline<'a> {
    /// `$crate::__private`
    pub facade: Code,
    /// The runtime in the scope that is printed: the facade, or its short name in the block around
    /// code.
    pub runtime: Code,
    pub attributes: &'a [Attribute],
    pub visibility: &'a TokenStream,
    pub name: &'a Ident,
    /// The type of an assembled mechanism.
    pub assembly: Ident,
    /// The part of it that is copied into the loops of sweeps.
    pub core: Ident,
    pub parameters: Vec<Parameter<'a>>,
    pub inputs: Vec<Input<'a>>,
    pub functions: Vec<Function<'a>>,
    /// The default assembly modes; true for `Plus`.
    pub modes: Vec<bool>,
    /// The number of prepared slots.
    pub prepared: usize,
    /// The number of angles that count their turns.
    pub continuous_angles: usize,
    /// The prepared states of each coupled group.
    pub starts: Vec<PreparedGroup>,
    /// The drawing in the docs, as HTML; empty without a picture.
    pub drawing: String,
    /// False after errors: the bodies are `unimplemented!()`.
    pub complete: bool,
}

/// A public field of the mechanism.
#[derive(Clone)]
pub(super) struct Parameter<'a> {
    /// The name of the field: `hook_crank` for `hook.crank`.
    pub name: Ident,
    pub attributes: Cow<'a, [Attribute]>,
    pub shape: Shape,
    pub components: Vec<Component>,
}

/// A scalar parameter.
#[derive(Clone)]
pub(super) struct Component {
    pub name: String,
    pub unit: String,
    pub nominal: f64,
    pub tolerance: f64,
}

/// The prepared state of a coupled group.
#[derive(Clone)]
pub(super) struct PreparedGroup {
    /// The inputs that it depends on.
    pub inputs: Vec<usize>,
    /// Numbers in a state.
    pub size: usize,
    /// True if its assembly is followed from the estimates.
    pub followed: bool,
    /// Coefficients in a cell, of a grid.
    pub coefficients: usize,
}

#[derive(Clone)]
pub(super) struct Input<'a> {
    pub name: &'a Ident,
    pub unit: String,
    pub reference: f64,
    pub range: Option<(f64, f64)>,
}

#[derive(Clone)]
pub(super) struct Function<'a> {
    pub attributes: &'a [Attribute],
    pub visibility: &'a TokenStream,
    pub name: &'a Ident,
    /// The result type, and the type of a column of results.
    pub result: &'a Ident,
    pub columns: Ident,
    pub arguments: Vec<&'a Ident>,
    /// The inputs that they are, among those of the mechanism.
    pub positions: Vec<usize>,
    /// The coupled groups whose states it starts from.
    pub states: Vec<usize>,
    /// True if there is another program for dimensions, derivatives or digits that tables do not
    /// know.
    pub beside: bool,
    /// True if a call chooses its instruction set at run time: less work than a call costs is
    /// inlined.
    pub chooses: bool,
    pub fields: Vec<Field<'a>>,
    /// Paragraphs for the docs of the method.
    pub notes: String,
}

#[derive(Clone)]
pub(super) struct Field<'a> {
    pub name: &'a Ident,
    pub attributes: &'a [Attribute],
    pub shape: Shape,
    /// The quantity and its unit, for the docs: `` derivative of `p` by `phi`, in mm/rad ``.
    pub about: String,
}

impl<'a> Outline<'a> {
    /// The outline of a mechanism without mistakes.
    pub(super) fn complete(
        krate: &TokenStream,
        def: &'a MechanismDef,
        unit: &CompiledMechanism,
    ) -> Self {
        let inputs = inputs(def).zip(&unit.inputs).map(|(name, input)| Input {
            name,
            unit: if input.angle {
                "rad".to_owned()
            } else {
                input.unit.clone()
            },
            reference: input.reference,
            range: input.range,
        });
        let declared: Vec<&ParamItem> = params(def).collect();
        let parameters = unit.parameters.iter().enumerate();
        let functions = def.functions.iter().zip(&unit.functions);
        let starts = unit.coupled.iter().map(|group| PreparedGroup {
            inputs: group.inputs.clone(),
            size: group.size,
            followed: group.followed,
            coefficients: group.in_cells.count(group.inputs.len()),
        });
        let drawing = unit.picture.as_ref();
        let title = format!("{} at its reference inputs", def.title());
        let drawing = drawing.and_then(|picture| drawing::html(picture, &title));
        Self {
            parameters: parameters
                .map(|(index, parameter)| {
                    complete_parameter(declared.get(index).copied(), parameter)
                })
                .collect(),
            functions: functions
                .map(|(def, function)| complete_function(def, function, unit))
                .collect(),
            inputs: inputs.collect(),
            modes: unit.modes(),
            prepared: unit.slots(),
            continuous_angles: unit.angles.len(),
            starts: starts.collect(),
            drawing: drawing.unwrap_or_default(),
            complete: true,
            ..Self::empty(krate, def)
        }
    }

    /// An outline without any parameter, input or function.
    pub(super) fn empty(krate: &TokenStream, def: &'a MechanismDef) -> Self {
        Self {
            facade: quote!(#krate::__private).into(),
            runtime: quote!(__p).into(),
            attributes: &def.attributes,
            visibility: &def.visibility,
            name: &def.name,
            assembly: format_ident!("{}{ASSEMBLY}", def.name),
            core: format_ident!("__Core", span = Span::call_site()),
            parameters: Vec::new(),
            inputs: Vec::new(),
            functions: Vec::new(),
            modes: Vec::new(),
            prepared: 0,
            continuous_angles: 0,
            starts: Vec::new(),
            drawing: String::new(),
            complete: false,
        }
    }

    /// The outline for the types, which are outside of the block around code.
    pub(super) fn for_types(&self) -> Self {
        Self {
            runtime: self.facade.clone(),
            ..self.clone()
        }
    }

    /// `body`, or a panic if the outline has no program.
    pub(super) fn body(&self, body: TokenStream) -> TokenStream {
        match self.complete {
            true => body,
            false => code::tokens(WITHOUT_PROGRAM),
        }
    }

    /// The text of a body, or of a panic if the outline has no program.
    pub(super) fn body_text<'b>(&self, body: &'b str) -> &'b str {
        match self.complete {
            true => body,
            false => WITHOUT_PROGRAM,
        }
    }

    /// Field accesses of all scalar parameters in order: `crank`, `pivot_d.x`, ...
    pub(super) fn scalar_fields(&self) -> Vec<TokenStream> {
        self.parameters
            .iter()
            .flat_map(Parameter::scalar_fields)
            .collect()
    }

    /// The name of the mechanism as a string.
    pub(super) fn title(&self) -> String {
        plain(self.name)
    }

    /// `[Plus, Minus, ...]`: the assembly modes that the start estimates choose.
    pub(super) fn default_modes(&self) -> TokenStream {
        let runtime = &self.runtime;
        let modes = self.modes.iter().map(|plus| match plus {
            true => quote!(#runtime::AssemblyMode::Plus),
            false => quote!(#runtime::AssemblyMode::Minus),
        });
        quote!([#(#modes),*])
    }
}

impl Parameter<'_> {
    pub(super) fn scalar_fields(&self) -> Vec<TokenStream> {
        let name = aside(&self.name);
        match self.shape {
            Shape::Vector(n) => COMPONENTS[..n.min(3)]
                .iter()
                .map(|component| {
                    let component = format_ident!("{component}");
                    quote!(#name.#component)
                })
                .collect(),
            _ => vec![quote!(#name)],
        }
    }
}

impl Function<'_> {
    /// The number of scalars that the result holds.
    pub(super) fn width(&self) -> usize {
        self.fields.iter().map(|field| field.shape.width()).sum()
    }
}

/// A name without the `r#` of a raw identifier.
pub(super) fn plain(name: &Ident) -> String {
    ir::plain(&name.to_string()).to_owned()
}

pub(super) fn params(def: &MechanismDef) -> impl Iterator<Item = &ParamItem> {
    def.items.iter().filter_map(|item| match item {
        Item::Param(param) => Some(param),
        _ => None,
    })
}

pub(super) fn inputs(def: &MechanismDef) -> impl Iterator<Item = &Ident> {
    def.items.iter().filter_map(|item| match item {
        Item::Input(input) => Some(&input.name),
        _ => None,
    })
}

/// A function with its fields still to come.
pub(super) fn function<'a>(def: &'a FunctionDef, fields: Vec<Field<'a>>) -> Function<'a> {
    Function {
        attributes: &def.attributes,
        visibility: &def.visibility,
        name: &def.name,
        result: &def.result,
        columns: format_ident!("{}{COLUMNS}", def.result),
        arguments: def.inputs.iter().collect(),
        positions: Vec::new(),
        states: Vec::new(),
        beside: false,
        chooses: false,
        fields,
        notes: String::new(),
    }
}

pub(super) fn field<'a>(quantity: &'a QuantityDef, shape: Shape, about: String) -> Field<'a> {
    Field {
        name: &quantity.field,
        attributes: &quantity.attributes,
        shape,
        about,
    }
}

/// `item` declares it; those of parts follow all that are declared.
fn complete_parameter<'a>(item: Option<&'a ParamItem>, parameter: &ir::Parameter) -> Parameter<'a> {
    let components = parameter.scalars.iter().map(|scalar| Component {
        name: scalar.name.clone(),
        unit: scalar.unit.clone(),
        nominal: scalar.nominal,
        tolerance: scalar.tolerance,
    });
    let (name, attributes) = match item {
        Some(item) => (item.name.field(), Cow::Borrowed(&item.attributes[..])),
        None => of_part(&parameter.name, &parameter.documentation),
    };
    Parameter {
        name,
        attributes,
        shape: parameter.shape.clone(),
        components: components.collect(),
    }
}

/// The field of a part's parameter and its docs. Other attributes are about the struct that they
/// are written in.
pub(super) fn of_part<'a>(name: &str, documentation: &str) -> (Ident, Cow<'a, [Attribute]>) {
    let name = format_ident!("{}", name.replace('.', "_"));
    let docs = documentation.lines().map(|line| {
        let line = format!(" {line}");
        Attribute {
            name: "doc".to_owned(),
            tokens: quote!(#[doc = #line]),
            arguments: quote!(= #line),
            span: (&name).into(),
        }
    });
    let docs = docs.collect();
    (name, Cow::Owned(docs))
}

fn complete_function<'a>(
    def: &'a FunctionDef,
    compiled: &ir::Function,
    unit: &CompiledMechanism,
) -> Function<'a> {
    let quantities = def.quantities.iter().zip(&compiled.fields);
    let fields = quantities
        .map(|(quantity, compiled_field)| {
            field(
                quantity,
                compiled_field.shape.clone(),
                compiled_field.description(),
            )
        })
        .collect();
    let arguments = def.inputs.iter().zip(&compiled.arguments);
    let arguments: Vec<String> = arguments
        .map(|(name, position)| docs::argument(&plain(name), *position, unit))
        .collect();
    let mut notes = String::new();
    if !arguments.is_empty() {
        notes = format!("Takes {}.\n\n", arguments.join("; "));
    }
    let count = count::words(&compiled.called.count);
    notes.push_str("A quantity that depends on something which cannot be assembled is NaN.\n\n");
    let direction = compiled.direction_note();
    notes.push_str(&format!("Operations: {count}.{direction}"));
    Function {
        notes,
        positions: compiled.arguments.clone(),
        states: compiled.states.clone(),
        beside: compiled.beside.is_some(),
        chooses: compiled.called.is_worth_a_call(),
        ..function(def, fields)
    }
}
