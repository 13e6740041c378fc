//! What the facade keeps for generated code is what generated code names: nothing is missing, nothing is left over.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use proc_macro2::{TokenStream, TokenTree};

/// The name of the module within the block around generated code.
const SHORT: &str = "__p";

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).expect("a file of the repository")
}

/// The names that the module `__private` of the facade re-exports.
fn kept() -> BTreeSet<String> {
    let facade: syn::File = syn::parse_str(&read(&repository().join("src/lib.rs"))).expect("Rust");
    let private = facade.items.into_iter().find_map(|item| match item {
        syn::Item::Mod(module) if module.ident == "__private" => module.content,
        _ => None,
    });
    let (_, items) = private.expect("a module `__private`");
    let mut names = BTreeSet::new();
    for item in items {
        match item {
            syn::Item::Use(list) => leaves(&list.tree, &mut names),
            _ => panic!("`__private` holds more than re-exports"),
        }
    }
    // The macros are called by the facade's wrapper.
    assert!(names.remove("mechanism") && names.remove("names"));
    names
}

fn leaves(tree: &syn::UseTree, names: &mut BTreeSet<String>) {
    match tree {
        syn::UseTree::Path(path) => leaves(&path.tree, names),
        syn::UseTree::Group(group) => group.items.iter().for_each(|item| leaves(item, names)),
        syn::UseTree::Name(name) => drop(names.insert(name.ident.to_string())),
        syn::UseTree::Rename(rename) => drop(names.insert(rename.rename.to_string())),
        syn::UseTree::Glob(_) => panic!("`__private` re-exports all"),
    }
}

/// The names behind `prefix ::`.
fn behind(prefix: &str, tokens: TokenStream, names: &mut BTreeSet<String>) {
    let tokens: Vec<TokenTree> = tokens.into_iter().collect();
    for (place, token) in tokens.iter().enumerate() {
        match token {
            TokenTree::Group(group) => behind(prefix, group.stream(), names),
            TokenTree::Ident(ident) if ident == prefix => {
                let colon = |token: Option<&TokenTree>| matches!(token, Some(TokenTree::Punct(colon)) if colon.as_char() == ':');
                if colon(tokens.get(place + 1))
                    && colon(tokens.get(place + 2))
                    && let Some(TokenTree::Ident(name)) = tokens.get(place + 3)
                {
                    names.insert(name.to_string());
                }
            }
            // Code that is printed as text.
            TokenTree::Literal(text) => {
                let (text, prefix) = (text.to_string(), format!("{prefix}::"));
                let rests = text.split(&prefix).skip(1);
                names.extend(rests.map(|rest| {
                    let is_part = |c: char| c.is_alphanumeric() || c == '_';
                    rest.chars().take_while(|c| is_part(*c)).collect::<String>()
                }));
            }
            _ => {}
        }
    }
}

fn files(folder: &Path, all: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder of the repository") {
        let path = entry.expect("an entry").path();
        match path.is_dir() {
            true => files(&path, all),
            false => all.push(path),
        }
    }
}

#[test]
fn generated_code_names_what_is_there() {
    let kept = kept();
    let mut all = Vec::new();
    files(
        &repository().join("linkage-compiler/tests/golden"),
        &mut all,
    );
    let mut named = BTreeSet::new();
    for path in all {
        if path.to_string_lossy().ends_with("6-emit.txt") {
            let tokens: TokenStream = read(&path).parse().expect("Rust");
            behind("__private", tokens.clone(), &mut named);
            behind(SHORT, tokens, &mut named);
        }
    }
    let missing: Vec<&String> = named.difference(&kept).collect();
    assert!(missing.is_empty(), "the facade lacks {missing:?}");
}

#[test]
fn nothing_is_there_that_no_generated_code_names() {
    let mut all = Vec::new();
    files(&repository().join("linkage-rust/src"), &mut all);
    let mut named = BTreeSet::new();
    for path in all
        .iter()
        .filter(|path| path.extension().is_some_and(|e| e == "rs"))
    {
        let tokens: TokenStream = read(path).parse().expect("Rust");
        // `quote!(#runtime::Name)`: the path of the facade's module.
        behind("runtime", tokens.clone(), &mut named);
        behind(SHORT, tokens, &mut named);
    }
    let kept = kept();
    let left: Vec<&String> = kept.difference(&named).collect();
    assert!(left.is_empty(), "no code that is printed names {left:?}");
}
