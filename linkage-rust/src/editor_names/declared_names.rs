//! The names that a mechanism declares.

use linkage_language::model::{Mechanism, Type};
use linkage_language::syntax::{
    Attribute, BodyItem, Item, ItemName, LinkedItem, LinkedWord, MarkWord, MechanismDef, Word,
    documentation, item_text,
};
use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

/// The names of a mechanism.
pub(super) struct Names {
    pub(super) mechanism: Ident,
    declared: Vec<Declared>,
}

impl Names {
    /// Returns the names of a mechanism as it is written and, after them, those that only its
    /// complete form has.
    pub(super) fn new(written: &MechanismDef, complete: &MechanismDef) -> Self {
        Self {
            mechanism: written.name.clone(),
            declared: declared([written, complete]),
        }
    }

    /// Returns the declaration of a name, which is no quantity of a link.
    pub(super) fn find(&self, name: &Ident) -> Option<&Declared> {
        let mut declared = self.declared.iter();
        declared.find(|declared| declared.link.is_none() && declared.name == *name)
    }

    /// Returns true for the link that does not move, unless the mechanism declares a value of that name.
    pub(super) fn is_frame(&self, name: &Ident) -> bool {
        is_frame(name) && self.find(name).is_none()
    }

    /// The types whose fields are the names: of the mechanism, and of each link.
    pub(super) fn types(&self, mechanism: Option<&Mechanism>) -> TokenStream {
        let of_link = |link: Option<&Ident>| {
            let fields = self
                .declared
                .iter()
                .filter(|declared| declared.link.as_ref() == link);
            let fields = fields.map(|declared| declared.field(&self.mechanism, mechanism));
            let holder = holder(&self.mechanism, link);
            quote!(struct #holder { #(#fields)* })
        };
        let links = self
            .declared
            .iter()
            .filter(|declared| matches!(declared.kind, Kind::Link));
        let links = links.map(|link| of_link(Some(&link.name)));
        let values = of_link(None);
        quote!(#values #(#links)*)
    }
}

/// A declared name.
pub(super) struct Declared {
    name: Ident,
    pub(super) kind: Kind,
    /// The link that it is a quantity of.
    link: Option<Ident>,
    /// Its doc comment.
    documentation: String,
    /// Its declaration without the `;`.
    line: String,
}

/// The kind of a name, as far as accesses to it differ.
pub(super) enum Kind {
    /// A public field of the mechanism.
    Parameter,
    /// A value, a point, a body or a joint.
    Value,
    /// A part, with the mechanism that it is.
    Part(Ident),
    /// A link.
    Link,
}

/// Returns the names of all forms in order, each name once.
fn declared(forms: [&MechanismDef; 2]) -> Vec<Declared> {
    let mut all: Vec<Declared> = Vec::new();
    for item in forms.into_iter().flat_map(|form| &form.items) {
        let attributes: &[Attribute] = match item {
            Item::Param(item) => &item.attributes,
            _ => &[],
        };
        for (name, kind) in names_of(item) {
            let (link, name) = (name.link().cloned(), name.last().clone());
            let is_word = matches!(kind, Kind::Link) && is_frame(&name);
            let mut others = all.iter();
            let is_new = !others.any(|other| other.link == link && other.name == name);
            if is_new && !is_word {
                all.push(Declared {
                    name,
                    kind,
                    link,
                    documentation: documentation(attributes),
                    line: item_text(item),
                });
            }
        }
    }
    all
}

impl Declared {
    /// The field that it is, with docs for hovers.
    fn field(&self, of: &Ident, mechanism: Option<&Mechanism>) -> TokenStream {
        let name = &self.name;
        let written = match &self.link {
            Some(link) => format!("{link}.{name}"),
            None => name.to_string(),
        };
        let ty = mechanism.and_then(|mechanism| type_of(mechanism, &written));
        let unit = mechanism
            .zip(ty.as_ref().and_then(Type::dimension))
            .map(|(mechanism, dimension)| dimension.unit(mechanism.unit))
            .filter(|unit| !unit.is_empty())
            .map_or_else(String::new, |unit| format!(", in {unit}"));
        let kind = ty
            .as_ref()
            .map(|ty| format!("\n\n{ty}{unit}"))
            .unwrap_or_default();
        let line = format!("`{}`{kind}", self.line);
        let docs = match self.documentation.is_empty() {
            true => line,
            false => format!("{}\n\n{line}", self.documentation),
        };
        let field = match (&self.kind, ty) {
            (Kind::Part(mechanism), _) => {
                let holder = holder(mechanism, None);
                quote!(#holder)
            }
            (Kind::Link, _) => {
                let holder = holder(of, Some(name));
                quote!(#holder)
            }
            (_, Some(Type::Vector(count, _))) => quote!([f64; #count]),
            (_, _) => quote!(f64),
        };
        quote!(#[doc = #docs] #name: #field,)
    }
}

/// Returns the type of a name of a mechanism without mistakes.
fn type_of(mechanism: &Mechanism, name: &str) -> Option<Type> {
    let scalar = |dimension| Type::Scalar(dimension);
    let parameters = mechanism
        .parameters
        .iter()
        .map(|item| (&item.name, item.ty.clone()));
    let constants = mechanism
        .constants
        .iter()
        .map(|item| (&item.name, item.value.ty.clone()));
    let inputs = mechanism
        .inputs
        .iter()
        .map(|item| (&item.name, scalar(item.dimension)));
    let arguments = mechanism
        .arguments
        .iter()
        .map(|item| (&item.name, scalar(item.dimension)));
    let unknowns = mechanism
        .unknowns
        .iter()
        .map(|item| (&item.name, item.ty.clone()));
    let lets = mechanism
        .lets
        .iter()
        .map(|item| (&item.name, item.value.ty.clone()));
    let mut all = parameters
        .chain(constants)
        .chain(inputs)
        .chain(arguments)
        .chain(unknowns)
        .chain(lets);
    all.find(|(known, _)| known.as_str() == name)
        .map(|(_, ty)| ty)
}

fn is_frame(name: &Ident) -> bool {
    *name == MarkWord::Frame.word()
}

fn names_of(item: &Item) -> Vec<(ItemName, Kind)> {
    let value = |name: &Ident| vec![(name.clone().into(), Kind::Value)];
    match item {
        Item::Const(item) | Item::Let(item) | Item::Argument(item) => {
            vec![(item.name.clone(), Kind::Value)]
        }
        Item::Unknown(item) => vec![(item.name.clone(), Kind::Value)],
        Item::Param(item) => vec![(item.name.clone(), Kind::Parameter)],
        Item::Input(item) => {
            let rates = item.speed.iter().chain(&item.acceleration);
            std::iter::once(&item.name)
                .chain(rates)
                .flat_map(value)
                .collect()
        }
        Item::Arc(item) => value(&item.name),
        Item::Part(item) => vec![(item.name.clone().into(), Kind::Part(item.mechanism.clone()))],
        Item::Body(BodyItem { name, joint, .. }) => {
            let joint = joint.name.iter().flat_map(value);
            value(name).into_iter().chain(joint).collect()
        }
        Item::Joint(item) => item.joint.name.iter().flat_map(value).collect(),
        Item::Linked(item) => of_linked(item),
        Item::Unit(_) | Item::Loop(_) | Item::Gravity(_) => Vec::new(),
        Item::Force(_)
        | Item::Torque(_)
        | Item::Spring(_)
        | Item::Damper(_)
        | Item::Friction(_) => Vec::new(),
    }
}

fn of_linked(item: &LinkedItem) -> Vec<(ItemName, Kind)> {
    match item {
        LinkedItem::Joints(joints) => {
            let names = joints.iter().map(|joint| joint.name.clone());
            names.map(|name| (name.into(), Kind::Value)).collect()
        }
        LinkedItem::Link(item) => vec![(item.name.clone().into(), Kind::Link)],
        LinkedItem::Slider(item) => vec![(item.name.clone().into(), Kind::Link)],
        LinkedItem::Lost(item) => {
            let kind = || match item.word {
                LinkedWord::Link | LinkedWord::Slider => Kind::Link,
                LinkedWord::Joint | LinkedWord::Gears | LinkedWord::Belt | LinkedWord::Weld => {
                    Kind::Value
                }
            };
            let names = item.names.iter();
            names.map(|name| (name.clone().into(), kind())).collect()
        }
        LinkedItem::Gears(_) | LinkedItem::Belt(_) | LinkedItem::Weld(_) => Vec::new(),
    }
}

/// The name of the type that has the names of a mechanism, or those of a link of it, as fields.
pub(super) fn holder(mechanism: &Ident, link: Option<&Ident>) -> Ident {
    let link = link.map(|link| format!("_{link}")).unwrap_or_default();
    format_ident!("__{mechanism}_names{link}", span = Span::call_site())
}
