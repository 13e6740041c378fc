//! No input makes the front end panic.

use linkage_random::Random;
use proc_macro2::{Group, TokenStream, TokenTree};

use super::{CRANK_ROCKER, LINKS, PRESS, SPACE_FORCES, SPATIAL, TWO_INPUTS};
use crate::diagnostic::Diagnostics;
use crate::model::{Library, read, resolve};
use crate::syntax::dump;

/// All tokens, those inside of groups too.
fn collect(tokens: TokenStream, all: &mut Vec<TokenTree>) {
    for token in tokens {
        if let TokenTree::Group(group) = &token {
            collect(group.stream(), all);
        }
        all.push(token);
    }
}

/// Deletes, doubles, swaps or replaces tokens at one level.
fn mutate(tokens: TokenStream, pool: &[TokenTree], random: &mut Random) -> TokenStream {
    let mut tokens: Vec<TokenTree> = tokens.into_iter().collect();
    if tokens.is_empty() {
        return tokens.into_iter().collect();
    }
    let index = random.below(tokens.len());
    if let TokenTree::Group(group) = &tokens[index]
        && random.below(8) > 0
    {
        let inner = mutate(group.stream(), pool, random);
        tokens[index] = TokenTree::Group(Group::new(group.delimiter(), inner));
        return tokens.into_iter().collect();
    }
    let other = random.below(tokens.len());
    match random.below(4) {
        0 => drop(tokens.remove(index)),
        1 => tokens.insert(index, tokens[index].clone()),
        2 => tokens.swap(index, other),
        _ => tokens[index] = pool[random.below(pool.len())].clone(),
    }
    tokens.into_iter().collect()
}

#[test]
fn mutated_mechanisms_do_not_panic() {
    let mut random = Random::new(1);
    let mut sources = vec![CRANK_ROCKER, TWO_INPUTS, SPATIAL, PRESS, SPACE_FORCES];
    // The last mechanism of a text is the one that is resolved below.
    sources.extend(
        LINKS
            .split_inclusive("\n}\n")
            .filter(|source| source.contains("struct")),
    );
    let samples: Vec<TokenStream> = sources
        .iter()
        .map(|source| source.parse().expect("the source has tokens"))
        .collect();
    let mut pool = Vec::new();
    samples
        .iter()
        .for_each(|sample| collect(sample.clone(), &mut pool));
    for round in 0..10_000 {
        let mut tokens = samples[round % samples.len()].clone();
        for _ in 0..1 + random.below(4) {
            tokens = mutate(tokens, &pool, &mut random);
        }
        let mut diagnostics = Diagnostics::default();
        let definitions = read(tokens, &mut diagnostics);
        let Some(definition) = definitions.into_iter().next_back() else {
            assert!(!diagnostics.is_empty());
            continue;
        };
        dump(&definition);
        let mechanism = resolve(&definition, &Library::default(), &mut diagnostics);
        assert_eq!(mechanism.is_some(), diagnostics.is_empty());
        diagnostics.to_tokens();
    }
}
