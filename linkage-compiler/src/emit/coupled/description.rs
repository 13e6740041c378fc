//! What the runtime must know of a coupled group to prepare it.

use linkage_runtime::numeric::roots::Variable;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::algebra::AXES;
use crate::emit::facts::Facts;
use crate::emit::literal;
use crate::emit::outline::Outline;
use crate::lower::Coupled;
use crate::model::Mechanism;

/// The runtime's description of a group.
pub(super) fn description(
    outline: &Outline,
    mechanism: &Mechanism,
    facts: &Facts,
    group: &Coupled,
) -> TokenStream {
    let runtime = &outline.runtime;
    let title = outline.title();
    let own = &facts.groups[group.group];
    let index = literal::index(group.group);
    let kind = &own.kind;
    let loops = own.loops.iter().map(|n| literal::index(*n));
    let names = &own.unknowns;
    let unknowns = group.unknowns.iter().map(|placed| {
        let unknown = &mechanism.unknowns[placed.unknown];
        let name = match placed.component {
            None => unknown.name.clone(),
            Some(k) => format!("{}.{}", unknown.name, AXES[k]),
        };
        let estimate = literal::float(placed.estimate);
        let dimension = unknown.ty.dimension();
        let number = dimension.is_some_and(|d| d.half_lengths == 0);
        let scale = literal::float(if number { 1.0 } else { facts.longest });
        let unit = match placed.angle {
            true => String::new(),
            false => unknown
                .ty
                .dimension()
                .map_or_else(String::new, |d| d.unit(mechanism.unit)),
        };
        let angle = placed.angle;
        quote! {
            #runtime::CoupledUnknown { name: #name, estimate: #estimate, scale: #scale, unit: #unit, angle: #angle }
        }
    });
    let variables = group.variables.iter().map(|variable| match variable {
        Variable::Unit => quote!(#runtime::Variable::Unit),
        Variable::Length => quote!(#runtime::Variable::Length),
        Variable::Point => quote!(#runtime::Variable::Point),
        Variable::Conjugate => quote!(#runtime::Variable::Conjugate),
    });
    let terms = group.terms.iter().map(|(equation, exponents)| {
        let equation = literal::index(*equation);
        let exponents = exponents.iter().map(|&e| Literal::i8_unsuffixed(e));
        quote!(#runtime::Term { equation: #equation, exponents: &[#(#exponents),*] })
    });
    let inputs = group.inputs.iter().map(|&input| {
        let item = &mechanism.inputs[input];
        let (name, unit) = (&item.name, item.dimension.unit(mechanism.unit));
        let angle = item.dimension.half_lengths == 0;
        let index = literal::index(input);
        let facts = &facts.inputs[input];
        let (low, high) = facts.followed;
        let (low, high) = (literal::float(low), literal::float(high));
        let declared = facts.range.is_some();
        quote! {
            #runtime::CoupledInput {
                name: #name, unit: #unit, index: #index, declared: #declared,
                range: #runtime::Range { low: #low, high: #high, turn: #angle },
            }
        }
    });
    quote! {
        #runtime::CoupledGroup {
            mechanism: #title,
            group: #index,
            kind: #kind,
            loops: &[#(#loops),*],
            names: &[#(#names),*],
            unknowns: &[#(#unknowns),*],
            variables: &[#(#variables),*],
            terms: &[#(#terms),*],
            inputs: &[#(#inputs),*],
        }
    }
}
