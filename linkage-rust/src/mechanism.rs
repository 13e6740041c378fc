//! The struct of dimensions: fields, default, conversion, constants.

use std::collections::BTreeSet;

use proc_macro2::{Ident, Span, TokenStream};
use quote::{format_ident, quote};

use super::code::joined;
use super::docs::{self, doc, documented, tokens, with_note};
use super::outline::{Component, Outline, Parameter, plain};
use super::spanned::aside;
use super::{attribute, code, literal};
use linkage_compiler::ir::in_degrees;

/// The default of the struct and its conversions.
pub(super) fn items(outline: &Outline) -> TokenStream {
    joined([default(outline), conversions(outline)])
}

/// The struct.
pub(super) fn structure(outline: &Outline) -> TokenStream {
    let Outline {
        visibility,
        name,
        attributes,
        ..
    } = outline;
    let derives = attribute::derives(*attributes, &[]);
    let drawing = docs::drawing(&outline.drawing);
    let head = with_note(
        &tokens(attributes),
        documented(attributes),
        "",
        &format!("Dimensions of the mechanism `{}`.", outline.title()),
    );
    let scalar = quote!(T);
    let fields = outline.parameters.iter().map(|parameter| {
        let name = &parameter.name;
        let ty = outline.field_type(&parameter.shape, &scalar);
        let [note, alone] = parameter_notes(outline, parameter);
        let head = with_note(
            &tokens(&parameter.attributes),
            documented(&parameter.attributes),
            &note,
            &alone,
        );
        quote!(#head pub #name: #ty,)
    });
    let marker = outline.parameters.is_empty().then(marker_field);
    let allow = attribute::allow();
    quote! {
        #head
        #drawing
        #allow
        #derives
        #visibility struct #name<T = ::core::primitive::f64> { #(#fields)* #marker }
    }
}

/// Carries the scalar type where a struct has no field.
pub(super) fn marker_field() -> TokenStream {
    quote!(#[doc(hidden)] pub __scalar: ::core::marker::PhantomData<T>,)
}

pub(super) fn marker_value() -> TokenStream {
    quote!(__scalar: ::core::marker::PhantomData,)
}

/// The docs of a parameter after those of the user, `In mm; default 50, tolerance 0.012.`, and
/// those without any, `` `crank`, in mm; default 50, tolerance 0.012. ``; angles are given in
/// degrees.
fn parameter_notes(outline: &Outline, parameter: &Parameter) -> [String; 2] {
    let name = plain(&parameter.name);
    if !outline.complete {
        return [String::new(), format!("`{name}`.")];
    }
    let list = |number: fn(&Component) -> f64| {
        let components = parameter.components.iter();
        let words = components.map(|c| in_degrees(number(c), &c.unit));
        let words = words.collect::<Vec<_>>().join(", ");
        if parameter.components.len() == 1 {
            words
        } else {
            format!("({words})")
        }
    };
    let mut values = format!("default {}", list(|c| c.nominal));
    if parameter.components.iter().any(|c| c.tolerance != 0.0) {
        values.push_str(&format!(", tolerance {}", list(|c| c.tolerance)));
    }
    match parameter.components.first().map_or("", |c| c.unit.as_str()) {
        "" => [
            format!("A number; {values}."),
            format!("`{name}`; {values}."),
        ],
        unit => [
            format!("In {unit}; {values}."),
            format!("`{name}`, in {unit}; {values}."),
        ],
    }
}

fn default(outline: &Outline) -> TokenStream {
    let name = outline.name;
    let body = outline.body(quote!(__of(|__k| Self::PARAMETERS[__k].nominal)));
    quote! {
        #[automatically_derived]
        impl ::core::default::Default for #name<__p::f64> {
            #[inline]
            fn default() -> Self { #body }
        }
    }
}

fn conversions(outline: &Outline) -> TokenStream {
    let Outline { runtime, name, .. } = outline;
    // A mechanism may be called as the type parameter usually is.
    let other = format_ident!("{}", if *name == "U" { "V" } else { "U" });
    let mut scalars = (0..outline.scalar_fields().len()).map(|index| {
        let index = literal::index(index);
        quote!(__number(#index))
    });
    let of_numbers = outline.body(from_scalars(outline, &mut scalars));
    let cast = outline.body(quote! {
        let __values = __values(self);
        __of(|__k| <#other as #runtime::Scalar>::from_f64(__values[__k]))
    });
    quote! {
        impl #name<__p::f64> {
            /// The same dimensions in another scalar type: single precision, lanes, dual numbers.
            #[must_use]
            pub fn cast<#other: #runtime::Scalar>(&self) -> #name<#other> { #cast }
        }
        /// The dimensions, each by its index in `PARAMETERS`.
        #[inline(always)]
        fn __of<T: #runtime::Scalar>(__number: impl #runtime::Fn(__p::usize) -> T) -> #name<T> {
            #of_numbers
        }
    }
}

/// The struct of the given scalars, in order.
fn from_scalars(outline: &Outline, scalars: &mut dyn Iterator<Item = TokenStream>) -> TokenStream {
    let name = outline.name;
    let fields = outline.parameters.iter().map(|parameter| {
        let name = aside(&parameter.name);
        let value = outline.field_value(&parameter.shape, scalars);
        quote!(#name: #value,)
    });
    let fields: Vec<_> = fields.collect();
    let marker = outline.parameters.is_empty().then(marker_value);
    quote!(#name { #(#fields)* #marker })
}

/// `INPUTS`, `PARAMETERS`, `STRUCTURE` and the named indices.
pub(super) fn constants(outline: &Outline, structure: &str) -> TokenStream {
    let name = outline.name;
    let components = outline.parameters.iter().flat_map(|p| &p.components);
    let rows = components.map(|component| {
        let Component { name, unit, .. } = component;
        let [nominal, tolerance] =
            [component.nominal, component.tolerance].map(literal::float_text);
        format!("__p::parameter({name:?}, {unit:?}, {nominal}, {tolerance}),")
    });
    let rows: String = rows.collect();
    let indices =
        index_names(outline)
            .into_iter()
            .enumerate()
            .map(|(index, (constant, name, span))| {
                let constant = Ident::new(&constant, span);
                let doc = doc(&format!(
                    "Index of `{name}` in `PARAMETERS` and in the arrays of `sensitivity`."
                ));
                let index = literal::index(index);
                quote!(#doc pub const #constant: __p::usize = #index;)
            });
    let inputs = outline.inputs.iter().map(|input| {
        let (name, unit) = (plain(input.name), &input.unit);
        let reference = literal::float_text(input.reference);
        let range = match input.range {
            Some((low, high)) => {
                let [low, high] = [low, high].map(literal::float_text);
                format!("__p::Some(({low}, {high}))")
            }
            None => "__p::None".to_owned(),
        };
        format!(
            "__p::Input {{ name: {name:?}, unit: {unit:?}, reference: {reference}, range: {range} }},"
        )
    });
    let inputs: String = inputs.collect();
    let tables = code::tokens(&format!(
        "/// The inputs in declaration order, with their reference positions and ranges.
        pub const INPUTS: &'static [__p::Input] = &[{inputs}];
        /// The scalar parameters in declaration order, with the defaults and tolerances of the declaration, in
        /// the units of the fields.
        pub const PARAMETERS: &'static [__p::Parameter] = &[{rows}];
        /// The groups in the order in which they are solved, their methods, and operation counts.
        pub const STRUCTURE: &'static __p::Structure = &{structure};"
    ));
    quote! {
        impl #name<__p::f64> {
            #tables
            #(#indices)*
        }
    }
}

/// Names of the index constants with the parameters that they stand for. `INDEX_PIVOT_D_X` for
/// `pivot_d.x`; where two parameters would share a name (`a` and `A`), the later one keeps its
/// spelling.
fn index_names(outline: &Outline) -> Vec<(String, String, Span)> {
    let mut taken = BTreeSet::new();
    let parameters = outline.parameters.iter();
    let components = parameters.flat_map(|parameter| {
        let components = parameter.components.iter();
        components.map(|component| (component, parameter.name.span()))
    });
    components
        .enumerate()
        .map(|(index, (component, span))| {
            let joined = component.name.replace('.', "_");
            let candidates = [
                format!("INDEX_{}", joined.to_uppercase()),
                format!("INDEX_{joined}"),
                format!("INDEX_{}", component.name.replace('.', "__")),
                format!("INDEX_{joined}_{index}"),
            ];
            let free = candidates.iter().find(|name| !taken.contains(*name));
            let name = free.unwrap_or(&candidates[3]).clone();
            taken.insert(name.clone());
            (name, component.name.clone(), span)
        })
        .collect()
}
