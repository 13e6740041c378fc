//! No input makes the compiler panic; its output is always Rust, and the same for the same input.

mod traps;

use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use linkage_random::Random;
use proc_macro2::{Delimiter, Group, Literal, TokenStream, TokenTree};
use quote::quote;

use super::compiled;
use traps::TRAPS;

const SAMPLES: [&str; 7] = [
    "crank_rocker",
    "favorit",
    "shaper",
    "loader",
    "wrist",
    "cam_press",
    "forces",
];

/// Mutations of the samples, and of the traps; `ROBUST_COUNT=100000` in the environment takes more.
const COUNT: usize = 500;

fn read(name: &str) -> TokenStream {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden");
    let text = fs::read_to_string(folder.join(format!("{name}.mech"))).expect("a mechanism");
    text.parse().expect("the mechanism is made of tokens")
}

/// All tokens, those inside of groups too.
fn collect(tokens: TokenStream, all: &mut Vec<TokenTree>) {
    for token in tokens {
        if let TokenTree::Group(group) = &token {
            collect(group.stream(), all);
        }
        all.push(token);
    }
}

/// Deletes, doubles, swaps or replaces tokens, changes a number, or wraps a token as macros do that hand it on, at one level.
fn mutate(tokens: TokenStream, pool: &[TokenTree], random: &mut Random) -> TokenStream {
    let mut tokens: Vec<TokenTree> = tokens.into_iter().collect();
    if tokens.is_empty() {
        return TokenStream::new();
    }
    let place = random.below(tokens.len());
    if place > 0 && passes_through(&tokens[place - 1]) {
        return tokens.into_iter().collect();
    }
    if let TokenTree::Group(group) = &tokens[place]
        && random.below(10) > 0
    {
        let inner = mutate(group.stream(), pool, random);
        tokens[place] = TokenTree::Group(Group::new(group.delimiter(), inner));
        return tokens.into_iter().collect();
    }
    if let TokenTree::Literal(literal) = &tokens[place]
        && random.below(4) > 0
    {
        tokens[place] = other_number(literal, random).into();
        return tokens.into_iter().collect();
    }
    let other = random.below(tokens.len());
    match random.below(5) {
        0 => drop(tokens.remove(place)),
        4 if !passes_through(&tokens[place]) => {
            let inner = TokenStream::from(tokens[place].clone());
            tokens[place] = Group::new(Delimiter::None, inner).into();
        }
        1 => tokens.insert(place, tokens[place].clone()),
        2 => tokens.swap(place, other),
        _ => tokens[place] = pool[random.below(pool.len())].clone(),
    }
    tokens.into_iter().collect()
}

/// Attributes and visibilities pass through as they are: what is wrong in them is between the user and rustc.
fn passes_through(before: &TokenTree) -> bool {
    match before {
        TokenTree::Punct(hash) => hash.as_char() == '#',
        TokenTree::Ident(ident) => ident == "pub",
        _ => false,
    }
}

/// Another number with the same unit.
fn other_number(literal: &Literal, random: &mut Random) -> Literal {
    const NUMBERS: [&str; 12] = [
        "0", "1", "2", "7.5", "45", "90", "180", "360", "1e-9", "1e9", "1e-300", "1e300",
    ];
    let text = literal.to_string();
    let digits = |c: char| c.is_ascii_digit() || c == '.' || c == '_';
    let unit = text.trim_start_matches(digits);
    let number = NUMBERS[random.below(NUMBERS.len())];
    format!("{number}{unit}")
        .parse()
        .unwrap_or_else(|_| literal.clone())
}

/// Compiles mutations of samples in turn, each in a moment: how many are accepted, and how many refused.
fn compile_mutations(samples: &[TokenStream], random: &mut Random) -> [usize; 2] {
    let mut pool = Vec::new();
    samples
        .iter()
        .for_each(|sample| collect(sample.clone(), &mut pool));
    let wanted = std::env::var("ROBUST_COUNT")
        .ok()
        .and_then(|text| text.parse().ok());
    let [mut accepted, mut refused] = [0; 2];
    for round in 0..wanted.unwrap_or(COUNT) {
        let mut tokens = samples[round % samples.len()].clone();
        for _ in 0..1 + random.below(3) {
            tokens = mutate(tokens, &pool, random);
        }
        let text = tokens.to_string();
        let compiled = || compiled(quote!([::linkage] #tokens)).to_string();
        let output = catch_unwind(AssertUnwindSafe(compiled));
        let output = output.unwrap_or_else(|_| panic!("round {round} panics:\n{text}"));
        if let Err(error) = syn::parse_str::<syn::File>(&output) {
            panic!("round {round}: {error}\n{text}\n{output}");
        }
        match output.contains("compile_error !") {
            true => refused += 1,
            false => accepted += 1,
        }
    }
    println!("{accepted} accepted, {refused} refused");
    [accepted, refused]
}

#[test]
fn mutated_mechanisms_compile_to_something() {
    let mut random = Random::new(0x2545_f491_4f6c_dd1d);
    let [accepted, refused] = compile_mutations(&SAMPLES.map(read), &mut random);
    assert!(
        accepted > 0 && refused > accepted / 10,
        "the mutations are of both sorts"
    );
}

#[test]
fn mutated_traps_compile_to_something() {
    let mut random = Random::new(16);
    let traps = TRAPS.map(|text| text.parse().expect("it is made of tokens"));
    let [accepted, refused] = compile_mutations(&traps, &mut random);
    assert!(
        accepted > 0 && refused > accepted / 10,
        "the mutations are of both sorts"
    );
}

#[test]
fn equal_input_gives_equal_output() {
    let outputs = || SAMPLES.map(|name| compiled(read(name)).to_string());
    let here = outputs();
    // Hash seeds differ from map to map and from thread to thread.
    let there = std::thread::spawn(outputs).join().expect("no panic");
    assert_eq!(here, there);
    assert_eq!(here, outputs());
}

/// What a scalar loop may be written with, about an angle or number `t`, a slide `s` and a point `p`; numbers, then lengths.
const NUMBERS: [&str; 22] = [
    "0",
    "1",
    "k",
    "0 / 0",
    "1 / (k - 1)",
    "t",
    "2 * t",
    "t * t",
    "k * t + phi",
    "t - t",
    "abs(t)",
    "norm(t * (1, 2))",
    "norm((t, 2 * t))",
    "norm((t, k, 0))",
    "distance((t, 0), (0, t))",
    "min(t, phi)",
    "hypot(t, k)",
    "sqrt(t)",
    "acos(k + t)",
    "cos(t)",
    "tan(t)",
    "atan2(sin(t), k)",
];
const LENGTHS: [&str; 18] = [
    "0",
    "l",
    "0 * l",
    "l / 0",
    "s",
    "s - s",
    "s * s / l",
    "abs(s)",
    "norm(p)",
    "norm(p - p)",
    "norm((s, s))",
    "distance(p, (s, l))",
    "norm(s * (1, 2, 3))",
    "norm(polar(s, t))",
    "sqrt(s * l)",
    "l * t",
    "dot(p, dir(t))",
    "p.x",
];

/// Loops of few unknowns with every two of these sides, in either order.
#[test]
fn no_scalar_loop_panics() {
    let mut accepted = 0;
    for sides in [&NUMBERS[..], &LENGTHS] {
        for left in sides {
            for right in sides {
                let unknowns = [("t", "10deg"), ("s", "5mm"), ("p", "(3mm, 4mm)")];
                let written = format!("{left} {right}");
                let declared: String = unknowns
                    .iter()
                    .filter(|(name, _)| {
                        written
                            .split(|c: char| !c.is_alphanumeric())
                            .any(|word| word == *name)
                    })
                    .map(|(name, estimate)| format!("unknown {name} = {estimate}; "))
                    .collect();
                let text = format!(
                    "struct A {{ unit mm; param l = 5mm; param k = 1; input phi = 10deg in 0deg..20deg; {declared}
                     loop {left} = {right}; }} impl A {{ fn f(phi) -> F {{ v: velocity({left}) }} }}"
                );
                let output = catch_unwind(|| compiled(text.parse().expect("tokens")).to_string());
                let output = output.unwrap_or_else(|_| panic!("{left} = {right} panics"));
                accepted += usize::from(!output.contains("compile_error !"));
            }
        }
    }
    assert!(accepted > 0, "some of them can be solved");
}
