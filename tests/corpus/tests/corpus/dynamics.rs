//! The equation of motion of all mechanisms with forces: its terms against torques, energies and each other.
//!
//! Functions with the terms are added to the texts of the tests of forces, of the folder `mechanisms` and of the golden
//! files. Their residuals are written in the language, which checks dimensions, too.

mod terms;

use std::fs;
use std::path::Path;

use linkage_compiler::check_all;
use linkage_corpus::given;
use linkage_engine::{Assembly, Mechanism};
use linkage_random::Random;
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

use terms::Terms;

/// The largest residual, relative to the sizes of its terms.
const ROUNDING: f64 = 1e-12;

/// Positions of each mechanism.
const POSITIONS: u32 = 12;

/// Mechanisms that must be compared at least: all those of the tests of forces have masses and loads.
const AT_LEAST: usize = 30;

#[test]
fn terms_of_the_equation_of_motion_fit_together() {
    let mut compared = 0;
    for text in texts() {
        let Some((mechanism, terms)) = with_terms(&text) else {
            continue;
        };
        let name = mechanism.name();
        let assembly = mechanism.assemble(&mechanism.dimensions());
        let assembly = assembly.unwrap_or_else(|error| panic!("{name}: {error}"));
        let mut random = Random::new(u64::from(POSITIONS));
        let finite = (0..POSITIONS).filter(|_| compare(&mechanism, &assembly, &terms, &mut random));
        assert!(finite.count() > 0, "{name} has no position");
        compared += 1;
    }
    assert!(compared >= AT_LEAST, "only {compared}");
}

/// Compares at a random position, speeds and loads; false where the mechanism cannot be assembled.
fn compare(mechanism: &Mechanism, assembly: &Assembly, terms: &Terms, random: &mut Random) -> bool {
    let name = mechanism.name();
    let given = terms.random_arguments(mechanism, random);
    let call = |function: &str| {
        let added = mechanism.function(&format!("terms_of_{function}"));
        let index = added.expect("it was added");
        assembly.call(index, &given.of(function, terms))
    };
    for function in ["driven", "free", "energies"] {
        for pair in call(function).chunks(2) {
            let [residual, size] = pair else {
                unreachable!("pairs")
            };
            if size.is_nan() {
                return false;
            }
            let good = residual.abs() <= ROUNDING * size;
            assert!(good, "{name}, {function}: {residual:e} of {size:e}");
        }
    }
    // Velocity terms do the work that changes the inertia, weights none of it.
    let (moving, rest) = (call("moving"), call("rest"));
    let [change, terms_of_inputs @ ..] = &moving[..] else {
        unreachable!("a change")
    };
    let speeds = given.speeds.iter();
    let works = speeds
        .zip(terms_of_inputs)
        .zip(&rest)
        .map(|((w, h), g)| [h * w, -g * w]);
    let works: Vec<f64> = works.flatten().collect();
    let energy = call("energies")[1];
    let size = works.iter().fold(energy, |sum, work| sum + work.abs());
    let residual = works.iter().sum::<f64>() - change;
    assert!(
        residual.abs() <= ROUNDING * size,
        "{name}: {residual:e} of {size:e}"
    );
    // The matrix is symmetric, and positive definite.
    let matrix = call("matrix");
    let count = given.speeds.len();
    let x: Vec<f64> = (0..count).map(|_| random.between(-1.0, 1.0)).collect();
    let mut square = 0.0;
    for (a, row) in matrix.chunks(count).enumerate() {
        for (b, entry) in row.iter().enumerate() {
            assert_eq!(entry.to_bits(), matrix[b * count + a].to_bits(), "{name}");
            square += x[a] * entry * x[b];
        }
    }
    assert!(square > 0.0, "{name}: {square:e}");
    true
}

/// The texts of mechanisms that may have forces.
fn texts() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let mut texts = Vec::new();
    for folder in ["tests/forces", "mechanisms"] {
        let files = fs::read_dir(root.join(folder)).expect("there are files");
        let mut names: Vec<String> = files
            .map(|file| {
                file.expect("a file")
                    .file_name()
                    .into_string()
                    .expect("a name")
            })
            .filter(|name| name.ends_with(".rs"))
            .collect();
        names.sort();
        for name in names {
            texts.extend(given::written(&format!("{folder}/{name}")));
        }
    }
    let golden = root.join("linkage-compiler/tests/golden/forces.mech");
    texts.push(fs::read_to_string(golden).expect("it can be read"));
    texts
}

/// The last mechanism of a text with the functions of its terms; `None` without masses.
fn with_terms(text: &str) -> Option<(Mechanism, Terms)> {
    let tokens: TokenStream = text.parse().expect("brackets have partners");
    let mut terms = Terms::new(tokens.clone())?;
    loop {
        let functions = terms.functions().parse().expect("brackets have partners");
        let all = check_all(added(tokens.clone(), functions));
        let last = all.last().expect("it has a mechanism");
        if let Some(mechanism) = Mechanism::new(last) {
            return Some((mechanism, terms));
        }
        let messages: Vec<&str> = last
            .messages
            .iter()
            .map(|message| message.text.as_str())
            .collect();
        // A load that is part of no force is no argument of the terms.
        let dropped = messages.iter().any(|message| terms.drop_unneeded(message));
        assert!(dropped, "{:?}: {messages:#?}", last.name);
    }
}

/// The text with functions at the end of its last `impl` block.
fn added(text: TokenStream, functions: TokenStream) -> TokenStream {
    let mut tokens: Vec<TokenTree> = text.into_iter().collect();
    let is_block = |token: &TokenTree| matches!(token, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
    let last = tokens.iter().rposition(is_block).expect("an `impl` block");
    if let TokenTree::Group(block) = &tokens[last] {
        let content = block.stream().into_iter().chain(functions).collect();
        tokens[last] = Group::new(Delimiter::Brace, content).into();
    }
    tokens.into_iter().collect()
}
