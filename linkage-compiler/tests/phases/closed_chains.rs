//! What positions and derivatives of closed chains cost: the examples of vehicles and robots.

use linkage_compiler::check_all;
use linkage_compiler::unit::Unit;
use linkage_symbolic::count::Count;
use proc_macro2::{TokenStream, TokenTree};

/// The mechanisms of an example, by name and call.
fn mechanisms(example: &str) -> Vec<Unit> {
    let tokens: Vec<TokenTree> = example
        .parse::<TokenStream>()
        .expect("tokens")
        .into_iter()
        .collect();
    let calls = tokens.windows(3).filter_map(|three| match three {
        [
            TokenTree::Ident(name),
            TokenTree::Punct(_),
            TokenTree::Group(body),
        ] if name == "mechanism" => Some(body.stream()),
        _ => None,
    });
    let checked = calls.flat_map(check_all);
    let units = checked.map(|own| own.unit.expect("a mechanism without a mistake"));
    units.collect()
}

/// The operations of a function that one of the mechanisms has.
fn operations(example: &str, function: &str) -> u32 {
    let all = mechanisms(example);
    let functions = all.iter().flat_map(|unit| &unit.functions);
    let found = functions
        .map(|own| (own.name.as_str(), own.called.count))
        .find(|(name, _)| *name == function);
    let (_, count) = found.expect("the example has the function");
    println!("{function}: {count:?}");
    total(count)
}

fn total(count: Count) -> u32 {
    let Count {
        add,
        mul,
        div,
        sqrt,
        sin_cos,
        atan2,
        other,
    } = count;
    add + mul + div + sqrt + sin_cos + atan2 + other
}

/// Its lower arm is two rods from one ball joint, its strut two scalar products.
#[test]
fn mcpherson_strut() {
    let example = include_str!("../../../examples/mcpherson.rs");
    assert!(operations(example, "wheel") <= 700);
    assert!(operations(example, "motion") <= 1000);
}

/// Each of its arms is two rods from one ball joint.
#[test]
fn double_wishbone() {
    let example = include_str!("../../../examples/double_wishbone.rs");
    assert!(operations(example, "wheel") <= 2200);
}
