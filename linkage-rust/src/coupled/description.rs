//! The description of a coupled group that the runtime needs to prepare it.

use linkage_core::numeric::continuation::Terms;
use linkage_core::numeric::roots::Variable;
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use crate::literal;
use crate::outline::Outline;
use linkage_compiler::ir::{CompiledMechanism, Coupled, ShownNumber};

/// The runtime's description of a group.
pub(super) fn literal(outline: &Outline, unit: &CompiledMechanism, group: &Coupled) -> TokenStream {
    let Outline { runtime, name, .. } = outline;
    let title = outline.title();
    let index = literal::index(group.group);
    let unknowns = group.unknowns.iter().map(|placed| {
        let ShownNumber { name, unit, scale } = unit.shown(placed);
        let estimate = literal::float(placed.estimate);
        let scale = literal::float(scale);
        let angle = placed.angle;
        quote! {
            #runtime::CoupledUnknown { name: #name, estimate: #estimate, scale: #scale, unit: #unit, angle: #angle }
        }
    });
    let variables = group.variables.iter().map(|variable| match variable {
        Variable::Unit => quote!(#runtime::Variable::Unit),
        Variable::Length => quote!(#runtime::Variable::Length),
        Variable::Number => quote!(#runtime::Variable::Number),
        Variable::Point => quote!(#runtime::Variable::Point),
        Variable::Conjugate => quote!(#runtime::Variable::Conjugate),
    });
    let terms = group.terms.iter().map(|(equation, exponents)| {
        let equation = literal::index(*equation);
        let exponents = exponents.iter().map(|&e| Literal::i8_unsuffixed(e));
        quote!(#runtime::Term { equation: #equation, exponents: &[#(#exponents),*] })
    });
    let missed = group.missed_loops.iter().map(|missed| {
        let [number, rows] = [missed.number, missed.rows].map(literal::index);
        let (joint, unit) = (&missed.joint, &missed.unit);
        let scale = literal::float(missed.scale);
        quote! {
            #runtime::CoupledLoop { number: #number, joint: #joint, rows: #rows, unit: #unit, scale: #scale }
        }
    });
    let inputs = group.inputs.iter().map(|&input| {
        let described = &unit.inputs[input];
        let (name, unit, angle) = (&described.name, &described.unit, described.angle);
        let index = literal::index(input);
        let (low, high) = described.followed;
        let (low, high) = (literal::float(low), literal::float(high));
        let declared = described.range.is_some();
        quote! {
            #runtime::CoupledInput {
                name: #name, unit: #unit, index: #index, declared: #declared,
                range: #runtime::Range { low: #low, high: #high, turn: #angle },
            }
        }
    });
    let (reach, turning) = (literal::float(group.reach), literal::index(group.turning));
    let in_cells = match group.in_cells {
        Terms::Slopes => quote!(Slopes),
        Terms::Polynomials => quote!(Polynomials),
    };
    quote! {
        #runtime::CoupledGroup {
            mechanism: #title,
            group: #index,
            described: &#name::<__p::f64>::STRUCTURE.groups[#index],
            unknowns: &[#(#unknowns),*],
            variables: &[#(#variables),*],
            terms: &[#(#terms),*],
            list: #runtime::list_roots,
            missed: &[#(#missed),*],
            inputs: &[#(#inputs),*],
            in_cells: #runtime::Terms::#in_cells,
            reach: #reach,
            turning: #turning,
        }
    }
}
